//! A tank that lifts: what stands on the ground in plan with the pressure there, and its positions over a cycle.

use tank::units::Dimension;

use super::svg::{Anchor, Svg, path_data};
use super::wall::{self, BAR, STEPS};
use super::{HALF, WIDE, ticks};
use crate::number::{Scale, with_unit};
use crate::words::uplift as words;
use results::GroundPlan;

/// A bottom that is lifted along its rim.
#[derive(Clone, Debug)]
pub struct Plan<'a> {
    /// Radius [m].
    pub radius: f64,
    /// Distance from the rim to the ground [m] by angle [°].
    pub lifted: &'a [[f64; 2]],
    /// Pressure of the ground, where it is known.
    pub ground: Option<&'a GroundPlan>,
}

/// Highest pressure with a colour of its own, over that at rest: along the toe the ground bears several times as much on a strip too narrow to
/// be seen.
const SHOWN_PRESSURE: f64 = 2.0;

/// Highest pressure with a colour of its own [Pa].
pub fn highest_colour(ground: &GroundPlan) -> f64 {
    let most = ground.pressure.iter().flatten().copied().fold(0.0, f64::max);
    most.min(SHOWN_PRESSURE * ground.rest)
}

impl Plan<'_> {
    /// Share of the bottom that is off the ground.
    pub fn share(&self) -> f64 {
        let area: f64 = (self.lifted.windows(2))
            .map(|pair| {
                let angle = (pair[1][0] - pair[0][0]).to_radians();
                let on = |width: f64| (self.radius - width.min(self.radius)).powi(2);
                0.5 * angle * (self.radius.powi(2) - 0.5 * (on(pair[0][1]) + on(pair[1][1])))
            })
            .sum();
        area / (std::f64::consts::PI * self.radius.powi(2))
    }

    /// Size and markup.
    pub fn draw(&self) -> ((f64, f64), String) {
        let ground = self.ground.filter(|g| g.is_whole() && highest_colour(g) > 0.0);
        // The bar of the colours stands at the right.
        let (size, middle, drawn) = match ground {
            Some(_) => (HALF, (0.5 * (HALF - BAR) + 6.0, 122.0), 84.0),
            None => (HALF, (HALF / 2.0, 118.0), 96.0),
        };
        let scale = drawn / self.radius;
        // θ from the right, counter-clockwise.
        let at = |degrees: f64, r: f64| {
            let (s, c) = degrees.to_radians().sin_cos();
            (middle.0 + scale * r * c, middle.1 - scale * r * s)
        };
        let mut svg = Svg::new();
        if let Some(ground) = ground {
            svg.append(&pressures(ground, &at));
        }
        let inner = |p: &[f64; 2]| at(p[0], self.radius - p[1].min(self.radius));
        // Between rim and ground, one piece for each lifted arc.
        for arc in self.lifted.split(|p| p[1] <= 0.0).filter(|arc| arc.len() > 1) {
            let rim = arc.iter().map(|p| at(p[0], self.radius));
            let points: Vec<(f64, f64)> = rim.chain(arc.iter().rev().map(inner)).collect();
            svg.path(&points, true, "ar k-lifted");
            let edge: Vec<(f64, f64)> = arc.iter().map(inner).collect();
            svg.path(&edge, false, "ln k-lifted");
        }
        svg.circle(middle, scale * self.radius, "out");
        for (degrees, anchor, shift) in [(0.0, Anchor::Start, 6.0), (180.0, Anchor::End, -6.0)] {
            let (x, y) = at(degrees, self.radius);
            svg.text((x + shift, y + 4.0), anchor, "tk", words::SIDES[usize::from(degrees > 0.0)]);
        }
        match ground {
            Some(ground) => colours(&mut svg, ground, (middle.1 - drawn, middle.1 + drawn)),
            None => svg.text(middle, Anchor::Middle, "tk", words::ON_THE_GROUND),
        }
        ((size, 236.0), svg.into_markup())
    }
}

/// The bar of the colours.
fn colours(svg: &mut Svg, ground: &GroundPlan, y: (f64, f64)) {
    let high = highest_colour(ground);
    let scale = Scale::of(Dimension::Stress, [high]);
    let (levels, decimals) = ticks(0.0, scale.convert(high), 5);
    let range = (0.0, scale.convert(high));
    wall::bar(svg, HALF, y, range, &levels, decimals, scale.symbol());
}

