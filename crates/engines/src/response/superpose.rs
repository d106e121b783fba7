//! Modal superposition, exact for ground motion that is linear between samples, with missing mass.
//!
//! ```text
//! x = Σ Γ_j φ_j D_j + x_r        D̈_j + 2 ξ_j ω_j Ḋ_j + ω_j² D_j = −a_g
//! x_r = −a_g [K⁻¹ M ι − Σ Γ_j φ_j/ω_j²]
//! ```
//!
//! D_j follows from the exact recurrence of [`oscillator::sdof::Recurrence`] with the mode's own damping. Modes that are not
//! kept follow the ground statically (the missing mass): their part of K⁻¹ M ι stays in x_r, and their relative
//! acceleration vanishes, so that ẍ_total = Σ Γ_j φ_j D̈_j + ι a_g. An output y = d·x + a·ẍ_total + b a_g becomes a
//! combination of the states D_j, Ḋ_j and a_g, and so does its slope:
//!
//! ```text
//! y = Σ (p_j − ω_j² q_j) D_j − Σ 2 ξ_j ω_j q_j Ḋ_j + [a·ι + b − Σ q_j − d·r] a_g
//! p_j = Γ_j d·φ_j        q_j = Γ_j a·φ_j        r = K⁻¹ M ι − Σ Γ_j φ_j/ω_j²
//! ```
//!
//! Source: Nigam & Jennings 1969; missing mass after Kennedy 1984 and Clough & Penzien 1993, section 12-6 (static
//! correction).

use fem::progress::Progress;
use oscillator::sdof::Recurrence;

use super::motion::{Grid, Motion};
use super::observe::{Chunk, Observed, Observer, Row, Slope};
use crate::FeError;
use crate::coupled::Coupled;
use crate::damping::Damper;
use crate::harmonic::{CoupledMode, Kind, failure};
use crate::probe::{ModeSelection, Probe};
use fem::linalg::{Cholesky, dot};

/// Modes kept by default: all up to this multiple of the first structural frequency.
pub const FREQUENCY_FACTOR: f64 = 6.0;
/// Sloshing modes kept at least.
pub const SLOSHING_MODES: usize = 10;
/// Structural modes kept at least.
pub const STRUCTURAL_MODES: usize = 4;

/// A quantity to be observed: Σ factor × probe of a system (by its number).
pub type Observable<'a> = Vec<(usize, f64, &'a Probe)>;

/// A coupled system in its modes.
#[derive(Clone, Debug)]
pub struct ModalSystem<'a> {
    system: &'a Coupled,
    modes: Vec<&'a CoupledMode>,
    damping: Vec<f64>,
    /// r of the module's theory.
    residual: Vec<f64>,
}

/// The modes to keep of `modes` for `damper`: up to [`FREQUENCY_FACTOR`] × the first structural frequency, at least
/// [`SLOSHING_MODES`] sloshing and [`STRUCTURAL_MODES`] structural ones; all of them with Rayleigh damping, whose highest
/// modes are so strongly damped that they do not follow the ground statically.
///
/// Peaks of every output then differ from those of all modes by less than 0.1 % (measured on tanks 8.1, 8.3 and strip 8.4:
/// 0.002 %, 0.02 %, 0.02 %; three times the first structural frequency would leave 0.02 %, 0.16 %, 0.36 %).
pub fn keep<'a>(modes: &'a [CoupledMode], damper: &Damper, wave_modes: usize) -> Vec<&'a CoupledMode> {
    let limit = match (damper, modes.iter().find(|m| m.kind == Kind::Structural)) {
        (Damper::ByKind { .. }, Some(first)) => FREQUENCY_FACTOR * first.omega,
        _ => f64::INFINITY,
    };
    let least = |kind: Kind| match kind {
        Kind::Sloshing => SLOSHING_MODES.max(wave_modes),
        Kind::Structural => STRUCTURAL_MODES,
        Kind::Rotational => 0,
    };
    modes
        .iter()
        .filter(|m| m.omega <= limit || m.number <= least(m.kind))
        .collect()
}

