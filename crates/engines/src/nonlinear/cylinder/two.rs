//! Two horizontal components of the ground motion at the same time.
//!
//! Nothing is symmetric: the whole wall is computed. At every committed step, relative to the static state,
//!
//! ```text
//! forces and moments     √(X² + Y²) at tan θ = Y/X
//! wave at the wall       even + √(X² + Y²)       even = (η_0 + η_180)/2,  X = (η_0 − η_180)/2,  Y = (η_90 − η_270)/2
//! ```
//!
//! The wave has no other harmonics: gravity acts on the surface in 0 and 1 alone. A nonlinear wall does not go with cos θ: at every sample
//! the stresses of all its cells are searched, and a fan of meridians keeps its histories for the limit states. X and Y are components of
//! **one** run with both records; a run with one of them alone may differ.

use fem::analysis::AnalysisError;
use fem::analysis::march::{Instant, Quantity, QuantityObserver};
use results::channel::{OnBase, OnWall};
use results::{Channel, Directional, SeriesInfo};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use tank::Case;
use tank::demand::Peak;
use tank::refusal::{Place, Refusal};

use super::meridian::Meridian;
use super::mesh::Cells;
use super::model::CylinderModel;
use super::recorded::{BASE_MOMENT, BASE_SHEAR, WAVE_BACK, WAVE_FRONT, base_reaction, row};
use crate::histories::Histories;
use tank::options::nonlinear::NonlinearOptions;

/// Base shear along y, recorded after the quantities of one component.
pub(super) const SHEAR_Y: usize = 8;
/// Moment that goes with it.
pub(super) const MOMENT_Y: usize = 9;
/// Elevation of the surface at the wall, θ = 90°.
const WAVE_LEFT: usize = 10;
/// The same at θ = 270°.
const WAVE_RIGHT: usize = 11;
/// Components that are read at every step: forces, moments, waves.
const READ: [usize; 8] = [BASE_SHEAR, SHEAR_Y, BASE_MOMENT, MOMENT_Y, WAVE_FRONT, WAVE_BACK, WAVE_LEFT, WAVE_RIGHT];
/// Diameters whose meridians keep histories, at most: between two of them the amplitude of a harmonic 1 varies by 2 %.
const DIAMETERS: usize = 8;

/// What two components ask of the case and the mesh.
pub(crate) fn refusals(case: &Case, options: &NonlinearOptions) -> Vec<Refusal> {
    if case.ground_motion.as_ref().is_none_or(|m| m.transverse.is_none()) {
        return Vec::new();
    }
    if !matches!(case.tank.shape, tank::Shape::Cylinder { .. }) {
        let message = "--quake-y: the nonlinear engine shakes a strip along x alone";
        return vec![Refusal::new(Place::Transverse, message, "\"cylinder\"").help("remove --quake-y")];
    }
    if options.symmetry {
        let message = "--quake-y: half of a tank (analysis.nonlinear.symmetry) does not move along y";
        return vec![
            Refusal::new(Place::Transverse, message, "the whole tank: analysis.nonlinear.symmetry false")
                .help("remove \"symmetry\": true from analysis.nonlinear, or remove --quake-y"),
        ];
    }
    let cells = Cells::new(&case.tank, case.liquid.fill_height, options.elements, false);
    if cells.sectors.is_multiple_of(4) {
        return Vec::new();
    }
    let message = "--quake-y: θ = 90° is a meridian of the mesh only with a multiple of four elements around the tank";
    vec![
        Refusal::new(Place::Sectors, message, "a multiple of four")
            .found(cells.sectors.to_string())
            .help(format!("set analysis.nonlinear.elements.circumference to {}", cells.sectors.next_multiple_of(4))),
    ]
}

/// A largest resultant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Largest {
    value: f64,
    time: f64,
    /// Direction [rad].
    theta: f64,
    /// Number of the row of the wall, of a stress.
    row: usize,
}

impl Largest {
    fn include(&mut self, value: f64, time: f64, theta: f64, row: usize) {
        if value > self.value {
            let theta = theta.rem_euclid(TAU);
            *self = Largest { value, time, theta, row };
        }
    }

    fn peak(self) -> Peak {
        Peak { value: self.value, time: self.time, theta: self.theta }
    }
}

/// Largest values of a stress: next to θ = 0 and 180°, next to 90° and 270°, of all cells.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Stress {
    /// Static values by row and column [Pa].
    rest: Vec<f64>,
    x: Largest,
    y: Largest,
    all: Largest,
}

