//! Memory and time of a run of the three-dimensional engine, from its mesh division.
//!
//! ```text
//! wall       5 unknowns a node of a closed surface                    factor: nested dissection of a surface
//! potential  1 a node of a closed block, 1 an elevation               factors of both
//! displacement liquid  3 a node, in one matrix with the wall          a factor for each pole
//! box        a plan of length × breadth, four walls around it          and factors of both together for each pole
//! reduction  three times VECTORS vectors over all unknowns, solves and orthogonalisation of each
//! ```

use tank::Case;
use tank::Shape;
use tank::options::AfterRecord;

use super::coupling;
use super::memory::RUN;
use super::mesh::Division;
use super::poles::{VECTORS, poles};
use crate::FeError;
use crate::estimate::{
    Estimate, FACTOR_RATE, Fill, Lever, NUMBER, PRODUCT_RATE, PROGRAM, Response, SWEEP_RATE, THE_PROGRAM, coarser,
    limit_states,
};
use crate::linear::model::shaken_upwards;
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;
use tank::options::solid::{Liquid, MeshSize, SolidOptions};

/// Unknowns of a node of the wall.
const WALL: f64 = 5.0;
/// Bytes of an element of the liquid with its nodes and places in the matrices: potential and displacement.
const CELL: [f64; 2] = [2_600.0, 9_000.0];
/// Bytes of an element of the wall.
const SHELL: f64 = 12_000.0;
/// Neighbours of a node in a matrix of which one triangle is kept: surface and block.
const NEIGHBOURS: [f64; 2] = [5.0, 14.0];
/// Matrices on the places of all unknowns, the places among them.
const MATRICES: f64 = 5.0;
/// Time of an element: matrices and pictures [s].
const CELL_TIME: f64 = 3.5e-5;
/// Steps of direct integration: in a period of the first mode of the wall, most in a sample.
const DIRECT: (f64, f64) = (100.0, 400.0);
/// States and outputs of one step of a modal response [s].
const MODAL_STEP: f64 = 1e-6;
/// Histories of a run with their copies.
const HISTORIES: f64 = 60.0;
/// Time of a number of a state for ParaView, written as text [s].
const STATE_TIME: f64 = 3e-7;
/// Fixed time [s]: the codes, results and report.
const REST: f64 = 0.05;
/// Modal states of one direction that the limit states keep.
const STATES: f64 = 25.0;
/// Vectors of the reduction and of the modes of other wave numbers that are drawn.
const SOLVES: f64 = VECTORS as f64 + 96.0;
/// Times that a vector meets those before it.
const ORTHOGONAL: f64 = 2.0;

/// Memory and time of [`super::simulate`], or, without a record, of [`super::modes`].
///
/// Errors: options out of range; an invalid mesh; a response longer than the limits.
pub fn estimate(case: &Case, options: &Options, solid: &SolidOptions) -> Result<Estimate, FeError> {
    crate::checks::check_options(case, options)?;
    let response = Response::of(case, AfterRecord::DEFAULT)?;
    let mut found = of(case, options, solid, response)?;
    let smaller = |give: String, options: &Options, solid: &SolidOptions| -> Result<_, FeError> {
        let smaller = of(case, options, solid, response)?;
        Ok((give, smaller.bytes(), smaller.seconds))
    };
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    match solid.mesh {
        Some(mesh) => {
            for part in [0.8, 0.65, 0.5, 0.35, 0.25, 0.15, 0.1, 0.05, 0.02, 0.01] {
                let scaled = |n: usize, least: usize| ((n as f64 * part) as usize).max(least);
                let mesh = MeshSize {
                    radial: scaled(mesh.radial, 1),
                    sectors: scaled(mesh.sectors, if round { 8 } else { 2 }).next_multiple_of(if round {
                        4
                    } else {
                        2
                    }),
                    vertical: scaled(mesh.vertical, 1),
                };
                let solid = SolidOptions { mesh: Some(mesh), ..solid.clone() };
                found.lever.smaller.push(smaller(format!("use --mesh {mesh}"), options, &solid)?);
            }
        }
        None => {
            for refine in coarser(options.refine) {
                let options = Options { refine, ..options.clone() };
                found.lever.smaller.push(smaller(format!("use --refine {refine}"), &options, solid)?);
            }
        }
    }
    Ok(found)
}

