//! Upright cylinders: the calculation sheet of EN 1998-4:2006 A.2, A.3, A.9, A.10 (ENV 1998-4:1998 annex B alike).
//!
//! Impulsive part: Veletsos' rule, the rigid pressure field with `S_e(T_f)` in place of the ground acceleration, which is
//! what the simplified procedure A.3.2.2 does too. Masses and levers come from table A.2 (default, EN only) or from the exact
//! series; profiles over the height always come from the exact pressure fields.

use std::f64::consts::PI;

use super::demand::Edition;
use super::flexible::{FlexibleMode, coupled_mode, equivalent_density_period, period_coefficient, period_formula};
use super::shell_mode::Base;
use super::simplified::{self, LIMITS, Row};
use super::work::{Masses, Work, combined};
use super::{cylinder_stress, cylinder_vertical};
use crate::mechanical::{Lumped, Plan, convective, eigenvalue, impulsive, sloshing_omega};
use crate::procedure::CodeError;
use crate::sheet::number;
use tank::case::{Combination, FlexibleImpulsive};
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Fills the sheet of a cylinder.
pub(super) fn assess(work: &mut Work, radius: f64) -> Result<(), CodeError> {
    let case = work.case;
    let edition = work.edition;
    let depth = case.liquid.fill_height;
    let gamma = depth / radius;
    work.tank("R", "inner radius", radius);
    work.demand.describe(&mut work.sheet);

    let rigid = impulsive(Plan::Circle, gamma);
    let first = convective(Plan::Circle, gamma, 1);
    let second = convective(Plan::Circle, gamma, 2);
    rigid_tank(work, gamma, rigid, first, second);
    let [t_c1, t_c2] = [1, 2].map(|n| sloshing_period(work, n, radius, depth));

    let row = table_row(work, gamma);
    let (t_i, mode) = impulsive_period(work, radius, gamma, row)?;
    let t_con = row.map(|row| {
        let terms = [("C_c", row.convective_period, Dimensionless), ("R", radius, Length)];
        work.sheet.calc(
            "T_con",
            "convective period of table A.2, C_c in s/√m",
            "C_c·√R",
            &terms,
            row.convective_period * radius.sqrt(),
            Time,
            &edition.clause("3.2.2"),
        )
    });

    work.sheet.section("Spectral accelerations");
    let damping = case.damping;
    let a_i = work
        .demand
        .impulsive(&mut work.sheet, &mut work.out.notes, "S_e(T_i)", t_i, damping.impulsive);
    let s_1 = work.demand.convective(
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
    let a_c = match t_con {
        Some(t) => work
            .demand
            .convective(&mut work.sheet, &mut work.out.notes, "S_e(T_con)", t, damping.sloshing),
        None => s_1,
    };
    work.wave("R", 0.84, "2.1.4", s_1, Some((0.07, s_2)));
    if t_con.is_some() {
        let terms = [
            ("R", radius, Length),
            ("S_e", a_c, Acceleration),
            ("g", case.gravity, Acceleration),
        ];
        work.sheet.calc(
            "d",
            "wave height of the simplified procedure (all sloshing mass in one mode), for information",
            "R·S_e/g",
            &terms,
            radius * a_c / case.gravity,
            Length,
            &edition.clause("3.2.2"),
        );
    }

    let masses = match row {
        Some(row) => Masses::of(case, table_lumped(row)),
        None => Masses::of(case, [rigid, first]),
    };
    if row.is_some() {
        table_masses(work, &masses);
    }
    let clause = edition.clause(if row.is_some() { "3.2.2" } else { "2.1" });
    let moment = work.resultants(&masses, a_i, a_c, &clause);
    if let Some(mode) = &mode {
        alternatives(work, mode, rigid, first, a_i, a_c);
    }
    let values = &mut work.out.values;
    values.insert(Quantity::SloshingPeriod, t_c1);
    values.insert(Quantity::ImpulsivePeriod, t_i);

    let motion = cylinder_vertical::assess(work, radius, gamma)?;
    cylinder_stress::assess(work, radius, moment, a_i, s_1, motion);
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

fn table_lumped(row: Row) -> [Lumped; 2] {
    [
        Lumped {
            mass: row.impulsive_mass,
            lever: row.impulsive_lever,
            lever_with_base: row.impulsive_lever_with_base,
        },
        Lumped {
            mass: row.convective_mass,
            lever: row.convective_lever,
            lever_with_base: row.convective_lever_with_base,
        },
    ]
}

/// Masses and levers of A.2.1.
fn rigid_tank(work: &mut Work, gamma: f64, rigid: Lumped, first: Lumped, second: Lumped) {
    let depth = work.case.liquid.fill_height;
    let mass = work.case.liquid_mass();
    work.sheet.section("Liquid in a rigid tank");
    let clause = work.edition.clause("2.1.2");
    work.ratio(
        ("m_i", "impulsive mass"),
        "m·2·γ·Σ I₁(ν_n/γ)/(ν_n³·I₁′(ν_n/γ)), ν_n = (2n+1)·π/2",
        ("m", mass, Mass),
        rigid.mass,
        &clause,
    );
    work.ratio(
        ("h_i", "impulsive lever, wall only"),
        "H·Σ I₁·(ν_n - (-1)ⁿ)/(ν_n⁴·I₁′)/Σ I₁/(ν_n³·I₁′)",
        ("H", depth, Length),
        rigid.lever,
        &clause,
    );
    work.ratio(
        ("h_i′", "impulsive lever, wall and base"),
        "H·[1/2 + 2·γ·Σ I₁·(ν_n - 2·(-1)ⁿ)/(ν_n⁴·I₁′)]/[2·γ·Σ I₁/(ν_n³·I₁′)]",
        ("H", depth, Length),
        rigid.lever_with_base,
        &clause,
    );
    let clause = work.edition.clause("2.1.3");
    for (n, part) in [(1, first), (2, second)] {
        let lambda = format!("λ_{n}");
        work.sheet.input(
            &lambda,
            "zero of J₁′",
            eigenvalue(Plan::Circle, n),
            Dimensionless,
            &clause,
        );
        let formula = format!("m·2·tanh({lambda}·γ)/(γ·{lambda}·({lambda}² - 1))");
        let terms = [
            ("m", mass, Mass),
            ("γ", gamma, Dimensionless),
            (lambda.as_str(), eigenvalue(Plan::Circle, n), Dimensionless),
        ];
        let symbol = format!("m_c{n}");
        work.sheet.calc(
            &symbol,
            &format!("mass of sloshing mode {n}"),
            &formula,
            &terms,
            part.mass * mass,
            Mass,
            &clause,
        );
    }
    for (symbol, name, ratio, constant) in [
        ("h_c1", "lever of sloshing mode 1, wall only", first.lever, "1"),
        (
            "h_c1′",
            "lever of sloshing mode 1, wall and base",
            first.lever_with_base,
            "2",
        ),
    ] {
        let formula = format!("H·(1 + ({constant} - cosh(λ_1·γ))/(λ_1·γ·sinh(λ_1·γ)))");
        let terms = [
            ("H", depth, Length),
            ("γ", gamma, Dimensionless),
            ("λ_1", eigenvalue(Plan::Circle, 1), Dimensionless),
        ];
        work.sheet
            .calc(symbol, name, &formula, &terms, ratio * depth, Length, &clause);
    }
}

fn sloshing_period(work: &mut Work, n: usize, radius: f64, depth: f64) -> f64 {
    let lambda = eigenvalue(Plan::Circle, n);
    let terms = [
        ("g", work.case.gravity, Acceleration),
        ("λ", lambda, Dimensionless),
        ("R", radius, Length),
        ("γ", depth / radius, Dimensionless),
    ];
    let omega = sloshing_omega(Plan::Circle, n, radius, depth, work.case.gravity);
    work.sheet.calc(
        &format!("T_c{n}"),
        &format!("period of sloshing mode {n}"),
        "2·π/√(g·λ·tanh(λ·γ)/R)",
        &terms,
        2.0 * PI / omega,
        Time,
        &work.edition.clause("2.1.3"),
    )
}

/// Impulsive period by table A.2, by the formula of A.3.1, or of the coupled shell mode, and that mode where it was computed.
fn impulsive_period(
    work: &mut Work,
    radius: f64,
    gamma: f64,
    row: Option<Row>,
) -> Result<(f64, Option<FlexibleMode>), CodeError> {
    let case = work.case;
    let (tank, liquid) = (&case.tank, case.liquid);
    let depth = liquid.fill_height;
    work.sheet.section("Impulsive period");
    let third = tank.course_at(depth / 3.0);
    let terms = [
        ("γ", gamma, Dimensionless),
        ("R", radius, Length),
        ("ρ", liquid.density, Density),
        ("H", depth, Length),
        ("E", third.material.youngs_modulus, Stress),
        ("s_⅓", third.thickness, Length),
        ("g_γ", period_coefficient(gamma), Dimensionless),
    ];
    let clause = work.edition.clause("3.1");
    let formula = (LIMITS.0..=LIMITS.1).contains(&gamma).then(|| {
        let formula = "0.01675·γ² - 0.15·γ + 0.46";
        work.sheet.calc(
            "g_γ",
            "coefficient of the period",
            formula,
            &terms,
            period_coefficient(gamma),
            Dimensionless,
            &clause,
        );
        let young = third.material.youngs_modulus;
        work.sheet.calc(
            "T_f",
            "impulsive period by the approximate formula, s_⅓ at z = H/3",
            "2·R/g_γ·√(ρ·H/(E·s_⅓))",
            &terms,
            period_formula(radius, depth, liquid.density, young, third.thickness),
            Time,
            &clause,
        )
    });
    if let Some(row) = row {
        return Ok((table_period(work, radius, row), None));
    }
    if let (Edition::Env1998, FlexibleImpulsive::Simplified, Some(period)) =
        (work.edition, case.procedures.ec8_impulsive, formula)
    {
        return Ok((period, None));
    }
    let mode = coupled_mode(radius, &tank.courses, liquid, Base::Clamped)?;
    match equivalent_density_period(radius, &tank.courses, liquid) {
        Ok(period) => {
            work.sheet.step(
                "T_eq",
                "period with the equivalent density as printed, for information",
                "dry shell with ρ_eq = p_f/(2·g·s) + ρ_s",
                "",
                period,
                Time,
                &clause,
            );
        }
        Err(error) => work
            .out
            .notes
            .push(format!("Equivalent density as printed, for information only: {error}.")),
    }
    work.sheet.step(
        "T_f",
        "period of the first coupled mode, iterated with the pressure as load",
        "2·π/ω_f, first cos θ mode of the clamped shell with p_f",
        &format!("{} rounds", mode.rounds),
        mode.period,
        Time,
        &clause,
    );
    work.sheet.input(
        "ψ",
        "participation factor",
        mode.field.participation,
        Dimensionless,
        &clause,
    );
    let lumped = mode.field.lumped;
    work.ratio(
        ("m_f", "flexible impulsive mass"),
        "m·ψ·γ·Σ (-1)ⁿ·d_n/ν_n",
        ("m", case.liquid_mass(), Mass),
        lumped.mass,
        &clause,
    );
    for (symbol, name, value) in [
        ("h_f", "its lever, wall only", lumped.lever),
        ("h_f′", "its lever, wall and base", lumped.lever_with_base),
    ] {
        let formula = "H·Σ(moment of p_f)/Σ(force of p_f)";
        work.ratio((symbol, name), formula, ("H", depth, Length), value, &clause);
    }
    Ok((mode.period, Some(mode)))
}

/// `T_imp` of the simplified procedure.
fn table_period(work: &mut Work, radius: f64, row: Row) -> f64 {
    let case = work.case;
    let depth = case.liquid.fill_height;
    let clause = work.edition.clause("3.2.2");
    let thickness = simplified::weighted_mean(&case.tank, depth, |c| c.thickness);
    let young = simplified::weighted_mean(&case.tank, depth, |c| c.thickness * c.material.youngs_modulus) / thickness;
    work.sheet.step(
        "s",
        "mean thickness of the wetted wall, weighted with the distance from the surface",
        "2/H²·∫(H - z)·s·dz",
        "",
        thickness,
        Length,
        &clause,
    );
    let terms = [
        ("C_i", row.impulsive_period, Dimensionless),
        ("ρ", case.liquid.density, Density),
        ("H", depth, Length),
        ("s", thickness, Length),
        ("R", radius, Length),
        ("E", young, Stress),
    ];
    work.sheet.input(
        "C_i",
        "coefficient of table A.2",
        row.impulsive_period,
        Dimensionless,
        &clause,
    );
    work.sheet.calc(
        "T_imp",
        "impulsive period",
        "C_i·√(ρ)·H/(√(s/R)·√(E))",
        &terms,
        simplified::impulsive_period(
            row.impulsive_period,
            case.liquid.density,
            depth,
            radius,
            thickness,
            young,
        ),
        Time,
        &clause,
    )
}

/// Lines of the masses and levers of table A.2.
fn table_masses(work: &mut Work, masses: &Masses) {
    work.sheet.section("Masses and levers of table A.2");
    let clause = work.edition.clause("3.2.2");
    let mass = work.case.liquid_mass();
    let depth = work.case.liquid.fill_height;
    let (i, c) = (masses.impulsive, masses.convective);
    for (symbol, name, value) in [
        ("m_i", "impulsive mass", i.mass),
        ("m_c", "convective mass, all modes", c.mass),
    ] {
        work.ratio((symbol, name), "m·table A.2", ("m", mass, Mass), value / mass, &clause);
    }
    for (symbol, name, value) in [
        ("h_i", "impulsive lever, wall only", i.lever),
        ("h_c", "convective lever, wall only", c.lever),
        ("h_i′", "impulsive lever, wall and base", i.lever_with_base),
        ("h_c′", "convective lever, wall and base", c.lever_with_base),
    ] {
        work.ratio(
            (symbol, name),
            "H·table A.2",
            ("H", depth, Length),
            value / depth,
            &clause,
        );
    }
    work.out.notes.push(
        "Base shear and moments follow table A.2, whose m_c lumps all sloshing modes; pressures, stresses over the height and the \
         wave follow the exact fields A.2.1 with the first sloshing mode."
            .into(),
    );
}

/// Base shear and moment by the other two combinations of rigid and flexible parts, for information.
fn alternatives(work: &mut Work, mode: &FlexibleMode, rigid: Lumped, first: Lumped, a_i: f64, a_c: f64) {
    let case = work.case;
    let (m, h) = (case.liquid_mass(), case.liquid.fill_height);
    let ground = work.demand.ground();
    let clause = work.edition.clause("3.1");
    let f = mode.field.lumped;
    let method = case.procedures.ec8_combination;
    let srss = |a: f64, b: f64| combined(Combination::Srss, a, b);
    let convective = [first.mass * m * a_c, first.mass * first.lever * m * h * a_c];
    work.sheet
        .section("Other combinations of rigid and flexible parts (information)");
    let two = [
        srss(rigid.mass * ground, f.mass * a_i) * m,
        srss(rigid.mass * rigid.lever * ground, f.mass * f.lever * a_i) * m * h,
    ];
    let rest_moment = rigid.mass * rigid.lever - f.mass * f.lever;
    let three = [
        srss((rigid.mass - f.mass) * ground, f.mass * a_i) * m,
        srss(rest_moment * ground, f.mass * f.lever * a_i) * m * h,
    ];
    for (index, name, impulsive, formula) in [
        (
            "a",
            "p_i with the ground acceleration and p_f with S_e(T_f)",
            two,
            "√((x_i·a_g)² + (x_f·S_e)²)",
        ),
        (
            "c",
            "three masses (Haroun and Housner)",
            three,
            "√(((x_i - x_f)·a_g)² + (x_f·S_e)²)",
        ),
    ] {
        for (k, symbol, dimension) in [(0, "Q", Force), (1, "M", Moment)] {
            work.sheet.step(
                &format!("{symbol}_{index}"),
                &format!("{name}, without wall and roof"),
                &format!("{formula} with the convective part"),
                "",
                combined(method, impulsive[k], convective[k]),
                dimension,
                &clause,
            );
        }
    }
}
