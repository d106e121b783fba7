//! S11: the wall of tank 8.1 as a model, for the benchmarks of its statics, sectors, locking and grading.
//!
//! All on one sector of n_c: nodes on two rays, displacement unknowns along (e_r, e_φ, e_z), u_φ and the rotation about
//! e_z held. The axially symmetric solution of the whole polygon has these planes of symmetry.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::cylinder_wall::{CylinderWall, Piece, WallSolution};
use super::{Answer, Solution, solve};
use fem::dofs::Dof;
use fem::element::ElementError;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::recovery::{centre_resultants, edge_values};
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{Normals, PlacedShell, ShellCell, ShellSurface};
use fem::element::shell4::{Axes, MembraneShear};
use fem::model::Builder;

const RADIUS: f64 = 1.83;

const STEP: f64 = 0.915;

pub(super) const HEIGHT: f64 = 1.83;

const LOWER: f64 = 2.03e-3;

const UPPER: f64 = 1.27e-3;

/// kN/m².
const YOUNG: f64 = 6.9e7;

const POISSON: f64 = 0.32;

/// One sector of a cylinder in a model.
pub(crate) struct TankStrip {
    /// The model without supports at its ends.
    pub builder: Builder,
    /// Its shells, from below.
    pub placed: PlacedShell,
    /// Nodes on the two rays, level by level.
    pub levels: Vec<[usize; 2]>,
}

/// Strip of one of `sectors` sectors of a cylinder about z with nodes at `heights`; `section(height of the middle)`.
///
/// Errors: those of the elements.
pub(crate) fn wall_strip(
    radius: f64,
    sectors: usize,
    heights: &[f64],
    membrane_shear: MembraneShear,
    section: impl Fn(f64) -> Arc<dyn Section>,
) -> Result<TankStrip, ElementError> {
    let half = PI / sectors as f64;
    let mut builder = Builder::new();
    let mut levels = Vec::with_capacity(heights.len());
    for &z in heights {
        levels.push([-half, half].map(|angle: f64| {
            let (s, c) = angle.sin_cos();
            let node = builder.node([radius * c, radius * s, z]);
            builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
            builder.hold(node, Dof::Uy);
            builder.hold(node, Dof::Ry);
            node
        }));
    }
    let cells = heights.windows(2).zip(levels.windows(2)).map(|(z, l)| ShellCell {
        nodes: [l[0][0], l[0][1], l[1][1], l[1][0]],
        section: section(0.5 * (z[0] + z[1])),
        group: "wall".to_owned(),
    });
    let positions: Vec<[f64; 3]> = levels.iter().flatten().map(|&n| builder.position(n)).collect();
    let radial = |_: usize, node: usize| Vector3::new(positions[node][0], positions[node][1], 0.0);
    let surface = ShellSurface {
        normals: Normals::Exact(&radial),
        axes: Axes::HOOP_Z,
        membrane_shear,
        ..ShellSurface::new(cells.collect())
    };
    let placed = surface.place(&mut builder)?;
    Ok(TankStrip { builder, placed, levels })
}

/// Pieces of the wall of tank 8.1 under a liquid of specific weight `gamma` [kN/m³] up to `fill` [m].
pub(crate) fn tank_pieces(gamma: f64, fill: f64) -> Option<WallSolution> {
    let pressure = |z: f64| gamma * (fill - z).max(0.0);
    let piece =
        |from: f64, top: f64, thickness: f64| Piece { top, thickness, pressure: [pressure(from), pressure(top)] };
    CylinderWall {
        radius: RADIUS,
        youngs_modulus: YOUNG,
        poisson_ratio: POISSON,
        pieces: vec![piece(0.0, STEP, LOWER), piece(STEP, fill, UPPER), piece(fill, HEIGHT, UPPER)],
    }
    .solve()
}

/// Heights between consecutive `breaks`: first element `h0` at the breaks where `refine`, growing by 1.15 up to `cap`,
/// scaled to fit.
pub(super) fn graded(breaks: &[(f64, bool)], h0: f64, cap: f64) -> Vec<f64> {
    let mut out = vec![breaks[0].0];
    for pair in breaks.windows(2) {
        let ((from, lower), (to, upper)) = (pair[0], pair[1]);
        let (mut below, mut above) = (Vec::new(), Vec::new());
        let (mut h_below, mut h_above) = (if lower { h0 } else { cap }, if upper { h0 } else { cap });
        let mut rest = to - from;
        while rest > 0.0 {
            if h_below <= h_above {
                below.push(h_below);
                rest -= h_below;
                h_below = (1.15 * h_below).min(cap);
            } else {
                above.push(h_above);
                rest -= h_above;
                h_above = (1.15 * h_above).min(cap);
            }
        }
        let sizes: Vec<f64> = below.into_iter().chain(above.into_iter().rev()).collect();
        let scale = (to - from) / sizes.iter().sum::<f64>();
        let mut z = from;
        for (k, h) in sizes.iter().enumerate() {
            z += h * scale;
            out.push(if k + 1 == sizes.len() { to } else { z });
        }
    }
    out
}

