//! What is to be computed: plain, validated data in SI.

use codes::Case;

use crate::fe::solid::SolidOptions;
use crate::results::{InputValue, SourceFile};

/// Which finite-element engines run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engines {
    /// One Fourier harmonic at a time.
    #[default]
    Harmonic,
    /// Three-dimensional elements.
    Solid,
    /// The harmonic engine, and the three-dimensional one beside it.
    Both,
}

impl Engines {
    /// Whether the three-dimensional engine runs.
    pub fn solid(self) -> bool {
        self != Engines::Harmonic
    }
}

/// One verification to be run.
#[derive(Clone, Debug)]
pub struct Job {
    /// The case, complete and validated.
    pub case: Case,
    /// Ids of the procedures to run, in report order.
    pub procedures: Vec<String>,
    /// Finite-element options of both engines; `None` leaves the engines out (`check`).
    pub fe: Option<crate::fe::Options>,
    /// Which engines run.
    pub engines: Engines,
    /// Options of the three-dimensional engine alone.
    pub solid: SolidOptions,
    /// Echo of the input, defaults marked.
    pub echo: Vec<InputValue>,
    /// Files the job was made from, with their hashes.
    pub files: Vec<SourceFile>,
    /// Horizontal (and vertical) record as read, before scaling, for the report's echo.
    pub raw_records: Vec<codes::record::Record>,
}
