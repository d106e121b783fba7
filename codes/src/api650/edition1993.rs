//! Appendix E of the 9th edition (1993): overturning moment, hold-down, shell compression.
//!
//! ```text
//! M = Z I (C_1 W_s X_s + C_1 W_r H_t + C_1 W_1 X_1 + C_2 W_2 X_2)
//! C_1 = 0.60      C_2 = 0.75 S/T  (T ≤ 4.5 s),  3.375 S/T²  above      T = k √D[ft]
//! ```
//!
//! * [`Excitation::Site`]: zone method, needs `zone_factor` in the site data.
//! * [`Excitation::Record`]: the spectrum alternative of E.3.3. `Z I C_1` becomes the largest spectral acceleration in the
//!   impulsive range at 2 % damping (`plateau`), `Z I C_2` becomes S_a(T) at 0.5 % damping. The appendix fixes
//!   both damping ratios.
//!
//! The ratio `x = M/(D² (w_t + w_L))` gives the shell compression b per length: the linear `w_t + 1.273 M/D²` up to 0.785
//! or if anchored, figure E-5 (exact, [`super::hold_down::figure_e5`]) up to 1.5, the printed formula up to 1.57.
//!
//! The appendix does not cover base shear, moment with base pressure, wave height and vertical motion.

mod limit_states;

use super::edition2020::limit_states::COMPRESSION;
use crate::base_state::BaseState;
use crate::lifted;
use crate::limit_state::LimitStateDef;
use crate::procedure::{CodeError, Label, Procedure};
use crate::roof::SNOW_OF_API;
use crate::sheet::Sheet;
use tank::assessment::{Assessment, CheckStatus, Excitation, NotApplicable};
use tank::case::{Case, Combination};
use tank::factor::Factor;
use tank::formula::evaluate;
use tank::ingredients::{Ingredients, Ordinate, Rule, Share};
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Moment, Stress, Time};

use super::basis::Basis;
use super::hold_down as hd;
use super::ingredients::{Action, Liquid, axial, ladders, resultant};
use super::masses::{ARGUMENT, COEFFICIENT_1993, PERIOD_1993, charts};
use crate::ordinates::{IMPULSIVE_RANGE, plateau, psa};

const EDITION: &str = "API 650:1993";
const E3_1: &str = "API 650:1993 E.3.1";
const E3_2: &str = "API 650:1993 E.3.2, figures E-2, E-3";
const E3_3: &str = "API 650:1993 E.3.3";
const E4: &str = "API 650:1993 E.4";
const E5_1: &str = "API 650:1993 E.5.1, figure E-5";
const E5_2: &str = "API 650:1993 E.5.2";
const E5_3: &str = "API 650:1993 E.5.3";
const E6: &str = "API 650:1993 E.6";

/// Lateral force coefficient C_1.
const C_1: f64 = 0.60;
/// Damping ratios of the spectrum alternative.
const DAMPING: (f64, f64) = (0.02, 0.005);

/// Appendix E, 9th edition (`api650-1993`).
#[derive(Clone, Copy, Debug)]
pub struct Api6501993;

/// Lateral force coefficient C_2 of the sloshing mass.
///
/// * `soil_factor`: S, 1.0 to 2.0
/// * `period`: T [s]
pub fn convective_coefficient(soil_factor: f64, period: f64) -> f64 {
    evaluate(convective_formula(period), &[("S", soil_factor), ("T", period)])
}

/// Formula of C_2 for a period [s].
fn convective_formula(period: f64) -> &'static str {
    if period <= 4.5 { "0.75·S/T" } else { "3.375·S/T²" }
}

/// Moment of shell, roof and W_1 [N·m]: a_1 is Z I C_1, or the spectral acceleration in its place.
pub(super) const IMPULSIVE_MOMENT: &str = "a_1·(W_s·X_s + W_r·H_t + W_1·X_1)";
/// Moment of W_2 [N·m]: a_2 is Z I C_2, or the spectral acceleration in its place.
pub(super) const CONVECTIVE_MOMENT: &str = "a_2·W_2·X_2";

