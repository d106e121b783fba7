//! Optional abilities agree with the element itself.

use fem::element::{Inspect, Response, Trial, Want, local_size, reference_stiffness};

use crate::frame::geometric;
use crate::motion::Moved;
use crate::registry::{all, least};
use crate::rigid::{MODES, mode};
use crate::specimen::{answer, largest, symmetric, virgin};

/// Samples have a row over all dofs. A rigid motion that leaves no force leaves no stress: 10⁻¹² of the row's largest entry at
/// positions of a metre or two.
#[test]
fn rigid_motions_make_no_stress() {
    for specimen in all() {
        let element = specimen.element();
        for sample in element.samples() {
            assert_eq!(sample.row.len(), local_size(&*element), "{specimen}: {}", sample.name);
            for (m, name) in MODES.into_iter().enumerate().filter(|(m, _)| !specimen.resists.0.contains(m)) {
                let row = specimen.row(|x| mode(m, x));
                let value: f64 = sample.row.iter().zip(&row).map(|(c, u)| c * u).sum();
                assert!(value.abs() <= 1e-12 * largest(&sample.row), "{specimen}: {} under {name}", sample.name);
            }
        }
    }
}

/// Dissipation starts at zero and never decreases, except for rounding.
#[test]
fn dissipated_energy_grows() {
    let mut some = 0;
    for specimen in all() {
        let element = specimen.element();
        let mut history = virgin(&*element);
        assert_eq!(element.dissipated(&history), 0.0, "{specimen}");
        for moved in &Moved::run(&specimen, 12) {
            let before = element.dissipated(&history);
            history = answer(&*element, moved, &history).history;
            let after = element.dissipated(&history);
            assert!(after >= before * (1.0 - 1e-12), "{specimen}: {before} J, then {after} J");
        }
        some += usize::from(element.dissipated(&history) > 0.0);
    }
    assert!(some >= least().dissipate, "{some} elements dissipate");
}

/// Points and sections come in the same number and order at every motion, as do switches.
#[test]
fn what_is_shown_keeps_its_order() {
    for specimen in all() {
        let element = specimen.element();
        let history = virgin(&*element);
        let shown = |moved: &Moved| {
            let (mut points, mut switches) = (Vec::new(), 0);
            element.material_points(moved.motion(), &history, &mut |p| points.push((p.point, p.layer)));
            if let Some(joint) = element.contact() {
                joint.switches(moved.motion(), &history, &mut |_| switches += 1);
                assert!(joint.penetration(moved.motion()) >= 0.0, "{specimen}");
            }
            let sections = element.sections(moved.motion(), &history).unwrap().len();
            (points, switches, sections)
        };
        let first = shown(&Moved::rest(&specimen));
        for k in 0..4 {
            assert_eq!(shown(&Moved::scattered(&specimen, k, 1.0)), first, "{specimen}");
        }
    }
}

/// The force is that of the element whatever is kept. The tangent is, as long as there is no iterate before, and again when the
/// one before is the present one (zero extrapolation: 10⁻¹² for the order of sums); in between it is another.
#[test]
fn mixed_tangent_meets_the_consistent_one() {
    let mut some = 0;
    for specimen in all() {
        let element = specimen.element();
        let Some(mixed) = element.mixed() else { continue };
        some += 1;
        let history = virgin(&*element);
        let mut kept = vec![0.0; mixed.mixed_len()];
        for (k, meets) in [(0, true), (1, false), (1, true)] {
            let moved = Moved::scattered(&specimen, k, 1.0);
            let expected = answer(&*element, &moved, &history);
            let mut out = Response::sized(local_size(&*element));
            let mut new = vec![0.0; history.len()];
            mixed
                .respond_mixed(
                    Trial { motion: moved.motion(), old: &history, new: &mut new, want: Want::ALL },
                    &mut kept,
                    &mut out,
                )
                .unwrap();
            assert_eq!((&out.force, &new), (&expected.force, &expected.history), "{specimen}");
            assert!(symmetric(&out.tangent), "{specimen}");
            let pairs = out.tangent.data.iter().zip(&expected.tangent.data);
            let difference = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let scale = largest(&expected.tangent.data);
            assert_eq!(difference <= 1e-12 * scale, meets, "{specimen}: {difference:e} of {scale:e}");
        }
    }
    assert!(some >= least().mixed, "{some} elements have a mixed tangent");
}

/// The geometric stiffness is symmetric, in proportion to the displacement, and none of a rigid motion: 10⁻¹² of the
/// stiffness, from which stresses of the same displacements come.
#[test]
fn geometric_stiffness_is_that_of_the_stresses() {
    let mut some = 0;
    for specimen in all() {
        let element = specimen.element();
        if element.buckling().is_none() {
            continue;
        }
        some += 1;
        let values = Moved::scattered(&specimen, 0, 1.0 / specimen.amplitude).values;
        let of = |values: &[f64]| geometric(&*element, values);
        let (once, twice) = (of(&values), of(&values.iter().map(|v| 2.0 * v).collect::<Vec<_>>()));
        let stiffness = largest(&reference_stiffness(&*element).unwrap().data);
        let scale = largest(&once.data);
        assert!(scale > 0.0 && symmetric(&once), "{specimen}");
        for (a, b) in once.data.iter().zip(&twice.data) {
            assert!((2.0 * a - b).abs() <= 1e-12 * scale, "{specimen}: not in proportion");
        }
        for (m, name) in MODES.into_iter().enumerate() {
            let found = largest(&of(&specimen.row(|x| mode(m, x))).data);
            assert!(found <= 1e-12 * stiffness, "{specimen}: {found:e} of {stiffness:e} under {name}");
        }
    }
    assert!(some >= least().buckle, "{some} elements buckle");
}
