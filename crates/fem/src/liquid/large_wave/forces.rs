//! Pressures on wall and floor, and their resultants.

use super::basis::{LANES, Place, Shape, Side};
use super::expansion::Liquid;
use super::quadrature::gauss_legendre;
use super::run::{Frame, product};
use std::f64::consts::{PI, TAU};

/// Quadrature points over the depth.
const LEVELS: usize = 16;

/// A point of the liquid whose pressure is observed.
#[derive(Clone, Debug)]
pub struct Probe {
    place: Place,
    z: f64,
    values: [Vec<f64>; 3],
    height: Vec<[f64; 2]>,
}

/// Resultants of the pressures on a tank at an instant. Of a rotation only the shear from momentum is whole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forces {
    /// Force on the wall along x and y, from the momentum of the liquid [N].
    pub shear: [f64; 2],
    /// The same from the pressures on the wall [N], a check.
    pub pressure_shear: [f64; 2],
    /// Moment of the pressures on the wall about the floor, positive with a force along the direction [N m].
    pub wall_moment: [f64; 2],
    /// The same with the pressures on the floor [N m].
    pub moment: [f64; 2],
}

/// Lines of the wall and levels on them: what the resultants need of a tank.
#[derive(Clone, Debug)]
pub(super) struct Wall {
    lines: Vec<Line>,
    /// z, weight, and Z_j and Z_j′ of each mode, at the levels.
    z: [f64; LEVELS],
    weight: [f64; LEVELS],
    heights: Vec<[[f64; LEVELS]; 2]>,
    /// 1/cosh k_j H.
    floor: Vec<f64>,
}

#[derive(Clone, Debug)]
struct Line {
    place: Place,
    normal: Place,
    /// Length along the circumference [m].
    length: f64,
    value: Vec<f64>,
    along: Vec<f64>,
}

impl Liquid {
    /// Z_j and Z_j′ of each mode at a height: exact below the level at rest, the expansion's terms above it.
    fn height(&self, z: f64) -> Vec<[f64; 2]> {
        (0..self.tanh.len()).map(|j| self.height_of(j, z)).collect()
    }

    fn height_of(&self, j: usize, z: f64) -> [f64; 2] {
        let k = self.basis.modes()[j].wave_number;
        let t = self.tanh[j];
        let s = k * z;
        if z > 0.0 {
            return [1.0 + s * (t + s * (0.5 + s * t / 6.0)), k * (t + s * (1.0 + 0.5 * s * t))];
        }
        // cosh k(z+H)/cosh kH without the overflow of deep liquids.
        let (up, down) = (s.exp(), (-s - 2.0 * k * self.own.depth).exp());
        let base = 1.0 + (-2.0 * k * self.own.depth).exp();
        [(up + down) / base, k * (up - down) / base]
    }

    pub(super) fn wall(&self) -> Wall {
        let both = self.basis.modes().iter().any(|m| m.sine);
        let side = if both { Side::Both } else { Side::Cosine };
        let n = self.tanh.len();
        let line = |place: Place, normal: Place, length: f64| {
            let at: Vec<[f64; 3]> = (0..n).map(|j| self.basis.at(j, place)).collect();
            let along = at.iter().map(|v| v[2]).collect();
            Line { place, normal, length, value: at.iter().map(|v| v[0]).collect(), along }
        };
        let lines = match self.basis.shape() {
            Shape::Strip { length, width } => {
                [1.0, -1.0].map(|sign| line([0.5 * sign * length, 0.0], [sign, 0.0], width)).into()
            }
            Shape::Cylinder { radius } => {
                let (count, span) = if side == Side::Cosine { (12, PI) } else { (24, TAU) };
                (0..count)
                    .map(|i| {
                        let (sin, cos) = (span * (f64::from(i) + 0.5) / f64::from(count)).sin_cos();
                        // The other half cancels the force across.
                        let across = if side == Side::Cosine { 0.0 } else { sin };
                        line([radius * cos, radius * sin], [cos, across], TAU * radius / f64::from(count))
                    })
                    .collect()
            }
        };
        let half = 0.5 * self.own.depth;
        let (mut z, mut weight) = ([0.0; LEVELS], [0.0; LEVELS]);
        for (l, (x, w)) in gauss_legendre(LEVELS).into_iter().enumerate() {
            (z[l], weight[l]) = (half * (x - 1.0), half * w);
        }
        let heights = (0..n)
            .map(|j| {
                let at = z.map(|z| self.height_of(j, z));
                [at.map(|[value, _]| value), at.map(|[_, slope]| slope)]
            })
            .collect();
        let floor = self.height(-self.own.depth).iter().map(|h| h[0]).collect();
        Wall { lines, z, weight, heights, floor }
    }

