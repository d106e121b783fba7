//! A tank whose slab stands on isolators.
//!
//! The modes of the tank on a fixed base become the body of [`::soil::isolated`], whose march finds the acceleration A of the slab under
//! both horizontal components. A takes the place of the ground motion, so that every value, envelope and demand of the run is that of the
//! tank on isolators. `docs/theory/soil.md`.

mod bearings;
mod beneath;
mod outcome;
#[cfg(test)]
mod tests;
mod words;

use std::collections::BTreeMap;

use ::soil::SoilError;
use ::soil::isolated::{self, History, Mode};
use ::soil::isolator::{Friction, Isolator};
use oscillator::record::Record;
use rayon::prelude::*;
use results::part::Fact;
use tank::case::GroundMotion;
use tank::demand::Demands;
use tank::options::LinearOptions as Options;
use tank::{Bearing, Case, Isolators, Quantity, Shape};

use super::analysis::{Analysis, Extent};
use super::around::Around;
use super::demands::{beside, wave};
use super::model::Model;
use crate::FeError;
use crate::harmonic::Places;
use crate::histories::Histories;
use crate::response::motion::{Grid, Motion};
use crate::response::superpose;

pub(crate) use beneath::{Below, Beneath};
pub(super) use outcome::Isolated;

/// Longest time step [s].
const LONGEST: f64 = 1e-3;

/// The run on isolators; `None` of a tank without them.
///
/// Lower and upper properties run in every extent: checks take the worst of all.
///
/// Errors: dashpots, which couple the modes; a march without convergence; a response that is not finite.
pub(super) fn isolated(
    case: &Case,
    model: &Model,
    still: &Analysis<'_>,
    motion: &GroundMotion,
    options: &Options,
) -> Result<Option<Isolated>, FeError> {
    let Some(given) = case.tank.isolators else { return Ok(None) };
    if !options.dashpots.is_empty() {
        return Err(FeError::Unsupported(words::DASHPOTS.into()));
    }
    let setup = Setup::new(case, model, &given, still.grid, motion, options);
    let bound = |&factor: &f64| setup.bound((case, model), (&given, factor), motion, options);
    let (main, bounds) = rayon::join(
        || setup.march(&setup.isolators(&given, 1.0), &[]),
        || given.bounds.par_iter().map(bound).collect::<Vec<_>>(),
    );
    let history = main.map_err(failure)?;
    let bounds = bounds.into_iter().collect::<Result<Vec<Bound>, FeError>>()?;
    Ok(Some(Isolated::new(setup, given, history, bounds, motion)))
}

/// The body of a case on its isolators.
#[derive(Clone, Debug)]
pub struct IsolatedBody {
    /// Modes on a fixed base.
    pub modes: Vec<Mode>,
    /// Mass of tank, liquid and slab [kg].
    pub mass: f64,
    /// Isolators with nominal properties.
    pub isolators: Vec<Isolator>,
}

/// The body of a case with a ground motion on its isolators, for a second integration of the run; `None` without isolators.
///
/// Errors: those of the model on a fixed base.
pub fn isolated_body(case: &Case, options: &Options) -> Result<Option<IsolatedBody>, FeError> {
    let (Some(given), Some(motion)) = (case.tank.isolators, case.ground_motion.as_ref()) else { return Ok(None) };
    let model = Model::new(case, options, false, Places::Usual)?;
    let grid = model.grid(motion, options.integrator)?;
    let setup = Setup::new(case, &model, &given, grid, motion, options);
    Ok(Some(IsolatedBody { isolators: setup.isolators(&given, 1.0), modes: setup.modes, mass: setup.mass }))
}

fn failure(error: SoilError) -> FeError {
    FeError::Analysis(format!("isolators: {error}"))
}

/// What does not depend on the properties.
#[derive(Clone)]
struct Setup {
    modes: Vec<Mode>,
    /// Mass of tank, liquid and slab [kg].
    mass: f64,
    gravity: f64,
    /// Radius of the plan, or its half length [m].
    radius: f64,
    /// Whether the plan is round.
    round: bool,
    /// Ground acceleration along x and y at each step [m/s²].
    ground: Vec<[f64; 2]>,
    /// Vertical ground acceleration at each step [m/s²]; empty without.
    vertical: Vec<f64>,
    /// Time step [s].
    step: f64,
    /// Steps in one of the record.
    parts: usize,
}

impl Setup {
    fn new(
        case: &Case,
        model: &Model,
        given: &Isolators,
        grid: Grid,
        motion: &GroundMotion,
        options: &Options,
    ) -> Setup {
        let harmonic = &model.horizontal;
        let coupled = &harmonic.coupled;
        let kept = superpose::keep(coupled, &harmonic.modes, &model.damper, options.wave_modes);
        let modes = kept.iter().map(|mode| Mode {
            mass: mode.effective_mass(),
            omega: mode.omega,
            damping: model.damper.ratio(mode.kind, mode.omega),
        });
        let parts = (grid.dt / LONGEST - 1e-9).ceil().max(1.0) as usize;
        let fine = Grid { sub_steps: parts, ..grid };
        let sampled = |record: &Record| {
            let motion = Motion::new(record, &fine);
            (0..=fine.steps()).map(|i| motion.at(i)).collect::<Vec<f64>>()
        };
        let along = sampled(&motion.horizontal);
        let across = motion.transverse.as_ref().map(sampled);
        Setup {
            modes: modes.collect(),
            mass: coupled.liquid_mass + coupled.wall_mass + given.slab_mass,
            gravity: case.gravity,
            radius: case.tank.shape.half_length(),
            round: matches!(case.tank.shape, Shape::Cylinder { .. }),
            ground: (0..along.len()).map(|i| [along[i], across.as_ref().map_or(0.0, |a| a[i])]).collect(),
            vertical: motion.vertical.as_ref().map_or_else(Vec::new, sampled),
            step: fine.h(),
            parts,
        }
    }

