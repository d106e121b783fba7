//! Limit states: what a code requires of a tank, and how each of them ends.
//!
//! A procedure declares its limit states before it computes. Each ends as a [`Check`]: a demand compared with a capacity, or a
//! reason why there is no comparison. A limit state never disappears.

use serde::{Deserialize, Serialize};

use crate::units::Dimension;

/// How a limit state ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CheckStatus {
    /// Checked; the demand exceeds the capacity.
    Fails,
    /// Required and not checked: input is missing, or the clause is not implemented.
    NotChecked,
    /// Not checked, and accepted by the user with a reason.
    Accepted,
    /// Checked; the demand is at most the capacity.
    Holds,
    /// Not required of this tank by the clause.
    NotApplicable,
}

impl CheckStatus {
    /// All, worst first.
    pub const ALL: [CheckStatus; 5] = [
        CheckStatus::Fails,
        CheckStatus::NotChecked,
        CheckStatus::Accepted,
        CheckStatus::Holds,
        CheckStatus::NotApplicable,
    ];
}

/// Whether a code requires a limit state of a tank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// It does, and the procedure checks it.
    Required,
    /// It does, and the procedure does not implement the clause.
    NotImplemented,
    /// Whether it does is not known without the input at this path of `tank.json`.
    Missing(String),
    /// It does not, for this reason.
    NotApplicable(String),
}

/// A limit state that a code names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LimitState {
    /// Stable id ("axial_buckling"); a check refers to it by [`Check::limit_state`].
    pub id: &'static str,
    /// What it is, in words.
    pub name: &'static str,
    /// Clause and edition.
    pub clause: String,
    /// Whether the code requires it of the tank at hand.
    pub requirement: Requirement,
}

/// How one limit state ends at its governing place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "Stored")]
pub struct Check {
    /// Stable id ("buckling_elastic").
    pub id: String,
    /// How it ends.
    pub status: CheckStatus,
    /// Id of the limit state that it belongs to.
    pub limit_state: String,
    /// What is checked, in words.
    pub name: String,
    /// Demand in SI, where it was computed.
    pub demand: Option<f64>,
    /// Capacity in SI, where it was computed.
    pub capacity: Option<f64>,
    /// demand / capacity; absent without a comparison, and where the capacity is ≤ 0 (such a check fails).
    pub utilisation: Option<f64>,
    /// Dimension of both.
    pub dimension: Dimension,
    /// Symbol of their SI unit.
    pub unit: String,
    /// Clause and edition.
    pub clause: String,
    /// Why there is no comparison, or why the gap is accepted; empty otherwise.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub reason: String,
    /// Who accepts the gap, and when.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accepted: Option<Approval>,
    /// Path in `tank.json` of the input that is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    /// Remark, may be empty.
    pub note: String,
    /// Time of the governing demand, of a demand that has a history [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time_s: Option<f64>,
    /// Its height above the base [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// Its angle from the direction of shaking [rad].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub theta: Option<f64>,
    /// Estimated discretisation error of the demand, relative.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// Whether the check holds and would not with the demand raised by its error.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub within_error: bool,
}

/// A check as earlier versions wrote it, or as this one does.
#[derive(Deserialize)]
struct Stored {
    id: String,
    name: String,
    demand: Option<f64>,
    capacity: Option<f64>,
    utilisation: Option<f64>,
    dimension: Dimension,
    clause: String,
    note: String,
    status: Option<CheckStatus>,
    limit_state: Option<String>,
    #[serde(default)]
    reason: String,
    accepted: Option<Approval>,
    input: Option<String>,
    time_s: Option<f64>,
    z: Option<f64>,
    theta: Option<f64>,
    error: Option<f64>,
    #[serde(default)]
    within_error: bool,
    /// In place of `status` until format 2.
    #[serde(default)]
    holds: bool,
}

impl From<Stored> for Check {
    fn from(stored: Stored) -> Check {
        let status = stored.status.unwrap_or(if stored.holds { CheckStatus::Holds } else { CheckStatus::Fails });
        Check {
            limit_state: stored.limit_state.unwrap_or_else(|| stored.id.clone()),
            id: stored.id,
            status,
            name: stored.name,
            demand: stored.demand,
            capacity: stored.capacity,
            utilisation: stored.utilisation,
            dimension: stored.dimension,
            unit: match stored.demand {
                Some(_) => stored.dimension.si_symbol().into(),
                None => String::new(),
            },
            clause: stored.clause,
            reason: stored.reason,
            accepted: stored.accepted,
            input: stored.input,
            note: stored.note,
            time_s: stored.time_s,
            z: stored.z,
            theta: stored.theta,
            error: stored.error,
            within_error: stored.within_error,
        }
    }
}

impl Check {
    /// A comparison, which holds while demand ≤ capacity; without a positive capacity it fails. Its limit state has its id.
    pub fn new(
        id: &str,
        name: &str,
        demand: f64,
        capacity: f64,
        dimension: Dimension,
        clause: &str,
        note: &str,
    ) -> Check {
        let utilisation = (capacity > 0.0).then(|| demand / capacity);
        let status = match utilisation {
            Some(utilisation) if utilisation <= 1.0 => CheckStatus::Holds,
            _ => CheckStatus::Fails,
        };
        Check {
            id: id.into(),
            status,
            limit_state: id.into(),
            name: name.into(),
            demand: Some(demand),
            capacity: Some(capacity),
            utilisation: utilisation.filter(|u| u.is_finite()),
            dimension,
            unit: dimension.si_symbol().into(),
            clause: clause.into(),
            reason: String::new(),
            accepted: None,
            input: None,
            note: note.into(),
            time_s: None,
            z: None,
            theta: None,
            error: None,
            within_error: false,
        }
    }