    /// Part of the pressure over density that the motion has at a place and height, without the potential of waves [m²/s²].
    fn carried(&self, frame: &Frame, place: Place, z: f64, values: &[f64]) -> f64 {
        let mut sum = 0.0;
        for d in 0..2 {
            let tilt = self.own.gravity * frame.motion.tilt[d];
            sum += (frame.motion.acceleration[d] - tilt) * place[d];
            let angular = frame.motion.angular[d];
            if angular != 0.0 {
                sum += angular * place[d] * (z + self.own.depth);
                for j in 1..values.len() {
                    let k = self.basis.modes()[j].wave_number;
                    let half = 0.5 * self.own.depth;
                    let share = self.basis.lever[d][j] / self.basis.norm[j];
                    sum -= angular * share * values[j] * 2.0 * (k * (z + half)).sinh() / (k * (k * half).cosh());
                }
            }
        }
        sum
    }

    /// A point whose pressure is observed; z from −H, 0 at the level at rest [m].
    pub fn probe(&self, place: Place, z: f64) -> Probe {
        let at: Vec<[f64; 3]> = (0..self.tanh.len()).map(|j| self.basis.at(j, place)).collect();
        let part = |i: usize| at.iter().map(|v| v[i]).collect();
        Probe { place, z, values: [part(0), part(1), part(2)], height: self.height(z) }
    }

