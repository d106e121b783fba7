//! What the rows compute: tanks, sections, laws.

use base::{Bands, Lifted, Plan, Plate, Rim, Strip, closed};
use codes::Procedure;
use codes::en1992::crack::{LASTING, width};
use codes::en1992::section::{Bars, Section as ConcreteSection};
use engines::solid::SolidOptions;
use engines::{Options, Simulation, Task};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::beam_section::FibreSection;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{ShellCell, ShellSurface};
use fem::linalg::Cholesky;
use fem::model::Builder;
use fem::progress::Silent;
use materials::Law;
use materials::concrete::{Compression, Softening, Tension, UniaxialConcrete};
use materials::von_mises::VonMises;
use oscillator::record::Record;
use results::EngineId;
use std::sync::Arc;
use tank::assessment::Excitation;
use tank::case::{Api650Site, Ec8Site, GroundMotion, GroundType, SiteClass};
use tank::options::AfterRecord;
use tank::options::nonlinear::{NonlinearOptions, WallElements};
use tank::reference::{case, material};
use tank::{Bottom, Case, Material, Quantity, Roof, Shape, Support};

use super::Answer;

/// Tilt of the base [rad].
pub(super) const TILT: f64 = 0.12;

pub(super) fn ec8(ground: GroundType, ag: f64, importance: f64) -> Ec8Site {
    Ec8Site {
        ground,
        spectrum: 1,
        ag: ag * tank::reference::GRAVITY,
        importance,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    }
}

/// The oil tank of the worked examples of EN 1998-4 and API 650: six courses, fixed roof, self-anchored.
pub(super) fn oil_tank() -> Case {
    let steel = Material {
        yield_strength: Some(235e6),
        allowable_stress: Some(157e6),
        ..material(210e9, 0.3, 7850.0)
    };
    let courses = [14e-3, 12e-3, 10e-3, 8e-3, 8e-3, 8e-3].map(|thickness| (2.4, thickness));
    let mut case = case(Shape::Cylinder { radius: 15.0 }, &courses, &steel, (900.0, 12.0));
    case.tank.roof = Roof {
        mass: 35e3,
        height: Some(15.2),
        ..Roof::default()
    };
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom {
        thickness: 0.010,
        sketch: None,
        projection: 0.0,
        corrosion: 0.0,
        width: None,
        subgrade_modulus: None,
        material: steel,
    });
    case.site.ec8 = Some(ec8(GroundType::C, 0.25, 1.2));
    case.site.api650 = Some(Api650Site {
        bearing_capacity: None,
        ss: 0.90,
        s1: 0.40,
        s0: None,
        site_class: SiteClass::D,
        asce7: 2010,
        fa: None,
        fv: None,
        q: 2.0 / 3.0,
        sug: 2,
        tl: 8.0,
        av: None,
        design_pressure: 0.0,
        joint_efficiency: 1.0,
        friction: 0.4,
        foundation_weight: None,
        zone_factor: Some(0.30),
        soil_factor: 1.5,
        importance_1993: 1.0,
    });
    case
}

/// A value of a procedure under the spectrum of the site.
pub(super) fn value(procedure: &dyn Procedure, case: &Case, quantity: Quantity) -> Answer {
    let sheet = procedure.assess(case, Excitation::Site)?;
    Ok(*sheet.values.get(&quantity).ok_or("no such value")?)
}

/// The first line with this symbol in the sheet of the oil tank, times `unit`.
pub(super) fn line(procedure: &dyn Procedure, symbol: &str, unit: f64) -> Answer {
    let sheet = procedure.assess(&oil_tank(), Excitation::Site)?;
    let line = sheet.steps.iter().find(|step| step.symbol == symbol);
    Ok(line.ok_or("no such line")?.value * unit)
}

pub(super) fn cracked_section() -> Answer {
    let bars = Bars {
        depth: 0.05,
        area: 1e-3,
        diameter: Some(0.016),
        yield_strength: 500e6,
        modulus: 200e9,
    };
    let section = ConcreteSection {
        thickness: 0.25,
        strength: 30e6,
        modulus: 33e9,
        bars: vec![bars],
        factors: (1.5, 1.15),
    };
    Ok(width(&section, 0.0, 50e3, 2.9e6, LASTING)
        .ok_or("nothing pulls")?
        .stress
        / 1e6)
}

pub(super) fn options() -> Options {
    Options {
        mesh_error: false,
        ..Options::default()
    }
}

/// First coupled frequency of a kind, harmonic 1 [rad/s].
pub(super) fn first(case: &Case, kind: &str) -> Answer {
    let modes = engines::modes(case, &options(), &[1], 1)?;
    Ok(modes.iter().find(|mode| mode.kind == kind).ok_or("no such mode")?.omega)
}

/// The case under a record that does nothing.
pub(super) fn at_rest(case: Case) -> Case {
    let horizontal = Record {
        name: "rest".into(),
        dt: 0.01,
        acceleration: vec![0.0; 3],
        processing: Vec::new(),
    };
    Case {
        ground_motion: Some(GroundMotion {
            horizontal,
            transverse: None,
            vertical: None,
        }),
        ..case
    }
}

