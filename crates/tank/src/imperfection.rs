//! Imperfections of a cylindrical wall: its radius deviates from R by w(θ, z), outwards positive.
//!
//! ```text
//! w = Σ a_i f_i(z) cos n_i (θ − φ_i) + Σ table          constant  f = 1        linear  f = z/L        sine_k  f = sin kπz/L
//! ```
//!
//! θ from the direction of shaking, z from the base, L the height of the wall. Between the given places of a table or of a
//! profile w is a cubic with the slopes of the parabola through three neighbours (periodic along θ): continuous with its slope, and
//! exact where w is linear.

use std::f64::consts::{PI, TAU};

use serde::{Deserialize, Serialize};

/// Largest relative difference of w(θ) and w(−θ) that counts as rounding.
const ROUNDING: f64 = 1e-9;
/// Places over the height, and around, at which a deviation is searched for its largest value.
const SEARCHED: [usize; 2] = [200, 720];
/// A harmonic of a table counts from this share of its largest deviation on.
const COUNTS: f64 = 0.02;

/// What is out of round.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Imperfections {
    /// Parts, which are added; none for a perfect wall.
    pub parts: Vec<Imperfection>,
}

/// A part of the deviation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Imperfection {
    /// One wave around the tank.
    Wave(Wave),
    /// A measured shape.
    Table(Table),
}

/// a f(z) cos n(θ − φ).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wave {
    /// Number of waves around the tank n.
    pub n: u32,
    /// a [m], outwards positive.
    pub amplitude: f64,
    /// f.
    pub profile: Profile,
    /// φ [rad].
    pub phase: f64,
}

/// A shape over the height.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Profile {
    /// 1.
    Constant,
    /// z/L.
    Linear,
    /// sin kπz/L.
    Sine(u32),
    /// Heights [m], ascending, and factors; constant beyond the ends.
    Points(Vec<[f64; 2]>),
}

/// A deviation on a grid of angles and heights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Angles [rad], ascending from 0 to below 2π; three or more.
    pub theta: Vec<f64>,
    /// Heights [m], ascending; constant beyond the ends.
    pub z: Vec<f64>,
    /// `w[height][angle]` [m].
    pub w: Vec<Vec<f64>>,
}

/// A deviation and its slopes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// w [m].
    pub w: f64,
    /// ∂w/∂θ [m].
    pub along_theta: f64,
    /// ∂w/∂z.
    pub along_z: f64,
}

impl Profile {
    /// f and its slope [1/m] at the height `z` of a wall `height` [m] tall.
    pub fn at(&self, z: f64, height: f64) -> [f64; 2] {
        match self {
            Profile::Constant => [1.0, 0.0],
            Profile::Linear => [z / height, 1.0 / height],
            Profile::Sine(k) => {
                let wave = f64::from(*k) * PI / height;
                let (s, c) = (wave * z).sin_cos();
                [s, wave * c]
            }
            Profile::Points(points) => {
                let x: Vec<f64> = points.iter().map(|p| p[0]).collect();
                cubic(&x, &|i| points[i][1], z, None)
            }
        }
    }
}

impl Table {
    fn at(&self, theta: f64, z: f64) -> Deviation {
        let along: Vec<[f64; 2]> = self.w.iter().map(|w| cubic(&self.theta, &|i| w[i], theta, Some(TAU))).collect();
        let [w, along_z] = cubic(&self.z, &|i| along[i][0], z, None);
        let [along_theta, _] = cubic(&self.z, &|i| along[i][1], z, None);
        Deviation { w, along_theta, along_z }
    }
}

/// Value and slope of the cubic through (x_i, y_i) at `at`; constant beyond the ends unless it has a `period`.
fn cubic(x: &[f64], y: &dyn Fn(usize) -> f64, at: f64, period: Option<f64>) -> [f64; 2] {
    let n = x.len();
    if n == 1 {
        return [y(0), 0.0];
    }
    // Place and value of a point by its number, which goes on beyond the ends of a period.
    let point = |i: isize| -> [f64; 2] {
        let turns = i.div_euclid(n as isize) as f64;
        let k = i.rem_euclid(n as isize) as usize;
        [x[k] + turns * period.unwrap_or(0.0), y(k)]
    };
    let at = match period {
        Some(p) => x[0] + (at - x[0]).rem_euclid(p),
        None if at <= x[0] => return [y(0), 0.0],
        None if at >= x[n - 1] => return [y(n - 1), 0.0],
        None => at,
    };
    let low = x.partition_point(|v| *v <= at).clamp(1, n) - 1;
    let low = (if period.is_none() { low.min(n - 2) } else { low }) as isize;
    let secant = |i: isize| {
        let ([x0, y0], [x1, y1]) = (point(i), point(i + 1));
        ((y1 - y0) / (x1 - x0), x1 - x0)
    };
    // Slope of the parabola through three neighbours, at an end of the line through the two that are there.
    let slope = |i: isize| match (period, i) {
        (None, 0) => secant(0).0,
        (None, i) if i as usize == n - 1 => secant(i - 1).0,
        _ => {
            let ((before, a), (after, b)) = (secant(i - 1), secant(i));
            (before * b + after * a) / (a + b)
        }
    };
    let ([x0, y0], [x1, y1]) = (point(low), point(low + 1));
    let h = x1 - x0;
    let (s, m0, m1) = ((at - x0) / h, slope(low) * h, slope(low + 1) * h);
    let (s2, s3) = (s * s, s * s * s);
    let value =
        y0 * (2.0 * s3 - 3.0 * s2 + 1.0) + m0 * (s3 - 2.0 * s2 + s) + y1 * (3.0 * s2 - 2.0 * s3) + m1 * (s3 - s2);
    let derivative = (y1 - y0) * (6.0 * s - 6.0 * s2) + m0 * (3.0 * s2 - 4.0 * s + 1.0) + m1 * (3.0 * s2 - 2.0 * s);
    [value, derivative / h]
}

