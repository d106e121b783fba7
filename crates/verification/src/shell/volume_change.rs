//! Temperature, shrinkage, prestress and creep of a cylindrical wall at rest.
//!
//! ```text
//! free, uniform ΔT              w = α ΔT R                                     no stress
//! clamped foot, uniform ΔT      M = p/(2 β²) ,  Q = p/β                        p = E t α ΔT/R ,  β = (3 (1 − ν²))^¼/√(R t)
//! ΔT between the faces          σ = ∓ E α ΔT/(2 (1 − ν))                       far from the edges
//! hoop bars, prestress σ_p      ε = −A σ_p/(E t + A E_s) ,  N_s = A (σ_p + E_s ε) ,  σ_c = E ε = −p R/t of p = N_s/R
//! shrinkage with bars, creep    ε = −ε_sh E' t/(E' t + A E_s) ,  σ_c = −N_s/t   E' = E/(1 + φ)
//! pressure after it             Δw = p R²/(E t + A E_s)                         the short-time modulus
//! ```
//!
//! The wall is free along its axis. Strains are those of Green and Lagrange: e + e²/2, which differs from e by 1e-4 of it.
//!
//! Source: Timoshenko & Woinowsky-Krieger 1959, art. 114-117 (edge of a long cylinder, thermal stresses); transformed sections.

use std::sync::Arc;

use super::path::Problem;
use super::tank::{TankStrip, graded, wall_strip};
use super::{Answer, Case, hold};
use crate::{Benchmark, Part, Reference, Row};
use fem::dofs::Dof;
use fem::element::Inspect;
use fem::element::shell::layered::{Bar, LayeredSection, Ply, PlyState};
use fem::element::shell::load::NodalLoads;
use fem::element::shell::rule::Rule;
use fem::element::shell::section::Section;
use fem::element::shell4::MembraneShear;
use fem::state::{Gather, State};
use materials::elastic::Elastic;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "volume-change",
    title: "Shell: temperature, shrinkage, prestress and creep at rest",
    model: "One sector of a cylindrical wall of layers and bars under free strains, clamped at its foot or free.",
    ids: &[("VC", "volume changes of a wall")],
    parts: &[Part::Fast(rows)],
};

const RADIUS: f64 = 10.0;
const SECTORS: usize = 64;
/// Height of the wall [m]: β z > 8 from its middle to the ends of all walls below.
const HEIGHT: f64 = 6.0;

/// A wall of one ply: modulus [Pa], Poisson's ratio, thickness [m].
#[derive(Clone, Copy)]
struct Wall {
    young: f64,
    poisson: f64,
    thickness: f64,
}

const STEEL: Wall = Wall { young: 210e9, poisson: 0.3, thickness: 0.02 };
const CONCRETE: Wall = Wall { young: 30e9, poisson: 0.2, thickness: 0.2 };

/// α ΔT.
const THERMAL: f64 = 12e-6 * 20.0;
/// Hoop bars in the middle of the wall: area [m²/m], modulus [Pa]; beside it thin shells misplace their radius by ζ/R.
const BARS: [f64; 2] = [20e-4, 200e9];
/// Their prestress [Pa].
const PRESTRESS: f64 = 1000e6;

impl Wall {
    fn beta(&self) -> f64 {
        (3.0 * (1.0 - self.poisson * self.poisson)).powf(0.25) / (RADIUS * self.thickness).sqrt()
    }

    /// Its section, with hoop bars that have this free strain.
    fn section(&self, state: PlyState, bars: Option<f64>) -> Answer<Arc<dyn Section>> {
        let law = Arc::new(Elastic::new(self.young, self.poisson)?);
        let ply = Ply { law, thickness: self.thickness, density: 0.0, rule: Rule::Lobatto(3) };
        let [area, young] = BARS;
        let law = Arc::new(Elastic::new(young, 0.0)?);
        let bar = Bar { law, area, depth: 0.0, angle: 0.0, density: 0.0 };
        let (all, free): (Vec<Bar>, Vec<f64>) = bars.map(|free| (bar, free)).into_iter().unzip();
        Ok(Arc::new(LayeredSection::new(&[ply], &all)?.lasting(&[state], &free)?))
    }
}

/// A wall at rest.
struct Rest {
    problem: Problem,
    state: State,
    elements: Vec<usize>,
    levels: Vec<[usize; 2]>,
    /// Forces of the supports.
    supports: Vec<((usize, Dof), f64)>,
}

