//! The nonlinear cylinder against the linear engine, against itself on the whole circle, and against itself resumed.

mod base_elements;
mod curve;
mod imperfect;
mod isolators;
mod opening;
mod resume;
mod soil;
mod standing;
mod two;

use std::sync::atomic::{AtomicU64, Ordering};

use fem::element::reference_mass;
use fem::linalg::dot;
use fem::progress::{Progress, Silent};
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::{BarDirection, Behaviour, Concrete, ConcreteLaw, Layer, LayerKind, Material, Reinforcement, Softening};
use tank::{Case, Quantity};
use tank::{Course, Shape, Support};

use super::super::{CheckpointFile, simulate};
use super::march::Cylinder;
use super::model::CylinderModel;
use crate as fe;
use results::nonlinear::End;
use tank::options::AfterRecord;
use tank::options::nonlinear::{Contact, NonlinearOptions, WallElements};
use tank::reference::{case, material};

/// An aluminium tank, R = 1.83 m, 3 mm; filled to 1.5 of 1.8 m.
fn elastic() -> Case {
    case(Shape::Cylinder { radius: 1.83 }, &[(1.8, 3e-3)], &material(69e9, 0.32, 2750.0), (1000.0, 1.5))
}

/// A shock that excites wall and liquid.
fn shaken(mut case: Case, acceleration: f64, samples: usize) -> Case {
    let of = |i: usize| {
        let t = 0.01 * i as f64;
        acceleration * ((40.0 * t).sin() * (-6.0 * t).exp() + 0.3 * (2.6 * t).sin())
    };
    let record =
        Record { name: "shock".into(), dt: 0.01, acceleration: (0..samples).map(of).collect(), processing: Vec::new() };
    case.ground_motion = Some(GroundMotion { horizontal: record, transverse: None, vertical: None });
    case
}

/// Without free vibration, which most of these tests do not need.
fn options(case: &Case, height: u32, circumference: u32) -> NonlinearOptions {
    NonlinearOptions {
        elements: Some(WallElements { height, circumference }),
        after_record: AfterRecord::NONE,
        ..NonlinearOptions::new(case.damping)
    }
}

/// A rigid translation of wall, base and liquid carries the mass of all of them. Flat facets between 24 meridians are
/// shorter than their arcs by 0.3 % of the wall's mass, which is 1 % of the whole: 1e-4.
#[test]
fn translation_carries_everything() {
    let mut case = elastic();
    case.tank.roof.mass = 800.0;
    // More than the rest of the wall together, at and between levels of nodes.
    crate::harmonic::test_tanks::fit(&mut case, (1.2, 4e-3, 1e-6), (0.777, 200.0));
    let tank = CylinderModel::new(&case, &options(&case, 8, 24)).unwrap();
    let mass: f64 = tank
        .model
        .elements()
        .iter()
        .map(|element| {
            let element = &**element;
            let mut w = Vec::new();
            for (local, &node) in element.nodes().iter().enumerate() {
                let global = match (element.own_axes(), tank.model.frame(node)) {
                    (true, Some(f)) => [f[(0, 0)], f[(1, 0)], f[(2, 0)]],
                    _ => [1.0, 0.0, 0.0],
                };
                w.extend(element.dofs(local).iter().map(|d| global.get(d.index()).copied().unwrap_or(0.0)));
            }
            dot(&w, &reference_mass(element).to_matrix().times(&w))
        })
        .sum();
    let exact = case.liquid_mass() + case.tank.wall_mass() + 800.0;
    assert!((2.0 * mass / exact - 1.0).abs() < 1e-4, "{} {exact}", 2.0 * mass);
}

