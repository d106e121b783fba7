//! The law of the base that covers the run, and its hysteretic share.

use std::sync::Arc;

use super::law::{closed as closed_ground, laws};
use super::peaks::{Peaks, turns};
use super::setup::{Laws, Missed, Setup, between};
use ::base::history::{Friction, History, March, Run, march};
use ::base::{Base, BaseError, Law, Waves};
use results::BaseSpread;

/// Largest rotation of the first law [rad].
pub(super) const FIRST: f64 = 2e-3;
/// Largest rotation of any law [rad].
pub(super) const MOST: f64 = 0.05;
/// Most rounds of the hysteretic share.
const ROUNDS: usize = 12;
/// Difference of the share from that of the largest rotation that is settled: a loop that is 1 % of the full one wider changes the damping of a
/// cycle by 2/π of that, 0.3 % of critical at most.
pub(super) const SETTLED: f64 = 0.005;
/// Deviation of the energy balance over the input with which a run is left, and how often its step is halved for that.
const CLOSED: f64 = 1e-3;
const HALVINGS: usize = 2;

/// A run that its law covers.
pub(super) struct Found {
    pub laws: Arc<Laws>,
    pub hysteretic: f64,
    /// Difference of the share from that of the largest rotation.
    pub settled: f64,
    pub dashpot: f64,
    pub history: History,
    /// Largest values with a motion that is weaker, one that is stronger, and half the step; none of a run that is not thorough.
    pub twins: Vec<Peaks>,
}

impl Found {
    fn with_twins(self, setup: &Setup, base: &Base) -> Result<Found, Missed> {
        let twins = match setup.thorough {
            true => {
                twins((setup, base), &self.laws, (self.hysteretic, self.dashpot), self.history.rotation.len())?.into()
            }
            false => Vec::new(),
        };
        Ok(Found { twins, ..self })
    }
}

/// Moment at which the rim leaves the ground, under a suction [Pa] or without; at most that of the law's end [N m].
pub(super) fn lifting(law: &Law, suction: f64) -> f64 {
    let first = |suction: f64| {
        let places = (0..=400).map(|i| law.turn(law.largest() * (f64::from(i) / 400.0).powi(3), suction));
        let mut lifted = places.skip_while(|turn| turn.uplift <= 0.0);
        let end = || law.turn(law.largest(), suction);
        lifted.next().unwrap_or_else(end).moment
    };
    first(0.0).min(first(suction))
}

/// Largest |ψ| [rad].
pub(super) fn turned(rotation: &[f64]) -> f64 {
    rotation.iter().fold(0.0, |m, psi| f64::max(m, psi.abs()))
}

/// A run on a law, with a hysteretic share and a dashpot; its rim ovals in time where it is not round.
fn given<'a>(setup: &'a Setup, laws: &'a Laws, (hysteretic, dashpot): (f64, f64)) -> Run<'a> {
    Run {
        body: &setup.body,
        law: Some(&laws.law),
        ring: laws.ring.as_ref(),
        heave: laws.heave.as_ref(),
        waves: laws.waves.as_ref(),
        hysteretic,
        dashpot,
        friction: setup.friction.clone(),
        rigid_pressure: setup.rigid_pressure,
        step: setup.step,
        ground: &setup.ground,
    }
}

/// That run over the steps that search; it can go on to the end of free vibration.
///
/// * `rim`: what ovals in time; none leaves the rim round, which takes a fiftieth of the time
pub(super) fn searched<'a>(
    setup: &'a Setup,
    laws: &'a Laws,
    damping: (f64, f64),
    rim: Option<&'a Waves>,
) -> Result<March<'a>, BaseError> {
    let mut march = March::new(Run { waves: rim, ..given(setup, laws, damping) });
    march.to(setup.searched)?;
    Ok(march)
}

/// Largest values of the run over `steps` with a motion that is weaker, one that is stronger, and half the step.
fn twins(
    (setup, base): (&Setup, &Base),
    laws: &Laws,
    damping: (f64, f64),
    steps: usize,
) -> Result<[Peaks; 3], BaseError> {
    let ground = &setup.ground[..steps.min(setup.ground.len())];
    let scaled = |factor: f64| ground.iter().map(|a| factor * a).collect::<Vec<f64>>();
    let mut halved = setup.friction.clone();
    if let Some(friction) = &mut halved {
        friction.vertical = between(&friction.vertical);
    }
    let run = |ground: &[f64], step: f64, friction: &Option<Friction>| {
        let history = march(&Run { friction: friction.clone(), step, ground, ..given(setup, laws, damping) })?;
        Ok::<_, BaseError>(Peaks::of(base, turns(laws, &history), laws, &history))
    };
    let (run, friction, step) = (&run, &setup.friction, setup.step);
    // The one of half the step takes as long as both others.
    let apart = |factor: f64| run(&scaled(factor), step, friction);
    let (half, both) = rayon::join(
        || run(&between(ground), 0.5 * step, &halved),
        || Ok((apart(1.0 - BaseSpread::APART)?, apart(1.0 + BaseSpread::APART)?)),
    );
    let (weaker, stronger) = both?;
    Ok([weaker, stronger, half?])
}

/// A run with a hysteretic share.
struct Round<'a> {
    share: f64,
    march: March<'a>,
    /// Largest rotation [rad].
    peak: f64,
    /// Share of that rotation less the share of the run.
    off: f64,
}

