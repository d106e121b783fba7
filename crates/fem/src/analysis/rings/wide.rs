//! Rows of nodes that a roof joins across the tank.

use std::collections::BTreeMap;

use super::layout::{NONE, REACH};
use crate::linalg::{Pattern, Symmetric};
use crate::ring::{Ring, Weight};

/// Entries of two rows some of whose nodes are more than [`REACH`] sectors apart. They are not averaged but taken into the harmonics.
pub(super) struct Wide {
    pub(super) row: u32,
    pub(super) column: u32,
    /// Place in the model's pattern, with the meridians of row and column.
    entries: Vec<(usize, u32, u32)>,
}

impl Wide {
    pub(super) fn joins(&self, a: u32, b: u32) -> bool {
        (self.row, self.column) == (a.max(b), a.min(b))
    }

    /// Hᵀ A H of the two rows on its diagonal, by harmonic.
    ///
    /// * `odd`: of row and column
    pub(super) fn diagonal(&self, ring: &Ring, odd: [bool; 2], sparse: &Symmetric) -> Vec<f64> {
        let (n, mut room) = (ring.meridians(), ring.room());
        let mut matrix = vec![0.0; n * n];
        for &(place, k, l) in &self.entries {
            matrix[l as usize * n + k as usize] = sparse.values[place];
            if self.row == self.column {
                matrix[k as usize * n + l as usize] = sparse.values[place];
            }
        }
        let mut half = vec![0.0; ring.harmonics() * n];
        for (l, values) in matrix.chunks_exact(n).enumerate() {
            let put = |m: usize, f: usize, c: f64| {
                if f == 0 {
                    half[m * n + l] = c;
                }
            };
            ring.analyse(values, odd[0], Weight::Displacements, &mut room, put);
        }
        let mut out = vec![0.0; ring.harmonics()];
        for (own, values) in half.chunks_exact(n).enumerate() {
            let put = |m: usize, f: usize, c: f64| {
                if m == own && f == 0 {
                    out[m] = c;
                }
            };
            ring.analyse(values, odd[1], Weight::Displacements, &mut room, put);
        }
        out
    }
}

/// The rows that a roof joins, each with itself and with each other.
pub(super) fn wide(
    ring: &Ring,
    pattern: &Pattern,
    of: &[(u32, u32)],
    without: impl Fn(usize, usize) -> bool,
) -> Vec<Wide> {
    let mut found: BTreeMap<(u32, u32), (bool, Wide)> = BTreeMap::new();
    for j in 0..pattern.size() {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            let (a, b) = (of[pattern.rows[p]], of[j]);
            if a.0 == NONE || b.0 == NONE || without(pattern.rows[p], j) {
                continue;
            }
            let (high, low) = if a.0 < b.0 { (b, a) } else { (a, b) };
            let apart = high.1.abs_diff(low.1) as usize;
            let none = || (false, Wide { row: high.0, column: low.0, entries: Vec::new() });
            let own = found.entry((high.0, low.0)).or_insert_with(none);
            own.0 |= apart.min(ring.sectors() - apart) > REACH;
            own.1.entries.push((p, high.1, low.1));
        }
    }
    found.into_values().filter(|(far, _)| *far).map(|(_, wide)| wide).collect()
}
