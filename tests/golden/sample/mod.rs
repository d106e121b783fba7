//! A results folder to render: the broad tank of Manos and Clough with plausible numbers, made without the pipeline.
//!
//! Frequencies, masses and levers follow Housner's formulas; the motion is a sum of sines under an envelope, and each
//! history is a single oscillator under that motion. Numbers are of the right size; no test asserts their values.

use results::*;
use tank::Quantity;
use tank::{Course, Liquid, Material, Roof, Shape, Support, Tank};

mod engine;
mod fields;
mod methods;
mod nonlinear;

use engine::fe_result;
use methods::{comparison, methods};

const G: f64 = 9.806_65;
const DT: f64 = 0.01;
const STEPS: usize = 2500;

/// Variant of the sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// `compare`: everything.
    Compare,
    /// `check`: no engine, no record.
    Check,
    /// `compare` of a rectangular concrete strip.
    Rectangle,
    /// `compare --fe both`.
    Both,
    /// `compare --fe solid`.
    Solid,
    /// `compare --fe nonlinear`.
    Nonlinear,
}

/// Results and series of this kind, with this title.
pub(crate) fn sample(kind: Kind, name: &str) -> (Results, Series) {
    let tank = tank(kind);
    let liquid =
        Liquid { density: 1000.0, fill_height: if kind == Kind::Rectangle { 4.0 } else { 1.525 }, bulk_modulus: None };
    let half = tank.shape.half_length();
    let acceleration = motion();
    let k = 1.8412 / half;
    let omega_c = (G * k * (k * liquid.fill_height).tanh()).sqrt();
    let omega_i = 2.0 * std::f64::consts::PI / 0.031;
    let slosh = oscillator(omega_c, 0.005, &acceleration);
    let impulsive = oscillator(omega_i, 0.02, &acceleration);
    let mass = liquid.mass(tank.shape);
    let with_fe = kind != Kind::Check;

    let wave: Vec<f64> = slosh.0.iter().map(|u| 0.837 * omega_c * omega_c * u * half / G).collect();
    let shear: Vec<f64> = impulsive
        .1
        .iter()
        .zip(&slosh.0)
        .map(|(a, u)| -(0.45 * mass * a - 0.5 * mass * omega_c * omega_c * u))
        .collect();
    let moment: Vec<f64> = shear.iter().map(|v| 0.42 * liquid.fill_height * v).collect();
    let axial: Vec<f64> =
        moment.iter().map(|m| m / (std::f64::consts::PI * half * half * tank.courses[0].thickness)).collect();
    let peak = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let values = [
        (Quantity::SloshingPeriod, std::f64::consts::TAU / omega_c),
        (Quantity::SloshingHeight, peak(&wave)),
        (Quantity::ImpulsivePeriod, std::f64::consts::TAU / omega_i),
        (Quantity::ImpulsiveMass, 0.46 * mass),
        (Quantity::ConvectiveMass, 0.52 * mass),
        (Quantity::BaseShear, peak(&shear)),
        (Quantity::BaseMoment, peak(&moment)),
        (Quantity::OverturningMoment, 2.1 * peak(&moment)),
        (Quantity::HoopStress, 14.2e6),
        (Quantity::AxialMembraneStress, peak(&axial)),
        (Quantity::BendingStress, 6.1e6),
    ];
    let methods = methods(kind, &tank, &liquid, &values, with_fe);
    let (fe, series) = if with_fe {
        let columns = vec![
            ("ground_acceleration", acceleration.clone()),
            ("ground_velocity", integrate(&acceleration)),
            ("ground_displacement", integrate(&integrate(&acceleration))),
            ("wave_height_theta_0", wave),
            ("base_shear", shear),
            ("base_moment", moment),
            ("axial_membrane_stress", axial),
        ];
        let time: Vec<f64> = (0..STEPS).map(|i| i as f64 * DT).collect();
        let fe = fe_result(&columns, &time, &tank, &liquid, omega_c, omega_i);
        let series = Series {
            time,
            ids: columns.iter().map(|c| c.0.to_owned()).collect(),
            columns: columns.into_iter().map(|c| c.1).collect(),
        };
        (Some(fe), series)
    } else {
        (None, Series::default())
    };
    let (mut methods, mut series) = (methods, series);
    let mut runs: Vec<Run> = fe.into_iter().collect();
    if let (Kind::Nonlinear, Some(engine)) = (kind, runs.first()) {
        let run = nonlinear::add(engine, &mut methods, &mut series, &tank, &liquid);
        runs.push(run);
    }
    if let (Kind::Both | Kind::Solid, Some(engine)) = (kind, runs.first_mut()) {
        let mut spatial = engine.clone();
        spatial.engine = EngineId::Solid;
        spatial.fields = Some(fields::fields(&tank, &liquid));
        if kind == Kind::Solid {
            *engine = spatial;
        } else {
            // The second engine: everything two percent larger.
            let at = methods.iter().position(|m| m.id == "fe").expect("the sample has an engine");
            let mut method = methods[at].clone();
            method.id = EngineId::Solid.beside().into();
            method.label = EngineId::Solid.label(1).into();
            method.figure_key = EngineId::Solid.figure_key(1).into();
            method.quantities.values_mut().for_each(|v| v.value *= 1.02);
            methods.insert(at + 1, method);
            for i in 0..series.ids.len() {
                series.ids.push(format!("{}{}", EngineId::Solid.prefix(), series.ids[i]));
                series.columns.push(series.columns[i].iter().map(|v| 1.02 * v).collect());
            }
            runs.push(spatial);
        }
    }
    let deciding = |m: &Method| Deciding { method: m.id.clone(), excitation: m.excitation };
    let deciding = methods.iter().filter(|m| !m.checks.is_empty()).map(deciding).collect();
    let verdict = results::verdict(&methods, deciding, false, None);
    let results = Results {
        format: FORMAT.into(),
        volatile: Volatile {
            version: "0.1.0".into(),
            created: "2026-11-20T10:31:07Z".into(),
            command:
                "tankcheck compare examples/01_broad_tank/tank.json --quake examples/records/elcentro.csv --out out/"
                    .into(),
            seconds: 0.31,
        },
        name: name.into(),
        project: Some(project()),
        parts: Vec::new(),
        record_set: None,
        not_computed: Vec::new(),
        files: vec![
            SourceFile {
                role: "tank".into(),
                name: "tank.json".into(),
                sha256: "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08".into(),
            },
            SourceFile {
                role: "record".into(),
                name: "elcentro.csv".into(),
                sha256: "60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752".into(),
            },
        ],
        input: input(),
        tank: TankSummary {
            wall_mass: tank.wall_mass(),
            liquid_mass: mass,
            gravity: G,
            deformability: Some(Deformability {
                as_printed: 0.0304,
                corrected: 27.4,
                note: "As printed a thicker wall raises the parameter and with it the failure probability; the \
                       reciprocal thickness ratio removes the contradiction."
                    .into(),
            }),
            tank,
            liquid,
        },
        records: if with_fe { vec![record(&acceleration)] } else { Vec::new() },
        spectra: if with_fe { spectra(&acceleration) } else { Vec::new() },
        comparison: comparison(&methods, with_fe),
        methods,
        runs,
        verdict,
        warnings: Vec::new(),
    };
    (results, series)
}

