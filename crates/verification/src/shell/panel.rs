//! Nonlinear buckling of a cylinder under axial compression: perfect, and with axisymmetric imperfections.
//!
//! A perfect cylinder buckles at σ = E t/(R √(3 (1 − ν²))) in all waves of Koiter's circle m² + s² = m₀ m at once
//! (m axial, s circumferential wave number), m₀ = (12 (1 − ν²))^¼/√(R t). An imperfection w₀ = δ cos m₀ z in the shape of the
//! axisymmetric wave meets the square waves m = s = m₀/2, and the cylinder bifurcates from its axisymmetric state at λ
//! times that stress,
//!
//! ```text
//! (1 − λ)² = 3/2 √(3 (1 − ν²)) λ |δ|/t                               δ ≪ t
//! ```
//!
//! Model: one half-wave of m₀/2 along the axis and one of s around it between planes of symmetry, 2π/m₀ by π/s. Only waves
//! that fit between these planes can appear.
//!
//! Source: Koiter 1945 (the formula), 1963 (axisymmetric imperfections).

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::path::{Problem, SHARP};
use super::{Answer, Grid, hold};
use fem::analysis::continuation::{Continuation, Critical};
use fem::dofs::Dof;
use fem::element::shell::load::{FollowerPressure, NodalLoads};
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;
use fem::element::shell4::Axes;
use fem::element::spring::{Direction, Spring};
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;

const RADIUS: f64 = 1.0;

pub(super) const THICKNESS: f64 = 1.0 / 400.0;

pub(super) const NU: f64 = 0.3;

/// A panel of n × n elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Panel {
    /// n.
    pub(super) elements: usize,
    /// Circumferential wave number s/m₀.
    pub(super) wave: f64,
    /// Hoop stress p R/t of an internal pressure over the classical stress.
    pub(super) pressure: f64,
}

/// Place of a node and its normal, of any length.
pub(super) type Place = (Vector3<f64>, Vector3<f64>);

impl Panel {
    /// The panel of the square waves, without pressure.
    pub(super) fn square(elements: usize) -> Panel {
        Panel { elements, wave: 0.5, pressure: 0.0 }
    }

    /// m₀.
    pub(super) fn axial_wave() -> f64 {
        (12.0_f64 * (1.0 - NU * NU)).powf(0.25) / (RADIUS * THICKNESS).sqrt()
    }

    /// Node on the first meridian, level `j`.
    pub(super) fn node(&self, j: usize) -> usize {
        Grid::new(self.elements, self.elements).node(0, j)
    }

    /// The panel under the classical load; `place` moves the node at a position of the cylinder.
    pub(super) fn problem(&self, place: impl Fn(usize, Vector3<f64>) -> Place) -> Answer<Problem> {
        let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.0, NU, THICKNESS, 0.0)?);
        let n = self.elements;
        let height = 2.0 * PI / Panel::axial_wave();
        let angle = PI / (self.wave * Panel::axial_wave() * RADIUS);
        let grid = Grid::new(n, n);
        let mut builder = Builder::new();
        let mut normals = Vec::new();
        for j in 0..=n {
            for i in 0..=n {
                let (s, c) = (angle * i as f64 / n as f64).sin_cos();
                let z = height * j as f64 / n as f64;
                let (position, normal) = place(grid.node(i, j), Vector3::new(RADIUS * c, RADIUS * s, z));
                let node = builder.node(position.into());
                normals.push(normal);
                // Displacements along e_r, e_φ, e_z.
                builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
            }
        }
        let normal = |_: usize, node: usize| normals[node];
        let mut shell = grid.surface(&section);
        (shell.normals, shell.axes) = (Normals::Exact(&normal), Axes::HOOP_Z);
        shell.place(&mut builder)?;
        let classical = THICKNESS / (RADIUS * (3.0 * (1.0 - NU * NU)).sqrt());
        if self.pressure > 0.0 {
            let pressure = self.pressure * classical * THICKNESS / RADIUS;
            for &nodes in &grid.cells {
                let positions = nodes.map(|n| builder.position(n));
                builder.element("pressure", FollowerPressure::new(nodes, positions, pressure));
            }
        }
        for ray in [0, n] {
            hold(&mut builder, &grid.line_i(ray), &[Dof::Uy, Dof::Ry]);
        }
        hold(&mut builder, &grid.line_j(0), &[Dof::Uz, Dof::Rx]);
        hold(&mut builder, &grid.line_j(n), &[Dof::Rx]);
        // The upper plane of symmetry stays plane: its nodes hang on one, by springs a thousand times as stiff as the panel.
        let master = builder.node([0.0, 0.0, height]);
        let stiffness = 1e3 * THICKNESS * angle / height;
        for node in grid.line_j(n) {
            let spring = Spring::between(node, master, Direction::Translation([0.0, 0.0, 1.0]), stiffness)?;
            builder.element("plane", spring);
        }
        hold(&mut builder, &[master], &[Dof::Ux, Dof::Uy]);
        let mut loads = NodalLoads::new();
        loads.force(master, [0.0, 0.0, -classical * THICKNESS * angle * RADIUS]);
        Problem::new(builder, &loads)
    }

    /// With the imperfection δ cos m₀ z, `delta` thicknesses inwards at its ends.
    pub(super) fn axisymmetric(&self, delta: f64) -> Answer<Problem> {
        let wave = Panel::axial_wave();
        self.problem(|_, p| {
            let radial = Vector3::new(p.x, p.y, 0.0) / RADIUS;
            let depth = delta * THICKNESS;
            let slope = depth * wave * (wave * p.z).sin();
            (p - radial * (depth * (wave * p.z).cos()), radial - Vector3::z() * slope)
        })
    }
}

/// Last stable load of a panel to a thousandth of the classical one, with the path and the state there.
pub(super) fn instability<'a>(problem: &'a Problem) -> Answer<(Critical, Continuation<'a>, State)> {
    let mut path = problem.continuation(SHARP)?.with_extrapolated_stresses();
    let mut state = State::new(&problem.model);
    let critical = path.first_instability(&mut state, 0.1, 1e-3, 1.5, &Silent)?;
    Ok((critical, path, state))
}
