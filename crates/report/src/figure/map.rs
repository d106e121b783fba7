//! A quantity over the developed wall: colours, contour lines and a colour bar.
//!
//! Colours are sixteen steps of viridis (van der Walt and Smith 2015), whose lightness rises evenly: readable for
//! colour-blind readers and in grey print. Contour lines at the ticks of the bar show the same without colour.

use tank::units::Dimension;

use super::perimeter::Perimeter;
use super::svg::{Anchor, Svg, n, path_data};
use super::wall::{self, BAR, BELOW, LEFT, PLOT, STEPS, TOP};
use super::width::{FONT, text_width};
use super::{Figure, WIDE, ticks};
use crate::number::{Scale, fixed, plain, with_unit};
use crate::table::{Column, Table, columns, spread};
use crate::words::figures::wall as words;
use results::WallMap;

/// Cells drawn over circumference and height.
const COLUMNS: usize = 144;
/// Where the number of a line may stand, as parts of its length, best first.
const PLACES: [f64; 7] = [0.5, 0.3, 0.7, 0.15, 0.85, 0.05, 0.95];
const ROWS: usize = 48;

/// A map with its angles closed to a full circle, on a regular grid.
struct Field {
    /// Angles [rad], or positions along the walls of a box [m].
    theta: Vec<f64>,
    z: Vec<f64>,
    values: Vec<f64>,
}

impl Field {
    /// `None` for a map without area or with a missing value.
    fn of(map: &WallMap) -> Option<Field> {
        let (rows, columns) = (map.z.len(), map.theta.len());
        if rows < 2 || columns < 2 || map.values.len() != rows * columns || map.values.iter().any(|v| !v.is_finite()) {
            return None;
        }
        let mut field = Field { theta: map.theta.clone(), z: map.z.clone(), values: map.values.clone() };
        // The gap over the seam is one more step: the first column closes the circle.
        let (first, last) = (map.theta[0], map.theta[columns - 1]);
        let step = (last - first) / (columns - 1) as f64;
        let gap = std::f64::consts::TAU - (last - first);
        if gap > 0.5 * step && gap < 1.5 * step {
            field.theta.push(first + std::f64::consts::TAU);
            field.values.extend_from_within(..rows);
        }
        Some(field)
    }

    /// Bilinear value.
    fn at(&self, theta: f64, z: f64) -> f64 {
        let (i, s) = cell(&self.theta, theta);
        let (j, t) = cell(&self.z, z);
        let v = |i: usize, j: usize| self.values[i * self.z.len() + j];
        (1.0 - s) * ((1.0 - t) * v(i, j) + t * v(i, j + 1)) + s * ((1.0 - t) * v(i + 1, j) + t * v(i + 1, j + 1))
    }
}

/// Interval of ascending stations that holds a point, and the place within.
fn cell(stations: &[f64], at: f64) -> (usize, f64) {
    let i = stations.partition_point(|s| *s <= at).clamp(1, stations.len() - 1) - 1;
    let part = (at - stations[i]) / (stations[i + 1] - stations[i]);
    (i, part.clamp(0.0, 1.0))
}

