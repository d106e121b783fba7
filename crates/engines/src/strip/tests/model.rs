//! Moments at the base and limits of the model.

use std::sync::Arc;

use materials::Law;
use materials::bar::{Bar, Rupture};
use materials::concrete::{Compression, Softening, Tension, UniaxialConcrete};
use materials::elastic::Elastic;
use oscillator::record::Record;

use fem::analysis::damping::Rayleigh;
use fem::analysis::march::{Instant, Outcome, Problem, Settings, march};
use fem::analysis::motion::Motion;
use fem::analysis::observable::apply;
use fem::analysis::scheme::TimeScheme;
use fem::analysis::transient::Load;
use fem::element::Inspect;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam::Options;
use fem::progress::Silent;
use fem::state::Gather;
use results::nonlinear::DepartureKind;

use crate::strip::liquid::StripLiquid;
use crate::strip::*;

const YOUNG: f64 = 3.4e10 / (1.0 - 0.04);
/// Strip 8.4: height, depth, thickness [m].
const HEIGHT: f64 = 3.0;
const DEPTH: f64 = 2.57;
const THICKNESS: f64 = 0.3;
/// Normal force of the base at rest [N/m].
const AXIAL: f64 = -2540.0 * THICKNESS * HEIGHT * oscillator::STANDARD_GRAVITY;
/// Damping proportional to the mass, 2.2 % at the first sloshing mode: 0.05 % of the wall mode.
const MASS: StripDamping = StripDamping::Rayleigh(Rayleigh { mass: 2.0 * 0.022 * 2.39, stiffness: 0.0 });
const BY_GROUP: StripDamping = StripDamping::ByGroup { wall: 0.05, sloshing: 0.005 };

fn concrete(softening: Softening) -> Arc<dyn Law<1>> {
    let tension = Tension { strength: 3.5e6, softening, stiffening: None, bond: None };
    Arc::new(UniaxialConcrete::new(YOUNG, Compression::Plastic { strength: 35e6 }, Some(tension)).unwrap())
}

fn bar() -> Bar {
    Bar::new(2.1e11, 5e8, 2.1e9).unwrap()
}

/// The wall of strip 8.4 with 7 cm²/m of bars on each face.
fn section(concrete: Arc<dyn Law<1>>, bar: Bar) -> FibreSection {
    FibreSection::new(2540.0 * THICKNESS)
        .unwrap()
        .with_attached_mass(123.0)
        .unwrap()
        .rectangle(concrete, [1.0, THICKNESS], 0.0, 20)
        .unwrap()
        .bars(Arc::new(bar), &[[-0.115, 7e-4], [0.115, 7e-4]])
        .unwrap()
}

fn strip(section: FibreSection, damping: StripDamping) -> StripModel {
    let section = Arc::new(section);
    let tank = StripTank {
        levels: levels([DEPTH, HEIGHT], [17, 3], 1.0).unwrap(),
        sections: vec![section; 20],
        shells: None,
        options: Options::default(),
        carried: Vec::new(),
        base_spring: None,
        liquid: StripLiquid::new(2.5, DEPTH, 1019.4),
        sloshing: 12,
        contact: Contact::Bonded,
        mesh: None,
    };
    StripModel::new(&tank, damping).unwrap()
}

/// A sine of this frequency [Hz] and amplitude [g] that rises within half a second.
fn quake(frequency: f64, amplitude: f64, until: f64, radius: f64) -> StripQuake {
    let sample = |i: usize| {
        let t = 0.02 * i as f64;
        amplitude * oscillator::STANDARD_GRAVITY * (std::f64::consts::TAU * frequency * t).sin() * (t / 0.5).min(1.0)
    };
    let record = Record {
        name: "sine".into(),
        dt: 0.02,
        acceleration: (0..=(until / 0.02) as usize).map(sample).collect(),
        processing: Vec::new(),
    };
    let mut quake = StripQuake::new(record, 2.5e-3);
    quake.scheme = TimeScheme::GeneralizedAlpha { radius };
    quake
}

