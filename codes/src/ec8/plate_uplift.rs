//! Uplift of the bottom plate of an unanchored wall: height, length, rotation of the joint and membrane stress of the plate.
//!
//! ```text
//! w, L        largest uplift of the rim under M and lifted length, own calculation ([`lifted`]) in place of the diagrams of A.9
//! θ = 2w/L − w/(2R) ≤ 0.20 rad        μ = (2R − L)/(2R)
//! σ_rb = (1/s_b) [(2/3) E s_b p² R² (1 − μ)²/(1 − ν²)]^(1/3) ≤ f_y
//! ```
//!
//! Each on ground as given and three times softer and stiffer; the least favourable decides. The diagrams are for rigid ground and tanks
//! with roofs. θ of the clause is the slope of a parabola: the plastic rotation of the strip stands beside it, about two thirds of it. The
//! printed σ_rb has (1 − ν²) in the numerator, 6 % less than the membrane in plane strain that it stands for; the larger value is taken.
//! As the membrane of the formula is fixed at the rim, σ_rb is an upper bound.
//!
//! Source: EN 1998-4:2006 A.9, formulas recalled; strips of [`base`].

use ::base::{Base, Stand};

use super::cylinder_stress::State;
use super::limit_states::UPLIFT;
use super::work::Work;
use crate::lifted;
use crate::sheet::{Term, number, with_unit};
use tank::Bottom;
use tank::assessment::{Check, CheckStatus};
use tank::units::Dimension::{self, *};

/// Largest plastic rotation of the joint of wall and bottom [rad].
const ROTATION: f64 = 0.20;
/// Writes lines and checks; returns the largest compression at the toe [N/m] where it was computed.
///
/// * `weight`: of wall and roof, less overpressure and vertical motion [N/m]
pub(super) fn assess(work: &mut Work, state: &State, weight: f64) -> Option<f64> {
    if !state.tank.is_metal() {
        // The limit state is not applicable: a slab turns as a whole.
        work.uplift = Some(0.0);
        return None;
    }
    let missing = |work: &mut Work, input: &str| {
        let reason = format!("`{input}` is missing");
        work.without_comparison(UPLIFT, CheckStatus::NotChecked, &reason, Some(input));
    };
    let Some(bottom) = &state.tank.bottom else {
        missing(work, "tank.bottom");
        return None;
    };
    let Some(f_y) = bottom.material.yield_strength else {
        missing(work, &format!("materials.{}.yield_strength", bottom.material.name));
        return None;
    };
    work.sheet
        .section("Uplift of the bottom plate (own calculation in place of the diagrams of A.9)");
    let Some(bases) = lifted::bases(work.case) else {
        let reason = "the uplift is computed for bottom plates of metal";
        work.without_comparison(UPLIFT, CheckStatus::NotChecked, reason, Some("tank.bottom"));
        return None;
    };
    let mut grounds = Vec::new();
    for base in &bases {
        let Some(stand) = lifted::under(base, state.base_moment, weight) else {
            no_equilibrium(work, state, base, weight);
            return None;
        };
        grounds.push(ground_lines(work, state, base, &stand));
    }
    let largest = |value: fn(&Ground) -> f64| grounds.iter().map(value).fold(0.0, f64::max);
    work.uplift = Some(largest(|g| g.uplift));
    checks(work, state, bottom, f_y, &grounds);
    Some(largest(|g| g.compression))
}

/// What the rim does on one ground.
struct Ground {
    /// Modulus k [N/m³].
    modulus: f64,
    /// w [m]; zero where all of the rim bears.
    uplift: f64,
    /// L [m].
    length: f64,
    /// θ of the clause [rad].
    rotation: f64,
    /// At the toe [N/m].
    compression: f64,
}

fn ground_lines(work: &mut Work, state: &State, base: &Base, stand: &Stand) -> Ground {
    let modulus = format!("{} MN/m³", number(base.modulus / 1e6));
    let source = format!("strips of the bottom plate side by side, subgrade modulus {modulus}");
    let clause = work.edition.clause("9");
    let own = "strips in place of A.9";
    let (turn, rim) = (&stand.turn, &stand.rim);
    let mut ground = Ground {
        modulus: base.modulus,
        uplift: turn.uplift.max(0.0),
        length: rim.lifted_width,
        rotation: 0.0,
        compression: turn.toe_force.max(0.0),
    };
    let lifts = ground.uplift > 0.0 && ground.length > 0.0;
    let mut values = vec![
        ("ψ", "rotation of the wall", turn.rotation, Angle),
        ("n_t", "compression at the toe", ground.compression, LineForce),
        ("w", "largest uplift", ground.uplift, Length),
    ];
    if lifts {
        values.extend([
            ("L", "lifted length", ground.length, Length),
            (
                "θ_p",
                "plastic rotation of the joint, for information",
                rim.plastic_rotation,
                Angle,
            ),
        ]);
    }
    for (symbol, name, value, dimension) in values {
        work.sheet.look_up(symbol, name, &source, value, dimension, own);
    }
    if lifts {
        let terms = [
            ("w", ground.uplift, Length),
            ("L", ground.length, Length),
            ("R", state.radius, Length),
        ];
        let name = format!("rotation of the joint on {modulus}");
        ground.rotation = work.sheet.calc("θ", &name, "2·w/L - w/(2·R)", &terms, Angle, &clause);
    }
    ground
}

