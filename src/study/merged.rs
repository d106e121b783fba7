//! What a merge of a study's results gives.

use std::collections::BTreeMap;

use super::damage::Worst;
use results::Study;

/// What was merged.
#[derive(Clone, Debug, Default)]
pub struct Merged {
    /// Rows.
    pub rows: usize,
    /// Rows by status.
    pub by_status: BTreeMap<&'static str, usize>,
    /// Tasks without a result.
    pub missing: usize,
    /// Those of them that have a damaged one.
    pub damaged: usize,
    /// Hash of rows.csv.
    pub sha256: String,
    /// What the report shows.
    pub study: Option<Study>,
    /// Tank → its worst row.
    pub worst: BTreeMap<String, Worst>,
}
