//! Elastic laws of the solid: second Piola-Kirchhoff stress S from Green-Lagrange strain E, components in an orthonormal
//! base (with linear kinematics: Cauchy stress from small strain).
//!
//! ```text
//! isotropic      S = λ tr(E) 1 + 2 μ E          λ = E ν / ((1 + ν)(1 − 2ν)),  μ = E / (2 (1 + ν))
//! normal only    S = s(e) n ⊗ n, e = n·E n      n unit normal of the layer in the reference state
//! core           S = E_n e n ⊗ n + 2 G (n ⊗ γ + γ ⊗ n) + E_p P E P, γ = E n − e n, P = 1 − n ⊗ n
//!
//! normal only, tension s = E_n e; without tension
//!                s = E_n e,                e ≤ 0
//!                    E_n (e − (1 − r) e²/2w),  0 < e < w        w width of the switch, 0 a sharp one
//!                    E_n ((1 − r) w/2 + r e),  e ≥ w            r residual
//! ```
//!
//! The first is St. Venant and Kirchhoff's law with the metric of the reference state (the dissertation prints that of the
//! current one in (6.25), (6.26)). The second is its layer between two shells, section 6.3.1, where only D³³³³ ≠ 0. The
//! third adds shear across the layer, the core of a sandwich, and stiffness in its plane without contraction: transversely isotropic,
//! isotropic with ν = 0 for E_n = E_p = 2 G.
//!
//! The switch lies wholly on the side of tension, so that the reference state is stressless and has the full modulus;
//! a width w costs a tensile strength of E_n w/2.
//!
//! Voigt order 11, 22, 33, 12, 23, 13, engineering shears in the strain.

use nalgebra::Vector3;

use super::{ElementError, not_negative, positive, require};

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
        /// Whether the layer holds two shells together.
        tension: Tension,
    },
    /// A bonded layer: stiff along its normal, and in shear across it or in its plane. It stands only between two shells.
    Core {
        /// Modulus along the normal [Pa], > 0.
        e_normal: f64,
        /// Shear modulus G_13 = G_23 [Pa], ≥ 0; > 0 without `e_parallel`.
        shear_modulus: f64,
        /// Modulus in the plane E_p [Pa], ≥ 0; its shear modulus there is E_p/2.
        e_parallel: f64,
    },
}

/// Behaviour of a layer under extension along its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tension {
    /// The same as under compression.
    Full,
    /// It parts.
    None {
        /// Share r of the modulus that remains, 0 < r < 1; usually 1e-6.
        residual: f64,
        /// Strain w over which the modulus falls, ≥ 0; 1e-8 calms an iteration that chatters.
        width: f64,
    },
}

impl Tension {
    /// No tension, sharp switch, residual 1e-6.
    pub const NONE: Tension = Tension::None { residual: 1e-6, width: 0.0 };
}

impl Law {
    /// Refuses parameters out of range.
    pub(super) fn check(&self, kind: &'static str) -> Result<(), ElementError> {
        let check = |good, parameter, found: f64, allowed| require(good, kind, parameter, found, allowed);
        match *self {
            Law::Isotropic { young_modulus, poisson_ratio: nu } => {
                check(positive(young_modulus), "young_modulus", young_modulus, "> 0")?;
                check(nu > -1.0 && nu < 0.5, "poisson_ratio", nu, "between −1 and 0.5")
            }
            Law::Core { e_normal, shear_modulus, e_parallel } => {
                check(positive(e_normal), "e_normal", e_normal, "> 0")?;
                check(not_negative(e_parallel), "e_parallel", e_parallel, "≥ 0")?;
                let stiff = positive(shear_modulus) || (shear_modulus == 0.0 && e_parallel > 0.0);
                check(stiff, "shear_modulus", shear_modulus, "> 0, or 0 beside an e_parallel")
            }
            Law::NormalOnly { e_normal, tension } => {
                check(positive(e_normal), "e_normal", e_normal, "> 0")?;
                let Tension::None { residual, width } = tension else { return Ok(()) };
                check(residual > 0.0 && residual < 1.0, "residual", residual, "between 0 and 1")?;
                check(not_negative(width), "width", width, "≥ 0")
            }
        }
    }

    /// Lamé's constants (λ, μ) of an isotropic law [Pa].
    pub fn lame(&self) -> Option<(f64, f64)> {
        match *self {
            Law::Isotropic { young_modulus, poisson_ratio } => Some(lame(young_modulus, poisson_ratio)),
            Law::NormalOnly { .. } | Law::Core { .. } => None,
        }
    }

    /// Whether stress is proportional to strain.
    pub fn is_linear(&self) -> bool {
        !matches!(self, Law::NormalOnly { tension: Tension::None { .. }, .. })
    }

    /// Whether an element of this law has modes without energy that only shells on both sides can hold.
    pub fn only_between_shells(&self) -> bool {
        !matches!(self, Law::Isotropic { .. })
    }

