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
            k: [
                [4.0 * beta.powi(3) * d, 2.0 * beta * beta * d],
                [2.0 * beta * beta * d, 2.0 * beta * d],
            ],
            free: [self.pressure * membrane, -self.gradient * membrane],
        }
    }
}
