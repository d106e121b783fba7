//! A cylinder of bricks, clamped below, under a harmonic force on its top: direct integration, for comparison with other
//! programs ([`benches/peers/brick_transient.py`]).
//!
//! ```text
//! brick_transient [--mesh R,C,Z] [--steps N] [--records N] [--model FILE] [--assembly]
//! ```
//!
//! 12 × 16 × 20 bricks (radius, circumference, height; those at the axis are wedges), R 5 m, H 10 m, E 30 GPa, ν 0.2,
//! ρ 2500 kg/m³, 1 MN sin(2π·10 Hz t) along x over the top nodes, trapezoidal rule with 1 ms. Prints unknowns, times and
//! the displacement of a node at the edge of the top after 10, 20, … steps. `--model` writes nodes, bricks and loads for
//! the peer; `--assembly` times assembly alone.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Instant;

use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::system::System;
use fem::analysis::transient::{Load, Settings, integrate};
use fem::assembly::{Assembler, order};
use fem::dofs::{Dof, KINDS};
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::element::{Element, LocalMatrix, Motion as Movement, Response, Trial, Want};
use fem::linalg::{Kind, Symbolic};
use fem::mesh::{Cylinder, Volume};
use fem::model::{Builder, Model};
use fem::progress::Silent;
use nalgebra::UnitQuaternion;

const RADIUS: f64 = 5.0;
const HEIGHT: f64 = 10.0;
const FORCE: f64 = 1e6;
const FREQUENCY: f64 = 10.0;
const STEP: f64 = 1e-3;

struct Options {
    mesh: [usize; 3],
    steps: usize,
    records: usize,
    model: Option<String>,
    assembly: bool,
}

fn options() -> Result<Options, Box<dyn Error>> {
    let mut found = Options { mesh: [12, 16, 20], steps: 200, records: 1, model: None, assembly: false };
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{name} wants a value"));
        match name.as_str() {
            "--mesh" => {
                let counts: Vec<usize> = value()?.split(',').map(str::parse).collect::<Result<_, _>>()?;
                found.mesh = counts.try_into().map_err(|_| "three counts")?;
            }
            "--steps" => found.steps = value()?.parse()?,
            "--records" => found.records = value()?.parse()?,
            "--model" => found.model = Some(value()?),
            "--assembly" => found.assembly = true,
            _ => return Err(format!("unknown argument {name}").into()),
        }
    }
    Ok(found)
}

fn volume([radial, sectors, vertical]: [usize; 3]) -> Result<Volume, Box<dyn Error>> {
    let even = |length: f64, n: usize| (0..=n).map(|i| length * i as f64 / n as f64).collect();
    let cylinder = Cylinder { radii: even(RADIUS, radial), sectors, heights: even(HEIGHT, vertical) };
    Ok(cylinder.volume()?)
}

fn bricks(volume: &Volume) -> Result<Vec<Solid8>, Box<dyn Error>> {
    let material = Elastic::isotropic(30e9, 0.2, 2500.0);
    let brick = |nodes: [usize; 8]| {
        let corners = nodes.map(|n| volume.nodes[n]);
        Solid8::new(nodes, corners, material, Kinematics::Linear)
    };
    Ok(volume.cells.iter().map(|c| brick(c.nodes)).collect::<Result<_, _>>()?)
}

fn model(volume: &Volume) -> Result<Model, Box<dyn Error>> {
    let mut builder = Builder::new();
    builder.nodes(&volume.nodes);
    for &node in &volume.bottom_nodes {
        for dof in [Dof::Ux, Dof::Uy, Dof::Uz] {
            builder.hold(node, dof);
        }
    }
    for brick in bricks(volume)? {
        builder.element("cylinder", brick);
    }
    Ok(builder.build()?)
}

/// Nodes (number, place, fixed), bricks (nodes) and loads (node, force), one a line.
fn write_model(volume: &Volume, share: f64, path: &str) -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    for (n, [x, y, z]) in volume.nodes.iter().enumerate() {
        let fixed = u8::from(volume.bottom_nodes.contains(&n));
        writeln!(text, "node {} {x:.17e} {y:.17e} {z:.17e} {fixed}", n + 1)?;
    }
    for cell in &volume.cells {
        let nodes: Vec<String> = cell.nodes.iter().map(|n| (n + 1).to_string()).collect();
        writeln!(text, "brick {}", nodes.join(" "))?;
    }
    for n in &volume.surface_nodes {
        writeln!(text, "load {} {share:.17e}", n + 1)?;
    }
    writeln!(text, "observe {}", observed(volume) + 1)?;
    Ok(std::fs::write(path, text)?)
}

