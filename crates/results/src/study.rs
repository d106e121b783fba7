//! What the report of a study shows. Plain data in SI, without times, paths or names of machines: the same results, the same report.

use tank::Project;
use tank::units::Dimension;

use super::{EngineId, VerdictStatus};

/// A study.
#[derive(Clone, Debug)]
pub struct Study {
    /// Title.
    pub name: String,
    /// Cover of the report.
    pub project: Option<Project>,
    /// Engine; none for the codes alone.
    pub engine: Option<EngineId>,
    /// Intensity measure.
    pub im: String,
    /// Dimension of the measure.
    pub dimension: Dimension,
    /// Unit in which all levels are given, as in the table of units; none of different units.
    pub unit: Option<String>,
    /// Levels; empty for factors.
    pub levels: Vec<f64>,
    /// Samples of each tank.
    pub samples: u32,
    /// Number of tasks.
    pub tasks: usize,
    /// Tasks without a result.
    pub missing_tasks: usize,
    /// Rows of the plan, and rows with a result.
    pub rows: [usize; 2],
    /// Rows by status.
    pub by_status: Vec<(String, usize)>,
    /// SHA-256 of `rows.csv`.
    pub sha256: String,
    /// How the curves of the tanks were found, in words.
    pub method: String,
    /// Resamples of the bands.
    pub resamples: usize,
    /// Whether there is a hazard curve.
    pub hazard: bool,
    /// Tanks, in the order of the study.
    pub tanks: Vec<StudyTank>,
    /// Damage states, from mild to severe.
    pub states: Vec<StudyState>,
    /// Demands that were not checked.
    pub gaps: Vec<StudyGap>,
    /// Curves of the tanks.
    pub curves: Vec<StudyCurve>,
    /// Curves of at least one tank in the state.
    pub system: Vec<StudyCurve>,
    /// Losses of contents at each level.
    pub losses: Vec<StudyLoss>,
    /// Why there are no losses of several tanks.
    pub no_losses: Option<String>,
    /// Records, in the order of the study.
    pub records: Vec<StudyRecord>,
    /// Demands of single records, of a few tanks.
    pub traces: Vec<StudyTrace>,
    /// Whether the records stand for a spectrum.
    pub rule: Option<StudyRule>,
    /// Why rows are not finished runs.
    pub faults: Vec<StudyFault>,
}

/// A tank of a study.
#[derive(Clone, Debug)]
pub struct StudyTank {
    /// Name.
    pub id: String,
    /// Samples with a result, and how many of them have the verdict.
    pub samples: [usize; 2],
    /// Verdict of the deciding codes: the worst of the samples; none of a tank without a result or that is not possible.
    pub verdict: Option<VerdictStatus>,
    /// Method, check, utilisation: the largest of the samples; infinite without any capacity.
    pub governing: Option<(String, String, f64)>,
    /// Impulsive and sloshing period of the first sample [s].
    pub periods: [Option<f64>; 2],
    /// Volume of the liquid of the first sample [m³].
    pub volume: Option<f64>,
    /// Method and limit state of what the deciding codes require and was not checked, of the first sample that is incomplete.
    pub open: Vec<(String, String)>,
    /// Radius of a cylinder or length of a box, and fill height, without sampling [m].
    pub size: Option<[f64; 2]>,
    /// Whether the first of the size is a radius.
    pub round: bool,
    /// Column → cell, of a tank of a table.
    pub given: Vec<(String, String)>,
}

/// A damage state.
#[derive(Clone, Debug)]
pub struct StudyState {
    /// Name.
    pub name: String,
    /// Ways into it.
    pub limits: Vec<StudyLimit>,
    /// Runs of all tanks that reached none of its limits and are in it because they reached a worse state or found no equilibrium.
    pub by_worse: usize,
}

/// A way into a damage state.
#[derive(Clone, Debug)]
pub struct StudyLimit {
    /// Demand.
    pub demand: String,
    /// Utilisation at which the state begins.
    pub limit: f64,
    /// Source.
    pub source: String,
    /// Runs of all tanks that reached it; a run may have reached several.
    pub runs: usize,
}