/// The run whose share is that of its largest rotation; the last one where it turns beyond the law, that with the smaller share where the largest
/// rotation jumps between two shares. Under a rim that ovals in time it starts at the share under a round one, and stays there unless it is to be `exact`.
fn consistent<'a>(
    setup: &'a Setup,
    base: &Base,
    laws: &'a Laws,
    dashpot: f64,
    exact: bool,
) -> Result<Round<'a>, BaseError> {
    let first = laws.law.share(base, laws.losses(base)?, 0.5 * laws.law.largest());
    let round = settled(setup, base, laws, ((first, dashpot), ROUNDS), None)?;
    match &laws.waves {
        Some(waves) => {
            settled(setup, base, laws, ((round.share, dashpot), if exact { ROUNDS } else { 0 }), Some(waves))
        }
        None => Ok(round),
    }
}

/// That run from a first share on, after so many rounds at most.
fn settled<'a>(
    setup: &'a Setup,
    base: &Base,
    laws: &'a Laws,
    ((first, dashpot), rounds): ((f64, f64), usize),
    rim: Option<&'a Waves>,
) -> Result<Round<'a>, BaseError> {
    let law = &laws.law;
    let losses = laws.losses(base)?;
    let run = |share: f64| -> Result<Round<'a>, BaseError> {
        let march = searched(setup, laws, (share, dashpot), rim)?;
        let peak = turned(march.rotation());
        Ok(Round { off: law.share(base, losses, peak) - share, share, march, peak })
    };
    let mut round = run(first)?;
    if rounds == 0 {
        return Ok(round);
    }
    // Shares that are too small and too large.
    let (mut low, mut high): (Option<Round<'_>>, Option<Round<'_>>) = (None, None);
    for i in 0..rounds {
        if round.peak > law.largest() || round.off.abs() <= SETTLED {
            return Ok(round);
        }
        let mut next = (round.share + round.off).clamp(0.0, 1.0);
        if round.off > 0.0 {
            low = Some(round);
        } else {
            high = Some(round);
        }
        if let (Some(low), Some(high)) = (&low, &high) {
            let width = high.share - low.share;
            if width <= SETTLED {
                break;
            }
            let weight = if i % 2 == 0 { low.off / (low.off - high.off) } else { 0.5 };
            next = low.share + weight.clamp(0.1, 0.9) * width;
        }
        round = run(next)?;
    }
    // Which of the two is left does not matter where only one side was found.
    match low.or(high) {
        Some(found) => Ok(found),
        None => run(first),
    }
}

/// How far a law has to reach [rad], as far as one that is at hand tells. Loops of full width take the most from the motion: a base that turns beyond
/// the law with them does so with any. One that does so only without loops is given the next law at once: most do with their own share, whose
/// search needs the loss of the strips.
///
/// Errors: no equilibrium of a step.
pub(super) fn reach(setup: &Setup, base: &Base, laws: &Laws) -> Result<f64, BaseError> {
    let law = &laws.law;
    let dashpot = closed_ground(setup, base, law);
    let run = |share: f64| searched(setup, laws, (share, dashpot), None).map(|march| turned(march.rotation()));
    let elastic = || if base.yields() { run(0.0) } else { Ok(0.0) };
    let (widest, elastic) = rayon::join(|| run(1.0), elastic);
    let (widest, elastic) = (widest?, elastic?);
    Ok(if widest > law.largest() {
        beyond(widest, law)
    } else if elastic > law.largest() {
        beyond(law.largest(), law)
    } else {
        law.largest()
    })
}

/// The reach of the law after one that `peak` [rad] leaves.
fn beyond(peak: f64, law: &Law) -> f64 {
    (1.3 * peak).max(2.0 * law.largest()).min(MOST)
}

/// The run on a ground, with a law that covers it and the hysteretic share of its largest rotation, and its twins where the setup asks for them.
///
/// * `reach`: of the first law [rad], `known` that law where it is at hand
///
/// Errors: no equilibrium; a base that turns too far.
pub(super) fn settle(
    setup: &Setup,
    base: &Base,
    known: (f64, Option<Arc<Laws>>),
    whole: bool,
) -> Result<Found, Missed> {
    covered(setup, base, known, whole)?.with_twins(setup, base)
}

/// The whole run with steps in which its energy closes within [`CLOSED`], as far as [`HALVINGS`] go: on hard ground a landing is short.
///
/// Errors: as [`settle`].
pub(super) fn closed(setup: &Setup, base: &Base, known: (f64, Option<Arc<Laws>>)) -> Result<(Setup, Found), Missed> {
    let mut setup = setup.clone();
    let mut found = covered(&setup, base, known, true)?;
    for _ in 0..HALVINGS {
        if found.history.balance <= CLOSED {
            break;
        }
        setup = setup.halved();
        let laws = Arc::clone(&found.laws);
        found = covered(&setup, base, (laws.law.largest(), Some(laws)), true)?;
    }
    let found = found.with_twins(&setup, base)?;
    Ok((setup, found))
}

/// The run without twins.
fn covered(setup: &Setup, base: &Base, (reach, known): (f64, Option<Arc<Laws>>), whole: bool) -> Result<Found, Missed> {
    let mut found = match known {
        Some(known) => known,
        None => laws(setup, base, reach)?,
    };
    loop {
        let largest = found.law.largest();
        let dashpot = closed_ground(setup, base, &found.law);
        let Round { share: hysteretic, mut march, mut peak, off } = consistent(setup, base, &found, dashpot, whole)?;
        if whole && peak <= largest {
            march.to(setup.ground.len())?;
            peak = turned(march.rotation());
        }
        let history = march.history();
        if peak <= largest {
            return Ok(Found { twins: Vec::new(), laws: found, hysteretic, settled: off.abs(), dashpot, history });
        }
        if largest >= MOST {
            let passes = history.rotation.iter().position(|psi| psi.abs() > largest).unwrap_or(0);
            return Err(Missed::TooFar(peak, passes as f64 * setup.step));
        }
        found = laws(setup, base, beyond(peak, &found.law))?;
    }
}
