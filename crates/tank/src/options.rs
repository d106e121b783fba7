//! Options of the engines with their defaults: plain data in SI, without the engines themselves.

pub mod after_record;
pub mod frequency;
pub mod linear;
pub mod nonlinear;
pub mod solid;

pub use after_record::AfterRecord;
pub use linear::LinearOptions;
pub use nonlinear::NonlinearOptions;
pub use solid::SolidOptions;

/// Default of the largest memory of a run [MiB].
pub const MEMORY_LIMIT_MIB: u64 = 4096;
