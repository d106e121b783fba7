//! S11: meshes graded to the base.

use super::tank::*;
use super::{Answer, Case};
use crate::{Benchmark, Part, Reference};
use fem::element::shell4::MembraneShear;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-tank-grading",
    title: "Shell: mesh graded to the base",
    model: "Wall of tank 8.1 by the grading of its mesh into the edge disturbance.",
    ids: &[("S11", "mesh graded to the base")],
    parts: &[Part::Slow(gradings)],
};

/// Table of the graded meshes: first element 1, ½, ¼, ⅛ √(R t).
pub(super) fn gradings() -> Answer {
    let (gamma, fill) = (9.81, 1.52);
    let closed = exact(gamma, fill)?;
    let case = Case { id: "S11", source: "closed form", unit: "over closed form" };
    let mut rows = Vec::new();
    for factor in [1.0, 0.5, 0.25, 0.125] {
        let run = TankRun::new(64, rule(factor, fill), MembraneShear::CentrePoint, gamma, fill)?;
        let elements = run.heights.len() - 1;
        let values = [
            ("w", largest(run.w()) / closed.largest(HEIGHT, |p| p.w).1),
            ("n_φ", largest(run.centres(0).iter().map(|p| p.1)) / closed.largest(HEIGHT, |p| p.n_phi).1),
            ("m_v(0), reactions", run.base_moment()? / closed.at(0.0).m_v),
            ("m_v above the base", largest(run.centres(4).iter().map(|p| p.1)) / closed.largest(0.5, |p| p.m_v).1),
        ];
        for (what, value) in values {
            let what = format!("{what}, first element {factor} √(R t), {elements} elements");
            // A study: the rule that follows from it is asserted by the rows of the static tank.
            rows.push(case.row(what, Reference::ClosedForm, 1.0, value, f64::INFINITY));
        }
    }
    Ok(rows)
}
