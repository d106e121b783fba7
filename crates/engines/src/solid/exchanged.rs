//! Motion of a box along y: that along x of the box with length and breadth exchanged.

use tank::Shape;
use tank::case::{Case, Site};
use tank::options::solid::{MeshSize, SolidOptions};

/// Assumption of a box under two horizontal components.
pub(super) const TWO_DIRECTIONS: &str = "Two horizontal components of a box: each excites motions of one symmetry, whose responses add at every \
    instant. The middles of the walls take one of them each; wave and horizontal moment of the corners take both, forces on the base their \
    resultant. Stresses and pressures between the middle of a wall and its corner are not searched; pictures show the motion along x.";

/// The box whose motion along x is that along y of a box under two horizontal components, turned by 90°, with its mesh; half length and
/// half breadth of the box itself [m]. None of other cases.
pub(super) fn exchanged(case: &Case, solid: &SolidOptions) -> Option<(Case, SolidOptions, [f64; 2])> {
    case.ground_motion.as_ref()?.transverse.as_ref()?;
    let Shape::Rectangle { length, breadth, strip } = case.tank.shape else { return None };
    let (mut other, mut own) = (case.clone(), solid.clone());
    // Its modes see records alone.
    other.site = Site::default();
    other.tank.shape = Shape::Rectangle { length: breadth, breadth: length, strip };
    own.mesh = solid.mesh.map(|size| MeshSize { radial: size.sectors / 2, sectors: 2 * size.radial, ..size });
    Some((other, own, [0.5 * length, 0.5 * breadth]))
}
