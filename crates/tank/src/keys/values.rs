//! Values of keys: what the file has, and what the tank has of it.

use crate::value::Value;

/// Declares numbers in SI.
macro_rules! numbers {
    ($($(#[doc = $doc:literal])+ $name:ident;)*) => {$(
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name(pub f64);

        impl Value for $name {
            type Domain = f64;
            fn domain(self) -> f64 {
                self.0
            }
        }
    )*};
}

numbers! {
    /// A bare number, or a percentage.
    Number;
    /// A length.
    Length;
    /// An angle.
    Angle;
    /// A time.
    Time;
    /// A mass.
    Mass;
    /// A density.
    Density;
    /// A velocity.
    Velocity;
    /// A subgrade modulus.
    Subgrade;
    /// An acceleration.
    Acceleration;
    /// A force.
    Force;
    /// A stress, pressure or modulus.
    Stress;
    /// A force per length; an energy per area.
    LineForce;
    /// An area per length.
    LineArea;
    /// An area.
    Area;
    /// A second moment of area.
    SecondMoment;
    /// A mass per area.
    AreaMass;
    /// A temperature, kept in °C.
    Temperature;
    /// A mapped acceleration, kept in units of g.
    InG;
    /// A period, kept in seconds.
    Seconds;
    /// Where on the frequency axis: `"3 rad/s"`, `"0.48 Hz"` or the period `"2.1 s"`; kept as circular frequency [rad/s].
    Pitch;
}

/// A whole number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Whole(pub u32);

impl Value for Whole {
    type Domain = u32;
    fn domain(self) -> u32 {
        self.0
    }
}
