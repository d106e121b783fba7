//! Eurocode 8 part 4: EN 1998-4:2006 annex A and the pre-standard ENV 1998-4:1998 annex B.
//!
//! | module | idea | clause (EN) |
//! |---|---|---|
//! | [`spectrum`] | elastic and design spectra | EN 1998-1:2004 3.2.2, ENV 1998-1-1:1994 4.2 |
//! | [`demand`] | accelerations of one assessment, from a site or a record | 2.1, 2.3.3, 4.4 |
//! | `design_spectrum` | S_d beside S_e/q | EN 1998-1:2004 3.2.2.5 |
//! | `directions` | two horizontal components | EN 1998-1:2004 4.3.3.5 |
//! | `tabulated` | the user's table as seismic action | EN 1998-1:2004 3.2.2.2 (η) |
//! | [`simplified`] | simplified procedure, table A.2 | A.3.2.2 |
//! | [`flexible`], [`shell_mode`] | flexible impulsive part, first mode of the wall with liquid | A.3.1 |
//! | [`vertical`] | vertical motion | A.2.2, A.3.3 |
//! | [`plate`] | deflection of rectangular walls | A.4 |
//! | [`uplift`] | estimate for unanchored walls | in place of the diagrams of A.9 |
//! | [`buckling`] | stability of steel walls | A.10 |
//! | `damage` | damage limitation: freeboard and hoop | 2.1.3, EN 1998-1:2004 2.2.3 |
//! | `soil` | period and damping on soil, for information | A.7 |
//! | `plate_uplift` | uplift of the bottom plate of unanchored walls | A.9 |
//! | `bearing` | largest pressure of the ground | EN 1998-5:2004 5.4.1.1 |
//! | `pipes` | displacement of pipes against their support | 4.5.2.3 |
//! | `walls`, `wall_bending` | walls of concrete and of boxes: forces, bending, shear, crack width | EN 1992-1-1, EN 1992-3 |
//! | `stability` | overturning and anchors of boxes | 4.5.1 |
//! | `anchor_layout` | number and spacing of anchors | good practice |
//! | `other_direction` | a box shaken along its breadth | EN 1998-1:2004 4.3.3.5.1 |
//! | `sliding` | base shear against friction | EN 1998-5:2004 5.4.1.1 |
//!
//! Masses, levers and pressures of the rigid tank (A.2.1, A.4) are those of [`crate::mechanical`]. The sheets themselves are
//! filled by `cylinder` and `rectangle`. `docs/theory/eurocode8.md` maps the clauses and lists the gaps.

pub(crate) mod anchor_layout;
pub mod bearing;
#[cfg(test)]
mod boundaries;
pub mod buckling;
mod cylinder;
mod cylinder_base;
pub(crate) mod cylinder_checks;
mod cylinder_stress;
mod cylinder_vertical;
mod damage;
pub mod demand;
mod design_spectrum;
mod directions;
#[cfg(test)]
pub(crate) mod example;
pub mod flexible;
mod ingredients;
pub(crate) mod limit_states;
mod modal;
mod other_direction;
#[cfg(test)]
mod own_spectrum;
mod pipes;
pub mod plate;
pub mod plate_uplift;
#[cfg(test)]
mod properties;
mod rectangle;
mod run;
#[cfg(test)]
mod scope;
pub mod shell_mode;
pub mod simplified;
mod sliding;
mod soil;
pub mod spectrum;
mod stability;
#[cfg(test)]
mod tables;
mod tabulated;
pub mod uplift;
pub mod vertical;
pub(crate) mod wall_bending;
mod walls;
mod work;

use demand::{Demand, Edition};
pub use run::Eurocode8;
use work::Work;

