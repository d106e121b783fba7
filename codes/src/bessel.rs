//! Bessel functions of potential flow in a circular tank.
//!
//! The convective modes of a cylinder need the zeros `λ_mn` of `J_m′` (no flow through the wall), the impulsive field the
//! ratio `I₁/I₁′`. The modified functions grow like `eˣ`; only their exponentially scaled forms are used, so that
//! arguments of several thousand (term 1000 of the impulsive series) do not overflow.
//!
//! This is a thin layer over `libm` (`J_n`) and `spec_math` (Cephes, `e⁻ˣ I₀`, `e⁻ˣ I₁`), checked against the tables of
//! Abramowitz and Stegun (1972), 9.5 and 9.8, and against 30-digit values.

use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;

use spec_math::cephes64;

/// `J_m(x)`, Bessel function of the first kind and integer order, `x ≥ 0`.
pub fn j(m: u32, x: f64) -> f64 {
    match m {
        0 => libm::j0(x),
        1 => libm::j1(x),
        _ => libm::jn(m as i32, x),
    }
}

/// Derivative `J_m′(x) = (J_{m−1} − J_{m+1})/2`, and `J_0′ = −J_1`.
pub fn j_prime(m: u32, x: f64) -> f64 {
    match m {
        0 => -libm::j1(x),
        _ => 0.5 * (j(m - 1, x) - j(m + 1, x)),
    }
}

/// Scaled `e⁻ˣ I₀(x)`, `x ≥ 0`.
pub fn i0_scaled(x: f64) -> f64 {
    cephes64::i0e(x)
}

/// Scaled `e⁻ˣ I₁(x)`, `x ≥ 0`.
pub fn i1_scaled(x: f64) -> f64 {
    cephes64::i1e(x)
}

/// Scaled `e⁻ˣ I₁′(x)` with `I₁′ = I₀ − I₁/x`, `x ≥ 0`.
pub fn i1_prime_scaled(x: f64) -> f64 {
    if x == 0.0 {
        return 0.5;
    }
    i0_scaled(x) - i1_scaled(x) / x
}

/// `I₁(x)/I₁′(x)`, `x ≥ 0`; `x` for small, `1 + 1/(2x)` for large arguments.
pub fn i1_over_i1_prime(x: f64) -> f64 {
    i1_scaled(x) / i1_prime_scaled(x)
}

/// The `n`-th positive zero `λ_mn` of `J_m′` (`n ≥ 1`), to rounding.
///
/// `λ₁₁ = 1.84118`, `λ₁₂ = 5.33144` … are the sloshing modes of a circular tank under horizontal motion (`m = 1`);
/// `m = 0` gives the axisymmetric modes, 3.83171, 7.01559 …; the zero at `x = 0` of `m = 0` is not counted.
///
/// The zeros are bracketed by walking in unit steps (they lie more than 2 apart and above `m`), so no start formula can
/// land on a neighbour, and then found by Newton's method with `J_m″ = −J_m′/x − (1 − m²/x²) J_m`.
///
/// This thread remembers those it has found.
///
/// # Panics
/// If `n = 0`.
pub fn j_prime_zero(m: u32, n: usize) -> f64 {
    assert!(n >= 1, "zeros of J_m' are counted from 1");
    if let Some(known) = ZEROS.with_borrow(|zeros| zeros.get(&(m, n)).copied()) {
        return known;
    }
    let found = nth_zero(m, n);
    ZEROS.with_borrow_mut(|zeros| zeros.insert((m, n), found));
    found
}

thread_local! {
    /// The zeros that this thread has found, by order and number: of sloshing modes, some tens.
    static ZEROS: RefCell<HashMap<(u32, usize), f64>> = RefCell::default();
}

fn nth_zero(m: u32, n: usize) -> f64 {
    let mut left = if m == 0 { 1.0 } else { f64::from(m) };
    let mut found = 0;
    loop {
        // McMahon's expansion puts zero k near (k + m/2 - 3/4) pi for k >> m; steps of 1 cannot skip two zeros.
        let right = left + 1.0;
        if j_prime(m, left).signum() != j_prime(m, right).signum() {
            found += 1;
            if found == n {
                return newton_in(m, left, right);
            }
        }
        left = right;
        debug_assert!(left < 10.0 * (n as f64 + 2.0 * f64::from(m) + 2.0) * PI, "zero not found");
    }
}

