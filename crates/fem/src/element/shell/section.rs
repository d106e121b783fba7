//! Sections: resultants from the strains of the reference surface.
//!
//! ```text
//! E_ij(ζ) = ε_ij + ζ κ_ij ,  ζ ∈ [e − t/2, e + t/2]        ζ along the director, e eccentricity
//! N = ∫ σ dζ ,  M = ∫ ζ σ dζ ,  Q = k_s G t γ
//!
//! elastic:   N = C t ε + C e t κ
//!            M = C e t ε + C (t³/12 + e² t) κ              C plane stress, k_s = 5/6
//! ```
//!
//! Strains and resultants have this order, shears as engineering strains:
//!
//! ```text
//! ε_11 ε_22 2ε_12   κ_11 κ_22 2κ_12   γ_1 γ_2
//! n_11 n_22 n_12    m_11 m_22 m_12    q_1 q_2
//! ```

use materials::PointState;

use crate::element::{ElementError, Stage, not_negative, positive, require};

/// Resultants of one point and their derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionResponse {
    /// n_11, n_22, n_12 [N/m], m_11, m_22, m_12 [N], q_1, q_2 [N/m].
    pub resultants: [f64; 8],
    /// Derivatives of the resultants with respect to the strains, symmetric.
    pub tangent: [[f64; 8]; 8],
}

impl Default for SectionResponse {
    fn default() -> Self {
        SectionResponse { resultants: [0.0; 8], tangent: [[0.0; 8]; 8] }
    }
}

/// A layer or bar as a picture shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerState {
    /// Number, bars after the layers.
    pub layer: usize,
    /// Depth ζ [m].
    pub depth: f64,
    /// Direction of the strain's first axis: angle from axis 1 of the section towards its axis 2 [rad]; 0 in layers.
    pub angle: f64,
    /// ε_11, ε_22, γ_12 less free and crept strains; of a bar the strain along it, alone.
    pub strain: [f64; 3],
    /// σ_11, σ_22, σ_12 [Pa]; of a bar its stress alone.
    pub stress: [f64; 3],
    /// State of the material.
    pub state: PointState,
}

/// Build-up of a shell through its thickness.
pub trait Section: Send + Sync {
    /// Number of history variables of one point.
    fn history_len(&self) -> usize {
        0
    }

    /// Writes the initial history of one point.
    fn init_history(&self, _slots: &mut [f64]) {}

    /// Whether the response depends on the directions of axes 1 and 2 (bars, orthotropy, anything with a history). The shell then
    /// hands over strains in its [`Axes`](crate::element::shell4::Axes), else in any frame.
    fn has_frame(&self) -> bool {
        true
    }

    /// Resultants and tangent at the strains ε, κ, γ, with the committed history `old`; writes the trial history `new`.
    ///
    /// Errors: a strain for which the law fails.
    fn respond(
        &self,
        strain: &[f64; 8],
        old: &[f64],
        new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError>;

    /// The same without the tangent, which may be left as it is; the resultants are those of [`Section::respond`], bit for bit.
    ///
    /// Errors: those of [`Section::respond`].
    fn resist(
        &self,
        strain: &[f64; 8],
        old: &[f64],
        new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError> {
        self.respond(strain, old, new, out)
    }

    /// Changes the stage in the committed history of one point.
    fn stage(&self, _stage: Stage, _history: &mut [f64]) {}

    /// Energy dissipated so far per area of the reference surface [J/m²], read from the committed history of one point.
    fn dissipated(&self, _history: &[f64]) -> f64 {
        0.0
    }

    /// Shows every layer and bar of one point: number, depth ζ [m], strain, stress [Pa], state; all in the section's frame.
    fn inspect(&self, _strain: &[f64; 8], _history: &[f64], _see: &mut dyn FnMut(LayerState)) {}

    /// ∫ρ dζ, ∫ρ ζ dζ, ∫ρ ζ² dζ [kg/m², kg/m, kg].
    fn inertia(&self) -> [f64; 3];

    /// Elastic in-plane shear stiffness G t [N/m], the measure of the drilling energy.
    fn shear_stiffness(&self) -> f64;
}

/// Shear correction factor of a homogeneous section.
pub const SHEAR_CORRECTION: f64 = 5.0 / 6.0;

/// Homogeneous isotropic elastic section.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticSection {
    youngs_modulus: f64,
    poisson_ratio: f64,
    thickness: f64,
    density: f64,
    eccentricity: f64,
    tangent: [[f64; 8]; 8],
}

impl ElasticSection {
    /// Section centred on the reference surface.
    ///
    /// * `youngs_modulus` E [Pa] > 0
    /// * `poisson_ratio` ν, −1 < ν ≤ 0.5
    /// * `thickness` t [m] > 0
    /// * `density` ρ [kg/m³] ≥ 0
    ///
    /// Errors: a parameter out of range.
    pub fn new(
        youngs_modulus: f64,
        poisson_ratio: f64,
        thickness: f64,
        density: f64,
    ) -> Result<ElasticSection, ElementError> {
        let check = |good, parameter, found: f64, allowed| require(good, "shell4", parameter, found, allowed);
        check(positive(youngs_modulus), "Young's modulus", youngs_modulus, "> 0 and finite")?;
        check(poisson_ratio > -1.0 && poisson_ratio <= 0.5, "Poisson's ratio", poisson_ratio, "above −1, at most 0.5")?;
        check(positive(thickness), "thickness", thickness, "> 0 and finite")?;
        check(not_negative(density), "density", density, "≥ 0 and finite")?;
        let mut section = ElasticSection {
            youngs_modulus,
            poisson_ratio,
            thickness,
            density,
            eccentricity: 0.0,
            tangent: [[0.0; 8]; 8],
        };
        section.fill();
        Ok(section)
    }

