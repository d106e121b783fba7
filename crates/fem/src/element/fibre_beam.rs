//! Straight beam-column of fibres in a plane x–z.
//!
//! ```text
//! 1 ────────── m ────────── 2      e₁ along the beam, e₂ = e_y × e₁      dofs: 1, 2: u_x u_z r_y, in global axes
//!                                                                       m: u_x u_y u_z
//!
//! w    cubic (Hermite) in w₁, θ₁, w₂, θ₂, θ = r_y; with shear the exact static functions, Φ = 12 E I/(G A_s L²)
//! u    quadratic in u₁, u_m, u₂
//! ε₀ = u′ [+ 1/(2L) ∫ w′² dx]      κ = −θ′      γ = w′ − θ
//! f = ∫ (N δε₀ + M δκ + G A_s γ δγ) dx
//! ```
//!
//! **Why a node in the middle.** A cracked section couples N with κ. Where κ is linear along the beam and ε₀ constant, N
//! cannot be constant although equilibrium requires it, and the beam is too stiff (membrane locking of cracked beams). With a
//! linear ε₀ the axial equilibrium of the middle node makes N equal at both Gauss points. Only its displacement along the
//! beam is used; [`FibreBeam::add_to`] makes the node and holds the rest.
//!
//! The term in brackets, on request, is the shortening by deflection averaged over the beam: geometric stiffness
//! N ∫ w′ᵀ w′ dx (P-Δ), for moderate rotations. Mass is consistent with the cubic of Φ = 0 and the quadratic; rotary
//! inertia is left out.
//!
//! Source: Przemieniecki 1968, (5.116); Friedman & Kosmatka 1993 (functions with shear); the coupling of N with κ after
//! Crisfield 1991, section 7.2.

mod abilities;

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::beam_section::FibreSection;
use super::{Element, ElementError, LocalMatrix, Response, Trial, positive, require};
use crate::dofs::Dof;
use crate::model::Builder;
use crate::shape::gauss;

const KIND: &str = "fibre_beam";
/// Dofs of the element.
const SIZE: usize = 9;

type Row = [f64; SIZE];

/// Points along the beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Points {
    /// Two Gauss points: N is equal at both.
    Gauss2,
    /// Three Gauss points.
    Gauss3,
    /// Three Lobatto points, with the sections at the ends and in the middle; exact to degree 3.
    Lobatto3,
}

impl Points {
    /// ξ in −1 … 1 and weights.
    fn rule(self) -> gauss::Rule {
        match self {
            Points::Gauss2 => gauss::TWO,
            Points::Gauss3 => gauss::THREE,
            Points::Lobatto3 => &[(-1.0, 1.0 / 3.0), (0.0, 4.0 / 3.0), (1.0, 1.0 / 3.0)],
        }
    }
}

/// How a beam is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Points along the beam.
    pub points: Points,
    /// Whether the shortening by deflection counts (P-Δ).
    pub second_order: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options { points: Points::Gauss2, second_order: false }
    }
}

/// One section along the beam.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Station {
    /// Weight times length [m].
    weight: f64,
    position: [f64; 3],
    strain: Row,
    curvature: Row,
}

/// The element.
#[derive(Clone, Debug)]
pub struct FibreBeam {
    nodes: [usize; 3],
    length: f64,
    /// Components (x, z) of e₁.
    along: [f64; 2],
    section: Arc<FibreSection>,
    stations: Vec<Station>,
    /// Row of γ; zero for Bernoulli's beam.
    shear: Row,
    /// ∫ w′ᵀ w′ dx/L where it counts.
    shortening: Option<LocalMatrix>,
}

impl FibreBeam {
    /// Beam from `ends[0]` to `ends[1]` [m], both at one y. `nodes`: first, second, middle.
    ///
    /// Errors: ends out of a plane x–z or too close, a section without stiffness.
    pub fn new(
        nodes: [usize; 3],
        ends: [[f64; 3]; 2],
        section: Arc<FibreSection>,
        options: Options,
    ) -> Result<FibreBeam, ElementError> {
        let [dx, dy, dz] = [0, 1, 2].map(|i| ends[1][i] - ends[0][i]);
        let length = dx.hypot(dz);
        require(positive(length), KIND, "length in the plane x–z", length, "> 0")?;
        require(dy.abs() <= 1e-9 * length, KIND, "difference of the ends' y", dy, "0")?;
        let along = [dx / length, dz / length];
        let k = section.at_rest()?.tangent;
        let found = format_args!("{}, {}", k[0][0], k[1][1]);
        require(k[0][0] > 0.0 && k[1][1] > 0.0, KIND, "E A, E I", found, "> 0")?;
        // E I about the centroid.
        let bending = k[1][1] - k[0][1] * k[0][1] / k[0][0];
        let phi = 12.0 * bending / (section.shear() * length * length);
        let station = |&(xi, weight): &(f64, f64)| {
            let s = 0.5 * (1.0 + xi);
            Station {
                weight: 0.5 * weight * length,
                position: [0, 1, 2].map(|i| ends[0][i] + s * (ends[1][i] - ends[0][i])),
                strain: spread(along, &axial_slope(s, length), &[0.0; 4]),
                curvature: spread(along, &[0.0; 3], &rotation_slope(s, length, phi).map(|x| -x)),
            }
        };
        let factor = phi / (1.0 + phi);
        let shear = [-factor / length, -0.5 * factor, factor / length, -0.5 * factor];
        Ok(FibreBeam {
            nodes,
            length,
            along,
            stations: options.points.rule().iter().map(station).collect(),
            shear: spread(along, &[0.0; 3], &shear),
            shortening: options.second_order.then(|| shortening(along, length)),
            section,
        })
    }

