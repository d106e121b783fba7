//! Rectangular tanks, EN 1998-4:2006 A.4: exact series of a rigid box, shaken along its length 2L; flexible walls through the
//! period of the wall that carries the impulsive mass.
//!
//! ```text
//! γ = H/L      m_i, h_i, h_i′, p_i and the sloshing modes: see `mechanical` (the annex gives graphs)
//! d_max = (8/π²) L S_e(T_c1)/g = 0.811 L S_e/g
//! T_f   = 2π √(d_f/g)      d_f deflection on the wall's vertical centre line at the height of the impulsive mass under the
//!                          uniform load (m_i/2 + wall) g/(b H) in the direction of motion
//! ```

use std::f64::consts::PI;

use super::plate::{Sides, deflection};
use super::work::{Masses, Work, combined};
use crate::mechanical::{
    ConvectiveField, ImpulsiveField, Lumped, Plan, convective, eigenvalue, impulsive, sloshing_omega, wave_factor,
};
use tank::case::{Case, Combination};
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Fills the sheet of a rectangle.
pub(super) fn assess(work: &mut Work, length: f64, breadth: f64, strip: bool) {
    let case = work.case;
    let half = 0.5 * length;
    let depth = case.liquid.fill_height;
    let gamma = depth / half;
    work.tank("L", "half length in the direction of shaking", half);
    work.sheet
        .input("b", "breadth across the shaking", breadth, Length, "input");
    work.demand.describe(&mut work.sheet);

    let rigid = impulsive(Plan::Rectangle, gamma);
    let first = convective(Plan::Rectangle, gamma, 1);
    lines(work, gamma, half, rigid, first);
    let t_c1 = 2.0 * PI / sloshing_omega(Plan::Rectangle, 1, half, depth, case.gravity);
    let t_c2 = 2.0 * PI / sloshing_omega(Plan::Rectangle, 2, half, depth, case.gravity);
    let t_i = wall_period(work, breadth, strip, rigid);

    work.sheet.section("Spectral accelerations");
    let damping = case.damping;
    let a_i = work
        .demand
        .impulsive(&mut work.sheet, &mut work.out.notes, "S_e(T_f)", t_i, damping.impulsive);
    let a_c = work.demand.convective(
        &mut work.sheet,
        &mut work.out.notes,
        "S_e(T_c1)",
        t_c1,
        damping.sloshing,
    );
    let s_2 = work.demand.convective(
        &mut work.sheet,
        &mut work.out.notes,
        "S_e(T_c2)",
        t_c2,
        damping.sloshing,
    );
    let second = wave_factor(Plan::Rectangle, 2);
    work.wave("L", wave_factor(Plan::Rectangle, 1), "4.1", a_c, Some((second, s_2)));
    let clause = work.edition.clause("4");
    let masses = Masses::of(case, [rigid, first]);
    work.resultants(&masses, a_i, a_c, &clause);
    work.out.values.insert(Quantity::SloshingPeriod, t_c1);
    work.out.values.insert(Quantity::ImpulsivePeriod, t_i);
    pressures(work, gamma, half, strip, a_i, a_c);
    work.out.notes.push(
        "Hoop and axial membrane stresses and the stability checks of A.10 belong to cylinders; the walls of a box bend as plates."
            .into(),
    );
}

