//! Bearing of the ground under the record, in the harmonic engine.

use results::VerdictStatus::Holds;
use serde_json::json;

use super::engine::tank;
use super::*;

/// Eurocode 8 alone, with a resistance of the ground [kPa].
fn ground(resistance: f64) -> Value {
    json!({ "site": { "api650": null, "ec8": { "bearing_capacity": format!("{resistance} kPa") } } })
}

/// The ground accelerates by a (1 − cos)/2 in 200 s towards θ = 0, and all follow statically; on the bottom lies ρ a x more pressure.
///
/// ```text
/// σ = (m + m_w) g/(π R²) + M′/(π R³/4)        M′ = a (ρ π R² H²/2 + ρ π R⁴/4 + m_w h/2), pressing at θ = 180°
/// ```
///
/// Tolerance 1 % of the part of the motion: as in `slow_motion_gives_closed_forms`.
#[test]
fn slow_motion_presses_by_a_closed_form() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank = tank("slow-bearing", "", (Holds, ANY), vec![ground(200.0), wall(&[8.0; 4])]).run(0.4);
    let tank = Tank { motion: (4000, |k| 0.5 * (1.0 - (k * std::f64::consts::TAU / 4000.0).cos())), ..tank };
    let results = tank.results(home.path()).expect("the input is good");
    let fe = results.methods.iter().find(|m| m.id == "fe").expect("a run");
    let check = fe.checks.iter().find(|c| c.id == "bearing").expect("a check");
    let (r, h, g, a, pi) = (10.0_f64, 8.5_f64, 9.80665_f64, 0.4_f64, std::f64::consts::PI);
    let (liquid, shell) = (1000.0 * pi * r * r * h, 7850.0 * 2.0 * pi * r * 10.0 * 0.008);
    let rest = (liquid + shell) * g / (pi * r * r);
    let moment = a * (0.5 * liquid * h + 1000.0 * pi * r.powi(4) / 4.0 + 5.0 * shell);
    let swing = check.demand.expect("a comparison") - rest;
    let expected = moment / (0.25 * pi * r.powi(3));
    assert!((swing / expected - 1.0).abs() < 1e-2, "{swing} {expected}");
    let (time, theta) = check.time_s.zip(check.theta).expect("a time and an angle");
    assert!((time - 100.0).abs() < 5.0 && (theta - pi).abs() < 1e-9, "{check:?}");
}
