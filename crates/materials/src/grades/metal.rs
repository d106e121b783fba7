//! Steel, aluminium, reinforcing steel.

use crate::LawError;
use crate::bar::{Bar, Rupture};
use crate::von_mises::VonMises;

/// Steel or aluminium of plates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteelGrade {
    /// Name.
    pub name: &'static str,
    /// Young's modulus E [Pa] > 0.
    pub young_modulus: f64,
    /// Poisson's ratio ν, −1 < ν < 0.5.
    pub poisson_ratio: f64,
    /// Density ρ [kg/m³] > 0.
    pub density: f64,
    /// Yield stress f_y, or 0.2 % proof stress f_o of aluminium [Pa] > 0.
    pub yield_stress: f64,
    /// Ultimate tensile strength f_u [Pa] > f_y.
    pub ultimate_strength: f64,
    /// Slope E_T of the bilinear curve beyond f_y [Pa], 0 ≤ E_T < E.
    pub tangent_modulus: f64,
    /// Sources of the numbers.
    pub source: &'static str,
}

impl SteelGrade {
    /// von Mises' law, bilinear.
    ///
    /// * `kinematic`: share of kinematic hardening, from 0 to 1
    ///
    /// Errors: a parameter out of range.
    pub fn law(&self, kinematic: f64) -> Result<VonMises, LawError> {
        VonMises::new(
            self.young_modulus,
            self.poisson_ratio,
            self.yield_stress,
            self.tangent_modulus,
            kinematic,
        )
    }
}

const EUROCODE_STEEL: &str = "EN 1993-1-1:2005 + AC:2009, table 3.1 (EN 10025-2, t ≤ 40 mm: f_y, f_u) and 3.2.6 (E, ν); \
     EN 1993-1-5:2006, C.6 (E_T = E/100); EN 1993-1-2:2005, 3.2.2 (ρ)";

/// Steel after EN 1993-1-1.
const fn eurocode(name: &'static str, yield_stress: f64, ultimate_strength: f64) -> SteelGrade {
    SteelGrade {
        name,
        young_modulus: 210e9,
        poisson_ratio: 0.3,
        density: 7850.0,
        yield_stress,
        ultimate_strength,
        tangent_modulus: 2.1e9,
        source: EUROCODE_STEEL,
    }
}

/// Steels and aluminium alloys of plates.
pub const STEELS: &[SteelGrade] = &[
    eurocode("S235", 235e6, 360e6),
    eurocode("S275", 275e6, 430e6),
    eurocode("S355", 355e6, 490e6),
    SteelGrade {
        name: "A36",
        young_modulus: 200e9,
        poisson_ratio: 0.3,
        density: 7850.0,
        yield_stress: 250e6,
        ultimate_strength: 400e6,
        tangent_modulus: 2.0e9,
        source: "ASTM A36/A36M (250 and 400 MPa, metric edition); ANSI/AISC 360 (E 29 000 ksi = 200 GPa, ν 0.3); E_T = E/100 \
                 as in EN 1993-1-5:2006, C.6",
    },
    SteelGrade {
        name: "EN AW-5083",
        young_modulus: 70e9,
        poisson_ratio: 0.3,
        density: 2700.0,
        yield_stress: 125e6,
        ultimate_strength: 275e6,
        // (f_u − f_o)/(½ ε_u − f_o/E), ε_u = 0.30 − 0.22 f_o/400
        tangent_modulus: 1.318e9,
        source: "EN 1999-1-1:2007, table 3.2a (sheet, temper O/H111, t ≤ 50 mm: f_o, f_u), 3.2.5 (E, ν, ρ), annex E (bilinear \
                 curve to ½ ε_u)",
    },
];

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
