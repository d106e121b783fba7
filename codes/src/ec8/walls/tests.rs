//! Source:    statics by hand, in each test
//! Goal:      demands and resistances of concrete walls on the whole sheet
//! Tolerance: 1e-9 where a number follows from others of the sheet, otherwise in the test

use super::super::En2006;
use super::super::example::{check, line, site};
use crate::procedure::Procedure;
use crate::samples::{self, concrete_rectangle, material};
use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};
use tank::{
    BarDirection, Behaviour, Concrete, ConcreteLaw, Course, Layer, LayerKind, Material, Reinforcement, Shape,
    Softening, WallBase,
};

fn c30() -> Material {
    Material {
        behaviour: Behaviour::Concrete(Concrete {
            law: ConcreteLaw::Cracked,
            compressive_strength: 30e6,
            characteristic_strength: Some(30e6),
            biaxial_ratio: 1.16,
            tensile_strength: 2.9e6,
            softening: Softening::Brittle,
            shear_retention: 0.1,
            shear_retention_strain: 2e-4,
            tension_stiffening: 0.0,
            crack_spacing: None,
            envelope: tank::BiaxialEnvelope::default(),
            bond: tank::BarBond::Perfect,
        }),
        ..material("c30", 33e9, 0.2, 2500.0)
    }
}

/// Bars of 16 mm, 5 cm from both faces, both directions [m²/m].
fn course(height: f64, thickness: f64, hoop: f64, vertical: f64) -> Course {
    let steel = Material { yield_strength: Some(500e6), ..material("b500", 200e9, 0.3, 7850.0) };
    let bars = |direction, area, depth| Reinforcement {
        direction,
        area,
        depth,
        diameter: Some(0.016),
        prestress: 0.0,
        material: steel.clone(),
    };
    let reinforcement = [0.05, thickness - 0.05]
        .into_iter()
        .flat_map(|depth| [bars(BarDirection::Hoop, hoop, depth), bars(BarDirection::Vertical, vertical, depth)])
        .filter(|b| b.area > 0.0)
        .collect();
    let layer = Layer { kind: LayerKind::Shell, thickness, material: c30(), reinforcement };
    Course::layered(height, vec![layer])
}

fn weak() -> Ec8Site {
    Ec8Site { ag: 0.1 * 9.81, importance: 1.0, ..site() }
}

/// R = 10 m, 5 m of water, wall 6 m × 30 cm.
fn cylinder(hoop: f64, vertical: f64) -> Case {
    let courses = vec![course(6.0, 0.3, hoop, vertical)];
    samples::case(Shape::Cylinder { radius: 10.0 }, courses, 5.0, Some(weak()))
}

fn assess(case: &Case) -> Assessment {
    En2006.assess(case, Excitation::Site).unwrap()
}

