//! Source:    potential flow in a rigid box; Leissa, "The free vibration of rectangular plates", J. Sound Vib. 31 (1973); PCA,
//!            "Rectangular Concrete Tanks"; Sylvester's law of inertia; the harmonic engine's strip; sums of masses
//! Goal:      the three-dimensional engine on rectangular tanks: waves, plates, static pressure, responses
//! Model:     boxes of plates with monolithic corners, clamped at the base, open at the top
//! Expected:  stated at each test
//! Tolerance: stated at each test, from the order of the elements or the digits of the tables

use std::f64::consts::PI;

use engines::modes::Kind;
use engines::solid::model::TankModel;
use engines::solid::spectrum::{self, TankMode};
use engines::solid::system::System;
use engines::solid::{self, MeshSize, SolidOptions};
use engines::{self, Integrator, Options, Simulation};
use fem::linalg::{Pencil, Symbolic};
use fem::progress::Silent;
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::reference::{GRAVITY, case, material};
use tank::{Case, Quantity, Shape};
use verification::potential::three_field::ThreeField;

/// Length, breadth, height of the walls, thickness and depth [m]; Young's modulus [Pa].
fn concrete([length, breadth, height, thickness, depth]: [f64; 5], youngs_modulus: f64) -> Case {
    let shape = Shape::Rectangle { length, breadth, strip: false };
    let material = material(youngs_modulus, 0.2, 2500.0);
    case(shape, &[(height, thickness)], &material, (1000.0, depth))
}

fn options(refine: f64) -> Options {
    Options { refine, mesh_error: false, ..Options::default() }
}

fn mesh(radial: usize, sectors: usize, vertical: usize) -> SolidOptions {
    SolidOptions { mesh: Some(MeshSize { radial, sectors, vertical }), ..SolidOptions::default() }
}

/// Poles near the first mode of the walls, which the engine itself takes.
fn model(case: &Case, options: &Options, solid: &SolidOptions, omega: f64) -> (TankModel, System) {
    let tank = TankModel::new(case, options, solid).unwrap();
    let poles = [omega * omega, 6.25 * omega * omega];
    let system = System::new(&tank.model, &tank.assembler, &poles, 1 << 32).unwrap();
    (tank, system)
}

fn parts((tank, system): &(TankModel, System), vectors: usize, most: usize) -> Vec<TankMode> {
    (0..4).flat_map(|part| spectrum::of_harmonic(tank, system, part, (vectors, most), &Silent).unwrap()).collect()
}

/// ω² = g k tanh k h, k² = (iπ/L)² + (jπ/B)², odd i in part 1, odd j in part 2, both in part 3. The quadratic form of linear elements
/// of length h overestimates k² of a cosine by (k h)²/12, along each direction: ω by half of it at most; twice that is allowed for the
/// depth. Elements here are 1/8 of a side, and the errors fall with the square of that.
#[test]
fn waves_of_a_rigid_box_in_both_directions() {
    let (length, breadth, depth) = (10.0, 6.0, 4.0);
    let rigid = concrete([length, breadth, 4.5, 1.0, depth], 3e13);
    let error = |n: usize| -> Vec<f64> {
        let model = model(&rigid, &options(1.0), &mesh(n, 2 * n, 2 * n), 1e4);
        let found = parts(&model, 60, 3);
        let wave = |i: u32, j: u32| {
            let k = PI * (f64::from(i) / length).hypot(f64::from(j) / breadth);
            let exact = (GRAVITY * k * (k * depth).tanh()).sqrt();
            let of_part = found.iter().filter(|m| m.harmonic == i % 2 + 2 * (j % 2) && m.kind == Kind::Sloshing);
            of_part.map(|m| m.omega / exact - 1.0).fold(1.0, |a: f64, b| if b.abs() < a.abs() { b } else { a })
        };
        [(1, 0), (0, 1), (1, 1), (2, 0), (3, 0)].map(|(i, j)| wave(i, j)).to_vec()
    };
    let (coarse, fine) = (error(4), error(8));
    for (k, (i, j)) in [(1, 0), (0, 1), (1, 1), (2, 0), (3, 0)].into_iter().enumerate() {
        let step = PI / 16.0 * f64::from(i.max(j));
        assert!(fine[k] > 0.0 && fine[k] < step * step / 12.0, "{i} {j}: {fine:?}");
        let ratio = coarse[k] / fine[k];
        assert!((3.0..5.5).contains(&ratio), "{i} {j}: {coarse:?} {fine:?}");
    }
}

