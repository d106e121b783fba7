//! Laws that every element must obey. An element joins by an entry in [`registry`]; [`sources`] fails for an element without entry.
//!
//! | law | requirement |
//! |---|---|
//! | `tangent` | the tangent is the derivative of the force, before and after a committed step, and symmetric |
//! | `rigid` | rigid motions leave no force, but those that the element is there to resist |
//! | `frame` | an element built and moved in turned axes answers with turned forces and matrices; a rotation on top of a deformed element with finite rotations turns its forces |
//! | `restart` | an answer depends on motion and committed history alone: a run split at any step repeats the whole bit by bit |
//! | `mass` | mass and damping are symmetric, the mass sums up to the hand calculation and the weight to the mass |
//! | `abilities` | contact, inspection, mixed tangent and buckling agree with the element itself |
//!
//! Exceptions are listed in the entry with a reason ([`specimen`]), and the suite checks that each is
//! real: a spring to the ground must resist, a massless element must have no mass.

mod abilities;
mod frame;
mod mass;
mod motion;
mod registry;
mod restart;
mod rigid;
mod sources;
mod specimen;
mod tangent;
