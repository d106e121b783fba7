//! `analysis`: options of the linear engines.

use tank::options::LinearOptions;
use tank::options::linear::{DampingModel, Integrator};
use tank::{Shape, Tank};

use super::imperfections::Imperfection;
use super::nonlinear::Nonlinear;
use super::rayleigh::{Rayleigh, rayleigh};
use super::solid::Solid;
use crate::input::tank::key::{Absent, Limits, default};
use crate::input::tank::read::{Field, Opt, choice, object};
use crate::input::tank::resolver::{Resolver, like_field, range_fault};
use crate::input::tank::values::{Length, Number, Time, Whole};

/// Defaults.
const DEFAULT: &LinearOptions = &LinearOptions::DEFAULT;
/// Gauges and stations; the tank bounds them further.
const PLACES: Limits = Limits::from(0.0).to(1000.0).items(0, 100);
/// Coefficients of Rayleigh damping.
const COEFFICIENT: Limits = Limits::from(-1e6).to(1e6);

object! {
    /// Options of the finite-element analysis.
    Analysis {
        /// Time integration.
        integrator: Opt<Integrator> = default(DEFAULT.integrator),
        /// Factor on the number of elements in each direction.
        refine (2): Opt<Number> [Limits::from(0.25).to(16.0)] = default(Number(DEFAULT.refine)),
        /// Number of sloshing modes that count for the wave height.
        wave_modes (5): Opt<Whole> [Limits::count(1, 50)] = default(Whole(DEFAULT.wave_modes as u32)),
        /// Whether the discretisation error is estimated on a second mesh.
        mesh_error (false): Opt<bool> = default(DEFAULT.mesh_error),
        /// Wave gauges besides the one at the wall: distances from the centre in the direction of shaking.
        gauges: Opt<Vec<Field<Length>>> [PLACES],
        /// Stress stations: heights above the base with histories of hoop, axial and bending stress.
        stations: Opt<Vec<Field<Length>>> [PLACES],
        /// Damping model.
        damping: Opt<AnalysisDamping> = Absent::Follows("the modal ratios of damping"),
        /// Deviations of a cylinder's wall from the perfect shape, which are added, in the three-dimensional and the nonlinear
        /// engine. All others compute the perfect cylinder.
        imperfections: Opt<Vec<Field<Imperfection>>> [Limits::ANY.items(0, 100)]
            = Absent::Without("the wall is a perfect cylinder"),
        /// Whether the wall of the three-dimensional engine moves about its state under weight and liquid, whose hoop force
        /// stiffens it against waves around the tank.
        initial_stress (true): Opt<bool> = Absent::Follows("true with imperfections, else false"),
        /// Options of the three-dimensional engine (--fe solid, --fe both).
        solid: Opt<Solid>,
        /// Options of the nonlinear engine.
        nonlinear: Opt<Nonlinear>,
    }

    /// Damping model of the finite-element analysis instead of modal ratios. Give one of the two.
    AnalysisDamping {
        /// Rayleigh damping fitted to two ratios.
        rayleigh: Opt<Rayleigh>,
        /// Rayleigh damping with its coefficients given, whatever their sign.
        coefficients: Opt<Coefficients>,
    }

    /// Coefficients of Rayleigh damping C = a_M M + a_K K.
    Coefficients {
        /// a_M in 1/s, a bare number.
        mass (0.1): Field<Number> [COEFFICIENT],
        /// a_K.
        stiffness ("0.001 s"): Field<Time> [COEFFICIENT],
    }
}

choice! {
    /// Time integration.
    Integrator {
        /// Exact piecewise-linear modal integration with missing mass.
        Modal = "modal",
        /// Direct integration by Newmark's method.
        Newmark = "newmark",
    }
}

/// Options of the linear engines. Defaults are those of the engine and not echoed one by one.
pub(super) fn analysis(r: &mut Resolver<'_>, given: Option<&Analysis>, tank: Option<&Tank>) -> LinearOptions {
    let Some(given) = given else {
        r.echo_default("analysis", "not given", "modal integration on the default mesh");
        return DEFAULT.clone();
    };
    let (half, what) = match tank.map(|t| t.shape) {
        Some(Shape::Cylinder { radius }) => (radius, "the radius"),
        Some(Shape::Rectangle { length, .. }) => (length / 2.0, "half the length"),
        None => (f64::NAN, ""),
    };
    let height = tank.map_or(f64::NAN, Tank::wall_height);
    LinearOptions {
        integrator: r.choice(&given.integrator),
        refine: r.or_default(&given.refine),
        wave_modes: r.count_or_default(&given.wave_modes) as usize,
        mesh_error: r.choice(&given.mesh_error),
        gauges: places(r, &given.gauges, half, what),
        stations: places(r, &given.stations, height, "the height of the wall"),
        damping: match &given.damping.given {
            Some(damping) => damping_model(r, damping),
            None => {
                r.echo_default("analysis.damping", "modal", "the ratios of `damping`");
                DampingModel::Modal
            }
        },
    }
}

/// Places from 0 to a length of the tank (NaN if the tank is faulty: no upper limit).
fn places(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Length>>>, end: f64, what: &str) -> Vec<f64> {
    let mut all = Vec::new();
    let Some((field, list)) = option.given.as_ref().and_then(|f| Some((f, f.value.as_ref()?))) else {
        return all;
    };
    let (_, most) = field.limits.items;
    if list.len() > most {
        r.faults.push(
            range_fault(field, "too many places", &format!("at most {most}")).found(format!("{} places", list.len())),
        );
    }
    for place in list {
        let value = r.within(place, field.limits);
        if value > end * (1.0 + 1e-9) {
            let allowed = format!("from 0 to {}, {what}", like_field(place, end));
            r.faults.push(range_fault(place, "outside the tank", &allowed));
        }
        all.push(value);
    }
    all
}

fn damping_model(r: &mut Resolver<'_>, field: &Field<AnalysisDamping>) -> DampingModel {
    let Some(model) = &field.value else {
        return DampingModel::Modal;
    };
    match (&model.rayleigh.given, &model.coefficients.given) {
        (Some(one), None) => match &one.value {
            Some(given) => {
                let (first, second, allow_negative) = rayleigh(r, given);
                DampingModel::Rayleigh {
                    first,
                    second,
                    allow_negative,
                }
            }
            None => DampingModel::Modal,
        },
        (None, Some(one)) => match &one.value {
            Some(c) => DampingModel::Coefficients {
                mass: r.number(&c.mass),
                stiffness: r.number(&c.stiffness),
            },
            None => DampingModel::Modal,
        },
        (Some(_), Some(_)) | (None, None) => {
            r.faults.push(
                range_fault(
                    field,
                    "not exactly one damping model",
                    "either rayleigh or coefficients",
                )
                .help("remove analysis.damping to use the modal ratios of `damping`"),
            );
            DampingModel::Modal
        }
    }
}
