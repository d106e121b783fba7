//! Reading `tank.json`, tables of tanks and accelerograms: text, units and file formats end here.

pub mod csv;
pub mod diagnostic;
pub mod records;
pub mod tank;

pub use tank::{TankFile, read as read_tank};