impl Imperfections {
    /// None.
    pub const NONE: Imperfections = Imperfections { parts: Vec::new() };

    /// Whether the wall is perfect: there is no part, or none of them deviates.
    pub fn is_empty(&self) -> bool {
        self.parts.iter().all(|part| match part {
            Imperfection::Wave(wave) => wave.amplitude == 0.0,
            Imperfection::Table(table) => table.w.iter().flatten().all(|w| *w == 0.0),
        })
    }

    /// The deviation at an angle [rad] and a height [m] of a wall `height` [m] tall.
    pub fn at(&self, theta: f64, z: f64, height: f64) -> Deviation {
        self.parts.iter().fold(Deviation::default(), |sum, part| {
            let own = match part {
                Imperfection::Wave(wave) => {
                    let [f, slope] = wave.profile.at(z, height);
                    let n = f64::from(wave.n);
                    let (s, c) = (n * (theta - wave.phase)).sin_cos();
                    Deviation {
                        w: wave.amplitude * f * c,
                        along_theta: -n * wave.amplitude * f * s,
                        along_z: wave.amplitude * slope * c,
                    }
                }
                Imperfection::Table(table) => table.at(theta, z),
            };
            Deviation {
                w: sum.w + own.w,
                along_theta: sum.along_theta + own.along_theta,
                along_z: sum.along_z + own.along_z,
            }
        })
    }

    /// Whether it is its own mirror image in the plane θ = 0, π.
    pub fn is_symmetric(&self, height: f64) -> bool {
        let largest = self.largest(height).0;
        let [levels, around] = SEARCHED;
        (0..=levels / 10).all(|l| {
            let z = height * l as f64 * 10.0 / levels as f64;
            (1..around / 2).all(|k| {
                let theta = TAU * k as f64 / around as f64;
                let difference = self.at(theta, z, height).w - self.at(-theta, z, height).w;
                difference.abs() <= ROUNDING * largest
            })
        })
    }

    /// Largest |w| [m], with its angle [rad] and height [m].
    pub fn largest(&self, height: f64) -> (f64, f64, f64) {
        let [levels, around] = SEARCHED;
        let mut found = (0.0_f64, 0.0, 0.0);
        for l in 0..=levels {
            let z = height * l as f64 / levels as f64;
            for k in 0..around {
                let theta = TAU * k as f64 / around as f64;
                let w = self.at(theta, z, height).w.abs();
                if w > found.0 {
                    found = (w, theta, z);
                }
            }
        }
        found
    }

    /// Fourier coefficients of the deviation at a height: of cos nθ and of sin nθ for n = 0 … `most` [m].
    pub fn harmonics(&self, z: f64, height: f64, most: u32) -> Vec<[f64; 2]> {
        let count = (4 * most as usize + 4).max(128);
        let values: Vec<f64> = (0..count).map(|k| self.at(TAU * k as f64 / count as f64, z, height).w).collect();
        (0..=most)
            .map(|n| {
                let factor = if n == 0 { 1.0 } else { 2.0 } / count as f64;
                values.iter().enumerate().fold([0.0, 0.0], |[c, s], (k, w)| {
                    let (sine, cosine) = (TAU * f64::from(n) * k as f64 / count as f64).sin_cos();
                    [c + factor * w * cosine, s + factor * w * sine]
                })
            })
            .collect()
    }

