//! Tank and liquid, and what must hold between values.

use std::collections::BTreeSet;

use tank::units::{Dimension, Unit};
use tank::{Anchors, Bottom, Liquid, Roof, Shape, Support, Tank};

use super::materials::Materials;
use super::wall::{self, Use};
use super::{Limits, Resolver, like_field, range_fault};
use crate::input::tank::read::Field;
use crate::input::tank::schema;
use crate::input::tank::syntax::join;
use crate::input::tank::values::Length;

/// Plan dimensions and the height of the roof, from the smallest laboratory tank up; the upper bound catches mm written as m.
const SIZE: Limits = Limits::from(1e-3).to(1000.0);
/// Heights of courses and of the liquid. What is too low for an engine depends on the radius: the engine refuses it.
pub(super) const HEIGHT: Limits = Limits::above(0.0).to(1000.0);
/// Wall and plate thicknesses; the least follows from the radius.
pub(super) const THICKNESS: Limits = Limits::above(0.0).to(10.0);
/// Liquids, from hydrogen (71 kg/m³) to mercury (13 600 kg/m³): `1 kg/m3` for water is a slip of the unit.
const LIQUID_DENSITY: Limits = Limits::above(50.0).to(15_000.0);
/// Slack for heights that are sums of decimal fractions.
const ROUNDING: f64 = 1e-9;

/// The tank.
pub(super) fn tank(r: &mut Resolver<'_>, field: &Field<schema::Tank>, materials: &Materials) -> Option<Tank> {
    let t = field.value.as_ref()?;
    let shape = shape(r, field, t);
    r.echo_given(&t.support);
    let support = t.support.value.map(|s| match s {
        schema::Support::Anchored => Support::Anchored,
        schema::Support::Unanchored => Support::Unanchored,
    });
    let courses = wall::courses(r, &t.courses, materials);
    let roof = match &t.roof {
        Some(Field {
            value: Some(roof),
            path,
            ..
        }) => Roof {
            mass: r.number(&roof.mass, Limits::from(0.0).to(1e9)),
            height: r.optional(&join(path, "height"), &roof.height, SIZE, "the top of the wall"),
        },
        Some(_) => Roof::default(),
        None => {
            r.echo_default("tank.roof.mass", "0 kg", "no roof given");
            Roof::default()
        }
    };
    let bottom = match &t.bottom {
        Some(Field {
            value: Some(bottom), ..
        }) => {
            let thickness = r.number(&bottom.thickness, THICKNESS);
            wall::material(r, &bottom.material, materials, Use::Shell).map(|material| Bottom { thickness, material })
        }
        Some(_) => None,
        None => {
            r.echo_default(
                "tank.bottom",
                "not given",
                "checks of uplift and anchorage are left out",
            );
            None
        }
    };
    let anchors = t
        .anchors
        .as_ref()
        .and_then(|f| f.value.as_ref().map(|a| (a, &f.path)))
        .map(|(a, path)| {
            r.echo_given(&a.count);
            let count = a.count.value.map_or(0, |c| c.0);
            if a.count.value.is_some() && !(1..=10_000).contains(&count) {
                r.faults
                    .push(range_fault(&a.count, "out of range", "a whole number from 1 to 10000"));
            }
            let capacity = r.optional(
                &join(path, "capacity"),
                &a.capacity,
                Limits::above(0.0).to(1e9),
                "the force of an anchor is given without a check",
            );
            Anchors { count, capacity }
        });
    if support == Some(Support::Unanchored)
        && let Some(anchors) = &t.anchors
    {
        r.faults.push(range_fault(
            anchors,
            "an unanchored tank with anchors",
            "either \"support\": \"anchored\" or no anchors",
        ));
    }
    Some(Tank {
        shape: shape?,
        support: support?,
        courses: courses?,
        roof,
        bottom,
        anchors,
    })
}

