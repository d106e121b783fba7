//! The result of a code procedure: quantities, calculation sheet, checks, profiles over the height.
//!
//! Plain data: procedures fill it, results keep it, reports print it.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use crate::check::{Check, CheckStatus, LimitState, Requirement};
use crate::ingredients::Ingredients;
use crate::quantity::Quantity;
use crate::units::Dimension;

/// Ground motion of an assessment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Excitation {
    /// The spectrum of the record, comparable with the finite-element history.
    Record,
    /// The design spectrum of the site.
    Site,
}

impl Excitation {
    /// In a word: `record` or `site`.
    pub fn word(self) -> &'static str {
        match self {
            Excitation::Record => "record",
            Excitation::Site => "site",
        }
    }
}

/// One line of a calculation sheet, with its clause: a formula (symbol = formula = numbers = value), a look-up, or an
/// input, which has neither.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// Heading of the line ("Convective part").
    pub section: String,
    /// Symbol as in the source ("m_c").
    pub symbol: String,
    /// Its name.
    pub name: String,
    /// Formula in symbols, of which the value was computed; empty otherwise.
    pub formula: String,
    /// Formula with the numbers put in, empty without one.
    pub substitution: String,
    /// Table, figure, spectrum, series, iteration or integral that gave the value, in words; empty otherwise.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub look_up: String,
    /// Value in SI.
    pub value: f64,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// Clause and edition ("EN 1998-4:2006 A.2.1.3").
    pub clause: String,
}

impl Default for Step {
    fn default() -> Step {
        Step {
            section: String::new(),
            symbol: String::new(),
            name: String::new(),
            formula: String::new(),
            substitution: String::new(),
            look_up: String::new(),
            value: 0.0,
            dimension: Dimension::Dimensionless,
            clause: String::new(),
        }
    }
}

/// A quantity over the height of the wall at θ = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// Id: `pressure_impulsive`, `pressure_convective`, `pressure_dynamic`, `hoop_stress`, `axial_membrane_stress`, ….
    pub id: String,
    /// Title for the figure legend.
    pub title: String,
    /// Dimension of the values.
    pub dimension: Dimension,
    /// Heights z above the base [m], ascending.
    pub z: Vec<f64>,
    /// Values in SI, seismic part, absolute; of [`TOTAL_HOOP`] with the static part.
    pub values: Vec<f64>,
}

/// Hoop forces and hoop stress of a course where it is used most, static and seismic.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CourseHoop {
    /// Number of the course, from 1 at the base.
    pub course: usize,
    /// Height above the base [m].
    pub z: f64,
    /// Thickness that counts, net of corrosion [m].
    pub thickness: f64,
    /// Hydrostatic hoop force N_h [N/m]; this and the following none where the method does not give it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hydrostatic: Option<f64>,
    /// Impulsive hoop force N_i [N/m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub impulsive: Option<f64>,
    /// Convective hoop force N_c [N/m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub convective: Option<f64>,
    /// Hoop force of the vertical motion N_v [N/m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertical: Option<f64>,
    /// Hoop stress σ [Pa].
    pub stress: f64,
    /// Its limit [Pa]; none where a strength is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
}

impl CourseHoop {
    /// σ over its limit.
    pub fn utilisation(&self) -> Option<f64> {
        self.limit.filter(|limit| *limit > 0.0).map(|limit| self.stress / limit)
    }
}

/// Id of the profile of the hoop stress, static and seismic; the other profiles are the seismic part alone.
pub const TOTAL_HOOP: &str = "hoop_stress_total";

/// The result of one procedure under one excitation.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Assessment {
    /// Quantities this procedure defines, in SI.
    pub values: BTreeMap<Quantity, f64>,
    /// The calculation sheet, in order.
    pub steps: Vec<Step>,
    /// Checks.
    pub checks: Vec<Check>,
    /// Values over the height.
    pub profiles: Vec<Profile>,
    /// Hoop stresses course by course, of the wall of a metal cylinder.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub courses: Vec<CourseHoop>,
    /// Assumptions of the procedure, one sentence each.
    pub assumptions: Vec<String>,
    /// Warnings and remarks, one sentence each.
    pub notes: Vec<String>,
    /// What the quantities are made of.
    #[serde(skip)]
    pub ingredients: Vec<Ingredients>,
    /// Why the tank is outside the scope of the procedure, which gives values all the same.
    #[serde(skip)]
    pub beyond_scope: Option<String>,
    /// Weight that holds an unanchored wall down, as the sheet takes it [N/m].
    #[serde(skip)]
    pub hold_down: Option<f64>,
    /// Clauses on which values rest and that no source was compared with.
    #[serde(skip)]
    pub recalled: Vec<String>,
}

/// Reason why a procedure does not apply.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
#[error("{clause}: {reason}")]
pub struct NotApplicable {
    /// Clause that sets the limit.
    pub clause: String,
    /// Reason, with found and expected values.
    pub reason: String,
}
