//! Several tanks in the same earthquakes.
//!
//! Records shake all tanks of a farm at once, so their losses are not independent: the probability that at least k tanks are lost is counted
//! over the earthquakes and compared with the value for independent tanks (the Poisson-binomial distribution of their own shares).

use serde::{Deserialize, Serialize};

/// Losses of a farm at one intensity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Losses {
    /// Earthquakes.
    pub n: usize,
    /// P(at least k tanks lost), k = 1, 2, …, counted.
    pub at_least: Vec<f64>,
    /// The same of independent tanks with the same shares.
    pub at_least_independent: Vec<f64>,
    /// Mean volume lost.
    pub mean_volume: f64,
    /// Largest volume lost in one earthquake.
    pub largest_volume: f64,
}

/// The losses of a farm.
///
/// * `lost`: tank by tank, earthquake by earthquake, whether it is lost
/// * `volumes`: of the tanks
///
/// `None` without tanks or earthquakes, or where the rows differ in length.
pub fn losses(lost: &[Vec<bool>], volumes: &[f64]) -> Option<Losses> {
    let n = lost.first()?.len();
    if n == 0 || lost.len() != volumes.len() || lost.iter().any(|row| row.len() != n) {
        return None;
    }
    let count = |quake: usize| lost.iter().filter(|row| row[quake]).count();
    let volume = |quake: usize| -> f64 {
        lost.iter()
            .zip(volumes)
            .filter(|(row, _)| row[quake])
            .fold(0.0, |sum, (_, v)| sum + v)
    };
    let counts: Vec<usize> = (0..n).map(count).collect();
    let at_least = (1..=lost.len()).map(|k| counts.iter().filter(|c| **c >= k).count() as f64 / n as f64);
    let shares = lost
        .iter()
        .map(|row| row.iter().filter(|l| **l).count() as f64 / n as f64);
    let volumes: Vec<f64> = (0..n).map(volume).collect();
    Some(Losses {
        n,
        at_least: at_least.collect(),
        at_least_independent: independent(&shares.collect::<Vec<_>>()),
        mean_volume: volumes.iter().fold(0.0, |sum, v| sum + v) / n as f64,
        largest_volume: volumes.iter().copied().fold(0.0, f64::max),
    })
}

/// P(at least k of the events), k = 1, 2, …, of independent events.
fn independent(shares: &[f64]) -> Vec<f64> {
    // Probability of exactly k of the events so far.
    let mut exactly = vec![1.0];
    for p in shares {
        let mut next = vec![0.0; exactly.len() + 1];
        for (k, q) in exactly.iter().enumerate() {
            next[k] += q * (1.0 - p);
            next[k + 1] += q * p;
        }
        exactly = next;
    }
    let tail = |k: usize| exactly[k..].iter().sum::<f64>().min(1.0);
    (1..exactly.len()).map(tail).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two tanks that are lost in the same half of the earthquakes: both or none, while independent ones would be lost together in a quarter.
    #[test]
    fn what_the_same_earthquakes_do() {
        let row = vec![true, true, false, false];
        let found = losses(&[row.clone(), row], &[100.0, 50.0]).unwrap();
        assert_eq!(found.at_least, [0.5, 0.5]);
        assert_eq!(found.at_least_independent, [0.75, 0.25]);
        assert_eq!((found.mean_volume, found.largest_volume), (75.0, 150.0));
    }

    /// Equal shares are the binomial distribution: P(at least 2 of 4), p = 0.3, is 0.3483.
    #[test]
    fn equal_shares_are_binomial() {
        let found = independent(&[0.3; 4]);
        assert!((found[1] - 0.3483).abs() < 1e-12);
    }
}
