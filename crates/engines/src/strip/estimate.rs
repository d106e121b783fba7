//! Memory and time of a nonlinear run of a strip: little for the wall, most for the histories of both walls step by step.

use tank::{Case, Shape};

use super::case::{ELEMENTS, STEPS_PER_PERIOD};
use super::section::course_at;
use crate::FeError;
use crate::estimate::{Estimate, Lever, NUMBER, PROGRAM, Response, THE_PROGRAM, first_wall_frequency};
use crate::nonlinear::cylinder::estimate::slots;
use tank::options::nonlinear::{Contact, LiquidForm, NonlinearOptions, StripWall};

/// Numbers that a step of a wall leaves behind: seven histories, time, energies, pressures that are followed.
const AT_STEP: f64 = 18.0;
/// Numbers of a sample: columns of the results, as text too.
const AT_SAMPLE: f64 = 60.0;
/// Iterations of a step.
const ITERATIONS: f64 = 2.2;
/// Time of a beam without its fibres, and of a fibre, in one iteration [s]: example 06 with 20 and 60 layers (docs/performance.md). Cracks
/// do not change it: 3.5 s under 0.05 and 0.4 times the record, 3.7 s under the whole.
const BEAM_TIME: f64 = 1.25e-6;
const FIBRE_TIME: f64 = 3.75e-8;
/// Time of an element of two shells and a layer without its layers of concrete, and of a layer of concrete at a point, in one iteration [s],
/// and bytes of such an element in the model: example 06 with 5 to 60 layers (processor time), and with 20 to 160 elements (resident memory).
const SHELL_TIME: f64 = 1e-5;
const LAYER_TIME: f64 = 6e-8;
const SHELL: f64 = 900_000.0;
/// Numbers a fibre remembers on average, those of [`slots`].
const FIBRE: f64 = 4.0 * 17.0;
/// Operations a second of a dense factorisation on one core.
const FLOPS: f64 = 5e9;
/// Dense blocks of a wall: stiffness and mass of the liquid, effective matrix, factor.
const BLOCKS: f64 = 4.0;
/// Time of an element of a displacement liquid in one iteration [s]: bonded, the factor kept; with joints that open, a factor each time. Example 06 with
/// 240 elements: 12 and 72 s. Bytes of such an element in the model, with 240 and 960 of them.
const CELL_TIME: [f64; 2] = [1.5e-6, 4.5e-6];
const CELL: f64 = 20_000.0;
/// Bytes of a beam in the model: section, element, matrices.
const BEAM: f64 = 20_000.0;

/// Cost of [`super::simulate`]; with `jobs` > 0 of `runs` runs of an incremental analysis, `jobs` in parallel.
///
/// Errors: no ground motion; a response longer than the limits.
pub(crate) fn estimate(case: &Case, options: &NonlinearOptions, jobs: usize, runs: usize) -> Result<Estimate, FeError> {
    let response = Response::of(case, options.after_record)?.ok_or(FeError::NoRecord)?;
    let beams = f64::from(options.elements.map_or(ELEMENTS, |e| e.height));
    let step = options.time_step.unwrap_or_else(|| {
        (std::f64::consts::TAU / first_wall_frequency(case) / STEPS_PER_PERIOD).min(0.5 * response.dt)
    });
    let samples = response.samples();
    let steps = samples * (response.dt / step - 1e-9).ceil().max(1.0);
    let middle = course_at(case, 0.5 * case.tank.wall_height());
    let fibres = slots(middle, &options.integration) / FIBRE;
    let at_a_time = jobs.max(1).min(runs.max(1)) as f64;
    let walls = 2.0;
    // The liquid couples deflection and slope of all wetted nodes: one dense block, factored in every iteration.
    let coupled = 2.0 * beams * (case.liquid.fill_height / case.tank.wall_height()).min(1.0);
    // Shells couple both edges of the wet face: as many unknowns.
    let [element, section, bytes] = match options.wall {
        StripWall::Fibre => [BEAM_TIME, 2.0 * FIBRE_TIME, BEAM],
        StripWall::Shell => [SHELL_TIME, 4.0 * LAYER_TIME, SHELL],
    };
    let wet = (beams * case.liquid.fill_height / case.tank.wall_height()).max(1.0);
    let cells = match (options.liquid, case.tank.shape) {
        (LiquidForm::Displacement, Shape::Rectangle { length, .. }) => {
            wet * options.liquid_elements.map_or(length * wet / case.liquid.fill_height, |half| 2.0 * f64::from(half))
        }
        _ => 0.0,
    };
    let liquid = match cells > 0.0 {
        true => 0.5 * cells * CELL_TIME[usize::from(options.contact == Contact::Opening)],
        false => coupled.powi(3) / 3.0 / FLOPS,
    };
    let iteration = beams * (element + fibres * section) + liquid;
    Ok(Estimate {
        run: "nonlinear run",
        size: format!(
            "{beams:.0} elements over each of two walls, {steps:.0} steps{}",
            if jobs > 0 { format!(", {runs} runs, {at_a_time:.0} at a time") } else { String::new() }
        ),
        parts: vec![
            (THE_PROGRAM, PROGRAM),
            ("wall", beams * bytes),
            ("liquid", at_a_time * walls * NUMBER * BLOCKS * coupled * coupled + cells * CELL),
            ("histories", at_a_time * NUMBER * (walls * AT_STEP * steps + AT_SAMPLE * samples)),
        ],
        samples,
        steps,
        seconds: walls * runs.max(1) as f64 * steps * ITERATIONS * iteration,
        inelastic: None,
        lever: Lever {
            smaller: Vec::new(),
            other: format!(
                "give `analysis.nonlinear.time_step` above {step:.2e} s{}{}",
                if jobs > 1 { ", or use fewer --jobs" } else { "" },
                if response.tail > 0.0 { ", or `after_record` as none" } else { "" }
            ),
        },
    })
}
