//! What the comparable quantities of EN 1998-4 are made of, for the attribution of differences.

use super::work::{Masses, Work};
use crate::mechanical::Lumped;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Part, Recipe, Response, Share, Vertical};
use tank::quantity::Quantity;

/// Periods [s] and accelerations [m/s²] of an assessment.
pub(super) struct Motion {
    /// Impulsive period and acceleration.
    pub impulsive: (f64, f64),
    /// Period and acceleration of the convective part of the resultants.
    pub convective: (f64, f64),
    /// Period of the first sloshing mode and its acceleration, for the wave.
    pub sloshing: (f64, f64),
}

/// The wall that the impulsive period belongs to.
pub(super) enum Wall {
    /// A cylinder of one thickness [m] and modulus [Pa], by a formula.
    Uniform { thickness: f64, modulus: f64 },
    /// The courses as they are, as a shell.
    Shell,
    /// A wall of a box, by its deflection.
    Plate,
}

/// Adds the ingredients of wave, shear and moments, masses and periods.
///
/// * `masses`: as the resultants have them; `exact`: those of the rigid tank in potential flow
pub(super) fn record(work: &mut Work, masses: &Masses, exact: &Masses, motion: &Motion, wall: &Wall) {
    responses(work, masses, motion);
    let period = work.out.values.get(&Quantity::SloshingPeriod).copied().unwrap_or(0.0);
    let liquid = work.mass;
    let mut ladder = |quantity, rungs: &[(Factor, f64)]| {
        work.out.ingredients.push(Ingredients::ladder(quantity, rungs));
    };
    // The period is the exact one.
    ladder(Quantity::SloshingPeriod, &[(Factor::RigidTank, period)]);
    ladder(
        Quantity::ImpulsiveMass,
        &[(Factor::RigidTank, exact.impulsive.mass), (Factor::Formula, masses.impulsive.mass)],
    );
    let one_mode = (Factor::RigidTank, exact.convective.mass);
    let all_modes = (Factor::AllSloshingModes, liquid - exact.impulsive.mass);
    let table = (Factor::Formula, masses.convective.mass);
    if masses == exact {
        ladder(Quantity::ConvectiveMass, &[one_mode]);
    } else {
        ladder(Quantity::ConvectiveMass, &[one_mode, all_modes, table]);
    }
    let period = motion.impulsive.0;
    match wall {
        Wall::Uniform { thickness, modulus } => work.out.ingredients.push(Ingredients {
            quantity: Quantity::ImpulsivePeriod,
            recipe: Recipe::UniformWall { thickness: *thickness, modulus: *modulus, period },
        }),
        Wall::Shell => ladder(Quantity::ImpulsivePeriod, &[(Factor::ShellModel, period)]),
        Wall::Plate => ladder(Quantity::ImpulsivePeriod, &[(Factor::Formula, period)]),
    }
}

fn responses(work: &mut Work, masses: &Masses, motion: &Motion) {
    let case = work.case;
    let (damping, combination) = (case.damping, case.procedures.ec8_combination);
    let q = work.demand.behaviour_factor;
    let ((t_i, a_i), (t_c, a_c), (t_w, a_w)) = (motion.impulsive, motion.convective, motion.sloshing);
    let impulsive = work.demand.ordinate(a_i, t_i, damping.impulsive, q);
    let convective = work.demand.ordinate(a_c, t_c, damping.sloshing, 1.0);
    let wave = work.demand.ordinate(a_w, t_w, damping.sloshing, 1.0);
    let (tank, roof) = (&case.tank, case.tank.roof.mass);
    type Arm = fn(&Lumped) -> f64;
    let arms: [(Quantity, Arm, bool); 3] = [
        (Quantity::BaseShear, |_| 1.0, false),
        (Quantity::BaseMoment, |part| part.lever, true),
        (Quantity::OverturningMoment, |part| part.lever_with_base, true),
    ];
    for (quantity, arm, moment) in arms {
        let height = |height: f64| if moment { height } else { 1.0 };
        let share = |part: &Lumped| Share::new(part.mass, arm(part));
        let response = Response {
            impulsive: Some(Part {
                wall: Share::new(tank.wall_mass(), height(tank.wall_centroid())),
                roof: Share::new(roof, height(tank.roof_height())),
                ..Part::liquid(impulsive.clone(), share(&masses.impulsive))
            }),
            convective: Some(Part::liquid(convective.clone(), share(&masses.convective))),
            combination,
            vertical: None,
        };
        work.out.ingredients.push(Ingredients::response(quantity, response));
    }
    if let Some(height) = work.out.values.get(&Quantity::SloshingHeight).filter(|_| a_w > 0.0) {
        let response = Response {
            impulsive: None,
            convective: Some(Part::liquid(wave, Share::new(height / a_w, 1.0))),
            combination,
            vertical: None,
        };
        work.out.ingredients.push(Ingredients::response(Quantity::SloshingHeight, response));
    }
}

/// Membrane stresses of a cylinder: stresses per acceleration [Pa·s²/m] of both parts at the place of the largest hoop stress,
/// the vertical motion there, and the axial stress of a moment at the base [1/m³].
pub(super) struct Stresses {
    /// Impulsive hoop stress.
    pub impulsive: f64,
    /// Convective hoop stress.
    pub convective: f64,
    /// Heights [m] with both hoop stresses there.
    pub along: Vec<(f64, f64, f64)>,
    /// Hoop stress of the vertical motion.
    pub vertical: Option<Vertical>,
    /// 1/(π R² s).
    pub axial: f64,
}

/// Adds the ingredients of the membrane stresses, after those of the base moment.
pub(super) fn stresses(work: &mut Work, motion: &Motion, stresses: &Stresses) {
    let damping = work.case.damping;
    let ((t_i, a_i), (t_w, a_w)) = (motion.impulsive, motion.sloshing);
    let q = work.demand.behaviour_factor;
    let impulsive = work.demand.ordinate(a_i, t_i, damping.impulsive, q);
    let convective = work.demand.ordinate(a_w, t_w, damping.sloshing, 1.0);
    let hoop = Response {
        vertical: stresses.vertical,
        ..Response::hoop(
            (impulsive, stresses.impulsive),
            (convective, stresses.convective),
            work.case.procedures.ec8_combination,
        )
        .along(&stresses.along)
    };
    let all = &mut work.out.ingredients;
    let moment = all.iter().find(|i| i.quantity == Quantity::BaseMoment);
    let axial = moment.and_then(|i| i.scaled(Quantity::AxialMembraneStress, stresses.axial));
    all.push(Ingredients::response(Quantity::HoopStress, hoop));
    all.extend(axial);
}

/// Adds the wall and the roof that move with the impulsive part: all of them, whatever moves in one mode of an engine.
pub(super) fn structure(work: &mut Work) {
    let tank = &work.case.tank;
    for (quantity, mass) in [(Quantity::WallMass, tank.wall_mass()), (Quantity::RoofMass, tank.roof.mass)] {
        if mass > 0.0 {
            work.out.values.insert(quantity, mass);
            let all = Ingredients::ladder(quantity, &[(Factor::Modes, mass)]);
            work.out.ingredients.push(all);
        }
    }
}