impl Stress {
    /// * `values`: by row and column
    fn see(&mut self, cells: &Cells, values: &[f64], time: f64) {
        if self.rest.is_empty() {
            self.rest = values.to_vec();
        }
        let columns = cells.columns();
        for (row, (own, rest)) in values.chunks(columns).zip(self.rest.chunks(columns)).enumerate() {
            let change = |column: usize| own[column] - rest[column];
            for column in 0..columns {
                let theta = (column as f64 + 0.5) * cells.angle();
                self.all.include(change(column).abs(), time, theta, row);
            }
            for quarter in 0..4 {
                // The two cells next to the meridian.
                let right = quarter * columns / 4;
                let left = (right + columns - 1) % columns;
                let value = 0.5 * (change(left) + change(right)).abs();
                let side = if quarter % 2 == 0 { &mut self.x } else { &mut self.y };
                side.include(value, time, FRAC_PI_2 * quarter as f64, row);
            }
        }
    }
}

/// What was seen of two components; empty with one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct TwoSeen {
    /// Values of [`READ`] in the static state.
    rest: Option<[f64; 8]>,
    shear: Largest,
    moment: Largest,
    wave: Largest,
    /// Up to the surface at rest.
    hoop: Stress,
    /// Above it.
    #[serde(default)]
    rim: Stress,
    axial: Stress,
    /// Meridians of the fan but those of θ = 0 and 180°: of each diameter the two ends.
    pub meridians: Vec<Meridian>,
}

impl TwoSeen {
    /// Nothing seen, on a fan of so many meridians beside those of the sides.
    pub(super) fn new(meridians: usize) -> TwoSeen {
        TwoSeen { meridians: vec![Meridian::default(); meridians], ..TwoSeen::default() }
    }

    /// Looks at the recorded quantities of a committed step.
    pub(super) fn see(&mut self, recorder: &QuantityObserver, now: &Instant<'_>) {
        let values = READ.map(|k| recorder.quantities()[k].at(now));
        let rest = *self.rest.get_or_insert(values);
        let [vx, vy, mx, my, front, back, left, right] = std::array::from_fn(|i| values[i] - rest[i]);
        let time = now.time;
        self.shear.include(vx.hypot(vy), time, vy.atan2(vx), 0);
        self.moment.include(mx.hypot(my), time, my.atan2(mx), 0);
        let (wave, theta) = largest_wave([front, back, left, right]);
        self.wave.include(wave, time, theta, 0);
    }

    /// Looks at the hoop and axial stresses of all cells at a sample, by row and column [Pa].
    ///
    /// * `depth`: height of the surface at rest [m]
    pub(super) fn stresses(&mut self, (cells, depth): (&Cells, f64), [hoop, axial]: [&[f64]; 2], time: f64) {
        let wet = cells.columns() * cells.z.windows(2).filter(|z| z[1] <= depth * (1.0 + 1e-9)).count();
        let (wall, rim) = hoop.split_at(wet.min(hoop.len()));
        self.hoop.see(cells, wall, time);
        self.rim.see(cells, rim, time);
        // At the base, as in the quantities of the run.
        self.axial.see(cells, &axial[..cells.columns()], time);
    }

    /// Largest hoop stress of the wall and of its rim, and axial stress of the base, along x [Pa], from the means of the cells on both sides of θ = 0 and 180°, in which
    /// the motion along y has no part; none with one component.
    pub(super) fn along(&self) -> Option<[f64; 3]> {
        self.rest.map(|_| [self.hoop.x.value, self.rim.x.value, self.axial.x.value])
    }

    /// Largest rise of the surface at the wall.
    pub(super) fn wave(&self) -> Peak {
        self.wave.peak()
    }

    /// Extremes along x, along y and of both.
    pub(super) fn results(&self, tank: &CylinderModel, recorder: &QuantityObserver) -> Vec<Directional> {
        let Some(rest) = self.rest else { return Vec::new() };
        let of = |k: usize| READ.iter().position(|&read| read == k).map_or(0.0, |i| rest[i]);
        let swing = |k: usize| {
            let range = &recorder.ranges[k];
            (range.max - of(k)).max(of(k) - range.min).max(0.0)
        };
        let rise = |k: usize| (recorder.ranges[k].max - of(k)).max(0.0);
        let directional = |id: String, title: String, channel: Channel, [x, y]: [f64; 2], found: Largest| Directional {
            id,
            title,
            dimension: channel.dimension(),
            z: None,
            x,
            y,
            resultant: found.value,
            time: found.time,
            theta: found.theta,
        };
        let mut out = Vec::new();
        for (what, [x, y], found) in
            [(OnBase::Shear, [BASE_SHEAR, SHEAR_Y], self.shear), (OnBase::Moment, [BASE_MOMENT, MOMENT_Y], self.moment)]
        {
            let channel = what.along();
            out.push(directional(channel.id(), channel.title(), channel, [swing(x), swing(y)], found));
        }
        let waves = [rise(WAVE_FRONT).max(rise(WAVE_BACK)), rise(WAVE_LEFT).max(rise(WAVE_RIGHT))];
        let title = "Wave height at the wall".to_owned();
        out.push(directional("wave_height".into(), title, Channel::WaveLargest, waves, self.wave));
        for (what, stress) in [(OnWall::Hoop, &self.hoop), (OnWall::Axial, &self.axial)] {
            let z = 0.5 * (tank.cells.z[stress.all.row] + tank.cells.z[stress.all.row + 1]);
            let (id, title) = (what.id().to_owned(), what.title().to_owned());
            let channel = Channel::Largest { what, z };
            out.push(Directional {
                z: Some(z),
                ..directional(id, title, channel, [stress.x.value, stress.y.value], stress.all)
            });
        }
        out
    }
}

