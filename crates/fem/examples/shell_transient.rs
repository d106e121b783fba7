//! A steel cylinder of layered shells, clamped below, that yields under a harmonic force on its top: nonlinear time steps, for
//! comparison with other programs ([`benches/peers/shell_transient.py`]).
//!
//! ```text
//! shell_transient [--mesh C,Z] [--layers N] [--steps N] [--threads N] [--model FILE]
//! ```
//!
//! 48 × 8 shells (circumference, height), R 6 m, H 6 m, t 60 mm, von Mises steel without hardening (E 210 GPa, ν 0.3, f_y 240 MPa, ρ
//! 7850 kg/m³) in 3 layers, 60 MN sin(2π·10 Hz t) along x over the top nodes, trapezoidal rule with 1 ms. The membrane shear is that
//! of plain MITC4, the mass lumped, as in the peer. Prints shells, iterations, times, dissipation and the displacement of a node
//! at the edge of the top after every step. `--model` writes nodes, shells, masses and loads for the peer.

use std::error::Error;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Instant as Clock;

use fem::analysis::march::{Instant, Observe, Problem, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::system::System;
use fem::analysis::transient::Load;
use fem::assembly::{Assembler, order};
use fem::dofs::{Dof, KINDS};
use fem::element::shell::layered::{LayeredSection, Ply};
use fem::element::shell::rule::Rule;
use fem::element::shell4::{Axes, MassKind, MembraneShear, Shell4};
use fem::linalg::Symbolic;
use fem::model::{Builder, Model};
use fem::progress::Silent;
use materials::von_mises::VonMises;
use nalgebra::{Matrix3, Vector3};

const RADIUS: f64 = 6.0;
const HEIGHT: f64 = 6.0;
const THICKNESS: f64 = 0.06;
const DENSITY: f64 = 7850.0;
const FORCE: f64 = 60e6;
const FREQUENCY: f64 = 10.0;
const STEP: f64 = 1e-3;

struct Options {
    mesh: [usize; 2],
    layers: usize,
    steps: usize,
    threads: usize,
    model: Option<String>,
}

fn options() -> Result<Options, Box<dyn Error>> {
    let mut found = Options { mesh: [48, 8], layers: 3, steps: 12, threads: 1, model: None };
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{name} wants a value"));
        match name.as_str() {
            "--mesh" => {
                let counts: Vec<usize> = value()?.split(',').map(str::parse).collect::<Result<_, _>>()?;
                found.mesh = counts.try_into().map_err(|_| "two counts")?;
            }
            "--layers" => found.layers = value()?.parse()?,
            "--steps" => found.steps = value()?.parse()?,
            "--threads" => found.threads = value()?.parse()?,
            "--model" => found.model = Some(value()?),
            _ => return Err(format!("unknown argument {name}").into()),
        }
    }
    Ok(found)
}

/// Positions, and corners of the shells, level by level.
fn mesh([sectors, rows]: [usize; 2]) -> (Vec<[f64; 3]>, Vec<[usize; 4]>) {
    let mut nodes = Vec::new();
    for level in 0..=rows {
        for sector in 0..sectors {
            let angle = TAU * sector as f64 / sectors as f64;
            let z = HEIGHT * level as f64 / rows as f64;
            nodes.push([RADIUS * angle.cos(), RADIUS * angle.sin(), z]);
        }
    }
    let at = |level: usize, sector: usize| level * sectors + sector % sectors;
    let cells = (0..rows * sectors)
        .map(|k| (k / sectors, k % sectors))
        .map(|(l, s)| [at(l, s), at(l, s + 1), at(l + 1, s + 1), at(l + 1, s)]);
    (nodes, cells.collect())
}

fn model(options: &Options) -> Result<Model, Box<dyn Error>> {
    let (nodes, cells) = mesh(options.mesh);
    let mut builder = Builder::new();
    builder.nodes(&nodes);
    let outward = |[x, y, _]: [f64; 3]| Vector3::new(x, y, 0.0) / RADIUS;
    for (node, &position) in nodes.iter().enumerate() {
        let director = outward(position);
        let around = Vector3::z().cross(&director);
        let rows = [around, Vector3::z(), director].map(|v| v.transpose());
        builder.rotation_frame(node, Matrix3::from_rows(&rows));
        builder.hold(node, Dof::Rz);
        if node < options.mesh[0] {
            Dof::SHELL.iter().for_each(|&dof| builder.hold(node, dof));
        }
    }
    let ply = Ply {
        law: Arc::new(VonMises::new(210e9, 0.3, 240e6, 0.0, 0.0)?),
        thickness: THICKNESS,
        density: DENSITY,
        rule: Rule::MidPoint(options.layers),
    };
    let section = Arc::new(LayeredSection::new(&[ply], &[])?);
    for nodes_of in cells {
        let positions = nodes_of.map(|n| nodes[n]);
        let shell = Shell4::new(nodes_of, positions, positions.map(outward), section.clone())?;
        let shell = shell.with_membrane_shear(MembraneShear::Full).with_mass(MassKind::Lumped).with_axes(Axes::HOOP_Z);
        builder.element("wall", shell);
    }
    Ok(builder.build()?)
}

