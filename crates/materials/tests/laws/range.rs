//! The elastic range: convex, and inside it the response of a point without a past is C ε, without dissipation, with the stated
//! history.

use materials::ElasticRange;

use crate::path::{Noise, Point};
use crate::registry::{Case, every_law};

/// A strain along a random direction, up to the end of the range (by bisection) or a part of the way.
fn inside<const N: usize>(range: &dyn ElasticRange<N>, noise: &mut Noise, size: f64, part: f64) -> [f64; N] {
    let direction: [f64; N] = noise.vector();
    let at = |s: f64| direction.map(|d| s * size * d);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if range.holds(&at(middle)) {
            low = middle;
        } else {
            high = middle;
        }
    }
    at(part * low)
}

fn check<const N: usize>(case: &Case<N>) {
    let Some(range) = case.law.elastic_range() else { return };
    let mut noise = Noise::new(97);
    let moduli = range.moduli();
    let scale = moduli.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(range.holds(&[0.0; N]) && !range.holds(&[f64::NAN; N]), "{}", case.name);
    for k in 0..400 {
        let mut point = Point::new(&*case.law);
        let ends = [1.0, 1.0, 0.6].map(|part| inside(range, &mut noise, case.strain, part));
        for strain in ends {
            let (response, history) = point.answer(&strain);
            for i in 0..N {
                let expected: f64 = (0..N).map(|j| moduli[i][j] * strain[j]).sum();
                // Rounding of sums of N terms E ε.
                assert!((response.stress[i] - expected).abs() <= 1e-13 * scale * case.strain, "{}, N = {N}", case.name);
            }
            assert_eq!(response.tangent, moduli, "{}, N = {N}", case.name);
            assert_eq!(response.dissipation, 0.0, "{}, N = {N}", case.name);
            let mut stated = vec![f64::NAN; history.len()];
            range.history(&strain, &mut stated);
            assert_eq!(history, stated, "{}, N = {N}", case.name);
            point.history = history;
        }
        // Between two strains of the range; 1e-12 off its border, which two roundings may see differently.
        let share = f64::from(k) / 400.0;
        let between: [f64; N] =
            std::array::from_fn(|i| (1.0 - 1e-12) * (share * ends[0][i] + (1.0 - share) * ends[1][i]));
        assert!(range.holds(&between), "{}, N = {N}: not convex", case.name);
    }
}

#[test]
fn elastic_ranges() {
    every_law!(check);
}
