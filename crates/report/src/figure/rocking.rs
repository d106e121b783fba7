//! A tank that lifts: what stands on the ground in plan, and its positions over a cycle.

use tank::units::Dimension;

use super::svg::{Anchor, Svg};
use super::{HALF, WIDE};
use crate::number::with_unit;
use crate::words::uplift as words;

/// A bottom that is lifted along its rim.
#[derive(Clone, Debug)]
pub struct Plan<'a> {
    /// Radius [m].
    pub radius: f64,
    /// Distance from the rim to the ground [m] by angle [°].
    pub lifted: &'a [[f64; 2]],
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
        let (size, middle) = (HALF, (HALF / 2.0, 118.0));
        let scale = 96.0 / self.radius;
        // θ from the right, counter-clockwise.
        let at = |degrees: f64, r: f64| {
            let (s, c) = degrees.to_radians().sin_cos();
            (middle.0 + scale * r * c, middle.1 - scale * r * s)
        };
        let mut svg = Svg::new();
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
            svg.text(
                (x + shift, y + 4.0),
                anchor,
                "tk",
                words::SIDES[usize::from(degrees > 0.0)],
            );
        }
        svg.text(middle, Anchor::Middle, "tk", words::ON_THE_GROUND);
        ((size, 236.0), svg.into_markup())
    }
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
    let most = positions
        .iter()
        .flat_map(|p| p.rim)
        .fold(0.0_f64, |m, w| m.max(w.abs()));
    if most <= 0.0 {
        return 1.0;
    }
    let wanted = SHOWN * 2.0 * tank.radius / most;
    let decade = 10_f64.powf(wanted.log10().floor());
    let round = [5.0, 2.0, 1.0]
        .map(|step| step * decade)
        .into_iter()
        .find(|step| *step <= wanted);
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
            (
                middle + scale * (c * x - s * z),
                ground - scale * (centre + s * x + c * z),
            )
        };
        let r = tank.radius;
        let surface = |x: f64| at(x, tank.depth - x * slope);
        svg.path(&[at(-r, 0.0), at(r, 0.0), surface(r), surface(-r)], true, "liq");
        svg.path(
            &[at(-r, 0.0), at(-r, tank.wall), at(r, tank.wall), at(r, 0.0)],
            false,
            "out",
        );
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
                    (
                        rim.0 - side * scale * reach * (1.0 - share),
                        ground - (ground - rim.1) * share.powi(3),
                    )
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
