//! The tangent against differences of the stress.
//!
//! Central differences with Richardson's extrapolation, error O(h⁴), at two widths h. Where the stress has a kink
//! within reach (first yield, start of unloading, opening and closing of a crack) the derivative does not exist: such
//! a point is detected by the disagreement of the two widths, or by dissipation on one side of the kink only, and is
//! excluded. Both tests are independent of the tangent. At most a tenth of all points may be excluded.

use crate::path::{Noise, Point, wander};
use crate::registry::{Case, every_law};

/// Relative to the largest entry of the elastic tangent.
const TOLERANCE: f64 = 1e-8;

/// ∂σ/∂ε_j by differences of width `h`; `None` at a kink.
fn column<const N: usize>(point: &Point<'_, N>, strain: &[f64; N], j: usize, h: f64) -> Option<[f64; N]> {
    let dissipates = point.answer(strain).0.dissipation > 0.0;
    let at = |shift: f64| {
        let mut strain = *strain;
        strain[j] += shift;
        let response = point.answer(&strain).0;
        ((response.dissipation > 0.0) == dissipates).then_some(response.stress)
    };
    let (a, b, c, d) = (at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?);
    Some(std::array::from_fn(|i| (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * h)))
}

fn check<const N: usize>(case: &Case<N>) {
    let mut noise = Noise::new(11);
    let virgin = Point::new(&*case.law).answer(&[0.0; N]).0.tangent;
    let scale = virgin.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let (mut worst, mut compared, mut kinks) = (0.0f64, 0, 0);
    for _ in 0..20 {
        let mut point = Point::new(&*case.law);
        for (i, strain) in wander(&mut noise, case.strain, 6, 12).iter().enumerate() {
            if i % 3 == 0 {
                let tangent = point.answer(strain).0.tangent;
                for j in 0..N {
                    let pair = [2e-4, 1e-4].map(|h| column(&point, strain, j, h * case.strain));
                    let [Some(wide), Some(narrow)] = pair else {
                        kinks += 1;
                        continue;
                    };
                    let gap = (0..N).map(|i| (wide[i] - narrow[i]).abs()).fold(0.0, f64::max);
                    if gap > 0.3 * TOLERANCE * scale {
                        kinks += 1;
                        continue;
                    }
                    compared += 1;
                    for i in 0..N {
                        worst = worst.max((tangent[i][j] - narrow[i]).abs() / scale);
                    }
                }
            }
            point.step(strain);
        }
    }
    println!("{:30} N = {N}: {worst:.1e} over {compared} columns, {kinks} beside kinks", case.name);
    assert!(worst < TOLERANCE, "{}, N = {N}: {worst:e}", case.name);
    assert!(10 * kinks < compared + kinks, "{}, N = {N}: {kinks} of {compared}", case.name);
}

#[test]
fn tangents() {
    every_law!(check);
}
