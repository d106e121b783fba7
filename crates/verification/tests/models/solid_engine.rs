//! Source:    Sylvester's law of inertia; the harmonic engine; sums of masses
//! Goal:      the three-dimensional engine finds every mode, and answers like the harmonic one in all directions
//! Model:     tank 8.1 on coarse meshes
//! Expected:  exact counts; harmonic values
//! Tolerance: counts exact; several per cent on coarse meshes, stated at each assertion (the rows of the verification
//!            manual hold finer meshes to 1 %)

use engines::modes::Kind;
use engines::solid::model::TankModel;
use engines::solid::system::System;
use engines::solid::{self, Liquid, MeshSize, SolidOptions, spectrum};
use engines::{self, FeError, Options, Simulation};
use fem::linalg::{Pencil, Symbolic};
use fem::progress::Silent;
use tank::case::GroundMotion;
use tank::reference::broad;
use verification::potential::three_field::ThreeField;
use verification::tanks::solid_against_harmonic::artificial;

fn coarse(radial: usize, sectors: usize, vertical: usize) -> SolidOptions {
    SolidOptions { mesh: Some(MeshSize { radial, sectors, vertical }), ..SolidOptions::default() }
}

fn options() -> Options {
    Options { mesh_error: false, ..Options::default() }
}

/// All modes below a frequency, wave number by wave number, against the number of eigenvalues below it by inertia. With 12
/// sectors the wave numbers 0 and 6 have one mode each (6: sin 6θ vanishes at the nodes), the others come in pairs.
#[test]
fn no_mode_is_missed() {
    let case = broad(1000.0);
    let tank = TankModel::new(&case, &options(), &coarse(3, 12, 5)).unwrap();
    let system = System::new(&tank.model, &tank.assembler, &[], 1 << 30).unwrap();
    let mut found = Vec::new();
    for n in 0..=6 {
        let modes = spectrum::of_harmonic(&tank, &system, n, (48, 12), &Silent).unwrap();
        let twins = if n == 0 || n == 6 { 1 } else { 2 };
        found.extend(modes.into_iter().map(|m| (m.omega, m.kind, twins)));
    }
    let slow = found.iter().filter(|m| m.1 == Kind::Sloshing);
    let waves: usize = slow.map(|m| m.2).sum();
    assert_eq!(waves, tank.volume.surface_nodes.len() - 1, "one wave a surface node but for the volume");

    let mass = tank.assembler.mass(&tank.model);
    let dofs = tank.model.dofs();
    let potentials = dofs.of_kind(fem::dofs::Dof::Phi);
    let ordering = fem::assembly::order(&tank.model, tank.assembler.pattern());
    let symbolic = Symbolic::new(tank.assembler.pattern().clone(), &ordering).unwrap();
    let pencil = ThreeField::new(system.stiffness(), &mass, symbolic.into(), potentials).unwrap();
    let mut omegas: Vec<f64> = found.iter().filter(|m| m.1 == Kind::Structural).map(|m| m.0).collect();
    omegas.sort_by(f64::total_cmp);
    for k in [0, 2, 4] {
        let limit = 0.5 * (omegas[k] + omegas[k + 1]);
        let expected: usize = found.iter().filter(|m| m.0 < limit).map(|m| m.2).sum();
        assert_eq!(pencil.count_below(limit * limit).unwrap(), expected, "below {limit} rad/s");
    }
}

fn shaken(vertical: bool) -> tank::Case {
    let mut case = broad(1000.0);
    case.ground_motion = Some(GroundMotion {
        horizontal: artificial(3.0),
        transverse: None,
        vertical: vertical.then(|| artificial(4.5)),
    });
    case
}

fn series(run: &Simulation, id: &str) -> f64 {
    run.result.histories.iter().find(|s| s.id == id).map_or(f64::NAN, |s| s.peak)
}

