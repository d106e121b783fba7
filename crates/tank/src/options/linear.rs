//! Options of the linear engine, which the three-dimensional one shares.

use oscillator::record::Record;
use serde::{Deserialize, Serialize};

use super::frequency::FrequencyOptions;
use crate::keys::{Angle, Field, Length, Limits, Number, Opt, Or, keys};
use crate::words;

words! {
    /// Time integration.
    pub Integrator {
        /// Exact piecewise-linear modal integration with missing mass.
        Modal = "modal",
        /// Direct integration by Newmark's method.
        Newmark = "newmark",
    }
}

words! {
    /// Liquid of the linear engines.
    pub LiquidModel {
        /// Small waves; where they are not small, a nonlinear run stands beside the linear one.
        Linear = "linear",
        /// Potential flow of third order: its wave, forces and moments are those of the run.
        Nonlinear = "nonlinear",
    }
}

/// Damping of the linear engine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DampingModel {
    /// Ratios of `Case::damping` by kind of mode.
    Modal,
    /// Rayleigh damping C = a_M M + a_K K fitted to two (circular frequency [rad/s], ratio) pairs.
    Rayleigh {
        /// First pair.
        first: (f64, f64),
        /// Second pair.
        second: (f64, f64),
        /// Accept a negative coefficient (parity with published runs), with a warning.
        allow_negative: bool,
    },
    /// Wall proportional to its stiffness, a ratio for every sloshing mode, as of the nonlinear engine.
    ByGroup {
        /// Ratio of the first mode of wall and liquid; that of the others grows with their frequency.
        wall: f64,
        /// Ratio of each sloshing mode.
        sloshing: f64,
    },
    /// Caughey's series through pairs of circular frequency [rad/s] and ratio.
    Caughey(CaugheyPairs),
    /// Rayleigh damping with given coefficients of either sign (parity with published runs), with a warning if
    /// one is negative.
    Coefficients {
        /// a_M [1/s].
        mass: f64,
        /// a_K [s].
        stiffness: f64,
    },
}

words! {
    /// Direction of dashpots.
    pub WallDirection {
        /// Outwards.
        Radial = "radial",
        /// Along the circumference.
        Tangential = "tangential",
        /// Along the axis.
        Vertical = "vertical",
    }
}

/// Heights of dashpots above the clamped base [m].
const RINGS: Limits = Limits::above(0.0).to(1000.0);

keys! {
    /// Dashpots between the ground and the wall, three or more, evenly spaced around it at one height: they damp each harmonic of the
    /// motion by itself.
    pub Dashpots as RingOfDashpots (Copy) {
        /// Height above the base.
        z: Field<Length> [RINGS],
        /// Direction.
        direction: Or<WallDirection> = default(WallDirection::Radial),
        /// Coefficient of all of them together in N s/m, a bare number.
        coefficient (200000): Field<Number> [Limits::above(0.0).to(1e15)],
    }
}

/// Pairs of Caughey's series, six at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaugheyPairs {
    pairs: [(f64, f64); CaugheyPairs::MOST],
    count: usize,
}

impl CaugheyPairs {
    /// Most pairs.
    pub const MOST: usize = 6;

    /// The first [`CaugheyPairs::MOST`] of `given`, each a circular frequency [rad/s] and a ratio.
    pub fn new(given: &[(f64, f64)]) -> CaugheyPairs {
        let count = given.len().min(CaugheyPairs::MOST);
        let mut pairs = [(0.0, 0.0); CaugheyPairs::MOST];
        pairs[..count].copy_from_slice(&given[..count]);
        CaugheyPairs { pairs, count }
    }

    /// The pairs.
    pub fn pairs(&self) -> &[(f64, f64)] {
        &self.pairs[..self.count]
    }
}

words! {
    /// How the largest responses of modes are combined.
    pub ModalCombination {
        /// Complete quadratic combination.
        Cqc = "cqc",
        /// Square root of the sum of squares.
        Srss = "srss",
        /// Sum of absolute values.
        Abs = "abs",
    }
}

words! {
    /// How the impulsive and the convective part are combined.
    pub PartCombination {
        /// All modes together, by `combination`.
        Modal = "modal",
        /// Square root of the sum of squares of the two parts.
        Srss = "srss",
        /// Sum of the two parts.
        Abs = "abs",
    }
}

/// Options of the response-spectrum method: the modes of a linear engine under the design spectrum of the site.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpectrumOptions {
    /// Combination of modes.
    pub combination: ModalCombination,
    /// Combination of the impulsive and the convective part.
    pub parts: PartCombination,
    /// Whether modes that are not kept follow the ground with the acceleration at T = 0.
    pub missing_mass: bool,
    /// Whether by the behaviour factor or the response modification of the code.
    pub reduced: bool,
    /// Id of the procedure whose design spectrum it is; the first that the site gives the data of, if none.
    pub code: Option<String>,
}

impl SpectrumOptions {
    /// The defaults.
    pub const DEFAULT: SpectrumOptions = SpectrumOptions {
        combination: ModalCombination::Cqc,
        parts: PartCombination::Modal,
        missing_mass: true,
        reduced: true,
        code: None,
    };
}