/// Every eigenvalue below a frequency is found: one wave a node of the surface but for the volume, and the walls'.
#[test]
fn no_mode_is_missed() {
    let case = concrete([6.0, 5.0, 4.0, 0.3, 3.0], 30e9);
    let model = model(&case, &options(1.0), &mesh(2, 4, 5), 150.0);
    let found = parts(&model, 90, 6);
    let (tank, system) = &model;
    let mass = tank.assembler.mass(&tank.model);
    let potentials = tank.model.dofs().of_kind(fem::dofs::Dof::Phi);
    let ordering = fem::assembly::order(&tank.model, tank.assembler.pattern());
    let symbolic = Symbolic::new(tank.assembler.pattern().clone(), &ordering).unwrap();
    let pencil = ThreeField::new(system.stiffness(), &mass, symbolic.into(), potentials).unwrap();
    let mut walls: Vec<f64> = found.iter().filter(|m| m.kind == Kind::Structural).map(|m| m.omega).collect();
    walls.sort_by(f64::total_cmp);
    for k in [0, 3] {
        let limit = 0.5 * (walls[k] + walls[k + 1]);
        let waves = tank.volume.surface_nodes.len() - 1;
        assert_eq!(pencil.count_below(limit * limit).unwrap(), waves + k + 1, "{walls:?}");
    }
}

/// Walls of a square box without liquid that matters (a millionth of the walls' mass). Modes even about both planes: neighbours in
/// opposite phase turn their corner freely, the plate is C-S-F-S, ω a² √(ρ t/D) = 12.687; all in phase keep it by symmetry, C-C-F-C,
/// 24.020 (Leissa, a/b = 1, ν = 0.3, thin plates). Tolerance 1 %: 20 elements over a side have (π/20)²/12 = 0.2 % for one half wave and
/// some times that beside clamped edges; shear at t/a = 1/100 and the membrane stiffness of the walls that hold the corners 0.1 %.
#[test]
fn plates_of_a_dry_square_box() {
    let (side, thickness) = (5.0, 0.05);
    let shape = Shape::Rectangle { length: side, breadth: side, strip: false };
    let material = material(30e9, 0.3, 2500.0);
    let dry = case(shape, &[(side, thickness)], &material, (1e-4, 4.0));
    let rigidity = 30e9 * thickness.powi(3) / (12.0 * (1.0 - 0.09));
    let unit = (rigidity / (2500.0 * thickness)).sqrt() / (side * side);
    let model = model(&dry, &options(1.0), &mesh(10, 20, 20), 15.0 * unit);
    // Modes odd about both planes are not compared.
    let of = |part| spectrum::of_harmonic(&model.0, &model.1, part, (120, 3), &Silent).unwrap();
    let found: Vec<TankMode> = (0..3).flat_map(of).collect();
    let walls: Vec<&TankMode> = found.iter().filter(|m| m.kind == Kind::Structural).collect();
    let even: Vec<f64> = walls.iter().filter(|m| m.harmonic == 0).map(|m| m.omega / unit).collect();
    for expected in [12.687, 24.020] {
        assert!(even.iter().any(|l| (l / expected - 1.0).abs() < 0.01), "{expected}: {even:?}");
    }
    // x and y are one: rounding, and the squares of the residuals.
    let first = |part: u32| walls.iter().find(|m| m.harmonic == part).map_or(f64::NAN, |m| m.omega);
    assert!((first(1) / first(2) - 1.0).abs() < 1e-5, "{} {}", first(1), first(2));
}

/// First mode along x of a square box of 5 m, walls of 4 m and 30 cm, 3.5 m of water, against Ritz' method (docs/theory/solid-box.md,
/// section 7: polynomials over the walls, series of potential flow in the liquid): 0.03562 s with shear and stretching of the walls, 0.03359 s
/// without. A tenth of the thickness with the same rigidity and mass per area takes both away but for 1/100. EN 1998-4 A.4, clamped
/// sides, gives 0.02834 s: corners turn. Tolerance 1 %, as of dry plates on this mesh.
#[test]
fn corners_turn_in_the_first_mode_of_a_square_box() {
    for (scale, expected) in [(1.0, 0.035_62), (0.1_f64, 0.033_59)] {
        let shape = Shape::Rectangle { length: 5.0, breadth: 5.0, strip: false };
        let material = material(30e9 / scale.powi(3), 0.2, 2500.0 / scale);
        let case = case(shape, &[(4.0, 0.3 * scale)], &material, (1000.0, 3.5));
        let model = model(&case, &options(1.0), &mesh(10, 20, 30), 180.0);
        let found = spectrum::of_harmonic(&model.0, &model.1, 1, (80, 3), &Silent).unwrap();
        let walls = found.iter().filter(|m| m.kind == Kind::Structural);
        let period = walls.map(|m| 2.0 * PI / m.omega).fold(0.0, f64::max);
        assert!((period / expected - 1.0).abs() < 0.01, "{scale}: {period} s, {expected} s");
    }
}

