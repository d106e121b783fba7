//! Viscous damping.
//!
//! ```text
//! C = a_M M + a_K K + C_s + W D Wᵀ
//! ```
//!
//! * a_M M + a_K K: **Rayleigh** damping, never formed: it adds no cost to a step.
//! * C_s: a sparse matrix on the model's pattern: Rayleigh coefficients **by group** of elements, and **dashpots** (given as a matrix).
//! * W D Wᵀ with W = M Φ: **modal** damping (Caughey), never formed either. With M-normalised modes,
//!
//! ```text
//! C = M [Σ (2 ξ_n ω_n − a_M − a_K ω_n²) φ_n φ_nᵀ] M + a_M M + a_K K
//! ```
//!
//! gives each mode n the ratio ξ_n exactly, and all others (a_M/ω + a_K ω)/2. Caughey's series in powers of M⁻¹K is the
//! same matrix in a form that is dense, ill-conditioned beyond four terms, and may be negative between its nodes.
//!
//! # Rayleigh's coefficients
//!
//! ```text
//! ξ(ω) = (a_M/ω + a_K ω)/2
//! a_M = 2 ω₁ω₂ (ω₂ ξ₁ − ω₁ ξ₂)/(ω₂² − ω₁²)        a_K = 2 (ω₂ ξ₂ − ω₁ ξ₁)/(ω₂² − ω₁²)
//! ```
//!
//! With ω₁ < ω₂ both coefficients are ≥ 0 if and only if ω₁/ω₂ ≤ ξ₂/ξ₁ ≤ ω₂/ω₁. Outside, one of them is negative: energy
//! is fed into all modes below (a_M < 0) or above (a_K < 0) √(−a_M/a_K).
//!
//! Source: Caughey 1960; Clough & Penzien 1993, sections 12-5 and 12-6.

use crate::assembly::Assembler;
use crate::element::ElementError;
use crate::linalg::{Eigen, Matrix, Symmetric, dot};
use crate::model::Model;

/// Ratios above this are flagged in the table.
pub const HIGH: f64 = 0.20;
/// Ratios below this are flagged in the table.
pub const LOW: f64 = 0.001;

/// Damping that is not admissible.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{option}: found {found}, allowed {allowed}")]
pub struct DampingError {
    /// Which damping.
    pub option: &'static str,
    /// Found.
    pub found: String,
    /// Allowed.
    pub allowed: String,
}

/// Coefficients of C = a_M M + a_K K.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rayleigh {
    /// a_M [1/s].
    pub mass: f64,
    /// a_K [s].
    pub stiffness: f64,
}

impl Rayleigh {
    /// No damping.
    pub const NONE: Rayleigh = Rayleigh { mass: 0.0, stiffness: 0.0 };

    /// Mass-proportional damping: the ratio `ratio` at `omega` [rad/s], falling with 1/ω.
    pub fn mass_proportional(omega: f64, ratio: f64) -> Rayleigh {
        Rayleigh { mass: 2.0 * ratio * omega, stiffness: 0.0 }
    }

    /// Stiffness-proportional damping: the ratio `ratio` at `omega` [rad/s], growing with ω.
    pub fn stiffness_proportional(omega: f64, ratio: f64) -> Rayleigh {
        Rayleigh { mass: 0.0, stiffness: 2.0 * ratio / omega }
    }