/// Under weak shaking an elastic tank responds as in the linear engine. The liquid is the same; the wall is another element
/// (flat shells on 48 sectors and 24 rows), whose discretisation costs 1 to 2 % of stresses (theory of the shell element); the
/// geometric stiffness of the hydrostatic pressure, which the linear engine leaves out, raises the frequency by less than 1 %.
/// Ten periods later that is up to half a radian of phase, by which histories of a wall that rings down part further: 8 %.
#[test]
fn small_shaking_is_linear() {
    let case = shaken(elastic(), 0.05, 60);
    let linear_options = fe::Options { integrator: fe::Integrator::Modal, mesh_error: false, ..fe::Options::default() };
    let linear = fe::simulate(&case, &linear_options).unwrap();
    let mut own = options(&case, 24, 48);
    own.spectral_radius = 1.0;
    own.time_step = Some(0.001);
    let nonlinear = simulate(&case, &own, None, &Silent).unwrap();
    assert_eq!(nonlinear.result.end, End::Completed);
    let within = |q: Quantity, tolerance: f64| {
        let (a, b) = (nonlinear.values[&q], linear.values[&q]);
        assert!((a / b - 1.0).abs() < tolerance, "{q:?}: {a}, expected {b}");
    };
    within(Quantity::ImpulsivePeriod, 0.01);
    within(Quantity::SloshingPeriod, 0.005);
    within(Quantity::BaseMoment, 0.03);
    // The mean of a cell is compared with the largest point of a meridian.
    within(Quantity::HoopStress, 0.06);
    // The linear run continues in free vibration, where the wave may grow: compare histories until then.
    let column = |s: &fe::Simulation, id: &str| -> Vec<f64> {
        let i = s.series.ids.iter().position(|c| c == id).unwrap();
        s.series.columns[i].clone()
    };
    for (id, tolerance) in [("base_shear", 0.04), ("wave_height_theta_0", 0.05), ("base_moment", 0.04)] {
        let (a, b) = (column(&nonlinear, id), column(&linear, id));
        let n = a.len().min(b.len());
        let largest = b[..n].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let apart = (0..n).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
        assert!(apart < tolerance * largest, "{id}: {apart} of {largest}");
    }
    // Statically the membrane carries ρ g (H − z) R, away from base and surface.
    let hoop = nonlinear.result.envelopes.iter().find(|e| e.id == "hoop_stress").unwrap();
    let (z, stress) = hoop.z.iter().zip(&hoop.static_).find(|(z, _)| **z > 0.6).map(|(z, s)| (*z, *s)).unwrap();
    let exact = 1000.0 * case.gravity * (1.5 - z) * 1.83 / 3e-3;
    assert!((stress / exact - 1.0).abs() < 0.02, "{stress} {exact} at {z}");
    assert!(nonlinear.result.nonlinear.unwrap().energies.error < 1e-3);
}

/// After the record the history goes on as without ground motion: up to its end it is that of a run without free vibration, bit
/// by bit, and the wave that rises after it is that of the linear engine, which is another wall and another integration over the
/// same two periods. The wave is the liquid's alone (the wall is 26 times as fast); 16 facets of the circle have 2.6 % less area
/// under the waves, less where they act on the first of them: 3 %.
#[test]
fn free_vibration_after_the_record_is_that_of_the_linear_engine() {
    let case = shaken(elastic(), 0.05, 60);
    let none = options(&case, 8, 16);
    let own = NonlinearOptions { after_record: AfterRecord::DEFAULT, ..none.clone() };
    let [short, long] = [&none, &own].map(|o| simulate(&case, o, None, &Silent).unwrap());
    assert_eq!((short.result.record_end, long.result.record_end), (None, Some(0.59)));
    let n = short.series.time.len();
    assert_eq!(n, 60);
    for (a, b) in short.series.columns.iter().zip(&long.series.columns) {
        assert_eq!(a[..], b[..n]);
    }
    let end = 0.59 + 2.0 * long.values[&Quantity::SloshingPeriod];
    let last = *long.series.time.last().unwrap();
    assert!((0.0..=0.011).contains(&(last - end)), "{last} {end}");
    let linear = fe::simulate(&case, &fe::Options { mesh_error: false, ..fe::Options::default() }).unwrap();
    let wave = |s: &fe::Simulation| s.values[&Quantity::SloshingHeight];
    assert!(wave(&long) > 1.1 * wave(&short), "{} {}", wave(&long), wave(&short));
    assert!((wave(&long) / wave(&linear) - 1.0).abs() < 0.03, "{} {}", wave(&long), wave(&linear));
}

