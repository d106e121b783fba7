//! Whole procedures: the dissertation's tank, records, unanchored walls, limits of scope.
//!
//! Source:    dissertation tables 8.1 and D.3; closed forms; integration of the profiles; scaling laws
//! Goal:      branches that the oil tank of `example` does not reach
//! Tolerance: stated with each value

use super::example::{check, close, integral, line, oil_tank, profile, site, steel};
use super::*;
use crate::api650::hold_down::figure_e5;
use crate::samples::{self, bottom_plate, record};
use oscillator::spectrum::ordinates;
use tank::assessment::CheckStatus;
use tank::case::{Damping, Ec8Site, GroundMotion, GroundType};
use tank::quantity::Quantity;
use tank::{Anchors, Support};

const GRAVITY: f64 = 9.81;

/// The dissertation's broad aluminium tank, 8.1, on ground A with 0.5 g.
fn broad_tank() -> Case {
    samples::broad_tank(Ec8Site { ground: GroundType::A, ag: 0.5 * GRAVITY, importance: 1.0, ..site() })
}

/// Table D.3 with η unrounded: 0.84·1.83 m·0.3645 = 0.560 m (printed 55.0 cm comes from η = 1.5, see `spectrum`), and under
/// EN 1998-1:2004 with 0.5 %: 0.472 m.
#[test]
fn broad_tank_wave_height() {
    let mut case = broad_tank();
    case.damping = Damping { sloshing: 0.01, impulsive: 0.01 };
    let env = Env1998.assess(&case, Excitation::Site).unwrap();
    close(env.values[&Quantity::SloshingHeight], 0.560, 5e-4);
    close(env.values[&Quantity::SloshingPeriod], 2.0952, 5e-5); // 2π/2.9989
    close(line(&env, "T_B"), 0.1, 0.0);
    case.damping.sloshing = 0.005;
    let en = En2006.assess(&case, Excitation::Site).unwrap();
    close(en.values[&Quantity::SloshingHeight], 0.472, 5e-4);
    // 0.305 m of freeboard are not enough for either.
    assert!(!check(&env, "freeboard").holds() && !check(&en, "freeboard").holds());
    // The coupled finite-element model has ω = 164.67 rad/s and h = 0.4205 H.
    case.procedures.ec8_impulsive = FlexibleImpulsive::Iterative;
    let en = En2006.assess(&case, Excitation::Site).unwrap();
    close(2.0 * std::f64::consts::PI / en.values[&Quantity::ImpulsivePeriod], 164.67, 0.5); // 0.3 %, no sloshing here
    close(line(&en, "m_f") / case.liquid_mass(), 0.475, 5e-3);
}

/// With a record every ordinate is the record's pseudo-acceleration; q of the site does not act.
#[test]
fn record_replaces_the_design_spectrum() {
    let mut case = oil_tank();
    case.site.ec8 = Some(Ec8Site { behaviour_factor: 1.5, ..site() });
    case.ground_motion = Some(GroundMotion { horizontal: record(3.0), transverse: None, vertical: None });
    for procedure in [&En2006 as &dyn Procedure, &Env1998] {
        let a = procedure.assess(&case, Excitation::Record).unwrap();
        let psa = |period: &str, damping| ordinates(&record(3.0), line(&a, period), damping).psa;
        close(line(&a, "S_e(T_c1)"), psa("T_c1", 0.005), 1e-12);
        let t_i = a.values[&Quantity::ImpulsivePeriod];
        close(line(&a, "S_e(T_i)"), ordinates(&record(3.0), t_i, 0.02).psa, 1e-12);
        close(line(&a, "PGA"), record(3.0).pga(), 0.0);
        close(a.values[&Quantity::SloshingHeight], 0.84 * 15.0 * psa("T_c1", 0.005) / GRAVITY, 1e-12);
        assert!(a.assumptions.iter().any(|n| n.contains("q = 1")));
        assert!(a.steps.iter().all(|s| s.symbol != "q"));
        assert!(a.notes.iter().all(|n| !n.contains("3.2.2.2")));
    }
    // The behaviour factor of the site divides the impulsive part only.
    let q = En2006.assess(&case, Excitation::Site).unwrap();
    let one = En2006.assess(&oil_tank(), Excitation::Site).unwrap();
    close(line(&q, "Q_i"), line(&one, "Q_i") / 1.5, 1.0);
    close(line(&q, "Q_c"), line(&one, "Q_c"), 1e-6);
    close(line(&q, "d_max"), line(&one, "d_max"), 0.0);
}

