//! Uplift of the bottom plate of an unanchored wall: height, length, rotation of the joint and membrane stress of the plate.
//!
//! ```text
//! w, L        largest uplift of the rim under M and lifted length, own calculation ([`lifted`]) in place of the diagrams of A.9
//! θ = 2w/L − w/(2R) ≤ 0.20 rad        μ = (2R − L)/(2R)
//! σ_rb = (1/s_b) [(2/3) E s_b p² R² (1 − μ)²/(1 − ν²)]^(1/3) ≤ f_y
//! ```
//!
//! Each on the ground of the file and on ground three times softer and stiffer. A given stiffness decides, the others are for information;
//! of assumed ones the least favourable decides. The diagrams are for rigid ground and tanks with roofs. θ is what the clause compares with
//! 0.20 rad, the slope of a parabola: the plastic rotation of the strip, about two thirds of it, stands beside it for information. The
//! printed σ_rb has (1 − ν²) in the numerator, 6 % less than the membrane in plane strain that it stands for; the larger value is taken.
//! As the membrane of the formula is fixed at the rim, σ_rb is an upper bound.
//!
//! Source: EN 1998-4:2006 A.9, formulas recalled; strips of [`base`].

use ::base::{Base, Stand};

use super::cylinder_stress::State;
use super::limit_states::{UPLIFT, UPLIFT_EQUILIBRIUM, UPLIFT_MEMBRANE, UPLIFT_ROTATION, UPLIFT_WIDTH};
use super::work::{Work, missing_input};
use crate::base_state::{Lift, leave_open};
use crate::lifted::{self, Ground};
use crate::sheet::with_unit;
use tank::Bottom;
use tank::assessment::CheckStatus;
use tank::units::Dimension::*;

/// Largest plastic rotation of the joint of wall and bottom [rad], EN 1998-4:2006 A.9.
pub const ROTATION: f64 = 0.20;
/// Writes lines and checks; returns the largest uplift and compression at the toe, or why they are not known.
///
/// * `weight`: of wall and roof, less overpressure and vertical motion [N/m]
pub(super) fn assess(work: &mut Work, state: &State, weight: f64) -> Result<Lift, String> {
    let missing = |work: &mut Work, input: &str| {
        work.missing(UPLIFT.id, input);
        Err(missing_input(input))
    };
    let Some(bottom) = &state.tank.bottom else { return missing(work, "tank.bottom") };
    let Some(f_y) = bottom.material.yield_strength else {
        return missing(work, &format!("materials.{}.yield_strength", bottom.material.name));
    };
    work.sheet.section("Uplift of the bottom plate (own calculation in place of the diagrams of A.9)");
    let Some(grounds) = lifted::grounds(work.case) else {
        let reason = "the uplift is computed for bottom plates of metal";
        work.without_comparison(UPLIFT.id, CheckStatus::NotChecked, reason, Some("tank.bottom"));
        return Err(reason.into());
    };
    work.out.notes.extend(grounds.first().map(|ground| ground.base.foot().into()));
    let mut rims = Vec::new();
    for ground in &grounds {
        if let Some(stand) = lifted::under(&ground.base, state.base_moment, weight) {
            rims.push(ground_lines(work, ground, &stand));
        } else if ground.decides {
            no_equilibrium(work, state, &ground.base, weight);
            return Err("the lifted rim has no equilibrium".into());
        } else {
            work.out.notes.push(format!(
                "{}: for information, ground of {} does not hold the moment.",
                work.edition.clause("9"),
                ground.modulus()
            ));
        }
    }
    let largest = |value: fn(&Rim) -> f64| rims.iter().filter(|r| r.decides).map(value).fold(0.0, f64::max);
    checks(work, state, bottom, f_y, &rims);
    let lift = Lift { uplift: largest(|r| r.uplift), toe: largest(|r| r.compression) };
    if let Some(reason) = softened(work, state) {
        leave_open(&mut work.out.checks, &[UPLIFT.id], &reason);
    }
    Ok(lift)
}

/// Why the strips do not hold, which leave out the horizontal pressure of the motion on the foot of the wall; also where they say that all of the rim bears.
pub(super) fn softened(work: &Work, state: &State) -> Option<String> {
    let suction = Base::net(work.case).ok()?.suction(state.pressure_horizontal(0.0))?;
    (!suction.holds()).then(|| suction.left_out())
}

/// What the rim does on one ground.
struct Rim {
    /// Modulus k, with its unit.
    modulus: String,
    /// Whether this ground decides.
    decides: bool,
    /// w [m]; zero where all of the rim bears.
    uplift: f64,
    /// L [m].
    length: f64,
    /// θ of the clause [rad].
    rotation: f64,
    /// Plastic rotation of the strip [rad].
    plastic: f64,
    /// At the toe [N/m].
    compression: f64,
}

