//! The toe of the oil tank without anchors.
//!
//! Source:    equilibrium by hand; plate of 10 mm, f_y = 235 MPa, wall of 14 mm, p_0 = 900·9.81·12 = 105 948 Pa
//! Goal:      pressure and force at the toe, each limit from both sides, a slab, what is missing, the same state in all checks
//! Tolerance: 1e-9 where lines of the sheet enter, 1e-6 for the arc in equilibrium

use std::f64::consts::PI;

use super::super::super::En2006;
use super::super::super::example::{check, line, oil_tank, site, steel};
use crate::Procedure;
use crate::samples::{bottom_plate, close};
use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};
use tank::{Anchors, Foundation, FoundationKind, Pipes, Support};

fn foundation(kind: FoundationKind) -> Foundation {
    Foundation {
        kind,
        stiffness: None,
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 1.0 / 3.0,
        width: None,
        thickness: None,
        friction: None,
    }
}

/// The oil tank, which lifts at 0.08 g.
fn lifting(kind: FoundationKind, resistance: f64) -> Case {
    let mut case = oil_tank();
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(bottom_plate(steel()));
    case.tank.foundation = Some(foundation(kind));
    case.site.ec8 = Some(Ec8Site { ag: 0.08 * 9.81, bearing_capacity: Some(resistance), ..site() });
    case
}

fn assess(case: &Case) -> Assessment {
    En2006.assess(case, Excitation::Site).unwrap()
}

fn ring(resistance: f64) -> Case {
    let mut case = lifting(FoundationKind::RingWall, resistance);
    let ring = case.tank.foundation.as_mut().unwrap();
    (ring.width, ring.thickness) = (Some(0.6), Some(1.0));
    case
}

/// A ring wall under a wall that does not lift, on anchors or on its own weight: w_t + n_z over the ring. The rigid base spreads the liquid over
/// the whole plan and holds on both.
#[test]
fn ring_wall_under_a_wall_that_bears() {
    let mut anchored = ring(1e9);
    anchored.tank.support = Support::Anchored;
    anchored.tank.anchors = Some(Anchors { capacity: Some(1e9), count: 40, ..Anchors::default() });
    let mut heavy = ring(1e9);
    heavy.site.ec8 = Some(Ec8Site { ag: 0.002 * 9.81, bearing_capacity: Some(1e9), ..site() });
    for case in [anchored, heavy] {
        let a = assess(&case);
        let demand = check(&a, "bearing_ring").demand.unwrap();
        let (force, pressure) = (line(&a, "n_T"), line(&a, "p_T"));
        close(demand / (force / 0.6 + pressure + 24_525.0), 1.0, 1e-9);
        // Weight of the wall and M/(π R²).
        let tank = &case.tank;
        let (radius, mass) = (tank.shape.half_length(), tank.wall_mass() + tank.roof.mass);
        let moment = a.values[&tank::Quantity::BaseMoment] / (PI * radius * radius);
        close((force - moment) / (mass * case.gravity / (2.0 * PI * radius)), 1.0, 1e-2);
        for (resistance, holds) in [(demand * 0.999, false), (demand * 1.001, true)] {
            let mut case = case.clone();
            case.site.ec8.as_mut().unwrap().bearing_capacity = Some(resistance);
            assert_eq!(check(&assess(&case), "bearing_ring").holds(), holds);
        }
        let mut case = case.clone();
        case.tank.foundation.as_mut().unwrap().width = None;
        let a = assess(&case);
        assert_eq!(check(&a, "bearing").input.as_deref(), Some("tank.foundation.width"));
    }
}

/// A line load at the centre of a strip: n/b, the liquid and the weight of 1 m of concrete, 2500·9.81 = 24 525 Pa.
#[test]
fn ring_wall() {
    let a = assess(&ring(1e9));
    let (force, pressure) = (line(&a, "n_T"), line(&a, "p_T"));
    assert!(pressure > 105_948.0 && force > line(&a, "w_t"));
    let demand = check(&a, "bearing_ring").demand.unwrap();
    close(demand / (force / 0.6 + pressure + 24_525.0), 1.0, 1e-9);
    for (resistance, holds) in [(demand * 0.999, false), (demand * 1.001, true)] {
        assert_eq!(check(&assess(&ring(resistance)), "bearing_ring").holds(), holds);
    }
    for (path, change) in [
        ("tank.foundation.width", (|f| f.width = None) as fn(&mut Foundation)),
        ("tank.foundation.thickness", |f| f.thickness = None),
    ] {
        let mut case = ring(1e9);
        change(case.tank.foundation.as_mut().unwrap());
        let a = assess(&case);
        let open = check(&a, "bearing");
        assert_eq!((open.status, open.input.as_deref()), (CheckStatus::NotChecked, Some(path)));
    }
}

