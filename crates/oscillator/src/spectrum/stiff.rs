//! Stiff oscillators of the fast spectrum: fewer than eight samples a period.
//!
//! They are kept as the oscillation (x₁, x₂) about the line that follows the load, rotated and damped from sample to
//! sample and kicked at each kink of the load. Within a step no value can exceed
//!
//! ```text
//! |A| ≤ max|p| + R        |y| ≤ max|p| + 2ξ|σ| + R        |y'| ≤ |σ| + R
//! ```
//!
//! and a step is searched over its first and its last vibration only: line plus decaying oscillation has its largest
//! extremum in one of the two, as successive maxima lie on a convex curve.

use std::f64::consts::TAU;

use pulp::Simd;

use super::blocks::{BLOCK, INTERVALS, Loads, Oscillator, Trace};
use super::lanes::{LANES, Lanes, Unit, lanes};
use super::peaks::{Maxima, State, larger};

/// Coefficients of stiff oscillators.
pub(crate) struct Stiff {
    oscillators: [Oscillator; LANES],
    /// Kick of x₁ and x₂ by a change of p₁ − p₀ from one step to the next.
    kick: [Lanes; 2],
    /// Decay and rotation over a step.
    cos: Lanes,
    sin: Lanes,
    /// 1/ω.
    per_omega: Lanes,
    two_xi: Lanes,
}

/// Decay and rotation of (x₁, x₂) over a time: e^{−ξωt} cos ω_d t, e^{−ξωt} sin ω_d t.
fn rotation(oscillator: &Oscillator, time: f64) -> (f64, f64) {
    let (omega, xi) = (oscillator.omega, oscillator.damping);
    let (sin, cos) = (omega * ((1.0 - xi) * (1.0 + xi)).sqrt() * time).sin_cos();
    let e = (-xi * omega * time).exp();
    (e * cos, e * sin)
}

impl Stiff {
    /// Coefficients for steps of `h` [s].
    pub(crate) fn new(oscillators: &[Oscillator; LANES], h: f64) -> Stiff {
        let turn: [(f64, f64); LANES] = std::array::from_fn(|i| rotation(&oscillators[i], h));
        let kick = |i: usize| {
            let Oscillator { omega, damping: xi } = oscillators[i];
            let kappa = ((1.0 - xi) * (1.0 + xi)).sqrt();
            (2.0 * xi / (omega * h), (2.0 * xi * xi - 1.0) / (kappa * omega * h))
        };
        Stiff {
            oscillators: *oscillators,
            kick: [lanes(|i| kick(i).0), lanes(|i| kick(i).1)],
            cos: lanes(|i| turn[i].0),
            sin: lanes(|i| turn[i].1),
            per_omega: lanes(|i| 1.0 / oscillators[i].omega),
            two_xi: lanes(|i| 2.0 * oscillators[i].damping),
        }
    }

    /// (x₁, x₂) at rest under the first load: opposite to the line.
    fn rest(&self, p: f64) -> [Lanes; 2] {
        let xi = |i: usize| self.oscillators[i].damping;
        [[-p; LANES], lanes(|i| -xi(i) / ((1.0 - xi(i)) * (1.0 + xi(i))).sqrt() * p)]
    }

