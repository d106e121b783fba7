//! Plates of European standards: EN 10025-2, EN 10028-2, -3 and -7, and the groups of EN 1993-1-1.
//!
//! `S355` is the steel of EN 1993-1-1 table 3.1, whose strengths change at 40 mm only; `S355JR` that of the product standard, which has
//! more steps. EN 1993-1-1 3.2.1 allows either.

use super::plate::{PlateKind, SteelGrade, Step, step};

const EUROCODE: &str = "EN 1993-1-1:2005 + AC:2009, table 3.1 (EN 10025-2: f_y, f_u) and 3.2.6 (E, ν); EN 1993-1-5:2006, C.6 (E_T = \
     E/100); EN 1993-1-2:2005, 3.2.2 (ρ)";
const STRUCTURAL: &str = "EN 10025-2:2004, table 7 (minimum R_eH and R_m of flat products); EN 1993-1-1:2005, 3.2.6 (E, ν); EN \
     1993-1-5:2006, C.6 (E_T = E/100); EN 1993-1-2:2005, 3.2.2 (ρ)";
const PRESSURE: &str = "EN 10028-2:2009 (minimum R_eH and R_m, plates up to 60 mm); EN 1993-1-1:2005, 3.2.6 (E, ν); EN \
     1993-1-5:2006, C.6 (E_T = E/100); EN 1993-1-2:2005, 3.2.2 (ρ)";
const FINE_GRAIN: &str = "EN 10028-3:2009 (minimum R_eH and R_m, plates up to 60 mm); EN 1993-1-1:2005, 3.2.6 (E, ν); EN \
     1993-1-5:2006, C.6 (E_T = E/100); EN 1993-1-2:2005, 3.2.2 (ρ)";
const STAINLESS: &str = "EN 10028-7:2007 and EN 1993-1-4:2006, table 2.1 (hot rolled plate, t ≤ 75 mm: R_p0.2, R_m) and 2.1.3 (E, ν); EN \
     10088-1:2005 (ρ); EN 1993-1-5:2006, C.6 (E_T = E/100)";

/// Ferritic steel.
const fn steel(
    name: &'static str,
    aliases: &'static [&'static str],
    steps: &'static [Step],
    source: &'static str,
) -> SteelGrade {
    SteelGrade {
        name,
        kind: PlateKind::CarbonSteel,
        aliases,
        young_modulus: 210e9,
        poisson_ratio: 0.3,
        density: 7850.0,
        steps,
        tangent_modulus: 2.1e9,
        source,
    }
}

/// Stainless steel.
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
        young_modulus: 200e9,
        poisson_ratio: 0.3,
        density,
        steps,
        tangent_modulus: 2.0e9,
        source: STAINLESS,
    }
}

const EC_235: &[Step] = &[step(40.0, 235.0, 360.0), step(80.0, 215.0, 360.0)];
const EC_275: &[Step] = &[step(40.0, 275.0, 430.0), step(80.0, 255.0, 410.0)];
const EC_355: &[Step] = &[step(40.0, 355.0, 490.0), step(80.0, 335.0, 470.0)];

const S235: &[Step] = &[
    step(16.0, 235.0, 360.0),
    step(40.0, 225.0, 360.0),
    step(100.0, 215.0, 360.0),
    step(150.0, 195.0, 350.0),
    step(200.0, 185.0, 340.0),
    step(250.0, 175.0, 340.0),
];
const S275: &[Step] = &[
    step(16.0, 275.0, 410.0),
    step(40.0, 265.0, 410.0),
    step(63.0, 255.0, 410.0),
    step(80.0, 245.0, 410.0),
    step(100.0, 235.0, 410.0),
    step(150.0, 225.0, 400.0),
    step(200.0, 215.0, 380.0),
    step(250.0, 205.0, 380.0),
];
const S355: &[Step] = &[
    step(16.0, 355.0, 470.0),
    step(40.0, 345.0, 470.0),
    step(63.0, 335.0, 470.0),
    step(80.0, 325.0, 470.0),
    step(100.0, 315.0, 470.0),
    step(150.0, 295.0, 450.0),
    step(200.0, 285.0, 450.0),
    step(250.0, 275.0, 450.0),
];

// Steps that could be confirmed by a second source.
const P235: &[Step] = &[step(16.0, 235.0, 360.0)];
const P265: &[Step] = &[step(16.0, 265.0, 410.0), step(40.0, 255.0, 410.0), step(60.0, 245.0, 410.0)];
const P295: &[Step] = &[step(16.0, 295.0, 460.0), step(40.0, 290.0, 460.0), step(60.0, 285.0, 460.0)];
const P355: &[Step] = &[step(16.0, 355.0, 490.0), step(40.0, 345.0, 490.0), step(60.0, 335.0, 490.0)];
const P460: &[Step] = &[step(16.0, 460.0, 570.0), step(40.0, 445.0, 570.0), step(60.0, 430.0, 570.0)];

const X200: &[Step] = &[step(75.0, 200.0, 500.0)];
const X210: &[Step] = &[step(75.0, 210.0, 520.0)];
const X220: &[Step] = &[step(75.0, 220.0, 520.0)];
const X460: &[Step] = &[step(75.0, 460.0, 640.0)];

/// The grades.
pub(super) const GRADES: &[SteelGrade] = &[
    steel("S235", &[], EC_235, EUROCODE),
    steel("S275", &[], EC_275, EUROCODE),
    steel("S355", &[], EC_355, EUROCODE),
    steel(
        "S235JR",
        &["S235J0", "S235JO", "S235J2", "S235JR+N", "S235J2+N", "1.0038", "1.0114", "1.0117"],
        S235,
        STRUCTURAL,
    ),
    steel(
        "S275JR",
        &["S275J0", "S275JO", "S275J2", "S275JR+N", "S275J2+N", "1.0044", "1.0143", "1.0145"],
        S275,
        STRUCTURAL,
    ),
    steel(
        "S355JR",
        &["S355J0", "S355JO", "S355J2", "S355K2", "S355J2+N", "S355K2+N", "1.0045", "1.0553", "1.0577", "1.0596"],
        S355,
        STRUCTURAL,
    ),
    steel("P235GH", &["1.0345"], P235, PRESSURE),
    steel("P265GH", &["1.0425"], P265, PRESSURE),
    steel("P295GH", &["1.0481"], P295, PRESSURE),
    steel("P355N", &["P355NH", "P355NL1", "P355NL2", "1.0562", "1.0565", "1.0566", "1.1106"], P355, FINE_GRAIN),
    steel("P460NH", &["P460NL1", "P460NL2", "1.8935", "1.8915", "1.8918"], P460, FINE_GRAIN),
    stainless("1.4301", &["X5CrNi18-10"], 7900.0, X210),
    stainless("1.4307", &["X2CrNi18-9"], 7900.0, X200),
    stainless("1.4541", &["X6CrNiTi18-10"], 7900.0, X200),
    stainless("1.4401", &["X5CrNiMo17-12-2"], 8000.0, X220),
    stainless("1.4404", &["X2CrNiMo17-12-2"], 8000.0, X220),
    stainless("1.4571", &["X6CrNiMoTi17-12-2"], 8000.0, X220),
    stainless("1.4462", &["X2CrNiMoN22-5-3"], 7800.0, X460),
];
