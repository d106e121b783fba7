use nalgebra::UnitQuaternion;

use super::*;
use crate::element::{Inspect, Motion, Trial, Want, reference_mass, reference_stiffness};

/// A distorted brick.
fn corners() -> [[f64; 3]; 8] {
    let bumps = [0.03, -0.05, 0.07, 0.02, -0.04, 0.06, -0.01, 0.05];
    std::array::from_fn(|a| {
        let c = CORNERS[a];
        [0.6 * c[0] + bumps[a], 0.4 * c[1] - 0.7 * bumps[(a + 3) % 8], 0.5 * c[2] + bumps[(a + 5) % 8]]
    })
}

fn brick(material: Elastic, kinematics: Kinematics) -> Solid8 {
    Solid8::new([0, 1, 2, 3, 4, 5, 6, 7], corners(), material, kinematics).unwrap()
}

fn materials() -> [Elastic; 2] {
    [Elastic::isotropic(7.0, 0.3, 2.0), Elastic::normal_only(5.0, 2.0)]
}

/// A smooth displacement, large enough for every nonlinear term to count.
fn displaced() -> [f64; 24] {
    std::array::from_fn(|i| 0.05 * (1.7 * i as f64 + 0.3).sin())
}

fn respond(element: &Solid8, values: &[f64], want: Want) -> Response {
    let mut response = Response::sized(24);
    let rotations = [UnitQuaternion::identity(); 8];
    let motion = Motion { values, rotations: &rotations };
    element.respond(Trial { motion, old: &[], new: &mut [], want }, &mut response).unwrap();
    response
}

/// W = ∫ ½ E : S dV₀.
fn energy(element: &Solid8, values: &[f64]) -> f64 {
    element
        .points()
        .iter()
        .map(|p| {
            let h = displacement_gradient(p, values);
            let strain = voigt(&(0.5 * (h + h.transpose() + h.transpose() * h)));
            let stress = element.material.law.stress(&strain, &p.normal).0;
            0.5 * p.volume * strain.iter().zip(&stress).map(|(e, s)| e * s).sum::<f64>()
        })
        .sum()
}

/// Central differences of the energy; their error is about step² times the third derivative, here 1e-9 of the largest entry of
/// the tangent.
#[test]
fn force_is_the_derivative_of_the_energy() {
    for material in materials() {
        let element = brick(material, Kinematics::GreenLagrange);
        let u = displaced();
        let all = respond(&element, &u, Want::ALL);
        let step = 1e-5;
        let scale = all.tangent.data.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        for j in 0..24 {
            let (mut lower, mut upper) = (u, u);
            lower[j] -= step;
            upper[j] += step;
            let force = (energy(&element, &upper) - energy(&element, &lower)) / (2.0 * step);
            assert!((force - all.force[j]).abs() < 1e-8 * scale, "force {j}");
        }
    }
}

/// The fast path, the isotropic tangent and BᵀDB are three ways to one matrix.
#[test]
fn the_three_stiffness_paths_agree() {
    let element = brick(materials()[0], Kinematics::GreenLagrange);
    let constants = element.material.law.lame().unwrap();
    let u = displaced();
    for values in [[0.0; 24], u] {
        let (mut general, mut isotropic) = (LocalMatrix::zeros(24), LocalMatrix::zeros(24));
        for p in &element.points() {
            let h = displacement_gradient(p, &values);
            let f = Matrix3::identity() + h;
            let strain = 0.5 * (h + h.transpose() + h.transpose() * h);
            let (stress, moduli) = element.material.law.stress(&voigt(&strain), &p.normal);
            add_stiffness(p, &f, &moduli, &stress, &mut general);
            add_isotropic_stiffness(p, &f, constants, &stress, &mut isotropic);
        }
        let engine = respond(&element, &values, Want::TANGENT).tangent;
        for k in 0..576 {
            assert!((general.data[k] - isotropic.data[k]).abs() < 1e-13);
            assert!((general.data[k] - engine.data[k]).abs() < 1e-13);
        }
    }
}

/// Linear kinematics: force = K u, and K is the reference stiffness of the nonlinear element.
#[test]
fn linear_force_is_stiffness_times_displacement() {
    for material in materials() {
        let linear = brick(material, Kinematics::Linear);
        let nonlinear = reference_stiffness(&brick(material, Kinematics::GreenLagrange)).unwrap();
        let u = displaced();
        let all = respond(&linear, &u, Want::ALL);
        for i in 0..24 {
            let product: f64 = (0..24).map(|j| nonlinear.get(i, j) * u[j]).sum();
            assert!((product - all.force[i]).abs() < 1e-13);
            for j in 0..24 {
                assert!((nonlinear.get(i, j) - all.tangent.get(i, j)).abs() < 1e-14);
                assert!((nonlinear.get(i, j) - nonlinear.get(j, i)).abs() < 1e-14);
            }
        }
    }
}

