//! Whether a run of a wall is still one of its model, looked at after every step.
//!
//! | limit | value | why |
//! |---|---|---|
//! | strain of a bar | ε_su of its law, else [`BAR_STRAIN`] | beyond it the bar has ruptured; the law continues its hardening |
//! | (damping + inertia)/section, moments at the base | [`MOMENT_SHARE`] | the reaction exceeds the resistance of the section |
//! | acceleration of a node | [`ACCELERATION`] | waves shorter than the thickness of the wall are not bending |
//! | E_int − E_hyst + E₀ | −[`ENERGY_SHARE`] of the largest energy | stored energy cannot be negative |
//!
//! **Stored energy.** E_int = Σ f̄·Δu is the work that the scheme does on the internal forces. While steps resolve the path of
//! every fibre it is stored or dissipated, E_int − E_hyst ≥ −E₀, E₀ ≤ p_c·u₀ the energy stored at rest. A crack that closes
//! and opens in less than a step is not resolved: the stiffness jumps from that of the bars to that of the concrete, f̄ is the
//! mean of the two ends, and a scheme that is stable for linear systems gains energy (Kuhl & Crisfield 1999; Erlicher,
//! Bonaventura & Bursi 2002). Modes that are not damped keep it. The balance of energies closes all the same, since it holds
//! for any f̄; stored energy does not. Later results are meaningless, and the run stops.

use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::analysis::march::Instant;
use fem::element::{Inspect, Inspection};
use results::nonlinear::{Departure, DepartureKind, Passed};

use super::model::{BaseReaction, StripModel};
use super::placed::PlacedWall;

/// Strain of a bar whose strain at rupture is not given: the least characteristic strain at the greatest force of any class
/// (class A).
///
/// Source: EN 1992-1-1:2004, annex C, table C.1.
pub const BAR_STRAIN: f64 = 0.025;

/// Damping and inertia over the section's own moment at the base, at the largest reaction. Chosen: with damping by group of 5 %
/// of a strip 8.4 that yields the share is 0.2 to 0.3, with mass-proportional damping below 1e-3.
pub const MOMENT_SHARE: f64 = 0.5;

/// Total acceleration of a node [m/s²], 500 times that of free fall. Chosen: a slice of concrete as long as a wall of 0.3 m is
/// thick then needs 3.7 MPa to be moved, its tensile strength; such waves do not keep sections plane. Fractures of strip
/// 8.4 without softening stay below 1,600 m/s², runs that have gained energy pass 10⁵ m/s².
pub const ACCELERATION: f64 = 500.0 * oscillator::STANDARD_GRAVITY;

/// Share of the largest energy by which the stored energy may fall below zero. Chosen: strip 8.4 keeps within 1e-3, and passes
/// the limit within milliseconds where it does not.
pub const ENERGY_SHARE: f64 = 0.05;

/// Kinds of departures, in the order of the numbers that checkpoints hold.
const KINDS: [DepartureKind; 4] =
    [DepartureKind::BarStrain, DepartureKind::MomentBalance, DepartureKind::Acceleration, DepartureKind::StoredEnergy];

/// Bar closest to its limit.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BarStrain {
    ratio: f64,
    strain: f64,
    height: f64,
}

impl BarStrain {
    /// Takes in a bar.
    pub(crate) fn see(&mut self, bar: &Inspection) {
        let strain = bar.strain[0];
        let ratio = match bar.state.rupture {
            0.0 => strain / BAR_STRAIN,
            given => given,
        };
        if ratio > self.ratio {
            *self = BarStrain { ratio, strain, height: bar.position[2] };
        }
    }
}

/// Looks at a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Validity {
    /// Dissipated energy and work of the loads at rest [J per m], once it has begun.
    start: Option<[f64; 2]>,
    /// Largest energy so far [J per m].
    largest: f64,
    /// Work on the joints that act at the end of a step [J per m]: losses at contact are not energy of the wall. With displacements
    /// and forces of the last step.
    joints: f64,
    before: [Vec<f64>; 2],
    /// Largest reaction and largest moment of the section at the base so far [N].
    moments: [f64; 2],
    found: Vec<Departure>,
}

