//! Source:    published table of the rigid box; closed forms; integration of the profiles
//! Goal:      the sheet of a strip, 2L = 5 m, H = 2.5 m of water, walls 0.3 m thick and 3 m high
//! Tolerance: stated with each value

use super::super::En2006;
use super::super::example::{close, integral, line, profile, site};
use crate::Procedure;
use crate::samples::concrete_rectangle;
use tank::Shape;
use tank::assessment::Excitation;
use tank::quantity::Quantity;

/// Strip: masses of the published table at H/L = 1, wave 0.811 L S_e/g, T_f of a cantilever in closed form, clamping moment as
/// the integral of pressure and inertia.
#[test]
fn rectangular_strip() {
    let strip = || concrete_rectangle(1.0, true, site());
    let case = strip();
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let m = 5.0 * 2.5 * 1000.0;
    close(line(&a, "m"), m, 1e-9);
    close(line(&a, "m_i") / m, 0.5000, 5e-5);
    close(line(&a, "h_i") / 2.5, 0.4047, 5e-5);
    close(line(&a, "h_i′") / 2.5, 0.8093, 5e-5);
    close(line(&a, "m_c1") / m, 0.4733, 5e-5);
    close(line(&a, "h_c1") / 2.5, 0.5825, 5e-5);
    close(line(&a, "h_c1′") / 2.5, 0.8591, 5e-5);
    // q_0(0) = 0.6753 of the published table: p_i at the base over ρ L A_i.
    close(line(&a, "p_i") / (1000.0 * 2.5 * line(&a, "S_e(T_f)")), 0.6753, 5e-5);
    let s_1 = line(&a, "S_e(T_c1)");
    close(a.values[&Quantity::SloshingHeight], 0.811 * 2.5 * s_1 / 9.81, 5e-4 * 2.5 * s_1 / 9.81);
    // Second mode: ω² = 3π/2 g/L tanh(3π/2 H/L), on the branch 1/T before T_D = 2 s; the first is on 1/T² after it.
    let eigenvalue = 1.5 * std::f64::consts::PI;
    let t_2 = 2.0 * std::f64::consts::PI / (eigenvalue * 9.81 / 2.5 * eigenvalue.tanh()).sqrt();
    let t_1 = a.values[&Quantity::SloshingPeriod];
    close(line(&a, "S_e(T_c2)") / s_1, t_1 * t_1 / (2.0 * t_2), 1e-6);
    // Load on the lower a = 2.5 m of the wall: w(z) = q (z⁴ − 4 a z³ + 6 a² z²)/(24 D) for z ≤ a.
    let q = (0.5 * line(&a, "m_i") + 3.0 * 0.3 * 2500.0) * 9.81 / 2.5;
    let d = 30e9 * 0.3f64.powi(3) / (12.0 * (1.0 - 0.04));
    let z = line(&a, "h_i");
    let w = q * (z.powi(4) - 10.0 * z.powi(3) + 37.5 * z * z) / (24.0 * d);
    close(line(&a, "d_f") / w, 1.0, 1e-9);
    close(line(&a, "T_f"), 2.0 * std::f64::consts::PI * (w / 9.81).sqrt(), 1e-9);
    // One wall: ∫ (p_i + p_c) z dz and its own inertia (trapezoidal rule: 0.3 %).
    let wall = 3.0 * 0.3 * 2500.0 * 1.5 * line(&a, "S_e(T_f)");
    let moment =
        integral(profile(&a, "pressure_impulsive"), 1) + integral(profile(&a, "pressure_convective"), 1) + wall;
    close(line(&a, "m_z") / moment, 1.0, 3e-3);
    close(a.values[&Quantity::BendingStress], 6.0 * line(&a, "m_z") / 0.09, 1e-6);
    assert!(!a.values.contains_key(&Quantity::HoopStress));
    // A roof of 4 t rests on both walls, 3 m above the bottom.
    let mut covered = strip();
    covered.tank.roof.mass = 4000.0;
    let r = En2006.assess(&covered, Excitation::Site).unwrap();
    let own = (3.0 * 0.3 * 2500.0 * 1.5 + 2000.0 * 3.0) * line(&r, "S_e(T_f)");
    let moment = integral(profile(&r, "pressure_impulsive"), 1) + integral(profile(&r, "pressure_convective"), 1) + own;
    close(line(&r, "m_z") / moment, 1.0, 3e-3);
    // A tank with side walls is stiffer than the strip.
    let mut boxed = strip();
    boxed.tank.shape = Shape::Rectangle { length: 5.0, breadth: 5.0, strip: false };
    let b = En2006.assess(&boxed, Excitation::Site).unwrap();
    assert!(line(&b, "T_f") < line(&a, "T_f"));
    assert!(!b.values.contains_key(&Quantity::BendingStress));
}
