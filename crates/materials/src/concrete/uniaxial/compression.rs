//! Compression of one axis: envelope and unloading.
//!
//! With s = −ε ≥ 0, x = s/ε_c1 and k = 1.05 E ε_c1/f_c (Sargin 1971, as in EN 1992-1-1, eq. (3.14)):
//!
//! ```text
//! σ/f_c = (k x − x²)/(1 + (k − 2) x)                     up to the peak, x = 1
//!         linear to 0.2 at s_u, then constant            crushing
//! s_u   = ε_c1 + G_c/(0.6 f_c h) − 0.8 f_c/E
//! ```
//!
//! G_c is the work done after the peak on the inelastic displacement h (s − σ/E), as G_f is for a crack: the unloading of
//! the element itself does not count, and the energy of a localised zone does not depend on h.
//!
//! Unloading is straight, from (s, σ) to the plastic strain s_p of Karsan & Jirsa (1969) and back on the same line:
//!
//! ```text
//! g(x) = (s − s_p)/ε_c1 = x − 0.145 x² − 0.13 x          x ≤ 3; g = g(3) = 1.305 beyond, where g' = 0
//! s − s_p ≥ σ/(1.05 E)
//! ```
//!
//! The two limits are additions. Beyond x = 3 the plastic strain of the fitted parabola approaches the strain itself
//! and the stiffness rises again; below x ≈ 0.3 its unloading is stiffer than the first loading. With them the
//! unloading modulus only falls, and the dissipation D(s) = ∫σ ds − ½ σ (s − s_p) only grows.

use crate::check::{found, positive};
use crate::{LawError, refuse};

/// Residual stress after crushing, as a share of f_c.
const RESIDUAL: f64 = 0.2;

/// x from which the elastic part of the strain no longer grows: the zero of 0.87 − 0.29 x.
const LAST: f64 = 3.0;

/// Branch after the peak of the compressive stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PostPeak {
    /// Linear to 0.2 f_c, by energy.
    Crushing {
        /// Crushing energy G_c [N/m] > 0, about 250 G_f.
        crushing_energy: f64,
        /// Length h of the crushing zone [m] (element, or integration length of a beam), below 0.98 E G_c/(0.48 f_c²).
        size: f64,
    },
    /// Linear to 0.2 f_c at this strain, above ε_c1.
    Linear {
        /// Strain, positive.
        strain: f64,
    },
    /// Sargin's curve continues to this strain, at least ε_c1 (or to 0.2 f_c, if that comes first); then constant.
    Curve {
        /// Strain, positive.
        strain: f64,
    },
}

/// Envelope of the Sargin type, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Envelope {
    strength: f64,
    peak_strain: f64,
    k: f64,
    /// x at which the curve ends.
    curve_end: f64,
    /// x at which the line ends.
    line_end: f64,
    /// Stress at the end of the line [Pa].
    residual: f64,
    /// Slope of the line [Pa].
    slope: f64,
    /// 1.05 E [Pa].
    pub initial: f64,
}

