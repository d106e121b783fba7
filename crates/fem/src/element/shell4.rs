//! Four-node shell with finite rotations: MITC4 with centre-point membrane shear, total Lagrangian.
//!
//! ```text
//!   4 ─────── 3      s       x = Σ N_a x_a          reference surface
//!   │         │      ▲       d = Σ N_a d_a          director, d_a = R_a D_a
//!   │         │      └─► r   x + ζ d                material point
//!   1 ─────── 2
//! ```
//!
//! Green-Lagrange strains in the Cartesian tangent frame e_1, e_2 of each point (quadratic terms in ζ dropped):
//!
//! ```text
//! ε_ij = ½ (x,i · x,j − X,i · X,j)
//! κ_ij = ½ (x,i · d,j + x,j · d,i − X,i · D,j − X,j · D,i)
//! γ_α  = x,α · d − X,α · D                 at the mid-points of the edges, interpolated linearly (MITC)
//! 2ε_12 := 2ε_12 at r = s = 0              at all four Gauss points (centre-point membrane shear)
//! ```
//!
//! All of them are polynomials of degree two in q = (x_a, d_a), so that ∂²(strain)/∂q² is constant:
//!
//! ```text
//! f_q = ∫ Bᵀ S dA ,  K_q = ∫ Bᵀ C B dA + ∫ S : ∂²(strain)/∂q² dA
//! f_θ = d × f_d ,  δd = θ × d = P θ ,  P = −skew(d)
//! K_uθ = K_xd P ,  K_θθ = Pᵀ K_dd P + ½ (f_d dᵀ + d f_dᵀ) − (f_d · d) 1       at every node
//! ```
//!
//! The last block is the second derivative of the energy along exp(skew θ) R: the tangent is symmetric everywhere. The
//! derivative of f_θ itself differs from it by ½ skew(f_θ), which vanishes with the nodal moments at equilibrium.
//!
//! Strains are evaluated from displacements u = x − X and w = d − D, never as differences of the two metrics: these
//! leave a residual of 10⁻¹⁶ E t |X|.
//!
//! Source: Dvorkin & Bathe 1984 (tying), Simo & Fox 1989 (measures); the centre-point shear and its reason are derived in
//! `docs/theory/shell-element.md`. Thickness change is not represented.

mod inspect;
mod lanes;
mod mixed;
mod place;
pub(super) mod rows;
mod strain;
mod turn;

use std::sync::Arc;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use lanes::{Forces, Four, Fours, Strains};
use rows::{add_material, put};
use strain::Stressed;
use turn::Turn;

use super::shell::director::turned;
use super::shell::drilling::Corner;
use super::shell::geometry::Point;
use super::shell::section::{Section, SectionResponse};
use super::{Buckling, Element, ElementError, LocalMatrix, Mixed, Response, Stage, Trial, not_negative, require};
use crate::dofs::Dof;

pub use rows::{Row, SIZE};

/// Names of the resultants, in the order of the section.
pub const RESULTANTS: [&str; 8] = ["n_11", "n_22", "n_12", "m_11", "m_22", "m_12", "q_1", "q_2"];

/// How the membrane shear strain is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum MembraneShear {
    /// Its value at the centre at all points.
    #[default]
    CentrePoint,
    /// Point by point: plain MITC4. Locks in thin cylinders; for comparison only.
    Full,
}

/// Distribution of the mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum MassKind {
    /// ∫ ρ Nᵀ N.
    #[default]
    Consistent,
    /// ∫ ρ N_a at node a, without coupling between nodes.
    Lumped,
}

/// Frame of resultants in output: e_1 by this rule, projected on the tangent plane; e_2 = n × e_1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axes {
    /// e_1 along X,r of the element's centre.
    Element,
    /// e_1 along a given vector.
    Along([f64; 3]),
    /// e_1 in hoop direction about the axis through `origin` along `axis`: axis × radius. On a wall whose normal points
    /// outwards e_2 is then the meridian, along the axis.
    Hoop {
        /// A point of the axis [m].
        origin: [f64; 3],
        /// Direction of the axis.
        axis: [f64; 3],
    },
}

