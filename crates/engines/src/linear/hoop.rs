//! Where the hoop stress of the motion is largest.

use tank::units::{Dimension, display};

use super::analysis::Analysis;
use super::model::Model;
use results::channel::OnWall;

/// Stress above the surface over that below it from which it is said.
const MORE: f64 = 1.05;

/// Largest dynamic hoop stress [Pa] with its height [m]: the upper edge of a wall without a ring can swing with the mass of its roof and hide
/// what the liquid does.
pub(super) struct Hoop {
    /// Anywhere.
    pub largest: (f64, f64),
    /// Not above the surface at rest.
    pub wetted: (f64, f64),
}

impl Hoop {
    /// * `fill`: height of the surface at rest [m]
    pub(super) fn of(analysis: &Analysis<'_>, model: &Model, fill: f64) -> Hoop {
        let heights = model
            .horizontal
            .coupled
            .line(OnWall::Hoop)
            .map(|line| line.z.as_slice());
        let peaks = analysis.line(OnWall::Hoop).zip(heights);
        let found = |top: f64| {
            let places = peaks
                .iter()
                .flat_map(|(line, z)| (0..z.len()).map(|i| (line.peak(i), z[i])));
            let below = places.filter(|(_, z)| *z <= top);
            below.fold((0.0, 0.0), |most: (f64, f64), at| if at.0 > most.0 { at } else { most })
        };
        Hoop {
            largest: found(f64::INFINITY),
            wetted: found(fill),
        }
    }

    /// That the largest is above the surface, where it is larger by more than a twentieth.
    pub(super) fn note(&self) -> Option<String> {
        let (largest, wetted) = (self.largest, self.wetted);
        (largest.0 > MORE * wetted.0).then(|| {
            format!(
                "The hoop stress of the motion is largest above the surface at rest, {} at z = {}, where the wall swings with its edge and \
                 roof; below it the largest is {} at z = {}. The procedures know hoop stress from pressure only.",
                display(largest.0, Dimension::Stress),
                display(largest.1, Dimension::Length),
                display(wetted.0, Dimension::Stress),
                display(wetted.1, Dimension::Length)
            )
        })
    }
}
