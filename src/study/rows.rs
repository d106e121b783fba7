//! What a task writes.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::listed;

listed! {
    /// How the run of a row ended.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum RowStatus {
        /// As in the files.
        word: &'static str,
    }
    /// To the end of the record.
    Ok: "ok";
    /// Without equilibrium, at a time.
    Collapsed: "collapsed";
    /// Out of its model, at a time.
    Opened: "opened";
    /// A tank with these values is not possible, or the engine does not model it.
    Refused: "refused";
    /// The computation failed.
    Error: "error";
}

/// How a limit state of the engine ends in a row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Ending {
    /// Largest utilisation of its checks.
    Utilisation(f64),
    /// `fails` where a capacity is not positive, `not_checked`, `accepted`.
    Word(String),
}

/// One tank, sample, record and scale.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Tank.
    pub tank: String,
    /// Sample, from 0.
    pub sample: u32,
    /// Record; `site` for the design spectra of the tank.
    pub record: String,
    /// Level of the intensity measure, SI; none for factors.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub level: Option<f64>,
    /// Factor on the record.
    pub factor: f64,
    /// Intensity measure of the scaled record, SI.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub im: Option<f64>,
    /// Peak acceleration [m/s²], velocity [m/s] and displacement [m] of the scaled record along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peaks: Option<[f64; 3]>,
    /// Longest period of which the record says something [s], where its file gives the corner of its filter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub usable_period: Option<f64>,
    /// Whether the sloshing period of the tank is longer than that; none where either is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sloshing_beyond_usable: Option<bool>,
    /// How the run ended.
    pub status: RowStatus,
    /// Time of its end [s], where that is not the end of the record.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
    /// Why, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// `method.quantity` → value, SI.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<String, f64>,
    /// `method.limit_state` → how it ends.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub checks: BTreeMap<String, Ending>,
    /// Why its limit states were not checked; kept with the tank, once for all rows of a task.
    #[serde(skip)]
    pub gaps: BTreeMap<String, String>,
}

impl Row {
    /// A row without a run.
    pub fn blank(tank: &str, sample: u32, record: &str, status: RowStatus) -> Row {
        Row {
            tank: tank.into(),
            sample,
            record: record.into(),
            level: None,
            factor: 1.0,
            im: None,
            peaks: None,
            usable_period: None,
            sloshing_beyond_usable: None,
            status,
            time: None,
            message: None,
            values: BTreeMap::new(),
            checks: BTreeMap::new(),
            gaps: BTreeMap::new(),
        }
    }
}

/// What a tank with the values of a sample has of its own: its periods and the verdict of the deciding codes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TankRow {
    /// Tank.
    pub tank: String,
    /// Sample, from 0.
    pub sample: u32,
    /// First impulsive and sloshing period of the engine [s], where it gives them.
    pub periods: [Option<f64>; 2],
    /// Volume of the liquid [m³].
    pub volume: Option<f64>,
    /// Verdict of the deciding codes under the design spectra: `holds`, `fails`, `incomplete`, `not_assessed`, or `refused`.
    pub verdict: String,
    /// Method and check with the largest utilisation, and that; none without any capacity, which exceeds all.
    pub governing: Option<(String, String, Option<f64>)>,
    /// Method and limit state of what the deciding codes require and was not checked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub open: Vec<(String, String)>,
    /// Limit state of the engine that a row of the task has not checked → why, of the first such row.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub gaps: BTreeMap<String, String>,
    /// Why it is refused.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// `method.quantity` → value under the design spectra, SI.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<String, f64>,
}

/// A line of a result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Line {
    /// A tank; before its rows.
    Tank(Box<TankRow>),
    /// A row.
    Row(Box<Row>),
}

/// Record of the only row of a tank without records: its design spectra.
pub(super) const SITE: &str = "site";

/// Longest message of a row [characters].
const MESSAGE: usize = 300;

/// A message on one line, without colours, cut.
pub(super) fn plain(message: &str) -> String {
    let mut text = String::new();
    let mut escape = false;
    for c in message.chars() {
        match c {
            '\u{1b}' => escape = true,
            'm' if escape => escape = false,
            _ if escape => {}
            c if c.is_control() => text.push(' '),
            c => text.push(c),
        }
    }
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").chars().take(MESSAGE).collect()
}

/// A number with the ten digits that files keep.
pub(super) fn kept(value: f64) -> f64 {
    format!("{value:.9e}").parse().unwrap_or(value)
}
