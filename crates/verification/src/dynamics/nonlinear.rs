//! Nonlinear time histories: rows D2, D9 and D11.
//!
//! * A tower of masses on bars of von Mises steel, under a constant pull along its motion: rest, balance, dissipation.
//! * Strip 8.4 as one super-element: the march of a linear model against direct integration.
//! * Tank 8.1, coarse, as a geometrically nonlinear shell under strong shaking, elastic and yielding: the liquid with all its
//!   unknowns, condensed onto the wetted wall and the surface, and with sloshing modes.

use std::sync::Arc;

use materials::von_mises::VonMises;

use super::bar::Bar;
use super::strip::Strip;
use crate::potential::coupled::{Assembled, Division, Tank, with_condensed, with_hexahedra};
use crate::potential::rigid::uniform;
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};
use fem::analysis::AnalysisError;
use fem::analysis::damping::{Damping, Rayleigh};
use fem::analysis::march::{Instant, Outcome, Problem, Quantity, QuantityObserver, Run, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::system::System;
use fem::analysis::transient::{self, Load, integrate};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::spring::PointMass;
use fem::element::super_element::SuperElement;
use fem::linalg::{Ordering, Symbolic};
use fem::model::{Builder, Model};
use fem::progress::Silent;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "nonlinear-dynamics",
    title: "Nonlinear time histories",
    model: "Rest, energy balance, and condensed liquids against the full ones, with walls that yield.",
    ids: &[
        ("D2", "rest under a constant load"),
        ("D9", "energy balance of nonlinear runs"),
        ("D11", "condensed liquids against full ones"),
    ],
    parts: &[Part::Tested(nonlinear)],
};

/// A model with its assembler, factors and matrices.
struct Parts {
    model: Model,
    assembler: Assembler,
    symbolic: Arc<Symbolic>,
    system: System,
}

impl Parts {
    fn new(model: Model, damping: Damping) -> Result<Parts, Failure> {
        let assembler = Assembler::new(&model);
        let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?;
        Ok(Parts {
            symbolic: Arc::new(symbolic),
            system: System::new(&model, &assembler)?.with_damping(damping),
            assembler,
            model,
        })
    }

    fn problem(&self) -> Problem<'_> {
        Problem { model: &self.model, assembler: &self.assembler, symbolic: &self.symbolic, system: &self.system }
    }
}

const STOREYS: usize = 5;

const YOUNG: f64 = 200e9;

const TANGENT: f64 = 10e9;

fn bar(storey: usize) -> Result<Bar, Failure> {
    Ok(Bar {
        nodes: [storey - 1, storey],
        area: 1e-4,
        length: 3.0,
        law: VonMises::new(YOUNG, 0.3, 250e6, TANGENT, 0.0)?,
    })
}

/// Five masses of 3 t on bars of 1 cm² × 3 m: lowest period 0.75 s, strength at the base 25 kN.
fn tower() -> Result<Parts, Failure> {
    let mut builder = Builder::new();
    for storey in 0..=STOREYS {
        let node = builder.node([3.0 * storey as f64, 0.0, 0.0]);
        for dof in [Dof::Ux, Dof::Uy, Dof::Uz] {
            if storey == 0 || dof != Dof::Ux {
                builder.hold(node, dof);
            }
        }
        if storey > 0 {
            builder.element("masses", PointMass::new(node, 3000.0)?);
            builder.element("bars", bar(storey)?);
        }
    }
    let damping = Damping::rayleigh(Rayleigh::mass_proportional(8.4, 0.02));
    Parts::new(builder.build()?, damping)
}

/// 5 Hz down to 0.5 Hz under a hump of 8 s, `peak` [m/s²] at most.
fn shaking(grid: &Grid, peak: f64) -> Load {
    let duration = 8.0;
    let count = (duration / grid.dt).round() as usize + 1;
    let a: Vec<f64> = (0..count)
        .map(|i| {
            let t = i as f64 * grid.dt;
            let hump = (std::f64::consts::PI * t / duration).sin().powi(2);
            peak * hump * (std::f64::consts::TAU * t * (5.0 - 0.28 * t)).sin()
        })
        .collect();
    Load::ground(0, Motion::sampled(grid.dt, &a, grid))
}

