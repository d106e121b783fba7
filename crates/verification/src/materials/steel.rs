//! M1, M2: von Mises' law.

use materials::Law;
use materials::von_mises::VonMises;

use super::drive::{Noise, Point};
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "materials-steel",
    title: "Stress laws: steel and Drucker-Prager's cone",
    model: "One point under strain paths: von Mises in a bar, in plane stress and in the solid; the cone in \
            plane stress; concrete damaged in compression.",
    ids: &[("M1", "von Mises: cycles of uniaxial strain"), ("M2", "von Mises: dissipation and yield surface")],
    parts: &[Part::Fast(steel)],
};

/// E, f_y and E_T of M1 [Pa].
const E: f64 = 2.1e11;

const F_Y: f64 = 500e6;

const E_T: f64 = 2.1e9;

/// Rows M1 (uniaxial cycles) and M2 (dissipation, yield surface).
///
/// Errors: a law that fails.
pub(crate) fn steel() -> Answer {
    let mut rows = cycles()?;
    rows.extend(dissipation()?);
    rows.push(ellipse()?);
    Ok(rows)
}

/// M1: strain .005, −.005, .005, −.01, .01 in 200 steps each, as a bar and under uniaxial stress in the plane and in the
/// solid. The worst of the three is compared.
fn cycles() -> Answer {
    const PEAKS: [f64; 5] = [0.005, -0.005, 0.005, -0.01, 0.01];
    let table = [
        ("kinematic", 1.0, [505.50, -505.50, 505.50, -516.00, 516.00]),
        ("isotropic", 0.0, [505.50, -516.39, 527.06, -548.02, 579.06]),
        ("half and half", 0.5, [505.50, -510.95, 516.34, -532.17, 547.85]),
    ];
    let mut rows = Vec::new();
    for (name, kinematic, stresses) in table {
        let law = VonMises::new(E, 0.3, F_Y, E_T, kinematic)?;
        let answers = [peaks::<1>(&law, &PEAKS)?, peaks::<3>(&law, &PEAKS)?, peaks::<6>(&law, &PEAKS)?];
        for (i, (peak, reference)) in PEAKS.into_iter().zip(stresses).enumerate() {
            let worst = answers
                .iter()
                .map(|answer| answer[i] / 1e6)
                .max_by(|a, b| (a - reference).abs().total_cmp(&(b - reference).abs()))
                .unwrap_or(f64::NAN);
            let source = "bilinear law by hand, E 210 GPa, f_y 500 MPa, E_T 2.1 GPa";
            rows.push(Row::new(
                "M1",
                format!("{name} hardening, strain {peak}, reversal {}", i + 1),
                (reference, source, Reference::ClosedForm),
                worst,
                (5e-4, "MPa"),
            ));
        }
    }
    Ok(rows)
}

/// Stress at the reversals of strain.
fn peaks<const N: usize>(law: &dyn Law<N>, peaks: &[f64]) -> Result<Vec<f64>, Failure> {
    let mut point = Point::new(law);
    let mut answer = Vec::new();
    let mut from = 0.0;
    for &to in peaks {
        let mut stress = 0.0;
        for i in 1..=200 {
            let strain = from + (to - from) * f64::from(i) / 200.0;
            stress = point.step_uniaxial(strain, F_Y)?.stress[0];
        }
        answer.push(stress);
        from = to;
    }
    Ok(answer)
}

/// M2: a hundred random closed cycles of strain in plane stress. No step may give energy back, and the work of the closed
/// cycle (trapezoidal rule) may not be negative.
fn dissipation() -> Answer {
    let laws = [
        VonMises::new(E, 0.3, F_Y, 0.0, 1.0)?,
        VonMises::new(E, 0.3, F_Y, E_T, 0.5)?,
        VonMises::new(E, 0.3, F_Y, E_T, 0.5)?.with_saturation(100e6, 20.0)?.with_back_stress(50e9, 400.0)?,
    ];
    let mut noise = Noise(2);
    let (mut least_step, mut least_work) = (f64::INFINITY, f64::INFINITY);
    for cycle in 0..100 {
        let mut point = Point::new(&laws[cycle % laws.len()] as &dyn Law<3>);
        let mut corners: Vec<[f64; 3]> = (0..4).map(|_| noise.vector().map(|x| 0.01 * x)).collect();
        corners.push([0.0; 3]);
        let (mut work, mut stress, mut from) = (0.0, [0.0; 3], [0.0; 3]);
        for to in corners {
            for i in 1..=100 {
                let before = point.strain;
                let t = f64::from(i) / 100.0;
                let response = point.step(std::array::from_fn(|k| from[k] + (to[k] - from[k]) * t))?;
                for k in 0..3 {
                    work += 0.5 * (stress[k] + response.stress[k]) * (point.strain[k] - before[k]);
                }
                stress = response.stress;
            }
            from = to;
        }
        least_step = least_step.min(point.least);
        least_work = least_work.min(work);
    }
    Ok([
        ("smallest dissipation of a step, 100 closed cycles", least_step),
        ("smallest work of a closed cycle, 100 cycles", least_work),
    ]
    .map(|(what, least)| {
        let what = format!("{what}: its negative part");
        let reference = (0.0, "second law of thermodynamics", Reference::ClosedForm);
        Row::new("M2", what, reference, least.min(0.0), (0.0, "J/m³"))
    })
    .into())
}

/// M2: ideal plasticity under proportional biaxial strain stays on σ_1² − σ_1 σ_2 + σ_2² = f_y².
fn ellipse() -> Result<Row, Failure> {
    let law = VonMises::new(E, 0.3, F_Y, 0.0, 1.0)?;
    let mut worst: f64 = 0.0;
    for k in 0..36 {
        let (sine, cosine) = (f64::from(k) * 10f64.to_radians()).sin_cos();
        let mut point = Point::new(&law as &dyn Law<3>);
        for i in 1..=50 {
            let size = 4e-4 * f64::from(i);
            let [x, y, _] = point.step([size * cosine, size * sine, 0.0])?.stress;
            if point.inspect().plastic_strain > 0.0 {
                worst = worst.max(((x * x - x * y + y * y).sqrt() / F_Y - 1.0).abs());
            }
        }
    }
    Ok(Row::new(
        "M2",
        "distance from the yield ellipse, ideal plasticity, 36 proportional paths to strain 0.02",
        (0.0, "von Mises' ellipse", Reference::ClosedForm),
        worst,
        (1e-9, ""),
    ))
}
