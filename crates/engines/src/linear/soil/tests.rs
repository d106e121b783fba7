//! A cylinder on its slab: rigid motion, the limit of hard soil, direct integration, free decay.

use ::soil::structure::OnSoil;
use fem::linalg::dot;
use fem::progress::Silent;
use oscillator::record::Record;
use results::Channel;
use tank::case::GroundMotion;
use tank::options::LinearOptions as Options;
use tank::options::linear::{Dashpots, Integrator, WallDirection};
use tank::{Case, Foundation, FoundationKind, Quantity, Shape, SoilLayer, Subsoil};

use super::Slab;
use super::extend::Rigid;
use super::twin::body;
use super::under::impulsive;
use crate::harmonic::{Places, test_tanks};
use crate::linear::analysis::{Analysis, analyse};
use crate::linear::model::Model;

const TAU: f64 = std::f64::consts::TAU;

/// Steel, 20 m across, 12 mm thick, 11 m of water; bursts of waves near the periods of the wall.
fn tank(velocity: Option<f64>, thickness: Option<f64>) -> Case {
    let shape = Shape::Cylinder { radius: 10.0 };
    let mut case = test_tanks::case(shape, &[(12.0, 12e-3)], (205e9, 0.3, 7850.0), (1000.0, 11.0));
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Slab,
        stiffness: None,
        shear_wave_velocity: velocity,
        soil_density: 1900.0,
        soil_poisson_ratio: 1.0 / 3.0,
        thickness,
        friction: None,
    });
    let dt = 0.01;
    let acceleration = (0..600).map(|i| {
        let t = dt * f64::from(i);
        2.0 * (0.5 * TAU * t / 6.0).sin().powi(2) * ((TAU * 4.1 * t).sin() + 0.6 * (TAU * 0.5 * t).sin())
    });
    shaken(case, dt, acceleration.collect())
}

fn shaken(mut case: Case, dt: f64, acceleration: Vec<f64>) -> Case {
    let horizontal = Record { name: "waves".into(), dt, acceleration, processing: Vec::new() };
    case.ground_motion = Some(GroundMotion { horizontal, transverse: None, vertical: None });
    case
}

fn model(case: &Case, options: &Options) -> Model {
    Model::new(case, options, false, Places::Usual).unwrap()
}

fn run<'a>(case: &Case, model: &'a Model, options: &Options) -> Analysis<'a> {
    analyse(model, case.ground_motion.as_ref().unwrap(), options, &Silent).unwrap()
}

/// A dashpot of next to nothing, with which a run on a fixed base keeps all modes as one on soil does.
fn every_mode() -> Options {
    Options {
        dashpots: vec![Dashpots { z: 6.0, direction: WallDirection::Radial, coefficient: 1e-3 }],
        ..Options::default()
    }
}

/// Liquid that moves as a rigid body: S = m_l (H/2 + R²/(4 H)) with the bottom pressure, and wall mass times its centroid. Discretisation of
/// the liquid: 1e-3. A rotation of everything: wall m (H_w²/3) in part, so that J exceeds S²/m.
#[test]
fn first_moment_of_a_rigid_translation() {
    let case = tank(Some(200.0), None);
    let slab = Slab::of(&case).unwrap().unwrap();
    let model = model(&case, &Options::default());
    let held = &model.held().coupled;
    let rigid = Rigid::of(held, &case, &slab).unwrap();
    let (r, h) = (10.0, 11.0);
    let expected = held.liquid_mass * (0.5 * h + r * r / (4.0 * h)) + held.wall_mass * 6.0;
    assert!((rigid.first / expected - 1.0).abs() < 1e-3, "{} {expected}", rigid.first);
    assert!(rigid.second > rigid.first.powi(2) / rigid.mass);
    // A ground that accelerates towards θ = 0 leaves suction there, as does a floor that goes down there.
    let foot = &held.line(results::channel::OnWall::Pressure).unwrap().probes[0];
    assert!(dot(&foot.absolute_acceleration, &held.influence) + foot.ground_acceleration < 0.0);
}