/// Accelerations in g that multiply the impulsive and the convective weights.
struct Coefficients {
    impulsive: f64,
    convective: f64,
}

impl Procedure for Api6501993 {
    fn id(&self) -> &'static str {
        "api650-1993"
    }

    fn label(&self) -> Label {
        Label {
            title: "API 650, appendix E (9th edition, 1993, superseded)",
            short: "API 650, 9th ed.",
            figure_key: "k-api650-1993",
        }
    }

    /// It knows them and requires none: a superseded edition gives comparisons, not a verdict.
    fn table(&self) -> &'static [LimitStateDef] {
        limit_states::TABLE
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        Basis::new(case, EDITION)?;
        let reason = match excitation {
            Excitation::Record if case.ground_motion.is_none() => "no record given",
            Excitation::Site if case.site.api650.is_none() && case.site.zone.is_none() => "`site.api650` is not given",
            Excitation::Site if case.site.zone().is_none() => {
                "`site.api650.zone_factor` is not given, which the zone method needs"
            }
            _ => return Ok(()),
        };
        Err(NotApplicable { clause: E3_3.into(), reason: reason.into() })
    }

    fn snow_share(&self, _case: &Case) -> f64 {
        SNOW_OF_API
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        self.covers(case, excitation)?;
        let case = &*case.with_snow(self.snow_share(case));
        let basis = Basis::new(case, EDITION)?;
        let mut sheet = Sheet::new();
        let mut out = Assessment::default();
        basis.assumptions(&mut out, false);
        if case.tank.roof.snow.is_some() {
            let text = "The 9th edition leaves the portion of the snow in W_r to the purchaser; it is 10 % here, as in the current annex.";
            out.assumptions.push(text.into());
        }
        let shell_height = case.tank.wall_height();
        basis.inputs(&mut sheet, ("H_t", shell_height));

        let masses = masses(&basis, &mut sheet, &mut out);
        let period = masses.period;
        let c = coefficients(&basis, excitation, period, &mut sheet, &mut out)?;
        let moment = moment(&c, &mut sheet);
        let name = "axial membrane stress of the moment, linear over the section";
        let axial = sheet.calc("σ_M", name, "1.273·M/D²/t_s", Stress, E5_2);
        resistance(&basis, moment, &mut sheet, &mut out);

        let g = case.gravity;
        out.values.extend([
            (Quantity::SloshingPeriod, period),
            (Quantity::ImpulsiveMass, masses.impulsive.0 / g),
            (Quantity::WallMass, basis.w_s / g),
            (Quantity::ConvectiveMass, masses.convective.0 / g),
            (Quantity::BaseMoment, moment),
            (Quantity::AxialMembraneStress, axial),
        ]);
        if basis.w_r > 0.0 {
            out.values.insert(Quantity::RoofMass, basis.w_r / g);
        }
        out.ingredients = ingredients(&basis, excitation, &masses, &c, shell_height);
        BaseState::on_anchors(&out.checks).follow(&mut out.checks);
        out.steps = sheet.into_steps()?;
        Ok(out)
    }
}

/// Weights [N] and heights [m] of the liquid's parts, and the sloshing period [s].
struct Masses {
    impulsive: (f64, f64),
    convective: (f64, f64),
    period: f64,
}

