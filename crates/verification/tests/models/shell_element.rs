//! Laws of the shell element: tangent, rigid motion, zero energies.

use std::sync::Arc;

use fem::element::shell::section::ElasticSection;
use fem::element::shell4::{MembraneShear, SIZE, Shell4, rigid_motion};
use fem::element::{Element, Motion, Response, Trial, Want};
use nalgebra::{UnitQuaternion, Vector3};

fn warped(membrane: MembraneShear, drilling: bool) -> (Shell4, [[f64; 3]; 4]) {
    let x = [[0.0, 0.0, 0.1], [1.2, 0.1, -0.1], [1.0, 0.9, 0.2], [-0.1, 1.1, -0.05]];
    let d =
        [[0.1, 0.05, 1.0], [-0.1, 0.1, 1.0], [0.0, -0.2, 1.0], [0.2, 0.1, 1.0]].map(|v| Vector3::from(v).normalize());
    let section = ElasticSection::new(1000.0, 0.3, 0.2, 1.0).unwrap().eccentric(0.07).unwrap();
    let shell = Shell4::new([0, 1, 2, 3], x, d, Arc::new(section)).unwrap().with_membrane_shear(membrane);
    (shell.with_drilling([drilling; 4], 0.1).unwrap(), x)
}

fn respond(shell: &Shell4, u: &[f64; SIZE], r: &[UnitQuaternion<f64>; 4]) -> Response {
    let mut out = Response::sized(SIZE);
    let motion = Motion { values: u, rotations: r };
    shell.respond(Trial { motion, old: &[], new: &mut [], want: Want::ALL }, &mut out).unwrap();
    out
}

/// Reproducible numbers in [−1, 1].
fn noise(k: usize) -> f64 {
    ((k as f64 * 12.9898 + 4.1414).sin() * 43758.5453).fract()
}

#[test]
fn tangent_is_the_derivative_of_the_force_at_warped_and_rotated_states() {
    for membrane in [MembraneShear::CentrePoint, MembraneShear::Full] {
        for drilling in [false, true] {
            let (shell, x) = warped(membrane, drilling);
            let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.7, -1.9, 1.1));
            let (mut u, mut r) = rigid_motion(&x, turn, [0.3, 0.2, 0.1]);
            for a in 0..4 {
                (0..3).for_each(|i| u[6 * a + i] += 0.2 * noise(3 * a + i));
                let own = Vector3::new(noise(40 + a), noise(50 + a), noise(60 + a)) * 0.4;
                r[a] = UnitQuaternion::from_scaled_axis(own) * r[a];
            }
            let at = respond(&shell, &u, &r);
            let h = 1e-5;
            let mut difference = vec![[0.0; SIZE]; SIZE];
            for j in 0..SIZE {
                let mut forces = Vec::new();
                for sign in [-1.0, 1.0] {
                    let (mut u, mut r) = (u, r);
                    if j % 6 < 3 {
                        u[j] += sign * h;
                    } else {
                        let mut spin = Vector3::zeros();
                        spin[j % 6 - 3] = sign * h;
                        r[j / 6] = UnitQuaternion::from_scaled_axis(spin) * r[j / 6];
                    }
                    forces.push(respond(&shell, &u, &r).force);
                }
                for i in 0..SIZE {
                    difference[i][j] = (forces[1][i] - forces[0][i]) / (2.0 * h);
                }
            }
            let scale = at.tangent.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for i in 0..SIZE {
                for j in 0..SIZE {
                    // Along exp(θ) the second derivative of the energy is the symmetric part of the force's derivative.
                    let expected = 0.5 * (difference[i][j] + difference[j][i]);
                    let error = (at.tangent.get(i, j) - expected).abs() / scale;
                    assert!(error < 1e-8, "{membrane:?} {drilling} ({i}, {j}): {error:.1e}");
                }
            }
        }
    }
}

#[test]
fn rigid_rotations_of_any_size_give_no_force() {
    for angle in [1e-8, 0.1, 1.5, 3.0] {
        let (shell, x) = warped(MembraneShear::CentrePoint, true);
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.48, -0.6, 0.64) * angle);
        let (u, r) = rigid_motion(&x, turn, [0.3, 0.2, 0.1]);
        let worst = respond(&shell, &u, &r).force.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        assert!(worst < 1e-12 * 1000.0, "{angle}: {worst:.1e}");
    }
}
