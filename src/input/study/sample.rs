//! `sample`: sampled parameters.
//!
//! ```text
//! u_ij    sobol: Owen-scrambled Sobol sequence, sample i, dimension j (Burley 2020)
//!         latin: first dimension of that sequence at π_j(i); π_j permutes every octave 2^k ≤ i < 2^(k+1) at random, for each dimension anew
//! x       low + u (high − low);     μ (1 + V Φ⁻¹(u));     θ exp(β Φ⁻¹(u));     reference · quantile of the beta distribution
//! ```
//!
//! Sample i does not depend on the number of samples. The first 2^k points of one dimension lie in 2^k equal parts, and so does every octave in the parts
//! that are left: of the first 2^k samples each parameter has one in each part, a Latin hypercube that grows (Qian 2009).

use std::ops::Range;

use files::code::Code;
use fragility::beta::Beta;
use fragility::draw::Draw;

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
    /// A reference value times a share.
    Beta(f64, Beta),
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
    /// Its place in the study file [bytes].
    pub place: Range<usize>,
}

/// The sampling of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    /// Number of samples.
    pub n: u32,
    /// Seed.
    pub seed: u32,
    /// Whether they are a Latin hypercube, not a Sobol sequence.
    pub latin: bool,
    /// Parameters, one dimension each.
    pub parameters: Vec<Sampled>,
}

impl Sampling {
    /// Text of every parameter of a sample.
    pub fn draw(&self, sample: u32) -> Vec<(&Sampled, String)> {
        let text = |dimension: u32, parameter: &Sampled| {
            let u = match self.latin {
                // Seeds of the dimensions differ, so that their scrambles do.
                true => sobol_burley::sample(shuffled(sample, dimension, self.seed), 0, mixed(dimension, self.seed)),
                false => sobol_burley::sample(sample, dimension, self.seed),
            };
            // In the middle of the cell of a single-precision number: neither 0 nor 1.
            let x = parameter.distribution.quantile(f64::from(u) + f64::from(f32::EPSILON) / 4.0);
            format!("{x:.9e} {}", parameter.unit).trim_end().to_owned()
        };
        let all = (0..).zip(&self.parameters);
        all.map(|(dimension, parameter)| (parameter, text(dimension, parameter))).collect()
    }
}

/// A seed of a dimension.
fn mixed(dimension: u32, seed: u32) -> u32 {
    let mut draw = Draw::new((u64::from(seed) << 32) | u64::from(dimension));
    let mut half = || draw.below(1 << 16) as u32;
    (half() << 16) | half()
}

/// A place of a sample of a dimension: within its octave at random.
fn shuffled(sample: u32, dimension: u32, seed: u32) -> u32 {
    let octave = sample.checked_ilog2().map_or(0, |k| 1_u32 << k);
    if octave < 2 {
        return sample;
    }
    let mask = octave - 1;
    let mut draw = Draw::new((u64::from(seed) << 32) | (u64::from(dimension) << 20) | u64::from(octave.ilog2() + 1));
    let mut place = sample & mask;
    // Each step is a permutation of the numbers below the octave: a sum, an odd factor, and a shift of the upper bits onto the lower ones.
    let half = octave.ilog2().div_ceil(2);
    for _ in 0..4 {
        let (sum, factor) = (draw.below(1 << 16) as u32, draw.below(1 << 16) as u32 | 1);
        place = place.wrapping_add(sum) & mask;
        place = place.wrapping_mul(factor) & mask;
        place ^= place >> half;
    }
    octave | place
}

impl Distribution {
    /// The value below which a share `u` of the probability lies, 0 < u < 1.
    pub fn quantile(self, u: f64) -> f64 {
        let normal = || fragility::normal::quantile(u);
        match self {
            Distribution::Uniform([low, high]) => low + u * (high - low),
            Distribution::Normal([mean, deviation]) => mean + deviation * normal(),
            Distribution::Lognormal([median, beta]) => median * (beta * normal()).exp(),
            Distribution::Beta(of, beta) => of * beta.quantile(u),
        }
    }
}

/// The sampling of the file; the outer option is none if it is faulty.
pub(super) fn sampling(r: &mut Resolver<'_>, option: &Opt<keys::Sample>) -> Option<Option<Sampling>> {
    let Some(field) = &option.given else { return Some(None) };
    let given = field.value.as_ref()?;
    let n = r.count(&given.n);
    let seed = r.or_default(&given.seed);
    let method = r.or_default(&given.method);
    r.sized(&given.parameters, "parameters");
    let mut parameters = Vec::new();
    for item in given.parameters.value.iter().flatten() {
        let Some(parameter) = item.value.as_ref() else { continue };
        let Some(found) = sampled(r, item, parameter) else { continue };
        if parameters.iter().any(|other: &Sampled| other.path == found.path) {
            let message = "a parameter that is sampled twice";
            let allowed = "each path once";
            r.refuse(Code::Repeated, &parameter.path, message, allowed);
        }
        parameters.push(found);
    }
    Some(Some(Sampling { n: n?, seed, latin: method == keys::SampleMethod::Latin, parameters }))
}

