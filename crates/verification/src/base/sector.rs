//! One sector of wall and round bottom plate as shells on unilateral ground, lifted evenly all around.
//!
//! Source:    an independent axisymmetric program of plate, ground and wall's edge; `base::Strip` with rings in place of beams
//! Model:     MITC4 between two meridians, large rotations: wall of 8 √(R s), round plate, fold at the foot; ground at the nodes
//! Reference: F(w) of the independent program, tank C
//! Tolerance: 2 %: rings of another discretisation; the wall is a shell here, the edge of a long cylinder there

use std::f64::consts::PI;
use std::sync::Arc;

use fem::analysis::continuation::{Constraint, Continuation, StepLength};
use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::element::Inspect;
use fem::element::ground::Ground;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{Normals, ShellCell, ShellSurface};
use fem::element::shell4::Axes;
use fem::linalg::Symbolic;
use fem::model::{Builder, Model};
use fem::progress::Silent;
use fem::state::{Gather, State};
use nalgebra::{Matrix3, Vector3};

use super::shells::{CRITERIA, stations};
use super::{GRAVITY, Sample, TANKS};
use crate::benchmark::{Benchmark, Part};
use crate::shell::hold;
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-sector",
    title: "Wall and bottom plate as shells, lifted evenly",
    model: "One sector of 180 of tank C: the wall as a shell, welded to the round bottom plate, which lies on ground that pushes but does \
            not pull. The uplift is the same all around.",
    ids: &[("U8", "hold-down force against uplift on k = 10⁸ N/m³")],
    parts: &[Part::Fast(rows)],
};

const SECTORS: f64 = 180.0;

/// Radius within which the plate stays on the ground, over that of the tank.
const CORE: f64 = 0.05;

/// Modulus of the ground [N/m³].
pub(super) const GROUND: f64 = 1e8;

/// One sector of wall and bottom plate.
pub(super) struct Sector<'a> {
    pub(super) tank: &'a Sample,
    pub(super) wall: Arc<dyn Section>,
    pub(super) plate: Arc<dyn Section>,
    /// Heights of the levels from the foot [m].
    pub(super) heights: Vec<f64>,
    /// First element of the plate at the foot [m].
    pub(super) first: f64,
}

/// A state of a sector.
pub(super) struct Lift {
    /// Hold-down force [N/m].
    pub(super) force: f64,
    /// Plastic rotations of the plate and of the wall at the joint [rad].
    pub(super) plastic: [f64; 2],
}

