use nalgebra::Matrix3;

use super::*;
use crate::element::{RotationPart, reference_mass, reference_stiffness};

/// A sector of a ring, distorted in all directions.
fn cell() -> Hexahedron {
    let chart = [
        [1.0, 0.1, 0.0],
        [1.6, 0.2, 0.1],
        [1.7, 0.7, 0.0],
        [1.1, 0.6, -0.1],
        [0.9, 0.15, 0.8],
        [1.5, 0.1, 0.9],
        [1.8, 0.65, 1.1],
        [1.2, 0.55, 0.9],
    ];
    Hexahedron { nodes: [0, 1, 2, 3, 4, 5, 6, 7], chart }
}

fn liquid(volume: VolumePart, rotation: RotationPart) -> LiquidProperties {
    LiquidProperties { density: 1000.0, bulk_modulus: 2e6, volume, rotation }
}

/// The matrices of appendix C, B̃ (rows u_1|_1, u_1|_2, …) at a point, over Cartesian unknowns: slow and obvious.
fn gradient(element: &Fluid8, p: &Point) -> [[f64; 24]; 9] {
    let gamma = element.chart.christoffel(p.x);
    let mut out = [[0.0; 24]; 9];
    for i in 0..3 {
        for j in 0..3 {
            let mut row = [[0.0; 8]; 3];
            for a in 0..8 {
                row[i][a] += p.d[j][a];
                for m in 0..3 {
                    row[m][a] -= p.n[a] * gamma[m][i][j];
                }
            }
            out[3 * i + j] = element.to_cartesian(&row);
        }
    }
    out
}

/// K + R as appendix C assembles them: e = g^ij u_i|_j, ω_ij = ½ (u_i|_j − u_j|_i) in all nine components.
fn textbook(element: &Fluid8) -> Vec<f64> {
    let (full, one) = element.liquid.rotation.penalties();
    let mut out = vec![0.0; 576];
    let mut add = |row: &[f64; 24], w: f64| {
        for a in 0..24 {
            for b in 0..24 {
                out[a + 24 * b] += w * row[a] * row[b];
            }
        }
    };
    let mut visit = |p: &Point, bulk: f64, penalty: f64| {
        let g = gradient(element, p);
        let mut e = [0.0; 24];
        for i in 0..3 {
            for c in 0..24 {
                e[c] += p.metric[i] * g[4 * i][c];
            }
        }
        add(&e, bulk * p.volume);
        for i in 0..3 {
            for j in 0..3 {
                let omega = std::array::from_fn(|c| 0.5 * (g[3 * i + j][c] - g[3 * j + i][c]));
                add(&omega, penalty * p.metric[i] * p.metric[j] * p.volume);
            }
        }
    };
    let bulk = element.liquid.bulk_modulus;
    let whole = element.liquid.volume == VolumePart::Full;
    for q in FULL.iter() {
        visit(&element.point(q), if whole { bulk } else { 0.0 }, full);
    }
    visit(&element.point(&CENTRE[0]), if whole { 0.0 } else { bulk }, one);
    out
}

#[test]
fn stiffness_is_that_of_appendix_c() {
    let parts = [RotationPart::Full(3e4), RotationPart::OnePoint(3e4), RotationPart::Split { centre: 3e4, rest: 1e4 }];
    for chart in [Chart::Cartesian, Chart::Cylindrical] {
        for volume in [VolumePart::Full, VolumePart::OnePoint] {
            for rotation in parts {
                let element = Fluid8::new(&cell(), chart, liquid(volume, rotation)).unwrap();
                let fast = reference_stiffness(&element).unwrap();
                let slow = textbook(&element);
                let scale = slow.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                for (f, s) in fast.data.iter().zip(&slow) {
                    assert!((f - s).abs() < 1e-13 * scale, "{chart:?} {volume:?} {rotation:?}: {f} {s}");
                }
            }
        }
    }
}

/// The gradient of the interpolated field with its Christoffel symbols is the Cartesian gradient of the same field, turned
/// into the chart: u = Σ u_i g^i differentiated numerically in space.
#[test]
fn covariant_derivative_is_the_spatial_gradient() {
    let element = Fluid8::new(&cell(), Chart::Cylindrical, liquid(VolumePart::Full, RotationPart::None)).unwrap();
    let u: [f64; 24] = std::array::from_fn(|k| (1.3 * k as f64 + 0.2).sin());
    let at = |r: f64, s: f64, t: f64| {
        let p = element.point(&Reference::at(r, s, t, 1.0));
        let mut covariant = Vector3::zeros();
        for a in 0..8 {
            let own = element.chart.covariant_base(cell().chart[a]) * Vector3::from_column_slice(&u[3 * a..3 * a + 3]);
            covariant += own * p.n[a];
        }
        // u = u_i g^ii base_i
        let raised = covariant.component_mul(&Vector3::from(p.metric));
        let value = element.chart.covariant_base(p.x).tr_mul(&raised);
        (Vector3::from(element.chart.position(p.x)), value)
    };
    let (xi, h) = ([0.3, -0.4, 0.1], 1e-5);
    let (mut place, mut slope) = (Matrix3::zeros(), Matrix3::zeros());
    for k in 0..3 {
        let (mut lower, mut upper) = (xi, xi);
        lower[k] -= h;
        upper[k] += h;
        let (x0, u0) = at(lower[0], lower[1], lower[2]);
        let (x1, u1) = at(upper[0], upper[1], upper[2]);
        place.set_column(k, &((x1 - x0) / (2.0 * h)));
        slope.set_column(k, &((u1 - u0) / (2.0 * h)));
    }
    let spatial = slope * place.try_inverse().unwrap();
    let p = element.point(&Reference::at(xi[0], xi[1], xi[2], 1.0));
    let base = element.chart.covariant_base(p.x);
    // u_i|_j = base_i · grad u · base_j
    let expected = base * spatial * base.transpose();
    let rows = gradient(&element, &p);
    for i in 0..3 {
        for j in 0..3 {
            let found: f64 = rows[3 * i + j].iter().zip(&u).map(|(r, v)| r * v).sum();
            assert!((found - expected[(i, j)]).abs() < 1e-8, "{i}{j} {found} {}", expected[(i, j)]);
        }
    }
}

