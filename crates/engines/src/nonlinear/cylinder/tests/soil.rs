//! A cylinder on a slab on soil against the linear engine, and against itself.

use tank::{Foundation, FoundationKind, SoilLayer, Subsoil};

use super::*;
use crate::linear::soil::slab_body;

/// Concrete, R = 5 m, 15 cm, elastic; 10 of 10.5 m of water on a slab of 0.6 m, on soil of this velocity [m/s] or on rigid ground.
pub(super) fn tank(velocity: Option<f64>) -> Case {
    let mut case = case(Shape::Cylinder { radius: 5.0 }, &[(10.5, 0.15)], &material(30e9, 0.2, 2500.0), (1000.0, 10.0));
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Slab,
        stiffness: None,
        shear_wave_velocity: velocity,
        soil_density: 1900.0,
        soil_poisson_ratio: 1.0 / 3.0,
        thickness: Some(0.6),
        friction: None,
    });
    shaken(case, 0.5, 150)
}

/// Small steps without numerical damping, which the linear engine does not have either.
fn precise(case: &Case, [height, circumference]: [u32; 2]) -> NonlinearOptions {
    let mut own = options(case, height, circumference);
    own.spectral_radius = 1.0;
    own.time_step = Some(1e-3);
    own
}

pub(super) fn column(found: &fe::Simulation, id: &str) -> Vec<f64> {
    let place =
        found.series.ids.iter().position(|c| c == id).unwrap_or_else(|| panic!("{id} of {:?}", found.series.ids));
    found.series.columns[place].clone()
}

pub(super) fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, v| most.max(v.abs()))
}

/// Largest difference over the largest value of the second, as far as both go.
fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let differences: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    peak(&differences) / peak(&expected[..differences.len()])
}

const SHEAR: &str = "base_shear";
const MOMENT: &str = "base_moment";
const TRANSLATION: &str = "foundation_translation";
const ROTATION: &str = "foundation_rotation";
const WAVE: &str = "wave_height_theta_0";

/// m, S and J of the tank with the liquid over its turning floor are those of the linear engine. Facets between 24 meridians have 0.3 % less wall,
/// rows of 0.6 m that interpolate pressures linearly 0.5 %: 1 %.
#[test]
fn the_slab_carries_what_it_carries_in_the_linear_engine() {
    let case = tank(Some(200.0));
    let model = CylinderModel::new(&case, &options(&case, 16, 24)).unwrap();
    let (body, _) = slab_body(&case, &fe::Options::default()).unwrap().unwrap();
    let border = model.system.border.as_ref().unwrap();
    let soil = model.slab.as_ref().unwrap().ground.trapped_inertia;
    for (i, j, expected) in
        [(0, 0, body.mass), (0, 1, body.first_moment / 5.0), (1, 1, (body.second_moment + soil) / 25.0)]
    {
        let found = 2.0 * border.own.get(i, j);
        assert!((found / expected - 1.0).abs() < 0.01, "{i} {j}: {found} {expected}");
    }
    // On the whole circle, in both directions.
    let whole = NonlinearOptions { symmetry: false, ..options(&case, 16, 24) };
    let whole = CylinderModel::new(&case, &whole).unwrap();
    let own = &whole.system.border.as_ref().unwrap().own;
    for (i, j) in [(0, 0), (0, 1), (1, 1)] {
        let half = 2.0 * border.own.get(i, j);
        for k in [0, 3] {
            assert!((own.get(i + k, j + k) / half - 1.0).abs() < 1e-9, "{i} {j} {k}");
            assert!(own.get(i + k, j + 3 - k).abs() < 1e-9 * half);
        }
    }
}

