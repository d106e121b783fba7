//! The largest value of a concave function of two variables, by Newton's method with halved steps.

/// Value, gradient and Hessian (first, mixed, second).
pub(crate) type Local = (f64, [f64; 2], [f64; 3]);

/// Most steps; concave likelihoods need fewer than twenty.
const STEPS: usize = 200;

/// Gain of a step over the value below which Newton's method has begun to double its digits.
const NEAR: f64 = 1e-10;

/// The place of the largest value; none if it is not found.
pub(crate) fn maximum(start: [f64; 2], function: impl Fn([f64; 2]) -> Local) -> Option<[f64; 2]> {
    let mut at = start;
    let mut local = function(at);
    for _ in 0..STEPS {
        let (value, g, [a, b, d]) = local;
        let determinant = a * d - b * b;
        if !(determinant > 0.0 && value.is_finite()) {
            return None;
        }
        let step = [
            -(d * g[0] - b * g[1]) / determinant,
            -(a * g[1] - b * g[0]) / determinant,
        ];
        // Twice what the step gains. Near the maximum a whole step is right, and rounding would halve it in vain.
        let near = step[0] * g[0] + step[1] * g[1] < NEAR * (1.0 + value.abs());
        let mut share = 1.0;
        let next = loop {
            let place = [at[0] + share * step[0], at[1] + share * step[1]];
            let found = function(place);
            if near || found.0 >= value || share < 1e-12 {
                break (place, found);
            }
            share *= 0.5;
        };
        let moved = (0..2).all(|i| (next.0[i] - at[i]).abs() <= 1e-14 * (1.0 + at[i].abs()));
        (at, local) = next;
        if moved {
            break;
        }
    }
    at.iter().all(|x| x.is_finite()).then_some(at)
}
