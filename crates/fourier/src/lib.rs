//! Fast Fourier transforms of real series of any length, from `realfft`. A planner compiles the whole of `rustfft` for its number
//! type wherever it is named: a quarter of the code of `fem`. It is named here alone.
//!
//! ```text
//! forward     X_m = Σ_k x_k e^(−2πi mk/N),  m = 0 … N/2
//! inverse     N x_k from X_m; the imaginary parts of X_0 and, for even N, of X_(N/2) are zero
//! ```

use std::sync::Arc;

use realfft::RealFftPlanner;
pub use realfft::num_complex::Complex64;
pub use realfft::{ComplexToReal, RealToComplex};

/// Both transforms of series of one length.
#[derive(Clone)]
pub struct Transforms {
    /// Series to harmonics.
    pub forward: Arc<dyn RealToComplex<f64>>,
    /// Harmonics to the series, times its length.
    pub inverse: Arc<dyn ComplexToReal<f64>>,
}

impl Transforms {
    /// Transforms of series of `length` numbers.
    pub fn new(length: usize) -> Transforms {
        let mut planner = RealFftPlanner::new();
        Transforms { forward: planner.plan_fft_forward(length), inverse: planner.plan_fft_inverse(length) }
    }
}