    /// Coefficients that give the ratios of two (circular frequency [rad/s], ratio) pairs.
    ///
    /// Errors: a frequency that is not positive, equal frequencies, a negative ratio; unless `allow_negative`, a negative
    /// coefficient, with the admissible range of ξ₂/ξ₁.
    pub fn fit(first: (f64, f64), second: (f64, f64), allow_negative: bool) -> Result<Rayleigh, DampingError> {
        let refuse =
            |found: String, allowed: &str| DampingError { option: "Rayleigh damping", found, allowed: allowed.into() };
        for (omega, ratio) in [first, second] {
            if !(omega > 0.0 && omega.is_finite()) {
                return Err(refuse(format!("circular frequency {omega} rad/s"), "a positive number"));
            }
            if !(0.0..1.0).contains(&ratio) {
                return Err(refuse(format!("damping ratio {ratio}"), "0 to 1"));
            }
        }
        let ((w1, x1), (w2, x2)) = if first.0 <= second.0 { (first, second) } else { (second, first) };
        let span = (w2 - w1) * (w2 + w1);
        if span <= 1e-9 * w2 * w2 {
            return Err(refuse(format!("both frequencies at {w1} rad/s"), "two different frequencies"));
        }
        let rayleigh =
            Rayleigh { mass: 2.0 * w1 * w2 * (w2 * x1 - w1 * x2) / span, stiffness: 2.0 * (w2 * x2 - w1 * x1) / span };
        if rayleigh.is_negative() && !allow_negative {
            return Err(refuse(
                format!(
                    "ratios {x1} at {w1} rad/s and {x2} at {w2} rad/s, which give a_M = {:.4} 1/s, a_K = {:.4e} s \
                     (a negative coefficient feeds energy into modes)",
                    rayleigh.mass, rayleigh.stiffness
                ),
                &format!(
                    "a quotient of the ratios from {:.4} to {:.4} (upper frequency's over lower frequency's)",
                    w1 / w2,
                    w2 / w1
                ),
            ));
        }
        Ok(rayleigh)
    }

    /// ξ(ω) = (a_M/ω + a_K ω)/2.
    pub fn ratio(&self, omega: f64) -> f64 {
        0.5 * (self.mass / omega + self.stiffness * omega)
    }

    /// Whether a coefficient is negative.
    pub fn is_negative(&self) -> bool {
        self.mass < 0.0 || self.stiffness < 0.0
    }
}

/// Remark on a ratio; empty for ordinary ratios.
pub fn remark(ratio: f64) -> &'static str {
    if ratio < 0.0 {
        "negative: energy is fed into the mode"
    } else if ratio < LOW {
        "below 0.1 %: practically undamped"
    } else if ratio >= 1.0 {
        "over-critical: the mode does not vibrate"
    } else if ratio > HIGH {
        "above 20 %: the mode is largely suppressed"
    } else {
        ""
    }
}

/// Ratio of one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioRow {
    /// Number of the mode, from 0.
    pub mode: usize,
    /// ω [rad/s].
    pub omega: f64,
    /// ξ.
    pub ratio: f64,
    /// Its [`remark`].
    pub note: &'static str,
}

/// The part W D Wᵀ, with D diagonal.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalPart {
    /// W = M Φ, a column a mode.
    pub momenta: Matrix,
    /// Diagonal of D [1/s]; no zeros.
    pub rates: Vec<f64>,
}

/// A damping matrix as a sum that is not formed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Damping {
    /// a_M and a_K over all the model.
    pub rayleigh: Rayleigh,
    /// C_s.
    pub sparse: Option<Symmetric>,
    /// Coefficients of the elements that are not assembled, besides those over all the model.
    pub operators: Rayleigh,
    /// W D Wᵀ.
    pub modal: Option<ModalPart>,
}

impl Damping {
    /// No damping.
    pub fn none() -> Damping {
        Damping::default()
    }

    /// a_M M + a_K K over all the model.
    pub fn rayleigh(rayleigh: Rayleigh) -> Damping {
        Damping { rayleigh, ..Damping::default() }
    }