fn sampled(r: &mut Resolver<'_>, item: &Field<keys::Parameter>, given: &keys::Parameter) -> Option<Sampled> {
    let path = r.text(&given.path)?;
    let all = (given.uniform.value(), given.normal.value(), given.lognormal.value(), given.beta.value());
    let (distribution, unit) = match all {
        (Some(range), None, None, None) => {
            let (low, unit) = measured(r, &range.low)?;
            let (high, other) = measured(r, &range.high)?;
            if other != unit || high <= low {
                let message = "a faulty range";
                let allowed = format!("more than `low`, in {unit}");
                r.refuse(Code::Contradiction, &range.high, message, &allowed);
            }
            (Distribution::Uniform([low, high]), unit)
        }
        (None, Some(normal), None, None) => {
            let (mean, unit) = measured(r, &normal.mean)?;
            let cov = r.number(&normal.cov);
            (Distribution::Normal([mean, cov * mean.abs()]), unit)
        }
        (None, None, Some(lognormal), None) => {
            let (median, unit) = measured(r, &lognormal.median)?;
            if median <= 0.0 {
                let message = "a median of 0 or less";
                r.refuse(Code::OutOfRange, &lognormal.median, message, "a median greater than 0");
            }
            (Distribution::Lognormal([median, r.number(&lognormal.beta)]), unit)
        }
        (None, None, None, Some(beta)) => shares(r, beta)?,
        _ => {
            let message = "a parameter needs one distribution";
            let allowed = "one of uniform, normal, lognormal, beta";
            let fault = range_fault(Code::Incomplete, item, message, allowed);
            r.faults.push(fault.found("{ … }"));
            return None;
        }
    };
    Some(Sampled { path, distribution, unit, place: given.path.span.clone() })
}

/// A reference value times a share of a beta distribution, and the unit.
fn shares(r: &mut Resolver<'_>, given: &keys::Beta) -> Option<(Distribution, String)> {
    let (of, unit) = measured(r, &given.of)?;
    let (mean, cov) = (r.number(&given.mean), r.number(&given.cov));
    let bounds = [r.or_default(&given.min), r.or_default(&given.max)];
    match Beta::new(bounds, mean, cov * mean.abs()) {
        Some(beta) => Some((Distribution::Beta(of, beta), unit)),
        None => {
            let allowed = format!(
                "a mean between {} and {}, and a deviation below that of its ends, √((mean − min)(max − mean))",
                bounds[0], bounds[1]
            );
            let message = "no beta distribution has this mean and deviation";
            r.refuse(Code::Contradiction, &given.mean, message, &allowed);
            None
        }
    }
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
            let message = "not a number with its unit";
            r.refuse(Code::BadForm, field, message, "a value such as \"8 m\"");
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
            place: 0..0,
        };
        Sampling {
            n,
            seed: 7,
            latin: false,
            parameters: vec![
                parameter("liquid.fill_height", Distribution::Uniform([8.0, 14.0]), "m"),
                parameter("materials.a.yield_strength", Distribution::Lognormal([250.0, 0.07]), "MPa"),
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

    /// Each parameter has one of the first 2^k samples in each of 2^k parts; the pairing of two parameters is at random: the correlation of 256 ranks has
    /// the standard deviation 1/16, and stays within four of them for every seed tried.
    #[test]
    fn a_latin_hypercube_that_grows() {
        for seed in 0..8 {
            let all = Sampling { seed, latin: true, ..sampling(256) };
            let share = |i: u32| (number(&all.draw(i)[0].1) - 8.0) / 6.0;
            for k in 0..=8 {
                let n = 1_u32 << k;
                let mut strata: Vec<u32> = (0..n).map(|i| (share(i) * f64::from(n)) as u32).collect();
                strata.sort_unstable();
                assert_eq!(strata, (0..n).collect::<Vec<_>>(), "{n} samples, seed {seed}");
            }
            let strength = |i: u32| (number(&all.draw(i)[1].1) / 250.0).ln() / 0.07;
            let heights: Vec<f64> = (0..256).map(|i| (share(i) - 0.5) * 12.0_f64.sqrt()).collect();
            let product: f64 = (0..256).map(|i| heights[i as usize] * strength(i)).sum();
            assert!((product / 256.0).abs() < 0.25, "{product} with the seed {seed}");
        }
        let sobol = sampling(256);
        let latin = Sampling { latin: true, ..sampling(256) };
        assert_ne!(latin.draw(5), sobol.draw(5));
        assert_eq!(latin.draw(5), Sampling { n: 9, ..latin.clone() }.draw(5));
    }

    /// I_x(2, 3) of a half is 0.6875, and its mean and coefficient of variation are 0.4 and 0.5: the quantile of 0.6875 is half of the reference.
    #[test]
    fn shares_of_a_reference() {
        let beta = Beta::new([0.0, 1.0], 0.4, 0.2).unwrap();
        assert!((Distribution::Beta(15.0, beta).quantile(0.6875) - 7.5).abs() < 1e-8);
    }
}
