use nalgebra::UnitQuaternion;

use super::*;
use crate::element::{Motion, Trial, Want, reference_stiffness};
use crate::shape::gauss;

const TOP: [usize; 4] = [0, 1, 2, 3];
const BOTTOM: [usize; 4] = [4, 5, 6, 7];
const UP: [[f64; 3]; 4] = [[0.0, 0.0, 1.0]; 4];

/// The 2 × 2 square in the plane z = 0, whose parameters are x and y.
fn square() -> Face {
    Face { nodes: BOTTOM, chart: quad4::CORNERS.map(|[x, y]| [x, y, 0.0]) }
}

fn joint(law: ContactLaw) -> Contact8 {
    Contact8::new(&square(), Chart::Cartesian, TOP, BOTTOM, UP, law).unwrap()
}

/// Values of the dofs for gaps at the corners.
fn opened(gaps: [f64; 4]) -> [f64; 24] {
    let mut values = [0.0; 24];
    for a in 0..4 {
        values[3 * a + 2] = gaps[a];
    }
    values
}

fn respond(element: &Contact8, values: &[f64]) -> Response {
    let mut response = Response::sized(24);
    let motion = Motion { values, rotations: &[UnitQuaternion::identity(); 8] };
    element.respond(Trial { motion, old: &[], new: &mut [], want: Want::ALL }, &mut response).unwrap();
    response
}

/// Forces along the normal at the top, per k_n, of a joint that transmits no tension at all.
fn forces(gaps: [f64; 4], integration: Integration) -> [f64; 4] {
    let law = ContactLaw { opening: Opening::Unilateral { residual: 0.0 }, integration, ..ContactLaw::bonded(1.0) };
    let force = respond(&joint(law), &opened(gaps)).force;
    std::array::from_fn(|a| force[3 * a + 2])
}

/// C7: t = k_n g with g = x on the closed half x < 0: ∫ N_a x dA = −5/12 at x = −1 and −1/12 at x = 1.
#[test]
fn half_closed_square() {
    let found = forces([-1.0, 1.0, 1.0, -1.0], Integration::Clipped);
    for (f, exact) in found.iter().zip([-5.0, -1.0, -1.0, -5.0]) {
        assert!((f - exact / 12.0).abs() < 1e-14, "{found:?}");
    }
}

/// C7: a uniform gap: closed, the whole area at each quarter; open, the residual only.
#[test]
fn uniform_gap() {
    let element = joint(ContactLaw::unilateral(3e6));
    let closed = respond(&element, &opened([-1e-3; 4])).force;
    let open = respond(&element, &opened([1e-3; 4])).force;
    for a in 0..4 {
        assert!((closed[3 * a + 2] + 3e3).abs() < 1e-9 && (closed[12 + 3 * a + 2] - 3e3).abs() < 1e-9);
        assert!((open[3 * a + 2] - 3e-3).abs() < 1e-15);
    }
    let bonded = respond(&joint(ContactLaw::bonded(3e6)), &opened([1e-3; 4])).force;
    assert!((bonded[2] - 3e3).abs() < 1e-9);
}

/// Forces by iterated integration the other way round, lines r = const, on 50 pieces between the places where the gap
/// changes sign on the edges s = ±1.
fn fine(gaps: [f64; 4]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    let zero = |a: f64, b: f64| if (a < 0.0) != (b < 0.0) { (a + b) / (a - b) } else { 1.0 };
    let mut cuts = [-1.0, zero(gaps[0], gaps[1]), zero(gaps[3], gaps[2]), 1.0];
    cuts.sort_by(f64::total_cmp);
    for ends in cuts.windows(2) {
        let half_piece = 0.5 * (ends[1] - ends[0]) / 50.0;
        for (piece, (y, wy)) in (0..50).flat_map(|piece| gauss::FIVE.iter().map(move |p| (piece, p))) {
            let r = ends[0] + half_piece * (2.0 * f64::from(piece) + 1.0 + y);
            let at = |s: f64| quad4::value(r, s).iter().zip(&gaps).map(|(n, g)| n * g).sum::<f64>();
            let (lower, upper) = (at(-1.0), at(1.0));
            let (from, to) = match (lower < 0.0, upper < 0.0) {
                (true, true) => (-1.0, 1.0),
                (true, false) => (-1.0, zero(lower, upper)),
                (false, true) => (zero(lower, upper), 1.0),
                (false, false) => continue,
            };
            for &(x, wx) in gauss::TWO {
                let s = 0.5 * (from + to) + 0.5 * (to - from) * x;
                let weight = wx * 0.5 * (to - from) * wy * half_piece;
                for (f, n) in sum.iter_mut().zip(quad4::value(r, s)) {
                    *f += weight * n * at(s);
                }
            }
        }
    }
    sum
}

