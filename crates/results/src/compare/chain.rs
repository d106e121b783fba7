//! Exchanges the ingredients of an engine's value for those of a procedure's, one after the other.
//!
//! ```text
//! V₀  the history                                       X_j = S_a(T_j, ξ_j) r_j    r_j response of a mode per acceleration
//! V₁  √(Σ X_j² + X_rest²)      time_history             all modes, and the rest with the peak ground acceleration
//! V₂  √(X_i² + X_c²)           modes                    the impulsive mode ([`crate::impulsive`]), the first sloshing mode
//! V₃… one ingredient after the other, in the order of `Factor`, until all are the procedure's
//! f_k = V_k/V_{k−1}            Π f_k = V_n/V₀
//! ```
//!
//! Before V₁ the history of a tank that lifts or slides is exchanged for that of the wall held down, and one on isolators or soil for that on
//! a fixed base: the modes are those of the latter.
//!
//! The last value is recomputed from the ingredients, not copied: that the product is the ratio is a check.

use std::collections::BTreeMap;

use tank::Quantity;
use tank::assessment::Excitation;
use tank::case::Combination;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Ordinate, Part, Recipe, Response, Rule, Rung, Share};

use super::factors::{Attribution, FactorStep};
use crate::impulsive;
use crate::modal::{Inertia, ModalPart};

/// An exchange that changes less than this is left out: rounding of equal ingredients.
const UNCHANGED: f64 = 1e-12;
/// Largest gap between the product of factors and the ratio.
pub const CLOSED: f64 = 1e-9;

/// S_a [m/s²] of the record at a period [s], 0 for the ground, and a damping ratio.
pub type Spectrum<'a> = &'a dyn Fn(f64, f64) -> f64;

/// The engine's side of attributions.
pub struct Engine<'a> {
    /// Its response mode by mode.
    pub modal: &'a [ModalPart],
    /// Mass of the liquid [kg].
    pub liquid_mass: f64,
    /// Spectrum of the record.
    pub spectrum: Spectrum<'a>,
    /// The same run with its base held, of one whose base moves.
    pub held: Option<Held>,
    /// Height of the hoop stresses of the modes [m]: where the engine's is largest on a base that is held; none without them.
    pub hoop_height: Option<f64>,
}

/// A run with its base held.
pub struct Held {
    /// What the base of the other does.
    pub factor: Factor,
    /// Values by id of the quantity.
    pub values: BTreeMap<String, f64>,
}

/// What a procedure under one excitation is compared by.
pub struct Made<'a> {
    /// Id of the method.
    pub method: &'a str,
    /// Excitation.
    pub excitation: Excitation,
    /// Ingredients of one quantity.
    pub ingredients: &'a Ingredients,
}