/// On soil of 1e6 m/s the flexibility is k/K_x = 1e-7: histories are those of the fixed base within 1e-6 of their largest value. The fixed run
/// keeps all modes here; the one of a user keeps the lower ones, which is a choice of 1e-3. Extremes lie on cubics between sub-steps, which
/// the modes of the slab make shorter: (2π/20)⁴/384 = 2.5e-5.
#[test]
fn hard_soil_is_a_fixed_base() {
    let soft = tank(Some(1e6), None);
    let held = tank(None, None);
    for (options, history, extreme) in [(every_mode(), 1e-6, 2.5e-5), (Options::default(), 1e-3, 1e-3)] {
        let (on_soil, fixed) = (model(&soft, &options), model(&held, &options));
        assert!(on_soil.fixed.is_some() && fixed.fixed.is_none());
        let (found, expected) = (run(&soft, &on_soil, &options), run(&held, &fixed, &options));
        for (scalar, values) in &expected.scalars {
            let same = found.scalars.iter().find(|(s, _)| s.channel == scalar.channel).unwrap();
            let peak = values.values.iter().fold(0.0, |m, v| f64::max(m, v.abs()));
            for (a, b) in same.1.values.iter().zip(&values.values) {
                assert!((a - b).abs() <= history * peak, "{:?}: {a} {b}, peak {peak}", scalar.channel);
            }
        }
        let (found, expected) = (found.values(&on_soil, true), expected.values(&fixed, true));
        assert_eq!(found.len(), expected.len());
        for (quantity, value) in &expected {
            let other = found[quantity];
            // The rim swings with the higher modes, of which the default leaves out some: to the stress of the wall.
            let scale = match quantity {
                Quantity::RimHoopStress => expected[&Quantity::HoopStress],
                _ => *value,
            };
            assert!((other - value).abs() < extreme * scale, "{quantity:?}: {other} {value}");
        }
    }
}

/// Statics: under an acceleration a that grows slowly the slab turns by −a S/K_θ, S as in [`first_moment_of_a_rigid_translation`],
/// K_θ = 8 G R³/(3 (1 − ν)), and the surface tilts as it does on rigid ground. The rim rises where the surface falls, so that the
/// wave relative to the rim is larger by R ψ. Discretisation of the liquid, and sloshing that is left of the start: 1 %.
#[test]
fn a_wave_is_measured_from_the_rim_that_turns() {
    let (dt, last, velocity, r, h) = (0.02, 4000, 80.0, 10.0, 11.0);
    let a = (0..=last).map(|i| 0.25 * (1.0 - (0.5 * TAU * f64::from(i) / f64::from(last)).cos()));
    let case = shaken(tank(Some(velocity), None), dt, a.collect());
    let turning = model(&case, &Options::default());
    let mut level = turning.clone();
    level.horizontal.coupled.probes.iter_mut().for_each(|probe| probe.rim.clear());
    let end = |model: &Model, side| {
        let found = run(&case, model, &Options::default());
        let scalar = found.scalars.iter().find(|(s, _)| s.channel == Channel::Wave(side)).unwrap();
        scalar.1.values[last as usize]
    };
    let held = &turning.held().coupled;
    let first = held.liquid_mass * (0.5 * h + r * r / (4.0 * h)) + held.wall_mass * 6.0;
    let stiffness = 8.0 * 1900.0 * velocity * velocity * f64::powi(r, 3) / (3.0 * (1.0 - 1.0 / 3.0));
    for (side, sign) in [(results::channel::Side::Front, -1.0), (results::channel::Side::Back, 1.0)] {
        let expected = sign * r * 0.5 * first / stiffness;
        let (found, elevation) = (end(&turning, side), end(&level, side));
        assert!(((found - elevation) / expected - 1.0).abs() < 0.01, "{found} {elevation} {expected}");
        assert!(elevation * sign > 0.0);
    }
}

/// Direct integration closes its balance of energy, radiated energy among the damping, and gives the peaks of modal superposition within
/// the 1 % of its step.
#[test]
fn direct_integration_agrees() {
    let case = tank(Some(200.0), Some(0.8));
    let options = Options { integrator: Integrator::Newmark, ..Options::default() };
    let model = model(&case, &options);
    let analysis = run(&case, &model, &options);
    assert!(analysis.energy.unwrap().error < 1e-6);
    let (difference, title) = analysis.difference.unwrap();
    assert!(difference < 0.01, "{difference} {title}");
}