fn completed(run: Run) -> Result<Run, Failure> {
    match run.outcome {
        Outcome::Completed => Ok(run),
        other => Err(format!("the march ended at {} s: {other:?}", run.time).into()),
    }
}

fn row(
    id: &str,
    what: String,
    source: &'static str,
    kind: Reference,
    computed: f64,
    tolerance: f64,
    unit: &'static str,
) -> Row {
    Row::new(id, what, (0.0, source, kind), computed, (tolerance, unit))
}

/// Rest, balance and dissipation of the tower.
fn steel(rows: &mut Vec<Row>) -> Result<(), Failure> {
    // More than 80 lines: a run after the other on one tower, each with its rows.
    let parts = tower()?;
    let problem = parts.problem();
    // 26 kN at the base: it yields before the shaking begins.
    let pull: Vec<f64> = problem.system.inertia[0].iter().map(|m| 26e3 / 15e3 * m).collect();
    let mut settings = Settings::new(Grid::new(5e-3, 5.0, 0.0, 5e-3));
    settings.constant = pull.clone();
    let mut start: Option<Vec<f64>> = None;
    let mut moved = 0.0_f64;
    let mut watch = |now: &Instant<'_>| {
        let u = &now.state.committed.u;
        let start = start.get_or_insert_with(|| u.clone());
        moved = u.iter().zip(start.iter()).fold(moved, |m, (a, b)| m.max((a - b).abs()));
    };
    completed(march(problem, &Load::default(), &settings, &mut [&mut watch], &Silent)?)?;
    rows.push(row(
        "D2",
        "tower of von Mises bars, yielded under a constant pull: largest displacement from it in 1000 steps without ground motion"
            .into(),
        "rest",
        Reference::ClosedForm,
        moved,
        1e-9,
        "m",
    ));
    let hardening = YOUNG * TANGENT / (YOUNG - TANGENT);
    for (name, scheme) in [
        ("trapezoidal rule", TimeScheme::Trapezoidal),
        ("generalised-α, ρ_∞ = 0.9", TimeScheme::GeneralizedAlpha { radius: 0.9 }),
    ] {
        let mut settings = Settings::new(Grid::new(5e-3, 8.0, 4.0, 2.5e-3));
        settings.constant = pull.clone();
        settings.scheme = scheme;
        let mut first = None;
        let (mut last, mut energy) = (0.0, 0.0);
        let mut trouble = None;
        let mut watch = |now: &Instant<'_>| {
            let mut stored = 0.0;
            for storey in 1..=STOREYS {
                let Ok(bar) = bar(storey) else { continue };
                let values = bar.nodes.map(|n| now.problem.model.at_node(&now.state.committed.u, n)[0]);
                let element = 2 * (storey - 1) + 1;
                let history = &now.state.old[now.state.history(element)];
                match bar.stored(&values, history, [YOUNG, hardening]) {
                    Ok(e) => stored += e,
                    Err(error) => trouble = Some(error),
                }
            }
            last = stored - *first.get_or_insert(stored);
            if now.sample.is_some() {
                energy = now.energies.internal - now.energies.hysteretic;
            }
        };
        let run = completed(march(problem, &shaking(&settings.grid, 6.0), &settings, &mut [&mut watch], &Silent)?)?;
        if let Some(error) = trouble {
            return Err(error.into());
        }
        let balance = &run.balance;
        let falls = balance.samples.windows(2).filter(|w| w[1].hysteretic < w[0].hysteretic);
        let falls = falls.count();
        let end = balance.samples.last().copied().unwrap_or_default();
        rows.push(row(
            "D9",
            format!(
                "tower of von Mises bars, {name}: residual of the energy balance ({:.0} % of the energy is hysteretic, {:.1e} numerical)",
                100.0 * end.hysteretic / end.input,
                end.numerical / end.input,
            ),
            "closes if every step is converged",
            Reference::ClosedForm,
            balance.error(),
            1e-3,
            "of the energy",
        ));
        rows.push(row(
            "D9",
            format!("tower of von Mises bars, {name}: samples at which the dissipated energy falls"),
            "none",
            Reference::ClosedForm,
            falls as f64,
            0.0,
            "",
        ));
        // The work is a sum of trapezia; where a step goes through a yield point these are too large by the order of the step.
        rows.push(row(
            "D9",
            format!("tower of von Mises bars, {name}: work on the bars less what they dissipate and store"),
            "σ²/2E + K a²/2 of the bars",
            Reference::SecondFormulation,
            (energy - last) / balance.largest,
            1e-3,
            "of the energy",
        ));
    }
    Ok(())
}

