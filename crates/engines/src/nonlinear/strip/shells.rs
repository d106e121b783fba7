//! From the layers of a wall to the shells of its strip: those of the cylinder, one element across.

use fem::strip::{ShellRow, ShellWall};
use tank::{Behaviour, Case, Layer, LayerKind};

use super::super::cylinder::section::{Part, row};
use super::super::laws::unsupported;
use super::section::{course_at, main_leaf};
use crate::FeError;
use tank::options::nonlinear::Integration;

/// Shells of a wall with nodes at `levels` [m].
///
/// Errors: layers or laws that shells do not have; a leaf that bends on another side, or another distance between leaves, from
/// course to course.
pub(super) fn wall(case: &Case, levels: &[f64], integration: &Integration) -> Result<ShellWall, FeError> {
    let mut found: Option<ShellWall> = None;
    for ends in levels.windows(2) {
        let layers = course_at(case, 0.5 * (ends[0] + ends[1])).build_up();
        let (own, main, gap) = shell_row(&layers, ends[1] - ends[0], integration)?;
        let wall = found.get_or_insert_with(|| ShellWall {
            rows: Vec::new(),
            main,
            gap,
        });
        if wall.main != main || (wall.gap - gap).abs() > 1e-9 * levels[levels.len() - 1] {
            return unsupported(
                "courses of a strip of shells have the same number of leaves at the same distance between their middles",
            );
        }
        wall.rows.push(own);
    }
    match found {
        Some(wall) => Ok(wall),
        None => unsupported("a wall without elements"),
    }
}

/// Shells of an element of this length [m]; number of the leaf that bends, and distance of the leaves [m].
///
/// Errors: layers or laws that shells do not have.
pub(crate) fn shell_row(
    layers: &[Layer],
    element: f64,
    integration: &Integration,
) -> Result<(ShellRow, usize, f64), FeError> {
    // What localises does so up the wall: the breadth of 1 m has no part in it.
    let row = row(layers, [element; 2], integration)?;
    let main = main_leaf(layers)?;
    let leaves = layers.split(|l| l.kind == LayerKind::Interlayer);
    let number = leaves.take_while(|leaf| !std::ptr::eq(*leaf, main)).count();
    let parts = row.parts.get(number).into_iter().flatten();
    let own = ShellRow {
        build: row.build,
        layers: parts.filter(|p| !matches!(p, Part::Bar(_))).count(),
    };
    Ok((own, number, row.gap))
}

/// The wall as if it stayed elastic and had no bars: mass and stiffness of the fibre section beside the shells.
pub(super) fn elastic(layers: &[Layer]) -> Vec<Layer> {
    let mut out = layers.to_vec();
    for layer in out.iter_mut().filter(|l| l.kind != LayerKind::Interlayer) {
        layer.reinforcement.clear();
        layer.material.behaviour = Behaviour::Elastic;
    }
    out
}
