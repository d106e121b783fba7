//! The engine on isolators against an independent program, its own fixed base, and one component along a diagonal.

use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

use super::*;
use crate::Simulation;
use crate::harmonic::{Places, test_tanks};
use crate::linear::simulate;
use results::Part;
use tank::options::linear::Integrator;

/// El Centro NS, the first 30 s, times `scale`.
fn el_centro(scale: f64) -> Record {
    let text = include_str!("../../../../../examples/records/elcentro.csv");
    let numbers = text.lines().filter_map(|line| line.split_once(',')?.1.trim().parse::<f64>().ok());
    Record {
        name: "El Centro".into(),
        dt: 0.02,
        acceleration: numbers.take(1501).map(|a| scale * 9.81 * a).collect(),
        processing: Vec::new(),
    }
}

const SLAB: f64 = 2400.0 * 0.6 * PI * 400.0;

/// Tank C of the sheet: 40 m wide, 15 m of oil of 870 kg/m³, wall and roof of 21 350 N/m, on a slab of 0.6 m.
fn tank(scale: f64) -> Case {
    let courses = [(5.0, 0.025), (5.0, 0.017), (6.5, 0.010)];
    let shape = Shape::Cylinder { radius: 20.0 };
    let mut case = test_tanks::case(shape, &courses, (205e9, 0.3, 7850.0), (870.0, 15.0));
    let wall: f64 = courses.iter().map(|(h, t)| h * t * 7850.0 * TAU * 20.0).sum();
    case.tank.roof.mass = 21_350.0 * TAU * 20.0 / 9.81 - wall;
    assert!(case.tank.roof.mass > 0.0);
    case.ground_motion = Some(GroundMotion { horizontal: el_centro(scale), transverse: None, vertical: None });
    case
}

/// Mass of liquid, wall, roof and slab [kg].
fn mass() -> f64 {
    870.0 * 15.0 * PI * 400.0 + 21_350.0 * TAU * 20.0 / 9.81 + SLAB
}

fn isolated(mut case: Case, bearing: Bearing) -> Case {
    case.tank.isolators = Some(Isolators {
        bearing,
        damper: None,
        slab_mass: SLAB,
        slab_thickness: 0.6,
        bounds: [0.6, 1.8],
        displacement_capacity: None,
    });
    case
}

fn rubber() -> Bearing {
    let yielded = mass() * (TAU / 2.5).powi(2);
    Bearing::LeadRubber { strength: 0.05 * mass() * 9.81, initial: 10.0 * yielded, yielded }
}

fn pendulum() -> Bearing {
    Bearing::FrictionPendulum { radius: 2.2365, friction: 0.05, slow: 0.05, rate: 0.0, slip: 1e-3 }
}

fn run(case: &Case) -> Simulation {
    let options = Options { mesh_error: false, ..Options::default() };
    simulate(case, &options).unwrap()
}

fn part(simulation: &Simulation) -> &Part {
    simulation.result.part("isolation").unwrap()
}

fn value(simulation: &Simulation, id: &str) -> f64 {
    part(simulation).value(id).unwrap().value.value
}

/// The body of the engine with its first sloshing mode alone, which is what the sheet's program has: base and force 3 %, impulsive acceleration
/// and wave 5 %, the tolerances of the sheet. Base displacement and impulsive acceleration on pendulums follow details that the sheet does not
/// state (verification I4), and are not held. Neither is the impulsive acceleration: at scale 1 the sheet's 0.184 g is 5 % above its own equations by Runge
/// and Kutta's method (0.175 g; verification I6, I8), and the wall of the engine has several modes. Rows: scale, bearings, base [m], force over weight, impulsive acceleration over g, wave [m].
#[test]
fn el_centro_agrees_with_the_independent_program() {
    for (scale, bearing, base, force, impulsive, wave) in [
        (1.0, rubber(), Some(53.5e-3), 0.085, None, 0.747),
        (2.0, rubber(), Some(134.7e-3), 0.137, None, 1.491),
        (1.0, pendulum(), None, 0.069, None, 0.671),
        (2.0, pendulum(), None, 0.114, None, 1.282),
    ] {
        let case = isolated(tank(scale), bearing);
        let options = Options::default();
        let model = Model::new(&case, &options, false, Places::Usual).unwrap();
        let (motion, given) = (case.ground_motion.as_ref().unwrap(), case.tank.isolators.unwrap());
        let grid = model.grid(motion, Integrator::Modal).unwrap();
        let mut setup = Setup::new(&case, &model, &given, grid, motion, &options);
        let first = setup.modes.iter().map(|m| m.omega).fold(f64::INFINITY, f64::min);
        // Sloshing is slower than 1 s, the wall faster.
        setup.modes.retain(|m| m.omega == first || m.omega > TAU);
        let history = setup.march(&setup.isolators(&given, 1.0), &[]).unwrap();
        let wall = (setup.modes.iter().enumerate().filter(|(_, m)| m.omega > TAU))
            .max_by(|a, b| a.1.mass.total_cmp(&b.1.mass))
            .unwrap()
            .0;
        let sloshing = setup.modes.iter().position(|m| m.omega == first).unwrap();
        let most = |values: Vec<[f64; 2]>| isolated::peak(&values);
        let rows = [
            (isolated::peak(&history.displacement), base, 0.03),
            (isolated::peak(&history.force) / (mass() * 9.81), Some(force), 0.03),
            (most(history.modes[wall].iter().map(|s| s.acceleration).collect()) / 9.81, impulsive, 0.05),
            (
                0.837 * 20.0 * first * first / 9.81
                    * most(history.modes[sloshing].iter().map(|s| s.displacement).collect()),
                Some(wave),
                0.05,
            ),
        ];
        for (found, expected, tolerance) in rows {
            println!("{scale} {found} of {expected:?}");
            if let Some(expected) = expected {
                assert!((found / expected - 1.0_f64).abs() < tolerance, "{found} of {expected}");
            }
        }
    }
}

