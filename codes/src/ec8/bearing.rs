//! Bearing of the ground: largest pressure under a rigid base without tension against a given resistance.
//!
//! ```text
//! circle, e ≤ R/4        σ = N/(π R²) (1 + 4 e/R)
//! circle, e > R/4        segment y ≥ R cos α, σ(y) = σ (y/R − cos α)/(1 − cos α):
//!                        N/(σ R²)    = [⅔ sin³α − cos α (α − sin α cos α)]/(1 − cos α)
//!                        M/(σ R³)    = [α/4 − sin 4α/16 − ⅔ cos α sin³α]/(1 − cos α)        e/R = ratio of both
//! rectangle, e ≤ B/6     σ = N/(B b) (1 + 6 e/B)             e > B/6        σ = 2 N/(3 b (B/2 − e))
//! ```
//!
//! N is the weight of liquid, wall and roof, with the vertical motion up or down; e = M′/N with the moment below the base plate. Base is
//! the plan of the tank: a foundation that spreads the load, and its weight, are left out. Anchors hold a tank to its foundation, so that one
//! whose resultant leaves its plan has not failed: it is not checked. The resistance is a given design value
//! (EN 1998-5 annex F, EN 1997-1).
//!
//! A wall that lifts, and any wall on a ring wall, presses with its toe, beside that of the rigid base (module `toe`). A slab spreads it, so that force and
//! moment of the whole decide.
//!
//! Source: EN 1998-5:2004 5.4.1.1, recalled; formulas derived here (no tension, plane distribution).

mod toe;

use std::f64::consts::PI;

use self::toe::Toe;

use super::limit_states::BEARING;
use super::work::Work;
use crate::base_state::BaseState;
use crate::sheet::{Sheet, number};
use tank::assessment::CheckStatus;
use tank::quantity::Quantity;
use tank::units::Dimension::*;
use tank::{Shape, Support};

const CLAUSE: &str = "EN 1998-5:2004 5.4.1.1";
/// Why the ground under an anchored tank is not compared where the resultant leaves its plan.
pub(crate) const ON_ANCHORS: &str =
    "the resultant leaves the plan of the tank, which is held to a foundation whose plan and weight are not an input";
/// The same where it leaves the kern of the plan alone, and the pressure beyond it exceeds the resistance.
pub(crate) const BEYOND_KERN: &str = "the resultant leaves the kern of the plan of the tank, which is held to a foundation whose plan and weight are not an input";
/// Why a rigid base does not speak of a tank whose wall lifts.
pub(crate) const LIFTS: &str =
    "the wall lifts and its toe presses on a narrow ring, where the pressure exceeds that under a rigid base";
/// Path of the resistance.
pub(crate) const RESISTANCE: &str = "site.ec8.bearing_capacity";

/// Eccentricity e/R and force N/(σ R²) of a segment in contact with the half angle 0 < α ≤ π.
fn segment(alpha: f64) -> (f64, f64) {
    let (s, c) = alpha.sin_cos();
    let cube = 2.0 / 3.0 * s.powi(3);
    let force = cube - c * (alpha - s * c);
    let moment = 0.25 * alpha - (4.0 * alpha).sin() / 16.0 - c * cube;
    (moment / force, force / (1.0 - c))
}

/// σ R²/N of a circle with the eccentricity e/R from 1/4 to below 1; infinite beyond.
///
/// Error: 1e-6 from e/R = 0.999 down.
pub fn circle(eccentricity: f64) -> f64 {
    if eccentricity.is_nan() || eccentricity >= 0.999 {
        return f64::INFINITY;
    }
    let (mut low, mut high) = (0.0, PI);
    for _ in 0..80 {
        let alpha = 0.5 * (low + high);
        // A smaller segment has its resultant farther out.
        if segment(alpha).0 > eccentricity {
            low = alpha;
        } else {
            high = alpha;
        }
    }
    1.0 / segment(0.5 * (low + high)).1
}

