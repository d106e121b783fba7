//! Whether the tank holds, and whether the results are complete.

use results::compare::{Incomplete, Unusable};
use results::{MESH_ERROR_LIMIT, Verdict};

/// Why the values of a run with separation are not design values.
pub const LIQUID_PARTED: &str = "The liquid has separated from the wall and closed again. An incompressible liquid on a stiff joint \
                                 exaggerates the impact, and a liquid separates from a tight wall near -98 kPa, not at atmospheric \
                                 pressure: forces and stresses after the first separation are not design values.";

/// The verdict in one line.
pub fn headline(verdict: &Verdict) -> String {
    if verdict.incomplete {
        return verdict.cause.as_ref().map_or_else(
            || "Incomplete: the finite-element run was interrupted, its extremes are not final".into(),
            incomplete,
        );
    }
    match (verdict.checks, verdict.failed) {
        (0, _) => "No check applies to this input".into(),
        (1, 0) => "The one applicable check holds".into(),
        (all, 0) => format!("All {all} applicable checks hold"),
        (1, 1) => "1 of 1 check fails".into(),
        (all, 1) => format!("1 of {all} checks fails"),
        (all, failed) => format!("{failed} of {all} checks fail"),
    }
}

/// Why results are not those of the whole ground motion, a sentence without its full stop.
pub fn incomplete(cause: &Incomplete) -> String {
    match cause {
        Incomplete::Missing { engine, error } => {
            let engine = engine.name();
            match error {
                None => format!("Incomplete: the {engine} run was interrupted before it had a result"),
                Some(error) => format!("Incomplete: the {engine} run failed before it had a result ({error})"),
            }
        }
        Incomplete::NotCarriedAtRest => "Collapse: the wall does not carry weight and static pressure".into(),
        Incomplete::NoEquilibrium { time } => {
            format!(
                "Collapse: the nonlinear run did not find equilibrium after {time:.2} s; its extremes are lower bounds"
            )
        }
        Incomplete::LeftModel { time } => format!(
            "The nonlinear run left its model and was stopped at {time:.2} s, its extremes are those until then"
        ),
        Incomplete::BeyondModel { time } => {
            format!("The nonlinear run left its model at {time:.2} s, later values are not results")
        }
        Incomplete::Interrupted { time } => {
            format!("Incomplete: the nonlinear run was interrupted at {time:.2} s, its extremes are not final")
        }
    }
}

/// A value that is not to be used.
pub fn unusable(found: &Unusable) -> String {
    format!(
        "{}: {} is unusable; found an estimated mesh error of {:.0} %, usual is below 5 %, allowed up to {:.0} %: refine the mesh",
        found.method,
        found.quantity.title(),
        100.0 * found.error,
        100.0 * MESH_ERROR_LIMIT
    )
}
