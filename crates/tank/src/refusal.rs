//! Input that an engine or a procedure rejects: the place, the value found, the values allowed.
//!
//! An engine names a place in the case; the reader of the file maps it to keys.

/// Place in the input.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// Shape of the tank.
    Shape,
    /// Its support.
    Support,
    /// Joint between its wall and its base.
    WallBase,
    /// Staging under it.
    Staging,
    /// Mass of its roof.
    Roof,
    /// A course, counted from 0.
    Course(usize),
    /// The concrete of this material.
    Concrete(String),
    /// The law of that concrete.
    Law(String),
    /// Changes of volume of this material.
    VolumeChange(String),
    /// Temperature of the wall at rest.
    Temperature,
    /// The interlayer of this material.
    Interlayer(String),
    /// Formulation of the liquid in three dimensions.
    Liquid,
    /// Rotation penalty of a displacement liquid.
    RotationPenalty,
    /// Number of elements over the height.
    Rows,
    /// Number of elements around the tank.
    Sectors,
    /// Ground motion along y.
    Transverse,
    /// Rotation of the base.
    Rotation,
    /// Deviations of the wall from the perfect cylinder.
    Imperfections,
    /// Dashpots of the linear engines.
    Dashpots,
}

/// A rejected input.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Where.
    pub place: Place,
    /// What is wrong.
    pub message: String,
    /// The value found; empty if the place implies it.
    pub found: String,
    /// The values allowed.
    pub allowed: String,
    /// How to correct it; may be empty.
    pub help: String,
}

impl Refusal {
    /// Without found value and help.
    pub fn new(place: Place, message: impl Into<String>, allowed: impl Into<String>) -> Refusal {
        Refusal { place, message: message.into(), found: String::new(), allowed: allowed.into(), help: String::new() }
    }

    /// With the value found.
    pub fn found(mut self, found: impl Into<String>) -> Refusal {
        self.found = found.into();
        self
    }

    /// With how to correct it.
    pub fn help(mut self, help: impl Into<String>) -> Refusal {
        self.help = help.into();
        self
    }
}
