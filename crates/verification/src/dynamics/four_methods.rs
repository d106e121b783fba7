//! D8: time integration and frequency domain against the exact modal recurrence.

use super::strip::*;
use crate::{Answer, Benchmark, Part, Reference, Row};
use fem::analysis::frequency::{Reduced, Window};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::transient::Transient;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "four-methods-on-one-model",
    title: "Four methods on one model",
    model: "Strip 8.4, linear, with modal damping, under 60 sines of 0.2 to 20 Hz: two schemes of time \
            integration and two windows of the frequency domain.",
    ids: &[
        ("methods", "two time integrations against the exact modal recurrence"),
        ("D8", "frequency domain against the exact modal recurrence"),
    ],
    parts: &[Part::Fast(four_methods)],
};

fn four_methods() -> Answer {
    let model = strip()?;
    let (grid, load) = shaking(8.0);
    let (fine, fine_load) = shaking(32.0);
    let all: Vec<usize> = (0..model.modes.omega.len()).collect();
    let exact = model.superposed(&all, false, &load, grid)?;
    let trapezoidal = model.direct(TimeScheme::Trapezoidal, &fine_load, fine)?;
    let alpha = model.direct(TimeScheme::GeneralizedAlpha { radius: 0.9 }, &fine_load, fine)?;
    let basis = model.basis(&all, false)?;
    let none = vec![0.0; all.len()];
    let reduced = Reduced::modal(&basis, &model.ratios(), &none)?;
    let frequency = reduced.respond(&load, grid, Window::Exponential(6.0), &model.observables)?;
    let slowest = Window::zeros_for(0.005, model.modes.omega[0]);
    let padded = reduced.respond(&load, grid, slowest, &model.observables)?;
    let mut rows = Vec::new();
    for (i, observable) in model.observables.iter().enumerate() {
        let direct = |t: &Transient| t.observed.scalars[i].extreme.peak().0;
        for (id, method, value) in [
            ("methods", "trapezoidal rule", direct(&trapezoidal)),
            ("methods", "generalised-α, ρ_∞ = 0.9", direct(&alpha)),
            ("D8", "frequency domain, exponential window", frequency[i].extreme.peak().0),
            ("D8", "frequency domain, zeros", padded[i].extreme.peak().0),
        ] {
            rows.push(Row::new(
                id,
                format!("strip 8.4: {}, {method}", observable.name),
                (exact[i], "exact modal recurrence", Reference::SecondFormulation),
                value,
                (5e-3, ["Nm/m", "m", "m"][i]),
            ));
        }
    }
    Ok(rows)
}