/// A vertical record: rigid part with its peak, breathing part with its spectrum.
#[test]
fn vertical_record() {
    let mut case = oil_tank();
    case.ground_motion = Some(GroundMotion { horizontal: record(3.0), transverse: None, vertical: Some(record(1.5)) });
    let a = En2006.assess(&case, Excitation::Record).unwrap();
    close(line(&a, "p_vr"), 900.0 * 12.0 * record(1.5).pga(), 1e-6);
    let breathing = ordinates(&record(1.5), line(&a, "T_vd"), 0.03).psa;
    close(line(&a, "p_vf"), 0.815 * line(&a, "f") * 900.0 * 12.0 * breathing, 1e-6);
}

/// Exact series and coupled mode: masses of the rigid tank, T_f of the shell, other combinations by hand.
#[test]
fn iterative_procedure() {
    let mut case = oil_tank();
    case.procedures.ec8_impulsive = FlexibleImpulsive::Iterative;
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let mode = flexible::coupled_mode(15.0, &case.tank.courses, case.liquid, shell_mode::Base::Clamped).unwrap();
    close(a.values[&Quantity::ImpulsivePeriod], mode.period, 1e-12);
    // Table A.2 (0.1905 s) is 1.3 % short of this mode; the formula of A.3.1 (massless uniform wall of the thickness at H/3) 8 %.
    close(0.1905 / mode.period, 1.0, 0.02);
    close(line(&a, "T_f") / mode.period, 1.0, 0.09);
    close(a.values[&Quantity::ImpulsiveMass] / 7_634_070.0, 0.46364, 5e-6);
    close(a.values[&Quantity::ConvectiveMass] / 7_634_070.0, 0.51140, 5e-6);
    let (m, a_i, a_g) = (line(&a, "m"), line(&a, "S_e(T_i)"), 2.943 * 1.15);
    let (m_i, m_f) = (a.values[&Quantity::ImpulsiveMass], line(&a, "m_f"));
    let q_c = line(&a, "Q_c");
    close(line(&a, "Q_a"), (m_i * a_g).hypot(m_f * a_i) + q_c, 1e-3 * m);
    close(line(&a, "Q_c"), 0.51140 * m * line(&a, "S_e(T_c1)"), 1e-4 * m);
    let three = a.steps.iter().rev().find(|s| s.symbol == "Q_c").unwrap().value;
    close(three, ((m_i - m_f) * a_g).hypot(m_f * a_i) + q_c, 1e-3 * m);
    // Moments: the same with the levers of the parts.
    let circle = crate::mechanical::Plan::Circle;
    let h_i = 12.0 * crate::mechanical::impulsive(circle, 0.8).lever;
    let h_c = 12.0 * crate::mechanical::convective(circle, 0.8, 1).lever;
    let (rigid, flexible) = (m_i * h_i, m_f * 12.0 * mode.field.lumped.lever);
    let a_c = line(&a, "S_e(T_c1)");
    let convective = crate::mechanical::convective(circle, 0.8, 1).mass * m * h_c * a_c;
    let expected = (rigid * a_g).hypot(flexible * a_i) + convective;
    close(line(&a, "M_a") / expected, 1.0, 1e-9);
    let three = a.steps.iter().rev().find(|s| s.symbol == "M_c").unwrap().value;
    let expected = ((rigid - flexible) * a_g).hypot(flexible * a_i) + convective;
    close(three / expected, 1.0, 1e-9);
    // Same demand: ENV without the spectrum's differences has the same masses.
    let env = Env1998.assess(&case, Excitation::Site).unwrap();
    close(env.values[&Quantity::ImpulsivePeriod], mode.period, 1e-12);
}

/// Outside table A.2: exact series, coupled mode, and a note. Inside: no such note.
#[test]
fn outside_the_table() {
    let mut case = oil_tank();
    case.liquid.fill_height = 3.0;
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    assert!(a.notes.iter().any(|n| n.contains("outside the 0.3 to 3.0")));
    let exact = crate::mechanical::impulsive(crate::mechanical::Plan::Circle, 0.2);
    close(a.values[&Quantity::ImpulsiveMass] / case.liquid_mass(), exact.mass, 1e-12);
    let mode = flexible::coupled_mode(15.0, &case.tank.courses, case.liquid, shell_mode::Base::Clamped).unwrap();
    close(a.values[&Quantity::ImpulsivePeriod], mode.period, 1e-12);
    let inside = En2006.assess(&oil_tank(), Excitation::Site).unwrap();
    assert!(inside.notes.iter().all(|n| !n.contains("outside")));
}

