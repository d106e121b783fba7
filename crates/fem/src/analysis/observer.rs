//! Observation of a response: histories of a few scalars, extremes of many, without keeping any history of the many.
//!
//! An analysis hands over its state in [`Chunk`]s of time. Every observed quantity is a [`Row`], a linear combination of
//! the state. A row is worked out over a chunk only if the extremes of the states there could exceed those found so
//! far:
//!
//! ```text
//! max_t Σ c_k s_k(t) ≤ Σ c_k m_k + |c_k| h_k          m_k, h_k: middle and half of the range of s_k
//! ```
//!
//! which leaves the strong part of the motion. Between the samples of the state the response is followed by the cubic
//! through values and slopes at both ends of a step, where the analysis provides slopes: with 20 steps a period its error
//! is (2π/20)⁴/384 = 2.5e-5 of the amplitude, while the samples alone may miss 1 − cos(π/20) = 1.2 %.

use std::collections::BTreeMap;

use super::motion::Grid;

/// A stretch of the state: `rows` states at `len` consecutive instants, the first of which is the last of the chunk
/// before.
#[derive(Clone, Debug)]
pub struct Chunk {
    /// Number of the first instant.
    pub start: usize,
    /// Number of instants, at most [`Chunk::LENGTH`] + 1.
    pub len: usize,
    data: Vec<f64>,
    /// Middle and half of the range of each state.
    ranges: Vec<[f64; 2]>,
}

impl Chunk {
    /// Steps in a full chunk.
    pub const LENGTH: usize = 32;
    const STRIDE: usize = Chunk::LENGTH + 1;

    /// An empty chunk of `rows` states.
    pub fn new(rows: usize) -> Chunk {
        Chunk { start: 0, len: 0, data: vec![0.0; rows * Chunk::STRIDE], ranges: vec![[0.0; 2]; rows] }
    }

    /// The instants of one state.
    pub fn state(&self, row: usize) -> &[f64] {
        &self.data[row * Chunk::STRIDE..][..self.len]
    }

    /// The instants of two neighbouring blocks of states at once: state `row` and state `other` > `row`.
    pub fn pair_mut(&mut self, row: usize, other: usize) -> (&mut [f64], &mut [f64]) {
        let (head, tail) = self.data.split_at_mut(other * Chunk::STRIDE);
        (&mut head[row * Chunk::STRIDE..][..self.len], &mut tail[..self.len])
    }

    /// The instants whose number is a multiple of `stride`, to be stepped through by it; without the first one if it is the last of the chunk before.
    pub(super) fn every(&self, stride: usize) -> std::ops::Range<usize> {
        let first = self.start + usize::from(self.start > 0);
        (first.next_multiple_of(stride) - self.start).min(self.len)..self.len
    }

    /// Sets one state at one instant.
    pub fn set(&mut self, row: usize, k: usize, value: f64) {
        self.data[row * Chunk::STRIDE + k] = value;
    }

    /// Works out the bounds of the states; to be called once the chunk is filled. False if a state is not finite.
    pub fn close(&mut self) -> bool {
        let mut finite = true;
        for (row, range) in self.ranges.iter_mut().enumerate() {
            let states = &self.data[row * Chunk::STRIDE..][..self.len];
            // Lanes beside each other: each waits for the one before.
            let (mut low, mut high, mut sum) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES], [0.0; LANES]);
            let mut add = |lane: usize, s: f64| {
                low[lane] = if s < low[lane] { s } else { low[lane] };
                high[lane] = if s > high[lane] { s } else { high[lane] };
                sum[lane] += s;
            };
            let (whole, rest) = states.as_chunks::<LANES>();
            for states in whole {
                for lane in 0..LANES {
                    add(lane, states[lane]);
                }
            }
            rest.iter().for_each(|&s| add(0, s));
            finite &= sum.iter().sum::<f64>().is_finite();
            let (low, high) =
                (low.iter().fold(f64::INFINITY, |m, &s| m.min(s)), high.iter().fold(-f64::INFINITY, |m, &s| m.max(s)));
            // Between samples 20 a period apart a sinusoid exceeds them by up to 1.2 %.
            *range = [0.5 * (low + high), 0.52 * (high - low)];
        }
        finite
    }
}

/// An observed quantity y = Σ c_k s_k, and its slope where the analysis provides it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// (state k, coefficient c_k).
    pub value: Vec<(usize, f64)>,
    /// Slope ẏ, if it is known.
    pub slope: Option<Slope>,
}

/// Slope of a row: a combination of the states, plus coefficients on the slope of states that are linear in a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slope {
    /// (state, coefficient).
    pub states: Vec<(usize, f64)>,
    /// (state that is linear between instants, coefficient of its slope).
    pub linear: Vec<(usize, f64)>,
}

