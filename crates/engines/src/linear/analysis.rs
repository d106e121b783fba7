//! One mesh, one run: histories, envelopes and the comparable values.

use std::collections::BTreeMap;

use fem::progress::Progress;
use tank::Quantity;
use tank::case::GroundMotion;

use super::model::{Model, Scalar};
use super::waves;
use crate::FeError;
use crate::hoop;
use crate::impulsive::Impulsive;
use crate::modes::{CoupledMode, Kind};
use crate::probe::ProbeLine;
use crate::response::direct::{self, DirectSystem};
use crate::response::motion::{Grid, Motion};
use crate::response::observe::{Extreme, History, Observed};
use crate::response::superpose::{self, ModalSystem, Observable};
use results::channel::{OnWall, Side};
use results::{Channel, EnergyBalance, Omittable};
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;

/// Extremes along a line at θ = 0 and at θ = 180°.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LineExtremes {
    /// Output.
    pub what: OnWall,
    /// Heights, ascending [m].
    pub z: Vec<f64>,
    /// Number of places up to the surface at rest.
    pub wetted: usize,
    /// At θ = 0, from the base up.
    pub front: Vec<Extreme>,
    /// At θ = 180°.
    pub back: Vec<Extreme>,
}

impl LineExtremes {
    /// * `level`: height of the surface at rest [m]
    pub(crate) fn new(line: &ProbeLine, level: f64, front: Vec<Extreme>, back: Vec<Extreme>) -> LineExtremes {
        LineExtremes { what: line.what, z: line.z.clone(), wetted: hoop::wetted(&line.z, level), front, back }
    }

    /// Largest absolute value at place `i` on either side.
    pub(crate) fn peak(&self, i: usize) -> f64 {
        self.front[i].peak().0.max(self.back[i].peak().0)
    }

    /// Place of the largest absolute value on either side up to the surface at rest.
    pub(crate) fn worst(&self) -> usize {
        hoop::worst(0..self.wetted, |i| self.peak(i)).unwrap_or(0)
    }

    /// The same above it; none of a wall that ends there.
    pub(crate) fn rim(&self) -> Option<usize> {
        hoop::worst(self.wetted..self.front.len(), |i| self.peak(i))
    }
}

/// A finished run on one mesh.
#[derive(Clone, Debug)]
pub(crate) struct Analysis<'a> {
    /// Time steps.
    pub grid: Grid,
    /// Scalars and their histories.
    pub scalars: Vec<(Scalar<'a>, History)>,
    /// Extremes of the scalars at θ = 180°, of the first ones (equal to the mirrored ones of θ = 0 without a vertical record).
    back: Vec<Extreme>,
    /// Extremes along the lines.
    pub lines: Vec<LineExtremes>,
    /// Numbers of modes kept, system by system; empty for direct integration.
    pub kept: Vec<Vec<&'a CoupledMode>>,
    /// Largest rise of the surface at the wall [m] with more sloshing modes than count for it, by their number; of modal
    /// superposition.
    pub waves: Vec<(usize, f64)>,
    /// Energy balance of direct integration.
    pub energy: Option<EnergyBalance>,
    /// Largest difference of a scalar's peak between direct integration and modal superposition, relative, with its title.
    pub difference: Option<(f64, String)>,
}