/// Masses, levers and period of the rigid box.
fn lines(work: &mut Work, gamma: f64, half: f64, rigid: Lumped, first: Lumped) {
    let case = work.case;
    let (mass, depth) = (case.liquid_mass(), case.liquid.fill_height);
    let clause = work.edition.clause("4.1");
    work.sheet.section("Liquid in a rigid tank");
    for (symbol, name, formula, whole, ratio) in [
        (
            "m_i",
            "impulsive mass",
            "m·2·γ·Σ tanh(ν_n/γ)/ν_n³, ν_n = (2n+1)·π/2",
            ("m", mass, Mass),
            rigid.mass,
        ),
        (
            "h_i",
            "impulsive lever, wall only",
            "H·Σ tanh·(ν_n - (-1)ⁿ)/ν_n⁴/Σ tanh/ν_n³",
            ("H", depth, Length),
            rigid.lever,
        ),
        (
            "h_i′",
            "impulsive lever, wall and base",
            "H·[1/2 + 2·γ·Σ tanh·(ν_n - 2·(-1)ⁿ)/ν_n⁴]/[2·γ·Σ tanh/ν_n³]",
            ("H", depth, Length),
            rigid.lever_with_base,
        ),
    ] {
        work.ratio((symbol, name), formula, whole, ratio, &clause);
    }
    let lambda = eigenvalue(Plan::Rectangle, 1);
    let terms = [
        ("m", mass, Mass),
        ("γ", gamma, Dimensionless),
        ("λ", lambda, Dimensionless),
        ("H", depth, Length),
        ("L", half, Length),
        ("g", case.gravity, Acceleration),
    ];
    let omega = sloshing_omega(Plan::Rectangle, 1, half, depth, case.gravity);
    for (symbol, name, formula, value, dimension) in [
        ("λ", "eigenvalue of sloshing mode 1", "π/2", lambda, Dimensionless),
        (
            "m_c1",
            "mass of sloshing mode 1",
            "m·2·tanh(λ·γ)/(λ³·γ)",
            first.mass * mass,
            Mass,
        ),
        (
            "h_c1",
            "its lever, wall only",
            "H·(1 - (cosh(λ·γ) - 1)/(λ·γ·sinh(λ·γ)))",
            first.lever * depth,
            Length,
        ),
        (
            "h_c1′",
            "its lever, wall and base",
            "H·(1 - (cosh(λ·γ) - 2)/(λ·γ·sinh(λ·γ)))",
            first.lever_with_base * depth,
            Length,
        ),
        ("T_c1", "its period", "2·π/√(g·λ·tanh(λ·γ)/L)", 2.0 * PI / omega, Time),
    ] {
        work.sheet
            .calc(symbol, name, formula, &terms, value, dimension, &clause);
    }
}

/// Uniform load on one wall across the motion that stands for impulsive liquid and wall [Pa].
fn wall_load(case: &Case, breadth: f64, impulsive_mass: f64) -> f64 {
    let wall: f64 = case
        .tank
        .courses
        .iter()
        .map(|c| c.height * c.thickness * c.material.density)
        .sum::<f64>()
        * breadth;
    (0.5 * impulsive_mass + wall) * case.gravity / (breadth * case.liquid.fill_height)
}

fn wall_period(work: &mut Work, breadth: f64, strip: bool, rigid: Lumped) -> f64 {
    let case = work.case;
    let depth = case.liquid.fill_height;
    let clause = work.edition.clause("4.2");
    let mass = rigid.mass * case.liquid_mass();
    let at = rigid.lever * depth;
    let load = wall_load(case, breadth, mass);
    let sides = if strip {
        Sides::Strip
    } else {
        Sides::Clamped {
            half_width: 0.5 * breadth,
        }
    };
    let d_f = deflection(&case.tank.courses, sides, load, depth, at);
    work.sheet.section("Flexible wall");
    let name = "uniform load of half the impulsive mass and one wall across the motion";
    work.sheet
        .step("q", name, "(m_i/2 + m_wall)·g/(b·H)", "", load, Stress, &clause);
    let how = if strip {
        "cantilever in plane strain"
    } else {
        "plate clamped at base and sides, free at the top"
    };
    let name = format!("deflection on the centre line at z = h_i under q, {how}");
    work.sheet.step("d_f", &name, "plate theory", "", d_f, Length, &clause);
    let terms = [("d_f", d_f, Length), ("g", case.gravity, Acceleration)];
    work.sheet.calc(
        "T_f",
        "impulsive period",
        "2·π·√(d_f/g)",
        &terms,
        2.0 * PI * (d_f / case.gravity).sqrt(),
        Time,
        &clause,
    )
}