impl Row {
    /// y at the instants of the chunk, summed in the order of the terms: on every machine the same bits.
    fn evaluate(&self, chunk: &Chunk, out: &mut [f64]) {
        pulp::Arch::new().dispatch(Evaluate { row: self, chunk, out });
    }

    /// Slopes h ẏ at both ends of the step from instant `k` to `k` + 1, times the step h.
    fn slopes(slope: &Slope, chunk: &Chunk, k: usize, h: f64) -> (f64, f64) {
        let at = |k: usize| slope.states.iter().map(|&(s, c)| c * chunk.state(s)[k]).sum::<f64>() * h;
        let linear: f64 = slope.linear.iter().map(|&(s, c)| c * (chunk.state(s)[k + 1] - chunk.state(s)[k])).sum();
        (at(k) + linear, at(k + 1) + linear)
    }
}

/// States, and rows whose bounds are summed, beside each other.
const LANES: usize = 4;

/// Coefficients of neighbouring rows by state, for the bounds of all of them at once.
#[derive(Clone, Debug)]
struct Neighbours(Vec<(usize, [f64; LANES])>);

impl Neighbours {
    /// At most [`LANES`] rows.
    fn of(rows: &[Row]) -> Neighbours {
        let mut terms: BTreeMap<usize, [f64; LANES]> = BTreeMap::new();
        for (lane, row) in rows.iter().enumerate() {
            for &(state, c) in &row.value {
                terms.entry(state).or_default()[lane] += c;
            }
        }
        Neighbours(terms.into_iter().collect())
    }
}

/// Lower and upper bounds of neighbouring rows in a chunk.
struct Bounds<'a> {
    rows: &'a Neighbours,
    chunk: &'a Chunk,
}

impl pulp::WithSimd for Bounds<'_> {
    type Output = [[f64; LANES]; 2];

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> [[f64; LANES]; 2] {
        let [mut low, mut high] = [[0.0; LANES]; 2];
        for &(state, ref coefficients) in &self.rows.0 {
            let [middle, half] = self.chunk.ranges[state];
            for lane in 0..LANES {
                let (at, away) = (coefficients[lane] * middle, coefficients[lane].abs() * half);
                low[lane] += at - away;
                high[lane] += at + away;
            }
        }
        [low, high]
    }
}

/// Registers of instants of a sum: a chunk but its last instant on machines with four in each.
const REGISTERS: usize = 8;

/// A row at the instants of a chunk. Each instant has its own lane, in which products and sums are rounded as they are without.
struct Evaluate<'a> {
    row: &'a Row,
    chunk: &'a Chunk,
    out: &'a mut [f64],
}

impl pulp::WithSimd for Evaluate<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) {
        let Evaluate { row, chunk, out } = self;
        let width = REGISTERS * S::F64_LANES;
        let mut first = 0;
        while first + width <= out.len() {
            // What is left of a chunk is a single instant: it goes along, where alone it would take as long as all others.
            let end = first + width;
            let single = end + 1 == out.len();
            let (mut sums, mut last) = ([simd.splat_f64s(0.0); REGISTERS], 0.0);
            for &(k, c) in &row.value {
                let state = chunk.state(k);
                let (values, _) = S::as_simd_f64s(&state[first..end]);
                if let Some(values) = values.first_chunk::<REGISTERS>() {
                    let factor = simd.splat_f64s(c);
                    for i in 0..REGISTERS {
                        sums[i] = simd.add_f64s(sums[i], simd.mul_f64s(factor, values[i]));
                    }
                }
                if single {
                    last += c * state[end];
                }
            }
            out[first..end].copy_from_slice(pulp::bytemuck::cast_slice(&sums));
            first = end;
            if single {
                out[end] = last;
                first += 1;
            }
        }
        let rest = &mut out[first..];
        rest.fill(0.0);
        for &(k, c) in &row.value {
            for (y, s) in rest.iter_mut().zip(&chunk.state(k)[first..]) {
                *y += c * s;
            }
        }
    }
}

/// Smallest and largest value of a quantity over time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Smallest value, at most 0 (the state of rest).
    pub min: f64,
    /// Its time [s].
    pub min_time: f64,
    /// Largest value, at least 0.
    pub max: f64,
    /// Its time [s].
    pub max_time: f64,
}

impl Extreme {
    /// At rest.
    pub const REST: Extreme = Extreme { min: 0.0, min_time: 0.0, max: 0.0, max_time: 0.0 };

    /// Largest absolute value and its time.
    pub fn peak(&self) -> (f64, f64) {
        if self.max >= -self.min { (self.max, self.max_time) } else { (-self.min, self.min_time) }
    }

    pub(crate) fn include(&mut self, value: f64, time: f64) {
        if value > self.max {
            (self.max, self.max_time) = (value, time);
        }
        if value < self.min {
            (self.min, self.min_time) = (value, time);
        }
    }
}