/// Looks at every step of the wall at +L.
fn observe(strip: &StripModel, quake: &StripQuake, mut see: impl FnMut(&Instant<'_>)) {
    let grid = strip.grid(quake);
    let record = &quake.horizontal;
    let load = Load::ground(0, Motion::sampled(record.dt, &record.acceleration, &grid));
    let mut settings = Settings::new(grid);
    settings.scheme = quake.scheme;
    settings.constant = strip.at_rest();
    settings.halvings = quake.halvings;
    let problem =
        Problem { model: &strip.model, assembler: &strip.assembler, symbolic: &strip.symbolic, system: &strip.system };
    let run = march(problem, &load, &settings, &mut [&mut see], &Silent).unwrap();
    assert_eq!(run.outcome, Outcome::Completed);
}

/// Of a wall that cracks: the part of the section is M(z) of its two Gauss points, extrapolated; damping and inertia are those of
/// the lowest element and the liquid, row by row of their matrices; the sum is the reaction.
#[test]
fn the_reaction_is_section_damping_inertia_and_load() {
    let softening = Softening::Strain { softening_strain: 3e-4 };
    let strip = strip(section(concrete(softening), bar()), BY_GROUP);
    let [mut worst, mut largest, mut cracked] = [0.0_f64; 3];
    observe(&strip, &quake(2.0, 1.0, 0.8, 0.9), |now| {
        let reaction = strip.base_reaction(&strip.walls[0], now.state, now.ground).unwrap();
        let element = &*strip.model.elements()[0];
        let mut gather = Gather::default();
        let motion = gather.motion(&strip.model, &now.state.committed, element);
        let sections = element.sections(motion, &now.state.old[now.state.history(0)]).unwrap();
        let [m1, m2] = [0, 1].map(|i| sections[i].resultants[3]);
        // Gauss points at (1 ∓ 1/√3)/2 of the element.
        let root = 3.0_f64.sqrt();
        let base = 0.5 * ((1.0 + root) * m1 + (1.0 - root) * m2);
        let fields = &now.state.committed;
        let linear = strip.base_moment();
        let damping = apply(&linear.velocity, &fields.v);
        let inertia =
            apply(&linear.acceleration, &fields.a) + linear.total_ground(&strip.system.influence)[0] * now.ground[0];
        let sum = base + damping + inertia + reaction.load[2];
        worst = worst.max((reaction.total()[2] - sum).abs());
        largest = largest.max(sum.abs());
        cracked = cracked.max(m1.abs());
    });
    assert!(worst < 1e-9 * largest, "{worst} of {largest}");
    assert!(cracked > 60e3, "the wall has not cracked: {cracked}");
}

/// An elastic wall: the reaction less that at rest is the linear functional of displacements, velocities and accelerations.
#[test]
fn the_reaction_of_an_elastic_wall_is_the_linear_one() {
    let elastic: Arc<dyn Law<1>> = Arc::new(Elastic::new(YOUNG, 0.0).unwrap());
    let section = FibreSection::new(2540.0 * THICKNESS).unwrap().rectangle(elastic, [1.0, THICKNESS], 0.0, 2).unwrap();
    let strip = strip(section, BY_GROUP);
    let row = strip.base_moment();
    let (mut rest, mut worst, mut largest) = (None, 0.0_f64, 0.0_f64);
    observe(&strip, &quake(3.0, 0.3, 1.0, 0.9), |now| {
        let fields = &now.state.committed;
        let total = row.total_ground(&strip.system.influence);
        let own = apply(&row.displacement, &fields.u)
            + apply(&row.velocity, &fields.v)
            + apply(&row.acceleration, &fields.a)
            + total[0] * now.ground[0];
        let found = strip.base_reaction(&strip.walls[0], now.state, now.ground).unwrap().total()[2];
        let [own0, found0] = *rest.get_or_insert([own, found]);
        worst = worst.max((found - found0 - (own - own0)).abs());
        largest = largest.max((own - own0).abs());
    });
    assert!(largest > 1e4 && worst < 1e-9 * largest, "{worst} of {largest}");
}

/// Pushed far beyond its yield moment the section bears no more than its moment-curvature line under the largest normal force that it
/// sees, whatever the reaction is: this exceeds it by damping, whose stiffness is that of the uncracked wall.
#[test]
fn the_section_bears_its_yield_moment_and_hardening() {
    let softening = Softening::Strain { softening_strain: 3e-4 };
    let wall = || section(concrete(softening), bar());
    let strip = strip(wall(), BY_GROUP);
    let [mut curvature, mut own, mut reaction, mut axial] = [0.0_f64; 4];
    observe(&strip, &quake(4.0, 1.2, 0.8, 0.9), |now| {
        let element = &*strip.model.elements()[0];
        let mut gather = Gather::default();
        let motion = gather.motion(&strip.model, &now.state.committed, element);
        let sections = element.sections(motion, &now.state.old[now.state.history(0)]).unwrap();
        curvature = curvature.max(sections[0].strain[3].abs());
        own = own.max(sections[0].resultants[3].abs());
        axial = axial.min(sections[0].resultants[0]);
        let total = strip.base_reaction(&strip.walls[0], now.state, now.ground).unwrap().total()[2];
        reaction = reaction.max(total.abs());
    });
    let path: Vec<f64> = (0..=400).map(|i| curvature * f64::from(i) / 400.0).collect();
    let yields = |axial: f64| {
        let line = wall().moment_curvature(axial, &path).unwrap();
        let yielding = line.iter().find(|p| p.fibres.iter().any(|f| f.block > 0 && f.state.plastic_strain > 0.0));
        let most = line.iter().fold(0.0_f64, |most, p| most.max(p.moment));
        [yielding.expect("the section yields").moment, most]
    };
    let [at_rest, _] = yields(AXIAL);
    assert!((85e3..100e3).contains(&at_rest), "{at_rest}");
    let [_, capacity] = yields(axial);
    assert!(own > 0.95 * at_rest && own < 1.03 * capacity, "{own} {at_rest} {capacity} {axial}");
    assert!(reaction > own, "{reaction} {own}");
}

/// Brittle concrete, next to no damping: cracks that close and open within a step feed energy into the wall. The run stops before
/// the waves reach the base, where a section that yields at 91 kNm/m was once held by a reaction of 1,245.
#[test]
fn a_run_that_gains_energy_is_stopped_and_marked() {
    let wall = || section(concrete(Softening::Brittle), bar());
    let model = strip(wall(), MASS);
    let both = |radius| Side::BOTH.map(|side| model.run(&quake(8.0, 1.5, 1.2, radius), 1.0, side, &Silent).unwrap());
    // Which wall it is depends on the last digit.
    let runs = both(0.9);
    let run = runs.iter().find(|r| r.demand.departures.iter().any(|d| d.kind.stops()));
    let run = run.expect("a wall gains energy");
    let Outcome::Stopped { reason } = &run.outcome else { panic!("{:?}", run.outcome) };
    assert!(reason.contains("gains energy"), "{reason}");
    let found = &run.demand.departures;
    let energy = found.iter().find(|d| d.kind == DepartureKind::StoredEnergy).expect("marked");
    let passed = energy.passed.expect("a value");
    assert!(passed.value < passed.limit && passed.limit < 0.0, "{energy:?}");
    assert!((energy.time - run.time).abs() < 1e-9, "{energy:?} {}", run.time);
    assert!(run.demand.base_moment < 300e3, "{}", run.demand.base_moment);
    // The same walls with numerical damping: no energy is gained, and the reaction is that of the section.
    for damped in both(0.5) {
        let demand = &damped.demand;
        assert!(!demand.departures.iter().any(|d| d.kind.stops()), "{:?}", demand.departures);
        // The Gauss point is 3 cm above the base, to which the reaction is extrapolated: 12 % in the wave of a fracture.
        assert!(demand.base_moment < 1.25 * demand.section_moment, "{demand:?}");
        assert!(demand.section_moment < 140e3, "{demand:?}");
    }
}

/// A bar beyond its strain at rupture, which its law only records, marks the run and is an event; without a strain at rupture the
/// limit is that of class A.
#[test]
fn a_bar_beyond_its_strain_at_rupture_marks_the_run() {
    let softening = Softening::Strain { softening_strain: 3e-4 };
    for (rupture, limit) in [(Some(0.004), 0.004), (None, BAR_STRAIN)] {
        let bar = match rupture {
            Some(strain) => bar().with_rupture(strain, Rupture::Recorded).unwrap(),
            None => bar(),
        };
        let model = strip(section(concrete(softening), bar), BY_GROUP);
        let run = model.single(&quake(2.0, 5.0, 1.0, 0.9), Side::Front, &Silent).unwrap();
        let history = &run.history;
        let found = history.departures.iter().find(|d| d.kind == DepartureKind::BarStrain);
        let found = found.unwrap_or_else(|| panic!("{limit}: {:?}", history.departures));
        let passed = found.passed.expect("a value");
        assert!((passed.limit / limit - 1.0).abs() < 1e-9 && passed.value > limit, "{found:?}");
        assert!(found.height < 0.2, "{found:?}");
        let event = history.events.iter().any(|e| e.kind == EventKind::BarRupture);
        assert_eq!(event, rupture.is_some());
    }
}
