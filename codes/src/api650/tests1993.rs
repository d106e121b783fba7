//! Source:    API 650, 9th edition; dissertation (2002), table D.2; values computed by an independent script
//! Goal:      every number of the worked example and of the dissertation's table, as printed and as it should be
//! Model:     worked example: see `example`; zone 3, soil S3, I = 1. Table D.2: D = 3.66 m, H = 1.52 m (1.525), W_T = 16.3 t
//! Expected:  per test
//! Tolerance: half the last printed digit
//!
//! Errors of table D.2 that the closed values rest on:
//! * chart readings of two digits (W_1 0.5 instead of 0.46);
//! * C_1 is the peak ground acceleration, not the plateau of the 2 % spectrum, and S_a has 1 % instead of 0.5 % damping;
//!   here both are given, so that does not matter;
//! * the shell's mass is 0.0955 t, not 0.3 t, which is 0.5 % of the moment.

use proptest::prelude::*;

use super::edition1993::{self, Api6501993, CONVECTIVE_MOMENT, IMPULSIVE_MOMENT, convective_coefficient};
use super::example::{case, close, line, steel, with_record};
use super::hold_down::figure_e5;
use super::masses::effective_masses;
use crate::procedure::{CodeError, Procedure};
use crate::sheet::Sheet;
use tank::assessment::{Assessment, Excitation};
use tank::case::Case;
use tank::formula::evaluate;
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Length, LineForce, Moment};
use tank::{Anchors, Shape, Support};

fn assess(case: &Case, excitation: Excitation) -> Assessment {
    Api6501993.assess(case, excitation).expect("the example is admissible")
}

/// b of an unanchored tank with D = 1 m.
fn compression(w_t: f64, w_l: f64, x: f64) -> Option<f64> {
    let terms = [
        ("M", x * (w_t + w_l), Moment),
        ("D", 1.0, Length),
        ("w_t", w_t, LineForce),
        ("w_L", w_l, LineForce),
        ("x", x, Dimensionless),
    ];
    let mut sheet = Sheet::new();
    sheet.given(&terms);
    edition1993::compression(&mut sheet, x)
}

#[test]
fn worked_example() {
    let out = assess(&case(), Excitation::Site);
    for (symbol, printed, digit) in [
        ("W_s", 1_045.1e3, 50.0),
        ("W_r", 343.35e3, 5.0),
        ("W_p", 74_890.2e3, 50.0),
        ("k", 0.60954, 5e-6),
        ("T", 6.0472, 5e-5),
        ("C_2", 0.13844, 5e-6),
        ("M", 40.445e6, 500.0),
        ("w_L", 49_874.8, 0.05),
        ("w_t", 14_732.3, 0.05),
        ("x", 0.6956, 5e-5),
        ("b", 71_939.0, 0.5),
        ("f", 5.139e6, 500.0),
        ("F_a", 38.73e6, 5e3),
    ] {
        close(line(&out, symbol), printed, digit, symbol);
    }
    let w_p = line(&out, "W_p");
    close(line(&out, "W_1") / w_p, 0.44989, 5e-6, "W_1");
    close(line(&out, "W_2") / w_p, 0.51704, 5e-6, "W_2");
    close(line(&out, "X_2") / 12.0, 0.57391, 5e-6, "X_2");
    assert!(out.checks.iter().all(|c| c.holds()), "{:?}", out.checks);
    assert_eq!(out.values[&Quantity::BaseMoment], line(&out, "M"));
    assert!(!out.values.contains_key(&Quantity::SloshingHeight) && !out.values.contains_key(&Quantity::BaseShear));
}

/// The moment times 1.9: x = 1.3216, figure E-5 exact 3.6767, f = 13.405 MPa.
#[test]
fn worked_example_scaled() {
    let out = assess(&case(), Excitation::Site);
    let (w_t, w_l, x) = (line(&out, "w_t"), line(&out, "w_L"), 1.9 * line(&out, "x"));
    close(x, 1.3216, 5e-5, "x");
    close(figure_e5(x).unwrap(), 3.6767, 5e-5, "y");
    close(compression(w_t, w_l, x).unwrap() / 0.014, 13.405e6, 500.0, "f");
    // And through the procedure: importance 1.9 is refused, so the zone factor carries it.
    let mut scaled = case();
    scaled.site.api650.as_mut().unwrap().zone_factor = Some(0.57);
    let out = assess(&scaled, Excitation::Site);
    close(line(&out, "f"), 13.405e6, 500.0, "f by the procedure");
    assert!(out.notes.iter().any(|n| n.contains("table E-2")));
}

