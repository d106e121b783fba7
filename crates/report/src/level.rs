//! How much a report says.
//!
//! | level | contents |
//! |---|---|
//! | summary | cover, verdict, what was not checked, headline figures: two pages |
//! | standard | and model, limits, checks, differences, pressures and stresses, histories, calculation sheets of the deciding procedures |
//! | full | and all other sheets and checks, the input, modes, why methods differ in words |

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
