//! A tank on a rigid slab on soil.

use serde::{Deserialize, Serialize};

use crate::base_run::BaseQuantity;
use crate::value::Value;

/// Period and damping of the impulsive mode on soil by one definition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EffectiveMode {
    /// `cones`, `veletsos`, `static` or `complex_mode`.
    pub id: String,
    /// Period [s].
    pub period: f64,
    /// Damping ratio; none for static springs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<f64>,
}

/// A value on soil and on a fixed base.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OnSoil {
    /// Id of the quantity.
    pub id: String,
    /// On soil.
    pub soil: Value,
    /// On a fixed base.
    pub fixed: Value,
}

/// The foundation of a run on soil, and what the soil changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SoilRun {
    /// Velocity of shear waves [m/s].
    pub shear_wave_velocity: f64,
    /// Density of the soil [kg/m³].
    pub density: f64,
    /// Poisson's ratio of the soil.
    pub poisson_ratio: f64,
    /// Radius of the slab [m].
    pub radius: f64,
    /// Thickness of the slab [m]; 0 of one without mass.
    pub thickness: f64,
    /// Mass of the slab [kg].
    pub slab_mass: f64,
    /// Static stiffness, horizontal [N/m].
    pub horizontal: f64,
    /// Static stiffness, rocking [N m].
    pub rocking: f64,
    /// Dashpot, horizontal [N s/m].
    pub horizontal_dashpot: f64,
    /// Dashpot between the rocking slab and the internal rotation [N m s].
    pub rocking_dashpot: f64,
    /// Moment of inertia of the internal rotation [kg m²].
    pub internal_inertia: f64,
    /// Moment of inertia of the soil that rocks with the slab [kg m²].
    pub trapped_inertia: f64,
    /// Period of the impulsive mode on a fixed base [s].
    pub fixed_period: f64,
    /// Its damping ratio.
    pub fixed_damping: f64,
    /// Its mass [kg].
    pub impulsive_mass: f64,
    /// Its arm above the underside of the slab, with bottom pressure [m].
    pub impulsive_arm: f64,
    /// Effective period and damping by each definition, that of the quantities first.
    pub effective: Vec<EffectiveMode>,
    /// Comparable values: `effective_period`, `effective_damping`, `base_translation`, `base_rotation`.
    pub quantities: Vec<BaseQuantity>,
    /// Results beside those on a fixed base.
    pub beside: Vec<OnSoil>,
    /// What it assumes, one sentence each.
    pub assumptions: Vec<String>,
}
