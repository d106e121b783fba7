//! Estimates against measured runs: memory and time within a factor of 1.5.
//!
//! Measured: largest resident set, and processor time of the release build on the idle reference machine, as in
//! docs/performance.md, which has the commands. The estimates follow from counts of elements, entries and operations; where one
//! leaves the factor, correct its model, not the number here.

use std::path::Path;

use engines::estimate::{Estimate, MIB};
use engines::nonlinear::push::{Amplitude, PushOptions, Quality};
use engines::nonlinear::{self, WallElements};
use engines::solid::{self, Liquid, MeshSize, SolidOptions};
use engines::{Integrator, Options, harmonic};
use tank::options::AfterRecord;
use tank::options::nonlinear::ThicknessRule;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;
use tankcheck::input::{TankFile, read_tank, records};

/// Factor that is allowed.
const FACTOR: f64 = 1.5;

/// The tank of an example under a record of the examples.
fn example(tank: &str, record: &str) -> TankFile {
    let home = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut file = read_tank(&home.join(tank)).expect("an example");
    let read = records::read(&home.join(record), &records::ReadOptions::default()).expect("a record");
    let horizontal = records::process(&read.record, &file.record).expect("its processing");
    file.case.ground_motion = Some(tank::case::GroundMotion { horizontal, transverse: None, vertical: None });
    file
}

/// Holds an estimate against a measured run: memory [MiB] and time [s], each where it was measured.
fn within(what: &str, found: &Estimate, memory: Option<f64>, seconds: Option<f64>, faults: &mut Vec<String>) {
    let mib = found.bytes() / MIB;
    println!("{what}: {mib:.0} MiB against {memory:?}, {:.3} s against {seconds:?}", found.seconds);
    for (name, found, measured) in [("MiB", mib, memory), ("s", found.seconds, seconds)] {
        if let Some(measured) = measured
            && !(1.0 / FACTOR..=FACTOR).contains(&(found / measured))
        {
            faults.push(format!("{what}: {found:.3} {name}, measured {measured} {name}"));
        }
    }
}

const BROAD: [&str; 2] = ["01_broad_tank/tank.json", "records/elcentro.csv"];

