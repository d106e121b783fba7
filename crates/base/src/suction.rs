//! How large the pressure of the motion on the bottom may be for strips under a rim that is not round.
//!
//! It lowers the hoop force of the lifted side, which resists the waves of the foot ([`crate::Warping`]). Up to 0.4 of the pressure at rest under a free rim
//! strips agree with shells that are pushed over. Beyond it, in the squat tank of `docs/theory/base.md`, section 2, strips under that pressure lift two to
//! three times as far, and strips of the codes, which leave it out, less than shells.

use crate::model::Base;

/// Largest bottom pressure of the motion over that at which the wall loses its stiffness against one combination of waves: where strips and shells that are
/// pushed over begin to differ, and in time. A squat tank had too little stress at the toe from 0.68 on, one of R/H = 1.5 enough at 0.63.
const AT_REST: f64 = 0.75;
const IN_TIME: f64 = 0.65;

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

    /// Why they do not hold, a clause.
    pub fn reason(&self) -> String {
        format!(
            "the bottom pressure of the motion reaches {:.2} of that at rest, above {:.2}, under a rim of the wall that is not round",
            self.share, self.limit
        )
    }

    /// The same with what follows for strips under that pressure.
    pub fn lifts_too_far(&self) -> String {
        format!(
            "{}: strips of the bottom plate lift up to three times as far as shells, with too little moment and toe stress",
            self.reason()
        )
    }

    /// The same for strips that leave that pressure out.
    pub fn left_out(&self) -> String {
        format!(
            "{}: strips of the bottom plate, which leave it out, lift less than shells and have too little stress at the toe",
            self.reason()
        )
    }
}

impl Base {
    /// A bottom pressure of the motion [Pa] beside the largest one for which the strips hold; `None` of a foot that stays plane and under a round rim.
    pub fn suction(&self, pressure: f64) -> Option<Suction> {
        let limit = AT_REST * self.warping.as_ref()?.softening()? / self.pressure;
        Some(Suction { share: pressure.abs() / self.pressure, limit })
    }

    /// The same of strips under a wall that ovals in time ([`crate::Waves`]).
    pub fn suction_in_time(&self, pressure: f64) -> Option<Suction> {
        let limit = IN_TIME * self.warping.as_ref()?.softening()? / self.pressure;
        Some(Suction { share: pressure.abs() / self.pressure, limit })
    }

    /// The same of a moment [N m] all of which is that of impulsive liquid on the wall.
    pub fn suction_with(&self, moment: f64) -> Option<Suction> {
        self.suction(self.warping.as_ref()?.suction_with(moment))
    }
}