/// Free decay of the rotation after a pulse against the complex mode of one mass on the cones. The engine has more modes, and mass beside the
/// impulsive one: 2 % of the period, 10 % of the damping.
#[test]
fn free_decay_has_the_effective_period() {
    let pulse = |case: Case| {
        let a = (0..400).map(|i| if i < 20 { (TAU * f64::from(i) / 20.0).sin() } else { 0.0 });
        shaken(case, 0.005, a.collect())
    };
    let case = pulse(tank(Some(400.0), None));
    let slab = Slab::of(&case).unwrap().unwrap();
    let model = model(&case, &Options::default());
    let analysis = run(&case, &model, &Options::default());
    let mode = impulsive(&case, model.held(), &model.damper, &slab).unwrap();
    let on = OnSoil::new(mode.structure(), slab.disc).unwrap();
    let chain = ::soil::chain::Chain::new(&on, [0.0, 0.0]).unwrap();
    let expected = chain.complex_mode().unwrap();
    let channel = Channel::FoundationRotation;
    let rotation = &analysis.scalars.iter().find(|(s, _)| s.channel == channel).unwrap().1.values;
    // Differences over a step take the sloshing away, whose period is 20 times longer.
    let rate: Vec<f64> = rotation.windows(3).map(|w| w[2] - 2.0 * w[1] + w[0]).collect();
    let mut peaks: Vec<(f64, f64)> = Vec::new();
    for (i, w) in rate.windows(3).enumerate().skip(40) {
        if w[1] > w[0] && w[1] >= w[2] && w[1] > 0.0 {
            // Parabola through three samples.
            let (slope, bend) = (0.5 * (w[2] - w[0]), w[2] - 2.0 * w[1] + w[0]);
            let s = -slope / bend;
            peaks.push((0.005 * (i as f64 + 1.0 + s), w[1] + 0.5 * slope * s));
        }
    }
    let n = 4;
    let (first, last) = (peaks[0], peaks[n]);
    let damped = (last.0 - first.0) / n as f64;
    let decrement = (first.1 / last.1).ln() / n as f64;
    let damping = decrement / (TAU * TAU + decrement * decrement).sqrt();
    let period = damped * (1.0 - damping * damping).sqrt();
    println!("fixed {} {}; expected {expected:?}; found {period} {damping}", on.structure.period, on.structure.damping);
    assert!(expected.period / on.structure.period > 1.03);
    assert!((period / expected.period - 1.0).abs() < 0.02, "{period} {expected:?}");
    assert!((damping / expected.damping - 1.0).abs() < 0.10, "{damping} {expected:?}");
}

/// The results of a run say what the soil did.
#[test]
fn the_results_hold_period_damping_and_motion() {
    let found = crate::linear::simulate(&tank(Some(150.0), Some(0.6)), &Options::default()).unwrap();
    let soil = found.result.part("soil").unwrap();
    let effective = |row: &str, column: &str| soil.cell("effective", row, column).unwrap();
    assert!(effective("cones", "period") > effective("fixed", "period"));
    assert!(effective("cones", "damping") > effective("fixed", "damping"));
    assert_eq!(found.values[&Quantity::ImpulsivePeriod], effective("fixed", "period"));
    for id in ["base_translation", "base_rotation"] {
        assert!(soil.value(id).unwrap().time.is_some(), "{id}");
    }
    assert!(soil.value("base_shear").unwrap().held.is_some());
    assert!(found.notes.iter().any(|note| note.contains("moves on its slab")), "{:?}", found.notes);
}

