//! Sketch of the tank to scale: section with courses, liquid level, dimensions and scale bar; plan with the direction of
//! shaking.

use tank::units::Dimension;
use tank::{Course, Shape, Support};

use super::svg::{Anchor, Svg};
use super::width::text_width;
use crate::number::{Scale, given, plain};
use results::TankSummary;

const WIDTH: f64 = super::WIDE;
const FONT: f64 = 11.0;
/// Least distance of the labels of courses.
const LABEL: f64 = 14.0;

/// Draws the sketch; returns its size, its markup and the factor by which wall thickness is exaggerated.
pub fn draw(summary: &TankSummary) -> ((f64, f64), String, f64) {
    let tank = &summary.tank;
    let half = tank.shape.half_length();
    let wall = tank.wall_height();
    let depth = summary.liquid.fill_height;
    let plan_depth = match tank.shape {
        Shape::Cylinder { radius } => 2.0 * radius,
        Shape::Rectangle { breadth, .. } => breadth,
    };
    // Section and plan share one scale; room is left for dimensions at the left and for the courses' labels.
    let left = 118.0;
    let labels = tank.courses.iter().map(|c| text_width(&label(c)) * FONT);
    let right = 56.0 + labels.fold(120.0, f64::max).min(0.4 * WIDTH);
    let scale = ((WIDTH - left - right) / (4.0 * half))
        .min(280.0 / wall)
        .min(280.0 / plan_depth);
    let thickest = tank.courses.iter().map(|c| c.total_thickness()).fold(0.0, f64::max);
    // The thickest course becomes 7 units wide, unless it is wider to scale.
    let exaggeration = nice_factor(7.0 / (thickest * scale)).max(1.0);

    let roof = if tank.roof.mass > 0.0 { 34.0 } else { 8.0 };
    // A flat tank of many courses: their labels are higher than its wall.
    let tall = LABEL * tank.courses.len().saturating_sub(1) as f64 + 14.0;
    let top = f64::max(10.0 + roof, tall - wall * scale);
    let ground = top + wall * scale;
    let height = (ground + 70.0).max(top + plan_depth * scale + 22.0);
    let x = |r: f64| left + (r + half) * scale;
    let y = |z: f64| ground - z * scale;
    let mut svg = Svg::new();

    // Liquid.
    svg.rect(x(-half), y(depth), 2.0 * half * scale, depth * scale, "liq");
    svg.line((x(-half), y(depth)), (x(half), y(depth)), "ln k-water");
    let level = x(-half) + 0.5 * half * scale;
    svg.path(
        &[
            (level - 6.0, y(depth) - 10.0),
            (level + 6.0, y(depth) - 10.0),
            (level, y(depth) - 1.0),
        ],
        true,
        "tri",
    );
    svg.text(
        (x(0.0), y(depth / 2.0) + 4.0),
        Anchor::Middle,
        "lb halo",
        &format!("ρ = {}", given(summary.liquid.density, Dimension::Density)),
    );
    // Axis of symmetry.
    svg.line((x(0.0), top - roof), (x(0.0), ground + 8.0), "cl");
    courses(&mut svg, summary, (x(-half), x(half)), &y, exaggeration * scale);
    if tank.roof.mass > 0.0 {
        // Its shape is not known: a mass on the rim.
        svg.path(&[(x(-half), y(wall) - 4.0), (x(half), y(wall) - 4.0)], false, "dash");
        let text = format!("roof {}", given(tank.roof.mass, Dimension::Mass));
        svg.text((x(0.0), y(wall) - 10.0), Anchor::Middle, "lb", &text);
    }
    if tank.roof.afloat > 0.0 {
        let rim = y(depth + tank.roof.rim).min(y(depth) - 3.0);
        svg.rect(x(-half), rim, 2.0 * half * scale, y(depth) - rim, "wall");
    }
    // Ground and support.
    svg.line((x(-half) - 26.0, ground), (x(half) + 26.0, ground), "gd");
    let (from, to) = (x(-half) - 26.0, x(half) + 26.0);
    let mut hatch = from;
    while hatch < to {
        svg.line((hatch + 7.0, ground), (hatch, ground + 7.0), "ht");
        hatch += 9.0;
    }
    if tank.support == Support::Anchored {
        for side in [-half, half] {
            svg.line((x(side), ground), (x(side), ground + 15.0), "wl");
            svg.line((x(side) - 5.0, ground + 15.0), (x(side) + 5.0, ground + 15.0), "wl");
        }
    }

    // Dimensions at the left: depth, then wall.
    let d = x(-half) - 44.0;
    vertical_dimension(
        &mut svg,
        d,
        y(0.0),
        y(depth),
        &format!("H = {}", given(depth, Dimension::Length)),
        false,
    );
    let d = x(-half) - 90.0;
    let text = format!("wall {}", given(wall, Dimension::Length));
    vertical_dimension(&mut svg, d, y(0.0), y(wall), &text, true);
    let below = ground + 34.0;
    match tank.shape {
        Shape::Cylinder { radius } => {
            let text = format!("R = {}", given(radius, Dimension::Length));
            horizontal_dimension(&mut svg, below, x(0.0), x(half), &text);
        }
        Shape::Rectangle { length, .. } => {
            let text = format!("2L = {}", given(length, Dimension::Length));
            horizontal_dimension(&mut svg, below, x(-half), x(half), &text);
        }
    }

    let middle = (top + (plan_depth * scale / 2.0).max(20.0)).max((top + ground) / 2.0);
    plan(&mut svg, summary, (WIDTH - 12.0 - half * scale, middle), scale);
    scale_bar(&mut svg, (x(-half), ground + 64.0), scale, half.max(wall));
    ((WIDTH, height), svg.into_markup(), exaggeration)
}