/// Pressure of a base of half length `half` and area `area` under N and e, times area/N; infinite where N leaves the base.
fn factor(shape: Shape, eccentricity: f64) -> f64 {
    match shape {
        Shape::Cylinder { .. } if eccentricity <= 0.25 => 1.0 + 4.0 * eccentricity,
        Shape::Cylinder { .. } => PI * circle(eccentricity),
        // e/L with B = 2 L: 6 e/B = 3 e/L; 2 N/(3 b L (1 − e/L)) times 2 L b/N.
        Shape::Rectangle { .. } if eccentricity <= 1.0 / 3.0 => 1.0 + 3.0 * eccentricity,
        Shape::Rectangle { .. } if eccentricity < 1.0 => 4.0 / (3.0 * (1.0 - eccentricity)),
        Shape::Rectangle { .. } => f64::INFINITY,
    }
}

/// Largest pressure [Pa] under a rigid base without tension; infinite where the resultant leaves it.
///
/// * `normal`: force on the base [N]
/// * `moment`: moment below the base plate, ≥ 0 [N·m]
pub(crate) fn largest_pressure(shape: Shape, normal: f64, moment: f64) -> f64 {
    match normal > 0.0 {
        true => normal / shape.plan_area() * factor(shape, moment / normal / shape.half_length()),
        false => f64::INFINITY,
    }
}

/// Whether the resultant leaves the kern, outside of which a part of the base has no contact.
pub(crate) fn leaves_kern(shape: Shape, normal: f64, moment: f64) -> bool {
    let kern = match shape {
        Shape::Cylinder { .. } => 0.25,
        Shape::Rectangle { .. } => 1.0 / 3.0,
    };
    normal <= 0.0 || moment / normal / shape.half_length() > kern
}

/// What a base without tension makes of force and moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Bears {
    /// Largest pressure [Pa].
    Pressure(f64),
    /// The resultant leaves the base.
    Leaves {
        /// Largest moment that a base without tension carries [N·m].
        limit: f64,
    },
}

/// Lines of eccentricity and pressure under a normal force N_b [N], below the line that gives it.
///
/// * `formula`: of the eccentricity
pub(crate) fn base_lines(sheet: &mut Sheet, shape: Shape, normal: f64, formula: &str) -> Bears {
    let half = match shape {
        Shape::Cylinder { radius } => ("R", radius, Length),
        Shape::Rectangle { length, .. } => ("L", 0.5 * length, Length),
    };
    sheet.given(&[half]);
    if let Shape::Rectangle { breadth, .. } = shape {
        sheet.given(&[("b", breadth, Length)]);
    }
    let eccentricity = match normal > 0.0 {
        true => sheet.calc("e", "eccentricity", formula, Length, CLAUSE),
        false => f64::INFINITY,
    };
    let ratio = eccentricity / half.1;
    if !factor(shape, ratio).is_finite() {
        // No pressure carries a resultant outside the base.
        let limit = normal.max(0.0) * half.1;
        return Bears::Leaves { limit };
    }
    let formula = match shape {
        Shape::Cylinder { .. } if ratio <= 0.25 => "N_b/(π·R²)·(1 + 4·e/R)",
        Shape::Cylinder { .. } => {
            let (name, source) =
                ("pressure σ R²/N of the segment in contact", "plane pressure without tension, solved for e/R");
            let value = circle(ratio);
            sheet.look_up("κ_b", name, source, value, Dimensionless, "statics");
            "κ_b·N_b/R²"
        }
        Shape::Rectangle { .. } if ratio <= 1.0 / 3.0 => "N_b/(2·L·b)·(1 + 3·e/L)",
        Shape::Rectangle { .. } => "2·N_b/(3·b·(L - e))",
    };
    Bears::Pressure(sheet.calc("σ_b,max", "largest pressure", formula, Stress, CLAUSE))
}

/// One combination of horizontal and vertical motion, vertical positive downwards.
type Factors = (f64, f64);