/// The wall of tank 8.1 on one mesh.
pub(super) struct TankRun {
    pub(super) heights: Vec<f64>,
    pub(super) solution: Solution,
    pub(super) levels: Vec<[usize; 2]>,
}

impl TankRun {
    pub(super) fn new(
        sectors: usize,
        heights: Vec<f64>,
        membrane_shear: MembraneShear,
        gamma: f64,
        fill: f64,
    ) -> Answer<TankRun> {
        let lower: Arc<dyn Section> = Arc::new(ElasticSection::new(YOUNG, POISSON, LOWER, 0.0)?);
        let upper: Arc<dyn Section> = Arc::new(ElasticSection::new(YOUNG, POISSON, UPPER, 0.0)?);
        let section = |z: f64| if z < STEP { lower.clone() } else { upper.clone() };
        let TankStrip { mut builder, placed, levels } = wall_strip(RADIUS, sectors, &heights, membrane_shear, section)?;
        for node in levels[0] {
            super::hold(&mut builder, &[node], &[Dof::Ux, Dof::Uz, Dof::Rx]);
        }
        let mut loads = NodalLoads::new();
        for l in levels.windows(2) {
            let nodes = [l[0][0], l[0][1], l[1][1], l[1][0]];
            let positions = nodes.map(|n| builder.position(n));
            loads.pressure(&nodes, &positions, |x| gamma * (fill - x[2]).max(0.0));
        }
        let solution = solve(builder, placed, &loads, [0.0; 3])?;
        Ok(TankRun { heights, solution, levels })
    }

    /// Radial displacement of every level.
    pub(super) fn w(&self) -> Vec<f64> {
        let radial = |n: usize| {
            let [x, y, _] = self.solution.model.nodes()[n];
            let u = self.solution.displacement(n);
            (u.x * x + u.y * y) / RADIUS
        };
        self.levels.iter().map(|l| 0.5 * (radial(l[0]) + radial(l[1]))).collect()
    }

    /// Height and value of a resultant at the centres.
    pub(super) fn centres(&self, k: usize) -> Vec<(f64, f64)> {
        centre_resultants(&self.solution.model, &self.solution.placed.elements, &self.solution.u)
            .into_iter()
            .map(|(x, n)| (x[2], n[k]))
            .collect()
    }

    /// Moment m_v at the bottom from the reactions.
    pub(super) fn base_moment(&self) -> Answer<f64> {
        let s = &self.solution;
        let forces = s.assembler.nodal_forces(&s.model, &s.u, |_| true)?;
        let edge = edge_values(&s.model, &self.levels[0], false, &forces);
        let hoop = |n: usize| {
            let [x, y, _] = s.model.nodes()[n];
            Vector3::new(-y, x, 0.0) / RADIUS
        };
        let along = |i: usize| hoop(self.levels[0][i]).dot(&Vector3::new(edge[i][3], edge[i][4], edge[i][5]));
        Ok(0.5 * (along(0) + along(1)))
    }
}

pub(super) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

pub(super) fn exact(gamma: f64, fill: f64) -> Answer<WallSolution> {
    tank_pieces(gamma, fill).ok_or_else(|| {
        ElementError::NoAnswer { kind: "cylinder wall", reason: "the closed form is singular".to_owned() }.into()
    })
}

/// The mesh of the sheet's rule: h0 = `factor` √(R t), refined at the bottom, the step and the liquid level.
pub(super) fn rule(factor: f64, fill: f64) -> Vec<f64> {
    let l = (RADIUS * LOWER).sqrt();
    let breaks = [(0.0, true), (STEP, true), (fill, true), (HEIGHT, false)];
    graded(&breaks, factor * l, 1.6 * l)
}

/// Largest w, largest n_φ and largest positive m_v over the closed form, 200 uniform elements, one mesh of sectors.
pub(super) fn ratios(sectors: usize, membrane_shear: MembraneShear) -> Answer<[f64; 3]> {
    let (gamma, fill) = (10.0, 1.525);
    let closed = exact(gamma, fill)?;
    let heights = (0..=200).map(|k| HEIGHT * f64::from(k) / 200.0).collect();
    let run = TankRun::new(sectors, heights, membrane_shear, gamma, fill)?;
    let lower = |values: Vec<(f64, f64)>| largest(values.iter().filter(|p| p.0 < 0.5).map(|p| p.1));
    Ok([
        largest(run.w()) / closed.largest(0.5, |p| p.w).1,
        lower(run.centres(0)) / closed.largest(0.5, |p| p.n_phi).1,
        lower(run.centres(4)) / closed.largest(0.5, |p| p.m_v).1,
    ])
}
