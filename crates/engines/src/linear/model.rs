//! The coupled systems of a case with their modes and observables.

use std::borrow::Cow;

use oscillator::record::Record;
use tank::case::GroundMotion;

use super::soil;
use super::system::Harmonic;
use super::turned::{self, Turned};
use crate::damping::Damper;
use crate::harmonic::{self, Places};
use crate::modes::{CoupledMode, Kind};
use crate::probe::{Probe, ProbeLine};
use crate::response::direct;
use crate::response::motion::{Grid, Motion};
use crate::response::superpose::{self, Observable};
use crate::{FeError, estimate};
use results::Channel;
use results::channel::{OnWall, Side};
use tank::options::linear::Integrator;
use tank::options::{AfterRecord, LinearOptions as Options};
use tank::{Case, Shape};

/// Sub-steps in the period of the highest significant mode, for extremes between samples (the response itself is exact).
const SUB_STEPS_PER_PERIOD: f64 = 20.0;
/// Most sub-steps in a step Δt of the record, modal. A mode of period T < Δt/2 follows the record statically but for the
/// ringing after each kink, about T/(2π Δt) of it: so few samples miss less of the ringing than 0.5 % of the whole.
const MOST_MODAL: f64 = 40.0;
/// The same for direct integration, which must resolve the mode itself.
const MOST_DIRECT: f64 = 400.0;

/// Whether the site asks for vertical motion.
pub(crate) fn shaken_upwards(case: &Case) -> bool {
    case.site.ec8.is_some_and(|site| site.vertical)
}

/// The model of a case: m = 1 for the horizontal record and, with a vertical one, m = 0.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    /// m = 1; on its slab where there is one on soil.
    pub horizontal: Harmonic,
    /// m = 1 on a fixed base, of a tank on soil.
    pub fixed: Option<Harmonic>,
    /// m = 0, with a vertical record only.
    pub vertical: Option<Harmonic>,
    /// m = 0 for the vertical spectrum of the site: no part of a response to records.
    pub site: Option<Harmonic>,
    /// Whether a record contains the free vibration after it.
    pub whole: bool,
    /// m = 1 under the rotation of its base, of a tank that lifts or slides.
    pub turned: Option<Turned>,
    /// Damping.
    pub damper: Damper,
}

impl Model {
    /// Builds the systems and finds their modes; `places` are those of the outputs over the height.
    ///
    /// Errors: as [`harmonic::build`], [`harmonic::solve`] and [`Damper::new`].
    pub(crate) fn new(case: &Case, options: &Options, vertical: bool, places: Places) -> Result<Model, FeError> {
        let damper = Damper::new(case, &options.damping)?;
        let prepare = |m: u32| -> Result<Harmonic, FeError> {
            let coupled = harmonic::build_observed(case, options, m, places)?;
            // All that double precision resolves: a fixed number might not be, for a very stiff wall.
            let modes = crate::modes::solve(&coupled, None)?;
            Ok(Harmonic { coupled, modes })
        };
        let horizontal = prepare(1)?;
        let vertical = if vertical { Some(prepare(0)?) } else { None };
        let round = matches!(case.tank.shape, Shape::Cylinder { .. });
        let site = match &vertical {
            _ if !(round && shaken_upwards(case)) => None,
            Some(same) => Some(same.clone()),
            None => Some(prepare(0)?),
        };
        let damper = damper.tuned(&horizontal.modes);
        let (horizontal, fixed) = soil::under(case, &damper, horizontal)?;
        let model = Model { whole: false, vertical, site, turned: None, damper, horizontal, fixed };
        match (&options.rotation, &case.ground_motion) {
            (Some(rotation), Some(motion)) => model.driven(case, options, (motion, rotation)),
            _ => Ok(model),
        }
    }

    /// The model on a base that turns as a record says.
    ///
    /// Errors: a tank whose base is not turned; those of [`Turned::driven`].
    fn driven(
        self,
        case: &Case,
        options: &Options,
        (motion, rotation): (&GroundMotion, &Record),
    ) -> Result<Model, FeError> {
        if let Some((reason, help)) = turned::turns_no_base(case, options) {
            return Err(FeError::Unsupported(format!("{}: {reason}; {help}", rotation.name)));
        }
        let grid = self.grid(motion, Integrator::Modal)?;
        let turned = Turned::driven(&self.horizontal, case, &grid, (&motion.horizontal, rotation))?;
        Ok(Model { turned: Some(turned), ..self })
    }

