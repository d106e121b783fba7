//! When a step has converged, and the aids of the iteration.

use std::sync::Arc;

use crate::analysis::zone::Zone;

/// When a step has converged, and when it has failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// Allowed |δu·r| relative to the first one of the step.
    pub energy: f64,
    /// Allowed ‖r‖ relative to the sum of the norms of the forces.
    pub force: f64,
    /// Iterations until the step has failed.
    pub iterations: usize,
}

impl Default for Criteria {
    fn default() -> Criteria {
        Criteria { energy: 1e-10, force: 1e-4, iterations: 25 }
    }
}

/// Aids of the iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// When a step has converged, and when it has failed.
    pub criteria: Criteria,
    /// Keep the factor while it serves.
    pub modified: bool,
    /// Shorten increments that overshoot.
    pub line_search: bool,
    /// Iterations with the initial stiffness after a failure, 0 for none.
    pub initial_stiffness: usize,
    /// a_K [s] by group of elements, on the last committed tangent; empty for none.
    pub tangent_damping: Vec<f64>,
    /// Part of the model whose tangent is renewed as it changes, while that of the rest is kept as long as iterations converge. Takes the place
    /// of `modified` and `initial_stiffness`.
    pub zone: Option<Arc<Zone>>,
}

impl Options {
    /// Full Newton without aids.
    pub fn plain(criteria: Criteria) -> Options {
        Options {
            criteria,
            modified: false,
            line_search: false,
            initial_stiffness: 0,
            tangent_damping: Vec::new(),
            zone: None,
        }
    }

    /// Full Newton without line search, for joints that open: a kept factor is that of another set of closed points, and between two
    /// sets the residual of the full step does not predict that of the next one.
    ///
    /// [`Options::for_ground`] where a zone has the tangent of the present set after every slow iteration.
    pub fn for_contact() -> Options {
        Options {
            criteria: Criteria {
                // The residual of a wrong set is small: a joint near the surface carries little.
                energy: 1e-18,
                force: 1e-9,
                ..Criteria::default()
            },
            modified: false,
            line_search: false,
            ..Options::default()
        }
    }

    /// For a structure on unilateral ground, with the `zone` of plate and ground. Its tangent is that of the present set of pressed points wherever it matters,
    /// so that a line search is on a function that it describes: plates that yield and unload in turn make Newton's method go round in circles without.
    ///
    /// Converged: the last increment did 10⁻⁸ of the work of the first, so that it was 10⁻⁴ of the motion of the step, and what it leaves is less by
    /// the rate of the iteration once more; a step of a twentieth of a period has errors of 10⁻³. 10⁻⁷ of the forces is the weight of a
    /// kilogram beside that of 10 000 t of liquid. It must not be much more: what is left accelerates nodes of the plate that weigh some kilograms, and at
    /// 10⁻⁵ a squat tank found no equilibrium in the next steps.
    pub fn for_ground(zone: Arc<Zone>) -> Options {
        Options {
            criteria: Criteria { energy: 1e-8, force: 1e-7, ..Criteria::default() },
            line_search: true,
            zone: Some(zone),
            ..Options::for_contact()
        }
    }
}

/// Modified Newton with line search, and the initial stiffness as a last resort.
impl Default for Options {
    fn default() -> Options {
        Options {
            criteria: Criteria::default(),
            modified: true,
            line_search: true,
            initial_stiffness: 60,
            tangent_damping: Vec::new(),
            zone: None,
        }
    }
}
