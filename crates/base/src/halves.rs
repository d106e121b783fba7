//! A list in two halves, side by side.

use crate::error::BaseError;

/// Applies `one` to each item and returns the results in order. A second thread takes the second half of the list.
///
/// Errors: the first in order.
pub(crate) fn side_by_side<T: Sync, R: Send>(
    items: &[T],
    one: impl Fn(&T) -> Result<R, BaseError> + Sync,
) -> Result<Vec<R>, BaseError> {
    let (first, second) = items.split_at(items.len().div_ceil(2));
    let all = |part: &[T]| part.iter().map(&one).collect::<Result<Vec<R>, BaseError>>();
    if second.is_empty() {
        return all(first);
    }
    let (first, second) = std::thread::scope(|scope| {
        let other = scope.spawn(|| all(second));
        let first = all(first);
        let second = other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        (first, second)
    });
    let mut made = first?;
    made.extend(second?);
    Ok(made)
}
