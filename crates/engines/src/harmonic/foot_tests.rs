//! Source:    Timoshenko and Woinowsky-Krieger, "Theory of Plates and Shells", art. 114 to 117: long cylinder under hydrostatic pressure
//! Goal:      a foot that is clamped, hinged or slides on a bearing, at rest and in its modes
//! Tolerance: far end of the closed form exp(−12.9), default mesh 0.5 % of the largest value ([`super::Static`] against its clamped form); a
//!            bearing of 1e13 Pa gives way by 1e-3 of what the shell does

use tank::{Shape, Support, WallBase};

use super::{Output, Places, Static, test_tanks};
use crate::linear::describe::mass_balance;
use crate::linear::model::Model;
use crate::modes::Kind;
use results::Channel;
use results::channel::OnWall;
use tank::options::LinearOptions as Options;

const JOINTS: [WallBase; 4] = [WallBase::Fixed, WallBase::Hinged, bearing(5e7), bearing(0.0)];

const fn bearing(stiffness: f64) -> WallBase {
    WallBase::Sliding { stiffness: Some(stiffness), friction: None }
}

/// R = 10 m, 10 cm of concrete without weight, full to 10 m.
fn tank(base: WallBase) -> tank::Case {
    let shape = Shape::Cylinder { radius: 10.0 };
    let mut case = test_tanks::case(shape, &[(10.0, 0.1)], (30e9, 0.2, 1e-6), (1000.0, 10.0));
    case.tank.wall_base = base;
    case
}

#[test]
fn at_rest_it_is_the_edge_solution() {
    let (r, t, h, nu, e) = (10.0f64, 0.1f64, 10.0f64, 0.2f64, 30e9f64);
    let beta = (3.0 * (1.0 - nu * nu) / (r * r * t * t)).powf(0.25);
    let d = e * t.powi(3) / (12.0 * (1.0 - nu * nu));
    let w_p = |z: f64| 9810.0 * (h - z) * r * r / (e * t);
    for base in JOINTS {
        let case = tank(base);
        let state = Static::solve(&case, 1.0, 0.0).unwrap();
        // w = w_p − e^(−βz) (a cos βz + b sin βz)
        let foot = 2.0 * beta.powi(3) * d;
        let (a, b) = match base {
            WallBase::Fixed => (w_p(0.0), w_p(0.0) * (1.0 - 1.0 / (beta * h))),
            WallBase::Hinged => (w_p(0.0), 0.0),
            WallBase::Sliding { .. } => (w_p(0.0) * base.stiffness() / (foot + base.stiffness()), 0.0),
        };
        for z in [0.0f64, 0.4, 1.0, 2.5, 5.0, 9.0] {
            let (c, s) = ((beta * z).cos() * (-beta * z).exp(), (beta * z).sin() * (-beta * z).exp());
            let hoop = e / r * (w_p(z) - a * c - b * s);
            let found = state.at(z, true, Output::HoopStress);
            assert!((found - hoop).abs() < 5e-3 * 9.81e6, "{base:?} z = {z}: {found} {hoop}");
            // Tension of the outer face is positive: D w″ of a wall that bends outwards above its foot.
            let moment = d * 2.0 * beta * beta * (a * s - b * c);
            let found = state.at(z, true, Output::BendingMoment);
            let largest = d * 2.0 * beta * beta * w_p(0.0);
            assert!((found - moment).abs() < 1e-2 * largest, "{base:?} z = {z}: {found} {moment}");
        }
    }
}

/// What holds less swings slower; a stiff bearing is a hinge; all that the foot takes is in the base shear.
#[test]
fn a_looser_foot_swings_slower() {
    let period = |base| {
        let mut case = tank(base);
        case.tank.courses[0].material.density = 2500.0;
        let model = Model::new(&case, &Options::default(), false, Places::Usual).unwrap();
        for balance in mass_balance(&model) {
            assert!(balance.error.abs() < 1e-9, "{base:?}: {balance:?}");
        }
        // A foot that turns has no bending to compare.
        let bending = model.horizontal.coupled.probe(Channel::Base(OnWall::Bending));
        assert_eq!(bending.is_some(), base.is_fixed());
        std::f64::consts::TAU / model.horizontal.first(Kind::Structural).unwrap().omega
    };
    let [fixed, hinged, pads, free] = JOINTS.map(period);
    assert!(fixed < hinged && hinged < pads && pads < free, "{fixed} {hinged} {pads} {free}");
    assert!((period(bearing(1e13)) / hinged - 1.0).abs() < 1e-4);
}

/// Engines that clamp the foot refuse it, the harmonic one on a base that moves.
#[test]
fn other_engines_refuse_it() {
    use crate::registry;
    use tank::options::nonlinear::NonlinearOptions;
    use tank::options::solid::SolidOptions;
    use tank::refusal::Place;

    let refused = |base, support| {
        let mut case = tank(base);
        case.tank.support = support;
        let (linear, solid) = (Options::default(), SolidOptions::default());
        let nonlinear = NonlinearOptions::new(case.damping);
        let task = crate::engine::Task {
            case: &case,
            linear: &linear,
            solid: &solid,
            nonlinear: &nonlinear,
            checkpoint: None,
            without: &[],
        };
        results::EngineId::ALL.map(|id| {
            let refusals = registry::engine(id).refuses(&task);
            refusals.iter().any(|refusal| refusal.place == Place::WallBase)
        })
    };
    assert_eq!(refused(WallBase::Fixed, Support::Anchored), [false; 3]);
    assert_eq!(refused(WallBase::Hinged, Support::Anchored), [false, true, true]);
    assert_eq!(refused(bearing(0.0), Support::Unanchored), [true; 3]);
}
