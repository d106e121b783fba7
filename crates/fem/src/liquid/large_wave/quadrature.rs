//! Gauss-Legendre rules of any number of points.

use std::f64::consts::PI;

/// Points and weights on −1 to 1.
pub(super) fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    let rule = |i: usize| {
        let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        // Newton's method from this start converges in four steps; the fifth is free of its rounding.
        for _ in 0..6 {
            let (mut low, mut high) = (1.0, x);
            for k in 2..=count {
                let k = k as f64;
                (low, high) = (high, ((2.0 * k - 1.0) * x * high - (k - 1.0) * low) / k);
            }
            slope = n * (x * high - low) / (x * x - 1.0);
            x -= high / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..count).map(rule).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_exact() {
        for n in [2, 5, 16, 28] {
            let degree = 2 * n as i32 - 2;
            let sum: f64 = gauss_legendre(n).iter().map(|(x, w)| w * x.powi(degree)).sum();
            assert!((sum - 2.0 / f64::from(degree + 1)).abs() < 1e-13, "{n}: {sum}");
        }
    }
}
