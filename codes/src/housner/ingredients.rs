//! What the quantities of Housner's model are made of, for the attribution of differences.
//!
//! ```text
//! P_k   = c_p m_k g θ_h = (c_p c_t/k) m_k S_a                                     by θ_h = c_t (A₁/a) tanh x, A₁ = S_a/ω²
//! d_max = c_d a coth x/(g/(ω² θ_h a) − 1) = (c_d c_t a/g) S_a/(1 − (c_t tanh x/g) S_a)
//! ```

use super::run::Run;
use super::stress;
use crate::mechanical::{Plan, convective, impulsive, sloshing_omega};
use tank::Shape;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Part, Response, Share};
use tank::quantity::Quantity;

/// The ingredients of a run.
pub(super) fn of(run: &Run) -> Vec<Ingredients> {
    let mut all = vec![wave(run)];
    all.extend(resultants(run));
    if let Shape::Cylinder { radius } = run.case.tank.shape {
        all.push(hoop(run, radius));
        all.extend(axial(run, radius, &all));
    }
    all.extend(ladders(run));
    all
}

fn wave(run: &Run) -> Ingredients {
    let (r, input) = (&run.response, &run.input);
    let (c, g) = (input.coefficients, input.gravity);
    let (factor, angle) = match r.wave.finite {
        Some(_) => (c.wave * c.angle, c.angle * r.x.tanh() / g),
        None => (c.wave_linear, 0.0),
    };
    let rise = Share::new(factor * input.half_length / g, 1.0);
    let ordinate = run.motion.sloshing_ordinate(r.period, r.acceleration);
    let response = Response {
        impulsive: None,
        convective: Some(Part { finite_angle: angle, ..Part::liquid(ordinate, rise) }),
        combination: run.combination,
        vertical: None,
    };
    Ingredients::response(Quantity::SloshingHeight, response)
}

/// Hoop stress where it is largest: both pressures are in proportion to their accelerations.
fn hoop(run: &Run, radius: f64) -> Ingredients {
    let (r, p) = (&run.response, run.pressures());
    let per = |z: f64, pressure: f64, acceleration: f64| match acceleration > 0.0 {
        true => stress::hoop(pressure, radius, run.case.tank.course_at(z).thickness) / acceleration,
        false => 0.0,
    };
    let at = |z: f64| {
        let impulsive = per(z, p.impulsive(z), run.motion.ground);
        (z, impulsive, per(z, p.convective(z), r.acceleration))
    };
    let (_, impulsive, convective) = at(run.hoop_place());
    let heights: Vec<_> = run.heights().into_iter().map(at).collect();
    let response = Response::hoop(
        (run.motion.ground_ordinate(), impulsive),
        (run.motion.sloshing_ordinate(r.period, r.acceleration), convective),
        run.combination,
    );
    let response = response.along(&heights);
    Ingredients::response(Quantity::HoopStress, response)
}

/// Axial stress of the moment at the base.
fn axial(run: &Run, radius: f64, all: &[Ingredients]) -> Option<Ingredients> {
    let moment = all.iter().find(|i| i.quantity == Quantity::BaseMoment)?;
    let modulus = stress::section_modulus_circle(2.0 * radius, run.case.tank.course_at(0.0).thickness);
    moment.scaled(Quantity::AxialMembraneStress, 1.0 / modulus)
}

fn resultants(run: &Run) -> [Ingredients; 3] {
    let (r, c) = (&run.response, run.input.coefficients);
    let mass = r.impulsive_mass + r.rigid_mass;
    let arm = |lever: f64| (r.impulsive_mass * (r.rigid_depth + lever) + r.rigid_mass * 0.5 * r.rigid_depth) / mass;
    let sloshing = r.convective_mass * c.force * c.angle / c.frequency;
    [
        (Quantity::BaseShear, 1.0, 1.0),
        (Quantity::BaseMoment, arm(r.impulsive_lever), r.rigid_depth + r.convective_lever),
        (Quantity::OverturningMoment, arm(r.impulsive_lever_with_base), r.rigid_depth + r.convective_lever_with_base),
    ]
    .map(|(quantity, impulsive_arm, convective_arm)| {
        let ordinate = run.motion.sloshing_ordinate(r.period, r.acceleration);
        let response = Response {
            impulsive: Some(Part::liquid(run.motion.ground_ordinate(), Share::new(mass, impulsive_arm))),
            convective: Some(Part::liquid(ordinate, Share::new(sloshing, convective_arm))),
            combination: run.combination,
            vertical: None,
        };
        Ingredients::response(quantity, response)
    })
}

/// Periods and masses: exact for the whole depth, exact for the depth that can slosh, and by the constants.
fn ladders(run: &Run) -> [Ingredients; 3] {
    let (r, input) = (&run.response, &run.input);
    let (plan, a): (Plan, f64) = (run.plan, input.half_length);
    let period = |depth: f64| std::f64::consts::TAU / sloshing_omega(plan, 1, a, depth, input.gravity);
    let sloshing = |mass: f64, depth: f64| mass * convective(plan, depth / a, 1).mass;
    let rigid = input.mass * impulsive(plan, input.depth / a).mass;
    [
        Ingredients::ladder(
            Quantity::SloshingPeriod,
            &[
                (Factor::RigidTank, period(input.depth)),
                (Factor::LiquidDepth, period(r.sloshing_depth)),
                (Factor::Formula, r.period),
            ],
        ),
        Ingredients::ladder(
            Quantity::ImpulsiveMass,
            &[(Factor::RigidTank, rigid), (Factor::Formula, r.impulsive_mass + r.rigid_mass)],
        ),
        Ingredients::ladder(
            Quantity::ConvectiveMass,
            &[
                (Factor::RigidTank, sloshing(input.mass, input.depth)),
                (Factor::LiquidDepth, sloshing(r.sloshing_mass, r.sloshing_depth)),
                (Factor::Formula, r.convective_mass),
            ],
        ),
    ]
}
