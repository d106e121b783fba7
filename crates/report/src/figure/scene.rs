//! Wall and free surface of a tank in space, seen from outside and above.
//!
//! Parallel projection: azimuth and elevation of the eye, no vanishing point, so that lengths along one direction keep
//! their ratio. Faces are drawn from far to near (painter's algorithm), after those were dropped that no pixel of a
//! depth buffer shows; a tank's wall hides half of its faces. The shade of a face follows the angle of its normal to a
//! light behind the eye's left shoulder.

use super::svg::{Anchor, Svg, path_data};
use crate::words;

/// Width of a picture and its greatest height, in user units.
const WIDTH: f64 = super::HALF;
const HIGHEST: f64 = 330.0;
const MARGIN: f64 = 8.0;
/// Eye: azimuth from the x axis (the direction of shaking) and elevation above the horizon.
const AZIMUTH: f64 = -0.9;
const ELEVATION: f64 = 0.5;
/// Shades of the classes `s0` (dark) to `s5` (light) in `templates/fields.css`.
const SHADES: f64 = 6.0;
/// Cells of the depth buffer a user unit.
const FINENESS: f64 = 1.5;

/// The part that a face belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The wall.
    Wall,
    /// The free surface.
    Surface,
}

/// A quadrilateral in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Its corners [m].
    pub corners: [[f64; 3]; 4],
    /// Its part.
    pub part: Part,
}

/// A face on the picture plane.
struct Seen {
    /// Right and up, user units before the shift into the picture.
    corners: [(f64, f64); 4],
    /// Towards the eye.
    depths: [f64; 4],
    class: String,
}

/// Right, up and towards the eye.
fn view(p: [f64; 3]) -> (f64, f64, f64) {
    let (sin_a, cos_a) = AZIMUTH.sin_cos();
    let (sin_e, cos_e) = ELEVATION.sin_cos();
    let right = -sin_a * p[0] + cos_a * p[1];
    let out = cos_a * p[0] + sin_a * p[1];
    (right, cos_e * p[2] - sin_e * out, sin_e * p[2] + cos_e * out)
}

/// Draws faces, and lines above them (the undeformed shape); returns size and markup. `extent` are points that the picture
/// always holds, so that several pictures of one tank have one scale.
pub fn draw(faces: &[Face], ghost: &[Vec<[f64; 3]>], extent: &[[f64; 3]]) -> ((f64, f64), String) {
    let corners = faces.iter().flat_map(|f| f.corners);
    let all: Vec<(f64, f64, f64)> = corners.chain(extent.iter().copied()).map(view).collect();
    let range = |of: fn(&(f64, f64, f64)) -> f64| {
        all.iter()
            .map(of)
            .filter(|v| v.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)))
    };
    let (left, right) = range(|p| p.0);
    let (bottom, top) = range(|p| p.1);
    let axes = 42.0;
    let scale = ((WIDTH - 2.0 * MARGIN) / (right - left)).min((HIGHEST - 2.0 * MARGIN - axes) / (top - bottom));
    let indent = (WIDTH - scale * (right - left)) / 2.0;
    let height = (top - bottom) * scale + 2.0 * MARGIN + axes;
    let place = |p: [f64; 3]| {
        let (x, y, _) = view(p);
        (indent + scale * (x - left), MARGIN + scale * (top - y))
    };

    let mut seen: Vec<Seen> = faces
        .iter()
        .filter(|f| f.corners.iter().flatten().all(|v| v.is_finite()))
        .map(|f| Seen { corners: f.corners.map(place), depths: f.corners.map(|p| scale * view(p).2), class: class(f) })
        .collect();
    let visible = visible(&seen, (WIDTH, height));
    let mut keep = visible.iter();
    seen.retain(|_| *keep.next().unwrap_or(&true));
    let depth = |s: &Seen| s.depths.iter().sum::<f64>();
    seen.sort_by(|a, b| depth(a).total_cmp(&depth(b)));

    let mut svg = Svg::new();
    for face in &seen {
        svg.path(&face.corners, true, &face.class);
    }
    let mut lines = String::new();
    for line in ghost {
        let points: Vec<(f64, f64)> = line.iter().map(|&p| place(p)).collect();
        lines.push_str(&path_data(&points));
    }
    if !lines.is_empty() {
        svg.append(&format!(r#"<path class="gh" d="{lines}"/>"#));
    }
    tripod(&mut svg, (26.0, height - 20.0));
    ((WIDTH, height), svg.into_markup())
}

/// The three axes in a corner.
fn tripod(svg: &mut Svg, origin: (f64, f64)) {
    let length = 20.0;
    for (name, axis) in [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])] {
        let (x, y, _) = view(axis);
        let end = (origin.0 + length * x, origin.1 - length * y);
        svg.line(origin, end, "dm");
        let beyond = (origin.0 + 1.45 * length * x, origin.1 - 1.45 * length * y + 3.5);
        svg.text(beyond, Anchor::Middle, "dl", name);
    }
}

