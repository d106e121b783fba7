//! Soft oscillators of the fast spectrum: at least eight samples a period.
//!
//! They follow the recurrence of [`crate::sdof`]; where T ≥ 64 h two or four steps are taken in one, as the state after
//! m steps is linear in the state before and in the m + 1 loads. With samples H = m h ≤ T/8 apart and ε = (ωH)²/8, the
//! continuous maxima of a block (left) follow from those of the samples (right) by the error of linear interpolation
//! and the equation of motion, solved for the three left sides:
//!
//! ```text
//! |y| ≤ |y| + ε |y''|        |y'| ≤ |y'| + ε (|σ| + 2ξ|y''| + |y'|)        |y''| ≤ |y| + 2ξ|y'| + |p|
//! ```

use std::f64::consts::TAU;

use pulp::Simd;

use super::blocks::{INTERVALS, Loads, Oscillator, Trace};
use super::lanes::{LANES, Lanes, Unit, lanes};
use super::peaks::{Maxima, State, larger};
use crate::sdof::Recurrence;

/// Largest number of combined steps.
const MAX_STRIDE: usize = 4;

/// Coefficients of soft oscillators.
pub(crate) struct Soft {
    oscillators: [Oscillator; LANES],
    /// The recurrence for (y, y') over one step.
    one: [Recurrence; LANES],
    /// Number of combined steps, m.
    stride: usize,
    /// Over m steps: y and y' from y, y' …
    state: [[Lanes; 2]; 2],
    /// … and from the m + 1 loads.
    load: [[Lanes; 2]; MAX_STRIDE + 1],
    two_xi: Lanes,
    /// 1/ω.
    per_omega: Lanes,
    /// ε = (ωH)²/8 and its factors in the bound of a block.
    e: Lanes,
    r: Lanes,
    scale: Lanes,
}

impl Soft {
    /// Coefficients for steps of `h` [s].
    pub(crate) fn new(oscillators: &[Oscillator; LANES], h: f64) -> Soft {
        let fastest = oscillators.iter().fold(0.0, |m, o| larger(o.omega, m));
        // T ≥ 32 H and four steps at most: with more the load varies too much between the used samples.
        let mut stride = 1;
        while stride < MAX_STRIDE && 2.0 * (2 * stride) as f64 * h * INTERVALS * fastest <= TAU {
            stride *= 2;
        }
        let one: [Recurrence; LANES] = std::array::from_fn(|i| scaled(&oscillators[i], h));
        // The effect of unit states and unit loads on the state after m steps. A load enters as the end of one step
        // and the beginning of the next, the first and the last one only once.
        let mut state = [[[0.0; LANES]; 2]; 2];
        let mut load = [[[0.0; LANES]; 2]; MAX_STRIDE + 1];
        for (i, step) in one.iter().enumerate() {
            let free = |(y, y1): (f64, f64)| step.step(y, y1, 0.0, 0.0);
            let after = |from: (f64, f64), steps: usize| (0..steps).fold(from, |x, _| free(x));
            for (column, unit) in [(1.0, 0.0), (0.0, 1.0)].into_iter().enumerate() {
                let (y, y1) = after(unit, stride);
                (state[0][column][i], state[1][column][i]) = (y, y1);
            }
            let (begin, end) = ((step.c, step.c_v), (step.d, step.d_v));
            let both = (free(end).0 + begin.0, free(end).1 + begin.1);
            let mut effect = both;
            for j in (1..stride).rev() {
                load[j] = with_lane(load[j], i, effect);
                effect = free(effect);
            }
            load[0] = with_lane(load[0], i, after(begin, stride - 1));
            load[stride] = with_lane(load[stride], i, end);
        }
        let two_xi = lanes(|i| 2.0 * oscillators[i].damping);
        let e = lanes(|i| (oscillators[i].omega * h * stride as f64).powi(2) / 8.0);
        // T ≥ 8 H makes ε ≤ 0.077, so both denominators are well above zero.
        let r = lanes(|i| 1.0 / (1.0 - e[i]));
        Soft {
            oscillators: *oscillators,
            one,
            stride,
            state,
            load,
            two_xi,
            per_omega: lanes(|i| 1.0 / oscillators[i].omega),
            e,
            r,
            scale: lanes(|i| 1.0 / (1.0 - (r[i] * two_xi[i]).powi(2) * e[i])),
        }
    }

