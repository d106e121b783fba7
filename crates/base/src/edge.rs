//! The lower edge of the wall, to which the plate is welded.
//!
//! ```text
//! ⎡P_δ ⎤       ⎡4 β³  2 β²⎤ ⎛⎡δ ⎤   ⎡ p R²/(E s)   ⎤⎞          β⁴ = 3 (1 − ν²)/(R² s²)     D_w = E s³/(12 (1 − ν²))
//! ⎣P_δ′⎦ = D_w ⎣2 β²  2 β ⎦ ⎝⎣δ′⎦ − ⎣ −ρ g R²/(E s)⎦⎠          δ′ = −θ ,  N = −P_δ ,  M = P_δ′
//! ```
//!
//! δ is the radial displacement of the edge, δ′ its slope upwards; the bracket on the right is the membrane state under the pressure of
//! the liquid. Long cylinder of the lowest course: exact where the course is higher than about 2.4 √(R s).
//!
//! Source: Timoshenko & Woinowsky-Krieger 1959, art. 114.

/// Edge of a long cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Radius R [m].
    pub radius: f64,
    /// Thickness s of the lowest course [m].
    pub thickness: f64,
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// Pressure p on the wall at its foot [Pa].
    pub pressure: f64,
    /// Its decrease upwards, ρ g [N/m³].
    pub gradient: f64,
}

/// Stiffness against (δ, δ′) and the state without forces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EdgeStiffness {
    pub(crate) k: [[f64; 2]; 2],
    pub(crate) free: [f64; 2],
}

impl Edge {
    pub(crate) fn stiffness(&self) -> EdgeStiffness {
        let (r, s) = (self.radius, self.thickness);
        let plane = 1.0 - self.poisson_ratio * self.poisson_ratio;
        let beta = (3.0 * plane).powf(0.25) / (r * s).sqrt();
        let d = self.young_modulus * s.powi(3) / (12.0 * plane);
        let membrane = r * r / (self.young_modulus * s);
        EdgeStiffness {
            k: [[4.0 * beta.powi(3) * d, 2.0 * beta * beta * d], [2.0 * beta * beta * d, 2.0 * beta * d]],
            free: [self.pressure * membrane, -self.gradient * membrane],
        }
    }

    /// Largest von Mises stress of the elastic wall at its foot, over both faces [Pa].
    ///
    /// ```text
    /// δ = δ_0 − (N + k_12 (δ′ − δ_0′))/k_11 ,  δ′ = −θ          σ_z = F/s ± 6 M/s² ,  σ_φ = E δ/R + ν σ_z
    /// ```
    ///
    /// * `forces`: tension N of the plate [N/m], moment M at the rim [N], tension F of the wall [N/m]
    /// * `rotation`: θ of the rim [rad]
    pub(crate) fn stress(&self, [tension, moment, pull]: [f64; 3], rotation: f64) -> f64 {
        let EdgeStiffness { k, free } = self.stiffness();
        let turn = -rotation - free[1];
        let out = free[0] - (tension + k[0][1] * turn) / k[0][0];
        let bending = 6.0 * moment / (self.thickness * self.thickness);
        let face = |bending: f64| {
            let axial = pull / self.thickness + bending;
            let hoop = self.young_modulus * out / self.radius + self.poisson_ratio * axial;
            (axial * axial - axial * hoop + hoop * hoop).sqrt()
        };
        face(bending).max(face(-bending))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Long cylinder under forces P at its edge without moment: δ = P/(2 β³ D), δ′ = −P/(2 β² D) (Timoshenko & Woinowsky-Krieger 1959, art. 114);
    /// the edge has hoop stress alone. Under a moment M: δ = −M/(2 β² D), δ′ = M/(β D). Closed forms, 1e-12.
    #[test]
    fn stress_at_the_edge_of_a_long_cylinder() {
        let edge = Edge {
            radius: 5.0,
            thickness: 8e-3,
            young_modulus: 205e9,
            poisson_ratio: 0.3,
            pressure: 0.0,
            gradient: 0.0,
        };
        let d = 205e9 * 8e-3_f64.powi(3) / (12.0 * 0.91);
        let beta = (3.0_f64 * 0.91).powf(0.25) / (5.0_f64 * 8e-3).sqrt();
        // The plate pulls inwards with N = −P.
        let p = 1e5;
        let pulled = edge.stress([p, 0.0, 0.0], -p / (2.0 * beta * beta * d));
        let hoop = 205e9 * p / (2.0 * beta.powi(3) * d) / 5.0;
        assert!((pulled / hoop - 1.0).abs() < 1e-12, "{pulled} {hoop}");
        let m = 1e3;
        let bent = edge.stress([0.0, m, 0.0], -m / (beta * d));
        let (axial, ring) = (6.0 * m / 64e-6, 205e9 * m / (2.0 * beta * beta * d) / 5.0);
        let face = |axial: f64| {
            let hoop = -ring + 0.3 * axial;
            (axial * axial - axial * hoop + hoop * hoop).sqrt()
        };
        assert!((bent / face(axial).max(face(-axial)) - 1.0).abs() < 1e-12, "{bent}");
    }
}
