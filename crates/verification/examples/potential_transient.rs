//! Cost of a time step of a potential liquid in a shell wall: the model of `benches/peers/acoustic_vs_opensees.py`.
//!
//! ```text
//! cargo run --release -p verification --example potential_transient -- RINGS SECTORS LEVELS STEPS
//! ```
//!
//! Steel cylinder R = 10 m, H = 10 m, t = 20 mm, clamped, full of water; radial forces cos θ kN at all nodes above the base grow
//! with t/0.1 s. Prints JSON: unknowns, seconds for set-up and for a step, the radial displacement of the top at θ = 0 after
//! each of the first twenty steps (with and without liquid, and without by plain MITC4), and the residual of the solutions.

use std::sync::Arc;
use std::time::Instant;

use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::system::System;
use fem::analysis::transient::{Load, Settings, Transient, integrate};
use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::element::shell4::MembraneShear;
use fem::linalg::Symbolic;
use fem::progress::Silent;
use verification::Failure;
use verification::potential::coupled::{Division, Tank, with_hexahedra};
use verification::potential::rigid::uniform;

const STEP: f64 = 2e-3;
const FORCE: f64 = 1e3;
const RAMP: f64 = 0.1;
const SHOWN: usize = 20;

fn run(tank: &Tank, division: &Division, steps: usize, wet: bool) -> Result<(Transient, f64, f64, usize), Failure> {
    let start = Instant::now();
    let mut model = with_hexahedra(tank, division)?;
    let dofs = model.model.dofs();
    if !wet {
        // Without the blocks that join wall and liquid.
        model.mass = model.assembler.mass_of(&model.model, |e| model.model.elements()[e].kind() != "wet_face");
    }
    let node = model.rows[model.rows.len() - 1][0];
    let mut force = vec![0.0; dofs.len()];
    for (level, row) in model.rows.iter().enumerate().skip(1) {
        for &node in row {
            let [x, y, _] = model.model.nodes()[node];
            let size = FORCE * x / (tank.radius * tank.radius);
            for (dof, component) in [(Dof::Ux, size * x), (Dof::Uy, size * y)] {
                let unknown = dofs.equation(node, dof);
                force[unknown.ok_or_else(|| format!("a wall node of level {level} is held"))?] = component;
            }
        }
    }
    let system = {
        let mut system = System::new(&model.model, &model.assembler)?;
        system.mass = model.mass.clone();
        system
    };
    let assembler = Assembler::new(&model.model);
    let pattern = assembler.pattern().clone();
    let symbolic = Arc::new(Symbolic::new(pattern.clone(), &order(&model.model, &pattern))?);
    let scalars = [Observable::displacement(&model.model, node, Dof::Ux)];
    let response = |steps: usize| {
        let grid = Grid { dt: STEP, sub_steps: 1, samples: steps + 1 };
        let ramp: Vec<f64> = (0..=steps).map(|i| i as f64 * STEP / RAMP).collect();
        let ramp = Motion::sampled(STEP, &ramp, &grid);
        let load = Load { forces: vec![(force.clone(), ramp)], ..Load::default() };
        integrate(&system, &symbolic, &[load], &Settings::new(grid), &scalars, &[], &Silent)
    };
    // Assembly, ordering, symbolic phase, factor and twenty steps; then the steps alone, as a difference.
    let first = response(SHOWN)?.remove(0);
    let set_up = start.elapsed().as_secs_f64();
    let clock = Instant::now();
    response(SHOWN)?;
    let short = clock.elapsed().as_secs_f64();
    let clock = Instant::now();
    let long = response(SHOWN + steps)?.remove(0);
    let step = (clock.elapsed().as_secs_f64() - short) / steps as f64;
    drop(first);
    Ok((long, set_up, step, dofs.len()))
}

fn main() -> Result<(), Failure> {
    let mut counts = [12, 16, 20, 400];
    for (count, argument) in counts.iter_mut().zip(std::env::args().skip(1)) {
        *count = argument.parse()?;
    }
    let [rings, sectors, levels, steps] = counts;
    let tank = Tank {
        radius: 10.0,
        depth: 10.0,
        liquid_density: 1000.0,
        material: [210e9, 0.3, 7850.0],
        courses: vec![(10.0, 0.02)],
        yields: None,
    };
    let division = Division {
        sectors,
        wall: uniform(tank.depth, levels),
        radii: uniform(tank.radius, rings),
        liquid: uniform(tank.depth, levels),
        membrane_shear: MembraneShear::default(),
    };
    let (wet, set_up, step, unknowns) = run(&tank, &division, steps, true)?;
    let (dry, ..) = run(&tank, &division, 1, false)?;
    let locked = Division { membrane_shear: MembraneShear::Full, ..division };
    let (plain, ..) = run(&tank, &locked, 1, false)?;
    let first = |t: &Transient| {
        let values: Vec<String> = t.observed.scalars[0].values[1..=SHOWN].iter().map(|v| format!("{v:.8e}")).collect();
        values.join(", ")
    };
    println!("{{");
    println!("  \"unknowns\": {unknowns}, \"steps\": {steps}, \"set_up_s\": {set_up:.4}, \"step_s\": {step:.6},");
    println!("  \"wet\": [{}],", first(&wet));
    println!("  \"dry\": [{}],", first(&dry));
    println!("  \"dry_plain_mitc4\": [{}],", first(&plain));
    println!("  \"residual\": {:.1e}", wet.residual);
    println!("}}");
    Ok(())
}
