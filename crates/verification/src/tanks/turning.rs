//! A base whose rotation is given.
//!
//! Source:    statics; potential flow in a tank that turns ([`fem::liquid::large_wave`], order 1, a formulation by modes of the rigid tank)
//! Model:     harmonic engine with a stiff wall, R = 10 m or a strip of L = 20 m, H = 8 m, under a rotation of its base about y
//! Tolerance: set before the values were computed: 1 % of the modes of the rigid tank, whose four radial ones leave out 0.3 % of the
//!            wave; 1 % of an acceleration −g ψ, from which a rotation of 60 s differs by ω² H/(2g) = 0.5 %; 0.5 % of statics, where
//!            the wave still has 0.2 % of its start

use std::f64::consts::{PI, TAU};

use fem::liquid::large_wave::{Basis, Liquid, Motion, Properties, Side, run};
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::reference::{GRAVITY, case, material};
use tank::{Case, Shape};

use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::{FeError, Options, Simulation, simulate};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "turning-base",
    title: "A base that turns",
    model: "Harmonic engine, default mesh, stiff wall without mass, R = 10 m, H = 8 m of water, 0.5 % damping of sloshing: the base turns about a \
            diameter of the floor, ψ from its second derivative. The same for a metre of a strip of L = 20 m.",
    ids: &[
        ("turning-1", "wave and shear under a burst of rotation, against modes of the rigid tank"),
        ("turning-2", "wave under a slow rotation ψ, against a horizontal acceleration −g ψ"),
        ("turning-3", "at rest on a base that has turned, against statics"),
    ],
    parts: &[
        Part::Fast(|| burst(&CYLINDER)),
        Part::Fast(|| burst(&STRIP)),
        Part::Fast(slow),
        Part::Fast(|| leaning(&CYLINDER)),
        Part::Fast(|| leaning(&STRIP)),
    ],
};

const RADIUS: f64 = 10.0;
const DEPTH: f64 = 8.0;
const DAMPING: f64 = 0.005;
/// Horizontal acceleration of a base that only turns [m/s²]: a record has to have some motion.
const STILL: f64 = 1e-7;
/// Sloshing modes of the wave, and of the modes of the rigid tank.
const MODES: usize = 4;
/// Step of the records [s].
const STEP: f64 = 0.01;

/// A plan.
struct Plan {
    name: &'static str,
    shape: Shape,
    /// Thickness of a wall that hardly bends [m].
    wall: f64,
    /// Modes of the rigid tank, which alternate between odd and even in a strip.
    basis: fn() -> Basis,
    /// What its first modes have of the lever of the wall.
    share: fn() -> f64,
    /// Area [m²] and second moment of the surface about y [m⁴].
    surface: [f64; 2],
}

const CYLINDER: Plan = Plan {
    name: "cylinder",
    shape: Shape::Cylinder { radius: RADIUS },
    wall: 0.05,
    basis: || Basis::cylinder(RADIUS, MODES, Side::Cosine),
    // r = Σ 2R/(λ² − 1) J₁(λr/R)/J₁(λ).
    share: || (1..=MODES).map(|n| 2.0 / (codes::bessel::j_prime_zero(1, n).powi(2) - 1.0)).sum(),
    surface: [PI * RADIUS * RADIUS, PI * RADIUS * RADIUS * RADIUS * RADIUS / 4.0],
};

const STRIP: Plan = Plan {
    name: "strip",
    shape: Shape::Rectangle { length: 2.0 * RADIUS, breadth: 1.0, strip: true },
    wall: 2.0,
    basis: || Basis::strip(2.0 * RADIUS, 1.0, 2 * MODES),
    // x = Σ 4/(L k²) sin kx/sin kL/2.
    share: || (1..=MODES).map(|n| 8.0 / (((2 * n - 1) as f64 * PI).powi(2))).sum(),
    surface: [2.0 * RADIUS, 2.0 * RADIUS * RADIUS * RADIUS / 3.0],
};

fn tank(plan: &Plan) -> Case {
    let mut tank = case(plan.shape, &[(1.05 * DEPTH, plan.wall)], &material(1e16, 0.3, 1.0), (1000.0, DEPTH));
    tank.damping.sloshing = DAMPING;
    tank
}

fn record(samples: Vec<f64>) -> Record {
    Record { name: "motion".into(), dt: STEP, acceleration: samples, processing: Vec::new() }
}

/// The engine under horizontal motion and rotation.
fn engine(plan: &Plan, along: Vec<f64>, rotation: Option<Vec<f64>>, damping: f64) -> Result<Simulation, FeError> {
    let mut tank = tank(plan);
    tank.damping.sloshing = damping;
    tank.ground_motion = Some(GroundMotion { horizontal: record(along), transverse: None, vertical: None });
    simulate(
        &tank,
        &Options { mesh_error: false, wave_modes: MODES, rotation: rotation.map(record), ..Options::default() },
    )
}

fn history<'a>(found: &'a Simulation, id: &str) -> Result<&'a [f64], FeError> {
    let place = found.series.ids.iter().position(|own| own == id);
    let history = place.and_then(|place| found.series.columns.get(place));
    history.map(Vec::as_slice).ok_or_else(|| FeError::Analysis(format!("no history {id}")))
}

/// Largest difference of two histories over the largest of the second.
fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |most, value| most.max(value.abs()));
    largest(&mut found.iter().zip(expected).map(|(f, e)| f - e)) / largest(&mut expected.iter().copied())
}