impl Rest {
    /// * `pressure`: load of the path after it [Pa]
    fn new(section: &Arc<dyn Section>, heights: &[f64], clamped: bool, pressure: f64) -> Answer<Rest> {
        let strip = wall_strip(RADIUS, SECTORS, heights, MembraneShear::CentrePoint, |_| section.clone())?;
        let TankStrip { mut builder, placed, levels } = strip;
        let foot: &[Dof] = if clamped { &[Dof::Ux, Dof::Uz, Dof::Rx] } else { &[Dof::Uz] };
        hold(&mut builder, &levels[0], foot);
        let mut loads = NodalLoads::new();
        for l in levels.windows(2) {
            let nodes = [l[0][0], l[0][1], l[1][1], l[1][0]];
            loads.pressure(&nodes, &nodes.map(|n| builder.position(n)), |_| pressure);
        }
        let problem = Problem::new(builder, &loads)?;
        let mut state = State::new(&problem.model);
        let supports = problem.rest(&mut state, 2)?;
        Ok(Rest { elements: placed.elements, problem, state, levels, supports })
    }

    /// Radial displacement at half the height [m].
    fn growth(&self) -> f64 {
        let node = self.levels[self.levels.len() / 2][0];
        let [x, y, _] = self.problem.model.nodes()[node];
        let [u, v, _] = self.problem.displacement(&self.state, node);
        (u * x + v * y) / RADIUS
    }

    /// Hoop stresses of the layers from inside to outside, then of the bars, at half the height [Pa].
    fn stresses(&self) -> Vec<f64> {
        let element = self.elements[self.elements.len() / 2];
        let shell = &*self.problem.model.elements()[element];
        let mut gather = Gather::default();
        let motion = gather.motion(&self.problem.model, &self.state.committed, shell);
        let mut out = Vec::new();
        shell.material_points(motion, &self.state.old[self.state.history(element)], &mut |p| {
            if p.point == 0 {
                out.push(p.stress[0]);
            }
        });
        out
    }

    /// Force of the foot along `dof` per length of the polygon [N/m, N].
    fn foot(&self, dof: Dof) -> f64 {
        let sum: f64 =
            self.supports.iter().filter(|((node, d), _)| *d == dof && self.levels[0].contains(node)).map(|s| s.1).sum();
        (sum / (2.0 * RADIUS * (std::f64::consts::PI / SECTORS as f64).sin())).abs()
    }
}

/// Levels of a wall, finer at its foot by the rule of S11.
fn refined(wall: Wall) -> Vec<f64> {
    let l = (RADIUS * wall.thickness).sqrt();
    graded(&[(0.0, true), (HEIGHT, true)], 0.125 * l, 1.6 * l)
}

fn even(rows: usize) -> Vec<f64> {
    (0..=rows).map(|k| HEIGHT * k as f64 / rows as f64).collect()
}

fn row(what: &str, unit: &'static str, reference: f64, computed: f64, tolerance: f64) -> Row {
    let case = Case { id: "VC", source: "closed form, above", unit };
    case.row(what, Reference::ClosedForm, reference, computed, tolerance)
}