use crate::base_state::BaseState;
use crate::hazard;
use crate::limit_state::LimitStateDef;
use crate::modal_action::ModalAction;
use crate::procedure::{CodeError, DesignCurve, Label, Procedure};
use crate::sheet::Sheet;
use spectrum::ElasticSpectrum;
use tank::assessment::{Assessment, Excitation, LimitState, NotApplicable};
use tank::case::{Case, Combination, FlexibleImpulsive, Site};
use tank::hazard::SpectrumForm;
use tank::units::Dimension::{Dimensionless, Stress};
use tank::{Shape, Support};

/// EN 1998-4:2006 annex A with EN 1998-1:2004 (`ec8-2006`).
#[derive(Clone, Copy, Debug)]
pub struct En2006;

/// ENV 1998-4:1998 annex B with ENV 1998-1-1:1994, as used in the dissertation (`ec8-env`).
#[derive(Clone, Copy, Debug)]
pub struct Env1998;

impl Procedure for En2006 {
    fn id(&self) -> &'static str {
        "ec8-2006"
    }

    fn label(&self) -> Label {
        Label { title: "EN 1998-4:2006, annex A", short: "EN 1998-4:2006", figure_key: "k-ec8-2006" }
    }

    fn decides(&self, site: &Site) -> bool {
        site.ec8.is_some()
    }

    fn table(&self) -> &'static [LimitStateDef] {
        limit_states::TABLE
    }

    fn limit_states(&self, case: &Case) -> Vec<LimitState> {
        limit_states::all(case, Edition::En2006)
    }

    fn design_curves(&self, site: &Site, dampings: &[f64]) -> Vec<DesignCurve> {
        let Some(ec8) = &site.ec8 else { return Vec::new() };
        let own = site.spectrum.as_ref();
        let title = if own.is_some() { "Own spectrum" } else { "EN 1998-1 elastic" };
        let curve = |&damping: &f64| {
            Some(DesignCurve {
                id: format!("ec8-{damping}"),
                title: format!("{title}, ξ = {:.1} %", damping * 100.0),
                damping,
                longest: own.map_or(f64::INFINITY, hazard::longest),
                acceleration: match own {
                    Some(own) => hazard::elastic(own, ec8.importance, damping),
                    None => {
                        let spectrum = ElasticSpectrum::new(ec8).ok()?;
                        Box::new(move |t| spectrum.horizontal(t, damping))
                    }
                },
            })
        };
        dampings.iter().filter_map(curve).collect()
    }

    fn modal_action<'a>(&self, case: &'a Case, reduced: bool) -> Option<Result<ModalAction<'a>, CodeError>> {
        case.site.ec8.map(|_| modal::action(case, reduced))
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        applies(case, excitation, Edition::En2006)
    }

    fn snow_share(&self, case: &Case) -> f64 {
        snow_share(case)
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        assess(&case.with_snow(self.snow_share(case)), excitation, Edition::En2006)
    }
}

impl Procedure for Env1998 {
    fn id(&self) -> &'static str {
        "ec8-env"
    }

    fn label(&self) -> Label {
        Label { title: "ENV 1998-4:1998, annex B (superseded)", short: "ENV 1998-4", figure_key: "k-ec8-env" }
    }

    fn table(&self) -> &'static [LimitStateDef] {
        limit_states::TABLE
    }

    fn limit_states(&self, case: &Case) -> Vec<LimitState> {
        limit_states::all(case, Edition::Env1998)
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        applies(case, excitation, Edition::Env1998)
    }

    fn snow_share(&self, case: &Case) -> f64 {
        snow_share(case)
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        assess(&case.with_snow(self.snow_share(case)), excitation, Edition::Env1998)
    }
}

/// ψ_E of EN 1998-1:2004 4.2.4 for the snow on the roof.
fn snow_share(case: &Case) -> f64 {
    case.tank.roof.snow.map_or(0.0, |snow| snow.combination)
}

/// The only limits are those of the ground motion: a missing record or site, a ground type the pre-standard lacks.
fn applies(case: &Case, excitation: Excitation, edition: Edition) -> Result<(), NotApplicable> {
    match Demand::new(case, excitation, edition) {
        Err(CodeError::NotApplicable(reason)) => Err(reason),
        // Inadmissible data are faults, not limits of scope: `assess` reports them.
        Ok(_) | Err(_) => Ok(()),
    }
}

