//! What is to be computed: plain, validated data in SI.

use codes::Case;

use crate::results::{InputValue, SourceFile};

/// One verification to be run.
#[derive(Clone, Debug)]
pub struct Job {
    /// The case, complete and validated.
    pub case: Case,
    /// Ids of the procedures to run, in report order.
    pub procedures: Vec<String>,
    /// Finite-element options; `None` leaves the engine out (`check`).
    pub fe: Option<crate::fe::Options>,
    /// Echo of the input, defaults marked.
    pub echo: Vec<InputValue>,
    /// Files the job was made from, with their hashes.
    pub files: Vec<SourceFile>,
    /// Horizontal (and vertical) record as read, before scaling, for the report's echo.
    pub raw_records: Vec<codes::record::Record>,
}
