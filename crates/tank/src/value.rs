//! A value of a key: what the file has, and what the tank has of it.

/// A value of a key of the tank file.
pub trait Value: 'static {
    /// What the tank has of it.
    type Domain;
    /// What the tank has of it.
    fn domain(self) -> Self::Domain;
}

/// Makes types values that the tank has as the file gives them.
macro_rules! own {
    ($($name:ty),+) => {$(
        impl $crate::value::Value for $name {
            type Domain = Self;
            fn domain(self) -> Self {
                self
            }
        }
    )+};
}

own!(bool, String);

pub(crate) use own;
