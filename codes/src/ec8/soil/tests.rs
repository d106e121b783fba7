//! Period and damping on soil.
//!
//! Source:    theory of a structure of one mass on a disc; the numbers of tanks B, C, D by an independent program
//! Goal:      the lines of the sheet, their limits, and that no check changes
//! Tolerance: periods 1 %, as was set; the sheet against its formulas with the numbers put in 1e-9

use super::super::En2006;
use super::super::example::{oil_tank, site};
use crate::Procedure;
use crate::sheet::Sheet;
use crate::slab;
use tank::assessment::{Assessment, Excitation};
use tank::case::Case;
use tank::{Foundation, FoundationKind, Shape, Support};

fn on_slab(velocity: f64) -> Case {
    let mut case = oil_tank();
    case.site.ec8 = Some(site());
    case.tank.support = Support::Anchored;
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Slab,
        stiffness: None,
        shear_wave_velocity: Some(velocity),
        soil_density: 1900.0,
        soil_poisson_ratio: 1.0 / 3.0,
        thickness: None,
        friction: None,
    });
    case
}

fn value(a: &Assessment, symbol: &str) -> f64 {
    let found: Vec<f64> = a.steps.iter().filter(|s| s.symbol == symbol).map(|s| s.value).collect();
    *found.last().unwrap_or_else(|| panic!("no line {symbol}: {:?}", a.notes))
}

fn assess(case: &Case) -> Assessment {
    En2006.assess(case, Excitation::Site).unwrap()
}

/// Tanks B, C, D at V_s = 150, 250, 500 m/s: static period and, by the complex stiffness, period and damping.
#[test]
fn periods_of_three_tanks() {
    type Soil = (f64, [f64; 3]);
    let tanks: [(f64, [f64; 3], [Soil; 3]); 3] = [
        (
            13.9,
            [5.794e6, 6.433, 0.2231],
            [(150.0, [0.3881, 0.3711, 0.241]), (250.0, [0.2934, 0.2842, 0.121]), (500.0, [0.2426, 0.2411, 0.0416])],
        ),
        (
            20.0,
            [7.479e6, 6.065, 0.2181],
            [(150.0, [0.3570, 0.2983, 0.278]), (250.0, [0.2763, 0.2535, 0.137]), (500.0, [0.2340, 0.2306, 0.0480])],
        ),
        (
            6.1,
            [1.0118e6, 4.795, 0.1403],
            [(150.0, [0.2743, 0.2761, 0.133]), (250.0, [0.1992, 0.1990, 0.079]), (500.0, [0.1571, 0.1570, 0.0325])],
        ),
    ];
    for (radius, [mass, height, period], soils) in tanks {
        for (velocity, [on_springs, expected, damping]) in soils {
            let mut case = on_slab(velocity);
            case.tank.shape = Shape::Cylinder { radius };
            case.tank.bottom = None;
            let parts = [[mass, height], [0.0, 0.0], [0.0, 0.0]];
            case.damping.impulsive = 0.02;
            let found = slab::lines(&mut Sheet::new(), &case, parts, period, "").unwrap();
            let complex = found.effective().unwrap();
            for (a, b) in [(found.period, on_springs), (complex.period, expected), (complex.damping, damping)] {
                assert!((a / b - 1.0).abs() < 0.01, "R = {radius}, V_s = {velocity}: {a}, expected {b}");
            }
        }
    }
}

/// The line of the sheet satisfies its own fixed point; hard soil leaves period and damping.
#[test]
fn the_sheet_has_period_and_damping() {
    let a = assess(&on_slab(200.0));
    let [t, k, k_x, k_t, h] = ["T_e", "k_e", "K_x", "K_θ", "h_e"].map(|s| value(&a, s));
    let fixed = a.values[&tank::Quantity::ImpulsivePeriod];
    let r: f64 = 15.0 + on_slab(200.0).tank.bottom.map_or(0.0, |b| b.projection);
    let square = (0.8 * std::f64::consts::TAU / t * r / 200.0).powi(2);
    let share = square / (1.0 + square);
    // ν = 1/3: α_x = 1, α_θ = 1 − ½ s.
    let expected = fixed * (1.0 + k / k_x + k * h * h / (k_t * (1.0 - 0.5 * share))).sqrt();
    assert!((t / expected - 1.0).abs() < 1e-9, "{t} {expected}");
    assert!(t > 1.02 * fixed && value(&a, "ξ_e") > value(&a, "ξ_ec"));
    assert!(a.notes.iter().any(|n| n.contains("for information; forces and checks")));

    let hard = assess(&on_slab(1e5));
    assert!((value(&hard, "T_e") / fixed - 1.0).abs() < 1e-5);
    assert!((value(&hard, "ξ_e") / value(&hard, "ξ_i") - 1.0).abs() < 1e-3);
}

/// Checks and values are those without soil; an unanchored tank and a wall on soil have no such lines.
#[test]
fn nothing_else_changes() {
    let with = assess(&on_slab(200.0));
    let mut plain = on_slab(200.0);
    plain.tank.foundation = None;
    let without = assess(&plain);
    assert_eq!(with.values, without.values);
    assert_eq!(with.checks, without.checks);
    assert!(without.steps.iter().all(|s| s.symbol != "T_e"));
    let mut free = on_slab(200.0);
    free.tank.support = Support::Unanchored;
    let free = assess(&free);
    assert!(free.steps.iter().all(|s| s.symbol != "T_e"));
    assert!(free.notes.iter().any(|n| n.contains("the tank is not anchored")));
}