impl Axes {
    /// Hoop direction about the global z axis.
    pub const HOOP_Z: Axes = Axes::Hoop { origin: [0.0; 3], axis: [0.0, 0.0, 1.0] };

    /// Unit e_1 at `position` on a surface with the unit normal `normal`; `None` where the rule does not apply.
    pub fn first(&self, position: Vector3<f64>, normal: Vector3<f64>) -> Option<Vector3<f64>> {
        let wish = match *self {
            Axes::Element => return None,
            Axes::Along(v) => Vector3::from(v),
            Axes::Hoop { origin, axis } => Vector3::from(axis).cross(&(position - Vector3::from(origin))),
        };
        let scale = wish.norm();
        let tangent = wish - normal * normal.dot(&wish);
        // Within 0.06 degrees of the normal (or on the axis) there is no direction to project.
        (tangent.norm() > 1e-3 * scale).then(|| tangent.normalize())
    }
}

/// Four-node shell.
#[derive(Clone)]
pub struct Shell4 {
    nodes: [usize; 4],
    x: [Vector3<f64>; 4],
    directors: [Vector3<f64>; 4],
    section: Arc<dyn Section>,
    points: [Point; 4],
    centre: Point,
    /// The points side by side.
    fours: Fours,
    membrane_shear: MembraneShear,
    mass: MassKind,
    axes: Axes,
    /// From the frames of the Gauss points to that of the section, where the section needs it.
    turns: Option<[Turn; 4]>,
    drilling: Vec<Corner>,
}

impl Shell4 {
    /// A shell with corners at `positions` [m] and initial unit directors `directors`.
    ///
    /// Errors: a quadrilateral that is degenerate or folded over, a director that is not a unit vector within 90 degrees
    /// of the normal.
    pub fn new(
        nodes: [usize; 4],
        positions: [[f64; 3]; 4],
        directors: [Vector3<f64>; 4],
        section: Arc<dyn Section>,
    ) -> Result<Shell4, ElementError> {
        const A: f64 = 0.577_350_269_189_625_8;
        let x = positions.map(Vector3::from);
        let at = |r, s, weight| Point::new(&x, r, s, weight, &nodes);
        let points = [at(-A, -A, 1.0)?, at(A, -A, 1.0)?, at(A, A, 1.0)?, at(-A, A, 1.0)?];
        let centre = at(0.0, 0.0, 4.0)?;
        for d in &directors {
            let good = (d.norm() - 1.0).abs() <= 1e-9 && d.dot(&centre.axis(2)) > 0.0;
            let found = format_args!("({:.3e}, {:.3e}, {:.3e})", d.x, d.y, d.z);
            require(good, "shell4", "director", found, "a unit vector within 90 degrees of the normal")?;
        }
        Ok(Shell4 {
            fours: Fours::new(&x, &points),
            nodes,
            x,
            directors,
            section,
            points,
            centre,
            membrane_shear: MembraneShear::default(),
            mass: MassKind::default(),
            axes: Axes::Element,
            turns: None,
            drilling: Vec::new(),
        })
    }

    /// The same with another membrane shear.
    pub fn with_membrane_shear(mut self, membrane_shear: MembraneShear) -> Shell4 {
        self.membrane_shear = membrane_shear;
        self
    }

    /// The same with another distribution of mass.
    pub fn with_mass(mut self, mass: MassKind) -> Shell4 {
        self.mass = mass;
        self
    }

    /// The same with another frame for the section and for all output. Where its rule does not apply (on the
    /// axis) the element's own frame is taken.
    pub fn with_axes(mut self, axes: Axes) -> Shell4 {
        self.axes = axes;
        let turns = self.points.each_ref().map(|p| self.turn(p));
        let needed = self.section.has_frame() && turns.iter().any(|t| *t != Turn::NONE);
        self.turns = needed.then_some(turns);
        self.fours.set_turns(self.turns.as_ref());
        self
    }

    /// The same with drilling energy at the corners with `at[corner]` (those with six dofs), `factor` k_d ≥ 0.
    ///
    /// Errors: a degenerate corner, a negative factor.
    pub fn with_drilling(mut self, at: [bool; 4], factor: f64) -> Result<Shell4, ElementError> {
        require(not_negative(factor), "shell4", "drilling factor", factor, "≥ 0 and finite")?;
        self.drilling.clear();
        for corner in (0..4).filter(|&c| at[c]) {
            let area: f64 = self.points.iter().map(|p| p.n[corner] * p.area).sum();
            let stiffness = factor * self.section.shear_stiffness() * area;
            self.drilling.push(Corner::new(&self.x, corner, stiffness, &self.nodes)?);
        }
        Ok(self)
    }

