//! Cells of the wall of a cylinder.

use std::f64::consts::{PI, TAU};

use tank::Tank;

use crate::solid::mesh::wall_levels;
use tank::options::nonlinear::WallElements;

/// Default number of sectors of the full circle.
const SECTORS: usize = 72;

/// Cells of the wall.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cells {
    /// Heights of the levels of nodes [m], from 0 to the top; the surface and every joint of courses is one.
    pub z: Vec<f64>,
    /// Sectors of the full circle.
    pub sectors: usize,
    /// Whether only 0 ≤ θ ≤ π is computed.
    pub half: bool,
}

/// Levels of the coarsest `rows(refine)` that has `count` rows: their number grows with the refinement, if not evenly.
pub(crate) fn enough_rows(rows: impl Fn(f64) -> Vec<f64>, count: usize) -> Vec<f64> {
    let (mut low, mut high) = (1e-3, 1.0);
    while rows(high).len() <= count && high < 1e4 {
        high *= 2.0;
    }
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if rows(middle).len() > count {
            high = middle;
        } else {
            low = middle;
        }
    }
    rows(high)
}

impl Cells {
    /// Cells of a tank filled to `depth` [m]: as many as given, or by the length √(R t) of the bending at an edge,
    /// finer towards the base and the changes of the wall in both cases.
    ///
    /// With `symmetry` an odd number of sectors is raised by one.
    pub(crate) fn new(tank: &Tank, depth: f64, wanted: Option<WallElements>, symmetry: bool) -> Cells {
        let rows = |refine: f64| wall_levels(tank, depth, refine);
        let z = wanted.map_or_else(|| rows(1.0), |wanted| enough_rows(rows, wanted.height as usize));
        let sectors = wanted.map_or(SECTORS, |w| w.circumference as usize);
        Cells { z, sectors: if symmetry { sectors.next_multiple_of(2) } else { sectors }, half: symmetry }
    }

    /// Angle of a sector [rad].
    pub(crate) fn angle(&self) -> f64 {
        TAU / self.sectors as f64
    }

    /// Number of sectors computed.
    pub(crate) fn columns(&self) -> usize {
        if self.half { self.sectors / 2 } else { self.sectors }
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.z.len() - 1
    }

    /// Angle computed [rad].
    pub(crate) fn span(&self) -> f64 {
        if self.half { PI } else { TAU }
    }

    /// Edges of the columns [rad].
    pub(crate) fn edges(&self) -> Vec<f64> {
        (0..=self.columns()).map(|k| self.angle() * k as f64).collect()
    }

    /// Number of levels of nodes up to the surface at `depth` [m].
    pub(crate) fn wet(&self, depth: f64) -> usize {
        self.z.iter().filter(|z| **z <= depth * (1.0 + 1e-9)).count()
    }

    /// Factor from the computed part to the whole tank.
    pub(crate) fn copies(&self) -> f64 {
        if self.half { 2.0 } else { 1.0 }
    }
}
