//! Titles of the sections.

/// Title of a section by its id; the id itself where it has none.
pub fn section(id: &'static str) -> &'static str {
    match id {
        "summary" => "Summary",
        "comparison" => "Quantities by method",
        "partings" => "Differences between methods",
        "reported" => "Measured and published values",
        "checks" => "Checks",
        "tank" => "Tank and liquid",
        "input" => "Input",
        "motion" => "Ground motion",
        "spectra" => "Spectra",
        "modes" => "Modes",
        "profiles" => "Pressure and stress over the height",
        "histories" => "Time histories",
        "nonlinear" => "Nonlinear run",
        "spatial" => "Three-dimensional run",
        "sheets" => "Calculation sheets",
        "engine" => "Finite-element model",
        "limits" => "Limits of validity",
        "provenance" => "Provenance and reproduction",
        other => other,
    }
}