/// What the soil changes is what it changes in the linear engine, set before: shear and moment on soil over those on rigid ground, translation
/// and rotation of the slab within 2 % on a coarse mesh, and no further apart on a finer one; the balance of energy closes.
#[test]
fn soil_changes_what_it_changes_in_the_linear_engine() {
    let cases = [None, Some(200.0)].map(tank);
    let linear = fe::Options { mesh_error: false, ..fe::Options::default() };
    let [fixed, soft] = cases.each_ref().map(|case| fe::simulate(case, &linear).unwrap());
    let mut last = [0.02; 4];
    for mesh in [[12, 24], [20, 40]] {
        let [own_fixed, own_soft] = cases.each_ref().map(|case| {
            let found = simulate(case, &precise(case, mesh), None, &Silent).unwrap();
            assert_eq!(found.result.end, End::Completed);
            let energy = found.result.energy.as_ref().unwrap();
            assert!(energy.error < 1e-6, "{energy:?}");
            found
        });
        let n = own_soft.series.time.len();
        let top = |found: &fe::Simulation, id: &str| peak(&column(found, id)[..n]);
        let changed = |soft: &fe::Simulation, fixed: &fe::Simulation, id: &str| top(soft, id) / top(fixed, id);
        let mut found = Vec::new();
        for id in [SHEAR, MOMENT] {
            let expected = changed(&soft, &fixed, id);
            assert!((expected - 1.0).abs() > 0.1, "{id}: the soil does something, {expected}");
            found.push(changed(&own_soft, &own_fixed, id) / expected - 1.0);
        }
        for id in [TRANSLATION, ROTATION] {
            found.push(top(&own_soft, id) / top(&soft, id) - 1.0);
        }
        for (found, last) in found.iter().zip(&mut last) {
            assert!(found.abs() < *last, "{mesh:?}: {found} {last}");
            *last = found.abs().max(0.005);
        }
    }
}

/// Layers with an embedded slab: springs and dashpots with their coupling, as in the linear engine; 2 %.
#[test]
fn layers_act_as_in_the_linear_engine() {
    let mut case = tank(Some(300.0));
    let layer =
        SoilLayer { thickness: 4.0, shear_wave_velocity: 180.0, density: 1800.0, poisson_ratio: 0.4, damping: 0.03 };
    case.tank.subsoil = Subsoil { layers: vec![layer], embedment: 0.6, damping: 0.02 };
    let linear = fe::simulate(&case, &fe::Options { mesh_error: false, ..fe::Options::default() }).unwrap();
    let own = simulate(&case, &precise(&case, [12, 24]), None, &Silent).unwrap();
    for id in [TRANSLATION, ROTATION] {
        let found = column(&own, id);
        let expected = peak(&column(&linear, id)[..found.len()]);
        assert!((peak(&found) / expected - 1.0).abs() < 0.02, "{id}: {} {expected}", peak(&found));
    }
}

/// On soil of 1e6 m/s the flexibility is 1e-7 of that of the wall: histories are those on rigid ground within 1e-4; a step is converged to 1e-5.
#[test]
fn hard_soil_is_rigid_ground() {
    let [fixed, hard] = [None, Some(1e6)].map(|velocity| {
        let case = tank(velocity);
        simulate(&case, &options(&case, 8, 16), None, &Silent).unwrap()
    });
    for id in [SHEAR, MOMENT, WAVE, "top_displacement", "belly_displacement"] {
        let difference = apart(&column(&hard, id), &column(&fixed, id));
        assert!(difference < 1e-4, "{id}: {difference}");
    }
}

/// Half a tank, the whole, and the liquid as an operator move alike: converged to 1e-5 of a step, 1e-4 after 300.
#[test]
fn half_whole_and_operator_move_alike_on_soil() {
    let case = tank(Some(150.0));
    let own = options(&case, 8, 16);
    let whole = NonlinearOptions { symmetry: false, ..own.clone() };
    let motion = case.ground_motion.as_ref().unwrap();
    let run = |options: &NonlinearOptions, operator: bool| {
        let tank = CylinderModel::in_form(&case, options, |_| operator).unwrap();
        let cylinder = Cylinder::of(&case, options, tank).unwrap();
        let (watch, run) = cylinder.march(motion, 1.0, 2, None, &Silent).unwrap();
        assert!(run.balance.error() < 1e-4, "{}", run.balance.error());
        let [translation, rotation] = watch.foundation.unwrap();
        let kept = [0, 1, 2, translation, rotation];
        kept.map(|k| watch.recorder.histories[k].clone())
    };
    let expected = run(&own, false);
    for (options, operator) in [(&own, true), (&whole, false), (&whole, true)] {
        for (k, (found, expected)) in run(options, operator).iter().zip(&expected).enumerate() {
            let difference = apart(found, expected);
            assert!(difference < 1e-4, "{k}, operator {operator}: {difference}");
        }
    }
}
