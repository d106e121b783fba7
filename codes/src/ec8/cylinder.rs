//! Upright cylinders: the calculation sheet of EN 1998-4:2006 A.2, A.3, A.9, A.10 (ENV 1998-4:1998 annex B alike).
//!
//! Impulsive part: Veletsos' rule, the rigid pressure field with `S_e(T_f)` in place of the ground acceleration, as in
//! the simplified procedure A.3.2.2. Masses and levers come from table A.2 (default, EN only) or from the exact
//! series; profiles over the height always come from the exact pressure fields.

use super::demand::Edition;
use super::flexible::{COEFFICIENT, PERIOD, coupled_mode, equivalent_density_period};
use super::ingredients::{self, Motion, Wall};
use super::shell_mode::Base;
use super::simplified::{self, LIMITS, Row};
use super::work::{DEPTH, MASS, Masses, Ratio, Work};
use super::{bearing, cylinder_checks, cylinder_stress, cylinder_vertical, damage, pipes, sliding, soil, walls};
use crate::mechanical::{Lumped, Plan, eigenvalue, impulsive};
use crate::procedure::CodeError;
use crate::sheet::number;
use tank::case::{Combination, FlexibleImpulsive};
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Argument from which `cosh` and `sinh` are one to the last digit, and which still is far from their overflow.
pub(super) const LARGE: f64 = 300.0;

/// Fills the sheet of a cylinder.
pub(super) fn assess(work: &mut Work, radius: f64) -> Result<(), CodeError> {
    let edition = work.edition;
    let gamma = work.tank("R", "inner radius", radius);
    work.demand.describe(&mut work.sheet);

    let rigid = rigid_tank(work, gamma);
    let [t_c1, t_c2] = [1, 2].map(|n| sloshing_period(work, n));

    let row = table_row(work, gamma);
    let (t_i, mode, wall) = impulsive_period(work, radius, gamma, row)?;
    let t_con = row.map(|row| {
        work.sheet.given(&[("C_c", row.convective_period, Dimensionless)]);
        work.sheet.calc(
            "T_con",
            "convective period of table A.2, C_c in s/√m",
            "C_c·√R",
            Time,
            &edition.clause("3.2.2"),
        )
    });

    work.sheet.section("Spectral accelerations");
    let a_i = work.impulsive("S_e(T_i)", t_i);
    let s_1 = work.convective("S_e(T_c1)", t_c1);
    let s_2 = work.convective("S_e(T_c2)", t_c2);
    let a_c = t_con.map_or(s_1, |t| work.convective("S_e(T_con)", t));
    let wave = work.wave("R", ["0.84", "0.07"], "2.1.4", s_1, s_2);
    if t_con.is_some() {
        work.sheet.given(&[("S_e", a_c, Acceleration)]);
        let name = "wave height of the simplified procedure (all sloshing mass in one mode)";
        let clause = edition.clause("3.2.2");
        work.sheet.calc("d", name, "R·S_e/g", Length, &clause);
        let name = "wave height that the freeboard has to hold, the larger of both clauses";
        let larger = work.sheet.calc("d_f", name, "max(d_max, d)", Length, &clause);
        let other =
            "the larger of A.2.1.4 and A.3.2.2; the sloshing height compared with other methods is that of A.2.1.4";
        work.freeboard(larger, "3.2.2", if larger > wave { other } else { "" });
    } else {
        work.freeboard(wave, "2.1.4", "");
    }

    let masses = match row {
        Some(row) => table_masses(work, row),
        None => rigid,
    };
    let clause = edition.clause(if row.is_some() { "3.2.2" } else { "2.1" });
    let moment = work.resultants(&masses, a_i, a_c, &clause);
    sliding::assess(work);
    if mode.is_some() {
        alternatives(work, a_i, a_c);
    }
    soil::assess(work, &masses, t_i);
    let values = &mut work.out.values;
    values.insert(Quantity::SloshingPeriod, t_c1);
    values.insert(Quantity::ImpulsivePeriod, t_i);
    ingredients::structure(work);
    let motion = Motion { impulsive: (t_i, a_i), convective: (t_con.unwrap_or(t_c1), a_c), sloshing: (t_c1, s_1) };
    ingredients::record(work, &masses, &rigid, &motion, &wall);

    let vertical = cylinder_vertical::assess(work, gamma)?;
    let state = cylinder_stress::assess(work, radius, moment, a_i, s_1, vertical);
    let vertical = vertical.is_some();
    let stresses = state.ingredients(vertical);
    ingredients::stresses(work, &motion, &stresses);
    cylinder_checks::assess(work, &state, vertical);
    damage::assess(work, Some(&state), vertical);
    walls::cylinder(work, &state, vertical);
    bearing::assess(work, state.largest_pressure(0.0, vertical));
    pipes::assess(work);
    Ok(())
}

