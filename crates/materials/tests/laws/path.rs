//! Random strain paths, and a point that follows them.

use materials::{Law, Response};

/// Random numbers from −1 to 1 of fixed seed (a linear congruence, its upper bits).
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new(seed: u64) -> Noise {
        Noise(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1u32 << 30) - 1.0
    }

    pub(crate) fn vector<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.next())
    }
}

/// Straight pieces between random corners of components up to `size`, `steps` steps a piece; some corners repeat
/// earlier ones, so that cracks close and yield surfaces are reached repeatedly.
pub(crate) fn wander<const N: usize>(noise: &mut Noise, size: f64, pieces: usize, steps: u32) -> Vec<[f64; N]> {
    let mut corners = vec![[0.0; N]];
    for i in 0..pieces {
        let corner = if i % 3 == 2 { corners[i / 2].map(|x| 0.5 * x) } else { noise.vector().map(|x| size * x) };
        corners.push(corner);
    }
    polygon(&corners, steps)
}

/// A closed path from 0 over random corners back to 0.
pub(crate) fn cycle<const N: usize>(noise: &mut Noise, size: f64, corners: usize, steps: u32) -> Vec<[f64; N]> {
    let mut all = vec![[0.0; N]];
    all.extend((0..corners).map(|_| noise.vector().map(|x| size * x)));
    all.push([0.0; N]);
    polygon(&all, steps)
}

fn polygon<const N: usize>(corners: &[[f64; N]], steps: u32) -> Vec<[f64; N]> {
    let mut path = Vec::new();
    for pair in corners.windows(2) {
        for i in 1..=steps {
            let t = f64::from(i) / f64::from(steps);
            path.push(std::array::from_fn(|k| pair[0][k] + t * (pair[1][k] - pair[0][k])));
        }
    }
    path
}

/// A point with its committed history.
#[derive(Clone)]
pub(crate) struct Point<'a, const N: usize> {
    pub(crate) law: &'a dyn Law<N>,
    pub(crate) history: Vec<f64>,
}

impl<'a, const N: usize> Point<'a, N> {
    pub(crate) fn new(law: &'a dyn Law<N>) -> Self {
        let mut history = vec![f64::NAN; law.history_len()];
        law.init_history(&mut history);
        Point { law, history }
    }

    /// Response without committing.
    pub(crate) fn answer(&self, strain: &[f64; N]) -> (Response<N>, Vec<f64>) {
        let mut new = vec![f64::NAN; self.history.len()];
        let response = self
            .law
            .respond(strain, &self.history, &mut new)
            .unwrap_or_else(|error| panic!("{} at {strain:?}: {error}", self.law.kind()));
        (response, new)
    }

    /// Response and commit.
    pub(crate) fn step(&mut self, strain: &[f64; N]) -> Response<N> {
        let (response, new) = self.answer(strain);
        self.history = new;
        response
    }
}

pub(crate) fn norm<const N: usize>(v: &[f64; N]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
