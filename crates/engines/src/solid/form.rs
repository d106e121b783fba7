//! The form of wall and liquid: perfect, or out of round.
//!
//! The nodes of the wall lie on the imperfect surface, their directors are its normals. The liquid follows: its nodes move by
//! w (r/R)² along the radius, and its joints with the wall take the area vectors of the imperfect surface, at the angles and heights of
//! the perfect one.

use fem::chart::Chart;
use fem::mesh::{Face, Volume};
use nalgebra::Vector3;
use tank::Case;
use tank::imperfection::{Deviation, Imperfections};

use crate::out_of_round::{area, place};

/// The form of a tank.
pub(super) struct Form<'a> {
    /// Radius of the perfect tank [m]; of a rectangle, which has no deviations, half its length.
    pub radius: f64,
    /// Height of the wall [m].
    pub height: f64,
    /// Deviations.
    pub imperfections: &'a Imperfections,
    /// Whether the liquid follows the wall; else it is that of the perfect tank.
    pub wet: bool,
}

impl<'a> Form<'a> {
    /// Form of the tank of a case, with a liquid that follows the wall.
    pub(super) fn of(case: &Case, imperfections: &'a Imperfections) -> Form<'a> {
        Form { radius: case.tank.shape.half_length(), height: case.tank.wall_height(), imperfections, wet: true }
    }

    /// The deviation at a point of the perfect wall, with its angle; `None` of a perfect tank.
    fn at(&self, point: [f64; 3]) -> Option<(f64, Deviation)> {
        let theta = point[1].atan2(point[0]);
        (!self.imperfections.is_empty()).then(|| (theta, self.imperfections.at(theta, point[2], self.height)))
    }

    /// The place of a point of the perfect wall.
    pub(super) fn moved(&self, point: [f64; 3]) -> [f64; 3] {
        match self.at(point) {
            None => point,
            Some((theta, deviation)) => (Vector3::from(point) + place(self.radius, theta, deviation).0).into(),
        }
    }

    /// Unit normal at a point of the perfect wall.
    pub(super) fn normal(&self, point: [f64; 3]) -> Vector3<f64> {
        match self.at(point) {
            None => Vector3::new(point[0], point[1], 0.0).normalize(),
            Some((theta, deviation)) => place(self.radius, theta, deviation).1.normalize(),
        }
    }

    /// Area vectors at the corners of a face of the wall over its perfect area; `None` where the liquid is that of the perfect tank.
    pub(super) fn area_vectors(&self, face: &Face) -> Option<[[f64; 3]; 4]> {
        (self.wet && !self.imperfections.is_empty()).then(|| {
            face.chart.map(|[_, theta, z]| area(self.radius, theta, self.imperfections.at(theta, z, self.height)))
        })
    }

    /// Moves the liquid with the wall, but for the faces at the wall.
    pub(super) fn deform(&self, volume: &mut Volume) {
        if !self.wet || self.imperfections.is_empty() {
            return;
        }
        let moved = |[r, theta, z]: [f64; 3]| {
            let w = self.imperfections.at(theta, z, self.height).w;
            [r + w * (r / self.radius).powi(2), theta, z]
        };
        for node in &mut volume.nodes {
            let chart = [node[0].hypot(node[1]), node[1].atan2(node[0]), node[2]];
            *node = Chart::Cylindrical.position(moved(chart));
        }
        let cells = volume.cells.iter_mut().flat_map(|cell| &mut cell.chart);
        let faces = volume.bottom.iter_mut().chain(&mut volume.surface);
        for chart in cells.chain(faces.flat_map(|face| &mut face.chart)) {
            *chart = moved(*chart);
        }
    }
}
