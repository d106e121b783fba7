//! The three-dimensional part of the sample: a mesh of wall and free surface with made-up shapes on it.

use std::f64::consts::{PI, TAU};

use results::*;
use tank::units::Dimension;
use tank::{Liquid, Tank};

const SECTORS: usize = 24;
const LEVELS: usize = 16;
const RINGS: usize = 8;

/// Fields over a round tank.
pub(super) fn fields(tank: &Tank, liquid: &Liquid) -> Fields {
    let (radius, height, depth) = (tank.shape.half_length(), tank.wall_height(), liquid.fill_height);
    let angle = |i: usize| TAU * i as f64 / SECTORS as f64;
    let on = |r: f64, i: usize, z: f64| [r * angle(i).cos(), r * angle(i).sin(), z];
    let mut nodes = Vec::new();
    for j in 0..=LEVELS {
        nodes.extend((0..SECTORS).map(|i| on(radius, i, height * j as f64 / LEVELS as f64)));
    }
    let first = nodes.len();
    nodes.push([0.0, 0.0, depth]);
    for k in 1..=RINGS {
        nodes.extend((0..SECTORS).map(|i| on(radius * k as f64 / RINGS as f64, i, depth)));
    }
    let wall_node = |i: usize, j: usize| j * SECTORS + i % SECTORS;
    let ring_node = |i: usize, k: usize| {
        if k == 0 { first } else { first + 1 + (k - 1) * SECTORS + i % SECTORS }
    };
    let wall = (0..LEVELS)
        .flat_map(|j| {
            (0..SECTORS)
                .map(move |i| [wall_node(i, j), wall_node(i + 1, j), wall_node(i + 1, j + 1), wall_node(i, j + 1)])
        })
        .collect();
    let surface = (0..RINGS)
        .flat_map(|k| {
            (0..SECTORS)
                .map(move |i| [ring_node(i, k), ring_node(i, k + 1), ring_node(i + 1, k + 1), ring_node(i + 1, k)])
        })
        .collect();
    // Radial motion of the wall, rise of the surface.
    let shape = |bulge: &dyn Fn(f64, f64) -> f64, rise: &dyn Fn(f64, f64) -> f64| -> Vec<[f64; 3]> {
        let moved = |(i, p): (usize, &[f64; 3])| {
            let (r, theta) = (p[0].hypot(p[1]), p[1].atan2(p[0]));
            if i < first {
                let w = bulge(theta, p[2] / height);
                [w * theta.cos(), w * theta.sin(), 0.0]
            } else {
                [0.0, 0.0, rise(theta, r / radius)]
            }
        };
        nodes.iter().enumerate().map(moved).collect()
    };
    let still = |_: f64, _: f64| 0.0;
    let picture = |title: &str, omega: f64, n: u32, displacement| Picture {
        title: title.into(),
        omega,
        circumferential: n,
        displacement,
    };
    let bulge = |t: f64, z: f64| t.cos() * (0.5 * PI * z).sin();
    let shell = |t: f64, z: f64| (5.0 * t).cos() * (0.5 * PI * z).sin();
    let wave = |t: f64, r: f64| t.cos() * (1.8412 * r).sin();
    let small_wave = |t: f64, r: f64| 0.137 * wave(t, r);
    let small_bulge = |t: f64, z: f64| 1.3e-4 * bulge(t, z) * (1.0 - 0.4 * z);
    let moment = |title: &str, time: f64, sign: f64| DeformedShape {
        title: title.into(),
        time,
        displacement: shape(&|t, z| sign * small_bulge(t, z), &|t, r| sign * small_wave(t, r)),
    };
    let theta: Vec<f64> = (0..SECTORS).map(angle).collect();
    let z: Vec<f64> = (0..=LEVELS).map(|j| height * j as f64 / LEVELS as f64).collect();
    let map = |id: &str, title: &str, time: f64, size: f64| WallMap {
        id: id.into(),
        title: title.into(),
        time: Some(time),
        dimension: Dimension::Stress,
        values: theta
            .iter()
            .flat_map(|t| z.iter().map(|z| size * t.cos() * (1.0 - (z / depth).min(1.0).powi(2)).sqrt()))
            .collect(),
        theta: theta.clone(),
        z: z.clone(),
    };
    Fields {
        modes: vec![
            picture("sloshing mode 1, n = 1", 2.996, 1, shape(&still, &wave)),
            picture("bulging mode 1, n = 1, m = 1", 202.0, 1, shape(&bulge, &|t, r| 0.06 * wave(t, r))),
            picture("shell mode, n = 5, m = 1", 61.0, 5, shape(&shell, &still)),
        ],
        moments: vec![moment("largest base moment", 4.31, 1.0), moment("largest wave at the wall", 11.02, -1.0)],
        maps: vec![
            map("pressure", "Pressure on the wall at the largest base moment", 4.31, 7.1e3),
            map("hoop_stress", "Hoop stress at the largest base moment", 4.31, 9.4e6),
        ],
        nodes,
        wall,
        surface,
    }
}
