//! Time steps of a response analysis, and ground motion on them.
//!
//! Histories are kept at the samples of the horizontal record; in between, `sub_steps` steps are taken. After the
//! record the ground is at rest and the response continues, because slow sloshing may peak later.

use oscillator::record::Record;

/// Samples and sub-steps of an analysis, from t = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Step of the samples [s].
    pub dt: f64,
    /// Steps taken from one sample to the next, at least 1.
    pub sub_steps: usize,
    /// Number of samples, at least 2.
    pub samples: usize,
}

impl Grid {
    /// The samples of records `duration` [s] long plus `tail` [s] of free vibration, in sub-steps of at most
    /// `longest_step` [s].
    pub fn new(dt: f64, duration: f64, tail: f64, longest_step: f64) -> Grid {
        Grid {
            dt,
            // A sub-step that is too long by rounding alone is accepted.
            sub_steps: ((dt / longest_step - 1e-9).ceil() as usize).max(1),
            samples: ((((duration + tail) / dt) - 1e-9).ceil() as usize).max(1) + 1,
        }
    }

    /// Length of a sub-step [s].
    pub fn h(&self) -> f64 {
        self.dt / self.sub_steps as f64
    }

    /// Number of sub-steps in all.
    pub fn steps(&self) -> usize {
        (self.samples - 1) * self.sub_steps
    }

    /// Time of the end of sub-step `i` [s].
    pub fn time(&self, i: usize) -> f64 {
        (i / self.sub_steps) as f64 * self.dt + (i % self.sub_steps) as f64 * self.h()
    }
}

/// Ground acceleration at the ends of the sub-steps: linear within them, zero after the last sample of the record.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    acceleration: Vec<f64>,
}

impl Motion {
    /// `record` on `grid`. Exact if the record's step is that of the grid, or a multiple of a sub-step; else a sub-step in
    /// which the record has a kink is linearised.
    pub fn new(record: &Record, grid: &Grid) -> Motion {
        Motion::sampled(record.dt, &record.acceleration, grid)
    }

    /// Samples `dt` [s] apart on `grid`, as [`Motion::new`]. Serves for the time function of a force as well.
    pub fn sampled(dt: f64, a: &[f64], grid: &Grid) -> Motion {
        let duration = dt * a.len().saturating_sub(1) as f64;
        let last = ((duration / grid.h() + 1e-6).floor() as usize).min(grid.steps());
        let value = |i: usize| {
            if dt == grid.dt {
                let (k, rest) = (i / grid.sub_steps, i % grid.sub_steps);
                let s = rest as f64 / grid.sub_steps as f64;
                if rest == 0 { a[k] } else { a[k] + s * (a[k + 1] - a[k]) }
            } else {
                let s = (grid.time(i) / dt).min((a.len() - 1) as f64);
                let k = (s as usize).min(a.len().saturating_sub(2));
                let next = a.get(k + 1).copied().unwrap_or(a[k]);
                a[k] + (s - k as f64) * (next - a[k])
            }
        };
        Motion { acceleration: if a.is_empty() { Vec::new() } else { (0..=last).map(value).collect() } }
    }

    /// Acceleration at the end of sub-step `i` [m/s²].
    pub fn at(&self, i: usize) -> f64 {
        self.acceleration.get(i).copied().unwrap_or(0.0)
    }

    /// Accelerations at both ends of the sub-step from `i` to `i` + 1, taken inside it: zero after the record, even if
    /// its last sample is not.
    pub fn interval(&self, i: usize) -> (f64, f64) {
        match self.acceleration.get(i + 1) {
            Some(&end) => (self.acceleration[i], end),
            None => (0.0, 0.0),
        }
    }

    /// Sub-step whose end is the last sample of the record.
    pub fn last(&self) -> usize {
        self.acceleration.len().saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(dt: f64, acceleration: &[f64]) -> Record {
        Record { name: "test".into(), dt, acceleration: acceleration.to_vec(), processing: Vec::new() }
    }

    #[test]
    fn sub_steps_are_short_enough_and_cover_the_tail() {
        let grid = Grid::new(0.02, 1.0, 0.5, 0.006);
        assert_eq!((grid.sub_steps, grid.samples), (4, 76));
        assert!((grid.time(grid.steps()) - 1.5).abs() < 1e-12);
        assert_eq!(Grid::new(0.02, 1.0, 0.0, 0.02).sub_steps, 1);
    }

    #[test]
    fn ground_is_linear_between_samples_and_rests_after_the_last() {
        let grid = Grid::new(0.1, 0.2, 0.2, 0.05);
        let motion = Motion::new(&record(0.1, &[0.0, 1.0, -1.0]), &grid);
        let found: Vec<f64> = (0..=grid.steps()).map(|i| motion.at(i)).collect();
        for (f, e) in found.iter().zip([0.0, 0.5, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0]) {
            assert!((f - e).abs() < 1e-12, "{found:?}");
        }
        assert_eq!(motion.interval(3), (motion.at(3), -1.0));
        assert_eq!(motion.interval(4), (0.0, 0.0));
    }

    /// A vertical record of another step: the same straight line, whatever its sampling.
    #[test]
    fn other_steps_are_interpolated() {
        let grid = Grid::new(0.02, 0.2, 0.0, 0.01);
        let line: Vec<f64> = (0..=8).map(|k| 2.5 * f64::from(k) * 0.025).collect();
        let motion = Motion::new(&record(0.025, &line), &grid);
        for i in 0..=grid.steps() {
            assert!((motion.at(i) - 2.5 * grid.time(i)).abs() < 1e-12);
        }
    }
}
