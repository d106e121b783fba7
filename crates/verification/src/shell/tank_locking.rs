//! S11: membrane locking of the wall of tank 8.1.

use super::tank::*;
use super::{Answer, Case};
use crate::{Benchmark, Part, Reference};
use fem::element::shell4::MembraneShear;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-tank-locking",
    title: "Shell: membrane locking of a cylindrical wall",
    model: "Sector of tank 8.1's wall with the membrane shear integrated fully and taken at the centre.",
    ids: &[("S11", "membrane locking of a cylindrical wall")],
    parts: &[Part::Slow(|| locking(&[16, 32, 64, 128, 256]))],
};

/// Table of the membrane locking of plain MITC4 and with centre-point shear.
pub(super) fn locking(counts: &[usize]) -> Answer {
    let plain = [(16, 0.728, 0.23), (32, 0.856, 0.52), (64, 0.939, 0.81), (128, 0.982, 0.94), (256, 0.996, 0.99)];
    let centre = [(16, 0.982, 0.98), (32, 0.996, 1.0), (64, 1.0, 1.0), (128, 1.001, 1.0)];
    let case = Case { id: "S11", source: "independent prototype on the same mesh", unit: "over closed form" };
    let mut rows = Vec::new();
    for &n in counts {
        for (name, shear, table) in [
            ("plain MITC4", MembraneShear::Full, &plain[..]),
            ("centre-point shear", MembraneShear::CentrePoint, &centre[..]),
        ] {
            let [w, n_phi, m] = ratios(n, shear)?;
            let Some(&(_, w_ref, m_ref)) = table.iter().find(|p| p.0 == n) else { continue };
            let kind = Reference::SecondFormulation;
            // Printed to three and two digits.
            rows.push(case.row(format!("largest w, {n} sectors, {name}"), kind, w_ref, w, 0.002));
            rows.push(case.row(format!("largest n_φ, {n} sectors, {name}"), kind, w_ref, n_phi, 0.003));
            rows.push(case.row(format!("positive m_v, {n} sectors, {name}"), kind, m_ref, m, 0.03));
        }
    }
    Ok(rows)
}
