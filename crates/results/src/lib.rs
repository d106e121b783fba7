//! The results folder: `results.json` (all numbers of a verification) and `series.csv` (time histories).
//!
//! `results.json` is ordered and deterministic; everything that may differ between two identical runs stands in
//! [`Volatile`]. All values are SI, each with its unit. The report, `diff` and users' scripts read only these files.

mod around;
mod base64;
mod base_run;
mod changes;
pub mod channel;
pub mod compare;
mod digits;
mod directions;
mod fact;
mod fields;
pub mod finite;
mod ida;
pub mod impulsive;
mod layout;
mod left_out;
pub mod modal;
pub mod nonlinear;
pub mod numdiff;
pub mod part;
mod previous;
mod push;
mod record_set;
pub mod roof_wave;
mod run;
pub mod scene;
mod snapshots;
mod standing;
mod store;
mod study;
mod transfer;
mod value;
mod verdict;
pub mod vtu;

use files::code::Warning;
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::assessment::{Check, CourseHoop, Excitation, Profile, Step};
use tank::units::Dimension;

pub use around::{Around, BaseAround, WaveAround};
pub use base_run::{
    AnchorRun, BaseBand, BaseEnergy, BaseRun, BaseSpread, GroundOrigin, GroundPlan, JointCycles, MissedBand,
};
pub use changes::{Changes, Ending, MovedCheck, MovedQuantity, Side};
pub use channel::{Channel, GROUND_COLUMNS, VERTICAL_PREFIX};
pub use directions::Directional;
pub use fact::{Fact, FactKind};
pub use fields::{DeformedShape, Fields, Picture, WallMap};
pub use ida::{
    Collapse, FirstCrack, IDA_FILE, IDA_FORMAT, IDA_PARTIAL_FILE, Ida, IdaRun, LiquidParting, ida_csv, read_ida,
    write_ida,
};
pub use left_out::{LeftOut, Omittable};
pub use part::{Finding, Part};
pub use push::{
    Capacity, Imperfection, PUSH_FILE, PUSH_FORMAT, Push, PushBase, PushFoot, PushJoint, PushLimit, PushMeridian,
    PushPoint, PushShell, PushStrip, read_push, write_push,
};
pub use record_set::{Compatibility, RecordSet, SetCheck, SetPeriod, SetQuantity, SetRun, SetScatter};
pub use run::{
    Balance, DampingRow, EnergyBalance, EngineId, Envelope, FE, Labelled, Limit, Mode, ModeShape, Run, SeriesInfo,
};
pub use snapshots::{DrawnMode, Resultants, Snapshot, Snapshots};
pub use store::{
    COMPARE, COMPARE_REPORT, FIGURES_FOLDER, FORMS, OUTPUT, REPORT_FILE, RESULTS_FILE, SERIES_FILE, TRANSFER_FILE, put,
    read, read_series, write,
};

pub use standing::{Standing, StandingGround, StandingPlate, StandingValues};
pub use study::{
    Study, StudyCurve, StudyFault, StudyGap, StudyLimit, StudyLoss, StudyRecord, StudyRule, StudyRuleRow, StudyState,
    StudyTank, StudyTrace,
};
pub use transfer::{Transfer, TransferFunction, TransferMode};
pub use value::Value;
pub use verdict::{Aside, Counts, Deciding, Governing, Overruled, Verdict, VerdictStatus, verdict};

pub use files::error::describe;

/// Version of the format. The version before it is converted when it is read; any other is refused.
pub const FORMAT: &str = "tankcheck-results/4";

/// Everything in `results.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// Format version, [`FORMAT`].
    pub format: String,
    /// Fields that may differ between identical runs; skipped by `diff`.
    pub volatile: Volatile,
    /// Title of the case.
    pub name: String,
    /// Cover of the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub project: Option<tank::Project>,
    /// Files read, with hashes.
    pub files: Vec<SourceFile>,
    /// Echo of the input, defaults marked.
    pub input: Vec<InputValue>,
    /// Geometry for the sketch and the scales of figures.
    pub tank: TankSummary,
    /// Ground motion: horizontal first, then vertical; empty in `check` without a record.
    pub records: Vec<RecordSummary>,
    /// The set of records, of a verification under several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record_set: Option<RecordSet>,
    /// Response spectra of the records and design spectra.
    pub spectra: Vec<SpectrumCurve>,
    /// Methods in report order: procedures, then `fe`, then `measured`.
    pub methods: Vec<Method>,
    /// Runs of the engines, that of the reference first; empty in `check`.
    pub runs: Vec<Run>,
    /// What belongs to no run: the base of an unanchored tank under the moments of the codes, in results that are written to a folder.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Part>,
    /// Quantities × methods.
    pub comparison: Comparison,
    /// The verdict.
    pub verdict: Verdict,
    /// Unusual input, one sentence each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Warning>,
    /// What a run of which parts were selected has not computed; empty in whole results.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub not_computed: Vec<LeftOut>,
}

