//! Damping by Caughey's series and by group in the linear engines.
//!
//! ```text
//! Caughey:   C = M Σ a_k (M⁻¹ K)^k        ξ(ω) = 1/2 Σ a_k ω^(2k−1)        through given pairs
//! by group:  C = a_K K_wall, a_K = 2 ξ_w/ω_1        sloshing modes: ξ_s each
//! decay:     η(t + n T)/η(t) = exp(−2π n ξ/√(1 − ξ²))
//! ```
//!
//! The decay is that of the wave after a pulse: in a rigid cylinder with the first mode damped by ξ and all others strongly, only the
//! first mode is left. Source: Caughey 1960; Clough & Penzien 1993, sections 2-5 and 12-5.

use super::{exact, row};
use crate::{Answer, Benchmark, Error, Part, Reference, Row};
use engines::damping::{Caughey, Damper};
use engines::modes::{self, Kind};
use engines::{DampingModel, FeError, Options, harmonic, simulate};
use fem::linalg::dot;
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::options::linear::CaugheyPairs;
use tank::reference::{broad, case, material};
use tank::{Case, Shape};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "mode-damping",
    title: "Caughey's series and damping by group",
    model: "Caughey's series through 5 % at 2, 2 % at 10 and 4 % at 40 rad/s; a chain of three equal masses and springs; tank 8.1 (ρ = 1 \
            t/m³) with its matrices; decay of the wave of a rigid cylinder, R = 10 m, 8 m of water, after a pulse of half a second.",
    ids: &[
        ("caughey-1", "ratios between the pairs"),
        ("caughey-2", "ratios of the modes of a chain by the matrix of the series"),
        ("caughey-3", "decay of the first sloshing mode over ten periods"),
        ("group-1", "ratios of modes of the wall by its matrix, and of sloshing modes"),
        ("group-2", "decay of the first sloshing mode over ten periods"),
    ],
    parts: &[Part::Fast(series), Part::Fast(groups), Part::Fast(decays)],
};

const PAIRS: [(f64, f64); 3] = [(2.0, 0.05), (10.0, 0.02), (40.0, 0.04)];

/// Errors: none that are expected.
fn series() -> Answer {
    let caughey = Caughey::fit(&PAIRS).map_err(|error| FeError::Analysis(error.to_string()))?;
    // a_0, a_1, a_2 = 0.19161…, 2.0974…e−3, −1.3576…e−7 from the three equations in fractions.
    let hand = "three equations for a_k, solved in fractions";
    let mut rows: Vec<Row> = [
        (3.0, 0.035_079_739_278_752_44),
        (5.0, 0.024_396_381_578_947_37),
        (20.0, 0.025_221_804_511_278_194),
        (30.0, 0.032_822_612_085_769_98),
    ]
    .into_iter()
    .map(|(omega, ratio)| {
        // Rounding of products of differences of squares.
        row("caughey-1", format!("ratio at {omega} rad/s"), hand, (ratio, 1e-12), caughey.ratio(omega), "–")
    })
    .collect();
    rows.extend(chain()?);
    Ok(rows)
}

/// k/m [[2, −1, 0], [−1, 2, −1], [0, −1, 2]] with k = m: ω² = 2 − √2, 2, 2 + √2; C from powers of the matrix on the modes.
fn chain() -> Result<Vec<Row>, FeError> {
    let root = 2.0_f64.sqrt();
    let modes = [
        (2.0 - root, [0.5, root / 2.0, 0.5]),
        (2.0, [root / 2.0, 0.0, -root / 2.0]),
        (2.0 + root, [0.5, -root / 2.0, 0.5]),
    ];
    let coefficients = [0.02, 0.01, 0.004];
    let ratio = |w: f64| 0.5 * (0.02 / w + 0.01 * w + 0.004 * w.powi(3));
    let caughey =
        Caughey::fit(&[0.7, 1.2, 1.9].map(|w| (w, ratio(w)))).map_err(|error| FeError::Analysis(error.to_string()))?;
    let times = |x: [f64; 3]| [2.0 * x[0] - x[1], 2.0 * x[1] - x[0] - x[2], 2.0 * x[2] - x[1]];
    let of_matrix = |mode: [f64; 3], omega: f64| {
        let powers = [mode, times(mode), times(times(mode))];
        let damped = |i: usize| coefficients.iter().zip(&powers).map(|(a, p)| a * p[i]).sum::<f64>();
        (0..3).map(|i| mode[i] * damped(i)).sum::<f64>() / (2.0 * omega)
    };
    let one = |(number, (square, mode)): (usize, (f64, [f64; 3]))| {
        let omega = square.sqrt();
        row(
            "caughey-2",
            format!("mode {} of the chain", number + 1),
            "φᵀ C φ/(2 ω) with C of the series",
            (of_matrix(mode, omega), 1e-12),
            caughey.ratio(omega),
            "–",
        )
    };
    Ok(modes.into_iter().enumerate().map(one).collect())
}

