//! Every check of the annex on either side of its limit, and the combination of horizontal with vertical motion.
//!
//! Source:    worked example of `example` with annex A of EN 1998-1 beyond 4 s; statics
//! Goal:      the check holds just below a utilisation of 1 and fails just above it; the factors 1 and 0.3 of E_x and E_z
//! Tolerance: ε = 3e-4; the printed numbers have four or five digits

use std::f64::consts::PI;

use super::example::{check, line, oil_tank, profile, site, steel};
use super::*;
use crate::samples::{bottom_plate, case, concrete_rectangle, course, record};
use tank::case::{Ec8Site, GroundMotion};
use tank::{Anchors, Roof, Support};

const EPSILON: f64 = 3e-4;
const UTILISATIONS: [(f64, bool); 5] =
    [(0.5, true), (1.0 - EPSILON, true), (1.0 + EPSILON, false), (1.04, false), (2.0, false)];

/// `case_at(u)` is the oil tank with the check utilised to u by hand.
fn limit(id: &str, case_at: impl Fn(f64) -> Case) {
    for (u, holds) in UTILISATIONS {
        let a = En2006.assess(&case_at(u), Excitation::Site).unwrap();
        let c = check(&a, id);
        assert_eq!(c.holds(), holds, "{id} at {u}: {c:?}");
        assert!((c.utilisation.unwrap() / u - 1.0).abs() < 0.8 * EPSILON, "{id} at {u}: {c:?}");
    }
}

/// d = R S_e(T_con)/g with S_De = d_g [b + (T − 6)/4 (1 − b)], d_g = 0.1015335 m, b = 3.370999, T_con = 1.57333·√15 = 6.09350 s.
#[test]
fn freeboard() {
    let t_con = (1.60 - 0.08 / 3.0) * 15.0_f64.sqrt();
    let s_de = 0.101_533_5 * (3.370_999 + (t_con - 6.0) / 4.0 * (1.0 - 3.370_999));
    let d_max = 15.0 * s_de * (2.0 * PI / t_con).powi(2) / 9.81;
    limit("freeboard", |u| {
        let mut c = oil_tank();
        // Five courses reach the surface at 12 m; the sixth is the freeboard.
        c.tank.courses[5].height = d_max / u;
        c
    });
}

/// n_a = 268.79 kN/m·189 684.14/189 997.7 (annex A) − 14.732 kN/m, 60 anchors.
#[test]
fn anchorage() {
    let n_a = 189_684.14e3 / (PI * 225.0) - 14_732.3;
    limit("anchorage", |u| {
        let mut c = oil_tank();
        c.tank.anchors = Some(Anchors {
            count: 60,
            capacity: Some(n_a * PI * 30.0 / 60.0 / u),
            attachment_capacity: None,
            ..Anchors::default()
        });
        c
    });
}

/// p_max = 105.948 + 83.736 + 1.8144 kPa at the base, R/s = 15 m/14 mm; f_y decides. The other courses do not yield.
#[test]
fn hoop_yield() {
    let hoop = (105_948.0 + 83_736.0 + 1_814.4) * 15.0 / 0.014;
    limit("hoop_yield", |u| {
        let mut c = oil_tank();
        for (k, course) in c.tank.courses.iter_mut().enumerate() {
            course.material.yield_strength = Some(if k == 0 { hoop / u } else { 1e12 });
        }
        c
    });
}

/// M = 189 684.14 kNm against π/2 D² (w_t + w_L), w_L = 10 mm·√(105.948 kPa·235 MPa); M grows with a_g.
#[test]
fn overturning() {
    let w_l = 0.010 * (105_948.0_f64 * 235e6).sqrt();
    let capacity = PI / 2.0 * 900.0 * (14_732.3 + w_l);
    limit("overturning", |u| {
        let mut c = oil_tank();
        c.tank.support = Support::Unanchored;
        c.tank.bottom = Some(bottom_plate(steel()));
        c.site.ec8 = Some(Ec8Site { ag: 0.25 * 9.81 * capacity / 189_684.14e3 * u, ..site() });
        c
    });
}

