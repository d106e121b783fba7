//! Base of a cylinder's wall: anchors, and an estimate for unanchored tanks in place of the diagrams of A.9.

use std::f64::consts::PI;

use super::cylinder_stress::State;
use super::limit_states::{ANCHORS, OVERTURNING};
use super::plate_uplift;
use super::uplift::{self, Compression};
use super::work::{Work, missing_input};
use crate::base_state::{BaseState, Lift};
use crate::sheet::with_unit;
use tank::assessment::CheckStatus;
use tank::case::Components;
use tank::units::Dimension::*;

/// Tension of the anchors, or a note that they are not given.
pub(super) fn anchorage(work: &mut Work, state: &State, vertical: bool) {
    let clause = work.edition.clause("9");
    work.sheet.section("Anchorage");
    let name = "uplift at the base of an anchored wall";
    work.sheet.given(&[
        ("n_z", state.axial(0.0), LineForce),
        ("N_0", state.held(), LineForce),
        ("A_v", work.demand.vertical_ground(), Acceleration),
    ]);
    // The larger of E_x + 0.3 E_z and 0.3 E_x + E_z; c_v of two horizontal components.
    let mut formula = String::from(if vertical && work.demand.components == Components::HundredThirty {
        "max(n_z - N_0·(1 - 0.3·A_v/g), c_v·n_z - N_0·(1 - A_v/g))"
    } else if vertical {
        "max(n_z - N_0·(1 - 0.3·A_v/g), 0.3·n_z - N_0·(1 - A_v/g))"
    } else {
        "n_z - N_0"
    });
    if state.tank.pressure.internal > 0.0 {
        formula += " + p_g·R/2";
    }
    let largest = work.sheet.calc("n_a", name, &formula, LineForce, &clause);
    let anchors = state.tank.anchors.and_then(|a| a.capacity.map(|capacity| (a.count, capacity)));
    match anchors {
        Some((count, capacity)) => {
            let spacing = 2.0 * PI * state.radius / f64::from(count.max(1));
            let force = (largest * spacing).max(0.0);
            let note = format!("{count} anchors, one every {}", with_unit(spacing, Length));
            work.check(ANCHORS.named("Tension of an anchor"), force, capacity, &clause, &note);
        }
        None if largest > 0.0 => {
            let input = match state.tank.anchors {
                Some(_) => "tank.anchors.capacity",
                None => "tank.anchors",
            };
            let reason =
                format!("the wall pulls at its base with {}; `{input}` is missing", with_unit(largest, LineForce));
            work.without_comparison(ANCHORS.id, CheckStatus::NotChecked, &reason, Some(input));
        }
        None => {
            let reason = "the wall does not pull at its base";
            work.without_comparison(ANCHORS.id, CheckStatus::NotApplicable, reason, None);
        }
    }
    work.base = BaseState::on_anchors(&work.out.checks);
    let down = if vertical { 1.0 + 0.3 * work.demand.vertical_ground() / state.gravity } else { 1.0 };
    work.rim = Some(state.weight(0.0) * down + state.axial(0.0));
}

/// Compression at the base of an unanchored wall over that of an anchored one.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Amplification {
    /// The factor.
    Factor(f64),
    /// None: the tank overturns.
    Overturns,
    /// Not known: this input is missing.
    Missing(String),
}

/// The input without which the pull of the bottom plate is not known. A wall of concrete has no plate that lifts with it.
fn missing(state: &State) -> Option<String> {
    if !state.tank.is_metal() {
        return None;
    }
    match &state.tank.bottom {
        None => Some("tank.bottom".into()),
        Some(bottom) if bottom.material.yield_strength.is_none() => {
            Some(format!("materials.{}.yield_strength", bottom.material.name))
        }
        Some(_) => None,
    }
}

/// w_t: weight of wall and roof per length, less what lifts them [N/m].
fn weight(work: &mut Work, state: &State, clause: &str) -> f64 {
    let name = "weight of wall and roof";
    work.sheet.given(&[("N_0", state.held(), LineForce), ("A_v", work.demand.vertical_ground(), Acceleration)]);
    let (mut name, mut formula) = (String::from(name), String::from("N_0"));
    if state.tank.roof.snow_on_wall() > 0.0 {
        name += ", without snow";
    }
    if work.demand.vertical {
        name += ", less 0.3 of the vertical motion";
        formula += "·(1 - 0.3·A_v/g)";
    }
    if state.tank.pressure.internal > 0.0 {
        name += ", less the overpressure on the roof";
        formula += " - p_g·R/2";
    }
    match formula.as_str() {
        "N_0" => work.sheet.input("w_t", &name, state.held(), LineForce, clause),
        formula => work.sheet.calc("w_t", &name, formula, LineForce, clause),
    }
}

/// The compression with uplift over that of an anchored tank.
///
/// * `toe`: compression at the toe by strips of the bottom plate [N/m]
fn amplification(work: &mut Work, state: &State, toe: Option<f64>, clause: &str) -> f64 {
    work.sheet.given(&[("n_z", state.axial(0.0), LineForce)]);
    let name = "the same if anchored";
    work.sheet.calc("N_a", name, "w_t + n_z", LineForce, "membrane theory");
    work.sheet.given(&[("n_t", toe.unwrap_or_default(), LineForce)]);
    let (name, formula) = match toe {
        Some(_) => ("amplification, the larger of both estimates", "max(N_u, n_t)/N_a"),
        None => ("amplification", "N_u/N_a"),
    };
    work.sheet.calc("N_u/N_a", name, formula, Dimensionless, clause)
}