/// Horizontal and vertical motion together, potential liquid: 24 sectors, 16 elements over the height. Coarse for the edge
/// bending; resultants carry the volume of the division, about 1 %.
#[test]
fn two_directions_agree_with_the_harmonic_engine() {
    let case = shaken(true);
    let reference = engines::simulate(&case, &options()).unwrap();
    let run = solid::simulate(&case, &options(), &coarse(8, 24, 16), &Silent).unwrap();
    for (id, tolerance) in [
        ("wave_height_theta_0", 0.03),
        ("wave_height_theta_180", 0.03),
        ("base_shear", 0.06),
        ("base_moment", 0.06),
        ("overturning_moment", 0.06),
    ] {
        let (found, expected) = (series(&run, id), series(&reference, id));
        assert!((found / expected - 1.0).abs() < tolerance, "{id}: {found} {expected}");
    }
    let first = |s: &Simulation, harmonic: u32| {
        let mut modes = s.result.modes.iter();
        modes.find(|m| m.harmonic == harmonic && m.kind == "structural").map_or(f64::NAN, |m| m.omega)
    };
    for harmonic in [0, 1] {
        let (found, expected) = (first(&run, harmonic), first(&reference, harmonic));
        assert!((found / expected - 1.0).abs() < 0.03, "m = {harmonic}: {found} {expected}");
    }
    let fields = run.result.fields.expect("pictures are made");
    assert!(fields.nodes.len() <= 2000 && !fields.modes.is_empty());
    assert!(fields.modes.iter().all(|m| m.displacement.len() == fields.nodes.len()));
    assert_eq!(fields.moments.len(), 2);
}

/// The displacement liquid: K4 of the theory of the fluid gives 3.020 rad/s in a rigid wall on 12 × 16 × 12 elements; the
/// wall lowers it by less than 0.03 %. Rotational modes are sorted out.
#[test]
fn displacement_liquid_sloshes_as_its_element_does() {
    let case = shaken(false);
    let options = options();
    let displacement = SolidOptions { liquid: Liquid::Displacement, ..coarse(12, 16, 14) };
    let run = solid::simulate(&case, &options, &displacement, &Silent).unwrap();
    let first = run.result.modes.iter().find(|m| m.kind == "sloshing").expect("it sloshes");
    assert!((first.omega / 3.020 - 1.0).abs() < 0.002, "{}", first.omega);
    let reference = engines::simulate(&case, &options).unwrap();
    for (id, tolerance) in [("wave_height_theta_0", 0.03), ("base_shear", 0.08), ("overturning_moment", 0.08)] {
        let (found, expected) = (series(&run, id), series(&reference, id));
        assert!((found / expected - 1.0).abs() < tolerance, "{id}: {found} {expected}");
    }
}

#[test]
fn too_large_a_mesh_is_refused_before_it_is_factored() {
    let small = SolidOptions { memory_limit_mib: 1, ..coarse(8, 24, 16) };
    assert!(matches!(
        solid::simulate(&shaken(false), &options(), &small, &Silent),
        Err(FeError::Memory { allowed_mib: 1, .. })
    ));
    assert!(matches!(
        solid::estimate(&shaken(false), &options(), &small).and_then(|found| found.hold(1)),
        Err(FeError::Memory { .. })
    ));
}

/// Trapezoidal rule on all unknowns of the model, liquid potentials included, against modal superposition of the reduced
/// system: independent in reduction, time integration and the liquid's elimination. 80 steps a period leave 0.05 % in the
/// period of the first wall mode; 0.5 % of the peak is allowed. The energy balance closes to rounding.
#[test]
fn direct_integration_of_all_unknowns_agrees_with_the_reduction() {
    let case = shaken(false);
    let direct = Options { integrator: engines::Integrator::Newmark, ..options() };
    let mesh = coarse(4, 12, 7);
    let modal = solid::respond(&case, &options(), &mesh, &Silent).unwrap();
    let run = solid::respond(&case, &direct, &mesh, &Silent).unwrap();
    for id in [
        "wave_height_theta_0",
        "base_shear",
        "base_moment",
        "overturning_moment",
        "axial_membrane_stress_base",
        "hoop_stress",
    ] {
        let (found, expected) = (series(&run, id), series(&modal, id));
        assert!((found / expected - 1.0).abs() < 0.005, "{id}: {found} {expected}");
    }
    let energy = run.result.energy.expect("direct integration keeps the energy balance");
    assert!(energy.error < 1e-8, "{energy:?}");
    assert!(!run.result.incomplete);
}
