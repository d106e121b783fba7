//! The nonlinear engine: walls that yield and crack, in large rotations, with the liquid of linear theory.

mod options;
mod strip;

pub use options::{Contact, Damping, Integration, MassProportionalAt, NonlinearOptions, ThicknessRule, WallElements};
pub use strip::Strip;