/// Plain Gauss points, those with g > 0 left out.
fn plain(gaps: [f64; 4], rule: gauss::Rule) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for (r, wr) in rule {
        for (s, ws) in rule {
            let shape = quad4::value(*r, *s);
            let g: f64 = (0..4).map(|a| shape[a] * gaps[a]).sum();
            if g < 0.0 {
                for a in 0..4 {
                    sum[a] += wr * ws * g * shape[a];
                }
            }
        }
    }
    sum
}

/// Random bilinear gaps with both signs, against fine quadrature. Errors are fractions of the resultant: mean, 95 %
/// quantile, worst.
fn errors(count: usize, rule: impl Fn([f64; 4]) -> [f64; 4]) -> [f64; 3] {
    let mut seed = 1u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mut found = Vec::new();
    while found.len() < count {
        let gaps = [random(), random(), random(), random()];
        let closed = gaps.iter().filter(|&&g| g < 0.0).count();
        if closed == 0 || closed == 4 {
            continue;
        }
        let (exact, computed) = (fine(gaps), rule(gaps));
        let resultant: f64 = exact.iter().sum::<f64>().abs();
        let error = exact.iter().zip(&computed).map(|(a, b)| (a - b).abs()).sum::<f64>() / resultant;
        found.push(error);
    }
    found.sort_by(f64::total_cmp);
    let mean = found.iter().sum::<f64>() / count as f64;
    [mean, found[count * 95 / 100], found[count - 1]]
}

/// Five points along each smooth piece leave 1e-3 of the resultant in the worst of 600 cases; the strips miss small corners
/// altogether.
#[test]
fn random_gaps() {
    let clip = errors(150, |g| forces(g, Integration::Clipped));
    assert!(clip[0] < 5e-5 && clip[1] < 5e-4 && clip[2] < 5e-3, "{clip:?}");
    let strips = errors(150, |g| forces(g, Integration::Strips));
    assert!(strips[0] < 0.2 && strips[0] > 1000.0 * clip[0], "{strips:?}");
}

/// The table of docs/theory/solid-and-contact.md, 2.1, to its two digits: mean, 95 % and worst of 600 random gaps.
#[test]
fn table_of_integration_rules() {
    let strips = |g: [f64; 4]| forces(g, Integration::Strips);
    let clip = |g: [f64; 4]| forces(g, Integration::Clipped);
    for (name, found, table) in [
        ("2x2", errors(600, |g| plain(g, gauss::TWO)), [0.22, 1.0, 1.0]),
        ("3x3", errors(600, |g| plain(g, gauss::THREE)), [0.10, 0.42, 1.0]),
        ("5x5", errors(600, |g| plain(g, gauss::FIVE)), [0.036, 0.12, 1.0]),
        ("strips", errors(600, strips), [0.11, 0.90, 1.0]),
        ("clip", errors(600, clip), [1.9e-5, 1.5e-4, 1.1e-3]),
    ] {
        for (found, table) in found.into_iter().zip(table) {
            assert!((found / table - 1.0).abs() < 0.05, "{name}: {found} {table}");
        }
    }
}

/// Area and nodal areas of a cylindrical face are those of the cylinder, r dθ dz.
#[test]
fn area_of_a_cylindrical_face() {
    let (radius, angle, height) = (2.0, 0.5, 0.7);
    let face = Face {
        nodes: BOTTOM,
        chart: quad4::CORNERS.map(|[r, s]| [radius, 0.5 * angle * (1.0 + r), 0.5 * height * (1.0 + s)]),
    };
    let normals = face.chart.map(|[_, t, _]| [t.cos(), t.sin(), 0.0]);
    let element = Contact8::new(&face, Chart::Cylindrical, TOP, BOTTOM, normals, ContactLaw::bonded(1.0)).unwrap();
    assert!((element.area() - radius * angle * height).abs() < 1e-14);
    let row: f64 = element.whole()[0].iter().sum();
    assert!((row - 0.25 * radius * angle * height).abs() < 1e-15);
}