/// Effective masses and sloshing period with their lines.
fn masses(basis: &Basis, sheet: &mut Sheet, out: &mut Assessment) -> Masses {
    let Basis { d, h, .. } = *basis;
    let charts = charts(d / h);
    sheet.section("Effective masses");
    let w_1 = sheet.calc("W_1", "impulsive weight", charts.w_i, Force, E3_2);
    let w_2 = sheet.calc("W_2", "convective weight", charts.w_c, Force, E3_2);
    let x_1 = sheet.calc("X_1", "height of W_1", charts.x_i, Length, E3_2);
    let name = "argument of the sloshing mode";
    sheet.calc("u", name, ARGUMENT, Dimensionless, E3_2);
    let x_2 = sheet.calc("X_2", "height of W_2", charts.x_c, Length, E3_2);
    let (name, figure) = ("sloshing coefficient", "API 650:1993 E.3.3, figure E-4");
    sheet.calc("k", name, COEFFICIENT_1993, Dimensionless, figure);
    let name = "period of the first sloshing mode";
    let period = sheet.calc("T", name, PERIOD_1993, Time, E3_3);
    out.assumptions
        .push("The 9th edition has the masses as charts; the closed forms are those of the current annex.".into());
    Masses { impulsive: (w_1, x_1), convective: (w_2, x_2), period }
}

/// Coefficients of the zone method or of the record's spectrum, with their lines.
fn coefficients(
    basis: &Basis,
    excitation: Excitation,
    period: f64,
    sheet: &mut Sheet,
    out: &mut Assessment,
) -> Result<Coefficients, CodeError> {
    sheet.section("Ground motion");
    let case = basis.case;
    match (excitation, &case.ground_motion, case.site.zone()) {
        (Excitation::Record, Some(motion), _) => {
            let record = &motion.horizontal;
            let (at, largest) = plateau(record, DAMPING.0);
            let source = format!("{E3_3}, spectrum of `{}`", record.name);
            let impulsive = sheet.input(
                "A_1",
                &format!("largest spectral acceleration, 2 % damping, at T = {at:.3} s [g]"),
                largest / case.gravity,
                Dimensionless,
                &source,
            );
            let convective = sheet.input(
                "A_2",
                "spectral acceleration at T, 0.5 % damping [g]",
                psa(record, period, DAMPING.1) / case.gravity,
                Dimensionless,
                &source,
            );
            out.assumptions.push(format!(
                "Z·I·C_1 is the largest spectral acceleration of the record at T = 0 and between {} and {} s, 2 % damping; \
                 Z·I·C_2 is its value at T, 0.5 % damping. I = 1.",
                IMPULSIVE_RANGE.0, IMPULSIVE_RANGE.1
            ));
            let damping = case.damping;
            if (damping.impulsive, damping.sloshing) != DAMPING {
                out.notes.push(format!(
                    "The appendix fixes 2 % and 0.5 % damping; the case has {} % (impulsive) and {} % (sloshing).",
                    100.0 * damping.impulsive,
                    100.0 * damping.sloshing
                ));
            }
            Ok(Coefficients { impulsive, convective })
        }
        (Excitation::Site, _, Some(site)) => {
            let (z, s, i) = (site.zone_factor, site.soil_factor, site.importance);
            for (key, value, least, most) in
                [("zone_factor", z, 0.0, 1.0), ("soil_factor", s, 1.0, 2.0), ("importance_1993", i, 1.0, 1.5)]
            {
                if !(least..=most).contains(&value) {
                    return Err(CodeError::Data {
                        clause: format!("{E3_3} (site.api650.{key})"),
                        reason: format!("found {value}, allowed {least} to {most}"),
                    });
                }
            }
            for (symbol, name, value, table) in [
                ("Z", "zone factor", z, "table E-2"),
                ("I", "importance factor", i, "E.3.1"),
                ("S", "site amplification", s, "table E-3"),
                ("C_1", "lateral force coefficient, impulsive", C_1, "E.3.3"),
            ] {
                sheet.input(symbol, name, value, Dimensionless, &format!("{EDITION} {table}"));
            }
            let name = "lateral force coefficient, convective";
            let c_2 = sheet.calc("C_2", name, convective_formula(period), Dimensionless, E3_3);
            if ![0.0, 0.075, 0.15, 0.20, 0.30, 0.40].contains(&z) {
                out.notes
                    .push(format!("Z = {z} is not a zone factor of table E-2 (0, 0.075, 0.15, 0.20, 0.30, 0.40)."));
            }
            Ok(Coefficients { impulsive: z * i * C_1, convective: z * i * c_2 })
        }
        // `applies` has asked before.
        _ => Err(CodeError::Data { clause: E3_3.into(), reason: "neither record nor site data".into() }),
    }
}