    /// Adds a beam between two nodes of `builder` with an added middle node, of which only the displacement along the
    /// beam is free; returns the number of the element.
    ///
    /// Errors: those of [`FibreBeam::new`].
    pub fn add_to(
        builder: &mut Builder,
        group: &str,
        nodes: [usize; 2],
        section: Arc<FibreSection>,
        options: Options,
    ) -> Result<usize, ElementError> {
        let ends = nodes.map(|n| builder.position(n));
        let middle = builder.node([0, 1, 2].map(|i| 0.5 * (ends[0][i] + ends[1][i])));
        let beam = FibreBeam::new([nodes[0], nodes[1], middle], ends, section, options)?;
        let [x, z] = beam.along;
        builder.hold(middle, Dof::Uy);
        if x == 0.0 {
            builder.hold(middle, Dof::Ux);
        } else {
            builder.hold(middle, Dof::Uz);
            if z != 0.0 {
                let e1 = Vector3::new(x, 0.0, z);
                let e2 = Vector3::y();
                builder.frame(middle, Matrix3::from_rows(&[e1.transpose(), e2.transpose(), e1.cross(&e2).transpose()]));
            }
        }
        Ok(builder.element(group, beam))
    }

    /// The section.
    pub fn section(&self) -> &FibreSection {
        &self.section
    }

    /// Number of sections along the beam.
    pub fn points(&self) -> usize {
        self.stations.len()
    }

    fn own<'a>(&self, history: &'a [f64], point: usize) -> &'a [f64] {
        let n = self.section.history_len();
        &history[point * n..(point + 1) * n]
    }

    /// ½ uᵀ G u and G u.
    fn shorten(&self, u: &[f64]) -> Option<(f64, Row)> {
        let g = self.shortening.as_ref()?;
        let row: Row = std::array::from_fn(|i| (0..SIZE).map(|j| g.get(i, j) * u[j]).sum());
        Some((0.5 * dot(&row, u), row))
    }

    /// ε₀ and κ at a station.
    fn strains(&self, station: &Station, u: &[f64], shortening: f64) -> [f64; 2] {
        [dot(&station.strain, u) + shortening, dot(&station.curvature, u)]
    }
}

fn dot(row: &Row, u: &[f64]) -> f64 {
    row.iter().zip(u).map(|(a, b)| a * b).sum()
}

/// u′ over u₁, u₂, u_m.
fn axial_slope(s: f64, l: f64) -> [f64; 3] {
    [(4.0 * s - 3.0) / l, (4.0 * s - 1.0) / l, (4.0 - 8.0 * s) / l]
}

/// θ′ over w₁, θ₁, w₂, θ₂.
fn rotation_slope(s: f64, l: f64, phi: f64) -> [f64; 4] {
    let f = 1.0 / (1.0 + phi);
    let w = 6.0 * f * (2.0 * s - 1.0) / (l * l);
    [w, f * (6.0 * s - 4.0 - phi) / l, -w, f * (6.0 * s - 2.0 + phi) / l]
}

/// A row over (u₁, u₂, u_m) and (w₁, θ₁, w₂, θ₂) as one over the global dofs; e₂ = (z, −x) for e₁ = (x, z).
fn spread([x, z]: [f64; 2], axial: &[f64; 3], bending: &[f64; 4]) -> Row {
    let [u1, u2, um] = *axial;
    let [w1, t1, w2, t2] = *bending;
    [x * u1 + z * w1, z * u1 - x * w1, t1, x * u2 + z * w2, z * u2 - x * w2, t2, x * um, 0.0, z * um]
}

/// Matrix over the axial and one over the bending dofs as one over the global dofs.
fn spread_matrix(along: [f64; 2], axial: &[[f64; 3]; 3], bending: &[[f64; 4]; 4], out: &mut LocalMatrix) {
    let unit_axial = |i: usize| spread(along, &std::array::from_fn(|k| f64::from(k == i)), &[0.0; 4]);
    let unit_bending = |i: usize| spread(along, &[0.0; 3], &std::array::from_fn(|k| f64::from(k == i)));
    for i in 0..3 {
        for j in 0..3 {
            add_product(axial[i][j], &unit_axial(i), &unit_axial(j), out);
        }
    }
    for i in 0..4 {
        for j in 0..4 {
            add_product(bending[i][j], &unit_bending(i), &unit_bending(j), out);
        }
    }
}

