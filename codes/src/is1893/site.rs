//! Accelerations of IS 1893-2 from zone, soil, importance and response reduction.

use tank::case::Case;
use tank::factor::Factor;
use tank::ingredients::Ordinate;
use tank::national::{Is1893Site, Soil, Zone};
use tank::units::Dimension::Dimensionless;
use tank::{STANDARD_GRAVITY, StagingKind, Support, WallBase};

use super::{CLAUSES, staging};
use crate::procedure::{CodeError, DesignCurve};
use crate::sheet::Sheet;
use crate::two_mass::{Action, Periods, Work};

const ZONE: &str = "IS 1893-1 table 3";
const SPECTRUM: &str = "IS 1893-1 6.4.2";
const IMPORTANCE: &str = "IS 1893-2:2014 table 1";
const TABLE: &str = "IS 1893-2:2014 table 2";
const OF_FRAMES: &str = "IS 1893-2:2014 table 2, one source";
const REDUCTION: &str = "IS 1893-2:2014 table 2, recalled";
const DAMPING: &str = "IITK-GSDMA 2007 4.4, 4.5.4";
const VERTICAL: &str = "IITK-GSDMA 2007 4.10, one source";
/// Period beyond which S_a/g keeps its value [s].
const LAST: f64 = 4.0;
/// Factor from 5 % to the 0.5 % of sloshing.
const SLOSHING: f64 = 1.75;

/// Zone factor Z.
fn zone_factor(zone: Zone) -> f64 {
    match zone {
        Zone::II => 0.10,
        Zone::III => 0.16,
        Zone::IV => 0.24,
        Zone::V => 0.36,
    }
}

/// Falling branch of S_a/g times the period [s], and its last value.
fn branches(soil: Soil) -> (f64, f64) {
    match soil {
        Soil::Hard => (1.0, 0.25),
        Soil::Medium => (1.36, 0.34),
        Soil::Soft => (1.67, 0.42),
    }
}

/// S_a/g at 5 % of a period of this symbol, as a formula.
fn ordinate(soil: Soil, symbol: &str, period: f64) -> String {
    let (falling, last) = branches(soil);
    if period > LAST { last.to_string() } else { format!("min(2.5, {falling}/{symbol})") }
}

/// Line of S_a/g at a period of this symbol.
fn spectrum(sheet: &mut Sheet, symbol: &str, soil: Soil, (at, period): (&str, f64)) {
    let beyond = if period > LAST { ", the last value beyond 4 s" } else { "" };
    let name = format!("S_a/g at {at}, 5 % damping{beyond}");
    sheet.calc(symbol, &name, &ordinate(soil, at, period), Dimensionless, SPECTRUM);
}

/// Response reduction R: the user's, or that of the kind of base or staging.
///
/// Errors: a flexible base of concrete, of which two recollections differ; a shaft, of which the code has a range.
fn reduction(site: &Is1893Site, case: &Case) -> Result<(f64, &'static str), CodeError> {
    if let Some(given) = site.response_reduction {
        return Ok((given, "site.is1893.response_reduction"));
    }
    let missing = |known: &str| CodeError::Data {
        clause: TABLE.into(),
        reason: format!("`site.is1893.response_reduction` is missing: {known}"),
    };
    if let Some(staging) = case.tank.staging {
        return match staging.kind {
            StagingKind::DuctileRcFrame => Ok((2.5, TABLE)),
            StagingKind::RcFrame => Ok((1.8, OF_FRAMES)),
            StagingKind::SteelFrame => Ok((2.5, REDUCTION)),
            StagingKind::RcShaft => {
                Err(missing("for shafts a public table has 1.5 to 1.8, and this program knows 1.3 to 1.8 from memory"))
            }
        };
    }
    let anchored = case.tank.support == Support::Anchored;
    let flexible = matches!(case.tank.wall_base, WallBase::Sliding { .. });
    match (case.tank.is_metal(), anchored) {
        (true, true) => Ok((2.5, REDUCTION)),
        (true, false) => Ok((2.0, REDUCTION)),
        (false, true) if flexible => Err(missing(
            "this program knows 2.5 and 3.5 from memory for an anchored flexible base of concrete, and neither is confirmed",
        )),
        (false, true) => Ok((2.0, REDUCTION)),
        (false, false) => Ok((1.5, REDUCTION)),
    }
}

