//! M4 to M9: laws of concrete.

use materials::Law;
use materials::concrete::{
    Compression, CrackedConcrete, CrackedParameters, PostPeak, ShearRetention, Softening, Tension, UniaxialConcrete,
};

use super::compression::{drucker_prager, kupfer, plastic_fracturing};
use super::drive::{Noise, Point};
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "materials-concrete",
    title: "Stress laws: cracking concrete",
    model: "One point: E = 34 GPa, ν = 0.2, f_c = 35 MPa, f_t = 3.5 MPa, G_f = 100 N/m on 100 mm; and a bar of 1 \
            m that localises in one element.",
    ids: &[
        ("M3", "Drucker-Prager: biaxial strength"),
        ("M4", "plastic-fracturing law: stresses, stiffness and residual strains"),
        ("M5", "cyclic path of cracking concrete"),
        ("M6", "energy of a bar that localises"),
        ("M7", "closed strain cycles dissipate"),
        ("M8", "shear of a crack"),
        ("M9", "a crack that closes and opens again"),
        ("M14", "biaxial envelope of Kupfer and Gerstle"),
    ],
    parts: &[Part::Fast(drucker_prager), Part::Fast(plastic_fracturing), Part::Fast(kupfer), Part::Fast(concrete)],
};

/// E [Pa], ν, f_c, f_t [Pa], G_f [N/m] of the rows, unless noted.
const E: f64 = 34e9;

const NU: f64 = 0.2;

const F_C: f64 = 35e6;

const F_T: f64 = 3.5e6;

const G_F: f64 = 100.0;

/// A prototype of the law, in another language, as printed in the theory manual.
const PROTOTYPE: &str = "prototype of the crack-strain model, table of the theory sheet";

fn tension(size: f64) -> Tension {
    Tension { strength: F_T, softening: Softening::Energy { fracture_energy: G_F, size }, stiffening: None, bond: None }
}

fn layer() -> Result<CrackedConcrete, Failure> {
    Ok(CrackedConcrete::new(&CrackedParameters::new(E, NU, F_C, tension(0.1)))?)
}

fn row(id: &str, what: String, reference: f64, source: &'static str, kind: Reference, computed: f64) -> Row {
    Row::new(id, what, (reference, source, kind), computed, (2e-3, "MPa"))
}

/// Rows M4 (residual strains of fibres), M5 (cyclic path), M6 (energy of a bar), M7 (closed cycles), M8 (shear of a crack)
/// and M9 (closing and opening again).
///
/// Errors: a law that fails.
pub(crate) fn concrete() -> Answer {
    let mut rows = residual()?;
    rows.extend(path()?);
    rows.extend(bar()?);
    rows.extend(cycles()?);
    rows.extend(shear()?);
    rows.extend(reopening()?);
    Ok(rows)
}

/// M4 of fibres: strain that remains after unloading from x ε_c1.
fn residual() -> Answer {
    let peak_strain = 2.2e-3;
    let law = UniaxialConcrete::new(
        E,
        Compression::Sargin {
            strength: F_C,
            peak_strain,
            post_peak: PostPeak::Crushing { crushing_energy: 250.0 * G_F, size: 0.1 },
        },
        None,
    )?;
    let mut point = Point::new(&law as &dyn Law<1>);
    let mut rows = Vec::new();
    for (x, reference) in [(0.5, 0.1013), (1.0, 0.275), (1.5, 0.521), (2.0, 0.840)] {
        point.step([-x * peak_strain])?;
        rows.push(Row {
            // The formula's printed digits.
            tolerance: 1e-3,
            unit: "",
            ..row(
                "M4",
                format!("fibre: residual strain over ε_c1 after unloading from {x} ε_c1"),
                reference,
                "Karsan & Jirsa 1969, 0.145 x² + 0.13 x",
                Reference::Published,
                point.inspect().plastic_strain / peak_strain,
            )
        });
    }
    Ok(rows)
}

/// M5: uniaxial stress along a path of strains, by the plane law and by the law of fibres.
fn path() -> Answer {
    const STEPS: [(f64, f64, f64); 11] = [
        (1e-4, 3.4, 0.0),
        (3e-4, 1.4171, 0.2583),
        (0.0, 0.0, 0.2583),
        (-5e-4, -17.0, 0.2583),
        (3e-4, 1.4171, 0.2583),
        (6e-4, 0.4489, 0.5868),
        (-2e-3, -35.0, 0.5868),
        (-1e-3, -1.0, 0.5868),
        (0.0, 0.1186, 0.9671),
        (6e-4, 0.0144, 1.570),
        (1.2e-3, 0.0018, 2.171),
    ];
    let fibre = UniaxialConcrete::new(E, Compression::Plastic { strength: F_C }, Some(tension(0.1)))?;
    let mut rows = walk::<3>("layer", &layer()?, &STEPS)?;
    rows.extend(walk::<1>("fibre", &fibre, &STEPS)?);
    Ok(rows)
}

