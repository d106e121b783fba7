//! Demands against intensities by regression (Cornell, Jalayer, Hamburger & Foutch 2002). Runs that collapsed have no demand: the curve is
//! that of the others, and the probability of collapse is given with it.
//!
//! ```text
//! ln d = a + b ln im        σ² = Σ r²/(n − 2)        θ = exp((ln d_limit − a)/b)        β = σ/b
//! P_c(im) = 1/(1 + exp(−(α + γ ln im)))        logistic regression of the collapses (Jalayer et al. 2017)
//! P(im) = P_nc(im) (1 − P_c(im)) + P_c(im)        both together: not lognormal, left to the reader
//! ```

use serde::{Deserialize, Serialize};

use crate::newton::{self, Local};
use crate::{Lognormal, NotIdentifiable};

/// Fewest runs without collapse.
pub const FEWEST: usize = 8;

/// Φ(1): the probability one standard deviation above the mean.
const ONE_DEVIATION: f64 = 0.841_344_746_068_542_9;

/// A run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Intensity, positive.
    pub im: f64,
    /// Demand, positive; none of a run that collapsed.
    pub demand: Option<f64>,
}

/// A regression.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cloud {
    /// Intercept a.
    pub intercept: f64,
    /// Slope b.
    pub slope: f64,
    /// Standard deviation σ of ln d.
    pub deviation: f64,
    /// Coefficient of determination R².
    pub determination: f64,
    /// Runs without collapse.
    pub n: usize,
    /// Runs that collapsed.
    pub collapsed: usize,
    /// Logistic regression of the collapses: intercept and slope on ln im; none where they do not identify it, or there are none.
    pub collapse: Option<[f64; 2]>,
}

/// The regression of the runs.
///
/// Errors: fewer than eight runs without collapse; intensities that are all equal; a demand that does not grow.
pub fn fit(runs: &[Run]) -> Result<Cloud, NotIdentifiable> {
    let points: Vec<[f64; 2]> = runs.iter().filter_map(|r| Some([r.im.ln(), r.demand?.ln()])).collect();
    let n = points.len();
    if n < FEWEST {
        return Err(NotIdentifiable::because(format!("{n} runs without collapse, fewer than {FEWEST}")));
    }
    let mean = |i: usize| points.iter().map(|p| p[i]).sum::<f64>() / n as f64;
    let (x, y) = (mean(0), mean(1));
    let sum = |of: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(of).sum::<f64>();
    let (xx, xy, yy) = (sum(&|p| (p[0] - x).powi(2)), sum(&|p| (p[0] - x) * (p[1] - y)), sum(&|p| (p[1] - y).powi(2)));
    if xx <= 1e-12 * n as f64 {
        return Err(NotIdentifiable::because("all intensities are equal"));
    }
    let slope = xy / xx;
    if slope <= 0.0 {
        return Err(NotIdentifiable::because("the demand does not grow with intensity"));
    }
    let residual = (yy - slope * xy).max(0.0);
    Ok(Cloud {
        intercept: y - slope * x,
        slope,
        deviation: (residual / (n - 2) as f64).sqrt(),
        determination: if yy > 0.0 { 1.0 - residual / yy } else { 1.0 },
        n,
        collapsed: runs.len() - n,
        collapse: logistic(runs),
    })
}

/// Logistic regression of the collapses; none where an intensity separates them.
fn logistic(runs: &[Run]) -> Option<[f64; 2]> {
    let fell = |r: &&Run| r.demand.is_none();
    let first = runs.iter().filter(fell).map(|r| r.im).reduce(f64::min)?;
    let last = runs.iter().filter(|r| !fell(r)).map(|r| r.im).reduce(f64::max)?;
    if last <= first {
        return None;
    }
    let centre = runs.iter().map(|r| r.im.ln()).sum::<f64>() / runs.len() as f64;
    let [a, b] = newton::maximum([0.0, 0.0], |at| likelihood(runs, centre, at))?;
    (b > 0.0).then_some([a - b * centre, b])
}

/// ln L of the collapses at the intercept a and the slope b on ln im − `centre`.
fn likelihood(runs: &[Run], centre: f64, [a, b]: [f64; 2]) -> Local {
    let (mut value, mut g, mut h) = (0.0, [0.0; 2], [0.0; 3]);
    for run in runs {
        let x = run.im.ln() - centre;
        let u = a + b * x;
        let p = 1.0 / (1.0 + (-u).exp());
        let z = f64::from(u8::from(run.demand.is_none()));
        // ln p and ln(1 − p) without cancellation.
        value -= if z > 0.0 { (-u).exp().ln_1p() } else { u.exp().ln_1p() };
        let (d, c) = (z - p, -p * (1.0 - p));
        g = [g[0] + d, g[1] + d * x];
        h = [h[0] + c, h[1] + c * x, h[2] + c * x * x];
    }
    (value, g, h)
}

impl Cloud {
    /// The curve of a limit of the demand, of runs without collapse.
    ///
    /// Errors: a regression without scatter, of which β would be 0.
    pub fn curve(&self, limit: f64) -> Result<Lognormal, NotIdentifiable> {
        if self.deviation <= 0.0 {
            return Err(NotIdentifiable::because("the demands lie on a line: the dispersion is not identified"));
        }
        Ok(Lognormal {
            median: ((limit.ln() - self.intercept) / self.slope).exp(),
            dispersion: self.deviation / self.slope,
        })
    }

