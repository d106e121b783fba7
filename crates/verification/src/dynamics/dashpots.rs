//! Dashpots that couple the modes: two masses against closed forms and an integration apart, a tank against its own matrices.
//!
//! ```text
//! (K + i Ω c b bᵀ − Ω² M) x = −M ι          M = [2 0; 0 1], K = [5 −2; −2 2], b = (1, 0), c = 0.8, ι = (1, 1)
//! ```
//!
//! solved by Cramer's rule for the two masses and by a factor of all unknowns for the tank; the history of the two masses by Runge and Kutta's
//! fourth order with steps of a thousandth of the shorter period. Source: Clough & Penzien 1993, sections 12-5 and 13-2 (non-classical damping).

use nalgebra::{Complex, DMatrix, DVector};

use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::damping::Damper;
use engines::harmonic;
use engines::modes;
use engines::response::superpose::{self, ModalSystem, Observable};
use engines::{DampingModel, FeError, Options};
use fem::analysis::frequency::Reduced;
use fem::analysis::modal::ModalBasis;
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable;
use fem::analysis::transient::Load;
use fem::linalg::{Matrix, dot};
use fem::progress::Silent;
use results::Channel;
use tank::options::linear::{Dashpots, WallDirection};
use tank::reference::broad;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "dashpots",
    title: "Dashpots that couple the modes",
    model: "Two masses of 2 and 1 kg on springs of 3 and 2 N/m, 0.8 N s/m between the ground and the first; tank 8.1 (ρ = 1 t/m³, wall 2 %, \
            sloshing 0.5 %) with 30 kN s/m radially around the top of its wall.",
    ids: &[
        ("dashpot-1", "two masses: steady state of the second one and of the force of both"),
        ("dashpot-2", "two masses: history of the second one"),
        ("dashpot-3", "tank: base shear in the steady state"),
    ],
    parts: &[Part::Fast(masses), Part::Fast(history), Part::Fast(tank)],
};

const COEFFICIENT: f64 = 0.8;
const ROW: [f64; 2] = [1.0, 0.0];

/// λ = (9 ± √33)/4, φ ∝ (2, 5 − 2 λ).
fn basis() -> Result<ModalBasis, FeError> {
    let mut vectors = Matrix::zeros(2, 2);
    let (mut omega, mut participation) = (Vec::new(), Vec::new());
    for (j, sign) in [-1.0, 1.0].into_iter().enumerate() {
        let square = (9.0 + sign * 33.0_f64.sqrt()) / 4.0;
        let shape = [2.0, 5.0 - 2.0 * square];
        let norm = (2.0 * shape[0] * shape[0] + shape[1] * shape[1]).sqrt();
        let shape = shape.map(|s| s / norm);
        vectors.column_mut(j).copy_from_slice(&shape);
        participation.push([2.0 * shape[0] + shape[1], 0.0, 0.0]);
        omega.push(square.sqrt());
    }
    let influence = [vec![1.0; 2], vec![0.0; 2], vec![0.0; 2]];
    let basis = ModalBasis::from_parts(&omega, &vectors, participation, influence, [None; 3]);
    let basis = basis.map_err(|error| FeError::Analysis(error.to_string()))?;
    Ok(basis.with_dashpots([(ROW.as_slice(), COEFFICIENT)]))
}

/// Displacement of the second mass; inertia force of both.
fn observables() -> Vec<observable::Observable> {
    vec![
        observable::Observable { displacement: vec![(1, 1.0)], ..observable::Observable::default() },
        observable::Observable { acceleration: vec![(0, 2.0), (1, 1.0)], ..observable::Observable::default() },
    ]
}

/// Errors: a failure of the analysis.
fn masses() -> Answer {
    let reduced = Reduced::modal(&basis()?, &[0.0; 2], &[0.0; 2])?;
    let mut rows = Vec::new();
    for omega in [0.4, 0.9, 1.4, 2.0] {
        let a = Complex::new(5.0 - 2.0 * omega * omega, omega * COEFFICIENT);
        let d = Complex::new(2.0 - omega * omega, 0.0);
        let determinant = a * d - 4.0;
        let x = [(-2.0 * d - 2.0) / determinant, (-a - 4.0) / determinant];
        let force = (x[0] * 2.0 + x[1]) * (-omega * omega) + 3.0;
        let found = reduced.transfer(&observables(), 0, &[omega])?;
        for ((title, unit), (expected, found)) in
            [("displacement", "m"), ("force", "N")].into_iter().zip([x[1], force].into_iter().zip(&found))
        {
            // Rounding.
            rows.push(Row::new(
                "dashpot-1",
                format!("{title}, Ω = {omega} rad/s"),
                (expected.norm(), "Cramer's rule", Reference::ClosedForm),
                found.first().map_or(f64::NAN, |h| h.norm()),
                (1e-10, unit),
            ));
        }
    }
    Ok(rows)
}

/// a(t) with straight lines between samples of 0.1 s.
fn ground(t: f64) -> f64 {
    let at = |k: f64| (0.9 * k * 0.1).sin() * (0.31 * k * 0.1).cos();
    let k = (t / 0.1).floor();
    at(k) + (t / 0.1 - k) * (at(k + 1.0) - at(k))
}

