//! Memory and time of a nonlinear run of a cylinder, from the numbers of its cells and wetted nodes.
//!
//! ```text
//! liquid     few wetted nodes w: a dense block: M, K, C of the element and of the liquid, places, M, C and tangents of the
//!            model, the factor, copies of an iteration
//!            many: one block over the levels for each harmonic, and a factored section of the wall with it
//!            a wall on its bottom: the latter, beside a factor of plate and ground
//! wall       5 unknowns a node (twice for two shells); nested dissection of a surface
//! history    committed and trial state of every point of every layer
//! ```

use fem::analysis::rings::OPEN_AT_MOST;
use tank::Case;
use tank::{Behaviour, Course, Layer, LayerKind};

use super::elements::iterates;
use super::march::{LOOKS, usual_step};
use super::mesh::Cells;
use super::{standing, two};
use crate::FeError;
use crate::estimate::{
    DENSE_RATE, Estimate, FACTOR_RATE, Fill, Lever, NUMBER, PRODUCT_RATE, PROGRAM, Response, SWEEP_RATE, THE_PROGRAM,
    first_wall_frequency,
};
use crate::solid::mesh::check_levels;
use tank::options::nonlinear::{Contact, Damping, Integration, NonlinearOptions, ThicknessRule, WallElements};

/// Unknowns of a node of a shell.
const SHELL: f64 = 5.0;
/// Full matrices over the wetted nodes that the model keeps.
const MODEL_BLOCKS: f64 = 8.5;
/// And those of a march: tangent, effective matrix and damping of half a matrix each, copies of an iteration.
const MARCH_BLOCKS: f64 = 3.2;
/// Bytes of a cell of one shell, its matrices in the model included, without its history.
const CELL: f64 = 20_000.0;
/// Bytes more where the wall stands on its bottom: tangents of the plate apart, of the whole and of the spare factor, finer cells. Measured: 177 MiB with 1 944
/// cells, 394 to 509 MiB with 5 328, 3 248 MiB with 50 200.
const GROUND_CELL: f64 = 30_000.0;
/// Integration points of a cell.
const POINTS: f64 = 4.0;
/// States of the history kept at a time: committed, trial, and a copy to return to.
const STATES: f64 = 3.2;
/// Vectors of an iterative solution, and of the state.
const VECTORS: f64 = 30.0;
/// Products of an iterative solution with bonded liquid, and with joints that open.
const PRODUCTS: [f64; 2] = [1.7, 6.0];
/// Steps of the static start ([`fem::analysis::march::Settings::load_steps`]).
const START: f64 = 5.0;
/// Bytes kept for a byte of a factored section: values alone.
const SECTION: f64 = 1.2;
/// Operations a second of the small factors [1/s].
const SMALL_RATE: f64 = 2e9;
/// Time of a transform of n numbers over n log₂ n, as bytes read.
const TRANSFORM: f64 = 4.0;
/// Iterations of a step of the record, and steps from one factorisation to the next, while the wall stays elastic.
const ITERATIONS: f64 = 3.5;
const KEPT: f64 = 30.0;
/// Iterations of a step of a wall on its bottom, those from one factor of plate and ground to the next, and those of a step of its static
/// start; bytes of a number of its factors (docs/performance.md, tank of R = 17.5 m: 29 100 iterations and 4 800 factors in 4 270 steps of which half lift far).
const GROUND_ITERATIONS: f64 = 6.0;
const RENEWED: f64 = 6.0;
const SINGLE: f64 = 4.0;
const GROUND_START: f64 = 12.0;
/// Unknowns of the foot and of the liquid's floor at a meridian.
const SEAM: f64 = 11.0;
/// Solutions with the factors in an iteration, beside a product with the tangent each.
const GUIDED: f64 = 2.5;
/// The same of a step of free vibration in a quiet wall: example 08, 31 ms a step against 57 ms in the record (docs/performance.md).
const QUIET_ITERATIONS: f64 = 1.9;
/// Time of a step in which the wall yields or cracks over that of an elastic one: the practical steel tank, 252 s against the 87 s of
/// elastic steps (docs/performance.md). Free vibration is in the upper time with elastic steps of the record: those of the steel tank
/// take 35 ms against 27 ms.
const INELASTIC: f64 = 3.0;
/// Time of a cell without its layers, and of a point of a layer, in one iteration [s]. Points of sections that neither yield nor
/// crack cost little; these are measured where few do.
const CELL_TIME: f64 = 1e-6;
const POINT_TIME: f64 = 4.5e-8;
/// Time of code procedures and linear engine beside the first run [s] (docs/performance.md).
const BESIDE: f64 = 0.14;
/// Sloshing amplitudes of half a cylinder.
const AMPLITUDES: f64 = 24.0;
/// Numbers kept at a sample, without the two of every row.
const AT_SAMPLE: f64 = 60.0;

