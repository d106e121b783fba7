//! A verification under a set of records: what stands for all of them, and each by itself.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::check::CheckStatus;
use tank::units::Dimension;

use crate::SourceFile;

/// A set of records. The columns under the record hold its design values; histories, spectra, profiles, sheets and the other parts of the
/// results that belong to one record are those of [`shown`](RecordSet::shown).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordSet {
    /// Title of the set; empty without one.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Code whose rules are asked, `en1998-1` or `asce7-16`.
    pub rule: String,
    /// `mean` or `worst`: the design value.
    pub combine: String,
    /// Clause of the design value.
    pub clause: String,
    /// Fewest records whose mean the code accepts as design value.
    pub fewest_for_mean: usize,
    /// Factor on all records, after the processing of the tank file.
    pub factor: f64,
    /// Id of the record whose histories are shown: that with the largest base shear of the engine.
    pub shown: String,
    /// The records with the runs under them.
    pub records: Vec<SetRun>,
    /// Scatter of the quantities of each method.
    pub quantities: Vec<SetQuantity>,
    /// Scatter of the utilisation of the checks of the engine; also those that are open.
    pub checks: Vec<SetCheck>,
    /// The set against the spectrum of its target; none without a target.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compatibility: Option<Compatibility>,
    /// Why there is no compatibility.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub no_target: String,
}

/// A record of a set and the run under it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetRun {
    /// Id, unique in the set.
    pub id: String,
    /// Its files, with hashes: along x, y, upwards.
    pub files: Vec<SourceFile>,
    /// Peak acceleration [m/s²], velocity [m/s] and displacement [m] along x, as applied.
    pub peaks: [f64; 3],
    /// Significant duration D5-95 along x [s].
    pub significant_duration: f64,
    /// Longest period of which its horizontal components say something [s], where their files give it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub usable_period: Option<f64>,
    /// Whether the sloshing period of the tank is longer.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub sloshing_beyond_usable: bool,
    /// Values by method and quantity, SI.
    pub values: BTreeMap<String, BTreeMap<String, f64>>,
    /// Utilisation by check of the engine; checks that are open under this record are left out.
    pub utilisations: BTreeMap<String, f64>,
    /// Ids of checks of the engine that fail without a capacity, whose utilisation is infinite.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub without_capacity: Vec<String>,
    /// Ids of the limits of validity that the run exceeds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits_exceeded: Vec<String>,
}

/// Scatter of a quantity over the records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetQuantity {
    /// Method.
    pub method: String,
    /// Id of the quantity.
    pub quantity: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Its numbers.
    #[serde(flatten)]
    pub scatter: SetScatter,
}

/// Scatter of a check over the records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetCheck {
    /// Id of the check.
    pub id: String,
    /// What is checked, in words.
    pub name: String,
    /// How it ends for the set.
    pub status: CheckStatus,
    /// Scatter of its utilisation; none where the set has no comparison, or a record leaves no capacity.
    pub scatter: Option<SetScatter>,
}

/// Scatter of a number over the records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetScatter {
    /// Design value.
    pub design: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation over the mean, n − 1.
    pub cov: Option<f64>,
    /// Smallest.
    pub min: f64,
    /// Largest.
    pub max: f64,
    /// Id of the record with the largest.
    pub max_record: String,
}

/// A set against its target spectrum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Compatibility {
    /// Clause.
    pub clause: String,
    /// `site`, or the name of a table.
    pub target: String,
    /// Whether the rule holds for the set as applied.
    pub holds: bool,
    /// The one factor for the set as applied with which the rule just holds.
    pub factor: f64,
    /// Fewest records of the rule.
    pub fewest_records: usize,
    /// Part of the target that the mean may fall to.
    pub share: f64,
    /// Mean of the peaks over the target at T = 0, where the rule asks for it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean_zero_period_ratio: Option<f64>,
    /// Period by period.
    pub periods: Vec<SetPeriod>,
}

/// The spectra of a set around a period of the tank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetPeriod {
    /// `impulsive`, `sloshing` or `isolators`.
    pub which: String,
    /// T₁ [s].
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Range of periods that the rule looks at [s].
    pub range: [f64; 2],
    /// `x`, `y`, or `largest` over all directions.
    pub component: String,
    /// Smallest mean/target.
    pub smallest_ratio: f64,
    /// Its period [s].
    pub at_period: f64,
    /// Whether the spectrum is not below its share of the target.
    pub holds: bool,
    /// Periods of the curves [s].
    pub periods: Vec<f64>,
    /// Target [m/s²].
    pub target: Vec<f64>,
    /// Mean of the set [m/s²].
    pub mean: Vec<f64>,
    /// Each record, in the order of [`RecordSet::records`] [m/s²].
    pub records: Vec<Vec<f64>>,
}
