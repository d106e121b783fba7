//! Memory and time of a run of the harmonic engine, from its numbers of elements.
//!
//! ```text
//! n = unknowns a wall node × wall nodes + surface nodes        c = 2 × wetted wall nodes + surface nodes
//! liquid        3 dense blocks of c columns over its nodes, its sparse factor      (built, condensed, dropped)
//! wall, liquid  8 matrices of order n (M, K, factor, operator, vectors, …), a row of 2 n for every observed place
//! response      histories of the scalars, ground motion at the steps
//! limit states  modal states at the instants, twice as many on a base that lifts; extremes at every place of the wall
//! ```
//!
//! A tank that is not anchored is taken to lift: whether it rests is known after the run alone.

use tank::options::AfterRecord;
use tank::{Case, Shape, Support};

use super::liquid_mesh;
use super::wall_mesh::wall_nodes;
use crate::FeError;
use crate::estimate::{
    DENSE_RATE, Estimate, FACTOR_RATE, Fill, Lever, MIB, NUMBER, PROGRAM, Response, SWEEP_RATE, THE_PROGRAM, coarser,
    first_wall_frequency, limit_states,
};
use crate::linear::mesh_error::SecondMesh;
use crate::linear::model::shaken_upwards;
use crate::linear::rocking;
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;

/// Dense matrices of the order of the coupled system that are there at a time while its modes are sought.
const MATRICES: f64 = 8.0;
/// Lines of observed places over the height of the wall.
const LINES: f64 = 5.0;
/// Histories of a run without gauges and stations, and histories of a station.
const HISTORIES: f64 = 14.0;
const PER_STATION: f64 = 3.0;
/// Histories of a station of internal forces.
const FORCES: f64 = 6.0;
/// Modal states of one direction that the limit states keep: a number, and of each unknown.
const STATES: [f64; 2] = [20.0, 0.115];
/// Matrices of the order of the coupled system that a system keeps, and that a base that lifts adds.
const KEPT: f64 = 4.0;
const LIFTED: f64 = 4.0;
/// Bytes of a step of a base that lifts, of its runs on softer and harder ground too.
const LIFTING_STEP: f64 = 220.0;
/// Vectors and threads of a mesh, however small [bytes].
const SMALL: f64 = 1.0 * MIB;
/// Times that a history is there: in the results or, after these, in the report, whose columns grow as they are read.
const COPIES: f64 = 1.5;
/// Operations of all modes of a dense pair of matrices of order n, over n³.
const MODES: f64 = 12.0;
/// States and outputs of one step of a modal response [s].
const MODAL_STEP: f64 = 6e-7;
/// Codes, reading, results and report [s].
const REST: f64 = 0.03;
/// Courses beyond which nodes are counted by their number alone.
const MANY_COURSES: usize = 1000;
/// Highest significant mode of the wall over the first, of a cylinder and of a plane wall: the others carry less than a hundredth of the mass. The second of
/// a cantilever is 22.03/3.516 times as fast as the first.
const HIGHEST: [f64; 2] = [1.3, 6.3];
/// Numbers of a state for pictures: displacements of 48 nodes at 35 levels and 15 rings, eight numbers of 48 cells at 34 levels; and the time for each [s].
const STATE_NUMBERS: f64 = 48.0 * (3.0 * (35.0 + 15.0) + 8.0 * 34.0);
const STATE_TIME: f64 = 2e-8;
/// Steps in a period of the highest significant mode, and most of them in a sample: modal and direct.
const STEPS: [(f64, f64); 2] = [(20.0, 40.0), (80.0, 400.0)];

/// Numbers of a mesh.
struct Mesh {
    /// Unknowns of the coupled system.
    unknowns: f64,
    /// Columns of the liquid's matrices.
    columns: f64,
    /// Nodes of the liquid along radius and depth.
    liquid: [f64; 2],
    /// Elements of the wall.
    wall: f64,
    /// Observed places on the wall.
    places: f64,
}

impl Mesh {
    fn new(case: &Case, refine: f64) -> Mesh {
        let depth = case.liquid.fill_height;
        let tank = &case.tank;
        let (wall, places) = match tank.courses.len() {
            n if n <= MANY_COURSES => {
                let nodes = wall_nodes(tank, depth, refine).0;
                // Mid-points of long elements, and both sides of a joint of courses.
                let long = nodes.windows(2).filter(|z| z[1] - z[0] > tank.wall_height() / 60.0).count();
                (nodes.len() as f64, (nodes.len() + long + n - 1) as f64)
            }
            n => (n as f64 + 46.0 * refine, 2.0 * n as f64 + 46.0 * refine),
        };
        let [radial, vertical] = liquid_mesh::elements(case, refine);
        let surface = 2.0 * radial + 1.0;
        let (nodal, wetted) = match tank.shape {
            Shape::Cylinder { .. } => (4.0, depth / tank.wall_height()),
            Shape::Rectangle { .. } => (2.0, depth / tank.wall_height()),
        };
        Mesh {
            unknowns: nodal * wall + surface,
            columns: 2.0 * (wetted.min(1.0) * wall).ceil() + surface,
            liquid: [surface, 2.0 * vertical + 1.0],
            wall: wall - 1.0,
            places,
        }
    }

    /// Modal states that the observables combine.
    fn states(&self) -> f64 {
        STATES[0] + STATES[1] * self.unknowns
    }