    /// The curve of a limit with the collapses: P = P_nc (1 − P_c) + P_c is not lognormal; its median is that of the curve, its dispersion half the
    /// logarithmic distance from the probability 16 % to 84 % (Jalayer et al. 2017). Without collapses it is [`Cloud::curve`].
    ///
    /// Errors: as [`Cloud::curve`]; collapses whose probability is not identified.
    pub fn total(&self, limit: f64) -> Result<Lognormal, NotIdentifiable> {
        let free = self.curve(limit)?;
        if self.collapsed == 0 {
            return Ok(free);
        }
        let Some([a, b]) = self.collapse else {
            return Err(NotIdentifiable::because(format!(
                "{} runs collapsed, and an intensity separates them from the others or too few collapsed: their probability is not identified",
                self.collapsed
            )));
        };
        let at = |log: f64| {
            let collapse = 1.0 / (1.0 + (-(a + b * log)).exp());
            let other = free.probability(log.exp());
            other * (1.0 - collapse) + collapse
        };
        // Both parts grow with intensity. Where both are 1e-6, and where one is 1 − 1e-6.
        let low = (free.quantile(1e-6).ln()).min((-13.8 - a) / b);
        let high = (free.quantile(1.0 - 1e-6).ln()).min((13.8 - a) / b);
        let place = |p: f64| {
            let (mut low, mut high) = (low, high);
            // To the last digits: 60 halvings.
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if at(middle) < p { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        };
        Ok(Lognormal {
            median: place(0.5).exp(),
            dispersion: 0.5 * (place(ONE_DEVIATION) - place(1.0 - ONE_DEVIATION)),
        })
    }

    /// Probability of collapse at an intensity; none where it is not identified.
    pub fn collapse_probability(&self, im: f64) -> Option<f64> {
        let [a, b] = self.collapse?;
        Some(1.0 / (1.0 + (-(a + b * im.ln())).exp()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ln d = 0.3 + 1.2 ln im ± 0.1 alternately in pairs at each intensity: the line is exact, Σ r² = 0.01 n.
    #[test]
    fn a_known_line() {
        let mut runs = Vec::new();
        for k in 1..=10 {
            let im = 0.1 * f64::from(k);
            for r in [-0.1, 0.1] {
                runs.push(Run { im, demand: Some((0.3 + 1.2 * im.ln() + r).exp()) });
            }
        }
        let found = fit(&runs).unwrap();
        assert!((found.intercept - 0.3).abs() < 1e-12 && (found.slope - 1.2).abs() < 1e-12);
        assert!((found.deviation - (0.01_f64 * 20.0 / 18.0).sqrt()).abs() < 1e-12);
        let curve = found.curve(1.0).unwrap();
        assert!((curve.median - (-0.25_f64).exp()).abs() < 1e-12);
        assert!((curve.dispersion - found.deviation / 1.2).abs() < 1e-15);
    }

    /// Two levels with shares ¼ and ¾ of collapses: the logistic line passes through both log-odds, ∓ ln 3, exactly.
    #[test]
    fn collapses_at_two_intensities() {
        let mut runs = Vec::new();
        for (im, fell) in [(1.0, 4), (2.0, 12)] {
            for k in 0..16 {
                runs.push(Run { im, demand: (k >= fell).then_some(im) });
            }
        }
        let found = fit(&runs).unwrap();
        assert!((found.collapse_probability(1.0).unwrap() - 0.25).abs() < 1e-10);
        assert!((found.collapse_probability(2.0).unwrap() - 0.75).abs() < 1e-10);
        assert_eq!(found.collapsed, 16);
    }

    #[test]
    fn derivatives_of_the_likelihood() {
        let run = |k: u32| Run { im: 0.3 * f64::from(k), demand: (!k.is_multiple_of(3)).then_some(1.0) };
        let runs: Vec<Run> = (1..=9).map(run).collect();
        newton::derivatives_agree([-0.4, 1.3], |at| likelihood(&runs, 0.2, at));
    }

    /// With the collapses of two levels above, the total is P_nc (1 − P_c) + P_c at the median and one dispersion beside it; without any it is the
    /// curve of the regression.
    #[test]
    fn the_total_has_the_collapses() {
        let cloud = Cloud {
            intercept: 0.0,
            slope: 1.0,
            deviation: 0.4,
            determination: 0.9,
            n: 40,
            collapsed: 8,
            collapse: Some([-1.0, 2.0]),
        };
        let (free, total) = (cloud.curve(1.0).unwrap(), cloud.total(1.0).unwrap());
        assert!(total.median < free.median);
        let at = |im: f64| {
            let c = cloud.collapse_probability(im).unwrap();
            free.probability(im) * (1.0 - c) + c
        };
        assert!((at(total.median) - 0.5).abs() < 1e-9);
        let searched = |p: f64| (0..400_000).map(|k| 0.01 + 1e-5 * f64::from(k)).find(|&im| at(im) >= p).unwrap();
        let wanted = 0.5 * (searched(ONE_DEVIATION) / searched(1.0 - ONE_DEVIATION)).ln();
        assert!((total.dispersion - wanted).abs() < 1e-3);
        let none = Cloud { collapsed: 0, collapse: None, ..cloud };
        assert_eq!(none.total(1.0).unwrap(), free);
        let open = Cloud { collapse: None, ..cloud };
        assert!(open.total(1.0).unwrap_err().reason.contains("8 runs collapsed"));
    }

    #[test]
    fn refusals() {
        let run = |im: f64, demand: f64| Run { im, demand: Some(demand) };
        let falling: Vec<Run> = (1..=9).map(|k| run(f64::from(k), 1.0 / f64::from(k))).collect();
        assert!(fit(&falling).unwrap_err().reason.contains("grow"));
        assert!(fit(&falling[..7]).unwrap_err().reason.contains("fewer"));
        assert!(fit(&[run(1.0, 1.0); 9]).unwrap_err().reason.contains("equal"));
    }
}
