//! Shells beside strips with the same rim: free, with a ring, round. Elastic plates and walls.
//!
//! ```text
//! cargo test -p engines --lib rim_study -- --ignored --nocapture
//! ```

use results::PushPoint;
use tank::options::nonlinear::WallElements;
use tank::reference::{case, material};
use tank::{Behaviour, Case, Material, RimSupport, Ring, Shape, Steel};

use super::*;
use crate::harmonic::test_tanks;

/// Largest rotation [rad].
const ROTATION: f64 = 5e-3;

fn steel(young: f64, density: f64) -> Material {
    let mut steel = material(young, 0.3, density);
    steel.yield_strength = Some(young);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength: young,
        tangent_modulus: 0.01 * young,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    steel
}

struct Tank {
    name: &'static str,
    /// R, H [m], density of the liquid [kg/m³].
    size: (f64, f64, f64),
    courses: &'static [(f64, f64)],
    plate: f64,
    /// Second moment [m⁴] and area [m²] of a wind girder on the top edge.
    girder: (f64, f64),
    /// States of the path up to [`ROTATION`].
    states: u64,
}

/// Those of the sheet (uplift.md), and a squat one.
const TANKS: [Tank; 5] = [
    Tank {
        name: "C, example 05",
        size: (20.0, 15.0, 870.0),
        courses: &[(2.4, 0.025), (2.4, 0.021), (2.4, 0.018), (2.4, 0.014), (7.2, 0.01)],
        plate: 0.01,
        girder: (4e-4, 1.2e-2),
        states: 26,
    },
    Tank {
        name: "B, 27.8 m",
        size: (13.9, 15.7, 1000.0),
        courses: &[(2.3, 0.0177), (2.3, 0.0157), (2.3, 0.0137), (2.3, 0.0118), (7.3, 0.009)],
        plate: 0.008,
        girder: (2e-4, 8e-3),
        states: 26,
    },
    Tank {
        name: "D, slender",
        size: (6.1, 11.3, 1000.0),
        courses: &[(4.0, 0.008), (4.0, 0.007), (4.0, 0.006)],
        plate: 6.35e-3,
        girder: (2e-5, 4e-3),
        states: 26,
    },
    Tank {
        name: "09, slender",
        size: (5.0, 11.0, 1000.0),
        courses: &[(2.0, 0.008), (2.0, 0.006), (8.0, 0.005)],
        plate: 0.008,
        girder: (2e-5, 4e-3),
        states: 26,
    },
    Tank {
        name: "squat",
        size: (25.0, 9.0, 1000.0),
        courses: &[(2.5, 0.02), (2.5, 0.016), (5.0, 0.011)],
        plate: 0.01,
        girder: (4e-4, 1.2e-2),
        states: 70,
    },
];

fn tank_of(tank: &Tank, rim: &str) -> Case {
    let steel = steel(205e9, 7850.0);
    let (radius, depth, density) = tank.size;
    let mut case = case(Shape::Cylinder { radius }, tank.courses, &steel, (density, depth));
    test_tanks::on_ground(&mut case, tank.plate, steel.clone(), 1e8);
    match rim {
        "round" => case.tank.roof.holds = RimSupport::Round,
        "ring" => case.tank.rings.push(Ring {
            height: case.tank.wall_height(),
            area: tank.girder.1,
            inertia: tank.girder.0,
            material: steel,
        }),
        _ => {}
    }
    case
}

/// Rows: ψ; of shells, strips with the same rim, plane strips: M [MNm], uplift [mm], toe stress [MPa], lifted width [m]. `TANKCHECK_STUDY` runs the
/// cases whose name contains it.
#[test]
#[ignore = "slow: a study, cargo test -p engines --lib rim_study -- --ignored --nocapture; last result in docs/theory/base.md"]
fn strips_and_shells_with_the_same_rim() {
    let chosen = std::env::var("TANKCHECK_STUDY").unwrap_or_default();
    for tank in &TANKS {
        for rim in ["free", "ring", "round"] {
            let name = format!("{}, {rim}", tank.name);
            if !name.contains(&chosen) {
                continue;
            }
            let case = tank_of(tank, rim);
            let options = NonlinearOptions {
                elements: Some(WallElements { height: 24, circumference: 48 }),
                ..NonlinearOptions::new(case.damping)
            };
            let plan = Plan::new(&case, &options, false).unwrap();
            let progress = super::uplift_tests::Until::states(tank.states);
            let found = path::follow(&plan, None, "perfect shell", None, &mut Keeper::new(None, &plan), &progress);
            let shell = found.unwrap().shell();
            let plate = plan.plate.as_ref().unwrap();
            let warping = ::base::Warping::of(&case).unwrap();
            let most = shell.path.iter().filter_map(|p| p.base).map(|b| b.uplift).fold(0.0, f64::max);
            let rocking = plate.base.rocking(-0.06, 0.05 + 3.0 * most, true).unwrap();
            let plane = rocking.clone().warping(None);
            println!(
                "{name}: K_2, K_3, K_4 = {:.1?} kPa",
                warping.stiffness()[..3].iter().map(|k| 1e-3 * k).collect::<Vec<f64>>()
            );
            let row = |p: &PushPoint| {
                let b = p.base.filter(|b| b.rotation > 2e-4 && b.rotation < 1.2 * ROTATION)?;
                let suction = plate.suction() * p.acceleration;
                let plane = plane.at(b.rotation, suction).ok()?;
                let warped = rocking.at(b.rotation, suction);
                let wall = plate.base.wall_thickness();
                let of = |t: &::base::Turn| {
                    let width = rocking.curve().at(t.uplift).lifted_width;
                    [1e-6 * t.moment, 1e3 * t.uplift, 1e-6 * t.toe_force / wall, width, t.lifted_angle]
                };
                println!(
                    "  ψ {:.2e}  a {:.3} g\n    shells {:8.3?}\n    strips {:8.3?}  {:.2?}\n    plane  {:8.3?}",
                    b.rotation,
                    p.acceleration / 9.81,
                    [1e-6 * b.moment, 1e3 * b.uplift, 1e-6 * b.toe_reaction, b.lifted_width, 0.5 * b.lifted_angle],
                    warped.as_ref().map(of).unwrap_or([f64::NAN; 5]),
                    warped
                        .as_ref()
                        .map(|t| t.waves[..5].iter().map(|x| 1e3 * x).collect::<Vec<f64>>())
                        .unwrap_or_default(),
                    of(&plane),
                );
                Some(())
            };
            let count = shell.path.iter().filter_map(row).count();
            if let Some(foot) = shell.feet.last() {
                let width = std::f64::consts::PI / (foot.w.len() - 1) as f64;
                let wave = |n: usize| {
                    let at = |i: usize| foot.w[i] * (n as f64 * (std::f64::consts::PI - foot.theta[i])).cos();
                    let sum: f64 = (1..foot.w.len()).map(|i| 0.5 * (at(i) + at(i - 1))).sum();
                    1e3 * sum * width * 2.0 / std::f64::consts::PI
                };
                println!("  U of shells, last state: {:.2?}", (2..13).map(wave).collect::<Vec<f64>>());
            }
            println!(
                "  {count} of {} states, {}",
                shell.path.len(),
                shell.path.last().map_or(f64::NAN, |p| p.base.map_or(f64::NAN, |b| b.rotation))
            );
        }
    }
}
