//! Options of the nonlinear engine.

use tank::case;
use tank::{Shape, Tank};

use super::options::{RATIO, rayleigh};
use super::{Limits, Resolver, range_fault};
use crate::input::tank::read::Field;
use crate::input::tank::schema;
use crate::input::tank::values::{Number, Time, Whole};
use tank::options::nonlinear::{Contact, Damping, Integration, MassProportionalAt, NonlinearOptions, WallElements};
use tank::options::nonlinear::{MOST_ROWS, MOST_SECTORS};

/// What is not given is the engine's own default; it is echoed if anything is given.
pub(super) fn nonlinear(
    r: &mut Resolver<'_>,
    field: &Option<Field<schema::Analysis>>,
    tank: Option<&Tank>,
    ratios: case::Damping,
) -> NonlinearOptions {
    let mut options = NonlinearOptions::new(ratios);
    let analysis = field.as_ref().and_then(|f| f.value.as_ref());
    let given = analysis
        .and_then(|a| a.nonlinear.as_ref())
        .and_then(|f| f.value.as_ref());
    let Some(given) = given else {
        return options;
    };
    let path = |key: &str| format!("analysis.nonlinear.{key}");
    options.elements = elements(r, given.elements.as_ref(), tank);
    if let (Some(symmetry), Some(Shape::Rectangle { strip: true, .. })) = (&given.symmetry, tank.map(|t| t.shape)) {
        r.faults.push(range_fault(
            symmetry,
            "a strip has no plane of symmetry",
            "symmetry for a cylinder or a rectangle",
        ));
    }
    options.symmetry = switch(
        r,
        &path("symmetry"),
        &given.symmetry,
        "half of the tank is computed, the other is its mirror image",
    );
    halves(r, given.elements.as_ref(), tank, &options);
    options.spectral_radius = r.or_default(
        &path("spectral_radius"),
        &given.spectral_radius,
        Limits::from(0.0).to(1.0),
        Number(options.spectral_radius),
        "0.9",
        "next to no numerical damping of the modes that count (Chung and Hulbert 1993)",
    );
    options.time_step = r.optional(
        &path("time_step"),
        &given.time_step,
        Limits::from(1e-6).to(1.0),
        "a twentieth of the impulsive period, at most half the step of the record",
    );
    options.damping = match given.damping.as_ref() {
        Some(field) => field
            .value
            .as_ref()
            .map_or(options.damping, |d| damping(r, field, d, ratios)),
        None => {
            r.echo_default(&path("damping"), "by group", "the ratios of `damping`");
            options.damping
        }
    };
    options.contact = match r.choice(
        &path("contact"),
        &given.contact,
        schema::Contact::Bonded,
        "bonded",
        "the liquid stays at the wall",
    ) {
        schema::Contact::Bonded => Contact::Bonded,
        schema::Contact::Opening => Contact::Opening,
    };
    options.self_weight = switch(r, &path("self_weight"), &given.self_weight, "the wall has weight");
    options.follower_pressure = switch(
        r,
        &path("follower_pressure"),
        &given.follower_pressure,
        "pressure stands on the deformed wall",
    );
    if let Some(Field { value: Some(rules), .. }) = &given.integration {
        let default = Integration::default();
        let mut rule = |field: &Option<Field<crate::input::tank::behaviour::Rule>>, default| match field {
            Some(field) => {
                r.echo_given(field);
                field.value.map_or(default, |rule| rule.0)
            }
            None => default,
        };
        options.integration = Integration {
            elastic: rule(&rules.elastic, default.elastic),
            steel: rule(&rules.steel, default.steel),
            concrete: rule(&rules.concrete, default.concrete),
        };
    } else {
        r.echo_default(
            &path("integration"),
            "gauss 2, gauss 5, midpoint 20",
            "elastic layers, steel, concrete",
        );
    }
    options.checkpoint = r.or_default(
        &path("checkpoint"),
        &given.checkpoint,
        Limits::from(1.0).to(1e6),
        Time(options.checkpoint),
        "60 s",
        "at most a minute of computing is lost",
    );
    options
}

/// True unless the file says otherwise.
fn switch(r: &mut Resolver<'_>, path: &str, field: &Option<Field<bool>>, source: &str) -> bool {
    r.choice(path, field, true, "true", source)
}

fn count(r: &mut Resolver<'_>, field: &Field<Whole>, least: u32, most: u32) -> u32 {
    r.echo_given(field);
    let Some(Whole(n)) = field.value else { return least };
    if !(least..=most).contains(&n) {
        let allowed = format!("a whole number from {least} to {most}");
        r.faults.push(range_fault(field, "out of range", &allowed));
    }
    n
}

