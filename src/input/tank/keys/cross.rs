//! Checks between values of different sections, and unused materials.

use files::code::Code;
use std::collections::BTreeSet;

use tank::case::Components;
use tank::units::{Dimension, Unit};
use tank::{Liquid, Shape, Tank};

use super::file::TankFile;
use super::wall::{Course, Layer, THICKNESS};
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
    if let (Some(liquid), Some(given), Some(courses)) = (liquid, &file.liquid.value, &t.courses.value) {
        // Uses only the heights, so that a misspelt material does not hide this fault.
        let heights: Option<Vec<f64>> = courses
            .iter()
            .map(|c| c.value.as_ref().and_then(|c| c.height.value).map(|h| h.0))
            .collect();
        // A list without courses is a fault already.
        let heights = heights.filter(|heights| !heights.is_empty());
        let wall = heights.map_or(f64::NAN, |h| h.iter().sum());
        if liquid.fill_height > wall * (1.0 + ROUNDING) {
            let field = &given.fill_height;
            r.faults.push(
                range_fault(
                    Code::LiquidAboveWall,
                    field,
                    "the liquid is higher than the wall",
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
    shallow(r, file, tank, liquid);
    let components = (file.site.value())
        .and_then(|site| site.ec8.value())
        .and_then(|ec8| ec8.components.given.as_ref());
    if let (Shape::Rectangle { .. }, Some(field)) = (tank.shape, components)
        && field.value == Some(Components::HundredThirty)
    {
        let fault = range_fault(Code::DoesNotApply, field, "two components are for cylinders", "\"one\"");
        r.faults
            .push(fault.help("assess the other direction with length and breadth exchanged"));
    }
    if let (Some(roof), Some(height)) = (t.roof.value(), tank.roof.height)
        && let Some(field) = &roof.height.given
    {
        let half = 0.5 * tank.wall_height();
        let fill = liquid.map_or(0.0, |liquid| liquid.fill_height);
        let (least, message, what) = match fill > half {
            true => (fill, "the roof is below the surface of the liquid", "the fill height"),
            false => (
                half,
                "the roof is in the lower half of the wall",
                "half the height of the wall",
            ),
        };
        if height < least * (1.0 - ROUNDING) {
            let allowed = format!("at least {}, {what}", like_field(field, least));
            r.faults
                .push(range_fault(Code::Contradiction, field, message, &allowed));
        }
    }
    if let (Some(roof), Some(liquid)) = (t.roof.value(), liquid)
        && tank.roof.afloat > 0.0
        && tank.roof.afloat >= liquid.mass(tank.shape)
    {
        r.faults.push(range_fault(
            Code::Contradiction,
            &roof.mass,
            "the floating roof is heavier than the liquid",
            "less than the mass of the liquid, which contains the roof's",
        ));
    }
    let half = tank.shape.half_length();
    let (thickest, what) = match tank.shape {
        Shape::Cylinder { .. } => (half / 5.0, "a fifth of the radius"),
        Shape::Rectangle { .. } => (half / 2.0, "a quarter of the length"),
    };
    let thinnest = half / 20_000.0;
    let plan = t.radius.given.as_ref().or(t.length.given.as_ref());
    let courses: Vec<&Course> = (t.courses.value.iter().flatten())
        .filter_map(|c| c.value.as_ref())
        .collect();
    let mut plates: Vec<&Field<Length>> = courses.iter().filter_map(|c| c.thickness.given.as_ref()).collect();
    plates.extend(courses.iter().flat_map(|c| layers(c)).map(|l| &l.thickness));
    plates.extend(t.bottom.value().map(|b| &b.thickness));
    plates.retain(|field| field.value.is_some_and(|l| THICKNESS.hold(l.0)));
    let thicknesses: Vec<f64> = plates.iter().filter_map(|field| field.value).map(|l| l.0).collect();
    let impossible = |half: f64| {
        let thickest = thickest / tank.shape.half_length() * half;
        let outside = |t: &&f64| **t > thickest || **t < half / 20_000.0;
        thicknesses.iter().filter(outside).count()
    };
    // Several plates that all contradict one dimension: that dimension is wrong, not each of them.
    if let Some(field) = plan
        && thicknesses.len() > 1
        && impossible(half) == thicknesses.len()
    {
        let key = if t.radius.given.is_some() { "radius" } else { "length" };
        let whole = match tank.shape {
            Shape::Cylinder { .. } => 1.0,
            Shape::Rectangle { .. } => 0.5,
        };
        let small = thicknesses.iter().all(|t| *t > thickest);
        let largest = thicknesses.iter().copied().fold(0.0, f64::max);
        let least = thicknesses.iter().copied().fold(f64::INFINITY, f64::min);
        let (message, allowed) = match small {
            true => (
                format!("the {key} is too small for the thickness of the wall"),
                format!("at least {}", like_field(field, largest * half / thickest / whole)),
            ),
            false => (
                format!("the {key} is too large for the thickness of the wall"),
                format!("at most {}", like_field(field, least * 20_000.0 / whole)),
            ),
        };
        let mut fault = range_fault(Code::OutOfRange, field, &message, &allowed);
        if let Some(meant) = meant(&field.text, &["m", "ft", "cm", "mm"], |size| {
            impossible(whole * size) == 0
        }) {
            fault = fault.help(format!("did you mean \"{meant}\"?"));
        }
        r.faults.push(fault);
        return;
    }
    for field in plates {
        let Some(Length(thickness)) = field.value else { continue };
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
        let mut fault = range_fault(Code::OutOfRange, field, message, &allowed);
        // R/t from 20 to 5000.
        let usual = |thickness: f64| (half / 5000.0..=half / 20.0).contains(&thickness);
        if let Some(meant) = meant(&field.text, &["mm", "cm", "m", "in"], usual) {
            fault = fault.help(format!("did you mean \"{meant}\"?"));
        }
        r.faults.push(fault);
    }
}

/// A film on the bottom, for which there are neither waves nor modes.
fn shallow(r: &mut Resolver<'_>, file: &TankFile, tank: &Tank, liquid: Option<Liquid>) {
    let (Some(liquid), Some(given)) = (liquid, &file.liquid.value) else {
        return;
    };
    let (half, what) = match tank.shape {
        Shape::Cylinder { radius } => (radius, "a thousandth of the radius"),
        Shape::Rectangle { length, .. } => (length / 2.0, "a thousandth of half the length"),
    };
    if liquid.fill_height < SHALLOWEST * half * (1.0 - ROUNDING) {
        let field = &given.fill_height;
        let allowed = format!("at least {}, {what}", like_field(field, SHALLOWEST * half));
        let fault = range_fault(
            Code::OutOfRange,
            field,
            "the liquid is shallower than any tank's",
            &allowed,
        );
        r.faults
            .push(fault.help("correct the unit; an empty tank is not assessed"));
    }
}

/// The same number with the first of these units that makes it a usual length, if there is one.
fn meant(text: &str, units: &[&str], usual: impl Fn(f64) -> bool) -> Option<String> {
    let number = text
        .trim()
        .trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.')
        .trim_end();
    let value: f64 = number.parse().ok()?;
    units.iter().find_map(|unit| {
        let length = value * Unit::find(unit, Dimension::Length)?.factor();
        usual(length).then(|| format!("{number} {unit}"))
    })
}

/// Adds a remark for each unused material.
pub(super) fn unused(r: &mut Resolver<'_>, file: &TankFile) {
    let (Some(tank), Some(materials)) = (&file.tank.value, &file.materials.value) else {
        return;
    };
    let courses = (tank.courses.value.iter().flatten()).filter_map(|c| c.value.as_ref());
    let layered = courses.clone().flat_map(layers);
    let bars = layered.clone().filter_map(|l| l.reinforcement.value());
    let bars = bars.chain(courses.clone().filter_map(|c| c.reinforcement.value()));
    let bars = bars.flatten().filter_map(|b| b.value.as_ref());
    let bottom = tank.bottom.value().map(|b| &b.material);
    let used: BTreeSet<&String> = (courses.filter_map(|c| c.material.given.as_ref()))
        .chain(layered.map(|l| &l.material))
        .chain(bars.map(|b| &b.material))
        .chain(bottom)
        .filter_map(|m| m.value.as_ref())
        .collect();
    for (name, field) in materials.0.iter().filter(|(name, _)| !used.contains(name)) {
        r.remarks.push(format!("{}: material `{name}` is unused", field.path));
    }
}

/// The readable layers of a course.
fn layers(course: &Course) -> impl Iterator<Item = &Layer> + Clone {
    let list = course.layers.value();
    list.into_iter().flatten().filter_map(|l| l.value.as_ref())
}
