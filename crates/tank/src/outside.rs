//! Why numbers of an engine are outside its model.

/// What the model of an engine leaves out where it matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// The wall lifts off, where the engine clamps it: an unanchored one that pulls at its base, or one that moves further than is followed.
    Uplift,
    /// The walls of a box bend as plates held at three sides, where the engine has cantilevers.
    Plates,
}

impl Outside {
    /// All of them.
    pub const ALL: [Outside; 2] = [Outside::Uplift, Outside::Plates];

    /// Id of the limit state that stays open because of it, whatever the user accepts.
    pub fn limit_state(self) -> &'static str {
        match self {
            Outside::Uplift => "uplift_tension",
            Outside::Plates => "plane_walls",
        }
    }
}