/// A pulse of 2 s and a tail.
fn shaken(mut case: Case, vertical: bool) -> Case {
    let record = |factor: f64| Record {
        name: "pulse".into(),
        dt: 0.02,
        acceleration: (0..200)
            .map(|k| {
                let t = 0.02 * f64::from(k);
                let swell = (PI * t / 2.0).sin().max(0.0) * f64::from(u8::from(t < 2.0));
                factor * swell * ((2.0 * PI * 0.25 * t).sin() + (2.0 * PI * 5.0 * t).sin())
            })
            .collect(),
        processing: Vec::new(),
    };
    case.ground_motion =
        Some(GroundMotion { horizontal: record(1.0), transverse: None, vertical: vertical.then(|| record(0.6)) });
    case
}

fn respond(case: &Case, options: &Options, solid: &SolidOptions) -> Simulation {
    solid::respond(case, options, solid, &Silent).unwrap()
}

fn envelope<'a>(run: &'a Simulation, id: &str) -> &'a results::Envelope {
    run.result.envelopes.iter().find(|e| e.id == id).unwrap()
}

/// Full square boxes: by symmetry the corners do not turn, and every wall is clamped at three edges. Moment at the middle of the base
/// over ρ g H³: 0.035, 0.086, 0.126 for breadth over height of 1, 2, 3 (PCA, ν = 0.2). Tolerance: half a digit of the table, 1 % for its
/// unstated method, 2 % for elements of H/24 beside the clamped edge.
#[test]
fn static_pressure_against_pca() {
    for (ratio, expected) in [(1.0, 0.035), (2.0, 0.086), (3.0, 0.126)] {
        let height = 4.0;
        let case = shaken(concrete([ratio * height, ratio * height, height, 0.2, height], 30e9), false);
        let run = respond(&case, &options(1.0), &mesh(10, 20, 24));
        let base = run.result.histories.iter().find(|s| s.id == "wall_moment_base").unwrap();
        let found = base.static_value.abs() / (1000.0 * GRAVITY * height.powi(3));
        assert!((found - expected).abs() < 0.0005 + 0.03 * expected, "{ratio}: {found} {expected}");
        // The line of the plate tends to the reaction, half an element above the base.
        let line = envelope(&run, "wall_moment").static_[0];
        assert!((line / base.static_value - 1.0).abs() < 0.05, "{line} {}", base.static_value);
        // Equilibrium by the sides: the corner pulls on the inner face, the middle on the outer one.
        let middle = envelope(&run, "horizontal_moment").static_.iter().copied().fold(0.0, f64::max);
        let corner = envelope(&run, "corner_moment").static_.iter().copied().fold(0.0, f64::min);
        assert!(corner < 0.0 && middle > 0.0 && corner.abs() > middle, "{corner} {middle}");
    }
}

/// Rigid walls: first convective mass 8 tanh(α h)/(α h π²), α = π/L, and all masses together (EN 1998-4 A.4, Graham and Rodriguez). One
/// linear element has (π/20)²/12 = 0.2 % in the frequency and four times that in tanh and masses.
#[test]
fn masses_of_a_rigid_box() {
    let (length, depth) = (10.0, 4.0);
    let case = shaken(concrete([length, 6.0, 4.5, 1.0, depth], 3e13), false);
    let run = respond(&case, &options(1.0), &mesh(10, 8, 16));
    let alpha = PI / length;
    let convective = 8.0 * (alpha * depth).tanh() / (alpha * depth * PI * PI);
    let mass = case.liquid_mass();
    let found = run.values[&Quantity::ConvectiveMass] / mass;
    assert!((found / convective - 1.0).abs() < 0.008, "{found} {convective}");
    // The record moves a rigid translation by all of the mass.
    for balance in &run.result.mass_balance {
        assert!(balance.error.abs() < 1e-9, "{balance:?}");
    }
    // Base moment of the first mode over its shear: h (1 − (cosh αh − 1)/(αh sinh αh)); the bottom adds (cosh αh − 1)/…
    let part = run.result.modal.iter().find(|m| m.kind == "sloshing" && m.number == 1).unwrap();
    let x = alpha * depth;
    let above = depth * (1.0 - (x.cosh() - 1.0) / (x * x.sinh()));
    let below = depth * (1.0 - (x.cosh() - 2.0) / (x * x.sinh()));
    let [found, under] = [part.total.moment, part.total.overturning].map(|m| m / part.total.shear);
    assert!((found / above - 1.0).abs() < 0.01, "{found} {above}");
    assert!((under / below - 1.0).abs() < 0.01, "{under} {below}");
}