/// Writes a sample into a folder.
pub(crate) fn write(folder: &std::path::Path, kind: Kind, name: &str) {
    let (results, series) = sample(kind, name);
    results::write(folder, &results, &series).expect("a temporary folder can be written");
}

fn tank(kind: Kind) -> Tank {
    let material = |name: &str, e: f64, nu: f64, rho: f64, f: f64| Material {
        family: tank::Family::inferred(e, rho),
        name: name.into(),
        youngs_modulus: e,
        poisson_ratio: nu,
        density: rho,
        yield_strength: Some(f),
        allowable_stress: None,
        behaviour: Default::default(),
        volume_change: Default::default(),
    };
    let aluminium = material("aluminium", 69e9, 0.32, 2750.0, 110e6);
    let concrete = material("concrete", 30e9, 0.2, 2500.0, 20e6);
    let course = |height, thickness, material: &Material| Course {
        height,
        thickness,
        corrosion: 0.0,
        material: material.clone(),
        layers: Vec::new(),
    };
    let (shape, courses) = if kind == Kind::Rectangle {
        let shape = Shape::Rectangle { length: 10.0, breadth: 1.0, strip: true };
        (shape, vec![course(4.8, 0.4, &concrete)])
    } else {
        let courses = vec![course(0.915, 0.002_03, &aluminium), course(0.915, 0.001_27, &aluminium)];
        (Shape::Cylinder { radius: 1.83 }, courses)
    };
    Tank {
        details: tank::Details::default(),
        shape,
        support: Support::Anchored,
        courses,
        roof: Roof { mass: if kind == Kind::Rectangle { 0.0 } else { 35.0 }, height: None, ..Roof::default() },
        bottom: None,
        wall_base: tank::WallBase::Fixed,
        foundation: None,
        isolators: None,
        staging: None,
        rings: Vec::new(),
        attachments: Vec::new(),
        subsoil: tank::Subsoil::default(),
        insulation: None,
        anchors: None,
        pressure: Default::default(),
        pipes: None,
    }
}

