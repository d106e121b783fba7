//! Bond of ribbed bars, smeared over the distance of cracks.
//!
//! Between two cracks of spacing s_r a bar slips by s against the concrete, nothing in the middle, s_L at the crack, L = s_r/2:
//!
//! ```text
//! τ = τ_max (s/s_1)^α                     bond stress, s ≤ s_1
//! σ_s' = 4 τ/φ ,  σ_c' = −ρ 4 τ/φ ,  s' = ε_s − ε_c
//! s″ = K s^α ,  K = 4 τ_max (1 + n ρ)/(φ E_s s_1^α) ,  n = E_s/E        s(0) = 0 ,  s(L) = s_L
//! s'² = s_0'² + 2 K s^(1+α)/(1 + α)       first integral; s_0' = s'(0), 0 while the middle is without slip
//! ```
//!
//! The opening strain of the crack is e = s_L/L, since the mean strains of bar and concrete differ by the mean of s'. Beyond the
//! traction at the crack's faces the concrete carries, on the average and in the middle,
//!
//! ```text
//! b(e) = r (s'(L) − e) ,   σ_0(e) = r (s'(L) − s_0') ,   r = ρ E_s/(1 + n ρ)
//! ```
//!
//! which is the bond, as a part of the traction of a smeared crack: bars keep their own law at the mean strain. Two limits:
//!
//! * the middle carries at most what is left of the tensile strength: b ≤ (b/σ_0) (f_t − f_t exp(−e/e_f)). More would crack it
//!   again; the spacing then falls and the mean stress stays.
//! * at the crack the bar carries σ_s = E_s u + b/ρ. From σ_s = f_y on (e = e_y) the force of the tie does not grow: b = ρ (f_y − E_s u)
//!   falls linearly to zero where the mean strain of the bar is f_y/E_s. Without that the tie would exceed A_s f_y.
//!
//! Source: differential equation of bond after Rehm 1961; bond law and its parameters: CEB-FIP Model Code 1990, 3.1.1; equilibrium
//! at the crack: Vecchio & Collins 1986. The module's tests and rows M13 integrate the differential equation on their own.
//!
//! Limits: monotonic bond law (repeated loading wears it: the unloading of the smeared crack is its secant); one spacing;
//! bars straight and ribbed, at right angles to the crack.

use crate::check::{found, positive, within};
use crate::{LawError, refuse};

/// Intervals of the table of b.
const KNOTS: usize = 16;
/// Intervals of the quadrature over the slip; its error is below 1e-5 of L.
const POINTS: usize = 64;

/// Bond conditions of the Model Code, unconfined concrete.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conditions {
    /// Good: bars that stand, or lie low in the cast.
    Good,
    /// All others.
    Other,
}

/// Bars across a crack and their bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond {
    /// Area of the bars over that of the concrete, ρ > 0.
    pub ratio: f64,
    /// Diameter of a bar φ [m] > 0.
    pub diameter: f64,
    /// Young's modulus of the bars E_s [Pa] > 0.
    pub bar_modulus: f64,
    /// Yield stress of the bars f_y [Pa], finite.
    pub yield_stress: f64,
    /// Bond strength τ_max [Pa] > 0.
    pub strength: f64,
    /// Slip s_1 at the bond strength [m] > 0.
    pub slip: f64,
    /// Exponent α, from 0 to below 1.
    pub exponent: f64,
    /// Spacing of the cracks s_r [m] > 0; bars must yield before they slip by s_1: s_r < 2 s_1 E_s/f_y.
    pub spacing: f64,
}

/// τ_max [Pa], s_1 [m] and α of ribbed bars in unconfined concrete.
///
/// ```text
/// good conditions   τ_max = 2.0 √f_ck ,  s_1 = 0.6 mm ,  α = 0.4        f_ck, τ_max in MPa
/// all others        τ_max = 1.0 √f_ck
/// ```
///
/// * `characteristic_strength`: f_ck [Pa]
///
/// Source: CEB-FIP Model Code 1990, table 3.1.1.
pub fn model_code_1990(characteristic_strength: f64, conditions: Conditions) -> [f64; 3] {
    let factor = match conditions {
        Conditions::Good => 2.0,
        Conditions::Other => 1.0,
    };
    [1e6 * factor * (characteristic_strength / 1e6).sqrt(), 0.6e-3, 0.4]
}