    /// Maxima of one oscillator at the samples and in the free vibration at the end.
    pub(crate) fn begin(&self, lane: usize, traced: &SoftTraced) -> Maxima {
        let [y, y1, a] = traced.samples.map(|s| s[lane]);
        let mut m = Maxima { y, y1, a };
        m.take_free_vibration(traced.end[0][lane], traced.end[1][lane], self.oscillators[lane].damping);
        m
    }

    /// Maxima of one oscillator, at least `m`, from the candidate blocks.
    pub(crate) fn search(
        &self,
        lane: usize,
        loads: &Loads,
        trace: &[Trace],
        candidates: &[usize],
        mut m: Maxima,
    ) -> Maxima {
        let Oscillator { omega, damping } = self.oscillators[lane];
        let parts = (INTERVALS * omega * loads.h / TAU).ceil().max(1.0);
        let part = if parts > 1.0 { scaled(&self.oscillators[lane], loads.h / parts) } else { self.one[lane] };
        for &block in candidates {
            let t = &trace[block];
            if t.bound[0][lane] <= m.y && t.bound[1][lane] <= m.y1 && t.bound[2][lane] <= m.a {
                continue;
            }
            // ε goes with the square of the distance of samples: here they are one step apart.
            let slack = t.slack.map(|s| s[lane] / (self.stride * self.stride) as f64);
            let (mut y, mut y1) = (t.start[0][lane], t.start[1][lane]);
            for pair in loads.block(block).windows(2) {
                let (next, next1) = self.one[lane].step(y, y1, pair[0], pair[1]);
                let absolute = |y: f64, y1: f64| (y + 2.0 * damping * y1).abs();
                let near = larger(y.abs(), next.abs()) + slack[0] > m.y
                    || larger(y1.abs(), next1.abs()) + slack[1] > m.y1
                    || larger(absolute(y, y1), absolute(next, next1)) + slack[2] > m.a;
                if near {
                    let phi = omega * loads.h / parts;
                    let sigma = (pair[1] - pair[0]) / (omega * loads.h);
                    let mut s0 = State::new(y, y1, pair[0], sigma, damping);
                    let (x1, x2) = s0.oscillation(pair[0], sigma, damping);
                    let mut load = pair[0];
                    for j in 1..=parts as usize {
                        let after = pair[0] + (pair[1] - pair[0]) * (j as f64 / parts);
                        let (y, y1) = part.step(s0.y, s0.y1, load, after);
                        let s1 = State::new(y, y1, after, sigma, damping);
                        m.take_interval(&s0, &s1, phi, x1.abs() + x2.abs(), damping);
                        (s0, load) = (s1, after);
                    }
                }
                (y, y1) = (next, next1);
            }
        }
        m
    }
}

/// `values` with the two entries of a lane set.
fn with_lane(mut values: [Lanes; 2], lane: usize, (first, second): (f64, f64)) -> [Lanes; 2] {
    (values[0][lane], values[1][lane]) = (first, second);
    values
}

/// The recurrence for (y, y') = (ω² u, ω u̇).
fn scaled(oscillator: &Oscillator, h: f64) -> Recurrence {
    let w = oscillator.omega;
    let r = Recurrence::new(w, oscillator.damping, h);
    Recurrence {
        a: r.a,
        b: r.b * w,
        c: r.c * w * w,
        d: r.d * w * w,
        a_v: r.a_v / w,
        b_v: r.b_v,
        c_v: r.c_v * w,
        d_v: r.d_v * w,
    }
}

/// Result of the first pass over soft oscillators.
pub(crate) struct SoftTraced {
    /// (y, y') at the last sample.
    end: [Lanes; 2],
    /// Largest |y|, |y'|, |A| at samples.
    samples: [Lanes; 3],
}

/// First pass over soft oscillators.
pub(crate) struct SoftTrace<'a> {
    /// The group.
    pub soft: &'a Soft,
    /// The record.
    pub loads: &'a Loads<'a>,
    /// One entry per block, to be filled.
    pub trace: &'a mut [Trace],
}

impl pulp::WithSimd for SoftTrace<'_> {
    type Output = SoftTraced;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> SoftTraced {
        // Registers at a time: two hide the latency of each other; as many as fit where they are narrow or wide.
        match S::F64_LANES {
            8 => self.stride::<S, 1>(simd),
            _ => self.stride::<S, 2>(simd),
        }
    }
}