/// The node at r = R, θ = 0 on top.
fn observed(volume: &Volume) -> usize {
    volume.wall_nodes[volume.wall_nodes.len() - 1][0]
}

/// Time this process has had on the CPU [s], where the system provides it; a shared machine spoils the wall clock.
fn cpu_seconds(start: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/self/schedstat");
    let nanoseconds = told.ok().and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |n| 1e-9 * n)
}

/// Seconds a brick for K and M of the elements alone, and with the sparse matrices.
fn time_assembly(volume: &Volume) -> Result<(), Box<dyn Error>> {
    let elements = bricks(volume)?;
    let rounds = 20;
    let (mut mass, mut response) = (LocalMatrix::zeros(24), Response::sized(24));
    let rest = Movement { values: &[0.0; 24], rotations: &[UnitQuaternion::identity(); 8] };
    let clock = Instant::now();
    let start = cpu_seconds(clock);
    let mut sum = 0.0;
    for _ in 0..rounds {
        for element in &elements {
            response.tangent.reset(24);
            mass.reset(24);
            element.respond(Trial { motion: rest, old: &[], new: &mut [], want: Want::TANGENT }, &mut response)?;
            element.mass(&mut mass);
            sum += response.tangent.get(0, 0) + mass.get(0, 0);
        }
    }
    let local = (cpu_seconds(clock) - start) / (rounds * elements.len()) as f64;
    let model = model(volume)?;
    let assembler = Assembler::new(&model);
    let start = cpu_seconds(clock);
    for _ in 0..rounds {
        let (k, m) = (assembler.stiffness(&model)?, assembler.mass(&model));
        sum += k.values[0] + m.values[0];
    }
    let global = (cpu_seconds(clock) - start) / (rounds * elements.len()) as f64;
    println!(
        "{{\"bricks\":{},\"element_us\":{:.3},\"assembled_us\":{:.3},\"elements_per_s\":{:.0},\"assembled_per_s\":{:.0},\"check\":{sum:.6e}}}",
        elements.len(),
        1e6 * local,
        1e6 * global,
        1.0 / local,
        1.0 / global
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = options()?;
    let start = Instant::now();
    let volume = volume(options.mesh)?;
    let share = FORCE / volume.surface_nodes.len() as f64;
    if let Some(path) = &options.model {
        return write_model(&volume, share, path);
    }
    if options.assembly {
        return time_assembly(&volume);
    }
    let model = model(&volume)?;
    let assembler = Assembler::new(&model);
    let system = System::new(&model, &assembler)?;
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &order(&model, assembler.pattern()))?);
    let grid = Grid { dt: STEP, sub_steps: 1, samples: options.steps + 1 };
    let shape = model.vector(|node| {
        let mut force = [0.0; KINDS];
        if volume.surface_nodes.binary_search(&node).is_ok() {
            force[0] = share;
        }
        force
    });
    // Records differ in phase, so that no two columns are alike; the first is the peer's.
    let loads: Vec<Load> = (0..options.records)
        .map(|record| {
            let phase = PI * record as f64 / options.records as f64;
            let sine = |i: usize| (TAU * FREQUENCY * STEP * i as f64 + phase).sin() - phase.sin();
            let history: Vec<f64> = (0..grid.samples).map(sine).collect();
            Load { forces: vec![(shape.clone(), Motion::sampled(STEP, &history, &grid))], ..Load::default() }
        })
        .collect();
    let tip = Observable::displacement(&model, observed(&volume), Dof::Ux);
    let settings = Settings { kind: Kind::Definite, ..Settings::new(grid) };
    let set_up = start.elapsed().as_secs_f64();
    let found = integrate(&system, &symbolic, &loads, &settings, &[tip], &[], &Silent)?;
    let total = start.elapsed().as_secs_f64();
    let history = &found[0].observed.scalars[0].values;
    let every: Vec<String> = history.iter().step_by(5).skip(1).map(|u| format!("{u:.9e}")).collect();
    println!(
        "{{\"unknowns\":{},\"records\":{},\"steps\":{},\"set_up_s\":{set_up:.4},\"total_s\":{total:.4},\"energy_error\":{:.1e},\"residual\":{:.1e},\"tip\":[{}]}}",
        model.dofs().len(),
        options.records,
        options.steps,
        found[0].energy.error(),
        found[0].residual,
        every.join(",")
    );
    Ok(())
}
