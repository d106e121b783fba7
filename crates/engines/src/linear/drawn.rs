//! Wall and free surface of the harmonic engine at moments, for pictures.
//!
//! ```text
//! cylinder   radial  w₀ + w cos θ       around  v sin θ       axial  u₀ + u cos θ       surface  η₀ + η cos θ
//! box        along x ± w₀ + w at the walls x = ± L/2, whose axial displacement is u₀; the side walls are rigid; a strip has none
//! ```
//!
//! The amplitudes are combinations of the modal states, also where the histories of the run are integrated directly. The surface has the sloshing modes that
//! count for the wave height. A component along y is the same turned by 90°. The base adds its own motion: slab, isolators, or a bottom that lifts.
//! The surface stays level where the base turns.

mod mesh;
mod rows;

use results::{Channel, DrawnMode, Resultants, Snapshot, Snapshots};
use tank::Case;
use tank::case::GroundMotion;
use tank::options::LinearOptions;
use tank::options::linear::Integrator;

use super::analysis::Analysis;
use super::demands::{combine, stride};
use super::isolation::Isolated;
use super::model::Model;
use super::rocking::Bottom;
use crate::FeError;
use crate::modes::{CoupledMode, Kind};
use crate::response::superpose::Combined;
use mesh::{Mesh, Spot};
use rows::{Amplitude, Rows};

/// Modes of a kind and harmonic that are drawn.
const MODES: usize = 3;
/// States in the first period of the wall about the largest base shear, and most of them.
const CLOSE: (f64, f64) = (5.0, 200.0);

/// Times of the states that are kept for pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pictures {
    /// Time between two of them [s].
    pub every: f64,
    /// Whether there are more where the base shear is largest, if `every` does not resolve the first period of the wall.
    pub close: bool,
}

/// What is drawn.
pub(super) struct Drawn<'a> {
    pub case: &'a Case,
    /// The model of the response, on the base that moves where one does.
    pub model: &'a Model,
    /// The motion that drives it.
    pub motion: &'a GroundMotion,
    pub options: &'a LinearOptions,
    pub analysis: &'a Analysis<'a>,
    pub bottom: Option<&'a Bottom>,
    pub isolated: Option<&'a Isolated>,
}

/// Motion of the base as a rigid body: along x and y, upwards, and the turns that move its top along x and y; height above its axis is z + `below`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Rigid {
    along: [f64; 2],
    up: f64,
    turn: [f64; 2],
    below: f64,
}

impl Rigid {
    fn at(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let arm = z + self.below;
        let level = self.along.iter().zip(self.turn).map(|(d, turn)| d + turn * arm);
        let mut out = [0.0, 0.0, self.up - self.turn[0] * x - self.turn[1] * y];
        out.iter_mut().zip(level).for_each(|(o, d)| *o = d);
        out
    }
}

/// The amplitudes of all rows at one moment: of m = 1 under the motion along x and along y, of m = 0.
struct Moment<'a> {
    along: &'a [f64],
    across: Option<&'a [f64]>,
}

impl Moment<'_> {
    fn of(&self, amplitude: Amplitude) -> [f64; 3] {
        let across = self.across.map_or(0.0, |values| values[amplitude.odd]);
        [self.along[amplitude.odd], across, amplitude.even.map_or(0.0, |i| self.along[i])]
    }

    /// Even in θ: even + X cos θ + Y sin θ.
    fn even(&self, amplitude: Amplitude, [c, s]: [f64; 2]) -> f64 {
        let [x, y, even] = self.of(amplitude);
        even + x * c + y * s
    }

    /// Odd in θ: X sin θ − Y cos θ.
    fn odd(&self, amplitude: Amplitude, [c, s]: [f64; 2]) -> f64 {
        let [x, y, _] = self.of(amplitude);
        x * s - y * c
    }
}