/// Static value of a history of the nonlinear engine, on as many elements over the height and around.
pub(super) fn nonlinear(case: Case, [height, circumference]: [u32; 2], history: &str) -> Answer {
    let case = at_rest(case);
    let own = NonlinearOptions {
        elements: Some(WallElements { height, circumference }),
        after_record: AfterRecord::NONE,
        self_weight: false,
        ..NonlinearOptions::new(case.damping)
    };
    let (linear, solid) = (options(), SolidOptions::default());
    let task = Task {
        case: &case,
        linear: &linear,
        solid: &solid,
        nonlinear: &own,
        checkpoint: None,
        without: &[],
    };
    let run: Simulation = engines::engine(EngineId::Nonlinear).run(&task, &Silent)?;
    let found = run.result.histories.iter().find(|found| found.id == history);
    Ok(found.ok_or("no such history")?.static_value)
}

/// Deflection of the middle of the free edge of a tapered panel under shear, E = 1, ν = 1/3.
pub(super) fn cook() -> Answer {
    const N: usize = 16;
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.0, 1.0 / 3.0, 1.0, 0.0)?);
    let node = |i: usize, j: usize| i + (N + 1) * j;
    let mut builder = Builder::new();
    for k in 0..(N + 1) * (N + 1) {
        let [a, b] = [k % (N + 1), k / (N + 1)].map(|i| i as f64 / N as f64);
        builder.node([48.0 * a, 44.0 * (a + b) - 28.0 * a * b, 0.0]);
    }
    let cells = (0..N * N).map(|k| (k % N, k / N)).map(|(i, j)| ShellCell {
        nodes: [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)],
        section: section.clone(),
        group: "shell".into(),
    });
    ShellSurface::new(cells.collect()).place(&mut builder)?;
    for k in 0..(N + 1) * (N + 1) {
        [Dof::Uz, Dof::Rx, Dof::Ry]
            .into_iter()
            .for_each(|dof| builder.hold(k, dof));
    }
    let mut loads = NodalLoads::new();
    for j in 0..=N {
        Dof::TRANSLATIONS.iter().for_each(|&dof| builder.hold(node(0, j), dof));
        if j < N {
            let edge = [node(N, j), node(N, j + 1)];
            loads.edge_force(edge, edge.map(|e| builder.position(e)), |_| [0.0, 1.0 / 16.0, 0.0]);
        }
    }
    let model = builder.build()?;
    let stiffness = Assembler::new(&model).stiffness(&model)?.to_dense();
    let u = Cholesky::factor(&stiffness)?.solve_vector(&loads.vector(&model));
    Ok(model.at_node(&u, node(N, N / 2))[1])
}

/// E = 210 GPa, f_y = 500 MPa, E_T = 2.1 GPa.
pub(super) fn steel_cycle() -> Answer {
    let law = VonMises::new(210e9, 0.3, 500e6, 2.1e9, 0.0)?;
    let law: &dyn Law<1> = &law;
    let mut history = vec![0.0; law.history_len()];
    law.init_history(&mut history);
    let mut stress = 0.0;
    for strain in (1..=100).chain((-100..100).rev()).map(|i| 5e-5 * f64::from(i)) {
        let mut trial = history.clone();
        stress = law.respond(&[strain], &history, &mut trial)?.stress[0];
        history = trial;
    }
    Ok(stress / 1e6)
}

/// The base of a wall 3 m high and 30 cm thick of 25 kN/m³, f_t = 3.5 MPa: the moment under which the strain of its edge reaches f_t/E.
pub(super) fn cracking_moment() -> Answer {
    let (modulus, strength, thickness) = (34e9 / 0.96, 3.5e6, 0.3);
    let softening = Softening::Strain { softening_strain: 3e-4 };
    let tension = Tension {
        strength,
        softening,
        stiffening: None,
        bond: None,
    };
    let concrete = UniaxialConcrete::new(modulus, Compression::Plastic { strength: 35e6 }, Some(tension))?;
    let section = FibreSection::new(765.0)?.rectangle(Arc::new(concrete), [1.0, thickness], 0.0, 30)?;
    let curvatures: Vec<f64> = (0..400).map(|i| 5e-6 * f64::from(i)).collect();
    let points = section.moment_curvature(-22.5e3, &curvatures)?;
    let reached = |i: usize| (points[i].strain + 0.5 * thickness * points[i].curvature) * modulus / strength;
    let i = (1..points.len()).find(|&i| reached(i) >= 1.0).ok_or("no crack")?;
    let share = (1.0 - reached(i - 1)) / (reached(i) - reached(i - 1));
    Ok((points[i - 1].moment + share * (points[i].moment - points[i - 1].moment)) / 1e3)
}

/// 10 mm of steel under 128 kPa on nearly rigid ground, its rim free to turn.
pub(super) fn lifted_plate() -> Answer {
    let plate = Plate {
        thickness: 0.01,
        young_modulus: 205e9,
        poisson_ratio: 0.3,
        yield_stress: None,
    };
    let (pressure, length) = (128e3, 0.7);
    let strip = Strip::new(Bands::uniform(plate), Rim::Hinged, 3.0, 1e12, pressure, Plan::Strip)?.refined(2.0);
    let mut state = Lifted::at_rest(&strip, 0.0)?;
    state.lift_to(closed::hinged(&plate, pressure, length).uplift)?;
    Ok(state.point().hold_down)
}
