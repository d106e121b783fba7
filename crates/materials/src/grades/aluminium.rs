//! Aluminium of plates.

use super::plate::{PlateKind, SteelGrade, Step, step};

const O_5083: &[Step] = &[step(50.0, 125.0, 275.0)];
const T6_6061: &[Step] = &[step(12.5, 240.0, 290.0)];
const T6_6061_WELDED: &[Step] = &[step(12.5, 115.0, 175.0)];

/// Alloy after EN 1999-1-1.
const fn alloy(
    name: &'static str,
    aliases: &'static [&'static str],
    steps: &'static [Step],
    tangent_modulus: f64,
    source: &'static str,
) -> SteelGrade {
    SteelGrade {
        name,
        kind: PlateKind::Aluminium,
        aliases,
        young_modulus: 70e9,
        poisson_ratio: 0.3,
        density: 2700.0,
        steps,
        tangent_modulus,
        source,
    }
}

// E_T = (f_u − f_o)/(½ ε_u − f_o/E), with ε_u = 0.30 − 0.22 f_o/400 below 400 MPa.

/// The alloys.
pub(super) const GRADES: &[SteelGrade] = &[
    alloy(
        "EN AW-5083",
        &[
            "5083",
            "5083-O",
            "5083-H111",
            "EN AW-5083-O",
            "EN AW-5083-H111",
            "5083-O/H111",
            "EN AW-5083-O/H111",
            "AlMg4.5Mn0.7",
        ],
        O_5083,
        1.318e9,
        "EN 1999-1-1:2007, table 3.2a (sheet, temper O/H111, t ≤ 50 mm: f_o, f_u), 3.2.5 (E, ν, ρ), annex E (bilinear curve to ½ ε_u)",
    ),
    alloy(
        "EN AW-6061-T6",
        &["6061-T6"],
        T6_6061,
        0.621e9,
        "EN 1999-1-1:2007, table 3.2a (sheet, temper T6, t ≤ 12.5 mm: f_o, f_u, unwelded), 3.2.5 (E, ν, ρ), annex E (bilinear curve to ½ \
         ε_u)",
    ),
    alloy(
        "EN AW-6061-T6 welded",
        &["6061-T6 welded", "EN AW-6061-T6 HAZ"],
        T6_6061_WELDED,
        0.514e9,
        "EN 1999-1-1:2007, table 3.2a (temper T6, heat-affected zone: f_o,haz, f_u,haz), 3.2.5 (E, ν, ρ), annex E (bilinear curve to ½ ε_u)",
    ),
];
