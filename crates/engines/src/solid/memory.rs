//! Memory of a three-dimensional run.

use crate::FeError;

/// Name of such a run in messages.
pub(super) const RUN: &str = "three-dimensional run";

/// Compares the memory of a run with its limit [bytes].
///
/// Errors: more than allowed.
pub(super) fn allow(needed: u64, limit: u64) -> Result<(), FeError> {
    if needed <= limit {
        return Ok(());
    }
    Err(FeError::Memory {
        run: RUN.into(),
        needed_mib: needed.div_ceil(1 << 20),
        allowed_mib: limit >> 20,
        help: "coarsen the mesh (--mesh, --refine), or raise --memory-limit".into(),
    })
}
