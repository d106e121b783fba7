//! Response analyses of a coupled system.
//!
//! | module | holds |
//! |---|---|
//! | [`motion`] | time steps and ground motion on them |
//! | [`observe`] | histories of scalars, extremes of everything else, in chunks of time |
//! | [`superpose`] | modal superposition, exact piecewise-linear, with missing mass |
//! | [`direct`] | direct Newmark integration on all unknowns, with energy balance |

pub mod direct;
pub mod superpose;

pub use fem::analysis::{motion, observer as observe};