/// Height, thickness and material of a course.
fn label(course: &Course) -> String {
    format!(
        "{} × {} {}",
        given(course.height, Dimension::Length),
        given(course.total_thickness(), Dimension::Length),
        course.material.name
    )
}

/// Courses with labels at the right of the section; `thickness_scale` in units per metre.
fn courses(
    svg: &mut Svg,
    summary: &TankSummary,
    (left, right): (f64, f64),
    y: &dyn Fn(f64) -> f64,
    thickness_scale: f64,
) {
    let courses = &summary.tank.courses;
    let mut base = 0.0;
    let mut labels = Vec::new();
    for course in courses {
        let (lower, upper) = (y(base), y(base + course.height));
        let width = (course.total_thickness() * thickness_scale).max(1.0);
        svg.rect(left - width, upper, width, lower - upper, "wall");
        svg.rect(right, upper, width, lower - upper, "wall");
        labels.push(((lower + upper) / 2.0, label(course)));
        base += course.height;
    }
    // Labels keep apart: pushed down from the top, then up from the bottom.
    labels.reverse();
    let mut at: Vec<f64> = labels.iter().map(|l| l.0).collect();
    for i in 1..at.len() {
        at[i] = at[i].max(at[i - 1] + LABEL);
    }
    let overflow = at.last().map_or(0.0, |l| (l - (y(0.0) - 2.0)).max(0.0));
    if overflow > 0.0 {
        let last = at.len() - 1;
        at[last] -= overflow;
        for i in (0..last).rev() {
            at[i] = at[i].min(at[i + 1] - LABEL);
        }
    }
    for ((middle, text), label) in labels.iter().zip(&at) {
        svg.path(&[(right + 9.0, *middle), (right + 22.0, *label)], false, "dm");
        svg.text((right + 26.0, label + 3.8), Anchor::Start, "lb", text);
    }
}

