//! Several tanks in the same earthquakes.
//!
//! Records shake all tanks of a farm at once, so their losses are not independent: the probability that at least k tanks are lost is counted
//! over the earthquakes and compared with the value for independent tanks (the Poisson-binomial distribution of their own shares).
//!
//! What became of a tank in an earthquake may be unknown. An earthquake counts for k where the tanks that are known decide it: k of them are
//! lost, or so many safe that k cannot be. A share counted like this lies between its bounds, no unknown tank lost and all of them, because
//! l ≤ m gives l/n ≤ l/m ≤ (l + n − m)/n, l lost of m decided of n; it errs towards loss, as an earthquake with one tank unknown is
//! decided if another one was lost. The volume is a sum over tanks, so its mean takes each tank from the earthquakes that know it.

use serde::{Deserialize, Serialize};

/// Losses of a farm at one intensity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Losses {
    /// Earthquakes in which every tank is known.
    pub whole: usize,
    /// P(at least k tanks lost), k = 1, 2, …, counted over the earthquakes that are decided; none where none is.
    pub at_least: Vec<Option<f64>>,
    /// Bounds of them.
    pub at_least_bounds: Vec<[f64; 2]>,
    /// The same of independent tanks with the same shares; none where a tank is known in no earthquake.
    pub at_least_independent: Option<Vec<f64>>,
    /// Mean volume lost; none where a tank is known in no earthquake.
    pub mean_volume: Option<f64>,
    /// Bounds of it.
    pub mean_volume_bounds: [f64; 2],
    /// Largest volume that is known to be lost in one earthquake.
    pub largest_volume: f64,
}

/// What became of a tank: whether it is lost; none where that is not known.
pub type Fate = Option<bool>;

/// The losses of a farm.
///
/// * `fates`: tank by tank, earthquake by earthquake
/// * `volumes`: of the tanks
///
/// `None` without tanks or earthquakes, and where the rows differ in length.
pub fn losses(fates: &[Vec<Fate>], volumes: &[f64]) -> Option<Losses> {
    let n = fates.first()?.len();
    if n == 0 || fates.len() != volumes.len() || fates.iter().any(|row| row.len() != n) {
        return None;
    }
    let of = |quake: usize, fate: Fate| fates.iter().filter(|row| row[quake] == fate).count();
    // Tanks lost for certain, and at most.
    let ranges: Vec<[usize; 2]> = (0..n)
        .map(|quake| {
            let lost = of(quake, Some(true));
            [lost, lost + of(quake, None)]
        })
        .collect();
    let share = |part: usize, whole: usize| (whole > 0).then(|| part as f64 / whole as f64);
    let (mut at_least, mut at_least_bounds) = (Vec::new(), Vec::new());
    for k in 1..=fates.len() {
        let lost = ranges.iter().filter(|[least, _]| *least >= k).count();
        let safe = ranges.iter().filter(|[_, most]| *most < k).count();
        at_least.push(share(lost, lost + safe));
        at_least_bounds.push([share(lost, n)?, share(n - safe, n)?]);
    }
    let (mut shares, mut mean_volume_bounds) = (Vec::new(), [0.0; 2]);
    for (row, volume) in fates.iter().zip(volumes) {
        let count = |fate: Fate| row.iter().filter(|f| **f == fate).count();
        let (lost, open) = (count(Some(true)), count(None));
        shares.push(share(lost, n - open));
        mean_volume_bounds[0] += volume * share(lost, n)?;
        mean_volume_bounds[1] += volume * share(lost + open, n)?;
    }
    let volume = |quake: usize| -> f64 {
        let lost = fates.iter().zip(volumes).filter(|(row, _)| row[quake] == Some(true));
        lost.fold(0.0, |sum, (_, v)| sum + v)
    };
    // Either every tank has a share, or there are none.
    let shares: Option<Vec<f64>> = shares.into_iter().collect();
    let mean = |shares: &Vec<f64>| shares.iter().zip(volumes).fold(0.0, |sum, (p, v)| sum + p * v);
    Some(Losses {
        whole: ranges.iter().filter(|[least, most]| least == most).count(),
        at_least,
        at_least_bounds,
        at_least_independent: shares.as_deref().map(independent),
        mean_volume: shares.as_ref().map(mean),
        mean_volume_bounds,
        largest_volume: (0..n).map(volume).fold(0.0, f64::max),
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
        let row: Vec<Fate> = [true, true, false, false].map(Some).into();
        let found = losses(&[row.clone(), row], &[100.0, 50.0]).unwrap();
        assert_eq!(found.at_least, [Some(0.5); 2]);
        assert_eq!(found.at_least_independent, Some(vec![0.75, 0.25]));
        assert_eq!((found.mean_volume, found.largest_volume), (Some(75.0), 150.0));
        assert_eq!(found.at_least_bounds, [[0.5; 2]; 2]);
        assert_eq!((found.whole, found.mean_volume_bounds), (4, [75.0; 2]));
    }

    /// Four earthquakes: none lost; one lost and one unknown; both lost; both unknown. One or more: 2 of 3 decided, 2/4 … 3/4; two: 1 of 2,
    /// 1/4 … 3/4. The first tank is lost in 2 of 3, the second in 1 of 2.
    #[test]
    fn what_is_not_known_bounds_the_losses() {
        let first = vec![Some(false), Some(true), Some(true), None];
        let second = vec![Some(false), None, Some(true), None];
        let found = losses(&[first, second], &[90.0, 40.0]).unwrap();
        assert_eq!(found.at_least, [Some(2.0 / 3.0), Some(0.5)]);
        assert_eq!(found.at_least_bounds, [[0.5, 0.75], [0.25, 0.75]]);
        assert_eq!((found.whole, found.largest_volume), (2, 130.0));
        assert!((found.mean_volume.unwrap() - 80.0).abs() < 1e-12);
        assert_eq!(found.mean_volume_bounds, [45.0 + 10.0, 67.5 + 30.0]);
    }

    /// A tank that no earthquake knows has no share; another one that is lost decides one or more.
    #[test]
    fn a_tank_that_is_never_known_has_no_share() {
        let found = losses(&[vec![Some(true)], vec![None]], &[3.0, 1.0]).unwrap();
        assert_eq!(found.at_least, [Some(1.0), None]);
        assert_eq!(found.at_least_bounds, [[1.0, 1.0], [0.0, 1.0]]);
        assert_eq!((found.at_least_independent, found.mean_volume), (None, None));
        assert_eq!((found.largest_volume, found.mean_volume_bounds), (3.0, [3.0, 4.0]));
    }

    /// Equal shares are the binomial distribution: P(at least 2 of 4), p = 0.3, is 0.3483.
    #[test]
    fn equal_shares_are_binomial() {
        let found = independent(&[0.3; 4]);
        assert!((found[1] - 0.3483).abs() < 1e-12);
    }
}
