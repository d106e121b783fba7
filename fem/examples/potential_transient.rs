//! Cost of a time step of a potential liquid in a shell wall: the model of `benches/peers/acoustic_vs_opensees.py`.
//!
//! ```text
//! cargo run --release -p fem --example potential_transient -- RINGS SECTORS LEVELS STEPS
//! ```
//!
//! Steel cylinder R = 10 m, H = 10 m, t = 20 mm, clamped, full of water; a force of 1 kN at the wall's top is switched on.
//! Prints JSON: unknowns, seconds for set-up and for a step, the radial displacement under the force after each of the first
//! ten steps (with and without liquid), and the residual of the solutions.

use std::sync::Arc;
use std::time::Instant;

use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::system::System;
use fem::analysis::transient::{Load, Settings, Transient, integrate};
use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::linalg::Symbolic;
use fem::progress::Silent;
use fem::verify::potential::Failure;
use fem::verify::potential::coupled::{Division, Tank, with_hexahedra};
use fem::verify::potential::rigid::uniform;

const STEP: f64 = 2e-3;
const FORCE: f64 = 1e3;

fn run(tank: &Tank, division: &Division, steps: usize, wet: bool) -> Result<(Transient, f64, f64, usize), Failure> {
    let start = Instant::now();
    let mut model = with_hexahedra(tank, division)?;
    let dofs = model.model.dofs();
    if !wet {
        // Without the blocks that join wall and liquid.
        model.mass = model
            .assembler
            .mass_of(&model.model, |e| model.model.elements()[e].kind() != "wet_face");
    }
    let node = model.rows[model.rows.len() - 1][0];
    let mut force = vec![0.0; dofs.len()];
    force[dofs.equation(node, Dof::Ux).ok_or("the top of the wall is free")?] = FORCE;
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
        let grid = Grid {
            dt: STEP,
            sub_steps: 1,
            samples: steps + 1,
        };
        let constant = Motion::sampled(STEP, &vec![1.0; steps + 1], &grid);
        let load = Load {
            forces: vec![(force.clone(), constant)],
            ..Load::default()
        };
        integrate(
            &system,
            &symbolic,
            &[load],
            &Settings::new(grid),
            &scalars,
            &[],
            &Silent,
        )
    };
    // Assembly, ordering, symbolic phase, factor and ten steps; then the steps alone, as a difference.
    let first = response(10)?.remove(0);
    let set_up = start.elapsed().as_secs_f64();
    let clock = Instant::now();
    response(10)?;
    let short = clock.elapsed().as_secs_f64();
    let clock = Instant::now();
    let long = response(10 + steps)?.remove(0);
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
    };
    let division = Division {
        sectors,
        wall: uniform(tank.depth, levels),
        radii: uniform(tank.radius, rings),
        liquid: uniform(tank.depth, levels),
    };
    let (wet, set_up, step, unknowns) = run(&tank, &division, steps, true)?;
    let (dry, ..) = run(&tank, &division, 10, false)?;
    let first = |t: &Transient| {
        let values: Vec<String> = t.observed.scalars[0].values[1..=10]
            .iter()
            .map(|v| format!("{v:.8e}"))
            .collect();
        values.join(", ")
    };
    println!("{{");
    println!("  \"unknowns\": {unknowns}, \"steps\": {steps}, \"set_up_s\": {set_up:.4}, \"step_s\": {step:.6},");
    println!("  \"wet\": [{}],", first(&wet));
    println!("  \"dry\": [{}],", first(&dry));
    println!("  \"residual\": {:.1e}", wet.residual);
    println!("}}");
    Ok(())
}
