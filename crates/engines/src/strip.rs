//! A long rectangular tank as a strip: walls of fibre beams or layered shells, and the liquid condensed in closed form.
//!
//! ```text
//!        z                       one wall of the strip at x = L, per metre of tank
//!        ▲  ┃                    wall: fibre beams, clamped or on a rotation spring at the base
//!    H_T ┤  ┃                    liquid: added mass and sloshing modes on its deflection ([`liquid`])
//!      H ┤~~┃                    at rest: hydrostatic pressure, and the weight of the wall
//!        └──┸──► x
//! ```
//!
//! The liquid is that of the antisymmetric motion: both walls move by the same. Walls that crack do not quite, since the
//! hydrostatic pressure bends them apart and the earthquake to one side; the neglected part is the liquid's response to the
//! difference of two wall deflections, far below that to the ground. The other wall is this one under the record with the
//! opposite sign: [`Side`]. Corners of real tanks are outside the model; concrete between them bends in plane strain, which
//! the caller puts into the law, E/(1 − ν²).
//!
//! With a [`LiquidMesh`] the liquid is a mesh of displacement elements instead, joined by contact elements to both walls in one model (`chain`).
//!
//! Where the joint of a condensed liquid may open ([`Contact`]) the liquid's face has its own displacement and carries the pressure at rest; joints
//! ([`fem::element::liquid_joint`]) stand between the two.
//!
//! * [`StripTank`]: parameters. [`StripModel`]: the model, its loads, damping and modes.
//! * [`StripModel::histories`]: both walls through an earthquake, with full histories ([`WallHistory`]).
//!   [`StripModel::run`]: one wall, its [`Demand`] alone; [`StripModel::incremental`]: both at rising scales.
//! * [`levels`]: nodes along a wall. [`ShellWall`]: shells and the layer between them in place of the beams.
//! * [`liquid`]: the liquid in closed form.
//!
//! `Strip` is such a model made from a case with its record: `simulate` runs it once, `Strip::incremental` at rising scales.

mod case;
mod chain;
mod contact;
mod curve;
mod demand;
mod describe;
pub(crate) mod estimate;
mod history;
pub mod liquid;
mod maps;
mod model;
mod modes;
mod parameters;
mod parts;
mod pictures;
mod placed;
mod report;
mod run;
pub(crate) mod section;
mod shell_wall;
pub(crate) mod shells;
mod simulate;
mod validity;
mod walls;

#[cfg(test)]
mod tests;

pub use chain::{Chain, WetLevel};
pub use contact::{Joints, Touch};
pub use demand::Demand;
pub use history::{Cell, EventKind, Picture, Scalar, WallEvent, WallHistory, WallState};
pub use model::{BaseReaction, StripModel};
pub use parameters::{Contact, LARGEST_DEFLECTION, LiquidMesh, StripError, StripTank, levels};
pub use parts::StripDamping;
pub use placed::PlacedWall;
pub use results::channel::Side;
pub use run::{StripLevel, StripQuake, StripRun, WallRun};
pub use shell_wall::{ShellRow, ShellWall};
pub use validity::{ACCELERATION, BAR_STRAIN, ENERGY_SHARE, MOMENT_SHARE};

pub(crate) use case::{ELEMENTS, Strip};
pub(crate) use simulate::simulate;