/// The row of table A.2 if the simplified procedure is asked for and covers H/R.
fn table_row(work: &mut Work, gamma: f64) -> Option<Row> {
    if work.edition != Edition::En2006 || work.case.procedures.ec8_impulsive != FlexibleImpulsive::Simplified {
        return None;
    }
    let row = simplified::table(gamma);
    if row.is_none() {
        work.out.notes.push(format!(
            "H/R = {} lies outside the 0.3 to 3.0 of table A.2 (EN 1998-4:2006 A.3.2.2): masses and levers are those of the \
             exact series A.2.1, the impulsive period that of the coupled shell mode A.3.1.",
            number(gamma)
        ));
    }
    row
}

/// Masses and levers of A.2.1.
fn rigid_tank(work: &mut Work, gamma: f64) -> Masses {
    let rigid = impulsive(Plan::Circle, gamma);
    let series = [
        "series 2·γ·Σ I₁(ν_n/γ)/(ν_n³·I₁′(ν_n/γ)), ν_n = (2n+1)·π/2",
        "series Σ I₁·(ν_n - (-1)ⁿ)/(ν_n⁴·I₁′)/Σ I₁/(ν_n³·I₁′)",
        "series [1/2 + 2·γ·Σ I₁·(ν_n - 2·(-1)ⁿ)/(ν_n⁴·I₁′)]/[2·γ·Σ I₁/(ν_n³·I₁′)]",
    ];
    let clause = work.edition.clause("2.1.2");
    let impulsive = work.rigid_part(rigid, series, &clause);

    let clause = work.edition.clause("2.1.3");
    let [m_c1, _] = [1, 2].map(|n| sloshing_mass(work, n, &clause));
    let [h_c1, h_c1b] =
        [("h_c1", "lever of sloshing mode 1, wall only", 1), ("h_c1′", "lever of sloshing mode 1, wall and base", 2)]
            .map(|(symbol, name, constant)| {
                let formula = if eigenvalue(Plan::Circle, 1) * gamma < LARGE {
                    format!("H·(1 + ({constant} - cosh(λ_1·γ))/(λ_1·γ·sinh(λ_1·γ)))")
                } else {
                    "H·(1 - 1/(λ_1·γ))".into()
                };
                work.sheet.calc(symbol, name, &formula, Length, &clause)
            });
    let convective = Lumped { mass: m_c1, lever: h_c1, lever_with_base: h_c1b };
    Masses { impulsive, convective }
}

/// Mass of a sloshing mode [kg].
fn sloshing_mass(work: &mut Work, n: usize, clause: &str) -> f64 {
    let (symbol, lambda) = (format!("m_c{n}"), format!("λ_{n}"));
    let zero = eigenvalue(Plan::Circle, n);
    work.sheet.input(&lambda, "zero of J₁′", zero, Dimensionless, clause);
    let formula = format!("m·2·tanh({lambda}·γ)/(γ·{lambda}·({lambda}² - 1))");
    let name = format!("mass of sloshing mode {n}");
    work.sheet.calc(&symbol, &name, &formula, Mass, clause)
}

