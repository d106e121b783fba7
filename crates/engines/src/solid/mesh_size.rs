//! Numbers of elements as users write them: `12x16x20`.

use std::str::FromStr;

/// Numbers of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// What is allowed, for messages.
    pub const ALLOWED: &str =
        "RADIALxSECTORSxVERTICAL, three whole numbers of elements from 1 to 1000 such as 12x16x20";
}

impl std::fmt::Display for MeshSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}x{}", self.radial, self.sectors, self.vertical)
    }
}

/// Text that is no mesh.
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
        // Digits only: `parse` alone would take a sign.
        let count = |part: &str| {
            let part = part.trim();
            let digits = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
            let count = digits.then(|| part.parse().ok()).flatten();
            count.filter(|n| (1..=MOST).contains(n)).ok_or_else(fault)
        };
        let parts: Vec<&str> = text.split(['x', 'X', '×']).collect();
        let [radial, sectors, vertical] = parts[..] else {
            return Err(fault());
        };
        Ok(MeshSize {
            radial: count(radial)?,
            sectors: count(sectors)?,
            vertical: count(vertical)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_positive_counts_and_nothing_else() {
        let mesh = MeshSize {
            radial: 12,
            sectors: 16,
            vertical: 20,
        };
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
