//! Record processing, damping, choices of the procedures and of the analysis, reported values.

use tank::Quantity;
use tank::case::{self, ProcedureOptions, Reported};
use tank::units::Dimension;
use tank::{Shape, Tank};

use super::{Limits, Resolver, like_field, range_fault};
use crate::input::records::Processing;
use crate::input::tank::read::{Field, FromNode};
use crate::input::tank::reported::{Measured, Raw};
use crate::input::tank::schema;
use crate::input::tank::values::{Length, Number, Pitch, Whole, quantity};
use tank::options::SolidOptions;
use tank::options::solid::Liquid;
use tank::options::{LinearOptions, linear};

/// Damping ratios.
pub(super) const RATIO: Limits = Limits::from(0.0).below(1.0);
/// Young's modulus [Pa] below which a wall counts as concrete or plastic, not metal.
const METAL: f64 = 60e9;

/// What to do to the record.
pub(super) fn record(r: &mut Resolver<'_>, field: &Option<Field<schema::Record>>) -> Processing {
    let absent = schema::Record {
        scale_to: None,
        scale_by: None,
        time_factor: None,
        resample: None,
    };
    let given = match field {
        Some(field) => match &field.value {
            Some(value) => value,
            None => return Processing::default(),
        },
        None => &absent,
    };
    let path = |key: &str| format!("record.{key}");
    let scale_to = r.optional(
        &path("scale_to"),
        &given.scale_to,
        Limits::above(0.0).to(10.0 * tank::STANDARD_GRAVITY),
        "not scaled to a peak",
    );
    let scale_by = r.optional(
        &path("scale_by"),
        &given.scale_by,
        Limits::from(-1000.0).to(1000.0),
        "1",
    );
    if let (Some(factor), Some(field)) = (scale_by, &given.scale_by) {
        if factor == 0.0 {
            r.faults
                .push(range_fault(field, "a factor of 0 leaves no motion", "any other number"));
        } else if given.scale_to.is_some() && factor != 1.0 && factor.is_finite() {
            r.faults.push(
                range_fault(
                    field,
                    "two scales for one record",
                    "either scale_to or scale_by (1.0 beside scale_to)",
                )
                .help("drop scale_by to scale to the peak, or scale_to to scale by a factor"),
            );
        }
    }
    let time_factor = r.optional(
        &path("time_factor"),
        &given.time_factor,
        Limits::from(1e-3).to(1e3),
        "1",
    );
    let resample = r.optional(
        &path("resample"),
        &given.resample,
        Limits::from(1e-5).to(1.0),
        "time step of the record",
    );
    Processing {
        scale_to,
        scale_by,
        time_factor,
        resample,
    }
}

/// Damping ratios; the default of the wall follows from its material.
pub(super) fn damping(
    r: &mut Resolver<'_>,
    field: &Option<Field<schema::Damping>>,
    tank: Option<&Tank>,
) -> case::Damping {
    let absent = schema::Damping {
        sloshing: None,
        impulsive: None,
    };
    let given = match field {
        Some(field) => match &field.value {
            Some(value) => value,
            None => {
                return case::Damping {
                    sloshing: f64::NAN,
                    impulsive: f64::NAN,
                };
            }
        },
        None => &absent,
    };
    let softest = tank.map_or(f64::NAN, |t| {
        t.courses
            .iter()
            .map(|c| c.material.youngs_modulus)
            .fold(f64::INFINITY, f64::min)
    });
    let (ratio, text, why) = if softest < METAL {
        (
            0.05,
            "0.05",
            "EN 1998-4:2006 2.3.3 and EN 1998-1: concrete 5 % (Young's modulus of the wall below 60 GPa)",
        )
    } else {
        (
            0.02,
            "0.02",
            "EN 1998-4:2006 2.3.3: welded steel 2 % (Young's modulus of the wall 60 GPa or more)",
        )
    };
    case::Damping {
        sloshing: r.or_default(
            "damping.sloshing",
            &given.sloshing,
            RATIO,
            Number(0.005),
            "0.005",
            "EN 1998-4:2006 2.3.3: water and other liquids 0.5 %",
        ),
        impulsive: r.or_default("damping.impulsive", &given.impulsive, RATIO, Number(ratio), text, why),
    }
}

