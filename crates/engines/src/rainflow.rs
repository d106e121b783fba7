//! Cycles of a history by the rainflow method.
//!
//! Source: ASTM E1049-85, 5.4.4.

/// Ranges of the cycles of a history with their number, 1 or ½, in the order in which they are closed.
pub(crate) fn cycles(history: impl IntoIterator<Item = f64>) -> Vec<(f64, f64)> {
    let mut turns: Vec<f64> = Vec::new();
    for value in history {
        match turns.as_slice() {
            [.., last] if *last == value => continue,
            [.., before, last] if (last - before) * (value - last) > 0.0 => {
                turns.pop();
            }
            _ => {}
        }
        turns.push(value);
    }
    let (mut open, mut out): (Vec<f64>, Vec<(f64, f64)>) = (Vec::new(), Vec::new());
    for turn in turns {
        open.push(turn);
        while let [.., a, b, c] = open.as_slice() {
            let (before, last) = ((b - a).abs(), (c - b).abs());
            if last < before {
                break;
            }
            let n = open.len();
            if n == 3 {
                // The range starts the history.
                out.push((before, 0.5));
                open.remove(0);
            } else {
                out.push((before, 1.0));
                open.drain(n - 3..n - 1);
            }
        }
    }
    out.extend(open.windows(2).map(|pair| ((pair[1] - pair[0]).abs(), 0.5)));
    out
}

/// Largest range, and [share, number of cycles whose range is at least that share of `limit`].
pub(crate) fn counted(cycles: &[(f64, f64)], limit: f64, shares: &[f64]) -> (f64, Vec<[f64; 2]>) {
    let largest = cycles.iter().map(|c| c.0).fold(0.0, f64::max);
    let number = |share: &f64| {
        let own = cycles.iter().filter(|(range, _)| *range >= share * limit);
        [*share, own.map(|(_, number)| number).sum()]
    };
    (largest, shares.iter().map(number).collect())
}

#[cfg(test)]
mod tests {
    use super::{counted, cycles};

    /// ASTM E1049-85, figure 6: ranges 3, 4, 6, 8, 9 with ½, 1½, ½, 1, ½ cycles.
    #[test]
    fn the_example_of_the_standard() {
        let history = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];
        let found = cycles(history);
        for (range, number) in [(3.0, 0.5), (4.0, 1.5), (6.0, 0.5), (8.0, 1.0), (9.0, 0.5)] {
            let own: f64 = found.iter().filter(|c| c.0 == range).map(|c| c.1).sum();
            assert_eq!(own, number, "{range}: {found:?}");
        }
        // Points on the way are no turns.
        assert_eq!(cycles([-2.0, -1.0, 1.0, 1.0, 0.5, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0]), found);
        assert_eq!(counted(&found, 8.0, &[0.5, 1.0]), (9.0, vec![[0.5, 3.5], [1.0, 1.5]]));
    }
}