/// Numbers of nodes.
struct Nodes {
    round: bool,
    /// Around the wall.
    around: f64,
    /// Nodes of the plan: around and over the radius, or over breadth and length.
    sectors: f64,
    radial: f64,
    depth: f64,
    wall: f64,
}

impl Nodes {
    fn of(division: &Division, round: bool) -> Nodes {
        let [sectors, radial] = match round {
            true => [division.sectors as f64, (division.radii.len() - 1) as f64],
            false => [&division.breadth, &division.radii].map(|places| 2.0 * places.len() as f64 - 1.0),
        };
        Nodes {
            round,
            around: division.sectors as f64,
            sectors,
            radial,
            depth: division.liquid.len() as f64,
            wall: (division.wall.len() - 1) as f64,
        }
    }
}

fn of(case: &Case, options: &Options, solid: &SolidOptions, response: Option<Response>) -> Result<Estimate, FeError> {
    let matching = solid.liquid == Liquid::Displacement;
    let division = Division::new(&case.tank, case.liquid.fill_height, options, solid, matching)?;
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    let nodes = Nodes::of(&division, round);
    let poles = poles(case, solid).len() as f64;
    let n = unknowns(&nodes, solid.liquid);
    let factors = factors(&nodes, solid.liquid, poles);
    let cells = nodes.sectors * nodes.radial * (nodes.depth - 1.0);
    let shells = nodes.around * nodes.wall;
    let liquid = match solid.liquid {
        Liquid::Potential => [1.0, CELL[0]],
        Liquid::Displacement => [3.0, CELL[1]],
    };
    let places = shells * WALL * WALL * NEIGHBOURS[0]
        + nodes.sectors * nodes.radial * nodes.depth * liquid[0] * liquid[0] * NEIGHBOURS[1];
    let height = case.tank.wall_height();
    let vectors = coupling::vectors(&solid.imperfections, height) as f64;
    let directions = match case.ground_motion.as_ref().map(|m| m.vertical.is_some()) {
        Some(true) => 2.0,
        _ if shaken_upwards(case) => 2.0,
        _ => 1.0,
    };
    let parts = vec![
        (THE_PROGRAM, PROGRAM),
        ("elements", cells * liquid[1] + shells * SHELL),
        ("matrices", NUMBER * MATRICES * places),
        ("factors", NUMBER * factors.entries),
        ("vectors of the reduction", NUMBER * (2.0 + directions) * vectors * n),
    ];
    // A solve for each vector at one of the poles, and the vectors before it.
    let sweep = 2.0 * NUMBER * factors.entries / (1.0 + poles) + ORTHOGONAL * 2.0 * NUMBER * vectors * n;
    let seconds = REST
        + factors.flops / FACTOR_RATE
        + (SOLVES - VECTORS as f64 + vectors) * directions * sweep / SWEEP_RATE
        + CELL_TIME * (cells + shells);
    let mut found = Estimate {
        run: RUN,
        size: format!("{} elements, {n:.0} unknowns", division.size()),
        parts,
        samples: 0.0,
        steps: 0.0,
        seconds,
        inelastic: None,
        lever: Lever {
            smaller: Vec::new(),
            other: match solid.snapshot_interval {
                Some(_) => "coarsen the mesh (--mesh, --refine), or give a longer --vtu-every",
                None => "coarsen the mesh (--mesh, --refine)",
            }
            .into(),
        },
    };
    if let Some(response) = response {
        let integrated = Integrated { response, nodes: &nodes, cells, shells, directions, places, factors };
        integrated.add_to(&mut found, case, options, solid);
    }
    // A box along y is a model of its own, built before the other.
    let two = case.ground_motion.as_ref().is_some_and(|motion| motion.transverse.is_some());
    if two && matches!(case.tank.shape, Shape::Rectangle { .. }) {
        found.seconds *= 2.0;
    }
    Ok(found)
}

