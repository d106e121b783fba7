//! Plates of ASTM and CSA: those of API 650 table 5-2, stainless steel and nine per cent nickel.
//!
//! API 650 4.2 limits the thickness and the quality of each; no limit of it is checked here.

use super::plate::{PlateKind, SteelGrade, Step, api, step};

const TABLE: &str = "API 650, 11th edition, table 5-2a (minimum yield and tensile strength, S_d); ANSI/AISC 360 (E 29 000 ksi = 200 GPa, ν 0.3); E_T = \
     E/100 as in EN 1993-1-5:2006, C.6";
const A240: &str = "ASTM A240/A240M (30 or 25 ksi, 75 or 70 ksi, metric edition); ASME BPVC II-D, table TM-1, group G (E); EN \
     1993-1-4:2006, 2.1.3 (ν); EN 10088-1:2005 (ρ); API 650, annex S, up to 40 °C (S_d, the lesser of 0.3 times the tensile and 0.9 times the yield \
     strength: API agenda item 650-621); E_T = E/100 as in EN 1993-1-5:2006, C.6";
/// 27.8·10⁶ psi.
const NICKEL_MODULUS: f64 = 191.7e9;

/// Ferritic steel of API 650 table 5-2.
const fn plate(name: &'static str, aliases: &'static [&'static str], steps: &'static [Step]) -> SteelGrade {
    SteelGrade {
        name,
        kind: PlateKind::CarbonSteel,
        aliases,
        young_modulus: 200e9,
        poisson_ratio: 0.3,
        density: 7850.0,
        steps,
        tangent_modulus: 2.0e9,
        source: TABLE,
    }
}

/// Stainless steel of ASTM A240.
const fn stainless(
    name: &'static str,
    aliases: &'static [&'static str],
    density: f64,
    steps: &'static [Step],
) -> SteelGrade {
    SteelGrade {
        name,
        kind: PlateKind::Stainless,
        aliases,
        young_modulus: 195e9,
        poisson_ratio: 0.3,
        density,
        steps,
        tangent_modulus: 1.95e9,
        source: A240,
    }
}

const ANY: f64 = f64::INFINITY;

const A36: &[Step] = &[api(ANY, 250.0, 400.0, 160.0)];
const A131: &[Step] = &[api(ANY, 235.0, 400.0, 157.0)];
const Y205_U380: &[Step] = &[api(ANY, 205.0, 380.0, 137.0)];
const A516_60: &[Step] = &[api(ANY, 220.0, 415.0, 147.0)];
const Y240_U450: &[Step] = &[api(ANY, 240.0, 450.0, 160.0)];
const A516_70: &[Step] = &[api(ANY, 260.0, 485.0, 173.0)];
const A573_58: &[Step] = &[api(ANY, 220.0, 400.0, 147.0)];
const A573_70: &[Step] = &[api(ANY, 290.0, 485.0, 193.0)];
const A662_B: &[Step] = &[api(ANY, 275.0, 450.0, 180.0)];
const A662_C: &[Step] = &[api(ANY, 295.0, 485.0, 194.0)];
const A537_1: &[Step] = &[api(65.0, 345.0, 485.0, 194.0), api(100.0, 310.0, 450.0, 180.0)];
const A537_2: &[Step] = &[api(65.0, 415.0, 550.0, 220.0), api(100.0, 380.0, 515.0, 206.0)];
const A633: &[Step] = &[api(65.0, 345.0, 485.0, 194.0), api(100.0, 315.0, 450.0, 180.0)];
const Y345_U485: &[Step] = &[api(ANY, 345.0, 485.0, 194.0)];
const Y415_U550: &[Step] = &[api(ANY, 415.0, 550.0, 220.0)];
const W260: &[Step] = &[api(ANY, 260.0, 410.0, 164.0)];
const W350: &[Step] = &[api(ANY, 350.0, 450.0, 180.0)];
const WT350: &[Step] = &[api(65.0, 350.0, 480.0, 192.0), api(100.0, 320.0, 480.0, 192.0)];

const Y205_U515: &[Step] = &[api(ANY, 205.0, 515.0, 155.0)];
const Y170_U485: &[Step] = &[api(ANY, 170.0, 485.0, 145.0)];
const A553: &[Step] = &[step(50.0, 585.0, 690.0)];

/// The grades; a metric designation is an alias.
pub(super) const GRADES: &[SteelGrade] = &[
    SteelGrade {
        source: "ASTM A36/A36M (250 and 400 MPa, metric edition); API 650, 11th edition, table 5-2a (S_d); ANSI/AISC 360 (E 29 000 ksi = 200 GPa, ν \
                 0.3); E_T = E/100 as in EN 1993-1-5:2006, C.6",
        ..plate("A36", &[], A36)
    },
    plate("A131 A", &["A131 B"], A131),
    plate("A283 C", &[], Y205_U380),
    plate("A285 C", &[], Y205_U380),
    plate("A516 55", &["A516 380"], Y205_U380),
    plate("A516 60", &["A516 415"], A516_60),
    plate("A516 65", &["A516 450"], Y240_U450),
    plate("A516 70", &["A516 485"], A516_70),
    plate("A537 1", &[], A537_1),
    plate("A537 2", &[], A537_2),
    plate("A573 58", &["A573 400"], A573_58),
    plate("A573 65", &["A573 450"], Y240_U450),
    plate("A573 70", &["A573 485"], A573_70),
    plate("A633 C", &["A633 D"], A633),
    plate("A662 B", &[], A662_B),
    plate("A662 C", &[], A662_C),
    plate("A678 A", &[], Y345_U485),
    plate("A678 B", &[], Y415_U550),
    plate("A737 B", &[], Y345_U485),
    plate("A841 1", &["A841 A"], Y345_U485),
    plate("A841 2", &["A841 B"], Y415_U550),
    plate("G40.21 260W", &["G40.21 260WT"], W260),
    plate("G40.21 350W", &[], W350),
    plate("G40.21 350WT", &[], WT350),
    SteelGrade {
        name: "A553 I",
        kind: PlateKind::NickelSteel,
        aliases: &["A553 1"],
        young_modulus: NICKEL_MODULUS,
        poisson_ratio: 0.3,
        density: 7850.0,
        steps: A553,
        tangent_modulus: 1.917e9,
        source: "ASTM A553/A553M, type I (585 and 690 MPa; plates up to 50 mm); ASME B31.3, table C-6, nickel steels with 2 to 9 % (E \
                 27.8·10⁶ psi); ν and ρ as those of steel in EN 1993-1-1 and EN 1993-1-2; E_T = E/100 as in EN 1993-1-5:2006, C.6",
    },
    stainless("A240 304", &["304"], 7900.0, Y205_U515),
    stainless("A240 304L", &["304L"], 7900.0, Y170_U485),
    stainless("A240 316", &["316"], 8000.0, Y205_U515),
    stainless("A240 316L", &["316L"], 8000.0, Y170_U485),
];
