//! Checks that every stress law must pass. Add a law with a line in [`registry`].
//! | check | requirement |
//! |---|---|
//! | `tangents` | the tangent is the derivative of the stress, on random paths |
//! | `frames` | rotating the whole strain path rotates the stress |
//! | `dissipation` | dissipation is never negative, closed cycles of strain do not produce work |
//! | `restart` | a run split at any step equals the whole run bit for bit |
//! | `range` | in the elastic range the response is C ε; the range is convex |
//! | `idempotence` | a second response at the committed state is equal, with zero dissipation |

mod dissipation;
mod frames;
mod idempotence;
mod path;
mod range;
mod registry;
mod restart;
mod tangents;