impl Sector<'_> {
    /// States at uplifts of the rim [m].
    pub(super) fn lift(&self, uplifts: &[f64]) -> Answer<Vec<Lift>> {
        let tank = self.tank;
        let (radius, half) = (tank.radius, PI / SECTORS);
        let mut builder = Builder::new();
        let mut pair = |r: f64, z: f64| {
            [-half, half].map(|angle: f64| {
                let (s, c) = angle.sin_cos();
                let node = builder.node([r * c, r * s, z]);
                builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
                node
            })
        };
        let levels: Vec<[usize; 2]> = self.heights.iter().map(|&z| pair(radius, z)).collect();
        let foot = levels[0];
        let inner = CORE * radius;
        let mut radii: Vec<f64> =
            stations(radius - inner, self.first, 80.0 * tank.plate, 1.15).iter().map(|x| inner + x).collect();
        radii.pop();
        let mut rings: Vec<[usize; 2]> = radii.iter().map(|&r| pair(r, 0.0)).collect();
        radii.push(radius);
        rings.push(foot);
        let mut cells = Vec::new();
        let mut dead = NodalLoads::new();
        for l in levels.windows(2) {
            let nodes = [l[0][0], l[0][1], l[1][1], l[1][0]];
            let positions = nodes.map(|n| builder.position(n));
            dead.pressure(&nodes, &positions, |x| tank.pressure() - tank.density * GRAVITY * x[2]);
            cells.push((nodes, self.wall.clone()));
        }
        let of_wall = cells.len();
        for (r, l) in radii.windows(2).zip(rings.windows(2)) {
            let nodes = [l[0][0], l[1][0], l[1][1], l[0][1]];
            let positions = nodes.map(|n| builder.position(n));
            dead.pressure(&nodes, &positions, |_| -tank.pressure());
            let width = (r[1] - r[0]) * half;
            // ∫ N r dr of the inner and the outer ring.
            let areas = [width * (2.0 * r[0] + r[1]) / 6.0, width * (r[0] + 2.0 * r[1]) / 6.0];
            for (ring, area) in l.iter().zip(areas) {
                for &node in ring {
                    builder.element("ground", Ground::new(node, GROUND, area)?);
                }
            }
            cells.push((nodes, self.plate.clone()));
        }
        let count = 2 * (levels.len() + rings.len() - 1);
        let places: Vec<[f64; 3]> = (0..count).map(|n| builder.position(n)).collect();
        let normal = |cell: usize, node: usize| match cell < of_wall {
            true => Vector3::new(places[node][0], places[node][1], 0.0),
            false => Vector3::z(),
        };
        let cell = |(nodes, section)| ShellCell { nodes, section, group: "shell".to_owned() };
        let surface = ShellSurface {
            normals: Normals::Exact(&normal),
            axes: Axes::HOOP_Z,
            ..ShellSurface::new(cells.into_iter().map(cell).collect())
        };
        let elements = surface.place(&mut builder)?.elements;
        for nodes in levels[1..].iter().chain(&rings[..rings.len() - 1]) {
            hold(&mut builder, nodes, &[Dof::Uy, Dof::Ry]);
        }
        for (&node, angle) in foot.iter().zip([-half, half]) {
            // A fold has rotations about global axes: turned to the meridian, whose plane is one of symmetry.
            let (s, c) = f64::sin_cos(angle);
            builder.rotation_frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
            hold(&mut builder, &[node], &[Dof::Uy, Dof::Rx, Dof::Rz]);
        }
        hold(&mut builder, &rings[0], &[Dof::Ux, Dof::Rx]);
        let edge = radius * half;
        let mut pull = NodalLoads::new();
        for node in foot {
            dead.force(node, [0.0, 0.0, -edge * tank.weight]);
            pull.force(node, [0.0, 0.0, edge]);
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &order(&model, assembler.pattern()))?);
        let (dead, pull) = (dead.vector(&model), pull.vector(&model));
        let none = vec![0.0; dead.len()];
        let mut state = State::new(&model);
        let mut rest = Continuation::new(&model, &assembler, &symbolic, &none, &dead, CRITERIA)?;
        for step in 1..=8 {
            rest.step(&mut state, &Constraint::Load(f64::from(step) / 8.0))
                .map_err(|e| Failure::from(format!("at rest, step {step}: {e}")))?;
        }
        let mut path = Continuation::new(&model, &assembler, &symbolic, &dead, &pull, CRITERIA)?;
        let lengths = StepLength { first: 1e-4, shortest: 1e-7, longest: 5e-3 };
        // From the joint on.
        let sizes = |x: &[f64]| x.windows(2).map(|x| x[1] - x[0]).collect::<Vec<f64>>();
        let wall: Vec<(usize, f64)> = elements.iter().copied().zip(sizes(&self.heights)).collect();
        let plate: Vec<(usize, f64)> = elements[of_wall..].iter().copied().zip(sizes(&radii)).rev().collect();
        let soft = |t: f64| 12.0 / (tank.young_modulus * t.powi(3));
        let row = model.row(foot[0], Dof::Uz);
        let mut found = Vec::new();
        let followed = path.to_displacements(&mut state, &row, uplifts, lengths, &Silent, |_, point, state| {
            let plastic = [(&plate, soft(tank.plate)), (&wall, soft(tank.wall))];
            let plastic = plastic.map(|(cells, soft)| hinge(&model, state, cells, soft).unwrap_or(f64::NAN));
            found.push(Lift { force: point.factor - tank.weight, plastic });
        })?;
        match followed.failure {
            Some(error) => Err(Failure::from(format!("after {} uplifts: {error}", found.len()))),
            None => Ok(found),
        }
    }
}

/// ∫ (κ − (M − ν M_hoop)/D′) ds of the meridian from the first of `cells`, each with its length, to where its sign changes [rad]; D′ = E t³/12 is
/// the inverse of `soft`.
fn hinge(model: &Model, state: &State, cells: &[(usize, f64)], soft: f64) -> Answer<f64> {
    let mut gather = Gather::default();
    let mut sum = 0.0_f64;
    for &(cell, length) in cells {
        let element = &*model.elements()[cell];
        let motion = gather.motion(model, &state.committed, element);
        let sections = element.sections(motion, &state.old[state.history(cell)])?;
        let plastic = |s: &fem::element::SectionState| s.strain[4] - soft * (s.resultants[4] - 0.3 * s.resultants[3]);
        let part = length * sections.iter().map(plastic).sum::<f64>() / sections.len() as f64;
        // Elastic cells have rounding alone.
        if sum * part < 0.0 {
            break;
        }
        sum += part;
    }
    Ok(sum.abs())
}

fn rows() -> Answer {
    let tank = &TANKS[2];
    let steel = |t: f64| -> Result<Arc<dyn Section>, Failure> {
        Ok(Arc::new(ElasticSection::new(tank.young_modulus, 0.3, t, 0.0)?))
    };
    let length = (tank.radius * tank.wall).sqrt();
    let sector = Sector {
        tank,
        wall: steel(tank.wall)?,
        plate: steel(tank.plate)?,
        heights: (0..=80).map(|k| 0.1 * length * f64::from(k)).collect(),
        first: 1.5 * tank.plate,
    };
    let expected = [
        (1e-3, 38.26),
        (5e-3, 46.27),
        (10e-3, 52.50),
        (20e-3, 61.07),
        (50e-3, 77.60),
        (100e-3, 97.99),
        (200e-3, 138.38),
    ];
    let found = sector.lift(&expected.map(|(w, _)| w))?;
    let row = |((uplift, force), lift): ((f64, f64), Lift)| {
        Row::new(
            "U8",
            format!("tank C: hold-down force at {} mm", 1e3 * uplift),
            (force, "independent axisymmetric program", Reference::SecondFormulation),
            lift.force / 1e3,
            (0.02, "kN/m"),
        )
    };
    Ok(expected.into_iter().zip(found).map(row).collect())
}