/// A light tank under a heavy roof: σ_m = (M/(π R²) + N_0)/s at the base grows with a_g. The limits are the formulas of A.10
/// with the pressures at the base, written out here; a_g is solved for u.
#[test]
fn stability() {
    // One course of 10 mm, so that the base governs; water 1 m deep in R = 5 m keeps the pressures small.
    let build = |ag: f64| {
        let shape = Shape::Cylinder { radius: 5.0 };
        let mut case = case(shape, vec![course(4.0, 0.010, steel())], 2.0, Some(Ec8Site { ag, ..site() }));
        case.tank.roof = Roof { mass: 2.0e6, height: Some(10.0), ..Roof::default() };
        case
    };
    // Moment and pressures are linear in a_g.
    let one = En2006.assess(&build(1.0), Excitation::Site).unwrap();
    let (moment, p_1) = (line(&one, "M"), line(&one, "p_i") + line(&one, "p_c"));
    let weight = (2.0e6 + 2.0 * PI * 5.0 * 4.0 * 0.010 * 7850.0) * 9.81 / (2.0 * PI * 5.0);
    let (e, f_y, s, r) = (210e9, 235e6, 0.010, 5.0);
    let sigma_c1 = 0.6 * e * s / r;
    let utilisation = |id: &str, ag: f64| {
        let sigma = (ag * moment / (PI * r * r) + weight) / s;
        let (p_0, p_h) = (9810.0 * 2.0, ag * p_1);
        let delta = 0.06 * (r / s).sqrt();
        let knock_down = 1.0 - 1.24 * delta * ((1.0 + 2.0 / (1.24 * delta)).sqrt() - 1.0);
        let lambda = f_y / (knock_down * sigma_c1);
        let limit = if id == "buckling_elastic" {
            let sigma_o = if lambda <= 2.0 { f_y * (1.0 - lambda / 4.0) } else { knock_down * sigma_c1 };
            let p_bar = (p_0 - p_h).max(0.0) * r / (s * sigma_c1);
            let loss = (1.0 - p_bar / 5.0) * (1.0 - sigma_o / sigma_c1);
            0.19 * sigma_c1 + 0.81 * sigma_c1 * (1.0 - loss * loss).sqrt()
        } else {
            let rho = r / s / 400.0;
            let hoop = (p_0 + p_h) * r / (s * f_y);
            sigma_c1 * (1.0 - hoop * hoop) * (1.0 - 1.0 / (1.12 + rho.powf(1.15))) * ((rho + f_y / 250e6) / (rho + 1.0))
        };
        sigma / limit
    };
    for id in ["buckling_elastic", "buckling_elastic_plastic"] {
        for (u, holds) in UTILISATIONS {
            let (mut low, mut high) = (0.0, 100.0);
            for _ in 0..80 {
                let ag = 0.5 * (low + high);
                if utilisation(id, ag) < u {
                    low = ag;
                } else {
                    high = ag;
                }
            }
            let a = En2006.assess(&build(low), Excitation::Site).unwrap();
            let c = check(&a, id);
            assert_eq!(c.holds(), holds, "{id} at {u}: {c:?}");
            assert!((c.utilisation.unwrap() / u - 1.0).abs() < 1e-9, "{id} at {u}: {c:?}");
        }
    }
}

