//! Demands of a run: stresses of the cells next to θ = 0 and θ = 180° at the samples of the record.
//!
//! The pressure is the hydrostatic one and, with the motion, that which membrane theory takes from the hoop stress,
//!
//! ```text
//! p(t) = ρ g (H − z) + [σ_θ(t) − σ_θ(0)] t/R
//! ```
//!
//! within 2.5 √(R t) of the base, where the clamped edge takes part of the load, from the first row above.

use std::f64::consts::PI;

use oscillator::record::Record;
use tank::Case;
use tank::demand::{Angles, Demands, Footing, FreeBase, OnWall, Peak, Place, Surface, Terms};

use super::meridian::Meridian;
use super::model::CylinderModel;
use super::recorded::{BASE_SHEAR, UPLIFT_BACK, UPLIFT_FRONT, WAVE_BACK, WAVE_FRONT};
use super::two::{self, SHEAR_Y};
use super::watch::Watch;

/// Length of the disturbance of a clamped edge over √(R t).
const EDGE: f64 = 2.5;

/// Share of the friction from which a base shear counts as capped by it: springs of the ground give way before.
const CAPPED: f64 = 0.95;

/// Common histories under construction.
struct States {
    states: Vec<Vec<f64>>,
    /// Number of samples.
    samples: usize,
}

impl States {
    /// Keeps a history less its first value.
    fn keep(&mut self, history: impl Iterator<Item = f64>) -> Terms {
        self.states.push(history.take(self.samples).collect());
        vec![(self.states.len() - 1, 1.0)]
    }

    /// The histories of both sides as rest, half their sum and half their difference.
    fn sides(&mut self, [front, back]: [&[f64]; 2], factor: f64) -> OnWall {
        let first = |side: &[f64]| side.first().copied().unwrap_or(0.0);
        let rest = 0.5 * factor * (first(front) + first(back));
        let both = || front.iter().zip(back);
        let even = self.keep(both().map(|(a, b)| 0.5 * factor * (a + b) - rest));
        let odd = self.keep(both().map(|(a, b)| 0.5 * factor * (a - b)));
        OnWall { rest, even, odd }
    }
}

/// Demands of what was watched; without places for a wall that is not a metal shell.
pub(super) fn demands(case: &Case, tank: &CylinderModel, watch: &Watch<'_>) -> Demands {
    let recorder = &watch.recorder;
    let sides = &watch.seen.sides;
    let rows = sides.iter().flat_map(|s| &s.hoop_history);
    let samples = rows.map(Vec::len).min().unwrap_or(0).min(recorder.times.len());
    let mut states = States { states: Vec::new(), samples };
    let rest = |k: usize| recorder.histories[k].first().copied().unwrap_or(0.0);
    let own = |k: usize| recorder.histories[k].iter().map(move |v| v - rest(k));
    let base_shear = states.keep(own(BASE_SHEAR));
    let two = case.ground_motion.as_ref().is_some_and(|motion| motion.transverse.is_some());
    let mut found = Vec::new();
    if case.tank.is_metal() {
        let [front, back] = sides;
        found.extend(places(case, tank, ([front, back], 0.0), &mut states));
        let fan = if two { two::fan(&tank.cells) } else { Vec::new() };
        for (ends, columns) in watch.seen.two.meridians.chunks_exact(2).zip(fan.chunks_exact(2)) {
            let turned = tank.cells.angle() * columns[0] as f64;
            found.extend(places(case, tank, ([&ends[0], &ends[1]], turned), &mut states));
        }
    }
    let vertical = case.ground_motion.as_ref().and_then(|motion| motion.vertical.as_ref());
    let vertical = vertical.map(|record| states.keep(recorder.times.iter().map(|t| at(record, *t))));
    let rise = |(k, theta): (usize, f64)| {
        let range = &recorder.ranges[k];
        Peak { value: range.max - rest(k), time: range.max_time, theta }
    };
    let [front, back] = [(WAVE_FRONT, 0.0), (WAVE_BACK, PI)].map(rise);
    let higher = if front.value >= back.value { front } else { back };
    // Only the base shear has a part of its own along y: the places have their meridians.
    let mut transverse = Vec::new();
    if two {
        transverse = vec![Vec::new(); states.states.len()];
        if let Some((state, _)) = base_shear.first() {
            transverse[*state] = own(SHEAR_Y).take(samples).collect();
        }
    }
    let between = if two { two::between_meridians(&tank.cells) } else { 0.0 };
    let step = recorder.times.get(1).copied().unwrap_or(0.0);
    Demands {
        times: recorder.times[..samples].to_vec(),
        states: states.states,
        transverse,
        angles: Angles::Sides,
        places: found,
        wave: (samples > 0).then_some(if two { watch.seen.two.wave() } else { higher }),
        surface: Surface::Linear,
        base_shear: (!slid(case, tank, watch)).then_some(base_shear),
        // The pressure on the bottom is not recorded.
        overturning_moment: None,
        vertical,
        plates: false,
        base: base(case, tank, watch),
        isolation: None,
        footing: Footing::Fixed,
        sampling: 1.0 - (0.5 * tank.wall_omega * step).min(0.5 * PI).cos() + between,
    }
}

