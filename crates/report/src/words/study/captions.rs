//! Titles of the tables of a study.

/// Tanks.
pub const TANKS: &str = "Tanks under their own design spectra";
/// Columns of the table of the study.
pub const GIVEN: &str = "Further values of the table of tanks, as given";
/// Damage states.
pub const STATES: &str = "Damage states, the demands that lead into them, and their sources";
/// Curves of the tanks.
pub const CURVES: &str = "Fragility curves of the tanks";
/// Losses.
pub const LOSSES: &str = "Losses of the farm by intensity";
/// Curves of the farm.
pub const SYSTEM: &str = "Fragility curves of the farm";
/// The rule.
pub const RULE: &str = "Mean spectrum of the records against the target";
/// Records.
pub const RECORDS: &str = "Records";
/// Faults.
pub const FAULTS: &str = "Rows without a finished run";
/// Gaps.
pub const GAPS: &str = "Demands of the damage states that were not checked, at least in some rows";
/// Cost.
pub const COST: &str = "Tasks and rows";