/// Rectangle, E_x + 0.3 E_z and 0.3 E_x + E_z: p = max(p_h + 0.3 p_v, 0.3 p_h + p_v), p_h = p_i + p_c, p_v = ρ (H − z) a_vg,
/// with a_vg = 0.9 a_g = 2.6487 m/s².
#[test]
fn rectangle_combines_vertical_motion_with_0_3() {
    let mut c = concrete_rectangle(4.0, false, site());
    c.site.ec8 = Some(Ec8Site { vertical: true, ..site() });
    let a = En2006.assess(&c, Excitation::Site).unwrap();
    assert!((line(&a, "a_vg") - 0.9 * 2.943).abs() < 1e-12);
    assert!((line(&a, "p_v") - 1000.0 * 2.5 * 0.9 * 2.943).abs() < 1e-9);
    let expected = |a: &Assessment, a_v: f64| {
        let (p_i, p_c, p) =
            (profile(a, "pressure_impulsive"), profile(a, "pressure_convective"), profile(a, "pressure_dynamic"));
        let (mut horizontal_leads, mut vertical_leads) = (false, false);
        for k in 0..p.z.len() {
            let h = p_i.values[k] + p_c.values[k];
            let v = 1000.0 * (2.5 - p.z[k]) * a_v;
            let (x, z) = (h + 0.3 * v, 0.3 * h + v);
            horizontal_leads |= x > z * 1.01;
            vertical_leads |= z > x * 1.01;
            assert!((p.values[k] - x.max(z)).abs() < 1e-9 * (h + v), "z = {}: {} {x} {z}", p.z[k], p.values[k]);
        }
        (horizontal_leads, vertical_leads)
    };
    assert!(expected(&a, 0.9 * 2.943).0, "E_x + 0.3 E_z governs somewhere");
    // A vertical record ten times the horizontal one: the other combination governs.
    c.ground_motion = Some(GroundMotion { horizontal: record(0.3), transverse: None, vertical: Some(record(6.0)) });
    let a = En2006.assess(&c, Excitation::Record).unwrap();
    assert!(expected(&a, record(6.0).pga()).1, "0.3 E_x + E_z governs somewhere");
    // Without vertical motion the vertical part is zero.
    let a = En2006.assess(&concrete_rectangle(4.0, false, site()), Excitation::Site).unwrap();
    assert!(a.steps.iter().all(|s| s.symbol != "p_v"));
    expected(&a, 0.0);
}

/// SRSS of the horizontal parts of a rectangle, where chosen.
#[test]
fn rectangle_combines_horizontal_parts_as_chosen() {
    let mut c = concrete_rectangle(4.0, false, site());
    c.procedures.ec8_combination = Combination::Srss;
    let a = En2006.assess(&c, Excitation::Site).unwrap();
    let (p_i, p_c, p) =
        (profile(&a, "pressure_impulsive"), profile(&a, "pressure_convective"), profile(&a, "pressure_dynamic"));
    for k in 0..p.z.len() {
        let expected = p_i.values[k].hypot(p_c.values[k]);
        assert!((p.values[k] - expected).abs() < 1e-9 * expected.max(1.0));
    }
    assert!((line(&a, "p") - p.values[0]).abs() < 1e-9 * p.values[0]);
}

/// Cylinder: the seismic pressure takes the same two combinations, the vertical part being √(p_vr² + p_vf²).
#[test]
fn cylinder_combines_vertical_motion_with_0_3() {
    let mut c = oil_tank();
    c.site.ec8 = Some(Ec8Site { vertical: true, ..site() });
    let a = En2006.assess(&c, Excitation::Site).unwrap();
    let (p_i, p_c, p) =
        (profile(&a, "pressure_impulsive"), profile(&a, "pressure_convective"), profile(&a, "pressure_dynamic"));
    let (rigid, flexible) = (line(&a, "p_vr"), line(&a, "p_vf"));
    for k in 0..p.z.len() {
        let zeta = p.z[k] / 12.0;
        let h = p_i.values[k] + p_c.values[k];
        let v = (rigid * (1.0 - zeta)).hypot(flexible * (0.5 * PI * zeta).cos());
        let expected = (h + 0.3 * v).max(0.3 * h + v);
        assert!((p.values[k] - expected).abs() < 1e-9 * (h + v).max(1.0), "z = {}: {} {expected}", p.z[k], p.values[k]);
    }
}

/// q of the impulsive part is admissible from 1 to 1.5.
#[test]
fn behaviour_factor_at_its_limits() {
    for (q, good) in [(1.0, true), (1.5, true), (1.0 - 1e-9, false), (1.5 + 1e-9, false), (f64::NAN, false)] {
        let mut c = oil_tank();
        c.site.ec8 = Some(Ec8Site { behaviour_factor: q, ..site() });
        assert_eq!(En2006.assess(&c, Excitation::Site).is_ok(), good, "q = {q}");
    }
}