/// The ingredients of moment, masses and sloshing period.
fn ingredients(
    basis: &Basis,
    excitation: Excitation,
    masses: &Masses,
    c: &Coefficients,
    shell_height: f64,
) -> Vec<Ingredients> {
    let g = basis.case.gravity;
    let (m_1, m_2) = (masses.impulsive.0 / g, masses.convective.0 / g);
    let (a_1, a_2) = (c.impulsive * g, c.convective * g);
    let impulsive = Ordinate { rule: Rule::Plateau, ..Ordinate::at(0.0, DAMPING.0, a_1) };
    let convective = Ordinate::at(masses.period, DAMPING.1, a_2);
    let (impulsive, convective) = match (excitation, &basis.case.ground_motion, basis.case.site.api650) {
        (Excitation::Site, _, Some(site)) => {
            let importance = (Factor::Importance, site.importance_1993);
            let long = (Factor::LongPeriod, (4.5 / masses.period).min(1.0));
            let impulsive = Ordinate { period: None, ..impulsive.split(&[importance]) };
            (impulsive, convective.split(&[long, importance]))
        }
        (_, Some(motion), _) => {
            let period = Some(plateau(&motion.horizontal, DAMPING.0).0);
            (Ordinate { period, ..impulsive }, convective)
        }
        _ => return Vec::new(),
    };
    let action = Action { impulsive, convective, combination: Combination::Abs };
    let liquid =
        Liquid { impulsive: Share::new(m_1, masses.impulsive.1), convective: Share::new(m_2, masses.convective.1) };
    let mut all = ladders(basis, masses.period, m_1, m_2);
    all.push(resultant(basis, &action, Quantity::BaseMoment, liquid, shell_height));
    all.extend(axial(basis, &all));
    all
}

/// Overturning moment [N·m].
fn moment(c: &Coefficients, sheet: &mut Sheet) -> f64 {
    sheet.section("Overturning moment");
    sheet.given(&[("a_1", c.impulsive, Dimensionless), ("a_2", c.convective, Dimensionless)]);
    let name = "moment of shell, roof and impulsive liquid; a_1 = Z·I·C_1 or A_1";
    sheet.calc("M_1", name, IMPULSIVE_MOMENT, Moment, E3_1);
    let name = "moment of the convective liquid; a_2 = Z·I·C_2 or A_2";
    sheet.calc("M_2", name, CONVECTIVE_MOMENT, Moment, E3_1);
    sheet.calc("M", "overturning moment at the bottom of the shell", "M_1 + M_2", Moment, E3_1)
}

/// Hold-down, stability, shell compression, anchors.
fn resistance(basis: &Basis, moment: f64, sheet: &mut Sheet, out: &mut Assessment) {
    sheet.section("Resistance");
    let w_t = basis.weight_line(sheet, E4);
    let b = if basis.anchored() {
        let name = "compression at the bottom of the shell, anchored";
        Some(sheet.calc("b", name, LINEAR, LineForce, E5_2))
    } else {
        match basis.bottom() {
            Ok((thickness, f_by)) => self_anchored(basis, (moment, w_t), thickness, f_by, sheet, out),
            Err(missing) => {
                out.notes.push(format!("{E4}, stability and shell compression: not checked, `{missing}` is missing."));
                None
            }
        }
    };
    if b.is_some() {
        let name = "compressive stress of the bottom course";
        let f = sheet.calc("f", name, "b/t_s", Stress, E5_3);
        match basis.allowable_compression(sheet, "F_a", E5_3, false) {
            Ok(allowable) => out.checks.push(COMPRESSION.check().of(f, allowable, E5_3, "")),
            Err(missing) => out.notes.push(format!("{E5_3}, shell compression: not checked, `{missing}` is missing.")),
        }
    }
    if basis.anchored() {
        let name = "uplift per length that the anchors resist";
        let uplift = sheet.calc("w_AB", name, "1.273·M/D² - w_t", LineForce, E6);
        match basis.anchors(sheet, uplift, "w_AB", E6, "Internal pressure is not added.") {
            Ok(check) => out.checks.push(check),
            Err((CheckStatus::NotChecked, input)) => {
                out.notes.push(format!("{E6}, anchor tension: not checked, `{input}` is missing."))
            }
            Err((_, reason)) => out.notes.push(format!("{E6}: {reason}.")),
        }
    }
}