/// History of a scalar at the samples of the grid, with the extremes in between.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// Values at the samples.
    pub values: Vec<f64>,
    /// Extremes between and at samples.
    pub extreme: Extreme,
}

/// Observations of an analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// Histories of the scalar rows.
    pub scalars: Vec<History>,
    /// Extremes of the other rows.
    pub extremes: Vec<Extreme>,
}

/// Collects from chunk to chunk.
#[derive(Clone, Debug)]
pub struct Observer<'a> {
    scalars: &'a [Row],
    others: &'a [Row],
    neighbours: Vec<Neighbours>,
    grid: Grid,
    buffer: Vec<f64>,
    observed: Observed,
}

impl<'a> Observer<'a> {
    /// Observes histories of `scalars` and extremes of `others` on `grid`.
    pub fn new(scalars: &'a [Row], others: &'a [Row], grid: Grid) -> Observer<'a> {
        let empty = |_| History { values: Vec::with_capacity(grid.samples), extreme: Extreme::REST };
        Observer {
            scalars,
            others,
            neighbours: others.chunks(LANES).map(Neighbours::of).collect(),
            grid,
            buffer: vec![0.0; Chunk::STRIDE],
            observed: Observed {
                scalars: scalars.iter().map(empty).collect(),
                extremes: vec![Extreme::REST; others.len()],
            },
        }
    }

    /// Takes a closed chunk.
    pub fn take(&mut self, chunk: &Chunk) {
        let y = &mut self.buffer[..chunk.len];
        let sub = self.grid.sub_steps;
        let samples = chunk.every(sub);
        for (row, history) in self.scalars.iter().zip(&mut self.observed.scalars) {
            row.evaluate(chunk, y);
            history.values.extend(samples.clone().step_by(sub).map(|k| y[k]));
            widen(row, chunk, y, &self.grid, &mut history.extreme);
        }
        let arch = pulp::Arch::new();
        let groups = self.others.chunks(LANES).zip(self.observed.extremes.chunks_mut(LANES));
        for ((rows, extremes), neighbours) in groups.zip(&self.neighbours) {
            let [low, high] = arch.dispatch(Bounds { rows: neighbours, chunk });
            for (lane, (row, extreme)) in rows.iter().zip(extremes).enumerate() {
                if low[lane] < extreme.min || high[lane] > extreme.max {
                    row.evaluate(chunk, y);
                    widen(row, chunk, y, &self.grid, extreme);
                }
            }
        }
    }

    /// The observations.
    pub fn finish(self) -> Observed {
        self.observed
    }
}

/// Widens `extreme` by the values `y` of `row` at the instants of `chunk` and the cubics on both sides of their extremes.
fn widen(row: &Row, chunk: &Chunk, y: &[f64], grid: &Grid, extreme: &mut Extreme) {
    let (mut low, mut high) = (0, 0);
    for (k, &value) in y.iter().enumerate() {
        if value < y[low] {
            low = k;
        }
        if value > y[high] {
            high = k;
        }
    }
    for (k, beyond) in [(low, y[low] < 0.98 * extreme.min), (high, y[high] > 0.98 * extreme.max)] {
        if !beyond {
            continue;
        }
        let start = chunk.start + k;
        extreme.include(y[k], grid.time(start));
        let Some(slope) = &row.slope else { continue };
        for left in [k.checked_sub(1), Some(k)].into_iter().flatten() {
            if left + 1 < chunk.len {
                let (m0, m1) = Row::slopes(slope, chunk, left, grid.h());
                for s in stationary(y[left], m0, y[left + 1], m1).into_iter().flatten() {
                    let time = grid.time(chunk.start + left) + s * grid.h();
                    extreme.include(cubic(y[left], m0, y[left + 1], m1, s), time);
                }
            }
        }
    }
}

/// Cubic with the values y₀, y₁ and the slopes m₀, m₁ at s = 0 and 1.
fn cubic(y0: f64, m0: f64, y1: f64, m1: f64, s: f64) -> f64 {
    let d = y1 - y0;
    y0 + s * (m0 + s * (3.0 * d - 2.0 * m0 - m1 + s * (m0 + m1 - 2.0 * d)))
}

