//! States of both walls for pictures: the walls over the breadth of the tank, and the surface between them.

use results::channel::Side;
use results::{Snapshot, Snapshots};

use super::history::WallState;
use super::model::StripModel;
use super::walls::Walls;

/// Lines of nodes over the breadth.
const COLUMNS: usize = 5;
/// Lines of nodes of the surface from the middle to a wall.
const LINES: usize = 13;

impl StripModel {
    /// Elevation of the surface at the lines of a picture, from the middle to the wall of `side` [m], for the unknowns `u`.
    pub(super) fn surface(&self, side: Side, u: &[f64]) -> Vec<f64> {
        if let Some(chain) = &self.chain {
            return chain.surface(self, side as usize, u, LINES);
        }
        let liquid = &self.tank.liquid;
        let amplitudes: Vec<f64> =
            self.amplitudes.iter().zip(&self.liquid.elevation).map(|(&e, wave)| u[e] * wave).collect();
        let at = |i: usize| {
            let x = i as f64 / (LINES - 1) as f64;
            let waves = amplitudes.iter().enumerate().map(|(n, at_wall)| {
                let k = liquid.wave_number(n) * liquid.half_width;
                at_wall * (k * x).sin() / k.sin()
            });
            waves.sum()
        };
        (0..LINES).map(at).collect()
    }
}

impl Walls<'_> {
    /// The states that both walls have; none where nobody asks for them.
    pub(super) fn snapshots(&self) -> Option<Snapshots> {
        let pairs = self.runs[0].history.states.iter().zip(&self.runs[1].history.states);
        let states: Vec<Snapshot> = pairs.map(|(front, back)| self.state([front, back])).collect();
        if states.is_empty() {
            return None;
        }
        let levels = &self.model.tank.levels;
        let (half, depth) = (self.model.tank.liquid.half_width, self.case.liquid.fill_height);
        let mut out = Snapshots { whole: true, states, ..Snapshots::default() };
        for side in [1.0, -1.0] {
            let first = out.nodes.len();
            for z in levels {
                // Counter-clockwise seen from outside.
                out.nodes.extend(across(side * self.breadth).map(|y| [side * half, y, *z]));
            }
            out.wall.extend(grid(first, levels.len()));
            let thickness = levels.windows(2).map(|z| self.case.tank.course_at(0.5 * (z[0] + z[1])).thickness);
            out.thickness.extend(thickness.flat_map(|t| [t; COLUMNS - 1]));
        }
        let first = out.nodes.len();
        for x in lines() {
            out.nodes.extend(across(self.breadth).map(|y| [half * x, y, depth]));
        }
        out.surface = grid(first, 2 * LINES - 1).map(|[a, b, c, d]| [a, d, c, b]).collect();
        Some(out)
    }

    /// Both walls at one time; the wall at −L is that at +L under the record with the opposite sign.
    fn state(&self, walls: [&WallState; 2]) -> Snapshot {
        let mut out = Snapshot { time: walls[0].time, ..Snapshot::default() };
        for (wall, side) in walls.into_iter().zip([1.0, -1.0]) {
            for [x, z] in &wall.displacement {
                out.displacement.extend([[side * x, 0.0, *z]; COLUMNS]);
            }
            out.cracks.extend(wall.cracks.iter().flat_map(|open| [*open; COLUMNS - 1]));
        }
        for i in 0..2 * LINES - 1 {
            let (wall, line) = if i < LINES - 1 { (1, LINES - 1 - i) } else { (0, i + 1 - LINES) };
            out.displacement.extend([[0.0, 0.0, walls[wall].surface[line]]; COLUMNS]);
        }
        out
    }
}

/// Places over a breadth, of a negative one backwards [m].
fn across(breadth: f64) -> impl Iterator<Item = f64> {
    (0..COLUMNS).map(move |k| breadth * (k as f64 / (COLUMNS - 1) as f64 - 0.5))
}

/// Lines of the surface, rising: x over the half width.
fn lines() -> impl Iterator<Item = f64> {
    let last = LINES - 1;
    (0..=2 * last).map(move |i| i as f64 / last as f64 - 1.0)
}

/// Quadrilaterals of `rows` rows of nodes.
fn grid(first: usize, rows: usize) -> impl Iterator<Item = [usize; 4]> {
    let node = move |row: usize, k: usize| first + row * COLUMNS + k;
    (0..rows - 1).flat_map(move |row| {
        (0..COLUMNS - 1).map(move |k| [node(row, k), node(row, k + 1), node(row + 1, k + 1), node(row + 1, k)])
    })
}