fn motion() -> Vec<f64> {
    let sines = [
        (0.31, 0.4, 0.3),
        (0.8, 0.7, 1.1),
        (1.7, 1.0, 2.3),
        (2.9, 0.9, 0.7),
        (4.3, 0.8, 4.1),
        (7.7, 0.5, 5.0),
        (11.3, 0.3, 0.2),
    ];
    let raw: Vec<f64> = (0..STEPS)
        .map(|i| {
            let t = i as f64 * DT;
            let envelope = (t / 2.0).min(1.0).powi(2) * (-0.16 * (t - 3.0).max(0.0)).exp();
            let sum: f64 =
                sines.iter().map(|(f, a, p)| a * (std::f64::consts::TAU * f * t + p + 0.4 * t.sin()).sin()).sum();
            envelope * sum
        })
        .collect();
    let peak = raw.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    raw.iter().map(|v| v / peak * 0.5 * G).collect()
}

fn integrate(v: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut out: Vec<f64> = vec![0.0];
    for w in v.windows(2) {
        sum += 0.5 * (w[0] + w[1]) * DT;
        out.push(sum);
    }
    let end = out[out.len() - 1] / (out.len() - 1) as f64;
    out.iter().enumerate().map(|(i, u)| u - end * i as f64).collect()
}

/// Relative displacement and absolute acceleration of an oscillator (average acceleration).
fn oscillator(omega: f64, damping: f64, ground: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut u, mut v, mut a) = (0.0, 0.0, -ground[0]);
    let (mut us, mut total) = (vec![0.0], vec![0.0]);
    let h = DT;
    for g in &ground[1..] {
        let rhs = -g - 2.0 * damping * omega * (v + h / 2.0 * a) - omega * omega * (u + h * v + h * h / 4.0 * a);
        let next = rhs / (1.0 + damping * omega * h + omega * omega * h * h / 4.0);
        u += h * v + h * h / 4.0 * (a + next);
        v += h / 2.0 * (a + next);
        a = next;
        us.push(u);
        total.push(a + g);
    }
    (us, total)
}

fn record(acceleration: &[f64]) -> RecordSummary {
    let peak = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let velocity = integrate(acceleration);
    RecordSummary {
        direction: "horizontal".into(),
        name: "elcentro".into(),
        processing: vec!["scaled to 0.5 g (factor 1.4368)".into(), "time axis multiplied by 0.57735".into()],
        dt: DT,
        samples: STEPS,
        pga_as_recorded: 0.348 * G,
        pga: peak(acceleration),
        pgv: peak(&velocity),
        pgd: peak(&integrate(&velocity)),
        arias: std::f64::consts::PI / (2.0 * G) * acceleration.iter().map(|a| a * a * DT).sum::<f64>(),
        cav: acceleration.iter().map(|a| a.abs() * DT).sum(),
        significant_duration: 11.3,
        usable_period: None,
        sloshing_beyond_usable: false,
    }
}

