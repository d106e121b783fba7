//! Cores that an analysis may use: all of the machine, or fewer if the user says so.
//!
//! No result depends on the number of threads, so that this is the one setting that is not part of an analysis.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};

/// 0: all.
static LIMIT: AtomicUsize = AtomicUsize::new(0);

/// Sets the number of cores for the rest of the process; 0: all of the machine. The first call sets up the threads that all computations share, and
/// their number stays.
///
/// A thread of the pool that waits takes other work of the pool. That must not read what a scope has set for its thread (units, language, sheets
/// without lines): procedures and the writing of reports do not run in it.
pub fn limit(cores: usize) {
    LIMIT.store(cores, Ordering::Relaxed);
    // An error says that there is a pool. Work that a waiting thread takes stands on its stack.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(cores).stack_size(16 << 20);
    let _ = pool.build_global();
}

/// Number of cores, ≥ 1.
pub fn available() -> usize {
    match LIMIT.load(Ordering::Relaxed) {
        0 => std::thread::available_parallelism().map_or(1, NonZero::get),
        cores => cores,
    }
}

/// Threads of each of `runs` analyses at a time, ≥ 1.
pub fn share(runs: usize) -> usize {
    (available() / runs.max(1)).max(1)
}

/// What `make` returns for every item with its number, on so many threads of the pool.
pub(crate) fn each<T: Send, R: Send>(
    threads: usize,
    items: &mut [T],
    make: impl Fn(usize, &mut T) -> R + Sync,
) -> Vec<R> {
    from(threads, 0, items, &make)
}

fn from<T: Send, R: Send>(
    threads: usize,
    first: usize,
    items: &mut [T],
    make: &(impl Fn(usize, &mut T) -> R + Sync),
) -> Vec<R> {
    if threads < 2 || items.len() < 2 {
        return items.iter_mut().enumerate().map(|(k, item)| make(first + k, item)).collect();
    }
    let half = items.len() / 2;
    let (left, right) = items.split_at_mut(half);
    let own = || from(threads / 2, first, left, make);
    let (mut own, other) = rayon::join(own, || from(threads - threads / 2, first + half, right, make));
    own.extend(other);
    own
}
