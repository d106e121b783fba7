//! `tankcheck init`: a commented tank file or study file to start from.

use std::path::Path;

use clap::ValueEnum;

use crate::cli::Global;
use crate::cli::outfile::OutFile;
use crate::cli::terminal::say;
use crate::error::{EXIT_OK, Error};
use crate::input::diagnostic::Source;
use crate::input::tank::parse;
use files::text::line;
use tank::Support;
use tank::case::Case;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck init --out tank.json
  tankcheck init --shape unanchored --out tank.json
  tankcheck init --shape rectangle > basin.json
  tankcheck init | tankcheck check -
  tankcheck init --study --out study.json         and the commands that make what it names")]
pub(crate) struct Args {
    /// Shape of the tank.
    #[arg(long, value_enum, default_value_t = Shape::Cylinder)]
    shape: Shape,
    /// Write a study file instead.
    #[arg(long, conflicts_with = "shape")]
    study: bool,
    #[command(flatten)]
    out: OutFile,
}

/// The study file.
const STUDY: &str = include_str!("init/study.json");

/// Shape of the tank in the file.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    /// A steel cylinder on anchors.
    Cylinder,
    /// A steel cylinder that stands on its bottom plate.
    Unanchored,
    /// A strip of a concrete basin.
    Rectangle,
}

impl Shape {
    fn text(self) -> &'static str {
        match self {
            Shape::Cylinder => include_str!("init/cylinder.json"),
            Shape::Unanchored => include_str!("init/unanchored.json"),
            Shape::Rectangle => include_str!("init/rectangle.json"),
        }
    }
}

/// The files to start from: name of the shape, what it is, text.
pub(crate) fn templates() -> Vec<(String, String, &'static str)> {
    let described = |shape: &Shape| {
        let value = clap::ValueEnum::to_possible_value(shape)?;
        let help = value.get_help().map_or_else(String::new, ToString::to_string);
        Some((value.get_name().to_owned(), help, shape.text()))
    };
    Shape::value_variants().iter().filter_map(described).collect()
}

/// The tanks on anchors and of a strip, and the first without anchors, with gas above the liquid and columns under its roof: between them every limit state is declared.
pub(crate) fn cases() -> Vec<Case> {
    let read = |shape: Shape| {
        let file = parse(&Source::new("tank.json", shape.text()));
        // A test reads the files.
        file.map(|file| file.case).ok()
    };
    let mut all: Vec<Case> = [Shape::Cylinder, Shape::Rectangle].into_iter().filter_map(read).collect();
    let strips = all.iter().filter_map(|case| match case.tank.shape {
        tank::Shape::Rectangle { length, breadth, .. } => {
            let mut boxed = case.clone();
            boxed.tank.shape = tank::Shape::Rectangle { length, breadth, strip: false };
            Some(boxed)
        }
        tank::Shape::Cylinder { .. } => None,
    });
    all.extend(strips.collect::<Vec<_>>());
    if let Some(mut lifted) = all.first().cloned() {
        lifted.tank.support = Support::Unanchored;
        lifted.tank.anchors = None;
        lifted.tank.pressure.internal = GAS;
        lifted.tank.roof.on_columns = 1.0 / 3.0;
        if let Some(site) = &mut lifted.site.api650 {
            site.design_pressure = GAS;
        }
        all.push(lifted);
    }
    all
}

/// Pressure above the liquid of the last of [`cases`] [Pa].
const GAS: f64 = 1e3;

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    args.out.put(if args.study { STUDY } else { args.shape.text() })?;
    if let Some(file) = args.out.path().filter(|_| args.study) {
        say!("next, in the folder of the file:");
        for command in commands(file) {
            say!("  {command}");
        }
    }
    Ok(EXIT_OK)
}

/// The commands that make what the study file names, as far as it is not there, and compute the study.
fn commands(file: &Path) -> Vec<String> {
    let beside = |name: &str| file.with_file_name(name).exists();
    let name = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let tank = (!beside("tank.json")).then(|| "tankcheck init --out tank.json".to_owned());
    let records = (!beside("records")).then(|| "tankcheck quake synth --target tank.json --out records/".to_owned());
    let study = [
        format!("tankcheck study plan {} --out farm/", line(&name)),
        "tankcheck study run farm/".into(),
        "tankcheck study merge farm/".into(),
    ];
    tank.into_iter().chain(records).chain(study).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::study;

    /// The study file with the files that it names beside it.
    #[test]
    fn the_study_file_is_valid() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            let path: &Path = &folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        write("tank.json", Shape::Cylinder.text());
        write("records/a.csv", "time_s,acceleration_m_s2\n0,0\n0.01,1\n0.02,0\n");
        write("study.json", STUDY);
        let found = study::read(&folder.path().join("study.json")).unwrap();
        assert_eq!((found.tanks.len(), found.records.len()), (1, 1));
        assert_eq!(found.scales.levels.len(), 12);
    }

    #[test]
    fn all_files_are_valid() {
        for shape in [Shape::Cylinder, Shape::Unanchored, Shape::Rectangle] {
            let source = Source::new("tank.json", shape.text());
            let file = parse(&source).unwrap_or_else(|faults| panic!("{}", faults.render(&source, false)));
            assert!(file.remarks.is_empty(), "{:?}", file.remarks);
        }
    }
}