impl Engine<'_> {
    /// The attribution of a quantity whose value from the engine is `value`; `None` if the engine or the procedure does not give
    /// the ingredients, or if a value on the way is not positive.
    pub fn attribute(&self, made: &Made, value: f64) -> Option<Attribution> {
        let quantity = made.ingredients.quantity;
        let held = self.held.as_ref().and_then(|held| {
            let value = *held.values.get(quantity.id())?;
            let factor = held.factor;
            Some(Rung { factor, value })
        });
        let rungs = match &made.ingredients.recipe {
            Recipe::Response(target) => self.response(quantity, target)?,
            Recipe::Ladder(rungs) => self.ladder(quantity, rungs),
            Recipe::UniformWall { .. } => return None,
        };
        let rungs: Vec<Rung> = held.into_iter().chain(rungs).collect();
        let attribution = Attribution {
            quantity,
            method: made.method.into(),
            excitation: made.excitation,
            engine: value,
            steps: steps(value, &rungs)?,
            ratio: made.ingredients.value()? / value,
        };
        (attribution.gap() <= CLOSED).then_some(attribution)
    }

    /// The impulsive mode.
    fn structural(&self) -> Option<&ModalPart> {
        impulsive::among(self.modal).map(|(dominant, _)| dominant)
    }

    /// The first sloshing mode.
    fn sloshing(&self) -> Option<&ModalPart> {
        self.modal.iter().find(|p| p.kind == "sloshing" && p.number == 1)
    }

    fn ordinate(&self, period: f64, damping: f64) -> Ordinate {
        Ordinate::at(period, damping, (self.spectrum)(period, damping))
    }

    /// Rungs of a response.
    fn response(&self, quantity: Quantity, target: &Response) -> Option<Vec<Rung>> {
        let mut squares = 0.0;
        for part in self.modal {
            let response = match stress(quantity, part) {
                Some(stress) => stress?,
                None if quantity == Quantity::SloshingHeight => part.wave,
                None => of(quantity, &part.total),
            };
            squares += (response * (self.spectrum)(part.period, part.damping)).powi(2);
        }
        let mut state = self.two_modes(quantity, target)?;
        let mut rungs = vec![
            Rung { factor: Factor::TimeHistory, value: f64::sqrt(squares) },
            Rung { factor: Factor::Modes, value: state.value() },
        ];
        let split = self.structural().is_some_and(|mode| mode.structure.is_some());
        for factor in Factor::ALL {
            self.exchange(factor, &mut state, target, split);
            rungs.push(Rung { factor, value: state.value() });
        }
        Some(rungs)
    }

    /// The engine's value by its two modes.
    fn two_modes(&self, quantity: Quantity, target: &Response) -> Option<Response> {
        let sloshing = self.sloshing()?;
        let rise = match quantity {
            Quantity::SloshingHeight => Share::new(sloshing.wave, 1.0),
            _ => share(quantity, &sloshing.total, 0.0),
        };
        let mut convective = Part::liquid(self.ordinate(sloshing.period, sloshing.damping), rise);
        convective.scale = scale(quantity, sloshing)?;
        let impulsive = match (&target.impulsive, self.structural()) {
            (Some(part), Some(mode)) => {
                Some(Part { scale: scale(quantity, mode)?, ..self.impulsive(quantity, mode, part) })
            }
            (None, _) => None,
            (Some(_), None) => return None,
        };
        Some(Response { impulsive, convective: Some(convective), combination: Combination::Srss, vertical: None })
    }

    /// The impulsive part by one mode; a share that the engine does not have stands on the target's arm.
    fn impulsive(&self, quantity: Quantity, mode: &ModalPart, target: &Part) -> Part {
        let ordinate = self.ordinate(mode.period, mode.damping);
        match (&mode.structure, mode.liquid()) {
            (Some([wall, roof]), Some(liquid)) if quantity != Quantity::HoopStress => Part {
                wall: share(quantity, wall, target.wall.arm),
                roof: share(quantity, roof, target.roof.arm),
                floor: Share::new(0.0, target.floor.arm),
                ..Part::liquid(ordinate, share(quantity, &liquid, target.liquid.arm))
            },
            _ => {
                let whole = share(quantity, &mode.total, target.liquid.arm);
                let none = Share::new(0.0, whole.arm);
                Part { wall: none, roof: none, floor: none, ..Part::liquid(ordinate, whole) }
            }
        }
    }

    /// Replaces one ingredient of `state` by that of `target`.
    fn exchange(&self, factor: Factor, state: &mut Response, target: &Response, split: bool) {
        if let (Some(own), Some(other)) = (&mut state.impulsive, &target.impulsive) {
            masses(factor, own, other, split);
            match factor {
                Factor::ImpulsiveStress => own.scale = self.scale_here(other),
                Factor::Place => own.scale = other.scale,
                _ => {}
            }
            self.exchange_ordinate(factor, &mut own.ordinate, &other.ordinate, true);
        }
        if let (Some(own), Some(other)) = (&mut state.convective, &target.convective) {
            match factor {
                Factor::ConvectiveMass if state.impulsive.is_some() => own.liquid.mass = other.liquid.mass,
                Factor::WaveFormula if state.impulsive.is_none() => {
                    own.liquid.mass = other.liquid.mass;
                    own.finite_angle = other.finite_angle;
                }
                Factor::LeverArm => own.liquid.arm = other.liquid.arm,
                Factor::ConvectiveStress => own.scale = self.scale_here(other),
                Factor::Place => own.scale = other.scale,
                _ => {}
            }
            self.exchange_ordinate(factor, &mut own.ordinate, &other.ordinate, false);
        }
        match factor {
            Factor::Combination => state.combination = target.combination,
            Factor::Vertical => state.vertical = target.vertical,
            _ => {}
        }
    }

    /// Scale of a part of a procedure at the height of the modes' hoop stresses; where it gives none there, that of its own height.
    fn scale_here(&self, part: &Part) -> f64 {
        let here = self.hoop_height.and_then(|z| part.scale_at(z));
        here.unwrap_or(part.scale)
    }

    fn exchange_ordinate(&self, factor: Factor, own: &mut Ordinate, other: &Ordinate, impulsive: bool) {
        let period = match other.rule {
            Rule::Ground => Factor::RigidWall,
            Rule::Plateau => Factor::Plateau,
            Rule::At if impulsive => Factor::ImpulsivePeriod,
            Rule::At => Factor::SloshingPeriod,
        };
        if factor == period {
            own.period = other.period.or(own.period);
        } else if factor == Factor::Damping {
            own.damping = other.damping;
        } else if factor == Factor::Spectrum {
            own.base = other.base;
            return;
        } else {
            if factor >= Factor::DampingCorrection && other.factors.iter().any(|f| f.0 == factor) {
                own.factors.push((factor, other.factor(factor)));
            }
            return;
        }
        own.base = (self.spectrum)(own.period.unwrap_or(0.0), own.damping);
    }

    /// Rungs of a ladder, for the mass of the liquid from the mode to all modes first.
    fn ladder(&self, quantity: Quantity, rungs: &[Rung]) -> Vec<Rung> {
        let sloshing = self.modal.iter().filter(|p| p.kind == "sloshing");
        let sloshing: f64 = sloshing.map(|p| p.total.shear).sum();
        let all_modes = Rung { factor: Factor::Modes, value: self.liquid_mass - sloshing };
        let first = (quantity == Quantity::ImpulsiveMass && sloshing > 0.0).then_some(all_modes);
        first.into_iter().chain(rungs.iter().copied()).collect()
    }
}

