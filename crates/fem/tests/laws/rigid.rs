//! Rigid motions leave no force.

use fem::dofs::KINDS;
use fem::element::reference_stiffness;
use nalgebra::Vector3;

use crate::motion::{Moved, turned_vector};
use crate::registry::all;
use crate::specimen::{Rotations, answer, largest, times, virgin};

/// Translations along x, y, z and rotations about them.
pub(crate) const MODES: [&str; 6] = ["u_x", "u_y", "u_z", "r_x", "r_y", "r_z"];

/// Field of rigid motion `mode` in linear theory; potential, elevation and amplitudes rest.
pub(crate) fn mode(mode: usize, x: [f64; 3]) -> [f64; KINDS] {
    let mut out = [0.0; KINDS];
    out[mode] = 1.0;
    if mode >= 3 {
        let mut axis = Vector3::zeros();
        axis[mode - 3] = 1.0;
        out[..3].copy_from_slice(axis.cross(&Vector3::from(x)).as_slice());
    }
    out
}

/// Forces K u at rest. Products of entries K with positions of a metre or two cancel to 10⁻¹³ of K or so; what resists does so
/// with at least 10⁻⁶ of K.
#[test]
fn rigid_motions_of_linear_theory_leave_no_force() {
    for specimen in all() {
        let element = specimen.element();
        let stiffness = reference_stiffness(&*element).unwrap();
        let scale = largest(&stiffness.data);
        for (m, name) in MODES.into_iter().enumerate() {
            let force = largest(&times(&stiffness, &specimen.row(|x| mode(m, x))));
            let (resisted, why) = specimen.resists;
            match resisted.contains(&m) {
                true => assert!(force > 1e-6 * scale, "{specimen}: {name} meets no force in spite of: {why}"),
                false => assert!(force <= 1e-12 * scale, "{specimen}: {name} meets {force:e} of {scale:e}"),
            }
        }
    }
}

/// The force at rest is zero, unless the element is a load.
#[test]
fn rest_has_no_force() {
    for specimen in all() {
        let element = specimen.element();
        let force = answer(&*element, &Moved::rest(&specimen), &virgin(&*element)).force;
        match specimen.load {
            Some(why) => assert!(largest(&force) > 0.0, "{specimen}: no force in spite of: {why}"),
            None => assert_eq!(largest(&force), 0.0, "{specimen}"),
        }
    }
}

/// A finite rotation and a translation carry the forces of a deformed element along, and cause none in an undeformed one.
/// Strains of 10⁻² or more are differences of positions: 10⁻¹¹ of K u is left.
#[test]
fn finite_rotations_carry_the_forces_along() {
    let shift = Vector3::new(0.3, -0.2, 0.7);
    for specimen in all() {
        let Some(turn) = specimen.turns.turn() else { continue };
        let element = specimen.element();
        let history = virgin(&*element);
        let stiffness = largest(&reference_stiffness(&*element).unwrap().data);
        for moved in [Moved::rest(&specimen), Moved::scattered(&specimen, 0, 1.0)] {
            let before = answer(&*element, &moved, &history).force;
            let carried = moved.carried(&specimen, &turn, shift);
            let after = answer(&*element, &carried, &history).force;
            let expected = turned_vector(&specimen, &turn, &before);
            let error = expected.iter().zip(&after).map(|(e, f)| (e - f).abs()).fold(0.0, f64::max);
            let scale = stiffness.max(largest(&before));
            match specimen.rotations {
                Rotations::Finite => assert!(error <= 1e-11 * scale, "{specimen}: {error:e} of {scale:e}"),
                Rotations::Small(why) => {
                    // Potentials do not turn.
                    let turns = largest(&before) > 0.0 && carried.values != moved.values;
                    assert!(!turns || error > 1e-6 * scale, "{specimen}: finite rotations in spite of: {why}");
                }
            }
        }
    }
}