/// Choices within the procedures, and the ids of those to run (empty: all).
pub(super) fn procedures(
    r: &mut Resolver<'_>,
    field: &Option<Field<schema::Procedures>>,
) -> (ProcedureOptions, Vec<String>) {
    let given = field.as_ref().and_then(|f| f.value.as_ref());
    let mut run: Vec<String> = Vec::new();
    match given.and_then(|p| p.run.as_ref()) {
        Some(list) => {
            for id in list.value.iter().flatten().filter(|id| id.value.is_some()) {
                r.echo_given(id);
                if run.contains(&id.text) {
                    r.faults
                        .push(range_fault(id, "a procedure named twice", "each procedure once"));
                }
                run.push(id.text.clone());
            }
            if list.value.as_ref().is_some_and(Vec::is_empty) {
                r.faults.push(range_fault(
                    list,
                    "no procedure",
                    "at least one id; leave `run` out to run all",
                ));
            }
        }
        None => r.echo_default("procedures.run", "all", "every procedure that applies"),
    }
    let housner = given.and_then(|p| p.housner.as_ref()).and_then(|f| f.value.as_ref());
    let ec8 = given.and_then(|p| p.ec8.as_ref()).and_then(|f| f.value.as_ref());
    let none = None;
    let (none_combination, none_impulsive) = (None, None);
    let combination = |c: schema::Combination| match c {
        schema::Combination::Abs => case::Combination::Abs,
        schema::Combination::Srss => case::Combination::Srss,
    };
    let convective = r.choice(
        "procedures.housner.convective",
        housner.map_or(&none, |h| &h.convective),
        schema::Convective::Exact,
        "exact",
        "the coefficients of 1957 are up to 30 % low",
    );
    let housner_combination = r.choice(
        "procedures.housner.combination",
        housner.map_or(&none_combination, |h| &h.combination),
        schema::Combination::Abs,
        "abs",
        "Housner 1963: the maxima are added",
    );
    let ec8_combination = r.choice(
        "procedures.ec8.combination",
        ec8.map_or(&none_combination, |e| &e.combination),
        schema::Combination::Abs,
        "abs",
        "EN 1998-4:2006 A.3.2.1: absolute values are added",
    );
    let impulsive = r.choice(
        "procedures.ec8.impulsive",
        ec8.map_or(&none_impulsive, |e| &e.impulsive),
        schema::Impulsive::Simplified,
        "simplified",
        "EN 1998-4:2006 A.3.2.2",
    );
    let options = ProcedureOptions {
        housner_convective: match convective {
            schema::Convective::Exact => case::ConvectiveCoefficient::Exact,
            schema::Convective::Housner1957 => case::ConvectiveCoefficient::Housner1957,
        },
        housner_combination: combination(housner_combination),
        ec8_combination: combination(ec8_combination),
        ec8_impulsive: match impulsive {
            schema::Impulsive::Simplified => case::FlexibleImpulsive::Simplified,
            schema::Impulsive::Iterative => case::FlexibleImpulsive::Iterative,
        },
    };
    (options, run)
}

/// Options of the finite-element engine; what is not given is the engine's own default.
pub(super) fn analysis(
    r: &mut Resolver<'_>,
    field: &Option<Field<schema::Analysis>>,
    tank: Option<&Tank>,
) -> LinearOptions {
    let mut options = LinearOptions::default();
    let Some(given) = field.as_ref().and_then(|f| f.value.as_ref()) else {
        r.echo_default("analysis", "not given", "modal integration on the default mesh");
        return options;
    };
    if let Some(field) = &given.integrator {
        r.echo_given(field);
        options.integrator = match field.value {
            Some(schema::Integrator::Newmark) => linear::Integrator::Newmark,
            _ => linear::Integrator::Modal,
        };
    }
    if let Some(field) = &given.refine {
        options.refine = r.number(field, Limits::from(0.25).to(16.0));
    }
    if let Some(field) = &given.wave_modes {
        r.echo_given(field);
        if let Some(modes) = field.value {
            if !(1..=50).contains(&modes.0) {
                r.faults
                    .push(range_fault(field, "out of range", "a whole number from 1 to 50"));
            }
            options.wave_modes = modes.0 as usize;
        }
    }
    if let Some(field) = &given.mesh_error {
        r.echo_given(field);
        options.mesh_error = field.value.unwrap_or(true);
    }
    let (half, what) = match tank.map(|t| t.shape) {
        Some(Shape::Cylinder { radius }) => (radius, "the radius"),
        Some(Shape::Rectangle { length, .. }) => (length / 2.0, "half the length"),
        None => (f64::NAN, ""),
    };
    let height = tank.map_or(f64::NAN, Tank::wall_height);
    options.gauges = places(r, &given.gauges, half, what);
    options.stations = places(r, &given.stations, height, "the height of the wall");
    if let Some(damping) = &given.damping {
        if let Some(model) = &damping.value {
            options.damping = damping_model(r, damping, model);
        }
    } else {
        r.echo_default("analysis.damping", "modal", "the ratios of `damping`");
    }
    options
}