/// Errors: a failure of the analysis.
fn history() -> Answer {
    let samples = 301;
    let record: Vec<f64> = (0..samples).map(|k| ground(f64::from(k) * 0.1)).collect();
    let grid = Grid::new(0.1, 30.0, 0.0, 0.1);
    let load = Load::ground(0, Motion::sampled(0.1, &record, &grid));
    let (found, _) = basis()?.respond(&[0.0; 2], &load, grid, &observables()[..1], &[], &Silent)?;
    let rate = |t: f64, z: [f64; 4]| {
        let [x, y, u, v] = z;
        let a = ground(t);
        [u, v, -a - (5.0 * x - 2.0 * y + COEFFICIENT * u) / 2.0, -a - (2.0 * y - 2.0 * x)]
    };
    let (mut z, h) = ([0.0; 4], 0.1 / 40.0);
    let along = |z: [f64; 4], k: [f64; 4], h: f64| -> [f64; 4] { std::array::from_fn(|i| z[i] + h * k[i]) };
    let mut rows = Vec::new();
    for step in 0..12_000 {
        let t = f64::from(step) * h;
        // The ramp of a step belongs to it: its end is not the next one's beginning.
        let k1 = rate(t + 1e-12, z);
        let k2 = rate(t + 0.5 * h, along(z, k1, 0.5 * h));
        let k3 = rate(t + 0.5 * h, along(z, k2, 0.5 * h));
        let k4 = rate(t + h - 1e-12, along(z, k3, h));
        z = std::array::from_fn(|i| z[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        if (step + 1) % 2000 == 0 {
            let sample = ((step + 1) / 40) as usize;
            let value = found.scalars.first().and_then(|s| s.values.get(sample));
            // (ω h)⁴/120 a radian: 1e-11; the smallest of the values is a hundredth of the largest.
            rows.push(Row::new(
                "dashpot-2",
                format!("displacement at {:.0} s", t + h),
                (z[1], "Runge and Kutta, fourth order", Reference::SecondFormulation),
                value.copied().unwrap_or(f64::NAN),
                (1e-7, "m"),
            ));
        }
    }
    Ok(rows)
}

/// Errors: a failure of the engine.
fn tank() -> Answer {
    let case = broad(1000.0);
    let options = Options {
        dashpots: vec![Dashpots { z: 1.83, direction: WallDirection::Radial, coefficient: 3e4 }],
        ..Options::default()
    };
    let coupled = harmonic::build(&case, &options, 1)?;
    let modes = modes::solve(&coupled, None)?;
    let damper = Damper::new(&case, &DampingModel::Modal)?;
    let Some(probe) = coupled.probe(Channel::BaseShear) else {
        return Err(FeError::Analysis("no base shear".into()).into());
    };
    let kept = superpose::keep(&coupled, &modes, &damper, 5);
    let system = ModalSystem::new(&coupled, kept, &damper)?;
    let observable: Observable = vec![(0, 1.0, probe)];
    let first = modes
        .iter()
        .filter(|m| m.kind == modes::Kind::Structural)
        .max_by(|a, b| a.effective_mass().total_cmp(&b.effective_mass()))
        .map_or(f64::NAN, |m| m.omega);
    // C = Σ 2 ξ ω (M φ)(M φ)ᵀ + c b bᵀ over all modes and unknowns.
    let n = coupled.influence.len();
    let dense = |m: &Matrix| DMatrix::from_fn(n, n, |i, j| m.get(i, j));
    let (mass, stiffness) = (dense(&coupled.mass), dense(&coupled.stiffness));
    let mut damping = DMatrix::zeros(n, n);
    for mode in &modes {
        let momentum = DVector::from_vec(coupled.mass.times(&mode.vector));
        damping += 2.0 * damper.ratio(mode.kind, mode.omega) * mode.omega * &momentum * momentum.transpose();
    }
    for (row, coefficient) in &coupled.dashpots {
        let row = DVector::from_vec(row.clone());
        damping += *coefficient * &row * row.transpose();
    }
    let load = coupled.mass.times(&coupled.influence);
    let mut rows = Vec::new();
    for multiple in [0.3, 0.9, 1.0, 1.1, 1.6] {
        let omega = multiple * first;
        let matrix = DMatrix::from_fn(n, n, |i, j| {
            Complex::new(stiffness[(i, j)] - omega * omega * mass[(i, j)], omega * damping[(i, j)])
        });
        let right = DVector::from_iterator(n, load.iter().map(|l| Complex::new(-l, 0.0)));
        let Some(x) = matrix.lu().solve(&right) else {
            return Err(FeError::Analysis("a singular matrix".into()).into());
        };
        let relative: Complex<f64> =
            (x.iter().zip(&probe.absolute_acceleration)).map(|(x, c)| x * (-omega * omega * c)).sum();
        let expected = relative + dot(&probe.absolute_acceleration, &coupled.influence) + probe.ground_acceleration;
        let found = superpose::transfer(&system, std::slice::from_ref(&observable), false, &[omega])?;
        // All modes that double precision resolves are kept; what is left of the mass follows the ground without the dashpots: 2e-3.
        rows.push(Row::new(
            "dashpot-3",
            format!("base shear at {multiple} times the frequency of the impulsive mode"),
            (expected.norm(), "factor of all unknowns", Reference::SecondFormulation),
            found.first().and_then(|h| h.first()).map_or(f64::NAN, |h| h.norm()),
            (2e-3, "N s²/m"),
        ));
    }
    Ok(rows)
}
