//! Why numbers of an engine are outside its model.

/// What the model of an engine leaves out where it matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// An unanchored wall pulls at its base, where the engine clamps it.
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
