//! Rim of an unanchored wall that turns as a plane: uplift and compression for a moment.
//!
//! ```text
//! w(φ) = ψ R (c + cos φ)        lifted (w > 0): pull F(w) of the bottom strip        on the ground: compression −K w
//! 2 R ∫₀^π q dφ + 2 π R w_t = 0        M = 2 R² ∫₀^π q cos φ dφ        q = F(w) or K w, downwards on the rim
//! ```
//!
//! ψ turns the wall, c places its axis. The plane stands for a wall with a roof or a stiff top girder; wide open-top walls warp. F is
//! that of [`Strip`], the hydrodynamic pressure on the bottom is left out, K follows from the subgrade modulus. The moment grows with ψ
//! up to (π/2) D² (w_t + F_max), where the tank overturns. Stiff ground lifts less and presses more at the toe than soft ground.
//!
//! Source: derived here. Check: no uplift, n = w_t + M/(π R²); strips of finite elements, see the tests.

use std::f64::consts::PI;

use super::bottom_strip::Strip;

/// Points of the midpoint rule on the half circle; more change uplift and compression by less than 1 %.
const POINTS: u32 = 120;
/// Halvings of the brackets of axis and rotation: 1e-13 and 1e-10 of them.
const HALVINGS: [u32; 2] = [44, 34];

/// Base of an unanchored wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// R [m].
    pub radius: f64,
    /// Weight of wall and roof w_t, less the overpressure on the roof [N/m].
    pub weight: f64,
    /// Strip of the bottom plate.
    pub strip: Strip,
    /// Subgrade modulus k of the ground under the rim [N/m³].
    pub ground: f64,
}

/// Equilibrium of the rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    /// Rotation ψ [rad].
    pub rotation: f64,
    /// Moment M [N·m].
    pub moment: f64,
    /// Largest uplift w [m]; zero where all of the rim bears.
    pub uplift: f64,
    /// Largest compression n [N/m].
    pub compression: f64,
}

impl Rim {
    /// Equilibrium at a rotation ψ > 0 [rad]; none where weight and strip do not hold the rim down.
    pub fn turned(&self, rotation: f64) -> Option<Turned> {
        let stiffness = self.strip.rim_stiffness(self.ground);
        let scale = rotation * self.radius;
        if self.weight + self.strip.largest_pull() <= 0.0 || scale <= 0.0 {
            return None;
        }
        let force = |w: f64| if w > 0.0 { self.strip.pull(w) } else { stiffness * w };
        let step = PI / f64::from(POINTS);
        let cosines: Vec<f64> = (0..POINTS).map(|i| ((f64::from(i) + 0.5) * step).cos()).collect();
        let resultant = |c: f64| step * cosines.iter().map(|x| force(scale * (c + x))).sum::<f64>() + PI * self.weight;
        // With all of the rim pressed down the ground carries more than the weight; with all of it lifted nothing carries.
        let (mut low, mut high) = (-1.0 - self.weight.abs() / (stiffness * scale), 1.0);
        // The pull grows with the uplift: the rim may have to lift as a whole.
        while resultant(high) < 0.0 && high < 1e9 {
            high *= 2.0;
        }
        for _ in 0..HALVINGS[0] {
            let c = 0.5 * (low + high);
            if resultant(c) > 0.0 {
                high = c;
            } else {
                low = c;
            }
        }
        let c = 0.5 * (low + high);
        let moment = cosines.iter().map(|x| force(scale * (c + x)) * x).sum::<f64>();
        Some(Turned {
            rotation,
            moment: 2.0 * self.radius * self.radius * step * moment,
            uplift: (scale * (c + 1.0)).max(0.0),
            compression: (stiffness * scale * (1.0 - c)).max(0.0),
        })
    }

