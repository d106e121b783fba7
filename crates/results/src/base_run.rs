//! A tank that rocks and slides on its base: without anchors, or on anchors that yield.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::FoundationKind;

use crate::part::Finding;

/// Where the modulus of the ground comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GroundOrigin {
    /// `tank.foundation.stiffness` or `tank.bottom.subgrade_modulus`.
    Given,
    /// From the velocity of shear waves.
    Waves,
    /// Assumed for a kind of foundation.
    Assumed(FoundationKind),
}

/// A time history with the base free to rotate and slide. The values of its run are those with uplift; those of the wall held down stand beside
/// them here.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaseRun {
    /// Modulus k of the ground under the rim [N/m³].
    pub modulus: f64,
    /// Its origin.
    pub origin: GroundOrigin,
    /// Coefficient of friction; none holds the tank in place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// Share of the moment of the base that is hysteretic.
    pub hysteretic: f64,
    /// Difference of the hysteretic share from that of the largest rotation of the run.
    pub settled: f64,
    /// Dashpot of the closed base [N m s].
    pub dashpot: f64,
    /// Time step [s].
    pub step: f64,
    /// Comparable values: `uplift`, `base_rotation`, `plastic_rotation`, `toe_axial_stress`, `slip`, `slip_residual`, `slip_path`,
    /// `anchor_force`,
    /// `base_shear`, `base_moment`, `overturning_moment`, `sloshing_height`, `hoop_stress`, `rim_hoop_stress`, `axial_membrane_stress`.
    pub quantities: Vec<Finding>,
    /// Limit of the plastic rotation of the joint [rad].
    pub plastic_rotation_limit: f64,
    /// Comparable values of the wall held down, by id of the quantity (SI).
    #[serde(default)]
    pub held: BTreeMap<String, f64>,
    /// Largest difference of the peaks of base shear and base moment between the superposed response, whose values are reported, and the march
    /// of the base, relative.
    #[serde(default)]
    pub superposition: f64,
    /// Anchors, where it stands on them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub anchors: Option<AnchorRun>,
    /// Energies at the end.
    pub energy: BaseEnergy,
    /// The same on softer and on harder ground.
    pub band: Vec<BaseBand>,
    /// Grounds of the band on which there is no run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missed: Vec<MissedBand>,
    /// Extremes of runs that should agree.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spread: Option<BaseSpread>,
    /// Moment of the base [N m] by rotation [rad] at the bottom pressure at rest, both rising.
    pub backbone: Vec<[f64; 2]>,
    /// Rotation [rad] and moment of the base [N m] around the largest rotation, in time.
    pub cycles: Vec<[f64; 2]>,
    /// Displacement of the rim [m], upwards, by angle [°] at the largest uplift.
    pub around: Vec<[f64; 2]>,
    /// Distance from the rim to the ground [m] by angle [°] there and then.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lifted: Vec<[f64; 2]>,
    /// Pressure of the ground on the bottom there and then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<GroundPlan>,
    /// Cycles of the joint.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<JointCycles>,
    /// What it assumes, one sentence each.
    pub assumptions: Vec<String>,
}

/// Pressure of the ground on a bottom plate at an instant, symmetric about the direction of the motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroundPlan {
    /// Time [s].
    pub time: f64,
    /// Pressure of the liquid on the bottom at rest [Pa].
    pub rest: f64,
    /// Distances from the axis [m], rising to the radius.
    pub radii: Vec<f64>,
    /// Angles from 0 to 180° [°], rising.
    pub degrees: Vec<f64>,
    /// Pressure [Pa] by angle, then by distance; 0 off the ground.
    pub pressure: Vec<Vec<f64>>,
}

impl GroundPlan {
    /// Whether every angle has its pressures, and both are in order.
    pub fn is_whole(&self) -> bool {
        let rises = |v: &[f64]| v.len() > 1 && v.windows(2).all(|w| w[1] > w[0]);
        let row = |p: &Vec<f64>| p.len() == self.radii.len() && p.iter().all(|v| v.is_finite());
        rises(&self.radii)
            && rises(&self.degrees)
            && self.pressure.len() == self.degrees.len()
            && self.pressure.iter().all(row)
    }
}

