//! A tank on isolators.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::base_run::BaseQuantity;

/// A time history on isolators. The values of its run are those on isolators; those on a fixed base stand beside them here.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct IsolationRun {
    /// Kind of the bearings: `friction_pendulum`, `lead_rubber`, `elastomer`.
    pub kind: String,
    /// Whether there are viscous dampers.
    pub dampers: bool,
    /// Mass of the slab [kg].
    pub slab_mass: f64,
    /// All mass on the isolators [kg].
    pub mass: f64,
    /// Time step of the march [s].
    pub step: f64,
    /// Comparable values: `isolator_displacement`, `isolator_residual`, `isolator_force`, `effective_stiffness`, `effective_period`,
    /// `effective_damping`, `bearing_share`, and the values of the run by id of their quantity.
    pub quantities: Vec<BaseQuantity>,
    /// Comparable values on a fixed base, by id of the quantity (SI).
    pub fixed: BTreeMap<String, f64>,
    /// Difference of the largest force of the isolators along x from that of the superposed response, relative.
    pub superposition: f64,
    /// Energies at the end.
    pub energy: IsolationEnergy,
    /// The same with lower, nominal and upper properties.
    pub band: Vec<IsolationBand>,
    /// Displacement [m] and force [N] of the isolators around the largest displacement, in its direction, in time.
    pub cycles: Vec<[f64; 2]>,
    /// What it assumes, one sentence each.
    pub assumptions: Vec<String>,
}

impl IsolationRun {
    /// A value by its id.
    pub fn quantity(&self, id: &str) -> Option<&BaseQuantity> {
        self.quantities.iter().find(|q| q.id == id)
    }
}

/// Energies at the end of a run [J].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct IsolationEnergy {
    /// Input of the ground.
    pub input: f64,
    /// Lost in the damping of wall and liquid.
    pub viscous: f64,
    /// Work of the isolators, stored and lost.
    pub isolators: f64,
    /// Kinetic energy, and what wall and liquid store.
    pub body: f64,
    /// Deviation of the balance over the input.
    pub error: f64,
}

/// Largest values with scaled properties.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct IsolationBand {
    /// Factor of strength, stiffness, friction and damper coefficient.
    pub factor: f64,
    /// Displacement of the isolators [m].
    pub isolator_displacement: f64,
    /// Force of the isolators [N].
    pub isolator_force: f64,
    /// Effective period [s].
    pub effective_period: f64,
    /// Effective damping ratio.
    pub effective_damping: f64,
    /// Base shear of the tank, of both components together [N].
    pub base_shear: f64,
    /// Wave height, of both components together [m].
    pub sloshing_height: f64,
}