/// ψ and ψ̈ of a burst of two tones that begins and ends at rest: X sin⁴(πt/T) (sin ω₁t + ½ sin ω₂t), differentiated by hand.
fn tones(t: f64) -> [f64; 2] {
    const LAST: f64 = 20.0;
    if t >= LAST {
        return [0.0, 0.0];
    }
    let k = PI / LAST;
    let (s, c) = (k * t).sin_cos();
    let window = [s.powi(4), 4.0 * k * s.powi(3) * c, 4.0 * k * k * (3.0 * s * s * c * c - s.powi(4))];
    let mut sum = [0.0; 2];
    // Below the fifth mode, which the modes of the rigid tank do not have, at 3.8 rad/s.
    for (size, omega) in [(0.004, 1.1), (0.002, 1.7)] {
        let (sin, cos) = (omega * t).sin_cos();
        sum[0] += size * window[0] * sin;
        sum[1] += size * (window[2] * sin + 2.0 * window[1] * omega * cos - window[0] * omega * omega * sin);
    }
    sum
}

/// Errors: a failure of the engine.
fn burst(plan: &Plan) -> Answer {
    const SOURCE: &str = "modes of the rigid tank, order 1, Runge-Kutta";
    let count = 3000;
    let rotation: Vec<f64> = (0..=count).map(|k| tones(STEP * f64::from(k))[1]).collect();
    let found = engine(plan, vec![STILL; count as usize + 1], Some(rotation), DAMPING)?;
    let own = Properties { depth: DEPTH, density: 1000.0, gravity: GRAVITY, damping: DAMPING, order: 1 };
    let liquid = Liquid::new((plan.basis)(), own);
    let drive = |t: f64| {
        let [tilt, angular] = tones(t);
        Motion { tilt: [tilt, 0.0], angular: [angular, 0.0], ..Motion::default() }
    };
    let modes = run(&liquid, &drive, STEP * f64::from(count), None, |motion| motion);
    let values = liquid.values([RADIUS, 0.0]);
    let wave: Vec<f64> = (0..=count).map(|k| modes.wave_at(&values, STEP * f64::from(k))).collect();
    let forces = liquid.forces(modes.frames());
    let times: Vec<f64> = modes.frames().map(|frame| frame.time).collect();
    let own_shear = history(&found, "base_shear")?;
    // The engine's shear at the instants of the modes; both are smooth over a step.
    let at = |t: f64| {
        let k = ((t / STEP) as usize).min(own_shear.len() - 2);
        own_shear[k] + (t / STEP - k as f64) * (own_shear[k + 1] - own_shear[k])
    };
    let shear: Vec<f64> = times.iter().map(|t| at(*t)).collect();
    let expected: Vec<f64> = forces.iter().map(|force| -force.shear[0]).collect();
    let row = |what: &str, difference: f64| {
        let what = format!("{}: largest difference of the {what} over its largest", plan.name);
        Row::new("turning-1", what, (0.0, SOURCE, Reference::SecondFormulation), difference, (0.01, "1"))
    };
    Ok(vec![
        row("wave", apart(history(&found, "wave_height_theta_0")?, &wave)),
        row("base shear", apart(&shear, &expected)),
    ])
}

/// Errors: a failure of the engine.
fn slow() -> Answer {
    // ψ = X sin²(πt/T)-like: (1 − cos ωt)/2 begins and ends at rest.
    let (size, omega, count) = (0.01, TAU / 60.0, 6000);
    let at = |k: i32| omega * STEP * f64::from(k);
    let rotation = (0..=count).map(|k| 0.5 * size * omega * omega * at(k).cos()).collect();
    let along = (0..=count).map(|k| -GRAVITY * 0.5 * size * (1.0 - at(k).cos())).collect();
    let turned = engine(&CYLINDER, vec![STILL; count as usize + 1], Some(rotation), 0.05)?;
    let pushed = engine(&CYLINDER, along, None, 0.05)?;
    let id = "wave_height_theta_0";
    let source = (0.0, "horizontal acceleration −g ψ of the same engine", Reference::SecondFormulation);
    let difference = apart(history(&turned, id)?, history(&pushed, id)?);
    Ok(vec![Row::new("turning-2", "largest difference of the wave over its largest", source, difference, (0.01, "1"))])
}

/// Errors: a failure of the engine.
fn leaning(plan: &Plan) -> Answer {
    // The base turns by 0.01 rad within 20 s, after which it rests for 60 s.
    let (angle, omega, last) = (0.01, TAU / 20.0, 2000);
    let rotation = (0..=8000)
        .map(|k| if k < last { angle * omega / 20.0 * (omega * STEP * f64::from(k)).sin() } else { 0.0 })
        .collect();
    let found = engine(plan, vec![STILL; 8001], Some(rotation), 0.1)?;
    let end = |id: &str| Ok::<f64, FeError>(history(&found, id)?[8000]);
    let [area, second] = plan.surface;
    let mass = 1000.0 * area * DEPTH;
    let across = GRAVITY * angle;
    let row = |what: &str, expected: f64, computed: f64, unit: &'static str| {
        Row::new(
            "turning-3",
            format!("{}: {what}", plan.name),
            (expected, "statics", Reference::ClosedForm),
            computed,
            (0.005, unit),
        )
    };
    let arm = 0.5 * DEPTH;
    let floor = second / (area * DEPTH);
    Ok(vec![
        row(
            "rise of the surface where the base is low, four modes",
            (plan.share)() * RADIUS * angle,
            end("wave_height_theta_0")?,
            "m",
        ),
        row("base shear", -mass * across, end("base_shear")?, "N"),
        row("moment above the base plate", -mass * across * arm, end("base_moment")?, "N m"),
        row("moment below it", -mass * across * (arm + floor), end("overturning_moment")?, "N m"),
    ])
}