/// Strip 8.4 as a super-element: balance, and histories of direct integration.
fn condensed_strip(rows: &mut Vec<Row>) -> Result<(), Failure> {
    let strip = Strip::new(14, 3, 12)?;
    let wall = strip.system.size() - strip.sloshing;
    let mut builder = Builder::new();
    let mut unknowns = Vec::new();
    for node in 0..wall / 2 {
        builder.node([0.0, 0.0, node as f64]);
        unknowns.extend([(node, Dof::Ux), (node, Dof::Ry)]);
    }
    for _ in 0..strip.sloshing {
        unknowns.push((builder.node([0.0; 3]), Dof::Amplitude));
    }
    let element = SuperElement::over(&unknowns)?
        .with_mass(strip.system.mass.to_dense())?
        .with_stiffness(strip.system.stiffness.to_dense())?;
    builder.element("strip", element);
    let mut parts = Parts::new(builder.build()?, Damping::none())?;
    // Unknowns stand node by node, as in the strip; the clamped base is not in the element.
    parts.system.inertia = strip.system.inertia.clone();
    let damping = Damping::rayleigh(Rayleigh::fit((2.5, 0.005), (100.0, 0.02), false).map_err(AnalysisError::from)?);
    parts.system.damping = damping.clone();
    let grid = Grid::new(5e-3, 8.0, 4.0, 5e-3);
    let load = shaking(&grid, 1.0);
    for (name, scheme) in [
        ("trapezoidal rule", TimeScheme::Trapezoidal),
        ("generalised-α, ρ_∞ = 0.9", TimeScheme::GeneralizedAlpha { radius: 0.9 }),
    ] {
        let mut settings = Settings::new(grid);
        settings.scheme = scheme;
        let quantities = strip.observables.iter().cloned().map(Quantity::Linear).collect();
        let mut recorder = QuantityObserver::new(quantities);
        let run = completed(march(parts.problem(), &load, &settings, &mut [&mut recorder], &Silent)?)?;
        rows.push(row(
            "D9",
            format!("strip 8.4 as a super-element, {name}: residual of the energy balance"),
            "closes for linear models",
            Reference::ClosedForm,
            run.balance.error(),
            1e-10,
            "of the energy",
        ));
        let mut linear = transient::Settings::new(grid);
        linear.scheme = scheme;
        let system = strip.system.clone().with_damping(damping.clone());
        let symbolic = Arc::new(Symbolic::new(system.mass.pattern.clone(), &Ordering::MinimumDegree)?);
        let direct =
            integrate(&system, &symbolic, std::slice::from_ref(&load), &linear, &strip.observables, &[], &Silent)?;
        let mut worst = 0.0_f64;
        for (found, expected) in recorder.histories.iter().zip(&direct[0].observed.scalars) {
            let peak = expected.extreme.peak().0;
            let pairs = found.iter().zip(&expected.values);
            worst = pairs.fold(worst, |m, (a, b)| m.max((a - b).abs() / peak));
        }
        rows.push(row(
            "D11",
            format!("strip 8.4 as a super-element, {name}: histories beside those of direct integration"),
            "linear direct integration",
            Reference::SecondFormulation,
            worst,
            1e-8,
            "of the peak",
        ));
    }
    Ok(())
}

/// Displacements of the wall's nodes at every step.
fn wall_history(tank: &Assembled, scale: f64) -> Result<Vec<Vec<f64>>, Failure> {
    Ok(shaken_wall(tank, scale)?.0)
}

