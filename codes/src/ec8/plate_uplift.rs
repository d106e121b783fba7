//! Uplift of the bottom plate of an unanchored wall: height, length, rotation of the joint and membrane stress of the plate.
//!
//! ```text
//! w           largest uplift of the rim under M, own calculation ([`Rim`]) in place of the diagrams of A.9
//! L           lifted length of the strip ([`Strip`])        μ = (2R − L)/(2R)
//! θ = 2w/L − w/(2R) ≤ 0.20 rad
//! σ_rb = (1/s_b) [(2/3) E s_b p² R² (1 − μ)²/(1 − ν²)]^(1/3) ≤ f_y
//! ```
//!
//! The diagrams are for rigid ground and tanks with roofs. Without `tank.bottom.subgrade_modulus` the uplift is that of soft ground and
//! the compression at the toe that of stiff ground. The printed σ_rb has (1 − ν²) in the numerator, 6 % less than the membrane in plane
//! strain that it stands for; the larger value is taken. As the membrane of the formula is fixed at the rim, σ_rb is an upper bound.
//!
//! Source: EN 1998-4:2006 A.9, formulas recalled; strip and rim derived here.

use super::bottom_strip::Strip;
use super::cylinder_stress::State;
use super::limit_states::UPLIFT;
use super::rim::{Rim, Turned};
use super::work::Work;
use crate::sheet::{Term, number, with_unit};
use tank::Bottom;
use tank::assessment::{Check, CheckStatus};
use tank::units::Dimension::{self, *};

/// Largest plastic rotation of the joint of wall and bottom [rad].
pub(crate) const ROTATION: f64 = 0.20;
/// Subgrade moduli of soft and stiff ground [N/m³]: compacted gravel, and rock, a slab or a ring wall.
const GROUND: [f64; 2] = [1e8, 1e10];

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
    let strip = strip_lines(work, state, bottom, f_y);
    let grounds = bottom.subgrade_modulus.map_or(GROUND.to_vec(), |k| vec![k]);
    let mut turned = Vec::new();
    for ground in grounds {
        let rim = Rim {
            radius: state.radius,
            weight,
            strip,
            ground,
        };
        match rim.under(state.base_moment) {
            Some(found) => {
                rim_lines(work, ground, found);
                turned.push(found);
            }
            None => {
                no_equilibrium(work, state, &rim);
                return None;
            }
        }
    }
    let uplift = turned.iter().map(|t| t.uplift).fold(0.0, f64::max);
    work.uplift = Some(uplift);
    checks(work, state, bottom, f_y, uplift);
    Some(turned.iter().map(|t| t.compression).fold(0.0, f64::max))
}

/// Lines of rigidity and plastic moment.
fn strip_lines(work: &mut Work, state: &State, bottom: &Bottom, f_y: f64) -> Strip {
    let material = &bottom.material;
    let terms = [
        ("E", material.youngs_modulus, Stress),
        ("ν", material.poisson_ratio, Dimensionless),
        ("f_y", f_y, Stress),
        ("s_b", bottom.net_thickness(), Length),
    ];
    let (name, formula) = ("rigidity of the bottom plate", "E·s_b³/(12·(1 - ν²))");
    work.sheet.calc("D_b", name, formula, &terms, Moment, "plate theory");
    let (name, formula) = ("its plastic moment", "f_y·s_b²/4");
    work.sheet
        .calc("M_p", name, formula, &terms, LineMoment, "plate theory");
    let pressure = state.pressure_hydrostatic(0.0);
    Strip::new(
        material.youngs_modulus,
        material.poisson_ratio,
        f_y,
        bottom.net_thickness(),
        pressure,
    )
}

fn rim_lines(work: &mut Work, ground: f64, turned: Turned) {
    let source = format!(
        "equilibrium of the rim on bottom strips, subgrade modulus {} MN/m³",
        number(ground / 1e6)
    );
    let clause = "strips in place of A.9";
    for (symbol, name, value, dimension) in [
        ("ψ", "rotation of the wall", turned.rotation, Angle),
        ("w", "largest uplift", turned.uplift, Length),
        ("n_t", "compression at the toe", turned.compression, LineForce),
    ] {
        work.sheet.look_up(symbol, name, &source, value, dimension, clause);
    }
}

/// The moment exceeds what the rim holds up to a rotation at which no tank stands.
fn no_equilibrium(work: &mut Work, state: &State, rim: &Rim) {
    let limit = rim.turned(0.1).map_or(0.0, |t| t.moment);
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

/// Lines of length, rotation and membrane stress, and their checks.
fn checks(work: &mut Work, state: &State, bottom: &Bottom, f_y: f64, uplift: f64) {
    let clause = work.edition.clause("9");
    let rotation_check = ("uplift_rotation", "Rotation of the joint of wall and bottom plate");
    if uplift == 0.0 {
        part(work, rotation_check, 0.0, ROTATION, Angle, "all of the rim bears");
        return;
    }
    work.out.notes.push(format!(
        "{clause}: the strip carries the hydrostatic pressure, as the clause takes it; the suction of the horizontal motion on the lifted side, \
         up to {} at the wall, is left out.",
        with_unit(state.pressure_horizontal(0.0), Stress)
    ));
    let material = &bottom.material;
    let strip = Strip::new(
        material.youngs_modulus,
        material.poisson_ratio,
        f_y,
        bottom.net_thickness(),
        state.pressure_hydrostatic(0.0),
    );
    let mut terms: Vec<Term> = vec![
        ("w", uplift, Length),
        ("p", strip.pressure, Stress),
        ("p_g", state.tank.pressure.internal, Stress),
        ("D_b", strip.rigidity, Moment),
        ("M_p", strip.plastic_moment, LineMoment),
        ("E", material.youngs_modulus, Stress),
        ("ν", material.poisson_ratio, Dimensionless),
        ("s_b", bottom.net_thickness(), Length),
        ("R", state.radius, Length),
    ];
    let mut line = |symbol: &'static str, name: &str, formula: &str, dimension, clause: &str| {
        let value = work.sheet.calc(symbol, name, formula, &terms, dimension, clause);
        terms.push((symbol, value, dimension));
        value
    };
    let (name, formula) = if strip.length(uplift) >= strip.length(strip.mechanism()) {
        ("lifted length, hinges at joint and in the span", "(2 + √(2))·√(M_p/p)")
    } else if uplift > strip.first_hinge() {
        (
            "lifted length, hinge at the joint",
            "√((2·M_p + √(4·M_p² + 24·p·D_b·w))/p)",
        )
    } else {
        ("lifted length, elastic", "√(√(72·D_b·w/p))")
    };
    let length = line("L", name, formula, Length, "strips in place of A.9");
    let name = "plastic rotation of the joint";
    let rotation = line("θ", name, "2·w/L - w/(2·R)", Angle, &clause);
    line(
        "μ",
        "bearing part of the radius",
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
    let note = match bottom.subgrade_modulus {
        Some(_) => "",
        None => "on soft ground, 100 MN/m³: `tank.bottom.subgrade_modulus` is not given",
    };
    part(work, rotation_check, rotation, ROTATION, Angle, note);
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
