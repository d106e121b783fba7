//! `wet_face`: joins the normal displacement of a wall to the potential of the liquid.
//!
//! ```text
//! φ,n = u_n = Σ_b N_b (n_b · u_b)        B_a(b,i) = ∫ N_a N_b n_b,i dA        mass blocks ρ B (φ, u) and ρ Bᵀ (u, φ)
//! ```
//!
//! Local nodes: first the corners of the liquid face (dof φ), then those of the wall face (u_x, u_y, u_z). The normals
//! n_b belong to the wall's nodes and point out of the liquid. As normal components are interpolated, not vectors, a
//! tangential motion of a round wall moves no liquid, and a uniform radial one the exact volume of the chart.
//!
//! **Round walls.** Between two meridians, Δ apart, the chord of a smooth w lies within it. ∫ N_a N_b dθ has the
//! weights Δ (1, 4, 1)/6, and a translation of the wall moves a mass 5Δ²/24 too small (3.2 % with 16 sectors).
//! On a face r = const whose wall has the same meridians the integral along θ is therefore that of the smooth function
//! through the nodal values, of fourth order:
//!
//! ```text
//! ∫ N_a w dθ ≈ Δ (w_{a−1} + 10 w_a + w_{a+1})/12        element: Δ/12 [5 1; 1 5], half consistent, half lumped
//! ```
//!
//! which leaves Δ²/24 (0.6 %) and keeps the areas. Source: Numerov's weights, e.g. Hairer, Nørsett & Wanner 1993, III.10.
//!
//! The faces match corner by corner ([`WetFace::new`]), or they are rectangles of one coordinate surface of the chart and
//! overlap in part ([`WetFace::overlapping`]): the integral is then taken over the overlap, so that wall and liquid may
//! be divided differently and the wall may stand partly above the liquid.
//!
//! A wall that follows the ground (a rigid tank, its bottom) is the same element with held displacements: the inertia of
//! the ground motion, [`crate::assembly::Assembler::inertia`], then holds the load ρ B ι. Its wall nodes may be the
//! liquid's own.

use nalgebra::Vector3;

use super::potential_face::{check_face, gauss_points, point};
use super::{Element, ElementError, Inspect, LocalMatrix, Response, Sample, Trial, positive, require};
use crate::chart::Chart;
use crate::dofs::Dof;
use crate::mesh::Face;
use crate::shape::{gauss, quad4};

const KIND: &str = "wet_face";

/// Overlaps narrower than this share of the faces' size are ignored.
const SLIVER: f64 = 1e-9;

/// Coupling of a liquid face with a wall face.
#[derive(Clone, Debug, PartialEq)]
pub struct WetFace {
    nodes: [usize; 8],
    /// ∫ N_a N_b dA: `areas[a][b]`, a of the liquid, b of the wall [m²].
    areas: [[f64; 4]; 4],
    normals: [[f64; 3]; 4],
    density: f64,
    /// Shape functions of the liquid face at the centre of the coupled part, and the centre itself.
    centre: ([f64; 4], [f64; 3]),
}

impl WetFace {
    /// Joins a liquid face to the wall nodes at its corners.
    ///
    /// * `liquid`: face of the liquid, normal outwards
    /// * `wall_nodes`: the wall's nodes at the face's corners, in the same order
    /// * `normals`: normal of the wall at each, out of the liquid, unit length
    /// * `density`: ρ of the liquid [kg/m³]
    ///
    /// Errors: an area or density that is not positive, a normal that is not a unit vector or points into the liquid.
    pub fn new(
        liquid: &Face,
        chart: Chart,
        wall_nodes: [usize; 4],
        normals: [[f64; 3]; 4],
        density: f64,
    ) -> Result<WetFace, ElementError> {
        require(positive(density), KIND, "density", density, "a positive number")?;
        check_face(KIND, liquid, chart)?;
        check_normals(liquid, chart, &normals)?;
        let mut areas = [[0.0; 4]; 4];
        for p in gauss_points(liquid, chart) {
            add_products(&mut areas, p.n, p.n, p.area);
        }
        smooth(&mut areas, chart, liquid, liquid);
        let middle = point(liquid, chart, 0.0, 0.0);
        Ok(WetFace {
            nodes: join(liquid.nodes, wall_nodes),
            areas,
            normals,
            density,
            centre: (middle.n, chart.position(middle.chart)),
        })
    }

