//! Heads of the columns of a study.

use results::{Study, StudyCurve};

/// The dimension in plan.
pub fn size(study: &Study) -> &'static str {
    let round = |wanted: bool| study.tanks.iter().any(|tank| tank.round == wanted);
    match (round(true), round(false)) {
        (true, true) => "Radius or length",
        (false, true) => "Length",
        _ => "Radius",
    }
}

/// What curves are fitted to.
pub fn behind(study: &Study, curves: &[StudyCurve]) -> &'static str {
    match curves.iter().all(|curve| curve.method.ends_with("capacities")) {
        true if study.samples > 1 => "Records and samples",
        true => super::RECORDS.1,
        false => RUNS,
    }
}

/// Tank.
pub const TANK: &str = "Tank";
/// Verdict.
pub const VERDICT: &str = "Verdict";
/// Samples with the verdict.
pub const SAMPLES: &str = "Samples";
/// Governing check.
pub const GOVERNING: &str = "Governing check";
/// Method.
pub const METHOD: &str = "Method";
/// Utilisation.
pub const UTILISATION: &str = "Utilised";
/// Fill height.
pub const FILL: &str = "Fill height";
/// Impulsive period.
pub const IMPULSIVE: &str = "Impulsive period";
/// Sloshing period.
pub const SLOSHING: &str = "Sloshing period";
/// Volume.
pub const VOLUME: &str = "Liquid";
/// Damage state.
pub const STATE: &str = "State";
/// Demand.
pub const DEMAND: &str = "Demand";
/// Utilisation at which a state begins.
pub const LIMIT: &str = "Begins at";
/// Runs that reached a state by a demand.
pub const WAYS: &str = "Runs";
/// Source.
pub const SOURCE: &str = "Source";
/// Median.
pub const MEDIAN: &str = "Median θ";
/// Band.
pub const BAND: &str = "5–95 %";
/// Dispersion.
pub const DISPERSION: &str = "Dispersion β";
/// Runs.
pub const RUNS: &str = "Runs";
/// Fit with one dispersion.
pub const COMMON: &str = "θ; common β";
/// Annual rate.
pub const RATE: &str = "Rate";
/// Share from beyond the hazard curve.
pub const BEYOND: &str = "beyond the hazard curve";
/// Medians if missing runs had reached the state, and if they had been safe.
pub const PARTIAL: &str = "θ with missing runs";
/// Remark.
pub const REMARK: &str = "Remark";
/// Earthquakes in which every tank was judged.
pub const EARTHQUAKES: &str = "Earthquakes";
/// Earthquakes in which a tank was not judged.
pub const NOT_JUDGED: &str = "with gaps";
/// Bounds of a share or mean, where tanks were not judged.
pub const BOUNDS: &str = "Bounds";
/// At least one tank.
pub const ONE: &str = "At least one tank";
/// The same of independent tanks.
pub const INDEPENDENT: &str = "if independent";
/// Mean volume.
pub const MEAN_VOLUME: &str = "Mean loss";
/// Largest volume.
pub const LARGEST_VOLUME: &str = "Largest loss";
/// Which period.
pub const PERIOD: &str = "Period";
/// Damping.
pub const DAMPING: &str = "Damping";
/// Smallest mean over target.
pub const SMALLEST: &str = "Smallest mean/target";
/// Mean peak over target.
pub const ZERO: &str = "Mean peak/target";
/// Factor of the set.
pub const FACTOR: &str = "Factor that just holds";
/// Whether the rule holds.
pub const RULE: &str = "Rule";
/// Duration.
pub const DURATION: &str = "Duration";
/// Time step.
pub const STEP: &str = "Step";
/// Demands over those of the other records.
pub const SEVERITY: &str = "Severity";
/// Rows in the worst state.
pub const LOST: &str = "Rows in the worst state";
/// As in the tables of the study.
pub const KEY: &str = "In rows.csv";
/// Tanks.
pub const TANKS: &str = "Tanks";
/// Why a demand was not checked, of the first row.
pub const WHY: &str = "Why, in the first of them";
/// Status.
pub const STATUS: &str = "Status";
/// Rows.
pub const ROWS: &str = "Rows";
/// First tank and record.
pub const FIRST: &str = "First of them";
/// Message.
pub const MESSAGE: &str = "Message";
/// What is counted.
pub const WHAT: &str = "Work";
/// Count.
pub const COUNT: &str = "Number";