/// Options of the three-dimensional engine; what is not given is the engine's own default, echoed where the engine runs.
pub(super) fn solid(r: &mut Resolver<'_>, field: &Option<Field<schema::Analysis>>) -> SolidOptions {
    let mut options = SolidOptions::default();
    let analysis = field.as_ref().and_then(|f| f.value.as_ref());
    let Some(given) = analysis.and_then(|a| a.solid.as_ref()).and_then(|f| f.value.as_ref()) else {
        return options;
    };
    if let Some(field) = &given.mesh {
        r.echo_given(field);
        options.mesh = field.value.map(|mesh| mesh.0);
    }
    if let Some(field) = &given.liquid {
        r.echo_given(field);
        options.liquid = match field.value {
            Some(schema::LiquidElement::Displacement) => Liquid::Displacement,
            _ => Liquid::Potential,
        };
    }
    if let Some(field) = &given.memory_limit {
        r.echo_given(field);
        match field.value {
            Some(Whole(0)) => r.faults.push(range_fault(
                field,
                "no memory at all",
                "a whole number of MiB from 1 on",
            )),
            Some(Whole(mib)) => options.memory_limit_mib = mib.into(),
            None => {}
        }
    }
    options
}

/// Places from 0 to a length of the tank (NaN: the tank is faulty, nothing is compared).
fn places(r: &mut Resolver<'_>, field: &Option<Field<Vec<Field<Length>>>>, end: f64, what: &str) -> Vec<f64> {
    let mut all = Vec::new();
    let Some(list) = field.as_ref().and_then(|f| f.value.as_ref()) else {
        return all;
    };
    if let (true, Some(field)) = (list.len() > 100, field) {
        r.faults
            .push(range_fault(field, "too many places", "at most 100").found(format!("{} places", list.len())));
    }
    for place in list {
        let value = r.number(place, Limits::from(0.0).to(1000.0));
        if value > end * (1.0 + 1e-9) {
            let allowed = format!("from 0 to {}, {what}", like_field(place, end));
            r.faults.push(range_fault(place, "outside the tank", &allowed));
        }
        all.push(value);
    }
    all
}

/// A (circular frequency [rad/s], ratio) pair.
type Pair = (f64, f64);

/// Both pairs of Rayleigh damping, and whether a negative coefficient is accepted.
pub(super) fn rayleigh(r: &mut Resolver<'_>, rayleigh: &schema::Rayleigh) -> (Pair, Pair, bool) {
    let mut pair = |f: &Field<schema::RatioAt>| {
        let Some(pair) = &f.value else {
            return (f64::NAN, f64::NAN);
        };
        r.echo_given(&pair.at);
        (pair.at.value.map_or(f64::NAN, |p| p.0), r.number(&pair.ratio, RATIO))
    };
    let (first, second) = (pair(&rayleigh.first), pair(&rayleigh.second));
    if (first.0 - second.0).abs() <= 1e-9 * first.0 {
        r.faults.push(range_fault(
            &rayleigh.second,
            "both pairs have the same frequency",
            "two frequencies",
        ));
    }
    let allow_negative = rayleigh.allow_negative.as_ref().is_some_and(|f| f.value == Some(true));
    if let Some(field) = &rayleigh.allow_negative {
        r.echo_given(field);
    }
    // ζ = a_M/(2ω) + a_K ω/2 through both pairs.
    let denominator = second.0.powi(2) - first.0.powi(2);
    let stiffness = 2.0 * (second.1 * second.0 - first.1 * first.0) / denominator;
    let mass = 2.0 * first.1 * first.0 - stiffness * first.0.powi(2);
    if !allow_negative && (stiffness < 0.0 || mass < 0.0) {
        r.faults.push(
            range_fault(
                &rayleigh.second,
                "these pairs need a negative coefficient",
                "both coefficients ≥ 0",
            )
            .found(format!("a_M = {mass:.4e} 1/s, a_K = {stiffness:.4e} s"))
            .help("choose other pairs, or set allow_negative to repeat a published run"),
        );
    }
    (first, second, allow_negative)
}