    /// Area of the reference surface [m²].
    pub fn area(&self) -> f64 {
        self.points.iter().map(|p| p.area).sum()
    }

    /// Corners of the reference surface [m].
    pub fn corners(&self) -> &[Vector3<f64>; 4] {
        &self.x
    }

    /// Initial unit directors at the corners.
    pub fn directors(&self) -> &[Vector3<f64>; 4] {
        &self.directors
    }

    /// The Gauss points, counter-clockwise as the corners.
    pub fn points(&self) -> &[Point; 4] {
        &self.points
    }

    /// The centre.
    pub fn centre(&self) -> &Point {
        &self.centre
    }

    /// Force and tangent; with `kept` the geometric part of the tangent takes extrapolated stresses.
    fn answer(&self, trial: Trial<'_>, mut kept: Option<&mut [f64]>, out: &mut Response) -> Result<(), ElementError> {
        let Trial { motion, old, new, want } = trial;
        let arch = pulp::Arch::new();
        let c = self.configuration(&motion);
        let (strains, slopes) = arch.dispatch(Strains { own: &self.fours, values: self.values(&c), c: &c });
        let common = want.tangent.then(|| self.common(&c));
        let extrapolated = match &kept {
            Some(kept) if want.tangent => self.extrapolate(kept, &motion),
            _ => None,
        };
        let (mut stressed, mut other) = (Stressed::default(), Stressed::default());
        let mut any = false;
        let mut section = SectionResponse::default();
        let mut resultants: [Four; 8] = [[0.0; 4]; 8];
        let len = self.section.history_len();
        for (g, p) in self.points.iter().enumerate() {
            let slots = g * len..(g + 1) * len;
            let (old, new) = (&old[slots.clone()], &mut new[slots]);
            let strain = strains.map(|of| of[g]);
            match want.tangent {
                true => self.section.respond(&strain, old, new, &mut section)?,
                false => self.section.resist(&strain, old, new, &mut section)?,
            }
            resultants.iter_mut().zip(section.resultants).for_each(|(to, n)| to[g] = n);
            let Some(common) = &common else { continue };
            let turn = self.turns.as_ref().map_or(Turn::NONE, |t| t[g]);
            turn.back(&mut section);
            let rows = Self::rows(p, &c, common);
            add_material(&rows, &section.tangent, p.area, &mut out.tangent);
            any |= section.resultants.iter().any(|&n| n != 0.0);
            if let Some(extrapolated) = &extrapolated {
                any |= extrapolated[g].iter().any(|&n| n != 0.0);
                self.stress(p, &extrapolated[g], &mut other);
            }
            if let Some(kept) = kept.as_deref_mut() {
                mixed::keep_point(kept, g, &section);
            }
            self.stress(p, &section.resultants, &mut stressed);
        }
        if want.force {
            let force = &mut out.force[..];
            let centre = (self.membrane_shear == MembraneShear::CentrePoint).then_some(&self.centre);
            arch.dispatch(Forces { own: &self.fours, centre, c: &c, slopes: &slopes, resultants: &resultants, force });
        }
        if want.tangent {
            out.tangent.mirror();
            if any {
                let stressed = if extrapolated.is_some() { &other } else { &stressed };
                self.add_geometric(&c, stressed, &mut out.tangent);
            }
            if let Some(kept) = kept {
                mixed::keep_motion(kept, &motion);
            }
        }
        for corner in &self.drilling {
            corner.respond(&c.u, &motion.rotations[corner.node], want, out);
        }
        Ok(())
    }

    /// Tangent of the initial section, in its own frame.
    fn initial_tangent(&self) -> Result<[[f64; 8]; 8], ElementError> {
        let mut old = vec![0.0; self.section.history_len()];
        self.section.init_history(&mut old);
        let mut new = old.clone();
        let mut response = SectionResponse::default();
        self.section.respond(&[0.0; 8], &old, &mut new, &mut response)?;
        Ok(response.tangent)
    }
}

