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
use fem::element::ground::Ground;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{Normals, ShellCell, ShellSurface};
use fem::element::shell4::Axes;
use fem::linalg::Symbolic;
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;
use nalgebra::{Matrix3, Vector3};

use super::shells::{CRITERIA, stations};
use super::{GRAVITY, TANKS};
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

fn rows() -> Answer {
    let tank = &TANKS[2];
    let (radius, half) = (tank.radius, PI / SECTORS);
    let steel = |t: f64| -> Result<Arc<dyn Section>, Failure> {
        Ok(Arc::new(ElasticSection::new(tank.young_modulus, 0.3, t, 0.0)?))
    };
    let (wall, plate) = (steel(tank.wall)?, steel(tank.plate)?);
    let mut builder = Builder::new();
    let mut pair = |r: f64, z: f64| {
        [-half, half].map(|angle: f64| {
            let (s, c) = angle.sin_cos();
            let node = builder.node([r * c, r * s, z]);
            builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
            node
        })
    };
    let length = (radius * tank.wall).sqrt();
    let heights: Vec<f64> = (0..=80).map(|k| 0.1 * length * f64::from(k)).collect();
    let levels: Vec<[usize; 2]> = heights.iter().map(|&z| pair(radius, z)).collect();
    let foot = levels[0];
    let inner = CORE * radius;
    let mut radii: Vec<f64> = stations(radius - inner, 1.5 * tank.plate, 80.0 * tank.plate, 1.15)
        .iter()
        .map(|x| inner + x)
        .collect();
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
        cells.push((nodes, wall.clone()));
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
                builder.element("ground", Ground::new(node, 1e8, area)?);
            }
        }
        cells.push((nodes, plate.clone()));
    }
    let count = 2 * (levels.len() + rings.len() - 1);
    let places: Vec<[f64; 3]> = (0..count).map(|n| builder.position(n)).collect();
    let normal = |cell: usize, node: usize| match cell < of_wall {
        true => Vector3::new(places[node][0], places[node][1], 0.0),
        false => Vector3::z(),
    };
    let cell = |(nodes, section)| ShellCell {
        nodes,
        section,
        group: "shell".to_owned(),
    };
    let surface = ShellSurface {
        normals: Normals::Exact(&normal),
        axes: Axes::HOOP_Z,
        ..ShellSurface::new(cells.into_iter().map(cell).collect())
    };
    surface.place(&mut builder)?;
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
    let symbolic = Arc::new(Symbolic::new(
        assembler.pattern().clone(),
        &order(&model, assembler.pattern()),
    )?);
    let (dead, pull) = (dead.vector(&model), pull.vector(&model));
    let none = vec![0.0; dead.len()];
    let mut state = State::new(&model);
    let mut rest = Continuation::new(&model, &assembler, &symbolic, &none, &dead, CRITERIA)?;
    for step in 1..=8 {
        rest.step(&mut state, &Constraint::Load(f64::from(step) / 8.0))
            .map_err(|e| Failure::from(format!("at rest, step {step}: {e}")))?;
    }
    let mut path = Continuation::new(&model, &assembler, &symbolic, &dead, &pull, CRITERIA)?;
    let expected = [
        (1e-3, 38.26),
        (5e-3, 46.27),
        (10e-3, 52.50),
        (20e-3, 61.07),
        (50e-3, 77.60),
        (100e-3, 97.99),
        (200e-3, 138.38),
    ];
    let lengths = StepLength {
        first: 1e-4,
        shortest: 1e-7,
        longest: 5e-3,
    };
    let row = model.row(foot[0], Dof::Uz);
    let mut rows = Vec::new();
    let uplifts = expected.map(|(w, _)| w);
    let followed = path.to_displacements(&mut state, &row, &uplifts, lengths, &Silent, |uplift, point, _| {
        let force = expected
            .iter()
            .find(|(w, _)| *w == uplift)
            .map_or(f64::NAN, |(_, f)| *f);
        rows.push(Row::new(
            "U8",
            format!("tank C: hold-down force at {} mm", 1e3 * uplift),
            (force, "independent axisymmetric program", Reference::SecondFormulation),
            (point.factor - tank.weight) / 1e3,
            (0.02, "kN/m"),
        ));
    })?;
    match followed.failure {
        Some(error) => Err(Failure::from(format!("after {} uplifts: {error}", rows.len()))),
        None => Ok(rows),
    }
}
