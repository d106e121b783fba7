//! What the quantities of both editions are made of, for the attribution of differences.

use tank::case::Combination;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Ordinate, Part, Response, Share};
use tank::quantity::Quantity;

use super::basis::Basis;
use crate::mechanical::{Plan, convective, impulsive, sloshing_omega};

/// Accelerations of the two parts, and their combination.
pub(super) struct Action {
    pub impulsive: Ordinate,
    pub convective: Ordinate,
    pub combination: Combination,
}

/// Masses [kg] and arms [m] of the liquid in one resultant; the arms are 1 in a base shear.
pub(super) struct Liquid {
    pub impulsive: Share,
    pub convective: Share,
}

/// A resultant of liquid, shell, roof and floor.
///
/// * `roof`: height of the roof's mass [m]
pub(super) fn resultant(basis: &Basis, action: &Action, quantity: Quantity, liquid: Liquid, roof: f64) -> Ingredients {
    let g = basis.case.gravity;
    let shear = quantity == Quantity::BaseShear;
    let height = |height: f64| if shear { 1.0 } else { height };
    let floor = if shear { basis.w_f / g } else { 0.0 };
    let response = Response {
        impulsive: Some(Part {
            wall: Share::new(basis.w_s / g, height(basis.x_s)),
            roof: Share::new(basis.w_r / g, height(roof)),
            floor: Share::new(floor, 1.0),
            ..Part::liquid(action.impulsive.clone(), liquid.impulsive)
        }),
        convective: Some(Part::liquid(action.convective.clone(), liquid.convective)),
        combination: action.combination,
        vertical: None,
    };
    Ingredients::response(quantity, response)
}

/// Axial membrane stress of the moment among `all`, `1.273 M/D²/t_s`.
pub(super) fn axial(basis: &Basis, all: &[Ingredients]) -> Option<Ingredients> {
    let moment = all.iter().find(|i| i.quantity == Quantity::BaseMoment)?;
    moment.scaled(Quantity::AxialMembraneStress, 1.273 / (basis.d * basis.d) / basis.t_s)
}

/// A wave of `rise` per acceleration [s²].
pub(super) fn wave(ordinate: Ordinate, rise: f64) -> Ingredients {
    let response = Response {
        impulsive: None,
        convective: Some(Part::liquid(ordinate, Share::new(rise, 1.0))),
        combination: Combination::Abs,
        vertical: None,
    };
    Ingredients::response(Quantity::SloshingHeight, response)
}

/// Sloshing period [s] and masses [kg] of the liquid against potential flow in a rigid tank; all of shell and roof.
pub(super) fn ladders(basis: &Basis, period: f64, impulsive_mass: f64, convective_mass: f64) -> Vec<Ingredients> {
    let (radius, depth) = (0.5 * basis.d, basis.h);
    let (gamma, mass, g) = (depth / radius, basis.case.liquid_mass(), basis.case.gravity);
    let exact = std::f64::consts::TAU / sloshing_omega(Plan::Circle, 1, radius, depth, g);
    let of =
        |quantity, exact, value| Ingredients::ladder(quantity, &[(Factor::RigidTank, exact), (Factor::Formula, value)]);
    let mut all = vec![
        of(Quantity::SloshingPeriod, exact, period),
        of(Quantity::ImpulsiveMass, mass * impulsive(Plan::Circle, gamma).mass, impulsive_mass),
        of(Quantity::ConvectiveMass, mass * convective(Plan::Circle, gamma, 1).mass, convective_mass),
        Ingredients::ladder(Quantity::WallMass, &[(Factor::Modes, basis.w_s / g)]),
    ];
    if basis.w_r > 0.0 {
        all.push(Ingredients::ladder(Quantity::RoofMass, &[(Factor::Modes, basis.w_r / g)]));
    }
    all
}