/// Cycles of the plastic rotation of the joint between wall and bottom plate, by the rainflow method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JointCycles {
    /// Angle of the joint with the largest range [°].
    pub degrees: f64,
    /// Largest range [rad].
    pub range: f64,
    /// Number of cycles whose range is at least this share of the limit of the plastic rotation, both as [share, cycles]; half cycles count
    /// as halves.
    pub counts: Vec<[f64; 2]>,
}

impl BaseRun {
    /// A value by its id.
    pub fn quantity(&self, id: &str) -> Option<&Finding> {
        self.quantities.iter().find(|q| q.id == id)
    }
}

/// Energies at the end of a run [J].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaseEnergy {
    /// Input of the ground.
    pub input: f64,
    /// Lost in the damping of wall and liquid.
    pub viscous: f64,
    /// Stored in the base.
    pub base_elastic: f64,
    /// Lost in the plastic joint.
    pub base_hysteretic: f64,
    /// Lost in anchors that yield or break.
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub anchors: f64,
    /// Radiated into the soil.
    pub base_radiated: f64,
    /// Lost in sliding.
    pub friction: f64,
    /// Kinetic energy, and what wall and liquid store.
    pub body: f64,
    /// Largest deviation of the balance over the largest input.
    pub error: f64,
}

fn is_nothing(energy: &f64) -> bool {
    *energy == 0.0
}

/// Anchors on which a base lifts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AnchorRun {
    /// Their number.
    pub count: usize,
    /// Stiffness of one [N/m].
    pub stiffness: f64,
    /// Force at which one yields [N].
    pub yield_force: f64,
    /// Play of the nut [m].
    pub gap: f64,
    /// Elongation at which one breaks [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rupture_elongation: Option<f64>,
    /// Largest plastic elongation at the end [m].
    pub plastic_elongation: f64,
    /// Largest elongation, also of one after it broke, play not counted [m].
    #[serde(default)]
    pub largest_elongation: f64,
    /// How many yield.
    pub yielded: usize,
    /// How many break.
    pub broken: usize,
    /// Plastic elongation of each at the end [m], by angle [°].
    pub around: Vec<[f64; 2]>,
    /// Largest force of each [N], by angle [°].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<[f64; 2]>,
}

/// A ground of the band on which there is no run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MissedBand {
    /// Modulus of the ground [N/m³].
    pub modulus: f64,
    /// Why, as a clause: the state of the base that has no equilibrium, or the rotation that exceeds the model's.
    pub reason: String,
}

/// Largest values on another ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaseBand {
    /// Modulus of the ground [N/m³].
    pub modulus: f64,
    /// Uplift [m].
    pub uplift: f64,
    /// Rotation of the base [rad].
    pub base_rotation: f64,
    /// Plastic rotation of the joint [rad].
    pub plastic_rotation: f64,
    /// Axial stress at the toe, compression [Pa].
    pub toe_axial_stress: f64,
    /// Slip [m].
    pub slip: f64,
    /// Base shear [N].
    pub base_shear: f64,
    /// Extremes of runs that should agree.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spread: Option<BaseSpread>,
}

/// Smallest and largest peaks of runs that should agree: the run itself, its motion weaker and stronger by [`BaseSpread::APART`], and half
/// its time step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaseSpread {
    /// Uplift [m].
    pub uplift: [f64; 2],
    /// Rotation of the base [rad].
    pub base_rotation: [f64; 2],
    /// Plastic rotation of the joint [rad].
    pub plastic_rotation: [f64; 2],
    /// Axial stress at the toe, compression [Pa].
    pub toe_axial_stress: [f64; 2],
    /// Base shear [N].
    pub base_shear: [f64; 2],
}

impl BaseSpread {
    /// What motions are apart, relative.
    pub const APART: f64 = 1e-3;
    /// Spread of a run that repeats: half a step moves a peak by less than 1 %, and motions 0.2 % apart peaks by less than 1 %; a base
    /// that rocks without loss doubles both.
    pub const REPEATS: f64 = 0.05;

    /// Largest of the spreads of rotation, toe stress and shear, over the larger value.
    pub fn relative(&self) -> f64 {
        let spread = |[low, high]: [f64; 2]| if high > 0.0 { (high - low) / high } else { 0.0 };
        [self.base_rotation, self.toe_axial_stress, self.base_shear].map(spread).into_iter().fold(0.0, f64::max)
    }

    /// Whether the runs agree.
    pub fn repeats(&self) -> bool {
        self.relative() <= BaseSpread::REPEATS
    }
}
