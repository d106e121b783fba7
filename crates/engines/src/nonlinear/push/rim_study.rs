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
    if let Some(foundation) = &mut case.tank.foundation {
        foundation.friction = Some(tank::FRICTION);
    }
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

/// Rotations at which strips and shells are compared [rad].
const ROTATIONS: [f64; 5] = [1e-3, 2e-3, 3e-3, 4e-3, 5e-3];

/// Rows of deviations of strips and of plane strips from shells in %, from the smallest to the largest over the rotations: M, uplift, toe, lifted width,
/// lifted angle; and the states. `TANKCHECK_STUDY` runs the cases whose name contains it.
#[test]
#[ignore = "slow: a study, cargo test -p engines --lib rim_study -- --ignored --nocapture; last result in docs/theory/base.md"]
fn strips_and_shells_with_the_same_rim() {
    let chosen = std::env::var("TANKCHECK_STUDY").unwrap_or_default();
    for tank in &TANKS {
        for rim in ["free", "ring", "round"] {
            let name = format!("{}, {rim}", tank.name);
            if chosen.split(';').any(|part| name.contains(part)) {
                compare(tank, rim, &name);
            }
        }
    }
}

fn compare(tank: &Tank, rim: &str, name: &str) {
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
    let most = shell.path.iter().filter_map(|p| p.base).map(|b| b.uplift).fold(0.0, f64::max);
    let rocking = plate.base.rocking(-0.06, 0.05 + 3.0 * most, true).unwrap();
    let flat = rocking.clone().warping(None);
    let wall = plate.base.wall_thickness();
    println!("{name}");
    let mut off: Vec<[[f64; 5]; 2]> = Vec::new();
    let row = |p: &PushPoint| {
        let b = p.base.filter(|b| b.rotation > 2e-4 && b.rotation < 1.2 * ROTATION)?;
        let suction = plate.suction() * p.acceleration;
        let of = |t: &::base::Turn| {
            let width = rocking.lifted_width(t.uplift, 1.0, suction);
            [1e-6 * t.moment, 1e3 * t.uplift, 1e-6 * t.toe_force / wall, width, 2.0 * t.lifted_angle(plate.base.radius)]
        };
        let warped = rocking.at(b.rotation, suction);
        let [strips, plane] = [&rocking, &flat].map(|r| r.at(b.rotation, suction).map_or([f64::NAN; 5], |t| of(&t)));
        let shells = [1e-6 * b.moment, 1e3 * b.uplift, 1e-6 * b.toe_reaction, b.lifted_width, b.lifted_angle];
        println!(
            "  ψ {:.2e}  a {:.3} g  p_b/p {:.2}\n    shells {shells:8.3?}\n    strips {strips:8.3?}  {:.2?}\n    plane  {plane:8.3?}",
            b.rotation,
            p.acceleration / 9.81,
            suction / plate.base.pressure,
            warped.map_or_else(|_| Vec::new(), |t| t.waves[..5].iter().map(|x| 1e3 * x).collect::<Vec<f64>>()),
        );
        Some((b.rotation, [strips, plane].map(|own| std::array::from_fn(|i| 100.0 * (own[i] / shells[i] - 1.0)))))
    };
    let rows: Vec<(f64, [[f64; 5]; 2])> = shell.path.iter().filter_map(row).collect();
    // Straight between the states.
    for psi in ROTATIONS {
        if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 <= psi && psi <= pair[1].0) {
            let t = (psi - pair[0].0) / (pair[1].0 - pair[0].0);
            let mix = |k: usize, i: usize| pair[0].1[k][i] + t * (pair[1].1[k][i] - pair[0].1[k][i]);
            off.push([0, 1].map(|k| std::array::from_fn(|i| mix(k, i))));
        }
    }
    for (k, what) in ["strips", "plane "].into_iter().enumerate() {
        let range = |i: usize| {
            let all = || off.iter().map(|o| o[k][i]).filter(|o| o.is_finite());
            format!("{:.1} … {:.1}", all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
        };
        println!("  {what}: {} rotations | {}", off.len(), (0..5).map(range).collect::<Vec<String>>().join(" | "));
    }
    if let Some(foot) = shell.feet.last() {
        let width = std::f64::consts::PI / (foot.w.len() - 1) as f64;
        let wave = |n: usize| {
            let at = |i: usize| foot.w[i] * (n as f64 * (std::f64::consts::PI - foot.theta[i])).cos();
            let sum: f64 = (1..foot.w.len()).map(|i| 0.5 * (at(i) + at(i - 1))).sum();
            1e3 * sum * width * 2.0 / std::f64::consts::PI
        };
        println!("  U of shells, last state: {:.2?}", (2..13).map(wave).collect::<Vec<f64>>());
    }
}