impl Analysis<'_> {
    /// Extremes of a scalar at θ = 0 and at θ = 180°.
    pub(crate) fn sides(&self, channel: Channel) -> Option<(Extreme, Extreme)> {
        let i = self.scalars.iter().position(|(s, _)| s.channel == channel)?;
        let front = self.scalars[i].1.extreme;
        Some((front, self.back.get(i).copied().unwrap_or(mirrored(&front))))
    }

    /// Largest absolute value of a scalar over both sides.
    fn peak(&self, channel: Channel) -> Option<f64> {
        let (front, back) = self.sides(channel)?;
        Some(front.peak().0.max(back.peak().0))
    }

    /// The extremes along a line.
    pub(crate) fn line(&self, what: OnWall) -> Option<&LineExtremes> {
        self.lines.iter().find(|line| line.what == what)
    }

    /// Largest rise of the surface at the wall [m].
    pub(crate) fn wave(&self) -> Option<f64> {
        let rises = Side::BOTH.map(|side| {
            let found = self.scalars.iter().find(|(s, _)| s.channel == Channel::Wave(side));
            found.map(|(_, history)| history.extreme.max)
        });
        Some(rises[0]?.max(rises[1]?))
    }

    /// Comparable values. `round`: whether the tank is a cylinder, whose walls have hoop and axial stress.
    pub(crate) fn values(&self, model: &Model, round: bool) -> BTreeMap<Quantity, f64> {
        let mut values = BTreeMap::new();
        let mut put = |quantity, value: Option<f64>| {
            if let Some(value) = value {
                values.insert(quantity, value);
            }
        };
        let mode = |kind| model.held().first(kind);
        let period = |m: &CoupledMode| std::f64::consts::TAU / m.omega;
        put(Quantity::SloshingPeriod, mode(Kind::Sloshing).map(period));
        put(Quantity::ConvectiveMass, mode(Kind::Sloshing).map(CoupledMode::effective_mass));
        let impulsive = model.held().impulsive();
        put(Quantity::ImpulsivePeriod, impulsive.as_ref().map(Impulsive::period));
        put(Quantity::ImpulsiveMass, impulsive.as_ref().map(Impulsive::mass));
        put(Quantity::SloshingHeight, self.wave());
        let mut scalars =
            vec![Channel::BaseShear, Channel::BaseMoment, Channel::OverturningMoment, Channel::Base(OnWall::Bending)];
        if round {
            scalars.push(Channel::Base(OnWall::Axial));
        }
        for channel in scalars {
            if let Some(quantity) = channel.quantity() {
                put(quantity, self.peak(channel));
            }
        }
        if let Some(line) = self.line(OnWall::Hoop).filter(|_| round) {
            hoop::put(&mut values, (&line.z, model.horizontal.coupled.level), |i| line.peak(i));
        }
        values
    }
}

/// Without a vertical record everything at θ = 180° is the negative of θ = 0.
pub(crate) fn mirrored(front: &Extreme) -> Extreme {
    Extreme { min: -front.max, min_time: front.max_time, max: -front.min, max_time: front.min_time }
}

/// Runs `model` under `motion`.
///
/// Errors: those of [`Model::grid`], [`superpose::respond`] and [`direct::respond`].
pub(crate) fn analyse<'a>(
    model: &'a Model,
    motion: &GroundMotion,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Analysis<'a>, FeError> {
    analyse_on(model, motion, (options, Extent::Whole), progress)
}

/// How much of a run is computed. Each extent has the values, demands and checks of the whole run, but for a quick run, which cannot tell whether a
/// base that lifts repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// All that is reported: extremes along all lines, histories, a base that lifts on softer and harder ground.
    Whole,
    /// Without [`Extent::LEAVES_OUT`].
    Selected,
    /// The lines that values and limits are made of, and a base that lifts in one run alone.
    Quick,
    /// Values and demands alone.
    Values,
    /// Values alone, without histories: those of a second mesh.
    Extremes,
}

impl Extent {
    /// Parts of the results that a selected run has not.
    pub(crate) const LEAVES_OUT: [Omittable; 3] = [Omittable::Envelopes, Omittable::Histories, Omittable::Grounds];

    /// The extent of a run of which nobody needs these parts.
    pub(crate) fn without(parts: &[Omittable]) -> Extent {
        if Extent::LEAVES_OUT.iter().all(|part| parts.contains(part)) { Extent::Selected } else { Extent::Whole }
    }

    /// Whether extremes along a line are observed.
    fn has(self, what: OnWall) -> bool {
        self == Extent::Whole || matches!(what, OnWall::Hoop | OnWall::Pressure)
    }

    /// Whether there is a history at the place of the largest hoop stress, which is known after a first pass alone.
    fn follows_hoop(self) -> bool {
        matches!(self, Extent::Whole | Extent::Quick)
    }