fn damping_model(
    r: &mut Resolver<'_>,
    field: &Field<schema::AnalysisDamping>,
    model: &schema::AnalysisDamping,
) -> linear::DampingModel {
    match (&model.rayleigh, &model.coefficients) {
        (
            Some(Field {
                value: Some(rayleigh), ..
            }),
            None,
        ) => {
            let (first, second, allow_negative) = self::rayleigh(r, rayleigh);
            linear::DampingModel::Rayleigh {
                first,
                second,
                allow_negative,
            }
        }
        (None, Some(Field { value: Some(c), .. })) => linear::DampingModel::Coefficients {
            mass: r.number(&c.mass, Limits::from(-1e6).to(1e6)),
            stiffness: r.number(&c.stiffness, Limits::from(-1e6).to(1e6)),
        },
        (Some(Field { value: None, .. }), None) | (None, Some(Field { value: None, .. })) => {
            linear::DampingModel::Modal
        }
        (Some(_), Some(_)) | (None, None) => {
            r.faults.push(
                range_fault(field, "one damping model is wanted", "either rayleigh or coefficients")
                    .help("leave analysis.damping out for the modal ratios of `damping`"),
            );
            linear::DampingModel::Modal
        }
    }
}

/// A value of this quantity, positive.
fn value(r: &mut Resolver<'_>, field: &Field<Raw>, what: Quantity) -> f64 {
    let value = field.value.as_ref().and_then(|raw| match what.dimension() {
        // Periods are as often published as frequencies.
        Dimension::Time => Pitch::from_node(&raw.0, r.faults).map(|p| 2.0 * std::f64::consts::PI / p.0),
        dimension => quantity(&raw.0, dimension, r.faults),
    });
    r.echo_given(field);
    match value {
        Some(value) if (0.0..=1e18).contains(&value) => value,
        Some(_) => {
            r.faults.push(range_fault(
                field,
                "out of range",
                "values are absolute maxima, 0 or greater",
            ));
            f64::NAN
        }
        None => f64::NAN,
    }
}

/// Measured values.
pub(super) fn measured(r: &mut Resolver<'_>, field: &Option<Field<Measured>>) -> Vec<Reported> {
    let mut all = Vec::new();
    for (quantity, field) in field.iter().filter_map(|f| f.value.as_ref()).flat_map(|m| &m.0) {
        let Some(given) = &field.value else { continue };
        all.push(Reported {
            quantity: *quantity,
            value: value(r, &given.value, *quantity),
            source: r.text(&given.source).unwrap_or_default(),
            note: given.note.as_ref().and_then(|n| r.text(n)),
        });
    }
    all
}

/// Published values.
pub(super) fn published(r: &mut Resolver<'_>, field: &Option<Field<Vec<Field<schema::Published>>>>) -> Vec<Reported> {
    let mut all = Vec::new();
    for given in field
        .iter()
        .filter_map(|f| f.value.as_ref())
        .flatten()
        .filter_map(|p| p.value.as_ref())
    {
        r.echo_given(&given.quantity);
        let Some(quantity) = given.quantity.value else { continue };
        all.push(Reported {
            quantity: quantity.0,
            value: value(r, &given.value, quantity.0),
            source: r.text(&given.source).unwrap_or_default(),
            note: given.note.as_ref().and_then(|n| r.text(n)),
        });
    }
    all
}