impl Bond {
    /// Mean stress b and stress σ_0 in the middle [Pa] at the opening strain e > 0, by the first integral.
    pub fn stresses(&self, young_modulus: f64, e: f64) -> [f64; 2] {
        let n = self.bar_modulus / young_modulus;
        let half = 0.5 * self.spacing;
        let slip = e * half;
        let alpha = self.exponent;
        let share = 1.0 + n * self.ratio;
        let k = 4.0 * self.strength * share / (self.diameter * self.bar_modulus * self.slip.powf(alpha));
        // s'² at the crack without s_0'.
        let square = 2.0 * k / (1.0 + alpha) * slip.powf(1.0 + alpha);
        let middle = middle_slope(square, slip, alpha, half);
        let end = (middle * middle + square).sqrt();
        let r = self.ratio * self.bar_modulus / share;
        [r * (end - e).max(0.0), r * (end - middle)]
    }

    /// The table of b for concrete of modulus E, strength f_t and softening strain e_f.
    ///
    /// Errors: a parameter out of range.
    pub(super) fn curve(&self, law: &'static str, [young, f_t, e_f]: [f64; 3]) -> Result<Curve, LawError> {
        positive(law, "bond, ratio of bars", self.ratio, "")?;
        positive(law, "bond, diameter", self.diameter, "m")?;
        positive(law, "bond, modulus of the bars", self.bar_modulus, "Pa")?;
        positive(law, "bond, yield stress", self.yield_stress, "Pa")?;
        positive(law, "bond, strength", self.strength, "Pa")?;
        positive(law, "bond, slip", self.slip, "m")?;
        positive(law, "bond, spacing", self.spacing, "m")?;
        within(law, "bond, exponent", self.exponent, [0.0, 0.99], "")?;
        let yields = self.yield_stress / self.bar_modulus;
        let longest = 2.0 * self.slip / yields;
        if self.spacing >= longest {
            let allowed = format!("below {longest:.4} m (2 s_1 E_s/f_y: the bars slip beyond s_1 before they yield)");
            return Err(refuse(law, "bond, spacing", found(self.spacing, "m"), &allowed));
        }
        let capped = |e: f64| {
            if e <= 0.0 {
                return 0.0;
            }
            let [mean, middle] = self.stresses(young, e);
            let left = -f_t * (-e / e_f).exp_m1();
            if middle > left { mean * left / middle } else { mean }
        };
        // Stress of the bar at the crack, which grows with e.
        let bar = |e: f64| {
            let b = capped(e);
            self.bar_modulus * (e + (f_t * (-e / e_f).exp() + b) / young) + b / self.ratio
        };
        let (mut low, mut high) = (0.0, yields);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if bar(middle) < self.yield_stress {
                low = middle;
            } else {
                high = middle;
            }
        }
        let end = low;
        let fall = capped(end) / (yields - end);
        let steepest = fall + f_t / e_f * (-end / e_f).exp();
        if end <= 0.0 || steepest > super::SIZE_MARGIN * young {
            let allowed = "bars that yield after the crack has softened: more of them, or a smaller fracture energy";
            return Err(refuse(law, "bond, ratio of bars", found(self.ratio, ""), allowed));
        }
        let values = std::array::from_fn(|i| capped(end * place(i)));
        Ok(Curve { end, zero: yields, values })
    }
}