fn pressures(work: &mut Work, gamma: f64, half: f64, strip: bool, a_i: f64, a_c: f64) {
    let case = work.case;
    let depth = case.liquid.fill_height;
    let rho = case.liquid.density;
    let field_i = ImpulsiveField::new(Plan::Rectangle, gamma);
    let field_c = ConvectiveField::new(Plan::Rectangle, gamma, 1);
    let method = case.procedures.ec8_combination;
    let p_i = |z: f64| rho * depth * field_i.wall(z / depth) * a_i;
    let p_c = |z: f64| rho * half * field_c.wall(z / depth) * a_c;
    let ground = work.demand.vertical_ground();
    let p_v = |z: f64| rho * (depth - z).max(0.0) * ground;
    let seismic = |z: f64| {
        let horizontal = combined(method, p_i(z), p_c(z));
        (horizontal + 0.3 * p_v(z)).max(0.3 * horizontal + p_v(z))
    };
    let z = work.heights();
    work.profile("pressure_impulsive", "Impulsive pressure", Stress, &z, p_i);
    work.profile("pressure_convective", "Convective pressure", Stress, &z, p_c);
    work.profile("pressure_dynamic", "Seismic pressure", Stress, &z, seismic);

    work.sheet.section("Pressures on the wall at its base");
    let clause = work.edition.clause("4.1");
    let (i, c) = (p_i(0.0), p_c(0.0));
    let terms = [
        ("ρ", rho, Density),
        ("H", depth, Length),
        ("L", half, Length),
        ("A_i", a_i, Acceleration),
        ("A_c1", a_c, Acceleration),
        ("C", field_i.wall(0.0), Dimensionless),
        ("q_c1", field_c.wall(0.0), Dimensionless),
        ("p_i", i, Stress),
        ("p_c", c, Stress),
    ];
    work.sheet
        .calc("p_i", "impulsive, q_0 = γ·C", "ρ·H·C·A_i", &terms, i, Stress, &clause);
    work.sheet
        .calc("p_c", "convective, mode 1", "ρ·L·q_c1·A_c1", &terms, c, Stress, &clause);
    let formula = match method {
        Combination::Abs => "p_i + p_c",
        Combination::Srss => "√(p_i² + p_c²)",
    };
    let combination = work.edition.clause("2.1");
    work.sheet.calc(
        "p",
        "horizontal motion",
        formula,
        &terms,
        combined(method, i, c),
        Stress,
        &combination,
    );
    if work.demand.vertical {
        let terms = [("ρ", rho, Density), ("H", depth, Length), ("A_v", ground, Acceleration)];
        let clause = work.edition.clause("2.2");
        work.sheet.calc(
            "p_v",
            "vertical motion, rigid",
            "ρ·H·A_v",
            &terms,
            p_v(0.0),
            Stress,
            &clause,
        );
    }
    if strip {
        bending(work, &field_i, &field_c, a_i, a_c);
    }
}

/// Bending of a strip's wall as a cantilever: half of the liquid's moment and the wall's own inertia.
fn bending(work: &mut Work, field_i: &ImpulsiveField, field_c: &ConvectiveField, a_i: f64, a_c: f64) {
    let case = work.case;
    // A strip's perimeter is its two walls: half the liquid's moment over the breadth of one.
    let scale = case.liquid_mass() * case.liquid.fill_height / case.tank.perimeter();
    let wall = case.tank.wall_mass() * case.tank.wall_centroid() / case.tank.perimeter();
    let roof = case.tank.roof.mass * case.tank.roof_height() / case.tank.perimeter();
    let impulsive = (scale * field_i.moment_above(0.0) + wall + roof) * a_i;
    let convective = scale * field_c.moment_above(0.0) * a_c;
    let moment = combined(case.procedures.ec8_combination, impulsive, convective);
    let thickness = case.tank.courses[0].thickness;
    let terms = [("m_z", moment, LineMoment), ("s", thickness, Length)];
    let stress = 6.0 * moment / (thickness * thickness);
    work.sheet.section("Bending of the wall (seismic part)");
    work.sheet.input(
        "m_z",
        "clamping moment of one wall, cantilever",
        moment,
        LineMoment,
        "statics",
    );
    work.sheet.calc(
        "σ_b",
        "bending stress at the base",
        "6·m_z/s²",
        &terms,
        stress,
        Stress,
        "statics",
    );
    work.out.values.insert(Quantity::BendingStress, stress);
}