    /// Equilibrium under a moment M > 0 [N·m]; none where the tank overturns.
    pub fn under(&self, moment: f64) -> Option<Turned> {
        let holds = |t: &Turned| t.moment >= moment;
        let (mut low, mut high) = (0.0, 1e-6);
        // A rotation of 0.1 rad lifts one tenth of the diameter: no tank stands so.
        while self.turned(high).filter(holds).is_none() {
            (low, high) = (high, 2.0 * high);
            if high > 0.1 {
                return None;
            }
        }
        for _ in 0..HALVINGS[1] {
            let middle = 0.5 * (low + high);
            match self.turned(middle).filter(holds) {
                Some(_) => high = middle,
                None => low = middle,
            }
        }
        self.turned(high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::close;

    /// Crude-oil tank of 20 m radius.
    fn oil(ground: f64) -> Rim {
        Rim {
            radius: 20.0,
            weight: 21_350.0,
            strip: Strip::new(205e9, 0.3, 205e6, 0.010, 128e3),
            ground,
        }
    }

    /// Tank of 6.1 m radius with 11.3 m of water.
    fn slender(ground: f64) -> Rim {
        Rim {
            radius: 6.1,
            weight: 7_284.0,
            strip: Strip::new(210e9, 0.3, 235e6, 0.00635, 110.8e3),
            ground,
        }
    }

    /// A small moment lifts nothing: w_t + M/(π R²), ψ = M/(π R³ K). Tolerance: bisection and midpoint rule, both exact to rounding here.
    #[test]
    fn all_of_the_rim_bears() {
        let rim = oil(1e8);
        let moment = 0.4 * PI * 400.0 * rim.weight;
        let t = rim.under(moment).unwrap();
        close(t.uplift, 0.0, 0.0);
        close(t.compression / (rim.weight + moment / (PI * 400.0)), 1.0, 1e-9);
        let stiffness = rim.strip.rim_stiffness(1e8);
        close(t.rotation / (moment / (PI * 8000.0 * stiffness)), 1.0, 1e-9);
    }

    /// Strips of finite elements (von Kármán, elastic-plastic with membrane force and the edge of the wall) under the same plane section:
    /// moment and toe compression of a rotation; 15 % for the moment, which lacks the membrane force and the turning of the joint, 10 %
    /// for the compression, which on stiff ground has a short arc.
    #[test]
    fn beside_finite_elements() {
        for (rim, rotation, moment, toe) in [
            (oil(1e8), 0.5e-3, 116e6, 5.8e6 * 0.025),
            (oil(1e8), 1e-3, 141e6, 8.0e6 * 0.025),
            (oil(1e8), 2e-3, 166e6, 10.9e6 * 0.025),
            (slender(1e8), 1e-3, 4.94e6, 8.2e6 * 0.008),
            (slender(1e8), 2e-3, 6.51e6, 11.8e6 * 0.008),
        ] {
            let t = rim.turned(rotation).unwrap();
            close(t.moment / moment, 1.0, 0.16);
            close(t.compression / toe, 1.0, 0.10);
        }
    }

    /// The moment approaches the overturning limit of the equilibrium curve, (π/2) D² (w_t + F): 99 % of it on stiff ground at a rotation
    /// at which nearly all strips are mechanisms; above it there is no equilibrium.
    #[test]
    fn overturning_is_the_limit() {
        let rim = oil(1e12);
        let limit = 0.5 * PI * 1600.0 * (rim.weight + rim.strip.largest_pull());
        let t = rim.turned(0.05).unwrap();
        assert!(t.moment < limit && t.moment > 0.99 * limit, "{} {limit}", t.moment);
        assert_eq!(rim.under(1.001 * limit), None);
        assert_eq!(Rim { weight: -60e3, ..rim }.under(1.0), None);
    }

    /// As many points do not matter: uplift and compression of a rotation against a rule of 100 times as many points (the smooth sum in the
    /// doc of the module, written out for the axis found), 1 % of the moment.
    #[test]
    fn points_of_the_rule() {
        for ground in [1e8, 1e10] {
            let rim = oil(ground);
            let t = rim.turned(1e-3).unwrap();
            let axis = t.uplift / (1e-3 * 20.0) - 1.0;
            let stiffness = rim.strip.rim_stiffness(ground);
            let n = 12_000;
            let step = PI / f64::from(n);
            let (force, moment) = (0..n).fold((0.0, 0.0), |(force, moment), i| {
                let x = ((f64::from(i) + 0.5) * step).cos();
                let w = 1e-3 * 20.0 * (axis + x);
                let q = if w > 0.0 { rim.strip.pull(w) } else { stiffness * w };
                (force + q * step, moment + q * x * step)
            });
            close((force + PI * rim.weight) / (PI * rim.weight), 0.0, 0.01);
            close(2.0 * 400.0 * moment / t.moment, 1.0, 0.01);
        }
    }

    /// Found rotation and moment belong together; soft ground lifts more, stiff ground presses more.
    #[test]
    fn ground_decides() {
        let moment = 150e6;
        let [soft, stiff] = [1e8, 1e10].map(|k| oil(k).under(moment).unwrap());
        close(soft.moment / moment, 1.0, 1e-9);
        assert!(soft.uplift > stiff.uplift && soft.compression < stiff.compression);
    }
}
