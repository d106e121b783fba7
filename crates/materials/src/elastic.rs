//! Isotropic linear elasticity, σ = C ε.

use crate::{Law, LawError, Response, refuse};

/// Isotropic linear elastic law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    young_modulus: f64,
    poisson_ratio: f64,
}

impl Elastic {
    /// * `young_modulus` E [Pa] > 0
    /// * `poisson_ratio` ν, −1 < ν < 0.5
    ///
    /// Errors: a parameter out of range.
    pub fn new(young_modulus: f64, poisson_ratio: f64) -> Result<Elastic, LawError> {
        let kind = "elastic";
        if !(young_modulus > 0.0 && young_modulus.is_finite()) {
            return Err(refuse(kind, "youngs_modulus", format!("{young_modulus} Pa"), "> 0 and finite"));
        }
        if !(poisson_ratio > -1.0 && poisson_ratio < 0.5) {
            return Err(refuse(kind, "poisson_ratio", poisson_ratio.to_string(), "between −1 and 0.5"));
        }
        Ok(Elastic { young_modulus, poisson_ratio })
    }

    /// Young's modulus E [Pa].
    pub fn young_modulus(&self) -> f64 {
        self.young_modulus
    }

    /// Poisson's ratio ν.
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// Shear modulus G [Pa].
    pub fn shear_modulus(&self) -> f64 {
        0.5 * self.young_modulus / (1.0 + self.poisson_ratio)
    }

    /// Moduli of plane stress [Pa].
    pub fn plane(&self) -> [[f64; 3]; 3] {
        let nu = self.poisson_ratio;
        let c = self.young_modulus / (1.0 - nu * nu);
        [[c, nu * c, 0.0], [nu * c, c, 0.0], [0.0, 0.0, self.shear_modulus()]]
    }

    /// Moduli of the solid [Pa].
    pub fn solid(&self) -> [[f64; 6]; 6] {
        let nu = self.poisson_ratio;
        let lambda = self.young_modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let mu = self.shear_modulus();
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
}

/// σ = C ε.
fn linear<const N: usize>(tangent: [[f64; N]; N], strain: &[f64; N]) -> Response<N> {
    Response { stress: tangent.map(|row| row.iter().zip(strain).map(|(c, e)| c * e).sum()), tangent, dissipation: 0.0 }
}

impl Law<1> for Elastic {
    fn kind(&self) -> &'static str {
        "elastic"
    }

    fn is_linear(&self) -> bool {
        true
    }

    fn respond(&self, strain: &[f64; 1], _old: &[f64], _new: &mut [f64]) -> Result<Response<1>, LawError> {
        Ok(linear([[self.young_modulus]], strain))
    }
}

impl Law<3> for Elastic {
    fn kind(&self) -> &'static str {
        "elastic"
    }

    fn is_linear(&self) -> bool {
        true
    }

    fn respond(&self, strain: &[f64; 3], _old: &[f64], _new: &mut [f64]) -> Result<Response<3>, LawError> {
        Ok(linear(self.plane(), strain))
    }
}

impl Law<6> for Elastic {
    fn kind(&self) -> &'static str {
        "elastic"
    }

    fn is_linear(&self) -> bool {
        true
    }

    fn respond(&self, strain: &[f64; 6], _old: &[f64], _new: &mut [f64]) -> Result<Response<6>, LawError> {
        Ok(linear(self.solid(), strain))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniaxial stress σ = E ε: ε = (σ, −ν σ, −ν σ)/E, in the solid and in the plane.
    #[test]
    fn uniaxial_stress_in_solid_and_plane() {
        let law = Elastic::new(210e9, 0.3).unwrap();
        let solid = law.respond(&[1e-3, -3e-4, -3e-4, 0.0, 0.0, 0.0], &[], &mut []).unwrap();
        let plane = law.respond(&[1e-3, -3e-4, 0.0], &[], &mut []).unwrap();
        assert!((solid.stress[0] / 210e6 - 1.0).abs() < 1e-12 && solid.stress[1].abs() < 1e-6);
        assert!((plane.stress[0] / 210e6 - 1.0).abs() < 1e-12 && plane.stress[1].abs() < 1e-6);
    }

    #[test]
    fn parameters_out_of_range_are_rejected() {
        assert!(Elastic::new(0.0, 0.2).is_err());
        assert!(Elastic::new(f64::NAN, 0.2).is_err());
        assert!(Elastic::new(1.0, 0.5).is_err());
    }
}
