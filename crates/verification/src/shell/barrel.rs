//! Part of a cylinder: the mesh of several benchmarks.

use super::Grid;
use fem::element::shell4::Axes;
use fem::model::Builder;

/// Hoop axes about the y axis: rotation frames are (hoop, y, radius).
pub(super) const ABOUT_Y: Axes = Axes::Hoop { origin: [0.0; 3], axis: [0.0, 1.0, 0.0] };

/// Part of a cylinder about y: from the end y = 0 to `length`, angle from the z axis `from` to `to`.
pub(super) fn barrel(n: usize, radius: f64, length: f64, to: f64) -> (Grid, Builder) {
    // i along the angle, j along y: hoop × y is the radius.
    let grid = Grid::new(n, n);
    let mut builder = Builder::new();
    grid.nodes(&mut builder, |a, b| {
        let (s, c) = (to * a).sin_cos();
        [radius * s, length * b, radius * c]
    });
    (grid, builder)
}
