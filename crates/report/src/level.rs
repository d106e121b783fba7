//! How much a report says.
//!
//! | level | contents |
//! |---|---|
//! | summary | cover with verdict, failing and open checks; datasheet with the courses: two pages |
//! | standard | and checks, sheets of the deciding procedures with their numbers, comparison, limits, pressures and stresses, histories, spectra |
//! | full | and all other sheets and checks, the model of the engine, modes, why methods differ, the input key by key |

/// How much a report says; each level contains the one before it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// What an approver reads.
    Summary,
    /// What a checker reads.
    #[default]
    Standard,
    /// Everything.
    Full,
}
