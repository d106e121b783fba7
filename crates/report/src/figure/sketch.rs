//! Sketch of the tank to scale: section with courses, liquid level, dimensions and scale bar; plan with the direction of
//! shaking.

use tank::units::Dimension;
use tank::{Course, Roof, RoofKind, Shape, Support};

use super::svg::{Anchor, Svg};
use super::width::text_width;
use crate::number::{Scale, given, plain};
use results::TankSummary;

const WIDTH: f64 = super::WIDE;
const FONT: f64 = 11.0;
/// Least distance of the labels of courses.
const LABEL: f64 = 14.0;
/// Height of a staging, which is not to scale.
const STAGING: f64 = 54.0;
/// Length of the tick of a ring.
const TICK: f64 = 6.0;

/// Rise of a roof as it is drawn [m]; of a cone without one that of a slope of 1 in 16, of a dome that of a sphere with the diameter as its
/// radius.
fn rise(roof: &Roof, half: f64) -> f64 {
    let usual = match roof.kind {
        RoofKind::Cone => half / 16.0,
        RoofKind::Dome => (2.0 - 3.0_f64.sqrt()) * half,
        _ => 0.0,
    };
    roof.rise.unwrap_or(usual)
}

/// Points (r, z) of a spherical cap over the width 2 `half`.
fn cap(half: f64, rise: f64) -> impl Iterator<Item = (f64, f64)> {
    let radius = (half * half + rise * rise) / (2.0 * rise);
    (0..=24).map(move |i| {
        let r = half * (f64::from(i) / 12.0 - 1.0);
        (r, (radius * radius - r * r).max(0.0).sqrt() - (radius - rise))
    })
}

/// The section of the tank on the page.
struct Section<'a> {
    summary: &'a TankSummary,
    /// Units of the page per metre.
    scale: f64,
    /// Left end of the section.
    left: f64,
    /// Level of the ground.
    ground: f64,
    /// Half length of the tank [m].
    half: f64,
    /// Height of the wall [m].
    wall: f64,
}