/// Heights, as those of gauges and stations; the tank bounds them further.
const HEIGHTS: Limits = Limits::from(0.0).to(1000.0).items(0, 100);
/// Angles around the tank [rad]: a turn in either sense.
const TURN: Limits = Limits::from(-std::f64::consts::TAU).to(std::f64::consts::TAU);

keys! {
    /// A place of a cylinder's wall: height above the base and angle from the direction of shaking.
    pub WallPlace as ForceStation (Copy) {
        /// Height above the base; at a joint of courses just above it.
        z: Field<Length> [HEIGHTS],
        /// Angle from the direction of shaking.
        theta ("90 deg"): Or<Angle> [TURN] = default(Angle(0.0)),
    }
}

impl WallPlace {
    /// θ in degrees as names have it, rounded to 1e-6.
    pub fn degrees(&self) -> f64 {
        // + 0.0 makes −0 a zero.
        (self.theta.to_degrees() * 1e6).round() / 1e6 + 0.0
    }
}

/// An instant of a time history.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Instant {
    /// A time [s].
    At(f64),
    /// The time of a peak.
    Peak(Peak),
}

/// Peak of a history, its largest absolute value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Peak {
    /// Wave height at the wall at θ = 0.
    Wave,
    /// Base shear along x.
    BaseShear,
    /// Moment above the base plate.
    BaseMoment,
    /// Moment below the base plate.
    OverturningMoment,
}

impl Peak {
    /// All of them.
    pub const ALL: [Peak; 4] = [Peak::Wave, Peak::BaseShear, Peak::BaseMoment, Peak::OverturningMoment];

    /// Its name in `analysis.snapshots`.
    pub fn name(self) -> &'static str {
        match self {
            Peak::Wave => "peak wave",
            Peak::BaseShear => "peak base shear",
            Peak::BaseMoment => "peak base moment",
            Peak::OverturningMoment => "peak overturning moment",
        }
    }
}

/// Damping of the foot that bounces.
const BOUNCE: Limits = Limits::from(0.0).to(2.0);

keys! {
    /// Wall and roof on the foot, which bounce on the ground where it lands.
    pub Heave as FootHeave (Copy, Default) {
        /// Ratio of critical damping of that bounce with all of the rim on the ground.
        damping (0.2): Opt<Number> [BOUNCE]
            = Absent::Follows("damping.impulsive, in proportion to the frequency of the bounce over that of the impulsive mode"),
    }
}

/// Options of the linear engine. The defaults keep the errors stated in the theory manual.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LinearOptions {
    /// Mesh refinement: every element count is multiplied by this (1 = default mesh).
    pub refine: f64,
    /// Time integration.
    pub integrator: Integrator,
    /// Damping.
    pub damping: DampingModel,
    /// Dashpots besides the damping model.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dashpots: Vec<Dashpots>,
    /// Sloshing modes that count for the wave height (5).
    pub wave_modes: usize,
    /// Liquid.
    #[serde(default = "linear", skip_serializing_if = "is_linear")]
    pub liquid: LiquidModel,
    /// Estimate the discretisation error by a second, coarser mesh.
    pub mesh_error: bool,
    /// Extra wave gauges: radii (or x) in the direction of shaking [m]; the wall is always gauged.
    pub gauges: Vec<f64>,
    /// Extra stress stations: heights above the base [m] with histories of hoop, axial and bending stress.
    pub stations: Vec<f64>,
    /// Places of a cylinder's wall with histories of its internal forces.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub force_stations: Vec<WallPlace>,
    /// Instants of states that the three-dimensional engine draws besides those of extreme response.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub snapshots: Vec<Instant>,
    /// Angle of the static tilt test [rad]; none without one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tilt: Option<f64>,
    /// Inertia of wall and roof that the foot of an unanchored cylinder lifts; none without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heave: Option<Heave>,
    /// Damping of the ground under the rim of an unanchored cylinder, of critical at its impulsive mode while the rim is in contact.
    #[serde(default)]
    pub ground_damping: f64,
    /// Response-spectrum method.
    pub spectrum: SpectrumOptions,
    /// Transfer functions; none without them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency: Option<FrequencyOptions>,
    /// Rotational acceleration of the base about y, positive where the top moves along x [rad/s²]; none without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotation: Option<Record>,
}

fn linear() -> LiquidModel {
    LiquidModel::Linear
}

fn is_linear(liquid: &LiquidModel) -> bool {
    *liquid == LiquidModel::Linear
}

impl LinearOptions {
    /// The defaults.
    pub const DEFAULT: LinearOptions = LinearOptions {
        refine: 1.0,
        integrator: Integrator::Modal,
        damping: DampingModel::Modal,
        dashpots: Vec::new(),
        wave_modes: 5,
        liquid: LiquidModel::Linear,
        mesh_error: true,
        gauges: Vec::new(),
        stations: Vec::new(),
        force_stations: Vec::new(),
        snapshots: Vec::new(),
        tilt: None,
        heave: None,
        ground_damping: 0.02,
        spectrum: SpectrumOptions::DEFAULT,
        frequency: None,
        rotation: None,
    };
}

impl Default for LinearOptions {
    fn default() -> Self {
        LinearOptions::DEFAULT
    }
}