/// A curve of a tank or of the farm.
#[derive(Clone, Debug)]
pub struct StudyCurve {
    /// Tank; none of the farm.
    pub tank: Option<String>,
    /// Damage state.
    pub state: String,
    /// Method, as in `fragility.json`.
    pub method: String,
    /// Median and dispersion; none where the data identify no curve.
    pub fit: Option<[f64; 2]>,
    /// Why there is none.
    pub reason: Option<String>,
    /// Bounds of the median where there is none.
    pub bounds: [Option<f64>; 2],
    /// Runs behind it.
    pub n: usize,
    /// 5 and 95 % of the median.
    pub median_band: Option<[f64; 2]>,
    /// 5 and 95 % of the dispersion.
    pub dispersion_band: Option<[f64; 2]>,
    /// Median and dispersion with one dispersion for all states, where curves cross.
    pub common: Option<[f64; 2]>,
    /// Annual rate, and its share from beyond the last point of the hazard curve.
    pub rate: Option<[f64; 2]>,
    /// Intensity, runs, runs in the state, bounds of the share where runs are missing.
    pub points: Vec<(f64, f64, f64, Option<[f64; 2]>)>,
    /// Intensity and probability along the curve.
    pub line: Vec<(f64, f64)>,
    /// Intensity, 5 and 95 % of the probability.
    pub band: Vec<(f64, f64, f64)>,
    /// Medians if all missing runs had been safe, and if all had reached the state.
    pub partial: Option<[Option<f64>; 2]>,
    /// Runs without a result.
    pub missing: usize,
    /// Runs that could not be judged.
    pub unjudged: usize,
    /// Demands that no run has checked.
    pub never_checked: Vec<String>,
    /// Remarks of the method.
    pub notes: Vec<String>,
}

/// Losses of contents at a level.
#[derive(Clone, Debug)]
pub struct StudyLoss {
    /// Intensity.
    pub im: f64,
    /// Earthquakes in which every tank was judged.
    pub earthquakes: usize,
    /// Earthquakes in which a tank was not judged, or that are missing.
    pub not_judged: usize,
    /// P(at least k tanks), k = 1, 2, …; none where no earthquake decides it.
    pub at_least: Vec<Option<f64>>,
    /// Bounds of P(at least one tank), where tanks or earthquakes are missing.
    pub bounds: Option<[f64; 2]>,
    /// Bounds of the mean volume [m³] there; none where a volume is not known.
    pub volume_bounds: Option<[f64; 2]>,
    /// The same of independent tanks; empty where a tank is judged in no earthquake.
    pub independent: Vec<Option<f64>>,
    /// Mean and largest known volume [m³]; no mean where a tank is judged in no earthquake.
    pub volume: [Option<f64>; 2],
}

/// A record of a study.
#[derive(Clone, Debug)]
pub struct StudyRecord {
    /// Name.
    pub id: String,
    /// Duration [s] and time step [s].
    pub duration: [f64; 2],
    /// Peaks of acceleration [m/s²], velocity [m/s] and displacement [m] along x, before scaling.
    pub peaks: Option<[f64; 3]>,
    /// Its demands over the geometric mean of all records at the same level.
    pub severity: Option<f64>,
    /// Rows in the worst state, of those that were judged.
    pub lost: [usize; 2],
}

/// Demands of single records on one tank.
#[derive(Clone, Debug)]
pub struct StudyTrace {
    /// Tank.
    pub tank: String,
    /// State whose largest demand over its limit it is.
    pub state: String,
    /// Record, and its points: intensity, demand over limit.
    pub records: Vec<(String, Vec<(f64, f64)>)>,
    /// Standard deviation of the logarithm of the demand at a level, pooled over the levels.
    pub deviation: Option<f64>,
}

/// Whether the records stand for a spectrum.
#[derive(Clone, Debug)]
pub struct StudyRule {
    /// Clause.
    pub clause: String,
    /// Target, in words.
    pub target: String,
    /// Number of records, and fewest of the rule.
    pub records: [usize; 2],
    /// Whether it holds for every tank.
    pub holds: bool,
    /// Tank by tank and period by period.
    pub rows: Vec<StudyRuleRow>,
}

/// The rule at a period of a tank.
#[derive(Clone, Debug)]
pub struct StudyRuleRow {
    /// Tank; empty for all.
    pub tank: String,
    /// Which period.
    pub which: String,
    /// Period [s].
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Smallest mean over target.
    pub smallest: f64,
    /// Mean of the peaks over the target at T = 0.
    pub zero: f64,
    /// The one factor for the set with which the rule just holds.
    pub factor: f64,
    /// Whether it holds for the set as it is.
    pub holds: bool,
}

/// A demand of the damage states that was not checked.
#[derive(Clone, Debug)]
pub struct StudyGap {
    /// Limit state of the engine.
    pub demand: String,
    /// Tanks with this gap.
    pub tanks: Vec<String>,
    /// Their rows with it.
    pub rows: usize,
    /// Why, of the first row.
    pub reason: String,
}

/// Why rows are not finished runs.
#[derive(Clone, Debug)]
pub struct StudyFault {
    /// Status.
    pub status: String,
    /// Message.
    pub message: String,
    /// Rows.
    pub rows: usize,
    /// Tank and record of the first.
    pub first: [String; 2],
}