fn assess(case: &Case, excitation: Excitation, edition: Edition) -> Result<Assessment, CodeError> {
    let mut work = worked(case, excitation, edition)?;
    other_direction::assess(&mut work, excitation);
    finished(work)
}

/// Shaken along the length of a box alone.
fn assess_one(case: &Case, excitation: Excitation, edition: Edition) -> Result<Assessment, CodeError> {
    finished(worked(case, excitation, edition)?)
}

fn finished(work: Work) -> Result<Assessment, CodeError> {
    let Work { sheet, mut out, base, .. } = work;
    base.follow(&mut out.checks);
    out.steps = sheet.into_steps()?;
    Ok(out)
}

fn worked(case: &Case, excitation: Excitation, edition: Edition) -> Result<Work<'_>, CodeError> {
    let demand = Demand::new(case, excitation, edition)?;
    let mut work = Work {
        case,
        edition,
        demand,
        sheet: Sheet::new(),
        mass: 0.0,
        wave: None,
        rim: None,
        uncovered: None,
        base: match case.tank.support {
            Support::Anchored => BaseState::Bears,
            Support::Unanchored => BaseState::Unknown("the uplift of the wall is not computed".into()),
        },
        out: Assessment::default(),
    };
    assumptions(&mut work, excitation);
    situation(&mut work);
    match case.tank.shape {
        Shape::Cylinder { radius } => cylinder::assess(&mut work, radius)?,
        Shape::Rectangle { length, breadth, strip } => rectangle::assess(&mut work, length, breadth, strip),
    }
    anchor_layout::assess(&mut work);
    match work.uncovered.take() {
        Some(refusal) => Err(refusal),
        None => Ok(work),
    }
}

/// Lines of the combination of actions.
fn situation(work: &mut Work) {
    let sheet = &mut work.sheet;
    sheet.section("Seismic design situation, G + ψ_2 Q + A_Ed");
    let clause = "EN 1990:2002 6.4.3.4, EN 1991-4:2006 annex A";
    let name = "factor of weight, liquid, pressure above it (ψ_2 = 1) and seismic action (γ_I is part of a_g)";
    sheet.input("γ_F", name, 1.0, Dimensionless, clause);
    let name = "partial factor of the resistance of a metal wall";
    sheet.input("γ_M", name, 1.0, Dimensionless, "EN 1998-1:2004 6.1.3, EN 1993-4-2:2007 2.9");
    let pressure = work.case.tank.pressure;
    if !pressure.is_none() {
        let (name, path) = ("overpressure above the liquid", "tank.pressure.internal");
        sheet.input("p_g", name, pressure.internal, Stress, path);
        let (name, path) = ("vacuum above the liquid, p_g = -p_vac", "tank.pressure.vacuum");
        sheet.input("p_vac", name, pressure.vacuum, Stress, path);
    }
}

/// What is assumed about a table of the user.
fn own_spectrum(case: &Case, excitation: Excitation) -> Option<String> {
    let own = case.site.spectrum.as_ref().filter(|_| excitation == Excitation::Site)?;
    let SpectrumForm::Table { vertical, .. } = &own.form else { return None };
    let vertical = match vertical {
        Some(_) => "",
        None => {
            " Vertical motion: shape of EN 1998-1 3.2.2.3 with a_vg as given share of the table's ground acceleration."
        }
    };
    Some(format!(
        "The user's table is linear between its rows and not continued beyond the last one; other dampings by η of the standard, \
         growing from none at T = 0 to the whole at the largest row.{vertical}"
    ))
}

