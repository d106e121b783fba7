//! Arbitrary start vectors and right-hand sides.

use crate::Matrix;

/// Numbers in (−1, 1) that are the same in every run (xorshift, Marsaglia 2003).
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new() -> Noise {
        Noise(0x9E37_79B9_7F4A_7C15)
    }

    pub(crate) fn block(&mut self, rows: usize, cols: usize) -> Matrix {
        let mut out = Matrix::zeros(rows, cols);
        for v in &mut out.data {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            *v = (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        }
        out
    }
}
