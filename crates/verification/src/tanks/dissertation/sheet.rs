//! Common to the examples: runs on all meshes, and tables next to the dissertation's numbers.

use std::fmt::Write as _;

use engines::solid::{self, Liquid, MeshSize, SolidOptions};
use engines::{DampingModel, FeError, Options, Simulation, simulate};
use fem::progress::Silent;
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::units::significant;
use tank::{Case, Quantity};

/// Meshes of table 8.1: elements over radius, circumference and height.
const MESHES: [(&str, MeshSize); 4] =
    [("A", mesh(12, 16, 12)), ("B", mesh(15, 18, 12)), ("C", mesh(12, 16, 19)), ("D", mesh(12, 16, 20))];

const fn mesh(radial: usize, sectors: usize, vertical: usize) -> MeshSize {
    MeshSize { radial, sectors, vertical }
}

/// A computed column.
pub(super) struct Column {
    pub(super) title: String,
    pub(super) values: Vec<f64>,
}

/// A line of a table: title, unit, numbers of the source's columns ("" where it has none).
pub(super) struct Line {
    pub(super) what: &'static str,
    pub(super) unit: &'static str,
    pub(super) sources: &'static [&'static str],
}

pub(super) const fn line(what: &'static str, unit: &'static str, sources: &'static [&'static str]) -> Line {
    Line { what, unit, sources }
}

/// Options of a run besides the mesh.
pub(super) fn options(damping: DampingModel, stations: &[f64]) -> Options {
    Options { mesh_error: false, stations: stations.to_vec(), damping, ..Options::default() }
}

pub(super) fn shaken(mut case: Case, record: &Record) -> Case {
    case.ground_motion = Some(GroundMotion { horizontal: record.clone(), transverse: None, vertical: None });
    case
}

pub(super) fn peak(run: &Simulation, id: &str) -> f64 {
    let found = run.result.histories.iter().find(|s| s.id == id);
    found.map_or(f64::NAN, |s| s.peak)
}

/// First sloshing frequency [rad/s].
pub(super) fn omega(run: &Simulation) -> f64 {
    let period = run.values.get(&Quantity::SloshingPeriod);
    period.map_or(f64::NAN, |t| std::f64::consts::TAU / t)
}

/// A run on each of the four meshes with `liquid`, and one of the harmonic engine.
pub(super) fn runs(case: &Case, options: &Options, liquid: Liquid) -> Result<Vec<(String, Simulation)>, FeError> {
    let mut out = Vec::new();
    for (name, size) in MESHES {
        let solid_options = SolidOptions { mesh: Some(size), liquid, ..SolidOptions::default() };
        let run = solid::respond(case, options, &solid_options, &Silent)?;
        out.push((format!("{name} {size}"), run));
    }
    out.push(("converged".to_owned(), simulate(case, options)?));
    Ok(out)
}

pub(super) fn columns(runs: &[(String, Simulation)], values: impl Fn(&Simulation) -> Vec<f64>) -> Vec<Column> {
    let each = |(title, run): &(String, Simulation)| Column { title: title.clone(), values: values(run) };
    runs.iter().map(each).collect()
}

/// A table: `heads` name the source's columns.
pub(super) fn table(text: &mut String, heads: &[&str], lines: &[Line], columns: &[Column]) {
    let titles: Vec<&str> = columns.iter().map(|c| c.title.as_str()).collect();
    let _ = writeln!(text, "| | unit | {} | {} |", heads.join(" | "), titles.join(" | "));
    let _ = writeln!(text, "|---|---|{}", "---|".repeat(heads.len() + columns.len()));
    for (i, line) in lines.iter().enumerate() {
        let values: Vec<String> = columns.iter().map(|c| significant(c.values[i], 4)).collect();
        let sources: Vec<&str> = line.sources.iter().map(|s| if s.is_empty() { "–" } else { s }).collect();
        let _ = writeln!(text, "| {} | {} | {} | {} |", line.what, line.unit, sources.join(" | "), values.join(" | "));
    }
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_a_row_a_line() {
        let mut text = String::new();
        let lines = [line("wave", "cm", &["38.6", ""]), line("shear", "kN", &["", ""])];
        let columns = [Column { title: "A".into(), values: vec![1.0; 2] }];
        table(&mut text, &["printed", "test"], &lines, &columns);
        assert_eq!(text.lines().filter(|l| l.starts_with('|')).count(), 4);
        assert!(text.contains("| wave | cm | 38.6 | – | 1.000 |"), "{text}");
    }
}
