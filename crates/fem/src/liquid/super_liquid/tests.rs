//! Condensed liquids against the mass of the liquid, its sloshing frequencies and each other.

use super::*;
use crate::liquid::LiquidMesh;

const RADIUS: f64 = 2.0;
const DEPTH: f64 = 1.6;
const DENSITY: f64 = 1000.0;
const GRAVITY: f64 = 9.81;

/// ιᵀ M ι of a translation along x.
fn moved(found: &CondensedLiquid, iota: &[f64]) -> f64 {
    crate::linalg::dot(iota, &found.mass.times(iota))
}

/// The harmonic liquid as matrices is its operator, and an element with amplitudes damps its modes.
#[test]
fn harmonic_liquid() {
    let liquid = HarmonicLiquid::new(
        RADIUS,
        DENSITY,
        GRAVITY,
        6,
        &[0.0, 0.5, 1.0, DEPTH],
        &LiquidMesh::graded(RADIUS, DEPTH, 1.0),
        1,
    )
    .unwrap();
    let found = CondensedLiquid::of_harmonic(&liquid);
    assert_eq!((found.wall, found.surface()), (24, liquid.elevations()));
    let mut iota: Vec<f64> = (0..24).map(|i| (std::f64::consts::TAU * (i % 6) as f64 / 6.0).cos()).collect();
    iota.resize(found.mass.rows, 0.0);
    let exact = DENSITY * std::f64::consts::PI * RADIUS * RADIUS * DEPTH;
    assert!((moved(&found, &iota) / exact - 1.0).abs() < 1e-9);
    let modal = found.with_sloshing_modes(6).unwrap();
    let wall: Vec<(usize, Dof)> = (0..24).map(|n| (n, Dof::Ux)).collect();
    let q: Vec<(usize, Dof)> = (24..30).map(|n| (n, Dof::Amplitude)).collect();
    let element = modal.element(&wall, &q, 0.005).unwrap();
    let mut c = crate::element::LocalMatrix::zeros(30);
    assert!(crate::element::Element::damping(&element, &mut c));
    for (j, omega) in modal.omega.iter().enumerate() {
        assert!((c.get(24 + j, 24 + j) - 0.01 * omega).abs() < 1e-12);
        assert!((modal.mass.get(24 + j, 24 + j) - 1.0).abs() < 1e-9);
    }
}

/// What a motion turned by a quarter of the circle does to the sine, the motion does to the cosine: rounding of sums of some ten
/// terms, 1e-12.
#[test]
fn a_turned_motion_lifts_the_sine() {
    let (sectors, heights) = (8, [0.0, 0.5, 1.0, DEPTH]);
    let mesh = LiquidMesh::graded(RADIUS, DEPTH, 1.0);
    let liquid = HarmonicLiquid::new(RADIUS, DENSITY, GRAVITY, sectors, &heights, &mesh, 1).unwrap();
    let whole = CondensedLiquid::of_harmonic(&liquid);
    let rim = whole.rim.iter().find(|rim| rim.harmonic == 1).unwrap();
    let own: Vec<usize> = liquid.blocks.iter().map(|b| b.elevations(heights.len())).collect();
    let motion = |turned: bool| {
        let back = if turned { sectors / 4 } else { 0 };
        let w = |level: usize, k: usize| ((3 * level + 5 * ((k + sectors - back) % sectors)) as f64).sin();
        let mut x: Vec<f64> = (0..heights.len()).flat_map(|l| (0..sectors).map(move |k| w(l, k))).collect();
        x.resize(whole.mass.rows, 0.0);
        let first = whole.wall + own[0] + if turned { own[1] } else { 0 };
        (0..own[1]).for_each(|i| x[first + i] = (0.7 * i as f64).cos());
        x
    };
    let (cosine, sine) = (crate::linalg::dot(&rim.row, &motion(false)), crate::linalg::dot(&rim.sine, &motion(true)));
    assert!((sine / cosine - 1.0).abs() < 1e-12, "{sine} {cosine}");
    assert!(whole.rim[0].sine.is_empty());
}