/// Largest rise around the circumference and its direction [rad], from those at θ = 0, 180°, 90°, 270°.
fn largest_wave([front, back, left, right]: [f64; 4]) -> (f64, f64) {
    let (even, x, y) = (0.5 * (front + back), 0.5 * (front - back), 0.5 * (left - right));
    (even + x.hypot(y), y.atan2(x))
}

/// Lowest elevation of the surface at the wall, from the same.
pub(super) fn trough(recorder: &QuantityObserver) -> Option<f64> {
    let last = |k: usize| recorder.histories.get(k)?.last().copied();
    let of = [WAVE_FRONT, WAVE_BACK, WAVE_LEFT, WAVE_RIGHT].map(last);
    let [Some(front), Some(back), Some(left), Some(right)] = of else { return None };
    Some(-largest_wave([-front, -back, -left, -right]).0)
}

/// The quantities recorded beside those of one component.
///
/// Errors: those of the elements.
pub(super) fn quantities(tank: &CylinderModel) -> Result<Vec<Quantity>, AnalysisError> {
    Ok(vec![
        base_reaction(tank, "base shear, y", 1, false)?,
        base_reaction(tank, "base moment, y", 1, true)?,
        row("wave at θ = 90°", tank.elevation(FRAC_PI_2)),
        row("wave at θ = 270°", tank.elevation(1.5 * PI)),
    ])
}

/// Columns of cells of the fan but those of θ = 0 and 180°: of each diameter the two ends.
pub(super) fn fan(cells: &Cells) -> Vec<usize> {
    let half = cells.columns() / 2;
    let diameters = DIAMETERS.min(half);
    (1..diameters).flat_map(|k| [k * half / diameters, k * half / diameters + half]).collect()
}

/// What lies between two meridians of the fan of a harmonic 1, relative: 1 − cos(π/2n) with n diameters.
pub(super) fn between_meridians(cells: &Cells) -> f64 {
    let diameters = DIAMETERS.min(cells.columns() / 2) as f64;
    1.0 - (FRAC_PI_2 / diameters).cos()
}

/// Adds the histories along y and of resultants, relative to the static state.
pub(super) fn add(histories: &mut Histories, recorder: &QuantityObserver, seen: &TwoSeen) {
    let Some(rest) = seen.rest else { return };
    let own = |k: usize| -> Vec<f64> {
        let first = READ.iter().position(|&read| read == k).map_or(0.0, |i| rest[i]);
        recorder.histories[k].iter().map(|v| v - first).collect()
    };
    let y = [
        (SHEAR_Y, Channel::Y(OnBase::Shear)),
        (MOMENT_Y, Channel::Y(OnBase::Moment)),
        (WAVE_LEFT, Channel::WaveAround { degrees: 90.0 }),
        (WAVE_RIGHT, Channel::WaveAround { degrees: 270.0 }),
    ];
    for (k, channel) in y {
        let (range, first) = (&recorder.ranges[k], recorder.histories[k].first().copied().unwrap_or(0.0));
        let (up, down) = (range.max - first, first - range.min);
        let peak = if up >= down { (up, range.max_time) } else { (down, range.min_time) };
        histories.push(SeriesInfo::of(channel, first, peak), own(k));
    }
    let both = [(OnBase::Shear, BASE_SHEAR, SHEAR_Y, seen.shear), (OnBase::Moment, BASE_MOMENT, MOMENT_Y, seen.moment)];
    for (what, x, y, found) in both {
        let values = own(x).iter().zip(own(y)).map(|(x, y)| x.hypot(y)).collect();
        let info = SeriesInfo::of(Channel::Resultant(what), 0.0, (found.value, found.time));
        histories.push(info, values);
    }
    let [front, back, left, right] = [WAVE_FRONT, WAVE_BACK, WAVE_LEFT, WAVE_RIGHT].map(own);
    let values = (0..front.len()).map(|i| largest_wave([front[i], back[i], left[i], right[i]]).0).collect();
    let info = SeriesInfo::of(Channel::WaveLargest, 0.0, (seen.wave.value, seen.wave.time));
    histories.push(info, values);
}

/// Assumption of a run with both components.
pub(super) const ASSUMPTION: &str = "Two horizontal components at the same time on the whole tank. Values of the comparison are those along x, at \
    θ = 0° and 180°; x and y of the list of both directions are components of this one run, not runs with one record each. Limit states \
    are checked on the meridians of eight diameters.";