/// Cost of [`super::simulate`]; with `jobs` > 0 of an incremental analysis of `runs` runs, `jobs` in parallel.
///
/// Errors: no ground motion; a response longer than the limits.
pub(crate) fn estimate(case: &Case, options: &NonlinearOptions, jobs: usize, runs: usize) -> Result<Estimate, FeError> {
    let response = Response::of(case, options.after_record)?.ok_or(FeError::NoRecord)?;
    check_levels(&case.tank, case.liquid.fill_height, 1.0)?;
    let mut found = of(case, options, response, [jobs, runs]);
    if jobs > 1 {
        let fewer = of(case, options, response, [1, runs]);
        found.lever.smaller.push(("use --jobs 1".into(), fewer.bytes(), fewer.seconds));
    }
    let cells = Cells::new(&case.tank, case.liquid.fill_height, options.elements, options.symmetry);
    for part in [0.8, 0.65, 0.5, 0.35, 0.25, 0.15] {
        let elements = WallElements {
            height: ((cells.rows() as f64 * part) as u32).max(2),
            circumference: ((cells.sectors as f64 * part) as u32).max(8).next_multiple_of(2),
        };
        let coarse = NonlinearOptions { elements: Some(elements), ..options.clone() };
        let smaller = of(case, &coarse, response, [jobs, runs]);
        let give = format!(
            "give `analysis.nonlinear.elements` as {{\"height\": {}, \"circumference\": {}}}",
            elements.height, elements.circumference
        );
        found.lever.smaller.push((give, smaller.bytes(), smaller.seconds));
    }
    Ok(found)
}

/// Numbers of a model that its memory and time follow from.
struct Size {
    cells: Cells,
    /// Whether the wall stands on a bottom on the ground, which has rings of cells, too; contact asks for a factor of them in most iterations.
    on_ground: bool,
    rows: f64,
    /// Elements of the wall and the bottom, and shells over each other in the wall.
    number: f64,
    shells: f64,
    unknowns: f64,
    /// Unknowns that the liquid joins.
    wetted: f64,
    /// Numbers that the material points remember.
    history: f64,
    /// Whether no factor joins the liquid to the wall.
    iterated: bool,
    /// Bytes of the liquid's block.
    block: f64,
    shared: Rings,
    /// Factor of the whole, or of plate and ground with the block that the wall leaves on the foot.
    fill: Fill,
}

