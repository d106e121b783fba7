//! Ground motion: a uniformly sampled acceleration record, and its measures.
//!
//! The acceleration is taken as linear between samples; velocity and displacement are its exact integrals from rest,
//! **without baseline correction**: the measures are those of the motion used by the engine.
//! [`Measures::final_velocity`] shows whether the velocity returns to zero.

use serde::{Deserialize, Serialize};

use crate::STANDARD_GRAVITY;

/// Ground acceleration at a uniform step, as used in the analysis (after scaling, stretching and resampling).
///
/// The acceleration is linear between samples, and zero before the first and after the last one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Name (file stem unless the format carries one).
    pub name: String,
    /// Time step Δt [s].
    pub dt: f64,
    /// Ground acceleration a_g [m/s²].
    pub acceleration: Vec<f64>,
    /// Processing steps, in order, in words for the report ("scaled to 0.5 g (factor 1.4368)").
    pub processing: Vec<String>,
}

/// Ground velocity and displacement at the samples, from rest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Velocity [m/s].
    pub velocity: Vec<f64>,
    /// Displacement [m].
    pub displacement: Vec<f64>,
}

/// Measures of a record; all integrals are exact for acceleration that is linear between samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measures {
    /// Peak ground acceleration max |a| [m/s²].
    pub pga: f64,
    /// Peak ground velocity max |∫ a dt| [m/s], between samples too, no baseline correction.
    pub pgv: f64,
    /// Peak ground displacement max |∬ a dt²| [m], between samples too, no baseline correction.
    pub pgd: f64,
    /// Arias intensity π/(2g) ∫ a² dt [m/s], g = 9.80665 m/s² (Arias 1970).
    pub arias: f64,
    /// Cumulative absolute velocity ∫ |a| dt [m/s] (EPRI 1988).
    pub cav: f64,
    /// Significant duration D5-95 [s]: time between 5 % and 95 % of the Arias intensity (Trifunac & Brady 1975).
    pub significant_duration: f64,
    /// Time at which 5 % of the Arias intensity is reached [s].
    pub significant_start: f64,
    /// Velocity at the last sample [m/s]; far from zero in a record without baseline correction.
    pub final_velocity: f64,
    /// Displacement at the last sample [m].
    pub final_displacement: f64,
}

impl Record {
    /// Largest absolute acceleration [m/s²].
    pub fn pga(&self) -> f64 {
        self.acceleration.iter().fold(0.0, |m, a| a.abs().max(m))
    }

    /// Time of the last sample [s].
    pub fn duration(&self) -> f64 {
        self.dt * (self.acceleration.len().saturating_sub(1)) as f64
    }

    /// Velocity and displacement of the ground at the samples.
    ///
    /// ```text
    /// v₁ = v₀ + h (a₀ + a₁)/2        d₁ = d₀ + h v₀ + h² (2 a₀ + a₁)/6
    /// ```
    pub fn motion(&self) -> Motion {
        let mut motion = Motion::default();
        let (mut v, mut d) = (0.0, 0.0);
        for (k, &a1) in self.acceleration.iter().enumerate() {
            if k > 0 {
                let a0 = self.acceleration[k - 1];
                d += self.dt * (v + self.dt * (2.0 * a0 + a1) / 6.0);
                v += self.dt * (a0 + a1) / 2.0;
            }
            motion.velocity.push(v);
            motion.displacement.push(d);
        }
        motion
    }

    /// Measures of this record.
    ///
    /// Check: a_g = A sin Ωt over whole periods gives PGA = A, PGV = 2A/Ω, Arias π A² t/(4 g), CAV = 2 A t/π.
    pub fn measures(&self) -> Measures {
        let h = self.dt;
        let motion = self.motion();
        let (mut pgv, mut pgd, mut energy, mut cav) = (0.0f64, 0.0f64, 0.0, 0.0);
        for (k, pair) in self.acceleration.windows(2).enumerate() {
            let (a0, a1) = (pair[0], pair[1]);
            let (v0, d0) = (motion.velocity[k], motion.displacement[k]);
            pgv = pgv.max(motion.velocity[k + 1].abs());
            pgd = pgd.max(motion.displacement[k + 1].abs());
            energy += energy_to(a0, a1, h, h);
            if a0 * a1 < 0.0 {
                let zero = h * a0 / (a0 - a1);
                pgv = pgv.max((v0 + a0 * zero / 2.0).abs());
                cav += (a0.abs() * zero + a1.abs() * (h - zero)) / 2.0;
            } else {
                cav += h * (a0 + a1).abs() / 2.0;
            }
            for zero in turning_points(v0, a0, (a1 - a0) / h) {
                if zero > 0.0 && zero < h {
                    let slope = (a1 - a0) / h;
                    pgd = pgd.max((d0 + zero * (v0 + zero * (a0 / 2.0 + zero * slope / 6.0))).abs());
                }
            }
        }
        let start = self.time_of_energy(0.05 * energy);
        Measures {
            pga: self.pga(),
            pgv,
            pgd,
            arias: std::f64::consts::PI / (2.0 * STANDARD_GRAVITY) * energy,
            cav,
            significant_duration: self.time_of_energy(0.95 * energy) - start,
            significant_start: start,
            final_velocity: motion.velocity.last().copied().unwrap_or(0.0),
            final_displacement: motion.displacement.last().copied().unwrap_or(0.0),
        }
    }

