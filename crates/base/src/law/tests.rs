//! The springs with friction against the curve, and the table between its places.

use super::*;
use crate::{Curve, Point};

const RADIUS: f64 = 10.0;

/// A law whose rim holds `hold(w)` over the pressure at rest times that pressure [N/m].
fn law(hold: impl Fn(f64) -> f64, largest: f64) -> Law {
    let places: Vec<f64> = (-80..=80).map(|i| 0.6 * (f64::from(i) / 80.0).powi(3)).collect();
    let curves = [1.0, 1.5, 0.5].map(|share| {
        let point = |w: &f64| Point {
            uplift: *w,
            hold_down: if *w < 0.0 { hold(*w) } else { share * hold(*w) },
            rotation: 0.0,
            rim_moment: 0.0,
            axial_force: 0.0,
            lifted_width: 0.0,
            plastic_rotation: 0.0,
        };
        (1e5 * share, Curve::through(places.iter().map(point).collect()))
    });
    Law::new(&Rocking::new(RADIUS, 15e3, curves.to_vec()).unwrap(), largest).unwrap()
}

/// Stiff where it presses, soft where it is lifted: M(ψ) is concave.
fn concave() -> Law {
    law(|w| if w < 0.0 { 1e7 * w } else { 1e5 * w }, 8e-3)
}

fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() < tolerance, "{found}, not {wanted}");
}

/// Springs and curve have the same moment where chords meet on the way from rest, for every share η. The tangent is the slope of the moment on any
/// way.
#[test]
fn the_springs_share_the_curve() {
    let law = concave();
    let rest = vec![0.0; law.springs().len()];
    assert!(law.springs().len() > 5);
    for &psi in law.rotations().iter().step_by(2).skip(1) {
        let curve = law.respond(psi, 0.0, 0.0, &[]).moment;
        for share in [0.3, 1.0] {
            close(law.respond(psi, 0.0, share, &rest).moment, curve, 1e-12);
        }
    }
    let mut slips = rest;
    law.commit(5e-3, &mut slips);
    for psi in [4.9e-3, 3.3e-3, -1.7e-3] {
        let at = |psi: f64| law.respond(psi, 0.0, 0.4, &slips);
        let slope = (at(psi + 1e-8).moment - at(psi - 1e-8).moment) / 2e-8;
        close(at(psi).tangent, slope, 1e-5);
    }
}

/// A cycle to ±ψ loses 8 ∫₀^ψ M dψ − 4 M ψ of the chain of chords (Masing), the first quarter of it nothing that comes back.
#[test]
fn a_cycle_of_the_springs_loses_what_masing_says() {
    let law = concave();
    let psi = law.largest();
    let mut slips = vec![0.0; law.springs().len()];
    law.commit(psi, &mut slips);
    let lost = law.commit(-psi, &mut slips) + law.commit(psi, &mut slips);
    let places: Vec<f64> = law.rotations().iter().step_by(2).copied().collect();
    let moment = |psi: f64| law.respond(psi, 0.0, 0.0, &[]).moment;
    let work: f64 = places.windows(2).map(|p| 0.5 * (moment(p[0]) + moment(p[1])) * (p[1] - p[0])).sum();
    close(lost, 8.0 * work - 4.0 * moment(psi) * psi, 1e-9);
}

/// Where the membrane stiffens the rim and it softens again, no spring is negative, and all of them with the rest have the stiffness of the first
/// chord.
#[test]
fn a_rim_that_stiffens_has_no_stiffer_springs() {
    let law = law(
        |w| match w {
            w if w < 0.0 => 1e7 * w,
            w if w < 0.02 => 1e5 * w,
            w if w < 0.05 => 2e3 + 2e7 * (w - 0.02),
            w => 6.02e5 + 1e5 * (w - 0.05),
        },
        8e-3,
    );
    let places: Vec<f64> = law.rotations().iter().step_by(2).copied().collect();
    let moment = |psi: f64| law.respond(psi, 0.0, 0.0, &[]).moment;
    let chords: Vec<f64> = places.windows(2).map(|p| (moment(p[1]) - moment(p[0])) / (p[1] - p[0])).collect();
    let rises = chords.windows(2).position(|c| c[1] > 1.1 * c[0]).unwrap();
    assert!(chords[rises + 1..].windows(2).any(|c| c[1] < 0.9 * c[0]), "{chords:?}");
    assert!(law.springs().iter().all(|s| s.stiffness > 0.0));
    let rest = vec![0.0; law.springs().len()];
    close(law.respond(0.0, 0.0, 1.0, &rest).tangent, chords[0], 1e-9);
}

/// The table's own turns at its places, halfway between two bottom pressures their mean, and mirrored on the other side.
#[test]
fn turns_between_the_places_of_the_table() {
    let law = concave();
    let fields = |t: &Turn| [t.moment, t.centre, t.uplift, t.toe_force, t.pull];
    for j in [1, 17, 40] {
        let psi = law.rotations()[j];
        for k in 1..law.suctions().len() {
            let (low, high) = (law.suctions()[k - 1], law.suctions()[k]);
            let own = law.turn(psi, high);
            let between = fields(&law.turn(psi, 0.5 * (low + high)));
            let mirrored = fields(&law.turn(-psi, -high));
            for i in 0..5 {
                let [a, b] = [k - 1, k].map(|k| fields(law.tabled(k, j))[i]);
                let near = |found: f64, wanted: f64| (found - wanted).abs() <= 1e-9 * (a.abs() + b.abs());
                assert!(near(fields(&own)[i], b) && near(mirrored[i], b), "{j} {k} {i}");
                assert!(near(between[i], 0.5 * (a + b)), "{j} {k} {i}");
            }
        }
    }
}