    /// Whether the waves of further modes are computed, for a note.
    fn has_further_waves(self) -> bool {
        matches!(self, Extent::Whole | Extent::Selected)
    }

    /// Whether a base that lifts is run under motions slightly apart: checks ask whether it repeats.
    pub(super) fn repeats(self) -> bool {
        self != Extent::Quick
    }

    /// Whether a base that lifts is run on softer and on harder ground: no value and no check depends on these runs.
    pub(super) fn has_band(self) -> bool {
        self == Extent::Whole
    }
}

/// The same to an extent.
///
/// Errors: as [`analyse`].
pub(crate) fn analyse_on<'a>(
    model: &'a Model,
    motion: &GroundMotion,
    (options, extent): (&Options, Extent),
    progress: &dyn Progress,
) -> Result<Analysis<'a>, FeError> {
    let both_sides = model.vertical.is_some();
    let on_lines = on_lines(model, extent);
    let kept = model.kept(options.wave_modes);
    let systems = model
        .systems()
        .zip(&kept)
        .map(|(h, kept)| ModalSystem::new(&h.coupled, kept.clone(), &model.damper))
        .collect::<Result<Vec<ModalSystem>, FeError>>()?;
    let grid = model.grid(motion, Integrator::Modal)?;
    let ground = model.motions((&motion.horizontal, motion.vertical.as_ref()), &grid);
    let ground: Vec<&Motion> = ground.iter().collect();
    progress.stage("linear response", 2 * grid.steps() as u64);
    let mut extremes = match extent.follows_hoop() {
        false => Vec::new(),
        true => {
            let found = superpose::respond(&systems, &ground, grid, &[], &on_lines, progress)?;
            collect(model, &found.extremes, both_sides, extent)
        }
    };
    let hoop = extremes.iter().find(|l| l.what == OnWall::Hoop).map(LineExtremes::worst);
    let scalars = model.scalars(hoop);
    let observables: Vec<Observable> = scalars.iter().map(|s| s.observable.clone()).collect();
    let opposite: Vec<Observable> =
        if both_sides { observables.iter().map(|o| mirror(model, o)).collect() } else { Vec::new() };
    let sloshing = kept[0].iter().filter(|m| m.kind == Kind::Sloshing).count();
    let further = match extent.has_further_waves() {
        true => waves::further(&scalars, options.wave_modes, sloshing),
        false => Vec::new(),
    };
    let number: usize = further.iter().map(|wave| wave.observables().count()).sum();
    let beside: &[Observable] = if extent.follows_hoop() { &[] } else { &on_lines };
    // Scalars without histories are observed as all others.
    let (kept_scalars, seen): (&[Observable], &[Observable]) =
        if extent == Extent::Extremes { (&[], &observables) } else { (&observables, &[]) };
    let others: Vec<Observable> = seen
        .iter()
        .chain(&opposite)
        .cloned()
        .chain(further.iter().flat_map(waves::Further::observables))
        .chain(beside.iter().cloned())
        .collect();
    let mut observed = superpose::respond(&systems, &ground, grid, kept_scalars, &others, progress)?;
    let extremes_of_scalars = observed.extremes.drain(..seen.len());
    observed.scalars.extend(extremes_of_scalars.map(|extreme| History { values: Vec::new(), extreme }));
    let mut others_found = observed.extremes.split_off(opposite.len());
    let lines_found = others_found.split_off(number);
    let waves = waves::rises(&further, &others_found);
    if !extent.follows_hoop() {
        extremes = collect(model, &lines_found, both_sides, extent);
    }
    let mut found = Analysis {
        grid,
        back: observed.extremes,
        lines: extremes,
        kept,
        waves,
        energy: None,
        difference: None,
        scalars: Vec::new(),
    };
    let mut histories = observed.scalars;
    if options.integrator == Integrator::Newmark {
        let others: Vec<Observable> = opposite.into_iter().chain(on_lines).collect();
        let (grid, mut direct, balance) = integrated(model, motion, &observables, &others, progress)?;
        found.grid = grid;
        found.lines = collect(model, &direct.extremes.split_off(found.back.len()), both_sides, extent);
        found.difference = largest_difference(&scalars, &histories, &direct.scalars);
        // The energies of the two parts of a lifting wall's motion do not add up to that of the whole.
        found.energy = model.turned.is_none().then_some(balance);
        (histories, found.back) = (direct.scalars, direct.extremes);
    }
    found.scalars = scalars.into_iter().zip(histories).collect();
    Ok(found)
}