    /// Joins a liquid face to a wall face over the part they share; `None` if they do not overlap.
    ///
    /// Both faces are rectangles on one coordinate surface of `chart` (r = R; or a plane x, y or z = const).
    ///
    /// * `normals`: normal of the wall at each corner of the wall face, out of the liquid, unit length
    ///
    /// Errors: those of [`WetFace::new`]; faces that are not such rectangles.
    pub fn overlapping(
        liquid: &Face,
        wall: &Face,
        chart: Chart,
        normals: [[f64; 3]; 4],
        density: f64,
    ) -> Result<Option<WetFace>, ElementError> {
        require(positive(density), KIND, "density", density, "a positive number")?;
        check_face(KIND, liquid, chart)?;
        check_face(KIND, wall, chart)?;
        let (own, other) = (Rectangle::of(liquid)?, Rectangle::of(wall)?);
        if own.fixed != other.fixed || (own.level - other.level).abs() > 1e-6 * own.size() {
            return Err(ElementError::NoAnswer {
                kind: KIND,
                reason: format!(
                    "the faces of liquid nodes {:?} and wall nodes {:?} lie on different coordinate surfaces",
                    liquid.nodes, wall.nodes
                ),
            });
        }
        let mut lower = [0.0; 2];
        let mut upper = [0.0; 2];
        for k in 0..2 {
            lower[k] = own.lower[k].max(other.lower[k]);
            upper[k] = own.upper[k].min(other.upper[k]);
            let width = (own.upper[k] - own.lower[k]).min(other.upper[k] - other.lower[k]);
            if upper[k] - lower[k] <= SLIVER * width {
                return Ok(None);
            }
        }
        check_normals(liquid, chart, &normals)?;
        let mut areas = [[0.0; 4]; 4];
        for &(r, wr) in gauss::TWO {
            for &(s, ws) in gauss::TWO {
                let at = place(lower, upper, [r, s]);
                let mut x = [own.level; 3];
                (x[own.axes[0]], x[own.axes[1]]) = (at[0], at[1]);
                let measure = 0.25 * (upper[0] - lower[0]) * (upper[1] - lower[1]) * own.area_factor(chart, x);
                add_products(&mut areas, own.shape(at), other.shape(at), measure * wr * ws);
            }
        }
        smooth(&mut areas, chart, liquid, wall);
        let middle = place(lower, upper, [0.0, 0.0]);
        let mut x = [own.level; 3];
        (x[own.axes[0]], x[own.axes[1]]) = (middle[0], middle[1]);
        Ok(Some(WetFace {
            nodes: join(liquid.nodes, wall.nodes),
            areas,
            normals,
            density,
            centre: (own.shape(middle), chart.position(x)),
        }))
    }

    /// The same on a wall that deviates from the face: `vectors` are n dA at its corners over the area dA of the face, of any
    /// length. The liquid's own nodes may follow the wall.
    pub fn with_area_vectors(mut self, vectors: [[f64; 3]; 4]) -> WetFace {
        self.normals = vectors;
        self
    }

    /// Area that is joined [m²].
    pub fn area(&self) -> f64 {
        self.areas.iter().flatten().sum()
    }
}

/// Nodes of the element from those of its two faces.
fn join(liquid: [usize; 4], wall: [usize; 4]) -> [usize; 8] {
    std::array::from_fn(|k| if k < 4 { liquid[k] } else { wall[k - 4] })
}

fn add_products(areas: &mut [[f64; 4]; 4], liquid: [f64; 4], wall: [f64; 4], area: f64) {
    for (row, na) in areas.iter_mut().zip(liquid) {
        for (entry, nb) in row.iter_mut().zip(wall) {
            *entry += na * nb * area;
        }
    }
}

