//! The whole way: a tank file and, after a zero byte, a record → procedures and linear engine on a coarse mesh → results →
//! report, in memory.
//!
//! Every number is finite. The same tank written otherwise gives the same numbers; the record in g those in m/s²; twice the
//! record twice the linear response.

use std::path::Path;

use ::results::{EngineId, Method, Results};
use ::tank::assessment::Excitation;
use ::tank::case::GroundMotion;
use fem::progress::Silent;
use oscillator::record::Record;
use report;
use tankcheck::input::TankFile;
use tankcheck::input::records::{ReadOptions, process};
use tankcheck::job::Job;
use tankcheck::pipeline::{self, Outcome};

use super::document::Json;
use super::{record, results, tank};

/// Largest number of samples of a record here; longer ones do not reach other code.
const SAMPLES: usize = 200;
/// Most steps of a response, free sloshing at its end included.
const STEPS: f64 = 4000.0;

/// Runs the target on one input.
pub fn run(bytes: &[u8]) {
    let middle = bytes.iter().position(|b| *b == 0).unwrap_or(bytes.len());
    let text = String::from_utf8_lossy(&bytes[..middle]);
    let quake = bytes.get(middle + 1..).unwrap_or_default();
    let Some(file) = tank::read(&text) else { return };
    let Some(quake) = record::read(quake, &ReadOptions::default()).map(|r| r.record) else { return };
    if !small(&file, &quake) {
        return;
    }
    let Some(found) = compute(file, &quake) else { return };
    whole(&found);
    // One further computation an input, which one the input decides.
    let document = Json::parse(&text).expect("the reader accepts only JSON with comments");
    match bytes.len() % 5 {
        0 => {
            let grams = record::columns_of(&quake, "g", ::tank::STANDARD_GRAVITY, ",", false);
            let other = record::read(grams.as_bytes(), &ReadOptions::default());
            let other = other.and_then(|r| compute(tank::read(&text)?, &r.record));
            if let Some(other) = other {
                close("record in g", &found.results, &other.results, 1e-6, |_| 1.0);
            }
        }
        1 => {
            let double = Record { acceleration: quake.acceleration.iter().map(|a| 2.0 * a).collect(), ..quake.clone() };
            let file = tank::read(&text).filter(|f| f.record.scale_to.is_none());
            if let Some(other) = file.and_then(|f| compute(f, &double)) {
                let linear = ["base_shear", "base_moment", "sloshing_height"];
                let factor = |id: &str| if linear.contains(&id) { 2.0 } else { f64::NAN };
                let fe = |r: &Results| {
                    r.methods
                        .iter()
                        .filter(|m| m.id == "fe" && m.excitation == Excitation::Record)
                        .cloned()
                        .collect::<Vec<Method>>()
                };
                methods("twice the record", &fe(&found.results), &fe(&other.results), 1e-9, factor);
            }
        }
        n => {
            let (how, other) = &tank::variants(&document)[n - 2];
            let other = tank::read(&other.print()).and_then(|f| compute(f, &quake));
            let other = other.unwrap_or_else(|| panic!("{how}: not computed"));
            close(how, &found.results, &other.results, 1e-12, |_| 1.0);
        }
    }
}

/// Whether the computation takes little time on a coarse mesh.
fn small(file: &TankFile, quake: &Record) -> bool {
    let size = file.case.tank.wall_height().max(file.case.tank.shape.half_length());
    let slowest = (size / file.case.gravity).sqrt();
    let dt = quake.dt * file.record.time_factor.unwrap_or(1.0);
    let dt = file.record.resample.unwrap_or(dt);
    quake.acceleration.len() <= SAMPLES
        && quake.duration() / quake.dt.min(dt) < STEPS
        && slowest * 50.0 / dt < STEPS
        && file.fe.gauges.len() + file.fe.stations.len() < 5
        && file.case.tank.courses.len() < 6
}

