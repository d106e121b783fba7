//! What a run on a free base is given, and laws of the base by the modulus of the ground.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use ::base::history::{Body, Friction};
use ::base::{Anchors, Base, BaseError, Drag, Heave, Law, Losses, Ring, Rocking, Soil, Waves};
use tank::options::linear::Heave as AskedHeave;

/// How much farther than asked a law that is known may reach: its points lie that much farther apart.
const FARTHER: f64 = 3.0;

/// What a run is given besides laws of the base. Of the ground only the drag of the plate depends on it.
#[derive(Clone)]
pub(super) struct Setup {
    /// Whether the run is repeated slightly apart.
    pub thorough: bool,
    /// Whether it is repeated on other grounds.
    pub grounds: bool,
    /// Laws of the base from runs under other records.
    pub known: Option<Arc<Known>>,
    /// Wall and liquid.
    pub body: Body,
    /// Rigid parts of the bottom pressure.
    pub rigid_pressure: [f64; 2],
    /// p_b(r)/p_b(R) at evenly spaced radii from the axis to the wall.
    pub form: Vec<f64>,
    /// Whether the bottom is drawn.
    pub drawn: bool,
    /// Anchors, of a tank that stands on them.
    pub anchors: Option<Anchors>,
    /// Inertia on the foot, where it is asked for.
    pub heave: Option<AskedHeave>,
    /// Damping ratio of the wall.
    pub damping: f64,
    /// Damping over stiffness of plate and ground, as that of the wall at its impulsive mode [s].
    pub delay: f64,
    /// Damping of the closed ground, of critical, and over its stiffness [s].
    pub ground_damping: [f64; 2],
    /// Friction.
    pub friction: Option<Friction>,
    /// Whether its coefficient is assumed, as nothing is given of the foundation.
    pub assumed: bool,
    /// Soil with the velocity of its shear waves [m/s] and its density [kg/m³].
    pub soil: Option<(Soil, f64, f64)>,
    /// Ground acceleration at each step [m/s²].
    pub ground: Vec<f64>,
    /// Steps of the runs that search.
    pub searched: usize,
    /// Time step [s].
    pub step: f64,
    /// Steps in one of the record.
    pub sub_steps: usize,
    /// Whether they are halved so that the energy closes.
    pub shortened: bool,
    /// Whether there is a vertical record.
    pub vertical: bool,
    /// Whether corrosion takes part of wall or plates, which are those as built.
    pub corrodes: bool,
}

impl Setup {
    /// The same with the bottom plate dragged along the ground of a base, where there is friction.
    pub(super) fn dragging(&self, base: &Base) -> Result<Setup, Missed> {
        let mut own = self.clone();
        if let Some(friction) = &mut own.friction {
            friction.springs = Drag::of(base, friction.coefficient)?.springs();
        }
        Ok(own)
    }

    /// The same with steps of half the length.
    pub(super) fn halved(&self) -> Setup {
        let mut own = self.clone();
        own.ground = between(&self.ground);
        if let Some(friction) = &mut own.friction {
            friction.vertical = between(&friction.vertical);
        }
        own.searched *= 2;
        own.step *= 0.5;
        own.sub_steps *= 2;
        own.shortened = true;
        own
    }
}

/// The base up to a rotation.
#[derive(Debug)]
pub(super) struct Laws {
    pub rocking: Rocking,
    pub law: Law,
    pub ring: Option<Ring>,
    /// Wall and roof that the foot lifts.
    pub heave: Option<Heave>,
    /// A rim that ovals in time.
    pub waves: Option<Waves>,
    /// Loss of its strips, once it is asked for.
    pub losses: OnceLock<Losses>,
}

impl Laws {
    /// Loss of its strips.
    ///
    /// Errors: no equilibrium of a step.
    pub(super) fn losses(&self, base: &Base) -> Result<&Losses, BaseError> {
        if let Some(known) = self.losses.get() {
            return Ok(known);
        }
        let found = self.law.losses(base)?;
        Ok(self.losses.get_or_init(|| found))
    }
}

/// Laws of a tank's base by the modulus of the ground: they do not depend on the record.
#[derive(Debug, Default)]
pub(crate) struct Known(Mutex<Vec<(f64, Arc<Laws>)>>);

impl Known {
    /// The shortest one that reaches a rotation [rad].
    pub(super) fn reaching(&self, modulus: f64, largest: f64) -> Option<Arc<Laws>> {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let fits = |laws: &Laws| (largest..=FARTHER * largest).contains(&laws.law.largest());
        let reaching = all.iter().filter(|(m, laws)| *m == modulus && fits(laws));
        let shortest = reaching.min_by(|a, b| a.1.law.largest().total_cmp(&b.1.law.largest()));
        shortest.map(|(_, laws)| Arc::clone(laws))
    }

    pub(super) fn add(&self, modulus: f64, laws: &Arc<Laws>) {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.push((modulus, Arc::clone(laws)));
    }
}

/// Values with their means between them: the motion is linear over a step.
pub(super) fn between(values: &[f64]) -> Vec<f64> {
    let last = values.last().copied();
    let pairs = values.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]);
    pairs.chain(last).collect()
}

/// Why there is no run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Missed {
    /// No equilibrium of the base.
    Base(BaseError),
    /// The base turns further than [`MOST`]: its largest rotation [rad], and when it first passes that limit [s].
    TooFar(f64, f64),
}

impl Missed {
    /// How far the base turns [rad], and when it leaves the model [s].
    pub(super) fn turns(&self) -> Option<[f64; 2]> {
        match self {
            Missed::Base(_) => None,
            Missed::TooFar(angle, time) => Some([*angle, *time]),
        }
    }
}

impl From<BaseError> for Missed {
    fn from(error: BaseError) -> Missed {
        Missed::Base(error)
    }
}