impl Element for Shell4 {
    crate::answers!("shell4", nodes, Dof::SHELL; inspect mixed buckling);

    fn history_len(&self) -> usize {
        4 * self.section.history_len()
    }

    fn init_history(&self, slots: &mut [f64]) {
        let len = self.section.history_len();
        if len > 0 {
            slots.chunks_exact_mut(len).for_each(|s| self.section.init_history(s));
        }
    }

    fn stage(&self, stage: Stage, history: &mut [f64]) {
        let len = self.section.history_len();
        if len > 0 {
            history.chunks_exact_mut(len).for_each(|own| self.section.stage(stage, own));
        }
    }

    fn mass(&self, out: &mut LocalMatrix) {
        let [m0, m1, m2] = self.section.inertia();
        let spin = self.directors.map(|d| -d.cross_matrix());
        let mut pair = |a: usize, b: usize, area: f64| {
            let turn: Matrix3<f64> = spin[a].transpose() * spin[b] * (m2 * area);
            for i in 0..3 {
                out.add(6 * a + i, 6 * b + i, m0 * area);
                for j in 0..3 {
                    out.add(6 * a + 3 + i, 6 * b + 3 + j, turn[(i, j)]);
                    if m1 != 0.0 {
                        out.add_symmetric(6 * a + i, 6 * b + 3 + j, m1 * area * spin[b][(i, j)]);
                    }
                }
            }
        };
        for p in &self.points {
            for a in 0..4 {
                match self.mass {
                    MassKind::Lumped => pair(a, a, p.n[a] * p.area),
                    MassKind::Consistent => (0..4).for_each(|b| pair(a, b, p.n[a] * p.n[b] * p.area)),
                }
            }
        }
    }

    fn has_mass(&self) -> bool {
        self.section.inertia()[0] > 0.0
    }

    fn respond(&self, trial: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        self.answer(trial, None, out)
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        let [m0, m1, _] = self.section.inertia();
        let b = Vector3::from(acceleration);
        for p in &self.points {
            for a in 0..4 {
                let weight = p.n[a] * p.area;
                let turn = self.directors[a].cross(&b);
                for i in 0..3 {
                    out[6 * a + i] += m0 * weight * b[i];
                    out[6 * a + 3 + i] += m1 * weight * turn[i];
                }
            }
        }
    }
}

impl Mixed for Shell4 {
    fn mixed_len(&self) -> usize {
        mixed::LEN
    }

    fn respond_mixed(&self, trial: Trial<'_>, kept: &mut [f64], out: &mut Response) -> Result<(), ElementError> {
        self.answer(trial, Some(kept), out)
    }
}

impl Buckling for Shell4 {
    fn geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError> {
        let reference = self.reference();
        let common = self.common(&reference);
        let tangent = self.initial_tangent()?;
        let mut stressed = Stressed::default();
        for (g, p) in self.points.iter().enumerate() {
            let strain =
                Self::rows(p, &reference, &common).map(|row| row.iter().zip(values).map(|(b, v)| b * v).sum::<f64>());
            let turn = self.turns.as_ref().map_or(Turn::NONE, |t| t[g]);
            let strain = turn.strain(&strain);
            let resultants = tangent.map(|row| row.iter().zip(&strain).map(|(c, e)| c * e).sum());
            self.stress(p, &turn.resultants_back(&resultants), &mut stressed);
        }
        self.add_geometric(&reference, &stressed, out);
        Ok(())
    }
}

/// Motion of a rigid body for tests and checks: local values and rotations under x → c + R (x − c) + v.
pub fn rigid_motion(
    positions: &[[f64; 3]; 4],
    rotation: UnitQuaternion<f64>,
    translation: [f64; 3],
) -> ([f64; SIZE], [UnitQuaternion<f64>; 4]) {
    let mut values = [0.0; SIZE];
    for (a, &x) in positions.iter().enumerate() {
        let x = Vector3::from(x);
        put(&mut values, 6 * a, turned(&rotation, &x) + Vector3::from(translation));
    }
    (values, [rotation; 4])
}

#[cfg(test)]
mod tests;
