//! Impossible values are rejected; unusual values are computed with a warning that gives the usual range.

use files::code::Code;
use std::collections::BTreeMap;

use tank::units::{Dimension, display_in, unit_for};
use tank::{LayerKind, Liquid, Shape, Tank};

use super::file::TankFile;
use super::tank::Tank as Given;
use crate::input::tank::resolver::{Resolver, like_field};
use crate::input::tank::syntax::join;

/// Usual densities of walls [kg/m³], from wood to tungsten.
const WALL_DENSITY: std::ops::RangeInclusive<f64> = 500.0..=20_000.0;
/// Largest usual H/R.
const SLENDER: f64 = 10.0;
/// Smallest usual H/R.
const SHALLOW: f64 = 0.01;
/// Largest height of the roof's mass over that of the wall.
const HIGHEST_ROOF: f64 = 10.0;
/// Slack for sums and quotients of decimal fractions.
const ROUNDING: f64 = 1e-9;

/// Proportions of tank and liquid, densities of the wall.
pub(super) fn tank(r: &mut Resolver<'_>, file: &TankFile, tank: Option<&Tank>, liquid: Option<Liquid>) {
    let (Some(tank), Some(given)) = (tank, &file.tank.value) else { return };
    densities(r, file, tank);
    thinner_below(r, given, tank);
    let (Some(liquid), Some(liquid_field)) = (liquid, &file.liquid.value) else { return };
    let fill = liquid.fill_height;
    if let (Some(roof), Some(height)) = (given.roof.value(), tank.roof.height)
        && let Some(field) = &roof.height.given
    {
        let wall = tank.wall_height();
        // Lower limits are those of the checks between sections.
        if height > HIGHEST_ROOF * wall {
            let allowed =
                format!("at most {}, {HIGHEST_ROOF} heights of the wall", like_field(field, HIGHEST_ROOF * wall));
            r.refuse(Code::OutOfRange, field, "the roof is far above the wall", &allowed);
        } else if height > wall + tank.shape.half_length() {
            r.warn(
                Code::UnusualTank,
                format!(
                    "{}: the mass of the roof is high above the wall; found {}, usual is up to {}",
                    field.path,
                    field.text,
                    like_field(field, wall + tank.shape.half_length())
                ),
            );
        }
    }
    let (what, half) = match tank.shape {
        Shape::Cylinder { radius } => ("H/R", radius),
        Shape::Rectangle { length, .. } => ("H/L (L is half the length)", length / 2.0),
    };
    let ratio = fill / half;
    let field = &liquid_field.fill_height;
    if ratio > SLENDER * (1.0 + ROUNDING) {
        r.warn(Code::UnusualTank, format!(
            "{}: unusually slender tank; found {what} = {ratio:.1}, usual is 0.3 to 3; procedures and engines are checked up to about 5",
            field.path
        ));
    }
    if ratio < SHALLOW * (1.0 - ROUNDING) {
        r.warn(Code::UnusualTank, format!(
            "{}: unusually shallow liquid; found {what} = {ratio:.2e}, usual is 0.3 to 3; below {SHALLOW} waves break and the linear \
             theory does not hold",
            field.path
        ));
    }
}

/// Courses that are thinner than the one above them, although the pressure grows downwards: two lines were exchanged, or a digit is missing.
fn thinner_below(r: &mut Resolver<'_>, given: &Given, tank: &Tank) {
    let fields: Vec<_> = (given.courses.value.iter().flatten())
        .map(|course| course.value.as_ref().and_then(|c| c.thickness.given.as_ref()))
        .collect();
    for (i, pair) in fields.windows(2).enumerate() {
        let ([Some(lower), Some(upper)], [below, above]) = (pair, &tank.courses[i..=i + 1]) else { continue };
        if below.material == above.material && below.thickness < above.thickness * (1.0 - ROUNDING) {
            r.warn(
                Code::UnusualTank,
                format!(
                    "{}: the course is thinner than the one above it; found {} below {}",
                    lower.path, lower.text, upper.text
                ),
            );
        }
    }
}

/// Densities of shells; layers between two shells may be light.
fn densities(r: &mut Resolver<'_>, file: &TankFile, tank: &Tank) {
    let mut shells: BTreeMap<&str, f64> = BTreeMap::new();
    for course in &tank.courses {
        if course.layers.is_empty() {
            shells.insert(&course.material.name, course.material.density);
        }
        for layer in course.layers.iter().filter(|l| l.kind == LayerKind::Shell) {
            shells.insert(&layer.material.name, layer.material.density);
        }
    }
    for (name, density) in shells {
        if density.is_nan() || WALL_DENSITY.contains(&density) {
            continue;
        }
        let path = join(&join(&file.materials.path, name), "density");
        r.warn(
            Code::UnusualTank,
            format!(
                "{path}: unusual density of a wall; found {}, usual is 500 to 20000 kg/m3",
                display_in(density, unit_for(density, Dimension::Density), 4)
            ),
        );
    }
}
