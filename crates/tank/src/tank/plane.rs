//! Where a plane strip stands for the walls of a box.

use super::{Shape, Tank};

/// Breadth over the height of the wall from which a strip, whose walls are cantilevers, has the moments and the frequencies of walls
/// held at their sides as well within 10 %.
///
/// Source: `docs/theory/limit-states-of-runs.md`, "Walls held at three sides".
pub const PLANE_WALLS: f64 = 7.0;

impl Tank {
    /// Breadth of a box over the height of its wall; none for a cylinder or a strip of a long tank.
    pub fn breadth_to_height(&self) -> Option<f64> {
        match self.shape {
            Shape::Rectangle { breadth, strip: false, .. } => Some(breadth / self.wall_height()),
            _ => None,
        }
    }

    /// Whether the walls across the shaking bend as plates held at their sides, not as cantilevers: a box less broad than
    /// [`PLANE_WALLS`] times its height.
    pub fn bends_as_plates(&self) -> bool {
        self.breadth_to_height().is_some_and(|ratio| ratio < PLANE_WALLS)
    }
}
