//! Overpressure and vacuum above the liquid.
//!
//! Source:    statics of a closed cylinder: hoop force p R, meridional force p R/2, and equilibrium of the roof, p π R² = 2 π R · p R/2
//! Goal:      each pressure enters hoop, both stability checks, anchors and damage limitation with its sign
//! Tolerance: 1e-9, the same sums in another order

use std::f64::consts::PI;

use super::super::En2006;
use super::super::buckling::{elastic, elastic_plastic};
use super::super::example::{check, line, oil_tank, steel};
use crate::Procedure;
use crate::samples::{close, course};
use tank::assessment::{Assessment, Excitation};
use tank::case::Case;
use tank::{Anchors, Pressure};

/// The oil tank with one course, so that its base governs all checks.
fn one_course(internal: f64, vacuum: f64) -> Case {
    let mut case = oil_tank();
    case.tank.courses = vec![course(14.4, 0.014, steel())];
    case.tank.pressure = Pressure { internal, vacuum };
    case.tank.anchors =
        Some(Anchors { count: 60, capacity: Some(1e6), attachment_capacity: None, ..Anchors::default() });
    case.site.ec8.as_mut().unwrap().reduction_factor = Some(0.5);
    case
}

fn assess(internal: f64, vacuum: f64) -> Assessment {
    En2006.assess(&one_course(internal, vacuum), Excitation::Site).unwrap()
}

/// Weight above the base: 14.4 m·14 mm·7850 kg/m³ and 35 t on 2 π 15 m.
const WEIGHT: f64 = (14.4 * 0.014 * 7850.0 + 35e3 / (2.0 * PI * 15.0)) * 9.81;

/// Compression of a given pressure: M/(π R² s) + (weight − p R/2)/s.
fn compression(a: &Assessment, gas: f64) -> f64 {
    (line(a, "M") / (PI * 225.0) + WEIGHT - gas * 7.5) / 0.014
}

#[test]
fn overpressure_stretches_hoops_and_relieves_the_wall() {
    let (a, gas) = (assess(20e3, 0.0), 20e3);
    let largest = line(&a, "p_0") + line(&a, "p") + gas;
    let hoop = check(&a, "hoop_yield");
    close(hoop.demand.unwrap() / (largest * 15.0 / 0.014), 1.0, 1e-9);
    let foot = check(&a, "buckling_elastic_plastic");
    let limit = elastic_plastic(210e9, 235e6, 0.014, 15.0, largest);
    close(foot.capacity.unwrap() / limit, 1.0, 1e-9);
    close(foot.demand.unwrap() / compression(&a, gas), 1.0, 1e-9);
    // The elastic check does not count on the overpressure.
    let smallest = line(&a, "p_0") - line(&a, "p");
    let buckling = check(&a, "buckling_elastic");
    close(buckling.demand.unwrap() / compression(&a, 0.0), 1.0, 1e-9);
    let limit = elastic(210e9, 235e6, 0.014, 15.0, smallest, 1.0);
    close(buckling.capacity.unwrap() / limit, 1.0, 1e-9);
    let damage = check(&a, "damage_hoop").demand.unwrap();
    let reduced = line(&a, "p_0") + gas + 0.5 * line(&a, "p");
    close(damage / (reduced * 15.0 / 0.014), 1.0, 1e-9);
}

#[test]
fn vacuum_presses_on_the_wall_and_takes_its_support() {
    let a = assess(0.0, 15e3);
    let buckling = check(&a, "buckling_elastic");
    close(buckling.demand.unwrap() / compression(&a, -15e3), 1.0, 1e-9);
    let smallest = line(&a, "p_0") - line(&a, "p") - 15e3;
    let limit = elastic(210e9, 235e6, 0.014, 15.0, smallest, 1.0);
    close(buckling.capacity.unwrap() / limit, 1.0, 1e-9);
    // The hoop stress does not count on the vacuum.
    let largest = line(&a, "p_0") + line(&a, "p");
    let hoop = check(&a, "hoop_yield").demand.unwrap();
    close(hoop / (largest * 15.0 / 0.014), 1.0, 1e-9);
}

/// An overpressure p pulls at an anchor with p R/2 over its spacing, 2 π 15 m/60; a vacuum does not.
#[test]
fn overpressure_pulls_at_the_anchors() {
    let force = |internal, vacuum| check(&assess(internal, vacuum), "anchorage").demand.unwrap();
    let spacing = 2.0 * PI * 15.0 / 60.0;
    let still = force(0.0, 0.0);
    close((force(20e3, 0.0) - still) / (20e3 * 7.5 * spacing), 1.0, 1e-9);
    close(force(0.0, 20e3) / still, 1.0, 1e-12);
}