    /// Maxima of one oscillator in the free vibration at the end and in its most promising block, which raises the
    /// threshold for all others.
    pub(crate) fn begin(&self, lane: usize, loads: &Loads, trace: &[Trace], traced: &StiffTraced) -> Maxima {
        let oscillator = self.oscillators[lane];
        let xi = oscillator.damping;
        let (last, change) = match loads.p {
            [.., p0, p1] => (*p1, p1 - p0),
            [p] => (*p, 0.0),
            [] => (0.0, 0.0),
        };
        // Back from the oscillation to the state.
        let sigma = change / (oscillator.omega * loads.h);
        let (x1, x2) = (traced.end[0][lane], traced.end[1][lane]);
        let y = last - 2.0 * xi * sigma + x1;
        let y1 = sigma + oscillator.kappa() * x2 - xi * x1;
        let mut m = Maxima::default();
        m.take(y, y1, xi);
        m.take_free_vibration(y, y1, xi);
        let best = traced.best[lane] as usize;
        if let Some(t) = trace.get(best) {
            // Its most promising step first.
            let mut most = 0.0;
            let mut chosen = None;
            self.walk(lane, loads, t, best, |x, pair| {
                let bound = larger(pair[0].abs(), pair[1].abs()) + (x.0 * x.0 + x.1 * x.1).sqrt();
                if bound > most {
                    (most, chosen) = (bound, Some((x, [pair[0], pair[1]])));
                }
            });
            if let Some((x, pair)) = chosen {
                StiffStep::new(oscillator, loads.h).search(&mut m, x, &pair);
            }
        }
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
        let (two_xi, per_step) = (self.two_xi[lane], self.per_omega[lane] / loads.h);
        let mut step = None;
        for &block in candidates {
            let t = &trace[block];
            if t.bound[0][lane] <= m.y && t.bound[1][lane] <= m.y1 && t.bound[2][lane] <= m.a {
                continue;
            }
            self.walk(lane, loads, t, block, |x, pair| {
                let (load, sigma) = (larger(pair[0].abs(), pair[1].abs()), (pair[1] - pair[0]).abs() * per_step);
                // Room that the largest values so far leave for R.
                let room = (m.a - load).min(m.y - load - two_xi * sigma).min(m.y1 - sigma);
                if room < 0.0 || x.0 * x.0 + x.1 * x.1 > room * room {
                    let step = step.get_or_insert_with(|| StiffStep::new(self.oscillators[lane], loads.h));
                    step.search(&mut m, x, pair);
                }
            });
        }
        m
    }

    /// Calls `visit` with the oscillation at the beginning of every step of a block, and the loads at its ends.
    #[inline]
    fn walk(&self, lane: usize, loads: &Loads, trace: &Trace, block: usize, mut visit: impl FnMut((f64, f64), &[f64])) {
        let (mut x1, mut x2) = (trace.start[0][lane], trace.start[1][lane]);
        let (kick1, kick2) = (self.kick[0][lane], self.kick[1][lane]);
        let (cos, sin) = (self.cos[lane], self.sin[lane]);
        let first = block * BLOCK;
        let mut change = if first == 0 { 0.0 } else { loads.p[first] - loads.p[first - 1] };
        for pair in loads.block(block).windows(2) {
            let kink = (pair[1] - pair[0]) - change;
            change = pair[1] - pair[0];
            (x1, x2) = (x1 + kick1 * kink, x2 + kick2 * kink);
            visit((x1, x2), pair);
            (x1, x2) = (cos * x1 + sin * x2, cos * x2 - sin * x1);
        }
    }
}

/// Search within one step of a stiff oscillator.
struct StiffStep {
    oscillator: Oscillator,
    h: f64,
    kappa: f64,
    /// One vibration, or the step if it is shorter.
    window: f64,
    /// Intervals of a window and their length.
    parts: f64,
    part: f64,
    turn: (f64, f64),
    /// Rotation to the beginning of the last window.
    jump: (f64, f64),
}

impl StiffStep {
    fn new(oscillator: Oscillator, h: f64) -> StiffStep {
        let Oscillator { omega, damping: xi } = oscillator;
        let kappa = ((1.0 - xi) * (1.0 + xi)).sqrt();
        let vibration = TAU / (omega * kappa);
        // Two windows that overlap are one.
        let window = if 2.0 * vibration < h { vibration } else { h };
        let parts = (INTERVALS * window * omega / TAU).ceil().max(1.0);
        let part = window / parts;
        StiffStep {
            oscillator,
            h,
            kappa,
            window,
            parts,
            part,
            turn: rotation(&oscillator, part),
            jump: rotation(&oscillator, h - window),
        }
    }

