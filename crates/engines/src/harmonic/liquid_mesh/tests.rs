use super::*;
use crate::Options;
use crate::coupled::Coupled;
use crate::harmonic::build;
use crate::harmonic::test_tanks::case;
use crate::modes::{Kind, solve};
use oscillator::record::Record;
use results::channel::OnWall;
use tank::case::GroundMotion;

const STEEL: (f64, f64, f64) = (210e9, 0.3, 7850.0);

/// A record of one frequency [Hz], 10 s.
fn shaken(mut case: Case, frequency: f64) -> Case {
    let dt = 0.1 / frequency;
    let value = |i: u32| (TAU * frequency * dt * f64::from(i)).sin();
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "sine".into(),
            dt,
            acceleration: (0..(10.0 / dt) as u32).map(value).collect(),
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    case
}

fn cylinder(radius: f64, courses: &[(f64, f64)], depth: f64) -> Case {
    case(Shape::Cylinder { radius }, courses, STEEL, (1000.0, depth))
}

/// Structural modes of horizontal motion: ω and γ p(z) on the wall.
fn modes(case: &Case, refine: f64) -> (Vec<f64>, Vec<(f64, Vec<f64>)>) {
    let options = Options { refine, ..Options::default() };
    let coupled: Coupled = build(case, &options, 1).unwrap();
    let line = coupled.line(OnWall::Pressure).unwrap();
    let modes = solve(&coupled, Some(coupled.surface.unknowns.len() + 6)).unwrap();
    let structural = modes.iter().filter(|m| m.kind == Kind::Structural);
    let pressures = structural.map(|mode| {
        let at =
            |p: &crate::probe::Probe| fem::linalg::dot(&p.absolute_acceleration, &mode.vector) * mode.participation;
        (mode.omega, line.probes.iter().map(at).collect())
    });
    (line.z.clone(), pressures.take(3).collect())
}

/// Relative distance of pressures in the mean square over the depth, at the places of the coarser mesh.
fn distance(coarse: (&[f64], &[f64]), fine: (&[f64], &[f64])) -> f64 {
    let at = |z: f64| {
        let k = fine.0.windows(2).position(|w| z <= w[1] + 1e-9 && w[1] > w[0]).unwrap();
        let share = ((z - fine.0[k]) / (fine.0[k + 1] - fine.0[k])).max(0.0);
        fine.1[k] + share * (fine.1[k + 1] - fine.1[k])
    };
    let z = coarse.0;
    let (mut error, mut whole) = (0.0, 0.0);
    for i in 0..z.len() {
        let weight = z[(i + 1).min(z.len() - 1)] - z[i.saturating_sub(1)];
        error += weight * (coarse.1[i] - at(z[i])).powi(2);
        whole += weight * at(z[i]).powi(2);
    }
    (error / whole).sqrt()
}

/// The modes that a record reaches on its mesh and on one with elements half as long: frequencies within 0.3 %, as asked for, and
/// pressures within the same on the broad tanks, where the default mesh is 0.4 to 2.7 % and 2 to 6 % off in mode 3. The pressures are
/// values at points of quadratic elements that meet the logarithm at the contact line: 0.6 % of the mean square is asked for.
#[test]
fn the_record_resolves_three_modes() {
    let courses = [0.025, 0.021, 0.018, 0.014, 0.011, 0.008, 0.008].map(|t| (2.4, t));
    for (name, tank, content) in [
        ("H/R 0.3", cylinder(10.0, &[(3.0, 0.01)], 3.0), 45.0),
        ("H/R 0.5", cylinder(10.0, &[(5.0, 0.01)], 5.0), 30.0),
        ("oil", cylinder(20.0, &courses, 15.0), 14.5),
        ("broad", cylinder(40.0, &[(8.0, 0.03), (8.0, 0.015)], 15.0), 10.0),
    ] {
        let tank = shaken(tank, content);
        let ((z, run), (fine_z, fine)) = (modes(&tank, 1.0), modes(&tank, 2.0));
        for (n, (own, finer)) in run.iter().zip(&fine).enumerate() {
            assert!(own.0 < TAU * content, "{name}: mode {} is beyond the content", n + 1);
            assert!((own.0 / finer.0 - 1.0).abs() < 0.003, "{name} {}: {} {}", n + 1, own.0, finer.0);
            let error = distance((&z, &own.1), (&fine_z, &finer.1));
            assert!(error < 0.006, "{name} {}: pressure {error}", n + 1);
        }
    }
}

/// ω(k_n) of the uniform wall against the coupled modes (harmonic engine): 7.7 %, what the margin of 25 % leaves beside the 16 % of walls
/// with courses.
#[test]
fn waves_of_the_wall_are_its_modes() {
    for (radius, depth) in [(10.0, 5.0), (10.0, 7.0), (10.0, 3.0)] {
        let tank = cylinder(radius, &[(depth, 0.01)], depth);
        let (_, found) = modes(&shaken(tank.clone(), 45.0), 1.0);
        for (n, mode) in found.iter().enumerate() {
            let k = (n as f64 + 0.5) * PI / depth;
            let ratio = wall_frequency(&tank, k) / mode.0;
            assert!((ratio - 1.0).abs() < 0.077, "H = {depth}, mode {}: {ratio}", n + 1);
            assert!((wave_number(&tank, wall_frequency(&tank, k), 10.0) / k - 1.0).abs() < 1e-9);
        }
    }
}

/// Without ground motion and site, and under a slow record, the mesh is the default one; the estimate counts the elements there are.
#[test]
fn counts() {
    let tank = cylinder(10.0, &[(5.0, 0.01)], 5.0);
    let default = |refine| LiquidMesh::graded(10.0, 5.0, refine);
    for refine in [0.5, 1.0, 2.0] {
        assert_eq!(mesh(&tank, refine), default(refine));
        assert_eq!(mesh(&shaken(tank.clone(), 1.0), refine), default(refine));
        for content in [1.0, 20.0, 60.0] {
            let shaken = shaken(tank.clone(), content);
            let found = mesh(&shaken, refine).elements();
            assert_eq!([found.0 as f64, found.1 as f64], elements(&shaken, refine), "{content} Hz");
        }
    }
    assert_eq!(label(&tank), None);
    assert!(label(&shaken(tank.clone(), 1.0)).unwrap().text.starts_with("the default"));
    let fast = mesh(&shaken(tank, 60.0), 1.0);
    assert_eq!((fast.r[0], *fast.r.last().unwrap(), *fast.z.last().unwrap()), (0.0, 10.0, 5.0));
    assert!(fast.r.windows(2).chain(fast.z.windows(2)).all(|w| w[1] > w[0]));
    let outermost = 10.0 - fast.r[fast.r.len() - 3];
    assert!(outermost <= 0.8 * 5.0 / (2.5 * PI), "{outermost}");
}