/// Plan with the direction of shaking, around its centre.
fn plan(svg: &mut Svg, summary: &TankSummary, (cx, cy): (f64, f64), scale: f64) {
    match summary.tank.shape {
        Shape::Cylinder { radius } => {
            let r = radius * scale;
            svg.circle((cx, cy), r, "liq");
            svg.circle((cx, cy), r, "out");
            svg.line((cx - r - 8.0, cy), (cx + r + 8.0, cy), "cl");
            svg.line((cx, cy - r - 8.0), (cx, cy + r + 8.0), "cl");
            svg.text((cx + r - 6.0, cy - 5.0), Anchor::End, "lb halo", "θ = 0");
        }
        Shape::Rectangle { length, breadth, strip } => {
            let (a, b) = (length * scale, breadth * scale);
            svg.rect(cx - a / 2.0, cy - b / 2.0, a, b, "liq");
            if strip {
                for side in [-1.0, 1.0] {
                    svg.line(
                        (cx + side * a / 2.0, cy - b / 2.0),
                        (cx + side * a / 2.0, cy + b / 2.0),
                        "wl",
                    );
                    svg.line(
                        (cx - a / 2.0, cy + side * b / 2.0),
                        (cx + a / 2.0, cy + side * b / 2.0),
                        "cl",
                    );
                }
            } else {
                svg.rect(cx - a / 2.0, cy - b / 2.0, a, b, "out");
            }
            let text = format!(
                "{} {}",
                if strip { "strip of" } else { "breadth" },
                given(breadth, Dimension::Length)
            );
            svg.text((cx, cy - b / 2.0 - 6.0), Anchor::Middle, "lb", &text);
        }
    }
    // Arrow of shaking.
    svg.line((cx - 26.0, cy + 16.0), (cx + 26.0, cy + 16.0), "ar-l");
    for side in [-1.0, 1.0] {
        svg.path(
            &[
                (cx + side * 32.0, cy + 16.0),
                (cx + side * 22.0, cy + 12.0),
                (cx + side * 22.0, cy + 20.0),
            ],
            true,
            "ar-h",
        );
    }
    svg.text((cx, cy + 33.0), Anchor::Middle, "lb halo", "shaking");
}

/// A dimension along the wall; where it is shorter than its text, the text stands `above` its upper or below its lower end.
fn vertical_dimension(svg: &mut Svg, x: f64, lower: f64, upper: f64, text: &str, above: bool) {
    svg.line((x, lower), (x, upper), "dm");
    for y in [lower, upper] {
        svg.line((x - 4.0, y + 4.0), (x + 4.0, y - 4.0), "dk");
        svg.line((x + 6.0, y), (x + 18.0, y), "dm");
    }
    let middle = (lower + upper) / 2.0;
    if lower - upper > text_width(text) * FONT + 8.0 {
        svg.rotated_text((x - 5.0, middle), -90.0, Anchor::Middle, "lb", text);
    } else {
        let centre = x.max(0.5 * text_width(text) * FONT);
        let at = if above { upper - 8.0 } else { lower + 17.0 };
        svg.text((centre, at), Anchor::Middle, "lb", text);
    }
}

fn horizontal_dimension(svg: &mut Svg, y: f64, left: f64, right: f64, text: &str) {
    svg.line((left, y), (right, y), "dm");
    for x in [left, right] {
        svg.line((x - 4.0, y + 4.0), (x + 4.0, y - 4.0), "dk");
    }
    svg.text(((left + right) / 2.0, y - 5.0), Anchor::Middle, "lb", text);
}

/// A bar of a round length, about a third of the tank, in two halves.
fn scale_bar(svg: &mut Svg, at: (f64, f64), scale: f64, size: f64) {
    let unit = Scale::single(Dimension::Length, [size]);
    let length = nice_factor(unit.convert(size) / 1.2);
    let width = length / unit.convert(1.0) * scale;
    svg.rect(at.0, at.1 - 5.0, width / 2.0, 5.0, "sb");
    svg.rect(at.0 + width / 2.0, at.1 - 5.0, width / 2.0, 5.0, "sb open");
    let text = format!("{} {}", plain(length, 3), unit.symbol());
    svg.text((at.0, at.1 - 9.0), Anchor::Middle, "tk", "0");
    svg.text((at.0 + width, at.1 - 9.0), Anchor::Middle, "tk", &text);
}

/// The largest 1, 2, 5 × 10ⁿ not above `value`.
fn nice_factor(value: f64) -> f64 {
    if !value.is_finite() || value <= 0.0 {
        return 1.0;
    }
    let power = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0]
        .into_iter()
        .map(|s| s * power)
        .find(|s| *s <= value)
        .unwrap_or(power)
}