impl Results {
    /// The first run, to which all ratios refer.
    pub fn reference(&self) -> Option<&Run> {
        self.runs.first()
    }

    /// The run of an engine that is not the first one.
    pub fn beside(&self, engine: EngineId) -> Option<&Run> {
        self.runs.iter().skip(1).find(|run| run.engine == engine)
    }
}

/// Fields that differ between identical runs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Volatile {
    /// Version of the program.
    pub version: String,
    /// Time of creation, ISO 8601.
    pub created: String,
    /// Command line.
    pub command: String,
    /// Wall time of the computation [s].
    pub seconds: f64,
}

/// A file the results were computed from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SourceFile {
    /// Role: `tank`, `record`, `vertical record`.
    pub role: String,
    /// File name without folders.
    pub name: String,
    /// SHA-256 of the bytes, hexadecimal.
    pub sha256: String,
}

/// One line of the input echo.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InputValue {
    /// JSON path (`tank.courses[0].thickness`).
    pub path: String,
    /// As written in the file; for a default, in the form the file takes.
    pub text: String,
    /// True if the file did not give it.
    pub default: bool,
    /// Source of a default ("EN 1998-4:2006 2.3.3"), empty otherwise.
    pub source: String,
}

/// Class of the neutral colour in `templates/figure.css`.
pub const NEUTRAL: &str = "k-other";

fn neutral() -> String {
    NEUTRAL.into()
}

impl Method {
    /// An empty column of computed values in the neutral colour, labelled with its title.
    pub fn new(id: &str, title: &str, excitation: Excitation) -> Method {
        Method {
            id: id.into(),
            title: title.into(),
            label: title.into(),
            figure_key: neutral(),
            excitation,
            status: Status::Computed,
            quantities: BTreeMap::new(),
            steps: Vec::new(),
            checks: Vec::new(),
            profiles: Vec::new(),
            courses: Vec::new(),
            assumptions: Vec::new(),
            notes: Vec::new(),
            beyond_scope: None,
            hold_down: None,
            recalled: Vec::new(),
        }
    }

    /// Whether it is the column of an engine.
    pub fn is_run(&self) -> bool {
        self.id == FE || EngineId::ALL.iter().any(|engine| engine.beside() == self.id)
    }
}

/// Geometry of the tank for the sketch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TankSummary {
    /// The tank as computed with.
    pub tank: tank::Tank,
    /// The liquid.
    pub liquid: tank::Liquid,
    /// g [m/s²].
    pub gravity: f64,
    /// Liquid mass [kg].
    pub liquid_mass: f64,
    /// Wall mass [kg].
    pub wall_mass: f64,
    /// Deformability parameter of the dissertation, eq. (3.1), with its remark.
    pub deformability: Option<Deformability>,
}

impl TankSummary {
    /// Height of the wall above the still liquid, as [`tank::Case::freeboard`] [m].
    pub fn freeboard(&self) -> f64 {
        self.tank.wall_height() - self.liquid.fill_height - self.tank.roof.rim
    }
}

/// Deformability parameter K = √(H/R) √(s/R).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deformability {
    /// K as printed.
    pub as_printed: f64,
    /// The parameter in the sense that a thinner wall deforms more.
    pub corrected: f64,
    /// Remark.
    pub note: String,
}

/// Ground motion as computed with, and its measures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordSummary {
    /// `horizontal`, `horizontal, y` or `vertical`.
    pub direction: String,
    /// Name.
    pub name: String,
    /// Processing of the file's numbers.
    pub processing: Vec<String>,
    /// Time step [s].
    pub dt: f64,
    /// Number of samples.
    pub samples: usize,
    /// Peak ground acceleration of the file, unprocessed [m/s²].
    pub pga_as_recorded: f64,
    /// Peak ground acceleration [m/s²].
    pub pga: f64,
    /// Peak ground velocity [m/s].
    pub pgv: f64,
    /// Peak ground displacement [m].
    pub pgd: f64,
    /// Arias intensity [m/s].
    pub arias: f64,
    /// Cumulative absolute velocity [m/s].
    pub cav: f64,
    /// Significant duration D5-95 [s].
    pub significant_duration: f64,
    /// Longest period of which the record says something [s]: that of the corner of its low-cut filter; none where its file does not give it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub usable_period: Option<f64>,
    /// Whether the sloshing period of the tank is longer than that of a horizontal record: its waves are not to be relied on.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub sloshing_beyond_usable: bool,
}

