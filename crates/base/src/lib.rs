//! The base of a tank that is not held down.
//!
//! Under an overturning moment the wall lifts a crescent of the bottom plate. What holds the wall down is the liquid on that crescent:
//! the plate is a strip under pressure that spans from the rim to where it meets the ground again. A strip gives the hold-down force
//! for every uplift of the rim ([`Strip`], [`Curve`]); strips side by side around the circumference give the moment for every
//! rotation of the base ([`Rocking`]).
//!
//! ```text
//! Case → Strip (plate, ground, edge of the wall) → Curve F(w) → Rocking M(ψ)
//! ```
//!
//! Everything is per metre of the rim where it is not said otherwise; lengths in m, forces in N, uplift positive.
//!
//! Sources: Malhotra & Veletsos 1994 (strips side by side); Wozniak & Mitchell 1978 (two plastic hinges).

mod anchors;
mod band;
pub mod closed;
mod curve;
mod drag;
mod edge;
mod element;
mod error;
mod foot;
mod ground;
mod halves;
mod heave;
pub mod history;
mod law;
mod march;
mod mesh;
pub mod model;
mod plate;
mod response;
mod rocking;
mod stand;
mod strip;
mod suction;
#[cfg(test)]
mod tests;
mod warp;
mod waves;

pub use anchors::{Anchors, Bolts, Cost, Pull, Ring};
pub use curve::Curve;
pub use drag::Drag;
pub use edge::Edge;
pub use error::BaseError;
pub use ground::{Soil, subgrade_modulus};
pub use heave::Heave;
pub use law::{Law, Losses, Spring};
pub use march::{Lifted, Point};
pub use model::{Base, FOLLOWED, Missing, Origin};
pub use plate::{Bands, Plate};
pub use response::Response;
pub use rocking::{Rocking, Turn, plane_section};
pub use stand::{PlatePoint, Stand, Stands};
pub use strip::{Plan, Rim, Strip};
pub use suction::Suction;
pub use warp::{Top, WAVES, Warping};
pub use waves::Waves;
