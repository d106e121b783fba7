//! Analytical lines of chapters 5 and 8: frequencies of model tank and cylinder, wave of the model tank, Housner's procedure for the slender tank
//! and for strip 8.4.

use std::f64::consts::TAU;

use codes::housner::Housner;
use codes::procedure::Procedure;
use tank::assessment::Excitation;
use tank::case::ConvectiveCoefficient;
use tank::quantity::Quantity;
use tank::reference::{case, material, slender as slender_tank};
use tank::{Case, Shape};

use super::appendix::{line, under, value, with_velocity};
use crate::tanks::G;
use crate::{Answer, Failure, Reference, Row};

/// Water of γ = 10 kN/m³ [kg/m³].
const WATER: f64 = 1e4 / G;

/// Model tank 8.2.
fn model_tank(depth: f64) -> Case {
    let perspex = material(3.3e9, 0.3, 1500.0);
    case(Shape::Cylinder { radius: 0.096 }, &[(0.225, 6e-3)], &perspex, (WATER, depth))
}

/// First sloshing frequency of Housner's procedure [rad/s], with the root of J₁′ in place of 1.84 if `exact`.
fn omega(case: Case, exact: bool) -> Result<f64, Failure> {
    let mut case = under(case, 1.0, 1.0)?;
    if exact {
        case.procedures.housner_convective = ConvectiveCoefficient::Exact;
    }
    let sheet = Housner.assess(&case, Excitation::Site)?;
    Ok(TAU / value(&sheet, Quantity::SloshingPeriod))
}

/// Table 8.8 and 5.3.3.1.
///
/// Errors: a failure of the procedure.
pub(super) fn frequencies() -> Answer {
    let mut rows = Vec::new();
    let by_hand = ("√(λ g/R tanh(λ h/R))/2π, λ = 1.8412, by hand", Reference::ClosedForm);
    let print = ("dissertation, table 8.8", Reference::Dissertation);
    let slip = "a slip: the other depths fit the formula to half a digit";
    let deep = "the table takes the whole depth, the procedure the 1.5 R that can slosh";
    // The text has 1.84, the table the root of J₁′: half of the last digit.
    for (depth, printed, reference, (source, kind), reason) in [
        (0.03, 1.573, 1.573, print, None),
        (0.06, 1.974, 1.974, print, None),
        (0.09, 2.117, 2.115, by_hand, Some(slip)),
        (0.12, 2.161, 2.161, print, None),
        (0.15, 2.176, 2.1744, by_hand, Some(deep)),
    ] {
        let found = omega(model_tank(depth), true)? / TAU;
        let what = format!("model tank, H = {depth} m, first frequency by Housner");
        let row = Row::new("table-8.8", what, (reference, source, kind), found, (5.5e-4 / reference, "Hz"));
        rows.push(match reason {
            Some(reason) => row.printed(printed, reason),
            None => row,
        });
    }
    // R = H = 5 m is read off figure 5.20; with g = 9.81 m/s² it is 1.853, with γ/ρ = 10 m/s² 1.8705.
    let mut cylinder =
        case(Shape::Cylinder { radius: 5.0 }, &[(5.0, 1e-2)], &material(210e9, 0.3, 7850.0), (1000.0, 5.0));
    cylinder.gravity = 10.0;
    let printed = (1.87, "dissertation 5.3.3.1, (5.67)", Reference::Dissertation);
    let what = "cylinder of figure 5.20, R = H = 5 m, γ/ρ = 10 m/s²: ω₁ by Housner";
    rows.push(Row::new("5.3.3.1", what, printed, omega(cylinder, false)?, (2.7e-3, "rad/s")));
    Ok(rows)
}

