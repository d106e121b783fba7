//! Behaviour of a material beyond its elastic range. Plain data for the nonlinear engine; the code procedures and the
//! linear engines use E, ν and ρ only.

use crate::keys::{Field, Limits, Or, Stress, keys};
use crate::words;
use serde::{Deserialize, Serialize};

/// Behaviour of a material.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Behaviour {
    /// Linear elastic, isotropic.
    #[default]
    Elastic,
    /// Yields.
    Steel(Steel),
    /// Cracks and crushes.
    Concrete(Concrete),
    /// Bars in concrete.
    Reinforcement(Bar),
    /// Elastic layer between two shells.
    Interlayer(Interlayer),
}

impl Behaviour {
    /// Kind, as in the tank file.
    pub fn kind(&self) -> &'static str {
        match self {
            Behaviour::Elastic => "elastic",
            Behaviour::Steel(_) => "steel",
            Behaviour::Concrete(_) => "concrete",
            Behaviour::Reinforcement(_) => "reinforcement",
            Behaviour::Interlayer(_) => "interlayer",
        }
    }

    /// Whether it is the elastic one.
    pub fn is_elastic(&self) -> bool {
        *self == Behaviour::Elastic
    }
}

/// Steel plate: von Mises yield condition, linear mixed hardening.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Steel {
    /// Yield strength σ_F [Pa] of the law, > 0. The code checks take [`super::Material::yield_strength`].
    pub yield_strength: f64,
    /// Slope E_T of the uniaxial stress-strain line beyond yielding [Pa], 0 ≤ E_T < E.
    pub tangent_modulus: f64,
    /// Share of kinematic hardening, from 0 (isotropic) to 1 (kinematic).
    pub kinematic_share: f64,
    /// Tensile strength [Pa], > σ_F: larger stresses are reported.
    pub ultimate_strength: Option<f64>,
}

/// Bars in concrete: uniaxial, bilinear, kinematic hardening.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bar {
    /// Yield strength f_y [Pa], > 0.
    pub yield_strength: f64,
    /// Slope E_T beyond yielding [Pa], 0 ≤ E_T < E.
    pub tangent_modulus: f64,
    /// Strain at rupture, > f_y/E: larger strains are reported.
    pub rupture_strain: Option<f64>,
}

/// Concrete.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Concrete {
    /// Law.
    pub law: ConcreteLaw,
    /// Uniaxial compressive strength f_c [Pa], > 0.
    pub compressive_strength: f64,
    /// Characteristic cylinder strength f_ck [Pa], needed by the checks of EN 1992.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub characteristic_strength: Option<f64>,
    /// Ratio f_bc/f_c of biaxial to uniaxial compressive strength, ≥ 1.
    pub biaxial_ratio: f64,
    /// Tensile strength f_t [Pa], 0 < f_t < f_c.
    pub tensile_strength: f64,
    /// Biaxial strength in compression.
    #[serde(default, skip_serializing_if = "BiaxialEnvelope::is_default")]
    pub envelope: BiaxialEnvelope,
    /// Tension beyond f_t.
    pub softening: Softening,
    /// Least shear stiffness of a cracked point over that of a sound one, from 0 to 1.
    pub shear_retention: f64,
    /// Crack strain e_b over which the shear stiffness falls, > 0.
    pub shear_retention_strain: f64,
    /// Tensile stress between cracks while the bars across them are elastic, over f_t: from 0 (none) to below 1.
    pub tension_stiffening: f64,
    /// Spacing of the cracks [m], where bars set it: the length over which an opening is smeared is at most this.
    pub crack_spacing: Option<f64>,
    /// Bond of the bars.
    #[serde(default, skip_serializing_if = "BarBond::is_perfect")]
    pub bond: BarBond,
}

words! {
    /// Biaxial strength in compression.
    pub BiaxialEnvelope: DruckerPrager in "snake_case" {
        /// Drucker and Prager's cone through both strengths.
        DruckerPrager = "drucker-prager",
        /// The curve of Kupfer and Gerstle through both strengths.
        Kupfer = "kupfer",
    }
}

impl BiaxialEnvelope {
    /// Whether it is the default.
    pub fn is_default(&self) -> bool {
        *self == BiaxialEnvelope::default()
    }
}

words! {
    /// Bond of bars.
    pub BarBond: Perfect {
        /// No slip.
        Perfect = "perfect",
        /// Bond law of CEB-FIP Model Code 1990, unconfined concrete, good bond conditions.
        Good = "good",
        /// The same, all other bond conditions.
        Other = "other",
    }
}

impl BarBond {
    /// Whether the bars do not slip.
    pub fn is_perfect(&self) -> bool {
        *self == BarBond::Perfect
    }
}