#[test]
fn estimates_are_within_a_factor_of_measured_runs() {
    let mut faults = Vec::new();
    let mut broad = example(BROAD[0], BROAD[1]);
    // Measured without the modes of the site's vertical motion.
    broad.case.site = tank::case::Site::default();
    let one = Options { mesh_error: false, ..broad.fe.clone() };
    for (mesh, liquid, newmark, memory, seconds) in MEASURED_SOLID {
        let options =
            Options { integrator: if newmark { Integrator::Newmark } else { Integrator::Modal }, ..one.clone() };
        let solid = SolidOptions {
            mesh: Some(MeshSize { radial: mesh[0], sectors: mesh[1], vertical: mesh[2] }),
            liquid,
            ..SolidOptions::default()
        };
        let found = solid::estimate(&broad.case, &options, &solid).expect("an estimate");
        let what = format!("solid {mesh:?} {liquid:?} newmark {newmark}");
        within(&what, &found, memory, seconds, &mut faults);
    }

    let mut strip = example("06_sandwich_strip/tank.json", "records/elcentro.csv");
    for (step, layers, memory, seconds) in MEASURED_STRIP {
        strip.nonlinear.time_step = Some(step);
        strip.nonlinear.integration.concrete = ThicknessRule::MidPoint(layers);
        // Measured without free vibration after the record.
        strip.nonlinear.after_record = AfterRecord::NONE;
        let found = nonlinear::estimate_incremental(&strip.case, &strip.nonlinear, 1, 1).expect("an estimate");
        within(&format!("strip, step {step} s, {layers} layers"), &found, memory, seconds, &mut faults);
    }

    for (tank, record, first, elements, memory, seconds) in MEASURED_CYLINDER {
        let mut cylinder = example(tank, record);
        if let (Some(first), Some(motion)) = (first, &mut cylinder.case.ground_motion) {
            let record = &mut motion.horizontal;
            record.acceleration.truncate((first / record.dt).round() as usize + 1);
        }
        cylinder.nonlinear.after_record = AfterRecord::NONE;
        cylinder.nonlinear.elements = Some(WallElements { height: elements[0], circumference: elements[1] });
        let found = nonlinear::estimate(&cylinder.case, &cylinder.nonlinear).expect("an estimate");
        within(&format!("{tank} {elements:?}"), &found, memory, seconds, &mut faults);
    }

    let steel = example("07_steel_cylinder/tank.json", "records/elcentro.csv");
    let push = PushOptions { imperfection: Some(Amplitude::Quality(Quality::B)), ..PushOptions::default() };
    let found = nonlinear::push::estimate(&steel.case, &steel.nonlinear, &push).expect("an estimate");
    within("push, class B", &found, None, Some(284.0), &mut faults);
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Memory of every kind of tank of the harmonic engine, which grows with mesh, record and checks, and twice as far where the base lifts.
#[test]
fn memory_of_the_harmonic_engine() {
    let mut faults = Vec::new();
    for (tank, shaken, refine, mesh_error, memory) in MEASURED_HARMONIC {
        let mut file = example(tank, BROAD[1]);
        if !shaken {
            file.case.ground_motion = None;
        }
        let options = Options { refine, mesh_error, ..file.fe.clone() };
        let found = harmonic::estimate(&file.case, &options).expect("an estimate");
        let what = format!("{tank}, shaken {shaken}, refine {refine}, mesh error {mesh_error}");
        within(&what, &found, Some(memory), None, &mut faults);
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Tank, whether under `elcentro.csv`, refinement, whether with a second mesh, memory: `compare … --no-report --refine N [--no-mesh-error]`. Measured as the
/// largest `RssAnon` of the development build and 12 MiB for the code of a release build, whose pages are a third of those of a development build.
const MEASURED_HARMONIC: [(&str, bool, f64, bool, f64); 13] = [
    ("01_broad_tank/tank.json", true, 1.0, true, 42.9),
    ("01_broad_tank/tank.json", true, 2.0, false, 45.2),
    ("01_broad_tank/tank.json", true, 4.0, false, 88.1),
    ("01_broad_tank/tank.json", true, 6.0, true, 235.8),
    ("01_broad_tank/tank.json", true, 8.0, false, 350.1),
    ("01_broad_tank/tank.json", false, 1.0, true, 37.4),
    ("02_perspex_model_tank/tank.json", true, 1.0, true, 47.8),
    ("04_concrete_strip/tank.json", true, 1.0, true, 47.0),
    ("05_oil_tank/tank.json", true, 1.0, false, 120.7),
    ("05_oil_tank/tank.json", true, 1.0, true, 131.5),
    ("05_oil_tank/tank.json", true, 4.0, false, 329.4),
    ("05_oil_tank/tank.json", false, 1.0, true, 44.7),
    ("09_slender_unanchored/tank.json", true, 1.0, true, 108.7),
];

/// Elements over radius, circumference and height.
type Mesh = [usize; 3];
/// The measured value, if there is one.
type Figure = Option<f64>;

/// Mesh, liquid, direct integration, memory, time: `compare … --no-mesh-error --fe solid --mesh RxSxV`.
const MEASURED_SOLID: [(Mesh, Liquid, bool, Figure, Figure); 5] = [
    ([12, 16, 20], Liquid::Potential, false, Some(42.7), Some(0.39)),
    ([24, 32, 40], Liquid::Potential, false, Some(275.8), Some(5.8)),
    ([12, 16, 20], Liquid::Displacement, false, Some(213.8), Some(1.76)),
    ([24, 32, 40], Liquid::Displacement, false, Some(2764.8), Some(53.0)),
    ([12, 16, 20], Liquid::Potential, true, None, Some(59.0)),
];

/// Time step, layers of concrete, memory, time: `ida examples/06_sandwich_strip/tank.json … --scale 1 --jobs 1`; times on a busy machine.
const MEASURED_STRIP: [(f64, u32, Figure, Figure); 3] =
    [(0.006, 20, None, Some(3.7)), (0.006, 60, None, Some(7.0)), (0.0025, 20, Some(19.4), Some(7.8))];

/// A row of the next table.
type Cylinder = (&'static str, &'static str, Figure, [u32; 2], Figure, Figure);

/// Tank, record and its first seconds, elements over height and around, memory, time: `compare … --fe nonlinear --no-mesh-error
/// --threads 1` without free vibration after the record; code procedures and linear engine are in the time, 0.2 s of it.
const MEASURED_CYLINDER: [Cylinder; 5] = [
    // Memory under the first second of the record: histories are some MiB of the whole.
    ("08_concrete_cylinder/tank.json", "08_concrete_cylinder/record.csv", None, [40, 100], Some(129.1), None),
    ("08_concrete_cylinder/tank.json", "08_concrete_cylinder/record.csv", Some(0.5), [40, 100], Some(131.8), Some(7.4)),
    ("07_steel_cylinder/tank.json", "07_steel_cylinder/shaking.csv", None, [48, 96], Some(73.4), None),
    ("07_steel_cylinder/tank.json", "07_steel_cylinder/shaking.csv", Some(0.4), [48, 96], Some(76.2), Some(2.56)),
    ("07_steel_cylinder/tank.json", "07_steel_cylinder/shaking.csv", Some(0.4), [24, 48], Some(37.4), Some(0.66)),
];

/// A steel tank of R = 15 m (docs/performance.md).
const PRACTICAL: &str = r#"{
  "name": "practical",
  "tank": { "shape": "cylinder", "radius": "15 m", "support": "anchored",
    "courses": [
      { "height": "2 m", "thickness": "12 mm", "material": "steel" },
      { "height": "2 m", "thickness": "10 mm", "material": "steel" },
      { "height": "2 m", "thickness": "9 mm", "material": "steel" },
      { "height": "6 m", "thickness": "8 mm", "material": "steel" } ],
    "roof": { "mass": "0 kg" } },
  "liquid": { "density": "1000 kg/m3", "fill_height": "11 m" },
  "materials": { "steel": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3",
    "yield_strength": "235 MPa" } },
  "analysis": { "nonlinear": { "elements": { "height": 48, "circumference": 96 } } }
}"#;

/// Times of walls that yield or crack, or vibrate after the record, lie between both times of the estimate, each taken with a factor of
/// 1.25, half of the factor that the times of elastic runs have; and the range is at most a factor of 3.5 wide.
#[test]
fn measured_times_are_in_the_range() {
    let concrete = example("08_concrete_cylinder/tank.json", "08_concrete_cylinder/record.csv");
    let mut steel = parse(&Source::new("tank.json", PRACTICAL.to_owned())).expect("a tank");
    steel.case.ground_motion = example("07_steel_cylinder/tank.json", "records/elcentro.csv").case.ground_motion;
    for (mut file, first, after, measured) in [
        (steel.clone(), 20.0, AfterRecord::NONE, 252.0),
        (steel.clone(), 1.0, steel.nonlinear.after_record, 45.0),
        (concrete.clone(), 0.5, concrete.nonlinear.after_record, 102.0),
    ] {
        let record = &mut file.case.ground_motion.as_mut().expect("a record").horizontal;
        record.acceleration.truncate((first / record.dt).round() as usize + 1);
        file.nonlinear.after_record = after;
        let found = nonlinear::estimate(&file.case, &file.nonlinear).expect("an estimate");
        let (low, high) = (found.seconds, found.longest());
        println!("{}: {low:.0} to {high:.0} s, measured {measured} s", found.sentence());
        assert!(low / 1.25 < measured && measured < 1.25 * high, "{low} {measured} {high}");
        assert!(high / low < 3.5, "{low} {high}");
    }
}
