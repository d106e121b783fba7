//! Response analyses of a coupled system.
//!
//! | module | holds |
//! |---|---|
//! | [`motion`] | time steps and ground motion on them |
//! | [`observe`] | histories of scalars, extremes of everything else, in chunks of time |
//! | [`superpose`] | modal superposition, exact piecewise-linear, with missing mass |
//! | `blocks` | several systems as diagonal blocks of one |
//! | [`direct`] | direct Newmark integration on all unknowns, with energy balance |

mod blocks;
pub mod direct;
pub mod superpose;

pub use fem::analysis::{motion, observer as observe};