    /// Bytes of the liquid, of wall and liquid, and operations of both.
    fn cost(&self) -> (f64, f64, f64) {
        let (n, c) = (self.unknowns, self.columns);
        let nodes = self.liquid[0] * self.liquid[1];
        let fill = Fill::grid([self.liquid[0], self.liquid[1], 1.0], 1.0, false);
        let liquid = NUMBER * (3.0 * c * nodes + 3.0 * c * c + fill.entries + 60.0 * nodes);
        // The liquid's matrices are dropped before the modes are sought.
        let modes = NUMBER * (MATRICES * n * n + 2.0 * n * LINES * self.places);
        let coupled = SMALL + (modes - liquid).max(NUMBER * n * n);
        let products = 2.0 * c * c * nodes + MODES * n * n * n;
        let solves = 2.0 * NUMBER * fill.entries * c;
        (liquid, coupled, products / DENSE_RATE + fill.flops / FACTOR_RATE + solves / SWEEP_RATE)
    }
}

/// Cost of [`crate::simulate`], both meshes; without a record, of the modes of one harmonic.
///
/// Errors: options out of range; a response longer than the limits.
pub fn estimate(case: &Case, options: &Options) -> Result<Estimate, FeError> {
    crate::checks::check_options(case, options)?;
    let response = Response::of(case, AfterRecord::DEFAULT)?;
    let mut found = of(case, options, response);
    for refine in coarser(options.refine) {
        let coarse = Options { refine, ..options.clone() };
        let smaller = of(case, &coarse, response);
        let give = format!("use --refine {refine}");
        found.lever.smaller.push((give, smaller.bytes(), smaller.seconds));
    }
    Ok(found)
}

/// Adds the states for pictures, `every` [s] apart.
///
/// Errors: a response longer than the limits.
pub(crate) fn add_states(found: &mut Estimate, case: &Case, every: f64) -> Result<(), FeError> {
    if let Some(response) = Response::of(case, AfterRecord::DEFAULT)? {
        let count = ((response.duration + response.tail) / every).floor() + 1.0;
        found.parts.push(("states for pictures (--vtu-every)", NUMBER * count * STATE_NUMBERS));
        found.seconds += count * STATE_NUMBERS * STATE_TIME;
        found.lever.other.push_str(", or give a longer --vtu-every");
    }
    Ok(())
}

fn of(case: &Case, options: &Options, response: Option<Response>) -> Estimate {
    let mesh = Mesh::new(case, options.refine);
    let directions = match case.ground_motion.as_ref().map(|m| m.vertical.is_some()) {
        Some(true) => 2.0,
        _ => 1.0,
    };
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    let lifts = round && case.tank.support == Support::Unanchored;
    // The spectrum of the site upwards has a system of its own.
    let systems = if round && shaken_upwards(case) { 2.0 } else { directions };
    // Two meshes side by side.
    let second = (response.is_some() || case.site.is_given())
        .then(|| SecondMesh::of(options))
        .flatten()
        .map(|second| Mesh::new(case, second.options.refine));
    let (mut liquid, mut coupled, mut seconds) = (0.0, 0.0, REST);
    for mesh in std::iter::once(&mesh).chain(&second) {
        let (block, system, time) = mesh.cost();
        liquid += block;
        // One system is kept while that of the other direction is made: M, K, modes, lines.
        coupled += system + KEPT * NUMBER * mesh.unknowns * mesh.unknowns * (systems - 1.0);
        seconds += systems * time;
    }
    let mut parts = vec![(THE_PROGRAM, PROGRAM), ("wall and liquid", coupled), ("condensed liquid", liquid)];
    let mut size = format!(
        "liquid {:.0} x {:.0}, wall {:.0}, {:.0} unknowns",
        0.5 * (mesh.liquid[0] - 1.0),
        0.5 * (mesh.liquid[1] - 1.0),
        mesh.wall,
        mesh.unknowns
    );
    let (mut samples, mut steps) = (0.0, 0.0);
    if let Some(response) = response {
        samples = response.samples();
        let histories = HISTORIES
            + options.gauges.len() as f64
            + PER_STATION * options.stations.len() as f64
            + FORCES * options.force_stations.len() as f64;
        let newmark = options.integrator == Integrator::Newmark;
        let [modal, direct] = STEPS.map(|(per_period, most)| {
            let highest = if round { HIGHEST[0] } else { HIGHEST[1] };
            let wanted = response.dt * per_period * highest * first_wall_frequency(case) / std::f64::consts::TAU;
            samples * wanted.ceil().clamp(1.0, most)
        });
        steps = if newmark { direct } else { modal };
        // The first run finds the extremes along the wall, the second the histories.
        let meshes = if second.is_some() { 3.0 } else { 2.0 };
        seconds += meshes * directions * modal * MODAL_STEP;
        if newmark {
            let products = 3.0 * mesh.unknowns * mesh.unknowns * directions;
            seconds += direct * products * NUMBER / (2.0 * SWEEP_RATE);
        }
        parts.push(("histories", NUMBER * samples * COPIES * histories));
        let (mut instants, mut states) = (modal, directions * mesh.states());
        if lifts {
            instants = samples * rocking::sub_steps(response.dt, (modal / samples).ceil() as usize) as f64;
            states *= 2.0;
            let models = LIFTED * NUMBER * mesh.unknowns * mesh.unknowns;
            parts.push(("lifting base", models + LIFTING_STEP * instants + 0.4 * NUMBER * instants * states));
        }
        parts.extend(limit_states(case, instants, states, mesh.places));
        parts.push(("ground motion", NUMBER * directions * steps * meshes.min(2.0)));
        size.push_str(&format!(", {samples:.0} samples"));
    }
    Estimate {
        run: "harmonic run",
        size,
        parts,
        samples,
        steps,
        seconds,
        inelastic: None,
        lever: Lever { smaller: Vec::new(), other: "resample the record (`record.resample`)".into() },
    }
}
