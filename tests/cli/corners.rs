//! Tanks that the input accepts but nobody builds: very flat, very slender, tiny, huge, of many courses, nearly empty or full,
//! on coarse and fine meshes. The codes and the harmonic engine return results of finite numbers, or an error in words; they do
//! not panic.

use std::cell::Cell;
use std::fmt::Write;

use engines::estimate::MEMORY_LIMIT_MIB;
use engines::harmonic::wall_nodes;
use fem::liquid::LiquidMesh;
use fem::progress::Silent;
use oscillator::record::Record;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use results::EngineId;
use tank::case::GroundMotion;
use tankcheck::input::read_tank;
use tankcheck::job::Job;

/// A number between two others, evenly in its logarithm.
fn log(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low.ln()..high.ln()).prop_map(f64::exp)
}

/// Material of a tank.
#[derive(Clone, Debug)]
struct Plan {
    round: bool,
    /// Radius, or half the length [m].
    half: f64,
    /// Height over it.
    slender: f64,
    /// Shares of the height and thickness over the radius, course by course from the base.
    courses: Vec<(f64, f64)>,
    /// Fill height over height of the wall.
    fill: f64,
    /// Young's modulus [Pa].
    modulus: f64,
    roof: f64,
    refine: f64,
}

fn plan() -> impl Strategy<Value = Plan> {
    let course = (log(1e-4, 1.0), log(1e-4, 0.1));
    let fill = prop_oneof![log(1e-5, 1.0), Just(1.0), (-9.0..-2.0f64).prop_map(|p| 1.0 - 10f64.powf(p)),];
    (
        any::<bool>(),
        log(1e-3, 450.0),
        log(1e-3, 1e3),
        prop::collection::vec(course, 1..9),
        fill,
        log(1e9, 1e13),
        prop_oneof![Just(0.0), log(1.0, 1e7)],
        prop::sample::select(vec![0.25, 0.5, 1.0, 1.3]),
    )
        .prop_map(|(round, half, slender, courses, fill, modulus, roof, refine)| Plan {
            round,
            half,
            slender,
            courses,
            fill,
            modulus,
            roof,
            refine,
        })
}

impl Plan {
    fn json(&self) -> String {
        // Within the limits of the input.
        let height = (self.slender * self.half).min(900.0);
        let sum: f64 = self.courses.iter().map(|c| c.0).sum();
        let mut courses = String::new();
        let mut built = 0.0;
        for (share, thickness) in &self.courses {
            let own = height * share / sum;
            built += own;
            let comma = if courses.is_empty() { "" } else { ", " };
            let _ = write!(
                courses,
                "{comma}{{ \"height\": \"{own:e} m\", \"thickness\": \"{:e} m\", \"material\": \"m\" }}",
                thickness * self.half
            );
        }
        let shape = match self.round {
            true => format!("\"shape\": \"cylinder\", \"radius\": \"{:e} m\"", self.half),
            false => format!("\"shape\": \"rectangle\", \"length\": \"{:e} m\", \"strip\": true", 2.0 * self.half),
        };
        format!(
            "{{ \"name\": \"corner\", \"tank\": {{ {shape}, \"support\": \"anchored\", \"courses\": [{courses}], \
             \"roof\": {{ \"mass\": \"{:e} kg\" }} }}, \
             \"liquid\": {{ \"density\": \"1000 kg/m3\", \"fill_height\": \"{:e} m\" }}, \
             \"materials\": {{ \"m\": {{ \"youngs_modulus\": \"{:e} Pa\", \"poisson_ratio\": 0.3, \"density\": \"7850 kg/m3\", \
             \"yield_strength\": \"235 MPa\" }} }}, \
             \"damping\": {{ \"sloshing\": 0.005, \"impulsive\": 0.02 }}, \
             \"analysis\": {{ \"refine\": {} }} }}",
            self.roof,
            built * self.fill,
            self.modulus,
            self.refine
        )
    }
}

/// The job of a tank file with a record of a second; `None` if the input refuses it.
fn job(text: &str) -> Option<Job> {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("tank.json");
    std::fs::write(&path, text).expect("writable");
    let tank = read_tank(&path).ok()?;
    let record = Record {
        name: "pulse".into(),
        dt: 0.05,
        acceleration: (0..20).map(|k| (0.7 * f64::from(k)).sin()).collect(),
        processing: Vec::new(),
    };
    let all = tankcheck::pipeline::procedures::select_procedures(&[], &[], &tank.case.site).expect("all");
    let mut job = Job { engines: vec![EngineId::Harmonic], raw_records: vec![record.clone()], ..Job::of(tank, all) };
    job.case.ground_motion = Some(GroundMotion { horizontal: record, transverse: None, vertical: None });
    Some(job)
}

