//! The benchmarks of the verification manual.

/// One row: a computed value beside a reference that nobody here invented.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Id of the acceptance row ("F12").
    pub id: String,
    /// What is compared.
    pub what: String,
    /// Reference value, in `unit`.
    pub reference: f64,
    /// Where the reference comes from.
    pub reference_source: String,
    /// Allowed |computed − reference| / |reference|.
    pub tolerance: f64,
    /// Computed value, in `unit`.
    pub computed: f64,
    /// Unit of both values.
    pub unit: String,
}
