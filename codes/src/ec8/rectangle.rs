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

use super::cylinder::LARGE;
use super::plate::{Sides, deflection};
use super::work::{Masses, Work, combined};
use super::{bearing, damage, ingredients, pipes, sliding, stability, walls};
use crate::mechanical::{ConvectiveField, ImpulsiveField, Lumped, Plan, impulsive, sloshing_omega};
use tank::case::{Case, Combination};
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Fills the sheet of a rectangle.
pub(super) fn assess(work: &mut Work, length: f64, breadth: f64, strip: bool) {
    let case = work.case;
    let half = 0.5 * length;
    let gamma = work.tank("L", "half length in the direction of shaking", half);
    work.sheet.input("b", "breadth across the shaking", breadth, Length, "input");
    work.demand.describe(&mut work.sheet);

    let (masses, t_c1) = lines(work, gamma);
    let t_c2 = 2.0 * PI / sloshing_omega(Plan::Rectangle, 2, half, case.liquid.fill_height, case.gravity);
    let t_i = wall_period(work, breadth, strip, &masses);

    work.sheet.section("Spectral accelerations");
    let a_i = work.impulsive("S_e(T_f)", t_i);
    let a_c = work.convective("S_e(T_c1)", t_c1);
    let s_2 = work.convective("S_e(T_c2)", t_c2);
    // 2/λ_n² of the first two modes.
    let wave = work.wave("L", ["8/π²", "8/(9·π²)"], "4.1", a_c, s_2);
    work.freeboard(wave, "4.1", "");
    let clause = work.edition.clause("4");
    work.resultants(&masses, a_i, a_c, &clause);
    sliding::assess(work);
    work.out.values.insert(Quantity::SloshingPeriod, t_c1);
    work.out.values.insert(Quantity::ImpulsivePeriod, t_i);
    ingredients::structure(work);
    let motion = ingredients::Motion { impulsive: (t_i, a_i), convective: (t_c1, a_c), sloshing: (t_c1, a_c) };
    ingredients::record(work, &masses, &masses, &motion, &ingredients::Wall::Plate);
    pressures(work, gamma, half, strip, a_i, a_c);
    damage::assess(work, None, false);
    stability::assess(work);
    wall_checks(work, gamma, (length, breadth), strip, (a_i, a_c));
    bearing::assess(work, 0.0);
    pipes::assess(work);
    if !case.tank.pressure.is_none() {
        work.out.notes.push(
            "The pressure above the liquid (`tank.pressure`) is not included in the walls of a rectangle.".into(),
        );
    }
    work.out.notes.push(
        "Hoop and axial membrane stresses and the stability checks of A.10 belong to cylinders; the walls of a box bend as plates."
            .into(),
    );
}

/// Checks of the walls: pressures and resultants over the height from the series.
fn wall_checks(work: &mut Work, gamma: f64, plan: (f64, f64), strip: bool, (a_i, a_c): (f64, f64)) {
    let case = work.case;
    let (depth, half) = (case.liquid.fill_height, 0.5 * plan.0);
    let (rho, mass) = (case.liquid.density, case.liquid_mass());
    let field_i = ImpulsiveField::new(Plan::Rectangle, gamma);
    let field_c = ConvectiveField::new(Plan::Rectangle, gamma, 1);
    let method = case.procedures.ec8_combination;
    let pressures = |z: f64| {
        let zeta = z / depth;
        let impulsive = rho * depth * field_i.wall(zeta) * a_i;
        (impulsive, rho * half * field_c.wall(zeta) * a_c)
    };
    let section = |z: f64| {
        let zeta = (z / depth).min(1.0);
        let (above, moment) = case.tank.mass_above(z);
        let i = (mass * depth * field_i.moment_above(zeta) + moment) * a_i;
        let c = mass * depth * field_c.moment_above(zeta) * a_c;
        let q_i = (mass * field_i.shear_above(zeta) + above) * a_i;
        let q_c = mass * field_c.shear_above(zeta) * a_c;
        (combined(method, i, c), combined(method, q_i, q_c))
    };
    let tank = walls::BoxTank { plan, strip, impulsive: a_i, pressures: &pressures, section: &section };
    walls::rectangle(work, &tank);
}