    /// The same section with its middle at ζ = `eccentricity` [m] from the reference surface, along the director.
    ///
    /// Errors: a value that is not finite.
    pub fn eccentric(mut self, eccentricity: f64) -> Result<ElasticSection, ElementError> {
        require(eccentricity.is_finite(), "shell4", "eccentricity", eccentricity, "finite")?;
        self.eccentricity = eccentricity;
        self.fill();
        Ok(self)
    }

    /// Thickness t [m].
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    fn shear_modulus(&self) -> f64 {
        0.5 * self.youngs_modulus / (1.0 + self.poisson_ratio)
    }

    fn fill(&mut self) {
        let (t, e, nu) = (self.thickness, self.eccentricity, self.poisson_ratio);
        let c = self.youngs_modulus / (1.0 - nu * nu);
        let plane = [[c, nu * c, 0.0], [nu * c, c, 0.0], [0.0, 0.0, self.shear_modulus()]];
        let bending = t * t * t / 12.0 + e * e * t;
        self.tangent = [[0.0; 8]; 8];
        for (i, row) in plane.iter().enumerate() {
            for (j, &c) in row.iter().enumerate() {
                self.tangent[i][j] = c * t;
                self.tangent[i][j + 3] = c * e * t;
                self.tangent[i + 3][j] = c * e * t;
                self.tangent[i + 3][j + 3] = c * bending;
            }
        }
        for i in 6..8 {
            self.tangent[i][i] = SHEAR_CORRECTION * self.shear_modulus() * t;
        }
    }
}

impl Section for ElasticSection {
    fn has_frame(&self) -> bool {
        false
    }

    fn respond(
        &self,
        strain: &[f64; 8],
        _old: &[f64],
        _new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError> {
        for (n, row) in out.resultants.iter_mut().zip(&self.tangent) {
            *n = row.iter().zip(strain).map(|(c, e)| c * e).sum();
        }
        out.tangent = self.tangent;
        Ok(())
    }

    fn inertia(&self) -> [f64; 3] {
        let (t, e, rho) = (self.thickness, self.eccentricity, self.density);
        [rho * t, rho * t * e, rho * (t * t * t / 12.0 + e * e * t)]
    }

    fn shear_stiffness(&self) -> f64 {
        self.shear_modulus() * self.thickness
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form against an integral over 2000 layers.
    #[test]
    fn eccentric_section_is_the_integral_over_its_thickness() {
        let (young, nu, t, e) = (70e9, 0.3, 0.02, 0.013);
        let section = ElasticSection::new(young, nu, t, 2700.0).unwrap().eccentric(e).unwrap();
        let strain = [1e-3, -4e-4, 7e-4, 0.02, 0.03, -0.01, 0.0, 0.0];
        let mut out = SectionResponse::default();
        section.respond(&strain, &[], &mut [], &mut out).unwrap();
        let layers = 2000;
        let mut sum = [0.0; 6];
        let mut inertia = [0.0; 3];
        for k in 0..layers {
            let dz = t / f64::from(layers);
            let z = e - 0.5 * t + dz * (f64::from(k) + 0.5);
            let at: [f64; 3] = std::array::from_fn(|i| strain[i] + z * strain[i + 3]);
            let c = young / (1.0 - nu * nu);
            let stress = [c * (at[0] + nu * at[1]), c * (at[1] + nu * at[0]), c * (1.0 - nu) / 2.0 * at[2]];
            for i in 0..3 {
                sum[i] += stress[i] * dz;
                sum[i + 3] += stress[i] * z * dz;
                inertia[i] += 2700.0 * z.powi(i as i32) * dz;
            }
        }
        for i in 0..6 {
            // Mid-point rule: relative error of ∫ζ² about 1/layers² = 2.5e-7.
            assert!((out.resultants[i] / sum[i] - 1.0).abs() < 1e-6, "{i}");
        }
        for i in 0..3 {
            assert!((section.inertia()[i] / inertia[i] - 1.0).abs() < 1e-6, "{i}");
        }
    }

    #[test]
    fn parameters_out_of_range_are_rejected() {
        assert!(ElasticSection::new(0.0, 0.3, 0.01, 0.0).is_err());
        assert!(ElasticSection::new(1.0, 0.6, 0.01, 0.0).is_err());
        assert!(ElasticSection::new(1.0, 0.3, -0.01, 0.0).is_err());
        assert!(ElasticSection::new(1.0, 0.3, 0.01, f64::NAN).is_err());
    }
}
