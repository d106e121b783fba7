//! Estimated memory and time of a run, printed before it starts and compared with the limits.

use crate::cli::Global;
use crate::cli::terminal::say;
use crate::error::Error;
use engines::estimate::{Estimate, WORTH_SAYING};

/// Memory limit of a run.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub(crate) struct MemoryArg {
    /// Memory limit; a run that needs more is rejected before it starts [default: 4096, or as in the tank file].
    #[arg(long, value_name = "MIB", value_parser = clap::value_parser!(u64).range(1..=16_777_216))]
    memory_limit: Option<u64>,
}

impl MemoryArg {
    /// The limit [MiB]; `given` is that of the tank file.
    pub(crate) fn over(self, given: u64) -> u64 {
        self.memory_limit.unwrap_or(given)
    }
}

/// Rejects a run that exceeds a limit; prints the estimate of a long run, or always if `always`.
///
/// * `limit`: memory allowed [MiB]
///
/// Errors: [`engines::FeError::Memory`], [`engines::FeError::TooLong`], before anything is built.
pub(crate) fn admit(estimate: &Estimate, limit: u64, always: bool, global: &Global) -> Result<(), Error> {
    estimate.hold(limit)?;
    if !global.quiet && (always || estimate.longest() > WORTH_SAYING) {
        say!("{}", estimate.sentence());
    }
    Ok(())
}