    /// Raises `m` over the step that begins with the oscillation `x`.
    fn search(&self, m: &mut Maxima, x: (f64, f64), pair: &[f64]) {
        let xi = self.oscillator.damping;
        let phi = self.part * self.oscillator.omega;
        let slope = (pair[1] - pair[0]) / self.h;
        let sigma = slope / self.oscillator.omega;
        let r = (x.0 * x.0 + x.1 * x.1).sqrt();
        // Only the oscillation is curved, so the response exceeds two neighbouring points by at most this.
        let slack = phi * phi / 8.0 * r;
        let point = |x: (f64, f64), time: f64| {
            let p = pair[0] + slope * time;
            (p - 2.0 * xi * sigma + x.0, sigma + self.kappa * x.1 - xi * x.0, p)
        };
        let turned = |(x1, x2): (f64, f64), (cos, sin): (f64, f64)| (cos * x1 + sin * x2, cos * x2 - sin * x1);
        let last = self.h - self.window;
        let windows = [(0.0, x), (last, turned(x, self.jump))];
        for (begin, mut x) in windows.into_iter().take(if last > 0.0 { 2 } else { 1 }) {
            let mut from = point(x, begin);
            m.take(from.0, from.1, xi);
            for j in 1..=self.parts as usize {
                x = turned(x, self.turn);
                let to = point(x, begin + self.part * j as f64);
                let absolute = |at: (f64, f64, f64)| (at.0 + 2.0 * xi * at.1).abs();
                if larger(from.0.abs(), to.0.abs()) + slack > m.y
                    || larger(from.1.abs(), to.1.abs()) + slack > m.y1
                    || larger(absolute(from), absolute(to)) + slack > m.a
                {
                    let state = |(y, y1, p)| State::new(y, y1, p, sigma, xi);
                    m.take_interval(&state(from), &state(to), phi, r, xi);
                }
                from = to;
            }
        }
    }
}

/// Result of the first pass over stiff oscillators.
pub(crate) struct StiffTraced {
    /// (x₁, x₂) at the last sample.
    end: [Lanes; 2],
    /// Number of the block with the largest bound of |A|.
    best: Lanes,
}

/// First pass over stiff oscillators.
pub(crate) struct StiffTrace<'a> {
    /// The group.
    pub stiff: &'a Stiff,
    /// The record.
    pub loads: &'a Loads<'a>,
    /// One entry per block, to be filled.
    pub trace: &'a mut [Trace],
}

impl pulp::WithSimd for StiffTrace<'_> {
    type Output = StiffTraced;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> StiffTraced {
        match S::F64_LANES {
            8 => self.run::<S, 1>(simd),
            _ => self.run::<S, 2>(simd),
        }
    }
}

impl StiffTrace<'_> {
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) -> StiffTraced {
        let s = self.stiff;
        let rest = s.rest(self.loads.p.first().copied().unwrap_or(0.0));
        let mut traced = StiffTraced { end: rest, best: [0.0; LANES] };
        for u in Unit::<S, N>::all(simd) {
            let [kick1, kick2] = s.kick.map(|x| u.load(&x));
            let (cos, sin) = (u.load(&s.cos), u.load(&s.sin));
            let (two_xi, per_omega) = (u.load(&s.two_xi), u.load(&s.per_omega));
            let zero = u.splat(0.0);
            let back = u.sub(zero, sin);
            let [mut x1, mut x2] = rest.map(|x| u.load(&x));
            let (mut best, mut most) = (zero, zero);
            let mut change = 0.0;
            for (block, t) in self.trace.iter_mut().enumerate() {
                u.store(&mut t.start[0], x1);
                u.store(&mut t.start[1], x2);
                let mut top = zero;
                for pair in self.loads.block(block).windows(2) {
                    let kink = u.splat((pair[1] - pair[0]) - change);
                    change = pair[1] - pair[0];
                    let (k1, k2) = (u.fma(kick1, kink, x1), u.fma(kick2, kink, x2));
                    top = u.max(top, u.fma(k1, k1, u.mul(k2, k2)));
                    x1 = u.fma(cos, k1, u.mul(sin, k2));
                    x2 = u.fma(cos, k2, u.mul(back, k1));
                }
                let (load, slope) = self.loads.blocks[block];
                let (r, sigma) = (u.sqrt(top), u.mul(u.splat(slope), per_omega));
                let bound = u.add(u.splat(load), r);
                u.store(&mut t.bound[0], u.fma(two_xi, sigma, bound));
                u.store(&mut t.bound[1], u.add(sigma, r));
                u.store(&mut t.bound[2], bound);
                best = u.choose(bound, most, u.splat(block as f64), best);
                most = u.max(most, bound);
            }
            u.store(&mut traced.end[0], x1);
            u.store(&mut traced.end[1], x2);
            u.store(&mut traced.best, best);
        }
        traced
    }
}

#[cfg(test)]
mod tests {
    use super::super::kernel::maxima;
    use super::*;

    /// Step of the records [s]; with 8 rad a step an oscillator is stiff.
    const H: f64 = 0.02;
    const TURN: f64 = 8.0;

    fn found(ground: &[f64], damping: f64) -> Maxima {
        let omega = TURN / H;
        maxima(ground, H, &[Oscillator { omega, damping }])[0]
    }