/// A response in time on a mesh.
struct Integrated<'a> {
    response: Response,
    nodes: &'a Nodes,
    /// Elements of liquid and wall.
    cells: f64,
    shells: f64,
    /// Directions of motion with systems of their own.
    directions: f64,
    /// Entries of a matrix.
    places: f64,
    factors: Fill,
}

impl Integrated<'_> {
    /// Adds its memory and time.
    fn add_to(&self, found: &mut Estimate, case: &Case, options: &Options, solid: &SolidOptions) {
        let Integrated { response, nodes, cells, shells, places, factors, .. } = self;
        found.samples = response.samples();
        let omega = crate::estimate::first_wall_frequency(case);
        let steps = |(per_period, most): (f64, f64)| {
            found.samples * (response.dt * per_period * omega / std::f64::consts::TAU).ceil().clamp(1.0, most)
        };
        let (modal, direct) = (steps((25.0, 40.0)), steps(DIRECT));
        found.steps = modal;
        found.seconds += 3.0 * self.directions * modal * MODAL_STEP;
        // And a second mesh with elements twice as long.
        if solid.mesh.is_none() && options.mesh_error {
            found.seconds *= 1.2;
        }
        let upwards = case.ground_motion.as_ref().is_some_and(|m| m.vertical.is_some());
        let states = if upwards { 2.0 * STATES } else { STATES };
        found.parts.extend(limit_states(case, modal, states, nodes.wall));
        found.parts.push(("histories", NUMBER * found.samples * HISTORIES));
        if let Some(interval) = solid.snapshot_interval {
            let states = (response.duration / interval).floor() + 1.0;
            let surface = nodes.sectors * nodes.radial;
            let liquid = if solid.snapshot_inside { 3.0 * surface * nodes.depth + cells } else { 3.0 * surface };
            let numbers = liquid + (3.0 + 8.0) * shells;
            found.parts.push(("states for pictures (--vtu-every)", NUMBER * states * numbers));
            found.seconds += states * numbers * STATE_TIME;
        }
        if options.integrator == Integrator::Newmark {
            found.seconds +=
                direct * (2.0 * NUMBER * factors.entries / SWEEP_RATE + 3.0 * NUMBER * places / PRODUCT_RATE);
            found.parts.push(("direct integration", NUMBER * (factors.entries + 2.0 * places + direct)));
            found.steps = direct;
        }
    }
}

fn unknowns(nodes: &Nodes, liquid: Liquid) -> f64 {
    let surface = nodes.sectors * nodes.radial;
    let wall = nodes.around * nodes.wall * WALL;
    match liquid {
        Liquid::Potential => surface * (nodes.depth + 1.0) + wall,
        Liquid::Displacement => 3.0 * surface * nodes.depth + wall,
    }
}

/// All factors.
fn factors(nodes: &Nodes, liquid: Liquid, poles: f64) -> Fill {
    let grid = |along: [f64; 2], dofs: f64| Fill::grid([nodes.sectors, along[0], along[1]], dofs, nodes.round);
    // A ring of plates is closed as a cylinder is.
    let wall = Fill::grid([nodes.around, nodes.wall, 1.0], WALL, true);
    let volume = |dofs: f64| grid([nodes.radial, nodes.depth], dofs);
    match liquid {
        Liquid::Potential => {
            let one = wall.with(1.0, volume(1.0)).with(1.0, grid([nodes.radial, 1.0], 1.0));
            // In three fields at a pole.
            one.with(poles, one)
        }
        Liquid::Displacement => {
            let one = wall.with(1.0, volume(3.0));
            one.with(poles, one)
        }
    }
}
