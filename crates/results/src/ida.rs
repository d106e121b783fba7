//! `ida.json`: the runs of an incremental dynamic analysis.

use std::path::Path;

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

use super::nonlinear::{BaseMoment, Departure, TwoSided};
use super::store::{read_document, write_document};
use super::{Fact, Limit, SourceFile, TankSummary, Volatile};
use files::error::Error;

/// Version of the format; a reader refuses any other.
pub const IDA_FORMAT: &str = "tankcheck-ida/1";
/// Name of the results of a finished analysis.
pub const IDA_FILE: &str = "ida.json";
/// Name of the results while runs are still under way.
pub const IDA_PARTIAL_FILE: &str = "ida.partial.json";

/// Everything in `ida.json`. Values are SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ida {
    /// Format version, [`IDA_FORMAT`].
    pub format: String,
    /// Fields that may differ between identical runs; skipped by `diff`.
    pub volatile: Volatile,
    /// Identity of the input: another key is another analysis.
    pub key: String,
    /// Title of the case.
    pub name: String,
    /// Cover of the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub project: Option<tank::Project>,
    /// Geometry for the sketch; none in results of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tank: Option<TankSummary>,
    /// Files read, with hashes.
    pub files: Vec<SourceFile>,
    /// The model in numbers.
    pub model: Vec<Fact>,
    /// Assumptions of the engine, one sentence each.
    pub assumptions: Vec<String>,
    /// Dimension of the moments at the base: of a metre of a strip, or of a whole cylinder.
    #[serde(default = "of_a_metre")]
    pub moment: Dimension,
    /// Runs by ascending scale.
    pub runs: Vec<IdaRun>,
    /// Whether runs that were asked for are missing.
    pub incomplete: bool,
    /// Longest period of which the record says something, and the sloshing period of the tank [s], where the latter is longer: its waves are not to
    /// be relied on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sloshing_beyond_usable: Option<[f64; 2]>,
}

fn of_a_metre() -> Dimension {
    Dimension::LineMoment
}

/// One run: of a strip the worse of both walls in every quantity, of a cylinder the whole tank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct IdaRun {
    /// Factor on the record.
    pub scale: f64,
    /// Peak ground acceleration [m/s²].
    pub pga: f64,
    /// Why and when no equilibrium was found; the demands are then lower bounds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub collapse: Option<Collapse>,
    /// Largest elevation of the surface at the wall from the static level, up or down [m].
    pub wave: f64,
    /// Largest deflection of the top of a strip's wall, largest radial displacement of a cylinder, static state included [m].
    pub wall_displacement: f64,
    /// Its time [s].
    pub wall_displacement_time: f64,
    /// Limits of the model that the run has passed, the first of each kind by time. With `stored_energy` it ends there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub departures: Vec<Departure>,
    /// Largest moment at the base, static state included: of a strip's wall [N m/m], of a cylinder [N m]. It is the reaction
    /// of the ground, with damping and inertia.
    pub base_moment: f64,
    /// Largest bending moment of the lowest section of a strip's wall, the integral of its stresses [N m/m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section_moment: Option<f64>,
    /// Parts of the largest moment at the base of a strip's wall.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_parts: Option<BaseMoment>,
    /// The first crack.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first_crack: Option<FirstCrack>,
    /// First separation of the liquid from a wall; a linear estimate where the model does not separate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parting: Option<LiquidParting>,
    /// Limits of validity of the theory with the values of this run; none in results of earlier versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<Limit>,
    /// Largest share of the wetted wall that the liquid has left at once, where it may.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub open_share: Option<f64>,
    /// Extremes of both signs and at both sides; none in results of earlier versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub extremes: Vec<TwoSided>,
    /// Height of the highest crack [m]; 0 without any.
    pub highest_crack: f64,
    /// Largest opening strain of a crack.
    pub largest_crack: f64,
    /// Largest plastic strain of steel plates and of concrete in compression.
    #[serde(default)]
    pub plastic_strain: f64,
    /// Largest stress of a bar [Pa].
    pub bar_stress: f64,
    /// Largest plastic strain of a bar.
    pub bar_plastic_strain: f64,
    /// Energy dissipated by the materials: of one wall of a strip, the larger one [J/m]; of a cylinder [J].
    pub hysteretic_energy: f64,
    /// Damping ratio of the first mode of wall and liquid, initial wall.
    pub wall_damping: f64,
    /// Number of times that a step was halved.
    pub halvings: u64,
    /// Steps done, both walls.
    pub steps: u64,
    /// Residual of the energy balance over the largest energy.
    pub energy_residual: f64,
}

impl IdaRun {
    /// Limits of validity that the run exceeds.
    pub fn exceeded(&self) -> impl Iterator<Item = &Limit> {
        self.limits.iter().filter(|limit| !limit.holds)
    }
}

/// No equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Collapse {
    /// Time of the last equilibrium [s].
    pub time: f64,
    /// Reason, with the worst point.
    pub reason: String,
}

/// The first crack of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FirstCrack {
    /// Time [s].
    pub time: f64,
    /// Height above the base [m].
    pub height: f64,
    /// Moment at the base then [N m/m], of a cylinder [N m].
    pub base_moment: f64,
}

