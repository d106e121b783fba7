//! `sample`: sampled parameters.
//!
//! ```text
//! u_ij    Owen-scrambled Sobol sequence, sample i, dimension j (Burley 2020); its start does not depend on the number of samples
//! x       low + u (high − low);     μ (1 + V Φ⁻¹(u));     θ exp(β Φ⁻¹(u))
//! ```

use super::keys;
use crate::input::tank::read::{Field, Opt};
use crate::input::tank::resolver::{Resolver, range_fault};

/// A distribution; values in the unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Between two values.
    Uniform([f64; 2]),
    /// Mean and standard deviation.
    Normal([f64; 2]),
    /// Median and standard deviation of the logarithm.
    Lognormal([f64; 2]),
}

/// A sampled value of the tank file.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// Path of the tank file.
    pub path: String,
    /// Its distribution.
    pub distribution: Distribution,
    /// Unit of its values, as written; empty for a bare number.
    pub unit: String,
}

/// The sampling of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    /// Number of samples.
    pub n: u32,
    /// Seed.
    pub seed: u32,
    /// Parameters, one dimension each.
    pub parameters: Vec<Sampled>,
}

impl Sampling {
    /// Path and text of every parameter of a sample.
    pub fn draw(&self, sample: u32) -> Vec<(String, String)> {
        let value = |(dimension, parameter): (usize, &Sampled)| {
            let u = sobol_burley::sample(sample, dimension as u32, self.seed);
            // In the middle of the cell of a single-precision number: neither 0 nor 1.
            let x = parameter
                .distribution
                .quantile(f64::from(u) + f64::from(f32::EPSILON) / 4.0);
            let text = format!("{x:.9e} {}", parameter.unit);
            (parameter.path.clone(), text.trim_end().to_owned())
        };
        self.parameters.iter().enumerate().map(value).collect()
    }
}

impl Distribution {
    /// The value below which a share `u` of the probability lies, 0 < u < 1.
    pub fn quantile(self, u: f64) -> f64 {
        let normal = || fragility::normal::quantile(u);
        match self {
            Distribution::Uniform([low, high]) => low + u * (high - low),
            Distribution::Normal([mean, deviation]) => mean + deviation * normal(),
            Distribution::Lognormal([median, beta]) => median * (beta * normal()).exp(),
        }
    }
}

/// The sampling of the file; the outer option is none if it is faulty.
pub(super) fn sampling(r: &mut Resolver<'_>, option: &Opt<keys::Sample>) -> Option<Option<Sampling>> {
    let Some(field) = &option.given else { return Some(None) };
    let given = field.value.as_ref()?;
    let n = r.count(&given.n);
    let seed = r.count_or_default(&given.seed);
    r.sized(&given.parameters, "parameters");
    let mut parameters = Vec::new();
    for item in given.parameters.value.iter().flatten() {
        if let Some(parameter) = item.value.as_ref() {
            parameters.extend(sampled(r, item, parameter));
        }
    }
    Some(Some(Sampling {
        n: n?,
        seed,
        parameters,
    }))
}

fn sampled(r: &mut Resolver<'_>, item: &Field<keys::Parameter>, given: &keys::Parameter) -> Option<Sampled> {
    let path = r.text(&given.path)?;
    let (distribution, unit) = match (given.uniform.value(), given.normal.value(), given.lognormal.value()) {
        (Some(range), None, None) => {
            let (low, unit) = measured(r, &range.low)?;
            let (high, other) = measured(r, &range.high)?;
            if other != unit || high <= low {
                let fault = range_fault(&range.high, "a faulty range", &format!("more than `low`, in {unit}"));
                r.faults.push(fault);
            }
            (Distribution::Uniform([low, high]), unit)
        }
        (None, Some(normal), None) => {
            let (mean, unit) = measured(r, &normal.mean)?;
            let cov = r.number(&normal.cov);
            (Distribution::Normal([mean, cov * mean.abs()]), unit)
        }
        (None, None, Some(lognormal)) => {
            let (median, unit) = measured(r, &lognormal.median)?;
            if median <= 0.0 {
                r.faults.push(range_fault(
                    &lognormal.median,
                    "a median of 0 or less",
                    "a median greater than 0",
                ));
            }
            (Distribution::Lognormal([median, r.number(&lognormal.beta)]), unit)
        }
        _ => {
            let fault = range_fault(
                item,
                "a parameter needs one distribution",
                "one of uniform, normal, lognormal",
            );
            r.faults.push(fault.found("{ … }"));
            return None;
        }
    };
    Some(Sampled {
        path,
        distribution,
        unit,
    })
}

