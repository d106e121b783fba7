//! Mass, damping and weight.

use fem::dofs::{Dof, KINDS};
use fem::element::reference_mass;
use nalgebra::{DMatrix, Vector3};

use crate::frame::{damping, weight};
use crate::registry::all;
use crate::specimen::{Mass, Specimen, largest, symmetric, times};

fn along(direction: usize) -> [f64; KINDS] {
    let mut out = [0.0; KINDS];
    out[direction] = 1.0;
    out
}

/// Directions along which the mass is known: those that the element has dofs for.
fn directions(specimen: &Specimen) -> impl Iterator<Item = Dof> {
    let own = |d: &Dof| match specimen.mass {
        Mass::Along(axis, ..) => d.index() == axis,
        _ => specimen.moves(d.index()),
    };
    Dof::TRANSLATIONS.iter().copied().filter(own).collect::<Vec<_>>().into_iter()
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Sums over the matrix against hand calculations: entries are exact quadratures, 10⁻¹² of the total is rounding.
#[test]
fn the_mass_sums_up() {
    for specimen in all() {
        let element = specimen.element();
        let mass = reference_mass(&*element);
        assert!(symmetric(&mass), "{specimen}: mass");
        assert_eq!(element.has_mass(), largest(&mass.data) > 0.0, "{specimen}: has_mass");
        match specimen.mass {
            Mass::Of(total) | Mass::Along(_, total, _) | Mass::Weightless(total, _) => {
                let why = match specimen.mass {
                    Mass::Along(_, _, why) => why,
                    _ => "",
                };
                for dof in directions(&specimen) {
                    let row = specimen.row(|_| along(dof.index()));
                    let found = product(&row, &times(&mass, &row));
                    assert!(
                        (found / total - 1.0).abs() <= 1e-12,
                        "{specimen}: {found} kg along {dof}, not {total} ({why})"
                    );
                }
                assert!(smallest(&mass.data, mass.n) >= -1e-12 * largest(&mass.data), "{specimen}: negative mass");
            }
            Mass::Joins { left, right, value } => {
                let found = product(&specimen.row(left), &times(&mass, &specimen.row(right)));
                assert!((found / value - 1.0).abs() <= 1e-12, "{specimen}: {found}, not {value}");
            }
            Mass::Elsewhere(why) => {
                assert!(largest(&mass.data) > 0.0, "{specimen}: no mass; {why}");
                assert!(smallest(&mass.data, mass.n) >= -1e-12 * largest(&mass.data), "{specimen}: negative mass");
            }
            Mass::None(why) => assert_eq!(largest(&mass.data), 0.0, "{specimen}: mass in spite of: {why}"),
        }
    }
}

/// The nodal weights add up to mass times acceleration.
#[test]
fn the_weight_is_that_of_the_mass() {
    let pull = Vector3::new(1.0, -2.0, 3.0);
    for specimen in all() {
        let element = specimen.element();
        let forces = weight(&*element, pull);
        match specimen.mass {
            Mass::Of(total) | Mass::Along(_, total, _) => {
                for dof in directions(&specimen) {
                    let sum = product(&forces, &specimen.row(|_| along(dof.index())));
                    let expected = total * pull[dof.index()];
                    assert!((sum / expected - 1.0).abs() <= 1e-12, "{specimen}: {sum} N along {dof}, not {expected}");
                }
            }
            Mass::Weightless(_, why) => assert_eq!(largest(&forces), 0.0, "{specimen}: weight in spite of: {why}"),
            _ => assert_eq!(largest(&forces), 0.0, "{specimen}: weight"),
        }
    }
}

/// Damping dissipates energy.
#[test]
fn damping_is_symmetric_and_takes_energy() {
    for specimen in all() {
        let matrix = damping(&*specimen.element());
        assert!(symmetric(&matrix), "{specimen}: damping");
        let least = smallest(&matrix.data, matrix.n);
        assert!(least >= -1e-12 * largest(&matrix.data), "{specimen}: gives energy, {least:e}");
    }
}

/// Smallest eigenvalue.
fn smallest(data: &[f64], n: usize) -> f64 {
    DMatrix::from_column_slice(n, n, data).symmetric_eigenvalues().min()
}