impl Size {
    fn of(case: &Case, options: &NonlinearOptions) -> Size {
        let depth = case.liquid.fill_height;
        let cells = Cells::new(&case.tank, depth, options.elements, options.symmetry);
        let rings = standing::rings(case, options) as f64;
        let on_ground = rings > 0.0;
        let (rows, columns) = (cells.rows() as f64 + rings, cells.columns() as f64);
        let meridians = columns + if cells.half { 1.0 } else { 0.0 };
        let wetted = cells.wet(depth) as f64 * meridians + AMPLITUDES;
        let shells = leaves(case);
        let node = SHELL * shells;
        let history: f64 = (0..cells.rows())
            .map(|row| {
                let middle = 0.5 * (cells.z[row] + cells.z[row + 1]);
                slots(case.tank.course_at(middle), &options.integration)
            })
            .sum::<f64>()
            * columns;
        let levels = cells.wet(depth) as f64;
        let operator = on_ground || iterates((levels * meridians) as usize, options.contact);
        let iterated = operator && !on_ground;
        let wall = node * if on_ground { cells.rows() as f64 } else { rows };
        let shared = if operator { Rings::new(&cells, levels, wall, options.contact) } else { Rings::default() };
        let fill = match (operator, on_ground) {
            (_, true) => {
                let zone = Fill::grid([meridians, rings, 1.0], node, !cells.half);
                zone.with(1.0, Fill::dense(SEAM * meridians))
            }
            (true, _) => Fill::default(),
            (false, _) => Fill::grid([meridians, rows, 1.0], node, !cells.half).with(1.0, Fill::dense(wetted)),
        };
        Size {
            on_ground,
            rows,
            number: rows * columns,
            shells,
            unknowns: node * rows * meridians + wetted * f64::from(u8::from(options.contact == Contact::Opening)),
            wetted,
            history,
            iterated,
            block: if operator { 0.0 } else { NUMBER * wetted * wetted },
            shared,
            fill,
            cells,
        }
    }

    /// Numbers of the histories.
    fn histories(&self, case: &Case, samples: f64) -> f64 {
        let two = case.ground_motion.as_ref().is_some_and(|motion| motion.transverse.is_some());
        // Hoop and axial stress of the meridians of a fan.
        let meridian = if two { 2.0 * self.rows * two::fan(&self.cells).len() as f64 } else { 0.0 };
        samples * (AT_SAMPLE + 2.0 * self.rows + meridian + 0.5 * self.wetted.min(LOOKS))
    }

    /// Bytes, part by part; `kept` numbers of the histories.
    fn parts(&self, case: &Case, options: &NonlinearOptions, at_a_time: f64, kept: f64) -> Vec<(&'static str, f64)> {
        let (block, number) = (self.block, self.number);
        let depth = case.liquid.fill_height;
        // C of the liquid is another one.
        let damped = matches!(options.damping, Damping::ByGroup { .. });
        let model = block * (MODEL_BLOCKS + if damped { 1.0 } else { 0.0 });
        // One harmonic of the liquid at a time: its mesh over radius and depth, dense in its columns.
        let section = 11.0 * (2.0 * 8.0 * (depth / case.tank.shape.half_length() / 2.7).max(1.0) + 1.0);
        let harmonic = NUMBER * section * (4.0 * (self.cells.wet(depth) as f64 + 11.0) + 100.0);
        let on_ground = |bytes: f64| if self.on_ground { bytes } else { 0.0 };
        vec![
            (THE_PROGRAM, PROGRAM),
            ("liquid block", model + at_a_time * MARCH_BLOCKS * block + self.shared.blocks),
            ("sections of the wall", (1.0 + at_a_time) * self.shared.sections),
            ("open joints", at_a_time * self.shared.joints),
            // A value, and its places.
            ("vectors of the iteration", at_a_time * VECTORS * NUMBER * self.unknowns),
            ("liquid of one harmonic", harmonic),
            ("wall", number * self.shells * CELL * (1.0 + 0.5 * at_a_time)),
            ("matrices of wall and plate", on_ground(at_a_time * GROUND_CELL * number)),
            ("history of the layers", at_a_time * STATES * NUMBER * self.history),
            ("factors", (1.0 + at_a_time) * NUMBER * self.fill.entries),
            ("histories", at_a_time * NUMBER * kept),
        ]
    }