impl Envelope {
    // Long: three branches, each with the check that it exists.
    pub(crate) fn new(
        law: &'static str,
        young_modulus: f64,
        strength: f64,
        peak_strain: f64,
        post: PostPeak,
    ) -> Result<Envelope, LawError> {
        positive(law, "peak_strain", peak_strain, "")?;
        let k = 1.05 * young_modulus * peak_strain / strength;
        if k <= 1.0 {
            return Err(refuse(
                law,
                "peak_strain",
                peak_strain.to_string(),
                &format!("> {:.3e} (f_c/(1.05 E))", strength / (1.05 * young_modulus)),
            ));
        }
        let linear = |strain: f64| Envelope {
            strength,
            peak_strain,
            k,
            curve_end: 1.0,
            line_end: strain / peak_strain,
            residual: RESIDUAL * strength,
            slope: -(1.0 - RESIDUAL) * strength / (strain - peak_strain),
            initial: 1.05 * young_modulus,
        };
        match post {
            PostPeak::Crushing { crushing_energy, size } => {
                positive(law, "crushing_energy", crushing_energy, "N/m")?;
                positive(law, "size", size, "m")?;
                let bound = 0.98 * young_modulus * crushing_energy / (0.48 * strength * strength);
                if size > bound {
                    return Err(refuse(
                        law,
                        "size",
                        found(size, "m"),
                        &format!(
                            "at most {bound:.4} m (0.98 E G_c/(0.48 f_c²): a longer zone snaps back when it crushes)"
                        ),
                    ));
                }
                Ok(linear(peak_strain + crushing_energy / (0.6 * strength * size) - 0.8 * strength / young_modulus))
            }
            PostPeak::Linear { strain } => {
                if !(strain > peak_strain && strain.is_finite()) {
                    return Err(refuse(
                        law,
                        "post_peak strain",
                        strain.to_string(),
                        &format!("> {peak_strain:.3e} and finite"),
                    ));
                }
                Ok(linear(strain))
            }
            PostPeak::Curve { strain } => {
                if !(strain >= peak_strain && strain.is_finite()) {
                    return Err(refuse(
                        law,
                        "post_peak strain",
                        strain.to_string(),
                        &format!("≥ {peak_strain:.3e} and finite"),
                    ));
                }
                // k x − x² = r (1 + (k − 2) x), the larger root; it lies before the pole, as r > 0.
                let half = 0.5 * (k - RESIDUAL * (k - 2.0));
                let fallen = half + (half * half - RESIDUAL).sqrt();
                let end = fallen.min(strain / peak_strain);
                let mut envelope = Envelope { curve_end: end, line_end: end, slope: 0.0, ..linear(2.0 * peak_strain) };
                envelope.residual = envelope.curve(end).0;
                Ok(envelope)
            }
        }
    }

    /// Stress and slope [Pa] of the curve.
    #[inline]
    fn curve(&self, x: f64) -> (f64, f64) {
        let (k, a) = (self.k, self.k - 2.0);
        let inverse = 1.0 / (1.0 + a * x);
        let y = (k * x - x * x) * inverse;
        (self.strength * y, self.strength / self.peak_strain * (k - 2.0 * x - a * y) * inverse)
    }

    /// Stress and slope [Pa] at a first strain s ≥ 0.
    #[inline]
    pub(crate) fn at(&self, s: f64) -> (f64, f64) {
        let x = s / self.peak_strain;
        if x <= self.curve_end {
            self.curve(x)
        } else if x < self.line_end {
            (self.residual + self.slope * (s - self.line_end * self.peak_strain), self.slope)
        } else {
            (self.residual, 0.0)
        }
    }

    /// Elastic part s − s_p of the strain s with envelope stress σ.
    #[inline]
    pub(crate) fn recoverable(&self, s: f64, stress: f64) -> f64 {
        let x = (s / self.peak_strain).min(LAST);
        (self.peak_strain * (0.87 - 0.145 * x) * x).max(stress / self.initial)
    }

    /// ∫σ ds [J/m³] from s_0 (stress σ_0) to s_1 (σ_1) along the envelope: Simpson's rule on the curve, exact on the lines.
    #[inline]
    pub(crate) fn work(&self, (s_0, sigma_0): (f64, f64), (s_1, sigma_1): (f64, f64)) -> f64 {
        let simpson = |a: f64, at_a: f64, b: f64, at_b: f64| {
            (b - a) / 6.0 * (at_a + 4.0 * self.curve(0.5 * (a + b) / self.peak_strain).0 + at_b)
        };
        let (mut from, mut total) = ((s_0, sigma_0), 0.0);
        let curve_end = self.curve_end * self.peak_strain;
        if s_1 <= curve_end {
            return simpson(s_0, sigma_0, s_1, sigma_1);
        }
        if s_0 < curve_end {
            let at_end = self.curve(self.curve_end).0;
            total += simpson(s_0, sigma_0, curve_end, at_end);
            from = (curve_end, at_end);
        }
        let line_end = self.line_end * self.peak_strain;
        if from.0 < line_end && s_1 > line_end {
            total += 0.5 * (line_end - from.0) * (from.1 + self.residual);
            from = (line_end, self.residual);
        }
        total + 0.5 * (s_1 - from.0) * (from.1 + sigma_1)
    }
}
