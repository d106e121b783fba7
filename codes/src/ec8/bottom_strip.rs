//! Strip of the bottom plate that the rim of an unanchored wall lifts off rigid ground, in bending.
//!
//! A strip of unit width under the pressure p touches the ground at the lifted length l from the rim, where deflection, slope and
//! moment vanish and a line reaction V remains. With the rigidity `D = E t³/(12 (1 − ν²))` and the plastic moment `M_p = f_y t²/4`
//! the pull F on the rim and its height w are, in three stages that meet:
//!
//! ```text
//! joint clamped        M = p l²/6 ≤ M_p        w = p l⁴/(72 D)                    F = 2 p l/3
//! hinge at the joint   V = p l/2 − M_p/l       w = p l⁴/(24 D) − M_p l²/(6 D)     F = p l/2 + M_p/l
//! hinge in the span    V²/(2 p) = M_p          l = (2 + √2) √(M_p/p)              F = 2 √(p M_p) = t √(p f_y)
//! ```
//!
//! The last stage is a mechanism: l and F stay, as in API 650, whose hold-down and annulus width they are. The membrane force is left
//! out; it is anchored by the edge of the wall, which is soft, and adds to the pull: less is on the safe side for w. For the length and
//! the rotation of the joint the mechanism is close to elastic-plastic finite elements with membrane force.
//!
//! Source: derived here; Timoshenko beam columns without axial force, Malhotra and Veletsos 1994 for the idea of strips.

/// l/√(M_p/p) of the mechanism: 2 + √2.
const MECHANISM: f64 = 2.0 + std::f64::consts::SQRT_2;

/// A strip of the bottom plate under pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Pressure p [Pa].
    pub pressure: f64,
    /// Rigidity D [N·m].
    pub rigidity: f64,
    /// Plastic moment M_p per length [N].
    pub plastic_moment: f64,
}

impl Strip {
    /// A plate.
    ///
    /// * `youngs_modulus`: E, `yield_strength`: f_y, `pressure`: p [Pa]; `poisson_ratio`: ν; `thickness`: t [m]
    pub fn new(youngs_modulus: f64, poisson_ratio: f64, yield_strength: f64, thickness: f64, pressure: f64) -> Strip {
        let nu2 = poisson_ratio * poisson_ratio;
        Strip {
            pressure,
            rigidity: youngs_modulus * thickness.powi(3) / (12.0 * (1.0 - nu2)),
            plastic_moment: 0.25 * yield_strength * thickness * thickness,
        }
    }

    /// M_p²/(p D), the scale of the uplift [m].
    fn scale(&self) -> f64 {
        self.plastic_moment * self.plastic_moment / (self.pressure * self.rigidity)
    }

    /// Uplift at which the joint yields [m]: M_p²/(2 p D).
    pub fn first_hinge(&self) -> f64 {
        0.5 * self.scale()
    }

    /// Uplift at which the mechanism forms [m]: 3.719 M_p²/(p D).
    pub fn mechanism(&self) -> f64 {
        (MECHANISM.powi(4) / 24.0 - MECHANISM * MECHANISM / 6.0) * self.scale()
    }

    /// Lifted length l [m] at the uplift w > 0 [m].
    pub fn length(&self, uplift: f64) -> f64 {
        let (p, d, m) = (self.pressure, self.rigidity, self.plastic_moment);
        if uplift <= 0.0 {
            0.0
        } else if uplift <= self.first_hinge() {
            (72.0 * d * uplift / p).sqrt().sqrt()
        } else if uplift < self.mechanism() {
            // p l⁴ − 4 M_p l² − 24 D w = 0.
            ((2.0 * m + (4.0 * m * m + 24.0 * p * d * uplift).sqrt()) / p).sqrt()
        } else {
            MECHANISM * (m / p).sqrt()
        }
    }

    /// Pull F on the rim [N/m] at the uplift w > 0 [m].
    pub fn pull(&self, uplift: f64) -> f64 {
        let (p, m) = (self.pressure, self.plastic_moment);
        let length = self.length(uplift);
        if uplift <= 0.0 {
            0.0
        } else if uplift <= self.first_hinge() {
            2.0 / 3.0 * p * length
        } else {
            0.5 * p * length + m / length
        }
    }

    /// Largest pull 2 √(p M_p) [N/m].
    pub fn largest_pull(&self) -> f64 {
        2.0 * (self.pressure * self.plastic_moment).sqrt()
    }

