//! Constants of the convective part.

use crate::mechanical::{self, Plan};
use tank::case::ConvectiveCoefficient;

/// Constants of Housner's convective part, for a length `a` = R (circle) or L (half length of a rectangle).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// k: `ω² = (k g/a) tanh(k H/a)`.
    pub frequency: f64,
    /// c_m: `m_k = m c_m (a/H) tanh(k H/a)`.
    pub mass: f64,
    /// c_t: `θ_h = c_t (A₁/a) tanh(k H/a)`.
    pub angle: f64,
    /// c_p: `P_k = c_p m_k g θ_h`.
    pub force: f64,
    /// c_d: `d_max = c_d a coth(k H/a)/(g/(ω² θ_h a) − 1)`.
    pub wave: f64,
    /// `d_lin = wave_linear · a S_a/g`, the surface at the wall without the finite-angle term.
    pub wave_linear: f64,
}

/// Circular tank as printed in TID-7024 (1963): 1.84, 0.318, 1.534, 1.2, 0.408.
///
/// 0.318 is 30 % below the exact first-mode mass factor 0.4545; later codes use 0.460. `c_d c_t = 0.626` is 25 % below
/// the exact linear wave factor 0.837.
// 0.318 is printed, not meant as 1/π.
#[allow(clippy::approx_constant)]
pub const CIRCLE_1957: Coefficients =
    Coefficients { frequency: 1.84, mass: 0.318, angle: 1.534, force: 1.2, wave: 0.408, wave_linear: 0.408 * 1.534 };

/// Rectangular tank as printed in TID-7024 (1963): 1.58 (= √(5/2)), 0.527 (= √(5/2)/3), 1.58, 1.0, 0.527.
pub const RECTANGLE_1957: Coefficients =
    Coefficients { frequency: 1.58, mass: 0.527, angle: 1.58, force: 1.0, wave: 0.527, wave_linear: 0.527 * 1.58 };

impl Coefficients {
    /// The constants as published.
    pub fn housner_1957(plan: Plan) -> Coefficients {
        match plan {
            Plan::Circle => CIRCLE_1957,
            Plan::Rectangle => RECTANGLE_1957,
        }
    }

    /// Frequency, mass and linear wave of the first mode exact in potential flow.
    ///
    /// ```text
    /// circle      k = λ₁ = 1.84118   c_m = 2/(λ₁ (λ₁² − 1)) = 0.4545   d_lin/(a S_a/g) = 2/(λ₁² − 1) = 0.8368
    /// rectangle   k = π/2            c_m = 16/π³ = 0.5160              d_lin/(a S_a/g) = 8/π² = 0.8106
    /// ```
    ///
    /// Angle and wave keep Housner's `c_t` and `c_d`: the finite-angle formula of the wave is his approximation and was
    /// made with them. `c_p = k/c_t`, so that `P_k = m_k S_a` holds exactly.
    pub fn exact(plan: Plan) -> Coefficients {
        let published = Coefficients::housner_1957(plan);
        let k = mechanical::eigenvalue(plan, 1);
        let w = mechanical::wave_factor(plan, 1);
        Coefficients { frequency: k, mass: w / k, force: k / published.angle, wave_linear: w, ..published }
    }

    /// By the user's choice.
    pub fn choose(plan: Plan, choice: ConvectiveCoefficient) -> Coefficients {
        match choice {
            ConvectiveCoefficient::Exact => Coefficients::exact(plan),
            ConvectiveCoefficient::Housner1957 => Coefficients::housner_1957(plan),
        }
    }
}

#[cfg(test)]
// Four printed digits, one of them π/2.
#[allow(clippy::approx_constant)]
mod tests {
    use super::*;

    /// Four digits, each from its closed form by hand calculation.
    #[test]
    fn exact_constants() {
        let c = Coefficients::exact(Plan::Circle);
        assert!((c.frequency - 1.8412).abs() < 0.5e-4);
        assert!((c.mass - 0.4545).abs() < 0.5e-4);
        assert!((c.wave_linear - 0.8368).abs() < 0.5e-4);
        let r = Coefficients::exact(Plan::Rectangle);
        assert!((r.frequency - 1.5708).abs() < 0.5e-4);
        assert!((r.mass - 0.5160).abs() < 0.5e-4);
        assert!((r.wave_linear - 0.8106).abs() < 0.5e-4);
    }

    /// `c_p c_t = k`: both forms of the convective force agree (circle as printed: 1.2 · 1.534 = 1.8408 for 1.84).
    #[test]
    fn force_by_angle_and_by_acceleration_agree() {
        for plan in [Plan::Circle, Plan::Rectangle] {
            for c in [Coefficients::exact(plan), Coefficients::housner_1957(plan)] {
                assert!((c.force * c.angle / c.frequency - 1.0).abs() < 1e-3);
            }
        }
    }
}
