//! Base of a cylinder's wall: anchors, and an estimate for unanchored tanks in place of the diagrams of A.9.

use std::f64::consts::PI;

use super::cylinder_stress::{Factors, State};
use super::uplift;
use super::work::Work;
use crate::sheet::with_unit;
use tank::units::Dimension::*;

/// Tension of the anchors, or a note that they are not given.
pub(super) fn anchorage(work: &mut Work, state: &State, vertical: bool) {
    let clause = work.edition.clause("9");
    let tension = |factors: &Factors| {
        let weight = state.weight(0.0) * (2.0 - state.weight_factor(factors.1));
        factors.0 * state.axial(0.0) - weight
    };
    let largest = state
        .combinations(vertical)
        .iter()
        .map(tension)
        .fold(f64::NEG_INFINITY, f64::max);
    work.sheet.section("Anchorage");
    let terms = [
        ("n_z", state.axial(0.0), LineForce),
        ("N_0", state.weight(0.0), LineForce),
    ];
    let formula = "n_z - N_0";
    if !vertical {
        work.sheet.calc(
            "n_a",
            "uplift at the base of an anchored wall",
            formula,
            &terms,
            largest,
            LineForce,
            &clause,
        );
    } else {
        let formula = "largest of n_z - N_0 over the combinations of horizontal and vertical motion";
        work.sheet.step(
            "n_a",
            "uplift at the base of an anchored wall",
            formula,
            "",
            largest,
            LineForce,
            &clause,
        );
    }
    let anchors = state
        .tank
        .anchors
        .and_then(|a| a.capacity.map(|capacity| (a.count, capacity)));
    match anchors {
        Some((count, capacity)) => {
            let spacing = 2.0 * PI * state.radius / f64::from(count.max(1));
            let force = (largest * spacing).max(0.0);
            let note = format!("{count} anchors, one every {}", with_unit(spacing, Length));
            work.check("anchorage", "Tension of an anchor", force, capacity, Force, &clause, &note);
        }
        None if largest > 0.0 => work.out.notes.push(format!(
            "The wall pulls at its base with {}; the anchors were not checked, their number and capacity are not given.",
            with_unit(largest, LineForce)
        )),
        None => {}
    }
}

/// Factor by which uplift raises the compression at the base, estimated by equilibrium; none if the tank overturns.
pub(super) fn unanchored(work: &mut Work, state: &State) -> Option<f64> {
    let clause = work.edition.clause("9");
    work.out.notes.push(format!(
        "{clause}: the axial amplification of an unanchored wall needs the code's diagrams, which are not reproduced. The value \
         used is an estimate from equilibrium: linear compression on one part of the circumference, the hold-down of wall weight \
         and bottom plate on the rest."
    ));
    let pressure = state.pressure_hydrostatic(0.0);
    let diameter = 2.0 * state.radius;
    let bottom = state
        .tank
        .bottom
        .as_ref()
        .and_then(|b| b.material.yield_strength.map(|f_y| (b.thickness, f_y)));
    let hold_down = match bottom {
        Some((thickness, f_y)) => uplift::hold_down(pressure, thickness, f_y, diameter),
        None => {
            work.out.notes.push(format!(
                "{clause}: thickness or yield strength of the bottom plate is not given; only the weight of wall and roof holds down."
            ));
            0.0
        }
    };
    let weight = state.weight(0.0) * (2.0 - state.weight_factor(0.3));
    let capacity = diameter * diameter * (weight + hold_down);
    let x = state.base_moment / capacity;
    let terms = [
        ("M", state.base_moment, Moment),
        ("D", diameter, Length),
        ("w_t", weight, LineForce),
        ("w_L", hold_down, LineForce),
    ];
    work.sheet.section("Uplift (estimate)");
    work.sheet
        .input("w_t", "weight of wall and roof", weight, LineForce, &clause);
    work.sheet.input(
        "w_L",
        "hold-down of the bottom plate, t_b·√(p·f_y)",
        hold_down,
        LineForce,
        "plastic bottom strip",
    );
    work.sheet.calc(
        "x",
        "overturning ratio",
        "M/(D²·(w_t + w_L))",
        &terms,
        x,
        Dimensionless,
        "equilibrium",
    );
    let limit = 0.5 * PI * capacity;
    let note = "equilibrium without the code's diagrams; beyond it the tank overturns";
    work.check(
        "overturning",
        "Overturning of the unanchored tank",
        state.base_moment,
        limit,
        Moment,
        &clause,
        note,
    );
    let compression = uplift::compression(x, weight, hold_down)?;
    let anchored = weight + state.axial(0.0);
    let amplification = compression / anchored;
    let terms = [("N_u", compression, LineForce), ("N_a", anchored, LineForce)];
    work.sheet.input(
        "N_u",
        "largest compression with uplift",
        compression,
        LineForce,
        "equilibrium",
    );
    work.sheet
        .input("N_a", "the same if anchored", anchored, LineForce, "membrane theory");
    work.sheet.calc(
        "N_u/N_a",
        "amplification",
        "N_u/N_a",
        &terms,
        amplification,
        Dimensionless,
        &clause,
    );
    Some(amplification)
}
