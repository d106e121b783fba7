//! The fast spectrum: eight oscillators side by side, time outermost, exact maxima of the continuous response.
//!
//! The inner loops work on `[f64; 8]`, which the compiler turns into vector instructions; [`pulp`] chooses the copy for
//! the processor at run time. Units and symbols are those of [`super::peaks`].
//!
//! Two loops, for two kinds of oscillators:
//!
//! * **Soft**, T ≥ 8 h: the recurrence of [`crate::sdof`] from sample to sample. After each block of 16 steps a bound
//!   on the continuous maxima in the block is held against the largest values so far; only where it exceeds them, the
//!   block is gone through again in steps of at most T/16.
//!
//!   ```text
//!   with ε = h²/8 and the maxima of the samples on the right, those of the continuous response on the left:
//!   |y|  ≤ |y|  + εω² |y''|        |y'| ≤ |y'| + εω² (|σ| + 2ξ|y''| + |y'|)        |y''| ≤ |y| + 2ξ|y'| + |p|
//!   ```
//!
//!   (error of linear interpolation and equation of motion; solved for the three left sides).
//! * **Stiff**, T < 8 h: the state is kept as the oscillation (x₁, x₂) about the line that follows the load, rotated and
//!   damped from sample to sample and kicked at each kink of the load. Within a step nothing can exceed
//!
//!   ```text
//!   |A| ≤ max|p| + R        |y| ≤ max|p| + 2ξ|σ| + R        |y'| ≤ |σ| + R
//!   ```
//!
//!   Only where one of these exceeds the largest value so far, the step is examined: over its first and its last
//!   vibration, as line plus decaying oscillation has its largest extremum in one of the two.
//!
//! Both are exact but for rounding and for the interpolation error of [`super::peaks`], below 3e-7 of the amplitude R.

use std::f64::consts::TAU;

use super::peaks::{Maxima, State};
use crate::sdof::Recurrence;

/// Oscillators side by side.
pub const LANES: usize = 8;
/// One value for each of them.
pub type Lanes = [f64; LANES];
/// Steps of a block.
const BLOCK: usize = 16;
/// Oscillators with fewer steps a period are stiff.
const STIFF: f64 = 8.0;
/// Intervals a period in which extrema are looked for.
const INTERVALS: f64 = 16.0;

/// Lanes from their index.
#[inline(always)]
pub fn lanes(f: impl Fn(usize) -> f64) -> Lanes {
    let mut out = [0.0; LANES];
    for (i, x) in out.iter_mut().enumerate() {
        *x = f(i);
    }
    out
}

/// Whether it holds for any lane.
#[inline(always)]
pub fn any(f: impl Fn(usize) -> bool) -> bool {
    let mut found = false;
    for i in 0..LANES {
        found |= f(i);
    }
    found
}

/// The larger of two numbers, without the rules of `f64::max` for NaN.
#[inline(always)]
pub fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// a b + c, fused where the processor does it in one instruction.
#[inline(always)]
fn fma<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// An oscillator: circular frequency [rad/s] > 0 and damping ratio 0 ≤ ξ < 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    /// ω [rad/s].
    pub omega: f64,
    /// ξ.
    pub damping: f64,
}

/// Largest ω²|u|, ω|u̇| and |ü + a_g| [m/s²] of each oscillator over the record and the free vibration after it.
///
/// `ground`: acceleration [m/s²] at samples `h` [s] apart.
pub fn maxima(ground: &[f64], h: f64, oscillators: &[Oscillator]) -> Vec<[f64; 3]> {
    // Neighbours in frequency share a group, so that a group is of one kind.
    let mut order: Vec<usize> = (0..oscillators.len()).collect();
    order.sort_by(|&i, &j| oscillators[j].omega.total_cmp(&oscillators[i].omega));
    let stiff = order.partition_point(|&i| oscillators[i].omega * h * STIFF > TAU);
    let blocks = Block::all(ground, h);
    let mut result = vec![[0.0; 3]; oscillators.len()];
    let groups = order[..stiff]
        .chunks(LANES)
        .map(|g| (true, g))
        .chain(order[stiff..].chunks(LANES).map(|g| (false, g)));
    let arch = pulp::Arch::new();
    for (stiff, group) in groups {
        // The last group is filled up with its last oscillator.
        let member = |i: usize| oscillators[group[i.min(group.len() - 1)]];
        let run = Run {
            ground,
            h,
            blocks: &blocks,
            omega: lanes(|i| member(i).omega),
            xi: lanes(|i| member(i).damping),
            stiff,
        };
        let m = arch.dispatch(run);
        for (i, &oscillator) in group.iter().enumerate() {
            result[oscillator] = [m.y[i], m.y1[i], m.a[i]];
        }
    }
    result
}

