//! Bessel functions of the first kind and whole order, by their integral.

use std::f64::consts::TAU;

/// Points of the trapezoidal rule, which is exact to rounding for |x| + |m| < 100.
const POINTS: usize = 160;

/// J_m(x), for |x| < 60 and |m| < 20.
///
/// ```text
/// J_m(x) = 1/(2π) ∫_0^{2π} cos(m τ − x sin τ) dτ
/// ```
///
/// Known value: J_1(1) = 0.440 050 585 744 933 5.
pub fn bessel_j(m: i32, x: f64) -> f64 {
    let points = POINTS as f64;
    (0..POINTS).map(|i| TAU * i as f64 / points).map(|t| (f64::from(m) * t - x * t.sin()).cos()).sum::<f64>() / points
}

/// The n-th positive zero of J_m′, n from 1; of m = 0 the zero at the origin does not count.
///
/// Known value: J_1′(1.841 183 781 34) = 0.
pub fn bessel_j_prime_zero(m: i32, n: usize) -> f64 {
    let slope = |x: f64| 0.5 * (bessel_j(m - 1, x) - bessel_j(m + 1, x));
    let mut found = 0;
    let mut low = 0.2;
    loop {
        let high = low + 0.2;
        if slope(low) * slope(high) <= 0.0 {
            found += 1;
            if found == n {
                return bisect(slope, low, high);
            }
        }
        low = high;
    }
}

/// The zero between two places where a function has different signs.
fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle).signum() == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        assert!((bessel_j(1, 1.0) - 0.440_050_585_744_933_5).abs() < 1e-14);
        assert!((bessel_j(0, 14.0) - 0.171_073_476_110_458_96).abs() < 1e-13);
        // Abramowitz & Stegun, table 9.5.
        for (m, n, zero) in [(0, 1, 3.831_705_970_2), (1, 1, 1.841_183_781_3), (1, 2, 5.331_442_77), (3, 4, 14.585_85)]
        {
            assert!((bessel_j_prime_zero(m, n) - zero).abs() < 1e-5, "J_{m}' zero {n}: {}", bessel_j_prime_zero(m, n));
        }
    }
}
