//! What the quantities of the chain are made of, for the attribution of differences.

use tank::case::Combination;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Part, Recipe, Response, Rung, Share, Vertical};
use tank::quantity::Quantity;

use super::wall::Stresses;
use super::{Action, Impulsive, Masses, Periods, Work};
use crate::mechanical::{Lumped, convective, impulsive, sloshing_omega};

impl Work<'_> {
    /// Adds the ingredients of all quantities.
    ///
    /// * `share`: share ε of the wall
    pub(super) fn ingredients(
        &mut self,
        masses: &Masses,
        periods: &Periods,
        action: &Action,
        share: f64,
        stresses: Stresses,
    ) {
        let mut all = self.ladders(masses, periods, share);
        all.extend(self.responses(masses, action, share));
        let rise = 0.5 * self.length / self.case.gravity;
        let wave = Response {
            impulsive: None,
            convective: Some(Part::liquid(action.wave.clone(), Share::new(rise, 1.0))),
            combination: Combination::Srss,
            vertical: None,
        };
        all.push(Ingredients::response(Quantity::SloshingHeight, wave));
        if let Some(hoop) = stresses.hoop {
            let parts = Response::hoop(
                (action.impulsive.clone(), hoop.impulsive),
                (action.convective.clone(), hoop.convective),
                Combination::Srss,
            );
            let vertical = Vertical { horizontal: 1.0, value: hoop.vertical, combination: Combination::Srss };
            let vertical = (hoop.vertical > 0.0).then_some(vertical);
            let response = Response { vertical, ..parts.along(&hoop.along) };
            all.push(Ingredients::response(Quantity::HoopStress, response));
            let moment = all.iter().find(|i| i.quantity == Quantity::BaseMoment);
            let axial = moment.and_then(|i| i.scaled(Quantity::AxialMembraneStress, stresses.axial));
            all.extend(axial);
        }
        self.out.ingredients = all;
    }

    /// Masses and periods against potential flow in a rigid tank; wall and roof that move with it.
    fn ladders(&self, masses: &Masses, periods: &Periods, share: f64) -> Vec<Ingredients> {
        let case = self.case;
        let (half, depth) = (0.5 * self.length, case.liquid.fill_height);
        let (gamma, mass) = (depth / half, case.liquid_mass());
        let exact = std::f64::consts::TAU / sloshing_omega(self.plan, 1, half, depth, case.gravity);
        let of = |quantity, exact, value| {
            Ingredients::ladder(quantity, &[(Factor::RigidTank, exact), (Factor::Formula, value)])
        };
        let of_wall = [(Factor::Modes, case.tank.wall_mass()), (Factor::Formula, share * case.tank.thick_wall().0)];
        let mut all = vec![
            of(Quantity::SloshingPeriod, exact, periods.convective),
            of(Quantity::ImpulsiveMass, mass * impulsive(self.plan, gamma).mass, masses.impulsive.mass),
            of(Quantity::ConvectiveMass, mass * convective(self.plan, gamma, 1).mass, masses.convective.mass),
            Ingredients::ladder(Quantity::WallMass, &of_wall),
        ];
        if case.tank.roof.mass > 0.0 {
            all.push(Ingredients::ladder(Quantity::RoofMass, &[(Factor::Modes, case.tank.roof.mass)]));
        }
        if let Some(Impulsive { period, uniform }) = periods.impulsive {
            let recipe = match uniform {
                Some((thickness, modulus)) => Recipe::UniformWall { thickness, modulus, period },
                None => Recipe::Ladder(vec![Rung { factor: Factor::Formula, value: period }]),
            };
            all.push(Ingredients { quantity: Quantity::ImpulsivePeriod, recipe });
        }
        all
    }

    /// Base shear and moments.
    fn responses(&self, masses: &Masses, action: &Action, share: f64) -> Vec<Ingredients> {
        let tank = &self.case.tank;
        let (wall, centre) = tank.thick_wall();
        type Arm = fn(&Lumped) -> f64;
        let arms: [(Quantity, Arm, bool); 3] = [
            (Quantity::BaseShear, |_| 1.0, false),
            (Quantity::BaseMoment, |part| part.lever, true),
            (Quantity::OverturningMoment, |part| part.lever_with_base, true),
        ];
        let response = |(quantity, arm, moment): (Quantity, Arm, bool)| {
            let height = |height: f64| if moment { height } else { 1.0 };
            let liquid = |part: &Lumped| Share::new(part.mass, arm(part));
            let response = Response {
                impulsive: Some(Part {
                    wall: Share::new(share * wall, height(centre)),
                    roof: Share::new(tank.roof.mass, height(tank.roof_height())),
                    ..Part::liquid(action.impulsive.clone(), liquid(&masses.impulsive))
                }),
                convective: Some(Part::liquid(action.convective.clone(), liquid(&masses.convective))),
                combination: Combination::Srss,
                vertical: None,
            };
            Ingredients::response(quantity, response)
        };
        arms.into_iter().map(response).collect()
    }
}