fn elements(
    r: &mut Resolver<'_>,
    field: Option<&Field<schema::Elements>>,
    tank: Option<&Tank>,
) -> Option<WallElements> {
    let Some(field) = field else {
        r.echo_default(
            "analysis.nonlinear.elements",
            "not given",
            "by the size of the wall and its materials",
        );
        return None;
    };
    let given = field.value.as_ref()?;
    let height = count(r, &given.height, 1, MOST_ROWS);
    let strip = tank.map(|t| matches!(t.shape, Shape::Rectangle { strip: true, .. }));
    let circumference = match (&given.circumference, strip) {
        (Some(field), Some(true)) => {
            r.faults.push(range_fault(
                field,
                "a strip has no circumference",
                "height alone for a strip",
            ));
            1
        }
        (Some(field), _) => count(r, field, 8, MOST_SECTORS),
        (None, Some(false)) => {
            r.faults.push(
                range_fault(
                    field,
                    "the key `circumference` is missing",
                    &format!("a whole number from 8 to {MOST_SECTORS}"),
                )
                .found("height alone")
                .help("add \"circumference\": 64"),
            );
            8
        }
        (None, _) => 1,
    };
    Some(WallElements { height, circumference })
}

/// The half of a cylinder has half of the elements around.
fn halves(
    r: &mut Resolver<'_>,
    field: Option<&Field<schema::Elements>>,
    tank: Option<&Tank>,
    options: &NonlinearOptions,
) {
    let cylinder = matches!(tank.map(|t| t.shape), Some(Shape::Cylinder { .. }));
    let around = options.elements.map_or(0, |e| e.circumference);
    let given = field
        .and_then(|f| f.value.as_ref())
        .and_then(|e| e.circumference.as_ref());
    if let (true, true, Some(given)) = (cylinder && options.symmetry, around % 2 == 1, given) {
        r.faults.push(
            range_fault(given, "an odd number of elements around half a tank", "an even number")
                .help(format!("write {}, or add \"symmetry\": false", around + 1)),
        );
    }
}

fn damping(
    r: &mut Resolver<'_>,
    field: &Field<schema::NonlinearDamping>,
    given: &schema::NonlinearDamping,
    ratios: case::Damping,
) -> Damping {
    let default = Damping::ByGroup {
        wall: ratios.impulsive,
        sloshing: ratios.sloshing,
    };
    match (&given.by_group, &given.rayleigh, &given.mass_proportional) {
        (Some(group), None, None) => {
            let Some(group) = &group.value else { return default };
            let path = |key: &str| format!("analysis.nonlinear.damping.by_group.{key}");
            let same = |ratio: f64| (Number(ratio), ratio.to_string());
            let (wall, wall_text) = same(ratios.impulsive);
            let (sloshing, sloshing_text) = same(ratios.sloshing);
            Damping::ByGroup {
                wall: r.or_default(&path("wall"), &group.wall, RATIO, wall, &wall_text, "damping.impulsive"),
                sloshing: r.or_default(
                    &path("sloshing"),
                    &group.sloshing,
                    RATIO,
                    sloshing,
                    &sloshing_text,
                    "damping.sloshing",
                ),
            }
        }
        (None, Some(field), None) => match &field.value {
            Some(given) => {
                let (first, second, allow_negative) = rayleigh(r, given);
                Damping::Rayleigh {
                    first,
                    second,
                    allow_negative,
                }
            }
            None => default,
        },
        (None, None, Some(mass)) => {
            let Some(mass) = &mass.value else { return default };
            let ratio = r.number(&mass.ratio, RATIO);
            let at = match &mass.at {
                Some(at) => {
                    r.echo_given(at);
                    MassProportionalAt::Frequency(at.value.map_or(f64::NAN, |p| p.0))
                }
                None => {
                    r.echo_default(
                        "analysis.nonlinear.damping.mass_proportional.at",
                        "first sloshing mode",
                        "the slowest mode",
                    );
                    MassProportionalAt::FirstSloshing
                }
            };
            r.remarks.push(format!(
                "{}: proportional to the mass alone, which leaves the wall next to undamped",
                field.path
            ));
            Damping::MassProportional { ratio, at }
        }
        _ => {
            r.faults.push(range_fault(
                field,
                "one damping model is wanted",
                "one of by_group, rayleigh and mass_proportional",
            ));
            default
        }
    }
}