    /// m = 1 on a fixed base.
    pub(crate) fn held(&self) -> &Harmonic {
        self.fixed.as_ref().unwrap_or(&self.horizontal)
    }

    /// The systems on a fixed base, m = 1 first.
    pub(crate) fn held_systems(&self) -> impl Iterator<Item = &Harmonic> {
        std::iter::once(self.held()).chain(&self.vertical)
    }

    /// The same on a fixed base.
    pub(crate) fn on_fixed_base(&self) -> Cow<'_, Model> {
        match &self.fixed {
            None => Cow::Borrowed(self),
            Some(fixed) => Cow::Owned(Model { horizontal: fixed.clone(), fixed: None, ..self.clone() }),
        }
    }

    /// The systems: m = 1, then m = 0, then m = 1 under the rotation of its base.
    pub(crate) fn systems(&self) -> impl Iterator<Item = &Harmonic> {
        let turned = self.turned.as_ref().map(|turned| &turned.harmonic);
        std::iter::once(&self.horizontal).chain(&self.vertical).chain(turned)
    }

    /// Circular frequency of the fastest significant mode [rad/s]: under the rotation of the base the modes are those of m = 1, with factors
    /// that say nothing of a mass.
    pub(crate) fn fastest(&self) -> f64 {
        let systems = std::iter::once(&self.horizontal).chain(&self.vertical);
        systems.map(Harmonic::significant).fold(0.0, f64::max)
    }

    /// Whether system `number` goes with cos θ.
    pub(crate) fn is_odd(&self, number: usize) -> bool {
        number != 1 || self.vertical.is_none()
    }

    /// The motion of each system on a grid, under a horizontal record and a vertical one.
    pub(crate) fn motions(&self, (horizontal, vertical): (&Record, Option<&Record>), grid: &Grid) -> Vec<Motion> {
        let vertical = vertical.map(|record| Motion::new(record, grid));
        match &self.turned {
            None => std::iter::once(Motion::new(horizontal, grid)).chain(vertical).collect(),
            Some(turned) => {
                let [along, rotation] = turned.motions(grid);
                std::iter::once(along).chain(vertical).chain([rotation]).collect()
            }
        }
    }

    /// The modes kept of each system; those of the rotation are those of the translation.
    pub(crate) fn kept(&self, wave_modes: usize) -> Vec<Vec<&CoupledMode>> {
        let own = std::iter::once(&self.horizontal).chain(&self.vertical);
        let mut kept: Vec<Vec<&CoupledMode>> =
            own.map(|h| superpose::keep(&h.coupled, &h.modes, &self.damper, wave_modes)).collect();
        if let Some(turned) = &self.turned {
            let same = |mode: &&CoupledMode| kept[0].iter().any(|k| (k.kind, k.number) == (mode.kind, mode.number));
            kept.push(turned.harmonic.modes.iter().filter(same).collect());
        }
        kept
    }

    /// A probe of m = 1 with the same probe under the rotation of the base.
    pub(crate) fn odd<'a>(&'a self, probe: &'a Probe) -> Observable<'a> {
        let same = self.turned.as_ref().and_then(|turned| {
            let coupled = &turned.harmonic.coupled;
            coupled.probes.iter().find(|p| p.channel == probe.channel)
        });
        self.with_rotation(vec![(0, 1.0, probe)], 1.0, same)
    }

    /// The observable with the same probe under the rotation of the base.
    fn with_rotation<'a>(
        &'a self,
        mut observable: Observable<'a>,
        factor: f64,
        same: Option<&'a Probe>,
    ) -> Observable<'a> {
        observable.extend(same.map(|probe| (1 + usize::from(self.vertical.is_some()), factor, probe)));
        observable
    }

    /// Place `i` of a line of m = 1 (of the shear as well), with the same place under the rotation of the base, both times `share`.
    pub(crate) fn odd_on_line<'a>(&'a self, line: &'a ProbeLine, i: usize, share: f64) -> Observable<'a> {
        let same = self.turned.as_ref().and_then(|turned| {
            let coupled = &turned.harmonic.coupled;
            let mut lines = coupled.lines.iter().chain(&coupled.shear);
            lines.find(|l| l.what == line.what && l.z == line.z).map(|l| &l.probes[i])
        });
        self.with_rotation(vec![(0, share, &line.probes[i])], share, same)
    }

    /// Time steps of an analysis by `integrator` under `motion`.
    ///
    /// Errors: more samples or steps than [`estimate::MOST_SAMPLES`] and [`estimate::MOST_STEPS`], which an estimate without
    /// the modes may not have seen.
    pub(crate) fn grid(&self, motion: &GroundMotion, integrator: Integrator) -> Result<Grid, FeError> {
        let omega = self.fastest();
        let (steps, most) = match integrator {
            Integrator::Modal => (SUB_STEPS_PER_PERIOD, MOST_MODAL),
            Integrator::Newmark => (direct::STEPS_PER_PERIOD, MOST_DIRECT),
        };
        let dt = motion.horizontal.dt;
        let longest = if omega > 0.0 { (std::f64::consts::TAU / omega / steps).max(dt / most) } else { dt };
        let period = |m: &CoupledMode| std::f64::consts::TAU / m.omega;
        let tail = match self.whole {
            true => 0.0,
            false => AfterRecord::DEFAULT.duration(self.horizontal.first(Kind::Sloshing).map_or(0.0, period)),
        };
        let duration = motion.duration();
        let mut grid = Grid::new(dt, duration, tail, longest);
        if let Some(turned) = &self.turned {
            grid.sub_steps = turned.sub_steps * grid.sub_steps.div_ceil(turned.sub_steps);
        }
        let samples = (duration + tail) / dt;
        estimate::check_steps("harmonic run", samples, samples * grid.sub_steps as f64)?;
        Ok(grid)
    }

    /// `probe` of m = 1 at θ = 0 (or 180°), with the probe of the same id of m = 0 where there is one.
    pub(crate) fn observable<'a>(&'a self, probe: &'a Probe, opposite: bool) -> Observable<'a> {
        let of = |v: &'a Harmonic| v.coupled.probes.iter().find(|p| p.channel == probe.channel);
        around(self.odd(probe), self.vertical.as_ref().and_then(of), opposite)
    }

    /// Probe `i` of `line` of m = 1 at θ = 0 (or 180°), with that of m = 0 (whose wall has the same heights).
    pub(crate) fn observable_on_line<'a>(&'a self, line: &'a ProbeLine, i: usize, opposite: bool) -> Observable<'a> {
        let of = |v: &'a Harmonic| {
            let same = v.coupled.lines.iter().find(|l| l.what == line.what && l.z == line.z);
            same.map(|l| &l.probes[i])
        };
        around(self.odd_on_line(line, i, 1.0), self.vertical.as_ref().and_then(of), opposite)
    }
}

