//! Gauss-Legendre quadrature on [−1, 1]: n points integrate polynomials of degree 2n − 1 exactly.
//!
//! Source: Abramowitz & Stegun 1964, table 25.4.

/// Points and weights.
pub type Rule = &'static [(f64, f64)];

const A2: f64 = 0.577_350_269_189_625_8;
const A3: f64 = 0.774_596_669_241_483_4;
const A4: (f64, f64) = (0.339_981_043_584_856_3, 0.861_136_311_594_052_6);
const W4: (f64, f64) = (0.652_145_154_862_546_1, 0.347_854_845_137_453_85);

const A5: (f64, f64) = (0.538_469_310_105_683, 0.906_179_845_938_664);
const W5: (f64, f64) = (0.478_628_670_499_366_47, 0.236_926_885_056_189_08);

/// Two points, exact to degree 3.
pub const TWO: Rule = &[(-A2, 1.0), (A2, 1.0)];

/// Three points, exact to degree 5.
pub const THREE: Rule = &[(-A3, 5.0 / 9.0), (0.0, 8.0 / 9.0), (A3, 5.0 / 9.0)];

/// Four points, exact to degree 7.
pub const FOUR: Rule = &[(-A4.1, W4.1), (-A4.0, W4.0), (A4.0, W4.0), (A4.1, W4.1)];

/// Five points, exact to degree 9.
pub const FIVE: Rule = &[(-A5.1, W5.1), (-A5.0, W5.0), (0.0, 128.0 / 225.0), (A5.0, W5.0), (A5.1, W5.1)];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn monomials_up_to_the_stated_degree() {
        for (rule, degree) in [(TWO, 3), (THREE, 5), (FOUR, 7), (FIVE, 9)] {
            for power in 0..=degree {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(power)).sum();
                let exact = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
                assert!((sum - exact).abs() < 1e-15, "degree {power}: {sum}");
            }
        }
    }
}