    /// A limit state without a comparison.
    pub fn without_comparison(state: &LimitState, status: CheckStatus, reason: &str, input: Option<&str>) -> Check {
        Check {
            id: state.id.into(),
            status,
            limit_state: state.id.into(),
            name: state.name.into(),
            demand: None,
            capacity: None,
            utilisation: None,
            dimension: Dimension::Dimensionless,
            unit: String::new(),
            clause: state.clause.clone(),
            reason: reason.into(),
            accepted: None,
            input: input.map(str::to_owned),
            note: String::new(),
            time_s: None,
            z: None,
            theta: None,
            error: None,
            within_error: false,
        }
    }

    /// The same check with time [s], height [m] and angle [rad] of its demand, where they are known.
    pub fn at(mut self, time_s: Option<f64>, z: Option<f64>, theta: Option<f64>) -> Check {
        (self.time_s, self.z, self.theta) = (time_s, z, theta);
        self
    }

    /// The same check with the estimated relative error of its demand.
    pub fn with_error(mut self, error: Option<f64>) -> Check {
        let larger = |utilisation: f64| error.is_some_and(|e| utilisation * (1.0 + e) > 1.0);
        self.within_error = self.holds() && self.utilisation.is_some_and(larger);
        self.error = error;
        self
    }

    /// The same check as part of another limit state.
    pub fn of(mut self, limit_state: &str) -> Check {
        self.limit_state = limit_state.into();
        self
    }

    /// Whether it was checked and holds.
    pub fn holds(&self) -> bool {
        self.status == CheckStatus::Holds
    }

    /// The same, not checked and without its numbers, as [`Check::without_comparison`] has it.
    ///
    /// * `reason`: why, a clause
    #[must_use]
    pub fn left_open(&self, reason: String) -> Check {
        Check {
            status: CheckStatus::NotChecked,
            reason,
            demand: None,
            capacity: None,
            utilisation: None,
            dimension: Dimension::Dimensionless,
            unit: String::new(),
            note: String::new(),
            time_s: None,
            z: None,
            theta: None,
            error: None,
            within_error: false,
            ..self.clone()
        }
    }

    /// Whether a demand was compared with a capacity.
    pub fn compared(&self) -> bool {
        matches!(self.status, CheckStatus::Holds | CheckStatus::Fails)
    }

    /// demand / capacity; infinite for a comparison without a positive capacity, absent without a comparison.
    pub fn ratio(&self) -> Option<f64> {
        self.compared().then(|| self.utilisation.unwrap_or(f64::INFINITY))
    }
}

/// Who accepts a gap, and when.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Approval {
    /// Name.
    pub by: String,
    /// Date, year-month-day.
    pub date: String,
}

/// A gap that the user accepts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Accepted {
    /// Limit state ("sliding"), of one method where it names that ("ec8-2006/sliding").
    pub check: String,
    /// Why.
    pub reason: String,
    /// Who, and when.
    pub approval: Approval,
}

impl Accepted {
    /// Whether it means this limit state of this method.
    pub fn means(&self, method: &str, limit_state: &str) -> bool {
        match self.check.split_once('/') {
            Some((of, state)) => of == method && state == limit_state,
            None => self.check == limit_state,
        }
    }
}

/// A part of a tank that a file describes, says that there is none of, or leaves unsaid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TankPart {
    /// Roof, or a mass on top of the wall.
    Roof,
    /// Foundation.
    Foundation,
    /// Bottom plate.
    Bottom,
    /// Anchors.
    Anchors,
    /// Pipes.
    Pipes,
}

impl TankPart {
    /// Its key in `tank`.
    pub fn key(self) -> &'static str {
        match self {
            TankPart::Roof => "roof",
            TankPart::Foundation => "foundation",
            TankPart::Bottom => "bottom",
            TankPart::Anchors => "anchors",
            TankPart::Pipes => "pipes",
        }
    }
}

/// Who decides about a tank, and which gaps are accepted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Decision {
    /// Ids of the methods that decide; empty for the editions in force that the site names.
    pub decide: Vec<String>,
    /// Accepted gaps.
    pub accepted: Vec<Accepted>,
    /// Parts of the tank of which nothing is said.
    pub unstated: Vec<TankPart>,
    /// Parts of which the file says that there are none.
    pub without: Vec<TankPart>,
}

/// Every declared limit state ends as a check: those that the procedure left out are added, with the reason. Checks are sorted
/// worst first: by status, then by utilisation, then in the order given.
pub fn complete(states: &[LimitState], mut checks: Vec<Check>) -> Vec<Check> {
    for state in states {
        if checks.iter().any(|check| check.limit_state == state.id) {
            continue;
        }
        checks.push(match &state.requirement {
            Requirement::NotApplicable(reason) => {
                Check::without_comparison(state, CheckStatus::NotApplicable, reason, None)
            }
            Requirement::NotImplemented => {
                let reason = format!("not implemented: {}", state.clause);
                Check::without_comparison(state, CheckStatus::NotChecked, &reason, None)
            }
            Requirement::Missing(input) => {
                let reason = format!("`{input}` is missing");
                Check::without_comparison(state, CheckStatus::NotChecked, &reason, Some(input))
            }
            Requirement::Required => {
                Check::without_comparison(state, CheckStatus::NotChecked, "the procedure gives no value for it", None)
            }
        });
    }
    checks.sort_by(|a, b| {
        let utilisation = |check: &Check| check.ratio().unwrap_or(0.0);
        a.status.cmp(&b.status).then(utilisation(b).total_cmp(&utilisation(a)))
    });
    checks
}

#[cfg(test)]
mod tests;
