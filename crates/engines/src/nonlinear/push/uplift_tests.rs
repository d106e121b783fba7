//! Unanchored tanks.

use std::sync::atomic::{AtomicU64, Ordering};

use results::PushBase;
use tank::options::nonlinear::WallElements;
use tank::reference::{case, material};
use tank::{Behaviour, Case, Shape, Steel};

use super::super::bottom;
use super::*;
use crate::harmonic::test_tanks;

/// Example 05 in brief: 40 m wide, 15 m of oil, 10 mm of bottom plate, on 10⁸ N/m³.
fn oil(yield_strength: f64) -> Case {
    let mut steel = material(2.05e11, 0.3, 7850.0);
    steel.yield_strength = Some(yield_strength);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength,
        tangent_modulus: 2.05e9,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    let courses = [(2.4, 0.025), (2.4, 0.021), (2.4, 0.018), (2.4, 0.014), (7.2, 0.01)];
    let mut case = case(Shape::Cylinder { radius: 20.0 }, &courses, &steel, (870.0, 15.0));
    test_tanks::on_ground(&mut case, 0.01, steel, 1e8);
    if let Some(foundation) = &mut case.tank.foundation {
        foundation.friction = Some(tank::FRICTION);
    }
    case
}

fn options(case: &Case, circumference: u32) -> NonlinearOptions {
    NonlinearOptions {
        elements: Some(WallElements { height: 24, circumference }),
        ..NonlinearOptions::new(case.damping)
    }
}

/// Stops after so many states.
pub(super) struct Until {
    states: u64,
    done: AtomicU64,
}

impl Until {
    pub(super) fn states(states: u64) -> Until {
        let done = AtomicU64::new(0);
        Until { states, done }
    }
}

impl Progress for Until {
    fn stage(&self, _name: &str, _steps: u64) {}
    fn advance(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }
    fn interrupted(&self) -> bool {
        self.done.load(Ordering::Relaxed) >= self.states
    }
}

/// Where the foot is kept a plane, elastic plates have the moments of the strips from 10⁻³ rad on, within 3 %: strips neglect hoop forces,
/// which makes them 1.3 to 1.8 % stiff against a plate of von Karman. Before, where the ground under the rim carries, within 5 %: its springs stand at
/// nodes two plate thicknesses apart. The impulsive pressure turns the foot of the wall; strips without that are 13 % stiff there.
#[test]
fn a_plane_foot_has_the_moments_of_the_strips() {
    let case = oil(205e9);
    let options = options(&case, 48);
    let plan = Plan::new(&case, &options, true).unwrap();
    let progress = Until::states(23);
    let found = path::follow(&plan, None, "perfect shell", None, &mut Keeper::new(None, &plan), &progress).unwrap();
    let mut shells = [found.shell()];
    lifted::compare(&plan, &mut shells);
    let bases = shells[0].path.iter().filter_map(|p| p.base);
    let far: Vec<PushBase> = bases.filter(|b| b.rotation > 1e-3).collect();
    assert!(far.len() > 4 && far.iter().any(|b| b.uplift > 0.08), "{far:?}");
    let bases = shells[0].path.iter().filter_map(|p| p.base);
    for base in bases.filter(|b| b.rotation > 1e-5) {
        let ratio = base.moment / base.strips.unwrap();
        let tolerance = if base.rotation > 1e-3 { 0.03 } else { 0.05 };
        assert!((ratio - 1.0).abs() < tolerance, "{ratio}: {base:?}");
    }
}

/// A friction of 0 leaves friction out of the pushover as of the history: the plate slips freely and the foot is held along the ground.
#[test]
fn a_friction_of_zero_is_none() {
    for (friction, words) in [(Some(0.4), "with friction of 0.4"), (None, "without friction, the foot held along it")] {
        let mut case = oil(205e9);
        if let Some(foundation) = &mut case.tank.foundation {
            foundation.friction = friction;
        }
        let options = options(&case, 16);
        let plan = Plan::new(&case, &options, false).unwrap();
        assert_eq!(plan.plate.as_ref().unwrap().friction, friction);
        assert!(assumptions(&plan).iter().any(|text| text.contains(words)), "{:?}", assumptions(&plan));
        let progress = Until::states(8);
        let found = path::follow(&plan, None, "perfect shell", None, &mut Keeper::new(None, &plan), &progress).unwrap();
        assert!(found.shell().path.iter().any(|p| p.base.is_some_and(|b| b.rotation > 1e-5)));
    }
}

/// Strips whose foot warps have what shells of the same rim have: elastic plates under a free top and under one that is held round, M(ψ) and uplift
/// within 5 % between 1 and 3·10⁻³ rad (at 5·10⁻³ the uplift is 1.5 % short). Plane strips have 30 to 40 % more moment than shells under a free top.
#[test]
fn strips_warp_as_shells_do() {
    for holds in [tank::RimSupport::Free, tank::RimSupport::Round] {
        let mut case = oil(205e9);
        case.tank.roof.holds = holds;
        let options = options(&case, 48);
        let plan = Plan::new(&case, &options, false).unwrap();
        let progress = Until::states(22);
        let found = path::follow(&plan, None, "perfect shell", None, &mut Keeper::new(None, &plan), &progress).unwrap();
        let path = found.shell().path;
        let plate = plan.plate.as_ref().unwrap();
        let rocking = plate.base.rocking(-0.06, 0.3, true).unwrap();
        let flat = rocking.clone().warping(None);
        let mut count = 0;
        for (point, base) in
            path.iter().filter_map(|p| Some((p, p.base?))).filter(|(_, b)| (1e-3..3e-3).contains(&b.rotation))
        {
            let suction = plate.suction() * point.acceleration;
            let turn = rocking.at(base.rotation, suction).unwrap();
            let plane = flat.at(base.rotation, suction).unwrap();
            let off = [turn.moment / base.moment - 1.0, turn.uplift / base.uplift - 1.0];
            assert!(off.iter().all(|o| o.abs() < 0.05), "{holds:?}: {off:?} {base:?}");
            if holds.is_free() {
                assert!(plane.moment > 1.25 * base.moment, "{plane:?} {base:?}");
            } else {
                assert!(turn.waves[0].abs() < 0.02 * turn.uplift, "{turn:?}");
            }
            count += 1;
        }
        assert!(count >= 3, "{count}");
    }
}

