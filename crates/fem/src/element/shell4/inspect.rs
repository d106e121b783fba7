//! Output of a shell: resultants as linear functions of its dofs, sections and material points of a state.

use nalgebra::Vector3;

use super::rows::{Row, SIZE};
use super::turn::Turn;
use super::{RESULTANTS, Shell4};
use crate::element::shell::geometry::{Point, blend};
use crate::element::shell::section::SectionResponse;
use crate::element::{ElementError, Inspect, Inspection, Motion, Sample, SectionState};

impl Shell4 {
    /// From the frame of a point to the shell's axes.
    pub(super) fn turn(&self, p: &Point) -> Turn {
        let first = self.axes.first(blend(&p.n, &self.x), p.axis(2));
        first.map_or(Turn::NONE, |e| Turn::new(e.dot(&p.axis(0)), e.dot(&p.axis(1))))
    }

    /// Axes 1 and 2 of the section at a point, in the reference state.
    fn section_axes(&self, p: &Point) -> [Vector3<f64>; 2] {
        let first = self.axes.first(blend(&p.n, &self.x), p.axis(2)).unwrap_or_else(|| p.axis(0));
        [first, p.axis(2).cross(&first)]
    }

    /// Rows of the resultants at `p` over the local dofs, at the reference state, in the frame of
    /// [`Axes`](super::Axes).
    ///
    /// Errors: those of the section.
    pub fn resultant_rows(&self, p: &Point) -> Result<[Row; 8], ElementError> {
        let reference = self.reference();
        let strains = Self::rows(p, &reference, &self.common(&reference));
        let tangent = self.initial_tangent()?;
        let turn = self.turn(p);
        let mut rows = [[0.0; SIZE]; 8];
        for j in 0..SIZE {
            let strain = turn.strain(&std::array::from_fn(|k| strains[k][j]));
            for (row, c) in rows.iter_mut().zip(&tangent) {
                row[j] = c.iter().zip(&strain).map(|(c, e)| c * e).sum();
            }
        }
        Ok(rows)
    }

    pub(super) fn resultant_samples(&self) -> Vec<Sample> {
        let mut out = Vec::with_capacity(40);
        for p in std::iter::once(&self.centre).chain(&self.points) {
            let position = blend(&p.n, &self.x).into();
            // A section that fails at zero strain has no samples.
            let Ok(rows) = self.resultant_rows(p) else { return Vec::new() };
            out.extend(RESULTANTS.iter().zip(&rows).map(|(&name, row)| Sample {
                name,
                position,
                row: row.to_vec(),
                of_acceleration: false,
            }));
        }
        out
    }

    pub(super) fn dissipated_energy(&self, history: &[f64]) -> f64 {
        let len = self.section.history_len();
        if len == 0 {
            return 0.0;
        }
        let points = history.chunks_exact(len).zip(&self.points);
        points.map(|(h, p)| self.section.dissipated(h) * p.area).sum()
    }

    /// Calls `see(number, point, history, strain in the section's frame)` for the Gauss points.
    fn at_points<'h>(
        &self,
        motion: &Motion<'_>,
        history: &'h [f64],
        mut see: impl FnMut(usize, &Point, &'h [f64], [f64; 8]) -> Result<(), ElementError>,
    ) -> Result<(), ElementError> {
        let c = self.configuration(motion);
        let values = self.values(&c);
        let len = self.section.history_len();
        self.points.iter().enumerate().try_for_each(|(g, p)| {
            let strain = self.turn(p).strain(&self.strain(p, &c, &values));
            see(g, p, &history[g * len..(g + 1) * len], strain)
        })
    }

    pub(super) fn show(&self, motion: &Motion<'_>, history: &[f64], see: &mut dyn FnMut(&Inspection)) {
        let shown = self.at_points(motion, history, |point, p, own, strain| {
            let position = blend(&p.n, &self.x).into();
            let axes = self.section_axes(p);
            self.section.inspect(&strain, own, &mut |layer| {
                let (s, c) = layer.angle.sin_cos();
                see(&Inspection {
                    point,
                    layer: layer.layer,
                    position,
                    depth: layer.depth,
                    axes: [axes[0] * c + axes[1] * s, axes[1] * c - axes[0] * s],
                    strain: layer.strain,
                    stress: layer.stress,
                    state: layer.state,
                });
            });
            Ok(())
        });
        debug_assert!(shown.is_ok(), "no call in the closure can fail");
    }

    pub(super) fn section_states(
        &self,
        motion: &Motion<'_>,
        history: &[f64],
    ) -> Result<Vec<SectionState>, ElementError> {
        let mut out = Vec::with_capacity(4);
        let mut response = SectionResponse::default();
        self.at_points(motion, history, |_, p, own, strain| {
            self.section.respond(&strain, own, &mut own.to_vec(), &mut response)?;
            out.push(SectionState {
                position: blend(&p.n, &self.x).into(),
                axes: self.section_axes(p),
                strain,
                resultants: response.resultants,
            });
            Ok(())
        })?;
        Ok(out)
    }
}

impl Inspect for Shell4 {
    /// Resultants in the frame of [`Axes`]: at the centre, then at the four Gauss points counter-clockwise, eight each
    /// in the order of [`RESULTANTS`]. m > 0 stretches the side to which the directors point.
    fn samples(&self) -> Vec<Sample> {
        self.resultant_samples()
    }

    fn dissipated(&self, history: &[f64]) -> f64 {
        self.dissipated_energy(history)
    }

    /// Layers and bars at the four Gauss points.
    fn material_points(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(&Inspection)) {
        self.show(&motion, history, see);
    }

    /// At the four Gauss points, in the frame of [`Axes`].
    fn sections(&self, motion: Motion<'_>, history: &[f64]) -> Result<Vec<SectionState>, ElementError> {
        self.section_states(&motion, history)
    }
}
