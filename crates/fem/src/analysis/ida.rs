//! Incremental dynamic analysis: one model under one record at rising scales.
//!
//! This module does not depend on the model: a run is a function of the scale. Runs go to threads as these become free. Each is
//! passed to the caller as it finishes, so that the caller may store it and later request only the missing ones; the result
//! is in the order of the scales and does not depend on the number of threads.
//!
//! ```text
//! demand ▲          ×──▶ collapsed: the demand is at least this (censored)
//!        │      ·
//!        │   ·
//!        │ ·
//!        └──────────────▶ scale
//! ```
//!
//! A curve of one record is not smooth: with more intensity the demand may fall (weaving), and a run above one
//! that collapsed may finish (resurrection). **Capacity is a statement over records**, [`RECORDS_FOR_CAPACITY`] of them at
//! least; a single curve gives no estimate.
//!
//! Source: Vamvatsikos & Cornell 2002.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

use crate::progress::Progress;

/// Fewest records from which a capacity may be read.
pub const RECORDS_FOR_CAPACITY: usize = 5;

/// A point of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Scale of the record.
    pub scale: f64,
    /// Largest demand, or the largest until the collapse.
    pub demand: f64,
    /// Whether the run collapsed: the demand is a lower bound.
    pub censored: bool,
}

/// Runs `run(scale)` for every scale on `threads` threads; `each(i, result)` is called, on the calling thread, for every run as it
/// finishes.
///
/// Returns the results in the order of the scales, `None` where an interruption came before the run.
pub fn incremental<T: Send>(
    scales: &[f64],
    threads: usize,
    progress: &dyn Progress,
    run: impl Fn(f64) -> T + Sync,
    mut each: impl FnMut(usize, &T),
) -> Vec<Option<T>> {
    let mut results: Vec<Option<T>> = scales.iter().map(|_| None).collect();
    progress.stage("runs", scales.len() as u64);
    let next = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, scales.len().max(1)) {
            let (send, next, run) = (send.clone(), &next, &run);
            scope.spawn(move || {
                while !progress.interrupted() {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(&scale) = scales.get(i) else { break };
                    // The receiver lives as long as the scope.
                    if send.send((i, run(scale))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        for (i, result) in receive {
            each(i, &result);
            progress.advance(1);
            results[i] = Some(result);
        }
    });
    results
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Silent;
    use std::sync::atomic::AtomicBool;

    #[test]
    fn order_does_not_depend_on_the_threads() {
        let scales: Vec<f64> = (0..20).map(f64::from).collect();
        let run = |s: f64| {
            // Later runs are quicker.
            std::thread::sleep(std::time::Duration::from_micros((20 - s as u64) * 50));
            s * s
        };
        for threads in [0, 1, 3, 50] {
            let mut heard = Vec::new();
            let found = incremental(&scales, threads, &Silent, run, |i, r| heard.push((i, *r)));
            let squares: Vec<Option<f64>> = scales.iter().map(|s| Some(s * s)).collect();
            assert_eq!(found, squares);
            assert_eq!(heard.len(), 20);
        }
        assert!(incremental(&[], 2, &Silent, run, |_, _| {}).is_empty());
    }

    /// An interruption leaves the runs that were not begun.
    #[test]
    fn interruption() {
        struct Stop(AtomicBool);
        impl Progress for Stop {
            fn stage(&self, _: &str, _: u64) {}
            fn advance(&self, _: u64) {}
            fn interrupted(&self) -> bool {
                self.0.load(Ordering::Relaxed)
            }
        }
        let stop = Stop(AtomicBool::new(false));
        let found = incremental(
            &[1.0, 2.0, 3.0],
            1,
            &stop,
            |s| {
                if s == 2.0 {
                    stop.0.store(true, Ordering::Relaxed);
                }
                s
            },
            |_, _| {},
        );
        assert_eq!(found, [Some(1.0), Some(2.0), None]);
    }
}
