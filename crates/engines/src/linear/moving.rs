//! The base under the wall, where it moves.

use results::{Part, Snapshots};
use tank::Case;
use tank::case::GroundMotion;
use tank::demand::Demands;
use tank::options::LinearOptions as Options;

use super::analysis::Analysis;
use super::drawn::{Drawn, Pictures};
use super::model::Model;
use super::{Linear, Values, isolation, rocking};
use crate::FeError;
use crate::response::motion::Grid;

/// A base that moves: on isolators, or a bottom plate that lifts or slides.
pub(super) struct MovingBase {
    pub(super) isolated: Option<isolation::Isolated>,
    pub(super) free: rocking::Free,
}

impl MovingBase {
    /// The base of a tank whose response with the wall held down is `analysis`.
    ///
    /// Errors: a march on isolators that fails.
    pub(super) fn of(
        case: &Case,
        options: &Options,
        linear: &Linear<'_>,
        analysis: &Analysis<'_>,
        motion: &GroundMotion,
    ) -> Result<MovingBase, FeError> {
        let of = (linear.engine, linear.model);
        let asked = (options, linear.extent, linear.known, linear.states.is_some());
        Ok(MovingBase {
            isolated: isolation::isolated(case, linear.model, analysis, motion, options)?,
            free: rocking::free(case, of, analysis, motion, asked),
        })
    }

    /// The model on this base, where it moves.
    pub(super) fn model(&self, held: &Model) -> Option<Model> {
        match &self.isolated {
            Some(found) => Some(found.model(held)),
            None => self.free.moved().map(|moved| moved.model(held)),
        }
    }

    /// States of the tank on this base, where they are asked for.
    ///
    /// Errors: a response that is not finite.
    pub(super) fn states(
        &self,
        pictures: Option<Pictures>,
        (case, model): (&Case, &Model),
        (motion, options): (&GroundMotion, &Options),
        analysis: &Analysis<'_>,
    ) -> Result<Option<Snapshots>, FeError> {
        let (bottom, isolated) = (self.free.bottom(), self.isolated.as_ref());
        let drawn = Drawn { case, model, motion, options, analysis, bottom, isolated };
        pictures.map(|pictures| drawn.states(pictures)).transpose()
    }

    /// The motion of the ground as the tank feels it: on isolators that of the slab.
    pub(super) fn motion(&self, ground: &GroundMotion) -> GroundMotion {
        self.isolated.as_ref().map_or_else(|| ground.clone(), |found| found.motion.clone())
    }

    /// Puts the base's own values to those of the wall; `held`: those of the wall held down.
    pub(super) fn put(&mut self, analysis: &Analysis<'_>, held: &Values, values: &mut Values) {
        if let Some(moved) = self.free.moved_mut() {
            moved.complete(analysis, values, held);
        }
        if let Some(found) = &self.isolated {
            rocking::of_base(&found.values, values);
        }
        self.free.rest(values);
    }

    /// Puts the values of isolators to the demands; returns remarks on them.
    ///
    /// * `values`, `held`: those of the tank on this base, and with the wall held down
    pub(super) fn complete(
        &mut self,
        (analysis, values, held): (&Analysis<'_>, &Values, &Values),
        demands: &mut Demands,
    ) -> Vec<String> {
        let Some(found) = &mut self.isolated else { return Vec::new() };
        found.complete(analysis, values, held, demands);
        found.notes()
    }

    /// Steps of the histories: those of the record on isolators, whose march has finer ones.
    pub(super) fn record_grid(&self, grid: Grid) -> Grid {
        self.isolated.as_ref().map_or(grid, |found| found.record_grid(grid))
    }

    /// What is reported of isolators.
    pub(super) fn part(&self) -> Option<Part> {
        self.isolated.as_ref().map(isolation::Isolated::part)
    }
}