fn concrete(name: &str) -> Material {
    Material {
        name: name.into(),
        behaviour: Behaviour::Concrete(Concrete {
            law: ConcreteLaw::Cracked,
            compressive_strength: 30e6,
            characteristic_strength: None,
            biaxial_ratio: 1.16,
            tensile_strength: 2e6,
            softening: Softening::FractureEnergy(100.0),
            shear_retention: 0.1,
            shear_retention_strain: 2e-4,
            tension_stiffening: 0.0,
            crack_spacing: Some(0.15),
            envelope: tank::BiaxialEnvelope::default(),
            bond: tank::BarBond::Perfect,
        }),
        ..material(30e9, 0.2, 2500.0)
    }
}

/// A concrete tank, R = 8 m, 20 cm, that cracks when it is shaken.
fn cracking() -> Case {
    let bars = |direction, depth| Reinforcement {
        direction,
        area: 8e-4,
        depth,
        diameter: None,
        prestress: 0.0,
        material: Material {
            behaviour: Behaviour::Reinforcement(tank::Bar {
                yield_strength: 500e6,
                tangent_modulus: 1e9,
                rupture_strain: None,
            }),
            ..material(200e9, 0.3, 7850.0)
        },
    };
    let layer = Layer {
        kind: LayerKind::Shell,
        thickness: 0.2,
        material: concrete("concrete"),
        reinforcement: vec![
            bars(BarDirection::Hoop, 0.04),
            bars(BarDirection::Vertical, 0.04),
            bars(BarDirection::Hoop, 0.16),
            bars(BarDirection::Vertical, 0.16),
        ],
    };
    let mut case = case(Shape::Cylinder { radius: 8.0 }, &[(5.0, 0.2)], &material(30e9, 0.2, 2500.0), (1000.0, 4.5));
    case.tank.courses = vec![Course::layered(5.0, vec![layer])];
    case
}

/// Half of the tank is the whole. A step ends with a residual of up to 1e-4 of the forces, and a crack that opens passes it on
/// to the next: 1e-3 of the largest value after 50 steps or so; a wrong half differs by its order of magnitude.
#[test]
fn half_is_the_whole() {
    let case = shaken(cracking(), 12.0, 25);
    let mut own = options(&case, 6, 16);
    let half = simulate(&case, &own, None, &Silent).unwrap();
    own.symmetry = false;
    let whole = simulate(&case, &own, None, &Silent).unwrap();
    for id in ["base_shear", "base_moment", "wave_height_theta_180", "belly_displacement"] {
        let column = |s: &fe::Simulation| {
            let i = s.series.ids.iter().position(|c| c == id).unwrap();
            s.series.columns[i].clone()
        };
        let (a, b) = (column(&half), column(&whole));
        let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let apart = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-3 * largest, "{id}: {apart} of {largest}");
    }
    // It has cracked, and the mirrored halves have the same cracks.
    let cracks = |s: &fe::Simulation| -> f64 {
        let nonlinear = s.result.nonlinear.as_ref().unwrap();
        let maps = nonlinear.maps.iter().filter(|m| m.id.starts_with("crack_width"));
        maps.flat_map(|m| m.values.iter().copied()).fold(0.0, f64::max)
    };
    assert!(cracks(&half) > 1e-6);
    assert!((cracks(&half) / cracks(&whole) - 1.0).abs() < 1e-2);
}

/// Stops after a number of steps.
struct StopAfter {
    left: AtomicU64,
}

impl Progress for StopAfter {
    fn stage(&self, _name: &str, _steps: u64) {}

    fn advance(&self, steps: u64) {
        let left = self.left.load(Ordering::Relaxed);
        self.left.store(left.saturating_sub(steps), Ordering::Relaxed);
    }

    fn interrupted(&self) -> bool {
        self.left.load(Ordering::Relaxed) == 0
    }
}

/// An interrupted run that is resumed ends bit by bit as the uninterrupted one; a checkpoint of another input is refused and
/// kept.
#[test]
fn resumed_is_uninterrupted() {
    for contact in [Contact::Bonded, Contact::Opening] {
        resumed_with(contact);
    }
}

