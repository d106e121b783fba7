//! Isolators below another model of the tank.
//!
//! ```text
//! M A + Σ m_n ÿ_n + ΔV + F = 0          ΔV = V − V_modes
//! ```
//!
//! The other model runs under the motion A of the slab and returns its base shear V. What V has beyond the modes under the same motion acts on
//! the slab in the next march, until V no longer changes. An elastic wall has little of it, and one that yields less shear than its modes.

use std::collections::BTreeMap;

use ::soil::isolated::{History, peak};
use rayon::prelude::*;
use results::{Part, SeriesInfo};
use tank::case::GroundMotion;
use tank::demand::Demands;
use tank::options::LinearOptions as Options;
use tank::{Case, Isolators, Quantity};

use super::outcome::Isolated;
use super::{Bound, Setup, failure};
use crate::FeError;
use crate::checks::checked_motion;
use crate::harmonic::Places;
use crate::linear::model::Model;

/// The isolators of a case.
pub(crate) struct Beneath<'a> {
    case: &'a Case,
    motion: &'a GroundMotion,
    model: Model,
    options: Options,
    given: Isolators,
    setup: Setup,
}

/// A march of the isolators.
pub(crate) struct Below {
    history: History,
    /// Motion of the slab in place of that of the ground.
    pub motion: GroundMotion,
    /// ΔV at each step of the march [N].
    more: Vec<[f64; 2]>,
}

/// What is reported of a run on isolators.
pub(crate) struct Outcome {
    pub part: Part,
    pub notes: Vec<String>,
    /// Histories of the isolators.
    pub columns: Vec<(SeriesInfo, Vec<f64>)>,
}

impl<'a> Beneath<'a> {
    /// `None` of a tank without isolators.
    ///
    /// Errors: no ground motion; those of the model on a fixed base.
    pub(crate) fn of(case: &'a Case) -> Result<Option<Beneath<'a>>, FeError> {
        let Some(given) = case.tank.isolators else { return Ok(None) };
        let motion = checked_motion(case)?;
        let options = Options { mesh_error: false, ..Options::default() };
        let model = Model::new(case, &options, motion.vertical.is_some(), Places::Usual)?;
        let grid = model.grid(motion, options.integrator)?;
        let setup = Setup::new(case, &model, &given, grid, motion, &options);
        Ok(Some(Beneath { case, motion, model, options, given, setup }))
    }

    /// The isolators under the modes alone.
    ///
    /// Errors: a march without convergence.
    pub(crate) fn first(&self) -> Result<Below, FeError> {
        self.march(Vec::new())
    }

    /// The isolators under what the other model has exerted: its base shear along x and y [N] at these times [s], under the motion of `last`. Returns
    /// the change of ΔV over the largest force of the isolators, too.
    ///
    /// Errors: as [`Beneath::first`].
    pub(crate) fn next(&self, last: &Below, times: &[f64], shear: [&[f64]; 2]) -> Result<(Below, f64), FeError> {
        let own = self.modal_shear(&last.history);
        let step = |t: f64| ((t / self.setup.step).round() as usize).min(own.len() - 1);
        let beyond = |k: usize| [0, 1].map(|c| shear[c].get(k).map_or(0.0, |v| v - own[step(times[k])][c]));
        let found: Vec<[f64; 2]> = (0..times.len()).map(beyond).collect();
        let before = |k: usize| last.more.get(step(times[k])).copied().unwrap_or_default();
        let change: Vec<[f64; 2]> = (0..times.len()).map(|k| [0, 1].map(|c| found[k][c] - before(k)[c])).collect();
        let change = peak(&change) / peak(&last.history.force).max(f64::MIN_POSITIVE);
        let at = |i: usize| {
            let t = i as f64 * self.setup.step;
            let k = times.partition_point(|own| *own <= t);
            match (k.checked_sub(1).map(|k| (times[k], found[k])), times.get(k)) {
                (Some((start, a)), Some(&end)) => {
                    let share = (t - start) / (end - start);
                    [0, 1].map(|c| a[c] + share * (found[k][c] - a[c]))
                }
                // The other model has ended.
                _ => [0.0; 2],
            }
        };
        Ok((self.march((0..own.len()).map(at).collect())?, change))
    }

    fn march(&self, more: Vec<[f64; 2]>) -> Result<Below, FeError> {
        let history = self.setup.march(&self.setup.isolators(&self.given, 1.0), &more).map_err(failure)?;
        Ok(Below { motion: self.setup.driven(&history, self.motion), history, more })
    }

    /// Base shear of the modes at each step [N].
    fn modal_shear(&self, history: &History) -> Vec<[f64; 2]> {
        let moving: f64 = self.setup.modes.iter().map(|mode| mode.mass).sum();
        let rigid = self.setup.mass - self.given.slab_mass - moving;
        let at = |(i, a): (usize, &[f64; 2])| {
            let modal = |c: usize| -> f64 {
                let own = self.setup.modes.iter().zip(&history.modes);
                own.map(|(mode, states)| mode.mass * states[i].acceleration[c]).sum()
            };
            [0, 1].map(|c| rigid * a[c] + modal(c))
        };
        history.acceleration.iter().enumerate().map(at).collect()
    }

    /// Whether the ground moves along y, too.
    pub(crate) fn is_two(&self) -> bool {
        self.motion.transverse.is_some()
    }

    /// What is reported and judged of a run of the other model on these isolators: its `values` and `demands`; lower and upper properties are those of
    /// the linear engine.
    ///
    /// * `change`: as of [`Beneath::next`]; `times`: those of the histories [s]
    ///
    /// Errors: a march without convergence, a response that is not finite.
    pub(crate) fn finish(
        &self,
        below: Below,
        change: f64,
        times: &[f64],
        values: &mut BTreeMap<Quantity, f64>,
        demands: &mut Demands,
    ) -> Result<Outcome, FeError> {
        let bound = |&factor: &f64| {
            self.setup.bound((self.case, &self.model), (&self.given, factor), self.motion, &self.options)
        };
        let bounds = self.given.bounds.par_iter().map(bound).collect::<Result<Vec<Bound>, FeError>>()?;
        let mut found = Isolated::new(self.setup.clone(), self.given, below.history, bounds, self.motion);
        found.of_another(change, values, demands);
        crate::linear::rocking::of_base(&found.values, values);
        let at = |(info, column): (SeriesInfo, Vec<f64>)| {
            let step = self.motion.horizontal.dt;
            let value =
                |t: &f64| column.get((t / step).round() as usize).or(column.last()).copied().unwrap_or_default();
            let own = times.iter().map(value).collect();
            (info, own)
        };
        Ok(Outcome { part: found.part(), notes: found.notes(), columns: found.columns().into_iter().map(at).collect() })
    }
}