    /// Times of the start, of a step under the record and of one of free vibration [s], of a wall that stays elastic.
    fn times(&self, contact: Contact) -> [f64; 3] {
        let cells = self.number * self.shells;
        let [bonded, opening] = PRODUCTS;
        let products = match contact {
            Contact::Bonded => bonded,
            Contact::Opening => opening,
        };
        let sweep = match self.on_ground {
            true => {
                let factors = 2.0 * SINGLE * self.fill.entries / SWEEP_RATE;
                GUIDED * (factors + self.shared.product(self.unknowns, cells) / PRODUCT_RATE)
            }
            false => {
                let bytes = 3.0 * self.block + 2.0 * NUMBER * self.fill.entries;
                (bytes + products * self.shared.product(self.unknowns, cells)) / PRODUCT_RATE
            }
        };
        let iteration = cells * CELL_TIME + self.history / 12.0 * POINT_TIME + sweep;
        let factor = self.fill.flops / FACTOR_RATE + self.shared.factor;
        match self.on_ground {
            true => {
                let each = GROUND_ITERATIONS * (iteration + factor / RENEWED);
                [START * GROUND_START * (iteration + factor), each, each]
            }
            false => [
                START * (ITERATIONS * iteration + factor),
                ITERATIONS * iteration + factor / KEPT,
                QUIET_ITERATIONS * iteration,
            ],
        }
    }
}

/// Adds the states for pictures, `every` [s] apart; a scene mirrors half a tank.
///
/// Errors: a response longer than the limits.
pub(crate) fn add_states(
    found: &mut Estimate,
    case: &Case,
    options: &NonlinearOptions,
    every: f64,
) -> Result<(), FeError> {
    if let Some(response) = Response::of(case, options.after_record)? {
        let size = Size::of(case, options);
        let count = ((response.duration + response.tail) / every).floor() + 1.0;
        let numbers = (3.0 * size.shells + 7.0) * size.number;
        found.parts.push((
            "states for pictures (--vtu-every)",
            NUMBER * count * numbers * if size.cells.half { 3.0 } else { 1.0 },
        ));
        found.lever.other.push_str(", or give a longer --vtu-every");
    }
    Ok(())
}

fn of(case: &Case, options: &NonlinearOptions, response: Response, [jobs, runs]: [usize; 2]) -> Estimate {
    let size = Size::of(case, options);
    let at_a_time = jobs.max(1).min(runs.max(1)) as f64;
    let usual = || usual_step(case, std::f64::consts::TAU / first_wall_frequency(case), response.dt);
    let step = options.time_step.unwrap_or_else(usual);
    let samples = response.samples();
    // A whole number of steps in a sample.
    let steps = samples * (response.dt / step - 1e-9).ceil().max(1.0);
    let free = steps * response.tail / (response.duration + response.tail);
    let [start, elastic, quiet] = size.times(options.contact);
    let all = |record: f64, tail: f64| {
        let once = start + (steps - free) * record + free * tail;
        // A history on isolators may be found in two runs.
        let runs = if jobs == 0 && case.tank.isolators.is_some() { 2 } else { runs.max(1) };
        BESIDE + once * runs as f64 + 2.0 * (size.block / NUMBER).powf(1.5) / DENSE_RATE
    };
    let of_runs = if jobs > 0 { format!(", {runs} runs, {at_a_time:.0} at a time") } else { String::new() };
    let (rows, unknowns, wetted) = (size.rows, size.unknowns, size.wetted);
    Estimate {
        run: "nonlinear run",
        size: format!(
            "{rows:.0} x {} elements, {unknowns:.0} unknowns, {wetted:.0} of them joined by the liquid{}, {steps:.0} steps{of_runs}",
            size.cells.sectors,
            if size.iterated { " (iterated)" } else { "" }
        ),
        parts: size.parts(case, options, at_a_time, size.histories(case, samples)),
        samples,
        steps,
        seconds: all(elastic, quiet),
        inelastic: Some(all(INELASTIC * elastic, elastic)),
        lever: Lever { smaller: Vec::new(), other: "coarsen the wall (`analysis.nonlinear.elements`)".into() },
    }
}

