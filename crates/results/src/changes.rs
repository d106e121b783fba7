//! What an engineer asks of two results: verdict, quantities and checks, matched by their ids.
//!
//! [`crate::numdiff`] compares every number of two folders by its place. Here methods, quantities and checks are matched by id; what only one
//! folder has is listed.

use std::collections::BTreeMap;

use serde::Serialize;
use tank::assessment::{Check, CheckStatus};
use tank::units::Dimension;

use crate::{Method, Results, VerdictStatus};

/// A verdict with its governing check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Side {
    /// Status.
    pub status: VerdictStatus,
    /// Method, check and utilisation that govern.
    pub governing: Option<(String, String, Option<f64>)>,
}

/// A quantity of a method that moved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovedQuantity {
    /// Method and excitation.
    pub method: String,
    /// Quantity.
    pub id: String,
    /// Dimension of both.
    #[serde(skip)]
    pub dimension: Dimension,
    /// Old value, SI.
    pub old: f64,
    /// New value, SI.
    pub new: f64,
    /// new/old − 1; none from 0.
    pub change: Option<f64>,
}

/// How a check ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ending {
    /// Status.
    pub status: CheckStatus,
    /// Utilisation.
    pub utilisation: Option<f64>,
}

/// A check that moved, appeared or vanished.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovedCheck {
    /// Method and excitation.
    pub method: String,
    /// Check.
    pub id: String,
    /// Before; none where it appeared.
    pub old: Option<Ending>,
    /// After; none where it vanished.
    pub new: Option<Ending>,
}

impl MovedCheck {
    /// Whether it ends otherwise than before, not only with another utilisation.
    pub fn turned(&self) -> bool {
        self.old.map(|e| e.status) != self.new.map(|e| e.status)
    }
}

/// The changes between two results.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Changes {
    /// Verdict before and after.
    pub verdict: [Side; 2],
    /// Quantities that moved, the largest change first.
    pub quantities: Vec<MovedQuantity>,
    /// Checks that moved: those that end otherwise first, then the largest change of utilisation.
    pub checks: Vec<MovedCheck>,
    /// Methods only in the old results.
    pub vanished: Vec<String>,
    /// Methods only in the new results.
    pub appeared: Vec<String>,
    /// Quantities and checks that are in both.
    pub compared: usize,
}

fn key(method: &Method) -> String {
    format!("{}/{}", method.id, method.excitation.word())
}

fn side(results: &Results) -> Side {
    let governing = results.verdict.governing.as_ref();
    Side {
        status: results.verdict.status,
        governing: governing.map(|g| (g.method.clone(), g.check.id.clone(), g.check.utilisation)),
    }
}

/// Checks by id; several of one id keep their order.
fn by_id(checks: &[Check]) -> BTreeMap<(String, usize), Ending> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    checks
        .iter()
        .map(|check| {
            let count = seen.entry(&check.id).or_default();
            *count += 1;
            let ending = Ending { status: check.status, utilisation: check.utilisation };
            ((check.id.clone(), *count), ending)
        })
        .collect()
}

/// Whether two numbers are the same within a relative tolerance.
fn same(old: f64, new: f64, rtol: f64) -> bool {
    (new - old).abs() <= rtol * old.abs().max(new.abs())
}

impl Changes {
    /// The changes from `old` to `new`.
    ///
    /// * `rtol`: relative to the larger of both values
    pub fn between(old: &Results, new: &Results, rtol: f64) -> Changes {
        let methods = |results: &Results| -> BTreeMap<String, Method> {
            results.methods.iter().map(|m| (key(m), m.clone())).collect()
        };
        let (before, after) = (methods(old), methods(new));
        let mut found = Changes {
            verdict: [side(old), side(new)],
            quantities: Vec::new(),
            checks: Vec::new(),
            vanished: before.keys().filter(|k| !after.contains_key(*k)).cloned().collect(),
            appeared: after.keys().filter(|k| !before.contains_key(*k)).cloned().collect(),
            compared: 0,
        };
        for (name, one) in &before {
            if let Some(other) = after.get(name) {
                found.method(name, one, other, rtol);
            }
        }
        let size = |q: &MovedQuantity| q.change.map_or(f64::INFINITY, f64::abs);
        found.quantities.sort_by(|a, b| size(b).total_cmp(&size(a)));
        let step = |c: &MovedCheck| {
            let value = |e: Option<Ending>| e.and_then(|e| e.utilisation).unwrap_or(0.0);
            (value(c.new) - value(c.old)).abs()
        };
        found.checks.sort_by(|a, b| b.turned().cmp(&a.turned()).then(step(b).total_cmp(&step(a))));
        found
    }

    fn method(&mut self, name: &str, old: &Method, new: &Method, rtol: f64) {
        for (id, value) in &old.quantities {
            let Some(other) = new.quantities.get(id) else { continue };
            self.compared += 1;
            if !same(value.value, other.value, rtol) {
                self.quantities.push(MovedQuantity {
                    method: name.into(),
                    id: id.clone(),
                    dimension: value.dimension,
                    old: value.value,
                    new: other.value,
                    change: (value.value != 0.0).then(|| other.value / value.value - 1.0),
                });
            }
        }
        let (before, after) = (by_id(&old.checks), by_id(&new.checks));
        let all: std::collections::BTreeSet<_> = before.keys().chain(after.keys()).collect();
        for id in all {
            let (one, other) = (before.get(id).copied(), after.get(id).copied());
            if let (Some(one), Some(other)) = (one, other) {
                self.compared += 1;
                let still = match (one.utilisation, other.utilisation) {
                    (Some(a), Some(b)) => same(a, b, rtol),
                    (a, b) => a == b,
                };
                if one.status == other.status && still {
                    continue;
                }
            }
            self.checks.push(MovedCheck { method: name.into(), id: id.0.clone(), old: one, new: other });
        }
    }

    /// Whether nothing changed.
    pub fn none(&self) -> bool {
        let [old, new] = &self.verdict;
        self.quantities.is_empty()
            && self.checks.is_empty()
            && self.vanished.is_empty()
            && self.appeared.is_empty()
            && old.status == new.status
    }
}