/// Weights of table D.2 in tonnes, accelerations in m/s², moments in kNm.
fn d2(w_1: (f64, f64), w_2: (f64, f64), s_a: f64) -> f64 {
    let roof = [("W_r", 0.0), ("H_t", 0.0)];
    let shell = [("a_1", 0.5 * 9.81), ("W_s", 0.3), ("X_s", 0.9), ("W_1", w_1.0), ("X_1", w_1.1)];
    let convective = [("a_2", s_a), ("W_2", w_2.0), ("X_2", w_2.1)];
    evaluate(IMPULSIVE_MOMENT, &[&shell[..], &roof].concat()) + evaluate(CONVECTIVE_MOMENT, &convective)
}

#[test]
fn table_d2() {
    let section_modulus = 0.0211;
    // The closed values belong to H = 1.525 m, the depth of the tank's drawing; the table's 1.52 m gives 0.4 % less.
    let h = 1.525;
    let m = effective_masses(3.66 / h);
    for (record, s_a, rounded, readings, closed, printed, stress, printed_stress) in [
        ("El Centro", 2.40, 42.05, 42.51, 40.00, 42.0, 1.90, 2.0),
        ("Parkfield", 0.27, 26.50, 26.89, 24.60, 26.5, 1.17, 1.3),
        ("Pacoima Dam", 0.66, 29.34, 29.75, 27.42, 29.3, 1.30, 1.4),
    ] {
        // As printed: 0.5·9.81·5 + S_a·7.3, and the moment to three digits (42.05 was truncated).
        let by_sums = 0.5 * 9.81 * 5.0 + s_a * 7.3;
        close(by_sums, rounded, 6e-3, record);
        close(by_sums, printed, 0.055, record);
        close(by_sums / section_modulus / 1e3, printed_stress, 0.05, record);
        // With the chart readings as printed, sums unrounded.
        close(d2((8.15, 0.59), (8.15, 0.90), s_a), readings, 6e-3, record);
        // With the closed charts.
        let moment = d2((m.w_i * 16.3, m.x_i * h), (m.w_c * 16.3, m.x_c * h), s_a);
        close(moment, closed, 6e-3, record);
        close(moment / section_modulus / 1e3, stress, 6e-3, record);
    }
}

#[test]
fn convective_coefficient_is_continuous() {
    for s in [1.0, 1.2, 1.5, 2.0] {
        close(convective_coefficient(s, 4.5), s / 6.0, 1e-15, "C_2 at 4.5 s");
        close(convective_coefficient(s, 4.5 + 1e-9), s / 6.0, 1e-9, "C_2 above 4.5 s");
    }
}

#[test]
fn compression_meets_at_its_thresholds() {
    let (w_t, w_l) = (3.0, 7.0);
    let b = |x| compression(w_t, w_l, x).unwrap();
    // 0.785 for π/4 and 1.273 for 4/π; figure E-5 starts at y = 2, b = w_t + (w_t + w_L).
    close(b(0.785) / b(0.785 + 1e-9), 1.0, 1e-3, "0.785");
    // The printed tail is 1.1 % above the figure at 1.5.
    close((b(1.5 + 1e-9) + w_l) / (b(1.5) + w_l), 1.011, 5e-4, "1.5");
    assert!(compression(w_t, w_l, 1.5698).is_some());
    assert_eq!(compression(w_t, w_l, 1.57), None);
    assert_eq!(compression(w_t, w_l, f64::INFINITY), None);
}

#[test]
fn unstable_tank_fails_its_check_and_says_so() {
    let mut c = case();
    c.tank.bottom.as_mut().unwrap().thickness = 0.002;
    c.site.api650.as_mut().unwrap().zone_factor = Some(0.40);
    let out = assess(&c, Excitation::Site);
    let check = out.checks.iter().find(|c| c.id == "stability").unwrap();
    assert!(!check.holds() && check.demand.unwrap() > check.capacity.unwrap());
    assert!(out.notes.iter().any(|n| n.contains("unstable")), "{:?}", out.notes);
    assert!(!out.checks.iter().any(|c| c.id == "shell_compression"));
}

#[test]
fn missing_data_is_named() {
    let mut c = case();
    c.tank.bottom = None;
    let out = assess(&c, Excitation::Site);
    assert!(out.checks.is_empty() && out.notes.iter().any(|n| n.contains("`tank.bottom` is missing")));
    let mut c = case();
    c.tank.bottom.as_mut().unwrap().material.yield_strength = None;
    let out = assess(&c, Excitation::Site);
    assert!(out.notes.iter().any(|n| n.contains("`materials.steel.yield_strength` is missing")));

    let mut c = case();
    c.tank.support = Support::Anchored;
    c.site.api650.as_mut().unwrap().zone_factor = Some(0.40);
    let out = assess(&c, Excitation::Site);
    assert!(out.notes.iter().any(|n| n.contains("`tank.anchors` is missing")));
    c.tank.anchors =
        Some(Anchors { count: 48, capacity: Some(100e3), attachment_capacity: None, ..Anchors::default() });
    let out = assess(&c, Excitation::Site);
    let anchor = out.checks.iter().find(|c| c.id == "anchor_tension").unwrap();
    close(anchor.demand.unwrap(), line(&out, "w_AB") * std::f64::consts::PI * 30.0 / 48.0, 1e-6, "P_AB");
}