/// Zero of `J_m′` in `[left, right]`, which it is known to bracket: Newton steps, bisection where they leave.
fn newton_in(m: u32, mut left: f64, mut right: f64) -> f64 {
    let order_squared = f64::from(m) * f64::from(m);
    let sign_left = j_prime(m, left).signum();
    let mut x = 0.5 * (left + right);
    for _ in 0..60 {
        let slope = j_prime(m, x);
        if slope == 0.0 {
            return x;
        }
        if slope.signum() == sign_left {
            left = x;
        } else {
            right = x;
        }
        let curvature = -slope / x - (1.0 - order_squared / (x * x)) * j(m, x);
        let mut next = x - slope / curvature;
        if !(next > left && next < right) {
            next = 0.5 * (left + right);
        }
        if (next - x).abs() <= 2.0 * f64::EPSILON * x {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
// References keep the digits they were computed with.
#[allow(clippy::excessive_precision)]
mod tests {
    use super::*;

    /// Panics unless the two agree within the relative tolerance.
    fn close(value: f64, reference: f64, rtol: f64) {
        assert!((value - reference).abs() <= rtol * reference.abs(), "{value} instead of {reference}");
    }

    /// Abramowitz and Stegun, table 9.5 (five decimals; order 0 to ten); tolerance half the last printed digit.
    #[test]
    fn zeros_of_the_derivative_agree_with_abramowitz_and_stegun() {
        let table: [(u32, [f64; 4]); 3] = [
            (1, [1.84118, 5.33144, 8.53632, 11.70600]),
            (2, [3.05424, 6.70613, 9.96947, 13.17037]),
            (3, [4.20119, 8.01524, 11.34592, 14.58585]),
        ];
        for (m, zeros) in table {
            for (i, zero) in zeros.into_iter().enumerate() {
                assert!((j_prime_zero(m, i + 1) - zero).abs() <= 0.5e-5, "m = {m}, n = {}", i + 1);
            }
        }
        assert!((j_prime_zero(0, 1) - 3.8317059702).abs() <= 0.5e-10);
        assert!((j_prime_zero(0, 2) - 7.0155866698).abs() <= 0.5e-10);
    }

    /// Values with 18 digits (mpmath, 30 digits of work). Rounding of J' (about 1e-16) over J'' (0.2 to 0.6) moves a zero
    /// by less than 1e-15.
    #[test]
    fn zeros_of_the_derivative_are_exact_to_rounding() {
        let values = [
            (0, 1, 3.83170597020751232),
            (0, 10, 32.1896799109744036),
            (1, 1, 1.8411837813406593),
            (1, 2, 5.33144277352503264),
            (1, 3, 8.53631636634628583),
            (1, 4, 11.7060049025920641),
            (1, 10, 30.6019229726690942),
            (2, 1, 3.05423692822714032),
            (4, 1, 5.31755312608399435),
            (8, 1, 9.64742165199721683),
            (8, 10, 40.8301786818220406),
        ];
        for (m, n, value) in values {
            close(j_prime_zero(m, n), value, 1e-15);
        }
    }

    /// Abramowitz and Stegun, table 9.8 (ten decimals), and 18-digit values elsewhere (Cephes: 6e-16).
    #[test]
    fn modified_functions_agree_with_abramowitz_and_stegun() {
        for (x, i0, i1) in [(5.0, 0.1835408126, 0.1639722669), (10.0, 0.1278333372, 0.1212626814)] {
            assert!((i0_scaled(x) - i0).abs() <= 0.5e-10);
            assert!((i1_scaled(x) - i1).abs() <= 0.5e-10);
        }
        for (x, i0, i1) in [
            (0.1, 0.907100925782301092, 0.0452984468088093273),
            (8.0, 0.143431781856850311, 0.134142493292698178),
            (50.0, 0.0565616266474541925, 0.0559931238928953996),
            (500.0, 0.0178457065001531672, 0.0178278518528980565),
        ] {
            close(i0_scaled(x), i0, 1e-15);
            close(i1_scaled(x), i1, 1e-15);
        }
    }

    #[test]
    fn ratios_hold_from_small_to_large_arguments() {
        for (x, over_prime) in [
            (0.01, 0.00999975000729145204),
            (0.5, 0.470872325690959873),
            (2.0, 1.07166499597229047),
            (10.0, 1.04801445932636074),
            (500.0, 1.00099949498483385),
        ] {
            close(i1_over_i1_prime(x), over_prime, 3e-15);
        }
        // 1 + 1/(2x) far out, where I itself has long overflowed.
        let x = 6283.0;
        close(i1_over_i1_prime(x), 1.0 + 0.5 / x, 1e-7);
        assert_eq!(i1_over_i1_prime(0.0), 0.0);
    }

    /// `J_m′` against a difference quotient of `J_m` (truncation h²/6 J''' about 1e-11, rounding 1e-11).
    #[test]
    fn derivative_is_the_slope() {
        for m in 0..5 {
            for x in [0.7, 2.3, 6.1, 14.0] {
                let h = 1e-5;
                let slope = (j(m, x + h) - j(m, x - h)) / (2.0 * h);
                assert!((j_prime(m, x) - slope).abs() < 1e-10);
            }
        }
    }
}
