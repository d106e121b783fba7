//! Strains and resultants in a tangent frame turned about the normal.
//!
//! ```text
//! e_1' = c e_1 + s e_2 ,  e_2' = −s e_1 + c e_2 ,  E' = T E ,  S = Tᵀ S' ,  C = Tᵀ C' T
//! ```

use crate::element::shell::section::SectionResponse;

/// Cosine and sine of the angle from the element's first axis to the section's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn {
    cosine: f64,
    sine: f64,
}

impl Turn {
    /// No turn.
    pub(super) const NONE: Turn = Turn { cosine: 1.0, sine: 0.0 };

    pub(super) fn new(cosine: f64, sine: f64) -> Turn {
        Turn { cosine, sine }
    }

    pub(super) fn cosine(self) -> f64 {
        self.cosine
    }

    pub(super) fn sine(self) -> f64 {
        self.sine
    }

    /// T E.
    pub(super) fn strain(self, v: &[f64; 8]) -> [f64; 8] {
        if self == Turn::NONE {
            return *v;
        }
        let (c, s) = (self.cosine, self.sine);
        let (cc, ss, cs) = (c * c, s * s, c * s);
        let plane = |a: f64, b: f64, g: f64| {
            [cc * a + ss * b + cs * g, ss * a + cc * b - cs * g, 2.0 * cs * (b - a) + (cc - ss) * g]
        };
        let ([e1, e2, g], [k1, k2, t]) = (plane(v[0], v[1], v[2]), plane(v[3], v[4], v[5]));
        [e1, e2, g, k1, k2, t, c * v[6] + s * v[7], c * v[7] - s * v[6]]
    }

    /// Tᵀ S'.
    pub(super) fn resultants_back(self, v: &[f64; 8]) -> [f64; 8] {
        if self == Turn::NONE {
            return *v;
        }
        let (c, s) = (self.cosine, self.sine);
        let (cc, ss, cs) = (c * c, s * s, c * s);
        let plane = |a: f64, b: f64, h: f64| {
            [cc * a + ss * b - 2.0 * cs * h, ss * a + cc * b + 2.0 * cs * h, cs * (a - b) + (cc - ss) * h]
        };
        let ([n1, n2, n], [m1, m2, m]) = (plane(v[0], v[1], v[2]), plane(v[3], v[4], v[5]));
        [n1, n2, n, m1, m2, m, c * v[6] - s * v[7], c * v[7] + s * v[6]]
    }

    /// Tᵀ S' and Tᵀ C' T.
    pub(super) fn back(self, section: &mut SectionResponse) {
        if self == Turn::NONE {
            return;
        }
        section.resultants = self.resultants_back(&section.resultants);
        // (Tᵀ C' T)ᵀ = Tᵀ (Tᵀ C')ᵀ: the columns, then the rows.
        for _ in 0..2 {
            let c = section.tangent;
            for j in 0..8 {
                section.tangent[j] = self.resultants_back(&std::array::from_fn(|i| c[i][j]));
            }
        }
    }
}