/// Place and time of the first separation of the liquid from a wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LiquidParting {
    /// Time [s].
    pub time: f64,
    /// Height above the base [m].
    pub height: f64,
    /// Whether it has left the wall; otherwise the model keeps it there though the pressure of the displaced particle is below
    /// that of the air, at a height that stays under the surface.
    pub open: bool,
}

/// Reads the results of an analysis from `path`.
///
/// Errors: an unreadable file, text that is not JSON, another format version.
pub fn read_ida(path: &Path) -> Result<Ida, Error> {
    read_document(path, IDA_FORMAT, "an analysis")
}

/// Writes `ida` to `path`, whole or not at all; 10 significant digits.
///
/// Errors: a file that cannot be written.
pub fn write_ida(path: &Path, ida: &Ida) -> Result<(), Error> {
    write_document(path, ida)
}

/// The runs as a table: head with units, one line a run.
pub fn ida_csv(ida: &Ida) -> String {
    use std::fmt::Write;
    let per = if ida.moment == Dimension::LineMoment { "_per_m" } else { "" };
    let mut text = format!(
        "scale,pga_m_s2,collapse_time_s,wave_m,wall_displacement_m,base_moment_nm{per},first_crack_time_s,\
         first_crack_moment_nm{per},highest_crack_m,largest_crack,plastic_strain,bar_stress_pa,bar_plastic_strain,wall_damping,\
         halvings,energy_residual,parting_time_s,parting_height_m,section_moment_nm{per},damping_moment_nm{per},\
         inertia_moment_nm{per},left_model_time_s,left_model,open_share,limits_exceeded\n",
    );
    let option = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:.6}"));
    let moment = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:.6e}"));
    for run in &ida.runs {
        let _ = writeln!(
            text,
            "{:.6},{:.6},{},{:.6e},{:.6e},{:.6e},{},{},{:.4},{:.4e},{:.4e},{:.6e},{:.4e},{:.6e},{},{:.2e},{},{},{},{},{},{},{},{},{}",
            run.scale,
            run.pga,
            option(run.collapse.as_ref().map(|c| c.time)),
            run.wave,
            run.wall_displacement,
            run.base_moment,
            option(run.first_crack.map(|c| c.time)),
            option(run.first_crack.map(|c| c.base_moment)),
            run.highest_crack,
            run.largest_crack,
            run.plastic_strain,
            run.bar_stress,
            run.bar_plastic_strain,
            run.wall_damping,
            run.halvings,
            run.energy_residual,
            option(run.parting.map(|p| p.time)),
            option(run.parting.map(|p| p.height)),
            moment(run.section_moment),
            moment(run.moment_parts.as_ref().map(|m| m.damping)),
            moment(run.moment_parts.as_ref().map(|m| m.inertia)),
            option(run.departures.first().map(|d| d.time)),
            run.departures.iter().map(|d| d.kind.id()).collect::<Vec<_>>().join(" "),
            option(run.open_share),
            run.exceeded().map(|l| l.id.as_str()).collect::<Vec<_>>().join(" ")
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Ida {
        Ida {
            format: IDA_FORMAT.into(),
            volatile: Volatile::default(),
            key: "k".into(),
            name: "strip".into(),
            project: None,
            tank: None,
            files: Vec::new(),
            model: Vec::new(),
            assumptions: Vec::new(),
            moment: Dimension::LineMoment,
            runs: vec![IdaRun {
                scale: 0.5,
                pga: 1.7,
                collapse: None,
                wave: 0.2,
                wall_displacement: 1e-3,
                wall_displacement_time: 3.0,
                departures: Vec::new(),
                base_moment: 5e4,
                section_moment: Some(4.9e4),
                moment_parts: None,
                first_crack: Some(FirstCrack { time: 2.5, height: 0.1, base_moment: 5.3e4 }),
                parting: Some(LiquidParting { time: 3.1, height: 4.6, open: false }),
                limits: Vec::new(),
                open_share: None,
                extremes: Vec::new(),
                highest_crack: 0.4,
                largest_crack: 1e-3,
                plastic_strain: 0.0,
                bar_stress: 3e8,
                bar_plastic_strain: 0.0,
                hysteretic_energy: 1.0,
                wall_damping: 2e-4,
                halvings: 3,
                steps: 5000,
                energy_residual: 1e-6,
            }],
            incomplete: false,
            sloshing_beyond_usable: None,
        }
    }

    #[test]
    fn written_and_read_back() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let path = home.path().join(IDA_FILE);
        write_ida(&path, &sample()).expect("writable");
        assert_eq!(read_ida(&path).expect("readable"), sample());
        assert_eq!(std::fs::read_dir(home.path()).expect("readable").count(), 1);
        std::fs::write(&path, "{\"format\": \"tankcheck-ida/0\"}").expect("writable");
        let message = read_ida(&path).expect_err("another version").to_string();
        assert!(message.contains("tankcheck-ida/0"), "{message}");
        std::fs::write(&path, "{").expect("writable");
        assert!(read_ida(&path).is_err());
    }

    #[test]
    fn a_line_has_a_number_a_column() {
        let text = ida_csv(&sample());
        let counts: Vec<usize> = text.lines().map(|l| l.split(',').count()).collect();
        // Head and line; those of the section and of the departures came to eighteen.
        assert_eq!(counts, [25, 25]);
    }
}