/// Z/2 k S_a over the period at 5 and 0.5 % damping, without importance and reduction.
pub(super) fn curves(site: &Is1893Site) -> Vec<DesignCurve> {
    let level = 0.5 * zone_factor(site.zone) * STANDARD_GRAVITY;
    let (falling, last) = branches(site.soil);
    let shape = move |t: f64| if t > LAST { last } else { f64::min(2.5, falling / t) };
    [("0.05", "5", 0.05, 1.0), ("0.005", "0.5", 0.005, SLOSHING)]
        .map(|(id, percent, damping, factor)| DesignCurve {
            id: format!("is1893-{id}"),
            title: format!("IS 1893 Z/2 S_a, ξ = {percent} %"),
            damping,
            longest: f64::INFINITY,
            acceleration: Box::new(move |t| level * factor * shape(t)),
        })
        .into()
}

/// Lines of the acceleration of the empty tank, below those of [`action`].
///
/// Errors: no site data.
pub(super) fn empty(sheet: &mut Sheet, case: &Case, period: f64) -> Result<(), CodeError> {
    let Some(site) = case.site.is1893 else { return Err(missing_site()) };
    spectrum(sheet, "S_e", site.soil, ("T_e", period));
    let name = "acceleration of the empty tank [g]";
    sheet.calc("A_e", name, "Z/2·I/R·k_i·S_e", Dimensionless, CLAUSES.action);
    Ok(())
}

fn missing_site() -> CodeError {
    CodeError::Data { clause: CLAUSES.action.into(), reason: "`site.is1893` is not given".into() }
}

/// Lines of the accelerations.
pub(super) fn action(work: &mut Work, periods: &Periods) -> Result<Action, CodeError> {
    // `applies` has asked before.
    let (Some(site), Some(impulsive)) = (work.case.site.is1893, periods.impulsive) else {
        return Err(missing_site());
    };
    let (r, source) = reduction(&site, work.case)?;
    let (structure, of_structure) = match staging::is_steel(work.case) {
        true => (1.40, "factor from 5 % to the 2 % damping of steel"),
        false => (1.0, "factor of the 5 % damping of concrete"),
    };
    let sheet = &mut work.sheet;
    for (symbol, name, value, clause) in [
        ("Z", "zone factor", zone_factor(site.zone), ZONE),
        ("I", "importance factor", site.importance, IMPORTANCE),
        ("R", "response reduction", r, source),
        ("k_i", of_structure, structure, DAMPING),
        ("k_c", "factor from 5 % to the 0.5 % damping of sloshing", SLOSHING, DAMPING),
    ] {
        sheet.input(symbol, name, value, Dimensionless, clause);
    }
    for (symbol, at, period) in [("S_i", "T_i", impulsive.period), ("S_c", "T_c", periods.convective)] {
        spectrum(sheet, symbol, site.soil, (at, period));
    }
    let clause = CLAUSES.action;
    let a_i = sheet.calc("A_i", "impulsive acceleration [g]", "Z/2·I/R·k_i·S_i", Dimensionless, clause);
    let a_c = sheet.calc("A_c", "convective acceleration [g]", "Z/2·I/R·k_c·S_c", Dimensionless, clause);
    let name = "acceleration of the sloshing wave, not reduced [g]";
    let a_w = sheet.calc("A_w", name, "A_c·R", Dimensionless, CLAUSES.wave);
    let a_v = sheet.calc("A_v", "vertical acceleration [g]", "2/3·Z/2·I/R·2.5", Dimensionless, VERTICAL);

    let g = work.case.gravity;
    let importance = (Factor::Importance, site.importance);
    let reduced = (Factor::BehaviourFactor, 1.0 / r);
    let of = |period: f64, value: f64, factors: &[(Factor, f64)]| Ordinate::at(period, 0.05, value * g).split(factors);
    let damped = (Factor::DampingCorrection, SLOSHING);
    Ok(Action {
        impulsive: of(impulsive.period, a_i, &[(Factor::DampingCorrection, structure), importance, reduced]),
        convective: of(periods.convective, a_c, &[damped, importance, reduced]),
        wave: of(periods.convective, a_w, &[damped, importance]),
        vertical: a_v * g,
    })
}