/// Value of a symbol in the section whose title contains this.
fn of(a: &Assessment, section: &str, symbol: &str) -> f64 {
    let step = a.steps.iter().find(|s| s.section.contains(section) && s.symbol == symbol);
    step.map_or(f64::NAN, |s| s.value)
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// Long-wall form of a cylinder on its base under a linear pressure from `p` at the foot to zero at the surface, H = 5 m, R = 10 m, s = 0.3 m:
/// hoop force, moment at z and shear at the base. βH = 3.7, so that the far end is exp(−3.7) away: 3 %.
fn long_wall(p: f64, base: WallBase, z: f64) -> (f64, f64, f64) {
    let (r, s, h, nu): (f64, f64, f64, f64) = (10.0, 0.3, 5.0, 0.2);
    let beta = (3.0 * (1.0 - nu * nu) / (r * r * s * s)).powf(0.25);
    let (c, d) = ((beta * z).cos() * (-beta * z).exp(), (beta * z).sin() * (-beta * z).exp());
    // Edge solution over w_p(0): A cos + B sin; clamped: w = 0, w' = 0; hinged: w = 0, w'' = 0.
    let (a, b) = match base {
        WallBase::Fixed => (1.0, 1.0 - 1.0 / (beta * h)),
        WallBase::Hinged => (1.0, 0.0),
        WallBase::Sliding { .. } => (0.0, 0.0),
    };
    let rigidity = p * r * s / (12.0 * (1.0 - nu * nu)).sqrt();
    let n = p * r * (1.0 - z / h - a * c - b * d);
    // w'' of the edge solution is 2β² (B cos − A sin); D 2β² w_p(0) = p R s/√(12 (1 − ν²)). It acts against the particular solution.
    (n, -rigidity * (a * d - b * c), rigidity * beta * (a + b))
}

/// Hydrostatic forces of the crack check are those of the long wall on each base: never p R at a foot that cannot move.
#[test]
fn hydrostatic_forces_on_each_base() {
    let p = 9810.0 * 5.0;
    for base in [WallBase::Fixed, WallBase::Hinged] {
        let mut case = cylinder(2e-3, 1e-3);
        case.tank.wall_base = base;
        let a = assess(&case);
        let heights = || (0..=500).map(|i| 0.01 * f64::from(i));
        let largest = heights().map(|z| long_wall(p, base, z).0).fold(0.0, f64::max);
        assert!(largest < 0.62 * p * 10.0);
        let section = "crack width, horizontal";
        near(of(&a, section, "n_Ed"), largest, 0.04);
        // ν m of the same place.
        assert!(of(&a, section, "m_Ed").abs() < 0.2 * 0.3 * p * 10.0 * 0.3);
    }
    // Free to slide the foot has p R, whatever friction may hold of it.
    for friction in [0.0, 0.3] {
        let mut case = cylinder(2e-3, 1e-3);
        case.tank.wall_base = WallBase::Sliding { stiffness: None, friction: Some(friction) };
        near(of(&assess(&case), "crack width, horizontal", "n_Ed"), p * 10.0, 2e-3);
    }
}

/// Forces of the earthquake are those of the same base. The pressures of the sheet with 0.3 m · 2500 kg/m³ of the wall lie between the
/// triangle of the same value at the foot and a uniform one: moment and shear at the foot, hinge and bearing as in [`long_wall`].
#[test]
fn seismic_forces_on_each_base() {
    let on = |base| {
        let mut case = cylinder(2e-3, 1e-3);
        case.tank.wall_base = base;
        assess(&case)
    };
    let (fixed, hinged) = (on(WallBase::Fixed), on(WallBase::Hinged));
    let still = line(&fixed, "p_0");
    let p = still + line(&fixed, "p_i") + line(&fixed, "p_c") + 750.0 * line(&fixed, "S_e(T_i)");
    let m = of(&fixed, "vertical bars, course", "m_Ed");
    let (_, clamping, _) = long_wall(p, WallBase::Fixed, 0.0);
    assert!(m > 0.95 * clamping && m < 1.3 * clamping, "{m} {clamping}");
    for (a, base) in [(&fixed, WallBase::Fixed), (&hinged, WallBase::Hinged)] {
        let v = of(a, "concrete: shear, course", "v_Ed");
        let (_, _, reaction) = long_wall(p, base, 0.0);
        assert!(v > 0.95 * reaction && v < 1.15 * reaction, "{base:?}: {v} {reaction}");
        let n = of(a, "horizontal bars, course", "n_Ed");
        assert!(n < 0.75 * p * 10.0, "{base:?}: {n} {p}");
    }
    // On a hinge the wall bends inwards of itself alone: outer bars pull in the span, less than the clamping moment.
    let span = of(&hinged, "vertical bars, course", "m_Ed");
    assert!(span < 0.0 && -span < m, "{span} {m}");
}

/// The hoop stress that is compared with other methods is that of the same base. The seismic pressure lies between the triangle of its value at
/// the foot, whose hoop force is the long wall's, and that value all over the height, with p R far from the foot: on a foot that is held it is
/// less than p R.
#[test]
fn the_compared_hoop_stress_is_that_of_the_base() {
    use tank::quantity::Quantity;
    for base in [WallBase::Fixed, WallBase::Hinged] {
        let mut case = cylinder(2e-3, 1e-3);
        case.tank.wall_base = base;
        let a = assess(&case);
        let p = line(&a, "p_i") + line(&a, "p_c");
        let heights = || (0..=500).map(|i| 0.01 * f64::from(i));
        let largest = heights().map(|z| long_wall(p, base, z).0).fold(0.0, f64::max) / 0.3;
        let found = a.values[&Quantity::HoopStress];
        assert!(found > 1.05 * largest && found < 0.98 * p * 10.0 / 0.3, "{base:?}: {found} {largest}");
    }
    let mut case = cylinder(2e-3, 1e-3);
    case.tank.wall_base = WallBase::Sliding { stiffness: Some(0.0), friction: None };
    let a = assess(&case);
    let p = line(&a, "p_i") + line(&a, "p_c");
    near(a.values[&Quantity::HoopStress], p * 10.0 / 0.3, 0.1);
}

/// A sliding joint: with μ n its force is that friction at most, and no more than a hinge's; the shear of the earthquake along it against μ n
/// of wall and roof, 0.3 · 6 m · 2500 kg/m³ · 9.81; without friction it is open with the path.
#[test]
fn a_sliding_joint_has_its_force() {
    let on = |stiffness, friction| {
        let mut case = cylinder(2e-3, 1e-3);
        case.tank.wall_base = WallBase::Sliding { stiffness, friction };
        assess(&case)
    };
    let weight = 0.3 * 6.0 * 2500.0 * 9.81;
    for friction in [0.0, 0.2, 0.5] {
        let a = on(None, Some(friction));
        let along = a.checks.iter().find(|c| c.id == "wall_joint").unwrap();
        assert_eq!(along.limit_state, "wall_shear");
        near(along.demand.unwrap(), line(&a, "Q") / (std::f64::consts::PI * 10.0), 1e-9);
        assert!((along.capacity.unwrap() - friction * weight).abs() < 1e-6 * weight);
        let v = check(&a, "wall_shear").demand.unwrap();
        let most = friction * (weight + of(&a, "concrete: shear, course", "n_Ed").abs());
        assert!(v <= most + 1e-6 * weight && v >= friction * weight * (1.0 - 1e-9), "{friction}: {v} {most}");
    }
    // A bearing as stiff as concrete is a hinge; without friction the shear along the joint is open.
    let stiff = on(Some(1e12), None);
    let mut case = cylinder(2e-3, 1e-3);
    case.tank.wall_base = WallBase::Hinged;
    near(of(&stiff, "concrete: shear, course", "v_Ed"), of(&assess(&case), "concrete: shear, course", "v_Ed"), 1e-3);
    let mut open = stiff.checks.iter().filter(|c| c.status == CheckStatus::NotChecked);
    assert!(open.any(|c| c.limit_state == "wall_shear" && c.input.as_deref() == Some("tank.wall_base.friction")));
}

/// Less hoop steel: bending fails, and the crack width before it.
#[test]
fn light_reinforcement_fails() {
    let strong = assess(&cylinder(3e-3, 1e-3));
    let light = assess(&cylinder(0.2e-3, 1e-3));
    let bending = "wall_tension_and_bending_horizontal";
    assert!(check(&strong, bending).holds() && check(&strong, "crack_width").holds());
    assert_eq!(check(&light, bending).status, CheckStatus::Fails);
    assert_eq!(check(&light, "crack_width").status, CheckStatus::Fails);
    let ratio = check(&light, bending).utilisation.unwrap() / check(&strong, bending).utilisation.unwrap();
    assert!(ratio > 4.0, "{ratio}");
}

/// Without bars: open, with the path and the areas; a wall with these areas has a utilisation near 1.
#[test]
fn required_areas() {
    let a = assess(&cylinder(0.0, 0.0));
    let gap = check(&a, "wall_tension_and_bending");
    assert_eq!(gap.status, CheckStatus::NotChecked);
    assert_eq!(gap.input.as_deref(), Some("tank.courses[0].reinforcement"));
    assert!(gap.reason.contains("cm²/m"), "{}", gap.reason);
    for state in ["wall_shear", "crack_width"] {
        assert_eq!(check(&a, state).status, CheckStatus::NotChecked);
    }
    let section = "Bars that the wall needs";
    let hoop = of(&a, section, "a_h,i").max(of(&a, section, "a_h,o"));
    let vertical = of(&a, section, "a_v,i").max(of(&a, section, "a_v,o"));
    let b = assess(&cylinder(hoop, vertical));
    for direction in ["horizontal", "vertical"] {
        let found = check(&b, &format!("wall_tension_and_bending_{direction}")).utilisation.unwrap();
        assert!(found > 0.7 && found <= 1.0 + 1e-6, "{direction} {found}");
    }
}

/// Missing strengths are named.
#[test]
fn missing_strengths() {
    let mut case = cylinder(1e-3, 1e-3);
    case.tank.courses[0].layers[0].reinforcement[0].material.yield_strength = None;
    let a = assess(&case);
    let gap = check(&a, "wall_tension_and_bending");
    assert_eq!(gap.input.as_deref(), Some("materials.b500.yield_strength"));
    let mut case = cylinder(1e-3, 1e-3);
    case.tank.courses[0].layers[0].material.behaviour = Behaviour::Elastic;
    let a = assess(&case);
    assert_eq!(check(&a, "crack_width").input.as_deref(), Some("materials.c30.grade"));
    let mut case = cylinder(1e-3, 1e-3);
    for bars in &mut case.tank.courses[0].layers[0].reinforcement {
        bars.diameter = None;
    }
    let a = assess(&case);
    assert!(check(&a, "wall_tension_and_bending_horizontal").holds());
    assert_eq!(check(&a, "crack_width").input.as_deref(), Some("tank.courses[0].reinforcement"));
    case.procedures.concrete.tightness_class = 2;
    let a = assess(&case);
    assert!(check(&a, "crack_width").reason.contains("tightness class 2"));
}

/// Damage limitation adds its crack width: ν = 0.5 of the earthquake on the hydrostatic state, short-term stiffening.
#[test]
fn damage_limitation() {
    let mut case = cylinder(2e-3, 1e-3);
    case.site.ec8.as_mut().unwrap().reduction_factor = Some(0.5);
    let a = assess(&case);
    let width = check(&a, "damage_crack_width");
    assert_eq!(width.limit_state, "damage_limitation");
    assert!(width.demand > check(&a, "crack_width").demand);
}

/// A strip: clamping moment of hydrostatic, liquid's and wall's pressure as its sheet gives them (m_z is the seismic part), without
/// vertical motion. The table of the pressures is linear between 80 points: 1e-3.
#[test]
fn strip_by_hand() {
    let mut case = concrete_rectangle(1.0, true, weak());
    case.tank.courses = vec![course(3.0, 0.3, 1e-3, 1e-3)];
    let a = assess(&case);
    let still = 9810.0 * 2.5f64.powi(3) / 6.0;
    near(of(&a, "vertical bars", "m_Ed"), still + line(&a, "m_z"), 1e-3);
    near(of(&a, "crack width", "m_Ed"), still, 1e-3);
    near(of(&a, "vertical bars", "n_Ed"), -0.3 * 3.0 * 2500.0 * 9.81, 1e-6);
    assert!(a.checks.iter().all(|c| c.id != "wall_tension_and_bending_horizontal"));
    // Shear: half the base shear of the strip is one wall's, and the hydrostatic p H/2.
    near(check(&a, "wall_shear").demand.unwrap(), 9810.0 * 2.5 * 2.5 / 2.0 + 0.5 * line(&a, "Q"), 1e-3);
}

/// A box: strong walls hold, weak ones do not; the moments lie below those of the strip.
#[test]
fn boxes() {
    let with = |thickness, area| {
        let mut case = concrete_rectangle(4.0, false, weak());
        case.tank.courses = vec![course(3.0, thickness, area, area)];
        assess(&case)
    };
    let strong = with(0.3, 1.5e-3);
    for id in ["wall_tension_and_bending_horizontal", "wall_tension_and_bending_vertical", "wall_shear", "crack_width"]
    {
        assert!(check(&strong, id).holds(), "{:?}", check(&strong, id));
    }
    let weak = with(0.15, 0.2e-3);
    assert_eq!(check(&weak, "wall_tension_and_bending_vertical").status, CheckStatus::Fails);
    assert_eq!(check(&weak, "crack_width").status, CheckStatus::Fails);
}

/// A box of steel: elastic stress below yield.
#[test]
fn metal_box() {
    let steel = Material { yield_strength: Some(235e6), ..samples::steel() };
    let mut case = concrete_rectangle(4.0, false, weak());
    for (thickness, status) in [(0.04, CheckStatus::Holds), (0.008, CheckStatus::Fails)] {
        case.tank.courses = vec![samples::course(3.0, thickness, steel.clone())];
        let a = assess(&case);
        assert_eq!(check(&a, "wall_tension_and_bending").status, status);
    }
    case.tank.courses = vec![samples::course(3.0, 0.04, samples::steel())];
    let a = assess(&case);
    assert_eq!(check(&a, "wall_tension_and_bending").input.as_deref(), Some("materials.steel.yield_strength"));
}