    /// The wave numbers it has, ascending; those of a table from 2 % of its largest deviation on.
    pub fn waves(&self, height: f64) -> Vec<u32> {
        let mut all = Vec::new();
        for part in &self.parts {
            match part {
                Imperfection::Wave(wave) if wave.amplitude != 0.0 => all.push(wave.n),
                Imperfection::Wave(_) => {}
                Imperfection::Table(table) => {
                    let alone = Imperfections { parts: vec![part.clone()] };
                    let most = (table.theta.len() / 2) as u32;
                    let least = COUNTS * alone.largest(height).0;
                    for &z in &table.z {
                        let found = alone.harmonics(z, height, most);
                        let counting = found.iter().enumerate().filter(|(_, [c, s])| c.hypot(*s) > least);
                        all.extend(counting.map(|(n, _)| n as u32));
                    }
                }
            }
        }
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Half waves over the height of its most wavy part.
    pub fn half_waves(&self) -> u32 {
        let waves = self.parts.iter().map(|part| match part {
            Imperfection::Wave(wave) => match &wave.profile {
                Profile::Constant | Profile::Linear => 1,
                Profile::Sine(k) => *k,
                Profile::Points(points) => points.len() as u32 / 2,
            },
            Imperfection::Table(table) => table.z.len() as u32 / 2,
        });
        waves.max().unwrap_or(0).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(n: u32, profile: Profile, phase: f64) -> Imperfections {
        Imperfections { parts: vec![Imperfection::Wave(Wave { n, amplitude: 0.01, profile, phase })] }
    }

    /// A table sampled from cos 3(θ − 0.2) z: exact along z, where it is linear, and to the fourth order along θ.
    fn sampled(count: usize) -> Imperfections {
        let theta: Vec<f64> = (0..count).map(|k| TAU * k as f64 / count as f64).collect();
        let z = vec![0.0, 1.0, 3.0, 4.0];
        let w = z.iter().map(|z| theta.iter().map(|t| 0.01 * z / 4.0 * (3.0 * (t - 0.2)).cos()).collect()).collect();
        Imperfections { parts: vec![Imperfection::Table(Table { theta, z, w })] }
    }

    #[test]
    fn slopes_are_derivatives() {
        let points = Profile::Points(vec![[0.0, 0.0], [1.0, 0.4], [2.5, 1.0], [4.0, -0.3]]);
        for own in [wave(3, Profile::Linear, 0.3), wave(5, Profile::Sine(2), 0.0), wave(2, points, 1.0), sampled(48)] {
            for (theta, z) in [(0.1, 0.6), (2.0, 1.7), (5.9, 3.3)] {
                let (d, h) = (own.at(theta, z, 4.0), 1e-6);
                let along =
                    |t: f64, v: f64| (own.at(theta + t, z + v, 4.0).w - own.at(theta - t, z - v, 4.0).w) / (2.0 * h);
                assert!((along(h, 0.0) - d.along_theta).abs() < 1e-8, "{own:?}");
                assert!((along(0.0, h) - d.along_z).abs() < 1e-8, "{own:?}");
            }
        }
    }

    /// Slopes by the parabola through three points miss h² w‴/6, the cubic with them about a quarter of h times that:
    /// 0.25 · 0.13 · 0.13² · 27/6 = 0.25 % of the amplitude with 48 angles.
    #[test]
    fn a_table_is_the_wave_it_was_sampled_from() {
        let (exact, table) = (wave(3, Profile::Linear, 0.2), sampled(48));
        for (theta, z) in [(0.07, 0.5), (3.3, 2.2), (6.25, 3.9)] {
            let (a, b) = (exact.at(theta, z, 4.0), table.at(theta, z, 4.0));
            assert!((a.w - b.w).abs() < 3e-5, "{a:?} {b:?}");
            assert!((a.along_z - b.along_z).abs() < 1e-5);
        }
        assert_eq!(table.waves(4.0), vec![3]);
        let [c, s] = table.harmonics(4.0, 4.0, 6)[3];
        assert!((c.hypot(s) - 0.01).abs() < 3e-5 && (s.atan2(c) - 0.6).abs() < 1e-3);
    }

    #[test]
    fn symmetry_about_the_plane_of_shaking() {
        assert!(wave(5, Profile::Constant, 0.0).is_symmetric(4.0));
        assert!(wave(5, Profile::Constant, PI / 5.0).is_symmetric(4.0));
        assert!(!wave(5, Profile::Constant, 0.1).is_symmetric(4.0));
        assert!(!sampled(48).is_symmetric(4.0));
    }

    #[test]
    fn nothing_deviates_with_an_amplitude_of_zero() {
        let mut none = wave(4, Profile::Constant, 0.0);
        if let Imperfection::Wave(wave) = &mut none.parts[0] {
            wave.amplitude = 0.0;
        }
        assert!(none.is_empty() && Imperfections::NONE.is_empty() && none.waves(1.0).is_empty());
        let found = wave(4, Profile::Sine(1), 0.0).largest(2.0);
        assert_eq!((found.0, found.2), (0.01, 1.0));
    }
}