/// Number and unit of a text.
fn measured(r: &mut Resolver<'_>, field: &Field<String>) -> Option<(f64, String)> {
    let text = r.text(field)?;
    let text = text.trim();
    let end = text
        .char_indices()
        .take_while(|(i, c)| {
            let after_exponent = text[..*i].ends_with(['e', 'E']);
            c.is_ascii_digit()
                || *c == '.'
                || (matches!(c, '+' | '-') && (*i == 0 || after_exponent))
                || (matches!(c, 'e' | 'E')
                    && text[i + 1..].starts_with(|n: char| n.is_ascii_digit() || n == '-' || n == '+'))
        })
        .map(|(i, c)| i + c.len_utf8())
        .last()
        .unwrap_or(0);
    match text[..end].parse::<f64>() {
        Ok(number) if number.is_finite() => Some((number, text[end..].trim().to_owned())),
        _ => {
            r.faults.push(range_fault(
                field,
                "not a number with its unit",
                "a value such as \"8 m\"",
            ));
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampling(n: u32) -> Sampling {
        let parameter = |path: &str, distribution, unit: &str| Sampled {
            path: path.into(),
            distribution,
            unit: unit.into(),
        };
        Sampling {
            n,
            seed: 7,
            parameters: vec![
                parameter("liquid.fill_height", Distribution::Uniform([8.0, 14.0]), "m"),
                parameter(
                    "materials.a.yield_strength",
                    Distribution::Lognormal([250.0, 0.07]),
                    "MPa",
                ),
            ],
        }
    }

    fn number(text: &str) -> f64 {
        text.split(' ').next().unwrap().parse().unwrap()
    }

    /// 2⁸ points of a scrambled Sobol sequence: one in each of 256 strata of a dimension, so the mean of the uniform one is that of the
    /// distribution within (high − low)/256.
    #[test]
    fn a_net_fills_the_strata() {
        let all = sampling(256);
        let heights: Vec<f64> = (0..256).map(|i| number(&all.draw(i)[0].1)).collect();
        let mut strata: Vec<usize> = heights.iter().map(|h| ((h - 8.0) / 6.0 * 256.0) as usize).collect();
        strata.sort_unstable();
        assert_eq!(strata, (0..256).collect::<Vec<_>>());
        let mean = heights.iter().sum::<f64>() / 256.0;
        assert!((mean - 11.0).abs() < 6.0 / 256.0);
        assert!(all.draw(0)[0].1.ends_with(" m"));
    }

    /// Quantiles of the standard normal (Abramowitz & Stegun table 26.5): 0.975 at 1.959964, 0.8413447 at 1.
    #[test]
    fn quantiles() {
        let normal = Distribution::Normal([0.0, 1.0]);
        assert!((normal.quantile(0.975) - 1.959_963_985).abs() < 1e-8);
        assert!((normal.quantile(0.841_344_746_068_543) - 1.0).abs() < 1e-9);
        let lognormal = Distribution::Lognormal([250.0, 0.07]);
        assert!((lognormal.quantile(0.5) - 250.0).abs() < 1e-9);
        assert!((lognormal.quantile(0.841_344_746_068_543) / 250.0 - 0.07_f64.exp()).abs() < 1e-9);
    }

    #[test]
    fn a_sample_does_not_depend_on_their_number() {
        assert_eq!(sampling(4).draw(3), sampling(400).draw(3));
    }
}
