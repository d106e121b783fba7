//! Rings of nodes of a wall on equally spaced meridians.

use fem::element::wall::place::{Footprint, PlacedWall};
use fem::model::Builder;
use fem::ring::{NodeRings, Ring};
use nalgebra::Matrix3;

use super::floor::LiquidFloor;
use super::mesh::Cells;
use crate::FeError;

/// Names the rings of nodes of a wall on equally spaced meridians, which get cylindrical frames, and those of the liquid's floor.
///
/// Errors: fewer than three sectors.
pub(super) fn name_rings(
    builder: &mut Builder,
    footprint: &Footprint,
    wall: &PlacedWall,
    wetted: &[usize],
    cells: &Cells,
    floor: Option<&LiquidFloor>,
) -> Result<(), FeError> {
    let ring = Ring::new(cells.sectors, cells.half)
        .ok_or_else(|| FeError::Unsupported("the wall has too few sectors".into()))?;
    let mut nodes: Vec<Vec<usize>> = Vec::new();
    for level in &footprint.levels {
        for side in [&wall.inner, &wall.outer] {
            let own: Vec<usize> = level.iter().filter_map(|&p| side.get(p).copied()).collect();
            for (&node, &point) in own.iter().zip(level) {
                let [c, s, _] = footprint.normals[point];
                builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
            }
            if !own.is_empty() {
                nodes.push(own);
            }
        }
    }
    // A face of the liquid's own.
    if wetted.first() != wall.inner.get(footprint.levels[0][0]) {
        nodes.extend(wetted.chunks(footprint.levels[0].len()).map(<[usize]>::to_vec));
    }
    let meridians = footprint.levels[0].len();
    nodes.extend(floor.iter().flat_map(|floor| floor.nodes.chunks(meridians)).map(<[usize]>::to_vec));
    builder.rings(NodeRings { ring, nodes });
    Ok(())
}
