//! Where a method differs from the finite elements and why, as facts: the report puts them into words.

use serde::{Deserialize, Serialize};
use tank::Quantity;

use super::factors::FactorStep;
use crate::{ComparisonRow, EngineId};

/// Where a method differs from the finite elements on the same ground motion, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Difference {
    /// Id of the method.
    pub method: String,
    /// The quantities that differ, at least one; the report lists the difference under the first.
    pub ratios: Vec<Ratio>,
    /// Why, where the theory or the runs have a reason.
    pub reasons: Vec<Reason>,
}

/// A quantity and its ratio to the finite-element value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ratio {
    /// The quantity.
    pub quantity: Quantity,
    /// Value over finite-element value.
    pub ratio: f64,
}

/// Those of `quantities` whose ratio in a column is off by more than a threshold.
pub(super) fn ratios(rows: &[ComparisonRow], column: usize, threshold: f64, quantities: &[Quantity]) -> Vec<Ratio> {
    let ratio = |&quantity: &Quantity| {
        let row = rows.iter().find(|row| row.quantity == quantity.id())?;
        let ratio = row.cells[column]?.ratio?;
        ((ratio - 1.0).abs() > threshold).then_some(Ratio { quantity, ratio })
    };
    quantities.iter().filter_map(ratio).collect()
}

/// A quantity and its estimated discretisation error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimated {
    /// The quantity.
    pub quantity: Quantity,
    /// Relative error.
    pub error: f64,
}

/// Why a method differs. The causes are those of the theory manual, with the numbers of the case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Reason {
    /// Both engines solve one problem on different meshes.
    Discretisation {
        /// Estimates of the three-dimensional engine.
        estimated: Vec<Estimated>,
    },
    /// Test values read within the edge disturbance, of a wall that could uplift.
    TestGauges,
    /// Scatter of a test and the assumptions of linear theory.
    TestScatter,
    /// The largest factors of the attribution, largest first.
    Factors {
        /// Up to two steps of it.
        steps: Vec<FactorStep>,
    },
    /// The nonlinear run left its model and was stopped.
    LeftModel {
        /// Time [s].
        time: f64,
    },
    /// The nonlinear run was interrupted.
    Interrupted {
        /// Time [s].
        time: f64,
    },
    /// The wall does not carry weight and static pressure.
    NotCarriedAtRest,
    /// The nonlinear run finds no equilibrium.
    NoEquilibrium {
        /// Time of the last equilibrium [s].
        time: f64,
    },
    /// The wall does not crack, yield or separate from the liquid.
    StaysLinear,
    /// Cracks, yielding, separation: the first events of the nonlinear run.
    LeavesLinearTheory {
        /// Number of events in the sentence.
        events: usize,
    },
    /// The runs are damped differently.
    Damping {
        /// Damping of the linear run.
        linear: Damping,
        /// Damping of the nonlinear run.
        nonlinear: Damping,
    },
    /// Cracks soften the wall.
    Cracking,
    /// Yielding bounds stresses.
    Yielding,
    /// The materials dissipate.
    Dissipation {
        /// Energy dissipated by the materials [J].
        energy: f64,
        /// Work of the loads [J].
        work: f64,
    },
    /// A cause that results of an earlier version state and this version does not.
    #[serde(other)]
    Withdrawn,
}

/// Damping of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "model", rename_all = "kebab-case")]
pub enum Damping {
    /// A ratio by kind of mode.
    Modal {
        /// Ratio of sloshing modes.
        sloshing: f64,
        /// Ratio of structural modes.
        structural: f64,
    },
    /// C = a_M M + a_K K.
    Rayleigh {
        /// a_M [1/s].
        mass: f64,
        /// a_K [s].
        stiffness: f64,
    },
    /// Wall proportional to its initial stiffness, a ratio for every sloshing mode.
    ByGroup {
        /// Ratio of the first mode of wall and liquid.
        wall: f64,
        /// Ratio of each sloshing mode.
        sloshing: f64,
    },
    /// Caughey's series through pairs.
    Caughey {
        /// Number of pairs.
        pairs: usize,
        /// Circular frequency [rad/s] and ratio of the lowest pair.
        first: [f64; 2],
        /// The same of the highest pair.
        last: [f64; 2],
    },
    /// Rayleigh damping on the initial stiffness, fitted at two circular frequencies.
    InitialRayleigh {
        /// Circular frequency [rad/s] and ratio.
        first: [f64; 2],
        /// Circular frequency [rad/s] and ratio.
        second: [f64; 2],
    },
    /// Proportional to the mass.
    MassProportional {
        /// Ratio at its frequency.
        ratio: f64,
    },
}

/// Why results are not those of the whole ground motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Incomplete {
    /// A further engine has no results.
    Missing {
        /// Which.
        engine: EngineId,
        /// The error that stopped it; the user if there is none.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        error: Option<String>,
    },
    /// The wall does not carry weight and static pressure.
    NotCarriedAtRest,
    /// The nonlinear run finds no equilibrium.
    NoEquilibrium {
        /// Time of the last equilibrium [s].
        time: f64,
    },
    /// The nonlinear run left its model and was stopped.
    LeftModel {
        /// Time [s].
        time: f64,
    },
    /// The nonlinear run left its model and went on.
    BeyondModel {
        /// Time [s].
        time: f64,
    },
    /// The nonlinear run was interrupted.
    Interrupted {
        /// Time [s].
        time: f64,
    },
}
