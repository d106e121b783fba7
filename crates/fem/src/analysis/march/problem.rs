//! What is marched.

use std::sync::Arc;

use crate::analysis::system::System;
use crate::assembly::Assembler;
use crate::linalg::Symbolic;
use crate::model::Model;

/// The problem.
#[derive(Clone, Copy)]
pub struct Problem<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its assembler.
    pub assembler: &'a Assembler,
    /// Symbolic factor of its pattern.
    pub symbolic: &'a Arc<Symbolic>,
    /// M, the initial K, C and M ι.
    pub system: &'a System,
}