/// Nodes (number, place, fixed, mass), shells (nodes) and loads (node, force), one a line.
fn write_model(options: &Options, path: &str) -> Result<(), Box<dyn Error>> {
    let (nodes, cells) = mesh(options.mesh);
    let ([sectors, rows], count) = (options.mesh, nodes.len());
    // Facets, as the shells have them.
    let facet = 2.0 * RADIUS * (0.5 * TAU / sectors as f64).sin() * HEIGHT / rows as f64;
    let mut masses = vec![0.0; count];
    for &node in cells.iter().flatten() {
        masses[node] += 0.25 * facet * THICKNESS * DENSITY;
    }
    let mut text = String::new();
    for (n, ([x, y, z], mass)) in nodes.iter().zip(masses).enumerate() {
        let fixed = u8::from(n < sectors);
        writeln!(text, "node {} {x:.17e} {y:.17e} {z:.17e} {fixed} {mass:.17e}", n + 1)?;
    }
    for cell in &cells {
        let corners = cell.map(|n| (n + 1).to_string());
        writeln!(text, "shell {}", corners.join(" "))?;
    }
    for n in count - sectors..count {
        writeln!(text, "load {} {:.17e}", n + 1, FORCE / sectors as f64)?;
    }
    writeln!(text, "layers {} {}", options.layers, THICKNESS / options.layers as f64)?;
    writeln!(text, "observe {}", count - sectors + 1)?;
    Ok(std::fs::write(path, text)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = options()?;
    if let Some(path) = &options.model {
        return write_model(&options, path);
    }
    let start = Clock::now();
    let model = model(&options)?;
    let assembler = Assembler::new(&model);
    let system = System::new(&model, &assembler)?;
    let ordering = order(&model, assembler.pattern());
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &ordering)?);
    let grid = Grid { dt: STEP, sub_steps: 1, samples: options.steps + 1 };
    let sectors = options.mesh[0];
    let top = model.nodes().len() - sectors;
    let shape = model.vector(|node| {
        let mut force = [0.0; KINDS];
        force[0] = if node >= top { FORCE / sectors as f64 } else { 0.0 };
        force
    });
    let sine: Vec<f64> = (0..grid.samples).map(|i| (TAU * FREQUENCY * STEP * i as f64).sin()).collect();
    let load = Load { forces: vec![(shape, Motion::sampled(STEP, &sine, &grid))], ..Load::default() };
    let mut settings = Settings::new(grid);
    settings.scheme = TimeScheme::GeneralizedAlpha { radius: 1.0 };
    settings.threads = options.threads;
    let set_up = start.elapsed().as_secs_f64();
    let mut tip = Vec::new();
    let mut watch = |now: &Instant<'_>| {
        if now.step > 0.0 {
            tip.push(format!("{:.9e}", model.at_node(&now.state.committed.u, top)[0]));
        }
    };
    let problem = Problem { model: &model, assembler: &assembler, symbolic: &symbolic, system: &system };
    let observers: &mut [&mut dyn Observe] = &mut [&mut watch];
    let run = march(problem, &load, &settings, observers, &Silent)?;
    let total = start.elapsed().as_secs_f64();
    let hysteretic = run.balance.samples.last().map_or(0.0, |e| e.hysteretic);
    println!(
        "{{\"unknowns\":{},\"shells\":{},\"steps\":{},\"iterations\":{},\"factors\":{},\"set_up_s\":{set_up:.4},\"total_s\":{total:.4},\"energy_error\":{:.1e},\"hysteretic\":{hysteretic:.6e},\"tip\":[{}]}}",
        model.dofs().len(),
        model.elements().len(),
        run.cost.steps,
        run.cost.iterations,
        run.cost.factors,
        run.balance.error(),
        tip.join(",")
    );
    Ok(())
}
