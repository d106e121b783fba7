//! Number of anchors, connections, welds, support and ground of the worked example.
//!
//! Source:    `example`, with the numbers of `docs/theory/api650.md`; second computation in plain numbers
//! Goal:      each detail holds, fails or is asked for as its clause says
//! Tolerance: that of the printed numbers

use std::f64::consts::PI;

use super::rest_tests::{assess, check};
use super::*;
use crate::api650::example::{case, close, line};
use tank::{Anchors, BottomConnections, Foundation, FoundationKind, Joint, ShellSupport, Support};

fn founded(case: &mut Case, kind: FoundationKind, width: Option<f64>) {
    case.tank.foundation = Some(Foundation {
        kind,
        stiffness: None,
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 0.33,
        thickness: None,
        width,
        friction: None,
    });
}

fn allow(case: &mut Case, pressure: f64) {
    case.site.api650.as_mut().unwrap().bearing_capacity = Some(pressure);
}

/// Anchors enough for any pull.
fn anchored(count: u32) -> Case {
    let mut case = case();
    case.tank.support = Support::Anchored;
    case.tank.anchors =
        Some(Anchors { count, capacity: Some(1e9), attachment_capacity: Some(1e9), ..Anchors::default() });
    case
}

/// Public agenda text: at least four, six where the earthquake governs.
#[test]
fn six_anchors_where_the_earthquake_pulls() {
    for (count, holds) in [(1, false), (5, false), (6, true), (60, true)] {
        let out = assess(&anchored(count));
        let found = check(&out, "anchor_count");
        assert_eq!(found.holds(), holds, "{count}");
        assert_eq!(found.demand, Some(6.0));
    }
    // Without pull four.
    let mut heavy = anchored(4);
    heavy.tank.roof.mass = 5e6;
    let out = assess(&heavy);
    assert!(line(&out, "w_AB") < 0.0);
    assert!(check(&out, "anchor_count").holds());
    assert_eq!(check(&out, "anchor_count").demand, Some(4.0));
}

/// 4 P_AB, and the yield force where that is less.
#[test]
fn connections_of_anchors() {
    let mut case = anchored(60);
    let out = assess(&case);
    let pull = line(&out, "w_AB") * PI * 30.0 / 60.0;
    close(check(&out, "connections").demand.unwrap() / pull, 4.0, 1e-12, "4 P_AB");
    let anchors = case.tank.anchors.as_mut().unwrap();
    (anchors.attachment_capacity, anchors.yield_force) = (Some(3.5 * pull), None);
    let out = assess(&case);
    assert!(check(&out, "anchor_attachment").holds() && !check(&out, "connections").holds());
    case.tank.anchors.as_mut().unwrap().yield_force = Some(3.2 * pull);
    assert!(check(&assess(&case), "connections").holds());
}

/// L of the example and 300 mm.
#[test]
fn connections_through_the_bottom() {
    let mut case = case();
    let needed = line(&assess(&case), "L") + 0.3;
    assert_eq!(check(&assess(&case), "connections").input.as_deref(), Some("tank.bottom.connections"));
    for (distance, holds) in [(1.001 * needed, true), (0.999 * needed, false)] {
        case.tank.details.bottom_connections = Some(BottomConnections::Within(distance));
        assert_eq!(check(&assess(&case), "connections").holds(), holds);
    }
    case.tank.details.bottom_connections = Some(BottomConnections::None);
    assert_eq!(check(&assess(&case), "connections").status, CheckStatus::NotApplicable);
}

/// Two fillets of 6 mm under 14 mm of shell: V_max over 8.484 mm against 0.8 · 235 MPa.
#[test]
fn shear_of_the_welds() {
    let mut case = case();
    let out = assess(&case);
    let flow = 2.0 * line(&out, "V") / (PI * 30.0);
    let found = check(&out, "shear_transfer");
    close(found.demand.unwrap() / (flow / 0.008484), 1.0, 1e-9, "τ");
    close(found.capacity.unwrap(), 188e6, 1.0, "0.8 F_y");
    case.tank.details.shell_weld = Some(flow / (1.414 * 188e6) * 0.999);
    assert!(!check(&assess(&case), "shear_transfer").holds());
    case.tank.courses[0].material.yield_strength = None;
    let input = check(&assess(&case), "shear_transfer").input.clone();
    assert_eq!(input.as_deref(), Some("materials.steel.yield_strength"));
}