/// Takes the integral along θ as that of a smooth function, if both faces lie on r = const between the same meridians.
fn smooth(areas: &mut [[f64; 4]; 4], chart: Chart, liquid: &Face, wall: &Face) {
    if chart != Chart::Cylindrical {
        return;
    }
    let theta = |f: &Face| f.chart.map(|c| c[1]);
    let (own, other) = (theta(liquid), theta(wall));
    let (low, high) =
        (own.iter().copied().fold(f64::INFINITY, f64::min), own.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * (high - low);
    let radius = liquid.chart[0][0];
    let round = liquid.chart.iter().chain(&wall.chart).all(|c| (c[0] - radius).abs() <= 1e-6 * radius);
    let paired = own.iter().chain(&other).all(|&t| near(t, low) || near(t, high));
    let two_each = [own, other].iter().all(|f| f.iter().filter(|&&t| near(t, low)).count() == 2);
    if !(round && paired && two_each && high > low) {
        return;
    }
    let consistent = *areas;
    for a in 0..4 {
        for b in 0..4 {
            if near(own[a], other[b]) {
                // The neighbour of b along θ: the neighbouring corner on the other meridian.
                let beside = [(b + 1) % 4, (b + 3) % 4].into_iter().find(|&c| !near(other[c], other[b]));
                let beside = beside.expect("two corners lie on each meridian");
                let moved = 0.5 * consistent[a][beside];
                areas[a][b] += moved;
                areas[a][beside] -= moved;
            }
        }
    }
}

/// Errors: a normal that is not a unit vector or points into the liquid.
fn check_normals(liquid: &Face, chart: Chart, normals: &[[f64; 3]; 4]) -> Result<(), ElementError> {
    let outwards = point(liquid, chart, 0.0, 0.0).normal;
    for n in normals {
        let v = Vector3::from(*n);
        let good = (v.norm() - 1.0).abs() <= 1e-6 && v.dot(&outwards) > 0.0;
        let found = format_args!("{n:?} where the liquid's face has {:?}", outwards.as_slice());
        require(good, KIND, "normal", found, "a unit vector out of the liquid")?;
    }
    Ok(())
}

/// Point of a rectangle at natural coordinates.
fn place(lower: [f64; 2], upper: [f64; 2], natural: [f64; 2]) -> [f64; 2] {
    std::array::from_fn(|k| 0.5 * (lower[k] + upper[k]) + 0.5 * (upper[k] - lower[k]) * natural[k])
}

/// A face whose sides follow two chart coordinates while the third is constant.
struct Rectangle {
    /// The constant coordinate and its value.
    fixed: usize,
    level: f64,
    /// The coordinates that vary, with their ranges.
    axes: [usize; 2],
    lower: [f64; 2],
    upper: [f64; 2],
    /// Signs of the corners' natural coordinates.
    corners: [[f64; 2]; 4],
}

impl Rectangle {
    fn of(face: &Face) -> Result<Rectangle, ElementError> {
        let no_rectangle = || {
            let what = "is not a rectangle in chart coordinates; overlaps need rectangles";
            ElementError::NoAnswer { kind: KIND, reason: format!("the face of nodes {:?} {what}", face.nodes) }
        };
        let range = |i: usize| {
            let values = face.chart.map(|c| c[i]);
            let lower = values.iter().copied().fold(f64::INFINITY, f64::min);
            (lower, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
        };
        let ranges = [range(0), range(1), range(2)];
        let width = |i: usize| ranges[i].1 - ranges[i].0;
        let fixed = (0..3).min_by(|&i, &j| width(i).total_cmp(&width(j))).expect("three coordinates");
        let axes = [(fixed + 1) % 3, (fixed + 2) % 3];
        let widest = width(axes[0]).max(width(axes[1]));
        if width(fixed) > 1e-6 * widest {
            return Err(no_rectangle());
        }
        let mut corners = [[0.0; 2]; 4];
        for (corner, at) in corners.iter_mut().zip(&face.chart) {
            for k in 0..2 {
                let (lower, upper) = ranges[axes[k]];
                let xi = (2.0 * at[axes[k]] - lower - upper) / (upper - lower);
                if (xi.abs() - 1.0).abs() > 1e-6 {
                    return Err(no_rectangle());
                }
                corner[k] = xi.signum();
            }
        }
        Ok(Rectangle {
            fixed,
            level: 0.5 * (ranges[fixed].0 + ranges[fixed].1),
            axes,
            lower: axes.map(|i| ranges[i].0),
            upper: axes.map(|i| ranges[i].1),
            corners,
        })
    }

    fn size(&self) -> f64 {
        (0..2).map(|k| self.upper[k] - self.lower[k]).fold(0.0, f64::max)
    }

    /// Shape functions of the corners at chart coordinates.
    fn shape(&self, at: [f64; 2]) -> [f64; 4] {
        let xi: [f64; 2] =
            std::array::from_fn(|k| (2.0 * at[k] - self.lower[k] - self.upper[k]) / (self.upper[k] - self.lower[k]));
        let n = quad4::value(xi[0], xi[1]);
        self.corners.map(|c| {
            let standard = quad4::CORNERS.iter().position(|s| *s == c);
            n[standard.expect("corners have natural coordinates ±1")]
        })
    }

    /// Area of a unit square of the two coordinates.
    fn area_factor(&self, chart: Chart, x: [f64; 3]) -> f64 {
        match (chart, self.fixed) {
            (Chart::Cylindrical, 0 | 2) => x[0],
            _ => 1.0,
        }
    }
}

impl Element for WetFace {
    crate::answers!(KIND, nodes; linear inspect);

    fn dofs(&self, node: usize) -> &'static [Dof] {
        if node < 4 { &[Dof::Phi] } else { Dof::TRANSLATIONS }
    }

    fn mass(&self, out: &mut LocalMatrix) {
        for (a, row) in self.areas.iter().enumerate() {
            for (b, area) in row.iter().enumerate() {
                for i in 0..3 {
                    out.add_symmetric(a, 4 + 3 * b + i, self.density * area * self.normals[b][i]);
                }
            }
        }
    }

    fn respond(&self, _: Trial<'_>, _out: &mut Response) -> Result<(), ElementError> {
        Ok(())
    }
}

impl Inspect for WetFace {
    /// Pressure p' = −ρ φ̈ on the wall, at the centre of the coupled part.
    fn samples(&self) -> Vec<Sample> {
        let (n, position) = self.centre;
        let mut row = vec![0.0; 16];
        for (entry, n) in row.iter_mut().zip(n) {
            *entry = -self.density * n;
        }
        vec![Sample { name: "pressure", position, row, of_acceleration: true }]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::element::reference_mass;
    use crate::mesh::Cylinder;

    const RADIUS: f64 = 1.7;

    fn cylinder(heights: &[f64]) -> Cylinder {
        Cylinder { radii: vec![0.0, RADIUS], sectors: 9, heights: heights.to_vec() }
    }

    fn normals(face: &Face) -> [[f64; 3]; 4] {
        face.chart.map(|c| [c[1].cos(), c[1].sin(), 0.0])
    }

    /// Wall and liquid divided differently, wall above the liquid: the joined areas are the wetted mantle, a uniform
    /// radial motion displaces its volume, a uniform turn no volume, and z N_a is integrated exactly on both sides.
    #[test]
    fn overlaps_cover_the_wetted_mantle() {
        let liquid = cylinder(&[0.0, 0.5, 1.1, 1.5]).volume().unwrap();
        let wall = cylinder(&[0.0, 0.1, 0.2, 0.9, 1.3, 2.0]).wall().unwrap();
        let (mut area, mut radial, mut turn, mut moment) = (0.0, 0.0, 0.0, 0.0);
        let mut faces = 0;
        for own in &liquid.wall {
            for other in &wall.cells {
                let Some(face) = WetFace::overlapping(own, other, Chart::Cylindrical, normals(other), 1.0).unwrap()
                else {
                    continue;
                };
                faces += 1;
                area += face.area();
                let b = reference_mass(&face);
                for a in 0..4 {
                    for c in 0..4 {
                        let theta = other.chart[c][1];
                        for (i, (n, t)) in [(theta.cos(), -theta.sin()), (theta.sin(), theta.cos())].iter().enumerate()
                        {
                            let value = b.get(a, 4 + 3 * c + i);
                            radial += value * n;
                            turn += value * t;
                            moment += own.chart[a][2] * value * n * other.chart[c][2];
                        }
                    }
                }
            }
        }
        // Each of the 9 sectors: liquid and wall cuts 0 .1 .2 .5 .9 1.1 1.3 1.5.
        assert_eq!(faces, 9 * 7);
        let exact = TAU * RADIUS * 1.5;
        for (found, expected) in
            [(area, exact), (radial, exact), (turn, 0.0), (moment, TAU * RADIUS * 1.5_f64.powi(3) / 3.0)]
        {
            assert!((found - expected).abs() < 1e-12 * exact, "{found} {expected}");
        }
    }

    /// On matching faces both constructors are the same element.
    #[test]
    fn matching_faces() {
        let liquid = cylinder(&[0.0, 0.5]).volume().unwrap();
        let wall = cylinder(&[0.0, 0.5]).wall().unwrap();
        for (own, other) in liquid.wall.iter().zip(&wall.cells) {
            assert_eq!(own.chart, other.chart);
            let direct = WetFace::new(own, Chart::Cylindrical, other.nodes, normals(other), 1.3).unwrap();
            let cut = WetFace::overlapping(own, other, Chart::Cylindrical, normals(other), 1.3).unwrap().unwrap();
            let (a, b) = (reference_mass(&direct), reference_mass(&cut));
            for (x, y) in a.data.iter().zip(&b.data) {
                assert!((x - y).abs() < 1e-14);
            }
        }
        let (own, other) = (&liquid.wall[0], &wall.cells[3]);
        assert!(WetFace::overlapping(own, other, Chart::Cylindrical, normals(other), 1.3).is_ok_and(|f| f.is_none()));
    }

    #[test]
    fn inward_normals_are_rejected() {
        let liquid = cylinder(&[0.0, 0.5]).volume().unwrap();
        let face = &liquid.wall[0];
        let inwards = normals(face).map(|n| n.map(|v| -v));
        assert!(matches!(
            WetFace::new(face, Chart::Cylindrical, face.nodes, inwards, 1.0),
            Err(ElementError::Parameter { .. })
        ));
    }
}
