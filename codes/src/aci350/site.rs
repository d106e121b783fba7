//! Accelerations of ACI 350.3-06 from the data of ASCE 7.

use tank::STANDARD_GRAVITY;
use tank::Shape;
use tank::case::{Api650Site, Site};
use tank::factor::Factor;
use tank::ingredients::{Ordinate, Rule};
use tank::units::Dimension::{Density, Dimensionless, Stress, Time};

use super::Kind;
use crate::api650::ground_motion::DesignSpectrum;
use crate::procedure::{CodeError, DesignCurve};
use crate::two_mass::{Action, Periods, Work};

const SITE: &str = "ACI 350.3-06 9.4, ASCE 7 11.4";
const IMPULSIVE: &str = "ACI 350.3-06 9.4.1";
const CONVECTIVE: &str = "ACI 350.3-06 9.4.2";
const VERTICAL: &str = "ACI 350.3-06 4.1.4, 9.4.3, one source";
const IMPORTANCE: &str = "ACI 350.3-06 table 4.1.1(a), recalled";
const REDUCTION: &str = "ACI 350.3-06 table 4.1.1(b), one source";
/// Importance factors by seismic use group.
const IMPORTANCE_FACTORS: [f64; 3] = [1.0, 1.25, 1.5];
/// Period of C_c beyond which it falls with 1/T²: 1.6/T_S.
const LONG: f64 = 1.6;

/// Importance factor I of a site.
fn importance(site: &Api650Site) -> Result<f64, CodeError> {
    IMPORTANCE_FACTORS.get(usize::from(site.sug).wrapping_sub(1)).copied().ok_or_else(|| CodeError::Data {
        clause: IMPORTANCE.into(),
        reason: format!("site.api650.sug: found {}, allowed 1, 2 and 3", site.sug),
    })
}

/// Response modification R_i of a kind of base.
fn reduction(kind: Kind) -> (f64, &'static str) {
    match kind {
        Kind::Flexible => (3.25, "response modification, impulsive, anchored flexible base"),
        Kind::Fixed => (2.0, "response modification, impulsive, fixed or hinged base"),
        Kind::Unanchored => (1.5, "response modification, impulsive, unanchored base"),
    }
}

/// C_i and C_c over the period, without importance and reduction; none where the data do not give them.
pub(super) fn curves(site: &Site) -> Vec<DesignCurve> {
    let given = site.api650.as_ref().filter(|_| site.spectrum.is_none());
    let Some(Ok(spectrum)) = given.map(DesignSpectrum::new) else { return Vec::new() };
    let DesignSpectrum { s_ds, s_d1, t_s, .. } = spectrum;
    let convective = move |t: f64| if t > LONG / t_s { 2.4 * s_ds / (t * t) } else { 1.5 * s_ds.min(s_d1 / t) };
    let curve = |id: &str, title: &str, damping: f64, acceleration: Box<dyn Fn(f64) -> f64>| DesignCurve {
        id: id.into(),
        title: title.into(),
        damping,
        longest: f64::INFINITY,
        acceleration,
    };
    vec![
        curve("aci350-0.05", "ACI 350.3 C_i, ξ = 5 %", 0.05, Box::new(move |t| s_ds.min(s_d1 / t) * STANDARD_GRAVITY)),
        curve("aci350-0.005", "ACI 350.3 C_c, ξ = 0.5 %", 0.005, Box::new(move |t| convective(t) * STANDARD_GRAVITY)),
    ]
}

