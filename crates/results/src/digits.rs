//! Numbers with a few significant digits, rounded as `format!("{x:.*e}")` rounds and many times as fast.

use std::io::Write;

/// Powers of ten that are doubles.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
/// log₁₀ 2 · 2²⁰: near enough that the whole part of its product with any exponent is right.
const LOG_2: i32 = 315_653;
/// Largest distance from a half that is not decided: products of two doubles below 10¹² are wrong by 6·10⁻⁵ at most.
const UNDECIDED: f64 = 1e-3;

/// `x` times 10^`power`: one rounding. None where the power of ten is not a double.
fn shifted(x: f64, power: i32) -> Option<f64> {
    let factor = *POWERS.get(power.unsigned_abs() as usize)?;
    Some(if power < 0 { x / factor } else { x * factor })
}

/// Digits m and decimal exponent e of |x| ≈ m · 10^(e − digits + 1), where 10^(digits − 1) ≤ m < 10^digits ≤ 10¹².
/// None where doubles do not decide it: beyond 10^±16 or so, zero, near a half.
fn decimal(x: f64, digits: usize) -> Option<(u64, i32)> {
    let x = x.abs();
    let last = digits as i32 - 1;
    let (low, high) = (POWERS[digits - 1], POWERS[digits]);
    // log₁₀ of the power of two below x: e, or one less.
    let binary = (x.to_bits() >> 52) as i32 - 1023;
    let mut e = (binary * LOG_2) >> 20;
    let mut m = shifted(x, last - e)?;
    if m >= high {
        e += 1;
        m = shifted(x, last - e)?;
    }
    let whole = m as u64;
    let rest = m - whole as f64;
    if !(low..high).contains(&m) || (rest - 0.5).abs() < UNDECIDED {
        return None;
    }
    let rounded = whole + u64::from(rest > 0.5);
    Some(if rounded == high as u64 { (low as u64, e + 1) } else { (rounded, e) })
}

/// `x` rounded to at most twelve significant digits: the double next to the decimal number.
pub(crate) fn rounded(x: f64, digits: usize) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let near = decimal(x, digits).and_then(|(m, e)| shifted(m as f64, e + 1 - digits as i32));
    match near {
        Some(near) => near.copysign(x),
        None => format!("{x:.*e}", digits - 1).parse().unwrap_or(x),
    }
}

/// Appends `x` with that many significant digits as `{:e}` writes [`rounded`]: without zeros at the end.
pub(crate) fn append(text: &mut Vec<u8>, x: f64, digits: usize) {
    let Some((mut m, e)) = decimal(x, digits) else {
        // A vector takes what is written.
        let _ = write!(text, "{:e}", rounded(x, digits));
        return;
    };
    let mut figures = [0u8; 12];
    for place in figures[..digits].iter_mut().rev() {
        *place = b'0' + (m % 10) as u8;
        m /= 10;
    }
    let kept = figures[..digits].iter().rposition(|&figure| figure != b'0').unwrap_or(0);
    if x < 0.0 {
        text.push(b'-');
    }
    text.push(figures[0]);
    if kept > 0 {
        text.push(b'.');
        text.extend_from_slice(&figures[1..=kept]);
    }
    text.push(b'e');
    if e < 0 {
        text.push(b'-');
    }
    let e = e.unsigned_abs() as u8;
    if e > 9 {
        text.push(b'0' + e / 10);
    }
    text.push(b'0' + e % 10);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By a decimal round trip.
    fn slow(x: f64, digits: usize) -> f64 {
        format!("{x:.*e}", digits - 1).parse().expect("a number")
    }

    fn assert_same(x: f64) {
        for digits in [1, 2, 7, 9, 10, 12] {
            let expected = if x == 0.0 { 0.0 } else { slow(x, digits) };
            let found = rounded(x, digits);
            assert!(found == expected || found.is_nan() && x.is_nan(), "{x:e} to {digits}: {found:e}, {expected:e}");
            let mut text = Vec::new();
            append(&mut text, x, digits);
            assert_eq!(String::from_utf8_lossy(&text), format!("{expected:e}"), "{x:e} to {digits}");
        }
    }

    #[test]
    fn as_a_decimal_round_trip() {
        for x in [0.0, -0.0, 1.0, -1.0, 9.9999999, 0.99999995, 9.5, 1e22, 1e23, 1e-5, f64::MAX, f64::MIN_POSITIVE] {
            assert_same(x);
        }
        // Halves, powers of ten and the doubles next to them.
        for e in -30..30 {
            for m in
                ["1", "9.9999995", "1.0000005", "2.5", "1.2345675", "9.99999999995", "9.999999999995", "1.00000000005"]
            {
                let x: f64 = format!("{m}e{e}").parse().expect("a number");
                [x, x.next_up(), x.next_down(), -x].into_iter().for_each(assert_same);
            }
        }
        assert_eq!(rounded(f64::INFINITY, 7), f64::INFINITY);
        assert!(rounded(f64::NAN, 7).is_nan());
        let mut seed = 7u64;
        for _ in 0..200_000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let x = (seed >> 11) as f64 * 2f64.powi((seed % 140) as i32 - 120);
            assert_same(x);
        }
    }
}
