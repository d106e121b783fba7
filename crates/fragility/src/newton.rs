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
        let step = [-(d * g[0] - b * g[1]) / determinant, -(a * g[1] - b * g[0]) / determinant];
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

/// Gradient and Hessian are the central differences of value and gradient, to the square of the step.
#[cfg(test)]
pub(crate) fn derivatives_agree(at: [f64; 2], function: impl Fn([f64; 2]) -> Local) {
    const STEP: f64 = 1e-5;
    let (_, gradient, [first, mixed, second]) = function(at);
    let hessian = [[first, mixed], [mixed, second]];
    for i in 0..2 {
        let moved = |sign: f64| {
            let mut place = at;
            place[i] += sign * STEP;
            function(place)
        };
        let (low, high) = (moved(-1.0), moved(1.0));
        let agree = |slope: f64, by: f64| {
            let difference = by / (2.0 * STEP);
            assert!((slope - difference).abs() < 1e-7 * (1.0 + slope.abs()), "{i}: {slope} {difference}");
        };
        agree(gradient[i], high.0 - low.0);
        for k in 0..2 {
            agree(hessian[i][k], high.1[k] - low.1[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// A quadratic is at its maximum after one step, and a step of nothing ends the search: three values. Where the second one is lower by
    /// rounding, the step near the maximum is still a whole one.
    #[test]
    fn a_quadratic_takes_one_step() {
        // −2x² + xy − 1.5y² about (0.3, −0.7).
        for (start, top, lost) in
            [([4.0, -9.0], 0.0, 0.0), ([0.3, -0.7 + 1e-6], 0.0, 1e-11), ([0.3 + 1e-4, -0.7], -1e3, 1e-7)]
        {
            let calls = Cell::new(0);
            let function = |[x, y]: [f64; 2]| -> Local {
                let (x, y) = (x - 0.3, y + 0.7);
                calls.set(calls.get() + 1);
                let value = top - 2.0 * x * x + x * y - 1.5 * y * y - lost * f64::from(calls.get());
                (value, [-4.0 * x + y, x - 3.0 * y], [-4.0, 1.0, -3.0])
            };
            let [x, y] = maximum(start, function).unwrap();
            assert!((x - 0.3).abs() < 1e-14 && (y + 0.7).abs() < 1e-14, "{start:?}: {x} {y}");
            assert_eq!(calls.get(), 3, "{start:?}");
        }
    }
}