/// The profiles integrate to the resultants of the exact series: Q = πR∫p dz, M = πR∫p z dz (trapezoidal rule, 40 steps: 0.3 %).
#[test]
fn profiles_integrate_to_the_resultants() {
    let mut case = oil_tank();
    case.procedures.ec8_impulsive = FlexibleImpulsive::Iterative;
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let pi_r = std::f64::consts::PI * 15.0;
    let (m_i, a_i) = (a.values[&Quantity::ImpulsiveMass], line(&a, "S_e(T_i)"));
    let p_i = profile(&a, "pressure_impulsive");
    close(pi_r * integral(p_i, 0) / (m_i * a_i), 1.0, 3e-3);
    close(pi_r * integral(p_i, 1) / (m_i * line(&a, "h_i") * a_i), 1.0, 3e-3);
    let (m_c, a_c) = (a.values[&Quantity::ConvectiveMass], line(&a, "S_e(T_c1)"));
    let p_c = profile(&a, "pressure_convective");
    close(pi_r * integral(p_c, 0) / (m_c * a_c), 1.0, 3e-3);
    close(pi_r * integral(p_c, 1) / (m_c * line(&a, "h_c1") * a_c), 1.0, 3e-3);
    for p in &a.profiles {
        assert!(p.z.windows(2).all(|z| z[0] < z[1]), "{}", p.id);
        assert!(p.values.iter().all(|v| v.is_finite() && *v >= 0.0), "{}", p.id);
    }
    // Hoop stress is p R/s; the largest is the quantity; the axial stress at the base is M/(πR² s).
    let (p, hoop) = (profile(&a, "pressure_dynamic"), profile(&a, "hoop_stress"));
    for i in 0..p.z.len() {
        close(hoop.values[i], p.values[i] * 15.0 / case.tank.course_at(p.z[i]).thickness, 1.0);
    }
    close(a.values[&Quantity::HoopStress], hoop.values.iter().copied().fold(0.0, f64::max), 1e-6);
    let axial = profile(&a, "axial_membrane_stress");
    close(axial.values[0], a.values[&Quantity::BaseMoment] / (pi_r * 15.0 * 0.014), 1.0);
    // Just above the base the moment of the fields takes over: the same to 0.1 % but for the step of the height.
    let step = axial.z[1];
    let slope = line(&a, "Q") * step / a.values[&Quantity::BaseMoment];
    close(axial.values[1] / axial.values[0], 1.0 - slope, 5e-3);
}

/// Unanchored walls: the note, the estimate's factor at the base, overturning.
#[test]
fn unanchored_walls() {
    let mut case = oil_tank();
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(bottom_plate(steel()));
    // The full motion overturns this tank.
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    assert!(a.notes.iter().any(|n| n.contains("needs the code's diagrams")));
    assert!(!check(&a, "overturning").holds());
    assert!(a.notes.iter().any(|n| n.contains("lower bound")));
    // A lower bound of the compression makes nothing hold.
    for id in ["buckling_elastic", "buckling_elastic_plastic"] {
        assert!(!check(&a, id).holds(), "{id}");
    }
    // A third of it lifts part of the wall.
    case.site.ec8 = Some(Ec8Site { ag: 0.08 * GRAVITY, ..site() });
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let x = line(&a, "x");
    assert!(x > 0.8 && x < 1.5, "{x}");
    let (w_t, w_l) = (line(&a, "w_t"), line(&a, "w_L"));
    // On the point of overturning the base bears at the toe alone: all of the ring, w_t + w_L a length, turns about it with the lever R.
    let held = 2.0 * std::f64::consts::PI * 15.0 * (w_t + w_l) * 15.0;
    close(line(&a, "M_Rd") / held, 1.0, 1e-12);
    close(check(&a, "overturning").capacity.unwrap() / held, 1.0, 1e-12);
    close(w_l, (0.010 * (105_948.0f64 * 235e6).sqrt()).min(0.02 * 30.0 * 105_948.0), 1.0);
    let b = figure_e5(x).unwrap() * (w_t + w_l) - w_l;
    close(line(&a, "N_u") / b, 1.0, 1e-9);
    // The turning rim on stiff ground presses more.
    let toes = a.steps.iter().filter(|s| s.symbol == "n_t").map(|s| s.value);
    let b = toes.fold(b, f64::max);
    close(line(&a, "N_u/N_a"), b / (w_t + line(&a, "M") / (std::f64::consts::PI * 225.0)), 1e-9);
    assert!(line(&a, "N_u/N_a") > 1.0);
    assert!(a.checks.iter().any(|c| c.id == "buckling_elastic"));
    // Without the data of the plate neither its pull nor what uplift does to the wall is known; the hoop stress does not need it.
    let asks = |case: &Case, input: &str| {
        let a = En2006.assess(case, Excitation::Site).unwrap();
        for id in ["overturning", "uplift", "buckling_elastic", "buckling_elastic_plastic"] {
            let found: Vec<_> = a.checks.iter().filter(|c| c.id == id || c.limit_state == id).collect();
            assert_eq!(found.len(), 1, "{id}: {found:?}");
            let gap = found[0];
            assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some(input)), "{gap:?}");
        }
        assert!(check(&a, "hoop_yield").demand.is_some());
    };
    case.tank.bottom.as_mut().unwrap().material.yield_strength = None;
    case.tank.bottom.as_mut().unwrap().material.name = "plate".into();
    asks(&case, "materials.plate.yield_strength");
    case.tank.bottom = None;
    asks(&case, "tank.bottom");
}