/// What is observed along the wall to an extent: line by line at θ = 0, and at 180° where the two differ.
fn on_lines(model: &Model, extent: Extent) -> Vec<Observable<'_>> {
    let sides: &[bool] = if model.vertical.is_some() { &[false, true] } else { &[false] };
    let mut all = Vec::new();
    for line in model.horizontal.coupled.lines.iter().filter(|line| extent.has(line.what)) {
        for &opposite in sides {
            all.extend((0..line.z.len()).map(|i| model.observable_on_line(line, i, opposite)));
        }
    }
    all
}

/// Direct integration of all unknowns, with its grid and energies.
///
/// Errors: an effective matrix that cannot be factored, a response that is not finite.
fn integrated(
    model: &Model,
    motion: &GroundMotion,
    observables: &[Observable<'_>],
    others: &[Observable<'_>],
    progress: &dyn Progress,
) -> Result<(Grid, Observed, EnergyBalance), FeError> {
    let grid = model.grid(motion, Integrator::Newmark)?;
    let ground = model.motions((&motion.horizontal, motion.vertical.as_ref()), &grid);
    let ground: Vec<&Motion> = ground.iter().collect();
    let systems: Vec<DirectSystem> =
        model.systems().map(|h| DirectSystem::new(&h.coupled, &h.modes, &model.damper)).collect();
    progress.stage("linear response, direct integration", grid.steps() as u64);
    let (observed, balance) = direct::respond(&systems, &ground, grid, observables, others, progress)?;
    Ok((grid, observed, balance))
}

/// The same observation at θ = 180°: m = 1 with the other sign.
fn mirror<'a>(model: &Model, observable: &Observable<'a>) -> Observable<'a> {
    observable
        .iter()
        .map(|&(system, factor, probe)| (system, if model.is_odd(system) { -factor } else { factor }, probe))
        .collect()
}

/// Sorts the extremes of the rows on lines by line and side.
fn collect(model: &Model, found: &[Extreme], both_sides: bool, extent: Extent) -> Vec<LineExtremes> {
    let mut rest = found.iter().copied();
    let mut lines = Vec::new();
    let lines_of = &model.horizontal.coupled.lines;
    for line in lines_of.iter().filter(|line| extent.has(line.what)) {
        let front: Vec<Extreme> = rest.by_ref().take(line.z.len()).collect();
        let back =
            if both_sides { rest.by_ref().take(line.z.len()).collect() } else { front.iter().map(mirrored).collect() };
        lines.push(LineExtremes::new(line, model.horizontal.coupled.level, front, back));
    }
    lines
}

/// Largest relative difference of the peaks of two runs, with its title. Scalars that are rounding errors compared with others
/// of their dimension (the axial stress of a plane wall under horizontal motion) do not count.
pub(crate) fn largest_difference(scalars: &[Scalar], modal: &[History], direct: &[History]) -> Option<(f64, String)> {
    let peak = |h: &History| h.extreme.peak().0;
    let counts = |s: &Scalar, m: &History| {
        let same = scalars.iter().zip(modal).filter(|(o, _)| o.channel.dimension() == s.channel.dimension());
        let largest = same.map(|(_, h)| peak(h)).fold(0.0, f64::max);
        peak(m) > 1e-6 * largest
    };
    scalars
        .iter()
        .zip(modal.iter().zip(direct))
        .filter(|(s, (m, _))| counts(s, m))
        .map(|(s, (m, d))| ((peak(d) / peak(m) - 1.0).abs(), s.channel.title()))
        .max_by(|a, b| a.0.total_cmp(&b.0))
}