/// The same with the share of the energy that the wall has dissipated.
fn shaken_wall(tank: &Assembled, scale: f64) -> Result<(Vec<Vec<f64>>, f64), Failure> {
    let system = System::new(&tank.model, &tank.assembler)?;
    let problem = Problem { model: &tank.model, assembler: &tank.assembler, symbolic: &tank.symbolic, system: &system };
    let grid = Grid::new(2e-3, 0.2, 0.0, 2e-3);
    let a: Vec<f64> = (0..=100).map(|i| scale * (0.25 * f64::from(i)).sin()).collect();
    let mut settings = Settings::new(grid);
    settings.newton.criteria.energy = 1e-22;
    settings.newton.modified = false;
    let mut out = Vec::new();
    let mut watch = |now: &Instant<'_>| {
        let nodes = tank.rows.iter().flatten();
        let at = |&node: &usize| now.problem.model.at_node(&now.state.committed.u, node);
        out.push(nodes.flat_map(|n| at(n)[..3].to_vec()).collect::<Vec<f64>>());
    };
    let load = Load::ground(0, Motion::sampled(grid.dt, &a, &grid));
    let run = completed(march(problem, &load, &settings, &mut [&mut watch], &Silent)?)?;
    let dissipated = run.balance.samples.last().map_or(0.0, |e| e.hysteretic);
    Ok((out, dissipated / run.balance.largest))
}

/// Largest difference of two histories, and largest value of the first relative to its start.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for (x, y) in a.iter().zip(b) {
        for ((p, q), s) in x.iter().zip(y).zip(&a[0]) {
            worst = worst.max((p - q).abs());
            largest = largest.max((p - s).abs());
        }
    }
    worst / largest
}

/// The liquid with all its unknowns and condensed.
fn condensation(rows: &mut Vec<Row>) -> Result<(), Failure> {
    let data = Tank::broad();
    let division = Division {
        sectors: 8,
        wall: vec![0.0, 0.15, 0.4, 0.915, 1.2, 1.525, 1.83],
        radii: uniform(data.radius, 3),
        liquid: uniform(data.depth, 4),
        membrane_shear: Default::default(),
    };
    let peak = 8.0;
    let full = wall_history(&with_hexahedra(&data, &division)?, peak)?;
    let condensed = wall_history(&with_condensed(&data, &division, None)?, peak)?;
    let half = wall_history(&with_condensed(&data, &division, None)?, 0.5 * peak)?;
    let doubled: Vec<Vec<f64>> =
        half.iter().map(|u| u.iter().zip(&half[0]).map(|(u, s)| s + 2.0 * (u - s)).collect()).collect();
    rows.push(row(
        "D11",
        format!(
            "tank 8.1 as a nonlinear shell, 100 steps: wall displacements, liquid condensed beside all its unknowns (twice half the shaking differs by {:.1} %)",
            100.0 * apart(&condensed, &doubled)
        ),
        "three-field model",
        Reference::SecondFormulation,
        apart(&full, &condensed),
        1e-8,
        "of the largest",
    ));
    for count in [12, 4] {
        let modal = wall_history(&with_condensed(&data, &division, Some(count))?, peak)?;
        rows.push(row(
            "D11",
            format!("tank 8.1 as a nonlinear shell: wall displacements with {count} sloshing modes, for comparison"),
            "three-field model",
            Reference::SecondFormulation,
            apart(&full, &modal),
            f64::INFINITY,
            "of the largest",
        ));
    }
    // A wall that yields; the same law in both models, so that the histories part by the condensation alone.
    let data = Tank { yields: Some([10e6, 5e9]), ..data };
    let (full, _) = shaken_wall(&with_hexahedra(&data, &division)?, peak)?;
    let (condensed, dissipated) = shaken_wall(&with_condensed(&data, &division, None)?, peak)?;
    rows.push(row(
        "D11",
        format!(
            "tank 8.1 with a wall that yields at 10 MPa (layered shell), 100 steps: wall displacements, liquid condensed beside all \
             its unknowns ({:.0} % of the energy is hysteretic)",
            100.0 * dissipated
        ),
        "three-field model",
        Reference::SecondFormulation,
        apart(&full, &condensed),
        1e-8,
        "of the largest",
    ));
    Ok(())
}

/// Rows D2, D9 and D11.
///
/// Errors: a model that cannot be solved, a march that does not complete.
pub(crate) fn nonlinear() -> Answer {
    let mut rows = Vec::new();
    steel(&mut rows)?;
    condensed_strip(&mut rows)?;
    condensation(&mut rows)?;
    Ok(rows)
}
