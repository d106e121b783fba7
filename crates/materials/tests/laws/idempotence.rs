//! A second response at the committed strain with the committed history: the same stress, zero dissipation.

use crate::path::{Noise, Point, norm, wander};
use crate::registry::{Case, every_law};

fn check<const N: usize>(case: &Case<N>) {
    let mut noise = Noise::new(53);
    for _ in 0..20 {
        let mut point = Point::new(&*case.law);
        for strain in wander(&mut noise, case.strain, 5, 10) {
            let first = point.step(&strain);
            let (again, _) = point.answer(&strain);
            let gap: [f64; N] = std::array::from_fn(|i| again.stress[i] - first.stress[i]);
            // Elastic strain is the difference of strain and plastic strain: rounding of 10⁻¹⁶ E ε.
            assert!(norm(&gap) <= 1e-10 * case.strength, "{}, N = {N}: {gap:?}", case.name);
            let energy = case.strength * case.strain;
            assert!(
                again.dissipation.abs() <= 1e-12 * energy,
                "{}, N = {N}: dissipation {:e}",
                case.name,
                again.dissipation
            );
        }
    }
}

#[test]
fn idempotence() {
    every_law!(check);
}