    /// Time at which ∫ a² dt reaches `target` [s]; else the end of the record.
    fn time_of_energy(&self, target: f64) -> f64 {
        let h = self.dt;
        let mut sum = 0.0;
        for (k, pair) in self.acceleration.windows(2).enumerate() {
            let part = energy_to(pair[0], pair[1], h, h);
            if sum + part >= target && part > 0.0 {
                // The integral grows monotonically within the step: bisect to the last bit.
                let (mut low, mut high) = (0.0, h);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if sum + energy_to(pair[0], pair[1], h, middle) < target {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                return k as f64 * h + high;
            }
            sum += part;
        }
        self.duration()
    }
}

/// ∫₀ᵗ a² dτ for a = a₀ + (a₁ − a₀) τ/h.
fn energy_to(a0: f64, a1: f64, h: f64, t: f64) -> f64 {
    let a = a0 + (a1 - a0) * (t / h);
    t * (a0 * a0 + a0 * a + a * a) / 3.0
}

/// Zeros of v₀ + a₀ τ + s τ²/2 (NaN if a zero does not exist).
fn turning_points(v0: f64, a0: f64, slope: f64) -> [f64; 2] {
    let root = (a0 * a0 - 2.0 * slope * v0).sqrt();
    // q avoids the cancellation of −a₀ ± root; it also covers slope = 0, where one zero is infinite.
    let q = -(a0 + root.copysign(a0));
    [q / slope, 2.0 * v0 / q]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn record(dt: f64, acceleration: Vec<f64>) -> Record {
        Record { name: "test".into(), dt, acceleration, processing: vec![] }
    }

    #[test]
    fn measures_of_a_triangle() {
        // 0, 2, −2, 0 m/s² at 1 s: velocity 0, 1, 1, 0 with its peak 1.5 at t = 1.5 s; displacement 1/3 at 1 s.
        let m = record(1.0, vec![0.0, 2.0, -2.0, 0.0]).measures();
        assert_eq!(m.pga, 2.0);
        assert!((m.pgv - 1.5).abs() < 1e-15);
        // d(3) = 1/3 + (1 + 2/6) + (1 − 4/6) = 2, reached with zero velocity.
        assert!((m.pgd - 2.0).abs() < 1e-15 && (m.final_displacement - 2.0).abs() < 1e-15);
        assert!(m.final_velocity.abs() < 1e-15);
        // ∫a² = 4/3 + 4/3 + 4/3; ∫|a| = 1 + 1 + 1.
        assert!((m.arias - PI / (2.0 * STANDARD_GRAVITY) * 4.0).abs() < 1e-15);
        assert!((m.cav - 3.0).abs() < 1e-15);
        // Symmetric: 5 % of 4 is reached at t³ 4/3 = 0.2.
        assert!((m.significant_start - 0.15f64.cbrt()).abs() < 1e-12);
        assert!((m.significant_duration - (3.0 - 2.0 * 0.15f64.cbrt())).abs() < 1e-12);
    }

    #[test]
    fn zeros_of_a_parabola() {
        // (1 − τ)(3 − τ), (4 − τ)(2 + τ), and the line 6 − 2 τ, whose other zero is infinite.
        assert_eq!(turning_points(3.0, -4.0, 2.0), [3.0, 1.0]);
        assert_eq!(turning_points(8.0, 2.0, -2.0), [4.0, -2.0]);
        assert_eq!(turning_points(6.0, -2.0, 0.0), [f64::INFINITY, 3.0]);
        // 1 + τ² has no root.
        assert!(turning_points(1.0, 0.0, 2.0).iter().all(|t| t.is_nan()));
    }

    #[test]
    fn displacement_peaks_between_samples() {
        // v₀ = 1 after the first pulse, then a = −2 constant: v = 0 at τ = 0.5, d = 0.5 + 0.25.
        let m = record(1.0, vec![2.0, 0.0, -2.0, -2.0]).measures();
        // a from 2 to 0: v = 1, d = 2/3; then 0 to −2: v = 1 − τ², zero at τ = 1; d = 2/3 + 1 − 1/3 = 4/3.
        assert!((m.pgd - 4.0 / 3.0).abs() < 1e-15, "{}", m.pgd);
        let m = record(1.0, vec![1.0, 1.0, -2.0, -2.0]).measures();
        // v = 1, d = 0.5 at 1 s; then v = 1 + τ − 1.5 τ² = 0 at τ = (1 + √7)/3 > 1; at 2 s v = 0.5, d = 0.5 + 1 + 0 = 1.5;
        // then a = −2: v = 0 at τ = 0.25, d = 1.5 + 0.125 − 0.0625.
        assert!((m.pgd - 1.5625).abs() < 1e-15, "{}", m.pgd);
    }

    #[test]
    fn measures_of_a_harmonic() {
        // 10 periods of 0.5 s at 1 ms; the linear interpolation is short by (Ωh)²/12 = 1.3e-5 of the integrals.
        let (amplitude, omega, dt) = (3.0, TAU / 0.5, 1e-3);
        let m = record(dt, (0..=5000).map(|k| amplitude * (omega * dt * f64::from(k)).sin()).collect()).measures();
        for (value, exact) in [
            (m.pga, amplitude),
            (m.pgv, 2.0 * amplitude / omega),
            (m.pgd, amplitude / omega * 5.0),
            (m.arias, PI * amplitude * amplitude * 5.0 / (4.0 * STANDARD_GRAVITY)),
            (m.cav, 2.0 * amplitude * 5.0 / PI),
            (m.significant_duration, 4.5),
        ] {
            // D5-95 of whole periods: 5 % is half a period, where the intensity grows evenly by symmetry.
            assert!((value / exact - 1.0).abs() < 5e-5, "{value} against {exact}");
        }
    }

    #[test]
    fn silence_has_no_measures() {
        let m = record(0.01, vec![0.0; 5]).measures();
        assert_eq!((m.pga, m.pgv, m.pgd, m.arias, m.cav), (0.0, 0.0, 0.0, 0.0, 0.0));
        assert!(m.significant_duration.abs() < 1e-15);
    }
}