/// Table 8.9: 6.2 mm follow if the ground's amplitude is the spectral displacement, S_a = ω² 5 mm: a reading, picked because it fits.
///
/// Errors: a failure of the procedure.
pub(super) fn harmonic_wave() -> Answer {
    let tank = model_tank(0.09);
    let omega = omega(tank.clone(), false)?;
    let sheet = Housner.assess(&under(tank, 1.0, omega * omega * 5e-3)?, Excitation::Site)?;
    let row = |what, printed, found, tolerance, unit| {
        Row::new(
            "table-8.9",
            what,
            (printed, "dissertation, table 8.9", Reference::Dissertation),
            found,
            (tolerance, unit),
        )
    };
    Ok(vec![
        row("model tank, H = 0.09 m: first frequency by Housner", 2.12, omega / TAU, 2.8e-3, "Hz"),
        row(
            "model tank, 5 mm as spectral displacement: wave by Housner",
            6.2e-3,
            value(&sheet, Quantity::SloshingHeight),
            8e-3,
            "m",
        ),
    ])
}

/// Table 8.10, analytical: S_v = 0.81 m/s, 0.5 g.
///
/// Errors: a failure of the procedure.
#[expect(clippy::approx_constant, reason = "3.14 rad/s is a frequency")]
pub(super) fn slender() -> Answer {
    let mut rows = Vec::new();
    let printed = |what: String, (reference, computed): (f64, f64), tolerance, unit| {
        Row::new(
            "table-8.10",
            what,
            (reference, "dissertation, table 8.10", Reference::Dissertation),
            computed,
            (tolerance, unit),
        )
    };
    let density = "computed with 1 t/m³; figure 8.7 has γ = 10 kN/m³";
    let slip =
        "the moment is quadratic in H, and this stress is not on the parabola of 3.0, 3.5 and 4.5 m; density as there";
    // The third is the stress on that parabola. W has three digits, 0.3 % off, and so have the stresses.
    for (depth, omega, stress, on_parabola) in [
        (3.0, 3.13, 7.70, 7.70),
        (3.5, 3.14, 11.05, 11.05),
        (4.0, 3.14, 14.95, 15.023),
        (4.5, 3.14, 19.62, 19.62),
        (5.0, 3.14, 24.45, 24.84),
    ] {
        let sheet = with_velocity(&slender_tank(WATER, depth), 0.5 * G, 0.81)?;
        let what = |quantity: &str| format!("slender tank, H = {depth} m: {quantity}");
        // The procedure takes the depth that can slosh, 1.5 R, in place of H: 0.4 %, and half a digit.
        rows.push(printed(what("ω₁"), (omega, line(&sheet, "ω")), 5.6e-3, "rad/s"));
        // Cut: 0.487 m.
        rows.push(printed(what("wave"), (0.48, value(&sheet, Quantity::SloshingHeight)), 2.1e-2, "m"));
        let reference = 1e6 * on_parabola * WATER / 1000.0;
        let found = value(&sheet, Quantity::AxialMembraneStress);
        let row = printed(what("axial membrane stress"), (reference, found), 1e-2, "Pa");
        rows.push(row.printed(1e6 * stress, if stress == on_parabola { density } else { slip }));
    }
    Ok(rows)
}

/// Table 8.11: S_v = 0.787 m/s, 0.348 g.
///
/// Errors: a failure of the procedure.
pub(super) fn strip() -> Answer {
    let shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    let case = case(shape, &[(3.0, 0.3)], &material(34e9, 0.2, 2540.0), (13_100.0 / (5.0 * 2.57), 2.57));
    let sheet = with_velocity(&case, 0.348 * G, 0.787)?;
    let row = |what, printed, found, tolerance, unit| {
        Row::new(
            "table-8.11",
            what,
            (printed, "dissertation, table 8.11", Reference::Dissertation),
            found,
            (tolerance, unit),
        )
    };
    let moment = row("strip 8.4: moment above the base", 41.55e3, value(&sheet, Quantity::BaseMoment), 1.3e-4, "N m");
    let by_hand = "Housner's formulas with 13.1 t in an independent script, to four digits";
    Ok(vec![
        row("strip 8.4: ω₁", 2.4, line(&sheet, "ω"), 2.1e-2, "rad/s"),
        // Cut: 0.556 m.
        row("strip 8.4: wave", 0.55, value(&sheet, Quantity::SloshingHeight), 1.8e-2, "m"),
        Row { source: by_hand, kind: Reference::SecondFormulation, ..moment }
            .printed(39.94e3, "4 % less, 2 % with 1 t/m³; no single change of a constant gives it: open"),
    ])
}