impl RecordSummary {
    /// Measures of `record`, which was made from `raw`.
    pub fn new(
        direction: &str,
        record: &oscillator::record::Record,
        raw: &oscillator::record::Record,
    ) -> RecordSummary {
        let measures = record.measures();
        RecordSummary {
            direction: direction.into(),
            name: record.name.clone(),
            processing: record.processing.clone(),
            dt: record.dt,
            samples: record.acceleration.len(),
            pga_as_recorded: raw.pga(),
            pga: measures.pga,
            pgv: measures.pgv,
            pgd: measures.pgd,
            arias: measures.arias,
            cav: measures.cav,
            significant_duration: measures.significant_duration,
            usable_period: None,
            sloshing_beyond_usable: false,
        }
    }
}

/// A curve S_a(T).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpectrumCurve {
    /// Id (`record-horizontal-0.005`, `ec8-site-0.02`, …).
    pub id: String,
    /// Legend text.
    pub title: String,
    /// Damping ratio.
    pub damping: f64,
    /// Periods [s], ascending.
    pub period: Vec<f64>,
    /// Spectral displacement [m].
    pub sd: Vec<f64>,
    /// Pseudo-velocity [m/s].
    pub psv: Vec<f64>,
    /// Pseudo-acceleration [m/s²].
    pub psa: Vec<f64>,
}

/// Whether a method gave values.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Status {
    /// It did.
    Computed,
    /// Outside its scope.
    NotApplicable {
        /// Clause that sets the limit.
        clause: String,
        /// Reason.
        reason: String,
    },
}

/// One column of the comparison.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Method {
    /// Id of a procedure, [`FE`], `fe-solid`, `fe-nonlinear` or [`compare::MEASURED`].
    pub id: String,
    /// Title with edition.
    pub title: String,
    /// Short label for figures and tables; empty in results of earlier versions, which show the title.
    #[serde(default)]
    pub label: String,
    /// Class of its colour and dash in `templates/figure.css`; [`NEUTRAL`] in results of earlier versions.
    #[serde(default = "neutral")]
    pub figure_key: String,
    /// Excitation.
    pub excitation: Excitation,
    /// Whether it gave values.
    pub status: Status,
    /// Values by quantity id, in SI.
    pub quantities: BTreeMap<String, Value>,
    /// Calculation sheet.
    pub steps: Vec<Step>,
    /// Checks.
    pub checks: Vec<Check>,
    /// Values over the height.
    pub profiles: Vec<Profile>,
    /// Hoop stresses course by course, static and seismic, of the wall of a metal cylinder.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub courses: Vec<CourseHoop>,
    /// Assumptions.
    pub assumptions: Vec<String>,
    /// Warnings and remarks.
    pub notes: Vec<String>,
    /// Why the tank is outside the scope of the procedure, which gives values all the same: they are no bars of a chart.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beyond_scope: Option<String>,
    /// Weight that holds an unanchored wall down, as the sheet takes it [N/m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hold_down: Option<f64>,
    /// Clauses on which its values rest and that no source was compared with: such a method decides only where the user names it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub recalled: Vec<String>,
}

/// Quantities × methods.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// One row a quantity that at least one method gives.
    pub rows: Vec<ComparisonRow>,
    /// Where and why the methods differ.
    #[serde(default)]
    pub differences: Vec<compare::Difference>,
    /// The ways from the value of the reference engine to those of the procedures.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub attribution: Vec<compare::Attribution>,
    /// Values others have published for this tank.
    pub published: Vec<tank::case::Reported>,
    /// Measured values that belong to another ground motion, or to none that is named.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub measured_apart: Vec<compare::Apart>,
    /// Why there is no ratio to a published value, in the order of `published`; `None` where it belongs to the ground motion.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub published_apart: Vec<Option<compare::Why>>,
}

/// One quantity over all methods.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ComparisonRow {
    /// Quantity id.
    pub quantity: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// One cell a method, in the order of [`Results::methods`]; `None` where the method does not give it.
    pub cells: Vec<Option<Cell>>,
}

/// A value and its ratio to the finite-element value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// Value in SI.
    pub value: f64,
    /// Ratio to the finite-element column, where there is one.
    pub ratio: Option<f64>,
    /// True if the estimated mesh error of the value is above [`MESH_ERROR_LIMIT`]: the number is not to be used.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unusable: bool,
    /// True if the value is outside the model of its engine; the check of [`tank::outside::Outside`] that is open says why.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub outside: bool,
}

/// Estimated discretisation error, relative, above which a number is marked as unusable.
pub const MESH_ERROR_LIMIT: f64 = 0.2;

/// Time histories of `series.csv`: a time column and the columns of the [`Run::histories`] of the first run in order, then
/// those of the others with their [`EngineId::prefix`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Time [s].
    pub time: Vec<f64>,
    /// Column ids.
    pub ids: Vec<String>,
    /// Columns, SI.
    pub columns: Vec<Vec<f64>>,
}
