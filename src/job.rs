//! Input of a computation: plain, validated data in SI.

use files::code::Warning;
use std::collections::BTreeMap;

use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use tank::check::Decision;
use tank::refusal::Refusal;
use tank::{Case, Project};

use crate::input::TankFile;
use crate::input::diagnostic::Faults;
use engines::Task;
use engines::nonlinear::push::PushOptions;
use engines::nonlinear::{CheckpointFile, NonlinearOptions};
use engines::solid::SolidOptions;
use results::{Deformability, EngineId, InputValue, Omittable, SourceFile, TankSummary};

/// Refusals of an analysis for a tank file, each with its place in the file.
///
/// * `refuses`: the refusals of an engine or of the pushover
pub fn refused(tank: &TankFile, refuses: impl Fn(&Task<'_>) -> Vec<Refusal>) -> Faults {
    let task = Task {
        case: &tank.case,
        linear: &tank.fe,
        solid: &tank.solid,
        nonlinear: &tank.nonlinear,
        checkpoint: None,
        without: &[],
    };
    tank.faults(&refuses(&task))
}

/// One verification to be run.
#[derive(Clone, Debug)]
pub struct Job {
    /// The case, complete and validated.
    pub case: Case,
    /// Cover of the report.
    pub project: Option<Project>,
    /// Ids of the procedures to run, in report order.
    pub procedures: Vec<String>,
    /// Who decides, and which gaps are accepted.
    pub decision: Decision,
    /// Engines that run, in this order; ratios refer to the first. Empty in `check`.
    pub engines: Vec<EngineId>,
    /// Options of the linear engines.
    pub linear: engines::Options,
    /// Options of the three-dimensional engine alone.
    pub solid: SolidOptions,
    /// Options of the nonlinear engine alone.
    pub nonlinear: NonlinearOptions,
    /// Checkpoint file of the nonlinear run.
    pub checkpoint: Option<CheckpointFile>,
    /// Parts of the results that nobody needs, and that are not computed.
    pub without: Vec<Omittable>,
    /// Echo of the input, defaults marked.
    pub echo: Vec<InputValue>,
    /// Input files of the job, with their hashes.
    pub files: Vec<SourceFile>,
    /// Warnings about the input, one sentence each.
    pub warnings: Vec<Warning>,
    /// Horizontal (and vertical) record as read, before scaling, for the report's echo.
    pub raw_records: Vec<oscillator::record::Record>,
    /// Longest period of which each of them says something as processed [s]: that of the corner of its low-cut filter, where its file gives
    /// it.
    pub usable_periods: Vec<Option<f64>>,
}

impl Job {
    /// That of a tank file alone: no engine, no record.
    ///
    /// * `procedures`: ids of those that run, in report order
    pub fn of(tank: TankFile, procedures: Vec<String>) -> Job {
        Job {
            project: tank.project,
            linear: tank.fe,
            solid: tank.solid,
            nonlinear: tank.nonlinear,
            echo: tank.echo,
            warnings: tank.warnings,
            ..Job::of_case(tank.case, procedures, tank.decision)
        }
    }

    /// That of a case alone, with the options that engines have by default.
    pub fn of_case(case: Case, procedures: Vec<String>, decision: Decision) -> Job {
        Job {
            nonlinear: NonlinearOptions::new(case.damping),
            case,
            project: None,
            procedures,
            decision,
            engines: Vec::new(),
            linear: engines::Options::default(),
            solid: SolidOptions::default(),
            checkpoint: None,
            without: Vec::new(),
            echo: Vec::new(),
            files: Vec::new(),
            warnings: Vec::new(),
            raw_records: Vec::new(),
            usable_periods: Vec::new(),
        }
    }

    /// The request to the engines.
    pub fn task(&self) -> Task<'_> {
        Task {
            case: &self.case,
            linear: &self.linear,
            solid: &self.solid,
            nonlinear: &self.nonlinear,
            checkpoint: self.checkpoint.as_ref(),
            without: &self.without,
        }
    }

    /// Geometry for sketches and scales of figures.
    pub fn tank(&self) -> TankSummary {
        let case = &self.case;
        TankSummary {
            tank: case.tank.clone(),
            liquid: case.liquid,
            gravity: case.gravity,
            liquid_mass: case.liquid_mass(),
            wall_mass: case.tank.wall_mass(),
            deformability: codes::deformability::of(case).map(|k| Deformability {
                as_printed: k.as_printed,
                corrected: k.corrected,
                note: k.note,
            }),
        }
    }

    /// Hash of the input of a nonlinear run.
    pub fn key(&self) -> String {
        let options = match self.solid.snapshot_interval {
            None => json!(self.nonlinear),
            // A checkpoint holds the states that are kept for pictures.
            Some(every) => json!({ "nonlinear": self.nonlinear, "states": every }),
        };
        identity("history", &self.case, options)
    }

    /// Hash of the input of an incremental dynamic analysis, without its scales.
    pub fn incremental_key(&self) -> String {
        identity("incremental", &self.case, json!(self.nonlinear))
    }
}

/// Hash of the input of an analysis as canonical JSON: the program, the analysis, the case with its processed records, the
/// options. Different hashes mean different analyses.
fn identity(analysis: &str, case: &Case, options: Value) -> String {
    let everything = json!({
        "analysis": analysis,
        "case": case,
        "checkpoint": fem::analysis::checkpoint::VERSION,
        "engine": EngineId::Nonlinear,
        "options": options,
        "version": env!("CARGO_PKG_VERSION"),
    });
    let mut hash = Sha256::new();
    hash.update(canonical(everything).to_string());
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A JSON value with the keys of all its objects sorted. Numbers keep all their digits.
pub(crate) fn canonical(value: Value) -> Value {
    match value {
        Value::Array(items) => items.into_iter().map(canonical).collect(),
        Value::Object(map) => {
            let sorted: BTreeMap<String, Value> = map.into_iter().map(|(key, item)| (key, canonical(item))).collect();
            sorted.into_iter().collect()
        }
        other => other,
    }
}

/// One incremental dynamic analysis: the nonlinear run of a job, once for each scale of its record.
#[derive(Clone, Debug)]
pub struct IdaJob {
    /// The job, its record at the scale of the tank file.
    pub job: Job,
    /// Factors on the record, ascending and different, ≥ 0; never empty.
    pub scales: Vec<f64>,
    /// Number of parallel runs, ≥ 1.
    pub jobs: usize,
    /// Folder of the results.
    pub out: std::path::PathBuf,
    /// Whether existing runs of the folder are kept.
    pub resume: bool,
}

/// One pushover.
#[derive(Clone, Debug)]
pub struct PushJob {
    /// The job, without a record.
    pub job: Job,
    /// The imperfect shell.
    pub options: PushOptions,
    /// Folder of the results.
    pub out: std::path::PathBuf,
    /// Checkpoint file of the run.
    pub checkpoint: Option<CheckpointFile>,
}

impl PushJob {
    /// Hash of the input of a pushover.
    pub fn key(&self) -> String {
        identity("push", &self.job.case, json!([self.job.nonlinear, self.options]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_keys_is_of_no_account_and_every_digit_counts() {
        let of = |text: &str| canonical(serde_json::from_str(text).expect("JSON")).to_string();
        assert_eq!(of(r#"{"b": [{"d": 1, "c": 0.1}], "a": null}"#), of(r#"{"a": null, "b": [{"c": 0.1, "d": 1}]}"#));
        assert_ne!(of("[0.1]"), of("[0.10000000000000002]"));
        assert_ne!(of("[1, 2]"), of("[2, 1]"));
    }
}
