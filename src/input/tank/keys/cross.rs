//! Checks between values of different sections, and unused materials.

use files::code::Code;
use std::collections::BTreeSet;

use tank::case::Components;
use tank::units::{Dimension, Unit};
use tank::{Liquid, Shape, Tank};

use super::file::TankFile;
use super::roof::Roof;
use super::tank::Tank as TankKeys;
use super::wall::{Course, Layer, THICKNESS};
use crate::input::diagnostic::Fault;
use crate::input::tank::read::Field;
use crate::input::tank::resolver::{Resolver, like_field, range_fault};
use crate::input::tank::values::Length;

/// Slack for heights that are sums of decimal fractions.
const ROUNDING: f64 = 1e-9;
/// Least depth of the liquid over the radius, or half the length.
const SHALLOWEST: f64 = 1e-3;

/// Checks values that are valid one by one but not together.
pub(super) fn checks(r: &mut Resolver<'_>, file: &TankFile, tank: Option<&Tank>, liquid: Option<Liquid>) {
    let Some(t) = &file.tank.value else { return };
    overfilled(r, file, t, liquid);
    let Some(tank) = tank else { return };
    shallow(r, file, tank, liquid);
    let components =
        (file.site.value()).and_then(|site| site.ec8.value()).and_then(|ec8| ec8.components.given.as_ref());
    if let (Shape::Rectangle { .. }, Some(field)) = (tank.shape, components)
        && field.value == Some(Components::HundredThirty)
    {
        let fault = range_fault(Code::DoesNotApply, field, "two components are for cylinders", "\"one\"");
        r.faults.push(fault.help("assess the other direction with length and breadth exchanged"));
    }
    if let Some(given) = t.roof.value() {
        roof(r, given, tank, liquid);
    }
    thicknesses(r, t, tank.shape);
}

/// A liquid above the wall, whose height comes from the heights of the courses, so that a misspelt material does not hide this fault.
fn overfilled(r: &mut Resolver<'_>, file: &TankFile, t: &TankKeys, liquid: Option<Liquid>) {
    let (Some(liquid), Some(given), Some(courses)) = (liquid, &file.liquid.value, &t.courses.value) else { return };
    let heights: Option<Vec<f64>> =
        courses.iter().map(|c| c.value.as_ref().and_then(|c| c.height.value).map(|h| h.0)).collect();
    // A list without courses is a fault already.
    let heights = heights.filter(|heights| !heights.is_empty());
    let wall = heights.map_or(f64::NAN, |h| h.iter().sum());
    if liquid.fill_height > wall * (1.0 + ROUNDING) {
        let field = &given.fill_height;
        let most = like_field(field, wall);
        let allowed = format!("at most {most}, the sum of the heights of tank.courses");
        let message = "the liquid is higher than the wall";
        let fault = range_fault(Code::LiquidAboveWall, field, message, &allowed);
        r.faults.push(fault.help("lower fill_height or add a course"));
    }
}

/// A roof in the liquid or in the lower half of the wall, and one that sinks.
fn roof(r: &mut Resolver<'_>, given: &Roof, tank: &Tank, liquid: Option<Liquid>) {
    if let (Some(height), Some(field)) = (tank.roof.height, &given.height.given) {
        let half = 0.5 * tank.wall_height();
        let fill = liquid.map_or(0.0, |liquid| liquid.fill_height);
        let (least, message, what) = match fill > half {
            true => (fill, "the roof is below the surface of the liquid", "the fill height"),
            false => (half, "the roof is in the lower half of the wall", "half the height of the wall"),
        };
        if height < least * (1.0 - ROUNDING) {
            let allowed = format!("at least {}, {what}", like_field(field, least));
            r.refuse(Code::Contradiction, field, message, &allowed);
        }
    }
    if liquid.is_some_and(|liquid| tank.roof.afloat > 0.0 && tank.roof.afloat >= liquid.mass(tank.shape)) {
        let message = "the floating roof is heavier than the liquid";
        let allowed = "less than the mass of the liquid, which contains the roof's";
        let internal = given.internal_floating.place().filter(|_| tank.roof.kind.is_fixed());
        r.refuse(Code::Contradiction, &internal.unwrap_or_else(|| given.mass.place()), message, allowed);
    }
}

