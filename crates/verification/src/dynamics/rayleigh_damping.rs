//! D4, D5: Rayleigh's coefficients.

use super::row;
use crate::{Answer, Benchmark, Part, Reference, Row};
use fem::analysis::damping::Rayleigh;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "rayleigh-damping",
    title: "Rayleigh damping",
    model: "Coefficients from two ratios, the ratios that result, and the rule for admissible pairs.",
    ids: &[("D4", "Rayleigh coefficients and ratios of tank 8.1"), ("D5", "admissible pairs of ratios")],
    parts: &[Part::Fast(rayleigh), Part::Fast(|| Ok(vec![admissible_ratios()]))],
};

/// D4: Rayleigh damping of tank 8.1 with the dissertation's pairs, 1 % at 3.02 and 2 % at 4.13 rad/s.
fn rayleigh() -> Answer {
    let r = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), true)?;
    let mut rows = vec![
        row("D4", "tank 8.1: a_M".into(), -0.0604, r.mass, 1e-3),
        row("D4", "tank 8.1: a_K".into(), 0.013205, r.stiffness, 1.4e-4),
    ];
    for row in &mut rows {
        (row.kind, row.source) = (Reference::Dissertation, "dissertation 8.1.4, printed");
    }
    rows[0].unit = "1/s";
    rows[1].unit = "s";
    // a_M/(2 ω) + a_K ω/2 with both coefficients from the two pairs, by hand to seven digits.
    for (omega, ratio, allowed) in [
        (1.0, -0.02341418, 5e-9),
        (2.0, -0.001803481, 5e-10),
        (2.13, -2.916932e-5, 5e-12),
        (3.02, 0.01, 1e-12),
        (4.13, 0.02, 1e-12),
        (10.0, 0.06302241, 5e-9),
        (50.0, 0.32952, 5e-7),
        (100.0, 0.6599405, 5e-8),
    ] {
        let what = format!("tank 8.1: damping ratio at {omega} rad/s");
        let mut entry = row("D4", what, ratio, r.ratio(omega), allowed);
        entry.source = "a_M/(2 ω) + a_K ω/2, by hand from the two pairs";
        rows.push(entry);
    }
    Ok(rows)
}

/// D5: how often the fit and the inequality ω₁/ω₂ ≤ ξ₂/ξ₁ ≤ ω₂/ω₁ disagree about a negative coefficient.
fn admissible_ratios() -> Row {
    let mut disagreements = 0;
    for i in 1..40 {
        for j in 1..80 {
            // Steps that never meet the bounds themselves, where rounding decides.
            let (factor, quotient) = (1.0 + 0.137 * f64::from(i), 0.0831 * f64::from(j));
            let fit = Rayleigh::fit((3.0, 0.01), (3.0 * factor, 0.01 * quotient), false);
            let admissible = 1.0 / factor <= quotient && quotient <= factor;
            disagreements += i32::from(fit.is_ok() != admissible);
        }
    }
    let mut row = row(
        "D5",
        "pairs for which the fit and the admissible range disagree".into(),
        0.0,
        f64::from(disagreements),
        0.0,
    );
    (row.kind, row.source) = (Reference::ClosedForm, "ω₁/ω₂ ≤ ξ₂/ξ₁ ≤ ω₂/ω₁");
    row
}