/// Translation and rotation against [`::soil::body`], the same modes eliminated in each of its steps, which have the whole of a force at the
/// underside of the slab. Bound set beforehand: 2e-3 of the peak at every sample. Forty steps to a sample leave (ω h)²/12 of the phase, 1e-5
/// at the impulsive frequency; direct integration has its own step, 1.6e-3.
#[test]
fn the_slab_moves_as_on_the_body() {
    for thickness in [None, Some(0.8)] {
        let case = tank(Some(200.0), thickness);
        let slab = Slab::of(&case).unwrap().unwrap();
        for integrator in [Integrator::Modal, Integrator::Newmark] {
            let options = Options { integrator, ..Options::default() };
            let model = model(&case, &options);
            let analysis = run(&case, &model, &options);
            let record = &case.ground_motion.as_ref().unwrap().horizontal;
            let mut ground = record.acceleration.clone();
            ground.resize(analysis.scalars[0].1.values.len().max(ground.len()), 0.0);
            let march =
                ::soil::body::march(&body(&case, &model, &slab).unwrap(), &slab.disc, &ground, record.dt, 40).unwrap();
            for (channel, expected) in
                [(Channel::FoundationTranslation, &march.translation), (Channel::FoundationRotation, &march.rotation)]
            {
                let found = &analysis.scalars.iter().find(|(s, _)| s.channel == channel).unwrap().1;
                let peak = expected.iter().fold(0.0, |m, v| f64::max(m, v.abs()));
                let pairs = found.values.iter().zip(expected);
                let worst = pairs.fold(0.0, |m, (a, b)| f64::max(m, (a - b).abs())) / peak;
                println!("{channel:?}, slab {thickness:?}, {integrator:?}: {worst:.1e}");
                assert!(worst < 2e-3, "{channel:?} {thickness:?} {integrator:?}: {worst}");
            }
        }
    }
}

/// The soil under a rim that lifts is that of the base alone.
#[test]
fn an_unanchored_tank_keeps_its_slab_at_rest_and_says_so() {
    let mut case = tank(Some(150.0), Some(0.6));
    case.tank.support = tank::Support::Unanchored;
    let found = crate::linear::simulate(&case, &Options::default()).unwrap();
    assert!(found.result.part("soil").is_none());
    assert!(found.notes.iter().any(|note| note.contains("counted twice")), "{:?}", found.notes);
}

/// Layers of the soil of the half-space, at rest on it and without damping, are the half-space: springs and dashpots at one frequency in place of
/// the cone's inner rotation. The response lies in a band about that frequency: 3 %, the wave 0.1 %.
#[test]
fn equal_layers_are_the_half_space() {
    let cones = tank(Some(200.0), Some(0.6));
    let mut layers = cones.clone();
    let own = SoilLayer {
        thickness: 8.0,
        shear_wave_velocity: 200.0,
        density: 1900.0,
        poisson_ratio: 1.0 / 3.0,
        damping: 0.0,
    };
    layers.tank.subsoil = Subsoil { layers: vec![own], ..Subsoil::default() };
    let options = Options::default();
    let [a, b] = [&cones, &layers].map(|case| {
        let model = model(case, &options);
        run(case, &model, &options).values(&model, true)
    });
    for (quantity, value) in &a {
        let bound = if *quantity == Quantity::SloshingHeight { 1e-3 } else { 0.03 };
        assert!((b[quantity] / value - 1.0).abs() < bound, "{quantity:?}: {value} {}", b[quantity]);
    }
}

/// Damping of the soil and embedment lower what the wall feels, a soft layer lengthens the period; the part of the run says so.
#[test]
fn damping_embedment_and_layers_act() {
    let plain = tank(Some(200.0), Some(0.6));
    let with = |subsoil: Subsoil| {
        let mut case = plain.clone();
        case.tank.subsoil = subsoil;
        case
    };
    let soft =
        SoilLayer { thickness: 5.0, shear_wave_velocity: 120.0, density: 1800.0, poisson_ratio: 0.4, damping: 0.0 };
    let cases = [
        plain.clone(),
        with(Subsoil { damping: 0.1, ..Subsoil::default() }),
        with(Subsoil { embedment: 4.0, ..Subsoil::default() }),
        with(Subsoil { layers: vec![soft], ..Subsoil::default() }),
    ];
    let found = cases.map(|case| {
        let slab = Slab::of(&case).unwrap().unwrap();
        let model = model(&case, &Options::default());
        let mode = impulsive(&case, model.held(), &model.damper, &slab).unwrap();
        let structure = mode.structure();
        match &slab.embedded {
            Some(soil) => soil.effective(&structure).unwrap(),
            None => OnSoil::new(structure, slab.disc).unwrap().effective(::soil::disc::Impedance::Cone).unwrap(),
        }
    });
    let [plain, damped, embedded, layered] = found;
    assert!(damped.damping > plain.damping + 0.01 && (damped.period / plain.period - 1.0).abs() < 0.02);
    assert!(embedded.period < plain.period && layered.period > plain.period, "{plain:?} {embedded:?} {layered:?}");
}