/// A ← A + factor a bᵀ.
fn add_product(factor: f64, a: &Row, b: &Row, out: &mut LocalMatrix) {
    if factor == 0.0 {
        return;
    }
    for j in 0..SIZE {
        for i in 0..SIZE {
            out.data[i + j * SIZE] += factor * a[i] * b[j];
        }
    }
}

/// ∫ w′ᵀ w′ dx/L of the cubics.
fn shortening(along: [f64; 2], l: f64) -> LocalMatrix {
    let (a, b, c, d) = (1.2 / (l * l), 0.1 / l, 2.0 / 15.0, -1.0 / 30.0);
    let rows = [[a, b, -a, b], [b, c, -b, d], [-a, -b, a, -b], [b, d, -b, c]];
    let mut out = LocalMatrix::zeros(SIZE);
    spread_matrix(along, &[[0.0; 3]; 3], &rows, &mut out);
    out
}

impl Element for FibreBeam {
    crate::answers!(KIND, nodes; inspect buckling);

    fn dofs(&self, node: usize) -> &'static [Dof] {
        match node {
            2 => Dof::TRANSLATIONS,
            _ => &[Dof::Ux, Dof::Uz, Dof::Ry],
        }
    }

    fn history_len(&self) -> usize {
        self.stations.len() * self.section.history_len()
    }

    fn init_history(&self, slots: &mut [f64]) {
        for own in slots.chunks_exact_mut(self.section.history_len()) {
            self.section.init_history(own);
        }
    }

    fn mass(&self, out: &mut LocalMatrix) {
        let m = self.section.mass() * self.length;
        let (l, f) = (self.length, m / 420.0);
        let bending = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        let axial = [[4.0, -1.0, 2.0], [-1.0, 4.0, 2.0], [2.0, 2.0, 16.0]];
        spread_matrix(
            self.along,
            &axial.map(|row| row.map(|x| m / 30.0 * x)),
            &bending.map(|row| row.map(|x| f * x)),
            out,
        );
    }

    fn has_mass(&self) -> bool {
        self.section.mass() > 0.0
    }

    fn respond(&self, Trial { motion, old, new, want }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let u = motion.values;
        let shortened = self.shorten(u);
        let (mut mean, slots) = (0.0, self.section.history_len());
        for (point, station) in self.stations.iter().enumerate() {
            let strains = self.strains(station, u, shortened.map_or(0.0, |(e, _)| e));
            let range = point * slots..(point + 1) * slots;
            let found = self.section.respond(strains, &old[range.clone()], &mut new[range])?;
            let mut strain = station.strain;
            if let Some((_, row)) = &shortened {
                strain.iter_mut().zip(row).for_each(|(a, b)| *a += b);
            }
            let (weight, curvature) = (station.weight, &station.curvature);
            let (n, m) = (weight * found.axial, weight * found.moment);
            mean += n;
            if want.force {
                for (f, (e, k)) in out.force.iter_mut().zip(strain.iter().zip(curvature)) {
                    *f += n * e + m * k;
                }
            }
            if want.tangent {
                let [[c00, c01], [c10, c11]] = found.tangent.map(|row| row.map(|c| weight * c));
                for j in 0..SIZE {
                    let (a, b) = (c00 * strain[j] + c01 * curvature[j], c10 * strain[j] + c11 * curvature[j]);
                    for i in 0..SIZE {
                        out.tangent.data[i + j * SIZE] += strain[i] * a + curvature[i] * b;
                    }
                }
            }
        }
        let shear = self.section.shear() * self.length;
        if shear.is_finite() {
            let force = shear * dot(&self.shear, u);
            if want.force {
                out.force.iter_mut().zip(&self.shear).for_each(|(f, g)| *f += force * g);
            }
            if want.tangent {
                add_product(shear, &self.shear, &self.shear, &mut out.tangent);
            }
        }
        if want.tangent
            && let Some(g) = &self.shortening
        {
            out.tangent.data.iter_mut().zip(&g.data).for_each(|(k, g)| *k += mean * g);
        }
        Ok(())
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        let [x, z] = self.along;
        let load = self.section.weight_mass() * self.length;
        let axial = load * (x * acceleration[0] + z * acceleration[2]);
        let across = load * (z * acceleration[0] - x * acceleration[2]);
        let end = self.length / 12.0 * across;
        let row = spread(
            self.along,
            &[axial / 6.0, axial / 6.0, axial * 2.0 / 3.0],
            &[0.5 * across, end, 0.5 * across, -end],
        );
        out.iter_mut().zip(row).for_each(|(o, f)| *o += f);
    }
}

#[cfg(test)]
mod tests;
