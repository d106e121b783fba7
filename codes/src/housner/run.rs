//! One run of the procedure on a case.

use super::lines::Totals;
use super::model::{Input, Response};
use super::motion::Motion;
use crate::mechanical::Plan;
use tank::case::{Case, Combination, ConvectiveCoefficient};

/// One run of the procedure.
pub(super) struct Run<'a> {
    pub(super) case: &'a Case,
    pub(super) plan: Plan,
    pub(super) input: Input,
    pub(super) response: Response,
    pub(super) totals: Totals,
    pub(super) motion: Motion<'a>,
    pub(super) combination: Combination,
}

impl Run<'_> {
    /// True if the convective constants are the exact ones.
    pub(super) fn exact(&self) -> bool {
        self.case.procedures.housner_convective == ConvectiveCoefficient::Exact
    }
}
