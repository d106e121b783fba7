//! D1, D3: amplification of time schemes, the exact recurrence.

use nalgebra::{Matrix4, Vector4};
use oscillator::sdof::Recurrence;

use super::row;
use crate::{Answer, Benchmark, Part, Reference, Row};
use fem::analysis::scheme::TimeScheme;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "time-integration",
    title: "Time integration",
    model: "Oscillators without space: amplification, period and numerical damping of Newmark's method and the \
            generalised-α method, the exact recurrence.",
    ids: &[
        ("D1", "numerical damping, period error and spectral radius of six schemes"),
        ("D3", "exact piecewise-linear recurrence"),
    ],
    parts: &[Part::Fast(amplification), Part::Fast(|| Ok(vec![recurrence()]))],
};

/// D1: numerical damping, period error and spectral radius of six schemes.
fn amplification() -> Answer {
    // More than 80 lines: half of it is the table of references.
    use TimeScheme::{GeneralizedAlpha, Hht, Trapezoidal};
    // Damping at Δt/T = .05, .1, .2, period error there, ρ_∞. Eigenvalues of the matrix that leads from (u, h u̇, h² ü) to the
    // next step, set up and solved apart with numpy, seven digits: ξ = −ln |λ|/arg λ, ΔT/T = x/arg λ − 1.
    let table = [
        ("trapezoidal rule", Trapezoidal, [0.0, 0.0, 0.0], [8.171243e-3, 3.207491e-2, 1.200331e-1], 1.0),
        (
            "HHT −0.05",
            Hht { alpha: -0.05 },
            [1.673982e-4, 1.183752e-3, 6.314369e-3],
            [9.276139e-3, 3.611096e-2, 1.320335e-1],
            0.905,
        ),
        (
            "HHT −0.1",
            Hht { alpha: -0.1 },
            [2.996776e-4, 2.106129e-3, 1.112980e-2],
            [1.020225e-2, 3.950576e-2, 1.424253e-1],
            0.818,
        ),
        (
            "generalised-α 0.9",
            GeneralizedAlpha { radius: 0.9 },
            [2.221817e-6, 1.692408e-5, 1.145459e-4],
            [8.272879e-3, 3.247155e-2, 1.214948e-1],
            0.9,
        ),
        (
            "generalised-α 0.8",
            GeneralizedAlpha { radius: 0.8 },
            [2.083850e-5, 1.572715e-4, 1.029031e-3],
            [8.623283e-3, 3.382841e-2, 1.263509e-1],
            0.8,
        ),
        (
            "generalised-α 0.5",
            GeneralizedAlpha { radius: 0.5 },
            [5.450138e-4, 3.780050e-3, 1.951309e-2],
            [1.215664e-2, 4.671532e-2, 1.653643e-1],
            0.5,
        ),
    ];
    let mut rows = Vec::new();
    for (name, scheme, dampings, periods, radius) in table {
        let scheme = scheme.with_step(1.0)?;
        for (k, part) in [0.05, 0.1, 0.2].into_iter().enumerate() {
            let (damping, period) = scheme.spectral_properties(std::f64::consts::TAU * part);
            // Half the last digit of the reference, or rounding for schemes without dissipation.
            let what = format!("{name}: numerical damping ratio at Δt/T = {part}");
            rows.push(row("D1", what, dampings[k], damping, f64::max(1e-6 * dampings[k], 1e-13)));
            let what = format!("{name}: relative period error at Δt/T = {part}");
            rows.push(row("D1", what, periods[k], period, 1e-6 * periods[k]));
        }
        // A double root splits by the square root of rounding, and 1/x² is left of the limit.
        let what = format!("{name}: spectral radius at infinite frequency");
        let mut limit = row("D1", what, radius, scheme.spectral_radius(1e5), 5e-4);
        limit.kind = Reference::ClosedForm;
        rows.push(limit);
    }
    // Closed form of the trapezoidal rule: phase 2 arctan(x/2) a step.
    let x = std::f64::consts::TAU * 0.1;
    let (_, period) = TimeScheme::Trapezoidal.with_step(1.0)?.spectral_properties(x);
    let mut exact = row(
        "D1",
        "trapezoidal rule: relative period error at Δt/T = 0.1, closed form".into(),
        x / (2.0 * (x / 2.0).atan()) - 1.0,
        period,
        1e-12,
    );
    (exact.kind, exact.source) = (Reference::ClosedForm, "x/(2 arctan(x/2)) − 1 (Hughes 1987, section 9.1)");
    rows.push(exact);
    Ok(rows)
}

/// D3: largest difference of the recurrence from the matrix exponential.
fn recurrence() -> Row {
    let mut worst = 0.0_f64;
    for x in [1e-6, 1e-4, 0.01, 0.3, 0.9, 1.1, 3.0, 10.0] {
        for damping in [0.0, 0.005, 0.05, 0.5] {
            // Unit frequency, step x: states u, v, p and its slope.
            let r = Recurrence::new(1.0, damping, x);
            let e = exponential(
                Matrix4::new(
                    0.0,
                    1.0,
                    0.0,
                    0.0, //
                    -1.0,
                    -2.0 * damping,
                    1.0,
                    0.0, //
                    0.0,
                    0.0,
                    0.0,
                    1.0, //
                    0.0,
                    0.0,
                    0.0,
                    0.0,
                ) * x,
            );
            for (state, load) in [([1.0, 0.0], [0.0, 0.0]), ([0.0, 1.0], [0.0, 0.0]), ([0.0, 0.0], [1.0, 0.4])] {
                let (u, v) = r.step(state[0], state[1], load[0], load[1]);
                // The exponential is taken of the matrix times x, so the slope counts a step.
                let end = e * Vector4::new(state[0], state[1], load[0], (load[1] - load[0]) / x);
                worst = worst.max((u - end[0]).abs()).max((v - end[1]).abs());
            }
        }
    }
    let mut row = row(
        "D3",
        "exact piecewise-linear recurrence against the matrix exponential, largest difference".into(),
        0.0,
        worst,
        // The exponential's own rounding: some twenty terms and up to five squarings of numbers of size 1.
        1e-14,
    );
    row.source = "Nigam & Jennings 1969; Taylor series with scaling and squaring";
    row
}

/// e^A by its series, scaled by 2⁻ᵏ and squared k times.
fn exponential(a: Matrix4<f64>) -> Matrix4<f64> {
    let halvings = a.abs().max().log2().ceil().max(0.0) as u32 + 1;
    let a = a / f64::from(1_u32 << halvings);
    // e^A − 1, so that squaring does not lose small parts: (1 + B)² − 1 = 2 B + B².
    let (mut term, mut b) = (Matrix4::identity(), Matrix4::zeros());
    for k in 1..24 {
        term = term * a / f64::from(k);
        b += term;
    }
    for _ in 0..halvings {
        b = 2.0 * b + b * b;
    }
    b + Matrix4::identity()
}