/// The arc on which the wall stands carries its weight and the pull of the lifted part, and the moment: integrated over the circle. The
/// force at the toe is that of the arc, or the larger one of the strips.
#[test]
fn the_toe_is_in_equilibrium() {
    let mut case = ring(1e9);
    case.site.ec8.as_mut().unwrap().ag = 0.10 * 9.81;
    let a = assess(&case);
    let [weight, pull, moment, peak] = ["w_t", "w_L", "M", "N_u"].map(|symbol| line(&a, symbol));
    assert!(line(&a, "x") > 0.25 * PI, "{}", line(&a, "x"));
    let sums = |beta: f64| {
        let n = 100_000;
        (0..n).fold((0.0, 0.0), |(force, about), i| {
            let phi = PI * (f64::from(i) + 0.5) / f64::from(n);
            let share = (phi.cos() - beta.cos()).max(0.0) / (1.0 - beta.cos());
            let up = ((peak + pull) * share - pull) * 30.0 * PI / f64::from(n);
            (force + up, about + up * 15.0 * phi.cos())
        })
    };
    let (mut low, mut high) = (0.01, PI);
    for _ in 0..60 {
        let beta = 0.5 * (low + high);
        if sums(beta).0 < 30.0 * PI * weight { low = beta } else { high = beta }
    }
    close(sums(0.5 * (low + high)).1 / moment, 1.0, 1e-6);
    let strips = a.steps.iter().filter(|s| s.symbol == "n_t").map(|s| s.value);
    close(line(&a, "n_T") / strips.fold(peak, f64::max), 1.0, 1e-12);
}

/// Ends that just yield: under q = R_d − p the end of a plate of 1 m width has the elastic moment f_y s_b²/6.
#[test]
fn plate_on_soil() {
    let resistance = 400e3;
    let a = assess(&lifting(FoundationKind::Soil, resistance));
    let (force, pressure) = (line(&a, "n_T"), line(&a, "p_T"));
    let elastic = 235e6 * 0.010 * 0.010 / 6.0;
    let inside = (2.0 * elastic / (resistance - pressure)).sqrt();
    let found = check(&a, "bearing_toe");
    let capacity = (resistance - pressure) * inside + resistance * 0.014;
    close(found.capacity.unwrap() / capacity, 1.0, 1e-9);
    close(found.demand.unwrap() / force, 1.0, 1e-12);
    assert_eq!(found.holds(), force <= capacity);
    // A projection of 50 mm, shorter than the end that yields, bears on all of it.
    let mut case = lifting(FoundationKind::Soil, resistance);
    case.tank.bottom.as_mut().unwrap().projection = 0.05;
    let wider = check(&assess(&case), "bearing_toe").capacity.unwrap();
    close((wider - found.capacity.unwrap()) / (0.05 * resistance), 1.0, 1e-6);
    // Enough of it holds.
    let strong = assess(&lifting(FoundationKind::Soil, 4e6));
    assert!(check(&strong, "bearing_toe").holds() && check(&strong, "bearing").holds());
}

/// A slab spreads the toe.
#[test]
fn slab_and_none() {
    let a = assess(&lifting(FoundationKind::Slab, 400e3));
    assert!(check(&a, "bearing").holds());
    // Without one the plate lies on the ground.
    let mut case = lifting(FoundationKind::Soil, 400e3);
    case.tank.foundation = None;
    let a = assess(&case);
    assert!(check(&a, "bearing_toe").capacity.is_some());
}

/// Anchors that fail hold nothing down: compression, bearing and pipes are open, whatever their numbers; anchors that hold decide for all.
#[test]
fn one_state_of_the_base() {
    for (capacity, status) in [(1.0, CheckStatus::NotChecked), (1e9, CheckStatus::Holds)] {
        let mut case = lifting(FoundationKind::Slab, 1e9);
        case.tank.support = Support::Anchored;
        case.tank.anchors = Some(Anchors { capacity: Some(capacity), count: 40, ..Anchors::default() });
        case.tank.pipes =
            Some(Pipes { support_distance: Some(5.0), allowable_displacement: Some(1.0), ..Pipes::default() });
        let a = assess(&case);
        for id in ["buckling_elastic", "buckling_elastic_plastic", "bearing", "pipes"] {
            assert_eq!(check(&a, id).status, status, "{id} {capacity}");
        }
    }
}
