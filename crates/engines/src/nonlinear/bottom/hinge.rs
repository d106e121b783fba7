//! Plastic rotations of the plate and of the wall at their joint.

use fem::analysis::AnalysisError;
use fem::element::Inspect;
use fem::model::Model;
use fem::state::{Gather, State};
use tank::Tank;

use super::Placed;

/// Sign of the plastic curvature that a plate has at its joint when it lifts.
const LIFTS: f64 = 1.0;

/// Plastic rotation of the plate at its joint, at the `back` (θ = π) or at θ = 0, positive where the plate lifts [rad], by [`hinge`].
///
/// Errors: a section that fails.
pub(in crate::nonlinear) fn plastic_rotation(
    model: &Model,
    bottom: &Placed,
    foot: usize,
    back: bool,
    state: &State,
) -> Result<f64, AnalysisError> {
    let cells = bottom.cells[foot..].iter().filter_map(|ring| if back { ring.last() } else { ring.first() });
    let sum = hinge(model, cells.map(|&cell| (cell, bottom.soft(cell))), state)?;
    Ok(LIFTS * sum)
}

/// That of the wall at its joint, positive where it turns with a plate that lifts [rad]: normals of a wall point outwards, those of the plate
/// upwards, and along the meridian, round the corner, their curvatures have opposite signs.
///
/// * `cells`: elements of a column from the foot on, with [`wall_bending`]
///
/// Errors: a section that fails.
pub(in crate::nonlinear) fn wall_rotation(
    model: &Model,
    cells: impl Iterator<Item = (usize, [f64; 2])>,
    state: &State,
) -> Result<f64, AnalysisError> {
    Ok(-LIFTS * hinge(model, cells, state)?)
}

/// Plastic rotation of shells along a meridian from the joint on: curvature of the meridian less that of an elastic shell under its moments,
/// from the first cell that yields to where its sign changes or nothing yields; its sign is that of the curvature [rad].
///
/// * `cells`: elements, the first at the joint, with 1/D′ and ν/D′, D′ = E t³/12 [1/(N m)]; their second local axis is the meridian
///
/// Errors: a section that fails.
pub(in crate::nonlinear) fn hinge(
    model: &Model,
    cells: impl Iterator<Item = (usize, [f64; 2])>,
    state: &State,
) -> Result<f64, AnalysisError> {
    let mut sum = 0.0_f64;
    for (cell, soft) in cells {
        let Some(part) = plastic_part(model, cell, soft, state)? else {
            if sum != 0.0 {
                break;
            }
            continue;
        };
        if sum * part < 0.0 {
            break;
        }
        sum += part;
    }
    Ok(sum)
}

/// 1/D′ and ν/D′ of the wall at a height [m], as in [`hinge`] [1/(N m)].
pub(in crate::nonlinear) fn wall_bending(tank: &Tank, height: f64) -> [f64; 2] {
    let course = tank.course_at(height);
    let soft = 12.0 / (course.material.youngs_modulus * course.thickness.powi(3));
    [soft, course.material.poisson_ratio * soft]
}

/// Plastic rotation across a cell along the meridian [rad]; none of a cell that has not yielded. `soft`: as in [`hinge`].
///
/// Errors: a section that fails.
pub(in crate::nonlinear) fn plastic_part(
    model: &Model,
    cell: usize,
    soft: [f64; 2],
    state: &State,
) -> Result<Option<f64>, AnalysisError> {
    let mut gather = Gather::default();
    let element = &*model.elements()[cell];
    let motion = gather.motion(model, &state.committed, element);
    let history = &state.old[state.history(cell)];
    let mut yields = false;
    element.material_points(motion, history, &mut |p| yields |= p.state.plastic_strain > 0.0);
    if !yields {
        return Ok(None);
    }
    let sections =
        element.sections(motion, history).map_err(|source| AnalysisError::Element { number: cell, source })?;
    let plastic = |s: &fem::element::SectionState| {
        let (hoop, along) = (s.resultants[3], s.resultants[4]);
        s.strain[4] - (soft[0] * along - soft[1] * hoop)
    };
    let mean = sections.iter().map(plastic).sum::<f64>() / sections.len() as f64;
    // Rings and levels: a plate extends over the radius, a wall over the height.
    let corners = element.nodes().iter().map(|&n| model.nodes()[n]);
    let extent = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |e, v| (e.0.min(v), e.1.max(v)));
        high - low
    };
    let along = extent(&mut corners.clone().map(|x| x[0].hypot(x[1])));
    Ok(Some(mean * along.hypot(extent(&mut corners.map(|x| x[2])))))
}
