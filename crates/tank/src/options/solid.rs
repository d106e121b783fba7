//! Options of the three-dimensional engine.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::MEMORY_LIMIT_MIB;
use crate::imperfection::Imperfections;
use crate::words;

words! {
    /// Formulation of the liquid in the three-dimensional engine.
    pub Liquid as LiquidElement {
        /// Displacement potential on hexahedra.
        Potential = "potential",
        /// Displacements in convective coordinates with a rotation penalty, joined to the wall by contact elements.
        Displacement = "displacement",
    }
}

/// Options of the three-dimensional engine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolidOptions {
    /// Numbers of elements; by the mesh rule of the theory manual if `None`.
    pub mesh: Option<MeshSize>,
    /// Formulation of the liquid.
    pub liquid: Liquid,
    /// Penalty K_rot [Pa] of the displacement liquid as [B02] has it, volume part at one point and full rotation part; `None`: mean
    /// dilatation and a split penalty, which needs no calibration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotation_penalty: Option<f64>,
    /// Largest memory of matrices and factors [MiB]; a larger model is refused before the run.
    pub memory_limit_mib: u64,
    /// Time between the states kept for pictures [s]; `None` keeps none.
    pub snapshot_interval: Option<f64>,
    /// Whether they hold the inside of the liquid, not wall and surface alone.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub snapshot_inside: bool,
    /// Whether the harmonic engine keeps more of them where the wall moves most, so that its first period is resolved there.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub snapshot_close: bool,
    /// Deviations of the wall from the perfect cylinder.
    #[serde(default, skip_serializing_if = "Imperfections::is_empty")]
    pub imperfections: Imperfections,
    /// Whether the wall moves about its loaded state, whose forces stiffen it; `None`: if it has imperfections.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial_stress: Option<bool>,
}

impl SolidOptions {
    /// The defaults.
    pub const DEFAULT: SolidOptions = SolidOptions {
        mesh: None,
        liquid: Liquid::Potential,
        rotation_penalty: None,
        memory_limit_mib: MEMORY_LIMIT_MIB,
        snapshot_interval: None,
        snapshot_inside: false,
        snapshot_close: false,
        imperfections: Imperfections::NONE,
        initial_stress: None,
    };

    /// Whether the wall moves about its loaded state.
    pub fn about_loaded_state(&self) -> bool {
        self.initial_stress.unwrap_or(!self.imperfections.is_empty())
    }
}

impl Default for SolidOptions {
    fn default() -> Self {
        SolidOptions::DEFAULT
    }
}

/// Numbers of elements, written `12x16x20`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MeshSize {
    /// Over the radius (or half length).
    pub radial: usize,
    /// Over the circumference (or the breadth of a rectangle).
    pub sectors: usize,
    /// Over the height of the wall.
    pub vertical: usize,
}

/// Most elements in one direction: beyond it a number is a slip of the finger, not a mesh.
const MOST: usize = 1000;

impl MeshSize {
    /// Allowed values, for messages.
    pub const ALLOWED: &str =
        "RADIALxSECTORSxVERTICAL, three whole numbers of elements from 1 to 1000 such as 12x16x20";
}

impl std::fmt::Display for MeshSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}x{}", self.radial, self.sectors, self.vertical)
    }
}

/// A text that is not a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("found `{found}`, allowed {}", MeshSize::ALLOWED)]
pub struct MeshSizeError {
    /// The text.
    pub found: String,
}

impl FromStr for MeshSize {
    type Err = MeshSizeError;

    /// Reads `12x16x20`; `×` and `X` serve as well, blanks around the numbers are skipped.
    fn from_str(text: &str) -> Result<MeshSize, MeshSizeError> {
        let fault = || MeshSizeError { found: text.into() };
        // Digits only: `parse` alone accepts a sign.
        let count = |part: &str| {
            let part = part.trim();
            let digits = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
            let count = digits.then(|| part.parse().ok()).flatten();
            count.filter(|n| (1..=MOST).contains(n)).ok_or_else(fault)
        };
        let parts: Vec<&str> = text.split(['x', 'X', '×']).collect();
        let [radial, sectors, vertical] = parts[..] else { return Err(fault()) };
        Ok(MeshSize { radial: count(radial)?, sectors: count(sectors)?, vertical: count(vertical)? })
    }
}

crate::value::own!(MeshSize);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_positive_counts_and_nothing_else() {
        let mesh = MeshSize { radial: 12, sectors: 16, vertical: 20 };
        for text in ["12x16x20", "12 x 16 x 20", "12X16×20"] {
            assert_eq!(text.parse(), Ok(mesh), "{text}");
        }
        assert_eq!(mesh.to_string(), "12x16x20");
        for text in [
            "",
            "x",
            "12",
            "12x16",
            "12x16x20x4",
            "0x16x20",
            "12x-16x20",
            "+12x16x20",
            "12x16x1001",
            "12x1.5x20",
            "axbxc",
            "12x16x",
            "99999999999999999999x1x1",
        ] {
            let error = text.parse::<MeshSize>().expect_err(text);
            assert!(error.to_string().contains("12x16x20"), "{text}");
        }
    }
}