/// Largest |p| and |dp/dt| of a block of steps.
struct Block {
    load: f64,
    slope: f64,
}

impl Block {
    fn all(ground: &[f64], h: f64) -> Vec<Block> {
        let steps = ground.len().saturating_sub(1);
        (0..steps)
            .step_by(BLOCK)
            .map(|first| {
                let part = &ground[first..=(first + BLOCK).min(steps)];
                Block {
                    load: part.iter().fold(0.0, |m, a| larger(m, a.abs())),
                    slope: part.windows(2).fold(0.0, |m, p| larger(m, (p[1] - p[0]).abs())) / h,
                }
            })
            .collect()
    }
}

/// One group over the whole record.
struct Run<'a> {
    ground: &'a [f64],
    h: f64,
    blocks: &'a [Block],
    omega: Lanes,
    xi: Lanes,
    stiff: bool,
}

impl pulp::WithSimd for Run<'_> {
    type Output = Maxima;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Maxima {
        match (self.stiff, S::IS_SCALAR) {
            (true, true) => self.run_stiff::<false>(),
            (true, false) => self.run_stiff::<true>(),
            (false, true) => self.run_soft::<false>(),
            (false, false) => self.run_soft::<true>(),
        }
    }
}

/// Coefficients of [`Recurrence`] for the scaled state (y, y').
struct Step {
    a: Lanes,
    b: Lanes,
    c: Lanes,
    d: Lanes,
    a1: Lanes,
    b1: Lanes,
    c1: Lanes,
    d1: Lanes,
}

impl Step {
    fn new(omega: &Lanes, xi: &Lanes, h: f64) -> Step {
        let r: [Recurrence; LANES] = std::array::from_fn(|i| Recurrence::new(omega[i], xi[i], h));
        Step {
            a: lanes(|i| r[i].a),
            b: lanes(|i| r[i].b * omega[i]),
            c: lanes(|i| r[i].c * omega[i] * omega[i]),
            d: lanes(|i| r[i].d * omega[i] * omega[i]),
            a1: lanes(|i| r[i].a_v / omega[i]),
            b1: lanes(|i| r[i].b_v),
            c1: lanes(|i| r[i].c_v * omega[i]),
            d1: lanes(|i| r[i].d_v * omega[i]),
        }
    }

    #[inline(always)]
    fn apply<const F: bool>(&self, y: &Lanes, y1: &Lanes, p0: f64, p1: f64) -> (Lanes, Lanes) {
        // The load first: only the two products with the state wait for the step before.
        let force = lanes(|i| fma::<F>(self.c[i], p0, self.d[i] * p1));
        let force1 = lanes(|i| fma::<F>(self.c1[i], p0, self.d1[i] * p1));
        (
            lanes(|i| fma::<F>(self.a[i], y[i], fma::<F>(self.b[i], y1[i], force[i]))),
            lanes(|i| fma::<F>(self.a1[i], y[i], fma::<F>(self.b1[i], y1[i], force1[i]))),
        )
    }
}