/// Computes a case on the coarsest mesh; `None` if it is refused or cannot be computed, with a message.
fn compute(file: TankFile, quake: &Record) -> Option<Outcome> {
    let refused = |error: &dyn std::fmt::Display| assert!(!error.to_string().trim().is_empty(), "no message");
    let horizontal = process(quake, &file.record).map_err(|e| refused(&e)).ok()?;
    let mut case = file.case;
    case.ground_motion = Some(GroundMotion { horizontal, transverse: None, vertical: None });
    let procedures = pipeline::procedures::select_procedures(&file.procedures, &file.decision.decide, &case.site)
        .map_err(|e| refused(&e))
        .ok()?;
    let mut fe = file.fe;
    fe.refine = 0.25;
    fe.mesh_error = false;
    let job = Job {
        project: None,
        case,
        procedures,
        decision: file.decision,
        engines: vec![EngineId::Harmonic],
        linear: fe,
        solid: file.solid,
        nonlinear: file.nonlinear,
        checkpoint: None,
        without: Vec::new(),
        echo: file.echo,
        files: Vec::new(),
        warnings: file.warnings,
        raw_records: vec![quake.clone()],
        usable_periods: Vec::new(),
    };
    pipeline::run(&job, &Silent).map_err(|e| refused(&e)).ok()
}

/// Results that can be written, read back and shown.
fn whole(found: &Outcome) {
    // Numbers that are not finite become `null`, which the reader rejects.
    let text = serde_json::to_string(&found.results).expect("results are JSON");
    let again: Results = serde_json::from_str(&text).unwrap_or_else(|e| panic!("not read back: {e}\n{text}"));
    assert_eq!(again, found.results, "other results are read back");
    let columns = found.series.columns.iter().chain([&found.series.time]);
    assert!(columns.flatten().all(|v| v.is_finite()), "a history is not finite");
    let report = report::build(&found.results, &found.series, results::templates(), report::Level::Full)
        .expect("the report renders");
    results::sound(&report);
}

/// Two results agree but for a factor by quantity (NaN: not compared).
fn close(how: &str, a: &Results, b: &Results, rtol: f64, factor: impl Fn(&str) -> f64) {
    assert_eq!(a.verdict.counts, b.verdict.counts, "{how}");
    methods(how, &a.methods, &b.methods, rtol, factor);
}

fn methods(how: &str, a: &[Method], b: &[Method], rtol: f64, factor: impl Fn(&str) -> f64) {
    assert_eq!(a.len(), b.len(), "{how}");
    for (a, b) in a.iter().zip(b) {
        assert_eq!((&a.id, &a.status), (&b.id, &b.status), "{how}");
        assert!(a.quantities.keys().eq(b.quantities.keys()), "{how}: {}", a.id);
        for (id, value) in &a.quantities {
            let (expected, found) = (factor(id) * value.value, b.quantities[id].value);
            let apart = (found - expected).abs();
            assert!(
                apart.is_nan() || apart <= rtol * expected.abs(),
                "{how}: {} {id}: {expected:e} against {found:e}",
                a.id
            );
        }
    }
}

/// A short record for seeds, as a CSV: 2 s of two decaying waves.
pub fn quake() -> String {
    let acceleration = (0..100).map(|k| {
        let t = f64::from(k) * 0.02;
        (-t).exp() * ((9.0 * t).sin() + 0.4 * (31.0 * t).cos() - 0.4)
    });
    let record =
        Record { name: "waves".into(), dt: 0.02, acceleration: acceleration.collect(), processing: Vec::new() };
    record::columns_of(&record, "m_s2", 1.0, ",", false)
}

/// Path that seeds are read from.
pub fn seeds(root: &Path) -> Vec<Vec<u8>> {
    let quake = quake();
    let with = |tank: Vec<u8>| [tank.as_slice(), b"\0", quake.as_bytes()].concat();
    super::seeds::tanks(root).into_iter().map(with).collect()
}