fn resumed_with(contact: Contact) {
    let case = shaken(cracking(), 6.0, 12);
    // Interrupted in the free vibration after the record, of 0.11 s.
    let own = NonlinearOptions { contact, after_record: AfterRecord::Time(0.06), ..options(&case, 4, 8) };
    let folder = tempfile::tempdir().unwrap();
    let file =
        |key: &str, resume| CheckpointFile { path: folder.path().join("run.checkpoint"), key: key.into(), resume };
    let straight = simulate(&case, &own, None, &Silent).unwrap();
    // Steps of the stages before count as well.
    let stop = StopAfter { left: AtomicU64::new(40) };
    let part = simulate(&case, &own, Some(&file("a", false)), &stop).unwrap();
    assert!(part.result.incomplete);
    assert!(part.series.time.len() < straight.series.time.len());
    let kept = std::fs::read(folder.path().join("run.checkpoint")).unwrap();
    let refused = simulate(&case, &own, Some(&file("b", true)), &Silent).unwrap_err();
    assert!(refused.to_string().contains("of another run"), "{refused}");
    assert_eq!(std::fs::read(folder.path().join("run.checkpoint")).unwrap(), kept);
    let resumed = simulate(&case, &own, Some(&file("a", true)), &Silent).unwrap();
    assert_eq!(resumed.series, straight.series);
    assert_eq!(resumed.values, straight.values);
    assert_eq!(resumed.result.events, straight.result.events);
    let (a, b) = (resumed.result.nonlinear.unwrap(), straight.result.nonlinear.unwrap());
    assert_eq!((&a.maps, &a.cracks, &a.loops), (&b.maps, &b.cracks, &b.loops));
    assert_eq!(a.energies, b.energies);
}

/// The bits of a run do not depend on the number of threads: with cracks, and with contact that opens. The shells and their
/// pressures are more than the fewest elements that are shared among threads.
#[test]
fn threads_change_no_bit() {
    for (case, contact) in
        [(shaken(cracking(), 12.0, 10), Contact::Bonded), (shaken(elastic(), 25.0, 8), Contact::Opening)]
    {
        let own = NonlinearOptions { contact, ..options(&case, 14, 24) };
        let cylinder = Cylinder::new(&case, &own, &Silent).unwrap();
        assert!(cylinder.tank.model.elements().len() > 256);
        let motion = case.ground_motion.as_ref().unwrap();
        let run = |threads: usize| {
            let (watch, run) = cylinder.march(motion, 1.0, threads, None, &Silent).unwrap();
            (watch.recorder.histories, watch.seen, run.state, run.balance, run.cost)
        };
        let one = run(1);
        assert!(one.4.steps > 8);
        // Two threads: `resume`.
        assert!(run(3) == one);
    }
}

/// A march with the liquid in one of its forms.
fn marched(case: &Case, options: &NonlinearOptions, operator: bool) -> (Vec<Vec<f64>>, fem::analysis::march::Run) {
    marched_to(case, options, operator, None)
}

/// The same with other criteria of a step.
fn marched_to(
    case: &Case,
    options: &NonlinearOptions,
    operator: bool,
    criteria: Option<fem::analysis::newton::Criteria>,
) -> (Vec<Vec<f64>>, fem::analysis::march::Run) {
    let tank = CylinderModel::in_form(case, options, |_| operator).unwrap();
    assert_eq!(tank.assembler.has_operators(), operator);
    let cylinder = Cylinder { criteria, ..Cylinder::of(case, options, tank).unwrap() };
    let (watch, run) = cylinder.march(case.ground_motion.as_ref().unwrap(), 1.0, 1, None, &Silent).unwrap();
    (watch.recorder.histories.clone(), run)
}