/// The foot of a wall on its bottom.
fn base(case: &Case, tank: &CylinderModel, watch: &Watch<'_>) -> Option<FreeBase> {
    tank.standing.as_ref()?;
    let seen = &watch.seen.standing;
    let lifts = [UPLIFT_FRONT, UPLIFT_BACK].iter().any(|k| watch.recorder.ranges[*k].max > 0.0);
    let mut joint = Peak::default();
    for (history, theta) in seen.joint.iter().zip([0.0, PI]) {
        for (value, time) in history.iter().zip(&watch.recorder.times) {
            if value.abs() > joint.value {
                joint = Peak { value: value.abs(), time: *time, theta };
            }
        }
    }
    let anchor = case.tank.anchors.filter(|_| !seen.anchor.is_empty()).and_then(|anchors| {
        let (height, time, theta) = seen.stretched;
        Some(Peak {
            // As if it had stayed elastic.
            value: anchors.stiffness? * (height - anchors.gap.unwrap_or(0.0)).max(0.0),
            time,
            theta,
        })
    });
    // At least one, of the force that it would have had it stayed elastic.
    let breaks = case.tank.anchors.is_some_and(|own| {
        let limit = own.stiffness.zip(own.rupture_elongation).map(|(k, u)| k * u);
        anchor.zip(limit).is_some_and(|(found, limit)| found.value > limit)
    });
    Some(FreeBase {
        lifts,
        scatters: false,
        softened: false,
        warps: false,
        joint: Some(joint),
        anchor,
        broken: usize::from(breaks),
        elastic_wall: false,
        held_shear: None,
    })
}

/// Whether friction caps the base shear, which then is no demand on friction; with vertical motion wherever there is friction.
fn slid(case: &Case, tank: &CylinderModel, watch: &Watch<'_>) -> bool {
    let friction = case.tank.foundation.map_or(Some(tank::FRICTION), |f| f.friction);
    let (Some(mu), true) = (friction, tank.standing.as_ref().is_some_and(|s| s.slides())) else { return false };
    let vertical = case.ground_motion.as_ref().is_some_and(|motion| motion.vertical.is_some());
    let weight = (case.liquid_mass() + case.tank.mass_above(0.0).0) * case.gravity;
    vertical || watch.recorder.ranges[BASE_SHEAR].peak().0 > CAPPED * mu * weight
}

/// Places of a diameter of meridians, whose first is at the angle `turned` [rad].
fn places(
    case: &Case,
    tank: &CylinderModel,
    ([front, back], turned): ([&Meridian; 2], f64),
    states: &mut States,
) -> Vec<Place> {
    let thickness = |row: usize| tank.rows[row].thickness;
    let middle = |row: usize| 0.5 * (tank.cells.z[row] + tank.cells.z[row + 1]);
    let rows = front.hoop_history.len().min(back.hoop_history.len()).min(tank.cells.rows());
    let mut places = Vec::new();
    for row in 0..rows {
        let hoop = [front, back].map(|s| s.hoop_history[row].as_slice());
        let axial = [front, back].map(|s| s.axial_history[row].as_slice());
        let z = middle(row);
        let edge = EDGE * (tank.radius * thickness(row)).sqrt();
        let clear = (row..rows).find(|&r| middle(r) >= edge).unwrap_or(row);
        let pressure = (z < tank.depth).then(|| {
            let of = [front, back].map(|s| s.hoop_history[clear].as_slice());
            OnWall { rest: tank.unit_weight * (tank.depth - z), ..states.sides(of, thickness(clear) / tank.radius) }
        });
        let bending = (row == 0).then(|| {
            let of = [front, back].map(|s| s.moment.as_slice());
            states.sides(of, 6.0 / (thickness(0) * thickness(0)))
        });
        places.push(Place {
            // The lowest row stands for the base, as in the quantities of the run.
            z: if row == 0 { 0.0 } else { z },
            course: course(case, z),
            turned,
            hoop: states.sides(hoop, 1.0),
            axial: states.sides(axial, 1.0),
            bending,
            shear: None,
            pressure,
        });
    }
    places
}

/// Acceleration of a record at a time, linear between its samples and zero after them.
fn at(record: &Record, time: f64) -> f64 {
    let steps = (time / record.dt).max(0.0);
    let sample = |i: usize| record.acceleration.get(i).copied().unwrap_or(0.0);
    let before = steps.floor() as usize;
    let share = steps.fract();
    (1.0 - share) * sample(before) + share * sample(before + 1)
}

/// Number of the course at a height.
fn course(case: &Case, z: f64) -> usize {
    let mut top = 0.0;
    let below = case.tank.courses.iter().take_while(|course| {
        top += course.height;
        z >= top
    });
    below.count().min(case.tank.courses.len() - 1)
}
