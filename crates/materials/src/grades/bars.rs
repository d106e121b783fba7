//! Reinforcing steel.

use crate::LawError;
use crate::bar::{Bar, Rupture};

/// Reinforcing steel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarGrade {
    /// Name.
    pub name: &'static str,
    /// Young's modulus E [Pa] > 0.
    pub young_modulus: f64,
    /// Density ρ [kg/m³] > 0.
    pub density: f64,
    /// Characteristic yield stress f_yk [Pa] > 0.
    pub yield_stress: f64,
    /// Characteristic tensile strength k f_yk [Pa] > f_yk.
    pub ultimate_strength: f64,
    /// Characteristic strain at the greatest force ε_uk, > f_yk/E.
    pub ultimate_strain: f64,
    /// Sources of the numbers.
    pub source: &'static str,
}

impl BarGrade {
    /// Slope from (f_yk/E, f_yk) to (ε_uk, k f_yk) [Pa] (EN 1992-1-1, figure 3.8).
    pub fn tangent_modulus(&self) -> f64 {
        (self.ultimate_strength - self.yield_stress) / (self.ultimate_strain - self.yield_stress / self.young_modulus)
    }

    /// Bilinear bar that records the passing of ε_uk.
    ///
    /// Errors: a parameter out of range.
    pub fn law(&self) -> Result<Bar, LawError> {
        Bar::new(self.young_modulus, self.yield_stress, self.tangent_modulus())?
            .with_rupture(self.ultimate_strain, Rupture::Recorded)
    }
}

const EUROCODE_BAR: &str = "EN 1992-1-1:2004, annex C, table C.1 (least k and ε_uk of the class) and 3.2.7 (E, ρ)";

/// f_yk = 500 MPa, annex C of EN 1992-1-1.
const fn b500(name: &'static str, ultimate_strength: f64, ultimate_strain: f64) -> BarGrade {
    BarGrade {
        name,
        young_modulus: 200e9,
        density: 7850.0,
        yield_stress: 500e6,
        ultimate_strength,
        ultimate_strain,
        source: EUROCODE_BAR,
    }
}

/// Reinforcing steels. `B500` is class B.
pub const BARS: &[BarGrade] = &[
    b500("B500", 540e6, 0.050),
    b500("B500A", 525e6, 0.025),
    b500("B500B", 540e6, 0.050),
    b500("B500C", 575e6, 0.075),
    BarGrade {
        name: "BSt500",
        young_modulus: 210e9,
        density: 7850.0,
        yield_stress: 500e6,
        ultimate_strength: 550e6,
        ultimate_strain: 0.10,
        source: "DIN 488-1:1984, BSt 500 S (β_S 500, β_Z 550 N/mm², elongation at fracture A_10 10 %); DIN 1045:1988, 16.2.1 (E). \
                 The 5 ‰ of DIN 1045 are a design limit, not a rupture strain.",
    },
];