impl Run<'_> {
    /// Oscillators with at least eight steps a period.
    #[inline(always)]
    fn run_soft<const F: bool>(&self) -> Maxima {
        let two_xi = lanes(|i| 2.0 * self.xi[i]);
        let step = Step::new(&self.omega, &self.xi, self.h);
        let fastest = self.omega.iter().fold(0.0, |m, &w| larger(m, w));
        let parts = (INTERVALS * fastest * self.h / TAU).ceil().max(1.0);
        let part = Step::new(&self.omega, &self.xi, self.h / parts);
        let bound = SoftBound::new(&self.omega, &self.xi, self.h);
        let mut m = Maxima::NONE;
        let (mut y, mut y1) = ([0.0; LANES], [0.0; LANES]);
        for (block, first) in self.blocks.iter().zip((0..self.ground.len()).step_by(BLOCK)) {
            let loads = &self.ground[first..self.ground.len().min(first + BLOCK + 1)];
            let start = (y, y1);
            let mut samples = Maxima::NONE;
            samples.take(&y, &y1, &two_xi);
            for pair in loads.windows(2) {
                (y, y1) = step.apply::<F>(&y, &y1, pair[0], pair[1]);
                samples.y = lanes(|i| larger(samples.y[i], y[i].abs()));
                samples.y1 = lanes(|i| larger(samples.y1[i], y1[i].abs()));
                samples.a = lanes(|i| larger(samples.a[i], fma::<F>(two_xi[i], y1[i], y[i]).abs()));
            }
            let most = bound.continuous(&samples, block);
            if any(|i| (most.y[i] > m.y[i]) | (most.y1[i] > m.y1[i]) | (most.a[i] > m.a[i])) {
                self.examine_block::<F>(&mut m, start, loads, &part, parts as usize, &two_xi);
            }
        }
        m.take_free_vibration(&y, &y1, &self.xi);
        m
    }

    /// Goes through a block again in parts of at most T/16.
    #[inline(always)]
    fn examine_block<const F: bool>(
        &self,
        m: &mut Maxima,
        start: (Lanes, Lanes),
        loads: &[f64],
        part: &Step,
        parts: usize,
        two_xi: &Lanes,
    ) {
        let (mut y, mut y1) = start;
        let phi = lanes(|i| self.omega[i] * self.h / parts as f64);
        let kappa = lanes(|i| ((1.0 - self.xi[i]) * (1.0 + self.xi[i])).sqrt());
        for pair in loads.windows(2) {
            let sigma = lanes(|i| (pair[1] - pair[0]) / (self.h * self.omega[i]));
            let r = lanes(|i| {
                let x1 = y[i] - pair[0] + two_xi[i] * sigma[i];
                x1.abs() + ((y1[i] - sigma[i] + self.xi[i] * x1) / kappa[i]).abs()
            });
            let mut load = pair[0];
            let mut s0 = State::new(y, y1, &[load; LANES], &sigma, two_xi);
            for j in 1..=parts {
                let next = pair[0] + (pair[1] - pair[0]) * (j as f64 / parts as f64);
                (y, y1) = part.apply::<F>(&y, &y1, load, next);
                load = next;
                let s1 = State::new(y, y1, &[load; LANES], &sigma, two_xi);
                m.take_interval(&s0, &s1, &phi, &r, two_xi);
                s0 = s1;
            }
        }
    }

    /// Oscillators with fewer than eight steps a period.
    #[inline(always)]
    fn run_stiff<const F: bool>(&self) -> Maxima {
        let h = self.h;
        let two_xi = lanes(|i| 2.0 * self.xi[i]);
        let kappa = lanes(|i| ((1.0 - self.xi[i]) * (1.0 + self.xi[i])).sqrt());
        let turn = Rotation::new(&self.omega, &self.xi, &[h; LANES]);
        // Kick of (x₁, x₂) by a change of the load's step p₁ − p₀.
        let per_step = lanes(|i| 1.0 / (self.omega[i] * h));
        let kick1 = lanes(|i| two_xi[i] * per_step[i]);
        let kick2 = lanes(|i| (two_xi[i] * self.xi[i] - 1.0) / kappa[i] * per_step[i]);
        let mut m = Maxima::NONE;
        // At rest under p₀ the oscillation is opposite to the line.
        let first = self.ground.first().copied().unwrap_or(0.0);
        let mut x1 = [-first; LANES];
        let mut x2 = lanes(|i| -self.xi[i] / kappa[i] * first);
        let mut change = 0.0;
        for pair in self.ground.windows(2) {
            let (p0, p1) = (pair[0], pair[1]);
            let kink = (p1 - p0) - change;
            change = p1 - p0;
            x1 = lanes(|i| fma::<F>(kick1[i], kink, x1[i]));
            x2 = lanes(|i| fma::<F>(kick2[i], kink, x2[i]));
            let load = larger(p0.abs(), p1.abs());
            let rise = change.abs();
            // Room that the largest values so far leave for R.
            let room = lanes(|i| {
                let y = fma::<F>(-kick1[i], rise, m.y[i]);
                let ya = if y < m.a[i] { y } else { m.a[i] } - load;
                let y1 = fma::<F>(-per_step[i], rise, m.y1[i]);
                let room = if ya < y1 { ya } else { y1 };
                larger(room, 0.0)
            });
            let amplitude2 = lanes(|i| fma::<F>(x1[i], x1[i], x2[i] * x2[i]));
            if any(|i| amplitude2[i] > room[i] * room[i]) {
                self.examine_step(&mut m, (&x1, &x2), pair, &kappa, &two_xi);
            }
            (x1, x2) = turn.apply::<F>(&x1, &x2);
        }
        // Back from the oscillation to the state.
        let last = self.ground.last().copied().unwrap_or(0.0);
        let sigma = lanes(|i| change * per_step[i]);
        let y = lanes(|i| last - two_xi[i] * sigma[i] + x1[i]);
        let y1 = lanes(|i| sigma[i] + kappa[i] * x2[i] - self.xi[i] * x1[i]);
        m.take(&y, &y1, &two_xi);
        m.take_free_vibration(&y, &y1, &self.xi);
        m
    }

    /// Examines the first and the last vibration of a step of stiff oscillators.
    #[inline(always)]
    fn examine_step(&self, m: &mut Maxima, x: (&Lanes, &Lanes), pair: &[f64], kappa: &Lanes, two_xi: &Lanes) {
        let h = self.h;
        let window = lanes(|i| {
            let vibration = TAU / (self.omega[i] * kappa[i]);
            if vibration < h { vibration } else { h }
        });
        let parts = lanes(|i| INTERVALS * window[i] * self.omega[i] / TAU);
        let parts = parts.iter().fold(0.0, |m, &n| larger(m, n)).ceil();
        let part = lanes(|i| window[i] / parts);
        let phi = lanes(|i| part[i] * self.omega[i]);
        let turn = Rotation::new(&self.omega, &self.xi, &part);
        let r = lanes(|i| x.0[i].abs() + x.1[i].abs());
        let sigma = lanes(|i| (pair[1] - pair[0]) / (h * self.omega[i]));
        let state = |x1: &Lanes, x2: &Lanes, time: &Lanes| {
            let p = lanes(|i| pair[0] + (pair[1] - pair[0]) * (time[i] / h));
            let y = lanes(|i| p[i] - two_xi[i] * sigma[i] + x1[i]);
            let y1 = lanes(|i| sigma[i] + kappa[i] * x2[i] - self.xi[i] * x1[i]);
            State::new(y, y1, &p, &sigma, two_xi)
        };
        let mut examine = |begin: Lanes| {
            let (mut x1, mut x2) = Rotation::new(&self.omega, &self.xi, &begin).apply::<false>(x.0, x.1);
            let mut s0 = state(&x1, &x2, &begin);
            m.take(&s0.y, &s0.y1, two_xi);
            for j in 1..=parts as usize {
                (x1, x2) = turn.apply::<false>(&x1, &x2);
                let s1 = state(&x1, &x2, &lanes(|i| begin[i] + part[i] * j as f64));
                m.take_interval(&s0, &s1, &phi, &r, two_xi);
                s0 = s1;
            }
        };
        examine([0.0; LANES]);
        if any(|i| window[i] < h) {
            examine(lanes(|i| h - window[i]));
        }
    }
}

