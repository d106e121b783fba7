//! Strips: two walls of fibre beams or layered shells, and the condensed liquid, marched through the record.
//!
//! [`Strip`] is the model; [`simulate`] runs it once, [`Strip::incremental`] at rising scales.

mod build;
mod curve;
mod departures;
mod describe;
pub(super) mod estimate;
mod failure;
mod maps;
mod modes;
mod report;
pub(super) mod section;
pub(super) mod shells;
mod simulate;
mod walls;

#[cfg(test)]
mod tests;

pub(super) use build::{ELEMENTS, Strip};
pub(super) use simulate::simulate;