/// Bounds of the thickness of the plates of a tank.
struct Bounds {
    /// Thickest plate over the half length.
    thickest: f64,
    /// Share of a plan dimension of the tank file that is its half length.
    whole: f64,
    /// The thickest plate in words.
    what: &'static str,
}

impl Bounds {
    /// Half length over the thinnest plate.
    const THINNEST: f64 = 20_000.0;

    const fn of(shape: Shape) -> Bounds {
        match shape {
            Shape::Cylinder { .. } => Bounds { thickest: 5.0, whole: 1.0, what: "a fifth of the radius" },
            Shape::Rectangle { .. } => Bounds { thickest: 2.0, whole: 0.5, what: "a quarter of the length" },
        }
    }

    /// Whether no tank of this half length [m] has a plate this thick or thin [m].
    fn exclude(&self, half: f64, thickness: f64) -> bool {
        thickness > half / self.thickest || thickness < half / Self::THINNEST
    }
}

/// Plates that are too thick or too thin for the tank, or a tank that is too small or too large for all its plates.
fn thicknesses(r: &mut Resolver<'_>, t: &TankKeys, shape: Shape) {
    let courses: Vec<&Course> = (t.courses.value.iter().flatten()).filter_map(|c| c.value.as_ref()).collect();
    let mut plates: Vec<&Field<Length>> = courses.iter().filter_map(|c| c.thickness.given.as_ref()).collect();
    plates.extend(courses.iter().flat_map(|c| layers(c)).map(|l| &l.thickness));
    plates.extend(t.bottom.value().map(|b| &b.thickness));
    let plates: Vec<(&Field<Length>, f64)> = (plates.into_iter())
        .filter_map(|field| Some((field, field.value?.0)))
        .filter(|(_, thickness)| THICKNESS.hold(*thickness))
        .collect();
    let bounds = Bounds::of(shape);
    let half = shape.half_length();
    // Several plates that all contradict one dimension: that dimension is wrong, not each of them.
    if let Some(field) = t.radius.given.as_ref().or(t.length.given.as_ref())
        && plates.len() > 1
        && plates.iter().all(|(_, t)| bounds.exclude(half, *t))
    {
        let key = if t.radius.given.is_some() { "radius" } else { "length" };
        let thicknesses: Vec<f64> = plates.iter().map(|(_, thickness)| *thickness).collect();
        wrong_dimension(r, (key, field), &thicknesses, (half, &bounds));
        return;
    }
    for (field, thickness) in plates.into_iter().filter(|(_, t)| bounds.exclude(half, *t)) {
        let (message, allowed) = if thickness > half / bounds.thickest {
            let most = like_field(field, half / bounds.thickest);
            ("the wall is thicker than any tank's", format!("at most {most}, {}", bounds.what))
        } else {
            let least = like_field(field, half / Bounds::THINNEST);
            ("the wall is thinner than any tank's", format!("at least {least}, R/20000"))
        };
        // R/t from 20 to 5000.
        let usual = |thickness: f64| (half / 5000.0..=half / 20.0).contains(&thickness);
        let fault = range_fault(Code::OutOfRange, field, message, &allowed);
        r.faults.push(suggest(fault, meant(&field.text, &["mm", "cm", "m", "in"], usual)));
    }
}

