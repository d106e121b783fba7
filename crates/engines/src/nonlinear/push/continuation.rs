//! Load steps and arcs of a shell.

use fem::analysis::continuation::Continuation;
use fem::analysis::newton::Criteria;
use fem::cores;

use super::model::PushModel;
use crate::FeError;

/// When a step has converged.
pub(super) const CRITERIA: Criteria = Criteria { energy: 1e-10, force: 1e-4, iterations: 20 };

pub(super) fn analysis(error: impl std::fmt::Display) -> FeError {
    FeError::Analysis(error.to_string())
}

/// Load steps and arcs of a model under `constant` and λ `load`.
pub(super) fn continuation<'a>(
    model: &'a PushModel,
    constant: &[f64],
    load: &[f64],
) -> Result<Continuation<'a>, FeError> {
    let path = Continuation::new(&model.model, &model.assembler, &model.symbolic, constant, load, CRITERIA);
    let path = path.map_err(analysis)?.on_threads(cores::available());
    Ok(path.with_extrapolated_stresses())
}
