//! What the user may choose of the engines, with its defaults: plain data in SI, without the engines themselves.

pub mod linear;
pub mod nonlinear;
pub mod solid;

pub use linear::LinearOptions;
pub use nonlinear::NonlinearOptions;
pub use solid::SolidOptions;

/// Largest memory of a run [MiB] unless the user says otherwise.
pub const MEMORY_LIMIT_MIB: u64 = 4096;