/// Runs a job as `compare` does; an error is one with words.
fn runs(job: &Job) -> Result<(), TestCaseError> {
    let admitted = engines::harmonic::estimate(&job.case, &job.linear).and_then(|e| e.hold(MEMORY_LIMIT_MIB));
    if let Err(refusal) = admitted {
        prop_assert!(!refusal.to_string().is_empty());
        return Ok(());
    }
    match tankcheck::pipeline::run(job, &Silent) {
        Ok(outcome) => {
            for method in outcome.results.methods.iter().filter(|m| m.id == "fe") {
                for (id, value) in &method.quantities {
                    prop_assert!(value.value.is_finite(), "{id}: {}", value.value);
                }
            }
        }
        Err(error) => prop_assert!(!error.to_string().is_empty()),
    }
    Ok(())
}

/// Gives `cases` plans (`PROPTEST_CASES` where it is set) whose tanks the input accepts, at least a third of them, to `body`.
fn each(cases: u32, body: impl Fn(Plan, Job) -> Result<(), TestCaseError>) {
    let cases = match std::env::var_os("PROPTEST_CASES") {
        Some(_) => ProptestConfig::default().cases,
        None => cases,
    };
    let config = ProptestConfig { cases, failure_persistence: None, max_shrink_iters: 40, ..ProptestConfig::default() };
    let accepted = Cell::new(0);
    let outcome = TestRunner::new(config).run(&plan(), |plan| {
        let Some(job) = job(&plan.json()) else { return Ok(()) };
        accepted.set(accepted.get() + 1);
        body(plan, job)
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
    println!("{} of {cases} tanks accepted", accepted.get());
    assert!(3 * accepted.get() >= cases, "only {} of {cases} were accepted", accepted.get());
}

#[test]
fn accepted_tanks_are_computed_or_refused_in_words() {
    each(40, |plan, mut job| {
        // The second mesh of every other tank.
        job.linear.mesh_error = plan.round;
        runs(&job)?;
        job.engines.clear();
        let codes = tankcheck::pipeline::run(&job, &Silent);
        prop_assert!(codes.is_ok() || !codes.unwrap_err().to_string().is_empty());
        Ok(())
    });
}

/// Meshes alone, on every refinement.
#[test]
fn nodes_ascend_and_belong_to_courses() {
    each(1000, |plan, job| {
        for refine in [0.25, plan.refine, 5.0, 16.0] {
            let options = engines::Options { refine, ..engines::Options::default() };
            let estimate = engines::harmonic::estimate(&job.case, &options);
            if estimate.and_then(|e| e.hold(MEMORY_LIMIT_MIB)).is_err() {
                continue;
            }
            let (depth, height) = (job.case.liquid.fill_height, job.case.tank.wall_height());
            let (nodes, courses) = wall_nodes(&job.case.tank, depth, refine);
            prop_assert!(nodes.windows(2).all(|z| z[1] > z[0]), "{nodes:?}");
            prop_assert!(courses.iter().all(|c| *c < job.case.tank.courses.len()));
            let wetted = nodes.iter().filter(|z| **z <= depth + 1e-6 * height).count();
            prop_assert!(wetted >= 2, "{wetted} of {nodes:?} under {depth}");
            let mesh = LiquidMesh::graded(job.case.tank.shape.half_length(), depth, refine);
            for nodes in [&mesh.r, &mesh.z] {
                prop_assert!(nodes.windows(2).all(|x| x[1] > x[0]), "{nodes:?}");
            }
        }
        Ok(())
    });
}

/// The least depth that the input takes, a thousandth of the radius: just refused, just computed.
#[test]
fn the_shallowest_liquid() {
    let plan = |fill: f64| Plan {
        round: true,
        half: 1.83,
        slender: 1.0,
        courses: vec![(0.5, 1.1e-3), (0.5, 0.7e-3)],
        fill,
        modulus: 69e9,
        roof: 0.0,
        refine: 1.0,
    };
    // A share of the height, which is the radius.
    for (fill, accepted) in [(5e-7, false), (0.99e-3, false), (1.01e-3, true), (1e-2, true)] {
        let options = engines::Options { mesh_error: false, ..engines::Options::default() };
        let found = job(&plan(fill).json()).map(|job| engines::simulate(&job.case, &options));
        assert_eq!(found.is_some(), accepted, "{fill}");
        assert!(found.is_none_or(|run| run.is_ok()), "{fill}");
    }
}
