//! A list, its items side by side.

use rayon::prelude::*;

use crate::error::BaseError;

/// Applies `one` to each item and returns the results in order.
///
/// Errors: the first in order.
pub(crate) fn side_by_side<T: Sync, R: Send>(
    items: &[T],
    one: impl Fn(&T) -> Result<R, BaseError> + Sync,
) -> Result<Vec<R>, BaseError> {
    let made: Vec<Result<R, BaseError>> = items.par_iter().map(&one).collect();
    made.into_iter().collect()
}
