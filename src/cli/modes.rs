//! `tankcheck modes`: coupled modes of tank and liquid.

use std::fmt::Write;
use std::path::PathBuf;

use fem::progress::Progress;
use serde_json::json;
use tank::{Case, Shape};

use crate::cli::budget::{self, MemoryArg};
use crate::cli::progress::Watch;
use crate::cli::table::Table;
use crate::cli::terminal::{say, warn};
use crate::cli::{self, Format, Global, print, solid};
use crate::error::{EXIT_OK, Error};
use crate::{input, job};
use engines::solid::SolidOptions;
use engines::{Task, engine, harmonic};
use files::text;
use report::words::terminal as words;
use results::{EngineId, Mode, finite};

/// Largest circumferential harmonic: the default meshes do not resolve more waves.
const MAX_HARMONIC: u32 = 20;

/// Last of the parts of the motions of a box in three dimensions: even or odd about each of its middle planes.
const MOST_PART: u32 = 3;

/// Largest number of modes of each kind.
const MAX_COUNT: usize = 100;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck modes tank.json
  tankcheck modes tank.json --harmonics 1 --count 5 --format json
  tankcheck modes tank.json --fe solid --mesh 12x16x20 --count 10

Harmonic 1 responds to horizontal motion, 0 to vertical motion (its effective mass is that of pressure and weight); 2 and
more do not respond to uniform ground motion. A rectangle has the symmetric half (0) and the antisymmetric half (1) of its
plane strip; in three dimensions four parts: 1 responds to motion along its length, 2 along its breadth, 3 to none.")]
pub(crate) struct Args {
    /// The tank (`-` reads standard input).
    #[arg(value_name = "TANK")]
    tank: PathBuf,
    /// Finite-element engine [default: harmonic; solid for a box less broad than seven heights of its walls].
    #[arg(long, value_enum)]
    fe: Option<Engine>,
    #[command(flatten)]
    solid: solid::SolidArgs,
    /// Circumferential harmonics, separated by commas [default: 0,1,2; rectangle 0,1; three-dimensional: all].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    harmonics: Option<Vec<u32>>,
    /// Modes of each kind (sloshing, structural) and harmonic.
    #[arg(long, value_name = "N", default_value_t = 3)]
    count: usize,
    /// Multiply every element count of the mesh, 0.25 to 16 [default: that of the tank file, else 1].
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    refine: Option<f64>,
    #[command(flatten)]
    memory: MemoryArg,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Finite-element engine.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Engine {
    /// One Fourier harmonic at a time.
    Harmonic,
    /// Three-dimensional elements: the lowest modes of all circumferential wave numbers at once.
    Solid,
}

impl Engine {
    fn id(self) -> EngineId {
        match self {
            Engine::Harmonic => EngineId::Harmonic,
            Engine::Solid => EngineId::Solid,
        }
    }
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let tank = input::read_tank(&args.tank)?;
    for warning in &tank.warnings {
        warn("", warning);
    }
    let fe = args.fe.unwrap_or(if tank.case.tank.bends_as_plates() { Engine::Solid } else { Engine::Harmonic });
    let solid = args.solid.over(&tank.solid);
    let faults = job::refused(&tank, |task| engine(fe.id()).refuses(&Task { solid: &solid, ..*task }));
    if !faults.is_empty() {
        return Err(faults.into_error(&tank.source).into());
    }
    let shape = tank.case.tank.shape;
    let mut options = tank.fe;
    options.refine = args.refine.unwrap_or(options.refine);
    let default = match (fe, shape) {
        (Engine::Solid, _) => Vec::new(),
        (_, Shape::Cylinder { .. }) => vec![0, 1, 2],
        (_, Shape::Rectangle { .. }) => vec![0, 1],
    };
    let harmonics = args.harmonics.unwrap_or(default);
    check(&harmonics, args.count, (shape, fe))?;
    let asked = Asked {
        case: tank.case,
        options,
        harmonics,
        count: args.count,
        memory_limit_mib: args.memory.over(tank.solid.memory_limit_mib),
    };
    if args.solid.is_nonlinear() {
        let text = "--liquid nonlinear: modes are those of small waves\n  help: remove --liquid nonlinear";
        return Err(Error::conflict(text));
    }
    let (modes, notes) = match (fe, args.solid.given()) {
        (Engine::Harmonic, Some(option)) => {
            let text = format!("{option} applies to the three-dimensional engine only\n  help: add --fe solid");
            return Err(Error::conflict(text));
        }
        (Engine::Harmonic, None) => asked.harmonic(global)?,
        (Engine::Solid, _) => asked.solid(solid, global)?,
    };
    finite::check("modes", &modes)?;
    show(&asked.case, (&modes, &notes), (fe, args.format), global)?;
    Ok(EXIT_OK)
}

/// The modes that are asked for.
struct Asked {
    case: Case,
    options: engines::Options,
    /// None for all of the three-dimensional engine.
    harmonics: Vec<u32>,
    /// Number of modes of each kind.
    count: usize,
    memory_limit_mib: u64,
}

impl Asked {
    /// Modes and notes of the harmonic engine: one mesh, and one harmonic after the other.
    fn harmonic(&self, global: &Global) -> Result<(Vec<Mode>, Vec<String>), Error> {
        let one = engines::Options { mesh_error: false, ..self.options.clone() };
        let mut estimate = harmonic::estimate(&self.case, &one)?;
        estimate.seconds *= self.harmonics.len() as f64;
        budget::admit(&estimate, self.memory_limit_mib, false, global)?;
        let watch = Watch::new(global, "modes");
        watch.stage("modes by harmonic", self.harmonics.len() as u64);
        let mut modes = Vec::new();
        for harmonic in &self.harmonics {
            modes.extend(engines::modes(&self.case, &self.options, &[*harmonic], self.count)?);
            watch.advance(1);
        }
        watch.finish();
        let notes = harmonic::notes(&self.case, &modes);
        Ok((modes, notes))
    }

