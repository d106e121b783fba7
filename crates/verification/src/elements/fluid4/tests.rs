use fem::element::{Fluid8, RotationPart, reference_mass, reference_stiffness};
use fem::mesh::Hexahedron;

use super::*;

fn face() -> Face {
    Face { nodes: [0, 1, 2, 3], chart: [[1.0, 0.0, 0.0], [1.9, 0.0, 0.1], [2.0, 0.0, 0.8], [0.9, 0.0, 0.7]] }
}

fn liquid(volume: VolumePart, rotation: RotationPart) -> LiquidProperties {
    LiquidProperties { density: 1000.0, bulk_modulus: 2e6, volume, rotation }
}

/// The spatial element one element thick, moved equally on both sides, is the plane element; in the cylindrical chart the
/// sector moved axisymmetrically is the axisymmetric one. The angle stays in θ, so the two agree exactly.
#[test]
fn spatial_element_under_plane_motion() {
    let parts = [RotationPart::Full(3e4), RotationPart::OnePoint(3e4), RotationPart::Split { centre: 3e4, rest: 1e4 }];
    let thickness = 0.3;
    for chart in [Chart::Cartesian, Chart::Cylindrical] {
        for volume in [VolumePart::Full, VolumePart::OnePoint, VolumePart::MeanDilatation] {
            for rotation in parts {
                let plane = Fluid4::new(&face(), chart, thickness, liquid(volume, rotation)).unwrap();
                // Bottom corners 1, 2 with y = 0 and y = thickness, then the top ones.
                let at = |a: usize, side: f64| {
                    let mut c = face().chart[a];
                    c[1] = side * thickness;
                    c
                };
                let order = [(0, 0.0), (1, 0.0), (1, 1.0), (0, 1.0), (3, 0.0), (2, 0.0), (2, 1.0), (3, 1.0)];
                let solid = Hexahedron { nodes: [0, 1, 2, 3, 4, 5, 6, 7], chart: order.map(|(a, side)| at(a, side)) };
                let spatial = Fluid8::new(&solid, chart, liquid(volume, rotation)).unwrap();
                // Columns: the spatial motion of each plane dof.
                let motion: Vec<Vec<f64>> = (0..8)
                    .map(|k| {
                        let mut u = vec![0.0; 24];
                        for (n, &(a, _)) in order.iter().enumerate() {
                            if a == k / 2 {
                                let base = chart.orthonormal_base(solid.chart[n])[if k % 2 == 0 { 0 } else { 2 }];
                                u[3 * n..3 * n + 3].copy_from_slice(base.as_slice());
                            }
                        }
                        u
                    })
                    .collect();
                for (one, other) in [
                    (reference_stiffness(&plane).unwrap(), reference_stiffness(&spatial).unwrap()),
                    (reference_mass(&plane), reference_mass(&spatial)),
                ] {
                    let scale = one.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                    for (i, left) in motion.iter().enumerate() {
                        for (j, right) in motion.iter().enumerate() {
                            let mut reduced = 0.0;
                            for a in 0..24 {
                                for b in 0..24 {
                                    reduced += left[a] * other.get(a, b) * right[b];
                                }
                            }
                            let expected = one.get(i, j);
                            assert!((reduced - expected).abs() < 1e-12 * scale, "{chart:?} {volume:?} {i} {j}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn bad_input_is_rejected() {
    let good = liquid(VolumePart::MeanDilatation, RotationPart::None);
    let mut inside_out = face();
    inside_out.chart.swap(1, 3);
    assert!(Fluid4::new(&inside_out, Chart::Cartesian, 1.0, good).is_err());
    assert!(Fluid4::new(&face(), Chart::Cartesian, 0.0, good).is_err());
    let bad = LiquidProperties { bulk_modulus: -2.0, ..good };
    assert!(Fluid4::new(&face(), Chart::Cartesian, 1.0, bad).is_err());
    // Half of it at negative radii.
    let mut across = face();
    across.chart.iter_mut().for_each(|c| c[0] -= 1.5);
    assert!(Fluid4::new(&across, Chart::Cylindrical, 1.0, good).is_err());
}