/// The lines of table A.2 at H/R = 0.8, a third of the way from 0.7 to 1.0.
#[test]
fn lines_of_the_table() {
    let a = En2006.assess(&oil_tank(), Excitation::Site).unwrap();
    let third = |below: f64, above: f64| below + (above - below) / 3.0;
    for (symbol, whole, share) in [
        ("m_i", line(&a, "m"), third(0.414, 0.548)),
        ("m_c", line(&a, "m"), third(0.586, 0.452)),
        ("h_i", 12.0, third(0.401, 0.419)),
        ("h_c", 12.0, third(0.571, 0.616)),
        ("h_i′", 12.0, third(1.009, 0.721)),
        ("h_c′", 12.0, third(1.011, 0.785)),
    ] {
        let step = a.steps.iter().find(|s| s.symbol == symbol && s.section.ends_with("table A.2")).unwrap();
        close(step.value / whole, share, 1e-9);
    }
}

/// Anchors: demand n_a × spacing where capacity is given, the missing input where not.
#[test]
fn anchors() {
    let mut case = oil_tank();
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let gap = check(&a, "anchorage");
    assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("tank.anchors")));
    assert!(gap.reason.contains("the wall pulls at its base"), "{gap:?}");
    case.tank.anchors =
        Some(Anchors { count: 60, capacity: Some(400e3), attachment_capacity: None, ..Anchors::default() });
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let spacing = std::f64::consts::PI * 30.0 / 60.0;
    close(check(&a, "anchorage").demand.unwrap(), (line(&a, "n_z") - line(&a, "N_0")) * spacing, 1.0);
    assert!(
        (check(&a, "anchorage").utilisation.unwrap() - check(&a, "anchorage").demand.unwrap() / 400e3).abs() < 1e-12
    );
}

/// Every limit of scope and every inadmissible datum has its answer.
#[test]
fn limits_of_scope() {
    let not_applicable = |p: &dyn Procedure, c: &Case, e| {
        let reason = p.applies(c, e).expect_err("not applicable");
        assert_eq!(p.assess(c, e), Err(CodeError::NotApplicable(reason.clone())));
        reason.to_string()
    };
    let mut case = oil_tank();
    assert!(not_applicable(&En2006, &case, Excitation::Record).contains("no record"));
    case.site.ec8 = Some(Ec8Site { ground: GroundType::D, ..site() });
    assert!(not_applicable(&Env1998, &case, Excitation::Site).contains("ground type D"));
    assert!(En2006.assess(&case, Excitation::Site).is_ok());
    case.site.ec8 = None;
    assert!(not_applicable(&En2006, &case, Excitation::Site).contains("site.ec8"));
    case.site.ec8 = Some(Ec8Site { behaviour_factor: 2.0, ..site() });
    assert!(matches!(En2006.assess(&case, Excitation::Site), Err(CodeError::Data { .. })));
    // Slender beyond A.3.3 with vertical motion.
    case = oil_tank();
    case.tank.shape = Shape::Cylinder { radius: 2.9 };
    assert!(En2006.assess(&case, Excitation::Site).is_ok());
    case.site.ec8 = Some(Ec8Site { vertical: true, ..site() });
    assert!(matches!(En2006.assess(&case, Excitation::Site), Err(CodeError::NotApplicable(_))));
    // A missing yield strength is named at each limit state that needs it.
    let a = En2006.assess(&broad_tank(), Excitation::Site).unwrap();
    for id in ["hoop_yield", "buckling_elastic", "buckling_elastic_plastic"] {
        let gap = check(&a, id);
        let input = gap.input.as_deref();
        assert_eq!((gap.status, input), (CheckStatus::NotChecked, Some("materials.aluminium.yield_strength")));
    }
}