/// Lines of the accelerations.
pub(super) fn action(work: &mut Work, periods: &Periods) -> Result<Action, CodeError> {
    // `applies` has asked before.
    let Some(site) = &work.case.site.api650 else {
        return Err(CodeError::Data { clause: SITE.into(), reason: "`site.api650` is not given".into() });
    };
    if work.case.site.spectrum.is_some() {
        return Err(CodeError::Data {
            clause: SITE.into(),
            reason: "`site.spectrum` has no S_DS and S_D1; give the mapped accelerations in `site.api650` without it"
                .into(),
        });
    }
    let spectrum = DesignSpectrum::new(site)?;
    let i = importance(site)?;
    let (r_i, name) = reduction(Kind::of(work.case));
    let sheet = &mut work.sheet;
    for (symbol, name, value, clause) in [
        ("q", "share of the maximum considered earthquake", site.q, SITE),
        ("S_S", "mapped acceleration at short periods [g]", site.ss, SITE),
        ("S_1", "mapped acceleration at one second [g]", site.s1, SITE),
        ("F_a", "site coefficient at short periods", spectrum.f_a, SITE),
        ("F_v", "site coefficient at one second", spectrum.f_v, SITE),
        ("I", "importance factor", i, IMPORTANCE),
        ("R_i", name, r_i, REDUCTION),
        ("R_c", "response modification, convective", 1.0, REDUCTION),
    ] {
        sheet.input(symbol, name, value, Dimensionless, clause);
    }
    sheet.calc("S_DS", "design acceleration at short periods [g]", "q·F_a·S_S", Dimensionless, SITE);
    sheet.calc("S_D1", "design acceleration at one second [g]", "q·F_v·S_1", Dimensionless, SITE);
    let t_s = sheet.calc("T_S", "end of the plateau", "S_D1/S_DS", Time, SITE);
    let short = periods.impulsive.is_none_or(|part| part.period <= t_s);
    let formula = if short { "S_DS" } else { "S_D1/T_i" };
    sheet.calc("C_i", "seismic coefficient, impulsive [g]", formula, Dimensionless, IMPULSIVE);
    let long = periods.convective > LONG / t_s;
    let formula = if long { "2.4·S_DS/T_c²" } else { "min(1.5·S_D1/T_c, 1.5·S_DS)" };
    sheet.calc("C_c", "seismic coefficient, convective, 0.5 % damping [g]", formula, Dimensionless, CONVECTIVE);
    let a_i = sheet.calc("A_i", "impulsive acceleration [g]", "C_i·I/R_i", Dimensionless, IMPULSIVE);
    let a_c = sheet.calc("A_c", "convective acceleration [g]", "C_c·I/R_c", Dimensionless, CONVECTIVE);
    let name = "acceleration of the sloshing wave, not reduced [g]";
    let a_w = sheet.calc("A_w", name, "C_c·I", Dimensionless, "ACI 350.3-06 7.1");
    let a_v = vertical(work, t_s);

    let g = work.case.gravity;
    let importance = (Factor::Importance, i);
    let one_second = spectrum.s_d1 / periods.convective;
    let shape = if long { LONG / t_s / periods.convective } else { 1.0 };
    let bounds = a_w / (one_second * 1.5 * shape * i);
    let of_convective = [
        (Factor::DampingCorrection, 1.5),
        (Factor::LongPeriod, shape),
        importance,
        (Factor::BehaviourFactor, 1.0),
        (Factor::Bounds, bounds),
    ];
    let impulsive = Ordinate::at(0.0, 0.05, a_i * g).split(&[importance, (Factor::BehaviourFactor, 1.0 / r_i)]);
    let rule = if periods.impulsive.is_some() { Rule::At } else { Rule::Plateau };
    let convective = |value: f64| Ordinate::at(periods.convective, 0.05, value * g).split(&of_convective);
    Ok(Action {
        impulsive: Ordinate { period: periods.impulsive.map(|part| part.period), rule, ..impulsive },
        convective: convective(a_c),
        wave: convective(a_w),
        vertical: a_v * g,
    })
}

/// Line of the vertical acceleration [g].
fn vertical(work: &mut Work, t_s: f64) -> f64 {
    let case = work.case;
    let course = case.tank.course_at(0.0);
    let formula = match case.tank.shape {
        Shape::Rectangle { .. } => "0.4·S_DS",
        Shape::Cylinder { .. } => {
            let sheet = &mut work.sheet;
            sheet.given(&[
                ("t", course.thickness, tank::units::Dimension::Length),
                ("E", course.material.youngs_modulus, Stress),
                ("ρ", case.liquid.density, Density),
            ]);
            let formula = "2·π·√(ρ·D·H²/(2·t·E))";
            let period = sheet.calc("T_v", "vertical period of the liquid in the shell", formula, Time, VERTICAL);
            if period <= t_s { "S_DS" } else { "S_D1/T_v" }
        }
    };
    let sheet = &mut work.sheet;
    sheet.calc("C_t", "seismic coefficient, vertical [g]", formula, Dimensionless, VERTICAL);
    let formula = "max(C_t·I·2/(3·R_i), 0.2·S_DS)";
    sheet.calc("A_v", "vertical acceleration [g]", formula, Dimensionless, VERTICAL)
}