/// What the base does, and the factor by which uplift raises the compression there, estimated by equilibrium.
pub(super) fn unanchored(work: &mut Work, state: &State) -> Amplification {
    let clause = work.edition.clause("9");
    work.out.notes.push(format!(
        "{clause}: the axial amplification of an unanchored wall needs the code's diagrams, which are not reproduced. The value \
         used is the larger of two estimates from equilibrium, with the hold-down of wall weight and bottom plate on the lifted part: a \
         linear compression on the rest of the circumference, and the rim of a wall that turns as a plane on the ground."
    ));
    let diameter = 2.0 * state.radius;
    work.sheet.section("Uplift (estimate)");
    let weight = weight(work, state, &clause);
    work.out.hold_down = Some(weight);
    if let Some(input) = missing(state) {
        work.missing(OVERTURNING.id, &input);
        let _ = strips(work, state, weight);
        work.base = BaseState::Unknown(missing_input(&input));
        return Amplification::Missing(input);
    }
    hold_down(work, state, diameter, &clause);
    work.sheet.given(&[("D", diameter, Length)]);
    let (name, formula) = ("overturning ratio", "M/(D²·(w_t + w_L))");
    let x = work.sheet.calc("x", name, formula, Dimensionless, "equilibrium");
    let name = "moment that weight and bottom plate hold, all of the wall lifted but its toe";
    let formula = "π/2·D²·(w_t + w_L)";
    let limit = work.sheet.calc("M_Rd", name, formula, Moment, "equilibrium");
    let note = match state.tank.is_metal() {
        true => "equilibrium of a ring without the code's diagrams; beyond it the ring overturns",
        false => "equilibrium of wall and roof alone, without the liquid on the bottom; beyond it they overturn",
    };
    work.check(OVERTURNING.named("Overturning of the unanchored tank"), state.base_moment, limit, &clause, note);
    let name = "largest compression with uplift";
    let Some(how) = uplift::compression(x) else {
        // Beyond the overturning limit the plate has no equilibrium either.
        let _ = strips(work, state, weight);
        work.base = BaseState::Unknown("the unanchored tank overturns".into());
        return Amplification::Overturns;
    };
    let compression = match how {
        Compression::Linear => {
            let formula = "w_t + 4·M/(π·D²)";
            work.sheet.calc("N_u", name, formula, LineForce, "equilibrium of a ring, all of which bears")
        }
        Compression::Arc(y) => {
            let (what, source) =
                ("(N_u + w_L)/(w_t + w_L)", "equilibrium of the bearing arc at x, solved for its angle");
            work.sheet.look_up("y", what, source, y, Dimensionless, "equilibrium");
            let formula = "y·(w_t + w_L) - w_L";
            work.sheet.calc("N_u", name, formula, LineForce, "equilibrium")
        }
    };
    let strips = strips(work, state, weight);
    let (toe, softened) = match &strips {
        Some(Ok(lift)) => (Some(lift.toe), plate_uplift::softened(work, state)),
        _ => (None, None),
    };
    work.base = softened.map_or_else(|| standing(how, compression, strips), BaseState::Unknown);
    work.rim = Some(compression);
    Amplification::Factor(amplification(work, state, toe, &clause))
}

/// Strips of the bottom plate; none under a wall of concrete, whose slab turns as a whole.
fn strips(work: &mut Work, state: &State, weight: f64) -> Option<Result<Lift, String>> {
    state.tank.is_metal().then(|| plate_uplift::assess(work, state, weight))
}

/// What the base does: it bears where both estimates say so, and its toe presses with the larger of them.
///
/// * `compression`: largest by the equilibrium of a ring [N/m]
fn standing(how: Compression, compression: f64, strips: Option<Result<Lift, String>>) -> BaseState {
    match strips {
        None => BaseState::Bears,
        Some(Err(reason)) => BaseState::Unknown(reason),
        Some(Ok(lift)) if lift.uplift <= 0.0 && how == Compression::Linear => BaseState::Bears,
        Some(Ok(lift)) => BaseState::Lifts(Lift { toe: lift.toe.max(compression), ..lift }),
    }
}

/// Hold-down of the bottom plate per length [N/m]; zero under a wall of concrete whose bottom is not of metal.
fn hold_down(work: &mut Work, state: &State, diameter: f64, clause: &str) -> f64 {
    let bottom = state.tank.bottom.as_ref().and_then(|b| b.material.yield_strength.map(|f_y| (b.net_thickness(), f_y)));
    let name = "hold-down of the bottom plate";
    let Some((thickness, f_y)) = bottom else {
        work.out
            .notes
            .push(format!("{clause}: no bottom plate of metal is given; only the weight of wall and roof holds down."));
        return work.sheet.input("w_L", name, 0.0, LineForce, "no bottom plate of metal");
    };
    work.sheet.given(&[
        ("t_b", thickness, Length),
        ("p", state.pressure_hydrostatic(0.0), Stress),
        ("f_y", f_y, Stress),
        ("D", diameter, Length),
    ]);
    work.sheet.calc("w_L", name, uplift::HOLD_DOWN, LineForce, "plastic bottom strip")
}
