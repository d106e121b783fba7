//! Cost of a step of a nonlinear wall with a linear liquid: liquid with all its unknowns, condensed onto the wetted wall and
//! the surface, and with sloshing modes.
//!
//! ```text
//! condensation [--mesh K] [--modes N] [--steps N]
//! ```
//!
//! Tank 8.1 with 8 K sectors and 4 K × 5 K elements of liquid (default K = 2), as a geometrically nonlinear shell under 20 steps
//! of shaking. Prints unknowns, entries of the factor, milliseconds of a refactorisation, a solve and an evaluation of all elements,
//! and the march.

use std::error::Error;
use std::time::Instant;

use fem::analysis::march::{Problem, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::system::System;
use fem::analysis::transient::Load;
use fem::element::Want;
use fem::linalg::{Kind, Symmetric};
use fem::progress::Silent;
use fem::state::State;
use verification::potential::coupled::{Assembled, Division, Tank, with_condensed, with_hexahedra};

type Answer<T> = Result<T, Box<dyn Error + Send + Sync>>;

fn milliseconds<T>(repeat: usize, mut work: impl FnMut() -> Answer<T>) -> Answer<f64> {
    let mut best = f64::INFINITY;
    for _ in 0..repeat {
        let start = Instant::now();
        work()?;
        best = best.min(1e3 * start.elapsed().as_secs_f64());
    }
    Ok(best)
}

fn measure(name: &str, tank: &Assembled, setup: f64, steps: usize) -> Answer<()> {
    let system = System::new(&tank.model, &tank.assembler)?;
    let h = 2e-3;
    let mut effective = tank.stiffness.clone();
    effective.add(4.0 / (h * h), &tank.mass);
    let mut factor = tank.symbolic.factor(&effective, Kind::QuasiDefinite)?;
    let refactor = milliseconds(5, || Ok(factor.refactor(&effective)?))?;
    let right = system.inertia[0].clone();
    let solve = milliseconds(9, || Ok(factor.solve_vector(&right)?))?;
    let linear = tank.assembler.linear_part(&tank.model).map_err(|(_, e)| e)?;
    let mut state = State::new(&tank.model);
    let mut tangent = Symmetric::zeros(tank.assembler.pattern().clone());
    let mut forces = Default::default();
    let mut evaluate = |want| {
        milliseconds(5, || {
            let found =
                tank.assembler.respond_into(&tank.model, &mut state, want, Some(&linear), &mut tangent, &mut forces);
            Ok(found.map_err(|(_, e)| e)?)
        })
    };
    let (force, all) = (evaluate(Want::FORCE)?, evaluate(Want::ALL)?);
    let grid = Grid::new(h, steps as f64 * h, 0.0, h);
    let a: Vec<f64> = (0..=steps).map(|i| 3.0 * (0.3 * i as f64).sin()).collect();
    let load = Load::ground(0, Motion::sampled(h, &a, &grid));
    let problem = Problem { model: &tank.model, assembler: &tank.assembler, symbolic: &tank.symbolic, system: &system };
    for modified in [true, false] {
        let mut settings = Settings::new(grid);
        settings.newton.modified = modified;
        let start = Instant::now();
        let run = march(problem, &load, &settings, &mut [], &Silent)?;
        let each = 1e3 * start.elapsed().as_secs_f64() / steps as f64;
        println!(
            "{name:<24} unknowns {:>6}  L {:>6.1} MB  set-up {setup:>6.1} s  refactor {refactor:>8.2} ms  solve {solve:>7.3} ms  \
             forces {force:>6.2} ms  with tangent {all:>6.2} ms  {} {each:>8.2} ms a step ({:.1} iterations, {:.2} factors)",
            tank.model.dofs().len(),
            8e-6 * tank.symbolic.entries() as f64,
            if modified { "modified" } else { "full    " },
            run.cost.iterations as f64 / steps as f64,
            run.cost.factors as f64 / steps as f64,
        );
    }
    Ok(())
}

fn main() -> Answer<()> {
    let (mut k, mut modes, mut steps) = (2, 20, 20);
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        let value = arguments.next().ok_or(format!("{name} wants a value"))?.parse()?;
        match name.as_str() {
            "--mesh" => k = value,
            "--modes" => modes = value,
            "--steps" => steps = value,
            _ => return Err(format!("unknown argument {name}").into()),
        }
    }
    let data = Tank::broad();
    let division = Division::refined(&data, k);
    let start = Instant::now();
    let tank = with_hexahedra(&data, &division)?;
    measure("all unknowns", &tank, start.elapsed().as_secs_f64(), steps)?;
    for (name, count) in [("wall and surface", None), ("wall and sloshing modes", Some(modes))] {
        let start = Instant::now();
        let tank = with_condensed(&data, &division, count)?;
        measure(name, &tank, start.elapsed().as_secs_f64(), steps)?;
    }
    Ok(())
}