/// The moment exceeds what the rim holds up to a rotation at which no tank stands.
fn no_equilibrium(work: &mut Work, state: &State, base: &Base, weight: f64) {
    let limit = lifted::held(base, state.base_moment, weight);
    let note = "no equilibrium of the lifted rim up to a rotation of 0.1 rad";
    let name = "Uplift of the bottom plate: moment that weight and plate hold";
    part(
        work,
        ("uplift_equilibrium", name),
        state.base_moment,
        limit,
        Moment,
        note,
    );
}

/// Adds a check of the limit state.
fn part(work: &mut Work, (id, name): (&str, &str), demand: f64, capacity: f64, dimension: Dimension, note: &str) {
    let clause = work.edition.clause("9");
    let check = Check::new(id, name, demand, capacity, dimension, &clause, note);
    work.out.checks.push(check.of(UPLIFT));
}

/// Lines of the membrane stress, and the checks.
fn checks(work: &mut Work, state: &State, bottom: &Bottom, f_y: f64, grounds: &[Ground]) {
    let clause = work.edition.clause("9");
    let rotation_check = ("uplift_rotation", "Rotation of the joint of wall and bottom plate");
    let most = |value: fn(&Ground) -> f64| grounds.iter().max_by(|a, b| value(a).total_cmp(&value(b)));
    let (Some(turned), Some(longest)) = (most(|g| g.rotation), most(|g| g.length)) else {
        return;
    };
    if turned.rotation == 0.0 {
        part(work, rotation_check, 0.0, ROTATION, Angle, "all of the rim bears");
        return;
    }
    work.out.notes.push(format!(
        "{clause}: the strip carries the hydrostatic pressure, as the clause takes it; the suction of the horizontal motion on the lifted side, \
         up to {} at the wall, is left out.",
        with_unit(state.pressure_horizontal(0.0), Stress)
    ));
    let material = &bottom.material;
    let length = longest.length;
    let mut terms: Vec<Term> = vec![
        ("p", state.pressure_hydrostatic(0.0), Stress),
        ("p_g", state.tank.pressure.internal, Stress),
        ("E", material.youngs_modulus, Stress),
        ("ν", material.poisson_ratio, Dimensionless),
        ("s_b", bottom.net_thickness(), Length),
        ("R", state.radius, Length),
        ("L", length, Length),
    ];
    let mut line = |symbol: &'static str, name: &str, formula: &str, dimension, clause: &str| {
        let value = work.sheet.calc(symbol, name, formula, &terms, dimension, clause);
        terms.push((symbol, value, dimension));
        value
    };
    line(
        "μ",
        "bearing part of the radius, with the largest L",
        "(2·R - L)/(2·R)",
        Dimensionless,
        &clause,
    );
    let name = "radial membrane stress of the plate, fixed at the rim; (1 - ν²) below, as plane strain asks";
    let formula = if state.tank.pressure.internal > 0.0 {
        "(2/3·E·s_b·(p + p_g)²·R²·(1 - μ)²/(1 - ν²))^(1/3)/s_b"
    } else {
        "(2/3·E·s_b·p²·R²·(1 - μ)²/(1 - ν²))^(1/3)/s_b"
    };
    let stress = line("σ_rb", name, formula, Stress, &clause);
    let on = |ground: &Ground| format!("on {} MN/m³", number(ground.modulus / 1e6));
    part(work, rotation_check, turned.rotation, ROTATION, Angle, &on(turned));
    let name = "Radial membrane stress of the bottom plate";
    part(work, ("uplift_membrane", name), stress, f_y, Stress, "with γ_M = 1");
    if let Some(width) = bottom.width {
        let name = "Lifted length within the plate under the wall";
        let note = "beyond `tank.bottom.width` the plate may be thinner";
        part(work, ("uplift_width", name), length, width, Length, note);
    }
}

#[cfg(test)]
mod tests;
