//! Memory and time of a pushover: half a wall of shells (with its bottom where it is unanchored), and a path of a limited number of states.

use tank::{Case, Shape, Support};

use super::PushOptions;
use super::model::{BASE, SECTORS};
use super::path::STATES;
use crate::FeError;
use crate::checks::check_depth;
use crate::estimate::{Estimate, FACTOR_RATE, Fill, Lever, NUMBER, PROGRAM, SWEEP_RATE, THE_PROGRAM};
use crate::nonlinear::bottom::Plate;
use crate::nonlinear::cylinder::estimate::slots;
use crate::nonlinear::cylinder::mesh::enough_rows;
use crate::solid::mesh::{based_levels, check_levels};
use tank::options::nonlinear::{NonlinearOptions, WallElements};

/// Unknowns of a node.
const NODE: f64 = 5.0;
/// Bytes of a cell with its matrices.
const CELL: f64 = 26_000.0;
/// States of the history kept at a time.
const HISTORIES: f64 = 4.0;
/// Iterations of a state with those of steps that were cut, each with a factorisation.
const ITERATIONS: f64 = 20.0;
/// Time of a cell without its layers, and of a point of a layer, in one iteration [s].
const CELL_TIME: f64 = 1.2e-5;
const POINT_TIME: f64 = 2.5e-7;
/// Numbers of a state that are kept, over the nodes of the wall.
const SEEN: f64 = 4.0;

/// Memory and time of [`super::pushover`].
///
/// Errors: a liquid too shallow for finite elements.
pub fn estimate(case: &Case, options: &NonlinearOptions, push: &PushOptions) -> Result<Estimate, FeError> {
    check_depth(case)?;
    // Twice as fine at the base as the rule that is counted: a factor below two in all.
    check_levels(&case.tank, case.liquid.fill_height, 1.0)?;
    let rows = |refine: f64| based_levels(&case.tank, case.liquid.fill_height, BASE, refine);
    let (height, sectors) = match options.elements {
        Some(elements) => (enough_rows(rows, elements.height as usize).len() - 1, elements.circumference),
        None => (rows(1.0).len() - 1, SECTORS),
    };
    // The plates alone decide how many rings the bottom has.
    let rings = match (case.tank.support, case.tank.shape) {
        (Support::Unanchored, Shape::Cylinder { radius }) => {
            Plate::of(case, radius, options.bottom_mesh)?.radii.len() - 1
        }
        _ => 0,
    };
    let of = |height: f64, sectors: f64| of(case, options, push, height + rings as f64, sectors);
    let mut found = of(height as f64, f64::from(sectors));
    for part in [0.8, 0.65, 0.5, 0.35, 0.25, 0.15, 0.1] {
        let elements = WallElements {
            height: ((height as f64 * part) as u32).max(4),
            circumference: ((f64::from(sectors) * part) as u32).max(8).next_multiple_of(2),
        };
        let smaller = of(f64::from(elements.height), f64::from(elements.circumference));
        let give = format!(
            "give `analysis.nonlinear.elements` as {{\"height\": {}, \"circumference\": {}}}",
            elements.height, elements.circumference
        );
        found.lever.smaller.push((give, smaller.bytes(), smaller.seconds));
    }
    Ok(found)
}

fn of(case: &Case, options: &NonlinearOptions, push: &PushOptions, rows: f64, sectors: f64) -> Estimate {
    let columns = 0.5 * sectors;
    let nodes = (columns + 1.0) * rows;
    let cells = columns * rows;
    let fill = Fill::grid([columns + 1.0, rows, 1.0], NODE, false);
    let each = case.tank.courses.iter().map(|c| slots(c, &options.integration) * c.height);
    let history = cells * each.sum::<f64>() / case.tank.wall_height();
    let shells = if push.imperfection.is_some() { 2.0 } else { 1.0 };
    let iteration = cells * CELL_TIME
        + history / 7.0 * POINT_TIME
        + fill.flops / FACTOR_RATE
        + 4.0 * NUMBER * fill.entries / SWEEP_RATE;
    Estimate {
        run: "pushover",
        size: format!(
            "{rows:.0} x {sectors:.0} elements, half of them computed, {:.0} unknowns, up to {STATES} states of {shells:.0} \
             shell(s)",
            NODE * nodes
        ),
        parts: vec![
            (THE_PROGRAM, PROGRAM),
            ("wall", cells * CELL),
            ("history of the layers", HISTORIES * NUMBER * history),
            ("factors", 2.0 * NUMBER * fill.entries),
            ("states", shells * NUMBER * SEEN * STATES as f64 * nodes),
        ],
        samples: 0.0,
        steps: shells * STATES as f64,
        seconds: shells * STATES as f64 * ITERATIONS * iteration,
        inelastic: None,
        lever: Lever { smaller: Vec::new(), other: "coarsen the wall (`analysis.nonlinear.elements`)".into() },
    }
}
