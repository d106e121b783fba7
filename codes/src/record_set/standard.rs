//! The rules: what a set of records must keep, and which value of its responses is the design value.

use serde::{Deserialize, Serialize};

/// A code with rules for sets of records.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Standard {
    /// EN 1998-1:2004.
    #[serde(rename = "en1998-1")]
    En1998,
    /// ASCE/SEI 7-16 chapter 16, recalled.
    #[serde(rename = "asce7-16")]
    Asce716,
}

/// Which value of the responses to the records of a set is the design value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Combine {
    /// Mean of the maxima.
    Mean,
    /// Largest maximum.
    Worst,
}

impl Combine {
    /// As in files.
    pub fn id(self) -> &'static str {
        match self {
            Combine::Mean => "mean",
            Combine::Worst => "worst",
        }
    }
}

impl Standard {
    /// All codes.
    pub const ALL: [Standard; 2] = [Standard::En1998, Standard::Asce716];

    /// As in files.
    pub fn id(self) -> &'static str {
        match self {
            Standard::En1998 => "en1998-1",
            Standard::Asce716 => "asce7-16",
        }
    }

    /// Clause on the spectrum of a set.
    pub fn clause(self) -> &'static str {
        match self {
            Standard::En1998 => "EN 1998-1:2004 3.2.3.1.2(4)",
            Standard::Asce716 => "ASCE/SEI 7-16 16.2",
        }
    }

    /// Clause on the design value.
    pub fn design_clause(self) -> &'static str {
        match self {
            Standard::En1998 => "EN 1998-1:2004 4.3.3.4.3(3)",
            Standard::Asce716 => "ASCE/SEI 7-16 16.2.2 and 16.4",
        }
    }

    /// Fewest records of a set whose spectrum is accepted.
    pub fn fewest(self) -> usize {
        match self {
            Standard::En1998 => 3,
            Standard::Asce716 => 11,
        }
    }

    /// Fewest records whose mean is the design value; of fewer it is the largest.
    pub fn fewest_for_mean(self) -> usize {
        match self {
            Standard::En1998 => 7,
            Standard::Asce716 => 11,
        }
    }

    /// The combination for a number of records.
    pub fn combine(self, count: usize) -> Combine {
        if count >= self.fewest_for_mean() { Combine::Mean } else { Combine::Worst }
    }

    /// Part of the target that the mean spectrum may fall to.
    pub fn share(self) -> f64 {
        0.9
    }

    /// The range of periods over T₁.
    pub fn range(self) -> [f64; 2] {
        [0.2, 2.0]
    }

    /// Whether the mean of the peaks must reach the target at T = 0.
    pub fn asks_for_peak(self) -> bool {
        self == Standard::En1998
    }
}