/// Slip of the liquid along a circular wall: u_θ = 1 at every node of one facet. With nodal normals it meets no force; with
/// the facet's own normal it meets the penalty: g = ∓ sin(Δ/2) at both ends. Over the node that two facets share, facet
/// normals hold both horizontal components.
#[test]
fn facet_normals_lock_the_slip() {
    let sectors = 16;
    let angle = std::f64::consts::TAU / f64::from(sectors);
    // Two neighbouring facets at θ = −Δ … 0 … Δ, joined on a ring whose outer (top) side is held.
    let facet = |from: f64| Face {
        nodes: BOTTOM,
        chart: quad4::CORNERS.map(|[r, s]| [1.0, from + 0.5 * angle * (1.0 + r), 0.5 * (1.0 + s)]),
    };
    let stiffness = |from: f64, nodal: bool| {
        let face = facet(from);
        let normals = face.chart.map(|[_, t, _]| {
            let t = if nodal { t } else { from + 0.5 * angle };
            [t.cos(), t.sin(), 0.0]
        });
        let element = Contact8::new(&face, Chart::Cylindrical, TOP, BOTTOM, normals, ContactLaw::bonded(1.0)).unwrap();
        (face, reference_stiffness(&element).unwrap())
    };
    let energy = |nodal: bool| -> f64 {
        [-angle, 0.0]
            .map(|from| {
                let (face, k) = stiffness(from, nodal);
                let mut u = [0.0; 24];
                for a in 0..4 {
                    let t = face.chart[a][1];
                    (u[12 + 3 * a], u[13 + 3 * a]) = (-t.sin(), t.cos());
                }
                0.5 * (0..24).map(|i| (0..24).map(|j| u[i] * k.get(i, j) * u[j]).sum::<f64>()).sum::<f64>()
            })
            .iter()
            .sum()
    };
    assert!(energy(true) < 1e-30);
    // ½ ∫ g² dA = ½ sin²(Δ/2) A/3 a facet.
    let exact = (0.5 * angle).sin().powi(2) * angle / 3.0;
    assert!((energy(false) - exact).abs() < 1e-15);

    // Horizontal stiffness of the shared lower node (θ = 0): corner 1 of the first facet, corner 0 of the second.
    let shared = |nodal: bool| {
        let (_, k1) = stiffness(-angle, nodal);
        let (_, k2) = stiffness(0.0, nodal);
        let block = |i: usize, j: usize| k1.get(15 + i, 15 + j) + k2.get(12 + i, 12 + j);
        nalgebra::Matrix2::new(block(0, 0), block(0, 1), block(1, 0), block(1, 1)).symmetric_eigenvalues()
    };
    let (nodal, flat) = (shared(true), shared(false));
    assert!(nodal.min().abs() < 1e-16 * nodal.max().max(1.0));
    // n₁ and n₂ are Δ apart: the weaker direction has tan²(Δ/2) of the stiffness of the stronger.
    assert!((flat.min() / flat.max() - (0.5 * angle).tan().powi(2)).abs() < 1e-12);
}

#[test]
fn bad_joints_are_rejected() {
    let new = |face: &Face, normals, law| Contact8::new(face, Chart::Cartesian, TOP, BOTTOM, normals, law);
    let good = ContactLaw::bonded(1.0);
    assert!(new(&square(), [[0.0, 0.0, 1.1]; 4], good).is_err());
    assert!(new(&square(), UP, ContactLaw::bonded(0.0)).is_err());
    assert!(new(&square(), UP, good.with_tangential(-1.0)).is_err());
    let law = ContactLaw { opening: Opening::Unilateral { residual: 1.0 }, ..good };
    assert!(new(&square(), UP, law).is_err());
    let line = Face { nodes: BOTTOM, chart: [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]] };
    assert!(matches!(new(&line, UP, good), Err(ElementError::Jacobian { .. })));
}