/// A radius or length that contradicts the thickness of every plate.
fn wrong_dimension(
    r: &mut Resolver<'_>,
    (key, field): (&str, &Field<Length>),
    thicknesses: &[f64],
    (half, bounds): (f64, &Bounds),
) {
    let small = thicknesses.iter().all(|t| *t > half / bounds.thickest);
    let (size, bound) = match small {
        true => {
            let largest = thicknesses.iter().copied().fold(0.0, f64::max);
            let least = largest * bounds.thickest / bounds.whole;
            ("small", format!("at least {}", like_field(field, least)))
        }
        false => {
            let least = thicknesses.iter().copied().fold(f64::INFINITY, f64::min);
            let most = least * Bounds::THINNEST / bounds.whole;
            ("large", format!("at most {}", like_field(field, most)))
        }
    };
    let message = format!("the {key} is too {size} for the thickness of the wall");
    let fits = |length: f64| !thicknesses.iter().any(|t| bounds.exclude(bounds.whole * length, *t));
    let fault = range_fault(Code::OutOfRange, field, &message, &bound);
    r.faults.push(suggest(fault, meant(&field.text, &["m", "ft", "cm", "mm"], fits)));
}

/// A fault with the value that was probably meant.
fn suggest(fault: Fault, meant: Option<String>) -> Fault {
    match meant {
        Some(meant) => fault.help(format!("did you mean \"{meant}\"?")),
        None => fault,
    }
}

/// A film on the bottom, for which there are neither waves nor modes.
fn shallow(r: &mut Resolver<'_>, file: &TankFile, tank: &Tank, liquid: Option<Liquid>) {
    let (Some(liquid), Some(given)) = (liquid, &file.liquid.value) else { return };
    let (half, what) = match tank.shape {
        Shape::Cylinder { radius } => (radius, "a thousandth of the radius"),
        Shape::Rectangle { length, .. } => (length / 2.0, "a thousandth of half the length"),
    };
    if liquid.fill_height < SHALLOWEST * half * (1.0 - ROUNDING) {
        let field = &given.fill_height;
        let allowed = format!("at least {}, {what}", like_field(field, SHALLOWEST * half));
        let message = "the liquid is shallower than any tank's";
        let fault = range_fault(Code::OutOfRange, field, message, &allowed);
        r.faults.push(fault.help("correct the unit; an empty tank is not assessed"));
    }
}

/// The same number with the first of these units that makes it a usual length, if there is one.
fn meant(text: &str, units: &[&str], usual: impl Fn(f64) -> bool) -> Option<String> {
    let number = text.trim().trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.').trim_end();
    let value: f64 = number.parse().ok()?;
    units.iter().find_map(|unit| {
        let length = value * Unit::find(unit, Dimension::Length)?.factor();
        usual(length).then(|| format!("{number} {unit}"))
    })
}

/// Adds a remark for each unused material.
pub(super) fn unused(r: &mut Resolver<'_>, file: &TankFile, used: &BTreeSet<&String>) {
    for (name, field) in file.materials.value.iter().flat_map(|named| &named.0).filter(|(name, _)| !used.contains(name))
    {
        r.remarks.push(format!("{}: material `{name}` is unused", field.path));
    }
}

/// Names of the materials of wall, bars and bottom.
pub(super) fn used(file: &TankFile) -> BTreeSet<&String> {
    let Some(tank) = &file.tank.value else { return BTreeSet::new() };
    let courses = (tank.courses.value.iter().flatten()).filter_map(|c| c.value.as_ref());
    let layered = courses.clone().flat_map(layers);
    let bars = layered.clone().filter_map(|l| l.reinforcement.value());
    let bars = bars.chain(courses.clone().filter_map(|c| c.reinforcement.value()));
    let bars = bars.flatten().filter_map(|b| b.value.as_ref());
    let bottom = tank.bottom.value().map(|b| &b.material);
    let rings = tank.rings.value().into_iter().flatten().filter_map(|ring| ring.value.as_ref());
    (courses.filter_map(|c| c.material.given.as_ref()))
        .chain(layered.map(|l| &l.material))
        .chain(bars.map(|b| &b.material))
        .chain(bottom)
        .chain(rings.map(|ring| &ring.material))
        .filter_map(|m| m.value.as_ref())
        .collect()
}

/// The readable layers of a course.
fn layers(course: &Course) -> impl Iterator<Item = &Layer> + Clone {
    let list = course.layers.value();
    list.into_iter().flatten().filter_map(|l| l.value.as_ref())
}
