//! First page: subtitle, key figures, limits of the theory that are exceeded.

use crate::number::{Scale, count};
use results::{Limit, RecordSet};

/// Subtitle of the report; `engine` is whether a finite-element run is part of it.
pub fn subtitle(engine: bool) -> &'static str {
    match engine {
        true => "Seismic verification: code procedures and a coupled finite-element time history",
        false => "Seismic verification by code procedures",
    }
}

/// Liquid mass of a whole tank or of a strip of it.
pub fn liquid_mass(strip: bool) -> &'static str {
    if strip { "Liquid mass of the strip" } else { "Liquid mass" }
}

/// Peak acceleration of the record as computed with.
pub const PEAK_GROUND_ACCELERATION: &str = "Peak ground acceleration";

/// Number of records and design value.
pub fn records(set: &RecordSet) -> String {
    let n = count(set.records.len());
    match set.combine.as_str() {
        "mean" => format!("{n}, mean"),
        _ => format!("{n}, largest"),
    }
}

/// Period of the first sloshing mode.
pub const FIRST_SLOSHING: &str = "First sloshing period";
/// Period of the impulsive part.
pub const IMPULSIVE: &str = "Impulsive period";

/// Value and limit.
pub fn exceeded(limit: &Limit) -> String {
    let scale = Scale::of(limit.dimension, [limit.value, limit.limit]);
    format!("{} against {} {}", scale.text(limit.value), scale.text(limit.limit), scale.symbol())
}

/// Entries of the cover.
pub const COVER: [&str; 5] = ["Project", "Client", "Document", "Revision", "Date"];
/// Who signs.
pub const SIGNATURES: [&str; 3] = ["Author", "Checked", "Approved"];
/// Heads of the table of signatures.
pub const SIGNATURE_HEADS: [&str; 3] = ["Name", "Date", "Signature"];
