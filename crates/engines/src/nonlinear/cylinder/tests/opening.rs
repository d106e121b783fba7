//! Contact that opens, with the liquid as an operator.

use fem::progress::Silent;
use tank::options::nonlinear::{Contact, NonlinearOptions};
use tank::reference::{case, material};
use tank::{Behaviour, Case, Shape, Steel};

use super::super::march::Cylinder;
use super::super::model::CylinderModel;
use super::{elastic, marched, options, shaken};

/// Half of the circle and all of it, on an elastic wall that the liquid leaves over a part of several levels: the preconditioner with the
/// joints that are open is the matrix but for the stress in the wall, so that a solution takes a few products wherever they are.
/// Goal set before: 15. With their mean over each level it takes one for each of them. Both forms of the liquid
/// meet the same criteria (residuals of 1e-9 of the forces): 1e-5 of the largest value, as for the elastic bonded wall.
#[test]
fn open_joints_take_no_products() {
    for (symmetry, sectors) in [(true, 24), (false, 16)] {
        let case = shaken(elastic(), 25.0, 8);
        let own = NonlinearOptions { contact: Contact::Opening, symmetry, ..options(&case, 8, sectors) };
        let (dense, _) = marched(&case, &own, false);
        let (found, run) = marched(&case, &own, true);
        let each = run.cost.products as f64 / run.cost.iterations as f64;
        for (k, (a, b)) in found.iter().zip(&dense).enumerate() {
            let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-5 * largest, "{k}: {apart} of {largest}");
        }
        assert!(each < 15.0, "{each} products a solution");
    }
}

/// Steel, R = 15 m, H = 12 m, 12 to 8 mm, filled to 11 m, that yields.
fn steel() -> Case {
    let mut steel = material(210e9, 0.3, 7850.0);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength: 235e6,
        tangent_modulus: 2.1e9,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    let courses = [(4.0, 0.012), (4.0, 0.010), (4.0, 0.008)];
    case(Shape::Cylinder { radius: 15.0 }, &courses, &steel, (1000.0, 11.0))
}

/// Processor time of this thread [s].
fn clock() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let first = text.split_whitespace().next().and_then(|t| t.parse::<f64>().ok());
    first.unwrap_or(0.0) * 1e-9
}

/// Times of both forms of the liquid, for the limit between them; the numbers stand in docs/performance.md.
///
/// `SIZES="16x40@1.5 24x60@0.8" cargo test -p engines --lib dense_or_iterated -- --ignored --nocapture`
#[test]
#[ignore = "slow: a measurement, cargo test -p engines --lib dense_or_iterated -- --ignored --nocapture; numbers in docs/performance.md"]
fn dense_or_iterated() {
    let sizes = std::env::var("SIZES").unwrap_or_else(|_| "16x40".into());
    for size in sizes.split_whitespace() {
        // 16x40@1.5: elements, and the amplitude over g.
        let (size, strength) = size.split_once('@').unwrap_or((size, "1.5"));
        let strength: f64 = strength.parse().unwrap();
        let (height, around) = size.split_once('x').unwrap();
        let mut case = steel();
        let mut own = NonlinearOptions {
            contact: Contact::Opening,
            ..options(&case, height.parse().unwrap(), around.parse().unwrap())
        };
        own.time_step = Some(0.005);
        case = shaken(case, 0.0, 41);
        if let Some(motion) = &mut case.ground_motion {
            for (i, a) in motion.horizontal.acceleration.iter_mut().enumerate() {
                *a = strength * case.gravity * (18.85 * 0.01 * i as f64).sin();
            }
        }
        for operator in [false, true] {
            let tank = CylinderModel::in_form(&case, &own, |_| operator).unwrap();
            let wetted = tank.wetted.len();
            let cylinder = Cylinder::of(&case, &own, tank).unwrap();
            let begin = clock();
            let motion = case.ground_motion.as_ref().unwrap();
            let (watch, run) = cylinder.march(motion, 1.0, 1, None, &Silent).unwrap();
            let each = run.cost.products as f64 / run.cost.iterations.max(1) as f64;
            let open = watch.openings.as_ref().map(|o| o.places().len());
            println!(
                "{size}, {strength} g, {wetted} wetted nodes, operator {operator}: {:.2} s, {each:.1} products a solution, {open:?} joints opened, {:?} {:?}",
                clock() - begin,
                run.outcome,
                run.cost
            );
        }
    }
}