/// Draws a map; `None` for a map without values.
///
/// * `walls`: of a box, whose plot runs along its walls; a cylinder's runs over the angle
pub fn figure(id: &str, map: &WallMap, walls: Option<Perimeter>) -> Option<Figure> {
    let mut field = Field::of(map)?;
    if let Some(walls) = walls {
        field.theta.iter_mut().for_each(|theta| *theta = walls.along(*theta));
        if field.theta.windows(2).any(|pair| pair[1] <= pair[0]) {
            return None;
        }
    }
    let scale = Scale::single(map.dimension, map.values.iter().copied());
    let shown = |v: f64| scale.convert(v);
    let low = map.values.iter().copied().map(shown).fold(f64::INFINITY, f64::min);
    let high = map.values.iter().copied().map(shown).fold(f64::NEG_INFINITY, f64::max);
    if high <= low {
        return None;
    }
    let (levels, decimals) = ticks(low, high, 10);
    let right = WIDE - BAR;
    let bottom = TOP + PLOT;
    let (theta, z) = (ends(&field.theta), ends(&field.z));
    let x = |t: f64| LEFT + (t - theta.0) / (theta.1 - theta.0) * (right - LEFT);
    let y = |h: f64| bottom - (h - z.0) / (z.1 - z.0) * PLOT;

    // Values in the printed unit on a regular grid.
    let along = |i: f64| theta.0 + (theta.1 - theta.0) * i / COLUMNS as f64;
    let height = |j: f64| z.0 + (z.1 - z.0) * j / ROWS as f64;
    let value = |i: f64, j: f64| shown(field.at(along(i), height(j)));
    let mut svg = Svg::new();
    svg.append(&colours(
        |i, j| ((value(i as f64 + 0.5, j as f64 + 0.5) - low) / (high - low) * STEPS as f64) as usize,
        |i| x(along(i as f64)),
        |j| y(height(j as f64)),
    ));
    // Numbers that stand: centre and half the width.
    let mut written: Vec<(f64, f64, f64)> = Vec::new();
    for &level in &levels {
        let lines = contour(level, &value, &|i, j| (x(along(i)), y(height(j))));
        if lines.is_empty() {
            continue;
        }
        let data: String = lines.iter().map(|l| path_data(l)).collect();
        svg.append(&format!(r#"<path class="iso" d="{data}"/>"#));
        // The longest line carries the number, where it covers no other.
        if let Some(line) = lines.iter().max_by_key(|l| l.len()).filter(|l| l.len() > 12) {
            let text = plain(level, decimals);
            let room = (0.5 * text_width(&text) * FONT + 2.0, 0.5 * FONT + 2.0);
            let inside = ((LEFT + 14.0, right - 14.0), (TOP + 9.0, bottom - 4.0));
            if let Some(at) = place_of_number(line, room, inside, &written) {
                written.push((at.0, at.1, room.0));
                svg.text(at, Anchor::Middle, "dl halo", &text);
            }
        }
    }
    frame(&mut svg, &field, (x(theta.0), x(theta.1)), walls);
    wall::bar(&mut svg, WIDE, (TOP, bottom), (low, high), &levels, decimals, scale.symbol());
    Some(
        Figure::new(id, map.title.clone(), ((WIDE, bottom + BELOW), svg.into_markup()), table(map, &scale, walls))
            .captioned(words::map(map.time, walls.is_some()))
            .described(describe(map, walls)),
    )
}

/// Where on a line its number stands: the best place that covers no other number.
///
/// * `room`: half the width and half the height of the number
/// * `inside`: range of x and of y
/// * `written`: numbers that stand: centre and half the width
fn place_of_number(
    line: &[(f64, f64)],
    room: (f64, f64),
    inside: ((f64, f64), (f64, f64)),
    written: &[(f64, f64, f64)],
) -> Option<(f64, f64)> {
    let (x, y) = inside;
    let at = |part: f64| {
        let at = line[(part * (line.len() - 1) as f64) as usize];
        (at.0.clamp(x.0, x.1), at.1.clamp(y.0, y.1))
    };
    let apart = |at: (f64, f64), other: &(f64, f64, f64)| {
        (at.0 - other.0).abs() > room.0 + other.2 || (at.1 - other.1).abs() > 2.0 * room.1
    };
    PLACES.map(at).into_iter().find(|at| written.iter().all(|other| apart(*at, other)))
}

fn ends(stations: &[f64]) -> (f64, f64) {
    (stations[0], stations[stations.len() - 1])
}

/// Cells of one colour in a row as one rectangle, all rectangles of one colour as one path.
fn colours(step: impl Fn(usize, usize) -> usize, x: impl Fn(usize) -> f64, y: impl Fn(usize) -> f64) -> String {
    let mut paths = vec![String::new(); STEPS];
    for j in 0..ROWS {
        let mut i = 0;
        while i < COLUMNS {
            let colour = step(i, j).min(STEPS - 1);
            let start = i;
            while i < COLUMNS && step(i, j).min(STEPS - 1) == colour {
                i += 1;
            }
            // A hair of overlap: no seams between neighbours.
            let (left, right) = (x(start), x(i) + 0.3);
            let (top, bottom) = (y(j + 1) - 0.3, y(j));
            paths[colour].push_str(&format!("M{} {}H{}V{}H{}Z", n(left), n(top), n(right), n(bottom), n(left)));
        }
    }
    let path = |(colour, data): (usize, String)| format!(r#"<path class="v v{colour}" d="{data}"/>"#);
    let filled = paths.into_iter().enumerate().filter(|(_, data)| !data.is_empty());
    filled.map(path).collect()
}

/// Lines on which the field has a value (marching squares, segments joined end to end).
fn contour(
    level: f64,
    value: &impl Fn(f64, f64) -> f64,
    place: &impl Fn(f64, f64) -> (f64, f64),
) -> Vec<Vec<(f64, f64)>> {
    let nodes: Vec<f64> = (0..=COLUMNS)
        .flat_map(|i| (0..=ROWS).map(move |j| (i, j)))
        .map(|(i, j)| value(i as f64, j as f64) - level)
        .collect();
    let at = |i: usize, j: usize| nodes[i * (ROWS + 1) + j];
    // Crossing of an edge, keyed by the edge: horizontal (from i, j to i + 1) or vertical.
    type Edge = (usize, usize, bool);
    let crossing = |(i, j, vertical): Edge| {
        let (a, b) = (at(i, j), if vertical { at(i, j + 1) } else { at(i + 1, j) });
        let part = a / (a - b);
        let along = if vertical { (i as f64, j as f64 + part) } else { (i as f64 + part, j as f64) };
        place(along.0, along.1)
    };
    let mut links: std::collections::BTreeMap<Edge, Vec<Edge>> = std::collections::BTreeMap::new();
    for i in 0..COLUMNS {
        for j in 0..ROWS {
            let above = |v: f64| v > 0.0;
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)].map(above);
            let edges: [Edge; 4] = [(i, j, false), (i + 1, j, true), (i, j + 1, false), (i, j, true)];
            let crossed: Vec<Edge> = (0..4).filter(|&k| corners[k] != corners[(k + 1) % 4]).map(|k| edges[k]).collect();
            // A saddle has four crossings: neighbours in their order are joined.
            for pair in crossed.chunks_exact(2) {
                links.entry(pair[0]).or_default().push(pair[1]);
                links.entry(pair[1]).or_default().push(pair[0]);
            }
        }
    }
    let mut lines = Vec::new();
    // Open lines start where one link ends; the rest are closed.
    for open in [true, false] {
        let starts: Vec<Edge> = links.keys().copied().collect();
        for start in starts {
            if links.get(&start).is_none_or(|l| l.is_empty() || (open && l.len() != 1)) {
                continue;
            }
            let mut line = vec![crossing(start)];
            let mut here = start;
            while let Some(next) = links.get_mut(&here).and_then(Vec::pop) {
                if let Some(back) = links.get_mut(&next) {
                    back.retain(|e| *e != here);
                }
                line.push(crossing(next));
                here = next;
            }
            lines.push(line);
        }
    }
    lines
}

/// Frame, ticks and titles of the plot; of a box with its corners and the names of its walls.
fn frame(svg: &mut Svg, field: &Field, across: (f64, f64), walls: Option<Perimeter>) {
    let bottom = TOP + PLOT;
    svg.path(&[(across.0, TOP), (across.1, TOP), (across.1, bottom), (across.0, bottom)], true, "ax");
    match walls {
        None => wall::angles(svg, ends(&field.theta), across, bottom),
        Some(walls) => wall::positions(svg, ends(&field.theta), across, (TOP, bottom), walls),
    }
    wall::heights(svg, ends(&field.z), across.0, (TOP, bottom));
}

/// A direction of a map in words: its angle, or the position along the walls of a box.
fn direction(theta: f64, walls: Option<Perimeter>, decimals: usize) -> String {
    match walls {
        None => format!("θ = {}°", fixed(theta.to_degrees(), decimals)),
        Some(walls) => format!("s = {}", with_unit(walls.along(theta), Dimension::Length)),
    }
}

/// Largest and smallest value and where they are.
fn describe(map: &WallMap, walls: Option<Perimeter>) -> String {
    let place = |better: fn(f64, f64) -> bool| {
        let best = (0..map.values.len()).fold(0, |b, i| if better(map.values[i], map.values[b]) { i } else { b });
        let (i, j) = (best / map.z.len(), best % map.z.len());
        format!(
            "{} at {}, z = {}",
            with_unit(map.values[best], map.dimension),
            direction(map.theta[i], walls, 0),
            with_unit(map.z[j], Dimension::Length)
        )
    };
    words::map_description((&map.title, walls.is_some()), map.time, &place(|a, b| a > b), &place(|a, b| a < b))
}

/// Values at some angles or positions (columns) and heights (rows).
fn table(map: &WallMap, scale: &Scale, walls: Option<Perimeter>) -> Table {
    let angles = spread(map.theta.len(), 9);
    let mut columns = columns!["z" => "m"];
    columns.extend(angles.iter().map(|&i| Column::numbers(&direction(map.theta[i], walls, 1), scale.symbol())));
    let mut table = Table::new(columns);
    for j in spread(map.z.len(), 21).into_iter().rev() {
        let mut row = vec![fixed(map.z[j], 3)];
        row.extend(angles.iter().map(|&i| scale.text(map.values[i * map.z.len() + j])));
        table.row(row);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(value: impl Fn(f64, f64) -> f64) -> WallMap {
        let theta: Vec<f64> = (0..16).map(|i| f64::from(i) * std::f64::consts::TAU / 16.0).collect();
        let z: Vec<f64> = (0..11).map(|j| 0.1 * f64::from(j)).collect();
        WallMap {
            id: "pressure".into(),
            title: "Pressure".into(),
            time: Some(1.0),
            dimension: Dimension::Stress,
            values: theta.iter().flat_map(|t| z.iter().map(|z| value(*t, *z)).collect::<Vec<_>>()).collect(),
            theta,
            z,
        }
    }

    #[test]
    fn the_circle_is_closed_and_interpolated() {
        let field = Field::of(&map(|t, z| t.cos() + z)).expect("a map");
        assert_eq!(field.theta.len(), 17);
        let last = std::f64::consts::TAU;
        assert!((field.at(last, 0.5) - 1.5).abs() < 1e-12);
        let (a, b) = ((15.0 / 16.0 * last).cos(), 1.0);
        assert!((field.at(31.0 / 32.0 * last, 0.25) - (0.5 * (a + b) + 0.25)).abs() < 1e-12);
    }

    #[test]
    fn half_a_circle_stays_open() {
        let mut half = map(|_, z| z);
        half.theta.iter_mut().for_each(|t| *t *= 0.5);
        assert_eq!(Field::of(&half).expect("a map").theta.len(), 16);
    }

    /// The line z = 0.5 of a field that is z: one line across, at half height.
    #[test]
    fn contours_lie_where_the_value_is() {
        let level = 0.47;
        let lines = contour(level, &|_, j| j / ROWS as f64, &|i, j| (i, j / ROWS as f64));
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].len(), COLUMNS + 1);
        assert!(lines[0].iter().all(|p| (p.1 - level).abs() < 1e-12));
    }

    #[test]
    fn a_circle_is_one_closed_line() {
        let (centre, radius) = ((70.0, 25.0), 15.0);
        let value = |i: f64, j: f64| (i - centre.0).hypot(j - centre.1) - radius;
        let lines = contour(0.0, &value, &|i, j| (i, j));
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        // Chords of the distance function: within h²/8r of the circle.
        assert!(lines[0].iter().all(|p| value(p.0, p.1).abs() < 1.0 / (8.0 * radius)));
    }

    /// A box has no angles: positions along its walls, corners between them and the names of the walls.
    #[test]
    fn a_box_has_positions_along_its_walls() {
        let walls = Perimeter { length: 12.0, breadth: 6.0 };
        let drawn = figure("a", &map(|t, z| t.cos() * z), Some(walls)).expect("a map");
        assert!(!drawn.markup.contains('θ') && !drawn.description.contains('θ'), "{}", drawn.description);
        for wall in Perimeter::WALLS {
            assert!(drawn.markup.contains(&format!(">{wall}<")), "{wall}");
        }
        assert!(drawn.table.columns.iter().skip(1).all(|c| c.title.starts_with("s = ")));
        let round = figure("a", &map(|t, z| t.cos() * z), None).expect("a map");
        assert!(round.markup.contains('θ'));
    }

    #[test]
    fn nothing_to_draw_gives_no_figure() {
        assert!(figure("a", &map(|_, _| 3.0), None).is_none());
        assert!(figure("a", &map(|_, _| f64::NAN), None).is_none());
        assert!(figure("a", &map(|t, _| t.cos()), None).is_some());
    }
}