    /// Stiffness of the strip pressed down on springs, per length of rim [N/m²]: k/λ with λ⁴ = k/(4 D), the edge of a long strip kept
    /// from turning.
    ///
    /// * `ground`: k, subgrade modulus [N/m³]
    pub fn rim_stiffness(&self, ground: f64) -> f64 {
        ground * (4.0 * self.rigidity / ground).sqrt().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::close;
    use proptest::prelude::*;

    /// Bottom plate of a crude-oil tank: 10 mm, f_y = 205 MPa, 15 m of oil of 870 kg/m³.
    fn oil() -> Strip {
        Strip::new(205e9, 0.3, 205e6, 0.010, 128e3)
    }

    /// Deflection, slope and moment of the strip integrated from the touch-down with its line reaction.
    fn integrated(strip: &Strip, length: f64, reaction: f64) -> [f64; 3] {
        let steps = 4000;
        let h = length / f64::from(steps);
        let (mut w, mut slope) = (0.0, 0.0);
        let moment = |s: f64| reaction * s - 0.5 * strip.pressure * s * s;
        for i in 0..steps {
            let s = (f64::from(i) + 0.5) * h;
            let curvature = moment(s) / strip.rigidity;
            w += h * (slope + 0.5 * h * curvature);
            slope += h * curvature;
        }
        [w, slope, moment(length)]
    }

    /// Each stage against an integration of its beam: the joint does not turn while clamped, carries M_p with a hinge, and the span
    /// reaches M_p at the mechanism. Tolerance: error of the midpoint rule, 1e-6.
    #[test]
    fn stages_are_beams() {
        let strip = oil();
        let (p, m) = (strip.pressure, strip.plastic_moment);
        for (uplift, clamped) in [(0.002, true), (0.005, true), (0.010, false), (0.030, false)] {
            let (l, pull) = (strip.length(uplift), strip.pull(uplift));
            let [w, slope, moment] = integrated(&strip, l, p * l - pull);
            close(w / uplift, 1.0, 1e-6);
            if clamped {
                close(slope * l / uplift, 0.0, 1e-6);
                assert!(moment.abs() <= m, "{moment}");
            } else {
                close(moment / -m, 1.0, 1e-9);
            }
            assert!((p * l - pull).powi(2) / (2.0 * p) <= m * (1.0 + 1e-12));
        }
        let l = strip.length(1.0);
        close((p * l - strip.pull(1.0)).powi(2) / (2.0 * p * m), 1.0, 1e-12);
    }

    /// The mechanism is hold-down and annulus of API 650: t √(p f_y), and l = 1.7071 t √(f_y/p). Uplift there: 3.719 M_p²/(p D) =
    /// 40.7 mm.
    #[test]
    fn mechanism_is_that_of_api_650() {
        let strip = oil();
        close(strip.pull(0.2) / (0.010 * (128e3f64 * 205e6).sqrt()), 1.0, 1e-12);
        close(strip.largest_pull() / strip.pull(0.2), 1.0, 1e-12);
        close(
            strip.length(0.2) / (1.707_106_78 * 0.010 * (205e6f64 / 128e3).sqrt()),
            1.0,
            1e-8,
        );
        close(strip.mechanism(), 0.0407, 5e-5);
    }

    /// Elastic-plastic finite elements with membrane force and the edge of the wall, 10, 20 and 50 mm of uplift: 46.0, 50.8 and 59.6
    /// kN/m. The clamped joint is stiffer at first (the wall turns), membrane force carries more at last: 10 % and 15 %.
    #[test]
    fn pull_beside_finite_elements() {
        for (w, reference, tolerance) in [(0.010, 46.0e3, 0.10), (0.020, 50.8e3, 0.10), (0.050, 59.6e3, 0.15)] {
            close(oil().pull(w) / reference, 1.0, tolerance);
        }
    }

    /// The length lets the formula of A.9 give the rotation that the same finite elements give at 100 mm with their length: 0.30 rad
    /// (tank of 20 m radius) and 0.37 rad (13.9 m, 8 mm, 235 MPa, 154 kPa). Tolerance: the last digit.
    #[test]
    fn rotation_with_the_length_of_finite_elements() {
        let other = Strip::new(210e9, 0.3, 235e6, 0.008, 154e3);
        for (strip, radius, rotation) in [(oil(), 20.0, 0.30), (other, 13.9, 0.37)] {
            let w = 0.1;
            close(2.0 * w / strip.length(w) - w / (2.0 * radius), rotation, 0.011);
        }
    }

    proptest! {
        /// Length and pull grow with the uplift, without jumps.
        #[test]
        fn monotone(t in 0.004f64..0.03, p in 1e4f64..3e5, w in 1e-4f64..0.5) {
            let strip = Strip::new(205e9, 0.3, 235e6, t, p);
            for f in [Strip::length, Strip::pull] {
                prop_assert!(f(&strip, w * 1.001) >= f(&strip, w) * (1.0 - 1e-12));
                prop_assert!(f(&strip, w * 1.001) <= f(&strip, w) * 1.001);
            }
        }
    }
}