impl Validity {
    /// Takes in a committed step, with the reaction at the base and the worst bar.
    pub(crate) fn see(
        &mut self,
        (strip, wall): (&StripModel, &PlacedWall),
        now: &Instant<'_>,
        reaction: &BaseReaction,
        bar: BarStrain,
    ) {
        let elements = strip.model.elements().iter().enumerate();
        let dissipated: f64 =
            elements.map(|(e, element)| element.dissipated(&now.state.old[now.state.history(e)])).sum();
        let [at_start, rest] = *self.start.get_or_insert_with(|| {
            let load = strip.at_rest();
            let work: f64 = load.iter().zip(&now.state.committed.u).map(|(p, u)| p * u).sum();
            [dissipated, work.abs()]
        });
        let energies = &now.energies;
        self.largest = self.largest.max(energies.input.abs()).max(energies.kinetic);
        let (u, force) = (&now.state.committed.u, &now.forces.at_end);
        let ([u0, f0], after) = (&self.before, u.iter().zip(force));
        let work: f64 = u0.iter().zip(f0).zip(after).map(|((u0, f0), (u, f))| 0.5 * (f + f0) * (u - u0)).sum();
        self.joints += work;
        if !force.is_empty() {
            self.before = [u.clone(), force.clone()];
        }
        let stored = energies.internal - self.joints - (dissipated - at_start);
        let section = reaction.section[2] + reaction.load[2];
        self.moments[1] = self.moments[1].max(section.abs());
        let total = reaction.total()[2].abs();
        let share = match total > self.moments[0] {
            true => (reaction.damping[2] + reaction.inertia[2]).abs() / self.moments[1],
            false => 0.0,
        };
        self.moments[0] = self.moments[0].max(total);
        let (acceleration, place) = strip.largest_acceleration(wall, &now.state.committed.a, wall.own(now.ground)[0]);
        let energy = -rest - ENERGY_SHARE * self.largest;
        for (kind, passed, height, value, limit) in [
            (DepartureKind::BarStrain, bar.ratio > 1.0, bar.height, bar.strain, bar.strain / bar.ratio),
            (DepartureKind::MomentBalance, share > MOMENT_SHARE, 0.0, share, MOMENT_SHARE),
            (DepartureKind::Acceleration, acceleration > ACCELERATION, place, acceleration, ACCELERATION),
            (DepartureKind::StoredEnergy, stored < energy, place, stored, energy),
        ] {
            if passed && self.found.iter().all(|d| d.kind != kind) {
                self.found.push(departure(kind, now.time, height, Passed { value, limit }));
            }
        }
    }

    /// The first of each kind, by time.
    pub(crate) fn found(&self) -> &[Departure] {
        &self.found
    }

    /// Why the run ends.
    pub(crate) fn stop(&self) -> Option<String> {
        let reason = "the time integration gains energy: the results are no longer valid".to_owned();
        self.found.iter().any(|d| d.kind.stops()).then_some(reason)
    }

    pub(crate) fn save(&self, to: &mut Writer) {
        let [dissipated, rest] = self.start.unwrap_or([f64::NAN; 2]);
        let [reaction, section] = self.moments;
        to.numbers(&[dissipated, rest, self.largest, reaction, section, self.joints]);
        self.before.iter().for_each(|field| to.numbers(field));
        let mut all = Vec::new();
        for d in &self.found {
            let (value, limit) = d.passed.map_or((0.0, 0.0), |p| (p.value, p.limit));
            all.extend([d.kind as usize as f64, d.time, d.height, value, limit]);
        }
        to.numbers(&all);
    }

    pub(crate) fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        let mut kept = [0.0; 6];
        from.numbers_into("limits of the model", &mut kept)?;
        let [dissipated, rest, largest, reaction, section, joints] = kept;
        self.joints = joints;
        self.before = [from.numbers("displacements")?, from.numbers("forces of the joints")?];
        self.start = (!dissipated.is_nan()).then_some([dissipated, rest]);
        (self.largest, self.moments) = (largest, [reaction, section]);
        let kind = |k: f64| KINDS.into_iter().find(|d| *d as usize as f64 == k);
        let departure = |d: &[f64]| {
            let passed = Passed { value: d[3], limit: d[4] };
            Some(departure(kind(d[0])?, d[1], d[2], passed))
        };
        let all = from.numbers("departures")?;
        self.found = all.chunks_exact(5).filter_map(departure).collect();
        Ok(())
    }
}

/// A departure of one wall.
fn departure(kind: DepartureKind, time: f64, height: f64, passed: Passed) -> Departure {
    Departure { kind, time, theta: None, height, passed: Some(passed) }
}

/// The first of each kind, by time.
pub(super) fn first_of(all: impl Iterator<Item = Departure>) -> Vec<Departure> {
    let mut all: Vec<Departure> = all.collect();
    all.sort_by(|a, b| a.time.total_cmp(&b.time));
    let mut first: Vec<Departure> = Vec::new();
    for departure in all {
        if first.iter().all(|d| d.kind != departure.kind) {
            first.push(departure);
        }
    }
    first
}