/// Part and shade as classes.
fn class(face: &Face) -> String {
    let [a, b, c, d] = face.corners;
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    // The diagonals' product: right also where a corner is collapsed.
    let (u, v) = (minus(c, a), minus(d, b));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let size = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (x, y, towards) = view(normal);
    // Both sides of a shell are lit: the side that is seen counts.
    let lit = if size > 0.0 { (-0.45 * x + 0.45 * y + 0.77 * towards) * towards.signum() / size } else { 1.0 };
    let shade = (lit.clamp(0.0, 0.999) * SHADES) as usize;
    match face.part {
        Part::Wall => format!("qw s{shade}"),
        Part::Surface => format!("qs s{shade}"),
    }
}

/// Which faces some cell of a depth buffer shows.
fn visible(faces: &[Seen], size: (f64, f64)) -> Vec<bool> {
    let (columns, rows) = ((size.0 * FINENESS) as usize + 1, (size.1 * FINENESS) as usize + 1);
    let mut nearest = vec![(f64::NEG_INFINITY, usize::MAX); columns * rows];
    for (i, face) in faces.iter().enumerate() {
        for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
            let at = |k: usize| (face.corners[k].0 * FINENESS, face.corners[k].1 * FINENESS);
            let (p, q, r) = (at(a), at(b), at(c));
            let area = (q.0 - p.0) * (r.1 - p.1) - (r.0 - p.0) * (q.1 - p.1);
            if area.abs() < 1e-9 {
                continue;
            }
            let bounds = |of: fn((f64, f64)) -> f64, most: usize| {
                let values = [of(p), of(q), of(r)];
                let low = values.iter().copied().fold(f64::INFINITY, f64::min).max(0.0) as usize;
                let high = values.iter().copied().fold(0.0, f64::max) as usize;
                low..(high + 2).min(most)
            };
            for row in bounds(|p| p.1, rows) {
                for column in bounds(|p| p.0, columns) {
                    let (x, y) = (column as f64, row as f64);
                    let v = ((x - p.0) * (r.1 - p.1) - (r.0 - p.0) * (y - p.1)) / area;
                    let w = ((q.0 - p.0) * (y - p.1) - (x - p.0) * (q.1 - p.1)) / area;
                    if v < 0.0 || w < 0.0 || v + w > 1.0 {
                        continue;
                    }
                    let depth = face.depths[a] * (1.0 - v - w) + face.depths[b] * v + face.depths[c] * w;
                    let cell = &mut nearest[row * columns + column];
                    if depth > cell.0 {
                        *cell = (depth, i);
                    }
                }
            }
        }
    }
    let mut shown = vec![false; faces.len()];
    for (_, i) in nearest {
        if let Some(shown) = shown.get_mut(i) {
            *shown = true;
        }
    }
    shown
}

/// Lines of a mesh that belong to one face only (its rims), each as an edge.
pub fn rims(faces: &[[usize; 4]]) -> Vec<[usize; 2]> {
    let mut edges: Vec<([usize; 2], [usize; 2])> = Vec::new();
    for face in faces {
        for k in 0..4 {
            let edge = [face[k], face[(k + 1) % 4]];
            if edge[0] != edge[1] {
                edges.push(([edge[0].min(edge[1]), edge[0].max(edge[1])], edge));
            }
        }
    }
    edges.sort_unstable();
    let once = |i: usize| {
        let same = |j: Option<usize>| j.and_then(|j| edges.get(j)).is_some_and(|e| e.0 == edges[i].0);
        !same(i.checked_sub(1)) && !same(Some(i + 1))
    };
    (0..edges.len()).filter(|&i| once(i)).map(|i| edges[i].1).collect()
}

