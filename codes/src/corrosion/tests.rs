//! Corroded tanks against tanks of the thickness that is left.
//!
//! Source:    definition: a wall of the net thickness whose density makes up for the lost mass is the same structure
//! Goal:      every comparison of API 650 is that of the substitute; hoop stress and buckling of EN 1998-4 use the net thickness
//! Tolerance: 1e-12, the products of the same numbers in another order

use tank::assessment::{Assessment, Excitation};
use tank::{Case, Support};

use crate::Procedure;
use crate::api650::edition2020::Api6502020;
use crate::ec8::En2006;
use crate::ec8::buckling::{elastic, elastic_plastic};

const EPSILON: f64 = 1e-12;
/// Corrosion of the courses from the base up [m], the last one is sound.
const LOSS: [f64; 6] = [0.002, 0.0015, 0.001, 0.001, 0.0005, 0.0];

fn corroded(mut case: Case) -> Case {
    for (course, loss) in case.tank.courses.iter_mut().zip(LOSS) {
        course.corrosion = loss;
    }
    if let Some(plate) = &mut case.tank.bottom {
        plate.corrosion = 0.001;
    }
    case
}

/// The same masses on the net thicknesses; the modulus keeps the membrane stiffness where `stiffness` is set.
fn substitute(mut case: Case, stiffness: bool) -> Case {
    for course in &mut case.tank.courses {
        let ratio = course.thickness / course.net_thickness();
        course.thickness = course.net_thickness();
        course.corrosion = 0.0;
        course.material.density *= ratio;
        if stiffness {
            course.material.youngs_modulus *= ratio;
        }
    }
    if let Some(plate) = &mut case.tank.bottom {
        plate.material.density *= plate.thickness / plate.net_thickness();
        plate.thickness = plate.net_thickness();
        plate.corrosion = 0.0;
    }
    case
}

fn same(name: &str, a: Option<f64>, b: Option<f64>) {
    match (a, b) {
        (Some(a), Some(b)) => assert!((a / b - 1.0).abs() < EPSILON, "{name}: {a} {b}"),
        (a, b) => assert_eq!(a, b, "{name}"),
    }
}

fn check<'a>(a: &'a Assessment, id: &str) -> &'a tank::assessment::Check {
    a.checks.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no {id}"))
}

#[test]
fn api_compares_the_net_thickness() {
    for support in [Support::Unanchored, Support::Anchored] {
        let mut case = crate::api650::example::case();
        case.tank.support = support;
        let case = corroded(case);
        let assess = |case: &Case| Api6502020.assess(case, Excitation::Site).unwrap();
        let (a, b) = (assess(&case), assess(&substitute(case.clone(), false)));
        assert_eq!(a.checks.len(), b.checks.len());
        assert!(a.checks.iter().filter(|c| c.compared()).count() >= 4);
        for (a, b) in a.checks.iter().zip(&b.checks) {
            assert_eq!((&a.id, a.status), (&b.id, b.status));
            same(&a.id, a.demand, b.demand);
            same(&a.id, a.capacity, b.capacity);
        }
    }
}

/// The line of each corroded part: 14 − 2 mm at the base.
#[test]
fn net_thicknesses_are_printed() {
    let case = corroded(crate::api650::example::case());
    let a = Api6502020.assess(&case, Excitation::Site).unwrap();
    let line = |symbol: &str| a.steps.iter().find(|s| s.symbol == symbol).map(|s| s.value);
    same("t_1", line("t_1"), Some(0.012));
    same("t_b", line("t_b"), Some(0.009));
    assert_eq!(line("t_6"), None);
    let plain = crate::api650::example::case();
    let a = Api6502020.assess(&plain, Excitation::Site).unwrap();
    assert!(a.steps.iter().all(|s| s.section != "Corrosion"));
}

/// EN 1998-4: the substitute keeps mass and membrane stiffness, so demands agree; its modulus is not that of the wall, so the
/// capacities are those of the formulas of A.10 with the net thickness.
#[test]
fn eurocode_compares_the_net_thickness() {
    let mut case = crate::ec8::example::oil_tank();
    for course in &mut case.tank.courses {
        course.material.yield_strength = Some(235e6);
    }
    // One corroded course at the base: it governs. A weak earthquake, so that hoop stress leaves a reserve against collapse.
    case.site.ec8.as_mut().unwrap().ag = 0.5;
    case.tank.courses[0].corrosion = 0.006;
    let assess = |case: &Case| En2006.assess(case, Excitation::Site).unwrap();
    let (a, b) = (assess(&case), assess(&substitute(case.clone(), true)));
    for id in ["hoop_yield", "buckling_elastic", "buckling_elastic_plastic"] {
        same(id, check(&a, id).demand, check(&b, id).demand);
    }
    let last = |symbol: &str| a.steps.iter().rev().find(|s| s.symbol == symbol).unwrap().value;
    let (net, radius) = (0.008, 15.0);
    let classical = 0.6 * 210e9 * net / radius;
    let p_min = last("p_r") * net * classical / radius;
    let limit = elastic(210e9, 235e6, net, radius, p_min, 1.0);
    same("elastic", check(&a, "buckling_elastic").capacity, Some(limit));
    // Hoop stress and collapse are governed by the same combination: the hoop stress gives the pressure.
    let (hoop, foot) = (check(&a, "hoop_yield"), check(&a, "buckling_elastic_plastic"));
    assert!(foot.note.contains("course 1") && hoop.note.contains(&foot.note), "{} {}", hoop.note, foot.note);
    let p_max = hoop.demand.unwrap() * net / radius;
    let limit = elastic_plastic(210e9, 235e6, net, radius, p_max);
    same("elastic-plastic", foot.capacity, Some(limit));
}