    /// Stress and tangent moduli ∂S/∂E [Pa] at `strain`, for the layer normal `normal`.
    pub fn stress(&self, strain: &[f64; 6], normal: &Vector3<f64>) -> ([f64; 6], Moduli) {
        let moduli = match *self {
            Law::Isotropic { young_modulus, poisson_ratio } => isotropic_moduli(lame(young_modulus, poisson_ratio)),
            Law::NormalOnly { e_normal, tension: Tension::Full } => normal_moduli(e_normal, normal),
            Law::NormalOnly { e_normal, tension: Tension::None { residual, width } } => {
                let p = dyad(normal);
                let strain: f64 = p.iter().zip(strain).map(|(p, e)| p * e).sum();
                let (stress, modulus) = without_tension(e_normal, residual, width, strain);
                return (p.map(|p| stress * p), normal_moduli(modulus, normal));
            }
            Law::Core { e_normal, shear_modulus, e_parallel } => {
                core_moduli([e_normal, shear_modulus, e_parallel], normal)
            }
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

/// Voigt vector of n ⊗ n that is work-conjugate to engineering shears: n·E n = p · ε.
pub(super) fn dyad(n: &Vector3<f64>) -> [f64; 6] {
    [n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z]
}

/// E_n p pᵀ.
fn normal_moduli(e_normal: f64, n: &Vector3<f64>) -> Moduli {
    let p = dyad(n);
    p.map(|a| p.map(|b| e_normal * a * b))
}

/// Voigt vector of a ⊗ b + b ⊗ a, work-conjugate to engineering shears: 2 a·E b = p · ε.
fn both(a: &Vector3<f64>, b: &Vector3<f64>) -> [f64; 6] {
    [
        2.0 * a.x * b.x,
        2.0 * a.y * b.y,
        2.0 * a.z * b.z,
        a.x * b.y + a.y * b.x,
        a.y * b.z + a.z * b.y,
        a.x * b.z + a.z * b.x,
    ]
}

/// E_n p pᵀ + G Σ p_α p_αᵀ + E_p (q₁ q₁ᵀ + q₂ q₂ᵀ + ½ q₁₂ q₁₂ᵀ) with two tangents t_α, p_α of t_α ⊗ n + n ⊗ t_α, q_α of t_α ⊗ t_α and q₁₂ of
/// t₁ ⊗ t₂ + t₂ ⊗ t₁.
fn core_moduli([e_normal, shear_modulus, e_parallel]: [f64; 3], n: &Vector3<f64>) -> Moduli {
    let wish = if n.x.abs() < 0.7 { Vector3::x() } else { Vector3::y() };
    let first = (wish - n * n.dot(&wish)).normalize();
    let second = n.cross(&first);
    let mut moduli = normal_moduli(e_normal, n);
    for (modulus, p) in [
        (shear_modulus, both(&first, n)),
        (shear_modulus, both(&second, n)),
        (e_parallel, dyad(&first)),
        (e_parallel, dyad(&second)),
        (0.5 * e_parallel, both(&first, &second)),
    ] {
        for (row, a) in moduli.iter_mut().zip(p) {
            for (d, b) in row.iter_mut().zip(p) {
                *d += modulus * a * b;
            }
        }
    }
    moduli
}

/// Stress and tangent modulus of a layer without tension.
fn without_tension(e_normal: f64, residual: f64, width: f64, strain: f64) -> (f64, f64) {
    let rest = 1.0 - residual;
    if strain <= 0.0 {
        (e_normal * strain, e_normal)
    } else if strain < width {
        let fallen = rest * strain / width;
        (e_normal * strain * (1.0 - 0.5 * fallen), e_normal * (1.0 - fallen))
    } else {
        (e_normal * (0.5 * rest * width + residual * strain), e_normal * residual)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniaxial stress: σ = E ε with ε_lateral = −ν ε.
    #[test]
    fn uniaxial_stress_shows_youngs_modulus() {
        let law = Law::Isotropic { young_modulus: 210e9, poisson_ratio: 0.3 };
        let (stress, _) = law.stress(&[1e-3, -0.3e-3, -0.3e-3, 0.0, 0.0, 0.0], &Vector3::z());
        assert!((stress[0] - 210e6).abs() < 1e-3);
        assert!(stress[1..].iter().all(|s| s.abs() < 1e-3));
    }

    #[test]
    fn normal_law_sees_the_normal_strain_only() {
        let law = Law::NormalOnly { e_normal: 3e9, tension: Tension::Full };
        let n = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let (stress, _) = law.stress(&[1e-3, 0.0, 0.0, 0.0, 0.0, 0.0], &n);
        // E_nn = n_x² ε_xx = 1e-3/9, S = 3e9 · E_nn n ⊗ n.
        assert!((stress[0] - 3e6 / 81.0).abs() < 1e-6 && (stress[4] - 3e6 / 9.0 * 4.0 / 9.0).abs() < 1e-6);
        let (shear, _) = law.stress(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], &Vector3::z());
        assert_eq!(shear, [0.0; 6]);
    }

    /// The stress is the integral of the modulus, continuous at both ends of the switch, and zero in the reference state.
    #[test]
    fn tension_is_cut_off() {
        let (e, r, w) = (4e9, 1e-3, 1e-4);
        assert_eq!(without_tension(e, r, w, -2e-3), (-8e6, e));
        assert_eq!(without_tension(e, r, w, 0.0), (0.0, e));
        let mut sum = 0.0;
        let (from, to, steps) = (-0.5e-4, 2e-4, 200_000);
        let mut last = without_tension(e, r, w, from).1;
        let step = (to - from) / f64::from(steps);
        for i in 1..=steps {
            let next = without_tension(e, r, w, from + step * f64::from(i)).1;
            sum += 0.5 * step * (last + next);
            last = next;
        }
        let change = without_tension(e, r, w, to).0 - without_tension(e, r, w, from).0;
        assert!((sum / change - 1.0).abs() < 1e-6);
        // Sharp: the residual alone.
        assert_eq!(without_tension(e, 1e-6, 0.0, 1e-3), (e * 1e-9, e * 1e-6));
    }

    /// Pure shear γ across the layer gives τ = G γ for any normal; shear and stretch in its plane give no stress.
    #[test]
    fn core_carries_shear_across() {
        let law = Law::Core { e_normal: 7.0, shear_modulus: 3.0, e_parallel: 0.0 };
        let n = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let t = Vector3::new(2.0, 1.0, -2.0) / 3.0;
        let voigt = |e: nalgebra::Matrix3<f64>| {
            [e[(0, 0)], e[(1, 1)], e[(2, 2)], 2.0 * e[(0, 1)], 2.0 * e[(1, 2)], 2.0 * e[(0, 2)]]
        };
        let tensor = |s: [f64; 6]| nalgebra::Matrix3::new(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]);
        let gamma = 1e-3;
        let (stress, _) = law.stress(&voigt((n * t.transpose() + t * n.transpose()) * (0.5 * gamma)), &n);
        let expected = (n * t.transpose() + t * n.transpose()) * (3.0 * gamma);
        assert!((tensor(stress) - expected).norm() < 1e-15);
        let (stress, _) = law.stress(&voigt(t * t.transpose()), &n);
        assert!(tensor(stress).norm() < 1e-14);
        let (stress, _) = law.stress(&voigt(n * n.transpose()), &n);
        assert!((tensor(stress) - n * n.transpose() * 7.0).norm() < 1e-14);
    }

    /// E_n = E_p = 2 G is the isotropic law with ν = 0 for any normal; stretch in the plane alone gives E_p.
    #[test]
    fn equal_moduli_are_isotropic() {
        let n = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let equal = Law::Core { e_normal: 4.0, shear_modulus: 2.0, e_parallel: 4.0 };
        let isotropic = Law::Isotropic { young_modulus: 4.0, poisson_ratio: 0.0 };
        let [found, expected] = [equal, isotropic].map(|law| law.stress(&[0.0; 6], &n).1);
        let difference = found.as_flattened().iter().zip(expected.as_flattened()).map(|(a, b)| (a - b).abs());
        assert!(difference.fold(0.0, f64::max) < 1e-14);
        let layer = Law::Core { e_normal: 7.0, shear_modulus: 0.0, e_parallel: 5.0 };
        let (stress, _) = layer.stress(&[1e-3, 2e-3, 0.0, 4e-3, 6e-3, 8e-3], &Vector3::z());
        let expected = [5e-3, 10e-3, 0.0, 10e-3, 0.0, 0.0];
        assert!(stress.iter().zip(expected).all(|(s, e)| (s - e).abs() < 1e-15), "{stress:?}");
    }

    #[test]
    fn parameters_out_of_range_are_rejected() {
        let isotropic = |young_modulus, poisson_ratio| Law::Isotropic { young_modulus, poisson_ratio };
        assert!(isotropic(0.0, 0.2).check("solid8").is_err());
        assert!(isotropic(1.0, 0.5).check("solid8").is_err());
        assert!(isotropic(f64::NAN, 0.2).check("solid8").is_err());
        let layer = |e_normal, tension| Law::NormalOnly { e_normal, tension };
        assert!(layer(-1.0, Tension::Full).check("solid8").is_err());
        assert!(layer(1.0, Tension::NONE).check("solid8").is_ok());
        let wide = |residual, width| layer(1.0, Tension::None { residual, width });
        assert!(wide(0.0, 0.0).check("solid8").is_err() && wide(0.1, -1.0).check("solid8").is_err());
        let core = |shear_modulus, e_parallel| Law::Core { e_normal: 1.0, shear_modulus, e_parallel };
        assert!(core(0.0, 0.0).check("solid8").is_err() && core(-1.0, 1.0).check("solid8").is_err());
        assert!(core(0.0, 1.0).check("solid8").is_ok() && core(1.0, -1.0).check("solid8").is_err());
        assert!(isotropic(1.0, -0.5).check("solid8").is_ok());
    }
}
