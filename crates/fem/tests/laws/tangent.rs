//! The tangent is the derivative of the force.
//!
//! Differences of forces f at a distance h = 10⁻⁵ of the amplitude: rounding leaves 10⁻¹⁶ |f|/h, about 10⁻¹¹ of the largest
//! entry, and the third derivative h² of it, less. Ten times the first is granted to every entry, and 10⁻⁷ of its column, so
//! that wrong terms show in soft columns as well.

use crate::motion::Moved;
use crate::registry::all;
use crate::specimen::{Specimen, Tangent, answer, largest, symmetric, virgin};

#[test]
fn tangent_is_the_derivative_of_the_force() {
    for specimen in all() {
        let element = specimen.element();
        let mut history = virgin(&*element);
        for (k, part) in [1.0, 0.4].into_iter().enumerate() {
            let moved = Moved::scattered(&specimen, k, part);
            let at = answer(&*element, &moved, &history);
            let expected = differences(&specimen, &moved, &history);
            let n = at.tangent.n;
            assert!(symmetric(&at.tangent), "{specimen}: not symmetric");
            let all = expected.iter().map(|c| largest(c)).fold(0.0, f64::max);
            for (j, column) in expected.iter().enumerate() {
                for (i, &value) in column.iter().enumerate() {
                    let (value, granted) = match specimen.tangent {
                        Tangent::Derivative => (value, 1e-7 * largest(column)),
                        Tangent::SymmetricPart(_) => (0.5 * (value + expected[i][j]), 1e-7 * all),
                        Tangent::Near(part, _) => (value, part * all),
                    };
                    let error = (at.tangent.get(i, j) - value).abs();
                    assert!(
                        error <= 1e-10 * all + granted,
                        "{specimen}: entry ({i}, {j}) of {n} is {}, differences give {value}, step {k}",
                        at.tangent.get(i, j)
                    );
                }
            }
            if let Tangent::SymmetricPart(why) = specimen.tangent {
                let skew = (0..n).flat_map(|j| (0..j).map(move |i| (i, j)));
                let worst = skew.map(|(i, j)| (expected[i][j] - expected[j][i]).abs()).fold(0.0, f64::max);
                assert!(worst > 1e-6 * all, "{specimen}: symmetric in spite of: {why}");
            }
            history = at.history;
        }
    }
}

/// Columns of central differences.
fn differences(specimen: &Specimen, moved: &Moved, history: &[f64]) -> Vec<Vec<f64>> {
    let element = specimen.element();
    let h = 1e-5 * specimen.amplitude;
    let column = |k: usize| {
        let [plus, minus] = [h, -h].map(|h| answer(&*element, &moved.nudged(specimen, k, h), history).force);
        plus.iter().zip(&minus).map(|(p, m)| (p - m) / (2.0 * h)).collect()
    };
    (0..moved.values.len()).map(column).collect()
}
