//! Memory and time of a run of the harmonic engine, from its numbers of elements.
//!
//! ```text
//! n = unknowns a wall node × wall nodes + surface nodes        c = 2 × wetted wall nodes + surface nodes
//! liquid        3 dense blocks of c columns over its nodes, its sparse factor      (built, condensed, dropped)
//! wall, liquid  8 matrices of order n (M, K, factor, operator, vectors, …), a row of 2 n for every observed place
//! response      histories of the scalars, ground motion at the steps
//! ```

use tank::Case;
use tank::Shape;
use tank::options::AfterRecord;

use super::liquid_mesh;
use super::wall_mesh::wall_nodes;
use crate::FeError;
use crate::estimate::{
    DENSE_RATE, Estimate, FACTOR_RATE, Fill, Lever, NUMBER, PROGRAM, Response, SWEEP_RATE, coarser,
    first_wall_frequency,
};
use crate::linear::demands::MOST_INSTANTS;
use crate::linear::mesh_error::SecondMesh;
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
/// Modal states of one direction that the limit states keep.
const STATES: f64 = 40.0;
/// Times that a history is there: in the response, as a column of the results, as text.
const COPIES: f64 = 3.0;
/// Operations of all modes of a dense pair of matrices of order n, over n³.
const MODES: f64 = 12.0;
/// States and outputs of one step of a modal response [s].
const MODAL_STEP: f64 = 6e-7;
/// Codes, reading, results and report [s].
const REST: f64 = 0.03;
/// Courses beyond which nodes are counted by their number alone.
const MANY_COURSES: usize = 1000;
/// Highest significant mode of the wall over the first: the others carry less than a hundredth of the mass.
const HIGHEST: f64 = 1.3;
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
}

impl Mesh {
    fn new(case: &Case, refine: f64) -> Mesh {
        let depth = case.liquid.fill_height;
        let tank = &case.tank;
        let wall = match tank.courses.len() {
            n if n <= MANY_COURSES => wall_nodes(tank, depth, refine).0.len() as f64,
            n => n as f64 + 46.0 * refine,
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
        }
    }

    /// Bytes of the liquid, of wall and liquid, and operations of both.
    fn cost(&self) -> (f64, f64, f64) {
        let (n, c) = (self.unknowns, self.columns);
        let nodes = self.liquid[0] * self.liquid[1];
        let fill = Fill::grid([self.liquid[0], self.liquid[1], 1.0], 1.0, false);
        let liquid = NUMBER * (3.0 * c * nodes + 3.0 * c * c + fill.entries + 60.0 * nodes);
        let places = 1.2 * self.wall;
        // The liquid's matrices are dropped before the modes are sought.
        let modes = NUMBER * (MATRICES * n * n + 2.0 * n * LINES * places);
        let coupled = (modes - liquid).max(NUMBER * n * n);
        let products = 2.0 * c * c * nodes + MODES * n * n * n;
        let solves = 2.0 * NUMBER * fill.entries * c;
        (
            liquid,
            coupled,
            products / DENSE_RATE + fill.flops / FACTOR_RATE + solves / SWEEP_RATE,
        )
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
        let coarse = Options {
            refine,
            ..options.clone()
        };
        let smaller = of(case, &coarse, response);
        let give = format!("use --refine {refine}");
        found.lever.smaller.push((give, smaller.bytes(), smaller.seconds));
    }
    Ok(found)
}

fn of(case: &Case, options: &Options, response: Option<Response>) -> Estimate {
    let mesh = Mesh::new(case, options.refine);
    let directions = match case.ground_motion.as_ref().map(|m| m.vertical.is_some()) {
        Some(true) => 2.0,
        _ => 1.0,
    };
    // Two meshes side by side.
    let second = response
        .and_then(|_| SecondMesh::of(options))
        .map(|second| Mesh::new(case, second.options.refine));
    let (mut liquid, mut coupled, mut seconds) = (0.0, 0.0, REST);
    for mesh in std::iter::once(&mesh).chain(&second) {
        let (block, system, time) = mesh.cost();
        liquid += block;
        // One system is kept while that of the other direction is made: M, K, modes.
        coupled += system * (1.0 + 0.5 * (directions - 1.0));
        seconds += directions * time;
    }
    let mut parts = vec![
        ("the program", PROGRAM),
        ("wall and liquid", coupled),
        ("condensed liquid", liquid),
    ];
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
            let wanted = response.dt * per_period * HIGHEST * first_wall_frequency(case) / std::f64::consts::TAU;
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
        let kept = modal.min(MOST_INSTANTS as f64) * STATES * directions;
        parts.push(("limit states", NUMBER * kept));
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
        lever: Lever {
            smaller: Vec::new(),
            other: "resample the record (`record.resample`)".into(),
        },
    }
}