impl Section<'_> {
    fn x(&self, r: f64) -> f64 {
        self.left + (r + self.half) * self.scale
    }

    fn y(&self, z: f64) -> f64 {
        self.ground - z * self.scale
    }

    /// Both sides of the wall.
    fn sides(&self) -> (f64, f64) {
        (self.x(-self.half), self.x(self.half))
    }

    /// The liquid with its level and density.
    fn liquid(&self, svg: &mut Svg) {
        let depth = self.summary.liquid.fill_height;
        let ((left, right), surface) = (self.sides(), self.y(depth));
        svg.rect((left, surface), (2.0 * self.half * self.scale, depth * self.scale), "liq");
        svg.line((left, surface), (right, surface), "ln k-water");
        let level = left + 0.5 * self.half * self.scale;
        let mark = [(level - 6.0, surface - 10.0), (level + 6.0, surface - 10.0), (level, surface - 1.0)];
        svg.path(&mark, true, "tri");
        let text = format!("ρ = {}", given(self.summary.liquid.density, Dimension::Density));
        let middle = (self.x(0.0), self.y(depth / 2.0) + 4.0);
        svg.text(middle, Anchor::Middle, "lb halo", &text);
    }

    /// A cone or dome with its columns, a roof of another shape as a mass on the rim, a floating one with its rim.
    fn roof(&self, svg: &mut Svg) {
        let (left, right) = self.sides();
        let (roof, wall) = (&self.summary.tank.roof, self.y(self.wall));
        let rise = rise(roof, self.half);
        if roof.mass > 0.0 {
            let outline: Vec<(f64, f64)> = match roof.kind {
                RoofKind::Cone => vec![(left, wall), (self.x(0.0), self.y(self.wall + rise)), (right, wall)],
                RoofKind::Dome => cap(self.half, rise).map(|(r, z)| (self.x(r), self.y(self.wall + z))).collect(),
                _ => vec![(left, wall - 4.0), (right, wall - 4.0)],
            };
            svg.path(&outline, false, "dash");
            // The mass as the file has it, without a share of snow.
            let mass = roof.snow.map_or(roof.mass, |snow| snow.bare);
            let text = format!("roof {}", given(mass, Dimension::Mass));
            svg.text((self.x(0.0), self.y(self.wall + rise) - 10.0), Anchor::Middle, "lb", &text);
        }
        if let Some(ring) = roof.columns {
            let sides: &[f64] = if ring > 0.0 { &[-1.0, 1.0] } else { &[0.0] };
            for side in sides {
                let top = self.y(self.wall + rise * (1.0 - ring / self.half));
                svg.line((self.x(side * ring), self.ground), (self.x(side * ring), top), "dash");
            }
        }
        if roof.afloat > 0.0 {
            let depth = self.summary.liquid.fill_height;
            let rim = self.y(depth + roof.rim).min(self.y(depth) - 3.0);
            let size = (2.0 * self.half * self.scale, self.y(depth) - rim);
            svg.rect((left, rim), size, "wall");
        }
    }

    /// Rings as ticks outside the wall.
    ///
    /// * `thickness`: units per metre of wall thickness
    fn rings(&self, svg: &mut Svg, thickness: f64) {
        let (left, right) = self.sides();
        let tank = &self.summary.tank;
        for ring in &tank.rings {
            let wall = (tank.course_at(ring.height).total_thickness() * thickness).max(1.0);
            let y = self.y(ring.height);
            svg.line((left - wall - TICK, y), (left - wall, y), "wl");
            svg.line((right + wall, y), (right + wall + TICK, y), "wl");
        }
    }

    /// Level of the ground under a staging, or under the tank.
    fn foot(&self) -> f64 {
        self.ground + if self.summary.tank.staging.is_some() { STAGING } else { 0.0 }
    }

    /// Ground and support.
    fn ground(&self, svg: &mut Svg) {
        let ground = self.foot();
        let (from, to) = (self.x(-self.half) - 26.0, self.x(self.half) + 26.0);
        svg.line((from, ground), (to, ground), "gd");
        let mut hatch = from;
        while hatch < to {
            svg.line((hatch + 7.0, ground), (hatch, ground + 7.0), "ht");
            hatch += 9.0;
        }
        let (left, right) = self.sides();
        if let Some(staging) = self.summary.tank.staging {
            svg.line((left, self.ground), (right, self.ground), "wl");
            for side in [left, right] {
                svg.line((side, self.ground), (side, ground), "wl");
            }
            let text = format!("staging {}", given(staging.height, Dimension::Length));
            svg.text((self.x(0.0), 0.5 * (self.ground + ground) + 4.0), Anchor::Middle, "lb halo", &text);
        } else if self.summary.tank.support == Support::Anchored {
            for side in [left, right] {
                svg.line((side, ground), (side, ground + 15.0), "wl");
                svg.line((side - 5.0, ground + 15.0), (side + 5.0, ground + 15.0), "wl");
            }
        }
    }

    /// Depth and height of the wall at the left, radius or length below.
    fn dimensions(&self, svg: &mut Svg) {
        let (left, right) = self.sides();
        let depth = self.summary.liquid.fill_height;
        let text = format!("H = {}", given(depth, Dimension::Length));
        vertical_dimension(svg, left - 44.0, (self.y(0.0), self.y(depth)), &text, false);
        let text = format!("wall {}", given(self.wall, Dimension::Length));
        vertical_dimension(svg, left - 90.0, (self.y(0.0), self.y(self.wall)), &text, true);
        let (symbol, size, from) = match self.summary.tank.shape {
            Shape::Cylinder { radius } => ("R", radius, self.x(0.0)),
            Shape::Rectangle { length, .. } => ("2L", length, left),
        };
        let text = format!("{symbol} = {}", given(size, Dimension::Length));
        horizontal_dimension(svg, self.foot() + 34.0, (from, right), &text);
    }
}