/// A free top lets the foot warp: more uplift and less moment at a rotation than the strips have. The plates yield at the joint; the ground
/// carries weight and pressure, and its moment is that of the forces on the wall, within 3 % for the turned pressure.
#[test]
fn a_free_top_lets_the_foot_warp() {
    let case = oil(205e6);
    let options = options(&case, 32);
    let pushed = pushover(&case, &options, &PushOptions::default(), &[], None, &Until::states(16)).unwrap();
    let path = &pushed.shells[0].path;
    let rest = path[0].base.unwrap();
    // The liquid turns the foot of the wall, which presses the rim down: sheet of the strips, with their weight.
    assert!((rest.toe - 3.85e-3).abs() < 0.15e-3 && rest.lifted_angle == 0.0, "{rest:?}");
    let last = path[path.len() - 1];
    let base = last.base.unwrap();
    assert!(base.uplift > 0.05 && base.plastic_rotation > 0.05, "{base:?}");
    let flat = ::base::Base::of(&case).unwrap().plane().rocking(-0.06, 0.3, true).unwrap();
    assert!(base.moment < 0.85 * flat.at(base.rotation, 0.0).unwrap().moment, "{base:?}");
    assert!((base.moment / last.base_moment - 1.0).abs() < 0.03, "{last:?}");
    assert!((base.reaction / rest.reaction - 1.0).abs() < 1e-3, "{base:?}");
}

#[test]
fn a_buckling_mode_is_rejected() {
    let case = oil(205e6);
    let options = options(&case, 32);
    let push =
        PushOptions { imperfection: Some(Amplitude::Thicknesses(0.5)), form: Form::Mode, ..PushOptions::default() };
    let error = pushover(&case, &options, &push, &[], None, &Until::states(1)).unwrap_err();
    assert!(matches!(error, FeError::Option { .. }), "{error}");
    let mut bare = case.clone();
    bare.tank.bottom = None;
    assert!(bottom::missing(&case).is_none() && bottom::missing(&bare).is_some());
}

/// A weld depression at the foot that is deeper than the first ring is wide.
#[test]
fn an_imperfect_foot_takes_the_plate_along() {
    let case = oil(205e6);
    let options = options(&case, 32);
    let plan = Plan::new(&case, &options, false).unwrap();
    let shape = Depression { radius: 20.0, amplitude: -0.03, height: 0.1, half_wave: 1.2 };
    assert!(plan.build(Some(&Dent::Weld(shape))).is_ok());
}

/// A tank of 8 m with thin plates of weak steel, small enough to be pushed to its end in seconds.
fn weak() -> Case {
    let mut case = oil(60e6);
    case.tank.shape = Shape::Cylinder { radius: 4.0 };
    let plate = case.tank.courses[0].clone();
    case.tank.courses = vec![tank::Course { height: 4.0, thickness: 5e-3, ..plate }];
    case.liquid.density = 1000.0;
    case.liquid.fill_height = 3.6;
    if let Some(bottom) = &mut case.tank.bottom {
        bottom.thickness = 4e-3;
    }
    case
}

/// A weld depression of half a thickness above the foot of an unanchored tank, pushed over its first states beside the perfect shell. On each of them
/// the ground carries weight and pressure, and its moment is that of the forces on the wall and of the liquid that leans with the base, W H ψ/2, within 2 %
/// for what the wall bends besides. The dent moves the foot at rest by less than half of what it does anyway.
#[test]
fn an_imperfect_tank_is_pushed_off_the_ground() {
    let case = weak();
    let own = NonlinearOptions {
        elements: Some(WallElements { height: 12, circumference: 8 }),
        ..NonlinearOptions::new(case.damping)
    };
    let plan = Plan::new(&case, &own, false).unwrap();
    let dent = Dent::Weld(Depression { radius: 4.0, amplitude: 2.5e-3, height: 0.15, half_wave: 0.34 });
    let weight = case.liquid_mass() * case.gravity;
    let path = |dent: Option<&Dent>| {
        let progress = Until::states(12);
        let mut keeper = Keeper::new(None, &plan);
        let found = path::follow(&plan, dent, "shell", None, &mut keeper, &progress).unwrap();
        let states = found.shell().path;
        let rest = states[0].base.unwrap();
        for state in &states {
            let base = state.base.unwrap();
            assert!((base.reaction / rest.reaction - 1.0).abs() < 1e-3, "{base:?}");
            let lean = weight * 0.5 * case.liquid.fill_height * base.rotation;
            let off = base.moment - state.base_moment - lean;
            assert!(base.rotation < 1e-3 || off.abs() < 0.02 * state.base_moment, "{off} {lean} {state:?}");
        }
        assert!(states.len() > 8 && states[states.len() - 1].base.unwrap().rotation > rest.rotation);
        rest
    };
    let (perfect, dented) = (path(None), path(Some(&dent)));
    assert!((perfect.reaction / dented.reaction - 1.0).abs() < 1e-3);
    assert!((dented.toe / perfect.toe - 1.0).abs() < 0.5 && dented.toe != perfect.toe, "{perfect:?} {dented:?}");
}
