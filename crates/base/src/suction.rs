//! How large the pressure of the motion on the bottom may be for strips under a rim that is not round.
//!
//! It lowers the hoop force of the lifted side, which resists the waves of the foot ([`crate::Warping`]). Up to 0.4 of the pressure at rest under a free rim
//! strips agree with shells; in the squat tank of `docs/theory/base.md`, section 2, they lift two to three times as far beyond it.

use crate::model::Base;

/// A bottom pressure of the motion beside the largest one for which the strips hold, both over the pressure at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suction {
    /// p_b/p.
    pub share: f64,
    /// The largest one for which the strips hold.
    pub limit: f64,
}

impl Suction {
    /// Whether the strips hold.
    pub fn holds(&self) -> bool {
        self.share <= self.limit
    }

    /// What follows where they do not, a clause.
    pub fn reason(&self) -> String {
        format!(
            "the bottom pressure of the motion reaches {:.2} of that at rest, above {:.2}: under a rim of the wall that is not round, strips of the \
             bottom plate lift too far and have 10 to 20 % too little moment and toe stress",
            self.share, self.limit
        )
    }
}

impl Base {
    /// A bottom pressure of the motion [Pa] beside the largest one for which the strips hold; `None` of a foot that stays plane and under a round rim.
    pub fn suction(&self, pressure: f64) -> Option<Suction> {
        let limit = self.warping.as_ref()?.largest_suction()? / self.pressure;
        Some(Suction { share: pressure.abs() / self.pressure, limit })
    }

    /// The same of a moment [N m] all of which is that of impulsive liquid on the wall.
    pub fn suction_with(&self, moment: f64) -> Option<Suction> {
        self.suction(self.warping.as_ref()?.suction_with(moment))
    }
}