fn walk<const N: usize>(name: &str, law: &dyn Law<N>, steps: &[(f64, f64, f64)]) -> Answer {
    let mut point = Point::new(law);
    let mut rows = Vec::new();
    for (i, &(strain, stress, opening)) in steps.iter().enumerate() {
        let found = point.step_uniaxial(strain, F_T)?.stress[0] / 1e6;
        let largest = 1e3 * point.inspect().cracks[0].map_or(0.0, |crack| crack.largest);
        let label = format!("{name}, strain {:.1}e-4, step {}", 1e4 * strain, i + 1);
        rows.push(Row {
            // 0.2 %, or half the last digit printed.
            tolerance: if stress == 0.0 { 5e-5 } else { f64::max(2e-3, 5e-5 / stress.abs()) },
            ..row("M5", format!("{label}: stress"), stress, PROTOTYPE, Reference::SecondFormulation, found)
        });
        rows.push(Row {
            tolerance: if opening == 0.0 { 5e-5 } else { 2e-3 },
            unit: "1e-3",
            ..row(
                "M5",
                format!("{label}: largest opening strain"),
                opening,
                PROTOTYPE,
                Reference::SecondFormulation,
                largest,
            )
        });
    }
    Ok(rows)
}

/// M6: a bar of 1 m, one of its elements cracks, the others unload. Work of the end force by the trapezoidal rule.
///
/// With e_f of h = 0.2 m kept for every mesh the energy is G_f h/(0.2 m): the mistake that the first rows exclude.
fn bar() -> Answer {
    let right = energies(|size| Softening::Energy { fracture_energy: G_F, size })?;
    let wrong = energies(|_| Softening::Strain { softening_strain: G_F / (3e6 * 0.2) })?;
    let study: Vec<(f64, f64)> = right.iter().map(|&(n, work)| (n, work / G_F - 1.0)).collect();
    let mut rows = Vec::new();
    for (works, name, kept) in [(right, "by fracture energy", false), (wrong, "e_f of h = 0.2 m kept", true)] {
        for (elements, work) in works {
            let reference = 1e-3 * if kept { G_F / (0.2 * elements) } else { G_F };
            rows.push(Row {
                tolerance: 2e-3,
                unit: "N/mm",
                convergence: if kept { Vec::new() } else { study.clone() },
                ..row(
                    "M6",
                    format!("energy of a cracking bar of {elements} elements, {name}"),
                    reference,
                    "∫ t de = f_t e_f",
                    Reference::ClosedForm,
                    1e-3 * work,
                )
            });
        }
    }
    Ok(rows)
}

/// Number of elements and work per area [N/m] of the bar: E 30 GPa, f_t 3 MPa.
fn energies(softening: impl Fn(f64) -> Softening) -> Result<Vec<(f64, f64)>, Failure> {
    let (young, strength) = (30e9, 3e6);
    let mut found = Vec::new();
    for elements in [5.0, 10.0, 20.0, 40.0] {
        let size = 1.0 / elements;
        let softening = softening(size);
        let e_f = match softening {
            Softening::Strain { softening_strain } => softening_strain,
            _ => G_F / (strength * size),
        };
        let law = CrackedConcrete::new(&CrackedParameters::new(
            young,
            NU,
            30e6,
            Tension { strength, softening, stiffening: None, bond: None },
        ))?;
        let mut point = Point::new(&law as &dyn Law<3>);
        let (mut work, mut end, mut stress) = (0.0, 0.0, 0.0);
        for i in 1..=2000 {
            // Finer where the crack begins.
            let strain = 25.0 * e_f * (f64::from(i) / 2000.0).powi(2);
            let next_stress = point.step_uniaxial(strain, strength)?.stress[0];
            let next = size * strain + (1.0 - size) * next_stress / young;
            work += 0.5 * (stress + next_stress) * (next - end);
            (end, stress) = (next, next_stress);
        }
        found.push((elements, work));
    }
    Ok(found)
}