impl Drawn<'_> {
    /// States about every so many seconds until the record ends and the last of the largest values is reached, those moments included.
    ///
    /// Errors: a response that is not finite.
    pub(super) fn states(&self, pictures: Pictures) -> Result<Snapshots, FeError> {
        let mesh = Mesh::of(self.case, self.model);
        let rows = Rows::of(self.model, &mesh, self.options.wave_modes);
        let observables = rows.observables(self.model);
        let grid = self.model.grid(self.motion, Integrator::Modal)?;
        let stride = stride(self.model, &grid);
        let kept = self.model.kept(self.options.wave_modes);
        let of = |record| {
            let records = (record, self.motion.vertical.as_ref());
            combine(self.model, &kept, records, (grid, stride), &observables)
        };
        let along = of(&self.motion.horizontal)?;
        let across = self.motion.transverse.as_ref().filter(|_| mesh.round).map(of).transpose()?;
        let moments = self.moments(pictures, grid.h() * stride as f64, grid.steps() / stride);
        let at = |found: &Combined, k: usize| -> Vec<f64> {
            let value = |terms: &Vec<(usize, f64)>| terms.iter().map(|&(s, c)| c * found.states[s][k]).sum();
            found.terms.iter().map(value).collect()
        };
        let times: Vec<f64> = moments.iter().map(|k| grid.time(k * stride)).collect();
        let states = moments.iter().zip(&times).map(|(&k, &time)| {
            let (along, across) = (at(&along, k), across.as_ref().map(|found| at(found, k)));
            let moment = Moment { along: &along, across: across.as_deref() };
            self.state(time, &moment, &mesh, &rows)
        });
        let mut out = Snapshots {
            states: states.collect(),
            nodes: mesh.nodes.clone(),
            wall: mesh.wall.clone(),
            sides: mesh.sides.clone(),
            thickness: mesh.cells.iter().map(|cell| cell.thickness).collect(),
            surface: mesh.surface.clone(),
            modes: self.modes(&mesh),
            ..Snapshots::default()
        };
        if let Some(bottom) = self.bottom {
            join(&mut out, bottom.states(&times));
        }
        Ok(out)
    }

    /// Numbers of the instants that are kept, of `count` after rest, `step` [s] apart.
    fn moments(&self, Pictures { every, close }: Pictures, step: f64, count: usize) -> Vec<usize> {
        let counts = |channel: Channel| {
            channel.is_wave_at_wall()
                || matches!(channel, Channel::BaseShear | Channel::OverturningMoment | Channel::Largest { .. })
        };
        let seen = self.analysis.scalars.iter().filter(|(scalar, _)| counts(scalar.channel));
        let peaks: Vec<f64> = seen
            .map(|(scalar, history)| match scalar.channel.is_wave_at_wall() {
                true => history.extreme.max_time,
                false => history.extreme.peak().1,
            })
            .collect();
        let end = peaks.iter().copied().fold(self.motion.duration(), f64::max);
        let close = close.then(|| self.close(every)).flatten();
        let close = close.into_iter().flatten().filter(|time| (0.0..=end).contains(time));
        let place = |time: f64| ((time / step).round() as usize).min(count);
        let even = (0..).map(|i| f64::from(i) * every).take_while(|time| *time <= end * (1.0 + 1e-9));
        let mut moments: Vec<usize> = even.chain(peaks.iter().copied()).chain(close).map(place).collect();
        moments.sort_unstable();
        moments.dedup();
        moments
    }

    /// Times about the largest base shear that resolve the first period of the wall, where `every` does not.
    fn close(&self, every: f64) -> Option<impl Iterator<Item = f64> + use<>> {
        let (in_a_period, most) = CLOSE;
        let structural = self.model.horizontal.modes.iter().filter(|m| m.kind == Kind::Structural);
        let omega = structural.map(|m| m.omega).fold(f64::INFINITY, f64::min);
        let spacing = std::f64::consts::TAU / omega / in_a_period;
        let shear = self.analysis.scalars.iter().find(|(scalar, _)| scalar.channel == Channel::BaseShear);
        let peak = shear.map(|(_, history)| history.extreme.peak().1)?;
        let first = (peak - 0.5 * most * spacing).max(0.0);
        let times = (0..most as u32).map(move |i| first + f64::from(i) * spacing);
        (omega.is_finite() && every > 1.25 * spacing).then_some(times)
    }

    fn state(&self, time: f64, moment: &Moment<'_>, mesh: &Mesh, rows: &Rows) -> Snapshot {
        let rigid = self.rigid(time, moment, rows);
        let now = self.bottom.map(|bottom| bottom.at(time));
        // The waves of a foot that warps; the ovalling that goes with them above is not drawn.
        let warped = |[c, s]: [f64; 2]| {
            now.as_ref().map_or(0.0, |now| {
                let radius = self.case.tank.shape.half_length();
                now.turn.rim_at(radius, now.rotation, s.atan2(c)) - (now.turn.centre - now.rotation * radius * c)
            })
        };
        let displacement = mesh.spots.iter().zip(&mesh.nodes).map(|(spot, place)| {
            let base = rigid.at(*place);
            match *spot {
                Spot::Wall { level, at } => {
                    let [w, v, u] = rows.levels[level];
                    let (out, around) = (moment.even(w, at), moment.odd(v, at));
                    let [c, s] = at;
                    let up = moment.even(u, at) + base[2] + warped(at);
                    [out * c - around * s + base[0], out * s + around * c + base[1], up]
                }
                Spot::Surface { ring, at } => [base[0], base[1], moment.even(rows.rings[ring], at)],
                Spot::Rigid => base,
            }
        });
        let resultants = mesh.cells.iter().map(|cell| {
            let row = &rows.cells[cell.level];
            let of = |amplitude: Option<Amplitude>| amplitude.map_or(f64::NAN, |a| moment.even(a, cell.at));
            let t = cell.thickness;
            Resultants {
                n_phi: of(row.hoop) * t,
                n_v: of(row.axial) * t,
                n_phi_v: row.shear.map_or(f64::NAN, |a| moment.odd(a, cell.at)),
                m_phi: f64::NAN,
                m_v: of(row.bending) * t * t / 6.0,
                m_phi_v: f64::NAN,
                q_v: f64::NAN,
            }
        });
        let pressure = mesh.cells.iter().map(|cell| {
            let row = rows.cells[cell.level].pressure;
            row.map_or(0.0, |a| moment.even(a, cell.at))
        });
        Snapshot {
            time,
            displacement: displacement.collect(),
            resultants: resultants.collect(),
            on_wall: pressure.collect(),
            ..Snapshot::default()
        }
    }

    /// The motion of the base.
    fn rigid(&self, time: f64, moment: &Moment<'_>, rows: &Rows) -> Rigid {
        if let Some(now) = self.bottom.map(|bottom| bottom.at(time)) {
            return Rigid { along: [now.slip, 0.0], up: now.turn.centre, turn: [now.rotation, 0.0], below: 0.0 };
        }
        if let Some(found) = self.isolated {
            return Rigid { along: found.displacement(time), ..Rigid::default() };
        }
        let Some([shift, turn]) = rows.slab else { return Rigid::default() };
        let both = |amplitude| {
            let [x, y, _] = moment.of(amplitude);
            [x, y]
        };
        let below = self.case.tank.foundation.and_then(|f| f.thickness).unwrap_or(0.0);
        Rigid { along: both(shift), up: 0.0, turn: both(turn), below }
    }

    /// The first modes of each kind on a fixed base.
    fn modes(&self, mesh: &Mesh) -> Vec<DrawnMode> {
        let mut drawn = Vec::new();
        for harmonic in self.model.held_systems() {
            for kind in [Kind::Sloshing, Kind::Structural] {
                let own = harmonic.modes.iter().filter(|m| m.kind == kind && m.number <= MODES);
                drawn.extend(own.map(|mode| {
                    let shape = mesh.shape(&harmonic.coupled, &mode.vector);
                    DrawnMode::new(title(mode, harmonic.coupled.harmonic, mesh.round), mode.omega, shape)
                }));
            }
        }
        drawn
    }
}

fn title(mode: &CoupledMode, harmonic: u32, round: bool) -> String {
    let kind = match mode.kind {
        Kind::Sloshing => "Sloshing",
        Kind::Structural | Kind::Rotational => "Wall and liquid",
    };
    let waves = match (harmonic, round) {
        (0, true) => "axisymmetric",
        (0, false) => "symmetric",
        (_, true) => "cos θ",
        (_, false) => "along x",
    };
    format!("{kind}, {waves}, mode {}", mode.number)
}

/// Adds the bottom and its states, one for each of the wall.
fn join(out: &mut Snapshots, bottom: Snapshots) {
    let (first, count) = (out.nodes.len(), bottom.nodes.len());
    out.nodes.extend(bottom.nodes);
    out.bottom = bottom.bottom.iter().map(|cell| cell.map(|n| first + n)).collect();
    out.modes.iter_mut().for_each(|mode| mode.displacement.extend(std::iter::repeat_n([0.0; 3], count)));
    for (state, own) in out.states.iter_mut().zip(bottom.states) {
        state.displacement.extend(own.displacement);
        state.ground = vec![0.0; first];
        state.ground.extend(own.ground);
        state.plastic = own.plastic;
    }
}

#[cfg(test)]
mod tests;
