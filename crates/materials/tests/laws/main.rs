//! Checks that every stress law must pass. A law joins by a line in [`registry`].
//!
//! | check | what it asks |
//! |---|---|
//! | `tangents` | the tangent is the derivative of the stress, on random paths |
//! | `frames` | turning the whole strain path turns the stress |
//! | `dissipation` | no step gives energy back, no closed cycle of strain yields work |
//! | `restart` | a run split at any step repeats the whole run bit by bit |
//! | `idempotence` | answering again at the committed state changes nothing and dissipates nothing |

mod dissipation;
mod frames;
mod idempotence;
mod path;
mod registry;
mod restart;
mod tangents;
