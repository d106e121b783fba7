//! Cylinders: half a wall of shells (or the whole) and the condensed liquid, marched through the record.

mod around;
mod contact;
mod curve;
mod demands;
mod describe;
mod elements;
pub(crate) mod estimate;
mod extremes;
mod floor;
mod limits;
mod march;
mod meridian;
pub(super) mod mesh;
mod model;
mod pictures;
mod points;
mod recorded;
mod report;
mod rings;
pub(crate) mod section;
mod simulate;
mod slab;
mod standing;
mod standing_recorded;
mod state;
pub(super) mod two;
mod watch;

#[cfg(test)]
mod tests;

pub(super) use march::Cylinder;
pub(super) use simulate::simulate;