    /// Modes and notes of the three-dimensional engine.
    fn solid(&self, options: SolidOptions, global: &Global) -> Result<(Vec<Mode>, Vec<String>), Error> {
        let (case, harmonics) = (&self.case, &self.harmonics);
        let solid = SolidOptions { memory_limit_mib: self.memory_limit_mib, ..options };
        let estimate = engines::solid::estimate(case, &self.options, &solid)?;
        budget::admit(&estimate, self.memory_limit_mib, true, global)?;
        let watch = Watch::new(global, "modes");
        let mut modes = engines::solid::modes(case, &self.options, &solid, self.count, &watch)?;
        watch.finish();
        modes.retain(|m| harmonics.is_empty() || harmonics.contains(&m.harmonic));
        let mut notes = harmonic::notes(case, &modes);
        notes.extend(engines::solid::penalty_notes(case, &solid, &modes));
        let most = engines::solid::most_waves(case, &self.options, &solid)?;
        if let Some(n) = harmonics.iter().find(|n| **n > most) {
            return Err(Error::value(format!(
                "--harmonics: found {n}, expected 0 to {most} on this mesh\n  help: give --mesh more sectors; a wave \
                     needs six"
            )));
        }
        notes.push(match case.tank.shape {
            Shape::Cylinder { .. } => words::wave_numbers(most),
            Shape::Rectangle { .. } => words::PARTS_OF_A_BOX.into(),
        });
        Ok((modes, notes))
    }
}

/// Prints the modes with their notes.
fn show(
    case: &Case,
    (modes, notes): (&[Mode], &[String]),
    (fe, format): (Engine, Format),
    global: &Global,
) -> Result<(), Error> {
    match format {
        Format::Human => {
            let mut text = format!("{}\n\n{}", text::line(&case.name), table(modes, case, fe));
            for note in notes {
                let _ = writeln!(text, "\nnote: {note}");
            }
            print(&text)
        }
        Format::Json => {
            let value = json!({ "name": case.name, "liquid_mass": case.liquid_mass(), "modes": modes, "notes": notes });
            print(&cli::json(&value)?)
        }
        Format::Csv => {
            print(&csv(modes))?;
            if !global.quiet {
                notes.iter().for_each(|note| say!("note: {note}"));
            }
            Ok(())
        }
    }
}

fn check(harmonics: &[u32], count: usize, (shape, engine): (Shape, Engine)) -> Result<(), Error> {
    let usage = |option: &str, found: String, allowed: String| {
        Error::value(format!("{option}: found `{found}`, expected {allowed}"))
    };
    let largest = match (shape, engine) {
        (Shape::Cylinder { .. }, _) => MAX_HARMONIC,
        (Shape::Rectangle { .. }, Engine::Harmonic) => 1,
        (Shape::Rectangle { .. }, Engine::Solid) => MOST_PART,
    };
    if let Some(m) = harmonics.iter().find(|&&m| m > largest) {
        return Err(usage("--harmonics", m.to_string(), format!("0 to {largest} for this tank")));
    }
    let mut seen = harmonics.to_vec();
    seen.sort_unstable();
    if let Some(pair) = seen.windows(2).find(|p| p[0] == p[1]) {
        return Err(usage("--harmonics", format!("{} twice", pair[0]), "each harmonic once".to_owned()));
    }
    if !(1..=MAX_COUNT).contains(&count) {
        return Err(usage("--count", count.to_string(), format!("1 to {MAX_COUNT}")));
    }
    Ok(())
}

fn table(modes: &[Mode], case: &Case, engine: Engine) -> Table {
    let liquid_mass = case.liquid_mass();
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    // Wave numbers as in the theory manual: one for the harmonic engine, two for the wall of the three-dimensional one.
    let waves: &[&str] = match engine {
        Engine::Harmonic => &["m"],
        Engine::Solid if round => &["n (around)", "m (axial)"],
        Engine::Solid => &["part"],
    };
    let head = ["mode"].iter().chain(waves).chain(&[
        "T [s]",
        "f [Hz]",
        "ω [rad/s]",
        "eff. mass [t]",
        "of liquid [%]",
        "height [m]",
    ]);
    let mut table = Table::new(head.copied());
    for mode in modes {
        // The motions of a box along y are its part 2.
        let moved = mode.harmonic <= if engine == Engine::Solid && !round { 2 } else { 1 };
        let cell = |shown: bool, text: String| if shown { text } else { "–".to_owned() };
        let axial = mode.axial.map_or("–".to_owned(), |m| m.to_string());
        let name = [format!("{} {}", mode.kind, mode.number), mode.harmonic.to_string()];
        table.row(name.into_iter().chain((engine == Engine::Solid && round).then_some(axial)).chain([
            format!("{:.5}", mode.period),
            format!("{:.4}", 1.0 / mode.period),
            format!("{:.4}", mode.omega),
            cell(moved, format!("{:.4}", mode.effective_mass / 1000.0)),
            cell(moved, format!("{:.2}", 100.0 * mode.effective_mass / liquid_mass)),
            cell(mode.harmonic == 1 && engine == Engine::Harmonic, format!("{:.4}", mode.effective_height)),
        ]));
    }
    table
}

fn csv(modes: &[Mode]) -> String {
    let mut text = String::from(
        "harmonic,kind,number,period_s,omega_rad_s,damping,participation,effective_mass_kg,effective_height_m,axial\n",
    );
    for m in modes {
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{}",
            m.harmonic,
            m.kind,
            m.number,
            m.period,
            m.omega,
            m.damping,
            m.participation,
            m.effective_mass,
            m.effective_height,
            m.axial.map_or(String::new(), |a| a.to_string())
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const CYLINDER: Shape = Shape::Cylinder { radius: 1.0 };
    const BOX: Shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };

    #[test]
    fn ranges() {
        assert!(check(&[0, 1, 2], 3, (CYLINDER, Engine::Harmonic)).is_ok());
        assert!(check(&[0, 1], 1, (BOX, Engine::Harmonic)).is_ok());
        assert!(check(&[2, 3], 1, (BOX, Engine::Solid)).is_ok());
        assert!(check(&[4], 1, (BOX, Engine::Solid)).is_err());
        for (harmonics, count, shape) in [
            (vec![21], 3, CYLINDER),
            (vec![2], 3, BOX),
            (vec![1, 0, 1], 3, CYLINDER),
            (vec![1], 0, CYLINDER),
            (vec![1], 101, CYLINDER),
        ] {
            assert!(matches!(
                check(&harmonics, count, (shape, Engine::Harmonic)),
                Err(Error::Files(files::error::Error::Input(..)))
            ));
        }
    }
}
