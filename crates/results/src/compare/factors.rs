//! An attribution: the way from an engine's value to a procedure's, one ingredient after the other.

use serde::{Deserialize, Serialize};
use tank::Quantity;
use tank::assessment::Excitation;
use tank::factor::Factor;

/// The way from the value of the reference engine to that of a procedure. Each step exchanges one ingredient, in the order of
/// [`Factor`]; the product of the factors is the ratio.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attribution {
    /// The quantity.
    pub quantity: Quantity,
    /// Id of the procedure.
    pub method: String,
    /// Its excitation; that of the engine is the record.
    pub excitation: Excitation,
    /// Value of the engine, in SI.
    pub engine: f64,
    /// The exchanges that change the value.
    pub steps: Vec<FactorStep>,
    /// Value of the procedure over that of the engine.
    pub ratio: f64,
}

/// The exchange of an ingredient.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FactorStep {
    /// Which ingredient.
    pub factor_id: Factor,
    /// Value after the exchange over the value before.
    pub factor: f64,
    /// Value after the exchange, in SI.
    pub value: f64,
}

impl Attribution {
    /// Relative gap between the product of the factors and the ratio.
    pub fn gap(&self) -> f64 {
        let product: f64 = self.steps.iter().map(|step| step.factor).product();
        (product / self.ratio - 1.0).abs()
    }

    /// The steps of the largest effect, largest first; steps within `least` of 1 do not count.
    pub fn largest(&self, count: usize, least: f64) -> Vec<FactorStep> {
        let effect = |step: &FactorStep| step.factor.ln().abs();
        let mut steps: Vec<FactorStep> = self.steps.iter().filter(|s| effect(s) > least).copied().collect();
        steps.sort_by(|a, b| effect(b).total_cmp(&effect(a)));
        steps.truncate(count);
        steps
    }
}