/// 161.9 kPa under a slab; the ring by hand.
#[test]
fn ground() {
    let mut case = case();
    assert_eq!(check(&assess(&case), "bearing").input.as_deref(), Some("site.api650.bearing_capacity"));
    allow(&mut case, 162e3);
    assert_eq!(check(&assess(&case), "bearing").input.as_deref(), Some("tank.foundation"));
    founded(&mut case, FoundationKind::Slab, None);
    let out = assess(&case);
    close(check(&out, "bearing").demand.unwrap(), 161.9e3, 100.0, "slab");
    assert!(check(&out, "bearing").holds());
    allow(&mut case, 161e3);
    assert!(!check(&assess(&case), "bearing").holds());
    founded(&mut case, FoundationKind::RingWall, None);
    assert_eq!(check(&assess(&case), "bearing").input.as_deref(), Some("tank.foundation.width"));
    founded(&mut case, FoundationKind::RingWall, Some(0.5));
    let out = assess(&case);
    let (m_s, m_rw) = (line(&out, "M_s"), line(&out, "M_rw"));
    let area = PI * 225.0;
    let floor = check(&out, "bearing");
    let weight = line(&out, "W_p") + 9.81 * 7850.0 * case.tank.bottom.as_ref().unwrap().thickness * area;
    let inside = weight * (1.0 + 0.4 * line(&out, "A_v")) / area + 32.0 * (m_s - m_rw) / (PI * 27000.0);
    let ring = line(&out, "σ_c") * 0.014 / 0.5 + 0.5 * inside;
    close(floor.demand.unwrap() / ring.max(inside), 1.0, 1e-6, "ring");
    // A narrower ring presses more, and a wide one not less than the liquid.
    founded(&mut case, FoundationKind::RingWall, Some(50.0));
    close(check(&assess(&case), "bearing").demand.unwrap() / inside, 1.0, 1e-6, "wide ring");
}

/// Agenda item 650-1003: seismic use group III with S_DS of at least 0.5 g, or plates thicker than 10 mm.
#[test]
fn welds_of_annular_plates() {
    for (sug, ss, thickness, asked) in [
        (3, 1.0, 0.008, true),
        (2, 1.0, 0.008, false),
        (3, 0.3, 0.008, false),
        (1, 0.3, 0.0101, true),
        (1, 0.3, 0.010, false),
    ] {
        let mut case = case();
        case.tank.bottom.as_mut().unwrap().thickness = thickness;
        let site = case.site.api650.as_mut().unwrap();
        (site.sug, site.ss, site.fa, site.fv) = (sug, ss, Some(1.0), Some(1.0));
        for (weld, status) in [
            (None, CheckStatus::NotChecked),
            (Some(Joint::Lap), CheckStatus::Fails),
            (Some(Joint::Butt), CheckStatus::Holds),
        ] {
            case.tank.details.annular_weld = weld;
            let found = check(&assess(&case), "annular_weld").status;
            let wanted = if asked { status } else { CheckStatus::NotApplicable };
            assert_eq!(found, wanted, "{sug} {ss} {thickness} {weld:?}");
        }
    }
}

/// E.7.9: anchored on grout alone; self-anchored on concrete on grout, a pad, or butt-welded plates.
#[test]
fn supports_of_the_shell() {
    use CheckStatus::{Fails, Holds, NotApplicable, NotChecked};
    use ShellSupport::{ButtWelded, Grouted, Padding, Shims};
    let end = |mut case: Case, support, weld| {
        case.tank.details.shell_support = support;
        case.tank.details.annular_weld = weld;
        let out = assess(&case);
        let states = Api6502020.limit_states(&case);
        let all = tank::check::complete(&states, out.checks);
        all.into_iter().find(|check| check.id == "shell_support").unwrap().status
    };
    let mut slab = case();
    founded(&mut slab, FoundationKind::Slab, None);
    for (support, weld, status) in [
        (None, None, NotChecked),
        (Some(Grouted), None, Holds),
        (Some(Padding), None, Holds),
        (Some(ButtWelded), Some(Joint::Butt), Holds),
        (Some(ButtWelded), Some(Joint::Lap), Fails),
        (Some(ButtWelded), None, NotChecked),
        (Some(Shims), None, NotChecked),
    ] {
        assert_eq!(end(slab.clone(), support, weld), status, "{support:?}");
    }
    assert_eq!(end(case(), None, None), NotChecked);
    let mut soil = case();
    founded(&mut soil, FoundationKind::Soil, None);
    assert_eq!(end(soil, None, None), NotApplicable);
    for (support, status) in [(Grouted, Holds), (Padding, Fails), (Shims, Fails)] {
        assert_eq!(end(anchored(60), Some(support), None), status, "{support:?}");
    }
}

/// Stainless steel of 195 GPa: F_C of steel times 195/200, and nothing else.
#[test]
fn stainless_steel() {
    let mut case = case();
    let steel = line(&assess(&case), "F_C");
    for course in &mut case.tank.courses {
        course.material.youngs_modulus = 195e9;
        course.material.family = Some(tank::Family::Stainless);
    }
    close(line(&assess(&case), "F_C") / steel, 0.975, 1e-9, "F_C");
    let state = |case: &Case| {
        let states = Api6502020.limit_states(case);
        states.into_iter().find(|state| state.id == "wall_material").unwrap().requirement
    };
    assert!(matches!(state(&case), tank::assessment::Requirement::NotApplicable(_)));
    case.tank.courses[2].material.family = None;
    let wanted = tank::assessment::Requirement::Missing("materials.steel.family".into());
    assert_eq!(state(&case), wanted);
}
