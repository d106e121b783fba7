//! Families of materials: each code has rules for some of them.

use super::{METAL, Material};
use crate::words;

words! {
    /// Family of a material.
    pub Family {
        /// Carbon and low-alloy steel.
        CarbonSteel = "carbon_steel",
        /// Stainless steel: API 650 annex S.
        Stainless = "stainless",
        /// Aluminium alloy: API 650 annex AL.
        Aluminium = "aluminium",
        /// Another metal, such as titanium or steel with nine per cent of nickel.
        OtherMetal = "other_metal",
        /// Concrete, reinforced or not.
        Concrete = "concrete",
        /// Polymer, with or without fibres.
        Polymer = "polymer",
        /// None of these.
        Other = "other",
    }
}

impl Family {
    /// Whether it is a metal.
    pub fn is_metal(self) -> bool {
        matches!(self, Family::CarbonSteel | Family::Stainless | Family::Aluminium | Family::OtherMetal)
    }

    /// The name as it stands in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Family::CarbonSteel => "carbon steel",
            Family::Stainless => "stainless steel",
            Family::Aluminium => "aluminium",
            Family::OtherMetal => "another metal",
            Family::Concrete => "concrete",
            Family::Polymer => "polymer",
            Family::Other => "another material",
        }
    }

    /// Moduli [Pa], Poisson's ratios and densities [kg/m³] that the family has at ambient temperature; none where it is open.
    pub fn ranges(self) -> Option<[(f64, f64); 3]> {
        match self {
            Family::CarbonSteel => Some([(190e9, 220e9), (0.25, 0.34), (7600.0, 8000.0)]),
            Family::Stainless => Some([(180e9, 220e9), (0.25, 0.34), (7600.0, 8200.0)]),
            Family::Aluminium => Some([(60e9, 80e9), (0.28, 0.36), (2550.0, 2900.0)]),
            Family::Concrete => Some([(5e9, 60e9), (0.0, 0.3), (1000.0, 4000.0)]),
            Family::Polymer => Some([(0.1e9, 60e9), (0.1, 0.5), (800.0, 2500.0)]),
            Family::OtherMetal | Family::Other => None,
        }
    }

    /// The only family with this modulus [Pa] and density [kg/m³]; none where several have them.
    ///
    /// Stainless steel has 193 to 200 GPa and 7700 to 8000 kg/m³ (duplex 7800), carbon steel 200 to 212 GPa and 7850 kg/m³: between them
    /// nothing decides. Glass (70 GPa, 2500 kg/m³) is lighter than aluminium, light concrete (below 2200 kg/m³) as heavy as a laminate.
    pub fn inferred(youngs_modulus: f64, density: f64) -> Option<Family> {
        let within = |e: (f64, f64), rho: (f64, f64)| {
            (e.0 * 1e9..=e.1 * 1e9).contains(&youngs_modulus) && (rho.0..=rho.1).contains(&density)
        };
        let ranges = [
            (Family::CarbonSteel, (198.0, 215.0), (7830.0, 7870.0)),
            (Family::CarbonSteel, (204.0, 215.0), (7700.0, 7890.0)),
            (Family::Stainless, (185.0, 201.0), (7890.0, 8100.0)),
            (Family::Aluminium, (65.0, 75.0), (2600.0, 2850.0)),
            (Family::Concrete, (15.0, 50.0), (2200.0, 2700.0)),
            (Family::Polymer, (0.5, 6.0), (850.0, 1600.0)),
        ];
        ranges.into_iter().find(|(_, e, rho)| within(*e, *rho)).map(|(family, ..)| family)
    }
}

impl Material {
    /// Whether it is a metal: by its family, or by its modulus where that is not known. Concrete has at most 50 GPa, aluminium 69 GPa.
    pub fn is_metal(&self) -> bool {
        (self.family).map_or(self.youngs_modulus >= METAL, Family::is_metal)
    }

    /// Whether it is of this family.
    pub fn is(&self, family: Family) -> bool {
        self.family == Some(family)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of EN 1993-1-1, EN 1993-1-4, EN 1999-1-1, EN 1992-1-1 and of data sheets; what two families share stays open.
    #[test]
    fn inference_leaves_open_what_is_not_one_family() {
        for (e, rho, family) in [
            (210e9, 7850.0, Some(Family::CarbonSteel)),
            (199.95e9, 7850.0, Some(Family::CarbonSteel)),
            (193e9, 8000.0, Some(Family::Stainless)),
            (200e9, 7900.0, Some(Family::Stainless)),
            // Duplex 1.4462, and a rounded carbon steel.
            (200e9, 7800.0, None),
            (70e9, 2700.0, Some(Family::Aluminium)),
            // Glass.
            (70e9, 2500.0, None),
            (33e9, 2500.0, Some(Family::Concrete)),
            // Light concrete, or a laminate of carbon fibres.
            (20e9, 1800.0, None),
            // Perspex.
            (3e9, 1190.0, Some(Family::Polymer)),
            (110e9, 4500.0, None),
            (f64::NAN, 7850.0, None),
        ] {
            assert_eq!(Family::inferred(e, rho), family, "{e} {rho}");
        }
    }
}