/// A wedge on the axis: three Cartesian unknowns at r = 0, whatever θ its corners have there.
#[test]
fn wedge_on_the_axis_sees_a_uniform_expansion() {
    let corner = |r: f64, theta: f64, z: f64| [r, theta, z];
    let chart = [
        corner(0.0, 0.3, 0.0),
        corner(0.8, 0.3, 0.0),
        corner(0.8, 0.7, 0.0),
        corner(0.0, 0.7, 0.0),
        corner(0.0, 0.3, 0.5),
        corner(0.8, 0.3, 0.5),
        corner(0.8, 0.7, 0.5),
        corner(0.0, 0.7, 0.5),
    ];
    let wedge = Hexahedron { nodes: [0, 1, 2, 0, 3, 4, 5, 3], chart };
    let element =
        Fluid8::new(&wedge, Chart::Cylindrical, liquid(VolumePart::MeanDilatation, RotationPart::None)).unwrap();
    assert!((element.volume() - 0.5 * 0.8 * 0.8 * 0.4 * 0.5).abs() < 1e-14);
    // u = (r e_r, z): û₁ = r is in the space, e = 3.
    let u: Vec<f64> = chart.iter().flat_map(|&c| Chart::Cylindrical.position(c)).collect();
    let sample = &element.samples()[0];
    let pressure: f64 = sample.row.iter().zip(&u).map(|(r, v)| r * v).sum();
    assert!((pressure + 3.0 * 2e6).abs() < 1e-6, "{pressure}");
}

#[test]
fn mass_and_weight() {
    for chart in [Chart::Cartesian, Chart::Cylindrical] {
        for volume in [VolumePart::Full, VolumePart::OnePoint, VolumePart::MeanDilatation] {
            let element = Fluid8::new(&cell(), chart, liquid(volume, RotationPart::Full(1.0))).unwrap();
            let m = reference_mass(&element);
            let vertical: f64 =
                (0..8).flat_map(|a| (0..8).map(move |b| (3 * a + 2, 3 * b + 2))).map(|(i, j)| m.get(i, j)).sum();
            assert!((vertical / (1000.0 * element.volume()) - 1.0).abs() < 1e-13);
            let mut load = [0.0; 24];
            element.body_force([0.0, 0.0, -9.81], &mut load);
            let sum: f64 = load.iter().skip(2).step_by(3).sum();
            let taken = match volume {
                VolumePart::OnePoint => element.point(&CENTRE[0]).volume,
                _ => element.volume(),
            };
            assert!((sum / (-9810.0 * taken) - 1.0).abs() < 1e-13);
            // Fully integrated, the load is the mass matrix times the field, if the field is in the space.
            if volume != VolumePart::OnePoint {
                for a in 0..8 {
                    let row: f64 = (0..8).map(|b| m.get(3 * a + 2, 3 * b + 2)).sum();
                    assert!((load[3 * a + 2] + 9.81 * row).abs() < 1e-9);
                }
            }
        }
    }
}

#[test]
fn bad_input_is_rejected() {
    let good = liquid(VolumePart::MeanDilatation, RotationPart::Full(1.0));
    let mut flat = cell();
    flat.chart.swap(0, 4);
    flat.chart.swap(1, 5);
    flat.chart.swap(2, 6);
    flat.chart.swap(3, 7);
    assert!(matches!(Fluid8::new(&flat, Chart::Cartesian, good), Err(ElementError::Jacobian { .. })));
    let mut nan = cell();
    nan.chart[3][1] = f64::NAN;
    assert!(Fluid8::new(&nan, Chart::Cartesian, good).is_err());
    let bad = [
        LiquidProperties { bulk_modulus: 0.0, ..good },
        LiquidProperties { density: -1.0, ..good },
        LiquidProperties { rotation: RotationPart::OnePoint(-1.0), ..good },
        LiquidProperties { rotation: RotationPart::Split { centre: 1.0, rest: 2.0 }, ..good },
    ];
    for liquid in bad {
        let error = Fluid8::new(&cell(), Chart::Cartesian, liquid).unwrap_err();
        assert!(matches!(error, ElementError::Parameter { .. }), "{error}");
    }
}
