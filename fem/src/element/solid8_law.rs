//! Elastic laws of the solid: second Piola-Kirchhoff stress S from Green-Lagrange strain E, components in an orthonormal
//! base (with linear kinematics: Cauchy stress from small strain).
//!
//! ```text
//! isotropic      S = λ tr(E) 1 + 2 μ E          λ = E ν / ((1 + ν)(1 − 2ν)),  μ = E / (2 (1 + ν))
//! normal only    S = E_n (n·E n) n ⊗ n          n unit normal of the layer in the reference state
//! ```
//!
//! The first is St. Venant and Kirchhoff's law with the metric of the reference state (the dissertation prints that of the
//! current one in (6.25), (6.26)). The second is its layer between two shells, section 6.3.1, where only D³³³³ ≠ 0.
//!
//! Voigt order 11, 22, 33, 12, 23, 13, engineering shears in the strain.

use nalgebra::Vector3;

use super::ElementError;

/// 6 × 6 matrix of a law, row by row.
pub type Moduli = [[f64; 6]; 6];

/// Stress law of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Isotropic, linear in S and E.
    Isotropic {
        /// Young's modulus E [Pa], > 0.
        young_modulus: f64,
        /// Poisson's ratio ν, −1 < ν < 0.5.
        poisson_ratio: f64,
    },
    /// Stiff along the layer's normal and nowhere else. The element alone has 20 modes without energy: it stands only
    /// between two shells, or with every tangential displacement held.
    NormalOnly {
        /// Modulus along the normal [Pa], > 0 (E_∥ of the dissertation's chapter 6, E_⊥ of its figure 8.9).
        e_normal: f64,
    },
}

impl Law {
    /// Refuses parameters out of range.
    pub(super) fn check(&self, kind: &'static str) -> Result<(), ElementError> {
        let refuse = |parameter, found: f64, allowed| {
            Err(ElementError::Parameter {
                kind,
                parameter,
                found: found.to_string(),
                allowed,
            })
        };
        match *self {
            Law::Isotropic { young_modulus, .. } if !(young_modulus > 0.0 && young_modulus.is_finite()) => {
                refuse("young_modulus", young_modulus, "> 0")
            }
            Law::Isotropic { poisson_ratio, .. } if !(poisson_ratio > -1.0 && poisson_ratio < 0.5) => {
                refuse("poisson_ratio", poisson_ratio, "between −1 and 0.5")
            }
            Law::NormalOnly { e_normal } if !(e_normal > 0.0 && e_normal.is_finite()) => {
                refuse("e_normal", e_normal, "> 0")
            }
            _ => Ok(()),
        }
    }

    /// Lamé's constants (λ, μ) of an isotropic law [Pa].
    pub fn lame(&self) -> Option<(f64, f64)> {
        match *self {
            Law::Isotropic {
                young_modulus,
                poisson_ratio,
            } => Some(lame(young_modulus, poisson_ratio)),
            Law::NormalOnly { .. } => None,
        }
    }

    /// Stress and tangent moduli ∂S/∂E [Pa] at `strain`, for the layer normal `normal`.
    pub fn stress(&self, strain: &[f64; 6], normal: &Vector3<f64>) -> ([f64; 6], Moduli) {
        let moduli = match *self {
            Law::Isotropic {
                young_modulus,
                poisson_ratio,
            } => isotropic_moduli(lame(young_modulus, poisson_ratio)),
            Law::NormalOnly { e_normal } => normal_moduli(e_normal, normal),
        };
        let stress = moduli.map(|row| row.iter().zip(strain).map(|(d, e)| d * e).sum());
        (stress, moduli)
    }
}

/// λ = E ν / ((1 + ν)(1 − 2ν)), μ = E / (2 (1 + ν)).
fn lame(e: f64, nu: f64) -> (f64, f64) {
    (e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), e / (2.0 * (1.0 + nu)))
}

fn isotropic_moduli((lambda, mu): (f64, f64)) -> Moduli {
    let mut d = [[0.0; 6]; 6];
    for i in 0..3 {
        for j in 0..3 {
            d[i][j] = lambda;
        }
        d[i][i] += 2.0 * mu;
        d[3 + i][3 + i] = mu;
    }
    d
}

/// E_n p pᵀ with p the Voigt vector of n ⊗ n that is work-conjugate to engineering shears.
fn normal_moduli(e_normal: f64, n: &Vector3<f64>) -> Moduli {
    let p = [n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z];
    p.map(|a| p.map(|b| e_normal * a * b))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniaxial stress: σ = E ε with ε_lateral = −ν ε.
    #[test]
    fn uniaxial_stress_shows_youngs_modulus() {
        let law = Law::Isotropic {
            young_modulus: 210e9,
            poisson_ratio: 0.3,
        };
        let (stress, _) = law.stress(&[1e-3, -0.3e-3, -0.3e-3, 0.0, 0.0, 0.0], &Vector3::z());
        assert!((stress[0] - 210e6).abs() < 1e-3);
        assert!(stress[1..].iter().all(|s| s.abs() < 1e-3));
    }

    #[test]
    fn normal_law_sees_the_normal_strain_only() {
        let law = Law::NormalOnly { e_normal: 3e9 };
        let n = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let (stress, _) = law.stress(&[1e-3, 0.0, 0.0, 0.0, 0.0, 0.0], &n);
        // E_nn = n_x² ε_xx = 1e-3/9, S = 3e9 · E_nn n ⊗ n.
        assert!((stress[0] - 3e6 / 81.0).abs() < 1e-6 && (stress[4] - 3e6 / 9.0 * 4.0 / 9.0).abs() < 1e-6);
        let (shear, _) = law.stress(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], &Vector3::z());
        assert_eq!(shear, [0.0; 6]);
    }

    #[test]
    fn parameters_out_of_range_are_refused() {
        let isotropic = |young_modulus, poisson_ratio| Law::Isotropic {
            young_modulus,
            poisson_ratio,
        };
        assert!(isotropic(0.0, 0.2).check("solid8").is_err());
        assert!(isotropic(1.0, 0.5).check("solid8").is_err());
        assert!(isotropic(f64::NAN, 0.2).check("solid8").is_err());
        assert!(Law::NormalOnly { e_normal: -1.0 }.check("solid8").is_err());
        assert!(isotropic(1.0, -0.5).check("solid8").is_ok());
    }
}