/// M7: 150 random closed strain cycles of 360 steps.
fn cycles() -> Answer {
    let law = layer()?;
    let mut noise = Noise(7);
    let (mut steps, mut cut) = (0.0, 0.0);
    let (mut least_work, mut least_step) = (f64::INFINITY, f64::INFINITY);
    for cycle in 0..150 {
        let size = [2e-4, 6e-4, 2e-3][cycle % 3];
        let mut history = vec![0.0; law.history_len()];
        let mut next_history = history.clone();
        let mut corners: Vec<[f64; 3]> = (0..5).map(|_| noise.vector().map(|x| size * x)).collect();
        corners.push([0.0; 3]);
        let (mut work, mut strain, mut stress, mut from) = (0.0, [0.0; 3], [0.0; 3], [0.0; 3]);
        for to in corners {
            for i in 1..=60 {
                let t = f64::from(i) / 60.0;
                let next: [f64; 3] = std::array::from_fn(|k| from[k] + t * (to[k] - from[k]));
                let response = law.respond(&next, &history, &mut next_history)?;
                std::mem::swap(&mut history, &mut next_history);
                for k in 0..3 {
                    work += 0.5 * (stress[k] + response.stress[k]) * (next[k] - strain[k]);
                }
                least_step = least_step.min(response.dissipation / (F_C * size));
                steps += 1.0;
                cut += if law.parts(&history) > 1 { 1.0 } else { 0.0 };
                (strain, stress) = (next, response.stress);
            }
            from = to;
        }
        least_work = least_work.min(work / (F_C * size));
    }
    let no = |what: &str, computed: f64, tolerance: f64, source: &'static str| Row {
        tolerance,
        unit: "",
        ..row("M7", what.to_owned(), 0.0, source, Reference::ClosedForm, computed)
    };
    Ok(vec![
        no(
            "least work of a closed cycle over f_c ε, 150 cycles: its negative part",
            least_work.min(0.0),
            1e-9,
            "second law of thermodynamics",
        ),
        no(
            "least dissipation of a step over f_c ε: its negative part",
            least_step.min(0.0),
            1e-12,
            "second law of thermodynamics",
        ),
        no("share of 54 000 steps that were cut in parts", cut / steps, 1e-3, "aim: 99.9 % in one part"),
    ])
}

/// M8: tension to 3e-4 without lateral strain, then a shear strain of 5e-4.
fn shear() -> Answer {
    let slow = ShearRetention { least: 0.05, strain: 1e-3 };
    let mut rows = Vec::new();
    for (name, retention, tau) in
        [("b 0.1, e_b 2e-4", ShearRetention::default(), 2.4435), ("b 0.05, e_b 1e-3 (locks)", slow, 5.5414)]
    {
        let law =
            CrackedConcrete::new(&CrackedParameters { retention, ..CrackedParameters::new(E, NU, F_C, tension(0.1)) })?;
        let mut point = Point::new(&law as &dyn Law<3>);
        let opened = point.step([3e-4, 0.0, 0.0])?.stress;
        let sheared = point.step([3e-4, 0.0, 5e-4])?.stress;
        for (what, reference, computed) in [
            ("stress across the crack", 1.4076, opened[0]),
            ("stress along the crack", 0.2815, opened[1]),
            ("shear stress", tau, sheared[2]),
        ] {
            rows.push(row(
                "M8",
                format!("{name}: {what}"),
                reference,
                PROTOTYPE,
                Reference::SecondFormulation,
                computed / 1e6,
            ));
        }
    }
    Ok(rows)
}

/// M9: opened to a crack strain of about 1e-3, compressed to −30 MPa, opened again.
fn reopening() -> Answer {
    let law = layer()?;
    let mut point = Point::new(&law as &dyn Law<3>);
    let mut stress = 0.0;
    for i in 1..=100 {
        stress = point.step_uniaxial(1.03e-5 * f64::from(i), F_T)?.stress[0];
    }
    let largest = point.inspect().cracks[0].map_or(f64::NAN, |crack| crack.largest);
    let closed = point.step_uniaxial(-30e6 / E, F_T)?.stress[0];
    let mut excess = f64::NEG_INFINITY;
    for i in 1..=100 {
        let again = point.step_uniaxial(1.03e-5 * f64::from(i), F_T)?.stress[0];
        let opening = point.inspect().cracks[0].map_or(f64::NAN, |crack| crack.opening);
        excess = excess.max((again - stress * opening / largest) / F_T);
    }
    Ok(vec![
        Row {
            tolerance: 1e-9,
            ..row(
                "M9",
                "stress of the closed crack at −30 MPa/E".to_owned(),
                -30.0,
                "whole concrete",
                Reference::ClosedForm,
                closed / 1e6,
            )
        },
        Row {
            tolerance: 1e-9,
            unit: "",
            ..row(
                "M9",
                "tension above the secant when opened again, over f_t".to_owned(),
                0.0,
                "σ = t(m) e/m",
                Reference::ClosedForm,
                excess.max(0.0),
            )
        },
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The energy check can fail: with e_f kept, three of four meshes miss G_f.
    #[test]
    fn kept_softening_strain_misses_the_energy() {
        let misses = bar()
            .unwrap()
            .into_iter()
            .filter(|row| row.what.contains("kept"))
            .map(|row| Row { reference: 0.1, ..row })
            .filter(|row| !row.holds())
            .count();
        assert_eq!(misses, 3);
    }
}
