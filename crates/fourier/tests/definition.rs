//! The transforms against their sums.

use std::f64::consts::TAU;

use fourier::{Complex64, Transforms};

/// A power of two, a product of 3 and 5, a prime, and a length with a large prime factor: the planner chooses another algorithm for each.
#[test]
fn transforms_are_the_sums_of_their_definition() {
    for length in [8_usize, 45, 37, 2 * 211] {
        let plan = Transforms::new(length);
        let series: Vec<f64> = (0..length).map(|k| (1.7 * k as f64).sin() + 0.1 * k as f64).collect();
        let mut found = plan.forward.make_output_vec();
        plan.forward.process(&mut series.clone(), &mut found).expect("lengths of the plan");
        assert_eq!(found.len(), length / 2 + 1);
        // N terms of size N/10, each with a rounding of 2e-16, and two digits to spare.
        let allowed = 2e-15 * (length * length) as f64;
        for (m, wave) in found.iter().enumerate() {
            let term =
                |(k, x): (usize, &f64)| Complex64::from_polar(*x, -TAU * ((m * k) % length) as f64 / length as f64);
            let sum: Complex64 = series.iter().enumerate().map(term).sum();
            assert!((wave - sum).norm() < allowed, "{length} {m}: {wave} {sum}");
        }
        let mut back = plan.inverse.make_output_vec();
        plan.inverse.process(&mut found, &mut back).expect("lengths of the plan");
        for (back, x) in back.iter().zip(&series) {
            assert!((back / length as f64 - x).abs() < allowed, "{length}: {back} {x}");
        }
    }
}