/// Decay and rotation of (x₁, x₂) over a time of each lane.
struct Rotation {
    cos: Lanes,
    sin: Lanes,
}

impl Rotation {
    #[inline(always)]
    fn new(omega: &Lanes, xi: &Lanes, time: &Lanes) -> Rotation {
        let polar = |i: usize| {
            let kappa = ((1.0 - xi[i]) * (1.0 + xi[i])).sqrt();
            let (sin, cos) = (omega[i] * kappa * time[i]).sin_cos();
            ((-xi[i] * omega[i] * time[i]).exp(), sin, cos)
        };
        let values: [_; LANES] = std::array::from_fn(polar);
        Rotation {
            cos: lanes(|i| values[i].0 * values[i].2),
            sin: lanes(|i| values[i].0 * values[i].1),
        }
    }

    #[inline(always)]
    fn apply<const F: bool>(&self, x1: &Lanes, x2: &Lanes) -> (Lanes, Lanes) {
        (
            lanes(|i| fma::<F>(self.cos[i], x1[i], self.sin[i] * x2[i])),
            lanes(|i| fma::<F>(self.cos[i], x2[i], -self.sin[i] * x1[i])),
        )
    }
}

/// Bound on the continuous maxima of a block from those of its samples; see the module's text.
struct SoftBound {
    e: Lanes,
    two_xi: Lanes,
    omega: Lanes,
    r: Lanes,
    scale: Lanes,
}

impl SoftBound {
    fn new(omega: &Lanes, xi: &Lanes, h: f64) -> SoftBound {
        let e = lanes(|i| (omega[i] * h) * (omega[i] * h) / 8.0);
        let two_xi = lanes(|i| 2.0 * xi[i]);
        // T ≥ 8 h makes e ≤ 0.077, so both denominators are well above zero.
        let r = lanes(|i| 1.0 / (1.0 - e[i]));
        let scale = lanes(|i| 1.0 / (1.0 - r[i] * r[i] * two_xi[i] * two_xi[i] * e[i]));
        SoftBound {
            e,
            two_xi,
            omega: *omega,
            r,
            scale,
        }
    }

    #[inline(always)]
    fn continuous(&self, samples: &Maxima, block: &Block) -> Maxima {
        let SoftBound { e, two_xi, r, .. } = self;
        let sigma = lanes(|i| block.slope / self.omega[i]);
        let velocity = lanes(|i| r[i] * (samples.y1[i] + e[i] * sigma[i]));
        let y2 = lanes(|i| self.scale[i] * r[i] * (samples.y[i] + block.load + two_xi[i] * velocity[i]));
        let y1 = lanes(|i| velocity[i] + r[i] * e[i] * two_xi[i] * y2[i]);
        let y3 = lanes(|i| sigma[i] + two_xi[i] * y2[i] + y1[i]);
        Maxima {
            y: lanes(|i| samples.y[i] + e[i] * y2[i]),
            y1,
            a: lanes(|i| samples.a[i] + e[i] * (y2[i] + two_xi[i] * y3[i])),
        }
    }
}