fn shape(r: &mut Resolver<'_>, field: &Field<schema::Tank>, t: &schema::Tank) -> Option<Shape> {
    r.echo_given(&t.shape);
    let kind = t.shape.value?;
    let (word, foreign) = match kind {
        schema::Shape::Cylinder => (
            "cylinder",
            vec![("length", t.length.as_ref()), ("breadth", t.breadth.as_ref())],
        ),
        schema::Shape::Rectangle => ("rectangle", vec![("radius", t.radius.as_ref())]),
    };
    let allowed = match kind {
        schema::Shape::Cylinder => "radius for a cylinder",
        schema::Shape::Rectangle => "length and breadth (or strip) for a rectangle",
    };
    for (key, given) in foreign {
        if let Some(given) = given {
            r.faults
                .push(range_fault(given, &format!("a {word} has no {key}"), allowed));
        }
    }
    match kind {
        schema::Shape::Cylinder => {
            if let Some(strip) = &t.strip {
                r.faults.push(range_fault(strip, "a cylinder has no strip", allowed));
            }
            Some(Shape::Cylinder {
                radius: required(r, field, "radius", &t.radius),
            })
        }
        schema::Shape::Rectangle => {
            let length = required(r, field, "length", &t.length);
            if let Some(strip) = &t.strip {
                r.echo_given(strip);
            }
            let strip = t.strip.as_ref().is_some_and(|s| s.value == Some(true));
            let breadth = match (&t.breadth, strip) {
                (Some(breadth), true) => {
                    r.faults.push(range_fault(
                        breadth,
                        "a strip has no breadth",
                        "either breadth or \"strip\": true",
                    ));
                    f64::NAN
                }
                (None, true) => {
                    r.echo_default("tank.breadth", "1 m", "strip: results are per metre of breadth");
                    1.0
                }
                (_, false) => required(r, field, "breadth", &t.breadth),
            };
            Some(Shape::Rectangle { length, breadth, strip })
        }
    }
}

/// A dimension that the shape requires.
fn required(r: &mut Resolver<'_>, tank: &Field<schema::Tank>, key: &str, field: &Option<Field<Length>>) -> f64 {
    match field {
        Some(field) => r.number(field, SIZE),
        // A misspelt key has been noted already, with this one as the suggestion.
        None if r.faults.suggest(&format!("did you mean `{key}`?")) => f64::NAN,
        None => {
            let alternative = if key == "breadth" { ", or \"strip\": true" } else { "" };
            let missing = Field::<Length> {
                value: None,
                span: tank.span.start..tank.span.start + 1,
                path: join(&tank.path, key),
                text: String::new(),
            };
            let allowed = SIZE.describe(Dimension::Length);
            r.faults.push(
                range_fault(&missing, &format!("the key `{key}` is missing"), &allowed)
                    .help(format!("add \"{key}\": \"1.83 m\"{alternative}")),
            );
            f64::NAN
        }
    }
}

/// The liquid.
pub(super) fn liquid(r: &mut Resolver<'_>, field: &Field<schema::Liquid>) -> Option<Liquid> {
    let l = field.value.as_ref()?;
    Some(Liquid {
        density: r.number(&l.density, LIQUID_DENSITY),
        fill_height: r.number(&l.fill_height, HEIGHT),
    })
}