    /// Resultants at each instant.
    pub fn forces<'a>(&self, frames: impl Iterator<Item = Frame<'a>>) -> Vec<Forces> {
        let wall = self.wall();
        let arch = pulp::Arch::new();
        frames.map(|frame| arch.dispatch(Resultants { liquid: self, wall: &wall, frame: &frame })).collect()
    }

    #[inline(always)]
    fn resultants(&self, wall: &Wall, frame: &Frame) -> Forces {
        let own = self.own;
        let n = self.tanh.len();
        let mut out = Forces::default();
        for d in 0..2 {
            let rigid = frame.motion.acceleration[d] + 0.5 * own.depth * frame.motion.angular[d]
                - own.gravity * frame.motion.tilt[d];
            out.shear[d] = -self.mass() * rigid - own.density * product(&self.basis.lever[d], frame.second);
        }
        let gravity = own.gravity + frame.motion.vertical;
        let (mut rate, mut along, mut rise) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        for line in &wall.lines {
            for j in 0..n {
                rate[j] = frame.potential_rate[j] * line.value[j];
                along[j] = frame.potential[j] * line.along[j];
                rise[j] = frame.potential[j] * line.value[j];
            }
            // Over the depth at rest, without the pressure at rest.
            let (mut force, mut moment) = (0.0, 0.0);
            let mut sums = [[0.0; LEVELS]; 3];
            for (j, [value, slope]) in wall.heights.iter().enumerate() {
                for l in 0..LEVELS {
                    sums[0][l] += rate[j] * value[l];
                    sums[1][l] += along[j] * value[l];
                    sums[2][l] += rise[j] * slope[l];
                }
            }
            let [t, v, w] = sums;
            for l in 0..LEVELS {
                let p =
                    t[l] + 0.5 * (v[l] * v[l] + w[l] * w[l]) + self.carried(frame, line.place, wall.z[l], &line.value);
                force -= wall.weight[l] * p;
                moment -= wall.weight[l] * p * (wall.z[l] + own.depth);
            }
            // From the level at rest to the surface by Simpson's rule; on the surface only damping presses.
            let eta = product(&line.value, frame.elevation);
            let at = |z: f64| {
                let [mut t, mut v, mut w] = [0.0; 3];
                for j in 0..n {
                    let [value, slope] = self.height_of(j, z);
                    t += rate[j] * value;
                    v += along[j] * value;
                    w += rise[j] * slope;
                }
                -(t + 0.5 * (v * v + w * w) + gravity * z + self.carried(frame, line.place, z, &line.value))
            };
            let damped: f64 =
                (0..n).map(|j| 2.0 * own.damping * self.omega[j] * frame.surface[j] * line.value[j]).sum();
            let [low, middle, high] = [at(0.0), at(0.5 * eta), damped];
            force += eta / 6.0 * (low + 4.0 * middle + high);
            moment += eta / 6.0 * (low * own.depth + 4.0 * middle * (own.depth + 0.5 * eta) + high * (own.depth + eta));
            for d in 0..2 {
                out.pressure_shear[d] += own.density * force * line.length * line.normal[d];
                out.wall_moment[d] += own.density * moment * line.length * line.normal[d];
            }
        }
        let bottom = self.bottom(wall, frame);
        for d in 0..2 {
            out.moment[d] = out.wall_moment[d] + bottom[d];
        }
        out
    }

    /// Moment of the pressures on the floor [N m].
    #[inline(always)]
    fn bottom(&self, wall: &Wall, frame: &Frame) -> [f64; 2] {
        let basis = &self.basis;
        let n = self.tanh.len();
        let scaled = |values: &[f64]| -> Vec<f64> { values.iter().zip(&wall.floor).map(|(v, f)| v * f).collect() };
        let (rate, potential) = (scaled(frame.potential_rate), scaled(frame.potential));
        let mut out = [0.0; 2];
        let mut values = vec![0.0; n];
        for block in 0..basis.blocks {
            let mut sums = [[0.0; LANES]; 3];
            for j in 0..n {
                let from = (block * n + j) * LANES;
                let tables = [&basis.value, &basis.slope[0], &basis.slope[1]].map(|table| &table[from..from + LANES]);
                for i in 0..LANES {
                    sums[0][i] += rate[j] * tables[0][i];
                    sums[1][i] += potential[j] * tables[1][i];
                    sums[2][i] += potential[j] * tables[2][i];
                }
            }
            let [t, v, w] = sums;
            for i in 0..LANES {
                let p = block * LANES + i;
                let (place, area) = (basis.places[p], basis.areas[p]);
                if frame.motion.angular != [0.0; 2] {
                    values.iter_mut().enumerate().for_each(|(j, value)| *value = basis.value[basis.index(p, j)]);
                }
                let carried = self.carried(frame, place, -self.own.depth, &values);
                let pressure = -(t[i] + 0.5 * (v[i] * v[i] + w[i] * w[i]) + carried) * self.own.density;
                for d in 0..2 {
                    out[d] += area * pressure * place[d];
                }
            }
        }
        if basis.modes().iter().all(|mode| !mode.sine) {
            out[1] = 0.0;
        }
        out
    }
}

/// Resultants of an instant, in the widest registers there are.
struct Resultants<'a> {
    liquid: &'a Liquid,
    wall: &'a Wall,
    frame: &'a Frame<'a>,
}

impl pulp::WithSimd for Resultants<'_> {
    type Output = Forces;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Forces {
        self.liquid.resultants(self.wall, self.frame)
    }
}

impl Probe {
    /// Pressure above that of the air at an instant [Pa], zero where the place is dry.
    ///
    /// ```text
    /// p = −ρ (φ_t + ½ |∇φ|² + (g + a_v) z + a·x)
    /// ```
    pub fn pressure(&self, liquid: &Liquid, frame: &Frame) -> f64 {
        let own = liquid.own;
        if product(&self.values[0], frame.elevation) < self.z {
            return 0.0;
        }
        let [mut t, mut u, mut v, mut w] = [0.0; 4];
        for j in 0..self.height.len() {
            let [value, slope] = self.height[j];
            t += frame.potential_rate[j] * self.values[0][j] * value;
            u += frame.potential[j] * self.values[1][j] * value;
            v += frame.potential[j] * self.values[2][j] * value;
            w += frame.potential[j] * self.values[0][j] * slope;
        }
        let motion = liquid.carried(frame, self.place, self.z, &self.values[0]);
        let gravity = own.gravity + frame.motion.vertical;
        -own.density * (t + 0.5 * (u * u + v * v + w * w) + gravity * self.z + motion)
    }
}
