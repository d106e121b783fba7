//! A limit state of a code is one constant: what it is called, which clause asks for it, of which tanks, and what it compares. The checks
//! in which it ends stand beside it.
//!
//! Each code has one table in its folder (`limit_states.rs`), and so have the engines (`time_history`). [`crate::meaning`] gathers them.

pub(crate) mod common;

use tank::assessment::{Check, LimitState, Requirement};
use tank::case::Case;
use tank::check::TankPart;
use tank::units::Dimension;

/// A limit state as a code asks for it.
#[derive(Clone, Copy, Debug)]
pub struct LimitStateDef {
    /// Stable id, as in `results.json`.
    pub id: &'static str,
    /// What it is, in words.
    pub name: &'static str,
    /// Clause and edition.
    pub clause: &'static str,
    /// Whether the clause requires it of a tank.
    pub applies: fn(&Case) -> Requirement,
    /// Whether a list for the tank has it at all.
    pub exists: fn(&Case) -> bool,
    /// What the demand is.
    pub demand: &'static str,
    /// What it is compared with, and what that depends on.
    pub capacity: &'static str,
    /// Dimension of both.
    pub dimension: Dimension,
    /// Place on the page of all: surface, wall, base, surroundings.
    pub page: u16,
    /// Parts of the tank without which it cannot hold.
    pub needs: &'static [TankPart],
    /// Checks in which it ends, where they are not named like it.
    pub parts: &'static [Part],
}

/// One of the checks in which a limit state ends.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Stable id, as in `results.json`.
    pub id: &'static str,
    /// What is checked, in words.
    pub name: &'static str,
    /// What the demand is.
    pub demand: &'static str,
    /// What it is compared with.
    pub capacity: &'static str,
    /// Dimension of both.
    pub dimension: Dimension,
}

impl Part {
    /// The same under another name.
    pub const fn named(self, name: &'static str) -> Part {
        Part { name, ..self }
    }

    /// Its comparison.
    pub fn of(&self, demand: f64, capacity: f64, clause: &str, note: &str) -> Check {
        Check::new(self.id, self.name, demand, capacity, self.dimension, clause, note)
    }
}

/// A limit state required of every tank, from which the constants begin.
pub const ASKED: LimitStateDef = LimitStateDef {
    id: "",
    name: "",
    clause: "",
    applies: |_| Requirement::Required,
    exists: |_| true,
    demand: "",
    capacity: "",
    dimension: Dimension::Dimensionless,
    page: 0,
    needs: &[],
    parts: &[],
};

impl LimitStateDef {
    /// The same by this clause.
    pub const fn by(self, clause: &'static str) -> LimitStateDef {
        LimitStateDef { clause, ..self }
    }

    /// The same of tanks of which this requires it.
    pub const fn when(self, applies: fn(&Case) -> Requirement) -> LimitStateDef {
        LimitStateDef { applies, ..self }
    }

    /// The same under another name.
    pub const fn named(self, name: &'static str) -> LimitStateDef {
        LimitStateDef { name, ..self }
    }

    /// The same in another dimension.
    pub const fn measured(self, dimension: Dimension) -> LimitStateDef {
        LimitStateDef { dimension, ..self }
    }

    /// The check that is named like it.
    pub fn check(&self) -> Part {
        Part { id: self.id, name: self.name, demand: self.demand, capacity: self.capacity, dimension: self.dimension }
    }

    /// The limit state of a case, under the clause of an edition.
    pub fn under(&self, clause: String, case: &Case) -> LimitState {
        LimitState { id: self.id, name: self.name, clause, requirement: (self.applies)(case) }
    }
}