/// Liquid and preconditioner by circumferential harmonics.
#[derive(Clone, Copy, Debug, Default)]
struct Rings {
    /// Bytes of the liquid's blocks, and of those that they are made from.
    blocks: f64,
    /// Bytes of the factored sections.
    sections: f64,
    /// Bytes of the compliances of open joints.
    joints: f64,
    /// Time of one factorisation of all of them [s].
    factor: f64,
    /// Entries read in a product with the liquid and a solution with the sections.
    entries: f64,
    /// Operations of the transforms.
    transforms: f64,
}

impl Rings {
    /// * `levels`: of wetted nodes; `section`: unknowns of a meridian
    fn new(cells: &Cells, levels: f64, section: f64, contact: Contact) -> Rings {
        let sectors = cells.sectors as f64;
        let harmonics = 0.5 * sectors + 1.0;
        let families = if cells.half { 1.0 } else { 2.0 };
        let joined = levels + AMPLITUDES / 2.0;
        // All but the joined unknowns are eliminated from the base upwards: on the average half of the joined ones are below.
        let factor = 0.5 * joined * joined + 0.5 * (section - levels) * joined;
        let flops = joined.powi(3) / 3.0 + (section - levels) * joined * joined / 3.0;
        // Matrix, its factor and that of the tangent before; by harmonic and by angle for every pair of levels.
        let open = (levels * cells.columns() as f64).min(OPEN_AT_MOST as f64);
        let joints = match contact {
            Contact::Bonded => 0.0,
            Contact::Opening => NUMBER * (3.0 * open * open + 0.5 * levels * levels * (harmonics + sectors)),
        };
        Rings {
            joints,
            blocks: 4.0 * NUMBER * harmonics * joined * joined,
            sections: SECTION * NUMBER * harmonics * factor,
            factor: harmonics * flops / SMALL_RATE,
            entries: harmonics * families * (joined * joined + 2.0 * factor),
            transforms: 2.0 * (section + levels) * TRANSFORM * sectors * sectors.log2(),
        }
    }

    /// Bytes, or operations of the same time, of one product: sparse matrix of the wall, liquid, preconditioner.
    fn product(&self, unknowns: f64, cells: f64) -> f64 {
        match self.entries {
            0.0 => 0.0,
            // Half a matrix of 20 x 20 a cell, with its indices; nine vectors.
            entries => 2.0 * NUMBER * 120.0 * cells + NUMBER * (entries + 9.0 * unknowns) + self.transforms,
        }
    }
}

/// Shells in the wall: two where there is a layer between them.
pub(crate) fn leaves(case: &Case) -> f64 {
    let between = |layer: &Layer| matches!(layer.kind, LayerKind::Interlayer);
    let two = case.tank.courses.iter().any(|c| c.build_up().iter().any(between));
    if two { 2.0 } else { 1.0 }
}

/// Numbers that the points of a cell remember.
pub(crate) fn slots(course: &Course, integration: &Integration) -> f64 {
    let points = |rule: ThicknessRule| {
        let (ThicknessRule::Gauss(n)
        | ThicknessRule::Lobatto(n)
        | ThicknessRule::MidPoint(n)
        | ThicknessRule::Simpson(n)
        | ThicknessRule::Trapezoid(n)) = rule;
        f64::from(n)
    };
    let of = |layer: &Layer| {
        let bars = 2.0 * layer.reinforcement.len() as f64;
        bars + match layer.material.behaviour {
            Behaviour::Steel(_) => 7.0 * points(integration.steel),
            Behaviour::Concrete(_) => 17.0 * points(integration.concrete),
            _ => 0.0,
        }
    };
    POINTS * course.build_up().iter().map(of).sum::<f64>()
}
