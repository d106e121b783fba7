//! Loads, mass, eccentric sections and recovery of the shell.

use std::sync::Arc;

use fem::assembly::{Assembler, local_values};
use fem::dofs::Dof;
use fem::element::shell::load::{FollowerPressure, NodalLoads};
use fem::element::shell::recovery::nodal_resultants;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{ShellCell, ShellSurface};
use fem::element::shell4::{Axes, MassKind, RESULTANTS, Shell4};
use fem::element::{Element, Inspect, reference_mass};
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::model::{Builder, Model};
use nalgebra::Vector3;

const QUAD: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.2, 0.1, 0.0], [1.0, 0.9, 0.0], [-0.1, 1.1, 0.0]];

/// Exact area of the plane quadrilateral: half the cross product of its diagonals.
fn area() -> f64 {
    let d = |a: usize, b: usize| Vector3::from(QUAD[b]) - Vector3::from(QUAD[a]);
    0.5 * d(0, 2).cross(&d(1, 3)).norm()
}

fn shell(section: ElasticSection, mass: MassKind) -> Shell4 {
    let shell = Shell4::new([0, 1, 2, 3], QUAD, [Vector3::z(); 4], Arc::new(section)).unwrap();
    shell.with_mass(mass)
}

/// Kinetic energies of rigid motions: translation, and a turn about the x axis through the origin, whose inertia is
/// ∫ ρ (y² + ζ²) dV. The lumped matrix keeps the translation and the rotary part.
#[test]
fn mass_of_rigid_motions() {
    let (t, rho, e) = (0.2, 7.0, 0.05);
    let section = || ElasticSection::new(1.0, 0.3, t, rho).unwrap().eccentric(e).unwrap();
    let energy = |kind: MassKind, v: &[f64]| {
        let m = reference_mass(&shell(section(), kind)).to_matrix();
        m.times(v).iter().zip(v).map(|(a, b)| a * b).sum::<f64>()
    };
    let slide: Vec<f64> = (0..24).map(|i| if i % 6 == 1 { 1.0 } else { 0.0 }).collect();
    let turn: Vec<f64> = (0..24)
        .map(|i| match i % 6 {
            2 => QUAD[i / 6][1],
            3 => 1.0,
            _ => 0.0,
        })
        .collect();
    for kind in [MassKind::Consistent, MassKind::Lumped] {
        assert!((energy(kind, &slide) / (rho * t * area()) - 1.0).abs() < 1e-12);
    }
    // ∫ y² dA by 200 × 200 mid-points of the bilinear map, good to 1e-4.
    let n = 200;
    let mut second = 0.0;
    for i in 0..n {
        for j in 0..n {
            let (r, s) =
                ((2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0, (2.0 * f64::from(j) + 1.0) / f64::from(n) - 1.0);
            let shape = fem::shape::quad4::value(r, s);
            let slope = fem::shape::quad4::slope(r, s);
            let sum = |f: &dyn Fn(usize) -> f64| (0..4).map(f).sum::<f64>();
            let y = sum(&|a| shape[a] * QUAD[a][1]);
            let jacobian = sum(&|a| slope[a][0] * QUAD[a][0]) * sum(&|a| slope[a][1] * QUAD[a][1])
                - sum(&|a| slope[a][0] * QUAD[a][1]) * sum(&|a| slope[a][1] * QUAD[a][0]);
            second += y * y * jacobian * 4.0 / f64::from(n * n);
        }
    }
    let expected = rho * (t * second + (t * t * t / 12.0 + e * e * t) * area());
    assert!((energy(MassKind::Consistent, &turn) / expected - 1.0).abs() < 1e-4);
}

/// Gravity on an eccentric section: force ρ t A g, moment about the reference surface ρ t e A g.
#[test]
fn weight_of_an_eccentric_section() {
    let (t, rho, e) = (0.2, 7.0, 0.05);
    let section = ElasticSection::new(1.0, 0.3, t, rho).unwrap().eccentric(e).unwrap();
    let mut out = [0.0; 24];
    shell(section, MassKind::Consistent).body_force([3.0, 0.0, -10.0], &mut out);
    let sum = |i: usize| (0..4).map(|a| out[6 * a + i]).sum::<f64>();
    let mass = rho * t * area();
    for (i, expected) in [3.0 * mass, 0.0, -10.0 * mass, 0.0, 3.0 * mass * e, 0.0].into_iter().enumerate() {
        assert!((sum(i) - expected).abs() < 1e-12, "{i}");
    }
}

/// S20: tangent of the follower pressure is the derivative of its force at a deformed face, and the forces of a closed
/// box under uniform pressure vanish in sum, deformed or not.
#[test]
fn follower_pressure() {
    let load = FollowerPressure::new([0, 1, 2, 3], [[0.0, 0.0, 0.1], QUAD[1], QUAD[2], QUAD[3]], 5.0);
    let u: Vec<f64> = (0..12).map(|k| 0.3 * (1.0 + 2.7 * f64::from(k)).sin()).collect();
    let (_, tangent) = load.force_and_tangent(&u);
    let h = 1e-5;
    for j in 0..12 {
        let at = |sign: f64| {
            let mut u = u.clone();
            u[j] += sign * h;
            load.force_and_tangent(&u).0
        };
        let (lower, upper) = (at(-1.0), at(1.0));
        for i in 0..12 {
            let difference = (upper[i] - lower[i]) / (2.0 * h);
            // The force is quadratic: central differences are exact up to rounding, 1e-16/1e-5.
            assert!((tangent[i][j] - difference).abs() < 1e-9, "({i}, {j})");
        }
    }
    let corner = |k: usize| [f64::from(k as u8 & 1), f64::from((k as u8 >> 1) & 1), f64::from((k as u8 >> 2) & 1)];
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    for amplitude in [0.0, 0.2] {
        let mut sum = Vector3::zeros();
        for face in faces {
            let u: Vec<f64> =
                face.iter().flat_map(|&n| (0..3).map(move |i| amplitude * (1.3 * (3 * n + i) as f64).sin())).collect();
            let (force, _) = FollowerPressure::new(face, face.map(corner), 2.0).force_and_tangent(&u);
            (0..4).for_each(|a| sum += Vector3::new(force[3 * a], force[3 * a + 1], force[3 * a + 2]));
        }
        assert!(sum.norm() < 1e-13, "{sum}");
    }
}

/// Resultant of p = γ (H − z) on a vertical 2 m × 3 m wall: γ (H − 1.5) per area, centre of pressure by statics.
#[test]
fn hydrostatic_pressure_has_the_resultant_of_statics() {
    let positions = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 2.0, 3.0], [0.0, 0.0, 3.0]];
    let (gamma, height) = (9.81, 3.0);
    let mut loads = NodalLoads::new();
    loads.pressure(&[0, 1, 2, 3], &positions, |x| gamma * (height - x[2]));
    let total = gamma * 0.5 * height * height * 2.0;
    assert!((loads.resultant()[0] - total).abs() < 1e-12 * total);
    let lever: f64 = (0..4).map(|n| loads.at(n)[0] * positions[n][2]).sum::<f64>() / total;
    assert!((lever - height / 3.0).abs() < 1e-12);
}

