//! Results do not depend on the axes in which an element is described.

use fem::element::{Element, LocalMatrix, reference_mass};
use nalgebra::{UnitQuaternion, Vector3};

use crate::motion::{Moved, turned_vector};
use crate::registry::all;
use crate::specimen::{Specimen, Turns, answer, largest, times, virgin};

/// Force, tangent, mass, damping, weight and geometric stiffness of an element built in turned axes, against the turned ones of
/// the element as its entry builds it. Sums of 10² products and the sines of the turn round to 10⁻¹³ or so of the largest
/// entry; strains of 10⁻² are differences of positions.
#[test]
fn turned_axes_turn_the_answers() {
    for specimen in all() {
        let Some(turn) = specimen.turns.turn() else { continue };
        let elements = [specimen.element(), (specimen.build)(&turn)];
        let mut histories = elements.each_ref().map(|e| virgin(&**e));
        for (k, moved) in Moved::run(&specimen, 4).into_iter().enumerate() {
            let motions = [moved.clone(), moved.turned(&specimen, &turn)];
            let [here, there] = [0, 1].map(|i| answer(&*elements[i], &motions[i], &histories[i]));
            let scale = largest(&here.tangent.data) * specimen.amplitude;
            let force = turned_vector(&specimen, &turn, &here.force);
            close(&specimen, &format!("force, step {k}"), &force, &there.force, scale);
            matrices(&specimen, &turn, "tangent", &here.tangent, &there.tangent);
            histories = [here.history, there.history];
        }
        let [here, there] = elements.each_ref().map(|e| reference_mass(&**e));
        matrices(&specimen, &turn, "mass", &here, &there);
        let [here, there] = elements.each_ref().map(|e| damping(&**e));
        matrices(&specimen, &turn, "damping", &here, &there);
        let pull = Vector3::new(1.0, -2.0, 3.0);
        // Elements in a plane carry loads in that plane.
        let pull = match specimen.turns {
            Turns::AboutY(_) => Vector3::new(pull.x, 0.0, pull.z),
            _ => pull,
        };
        let [here, there] = [(0, pull), (1, turn * pull)].map(|(i, b)| weight(&*elements[i], b));
        let expected = turned_vector(&specimen, &turn, &here);
        close(&specimen, "weight", &expected, &there, largest(&here));
        if elements[0].buckling().is_some() {
            let moved = Moved::scattered(&specimen, 0, 1.0);
            let values = [moved.values.clone(), turned_vector(&specimen, &turn, &moved.values)];
            let [here, there] = [0, 1].map(|i| geometric(&*elements[i], &values[i]));
            matrices(&specimen, &turn, "geometric stiffness", &here, &there);
        }
    }
}

pub(crate) fn damping(element: &dyn Element) -> LocalMatrix {
    let mut out = LocalMatrix::zeros(fem::element::local_size(element));
    if !element.damping(&mut out) {
        out.data.fill(0.0);
    }
    out
}

pub(crate) fn weight(element: &dyn Element, acceleration: Vector3<f64>) -> Vec<f64> {
    let mut out = vec![0.0; fem::element::local_size(element)];
    element.body_force(acceleration.into(), &mut out);
    out
}

pub(crate) fn geometric(element: &dyn Element, values: &[f64]) -> LocalMatrix {
    let mut out = LocalMatrix::zeros(values.len());
    let buckling = element.buckling().expect("asked of elements that buckle");
    buckling.geometric_stiffness(values, &mut out).unwrap();
    out
}

/// T A x = B T x for every unit vector x.
fn matrices(specimen: &Specimen, turn: &UnitQuaternion<f64>, what: &str, here: &LocalMatrix, there: &LocalMatrix) {
    for k in 0..here.n {
        let mut unit = vec![0.0; here.n];
        unit[k] = 1.0;
        let back = turned_vector(specimen, &turn.inverse(), &unit);
        let expected = turned_vector(specimen, turn, &times(here, &back));
        close(specimen, what, &expected, &times(there, &unit), largest(&here.data));
    }
}

fn close(specimen: &Specimen, what: &str, expected: &[f64], found: &[f64], scale: f64) {
    for (k, (e, f)) in expected.iter().zip(found).enumerate() {
        assert!((e - f).abs() <= 1e-11 * scale, "{specimen}: {what} {k}: {e} turned, {f} found");
    }
}
