//! The operator against the dense matrices, which are made in another way: over all elevations first.

use super::*;
use crate::liquid::{CondensedLiquid, LiquidMesh};

const RADIUS: f64 = 1.83;
const DEPTH: f64 = 1.5;

fn liquid(sectors: usize) -> HarmonicLiquid {
    let mesh = LiquidMesh::graded(RADIUS, DEPTH, 1.0);
    HarmonicLiquid::new(RADIUS, 1000.0, 9.81, sectors, &[0.0, 0.2, 0.6, 1.1, DEPTH], &mesh, 1).unwrap()
}

/// Largest difference relative to the largest entry.
fn apart(a: &Matrix, b: &Matrix) -> f64 {
    let largest = a.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let pairs = a.data.iter().zip(&b.data);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

/// Mass and stiffness over the wall and, independent of the signs of modes, what the amplitudes add to wall and rim; 10⁻¹² is
/// rounding of sums of a hundred terms.
#[test]
fn operator_is_the_dense_matrix() {
    for (sectors, half) in [(9, false), (12, false), (12, true)] {
        let harmonic = liquid(sectors);
        let own = CircularLiquid::new(&harmonic, half, 7).unwrap();
        let count = own.omega.len();
        // Both families of a harmonic or none.
        assert!(count == 7 || (!half && count == 6));
        let whole = match half {
            true => CondensedLiquid::of_harmonic_half(&harmonic).unwrap(),
            false => CondensedLiquid::of_harmonic(&harmonic),
        };
        let dense = whole.with_sloshing_modes(count).unwrap();
        assert_eq!(dense.wall, own.operator.wall());
        for (a, b) in own.omega.iter().zip(&dense.omega) {
            assert!((a / b - 1.0).abs() < 1e-10, "{a} {b}");
        }
        let wall: Vec<usize> = (0..dense.wall).collect();
        let surface: Vec<usize> = (dense.wall..dense.mass.rows).collect();
        let pairs = [(&dense.mass, own.operator.dense_mass()), (&dense.stiffness, own.operator.dense_stiffness())];
        for (a, b) in &pairs {
            assert!(apart(&a.select(&wall, &wall), &b.select(&wall, &wall)) < 1e-12);
            assert!(apart(&a.select(&surface, &surface), &b.select(&surface, &surface)) < 1e-12);
            let gram = |a: &Matrix| {
                let coupling = a.select(&surface, &wall);
                transposed_product(&coupling, &coupling)
            };
            // The stiffness does not couple modes and wall except by the volume.
            let largest = gram(a).data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            assert!(largest < 1e-9 || apart(&gram(a), &gram(b)) < 1e-12);
        }
        let coupling = |a: &Matrix| a.select(&surface, &wall);
        let masses = [coupling(pairs[0].0), coupling(&pairs[0].1)];
        assert_eq!(own.rim.len(), dense.rim.len());
        for (a, b) in dense.rim.iter().zip(&own.rim) {
            assert_eq!(a.harmonic, b.harmonic);
            assert_eq!((a.sine.is_empty(), b.sine.is_empty()), (half || a.harmonic == 0, half || a.harmonic == 0));
            for (a, b) in [(&a.row, &b.row), (&a.sine, &b.sine)] {
                if a.is_empty() {
                    continue;
                }
                let largest = a.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                for (a, b) in a[..dense.wall].iter().zip(b) {
                    assert!((a - b).abs() < 1e-12 * largest, "{a} {b}");
                }
                let on_wall =
                    [masses[0].transposed_times(&a[dense.wall..]), masses[1].transposed_times(&b[dense.wall..])];
                let largest = on_wall[0].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                for (a, b) in on_wall[0].iter().zip(&on_wall[1]) {
                    assert!((a - b).abs() < 1e-11 * largest, "{a} {b}");
                }
            }
        }
    }
}

/// With all modes a translation carries the liquid, ρ π R² H (half of it on half a tank), on any mesh; modes that are left out
/// carry theirs with an elevation of their own.
#[test]
fn translation_carries_the_liquid() {
    for (half, share) in [(false, 1.0), (true, 0.5)] {
        let own = CircularLiquid::new(&liquid(10), half, 1000).unwrap();
        let meridians = own.operator.ring().meridians();
        let mut x: Vec<f64> =
            (0..own.operator.wall()).map(|i| (std::f64::consts::TAU * (i % meridians) as f64 / 10.0).cos()).collect();
        x.resize(own.operator.size(), 0.0);
        let mut y = vec![0.0; x.len()];
        own.operator.add_mass(1.0, &x, &mut y);
        let exact = share * 1000.0 * std::f64::consts::PI * RADIUS * RADIUS * DEPTH;
        assert!((dot(&x, &y) / exact - 1.0).abs() < 1e-9);
    }
}

#[test]
fn bad_input_is_rejected() {
    assert!(CircularLiquid::new(&liquid(9), true, 4).is_err());
    let own = CircularLiquid::new(&liquid(8), true, 4).unwrap();
    assert!(own.element(&[], &[], 0.0).is_err());
}