    /// Rayleigh's coefficients by group of elements (`coefficients[group]`), and the elements' own damping (dashpots).
    ///
    /// Errors: those of the elements; a negative coefficient unless `allow_negative`.
    pub fn by_group(
        assembler: &Assembler,
        model: &Model,
        coefficients: &[Rayleigh],
        allow_negative: bool,
    ) -> Result<Damping, super::AnalysisError> {
        for (group, c) in coefficients.iter().enumerate() {
            let finite = c.mass.is_finite() && c.stiffness.is_finite();
            if !finite || (c.is_negative() && !allow_negative) {
                return Err(DampingError {
                    option: "Rayleigh damping by group",
                    found: format!(
                        "a_M = {} 1/s, a_K = {} s in group {}",
                        c.mass,
                        c.stiffness,
                        model.groups().get(group).map_or("?", String::as_str)
                    ),
                    allowed: "finite coefficients ≥ 0".into(),
                }
                .into());
            }
        }
        let of = |e: usize| coefficients.get(model.group_of(e)).copied().unwrap_or(Rayleigh::NONE);
        let mut c = assembler.damping(model);
        for (group, r) in coefficients.iter().enumerate() {
            let belongs = |e: usize| model.group_of(e) == group && of(e) == *r;
            if r.mass != 0.0 {
                c.add(r.mass, &assembler.mass_of(model, belongs));
            }
            if r.stiffness != 0.0 {
                let k = assembler.stiffness_of(model, belongs);
                c.add(
                    r.stiffness,
                    &k.map_err(|source: ElementError| super::AnalysisError::Element { number: group, source })?,
                );
            }
        }
        let operators: Vec<Rayleigh> = assembler.operators(model).map(|p| of(p.element)).collect();
        if operators.windows(2).any(|pair| pair[0] != pair[1]) {
            return Err(DampingError {
                option: "Rayleigh damping by group",
                found: format!("{operators:?} for elements that are not assembled"),
                allowed: "the same for all of them".into(),
            }
            .into());
        }
        Ok(Damping {
            sparse: c.values.iter().any(|v| *v != 0.0).then_some(c),
            operators: operators.first().copied().unwrap_or_default(),
            ..Damping::default()
        })
    }

    /// Coefficients of the elements that are not assembled.
    pub fn of_operators(&self) -> Rayleigh {
        Rayleigh {
            mass: self.rayleigh.mass + self.operators.mass,
            stiffness: self.rayleigh.stiffness + self.operators.stiffness,
        }
    }

    /// Adds a sparse matrix on the pattern of M and K (dashpots).
    pub fn add_sparse(&mut self, matrix: Symmetric) {
        match &mut self.sparse {
            Some(c) => c.add(1.0, &matrix),
            None => self.sparse = Some(matrix),
        }
    }

    /// Gives every one of the M-normalised `modes` its ratio; all other motion has `rest`.
    ///
    /// Errors: a negative coefficient in `rest`, a ratio outside 0 to 1, more ratios than modes.
    pub fn modal(mass: &Symmetric, modes: &Eigen, ratios: &[f64], rest: Rayleigh) -> Result<Damping, DampingError> {
        let refuse =
            |found: String, allowed: &str| DampingError { option: "modal damping", found, allowed: allowed.into() };
        if rest.is_negative() {
            return Err(refuse(
                format!("a_M = {} 1/s, a_K = {} s for the rest", rest.mass, rest.stiffness),
                "coefficients ≥ 0",
            ));
        }
        if ratios.len() > modes.omega.len() {
            return Err(refuse(
                format!("{} ratios", ratios.len()),
                &format!("at most one a mode, of which there are {}", modes.omega.len()),
            ));
        }
        if let Some(ratio) = ratios.iter().find(|x| !(0.0..1.0).contains(*x)) {
            return Err(refuse(format!("damping ratio {ratio}"), "0 to 1"));
        }
        let (mut data, mut rates) = (Vec::new(), Vec::new());
        for (j, (&ratio, &omega)) in ratios.iter().zip(&modes.omega).enumerate() {
            let rate = 2.0 * ratio * omega - rest.mass - rest.stiffness * omega * omega;
            if rate != 0.0 {
                data.extend(mass.times(modes.vectors.column(j)));
                rates.push(rate);
            }
        }
        let modal = (!rates.is_empty())
            .then(|| ModalPart { momenta: Matrix { rows: mass.size(), cols: rates.len(), data }, rates });
        Ok(Damping { rayleigh: rest, modal, ..Damping::default() })
    }

    /// y = C x.
    pub fn times(&self, mass: &Symmetric, stiffness: &Symmetric, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        self.add_sparse_product(mass, stiffness, 1.0, x, &mut y);
        if let Some(modal) = &self.modal {
            modal.add_product(x, &mut y);
        }
        y
    }

    /// y ← y + factor (C − W D Wᵀ) x: all but the modal part.
    pub fn add_sparse_product(&self, mass: &Symmetric, stiffness: &Symmetric, factor: f64, x: &[f64], y: &mut [f64]) {
        if self.rayleigh.mass != 0.0 {
            mass.add_product(factor * self.rayleigh.mass, x, y);
        }
        if self.rayleigh.stiffness != 0.0 {
            stiffness.add_product(factor * self.rayleigh.stiffness, x, y);
        }
        if let Some(c) = &self.sparse {
            c.add_product(factor, x, y);
        }
    }

