//! Simplifications of a procedure against a time history, as far as they explain differences.

/// The simplifications of a procedure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Approach {
    /// Largest wave.
    pub wave: Wave,
    /// Convective mass.
    pub convective_mass: ConvectiveMass,
    /// Shear, moments and stresses.
    pub forces: Forces,
}

/// Where a procedure takes the largest wave from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wave {
    /// One mode with the denominator of finite angles (Housner).
    FiniteAngle,
    /// The first mode at its spectral peak, 0.84 R S_e/g.
    SpectralPeak,
    /// The first mode at a period from a fitted formula, 0.42 D A_f.
    FittedPeriod,
}

/// The convective mass of a procedure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConvectiveMass {
    /// All that is not impulsive.
    AllModes,
    /// The first mode with Housner's coefficient of 1957.
    Coefficient1957,
    /// A fit to the first mode, 0.230 D/H.
    Fit,
}

/// How a procedure loads the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forces {
    /// The impulsive mass moves with the ground.
    RigidWall,
    /// The impulsive mass has the acceleration of the first mode; maxima are added.
    FirstMode,
    /// The impulsive mass has one acceleration, whatever its period; maxima are added.
    AnyPeriod,
    /// The impulsive mass has the acceleration at a period of a fitted coefficient; maxima are combined by square roots.
    FittedPeriod,
}