/// Where that cubic is stationary inside (0, 1).
fn stationary(y0: f64, m0: f64, y1: f64, m1: f64) -> [Option<f64>; 2] {
    let d = y1 - y0;
    // 3 a s² + 2 b s + m₀ = 0
    let (a, b) = (3.0 * (m0 + m1 - 2.0 * d), 3.0 * d - 2.0 * m0 - m1);
    let inside = |s: f64| (s > 0.0 && s < 1.0).then_some(s);
    let root = b * b - a * m0;
    if root < 0.0 {
        return [None, None];
    }
    // Without cancellation: q = −(b ± √…), s = q/a and m₀/q.
    let q = -(b + root.sqrt().copysign(b));
    if q == 0.0 {
        return [None, None];
    }
    [inside(m0 / q), if a == 0.0 { None } else { inside(q / a) }]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two states sin ωt, cos ωt with 20 samples a period; rows of known amplitude and extreme.
    fn observe(rows: &[Row], periods: f64) -> (Grid, Observed) {
        let omega = 7.0;
        let dt = std::f64::consts::TAU / omega / 20.0;
        let grid = Grid::new(dt, periods * 20.0 * dt, 0.0, dt);
        let mut observer = Observer::new(rows, rows, grid);
        let mut chunk = Chunk::new(2);
        while chunk.start < grid.steps() {
            chunk.len = (grid.steps() - chunk.start).min(Chunk::LENGTH) + 1;
            for k in 0..chunk.len {
                let t = grid.time(chunk.start + k);
                // Rows start at zero, then grow.
                let swell = 1.0 - (-0.1 * t).exp();
                chunk.set(0, k, swell * (omega * t).sin());
                chunk.set(1, k, swell * (omega * t).cos());
            }
            assert!(chunk.close());
            observer.take(&chunk);
            chunk.start += chunk.len - 1;
        }
        (grid, observer.finish())
    }

    /// The amplitude of a sin ωt + b cos ωt is √(a² + b²); the samples alone miss up to 1.2 %, the cubic 2.5e-5.
    #[test]
    fn extremes_lie_between_samples() {
        let omega = 7.0;
        let rows: Vec<Row> = (0..24)
            .map(|i| {
                let (a, b) = (f64::from(i) * 0.26).sin_cos();
                Row {
                    value: vec![(0, a), (1, b)],
                    slope: Some(Slope { states: vec![(0, -omega * b), (1, omega * a)], linear: Vec::new() }),
                }
            })
            .collect();
        let (grid, observed) = observe(&rows, 80.0);
        // Swell at the end: 1 − e^{−0.1·71.8} = 0.99924; an extreme is at most a period (0.9 s) earlier.
        for extreme in &observed.extremes {
            for value in [extreme.max, -extreme.min] {
                assert!((value - 0.9992).abs() < 2e-4, "{value}");
            }
            assert!(extreme.max_time > 70.0);
        }
        for (history, extreme) in observed.scalars.iter().zip(&observed.extremes) {
            assert_eq!(history.extreme, *extreme, "pruning must not change the result");
            assert_eq!(history.values.len(), grid.samples);
        }
    }

    #[test]
    fn cubic_finds_its_extremes() {
        // y = s (1 − s): values 0, 0, slopes 1, −1; maximum 1/4 at 1/2.
        let roots = stationary(0.0, 1.0, 0.0, -1.0);
        assert_eq!(roots.into_iter().flatten().collect::<Vec<_>>(), vec![0.5]);
        assert_eq!(cubic(0.0, 1.0, 0.0, -1.0, 0.5), 0.25);
        // y = (s − 0.2)(s − 0.7)(s − 1.4) has y' = 3s² − 4.6s + 1.4: roots 0.4195… and 1.1138….
        let y = |s: f64| (s - 0.2) * (s - 0.7) * (s - 1.4);
        let slope = |s: f64| 3.0 * s * s - 4.6 * s + 1.4;
        let roots: Vec<f64> = stationary(y(0.0), slope(0.0), y(1.0), slope(1.0)).into_iter().flatten().collect();
        assert_eq!(roots.len(), 1);
        assert!(slope(roots[0]).abs() < 1e-12);
    }

    /// Chunks of all lengths: y = Σ k (i + k) for k = 1 to 5 is 15 i + 55.
    #[test]
    fn rows_are_evaluated_at_every_instant() {
        let row = Row { value: (1..6_u32).map(|k| (k as usize, f64::from(k))).collect(), slope: None };
        let mut chunk = Chunk::new(6);
        for k in 0..6 {
            (0..Chunk::STRIDE).for_each(|i| chunk.set(k, i, (i + k) as f64));
        }
        for len in 1..=Chunk::STRIDE {
            chunk.len = len;
            let mut found = vec![f64::NAN; len];
            row.evaluate(&chunk, &mut found);
            assert!((0..len).all(|i| found[i] == (15 * i + 55) as f64), "{found:?}");
            chunk.close();
            let rows = Neighbours::of(std::slice::from_ref(&row));
            let [low, high] = pulp::Arch::new().dispatch(Bounds { rows: &rows, chunk: &chunk });
            assert!(low[0] <= found[0] && found[len - 1] <= high[0]);
        }
    }

    #[test]
    fn not_a_number_is_noticed() {
        let mut chunk = Chunk::new(1);
        chunk.len = 3;
        chunk.set(0, 1, f64::NAN);
        assert!(!chunk.close());
    }
}