/// Hold-down of an unanchored tank; the compression b per length [N/m] unless it is unstable.
fn self_anchored(
    basis: &Basis,
    (moment, w_t): (f64, f64),
    thickness: f64,
    f_by: f64,
    sheet: &mut Sheet,
    out: &mut Assessment,
) -> Option<f64> {
    let Basis { t_s, .. } = *basis;
    // E.4.2: not more than the larger of 6 mm and the bottom course.
    let t_b = thickness.min(t_s.max(0.006));
    let name = "thickness of the bottom plate that counts (at most the larger of 6 mm and t_s)";
    sheet.input("t_b", name, t_b, Length, "API 650:1993 E.4.2");
    sheet.input("F_by", "yield strength of the bottom plate", f_by, Stress, "tank.bottom");
    let name = "hold-down force of the bottom strip per length";
    sheet.calc("w_L", name, hd::HOLD_DOWN_1993, LineForce, E4);
    let (name, formula) = ("ratio of moment and hold-down", "M/(D²·(w_t + w_L))");
    let x = sheet.calc("x", name, formula, Dimensionless, E5_1);
    let last = 1.0 / 0.637;
    let note = "1.57 as printed; the formula above 1.5 is undefined from 1/0.637 = 1.5699 on.";
    let stability = limit_states::STABILITY.named("Stability of the unanchored tank");
    out.checks.push(stability.check().of(x, last, E5_1, note));
    let b = compression(sheet, x);
    match b {
        None => out.notes.push(format!("{E5_1}: unstable at x = {x:.3}; anchor the tank or thicken the bottom plate.")),
        Some(_) if x > hd::NO_UPLIFT => out.notes.push(format!("{E5_1}: the shell lifts (x = {x:.3} above 0.785).")),
        Some(_) => {}
    }
    out.hold_down = Some(w_t);
    let notes = lifted::information(sheet, basis.case, ("M", moment), w_t, E5_1);
    out.notes.extend(notes);
    sheet.section("Resistance");
    b
}

/// Compression where the whole ring bears; 1.273 is 4/π.
const LINEAR: &str = "w_t + 1.273·M/D²";

/// Lines of the shell compression b of an unanchored tank; returns it [N/m]. `None` if the tank is not stable
/// (x ≥ 1/0.637 = 1.5699).
///
/// * `sheet`: with M, D, the weight w_t and the hold-down w_L per length, and `x`
/// * `x`: M/(D² (w_t + w_L))
pub(super) fn compression(sheet: &mut Sheet, x: f64) -> Option<f64> {
    let name = "compression at the bottom of the shell";
    if x <= hd::NO_UPLIFT {
        return Some(sheet.calc("b", name, LINEAR, LineForce, E5_1));
    }
    if x <= 1.5 {
        let (what, source) = ("(b + w_L)/(w_t + w_L)", "figure E-5, from equilibrium of the bearing arc");
        sheet.look_up("y", what, source, hd::figure_e5(x)?, Dimensionless, E5_1);
    } else if hd::has_tail(x) {
        let what = "(b + w_L)/(w_t + w_L) above x = 1.5";
        sheet.calc("y", what, hd::TAIL, Dimensionless, E5_1);
    } else {
        return None;
    }
    Some(sheet.calc("b", name, "y·(w_t + w_L) - w_L", LineForce, E5_1))
}