/// φᵀ a_K K_wall φ/(2 ω) of the engine's matrices. K of wall and surface without the surface's block holds gravity's part in a wall's mode,
/// (ω_s/ω)² of it, below 1e-3 in this tank.
///
/// Errors: a failure of the engine.
fn groups() -> Answer {
    let (case, wall, sloshing) = (broad(1000.0), 0.02, 0.005);
    let coupled = harmonic::build(&case, &Options::default(), 1)?;
    let modes = modes::solve(&coupled, None)?;
    let damper = Damper::new(&case, &DampingModel::ByGroup { wall, sloshing })?.tuned(&modes);
    let of = |kind: Kind| modes.iter().filter(move |m| m.kind == kind);
    let Some(first) = of(Kind::Structural).next().map(|m| m.omega) else {
        return Err(Error::Benchmark { benchmark: BENCHMARK.id.into(), what: "no structural mode".into() }.into());
    };
    let mut rows = Vec::new();
    for mode in of(Kind::Structural).take(4) {
        let x = &mode.vector;
        let energy = dot(&coupled.stiffness.times(x), x) - coupled.surface.energy(x);
        rows.push(Row::new(
            "group-1",
            format!("structural mode {}", mode.number),
            (
                2.0 * wall / first * energy / (2.0 * mode.omega),
                "φᵀ a_K K_wall φ/(2 ω) of the engine's matrices",
                Reference::SecondFormulation,
            ),
            damper.ratio(mode.kind, mode.omega),
            (1e-3, "–"),
        ));
    }
    Ok(rows)
}

/// Errors: a failure of the engine.
fn decays() -> Answer {
    let (radius, depth) = (10.0, 8.0);
    let stiff = material(1e16, 0.3, 1.0);
    let tank = case(Shape::Cylinder { radius }, &[(1.05 * depth, 0.05)], &stiff, (1000.0, depth));
    let zeros = [1.841_184, 5.331_443].map(|zero| exact(radius, depth, zero));
    let caughey = CaugheyPairs::new(&[(zeros[0], 0.01), (zeros[1], 0.5)]);
    let mut rows = Vec::new();
    for (id, title, ratio, model, allowed) in [
        // All others have 50 % of their own and are gone before the first window.
        ("caughey-3", "1 % at the first mode, 50 % from the second on", 0.01, DampingModel::Caughey(caughey), 2e-3),
        // All modes are damped alike: those beyond the first decay by the first window (40 periods) to e^(−1.8 · 2π · 40 · 0.03), 1e-6.
        ("group-2", "3 % in every sloshing mode", 0.03, DampingModel::ByGroup { wall: 0.02, sloshing: 0.03 }, 2e-3),
    ] {
        let expected = (-std::f64::consts::TAU * 10.0 * ratio / (1.0 - ratio * ratio).sqrt()).exp();
        let found = decay(&tank, model, zeros[0] * (1.0 - ratio * ratio).sqrt())?;
        // 200 samples a period: a crest is missed by (π/200)²/2 = 1e-4; the frequency errs by 1e-4, which is 1e-4 of the exponent 1 to 2.
        rows.push(row(
            id,
            format!("wave after ten periods over the wave before: {title}"),
            "closed form",
            (expected, allowed),
            found,
            "–",
        ));
    }
    Ok(rows)
}

/// Largest wave in a period around 50 periods over that ten periods before, after a pulse.
fn decay(tank: &Case, damping: DampingModel, omega: f64) -> Result<f64, FeError> {
    let mut case = tank.clone();
    let per_period = 200;
    let dt = std::f64::consts::TAU / omega / f64::from(per_period);
    let pulse = (0.5 / dt).ceil() as usize;
    let end = 52 * per_period as usize;
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "pulse".into(),
            dt,
            acceleration: (0..end).map(|k| if k < pulse { 1.0 } else { 0.0 }).collect(),
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    let options = Options { damping, mesh_error: false, ..Options::default() };
    let run = simulate(&case, &options)?;
    let place = run.series.ids.iter().position(|id| id == "wave_height_theta_0");
    let wave = place.map(|place| &run.series.columns[place]);
    let wave = wave.ok_or_else(|| FeError::Analysis("no wave".into()))?;
    let window = |periods: usize| {
        let from = periods * per_period as usize;
        wave[from..from + per_period as usize].iter().fold(0.0_f64, |m, w| m.max(w.abs()))
    };
    Ok(window(50) / window(40))
}
