//! The workbook: names of its sheets, heads of its columns.

/// Sheets of all methods together.
pub mod sheets {
    /// Quantities × methods.
    pub const QUANTITIES: &str = "Quantities";
    /// Checks.
    pub const CHECKS: &str = "Checks";
    /// Values over the height.
    pub const PROFILES: &str = "Profiles";
}

/// Heads of the sheet of a method.
pub const STEPS: [&str; 10] =
    ["No.", "Section", "Quantity", "Symbol", "Formula", "Source", "Value", "Unit", "Clause", "Value in SI"];
/// Heads of the checks.
pub const CHECKS: [&str; 10] =
    ["Method", "Excitation", "Decides", "Check", "Clause", "Demand", "Capacity", "Unit", "Utilisation", "Result"];
/// Heads of the profiles.
pub const PROFILES: [&str; 7] = ["Method", "Excitation", "Profile", "Height", "Unit", "Value", "Unit"];
/// Heads of the quantities, before the methods.
pub const QUANTITIES: [&str; 2] = ["Quantity", "Unit"];
/// Labels of the overview.
pub const VERDICT: [&str; 2] = ["Verdict", "Deciding"];
/// Labels of the overview.
pub const PROVENANCE: [&str; 3] = ["Version", "Created", "Command line"];
/// Heads of the files read.
pub const FILES: [&str; 3] = ["Role", "File", "SHA-256"];

/// Whether a method decides.
pub fn decides(decides: bool) -> &'static str {
    if decides { "yes" } else { "no" }
}
