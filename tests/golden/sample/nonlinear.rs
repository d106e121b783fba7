//! The nonlinear part of the sample: half a wall with made-up cracks, maps, loops and energies.

use std::f64::consts::PI;

use results::nonlinear::*;
use results::*;
use tank::units::Dimension;
use tank::{Liquid, Tank};

/// Sectors of the half, and rows.
const SECTORS: usize = 40;
const ROWS: usize = 20;

/// Adds method and series of the second engine: forces a fifth smaller because of yielding.
pub(super) fn add(linear: &Run, methods: &mut Vec<Method>, series: &mut Series, tank: &Tank, liquid: &Liquid) -> Run {
    let at = methods.iter().position(|m| m.id == "fe").expect("the sample has an engine");
    let mut method = methods[at].clone();
    method.id = EngineId::Nonlinear.beside().into();
    method.label = EngineId::Nonlinear.label(1).into();
    method.figure_key = EngineId::Nonlinear.figure_key(1).into();
    method.title = "Finite elements, nonlinear, time history".into();
    method.label = EngineId::Nonlinear.label(1).into();
    method.figure_key = EngineId::Nonlinear.figure_key(1).into();
    for (id, value) in &mut method.quantities {
        let factor = match id.as_str() {
            "base_shear" | "base_moment" | "overturning_moment" | "axial_membrane_stress" => 0.81,
            "hoop_stress" | "bending_stress" => 0.9,
            _ => 1.0,
        };
        value.value *= factor;
    }
    methods.insert(at + 1, method);
    let softened = |t: f64| if t > 4.0 { 0.7 } else { 1.0 };
    for i in 0..series.ids.len() {
        series.ids.push(format!("{}{}", EngineId::Nonlinear.prefix(), series.ids[i]));
        let column = series.time.iter().zip(&series.columns[i]);
        series.columns.push(column.map(|(t, v)| softened(*t) * v).collect());
    }
    let mut largest = 0.0_f64;
    let shear = series.ids.iter().position(|id| id == "base_shear").expect("a shear");
    let width: Vec<f64> = series.columns[shear]
        .iter()
        .map(|v| {
            largest = largest.max(v.abs());
            1e-8 * largest
        })
        .collect();
    let info = SeriesInfo {
        id: "largest_crack".into(),
        title: "Largest crack".into(),
        dimension: Dimension::Length,
        static_value: 0.0,
        peak: largest * 1e-8,
        time: 5.1,
    };
    series.ids.push(format!("{}{}", EngineId::Nonlinear.prefix(), info.id));
    series.columns.push(width);
    let mut fe = linear.clone();
    fe.engine = EngineId::Nonlinear;
    fe.histories.push(info);
    for envelope in &mut fe.envelopes {
        for v in envelope.min.iter_mut().chain(&mut envelope.max) {
            *v *= 0.85;
        }
    }
    fe.nonlinear = Some(run(tank, liquid, &series.time));
    fe.events = events();
    fe
}

fn events() -> Vec<Event> {
    let event = |kind: EventKind, title: &str, time: f64, place: &str, note: &str| Event {
        kind,
        title: title.into(),
        time,
        place: place.into(),
        note: note.into(),
    };
    vec![
        event(EventKind::FirstCrack, "first crack", 0.0, "base, inner face", ""),
        event(
            EventKind::LowPressure,
            "separation",
            2.31,
            "θ = 180°, z = 1.50 m",
            "Pressure of the displaced particle falls below zero.",
        ),
        event(EventKind::FirstYield, "first yield", 3.94, "θ = 4.5°, z = 0.02 m, outer face", ""),
        event(EventKind::FirstBarYield, "first yield of a bar", 4.02, "θ = 0°, base", ""),
    ]
}