impl<'a> ModalSystem<'a> {
    /// The system in the given modes; the others follow statically.
    ///
    /// Errors: a stiffness matrix that is not positive definite.
    pub fn new(system: &'a Coupled, modes: Vec<&'a CoupledMode>, damper: &Damper) -> Result<ModalSystem<'a>, FeError> {
        let load = system.mass.times(&system.influence);
        let mut residual = Cholesky::factor(&system.stiffness)
            .map_err(failure("the coupled stiffness matrix"))?
            .solve_vector(&load);
        for mode in &modes {
            let factor = mode.participation / (mode.omega * mode.omega);
            for (r, phi) in residual.iter_mut().zip(&mode.vector) {
                *r -= factor * phi;
            }
        }
        Ok(ModalSystem {
            system,
            damping: modes.iter().map(|m| damper.ratio(m.kind, m.omega)).collect(),
            modes,
            residual,
        })
    }

    /// Number of states: D_j, Ḋ_j, a_g.
    fn states(&self) -> usize {
        2 * self.modes.len() + 1
    }

    /// Adds `factor` × `probe` to `row`, with the states of this system starting at `offset`.
    fn observe(&self, probe: &Probe, factor: f64, offset: usize, row: &mut Row) {
        let slope = row.slope.get_or_insert_with(Slope::default);
        let n = self.modes.len();
        let ground = offset + 2 * n;
        let counts = |mode: &CoupledMode| match probe.modes {
            ModeSelection::All => true,
            ModeSelection::FirstSloshing(most) => mode.kind == Kind::Sloshing && mode.number <= most,
        };
        let (d, a) = (&probe.displacement, &probe.absolute_acceleration);
        let mut rigid = match probe.modes {
            ModeSelection::All => dot(a, &self.system.influence) + probe.ground_acceleration - dot(d, &self.residual),
            // Selected modes only: their total acceleration is Γ φ (D̈ + a_g).
            ModeSelection::FirstSloshing(_) => 0.0,
        };
        for (j, mode) in self.modes.iter().enumerate().filter(|(_, mode)| counts(mode)) {
            let p = mode.participation * dot(d, &mode.vector);
            let q = mode.participation * dot(a, &mode.vector);
            let (c, k) = (2.0 * self.damping[j] * mode.omega, mode.omega * mode.omega);
            if probe.modes == ModeSelection::All {
                rigid -= q;
            }
            let (on_d, on_v) = (factor * (p - k * q), -factor * c * q);
            row.value.push((offset + j, on_d));
            // ẏ = on_d Ḋ + on_v (−a_g − c Ḋ − k D)
            slope.states.push((offset + n + j, on_d - c * on_v));
            if on_v != 0.0 {
                row.value.push((offset + n + j, on_v));
                slope.states.push((offset + j, -k * on_v));
                slope.states.push((ground, -on_v));
            }
        }
        if rigid != 0.0 {
            row.value.push((ground, factor * rigid));
            slope.linear.push((ground, factor * rigid));
        }
    }
}

/// Rows of `observables` over the states of `systems`, which follow one another.
fn rows(systems: &[ModalSystem], observables: &[Observable]) -> Vec<Row> {
    let offsets: Vec<usize> = systems
        .iter()
        .scan(0, |next, s| {
            let offset = *next;
            *next += s.states();
            Some(offset)
        })
        .collect();
    observables
        .iter()
        .map(|terms| {
            let mut row = Row::default();
            for &(system, factor, probe) in terms {
                systems[system].observe(probe, factor, offsets[system], &mut row);
            }
            row
        })
        .collect()
}

/// Response of `systems` to `motions` (one each): histories of `scalars`, extremes of `others`.
///
/// Errors: a response that is not finite, with its time.
pub fn respond(
    systems: &[ModalSystem],
    motions: &[&Motion],
    grid: Grid,
    scalars: &[Observable],
    others: &[Observable],
    progress: &dyn Progress,
) -> Result<Observed, FeError> {
    let (scalars, others) = (rows(systems, scalars), rows(systems, others));
    let mut observer = Observer::new(&scalars, &others, grid);
    let recurrences: Vec<Vec<Recurrence>> = systems
        .iter()
        .map(|s| {
            let step = |(mode, &damping): (&&CoupledMode, &f64)| Recurrence::new(mode.omega, damping, grid.h());
            s.modes.iter().zip(&s.damping).map(step).collect()
        })
        .collect();
    let mut chunk = Chunk::new(systems.iter().map(ModalSystem::states).sum());
    // States at the first instant of the chunk, (D, Ḋ) mode by mode.
    let mut now: Vec<Vec<(f64, f64)>> = systems.iter().map(|s| vec![(0.0, 0.0); s.modes.len()]).collect();
    let mut load = Vec::with_capacity(Chunk::LENGTH);
    while chunk.start < grid.steps() {
        chunk.len = (grid.steps() - chunk.start).min(Chunk::LENGTH) + 1;
        let mut offset = 0;
        for ((system, motion), (steps, now)) in systems.iter().zip(motions).zip(recurrences.iter().zip(&mut now)) {
            let n = system.modes.len();
            load.clear();
            load.extend((chunk.start..chunk.start + chunk.len - 1).map(|i| motion.interval(i)));
            for (j, (step, state)) in steps.iter().zip(now.iter_mut()).enumerate() {
                let (d, v) = chunk.pair_mut(offset + j, offset + n + j);
                (d[0], v[0]) = *state;
                for ((d, v), &(a0, a1)) in d[1..].iter_mut().zip(&mut v[1..]).zip(&load) {
                    *state = step.step(state.0, state.1, -a0, -a1);
                    (*d, *v) = *state;
                }
            }
            let start = chunk.start;
            for (k, a) in chunk.state_mut(offset + 2 * n).iter_mut().enumerate() {
                *a = motion.at(start + k);
            }
            offset += system.states();
        }
        if !chunk.close() {
            return Err(FeError::NotFinite {
                time: grid.time(chunk.start),
                cause: "a mode with negative damping, or ground motion that is not finite".into(),
            });
        }
        observer.take(&chunk);
        progress.advance((chunk.len - 1) as u64);
        chunk.start += chunk.len - 1;
    }
    Ok(observer.finish())
}