fn assumptions(work: &mut Work, excitation: Excitation) {
    let case = work.case;
    let out = &mut work.out.assumptions;
    out.push("Inviscid liquid, small waves; rigid ground, no soil-structure interaction.".into());
    out.push(match excitation {
        Excitation::Record => "The spectrum of the record stands for the design spectrum; q = 1, γ_I = 1.".into(),
        Excitation::Site => {
            let parameters = match &case.site.spectrum {
                Some(_) => "The user's spectrum, times γ_I.",
                None => "Recommended values of the standard; a national annex may differ.",
            };
            let design = match work.edition {
                Edition::En2006 => ", not less than the design spectrum S_d with its lower bound",
                Edition::Env1998 => "",
            };
            format!(
                "Impulsive part: elastic spectrum at its damping divided by q{design}; sloshing: elastic spectrum, q = 1. {parameters}"
            )
        }
    });
    out.push(
        "Seismic design situation of EN 1990 6.4.3.4: weight, liquid at its fill height, pressure above it and seismic action each with \
         the factor 1; resistance of metal walls with γ_M = 1 (recommended values; a national annex may differ)."
            .into(),
    );
    out.extend(own_spectrum(case, excitation));
    if excitation == Excitation::Site {
        out.push(match case.tank.shape {
            Shape::Cylinder { .. } => directions::assumption(work.demand.components).into(),
            Shape::Rectangle { .. } => {
                "One horizontal component at a time: along the length of the tank, and along its breadth in the check of the other \
                 direction (EN 1998-1:2004 4.3.3.5.1(8))."
                    .into()
            }
        });
    }
    out.push(match case.procedures.ec8_combination {
        Combination::Abs => "Impulsive and convective maxima are added as absolute values.".into(),
        Combination::Srss => {
            "Impulsive and convective maxima are combined by SRSS; the annex recommends absolute values.".to_string()
        }
    });
    if case.damping.impulsive < 0.05 && excitation == Excitation::Site {
        out.push(format!(
            "Damping of the impulsive part {} % in every limit state; 2.3.3.1 has 5 % for the ultimate limit state, with smaller \
             actions, and less for damage limitation only.",
            crate::sheet::number(100.0 * case.damping.impulsive)
        ));
    }
    match case.tank.shape {
        Shape::Cylinder { .. } => of_a_cylinder(case, work.edition, out),
        Shape::Rectangle { .. } => {
            out.push("Impulsive part: rigid pressure field with the spectral acceleration at T_f of the wall.".into());
        }
    }
    if work.demand.vertical {
        out.push(
            "Horizontal and vertical motion: E_x + 0.3 E_z and 0.3 E_x + E_z; breathing mode at 3 % damping.".into(),
        );
    }
}

/// What is assumed of a cylinder alone.
fn of_a_cylinder(case: &Case, edition: Edition, out: &mut Vec<String>) {
    out.push("Impulsive part: rigid pressure field with the spectral acceleration at T_f (Veletsos).".into());
    if (edition, case.procedures.ec8_impulsive) == (Edition::En2006, FlexibleImpulsive::Simplified) {
        out.push(
            "Freeboard: the larger of R S_e(T_con)/g (A.3.2.2) and 0.84 R S_e(T_c1)/g (A.2.1.4); the sloshing height compared with \
             other methods is the latter."
                .into(),
        );
    }
    if case.tank.is_metal() {
        out.push(
            "Elastic-plastic collapse (A.10.3): of the exponents 1.15 (as the clause) and 1.5 (Rotter 1990, EN 1993-1-6) of R/(400 s) \
             the one with the smaller capacity: 1.15 from R/s = 400 on."
                .into(),
        );
    }
    out.push(match (edition, case.procedures.ec8_impulsive) {
        (Edition::En2006, FlexibleImpulsive::Simplified) => "Masses, levers and periods of table A.2 (A.3.2.2).".into(),
        (Edition::Env1998, FlexibleImpulsive::Simplified) => "T_f by the approximate formula of B.3.1.".to_string(),
        (_, FlexibleImpulsive::Iterative) => "T_f of the coupled first mode of the clamped wall.".into(),
    });
    out.push(
        "Membrane stresses; the bending of the wall near its base and at joints of courses is not included.".into(),
    );
}