fn sloshing_period(work: &mut Work, n: usize) -> f64 {
    work.sheet.given(&[("λ", eigenvalue(Plan::Circle, n), Dimensionless)]);
    work.sheet.calc(
        &format!("T_c{n}"),
        &format!("period of sloshing mode {n}"),
        "2·π/√(g·λ·tanh(λ·γ)/R)",
        Time,
        &work.edition.clause("2.1.3"),
    )
}

/// Impulsive period [s] by table A.2, by the formula of A.3.1, or of the coupled shell mode, and mass [kg] and levers [m] of
/// that mode where it was computed; and the wall it belongs to.
fn impulsive_period(
    work: &mut Work,
    radius: f64,
    gamma: f64,
    row: Option<Row>,
) -> Result<(f64, Option<Lumped>, Wall), CodeError> {
    let case = work.case;
    let (tank, liquid) = (&case.tank, case.liquid);
    let depth = liquid.fill_height;
    work.sheet.section("Impulsive period");
    let third = tank.course_at(depth / 3.0);
    let clause = work.edition.clause("3.1");
    let formula = (LIMITS.0..=LIMITS.1).contains(&gamma).then(|| {
        let (name, formula) = ("coefficient of the period", COEFFICIENT);
        work.sheet.calc("g_γ", name, formula, Dimensionless, &clause);
        work.sheet.given(&[("E", third.material.youngs_modulus, Stress), ("s_⅓", third.thickness, Length)]);
        let name = "impulsive period by the approximate formula, s_⅓ at z = H/3";
        work.sheet.calc("T_f", name, PERIOD, Time, &clause)
    });
    if let Some(row) = row {
        let (period, uniform) = table_period(work, row);
        return Ok((period, None, uniform));
    }
    if let (Edition::Env1998, FlexibleImpulsive::Simplified, Some(period)) =
        (work.edition, case.procedures.ec8_impulsive, formula)
    {
        let uniform = Wall::Uniform { thickness: third.thickness, modulus: third.material.youngs_modulus };
        return Ok((period, None, uniform));
    }
    let mode = coupled_mode(radius, &tank.courses, liquid, Base::Clamped)?;
    match equivalent_density_period(radius, &tank.courses, liquid) {
        Ok(period) => {
            let name = "period with the equivalent density as printed, for information";
            let source = "dry shell with ρ_eq = p_f/(2·g·s) + ρ_s";
            work.sheet.look_up("T_eq", name, source, period, Time, &clause);
        }
        Err(error) => work.out.notes.push(format!("Equivalent density as printed, for information only: {error}.")),
    }
    let name = "period of the first coupled mode, iterated with the pressure as load";
    let source = format!("first cos θ mode of the clamped shell with p_f, {} rounds of the iteration", mode.rounds);
    let period = work.sheet.look_up("T_f", name, &source, mode.period, Time, &clause);
    let (name, source) = ("participation factor", "integrals over the mode shape");
    let psi = mode.field.participation;
    work.sheet.look_up("ψ", name, source, psi, Dimensionless, &clause);
    let lumped = mode.field.lumped;
    let share = |symbol, source, value| Ratio { symbol, source, value };
    let mass = share("μ_f", "series ψ·γ·Σ (-1)ⁿ·d_n/ν_n", lumped.mass);
    let lever = share("χ_f", "Σ(moment of p_f)/Σ(force of p_f), wall", lumped.lever);
    let source = "Σ(moment of p_f)/Σ(force of p_f), wall and base";
    let lever_with_base = share("χ_f′", source, lumped.lever_with_base);
    let flexible = Lumped {
        mass: work.share(("m_f", "flexible impulsive mass"), MASS, mass, &clause),
        lever: work.share(("h_f", "its lever, wall only"), DEPTH, lever, &clause),
        lever_with_base: work.share(("h_f′", "its lever, wall and base"), DEPTH, lever_with_base, &clause),
    };
    Ok((period, Some(flexible), Wall::Shell))
}

