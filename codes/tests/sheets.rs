//! Goal:  every line of every calculation sheet over a wide family of tanks, sites and records: each formula can be
//!        computed, whatever the branch, and each branch is reached
//! Model: [`family`]

mod family;

use std::collections::BTreeSet;

use codes::ALL;
use codes::procedure::CodeError;
use rayon::prelude::*;
use tank::Case;
use tank::assessment::{Excitation, Step};
use tank::formula::Formula;

/// All lines of a procedure; none where it does not apply or the data are inadmissible for it.
fn lines(case: &Case, mut each: impl FnMut(&str, &Step)) {
    for procedure in ALL {
        for excitation in [Excitation::Record, Excitation::Site] {
            match procedure.assess(case, excitation) {
                Ok(out) => out.steps.iter().for_each(|step| each(procedure.id(), step)),
                Err(CodeError::NotApplicable(_) | CodeError::Data { .. } | CodeError::NotConverged { .. }) => {}
                Err(error @ CodeError::Formula(_)) => panic!("{}: {error}", procedure.id()),
            }
        }
    }
}

#[test]
fn every_line_is_what_it_says_and_every_branch_is_reached() {
    let cases: Vec<Case> = family::cases().collect();
    let checked = |case: &Case| {
        let (mut count, mut seen) = (0, BTreeSet::new());
        lines(case, |id, step| {
            count += 1;
            let of = format!("{id}, {}, {}: {step:?}", step.section, step.symbol);
            assert!(!step.section.is_empty() && !step.name.is_empty() && !step.clause.is_empty(), "{of}");
            assert!(!step.value.is_nan(), "{of}");
            assert!(step.formula.is_empty() || step.look_up.is_empty(), "{of}");
            assert_eq!(step.formula.is_empty(), step.substitution.is_empty(), "{of}");
            if !step.formula.is_empty() {
                // The substitution has numbers only, so that a reader can evaluate the line.
                Formula::parse(&step.substitution).expect(&of).value(&[]).expect(&of);
                seen.insert((id.to_string(), step.formula.clone()));
            }
        });
        (count, seen)
    };
    let (count, seen) = cases.par_iter().map(checked).reduce(Default::default, |a, b| (a.0 + b.0, &a.1 | &b.1));
    assert!(count > 90_000, "{count} lines");
    for (id, formulas) in BRANCHES {
        for formula in formulas {
            assert!(seen.contains(&(id.to_string(), formula.to_string())), "{id}: {formula}");
        }
    }
}

/// A shallow and a very slender tank: `cosh` and Bessel functions of large arguments overflow, the values must not.
#[test]
fn extreme_proportions() {
    for slenderness in [0.0015, 400.0] {
        let case = family::of_slenderness(slenderness);
        lines(&case, |id, step| {
            assert!(step.value.is_finite(), "{id}, H/R = {slenderness}: {step:?}");
        });
    }
}