/// Cells in the colours of their pressure, on both sides of the direction of the motion; one without pressure at most of its corners has none.
fn pressures(ground: &GroundPlan, at: &dyn Fn(f64, f64) -> (f64, f64)) -> String {
    let high = highest_colour(ground);
    let mut paths = vec![String::new(); STEPS];
    let edge = ground.radii[ground.radii.len() - 1];
    // A hair of overlap: no seams between neighbours.
    let (wider, further) = (0.3, 0.004 * edge);
    for (i, angles) in ground.degrees.windows(2).enumerate() {
        for (j, radii) in ground.radii.windows(2).enumerate() {
            let row = |i: usize| [ground.pressure[i][j], ground.pressure[i][j + 1]];
            let corners = [row(i), row(i + 1)].concat();
            if corners.iter().filter(|p| **p > 0.0).count() < 3 {
                continue;
            }
            let mean = corners.iter().sum::<f64>() / corners.len() as f64;
            let colour = ((mean / high * STEPS as f64) as usize).min(STEPS - 1);
            for side in [1.0, -1.0] {
                let corner = |a: usize, r: usize| {
                    let outwards = (radii[r] + r as f64 * further).min(edge);
                    at(side * (angles[a] + a as f64 * wider).min(180.0), outwards)
                };
                let cell = [corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)];
                paths[colour].push_str(&path_data(&cell));
                paths[colour].push('Z');
            }
        }
    }
    let path = |(colour, data): (usize, String)| format!(r#"<path class="v v{colour}" d="{data}"/>"#);
    let filled = paths.into_iter().enumerate().filter(|(_, data)| !data.is_empty());
    filled.map(path).collect()
}

/// A position of the tank.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    /// When [s].
    pub time: f64,
    /// Displacement of the rim at θ = 0 and 180° [m].
    pub rim: [f64; 2],
}

/// The tank in elevation.
#[derive(Clone, Copy, Debug)]
pub struct Elevation {
    /// Radius [m].
    pub radius: f64,
    /// Height of the wall [m].
    pub wall: f64,
    /// Depth of the liquid [m].
    pub depth: f64,
}

/// Places in a row.
const ACROSS: usize = 4;
/// Share of its width by which the largest uplift is drawn.
const SHOWN: f64 = 0.12;

/// Factor by which displacements are drawn, a round one.
pub fn factor(tank: &Elevation, positions: &[Position]) -> f64 {
    let most = positions.iter().flat_map(|p| p.rim).fold(0.0_f64, |m, w| m.max(w.abs()));
    if most <= 0.0 {
        return 1.0;
    }
    let wanted = SHOWN * 2.0 * tank.radius / most;
    let decade = 10_f64.powf(wanted.log10().floor());
    let round = [5.0, 2.0, 1.0].map(|step| step * decade).into_iter().find(|step| *step <= wanted);
    round.unwrap_or(decade).max(1.0)
}

/// Positions side by side: size and markup. `width` is the distance from the rim to the ground for an uplift [m].
pub fn positions(tank: &Elevation, positions: &[Position], width: &dyn Fn(f64) -> f64) -> ((f64, f64), String) {
    let cell = WIDE / ACROSS as f64;
    let scale = (0.66 * cell / (2.0 * tank.radius)).min(110.0 / tank.wall);
    let tall = scale * tank.wall + 62.0;
    let factor = factor(tank, positions);
    let mut svg = Svg::new();
    for (i, position) in positions.iter().enumerate() {
        let middle = cell * ((i % ACROSS) as f64 + 0.5);
        let ground = tall * (i / ACROSS) as f64 + scale * tank.wall + 22.0;
        let [right, left] = position.rim.map(|w| factor * w);
        let slope = 0.5 * (right - left) / tank.radius;
        let turn = slope.atan();
        let centre = 0.5 * (right + left);
        // A point of the tank, x to θ = 0 and z upwards from the foot [m].
        let at = |x: f64, z: f64| {
            let (s, c) = turn.sin_cos();
            (middle + scale * (c * x - s * z), ground - scale * (centre + s * x + c * z))
        };
        let r = tank.radius;
        let surface = |x: f64| at(x, tank.depth - x * slope);
        svg.path(&[at(-r, 0.0), at(r, 0.0), surface(r), surface(-r)], true, "liq");
        svg.path(&[at(-r, 0.0), at(-r, tank.wall), at(r, tank.wall), at(r, 0.0)], false, "out");
        svg.line((middle - 0.46 * cell, ground), (middle + 0.46 * cell, ground), "gd");
        // The plate, from the lifted rim down to the ground.
        for (side, w) in [(1.0, position.rim[0]), (-1.0, position.rim[1])] {
            if w <= 0.0 {
                continue;
            }
            let reach = width(w).min(2.0 * r);
            let rim = at(side * r, 0.0);
            let plate: Vec<(f64, f64)> = (0..=12)
                .map(|k| {
                    let share = f64::from(k) / 12.0;
                    // A curve that leaves the ground flat.
                    (rim.0 - side * scale * reach * (1.0 - share), ground - (ground - rim.1) * share.powi(3))
                })
                .collect();
            svg.path(&plate, false, "ln k-lifted");
        }
        svg.text((middle, ground + 15.0), Anchor::Middle, "lb", &words::at(position.time));
        let [front, back] = position.rim;
        let largest = front.max(back);
        let text = match largest > 0.0 {
            true => words::lifts(&with_unit(largest, Dimension::Length), front < back),
            false => words::STANDS.to_owned(),
        };
        svg.text((middle, ground + 28.0), Anchor::Middle, "tk", &text);
    }
    let rows = positions.len().div_ceil(ACROSS);
    ((WIDE, tall * rows as f64), svg.into_markup())
}
