//! One step of direct integration (trapezoidal rule, Rayleigh damping), with 1 and 8 right-hand sides, on a cylinder of
//! 12 × 16 × 20 bricks: 11 580 unknowns. Timed is the difference of two runs of different length, so that assembly and
//! factorisation drop out; the energy balance is checked.

use std::sync::Arc;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use fem::analysis::damping::{Damping, Rayleigh};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::system::System;
use fem::analysis::transient::{Load, Settings, integrate};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::linalg::{Ordering, Symbolic};
use fem::mesh::Cylinder;
use fem::model::Builder;
use fem::progress::Silent;

const DT: f64 = 0.005;

struct Cantilever {
    system: System,
    symbolic: Arc<Symbolic>,
    top: Observable,
}

impl Cantilever {
    /// Concrete column, 12 m high and 3 m in radius, clamped.
    fn new(rings: usize, sectors: usize, levels: usize) -> Cantilever {
        let mesh = Cylinder {
            radii: (0..=rings).map(|i| 3.0 * i as f64 / rings as f64).collect(),
            sectors,
            heights: (0..=levels).map(|i| 12.0 * i as f64 / levels as f64).collect(),
        };
        let volume = mesh.volume().expect("ascending radii and heights");
        let mut builder = Builder::new();
        builder.nodes(&volume.nodes);
        let concrete = Elastic::isotropic(30e9, 0.2, 2400.0);
        for cell in &volume.cells {
            let corners = cell.nodes.map(|n| volume.nodes[n]);
            let brick = Solid8::new(cell.nodes, corners, concrete, Kinematics::Linear).expect("a regular brick");
            builder.element("column", brick);
        }
        for &node in &volume.bottom_nodes {
            Dof::TRANSLATIONS.iter().for_each(|&dof| builder.hold(node, dof));
        }
        let model = builder.build().expect("a sound model");
        let assembler = Assembler::new(&model);
        let dofs = model.dofs();
        let node_of: Vec<usize> = (0..dofs.len()).map(|e| dofs.unknown(e).0).collect();
        let ordering = Ordering::best(assembler.pattern(), &node_of, model.nodes());
        let symbolic = Symbolic::new(assembler.pattern().clone(), &ordering).expect("enough memory");
        let damping = Damping::rayleigh(Rayleigh::fit((40.0, 0.02), (400.0, 0.05), false).expect("admissible"));
        let top = volume.surface_nodes[0];
        Cantilever {
            system: System::new(&model, &assembler).expect("regular elements").with_damping(damping),
            symbolic: Arc::new(symbolic),
            top: Observable::displacement(&model, top, Dof::Ux),
        }
    }

    /// Time of `steps` steps under `records` records.
    fn run(&self, steps: usize, records: usize) -> Duration {
        let grid = Grid::new(DT, DT * steps as f64, 0.0, DT);
        let loads: Vec<Load> = (0..records)
            .map(|r| {
                let a: Vec<f64> = (0..=steps).map(|k| (0.3 * k as f64 + r as f64).sin()).collect();
                Load::ground(0, Motion::sampled(DT, &a, &grid))
            })
            .collect();
        let start = Instant::now();
        let top = std::slice::from_ref(&self.top);
        let found = integrate(&self.system, &self.symbolic, &loads, &Settings::new(grid), top, &[], &Silent);
        let elapsed = start.elapsed();
        for transient in found.expect("a stable system") {
            assert!(transient.energy.error() < 1e-9 && transient.residual < 1e-9);
        }
        elapsed
    }
}

fn step(c: &mut Criterion) {
    let model = Cantilever::new(12, 16, 20);
    let mut group = c.benchmark_group("transient, 11 580 unknowns");
    group.sample_size(10);
    for records in [1, 8] {
        group.bench_function(format!("step, {records} right-hand sides"), |bencher| {
            bencher.iter_custom(|iterations| {
                let n = (iterations as usize).max(32);
                let long = model.run(32 + n, records);
                let short = model.run(32, records);
                long.saturating_sub(short).mul_f64(iterations as f64 / n as f64)
            });
        });
    }
    group.finish();
    if std::env::var_os("FEM_BENCH_LONG").is_some() {
        println!("2 600 steps with factorisation: {:.1} s", model.run(2600, 1).as_secs_f64());
    }
}

criterion_group!(benches, step);
criterion_main!(benches);