words! {
    /// Law of concrete.
    pub ConcreteLaw: Cracked in "snake_case" {
        /// Fixed cracks at right angles, Drucker-Prager compression.
        Cracked = "cracked",
        /// Uniaxial laws in the directions of the wall, for strips and rings.
        Uniaxial = "uniaxial",
        /// Plastic-fracturing theory.
        PlasticFracturing = "plastic-fracturing",
        /// Two cones of Drucker and Prager through compressive_strength, biaxial_ratio and tensile_strength, ideally plastic: it does not
        /// soften and has no cracks.
        TwoSurface = "two-surface",
        /// Dougill's progressively fracturing solid: from compressive_strength on its stiffness falls, without permanent strain; the energy
        /// is 250 times the fracture energy of the compressive strength (fib Model Code 2010) over the size of the element.
        /// tensile_strength does not enter: in tension the stiffness falls from 0.6 to 1 of the compressive strength on, by biaxial_ratio.
        Fracturing = "fracturing",
    }
}

impl ConcreteLaw {
    /// Whether the law has a softening branch in tension, cracks and their shear.
    pub fn cracks(self) -> bool {
        matches!(self, ConcreteLaw::Cracked | ConcreteLaw::Uniaxial)
    }
}

/// Tension of concrete beyond its strength.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", content = "value", rename_all = "snake_case")]
pub enum Softening {
    /// σ = f_t exp(−e/e_f), e_f = G_f/(f_t h), with the fracture energy G_f [N/m] and the size h of the element.
    FractureEnergy(f64),
    /// The same with this strain e_f in every element: the energy of a crack grows with the element.
    Strain(f64),
    /// The stress drops to zero.
    Brittle,
}

/// Moduli and strengths; "rigid" walls of benchmarks are allowed.
pub const STRESS: Limits = Limits::from(1e3).to(1e18);
/// Slopes and moduli that may be zero.
pub const SLOPE: Limits = Limits::from(0.0).to(1e18);

keys! {
    /// Elastic layer between two shells.
    pub Interlayer as InterlayerBehaviour (Copy) {
        /// Modulus along the normal of the wall.
        e_normal ("10 MPa"): Field<Stress> [STRESS],
        /// Modulus in the plane of the wall, between the shells of the nonlinear engine; the homogeneous wall of the others leaves it out.
        e_parallel ("10 MPa"): Or<Stress> [SLOPE] = default(Stress(0.0)).because("stiff along the normal only"),
        /// Transverse shear modulus; 0: the layer passes no shear.
        shear_modulus ("4 MPa"): Or<Stress> [SLOPE] = default(Stress(0.0)).because("passes no shear"),
        /// Whether the layer carries tension along the normal.
        tension (false): Or<bool> = default(true).because("glued"),
    }
}

/// Used fraction of the largest stable element size.
const MARGIN: f64 = 0.98;

impl Concrete {
    /// Largest element size h [m] for which the softening branch is not steeper than the elastic one of Young's
    /// modulus `e` [Pa], with a margin of 2 %; infinite if the branch is independent of the size.
    ///
    /// ```text
    /// |dσ/de| = f_t²h/G_f ≤ E   ⇔   h ≤ E G_f/f_t²
    /// ```
    ///
    /// On a larger element a crack snaps back: its strain falls while it opens (Bažant and Oh 1983).
    /// Known value: E = 34 GPa, G_f = 140 N/m, f_t = 3.5 MPa gives 0.98 · 0.3886 m.
    pub fn largest_element(&self, e: f64) -> f64 {
        match self.softening {
            Softening::FractureEnergy(g_f) => MARGIN * e * g_f / self.tensile_strength.powi(2),
            Softening::Strain(_) | Softening::Brittle => f64::INFINITY,
        }
    }

    /// Least softening strain e_f with the same property: f_t/E, with the margin of [`Concrete::largest_element`].
    pub fn least_softening_strain(&self, e: f64) -> f64 {
        self.tensile_strength / (MARGIN * e)
    }

    /// Length h [m] over which an opening is smeared in an element of size `element` [m].
    pub fn band(&self, element: f64) -> f64 {
        self.crack_spacing.map_or(element, |spacing| spacing.min(element))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn size_of_the_snap_back() {
        let concrete = Concrete {
            law: ConcreteLaw::Cracked,
            compressive_strength: 35e6,
            characteristic_strength: None,
            biaxial_ratio: 1.16,
            tensile_strength: 3.5e6,
            softening: Softening::FractureEnergy(140.0),
            shear_retention: 0.1,
            shear_retention_strain: 2e-4,
            tension_stiffening: 0.0,
            crack_spacing: None,
            envelope: BiaxialEnvelope::default(),
            bond: BarBond::Perfect,
        };
        let (e, h) = (34e9, concrete.largest_element(34e9));
        assert!((h - 0.98 * 0.388_571).abs() < 1e-6, "{h}");
        // On that element e_f = G_f/(f_t h), and the branch starts with f_t/e_f: 2 % less than E.
        let e_f = 140.0 / (3.5e6 * h);
        assert!((3.5e6 / e_f / e - 0.98).abs() < 1e-12);
        assert!((concrete.least_softening_strain(e) - e_f).abs() < 1e-12);
        assert_eq!(concrete.band(0.5), 0.5);
        let spaced = Concrete { crack_spacing: Some(0.15), softening: Softening::Brittle, ..concrete };
        assert_eq!((spaced.band(0.5), spaced.band(0.1)), (0.15, 0.1));
        assert_eq!(spaced.largest_element(e), f64::INFINITY);
    }
}