/// Uniform temperature and a gradient, without bars.
fn temperature() -> Answer {
    let wall = STEEL;
    let uniform = wall.section(PlyState { free: [THERMAL; 2], creep: 0.0 }, None)?;
    let free = Rest::new(&uniform, &even(12), false, 0.0)?;
    let largest = free.stresses().iter().fold(0.0_f64, |a, s| a.max(s.abs()));
    // The strain of Green and Lagrange misses by e/2 = 1.2e-4. A ring that grows by e keeps its director, so that a thin shell strains its face by
    // e (1 + t/2R): t/2R = 1e-3 of E α ΔT/(1 − ν) = 72 MPa stays.
    let mut rows = vec![
        row("free, uniform ΔT: radial displacement", "mm", 1e3 * THERMAL * RADIUS, 1e3 * free.growth(), 2e-4),
        row("free, uniform ΔT: largest stress", "MPa", 0.0, 1e-6 * largest, 0.1),
    ];
    let (beta, pressure) = (wall.beta(), wall.young * wall.thickness * THERMAL / RADIUS);
    let (moment, shear) = (pressure / (2.0 * beta * beta), pressure / beta);
    let clamped = Rest::new(&uniform, &refined(wall), true, 0.0)?;
    // As the moment of S11 on the same rule for the mesh: polygon 0.12 %, shear flexibility t/R = 0.2 %, mesh; 1 %.
    let mut of_foot =
        row("clamped, uniform ΔT: moment at the foot", "kN", 1e-3 * moment, 1e-3 * clamped.foot(Dof::Rx), 0.01);
    for n in [25, 50, 100, 200] {
        let run = Rest::new(&uniform, &even(n), true, 0.0)?;
        of_foot.convergence.push((n as f64, run.foot(Dof::Rx) / moment - 1.0));
    }
    rows.push(of_foot);
    rows.push(row("clamped, uniform ΔT: shear at the foot", "kN/m", 1e-3 * shear, 1e-3 * clamped.foot(Dof::Ux), 0.01));
    let gradient = wall.section(PlyState { free: [0.0, THERMAL], creep: 0.0 }, None)?;
    let stresses = Rest::new(&gradient, &even(48), false, 0.0)?.stresses();
    let face = wall.young * THERMAL / (2.0 * (1.0 - wall.poisson));
    // t/2R = 1e-3 of the mean thermal stress, which is that of the face, and of the stress itself; e^(−β z) of the edges is 2e-4.
    rows.push(row("ΔT between the faces: hoop stress inside", "MPa", 1e-6 * face, 1e-6 * stresses[0], 3e-3));
    rows.push(row("ΔT between the faces: hoop stress outside", "MPa", -1e-6 * face, 1e-6 * stresses[2], 3e-3));
    Ok(rows)
}

/// Hoop bars with a prestress, and a shrinking and creeping wall with bars.
fn bars() -> Answer {
    let wall = CONCRETE;
    let [area, steel] = BARS;
    let stiffness = |young: f64| young * wall.thickness + area * steel;
    let prestressed = wall.section(PlyState::default(), Some(-PRESTRESS / steel))?;
    let rest = Rest::new(&prestressed, &even(12), false, 0.0)?;
    let strain = -area * PRESTRESS / stiffness(wall.young);
    let force = area * (PRESTRESS + steel * strain);
    let stresses = rest.stresses();
    // Nothing varies over the height: the strain of Green and Lagrange misses by e/2 = 1.6e-4, squared by the polygon's turn nothing.
    let tolerance = 5e-4;
    let mut rows = vec![
        row(
            "prestress: radial displacement, −p R²/(E t)",
            "mm",
            -1e3 * force * RADIUS / (wall.young * wall.thickness),
            1e3 * rest.growth(),
            tolerance,
        ),
        row(
            "prestress: stress of the wall, −p R/t",
            "MPa",
            -1e-6 * force / wall.thickness,
            1e-6 * stresses[1],
            tolerance,
        ),
        row("prestress: force of the bars p R", "kN/m", 1e-3 * force, 1e-3 * area * stresses[3], tolerance),
    ];
    let (shrinkage, creep, pressure) = (3e-4, 2.0, 50e3);
    let shrinking = wall.section(PlyState { free: [-shrinkage; 2], creep }, Some(0.0))?;
    let mut rest = Rest::new(&shrinking, &even(12), false, pressure)?;
    let lasting = wall.young / (1.0 + creep);
    let strain = -shrinkage * lasting * wall.thickness / stiffness(lasting);
    let (stresses, before) = (rest.stresses(), rest.growth());
    rows.push(row(
        "shrinkage and creep: stress of the bars",
        "MPa",
        1e-6 * steel * strain,
        1e-6 * stresses[3],
        tolerance,
    ));
    // The wall has a sixth of the shrinkage as strain, so that what the strain of Green and Lagrange misses counts six times.
    rows.push(row(
        "shrinkage and creep: stress of the wall",
        "MPa",
        -1e-6 * area * steel * strain / wall.thickness,
        1e-6 * stresses[1],
        1.5e-3,
    ));
    rest.problem.load_steps_from(&mut rest.state, 1, false, |_, _| {})?;
    // The load sits on the chord of the polygon: 1 − (π/64)²/6 = 4e-4 of the ring's force.
    let expected = pressure * RADIUS * RADIUS / stiffness(wall.young);
    rows.push(row(
        "pressure after creep: radial displacement",
        "mm",
        1e3 * expected,
        1e3 * (rest.growth() - before),
        2e-3,
    ));
    Ok(rows)
}

pub(super) fn rows() -> Answer {
    let mut rows = temperature()?;
    rows.extend(bars()?);
    Ok(rows)
}
