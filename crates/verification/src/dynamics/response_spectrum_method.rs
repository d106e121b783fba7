//! D6: correlation of modes.

use super::row;
use crate::{Benchmark, Part, Reference, Row};
use fem::analysis::spectrum::correlation;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "response-spectrum-method",
    title: "Response-spectrum method",
    model: "Coefficients of the complete quadratic combination for pairs of ratios and frequencies.",
    ids: &[("D6", "correlation of modes (CQC)")],
    parts: &[Part::Fast(|| Ok(correlations()))],
};

/// D6: correlation of modes.
fn correlations() -> Vec<Row> {
    [
        (0.05, 0.05, 0.95, 0.7914, 5e-5),
        (0.05, 0.05, 0.9, 0.4730, 5e-5),
        (0.05, 0.05, 0.8, 0.1656, 5e-5),
        (0.05, 0.05, 0.5, 0.0185, 5e-5),
        (0.005, 0.05, 0.5, 0.00237, 5e-6),
    ]
    .into_iter()
    .map(|(xi, xj, r, reference, half_digit)| {
        let what = format!("correlation at r = {r}, ξ = {xi} and {xj}");
        let mut entry = row("D6", what, reference, correlation((1.0, xi), (r, xj)), half_digit);
        (entry.kind, entry.source) = (Reference::Published, "Wilson, Der Kiureghian & Bayo 1981, evaluated apart");
        entry
    })
    .collect()
}
