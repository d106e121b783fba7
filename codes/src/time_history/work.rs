//! An assessment of demands under construction.

use std::collections::BTreeMap;

use tank::assessment::{Check, CheckStatus, CourseHoop, LimitState};
use tank::case::Case;
use tank::demand::Demands;
use tank::quantity::Quantity;
use tank::units::Dimension;

use super::field::angle;
use super::ready::Ready;
use super::search::{Found, Search, Searched};
use crate::code::Code;
use crate::sheet::{Sheet, with_unit};

/// Where and when a demand governs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment {
    /// Time [s].
    pub(super) time: f64,
    /// Height [m].
    z: f64,
    /// Angle [rad].
    pub(super) theta: f64,
}

impl Moment {
    /// In words.
    pub(super) fn words(&self) -> String {
        let (z, time) = (with_unit(self.z, Dimension::Length), with_unit(self.time, Dimension::Time));
        format!("z = {z}, θ = {:.0}°, t = {time}", self.theta.to_degrees())
    }
}

/// The growing assessment.
pub(super) struct Work<'a> {
    pub(super) case: &'a Case,
    pub(super) codes: &'a [&'static dyn Code],
    pub(super) ready: &'a Ready<'a>,
    pub(super) demands: &'a Demands,
    /// Factor on the motion.
    pub(super) factor: f64,
    /// Relative mesh errors by quantity.
    errors: &'a BTreeMap<String, f64>,
    states: &'a [LimitState],
    pub(super) sheet: Sheet,
    pub(super) checks: Vec<Check>,
    /// Hoop stresses of the courses.
    pub(super) courses: Vec<CourseHoop>,
    pub(super) notes: Vec<String>,
}

impl<'a> Work<'a> {
    pub(super) fn new(
        (case, codes): (&'a Case, &'a [&'static dyn Code]),
        (ready, factor): (&'a Ready<'a>, f64),
        errors: &'a BTreeMap<String, f64>,
        states: &'a [LimitState],
    ) -> Work<'a> {
        Work {
            case,
            codes,
            ready,
            demands: ready.demands,
            factor,
            errors,
            states,
            sheet: Sheet::new(),
            checks: Vec::new(),
            courses: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// A place under the motion of this assessment.
    pub(super) fn search<'b>(&'b self, place: &'b Searched<'a>) -> Search<'b> {
        place.under(self.factor, &self.ready.directions)
    }

    /// A limit state without a comparison.
    pub(super) fn without(&mut self, id: &str, status: CheckStatus, reason: &str, input: Option<&str>) {
        if let Some(state) = self.states.iter().find(|state| state.id == id) {
            self.checks.push(Check::without_comparison(state, status, reason, input));
        }
    }

    /// A limit state whose `input` is missing.
    pub(super) fn missing(&mut self, id: &str, input: &str) {
        self.without(id, CheckStatus::NotChecked, &format!("`{input}` is missing"), Some(input));
    }

    /// Clause of a limit state.
    pub(super) fn clause(&self, id: &str) -> String {
        let state = self.states.iter().find(|state| state.id == id);
        state.map_or(String::new(), |state| state.clause.clone())
    }

    /// Where and when something was found at a height [m].
    pub(super) fn moment(&self, found: &Found, z: f64) -> Moment {
        Moment {
            time: self.demands.times.get(found.instant).copied().unwrap_or_default(),
            z,
            theta: angle(found.direction),
        }
    }

    /// Estimated relative error of a demand: the largest mesh error of its quantities and what lies between two instants, on its
    /// seismic part. None where the mesh error was not estimated.
    pub(super) fn error(&self, of: &[Quantity], found: &Found) -> Option<f64> {
        let errors: Option<Vec<f64>> = of.iter().map(|q| self.errors.get(q.id()).copied()).collect();
        let mesh = errors?.into_iter().fold(0.0, f64::max);
        let seismic = if found.demand > 0.0 { ((found.demand - found.rest) / found.demand).abs() } else { 0.0 };
        Some((mesh + self.demands.sampling) * seismic)
    }

    /// The mesh error of a quantity whose extremes are exact in time.
    pub(super) fn mesh_error(&self, of: Quantity) -> Option<f64> {
        self.errors.get(of.id()).copied()
    }
}
