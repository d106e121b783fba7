//! Reading `tank.json`, `study.json`, `set.json`, tables and accelerograms: text, units and file formats end here.

pub mod csv;
pub mod diagnostic;
pub mod fragility;
pub mod named;
pub mod records;
pub(crate) mod rotation;
pub mod set;
mod stdin;
pub mod study;
pub mod tank;
pub mod target;

pub use tank::{TankFile, read as read_tank};