/// A cantilever strip of 4 × 1 elements along x under a load at its end; `eccentricity` of the section, the reference
/// surface at z = −e so that the material is the same.
fn strip(eccentricity: f64) -> (Model, Vec<f64>, Vec<usize>) {
    let section: Arc<dyn Section> =
        Arc::new(ElasticSection::new(1e6, 0.0, 0.1, 1.0).unwrap().eccentric(eccentricity).unwrap());
    let mut builder = Builder::new();
    for y in [0.0, 0.5] {
        for k in 0..5 {
            builder.node([0.5 * f64::from(k), y, -eccentricity]);
        }
    }
    let cells = (0..4).map(|k| ShellCell {
        nodes: [k, k + 1, k + 6, k + 5],
        section: section.clone(),
        group: "strip".to_owned(),
    });
    let mut surface = ShellSurface::new(cells.collect());
    surface.axes = Axes::Along([1.0, 0.0, 0.0]);
    let placed = surface.place(&mut builder).unwrap();
    for node in [0, 5] {
        Dof::SHELL.iter().for_each(|&d| builder.hold(node, d));
    }
    let mut loads = NodalLoads::new();
    for node in [4, 9] {
        // Force through the middle surface: on the reference surface it comes with a moment.
        loads.force(node, [0.5, 0.0, 1.0]);
        loads.moment(node, [0.0, 0.5 * eccentricity, 0.0]);
    }
    let model = builder.build().unwrap();
    let assembler = Assembler::new(&model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let factor = symbolic.factor(&assembler.stiffness(&model).unwrap(), Kind::Definite).unwrap();
    let u = factor.solve_vector(&loads.vector(&model)).unwrap();
    (model, u, placed.elements)
}

/// The same plate, described from another surface: same deflection; N of the section, M about its own middle.
#[test]
fn the_reference_surface_does_not_matter() {
    let (centred, u, _) = strip(0.0);
    let (eccentric, v, _) = strip(0.04);
    for node in 0..10 {
        let (a, b) = (centred.at_node(&u, node), eccentric.at_node(&v, node));
        assert!((a[2] - b[2]).abs() < 1e-9 * u.iter().fold(0.0_f64, |m, x| m.max(x.abs())));
        // The middle surface lies 0.04 above: u_middle = u + θ_y e.
        assert!((a[0] - (b[0] + 0.04 * b[4])).abs() < 1e-9);
    }
}

/// Moments of a cantilever under an end load are linear; elements hold their mean. Nodal values are the mean of the
/// neighbours inside, where that is exact.
#[test]
fn nodal_moments_of_a_cantilever() {
    let (model, u, elements) = strip(0.0);
    let nodal = nodal_resultants(&model, &elements, &u);
    let m_11 = RESULTANTS.iter().position(|n| *n == "m_11").unwrap();
    for k in 1..4 {
        // Force 2 over the breadth 0.5; w upwards bends the strip with m = −D w'' negative.
        let expected = -2.0 / 0.5 * (2.0 - 0.5 * k as f64);
        assert!((nodal[&k][m_11] - expected).abs() < 1e-9, "{k}: {} {expected}", nodal[&k][m_11]);
        assert!((nodal[&k][0] - 1.0 / 0.5).abs() < 1e-9);
    }
    // The reaction at the clamp is exact where the element's mean is not.
    let forces = Assembler::new(&model).nodal_forces(&model, &u, |_| true).unwrap();
    assert!((forces[0][4] + forces[5][4] - 4.0).abs() < 1e-9, "{}", forces[0][4] + forces[5][4]);
    assert!((forces[0][2] + forces[5][2] + 2.0).abs() < 1e-9);
}

/// Resultants in a turned frame are the tensor's components there: their invariants stay.
#[test]
fn resultants_turn_as_tensors() {
    let values: Vec<f64> = (0..24).map(|k| (0.7 * f64::from(k)).sin()).collect();
    let sampled = |axes: Axes| -> Vec<f64> {
        let section = ElasticSection::new(10.0, 0.3, 0.2, 1.0).unwrap();
        let shell = shell(section, MassKind::Consistent).with_axes(axes);
        let samples = shell.samples();
        assert_eq!(samples.len(), 40);
        samples.iter().map(|s| s.row.iter().zip(&values).map(|(a, b)| a * b).sum()).collect()
    };
    let (own, turned) = (sampled(Axes::Element), sampled(Axes::Along([0.3, 1.0, 0.0])));
    let hoop = sampled(Axes::Hoop { origin: [0.4, -1.0, 0.0], axis: [0.0, 0.0, 1.0] });
    for other in [turned, hoop] {
        for p in 0..5 {
            for k in [8 * p, 8 * p + 3] {
                let invariants = |v: &[f64]| [v[k] + v[k + 1], v[k] * v[k + 1] - v[k + 2] * v[k + 2]];
                for (a, b) in invariants(&own).into_iter().zip(invariants(&other)) {
                    assert!((a - b).abs() < 1e-12);
                }
            }
            let q = 8 * p + 6;
            assert!((own[q].hypot(own[q + 1]) - other[q].hypot(other[q + 1])).abs() < 1e-12);
        }
    }
}

/// Reactions are the forces of the linear solution on the supports: K u over all nodes sums to zero with the load.
#[test]
fn nodal_forces_are_in_equilibrium() {
    let (model, u, elements) = strip(0.04);
    let forces = Assembler::new(&model).nodal_forces(&model, &u, |_| true).unwrap();
    let sum = |i: usize| forces.iter().map(|f| f[i]).sum::<f64>();
    assert!(sum(0).abs() < 1e-9 && sum(2).abs() < 1e-9);
    assert_eq!(local_values(&model, &*model.elements()[elements[0]], &u).len(), 24);
}