/// Formulas that hold on one branch only.
const BRANCHES: [(&str, &[&str]); 8] = [
    (
        "housner",
        &[
            "P_i",
            "P_i + P_r",
            "m·H_r/H",
            "m_b·r",
            "Q_i + Q_k",
            "√(Q_i² + Q_k²)",
            "k/c_t",
            "c_d·R/tanh(x)/(g/(ω²·θ_h·R) − 1)",
            "d_lin",
            "M/2/(b·s²/6)",
        ],
    ),
    (
        "ec8-env",
        &[
            "0.7·a_g·S",
            "a_g·S·(1 + T/T_B·(2.5·η - 1))/q",
            "a_g·S·2.5·η/q",
            "a_g·S·2.5·η·T_C/T",
            "a_g·S·2.5·η·T_C·T_D/T²",
            "2·R/g_γ·√(ρ·H/(E·s_⅓))",
            "6·m_z/s²",
        ],
    ),
    (
        "ec8-2006",
        &[
            "k_v·a_g",
            "S_De·(2·π/T)²",
            "S_De·(2·π/T)²/q",
            "0.025·a_g·S·T_C·T_D·2.5·η",
            "0.025·a_g·S·T_C·T_D·(2.5·η + (T - T_E)/(T_F - T_E)·(1 - 2.5·η))",
            "0.025·a_g·S·T_C·T_D",
            "C_i·√(ρ)·H/(√(s/R)·√(E))",
            "m·μ_c",
            "√(((m_i - m_f)·A_g)² + (m_f·A_i)²) + m_c1·A_c",
            "√(((m_i - m_f)·A_g)² + (m_f·A_i)² + (m_c1·A_c)²)",
            "1",
            "1.078 + 0.274·ln(γ)",
            "√(p_vr² + p_vf²)",
            "n_z - N_0",
            "max(n_z - N_0·(1 - 0.3·A_v/g), 0.3·n_z - N_0·(1 - A_v/g))",
            "min(t_b·√(p·f_y), 0.02·D·p)",
            "w_t + 4·M/(π·D²)",
            "y·(w_t + w_L) - w_L",
            "f_y·(1 - λ2/4)",
            "k_s·σ_c1",
            "σ_c1",
            "0 MPa",
        ],
    ),
    (
        "aci350-2006",
        &[
            "(0.5 - 0.09375·r)·H",
            "0.375·H",
            "0.45·H",
            "2·π·H/(C_l·√(E/ρ_w))",
            "√(8·π·(m_w + m_r + m_i)/(D·k_a))",
            "2·π·√((m′_w + m′_i)/k)",
            "S_DS",
            "S_D1/T_i",
            "2.4·S_DS/T_c²",
            "min(1.5·S_D1/T_c, 1.5·S_DS)",
            "0.4·S_DS",
            "min(1, 0.0151·r² - 0.1908·r + 1.021)",
            "0 MPa",
            "A_c·g·m_c/2·(4·H - 6·h_c)/H²·32/(9·π·D)",
            "A_c·g·m_c/2·(4·H - 6·h_c)/H²/B",
            "A_i·g·(m_i·h_i′ + ε·m_w·h_w + m_r·h_r)",
        ],
    ),
    (
        "is1893-2014",
        &[
            "1/(√(x)·(0.46 - 0.3·x + 0.067·x²))",
            "2·π·√(d/g)",
            "min(2.5, 1/T_c)",
            "min(2.5, 1.36/T_c)",
            "min(2.5, 1.67/T_c)",
            "0.25",
            "0.34",
            "0.42",
            "0.5625·(1 - 1/3)/cosh(3.674/r)·A_c·ρ·g·D",
            "0.4165/cosh(3.162/r)·A_c·ρ·g·L",
        ],
    ),
    ("national", &["γ·S_i/R_i", "γ·k·S_c/R_c", "k_v·γ·S_0"]),
    (
        "api650-1993",
        &[
            "W_p·tanh(0.866·D/H)/(0.866·D/H)",
            "W_p·(1 - 0.218·D/H)",
            "0.75·S/T",
            "3.375·S/T²",
            "w_t + 1.273·M/D²",
            "y·(w_t + w_L) - w_L",
            "1.273·M/D² - w_t",
            "w_AB·π·D/n_A",
            "83 GPa·t_s/D",
            "min(83 GPa·t_s/D, 0.5·F_ty)",
            "min(83 GPa·t_s/(2.5·D) + 7.5 MPa·√(G·H), 0.5·F_ty)",
        ],
    ),
    (
        "api650-2020",
        &[
            "0.375·(1 + 1.333·(0.866·D/H/tanh(0.866·D/H) - 1))·H",
            "(0.5 + 0.06·D/H)·H",
            "C_i·H·√(ρ)/√(2·t_u/D·E)",
            "max(S_DS·I/R_wi, 0.5·S_1·I/R_wi, 0.007)",
            "max(S_DS·I/R_wi, 0.007)",
            "max(max(S_DS, 2.5·Q·F_a·S_0)·I/R_wi, 0.5·S_1·I/R_wi, 0.007)",
            "max(max(S_DS, 2.5·Q·F_a·S_0)·I/R_wi, 0.007)",
            "min(K·S_D1/T_c·I/R_wc, A_i)",
            "min(K·S_D1·T_L/T_c²·I/R_wc, A_i)",
            "0.47·S_DS",
            "K·S_D1/T_c",
            "K·S_D1·T_L/T_c²",
            "K·S_D1·I/T_c",
            "K·S_D1·I·4 s/T_c²",
            "A_c",
            "8480·A_i·G·D·H·(Y/H - 0.5·(Y/H)²)·tanh(0.866·D/H)",
            "5220·A_i·G·D²·(Y/(0.75·D) - 0.5·(Y/(0.75·D))²)",
            "2600·A_i·G·D²",
            "√(N_i² + N_c²)/t",
            "(N_h + √(N_i² + N_c² + (A_v·N_h/2.5)²))/t",
            "M_rw/(D²·(w_t·(1 - 0.4·A_v) + w_a - 0.4·w_int))",
            "∞",
            "max(min(0.01723·t·√(F_y/(H·G_e)), 0.035·D), 0.45 m)",
            "12.1·10⁻¹²·F_y·L²/t_a",
            "(w_t·(1 + 0.4·A_v) + 1.273·M_rw/D²)/t_s",
            "((w_t·(1 + 0.4·A_v) + w_a)/(0.607 - 0.18667·J^2.3) - w_a)/t_s",
            "1.273·M_rw/D² - w_t·(1 - 0.4·A_v) + P·D/4",
            "μ·(W_s + W_r + W_f + W_p)·(1 - 0.4·A_v)",
        ],
    ),
];