/// s'(0): 0 if the slip s_L fades within L, else such that it fades at the middle.
///
/// With s = s_L v^p, p = 2/(1 − α), the quadrature L = ∫ ds/s' has a smooth integrand.
fn middle_slope(square: f64, slip: f64, alpha: f64, half: f64) -> f64 {
    let p = 2.0 / (1.0 - alpha);
    let length = |middle: f64| {
        let at = |i: usize| {
            let v = (i as f64 / POINTS as f64).powf(p - 1.0);
            let weight = match i {
                0 | POINTS => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let under = (middle * middle + square * v * v).sqrt();
            // 0/0 of a middle without slip: its limit.
            let ratio = if under > 0.0 { v / under } else { 1.0 / square.sqrt() };
            weight * ratio
        };
        p * slip * (0..=POINTS).map(at).sum::<f64>() / (3.0 * POINTS as f64)
    };
    if length(0.0) <= half {
        return 0.0;
    }
    // s' grows from the middle on: s'(0) is below its mean.
    let (mut low, mut high) = (0.0, slip / half);
    for _ in 0..45 {
        let middle = 0.5 * (low + high);
        if length(middle) > half {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Place of a knot, from 0 to 1: denser at small openings, where b bends.
fn place(i: usize) -> f64 {
    let x = i as f64 / KNOTS as f64;
    x * x
}

/// b(e), linear between knots; falls to zero after the bars yield.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Curve {
    /// Opening strain e_y at which the bars yield at the crack.
    end: f64,
    /// Mean strain at which they yield everywhere; no bond from there on.
    zero: f64,
    /// b at the knots [Pa].
    values: [f64; KNOTS + 1],
}

impl Curve {
    /// Number of knots and of the end of the fall.
    pub(super) const PIECES: usize = KNOTS + 1;

    /// Opening at the beginning of a piece; the last one begins where the bond has gone.
    #[inline]
    pub(super) fn begins(&self, piece: usize) -> f64 {
        if piece > KNOTS { self.zero } else { self.end * place(piece) }
    }

    /// Value [Pa] at the beginning of a piece.
    #[inline]
    fn value(&self, piece: usize) -> f64 {
        self.values.get(piece).copied().unwrap_or(0.0)
    }

    /// Slope [Pa] of a piece.
    #[inline]
    fn slope(&self, piece: usize) -> f64 {
        if piece > KNOTS {
            return 0.0;
        }
        (self.value(piece + 1) - self.value(piece)) / (self.begins(piece + 1) - self.begins(piece))
    }

    /// Piece that holds the opening e ≥ 0.
    #[inline]
    fn piece(&self, e: f64) -> usize {
        if e >= self.zero {
            KNOTS + 1
        } else if e >= self.end {
            KNOTS
        } else {
            let mut i = (KNOTS as f64 * (e / self.end).max(0.0).sqrt()) as usize;
            // Rounding of the root.
            i -= usize::from(i > 0 && self.begins(i) > e);
            i.min(KNOTS - 1)
        }
    }

    /// b and its slope [Pa] at the opening e ≥ 0.
    #[inline]
    pub(super) fn at(&self, e: f64) -> (f64, f64) {
        let i = self.piece(e);
        let slope = self.slope(i);
        (self.value(i) + slope * (e - self.begins(i)), slope)
    }

    /// Value extrapolated to e = 0 and slope [Pa] of a piece.
    #[inline]
    pub(super) fn line(&self, piece: usize) -> (f64, f64) {
        let slope = self.slope(piece);
        (self.value(piece) - slope * self.begins(piece), slope)
    }

    /// ∫ b de from 0 to m [J/m³].
    pub(super) fn work(&self, m: f64) -> f64 {
        let mut sum = 0.0;
        for i in 0..=KNOTS {
            let (from, to) = (self.begins(i), self.begins(i + 1).min(m));
            if to <= from {
                break;
            }
            sum += (to - from) * (self.value(i) + 0.5 * self.slope(i) * (to - from));
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const E: f64 = 33e9;

    pub(crate) fn bond() -> Bond {
        let [strength, slip, exponent] = model_code_1990(30e6, Conditions::Good);
        Bond {
            ratio: 0.015,
            diameter: 16e-3,
            bar_modulus: 200e9,
            yield_stress: 500e6,
            strength,
            slip,
            exponent,
            spacing: 0.2,
        }
    }

    /// s, s' and ∫σ_c dx at the crack, by Runge and Kutta from the middle with the slope s_0'. Without slip in the middle the
    /// equation has s = 0 as a solution as well: begin with the power s = (K (1−α)²/(2 (1+α)))^(1/(1−α)) x^(2/(1−α)).
    fn shoot(bond: &Bond, middle: f64, free: f64, steps: usize) -> [f64; 3] {
        let share = 1.0 + bond.bar_modulus / E * bond.ratio;
        let k = 4.0 * share / (bond.diameter * bond.bar_modulus);
        let tau = |s: f64| bond.strength * (s.max(0.0) / bond.slip).powf(bond.exponent);
        let a = bond.exponent;
        let x0 = free;
        let h = (0.5 * bond.spacing - x0) / steps as f64;
        let (mut y, start) = if middle > 0.0 {
            ([0.0, middle, 0.0], 0)
        } else {
            let unit = bond.strength / bond.slip.powf(a) * k;
            let c = (unit * (1.0 - a) * (1.0 - a) / (2.0 * (1.0 + a))).powf(1.0 / (1.0 - a));
            let m = 2.0 / (1.0 - a);
            ([c * h.powf(m), c * m * h.powf(m - 1.0), 0.0], 1)
        };
        // Third: the force handed over so far, from the middle: σ_0 − σ_c.
        if start == 1 {
            y[2] = bond.ratio * bond.bar_modulus / share * y[1];
        }
        let f = |y: [f64; 3]| [y[1], k * tau(y[0]), 4.0 * bond.ratio / bond.diameter * tau(y[0])];
        let add = |y: [f64; 3], d: [f64; 3], t: f64| -> [f64; 3] { std::array::from_fn(|i| y[i] + t * d[i]) };
        let mut area = 0.0;
        for _ in start..steps {
            let a1 = f(y);
            let a2 = f(add(y, a1, 0.5 * h));
            let a3 = f(add(y, a2, 0.5 * h));
            let a4 = f(add(y, a3, h));
            let next: [f64; 3] = std::array::from_fn(|i| y[i] + h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]));
            area += 0.5 * h * (y[2] + next[2]);
            y = next;
        }
        // σ_c(x) = σ_0 − y_2(x), zero at the crack: mean = y_2(L) − area/L.
        [y[0], y[2] - area / (0.5 * bond.spacing), y[2]]
    }

    /// The first integral against shooting with Runge and Kutta, with slip in the middle and without.
    /// Tolerance: the trapezoids of 4000 steps.
    #[test]
    fn stresses_solve_the_differential_equation() {
        let bond = bond();
        for middle in [1e-5, 2e-4, 1e-3, 2.4e-3] {
            let [slip, mean, peak] = shoot(&bond, middle, 0.0, 4000);
            let [b, sigma_0] = bond.stresses(E, slip / (0.5 * bond.spacing));
            assert!((b / mean - 1.0).abs() < 1e-3, "{middle}: {b} {mean}");
            assert!((sigma_0 / peak - 1.0).abs() < 1e-3, "{middle}: {sigma_0} {peak}");
        }
        for free in [0.0, 0.03, 0.06] {
            let [slip, mean, peak] = shoot(&bond, 0.0, free, 4000);
            let [b, sigma_0] = bond.stresses(E, slip / (0.5 * bond.spacing));
            assert!((b / mean - 1.0).abs() < 1e-3, "{free}: {b} {mean}");
            assert!((sigma_0 / peak - 1.0).abs() < 1e-3, "{free}: {sigma_0} {peak}");
        }
    }

    /// α = 0 is the tie of constant bond stress by hand: σ_0 = 4 ρ τ L/φ, b half of it, once the whole length slips.
    #[test]
    fn constant_bond_by_hand() {
        let bond = Bond { exponent: 0.0, strength: 3e6, ..bond() };
        let [b, sigma_0] = bond.stresses(E, 2e-3);
        let exact = 4.0 * 0.015 * 3e6 * 0.1 / 16e-3;
        assert!((sigma_0 / exact - 1.0).abs() < 1e-6 && (b / exact - 0.5).abs() < 1e-6, "{b} {sigma_0} {exact}");
    }

    /// The table: zero at both ends, below the strength, and work as the sum of trapezoids.
    #[test]
    fn table() {
        let curve = bond().curve("law", [E, 2.9e6, 2.4e-4]).unwrap();
        assert_eq!(curve.at(0.0).0, 0.0);
        assert_eq!(curve.at(2.5e-3), (0.0, 0.0));
        let (mut sum, n) = (0.0, 20_000);
        let h = 3e-3 / f64::from(n);
        for i in 0..n {
            let e = h * (f64::from(i) + 0.5);
            let (b, _) = curve.at(e);
            assert!((0.0..2.9e6).contains(&b));
            sum += h * b;
            assert!((curve.work(e + 0.5 * h) - sum).abs() < 1e-5 * 2.9e6 * 3e-3);
        }
        let text = Bond { spacing: 0.6, ..bond() }.curve("law", [E, 2.9e6, 2.4e-4]).unwrap_err().to_string();
        assert!(text.contains("below 0.48"), "{text}");
    }

    /// By hand: 2 √25 = 10 MPa.
    #[test]
    fn model_code() {
        assert_eq!(model_code_1990(25e6, Conditions::Good)[0], 10e6);
    }
}