/// The liquid as an operator, its systems solved by iteration, gives the march of the dense block: a tank that cracks, half and
/// whole, with every kind of damping, bonded and with contact. Both end their steps with residuals of up to 1e-4 of the forces,
/// which cracks pass on: 3e-3 of the largest value (1e-3 as between half and whole was set first; the displacement of the top differs
/// by 1.5e-3); elastic walls agree to 1e-5.
#[test]
fn operator_is_the_dense_march() {
    let by_group = options(&cracking(), 6, 16);
    let whole = NonlinearOptions {
        symmetry: false,
        damping: tank::options::nonlinear::Damping::Rayleigh {
            first: (5.0, 0.02),
            second: (60.0, 0.03),
            allow_negative: false,
        },
        ..by_group.clone()
    };
    let opening = NonlinearOptions { contact: Contact::Opening, damping: whole.damping, ..by_group.clone() };
    for (own, strength, tolerance) in
        [(&by_group, 12.0, 3e-3), (&whole, 12.0, 3e-3), (&opening, 12.0, 3e-3), (&by_group, 0.02, 1e-5)]
    {
        let mut case = shaken(cracking(), strength, 20);
        case.tank.roof.mass = 3000.0;
        let (dense, dense_run) = marched(&case, own, false);
        let (found, run) = marched(&case, own, true);
        assert!(run.cost.products > 0 && dense_run.cost.products == 0);
        assert!(run.balance.error() < 1e-3, "{}", run.balance.error());
        for (k, (a, b)) in found.iter().zip(&dense).enumerate() {
            let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < tolerance * largest, "{strength} {:?} {k}: {apart} of {largest}", own.contact);
        }
        // The wall is elastic and round: the preconditioner is the matrix, but for the stress that is there.
        let each = run.cost.products as f64 / run.cost.iterations as f64;
        assert!(strength > 1.0 || each < 10.0, "{each} products a solution");
    }
}

/// A joint that may open follows the wall as long as it is in compression; pulled hard it opens near the surface, and the
/// numbers stay finite. The penalty gives way by 1e-3 of the membrane, and peaks of a wall that rings at a frequency lower by
/// half of that fall between other samples: 5e-3, not estimated further.
#[test]
fn contact_that_opens() {
    for (acceleration, opens) in [(0.2, false), (25.0, true)] {
        let case = shaken(elastic(), acceleration, 30);
        let bonded = options(&case, 8, 16);
        let own = NonlinearOptions { contact: Contact::Opening, ..bonded.clone() };
        let found = simulate(&case, &own, None, &Silent).unwrap();
        let n = found.result.nonlinear.as_ref().unwrap();
        assert_eq!(found.result.end, End::Completed);
        assert!(n.energies.error < 1e-3, "{}", n.energies.error);
        let gap = n.maps.iter().find(|m| m.id == "separation").unwrap();
        assert_eq!(gap.values.iter().any(|g| *g > 0.0), opens);
        assert_eq!(found.result.events.iter().any(|e| e.title == "the liquid separates from the wall"), opens);
        if !opens {
            let tight = simulate(&case, &bonded, None, &Silent).unwrap();
            for (quantity, a) in &found.values {
                let b = tight.values[quantity];
                assert!((a / b - 1.0).abs() < 5e-3, "{}: {a} {b}", quantity.id());
            }
        }
    }
}

/// A wall that cannot carry the hydrostatic pressure: collapse before the shaking, and every number is finite.
#[test]
fn collapse_at_rest_is_a_result() {
    let mut case = shaken(cracking(), 1.0, 5);
    let mut layer = case.tank.courses[0].layers[0].clone();
    layer.thickness = 0.04;
    layer.reinforcement.clear();
    case.tank.courses = vec![Course::layered(5.0, vec![layer])];
    let found = simulate(&case, &options(&case, 4, 8), None, &Silent).unwrap();
    assert!(
        matches!(found.result.end, End::Collapsed { load_factor: Some(f), .. } if f < 1.0),
        "{:?}",
        found.result.end
    );
    assert!(found.result.incomplete && found.values.values().all(|v| v.is_finite()));
    let text = serde_json::to_string(&found.result).unwrap();
    let again: results::Run = serde_json::from_str(&text).unwrap();
    assert_eq!(again.end, found.result.end);
}

/// An unanchored tank is clamped: the report states this in its notes and its assumptions.
#[test]
fn an_unanchored_tank_is_held_down_and_says_so() {
    let mut case = shaken(elastic(), 0.05, 4);
    let said = |case: &Case| {
        let run = simulate(case, &options(case, 6, 16), None, &Silent).unwrap();
        [run.notes, run.assumptions].map(|list| list.iter().any(|line| line.contains("unanchored")))
    };
    assert_eq!(said(&case), [false; 2]);
    case.tank.support = Support::Unanchored;
    assert_eq!(said(&case), [true; 2]);
}