/// What must hold between values, each of which is right on its own.
pub(super) fn cross_checks(r: &mut Resolver<'_>, file: &schema::TankFile, tank: Option<&Tank>, liquid: Option<Liquid>) {
    let Some(t) = &file.tank.value else { return };
    if let (Some(liquid), Some(given), Some(courses)) = (liquid, &file.liquid.value, &t.courses.value) {
        // Heights alone decide, so that a misspelt material does not hide this fault.
        let heights: Option<Vec<f64>> = courses
            .iter()
            .map(|c| c.value.as_ref().and_then(|c| c.height.value).map(|h| h.0))
            .collect();
        let wall = heights.map_or(f64::NAN, |h| h.iter().sum());
        if liquid.fill_height > wall * (1.0 + ROUNDING) {
            let field = &given.fill_height;
            r.faults.push(
                range_fault(
                    field,
                    "the liquid stands above the wall: the courses end below fill_height",
                    &format!(
                        "at most {}, the sum of the heights of tank.courses",
                        like_field(field, wall)
                    ),
                )
                .help("lower fill_height or add a course"),
            );
        }
    }
    let Some(tank) = tank else { return };
    if let (Some(Field { value: Some(roof), .. }), Some(height)) = (&t.roof, tank.roof.height)
        && let Some(field) = &roof.height
        && height < 0.5 * tank.wall_height()
    {
        let allowed = format!(
            "at least {}, half the height of the wall",
            like_field(field, 0.5 * tank.wall_height())
        );
        r.faults.push(range_fault(
            field,
            "the roof lies in the lower half of the wall",
            &allowed,
        ));
    }
    let half = tank.shape.half_length();
    let (thickest, what) = match tank.shape {
        Shape::Cylinder { .. } => (half / 5.0, "a fifth of the radius"),
        Shape::Rectangle { .. } => (half / 2.0, "a quarter of the length"),
    };
    let thinnest = half / 20_000.0;
    let courses: Vec<&schema::Course> = (t.courses.value.iter().flatten())
        .filter_map(|c| c.value.as_ref())
        .collect();
    let mut plates: Vec<&Field<Length>> = courses.iter().filter_map(|c| c.thickness.as_ref()).collect();
    plates.extend(courses.iter().flat_map(|c| layers(c)).map(|l| &l.thickness));
    plates.extend(t.bottom.as_ref().and_then(|b| b.value.as_ref()).map(|b| &b.thickness));
    for field in plates {
        let Some(Length(thickness)) = field.value.filter(|l| THICKNESS.hold(l.0)) else {
            continue;
        };
        let (message, allowed) = if thickness > thickest {
            (
                "the wall is thicker than any tank's",
                format!("at most {}, {what}", like_field(field, thickest)),
            )
        } else if thickness < thinnest {
            (
                "the wall is thinner than any tank's",
                format!("at least {}, R/20000", like_field(field, thinnest)),
            )
        } else {
            continue;
        };
        let mut fault = range_fault(field, message, &allowed);
        if let Some(meant) = meant_thickness(&field.text, half) {
            fault = fault.help(format!("did you mean \"{meant}\"?"));
        }
        r.faults.push(fault);
    }
}

/// The same number with the unit that makes it a usual thickness (R/t from 20 to 5000), if there is one.
fn meant_thickness(text: &str, half: f64) -> Option<String> {
    let number = text
        .trim()
        .trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.')
        .trim_end();
    let value: f64 = number.parse().ok()?;
    ["mm", "cm", "m", "in"].into_iter().find_map(|unit| {
        let thickness = value * Unit::find(unit, Dimension::Length)?.factor();
        (half / 5000.0..=half / 20.0)
            .contains(&thickness)
            .then(|| format!("{number} {unit}"))
    })
}

/// Materials that nothing is made of: no fault, but worth saying.
pub(super) fn unused(r: &mut Resolver<'_>, file: &schema::TankFile) {
    let (Some(tank), Some(materials)) = (&file.tank.value, &file.materials.value) else {
        return;
    };
    let courses = (tank.courses.value.iter().flatten()).filter_map(|c| c.value.as_ref());
    let layered = courses.clone().flat_map(layers);
    let bars = layered.clone().filter_map(|l| l.reinforcement.as_ref()?.value.as_ref());
    let bars = bars.flatten().filter_map(|b| b.value.as_ref());
    let bottom = tank.bottom.iter().filter_map(|b| b.value.as_ref()).map(|b| &b.material);
    let used: BTreeSet<&String> = (courses.filter_map(|c| c.material.as_ref()))
        .chain(layered.map(|l| &l.material))
        .chain(bars.map(|b| &b.material))
        .chain(bottom)
        .filter_map(|m| m.value.as_ref())
        .collect();
    for (name, field) in materials.0.iter().filter(|(name, _)| !used.contains(name)) {
        r.remarks
            .push(format!("{}: nothing is made of the material `{name}`", field.path));
    }
}

/// The layers of a course, as far as they can be read.
fn layers(course: &schema::Course) -> impl Iterator<Item = &schema::Layer> + Clone {
    let list = course.layers.as_ref().and_then(|f| f.value.as_ref());
    list.into_iter().flatten().filter_map(|l| l.value.as_ref())
}