/// A whole run: mass, balance of the march (exact in the method), two integrations of one body at 1 ms within 1 %, bounds, and the motion's
/// place in the histories.
#[test]
fn a_run_closes() {
    let simulation = run(&isolated(tank(1.0), pendulum()));
    let isolation = part(&simulation);
    assert!((isolation.said("isolation-isolators", "mass").unwrap() / mass() - 1.0).abs() < 1e-6);
    assert!(isolation.said("isolation-balance", "error").unwrap() < 1e-9);
    let superposition = isolation.said("isolation-balance", "superposition").unwrap();
    assert!(superposition < 0.01, "{superposition}");
    let band = isolation.table("band").unwrap();
    assert_eq!(band.column("factor"), [0.6, 1.0, 1.8]);
    let nominal = |id| band.column(id)[1];
    assert_eq!(nominal("isolator_displacement"), value(&simulation, "isolator_displacement"));
    assert_eq!(nominal("base_shear"), simulation.values[&Quantity::BaseShear]);
    let force = band.column("isolator_force");
    assert!(force[2] > force[0]);
    // Isolation lowers the shear several times; the wave goes its way.
    assert!(simulation.values[&Quantity::BaseShear] < 0.5 * isolation.held()["base_shear"]);
    let columns = simulation.series.columns.iter().map(Vec::len);
    assert!(columns.into_iter().all(|length| length == simulation.series.time.len()));
    assert!((simulation.series.time[1] - 0.02).abs() < 1e-12);
}

/// Springs on which the whole tank swings at 100 times the frequency of the wall: what remains is (ω_i/ω_b)² = 1e-4, and the step of the march.
#[test]
fn very_stiff_isolators_are_a_fixed_base() {
    let still = run(&tank(1.0));
    let omega = TAU / still.values[&Quantity::ImpulsivePeriod];
    let stiff = Bearing::Elastomer { stiffness: 1e4 * mass() * omega * omega, damping: 0.3 };
    let simulation = run(&isolated(tank(1.0), stiff));
    for (quantity, expected) in &still.values {
        let found = simulation.values[quantity];
        assert!((found / expected - 1.0).abs() < 1e-3, "{quantity:?}: {found} of {expected}");
        if let Some(fixed) = part(&simulation).held().get(quantity.id()) {
            assert_eq!(fixed, expected);
        }
    }
    assert_eq!(simulation.series.time.len(), still.series.time.len());
    assert!(value(&simulation, "isolator_displacement") < 1e-5);
}

/// The law and the tank know no direction: a record along a diagonal moves both components by 1/√2, to rounding of the march.
#[test]
fn a_diagonal_motion_is_that_of_one_component() {
    let one = run(&isolated(tank(1.0), rubber()));
    let mut case = isolated(tank(FRAC_1_SQRT_2), rubber());
    if let Some(motion) = &mut case.ground_motion {
        motion.transverse = Some(motion.horizontal.clone());
    }
    let both = run(&case);
    for id in ["isolator_displacement", "isolator_force", "bearing_share"] {
        let (found, expected) = (value(&both, id), value(&one, id));
        assert!((found / expected - 1.0).abs() < 1e-8, "{id}: {found} of {expected}");
    }
    let demands = both.demands.unwrap();
    let (wave, expected) = (demands.wave.unwrap().value, one.demands.unwrap().wave.unwrap().value);
    assert!((wave / expected - 1.0).abs() < 3e-3, "{wave} of {expected}");
}

/// C = 2 ξ m ω: the effective ratio is that given, 1e-8 by the quadrature of the cycle; the period that of mass on stiffness.
#[test]
fn a_linear_damper_has_its_ratio() {
    let case = isolated(tank(1.0), Bearing::Elastomer { stiffness: mass() * (TAU / 2.5).powi(2), damping: 0.0 });
    let mut damped = case.clone();
    if let Some(isolators) = &mut damped.tank.isolators {
        isolators.damper = Some([2.0 * 0.2 * mass() * TAU / 2.5, 1.0]);
    }
    let run = run(&damped);
    assert!((value(&run, "effective_damping") / 0.2 - 1.0).abs() < 1e-8);
    assert!((value(&run, "effective_period") / 2.5 - 1.0).abs() < 1e-9);
}