/// `T_imp` of the simplified procedure, and its uniform wall.
fn table_period(work: &mut Work, row: Row) -> (f64, Wall) {
    let case = work.case;
    let depth = case.liquid.fill_height;
    let clause = work.edition.clause("3.2.2");
    let name = "mean thickness of the wetted wall, weighted with the distance from the surface";
    let thickness = simplified::mean_thickness(&mut work.sheet, "s", name, &case.tank, depth, &clause);
    let young = simplified::weighted_mean(&case.tank, depth, |c| c.thickness * c.material.youngs_modulus) / thickness;
    work.sheet.given(&[("E", young, Stress)]);
    let (name, source) = ("coefficient of the impulsive period", "table A.2 at H/R");
    work.sheet.look_up("C_i", name, source, row.impulsive_period, Dimensionless, &clause);
    let period = work.sheet.calc("T_imp", "impulsive period", simplified::PERIOD, Time, &clause);
    let uniform = Wall::Uniform { thickness, modulus: young };
    (period, uniform)
}

/// Lines of the masses and levers of table A.2.
fn table_masses(work: &mut Work, row: Row) -> Masses {
    work.sheet.section("Masses and levers of table A.2");
    let clause = work.edition.clause("3.2.2");
    let mut line = |symbol, name, whole, share, value| {
        let ratio = Ratio { symbol: share, source: "table A.2 at H/R", value };
        work.share((symbol, name), whole, ratio, &clause)
    };
    let m_i = line("m_i", "impulsive mass", MASS, "μ_i", row.impulsive_mass);
    let name = "convective mass, all modes";
    let m_c = line("m_c", name, MASS, "μ_c", row.convective_mass);
    let h_i = line("h_i", "impulsive lever, wall only", DEPTH, "χ_i", row.impulsive_lever);
    let h_c = line("h_c", "convective lever, wall only", DEPTH, "χ_c", row.convective_lever);
    let (name, value) = ("impulsive lever, wall and base", row.impulsive_lever_with_base);
    let h_ib = line("h_i′", name, DEPTH, "χ_i′", value);
    let (name, value) = ("convective lever, wall and base", row.convective_lever_with_base);
    let h_cb = line("h_c′", name, DEPTH, "χ_c′", value);
    work.out.notes.push(
        "Base shear and moments follow table A.2, whose m_c lumps all sloshing modes; pressures, stresses over the height and the \
         wave follow the exact fields A.2.1 with the first sloshing mode."
            .into(),
    );
    Masses {
        impulsive: Lumped { mass: m_i, lever: h_i, lever_with_base: h_ib },
        convective: Lumped { mass: m_c, lever: h_c, lever_with_base: h_cb },
    }
}

/// Base shear and moment by the other two combinations of rigid and flexible parts, for information.
fn alternatives(work: &mut Work, a_i: f64, a_c: f64) {
    work.sheet.given(&[
        ("A_g", work.demand.ground(), Acceleration),
        ("A_i", a_i, Acceleration),
        ("A_c", a_c, Acceleration),
    ]);
    let clause = work.edition.clause("3.1");
    let method = work.case.procedures.ec8_combination;
    work.sheet.section("Other combinations of rigid and flexible parts (information)");
    for (index, name) in
        [("a", "p_i with the ground acceleration and p_f with S_e(T_f)"), ("c", "three masses (Haroun and Housner)")]
    {
        for (symbol, of_i, of_f, of_c, dimension) in
            [("Q", "m_i", "m_f", "m_c1", Force), ("M", "m_i·h_i", "m_f·h_f", "m_c1·h_c1", Moment)]
        {
            let rest = if index == "a" { format!("({of_i}·A_g)²") } else { format!("(({of_i} - {of_f})·A_g)²") };
            let formula = match method {
                Combination::Abs => format!("√({rest} + ({of_f}·A_i)²) + {of_c}·A_c"),
                Combination::Srss => format!("√({rest} + ({of_f}·A_i)² + ({of_c}·A_c)²)"),
            };
            let symbol = format!("{symbol}_{index}");
            let name = format!("{name}, without wall and roof");
            work.sheet.calc(&symbol, &name, &formula, dimension, &clause);
        }
    }
}