/// Six rigid modes for the isotropic brick; 20 modes without energy for the normal-only one (24 less four fibres).
#[test]
fn number_of_modes_without_energy() {
    for (material, expected) in materials().into_iter().zip([6, 20]) {
        // The count of fibres needs a layer with parallel faces.
        let flat = std::array::from_fn(|a| {
            let [x, y, _] = corners()[a % 4];
            [x, y, if a < 4 { 0.0 } else { 0.3 }]
        });
        let element = Solid8::new([0, 1, 2, 3, 4, 5, 6, 7], flat, material, Kinematics::Linear).unwrap();
        let k = reference_stiffness(&element).unwrap();
        let values = nalgebra::DMatrix::from_column_slice(24, 24, &k.data).symmetric_eigenvalues();
        let zero = values.iter().filter(|v| v.abs() < 1e-12).count();
        assert_eq!(zero, expected);
    }
}

/// A linear displacement field makes the exact uniform stress at every point of a distorted brick.
#[test]
fn samples_pass_the_patch_test() {
    let h = Matrix3::new(1e-3, 2e-3, -1e-3, 0.5e-3, -2e-3, 0.0, 1e-3, 3e-3, 4e-3);
    let element = brick(materials()[0], Kinematics::Linear);
    let u: Vec<f64> = corners().iter().flat_map(|&p| (h * Vector3::from(p)).data.0[0]).collect();
    let exact = element.material.law.stress(&voigt(&(0.5 * (h + h.transpose()))), &Vector3::z()).0;
    let samples = element.samples();
    assert_eq!(samples.len(), 48);
    for (k, sample) in samples.iter().enumerate() {
        let value: f64 = sample.row.iter().zip(&u).map(|(c, u)| c * u).sum();
        assert!((value - exact[k % 6]).abs() < 1e-15, "{}: {value}", sample.name);
    }
    let layer = brick(materials()[1], Kinematics::Linear);
    assert!(layer.samples().iter().all(|s| s.name == "stress_nn") && layer.samples().len() == 8);
}

/// Mass, first moments and weight are those of the volume; the mass is symmetric.
#[test]
fn mass_and_weight() {
    let element = brick(materials()[0], Kinematics::Linear);
    let mass = reference_mass(&element);
    let total: f64 = (0..8).flat_map(|a| (0..8).map(move |b| (a, b))).map(|(a, b)| mass.get(3 * a, 3 * b)).sum();
    assert!((total - 2.0 * element.volume()).abs() < 1e-14);
    let mut weight = vec![0.0; 24];
    element.body_force([0.0, 0.0, -9.81], &mut weight);
    for a in 0..8 {
        let row: f64 = (0..8).map(|b| mass.get(3 * a + 2, 3 * b + 2)).sum();
        assert!((weight[3 * a + 2] + 9.81 * row).abs() < 1e-13);
        assert_eq!(weight[3 * a], 0.0);
    }
    // A box: 1.2 × 0.8 × 1.0.
    let cube = CORNERS.map(|c| [0.6 * c[0], 0.4 * c[1], 0.5 * c[2]]);
    let plain = Solid8::new([0, 1, 2, 3, 4, 5, 6, 7], cube, materials()[0], Kinematics::Linear).unwrap();
    assert!((plain.volume() - 0.96).abs() < 1e-15);
}

#[test]
fn element_rayleigh_damping() {
    let plain = materials()[0];
    let element = brick(plain.with_damping(0.3, 0.02), Kinematics::GreenLagrange);
    let mut c = LocalMatrix::zeros(24);
    assert!(element.damping(&mut c));
    let (m, k) = (reference_mass(&element), reference_stiffness(&element).unwrap());
    for i in 0..576 {
        assert!((c.data[i] - 0.3 * m.data[i] - 0.02 * k.data[i]).abs() < 1e-15);
    }
    assert!(!brick(plain, Kinematics::Linear).damping(&mut c));
}

#[test]
fn bad_bricks_are_rejected() {
    let nodes = [0, 1, 2, 3, 4, 5, 6, 7];
    let mut inside_out = corners();
    inside_out.swap(0, 4);
    inside_out.swap(1, 5);
    inside_out.swap(2, 6);
    inside_out.swap(3, 7);
    let refused = Solid8::new(nodes, inside_out, materials()[0], Kinematics::Linear);
    assert!(matches!(refused, Err(ElementError::Jacobian { determinant, .. }) if determinant < 0.0));
    let bad = Elastic::isotropic(1.0, 0.3, -1.0);
    let refused = Solid8::new(nodes, corners(), bad, Kinematics::Linear);
    assert!(matches!(refused, Err(ElementError::Parameter { parameter: "density", .. })));
}