fn spectra(acceleration: &[f64]) -> Vec<SpectrumCurve> {
    let period: Vec<f64> = (0..120).map(|i| 0.02 * 1000f64.powf(f64::from(i) / 119.0)).collect();
    let curve = |id: &str, title: &str, damping: f64, psa: Vec<f64>| {
        let omega = |t: &f64| std::f64::consts::TAU / t;
        SpectrumCurve {
            id: id.into(),
            title: title.into(),
            damping,
            sd: period.iter().zip(&psa).map(|(t, a)| a / omega(t).powi(2)).collect(),
            psv: period.iter().zip(&psa).map(|(t, a)| a / omega(t)).collect(),
            psa,
            period: period.clone(),
        }
    };
    let response = |damping: f64| -> Vec<f64> {
        period
            .iter()
            .map(|t| {
                let omega = std::f64::consts::TAU / t;
                let (u, _) = oscillator(omega, damping, acceleration);
                omega * omega * u.iter().fold(0.0_f64, |m, x| m.max(x.abs()))
            })
            .collect()
    };
    let design: Vec<f64> = period
        .iter()
        .map(|&t| {
            let ag = 0.25 * G;
            match t {
                t if t < 0.15 => ag * (1.0 + t / 0.15 * 1.5),
                t if t < 0.4 => ag * 2.5,
                t if t < 2.0 => ag * 2.5 * 0.4 / t,
                t => ag * 2.5 * 0.8 / (t * t),
            }
        })
        .collect();
    vec![
        curve("record-horizontal-0.005", "record, 0.5 %", 0.005, response(0.005)),
        curve("record-horizontal-0.02", "record, 2 %", 0.02, response(0.02)),
        curve("ec8-site-0.05", "EN 1998-1 design, ground A, 5 %", 0.05, design),
    ]
}

fn input() -> Vec<InputValue> {
    let given = |path: &str, text: &str| InputValue {
        path: path.into(),
        text: text.into(),
        default: false,
        source: String::new(),
    };
    let default = |path: &str, text: &str, source: &str| InputValue {
        path: path.into(),
        text: text.into(),
        default: true,
        source: source.into(),
    };
    vec![
        given("name", "Broad tank of Manos and Clough, 1982"),
        given("tank.shape", "cylinder"),
        given("tank.radius", "1.83 m"),
        given("tank.support", "anchored"),
        given("tank.courses[0].height", "0.915 m"),
        given("tank.courses[0].thickness", "2.03 mm"),
        given("tank.courses[0].material", "aluminium"),
        given("tank.courses[1].height", "0.915 m"),
        given("tank.courses[1].thickness", "1.27 mm"),
        given("tank.courses[1].material", "aluminium"),
        given("tank.roof.mass", "35 kg"),
        given("liquid.density", "1000 kg/m3"),
        given("liquid.fill_height", "1.525 m"),
        default("gravity", "9.80665 m/s2", "standard acceleration of free fall"),
        given("record.scale_to", "0.5 g"),
        given("record.time_factor", "0.57735"),
        default("damping.sloshing", "0.005", "EN 1998-4:2006 2.3.3.2 (liquids other than viscous)"),
        default("damping.impulsive", "0.02", "EN 1998-4:2006 2.3.3.1 (damage limitation)"),
    ]
}

/// A cover in which nothing is missing but the approver.
fn project() -> tank::Project {
    let text = |text: &str| Some(text.to_owned());
    tank::Project {
        name: text("Shaking table"),
        client: text("Harbour Storage Ltd"),
        document: text("TK-104-SV-001"),
        revision: text("B"),
        date: text("2026-03-14"),
        author: text("J. Doe"),
        checker: text("A. Smith"),
        approver: None,
        ..tank::Project::default()
    }
}