    fn close(value: f64, expected: f64) {
        assert!((value / expected - 1.0).abs() < 1e-6, "{value} {expected}");
    }

    /// Undamped under a load that rises from 0 to p in one step and ends: `y = p (φ − sin φ)/φ₁`, `y' = p (1 − cos φ)/φ₁`
    /// with φ₁ = ωh, and after it a vibration of the amplitude √(y² + y'²).
    #[test]
    fn free_vibration_after_a_rising_load() {
        let (y, y1) = ((TURN - TURN.sin()) / TURN, (1.0 - TURN.cos()) / TURN);
        let amplitude = 3.0 * y.hypot(y1);
        let m = found(&[0.0, 3.0], 0.0);
        for value in [m.y, m.y1, m.a] {
            close(value, amplitude);
        }
    }

    /// A load p from the first sample on: overshoot `y = p (1 + e^{−πξ/κ})`.
    #[test]
    fn overshoot_of_a_sudden_load() {
        for damping in [0.0, 0.05, 0.3, 0.7] {
            let kappa = f64::sqrt(1.0 - damping * damping);
            let overshoot = (-std::f64::consts::PI * damping / kappa).exp();
            close(found(&[2.0; 4], damping).y, 2.0 * (1.0 + overshoot));
        }
    }

    /// Seven vibrations in a step, undamped: a load of 1 that rises by 1/2 gives `y = 1 − cos φ + ε (φ − sin φ)`,
    /// ε = 1/(2 φ₁). It is largest in the last vibration, where cot(φ/2) = −ε, and 1/2 at the end of the step.
    #[test]
    fn largest_in_the_last_vibration_of_a_step() {
        let end = 7.0 * TAU;
        let epsilon = 0.5 / end;
        let phi = 6.5 * TAU + 2.0 * epsilon.atan();
        let oscillator = Oscillator { omega: end / H, damping: 0.0 };
        let m = maxima(&[1.0, 1.5], H, &[oscillator])[0];
        close(m.y, 1.0 - phi.cos() + epsilon * (phi - phi.sin()));
    }

    /// Damped, a sudden load p₀ and the same rise: `y = p₀ (1 − e^{−ξφ} (cos κφ + ξ/κ sin κφ)) + p/φ₁ (φ − 2ξ +
    /// e^{−ξφ} (2ξ cos κφ + (2ξ² − 1)/κ sin κφ))` up to φ₁, free vibration from there, both sampled finely; the absolute
    /// acceleration is y + 2ξ y'.
    #[test]
    fn damped_oscillator_under_a_rising_load() {
        for (xi, sudden) in [(0.02, 0.0), (0.1, 0.0), (0.3, 0.0), (0.1, 0.5), (0.3, -0.4), (0.7, 0.2f64)] {
            let kappa = f64::sqrt(1.0 - xi * xi);
            // e^{−ξφ} (α cos κφ + β sin κφ) and its slope.
            let decay = |alpha: f64, beta: f64, phi: f64| {
                let (sin, cos) = (kappa * phi).sin_cos();
                let e = (-xi * phi).exp();
                (
                    e * (alpha * cos + beta * sin),
                    e * ((kappa * beta - xi * alpha) * cos - (kappa * alpha + xi * beta) * sin),
                )
            };
            let loaded = |phi: f64| {
                let (rise, rise1) = decay(2.0 * xi, (2.0 * xi * xi - 1.0) / kappa, phi);
                let (step, step1) = decay(-sudden, -sudden * xi / kappa, phi);
                (sudden + step + (phi - 2.0 * xi + rise) / TURN, step1 + (1.0 + rise1) / TURN)
            };
            let (y_end, y1_end) = loaded(TURN);
            let free = |phi: f64| decay(y_end, (y1_end + xi * y_end) / kappa, phi);
            let (mut y_max, mut y1_max, mut a_max) = (0.0, 0.0, 0.0);
            for i in 0..=80_000 {
                let phi = f64::from(i) * 1e-4;
                for (y, y1) in [loaded(phi), free(phi)] {
                    y_max = larger(y_max, y.abs());
                    y1_max = larger(y1_max, y1.abs());
                    a_max = larger(a_max, (y + 2.0 * xi * y1).abs());
                }
            }
            let m = found(&[sudden, sudden + 1.0], xi);
            close(m.y, y_max);
            close(m.y1, y1_max);
            close(m.a, a_max);
        }
    }
}
