//! Springs and dashpots with constant coefficients under a slab.
//!
//! A half-space has those of its cones. Layers, embedment and hysteresis make the impedance depend on the frequency: then springs and
//! dashpots are Re S and Im S/ω at the frequency ω̃ of the impulsive mode on the soil. Waves of the liquid, 10 to 50 times slower, hardly move the slab.

use ::soil::body::Mode;
use ::soil::layered::Embedded;

use super::Slab;
use crate::FeError;

/// What holds a slab, about its underside.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ground {
    /// Springs of x and ψ.
    pub spring: [[f64; 2]; 2],
    /// Dashpots of x and ψ, positive semi-definite.
    pub dashpot: [[f64; 2]; 2],
    /// Moment of inertia of the soil that rocks with the slab [kg m²].
    pub trapped_inertia: f64,
    /// Moment of inertia of the internal rotation of the cone [kg m²], and the dashpot between it and the slab [N m s].
    pub inner: Option<[f64; 2]>,
    /// Frequency to which springs and dashpots belong, where they depend on it [rad/s].
    pub omega: Option<f64>,
}

impl Ground {
    /// The ground of a slab.
    ///
    /// * `impulsive`: the impulsive mode on a fixed base
    ///
    /// Errors: no effective period; layers under a tank without an impulsive mode.
    pub(super) fn of(slab: &Slab, impulsive: Option<Mode>) -> Result<Ground, FeError> {
        let Some(soil) = &slab.embedded else {
            let cones = slab.disc.cones();
            return Ok(Ground {
                spring: [[cones.stiffness.horizontal, 0.0], [0.0, cones.stiffness.rocking]],
                dashpot: [[cones.horizontal_dashpot, 0.0], [0.0, 0.0]],
                trapped_inertia: cones.trapped_inertia,
                inner: Some([cones.internal_inertia, cones.rocking_dashpot]),
                omega: None,
            });
        };
        let failed = |e: String| FeError::Analysis(format!("the tank on soil: {e}"));
        let mode = impulsive.ok_or_else(|| failed("no impulsive mode to which the soil could belong".into()))?;
        let period = soil.effective(&mode.structure()).map_err(|e| failed(e.to_string()))?.period;
        Ok(Ground::at(soil, std::f64::consts::TAU / period))
    }

    fn at(soil: &Embedded, omega: f64) -> Ground {
        let s = soil.impedance(omega);
        let part = |of: fn(&::soil::C64) -> f64| s.map(|row| [of(&row[0]), of(&row[1])]);
        Ground {
            spring: part(|v| v.re),
            dashpot: semi_definite(part(|v| v.im).map(|row| row.map(|v| v / omega))),
            trapped_inertia: soil.trapped_inertia(),
            inner: None,
            omega: Some(omega),
        }
    }

    /// Dashpots as rows over x and ψ in units of `scale`, with their coefficients.
    pub(super) fn principal(&self, scale: [f64; 2]) -> [([f64; 2], f64); 2] {
        let [[a, b], [_, d]] = self.dashpot;
        let (a, b, d) = (a * scale[0] * scale[0], b * scale[0] * scale[1], d * scale[1] * scale[1]);
        // Eigenvectors of a symmetric matrix of two rows.
        let angle = 0.5 * (2.0 * b).atan2(a - d);
        let (sine, cosine) = angle.sin_cos();
        let first = a * cosine * cosine + 2.0 * b * sine * cosine + d * sine * sine;
        let second = a * sine * sine - 2.0 * b * sine * cosine + d * cosine * cosine;
        [([cosine, sine], first.max(0.0)), ([-sine, cosine], second.max(0.0))]
    }
}

/// With a coupling no larger than the diagonal bears: cones of discs may exceed it by rounding.
fn semi_definite([[a, b], [_, d]]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let (a, d) = (a.max(0.0), d.max(0.0));
    let most = (a * d).sqrt();
    let b = b.clamp(-most, most);
    [[a, b], [b, d]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// λ₁ v₁ v₁ᵀ + λ₂ v₂ v₂ᵀ is the matrix.
    #[test]
    fn principal_dashpots_are_the_matrix() {
        let dashpot = [[3.0, -1.2], [-1.2, 2.0]];
        let ground = Ground { spring: dashpot, dashpot, trapped_inertia: 0.0, inner: None, omega: None };
        let parts = ground.principal([1.0, 0.5]);
        for i in 0..2 {
            for j in 0..2 {
                let sum: f64 = parts.iter().map(|(v, c)| c * v[i] * v[j]).sum();
                let scale = [1.0, 0.5];
                assert!((sum - dashpot[i][j] * scale[i] * scale[j]).abs() < 1e-14);
            }
        }
        assert_eq!(semi_definite([[4.0, 9.0], [9.0, 1.0]]), [[4.0, 2.0], [2.0, 1.0]]);
    }
}