/// Half of a liquid has half the energy of every motion that is symmetric, and its rim rises as the whole one does.
#[test]
fn symmetric_half() {
    let heights = [0.0, 0.5, 1.0, DEPTH];
    let sectors = 8;
    let mesh = LiquidMesh::graded(RADIUS, DEPTH, 1.0);
    let liquid = HarmonicLiquid::new(RADIUS, DENSITY, GRAVITY, sectors, &heights, &mesh, 1).unwrap();
    let (whole, half) = (CondensedLiquid::of_harmonic(&liquid), CondensedLiquid::of_harmonic_half(&liquid).unwrap());
    let meridians = sectors / 2 + 1;
    assert_eq!((half.wall, half.rim.len()), (meridians * heights.len(), 2));
    // A motion without pattern; elevations of the cosines only.
    let w = |level: usize, k: usize| ((3 * level + 5 * k) as f64).sin();
    let eta = |i: usize| (0.7 * i as f64).cos();
    let mut x: Vec<f64> =
        (0..heights.len()).flat_map(|l| (0..sectors).map(move |k| w(l, k.min(sectors - k)))).collect();
    let mut y: Vec<f64> = (0..heights.len()).flat_map(|l| (0..meridians).map(move |k| w(l, k))).collect();
    let own: Vec<usize> = liquid.blocks.iter().map(|b| b.elevations(heights.len())).collect();
    x.extend((0..own[0] + own[1]).map(eta));
    x.resize(whole.mass.rows, 0.0);
    y.extend((0..own[0] + own[1]).map(eta));
    assert_eq!(y.len(), half.mass.rows);
    let energy = |a: &Matrix, x: &[f64]| crate::linalg::dot(x, &a.times(x));
    for (a, b) in [(&whole.mass, &half.mass), (&whole.stiffness, &half.stiffness)] {
        let (full, part) = (energy(a, &x), energy(b, &y));
        assert!((2.0 * part / full - 1.0).abs() < 1e-12, "{part} {full}");
    }
    for (a, b) in whole.rim.iter().zip(&half.rim) {
        let (full, part) = (crate::linalg::dot(&a.row, &x), crate::linalg::dot(&b.row, &y));
        assert!(a.harmonic == b.harmonic && (part / full - 1.0).abs() < 1e-12, "{part} {full}");
    }
    // With all modes the same energies, and at rest a rim that rises by what a breathing wall displaces less:
    // π R² η = −2 π R H w for a uniform elevation, which is the only one without pressure from gravity alone.
    let modal = half.with_sloshing_modes(half.surface()).unwrap();
    let (mut k, mut f) = (modal.stiffness.clone(), vec![0.0; modal.mass.rows]);
    (0..modal.wall).for_each(|i| k.add(i, i, 1.0));
    // Wall held at w = 1 by stiff springs.
    let stiff = 1e15;
    for i in 0..modal.wall {
        k.add(i, i, stiff);
        f[i] = stiff;
    }
    let mut rest = Matrix { rows: f.len(), cols: 1, data: f };
    crate::linalg::Cholesky::factor(&k).unwrap().solve(&mut rest);
    let rise = |rim: &Rim| crate::linalg::dot(&rim.row, &rest.data);
    let exact = -2.0 * DEPTH / RADIUS;
    assert!((rise(&modal.rim[0]) / exact - 1.0).abs() < 1e-6, "{} {exact}", rise(&modal.rim[0]));
    assert!(rise(&modal.rim[1]).abs() < 1e-6);
    let odd = HarmonicLiquid::new(RADIUS, DENSITY, GRAVITY, 7, &heights, &mesh, 1).unwrap();
    assert!(CondensedLiquid::of_harmonic_half(&odd).is_err());
}