/// Masses and levers of the rigid box, and its first sloshing period [s].
fn lines(work: &mut Work, gamma: f64) -> (Masses, f64) {
    let clause = work.edition.clause("4.1");
    let rigid = impulsive(Plan::Rectangle, gamma);
    let series = [
        "series 2·γ·Σ tanh(ν_n/γ)/ν_n³, ν_n = (2n+1)·π/2",
        "series Σ tanh·(ν_n - (-1)ⁿ)/ν_n⁴/Σ tanh/ν_n³",
        "series [1/2 + 2·γ·Σ tanh·(ν_n - 2·(-1)ⁿ)/ν_n⁴]/[2·γ·Σ tanh/ν_n³]",
    ];
    let impulsive = work.rigid_part(rigid, series, &clause);

    let sheet = &mut work.sheet;
    let name = "eigenvalue of sloshing mode 1";
    let lambda = sheet.calc("λ", name, "π/2", Dimensionless, &clause);
    let (name, formula) = ("mass of sloshing mode 1", "m·2·tanh(λ·γ)/(λ³·γ)");
    let m_c = sheet.calc("m_c1", name, formula, Mass, &clause);
    let [h_c, h_cb] = [("h_c1", "its lever, wall only", 1), ("h_c1′", "its lever, wall and base", 2)].map(
        |(symbol, name, constant)| {
            let formula = if lambda * gamma < LARGE {
                format!("H·(1 - (cosh(λ·γ) - {constant})/(λ·γ·sinh(λ·γ)))")
            } else {
                "H·(1 - 1/(λ·γ))".into()
            };
            sheet.calc(symbol, name, &formula, Length, &clause)
        },
    );
    let formula = "2·π/√(g·λ·tanh(λ·γ)/L)";
    let period = sheet.calc("T_c1", "its period", formula, Time, &clause);
    let convective = Lumped { mass: m_c, lever: h_c, lever_with_base: h_cb };
    (Masses { impulsive, convective }, period)
}

/// Mass of one wall across the motion [kg].
fn mass_of_one_wall(case: &Case, breadth: f64) -> f64 {
    let area: f64 = case.tank.courses.iter().map(|c| c.height * c.thickness * c.material.density).sum();
    area * breadth
}

/// Period of the impulsive mass on the flexible walls [s].
fn wall_period(work: &mut Work, breadth: f64, strip: bool, masses: &Masses) -> f64 {
    let case = work.case;
    let depth = case.liquid.fill_height;
    let clause = work.edition.clause("4.2");
    let sides = if strip { Sides::Strip } else { Sides::Clamped { half_width: 0.5 * breadth } };
    work.sheet.section("Flexible wall");
    work.sheet.given(&[("m_wall", mass_of_one_wall(case, breadth), Mass)]);
    let name = "uniform load of half the impulsive mass and one wall across the motion";
    let formula = "(m_i/2 + m_wall)·g/(b·H)";
    let load = work.sheet.calc("q", name, formula, Stress, &clause);
    let how = if strip { "cantilever in plane strain" } else { "plate clamped at base and sides, free at the top" };
    let d_f = deflection(&case.tank.courses, sides, load, depth, masses.impulsive.lever);
    let name = "deflection on the centre line at z = h_i under q";
    let source = format!("plate theory, {how}");
    work.sheet.look_up("d_f", name, &source, d_f, Length, &clause);
    work.sheet.calc("T_f", "impulsive period", "2·π·√(d_f/g)", Time, &clause)
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
    let sheet = &mut work.sheet;
    sheet.given(&[
        ("A_i", a_i, Acceleration),
        ("A_c1", a_c, Acceleration),
        ("C", field_i.wall(0.0), Dimensionless),
        ("q_c1", field_c.wall(0.0), Dimensionless),
        ("A_v", ground, Acceleration),
    ]);
    sheet.calc("p_i", "impulsive, q_0 = γ·C", "ρ·H·C·A_i", Stress, &clause);
    sheet.calc("p_c", "convective, mode 1", "ρ·L·q_c1·A_c1", Stress, &clause);
    let formula = match method {
        Combination::Abs => "p_i + p_c",
        Combination::Srss => "√(p_i² + p_c²)",
    };
    let combination = work.edition.clause("2.1");
    sheet.calc("p", "horizontal motion", formula, Stress, &combination);
    if work.demand.vertical {
        let (name, clause) = ("vertical motion, rigid", work.edition.clause("2.2"));
        sheet.calc("p_v", name, "ρ·H·A_v", Stress, &clause);
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
    let thickness = case.tank.courses[0].net_thickness();
    work.sheet.given(&[("s", thickness, Length)]);
    work.sheet.section("Bending of the wall (seismic part)");
    let (name, source) = ("clamping moment of one wall, cantilever", "moment of the pressures over the height");
    work.sheet.look_up("m_z", name, source, moment, LineMoment, "statics");
    let name = "bending stress at the base";
    let stress = work.sheet.calc("σ_b", name, "6·m_z/s²", Stress, "statics");
    work.out.values.insert(Quantity::BendingStress, stress);
}

#[cfg(test)]
mod tests;