/// cos θ of m = 1 changes sign on the opposite side, m = 0 does not.
fn around<'a>(odd: Observable<'a>, vertical: Option<&'a Probe>, opposite: bool) -> Observable<'a> {
    let turned = odd.into_iter().map(|(system, factor, probe)| {
        let factor = factor * probe.turn.map_or(1.0, |turn| turn.along);
        (system, if opposite { -factor } else { factor }, probe)
    });
    let mut terms: Observable<'a> = turned.collect();
    terms.extend(vertical.map(|v| (1, 1.0, v)));
    terms
}

/// A scalar that gets a history.
#[derive(Clone, Debug)]
pub(crate) struct Scalar<'a> {
    /// Channel.
    pub channel: Channel,
    /// Value in the static state.
    pub static_value: f64,
    /// Output.
    pub observable: Observable<'a>,
}

impl Model {
    /// Scalars with a history; `hoop` is the place on the hoop line where the hoop stress is largest.
    pub(crate) fn scalars(&self, hoop: Option<usize>) -> Vec<Scalar<'_>> {
        let coupled = &self.horizontal.coupled;
        let scalar =
            |probe: &Probe, channel, observable| Scalar { channel, static_value: probe.static_value, observable };
        let mut scalars = Vec::new();
        // A corner of a box has histories of both components together alone.
        let corner = |probe: &&Probe| matches!(probe.channel, Channel::WaveAround { .. });
        for probe in coupled.probes.iter().filter(|probe| !corner(probe)) {
            scalars.push(scalar(probe, probe.channel, self.observable(probe, false)));
            // The wave at θ = 180° has a separate history.
            if let Channel::Wave(Side::Front) = probe.channel {
                let opposite = self.observable(probe, true);
                scalars.push(scalar(probe, Channel::Wave(Side::Back), opposite));
            }
        }
        let what = OnWall::Hoop;
        if let (Some(i), Some(line)) = (hoop, coupled.line(what)) {
            let channel = Channel::Largest { what, z: line.z[i] };
            let observable = self.observable_on_line(line, i, false);
            scalars.push(scalar(&line.probes[i], channel, observable));
        }
        scalars
    }
}
