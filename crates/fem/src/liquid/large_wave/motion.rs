//! What moves the tank: accelerations of its frame, a small rotation, a record of them.

/// Motion of the tank's frame at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Acceleration of the floor's centre along x and y [m/s²].
    pub acceleration: [f64; 2],
    /// Vertical acceleration, upwards [m/s²].
    pub vertical: f64,
    /// Small rotation about the floor's centre that moves the rim along x and along y [rad].
    pub tilt: [f64; 2],
    /// Its second derivative [rad/s²].
    pub angular: [f64; 2],
}

impl Motion {
    /// Horizontal acceleration along x only [m/s²].
    pub fn along_x(acceleration: f64) -> Motion {
        Motion { acceleration: [acceleration, 0.0], ..Motion::default() }
    }

    pub(super) fn combine(terms: [(f64, Motion); 3]) -> Motion {
        let mut sum = Motion::default();
        for (factor, motion) in terms {
            sum.vertical += factor * motion.vertical;
            for d in 0..2 {
                sum.acceleration[d] += factor * motion.acceleration[d];
                sum.tilt[d] += factor * motion.tilt[d];
                sum.angular[d] += factor * motion.angular[d];
            }
        }
        sum
    }
}

/// Motion as the march reads it: at the start, the middle and the end of a step.
pub trait Drive {
    /// Motion from `time` to `time + step` [s].
    fn over(&self, time: f64, step: f64) -> [Motion; 3];

    /// Motion at an instant.
    fn now(&self, time: f64) -> Motion;
}

impl<F: Fn(f64) -> Motion> Drive for F {
    fn over(&self, time: f64, step: f64) -> [Motion; 3] {
        [self(time), self(time + 0.5 * step), self(time + step)]
    }

    fn now(&self, time: f64) -> Motion {
        self(time)
    }
}

/// A record of equal steps, linear between its samples, zero outside.
///
/// A step of the liquid is longer than one of the record. It reads the parabola with the mean and the first two moments of the
/// record over the step, so that shaking faster than the steps neither is lost nor returns as a slow one.
#[derive(Clone, Debug)]
pub struct Sampled {
    step: f64,
    samples: Vec<Motion>,
}

impl Sampled {
    /// The record of these samples, the first at time zero; `step` [s], positive.
    pub fn new(step: f64, samples: Vec<Motion>) -> Sampled {
        Sampled { step, samples }
    }

    /// Duration [s].
    pub fn duration(&self) -> f64 {
        self.step * self.samples.len().saturating_sub(1) as f64
    }

    /// The motion at an instant.
    pub fn at(&self, time: f64) -> Motion {
        let place = time / self.step;
        if self.samples.is_empty() || place < 0.0 || place > (self.samples.len() - 1) as f64 {
            return Motion::default();
        }
        let first = place.floor() as usize;
        let second = (first + 1).min(self.samples.len() - 1);
        let part = place - first as f64;
        Motion::combine([(1.0 - part, self.samples[first]), (part, self.samples[second]), (0.0, Motion::default())])
    }
}

impl Drive for Sampled {
    fn over(&self, time: f64, step: f64) -> [Motion; 3] {
        // Moments with Legendre's polynomials 1, s, (3s² − 1)/2 of s = −1 to 1; Simpson's rule is exact between two samples.
        let mut moments = [Motion::default(); 3];
        let end = time + step;
        let mut from = time;
        while from < end - 1e-12 * step {
            let next = ((from / self.step + 1e-9).floor() + 1.0) * self.step;
            let to = next.min(end);
            for (place, weight) in [(from, 1.0), (0.5 * (from + to), 4.0), (to, 1.0)] {
                let s = 2.0 * (place - time) / step - 1.0;
                let motion = self.at(place);
                let w = weight * (to - from) / (6.0 * step);
                for (moment, polynomial) in moments.iter_mut().zip([1.0, 3.0 * s, 2.5 * (3.0 * s * s - 1.0)]) {
                    *moment = Motion::combine([(1.0, *moment), (w * polynomial, motion), (0.0, motion)]);
                }
            }
            from = to;
        }
        let [c0, c1, c2] = moments;
        [
            Motion::combine([(1.0, c0), (-1.0, c1), (1.0, c2)]),
            Motion::combine([(1.0, c0), (0.0, c1), (-0.5, c2)]),
            Motion::combine([(1.0, c0), (1.0, c1), (1.0, c2)]),
        ]
    }

    fn now(&self, time: f64) -> Motion {
        self.at(time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_has_the_moments_of_the_record() {
        let samples: Vec<f64> = (0..40).map(|i| f64::from(i * i % 17) - 5.0).collect();
        let record = Sampled::new(0.01, samples.iter().map(|&a| Motion::along_x(a)).collect());
        let [a, b, c] = record.over(0.03, 0.1).map(|m| m.acceleration[0]);
        // Mean and first moment by the trapezoidal rule on a hundredth of a sample.
        let n = 1000;
        let (mut mean, mut first) = (0.0, 0.0);
        for i in 0..n {
            let s = (f64::from(i) + 0.5) / f64::from(n);
            let value = record.at(0.03 + 0.1 * s).acceleration[0] / f64::from(n);
            mean += value;
            first += value * s;
        }
        assert!(((a + 4.0 * b + c) / 6.0 - mean).abs() < 1e-3 * mean.abs(), "{mean}");
        assert!(((4.0 * b * 0.5 + c) / 6.0 - first).abs() < 1e-3 * first.abs(), "{first}");
    }
}
