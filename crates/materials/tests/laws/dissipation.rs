//! Dissipation is never negative, and closed cycles of strain from the initial state do not produce work.

use crate::path::{Noise, Point, cycle, norm, wander};
use crate::registry::{Case, every_law};

fn check<const N: usize>(case: &Case<N>) {
    let mut noise = Noise::new(37);
    // Rounding of a product of stress and strain.
    let rounding = 1e-13 * case.strength * case.strain;
    for run in 0..40 {
        let path =
            if run % 2 == 0 { wander(&mut noise, case.strain, 5, 10) } else { cycle(&mut noise, case.strain, 4, 50) };
        let mut point = Point::new(&*case.law);
        let (mut work, mut scale) = (0.0, rounding);
        let (mut strain, mut stress) = ([0.0; N], point.answer(&[0.0; N]).0.stress);
        for next in path {
            let response = point.step(&next);
            assert!(
                response.dissipation >= -rounding,
                "{}, N = {N}: dissipation {:e}",
                case.name,
                response.dissipation
            );
            for k in 0..N {
                work += 0.5 * (stress[k] + response.stress[k]) * (next[k] - strain[k]);
            }
            scale = f64::max(scale, norm(&response.stress) * norm(&next));
            (strain, stress) = (next, response.stress);
        }
        // Work = dissipation + stored energy ≥ 0; the trapezoidal rule errs where a step crosses a kink.
        let closed = run % 2 == 1;
        assert!(!closed || work >= -1e-6 * scale, "{}, N = {N}: work {work:e} of {scale:e}", case.name);
    }
}

#[test]
fn dissipation() {
    every_law!(check);
}