/// Writes the check, or that the resistance is missing. Needs the moment below the base plate.
///
/// * `at_toe`: largest pressure of the liquid at the foot of the wall [Pa], of a tank that may lift
pub(super) fn assess(work: &mut Work, at_toe: f64) {
    let Some(moment) = work.out.values.get(&Quantity::OverturningMoment).copied() else { return };
    let Some(resistance) = work.demand.site.and_then(|site| site.bearing_capacity) else {
        work.missing(BEARING.id, RESISTANCE);
        return;
    };
    let case = work.case;
    let mass = work.mass + case.tank.wall_mass() + case.tank.roof.mass;
    let force = |(_, v): Factors| mass * (case.gravity + v * work.demand.vertical_ground());
    let pressure = |f: Factors| largest_pressure(case.tank.shape, force(f), f.0 * moment);
    let combinations: &[Factors] = match work.demand.vertical {
        true => &[(1.0, 0.3), (1.0, -0.3), (0.3, 1.0), (0.3, -1.0)],
        false => &[(1.0, 0.0)],
    };
    let worst = combinations.iter().copied().max_by(|a, b| pressure(*a).total_cmp(&pressure(*b)));
    if let Some(factors) = worst {
        lines(work, factors, mass, (moment, resistance, at_toe));
    }
}

/// Lines of the governing combination, and the check.
fn lines(work: &mut Work, (x, v): Factors, mass: f64, (moment, resistance, at_toe): (f64, f64, f64)) {
    let case = work.case;
    let shape = case.tank.shape;
    let sheet = &mut work.sheet;
    sheet.given(&[
        ("A_v", work.demand.vertical_ground(), Acceleration),
        ("E_x", x, Dimensionless),
        ("E_z", v, Dimensionless),
    ]);
    sheet.section("Bearing of the ground");
    sheet.input("m_t", "mass of liquid, wall and roof", mass, Mass, "definition");
    sheet.input("R_d", "design bearing resistance", resistance, Stress, RESISTANCE);
    let (name, formula) = match work.demand.vertical {
        true => ("weight with the vertical motion", "m_t·(g + E_z·A_v)"),
        false => ("weight", "m_t·g"),
    };
    let normal = sheet.calc("N_b", name, formula, Force, CLAUSE);
    let name = "Pressure under a rigid base";
    let note = match work.demand.vertical {
        true => format!(
            "rigid base without tension; floor slab and foundation are left out and add their weight; {} E_x, {} E_z (downwards positive)",
            number(x),
            number(v)
        ),
        false => "rigid base without tension; floor slab and foundation are left out and add their weight".to_string(),
    };
    let anchored = case.tank.support == Support::Anchored;
    let sheet = &mut work.sheet;
    let bears = base_lines(sheet, shape, normal, "E_x·M′/N_b");
    match (bears, work.base.clone()) {
        (Bears::Pressure(pressure), BaseState::Unknown(reason)) if pressure <= resistance => {
            work.without_comparison(BEARING.id, CheckStatus::NotChecked, &reason, None);
        }
        (Bears::Pressure(pressure), BaseState::Lifts(lift)) if pressure <= resistance => {
            let toe = Toe { force: lift.toe, pressure: at_toe, lifts: true };
            if toe::assess(work, toe, resistance) {
                work.check(BEARING.named(name), pressure, resistance, CLAUSE, &note);
            }
        }
        (Bears::Pressure(pressure), BaseState::Bears) if pressure <= resistance && toe::on_a_ring(case) => {
            if toe::of_a_rim(work, at_toe, resistance) {
                work.check(BEARING.named(name), pressure, resistance, CLAUSE, &note);
            }
        }
        (Bears::Pressure(pressure), _)
            if pressure > resistance && anchored && leaves_kern(shape, normal, x * moment) =>
        {
            work.without_comparison(BEARING.id, CheckStatus::NotChecked, BEYOND_KERN, None);
        }
        (Bears::Pressure(pressure), _) => work.check(BEARING.named(name), pressure, resistance, CLAUSE, &note),
        (Bears::Leaves { .. }, _) if anchored => {
            work.without_comparison(BEARING.id, CheckStatus::NotChecked, ON_ANCHORS, None);
        }
        (Bears::Leaves { limit }, _) => {
            let note = format!("the resultant leaves the base; {note}");
            let name = "Moment that a base without tension carries";
            work.check(BEARING.named(name).measured(Moment), x * moment, limit, CLAUSE, &note);
        }
    }
}

#[cfg(test)]
mod tests;