/// The part of an inertia that a quantity is.
fn of(quantity: Quantity, inertia: &Inertia) -> f64 {
    match quantity {
        Quantity::BaseMoment | Quantity::AxialMembraneStress => inertia.moment,
        Quantity::OverturningMoment => inertia.overturning,
        _ => inertia.shear,
    }
}

/// A mass and its arm; a mass of zero stands on `arm`.
fn share(quantity: Quantity, inertia: &Inertia, arm: f64) -> Share {
    let shear = inertia.shear;
    match quantity {
        Quantity::BaseShear => Share::new(shear, 1.0),
        Quantity::HoopStress => Share::new(1.0, 1.0),
        _ if shear == 0.0 => Share::new(0.0, arm),
        _ => Share::new(shear, of(quantity, inertia) / shear),
    }
}

/// The stress that a quantity is, per acceleration [Pa·s²/m]: none for what is no stress, none within if the engine has none.
fn stress(quantity: Quantity, part: &ModalPart) -> Option<Option<f64>> {
    match quantity {
        Quantity::HoopStress => Some(part.stress.map(|s| s.hoop)),
        Quantity::AxialMembraneStress => Some(part.stress.map(|s| s.axial)),
        _ => None,
    }
}

/// Stress of a mode per acceleration (hoop) or per moment (axial), 1 for what is no stress; `None` if the engine has none.
fn scale(quantity: Quantity, mode: &ModalPart) -> Option<f64> {
    let scale = match (quantity, stress(quantity, mode)) {
        (Quantity::AxialMembraneStress, Some(stress)) => stress? / mode.total.moment,
        (_, Some(stress)) => stress?,
        (_, None) => 1.0,
    };
    scale.is_finite().then_some(scale)
}

/// Replaces the masses or the arms of an impulsive part. An engine that does not separate its masses exchanges them together.
fn masses(factor: Factor, own: &mut Part, other: &Part, split: bool) {
    if factor == Factor::LeverArm {
        own.liquid.arm = other.liquid.arm;
        own.wall.arm = other.wall.arm;
        own.roof.arm = other.roof.arm;
        own.floor.arm = other.floor.arm;
    }
    let together = factor == Factor::ImpulsiveMass && !split;
    let takes = |own_factor| together || (split && factor == own_factor);
    for (which, own, other) in [
        (Factor::LiquidMass, &mut own.liquid, &other.liquid),
        (Factor::WallMass, &mut own.wall, &other.wall),
        (Factor::RoofMass, &mut own.roof, &other.roof),
        (Factor::FloorMass, &mut own.floor, &other.floor),
    ] {
        if takes(which) {
            own.mass = other.mass;
        }
    }
}

/// The factors of the rungs; `None` if a value is not positive and finite.
fn steps(start: f64, rungs: &[Rung]) -> Option<Vec<FactorStep>> {
    let sound = |value: f64| value > 0.0 && value.is_finite();
    let mut before = start;
    let mut steps = Vec::new();
    for rung in rungs {
        if !sound(before) || !sound(rung.value) {
            return None;
        }
        let factor = rung.value / before;
        if (factor - 1.0).abs() > UNCHANGED {
            steps.push(FactorStep { factor_id: rung.factor, factor, value: rung.value });
            before = rung.value;
        }
    }
    Some(steps)
}

#[cfg(test)]
mod tests;