    /// Ratios φᵀ C φ/(2 ω) of M-normalised modes; for damping that couples modes, the diagonal part.
    pub fn ratios(&self, mass: &Symmetric, stiffness: &Symmetric, modes: &Eigen) -> Vec<RatioRow> {
        let row = |(mode, &omega): (usize, &f64)| {
            let phi = modes.vectors.column(mode);
            let ratio = dot(phi, &self.times(mass, stiffness, phi)) / (2.0 * omega);
            RatioRow { mode, omega, ratio, note: remark(ratio) }
        };
        modes.omega.iter().enumerate().map(row).collect()
    }
}

impl ModalPart {
    /// y ← y + W D Wᵀ x.
    pub fn add_product(&self, x: &[f64], y: &mut [f64]) {
        for (j, rate) in self.rates.iter().enumerate() {
            let w = self.momenta.column(j);
            let factor = rate * dot(w, x);
            for (y, w) in y.iter_mut().zip(w) {
                *y += factor * w;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Dissertation example 8.1 as corrected in the theory of damping: a_M = −0.0600, a_K = 0.01320 for 1 % at 3.02 and
    /// 2 % at 4.13 rad/s (printed −0.0604 and 0.013205); half the last digit.
    #[test]
    fn coefficients_of_the_broad_tank() {
        let r = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), true).unwrap();
        assert!((r.mass + 0.0600).abs() < 5e-5, "{}", r.mass);
        assert!((r.stiffness - 0.01320).abs() < 5e-6, "{}", r.stiffness);
        let message = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), false).unwrap_err().to_string();
        // 3.02/4.13 and its inverse.
        assert!(message.contains("0.7312") && message.contains("1.3675"), "{message}");
    }

    /// Table of resulting ratios (theory sheet on damping, D4), each to 1 % of its value or half its last digit.
    #[test]
    fn ratios_of_the_broad_tank() {
        let r = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), true).unwrap();
        for (omega, ratio, tolerance) in [
            (1.0, -0.023, 5e-4),
            (2.0, -0.002, 5e-4),
            (2.13, 0.0, 5e-5),
            (3.02, 0.01, 1e-12),
            (4.13, 0.02, 1e-12),
            (10.0, 0.063, 5e-4),
            (50.0, 0.33, 5e-3),
            (100.0, 0.66, 5e-3),
        ] {
            assert!((r.ratio(omega) - ratio).abs() <= tolerance, "{omega}: {}", r.ratio(omega));
        }
    }

    #[test]
    fn refuses_what_has_no_meaning() {
        assert!(Rayleigh::fit((3.0, 0.01), (3.0, 0.02), true).is_err());
        assert!(Rayleigh::fit((0.0, 0.01), (3.0, 0.02), true).is_err());
        assert!(Rayleigh::fit((1.0, -0.01), (3.0, 0.02), true).is_err());
        assert!(Rayleigh::fit((f64::NAN, 0.01), (3.0, 0.02), true).is_err());
    }

    proptest! {
        /// The fit returns the given ratios in any order, and rejects exactly those outside the inequality.
        #[test]
        fn fit_meets_both_points(w1 in 0.1f64..50.0, factor in 1.01f64..100.0, x1 in 1e-4f64..0.3, q in 0.001f64..100.0) {
            let (w2, x2) = (w1 * factor, (x1 * q).min(0.99));
            let r = Rayleigh::fit((w1, x1), (w2, x2), true).unwrap();
            prop_assert!((r.ratio(w1) - x1).abs() < 1e-9 && (r.ratio(w2) - x2).abs() < 1e-9);
            prop_assert_eq!(Rayleigh::fit((w2, x2), (w1, x1), true).unwrap(), r);
            let quotient = x2 / x1;
            // Equality is a matter of rounding.
            if quotient > 1.000001 / factor && quotient < 0.999999 * factor {
                prop_assert!(Rayleigh::fit((w1, x1), (w2, x2), false).is_ok());
            }
            if quotient < 0.999999 / factor || quotient > 1.000001 * factor {
                prop_assert!(Rayleigh::fit((w1, x1), (w2, x2), false).is_err());
            }
        }
    }
}
