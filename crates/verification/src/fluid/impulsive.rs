//! K7: impulsive mass of tank 8.1, the limit of high frequency between rigid walls.
//!
//! With the wall's normal acceleration prescribed, surface and rotation part without effect and the liquid nearly
//! incompressible, the acceleration a minimises aᵀ (M + K_vol/ω₀²) a, and m_i is the minimum at unit base acceleration.
//! ω₀² = 10⁻⁶ c²/R² makes the error of compressibility about 10⁻⁶.

use std::sync::Arc;

use super::tank::{Sector, Tank};
use super::{BULK_MODULUS, GRAVITY, Source};
use crate::{Answer, Benchmark, Failure, Part, Reference};
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{LiquidProperties, RotationPart, VolumePart};
use fem::linalg::{Kind, Ordering, Symbolic, dot};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "fluid-impulsive",
    title: "Impulsive mass of the displacement liquid",
    model: "Tank 8.1, `fluid8`, the wall's normal acceleration prescribed, nearly incompressible.",
    ids: &[("K7", "impulsive mass of tank 8.1")],
    parts: &[Part::Fast(impulsive_mass)],
};

const RADIUS: f64 = 1.83;

const FILL: f64 = 1.525;

/// m_i/m = 1 − Σ 2 tanh(a)/(a (λ² − 1)), a = λ H/R, over the zeros of J₁'. Terms fall as λ⁻³: after 100 of them the
/// rest is below 10⁻⁵.
fn exact() -> f64 {
    let share = |n: usize| {
        let lambda = codes::bessel::j_prime_zero(1, n);
        let a = lambda * FILL / RADIUS;
        2.0 * a.tanh() / (a * (lambda * lambda - 1.0))
    };
    1.0 - (1..=100).map(share).sum::<f64>()
}

/// m_i/m on a mesh of the quarter.
fn impulsive(counts: [usize; 3], volume: VolumePart) -> Result<f64, Failure> {
    let tank = Tank { radius: RADIUS, fill: FILL, counts, grading: 1.0, part: Sector::Odd };
    let liquid = LiquidProperties { density: 1.0, bulk_modulus: BULK_MODULUS, volume, rotation: RotationPart::None };
    let built = tank.build(Chart::Cylindrical, liquid, GRAVITY, false)?;
    let model = &built.model;
    let group = model.group("liquid");
    let mut a = built.assembler.stiffness_of(model, |e| Some(model.group_of(e)) == group)?;
    let omega_square = 1e-6 * BULK_MODULUS / (RADIUS * RADIUS);
    a.values.iter_mut().for_each(|v| *v /= omega_square);
    a.add(1.0, &built.assembler.mass(model));
    let mut x = vec![0.0; model.dofs().len()];
    let mut free = vec![true; x.len()];
    for &(node, theta) in &built.wall {
        if let Some(e) = model.dofs().equation(node, Dof::Ux) {
            (x[e], free[e]) = (theta.cos(), false);
        }
    }
    let free: Vec<usize> = (0..x.len()).filter(|&e| free[e]).collect();
    let load = a.times(&x);
    let inner = a.submatrix(&free);
    let symbolic = Arc::new(Symbolic::new(inner.pattern.clone(), &Ordering::MinimumDegree)?);
    let right: Vec<f64> = free.iter().map(|&e| -load[e]).collect();
    let found = symbolic.factor(&inner, Kind::Definite)?.solve_vector(&right)?;
    free.iter().zip(found).for_each(|(&e, v)| x[e] = v);
    let mass = std::f64::consts::PI * RADIUS * RADIUS * FILL;
    Ok(4.0 * dot(&x, &a.times(&x)) / mass)
}

/// K7 and its convergence.
///
/// Errors: none to be expected.
pub(crate) fn impulsive_mass() -> Answer {
    let prototype = Source { source: "independent prototype of the same element", kind: Reference::SecondFormulation };
    let series = Source { source: "potential flow, 1 − Σ 2 tanh(a)/(a (λ² − 1))", kind: Reference::ClosedForm };
    let reference = exact();
    let mut convergence = Vec::new();
    for counts in [[6, 8, 6], [9, 12, 9], [12, 16, 12]] {
        let found = impulsive(counts, VolumePart::OnePoint)?;
        convergence.push((counts.iter().product::<usize>() as f64, found / reference - 1.0));
    }
    let one_point = reference * (1.0 + convergence[2].1);
    let what = "tank 8.1, 12 × 16 × 12, m_i/m";
    let mut k7 = prototype.row("K7", format!("{what}, one-point volume part"), (0.4673, one_point), 5e-3, "-");
    k7.convergence = convergence.clone();
    let order = (convergence[0].1 / convergence[2].1).log2();
    let mean = impulsive([12, 16, 12], VolumePart::MeanDilatation)?;
    Ok(vec![
        k7,
        // Half as many elements a direction are 10 % off (prototype), so these are 2.5 %.
        series.row("K7", format!("{what}, mean dilatation"), (reference, mean), 0.03, "-"),
        series.row("K7", "observed order of m_i", (2.0, order), 0.1, "-"),
    ])
}

#[cfg(test)]
mod tests {
    /// The first three terms, 0.49696, 0.0164 and 0.0039, leave 0.4828; with the rest 0.4791 (Veletsos 1984's series).
    #[test]
    fn series() {
        assert!((super::exact() - 0.4791).abs() < 1e-4, "{}", super::exact());
    }
}