fn ground_lines(work: &mut Work, ground: &Ground, stand: &Stand) -> Rim {
    let modulus = ground.modulus();
    let aside = if ground.decides { "" } else { ", for information" };
    let source = format!("strips of the bottom plate side by side, subgrade modulus {modulus}{aside}");
    let clause = work.edition.clause("9");
    let own = "strips in place of A.9";
    let (turn, point) = (&stand.turn, &stand.rim);
    let mut rim = Rim {
        modulus,
        decides: ground.decides,
        uplift: turn.uplift.max(0.0),
        length: point.lifted_width,
        rotation: 0.0,
        plastic: point.plastic_rotation,
        compression: turn.toe_force.max(0.0),
    };
    let lifts = rim.uplift > 0.0 && rim.length > 0.0;
    let mut values = vec![
        ("ψ", "rotation of the wall", turn.rotation, Angle),
        ("n_t", "compression at the toe", rim.compression, LineForce),
        ("w", "largest uplift", rim.uplift, Length),
    ];
    if lifts {
        let name = "plastic rotation of the joint, for information";
        values.extend([("L", "lifted length", rim.length, Length), ("θ_p", name, rim.plastic, Angle)]);
    }
    for (symbol, name, value, dimension) in values {
        work.sheet.look_up(symbol, name, &source, value, dimension, own);
    }
    if lifts {
        let name = format!("rotation of the joint on {}{aside}", rim.modulus);
        rim.rotation = work.sheet.calc("θ", &name, "2·w/L - w/(2·R)", Angle, &clause);
    }
    rim
}

/// The moment exceeds what the rim holds up to a rotation at which no tank stands.
fn no_equilibrium(work: &mut Work, state: &State, base: &Base, weight: f64) {
    let limit = lifted::held(base, state.base_moment, weight);
    let note = "no equilibrium of the lifted rim up to a rotation of 0.1 rad";
    let name = "Uplift of the bottom plate: moment that weight and plate hold";
    let check = UPLIFT_EQUILIBRIUM.named(name);
    work.part((UPLIFT, check), state.base_moment, limit, note);
}

/// The remark of the rotation: on which ground, why on that, and what stands beside it.
fn remark(rims: &[Rim], decisive: &Rim) -> String {
    let rotation = |rim: &Rim| format!("{:.3} rad on {}", rim.rotation, rim.modulus);
    let others: Vec<String> = rims.iter().filter(|r| r.modulus != decisive.modulus).map(rotation).collect();
    let why = if rims.iter().filter(|r| r.decides).count() > 1 {
        "the least favourable ground, as `tank.foundation` gives no stiffness"
    } else {
        "the ground that is given"
    };
    format!(
        "on {}, {why}; {}; the plastic rotation of the strip is {:.3} rad, for information",
        decisive.modulus,
        others.join(", "),
        decisive.plastic
    )
}

/// Lines of the membrane stress, and the checks.
fn checks(work: &mut Work, state: &State, bottom: &Bottom, f_y: f64, rims: &[Rim]) {
    let clause = work.edition.clause("9");
    let rotation_check = (UPLIFT, UPLIFT_ROTATION);
    let most = |value: fn(&Rim) -> f64| {
        let deciding = rims.iter().filter(|r| r.decides);
        deciding.max_by(|a, b| value(a).total_cmp(&value(b)))
    };
    let (Some(turned), Some(longest)) = (most(|r| r.rotation), most(|r| r.length)) else { return };
    if turned.rotation == 0.0 {
        work.part(rotation_check, 0.0, ROTATION, "all of the rim bears");
        return;
    }
    work.out.notes.push(format!(
        "{clause}: the strip carries the hydrostatic pressure, as the clause takes it; the suction of the horizontal motion on the lifted side, \
         up to {} at the wall, is left out.",
        with_unit(state.pressure_horizontal(0.0), Stress)
    ));
    let material = &bottom.material;
    let length = longest.length;
    work.sheet.given(&[
        ("p", state.pressure_hydrostatic(0.0), Stress),
        ("E", material.youngs_modulus, Stress),
        ("ν", material.poisson_ratio, Dimensionless),
        ("s_b", bottom.net_thickness(), Length),
        ("L", length, Length),
    ]);
    let mut line = |symbol: &'static str, name: &str, formula: &str, dimension, clause: &str| {
        work.sheet.calc(symbol, name, formula, dimension, clause)
    };
    line("μ", "bearing part of the radius, with the largest L", "(2·R - L)/(2·R)", Dimensionless, &clause);
    let name = "radial membrane stress of the plate, fixed at the rim; (1 - ν²) below, as plane strain asks";
    let formula = if state.tank.pressure.internal > 0.0 {
        "(2/3·E·s_b·(p + p_g)²·R²·(1 - μ)²/(1 - ν²))^(1/3)/s_b"
    } else {
        "(2/3·E·s_b·p²·R²·(1 - μ)²/(1 - ν²))^(1/3)/s_b"
    };
    let stress = line("σ_rb", name, formula, Stress, &clause);
    let note = remark(rims, turned);
    work.part(rotation_check, turned.rotation, ROTATION, &note);
    let name = "Radial membrane stress of the bottom plate";
    work.part((UPLIFT, UPLIFT_MEMBRANE.named(name)), stress, f_y, "with γ_M = 1");
    if let Some(width) = bottom.width {
        let name = "Lifted length within the plate under the wall";
        let note = "beyond the width given in the file the plate may be thinner";
        work.part((UPLIFT, UPLIFT_WIDTH.named(name)), length, width, note);
    }
}

#[cfg(test)]
mod tests;