/// A channel 16 heights broad against the strip: its walls are cantilevers but for a height or two at each end. The first mode of plates is
/// 1 % above the strip's and the shear, in which modes of more waves share, within 5 %; the walls along the shaking follow the ground in
/// the strip and nearly so here.
#[test]
fn a_channel_is_a_strip() {
    let height = 4.0;
    let case = shaken(concrete([10.0, 16.0 * height, height, 0.4, 3.0], 30e9), false);
    // The first wave alone: of waves with five to nine half waves, 20 linear elements get the frequencies wrong by per cents.
    let options = Options { wave_modes: 1, ..options(1.0) };
    let strip = engines::simulate(&case, &options).unwrap();
    let plates = respond(&case, &options, &SolidOptions::default());
    let mut apart = Vec::new();
    for (quantity, tolerance) in [
        (Quantity::SloshingPeriod, 0.005),
        (Quantity::SloshingHeight, 0.02),
        (Quantity::ImpulsivePeriod, 0.03),
        (Quantity::BaseShear, 0.05),
        (Quantity::BaseMoment, 0.05),
        (Quantity::OverturningMoment, 0.05),
        (Quantity::BendingStress, 0.05),
    ] {
        let (a, b) = (plates.values[&quantity], strip.values[&quantity]);
        if (a / b - 1.0).abs() > tolerance {
            apart.push(format!("{quantity:?}: {a} {b}"));
        }
    }
    assert!(apart.is_empty(), "{apart:?}");
}

/// Direct integration of all unknowns against modal superposition, energy balance, and a vertical record: without a horizontal one both
/// sides move alike.
#[test]
fn newmark_against_modes_and_the_vertical_motion() {
    // Soft walls and few elements: the steps follow the fastest mode that carries a hundredth of the mass.
    let base = concrete([6.0, 5.0, 4.0, 0.3, 3.0], 1e9);
    let coarse = mesh(2, 4, 5);
    let mut case = shaken(base.clone(), false);
    if let Some(motion) = &mut case.ground_motion {
        motion.horizontal.acceleration.truncate(50);
    }
    let modal = respond(&case, &options(1.0), &coarse);
    let newmark = Options { integrator: Integrator::Newmark, ..options(1.0) };
    let direct = respond(&case, &newmark, &coarse);
    // Average acceleration with a hundred steps in the first period of the walls: (2π/100)²/12 of the period.
    for quantity in [Quantity::SloshingHeight, Quantity::BaseShear, Quantity::OverturningMoment] {
        let (a, b) = (direct.values[&quantity], modal.values[&quantity]);
        assert!((a / b - 1.0).abs() < 0.01, "{quantity:?}: {a} {b}");
    }
    let energy = direct.result.energy.as_ref().unwrap();
    assert!(energy.error.abs() < 1e-6, "{energy:?}");

    let mut up = shaken(base, true);
    if let Some(motion) = &mut up.ground_motion {
        motion.horizontal.acceleration.iter_mut().for_each(|a| *a *= 1e-9);
    }
    let run = respond(&up, &options(1.0), &coarse);
    let extreme = |id: &str| envelope(&run, id).max.iter().copied().fold(0.0, f64::max);
    // The pressure of a rigid box is ρ a (H − z), 3000 Pa at the base for 1 m/s²: walls that give way add to it.
    let peak = up.ground_motion.as_ref().and_then(|m| m.vertical.as_ref()).unwrap().pga();
    let rigid = 1000.0 * 3.0 * peak;
    assert!((0.9..2.5).contains(&(extreme("pressure") / rigid)), "{} {rigid}", extreme("pressure"));
    assert!(extreme("horizontal_moment") > 0.0);
    // Of the wave only second order of the walls' motion is left, of the shear nothing.
    let shear = run.result.histories.iter().find(|s| s.id == "base_shear").unwrap();
    assert!(shear.peak.abs() < 1e-6 * rigid, "{}", shear.peak);
}

/// A strip has no corners, the displacement liquid no box: both are refused with the way out; so is an odd division of the breadth.
#[test]
fn what_is_not_modelled_is_refused() {
    let mut strip = concrete([6.0, 1.0, 4.0, 0.3, 3.0], 30e9);
    strip.tank.shape = Shape::Rectangle { length: 6.0, breadth: 1.0, strip: true };
    let refused = |case: &Case, solid: &SolidOptions| match TankModel::new(case, &options(1.0), solid) {
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    };
    assert!(refused(&strip, &SolidOptions::default()).contains("--fe harmonic"));
    let case = concrete([6.0, 5.0, 4.0, 0.3, 3.0], 30e9);
    let displacement = SolidOptions { liquid: solid::Liquid::Displacement, ..SolidOptions::default() };
    assert!(refused(&case, &displacement).contains("--liquid potential"));
    assert!(refused(&case, &mesh(4, 5, 6)).contains("even"));
}