/// Left and right contour of a wall: the edges between a face seen from outside and one seen from inside.
pub fn contours(nodes: &[[f64; 3]], faces: &[[usize; 4]]) -> Vec<[usize; 2]> {
    let towards = |face: &[usize; 4]| {
        let screen: Vec<(f64, f64)> = face
            .iter()
            .map(|&i| {
                let (x, y, _) = view(nodes[i]);
                (x, y)
            })
            .collect();
        (0..4).map(|k| screen[k].0 * screen[(k + 1) % 4].1 - screen[(k + 1) % 4].0 * screen[k].1).sum::<f64>() > 0.0
    };
    let mut edges: Vec<([usize; 2], bool)> = Vec::new();
    for face in faces {
        let side = towards(face);
        for k in 0..4 {
            let (a, b) = (face[k], face[(k + 1) % 4]);
            edges.push(([a.min(b), a.max(b)], side));
        }
    }
    edges.sort_unstable();
    edges.windows(2).filter(|w| w[0].0 == w[1].0 && w[0].1 != w[1].1).map(|w| w[0].0).collect()
}

/// A number as the factor of a scale: 1, 2 or 5 times a power of ten, not above it.
pub fn round_down(value: f64) -> f64 {
    if !value.is_finite() || value <= 0.0 {
        return 1.0;
    }
    let power = 10f64.powf(value.log10().floor());
    let digit = [5.0, 2.0, 1.0].into_iter().find(|d| d * power <= value * (1.0 + 1e-9));
    digit.unwrap_or(1.0) * power
}

/// The point of view, for descriptions.
pub fn eye() -> String {
    words::figures::spatial::eye(AZIMUTH.abs().to_degrees().round(), ELEVATION.to_degrees().round())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(z: f64, side: f64) -> Face {
        Face { corners: [[-side, -side, z], [side, -side, z], [side, side, z], [-side, side, z]], part: Part::Surface }
    }

    #[test]
    fn what_is_behind_is_not_drawn() {
        let paths = |faces: &[Face]| draw(faces, &[], &[]).1.matches("class=\"qs").count();
        // Seen from above, a larger square just above hides a smaller one, in either order.
        let (low, high) = (square(0.0, 0.5), square(0.01, 1.0));
        assert_eq!(paths(&[low, high]), 1);
        assert_eq!(paths(&[high, low]), 1);
        // The small one above is seen.
        assert_eq!(paths(&[square(0.0, 1.0), square(0.01, 0.5)]), 2);
    }

    #[test]
    fn far_faces_come_first() {
        let mut near = square(1.0, 0.3);
        near.part = Part::Wall;
        let (_, markup) = draw(&[near, square(0.0, 1.0)], &[], &[]);
        assert!(markup.find("qs").unwrap() < markup.find("qw").unwrap());
    }

    #[test]
    fn rims_of_a_ring_are_its_two_circles() {
        // Four faces around a square tube: nodes 0 to 3 below, 4 to 7 above.
        let faces: Vec<[usize; 4]> = (0..4).map(|i| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]).collect();
        let rims = rims(&faces);
        assert_eq!(rims.len(), 8);
        assert!(rims.iter().all(|e| (e[0] < 4) == (e[1] < 4)));
        // Two of its four vertical edges are contours, seen from a direction that is not a diagonal.
        let nodes: Vec<[f64; 3]> = (0..8)
            .map(|i| {
                let angle = (i % 4) as f64 * std::f64::consts::FRAC_PI_2;
                [angle.cos(), angle.sin(), (i / 4) as f64]
            })
            .collect();
        let sides = contours(&nodes, &faces);
        assert_eq!(sides.len(), 2, "{sides:?}");
    }

    #[test]
    fn factors_are_round() {
        for (value, factor) in [(1.0, 1.0), (7.3, 5.0), (49.0, 20.0), (0.3, 0.2), (1000.0, 1000.0), (0.0, 1.0)] {
            assert!((round_down(value) - factor).abs() < 1e-9 * factor, "{value}");
        }
    }
}
