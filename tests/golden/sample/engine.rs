//! The finite-element part of the sample.

use std::collections::BTreeMap;

use results::*;
use tank::units::Dimension;
use tank::{Liquid, Tank};

use super::G;

pub(super) fn fe_result(
    columns: &[(&str, Vec<f64>)],
    time: &[f64],
    tank: &Tank,
    liquid: &Liquid,
    omega_c: f64,
    omega_i: f64,
) -> Run {
    let (r, h, wall) = (tank.shape.half_length(), liquid.fill_height, tank.wall_height());
    let mass = liquid.mass(tank.shape);
    let label = |label: &str, text: &str| Labelled { label: label.into(), text: text.into() };
    let dimension = |id: &str| match id {
        "ground_acceleration" => Dimension::Acceleration,
        "ground_velocity" => Dimension::Velocity,
        "base_shear" => Dimension::Force,
        "base_moment" => Dimension::Moment,
        "axial_membrane_stress" => Dimension::Stress,
        _ => Dimension::Length,
    };
    let title = |id: &str| match id {
        "wave_height_theta_0" => "Wave height at the wall, θ = 0".to_owned(),
        "axial_membrane_stress" => "Axial membrane stress at the base".to_owned(),
        other => other.replace('_', " "),
    };
    let z: Vec<f64> = (0..=60).map(|i| wall * f64::from(i) / 60.0).collect();
    let envelope =
        |id: &str, title: &str, dimension, fixed: &dyn Fn(f64) -> f64, swing: &dyn Fn(f64) -> f64| Envelope {
            id: id.into(),
            title: title.into(),
            dimension,
            static_: z.iter().map(|z| fixed(*z)).collect(),
            min: z.iter().map(|z| -0.93 * swing(*z)).collect(),
            max: z.iter().map(|z| swing(*z)).collect(),
            z: z.clone(),
        };
    let wet = |z: f64| if z < h { 1.0 - z / h } else { 0.0 };
    let layer = |z: f64| (-z / 0.06).exp() * (z / 0.06).cos();
    let thickness = |z: f64| tank.course_at(z).thickness;
    Run {
        mesh: vec![
            label("liquid elements (r × z)", "6 × 9, quadratic"),
            label("wall elements", "24, cubic w, graded to the base"),
            label("unknowns before condensation", "1 204"),
            label("unknowns of the coupled system", "131"),
        ],
        modes: modes(r, h, wall, mass, omega_c, omega_i),
        integration: vec![
            label("integration", "exact piecewise linear, modal, 40 modes and missing mass"),
            label("damping", "modal: sloshing 0.5 %, structural 2 %"),
            label("time step", "0.01 s"),
        ],
        mesh_error: BTreeMap::from([
            ("base_moment".to_owned(), 0.0007),
            ("sloshing_height".to_owned(), 0.0021),
            ("hoop_stress".to_owned(), 0.0064),
        ]),
        mass_balance: vec![
            Balance { label: "effective masses against liquid and wall".into(), error: 3.1e-10 },
            Balance { label: "base shear of a rigid translation against the mass".into(), error: 4.4e-12 },
        ],
        energy: Some(EnergyBalance { input: 412.0, kinetic: 0.9, elastic: 1.4, damping: 409.6, error: 0.000_24 }),
        envelopes: vec![
            envelope("pressure", "Pressure on the wall", Dimension::Stress, &|z| 1000.0 * G * (h - z).max(0.0), &|z| {
                7.1e3 * wet(z).sqrt()
            }),
            envelope(
                "hoop_stress",
                "Hoop stress",
                Dimension::Stress,
                &|z| 1000.0 * G * (h - z).max(0.0) * r / thickness(z) * (1.0 - layer(z)),
                &|z| 6.2e3 * wet(z).sqrt() * r / thickness(z) * (1.0 - layer(z)),
            ),
            envelope(
                "axial_membrane_stress",
                "Axial membrane stress",
                Dimension::Stress,
                &|z| -2750.0 * G * (wall - z),
                &|z| 1.7e6 * (1.0 - z / wall).powi(2),
            ),
            envelope("bending_stress", "Meridional bending stress", Dimension::Stress, &|z| 9.3e6 * layer(z), &|z| {
                4.1e6 * layer(z).abs()
            }),
            envelope(
                "radial_displacement",
                "Radial displacement",
                Dimension::Length,
                &|z| 2.6e-4 * wet(z) * (1.0 - layer(z)),
                &|z| 1.3e-4 * wet(z).sqrt() * (1.0 - layer(z)),
            ),
        ],
        histories: columns
            .iter()
            .map(|(id, v)| {
                let i = (0..v.len()).fold(0, |b, i| if v[i].abs() > v[b].abs() { i } else { b });
                SeriesInfo {
                    id: (*id).into(),
                    title: title(id),
                    dimension: dimension(id),
                    static_value: if *id == "axial_membrane_stress" { -49_000.0 } else { 0.0 },
                    peak: v[i].abs(),
                    time: time[i],
                }
            })
            .collect(),
        limits: vec![
            Limit {
                id: "wave_against_radius".into(),
                name: "wave height against radius".into(),
                value: 0.137,
                limit: 0.2 * r,
                dimension: Dimension::Length,
                holds: true,
                note: "linear waves are accurate while the height stays below a fifth of the radius".into(),
            },
            Limit {
                id: "suction".into(),
                name: "smallest total pressure".into(),
                value: -180.0,
                limit: 0.0,
                dimension: Dimension::Stress,
                holds: false,
                note: "suction of 0.2 kPa at z = 1.48 m, t = 4.31 s; the liquid separates from the wall".into(),
            },
        ],
        ..Run::new(EngineId::Harmonic)
    }
}

fn modes(r: f64, h: f64, wall: f64, mass: f64, omega_c: f64, omega_i: f64) -> Vec<Mode> {
    let zs: Vec<f64> = (0..=24).map(|i| wall * f64::from(i) / 24.0).collect();
    let rs: Vec<f64> = (0..=24).map(|i| r * f64::from(i) / 24.0).collect();
    let mode = |kind: &str, number: usize, omega: f64, share: f64| {
        let n = number as f64;
        let sloshing = kind == "sloshing";
        let wave = |x: f64| (x * (2.0 * n - 1.0) * std::f64::consts::FRAC_PI_2).sin();
        let bulge = |z: f64| (z / wall * (2.0 * n - 1.0) * std::f64::consts::FRAC_PI_2).sin();
        Mode {
            harmonic: 1,
            axial: None,
            kind: kind.into(),
            number,
            omega,
            period: std::f64::consts::TAU / omega,
            damping: if sloshing { 0.005 } else { 0.02 },
            participation: (share * mass).sqrt(),
            effective_mass: share * mass,
            effective_height: h * if sloshing { 0.6 } else { 0.42 },
            shape: ModeShape {
                wall: zs.iter().map(|z| if sloshing { 0.0 } else { bulge(*z) }).collect(),
                z: zs.clone(),
                surface: rs.iter().map(|x| if sloshing { wave(x / r) } else { 0.06 * wave(x / r) }).collect(),
                r: rs.clone(),
            },
        }
    };
    vec![
        mode("sloshing", 1, omega_c, 0.52),
        mode("sloshing", 2, 1.73 * omega_c, 0.017),
        mode("sloshing", 3, 2.2 * omega_c, 0.004),
        mode("structural", 1, omega_i, 0.41),
        mode("structural", 2, 1.9 * omega_i, 0.04),
    ]
}
