use super::*;
use crate::harmonic::{Places, test_tanks};
use tank::options::LinearOptions as Options;

/// A small turn about an axis below keeps the distances of points on the same body, and a shift is that of all.
#[test]
fn a_rigid_motion_keeps_distances() {
    let small = 1e-6;
    let rigid = Rigid { along: [0.3, -0.2], up: 0.1, turn: [2.0 * small, -3.0 * small], below: 1.5 };
    let points = [[1.0, 2.0, 3.0], [-4.0, 0.5, 7.0], [0.0, 0.0, 0.0]];
    for (p, q) in [(0, 1), (0, 2), (1, 2)] {
        let length = |moved: bool| {
            let at = |i: usize| {
                let u = if moved { rigid.at(points[i]) } else { [0.0; 3] };
                [0, 1, 2].map(|k| points[i][k] + u[k])
            };
            let (a, b) = (at(p), at(q));
            (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
        };
        assert!((length(true) - length(false)).abs() < 1e-9, "{p} {q}");
    }
    let still = Rigid { along: [0.3, -0.2], up: 0.1, ..Rigid::default() };
    assert_eq!(points.map(|p| still.at(p)), [[0.3, -0.2, 0.1]; 3]);
}

/// Rows of the wall under a translation along x, w = 1 and v = −1, are (1, 0, 0) all around.
#[test]
fn a_translation_is_one_all_around() {
    let along = [1.0, -1.0, 0.0];
    let moment = Moment { along: &along, across: None };
    let row = |odd: usize| Amplitude { odd, even: None };
    for k in 0..12 {
        let (s, c) = (std::f64::consts::TAU * f64::from(k) / 12.0).sin_cos();
        let (out, around) = (moment.even(row(0), [c, s]), moment.odd(row(1), [c, s]));
        let found = [out * c - around * s, out * s + around * c];
        assert!((found[0] - 1.0).abs() < 1e-12 && found[1].abs() < 1e-12, "{found:?}");
    }
}

/// In every axisymmetric mode the surface gives way to what the wall takes: ∫ η r dr + R ∫ w dz = 0 over the wetted wall, at θ = 0. Rings are the nodes
/// of quadratic elements, so that Simpson's rule is exact; the wall is straight between drawn levels: 1 % of what moves.
#[test]
fn axisymmetric_modes_keep_the_volume() {
    let case = test_tanks::broad();
    let model = Model::new(&case, &Options::default(), true, Places::Usual).unwrap();
    let mesh = Mesh::of(&case, &model);
    let vertical = model.vertical.as_ref().unwrap();
    let depth = case.liquid.fill_height;
    for mode in vertical.modes.iter().filter(|m| m.number <= 2) {
        let shape = mesh.shape(&vertical.coupled, &mode.vector);
        let front = |wanted: &dyn Fn(&Spot) -> bool| -> Vec<usize> {
            let found = mesh.spots.iter().enumerate().filter(|(_, spot)| wanted(spot));
            found.map(|(node, _)| node).collect()
        };
        let rings = front(&|spot| matches!(spot, Spot::Surface { at, .. } if at[1] == 0.0 && at[0] > 0.0));
        let levels = front(&|spot| matches!(spot, Spot::Wall { at, .. } if at[1] == 0.0 && at[0] > 0.0));
        let moment = |node: usize| shape[node][2] * mesh.nodes[node][0];
        let elements = rings.as_chunks::<2>().0.iter().enumerate().map(|(e, _)| [2 * e, 2 * e + 1, 2 * e + 2]);
        let (mut given, mut surface) = (0.0, 0.0);
        for own in elements.filter(|own| own[2] < rings.len()) {
            let [p, q, r] = own.map(|ring| rings[ring]);
            let length = mesh.nodes[r][0] - mesh.nodes[p][0];
            assert!((mesh.nodes[q][0] - mesh.nodes[p][0] - 0.5 * length).abs() < 1e-9);
            let own = length / 6.0 * (moment(p) + 4.0 * moment(q) + moment(r));
            (given, surface) = (given + own, surface + own.abs());
        }
        let (mut taken, mut wall) = (0.0, 0.0);
        for pair in levels.windows(2).filter(|pair| mesh.nodes[pair[1]][2] <= depth * (1.0 + 1e-9)) {
            let [low, high] = [pair[0], pair[1]];
            let length = mesh.nodes[high][2] - mesh.nodes[low][2];
            let own = mesh.nodes[low][0] * length * 0.5 * (shape[low][0] + shape[high][0]);
            (taken, wall) = (taken + own, wall + own.abs());
        }
        let at = format!("{:?} {}: {taken} {given} of {wall} {surface}", mode.kind, mode.number);
        assert!((taken + given).abs() < 0.01 * (wall + surface), "{at}");
        // Both parts matter in a mode of the wall.
        assert!(mode.kind == Kind::Sloshing || wall > 0.1 * surface, "{at}");
    }
}