fn run(tank: &Tank, liquid: &Liquid, time: &[f64]) -> Nonlinear {
    let height = tank.wall_height();
    let grid = WallGrid {
        columns: Columns::Sectors {
            radius: tank.shape.half_length(),
            edges: (0..=SECTORS).map(|i| PI * i as f64 / SECTORS as f64).collect(),
            mirrored: true,
        },
        // Graded to the base.
        z: (0..=ROWS).map(|j| height * (j as f64 / ROWS as f64).powf(1.3)).collect(),
        surface: liquid.fill_height,
    };
    let place = |cell: usize| {
        let theta = PI * ((cell % SECTORS) as f64 + 0.5) / SECTORS as f64;
        (theta, 0.5 * (grid.z[cell / SECTORS] + grid.z[cell / SECTORS + 1]) / height)
    };
    let bend = |theta: f64, z: f64| (1.0 - 1.2 * z).max(0.0) * theta.cos().abs().powf(1.5);
    let cells = |value: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
        (0..SECTORS * ROWS)
            .map(|cell| {
                let (theta, z) = place(cell);
                value(theta, z)
            })
            .collect()
    };
    let map = |id: &str, title: &str, dimension, mark, values| CellMap {
        id: id.into(),
        title: title.into(),
        dimension,
        values,
        mark,
        note: "Largest over time and thickness.".into(),
    };
    let picture = |title: &str, face: &str, time: f64, size: f64, side: f64| {
        let mut cracks = Vec::new();
        for cell in 0..SECTORS * ROWS {
            let (theta, z) = place(cell);
            let (bent, hoop) = (bend(theta, z), (1.0 - (z - 0.3).abs() * 2.0) * theta.cos() * side);
            if size * bent > 0.35 {
                cracks.push(Crack {
                    cell,
                    angle: 0.6 * theta.sin() * z,
                    width: if hoop < -0.6 { 0.0 } else { 1.1e-3 * (size * bent - 0.35) },
                    largest: 1.4e-3 * (size * bent - 0.35),
                });
            }
            if size * hoop > 0.5 {
                cracks.push(Crack {
                    cell,
                    angle: 0.5 * PI + 0.3 * theta,
                    width: 2e-4 * size * hoop,
                    largest: 2e-4 * size * hoop,
                });
            }
        }
        CrackPicture { title: title.into(), face: face.into(), time, cracks }
    };
    let rate = |t: f64| (-(t - 5.0).powi(2) / 4.0).exp();
    let mut done = 0.0;
    let dissipated: Vec<f64> = time
        .iter()
        .map(|t| {
            done += rate(*t);
            done
        })
        .collect();
    let of = |factor: f64| -> Vec<f64> { dissipated.iter().map(|d| factor * d).collect() };
    let swing = |t: f64| 180.0 * rate(t) * (30.0 * t).sin().powi(2);
    let with = |factor: f64, part: f64| -> Vec<f64> {
        time.iter().zip(&dissipated).map(|(t, d)| factor * d + part * swing(*t)).collect()
    };
    let amplitude = |t: f64| 1.8e-2 * (t / 5.0).min(1.0) * (-0.1 * (t - 5.0).max(0.0)).exp();
    let count = |label: &str, value: f64, dimension| Count { label: label.into(), value, dimension };
    Nonlinear {
        maps: vec![
            map(
                "plastic_strain",
                "Plastic strain, outer face",
                Dimension::Dimensionless,
                None,
                cells(&|t, z| 2.4e-3 * (bend(t, z) - 0.6).max(0.0)),
            ),
            map(
                "utilisation",
                "Utilisation, σ_v / f_y",
                Dimension::Dimensionless,
                Some(1.0),
                cells(&|t, z| 1.15 * bend(t, z).sqrt() + 0.03),
            ),
            map(
                "bar_stress",
                "Stress of the vertical bars",
                Dimension::Stress,
                Some(5e8),
                cells(&|t, z| 4.2e8 * bend(t, z) - 2e7),
            ),
            map("separation", "Separation", Dimension::Length, None, cells(&|_, _| 0.0)),
        ],
        cracks: vec![
            picture("first yield", "inner face", 3.94, 0.6, 1.0),
            picture("largest base moment", "inner face", 4.31, 1.0, 1.0),
            picture("largest base moment", "outer face", 4.31, 0.8, -1.0),
            picture("at rest", "outer face", 0.0, 0.1, -1.0),
        ],
        loops: vec![
            Loop {
                id: "moment_curvature_theta_0".into(),
                title: "Moment over curvature at the base, θ = 0°".into(),
                x: LoopAxis { title: "curvature".into(), dimension: Dimension::Curvature },
                y: LoopAxis { title: "moment".into(), dimension: Dimension::LineMoment },
                points: time
                    .iter()
                    .map(|t| {
                        let k = amplitude(*t) * (6.0 * t).sin();
                        [k, 9e4 * (60.0 * (k - 2.5e-3 * (6.0 * t).cos())).tanh()]
                    })
                    .collect(),
            },
            Loop {
                id: "shear_displacement".into(),
                title: "Base shear over displacement of the top".into(),
                x: LoopAxis { title: "displacement".into(), dimension: Dimension::Length },
                y: LoopAxis { title: "base shear".into(), dimension: Dimension::Force },
                points: time
                    .iter()
                    .map(|t| [0.2 * amplitude(*t) * (6.0 * t).sin(), 3e6 * amplitude(*t) * (6.0 * t + 0.3).sin()])
                    .collect(),
            },
            Loop {
                id: "still".into(),
                title: "Nothing moves".into(),
                x: LoopAxis { title: "curvature".into(), dimension: Dimension::Curvature },
                y: LoopAxis { title: "moment".into(), dimension: Dimension::LineMoment },
                points: vec![[0.0, 0.0]; 5],
            },
        ],
        energies: Energies {
            time: time.to_vec(),
            input: with(2.0, 1.0),
            kinetic: with(0.0, 0.6),
            internal: with(1.2, 0.4),
            damping: of(0.79),
            numerical: of(0.01),
            hysteretic: of(1.2),
            error: 2.3e-5,
        },
        moments: Vec::new(),
        departures: Vec::new(),
        extremes: Vec::new(),
        cost: vec![
            count("time steps", 5211.0, Dimension::Dimensionless),
            count("halved steps", 17.0, Dimension::Dimensionless),
            count("iterations", 14_873.0, Dimension::Dimensionless),
            count("largest time step", 0.005, Dimension::Time),
            count("iterations a step", 2.854, Dimension::Dimensionless),
        ],
        grid,
    }
}
