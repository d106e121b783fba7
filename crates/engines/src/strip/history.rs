//! Results of a run of one wall: histories, extremes, first events, and the final state of the wall.
//!
//! Signs are those of the wall at x = +L: deflections and pressures outwards, ζ from the wet face to the dry one, moments about
//! y as the ground exerts them. Everything contains the state at rest. Faces: 0 is the wet half of the section, 1 the dry one.

mod observer;

pub(super) use observer::WallObserver;

use fem::analysis::march::Range;
use fem::liquid::separation::{Openings, SeparationCheck};
use results::nonlinear::{BaseMoment, Departure};

/// A quantity with a history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// Elevation of the surface at the wall [m].
    Elevation,
    /// Deflection of the top [m].
    Deflection,
    /// Force along x that the ground exerts on the base [N/m].
    Shear,
    /// Moment about y that the ground exerts on the base [N].
    Moment,
    /// Moment of the dynamic pressure on this half of the bottom [N], of the sign of the wall's.
    BottomMoment,
    /// Bending moment of the lowest section [N].
    SectionMoment,
    /// Its curvature [1/m].
    Curvature,
    /// Part of [`Scalar::Moment`] that the stresses of the lowest element exert [N].
    StressMoment,
    /// Part of [`Scalar::Moment`] of viscous damping [N].
    DampingMoment,
    /// Part of [`Scalar::Moment`] of inertia and dynamic pressure of the lowest element [N].
    InertiaMoment,
    /// Largest total acceleration of a node of the wall along x, absolute [m/s²].
    Acceleration,
}

impl Scalar {
    /// All of them, in the order of [`WallHistory::scalars`].
    pub const ALL: [Scalar; 11] = [
        Scalar::Elevation,
        Scalar::Deflection,
        Scalar::Shear,
        Scalar::Moment,
        Scalar::BottomMoment,
        Scalar::SectionMoment,
        Scalar::Curvature,
        Scalar::StressMoment,
        Scalar::DampingMoment,
        Scalar::InertiaMoment,
        Scalar::Acceleration,
    ];
}

/// Kind of a first event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A crack.
    Crack,
    /// Plastic strain in a layer: steel yields, concrete crushes.
    Yield,
    /// Plastic strain in a bar.
    BarYield,
    /// A bar strained beyond its limit.
    BarRupture,
}

impl EventKind {
    /// All of them.
    pub const ALL: [EventKind; 4] = [EventKind::Crack, EventKind::Yield, EventKind::BarYield, EventKind::BarRupture];
}

/// When and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallEvent {
    /// Kind of the event.
    pub kind: EventKind,
    /// Time [s].
    pub time: f64,
    /// Height of the section [m].
    pub height: f64,
    /// Depth ζ of the fibre [m].
    pub depth: f64,
    /// Moment at the base then [N].
    pub base_moment: f64,
}

/// Worst of an element so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    /// Share of the fibres of a section that have cracked.
    pub cracked: f64,
    /// Largest utilisation of a layer.
    pub utilisation: f64,
    /// Largest plastic strain of a layer.
    pub plastic_strain: f64,
    /// Largest |stress| of a bar [Pa].
    pub bar_stress: f64,
    /// Largest plastic strain of a bar.
    pub bar_plastic_strain: f64,
    /// Highest section with a crack [m]; 0 without any.
    pub highest_crack: f64,
}

impl Cell {
    pub(super) const COUNT: usize = 6;

    pub(super) fn array(&self) -> [f64; Cell::COUNT] {
        [
            self.cracked,
            self.utilisation,
            self.plastic_strain,
            self.bar_stress,
            self.bar_plastic_strain,
            self.highest_crack,
        ]
    }

    pub(super) fn of(a: &[f64]) -> Cell {
        Cell {
            cracked: a[0],
            utilisation: a[1],
            plastic_strain: a[2],
            bar_stress: a[3],
            bar_plastic_strain: a[4],
            highest_crack: a[5],
        }
    }

    pub(super) fn include(&mut self, other: &Cell) {
        let (mut a, b) = (self.array(), other.array());
        a.iter_mut().zip(b).for_each(|(a, b)| *a = a.max(b));
        *self = Cell::of(&a);
    }
}

/// A state for pictures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WallState {
    /// Time [s].
    pub time: f64,
    /// Displacement of the levels along x and upwards, from the wall without load [m].
    pub displacement: Vec<[f64; 2]>,
    /// Elevation of the surface at the lines of a picture, from the middle to the wall [m].
    pub surface: Vec<f64>,
    /// Opening strain of the widest crack that is open, of every element.
    pub cracks: Vec<f64>,
}

/// Opening strain of the widest crack of every element, from the base up: now, and the largest so far.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Time [s].
    pub time: f64,
    /// Moment at the base [N].
    pub base_moment: f64,
    /// Wet and dry face.
    pub faces: [Vec<[f64; 2]>; 2],
}

/// The history of a wall.
#[derive(Clone, Debug, PartialEq)]
pub struct WallHistory {
    /// Times of the committed steps, the start included [s].
    pub times: Vec<f64>,
    /// Numbers in `times` of the samples of the grid.
    pub samples: Vec<usize>,
    /// Every [`Scalar`] at `times`.
    pub scalars: Vec<Vec<f64>>,
    /// Deflection at the levels of the wall [m]: at rest, and its range.
    pub deflection: Vec<(f64, Range)>,
    /// Heights of the wet levels, or of the points of the joints [m], and range of the dynamic pressure there [Pa].
    pub pressure: Vec<(f64, Range)>,
    /// Elements from the base up.
    pub cells: Vec<Cell>,
    /// First of each kind, by time.
    pub events: Vec<WallEvent>,
    /// Cracks at the largest moment at the base, and in the last state.
    pub pictures: [Picture; 2],
    /// Whether the liquid would leave the wall, in the middle of every wet element; empty where it is joined.
    pub separation: SeparationCheck,
    /// Whether it has left the wall, at the points of the joints.
    pub openings: Option<Openings>,
    /// States for pictures, where they are asked for.
    pub states: Vec<WallState>,
    /// The largest moment at the base and its parts.
    pub peak: BaseMoment,
    /// Limits of the model that were passed, the first of each kind by time; known at the end of a run.
    pub departures: Vec<Departure>,
}

impl WallHistory {
    /// A scalar at [`WallHistory::times`].
    pub fn scalar(&self, scalar: Scalar) -> &[f64] {
        &self.scalars[scalar as usize]
    }

    /// A scalar with its value at rest and its range.
    pub fn range(&self, scalar: Scalar) -> (Scalar, f64, Range) {
        let mut range = Range::EMPTY;
        for (&value, &time) in self.scalar(scalar).iter().zip(&self.times) {
            range.include(value, time);
        }
        (scalar, self.at_rest(scalar), range)
    }

    /// A scalar at rest.
    pub fn at_rest(&self, scalar: Scalar) -> f64 {
        self.scalar(scalar).first().copied().unwrap_or(0.0)
    }
}