    /// The isolators with scaled properties.
    fn isolators(&self, given: &Isolators, factor: f64) -> Vec<Isolator> {
        let bearing = match given.bearing {
            Bearing::FrictionPendulum { radius, friction, slow, rate, slip } => Isolator::FrictionPendulum {
                radius,
                friction: Friction { fast: factor * friction, slow: factor * slow, rate },
                slip,
            },
            Bearing::LeadRubber { strength, initial, yielded } => Isolator::LeadRubber {
                strength: factor * strength,
                initial_stiffness: factor * initial,
                yielded_stiffness: factor * yielded,
            },
            Bearing::Elastomer { stiffness, damping } => Isolator::Elastomer { stiffness: factor * stiffness, damping },
        };
        let damper = given
            .damper
            .map(|[coefficient, exponent]| Isolator::Damper { coefficient: factor * coefficient, exponent });
        std::iter::once(bearing).chain(damper).collect()
    }

    /// * `more`: what another model exerts on the slab beyond the modes, at each step [N]; empty without
    fn march(&self, isolators: &[Isolator], more: &[[f64; 2]]) -> Result<History, SoilError> {
        isolated::march(&isolated::Run {
            mass: self.mass,
            modes: &self.modes,
            isolators,
            gravity: self.gravity,
            step: self.step,
            parts: 1,
            ground: &self.ground,
            vertical: &self.vertical,
            more,
        })
    }

    /// The motion of the slab in place of that of the ground.
    fn driven(&self, history: &History, motion: &GroundMotion) -> GroundMotion {
        let component = |record: &Record, c: usize| Record {
            dt: self.step,
            acceleration: history.acceleration.iter().map(|a| a[c]).collect(),
            ..record.clone()
        };
        GroundMotion {
            horizontal: component(&motion.horizontal, 0),
            transverse: motion.transverse.as_ref().map(|record| component(record, 1)),
            vertical: motion.vertical.clone(),
        }
    }

    /// Effective stiffness [N/m], period [s] and damping ratio of a cycle of this amplitude [m].
    fn effective(&self, isolators: &[Isolator], amplitude: f64) -> [f64; 3] {
        let weight = self.mass * self.gravity;
        let stiffness: f64 =
            (isolators.iter()).map(|isolator| isolator.effective(amplitude, weight, 1.0, 1.0).stiffness).sum();
        let omega = (stiffness / self.mass).sqrt();
        let damping = isolators.iter().map(|isolator| {
            let own = isolator.effective(amplitude, weight, omega, stiffness);
            // A damper's ratio is over all stiffness already.
            match isolator {
                Isolator::Damper { .. } => own.damping,
                _ => own.damping * own.stiffness / stiffness,
            }
        });
        [stiffness, std::f64::consts::TAU / omega, damping.sum()]
    }

    /// The run with scaled properties.
    fn bound(
        &self,
        (case, model): (&Case, &Model),
        (given, factor): (&Isolators, f64),
        motion: &GroundMotion,
        options: &Options,
    ) -> Result<Bound, FeError> {
        let isolators = self.isolators(given, factor);
        let history = self.march(&isolators, &[]).map_err(failure)?;
        let model = on_isolators(model);
        let driven = self.driven(&history, motion);
        let (analysis, mut demands) = beside(case, &model, &driven, (options, Extent::Values))?;
        let around = Around::of(&model, None, &driven, options, &analysis)?;
        demands.wave = match around {
            Some(around) => around.wave,
            None => wave(&analysis),
        };
        demands.isolation = Some(bearings::isolation(self, given, &history, &demands));
        Ok(Bound {
            factor,
            band: self.band(&isolators, factor, &history, (&analysis.values(&model, self.round), &demands)),
            demands,
        })
    }

    /// A row of the table of values by the factor of the properties.
    fn band(
        &self,
        isolators: &[Isolator],
        factor: f64,
        history: &History,
        (values, demands): (&BTreeMap<Quantity, f64>, &Demands),
    ) -> Vec<Fact> {
        let displacement = isolated::peak(&history.displacement);
        let [_, period, damping] = self.effective(isolators, displacement);
        let value = |quantity| values.get(&quantity).copied().unwrap_or(0.0);
        let wave = match (demands.transverse.is_empty(), demands.wave) {
            (false, Some(wave)) => wave.value,
            _ => value(Quantity::SloshingHeight),
        };
        let shear = both(demands).unwrap_or_else(|| value(Quantity::BaseShear));
        let force = isolated::peak(&history.force);
        [factor, displacement, force, period, damping, shear, wave].map(Fact::from).to_vec()
    }
}

/// Largest base shear of both horizontal components together [N]; none of one.
fn both(demands: &Demands) -> Option<f64> {
    let terms = demands.base_shear.as_ref()?;
    let (x, y) = (demands.history(terms), demands.transverse(terms)?);
    Some(x.iter().zip(&y).map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max))
}

/// A run with scaled properties.
struct Bound {
    factor: f64,
    band: Vec<Fact>,
    demands: Demands,
}

/// The model under the motion of its slab, which contains the free vibration.
fn on_isolators(model: &Model) -> Model {
    Model { whole: true, ..model.clone() }
}

/// Keeps the histories at the steps of the record, and adds those of the isolators.
pub(super) fn push(found: &Isolated, histories: &mut Histories) {
    let parts = found.parts();
    histories.series.time = histories.series.time.iter().step_by(parts).copied().collect();
    for column in &mut histories.series.columns {
        *column = column.iter().step_by(parts).copied().collect();
    }
    for (info, column) in found.columns() {
        histories.push(info, column);
    }
}