/// Above t_s (and 6 mm) a thicker bottom plate does not count (E.4.2).
#[test]
fn bottom_plate_counts_up_to_the_shell() {
    let with = |t| {
        let mut c = case();
        c.tank.bottom.as_mut().unwrap().thickness = t;
        line(&assess(&c, Excitation::Site), "t_b")
    };
    assert_eq!((with(0.010), with(0.014), with(0.020)), (0.010, 0.014, 0.014));
}

#[test]
fn scope() {
    let mut c = case();
    c.tank.shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    assert!(Api6501993.applies(&c, Excitation::Site).unwrap_err().reason.contains("rectangular"));
    let mut c = case();
    assert!(Api6501993.applies(&c, Excitation::Record).unwrap_err().reason.contains("no record"));
    c.site.api650.as_mut().unwrap().zone_factor = None;
    assert!(
        matches!(Api6501993.assess(&c, Excitation::Site), Err(CodeError::NotApplicable(n)) if n.reason.contains("zone_factor"))
    );
    c.site.api650 = None;
    assert!(Api6501993.applies(&c, Excitation::Site).is_err());
    let mut c = case();
    c.site.api650.as_mut().unwrap().soil_factor = 7.0;
    assert!(matches!(Api6501993.assess(&c, Excitation::Site), Err(CodeError::Data { .. })));
}

/// Spectrum method: the moment is that of the ordinates, whatever the zone.
#[test]
fn ordinates_of_the_record() {
    let c = with_record(case());
    let out = assess(&c, Excitation::Record);
    let record = &c.ground_motion.as_ref().unwrap().horizontal;
    let sa = |t: f64, damping: f64| oscillator::spectrum::ordinates(record, t, damping).psa / 9.81;
    let (t, a_1) = (line(&out, "T"), line(&out, "A_1"));
    close(line(&out, "A_2"), sa(t, 0.005), 1e-12, "A_2");
    // Resonant at 2π/15.7 = 0.400 s: larger than at any coarse sample of periods.
    for period in [0.06, 0.1, 0.2, 0.3, 0.5] {
        assert!(a_1 >= sa(period, 0.02) * 0.999);
    }
    assert!(a_1 > 2.0 * record.pga() / 9.81);
    let mut damped = c.clone();
    damped.damping.impulsive = 0.05;
    let other = assess(&damped, Excitation::Record);
    assert!(other.notes.iter().any(|n| n.contains("fixes 2 % and 0.5 %")));
    assert_eq!(line(&other, "M"), line(&out, "M"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Any tank: finite values, moment proportional to the zone factor, compression growing with it.
    #[test]
    fn any_tank(radius in 1.0..45.0f64, depth in 0.5..14.0f64, t in 0.004..0.03f64, z in 0.01..0.2f64) {
        let mut c = case();
        c.tank.shape = Shape::Cylinder { radius };
        c.liquid.fill_height = depth;
        c.tank.courses[0].thickness = t;
        c.tank.courses[0].material = steel();
        c.tank.support = Support::Anchored;
        c.site.api650.as_mut().unwrap().zone_factor = Some(z);
        let one = assess(&c, Excitation::Site);
        c.site.api650.as_mut().unwrap().zone_factor = Some(2.0 * z);
        let two = assess(&c, Excitation::Site);
        prop_assert!(one.values.values().all(|v| v.is_finite() && *v > 0.0));
        prop_assert!((line(&two, "M") / line(&one, "M") - 2.0).abs() < 1e-12);
        prop_assert!(line(&two, "f") > line(&one, "f"));
    }
}

/// The strips stand beside x and b and decide nothing: k/3, k, 3k and concrete, as nothing is said of the foundation. Under a round rim the toe carries more
/// on harder ground; a foot that warps freely spreads it.
#[test]
fn strips_of_the_bottom_stand_beside() {
    let mut case = case();
    case.tank.roof.holds = tank::RimSupport::Round;
    let out = assess(&case, Excitation::Site);
    let lines: Vec<&tank::assessment::Step> = out.steps.iter().filter(|s| s.section.contains("strips")).collect();
    let values = |symbol: &str| -> Vec<f64> { lines.iter().filter(|s| s.symbol == symbol).map(|s| s.value).collect() };
    assert_eq!((values("ψ").len(), values("w").len(), values("σ_t").len()), (4, 4, 4));
    assert!(values("σ_t").windows(2).all(|s| s[1] > s[0]), "{:?}", values("σ_t"));
    assert!(out.checks.iter().all(|c| !c.id.contains("uplift")));
}
