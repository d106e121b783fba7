//! Laws of concrete against closed forms, published formulas and the theory sheet of this project.

mod cracked;
mod cycles;
mod uniaxial;

use materials::{Law, Response};

/// Pseudo-random numbers, equal on every machine (xorshift of 64 bits).
struct Noise(u64);

impl Noise {
    fn new(seed: u64) -> Noise {
        Noise(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Uniform in −1 … 1.
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A point with its history.
struct Point<'a, const N: usize> {
    law: &'a dyn Law<N>,
    history: Vec<f64>,
}

impl<'a, const N: usize> Point<'a, N> {
    fn new(law: &'a dyn Law<N>) -> Self {
        let mut history = vec![0.0; law.history_len()];
        law.init_history(&mut history);
        Point { law, history }
    }

    /// Response without commitment.
    fn trial(&self, strain: &[f64; N]) -> Response<N> {
        let mut new = self.history.clone();
        self.law.respond(strain, &self.history, &mut new).unwrap()
    }

    /// Response, committed.
    fn step(&mut self, strain: &[f64; N]) -> Response<N> {
        let mut new = vec![f64::NAN; self.history.len()];
        let response = self.law.respond(strain, &self.history, &mut new).unwrap();
        self.history = new;
        response
    }
}