/// Draws the sketch; returns its size, its markup and the factor by which wall thickness is exaggerated.
pub fn draw(summary: &TankSummary) -> ((f64, f64), String, f64) {
    let tank = &summary.tank;
    let half = tank.shape.half_length();
    let wall = tank.wall_height();
    let plan_depth = match tank.shape {
        Shape::Cylinder { radius } => 2.0 * radius,
        Shape::Rectangle { breadth, .. } => breadth,
    };
    // Section and plan share one scale; room is left for dimensions at the left and for the courses' labels.
    let left = 118.0;
    let labels = tank.courses.iter().map(|c| text_width(&label(c)) * FONT);
    let right = 56.0 + labels.fold(120.0, f64::max).min(0.4 * WIDTH);
    let scale = ((WIDTH - left - right) / (4.0 * half)).min(280.0 / wall).min(280.0 / plan_depth);
    let thickest = tank.courses.iter().map(|c| c.total_thickness()).fold(0.0, f64::max);
    // The thickest course becomes 7 units wide, unless it is wider to scale.
    let exaggeration = nice_factor(7.0 / (thickest * scale)).max(1.0);

    let roof = if tank.roof.mass > 0.0 { 34.0 + rise(&tank.roof, half) * scale } else { 8.0 };
    // A flat tank of many courses: their labels are higher than its wall.
    let tall = LABEL * tank.courses.len().saturating_sub(1) as f64 + 14.0;
    let top = f64::max(10.0 + roof, tall - wall * scale);
    let ground = top + wall * scale;
    let section = Section { summary, scale, left, ground, half, wall };
    let height = (section.foot() + 70.0).max(top + plan_depth * scale + 22.0);
    let mut svg = Svg::new();
    section.liquid(&mut svg);
    // Axis of symmetry.
    let axis = section.x(0.0);
    svg.line((axis, top - roof), (axis, ground + 8.0), "cl");
    courses(&mut svg, &section, exaggeration * scale);
    section.rings(&mut svg, exaggeration * scale);
    section.roof(&mut svg);
    section.ground(&mut svg);
    section.dimensions(&mut svg);
    let middle = (top + (plan_depth * scale / 2.0).max(20.0)).max((top + ground) / 2.0);
    plan(&mut svg, summary, (WIDTH - 12.0 - half * scale, middle), scale);
    scale_bar(&mut svg, (section.x(-half), section.foot() + 64.0), scale, half.max(wall));
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
fn courses(svg: &mut Svg, section: &Section<'_>, thickness_scale: f64) {
    let (left, right) = section.sides();
    let y = |z| section.y(z);
    let courses = &section.summary.tank.courses;
    let mut base = 0.0;
    let mut labels = Vec::new();
    for course in courses {
        let (lower, upper) = (y(base), y(base + course.height));
        let width = (course.total_thickness() * thickness_scale).max(1.0);
        svg.rect((left - width, upper), (width, lower - upper), "wall");
        svg.rect((right, upper), (width, lower - upper), "wall");
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
            svg.rect((cx - a / 2.0, cy - b / 2.0), (a, b), "liq");
            if strip {
                for side in [-1.0, 1.0] {
                    svg.line((cx + side * a / 2.0, cy - b / 2.0), (cx + side * a / 2.0, cy + b / 2.0), "wl");
                    svg.line((cx - a / 2.0, cy + side * b / 2.0), (cx + a / 2.0, cy + side * b / 2.0), "cl");
                }
            } else {
                svg.rect((cx - a / 2.0, cy - b / 2.0), (a, b), "out");
            }
            let text = format!("{} {}", if strip { "strip of" } else { "breadth" }, given(breadth, Dimension::Length));
            svg.text((cx, cy - b / 2.0 - 6.0), Anchor::Middle, "lb", &text);
        }
    }
    // Arrow of shaking.
    svg.line((cx - 26.0, cy + 16.0), (cx + 26.0, cy + 16.0), "ar-l");
    for side in [-1.0, 1.0] {
        svg.path(
            &[(cx + side * 32.0, cy + 16.0), (cx + side * 22.0, cy + 12.0), (cx + side * 22.0, cy + 20.0)],
            true,
            "ar-h",
        );
    }
    svg.text((cx, cy + 33.0), Anchor::Middle, "lb halo", "shaking");
}

/// A dimension along the wall; where it is shorter than its text, the text stands `above` its upper or below its lower end.
fn vertical_dimension(svg: &mut Svg, x: f64, (lower, upper): (f64, f64), text: &str, above: bool) {
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

fn horizontal_dimension(svg: &mut Svg, y: f64, (left, right): (f64, f64), text: &str) {
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
    svg.rect((at.0, at.1 - 5.0), (width / 2.0, 5.0), "sb");
    svg.rect((at.0 + width / 2.0, at.1 - 5.0), (width / 2.0, 5.0), "sb open");
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
    [5.0, 2.0, 1.0].into_iter().map(|s| s * power).find(|s| *s <= value).unwrap_or(power)
}
