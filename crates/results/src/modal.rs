//! The response of an engine mode by mode: what its history is compared with, ingredient by ingredient.

use serde::{Deserialize, Serialize};

/// A mode's largest response per unit of its pseudo-acceleration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModalPart {
    /// `sloshing`, `structural`, `rotational`, or [`REST`].
    pub kind: String,
    /// Number within its kind, from 1.
    pub number: usize,
    /// Period [s]; 0 of the rest, which follows the ground.
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Rise of the surface at the wall [s²].
    pub wave: f64,
    /// All masses together.
    pub total: Inertia,
    /// Wall and roof, where the engine separates them from the liquid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub structure: Option<[Inertia; 2]>,
    /// Membrane stresses of a cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stress: Option<ModalStress>,
}

/// Membrane stresses per unit of acceleration [Pa·s²/m].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModalStress {
    /// Hoop stress where the history has its largest.
    pub hoop: f64,
    /// Axial stress at the base.
    pub axial: f64,
}

impl ModalStress {
    /// What remains of a total without other parts.
    pub fn without(self, parts: &[ModalStress]) -> ModalStress {
        parts
            .iter()
            .fold(self, |rest, part| ModalStress { hoop: rest.hoop - part.hoop, axial: rest.axial - part.axial })
    }
}

/// Kind of the part that is not in the listed modes: higher modes, and what is clamped to the ground.
pub const REST: &str = "rest";

/// Base shear [kg] and moments [kg·m] per unit of acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Inertia {
    /// Base shear.
    pub shear: f64,
    /// Moment just above the base plate.
    pub moment: f64,
    /// Moment below it, with the pressure on the bottom.
    pub overturning: f64,
}

impl Inertia {
    /// What remains of a total without other parts.
    pub fn without(self, parts: &[Inertia]) -> Inertia {
        parts.iter().fold(self, |rest, part| Inertia {
            shear: rest.shear - part.shear,
            moment: rest.moment - part.moment,
            overturning: rest.overturning - part.overturning,
        })
    }
}

impl ModalPart {
    /// The liquid, if the engine separates it from wall and roof.
    pub fn liquid(&self) -> Option<Inertia> {
        self.structure.as_ref().map(|parts| self.total.without(parts))
    }
}