impl SoftTrace<'_> {
    #[inline(always)]
    fn stride<S: Simd, const N: usize>(self, simd: S) -> SoftTraced {
        match self.soft.stride {
            1 => self.run::<S, N, 1>(simd),
            2 => self.run::<S, N, 2>(simd),
            _ => self.run::<S, N, MAX_STRIDE>(simd),
        }
    }

    #[inline(always)]
    fn run<S: Simd, const N: usize, const STRIDE: usize>(self, simd: S) -> SoftTraced {
        let s = self.soft;
        let mut traced = SoftTraced { end: [[0.0; LANES]; 2], samples: [[0.0; LANES]; 3] };
        for u in Unit::<S, N>::all(simd) {
            let [[a, b], [a1, b1]] = s.state.map(|row| row.map(|x| u.load(&x)));
            let load = s.load.map(|both| both.map(|x| u.load(&x)));
            let two_xi = u.load(&s.two_xi);
            let (e, r, scale, per_omega) = (u.load(&s.e), u.load(&s.r), u.load(&s.scale), u.load(&s.per_omega));
            let zero = u.splat(0.0);
            let (mut y, mut y1) = (zero, zero);
            let mut samples = [zero; 3];
            for (block, t) in self.trace.iter_mut().enumerate() {
                let p = self.loads.block(block);
                u.store(&mut t.start[0], y);
                u.store(&mut t.start[1], y1);
                let mut top = u.max_abs(zero, y);
                let mut top1 = u.max_abs(zero, y1);
                let mut top_a = u.max_abs(zero, u.fma(two_xi, y1, y));
                let mut first = 0;
                while first + STRIDE < p.len() {
                    let p = &p[first..=first + STRIDE];
                    // The load first: only the products with the state wait for the step before.
                    let p0 = u.splat(p[0]);
                    let (mut force, mut force1) = (u.mul(load[0][0], p0), u.mul(load[0][1], p0));
                    for j in 1..=STRIDE {
                        let pj = u.splat(p[j]);
                        force = u.fma(load[j][0], pj, force);
                        force1 = u.fma(load[j][1], pj, force1);
                    }
                    (y, y1) = (u.fma(a, y, u.fma(b, y1, force)), u.fma(a1, y, u.fma(b1, y1, force1)));
                    top = u.max_abs(top, y);
                    top1 = u.max_abs(top1, y1);
                    top_a = u.max_abs(top_a, u.fma(two_xi, y1, y));
                    first += STRIDE;
                }
                // The rest of the last block, step by step.
                for pair in p[first..].windows(2) {
                    let one = |f: fn(&Recurrence) -> f64| u.load(&lanes(|i| f(&s.one[i])));
                    let (p0, p1) = (u.splat(pair[0]), u.splat(pair[1]));
                    let force = u.fma(one(|r| r.c), p0, u.mul(one(|r| r.d), p1));
                    let force1 = u.fma(one(|r| r.c_v), p0, u.mul(one(|r| r.d_v), p1));
                    let next = u.fma(one(|r| r.a), y, u.fma(one(|r| r.b), y1, force));
                    y1 = u.fma(one(|r| r.a_v), y, u.fma(one(|r| r.b_v), y1, force1));
                    y = next;
                    top = u.max_abs(top, y);
                    top1 = u.max_abs(top1, y1);
                    top_a = u.max_abs(top_a, u.fma(two_xi, y1, y));
                }
                let (load, slope) = self.loads.blocks[block];
                let sigma = u.mul(u.splat(slope), per_omega);
                let velocity = u.mul(r, u.fma(e, sigma, top1));
                let y2 = u.mul(u.mul(scale, r), u.fma(two_xi, velocity, u.add(top, u.splat(load))));
                let slack1 = u.sub(u.fma(u.mul(r, e), u.mul(two_xi, y2), velocity), top1);
                let y3 = u.fma(two_xi, y2, u.add(sigma, u.add(top1, slack1)));
                let slack = u.mul(e, y2);
                let slack_a = u.mul(e, u.fma(two_xi, y3, y2));
                for (k, (top, slack)) in [(top, slack), (top1, slack1), (top_a, slack_a)].into_iter().enumerate() {
                    u.store(&mut t.bound[k], u.add(top, slack));
                    u.store(&mut t.slack[k], slack);
                    samples[k] = u.max(samples[k], top);
                }
            }
            u.store(&mut traced.end[0], y);
            u.store(&mut traced.end[1], y1);
            for (to, from) in traced.samples.iter_mut().zip(samples) {
                u.store(to, from);
            }
        }
        traced
    }
}
