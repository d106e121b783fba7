//! Source:    dissertation (2002), tables D.1, 8.8, 8.9, 8.10, 8.11; values computed by an independent script
//! Goal:      every number the dissertation took from Housner's procedure, as printed and as it should be
//! Model:     constants of 1957, g = 9.81 m/s², a_B = 0.5 g unless stated
//! Expected:  per test
//! Tolerance: script values: half their last digit. Printed values: one unit of their last digit where the printed
//!            intermediate values were rounded; otherwise a bound that was set knowing the difference, marked as such
//!
//! Errors of the source that the corrected values rest on:
//! * D.1 prints h_k = 1.47 m; its own formula gives 0.884 m (1.47 m would lie at the surface). All moments of D.1 inherit it.
//! * D.1's S_v = 0.80 m/s belongs to the unscaled El Centro record; here S_v is given, so that does not matter.
//! * 0.318 is 30 % below the exact mass factor 0.4545.

// 3.14 rad/s is a printed frequency.
#![allow(clippy::approx_constant)]

mod properties;

use super::coefficients::{CIRCLE_1957, Coefficients, RECTANGLE_1957};
use super::lines::{Lines, Ordinate};
use super::model::{self, Arms, InputError, Response};
use super::stress::{Pressures, section_modulus_circle};
use crate::mechanical::Plan;
use crate::samples::near;
use crate::sheet::Sheet;
use tank::case::Combination::{Abs, Srss};

const G: f64 = 9.81;

/// The ordinate of the sloshing mode: one of three equivalent ones.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Spectral {
    /// Pseudo-velocity S_v [m/s].
    Velocity(f64),
    /// Spectral displacement A₁ = S_v/ω [m].
    Displacement(f64),
    /// Pseudo-acceleration S_a = ω S_v [m/s²].
    Acceleration(f64),
}

/// A tank with the ordinate of its sloshing mode.
#[derive(Clone, Copy, Debug)]
struct Input {
    half_length: f64,
    depth: f64,
    mass: f64,
    ground_acceleration: f64,
    spectral: Spectral,
    gravity: f64,
    coefficients: Coefficients,
}

fn respond(input: &Input) -> Result<Response, InputError> {
    let tank = model::Input {
        half_length: input.half_length,
        depth: input.depth,
        mass: input.mass,
        ground_acceleration: input.ground_acceleration,
        gravity: input.gravity,
        coefficients: input.coefficients,
    };
    let ordinate = |omega: f64, _: f64| Ordinate {
        value: match input.spectral {
            Spectral::Velocity(s_v) => s_v * omega,
            Spectral::Displacement(a_1) => omega * omega * a_1,
            Spectral::Acceleration(s_a) => s_a,
        },
        look_up: String::new(),
        clause: String::new(),
    };
    let mut sheet = Sheet::new();
    let lines = Lines::new(&tank, Plan::Circle, Abs, &mut sheet);
    Ok(lines.respond("", ordinate)?.0)
}

fn solve(input: Input) -> Response {
    respond(&input).expect("the test's input is admissible")
}

/// Tank 8.1: R = 1.83 m, H = 1.525 m, m = 16.3 t (as printed; π R² H ρ with 10/9.81 gives 16.36 t).
fn broad_tank(spectral: Spectral) -> Input {
    Input {
        half_length: 1.83,
        depth: 1.525,
        mass: 16_300.0,
        ground_acceleration: 0.5 * G,
        spectral,
        gravity: G,
        coefficients: CIRCLE_1957,
    }
}

/// ω = √((k g/a) tanh(k H/a)) for the whole depth, slender or not.
fn omega(c: Coefficients, a: f64, depth: f64) -> f64 {
    (c.frequency * G / a * (c.frequency * depth / a).tanh()).sqrt()
}

#[test]
fn table_d1_intermediate_values() {
    let r = solve(broad_tank(Spectral::Velocity(1.0)));
    assert!(!r.slender);
    near(r.x, 1.53333, 0.5e-5, "x");
    near(r.omega, 2.9976, 0.5e-4, "omega");
    near(r.omega, 3.0, 0.05, "omega, printed");
    near(r.q, 2.0785, 0.5e-4, "q");
    near(r.r, 0.46629, 0.5e-5, "r");
    near(r.impulsive_mass, 7600.6, 0.05, "m_i");
    near(r.impulsive_force, 37_281.0, 0.5, "P_i");
    near(r.impulsive_force, 37_200.0, 100.0, "P_i, printed");
    near(r.convective_mass, 5666.5, 0.05, "m_k");
    near(r.angle, 0.25475, 0.5e-5, "theta_h/S_v");
    near(r.angle, 0.254, 1e-3, "theta_h/S_v, printed");
    near(r.convective_force, 16_993.0, 0.5, "P_k/S_v");
    // 0.3 %: the printed 16.94 was computed with omega = 3.0 and theta_h = 0.254.
    near(r.convective_force, 16_940.0, 0.004 * 16_940.0, "P_k/S_v, printed");
    near(r.impulsive_lever, 0.5719, 0.5e-4, "h_i");
    near(r.convective_lever, 0.8835, 0.5e-4, "h_k; printed 1.47");
    near(r.impulsive_lever_with_base, 1.4446, 0.5e-4, "h_i'");
    near(r.convective_lever_with_base, 1.3338, 0.5e-4, "h_k'");
    // The limit of the printed wave formula, d = 0.82/(2.345/S_v - 1) per the rise S_v.
    near(r.wave.ratio, 2.345, 0.5e-2, "g/(omega^2 theta_h R), printed");
}

#[test]
fn table_d1_results_corrected_and_as_printed() {
    // S_v, P_k, d_max [cm], M (EBP), M with the printed lever 1.47 m, sigma, sigma with 1.47 m: script; then printed:
    // P_k, d_max, M, sigma (truncated to a tenth)
    let table = [
        (0.80, [13.59, 42.5, 33.33, 41.30, 1.58, 1.96], [13.55, 42.4, 41.1, 1.9]),
        (0.09, [1.529, 3.28, 22.67, 23.57, 1.08, 1.12], [1.52, 3.3, 23.4, 1.1]),
        (0.22, [3.739, 8.50, 24.62, 26.82, 1.17, 1.27], [3.72, 8.5, 26.6, 1.2]),
    ];
    let modulus = section_modulus_circle(3.66, 2e-3);
    near(modulus, 0.02104, 0.5e-5, "W");
    near(modulus, 0.0211, 1e-4, "W, printed");
    for (s_v, [p_k, d, m, m_147, sigma, sigma_147], [p_k_print, d_print, m_print, sigma_print]) in table {
        let r = solve(broad_tank(Spectral::Velocity(s_v)));
        let force = 1e-3 * r.convective_force;
        near(force, p_k, 0.51e-2, "P_k");
        // 16.94 S_v, truncated to two decimals.
        near(force, p_k_print, 0.004 * p_k_print + 0.01, "P_k, printed");
        let height = 100.0 * r.wave.finite.expect("inside Housner's theory");
        near(height, d, 0.51e-1, "d_max");
        // Printed from 0.82/(2.345/S_v - 1), two and four digits.
        near(height, d_print, 0.15, "d_max, printed");
        let moment = r.moment(Arms::Wall, Abs);
        near(1e-3 * moment, m, 0.51e-2, "M");
        near(1e-6 * moment / modulus, sigma, 0.51e-2, "sigma");
        // As printed: the wrong lever.
        let printed = r.impulsive.wall_moment + r.convective_force * 1.47;
        near(1e-3 * printed, m_147, 0.51e-2, "M with 1.47 m");
        near(1e-6 * printed / modulus, sigma_147, 0.51e-2, "sigma with 1.47 m");
        // 0.8 %: printed from 37.2 kN, 0.57 m and the rounded P_k; the stresses are truncated to a tenth.
        near(1e-3 * printed, m_print, 0.01 * m_print, "M, printed");
        let stress = 1e-6 * printed / modulus;
        assert!(stress >= sigma_print && stress < sigma_print + 0.1, "sigma, printed: {stress}");
    }
    // With base pressure (below the plate).
    for (s_v, m) in [(0.80, 71.99), (0.09, 55.90), (0.22, 58.84)] {
        let r = solve(broad_tank(Spectral::Velocity(s_v)));
        near(1e-3 * r.moment(Arms::WallAndBase, Abs), m, 0.51e-2, "M_o");
    }
}

#[test]
fn combinations_of_the_parts() {
    let r = solve(broad_tank(Spectral::Velocity(0.8)));
    let (i, k) = (r.impulsive, r.convective);
    near(r.base_shear(Abs), i.force + k.force, 1e-9, "abs");
    near(r.base_shear(Srss), (i.force.powi(2) + k.force.powi(2)).sqrt(), 1e-6, "srss");
    near(r.moment(Arms::Wall, Srss), (i.wall_moment.powi(2) + k.wall_moment.powi(2)).sqrt(), 1e-6, "srss");
}

/// Table 8.8: R = 0.096 m. The text prints 1.84, the table was computed with the exact root 1.8412; 2.117 Hz at 9 cm is a
/// slip for 2.115 (its neighbours fit).
#[test]
fn table_8_8_sloshing_frequencies() {
    let exact = Coefficients::exact(Plan::Circle);
    for (h, with_184, with_root, printed) in [
        (0.03, 1.5722, 1.5732, 1.573),
        (0.06, 1.9735, 1.9744, 1.974),
        (0.09, 2.1142, 2.1150, 2.117),
        (0.12, 2.1605, 2.1613, 2.161),
        (0.15, 2.1754, 2.1762, 2.176),
    ] {
        let hertz = |c: Coefficients| omega(c, 0.096, h) / std::f64::consts::TAU;
        near(hertz(CIRCLE_1957), with_184, 0.5e-4, "f with 1.84");
        near(hertz(exact), with_root, 0.5e-4, "f with the root");
        let slip = if h == 0.09 { 2e-3 } else { 0.0 };
        near(hertz(exact), printed, 0.5e-3 + slip, "f, printed");
    }
}

/// Table 8.9: H = 9 cm, base motion 5 mm at 1.2 Hz. The printed 6.2 mm follows only if the ground's amplitude is used as
/// spectral displacement (a reading picked because it fits); the steady state is u₀ ρ²/(1 − ρ²) with ρ = 1.2/2.114.
#[test]
fn table_8_9_wave_under_harmonic_motion() {
    let input = |a_1: f64| Input {
        half_length: 0.096,
        depth: 0.09,
        mass: 1.0,
        ground_acceleration: 0.0,
        spectral: Spectral::Displacement(a_1),
        gravity: G,
        coefficients: CIRCLE_1957,
    };
    let height = |a_1: f64| 1e3 * solve(input(a_1)).wave.finite.expect("inside Housner's theory");
    near(height(5e-3), 6.21, 0.5e-2, "d_max with A1 = 5 mm");
    near(height(5e-3), 6.2, 0.05, "d_max, printed");
    let rho: f64 = 1.2 / 2.114;
    let steady = 5e-3 * rho * rho / (1.0 - rho * rho);
    near(1e3 * steady, 2.377, 0.5e-3, "A1");
    near(height(steady), 2.74, 0.5e-2, "d_max in the steady state");
}

/// Slender tank of table 8.10.
fn slender_tank(depth: f64, s_v: f64) -> Input {
    Input {
        half_length: 1.83,
        depth,
        mass: 1000.0 * std::f64::consts::PI * 1.83 * 1.83 * depth,
        ground_acceleration: 0.5 * G,
        spectral: Spectral::Velocity(s_v),
        gravity: G,
        coefficients: CIRCLE_1957,
    }
}

/// Table 8.10: five fill heights, t = 2.0 mm, S_v = 0.81 m/s. ρ = 1000 kg/m³ and W = 0.0211 m³ were chosen to fit the print
/// (the dissertation states neither). A quadratic in H has equal second differences (0.61); the printed ones are 0.55,
/// 0.77, 0.16, so 14.95 and 24.45 are most likely slips: bound 2 % there, 1 % elsewhere, both set knowing the differences.
#[test]
fn table_8_10_slender_tank() {
    let modulus = section_modulus_circle(3.66, 2e-3);
    let mut stresses = Vec::new();
    for (h, moment, sigma, sigma_0211, printed, bound) in [
        (3.0, 163.47, 7.769, 7.747, 7.70, 0.01),
        (3.5, 234.45, 11.142, 11.111, 11.05, 0.01),
        (4.0, 318.34, 15.129, 15.087, 14.95, 0.02),
        (4.5, 415.12, 19.728, 19.674, 19.62, 0.01),
        (5.0, 524.81, 24.941, 24.872, 24.45, 0.02),
    ] {
        let r = solve(slender_tank(h, 0.81));
        assert!(r.slender);
        let m = r.moment(Arms::Wall, Abs);
        near(1e-3 * m, moment, 0.51e-2, "M_w");
        near(1e-6 * m / modulus, sigma, 0.51e-3, "sigma");
        near(1e-6 * m / 0.0211, sigma_0211, 0.51e-3, "sigma with W = 0.0211");
        near(1e-6 * m / 0.0211, printed, bound * printed, "sigma, printed");
        stresses.push(m);
        let height = r.wave.finite.expect("inside Housner's theory");
        near(height, 0.487, 0.5e-3, "d_max");
        near(solve(slender_tank(h, 0.80)).wave.height(), 0.478, 0.5e-3, "d_max with S_v = 0.80");
        near(height, 0.48, 0.01, "d_max, printed");
        // The dissertation takes the frequency with the full depth (differs by less than 0.4 %).
        let printed_omega = if h == 3.0 { 3.13 } else { 3.14 };
        near(omega(CIRCLE_1957, 1.83, h), printed_omega, 0.5e-2, "omega, printed");
        near(r.omega, omega(CIRCLE_1957, 1.83, h), 0.004 * r.omega, "omega with H_b");
    }
    let second = |i: usize| stresses[i] - 2.0 * stresses[i + 1] + stresses[i + 2];
    near(second(0), second(1), 1e-6 * second(0), "quadratic in H");
    near(second(1), second(2), 1e-6 * second(0), "quadratic in H");
}

/// Table 8.11: strip 1 m of a rectangular tank, 2L = 5 m, H = 2.57 m, a_B = 0.348 g, S_v = 0.787 m/s (printed in m/s²).
/// No single change of a constant gives the printed 39.94 kNm; the bound of 2.5 % was set knowing the difference.
#[test]
fn table_8_11_rectangular_strip() {
    let strip = |mass: f64| {
        solve(Input {
            half_length: 2.5,
            depth: 2.57,
            mass,
            ground_acceleration: 0.348 * G,
            spectral: Spectral::Velocity(0.787),
            gravity: G,
            coefficients: RECTANGLE_1957,
        })
    };
    let r = strip(13_100.0);
    near(r.omega, 2.395, 0.5e-3, "omega");
    near(r.omega, 2.40, 0.5e-2, "omega, printed");
    near(r.angle, 0.1921, 0.5e-4, "theta_h");
    let height = r.wave.finite.expect("inside Housner's theory");
    near(height, 0.556, 0.5e-3, "d_max");
    near(height, 0.55, 0.01, "d_max, printed (truncated)");
    near(r.impulsive_lever, 0.9638, 0.51e-4, "h_i");
    near(r.convective_lever, 1.5087, 0.5e-4, "h_k");
    near(1e-3 * r.moment(Arms::Wall, Abs), 41.55, 0.5e-2, "M_w with 13.1 t");
    let light = strip(1000.0 * 5.0 * 2.57);
    near(1e-3 * light.moment(Arms::Wall, Abs), 40.76, 0.5e-2, "M_w with 12.85 t");
    near(1e-3 * light.moment(Arms::Wall, Abs), 39.94, 0.025 * 39.94, "M_w, printed");
}

/// Housner's masses and the exact ones at four ratios H/R (table of the theory page).
#[test]
fn masses_beside_potential_flow() {
    // H/R, Housner m_i/m, exact m_k/m, m_k/m with 0.318
    for (ratio, m_i, exact, published) in [
        (0.5, 0.2881, 0.6601, 0.4617),
        (0.8333, 0.4663, 0.4970, 0.3476),
        (1.0, 0.5423, 0.4322, 0.3024),
        (1.5, 0.7095, 0.3006, 0.2103),
    ] {
        let model = |coefficients| {
            solve(Input {
                half_length: 1.0,
                depth: ratio,
                mass: 1.0,
                ground_acceleration: 1.0,
                spectral: Spectral::Acceleration(1.0),
                gravity: G,
                coefficients,
            })
        };
        let r = model(CIRCLE_1957);
        near(r.impulsive_mass, m_i, 0.51e-4, "m_i");
        near(r.convective_mass, published, 0.51e-4, "m_k 1957");
        let r = model(Coefficients::exact(Plan::Circle));
        near(r.convective_mass, exact, 0.51e-4, "m_k exact");
        near(r.convective_force, r.convective_mass, 1e-12, "P_k = m_k S_a");
    }
    // Slender: the mass that moves with the wall is 1 - 0.4357 R/H.
    let r = solve(slender_tank(5.0, 0.8));
    let moving = (r.impulsive_mass + r.rigid_mass) / (r.sloshing_mass + r.rigid_mass);
    near(moving, 1.0 - 0.4357 * 1.83 / 5.0, 1e-4, "moving mass");
}

/// A wave formula without solution: the linear value stands in, no number is invented.
#[test]
fn wave_outside_housners_theory_is_linear() {
    let r = solve(broad_tank(Spectral::Velocity(2.5)));
    assert!(r.wave.ratio <= 1.0 && r.wave.finite.is_none());
    // d_lin = 0.626 R S_a/g.
    near(r.wave.height(), 0.408 * 1.534 * 1.83 * r.acceleration / G, 1e-12, "d_lin");
    let calm = solve(broad_tank(Spectral::Velocity(0.0)));
    assert_eq!(calm.wave.height(), 0.0);
    // Small motion: both values agree (the finite-angle term is 4e-4 of the ratio here).
    let small = solve(broad_tank(Spectral::Velocity(1e-3)));
    let finite = small.wave.finite.expect("inside Housner's theory");
    near(finite / small.wave.linear, 1.0, 1.5e-3, "small waves");
}

#[test]
fn inadmissible_input_is_refused_with_its_value() {
    let base = broad_tank(Spectral::Velocity(0.8));
    for bad in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        for input in [
            Input { half_length: bad, ..base },
            Input { depth: bad, ..base },
            Input { mass: bad, ..base },
            Input { gravity: bad, ..base },
        ] {
            assert!(matches!(respond(&input), Err(InputError::NotPositive { .. })));
        }
    }
    for spectral in [Spectral::Velocity(-0.1), Spectral::Displacement(-0.1), Spectral::Acceleration(f64::NAN)] {
        let error = respond(&Input { spectral, ..base }).expect_err("negative ordinates are refused");
        assert!(error.to_string().contains("must be zero or positive"));
    }
    assert!(respond(&Input { ground_acceleration: -1.0, ..base }).is_err());
}

/// The pressures integrate to the forces and moments of the model (Simpson, smooth parts: 1e-6 of the result). The
/// constrained lower part carries 6.4 % more pressure than its force implies: Housner continues the pressure at its upper
/// end, 1.064 ρ a_B R, while the solid needs ρ a_B R; moments over the height use the force.
#[test]
fn pressures_integrate_to_forces() {
    for (depth, slender) in [(1.525, false), (4.0, true)] {
        let r = solve(slender_tank(depth, 0.8));
        let field = Pressures { response: &r, plan: Plan::Circle, half_length: 1.83, breadth: 0.0 };
        assert_eq!(r.slender, slender);
        let n = 2000;
        let h = r.sloshing_depth / f64::from(n);
        let (mut i, mut k, mut mi, mut mk) = (0.0, 0.0, 0.0, 0.0);
        for j in 0..=n {
            let weight = if j == 0 || j == n { 1.0 } else { f64::from(2 + 2 * (j % 2)) } * h / 3.0;
            let z = r.rigid_depth + f64::from(j) * h;
            let c = std::f64::consts::PI * 1.83 * weight;
            // The last point may lie a rounding above the surface.
            let z = z.min(depth);
            i += c * field.impulsive(z);
            k += c * field.convective(z);
            mi += c * field.impulsive(z) * z;
            mk += c * field.convective(z) * z;
        }
        near(i, r.impulsive_force, 1e-6 * i, "P_i");
        near(k, r.convective_force, 1e-6 * k, "P_k");
        near(mi + r.rigid_force * r.rigid_depth / 2.0, r.impulsive.wall_moment, 1e-6 * mi, "M_i");
        near(mk, r.convective.wall_moment, 1e-6 * mk, "M_k");
        near(field.impulsive_moment_above(0.0), r.impulsive.wall_moment, 1e-9 * mi, "M_i(0)");
        near(field.convective_moment_above(0.0), r.convective.wall_moment, 1e-9 * mk, "M_k(0)");
        for z in [depth, depth + 0.1] {
            near(field.impulsive_moment_above(z), 0.0, 1e-9 * mi, "M_i above the surface");
            near(field.convective_moment_above(z), 0.0, 1e-9 * mk, "M_k above the surface");
        }
        assert_eq!(field.impulsive(depth + 0.1), 0.0);
        assert_eq!(field.convective(depth + 0.1), 0.0);
        // Printed form of the impulsive pressure at the bottom of the sloshing part.
        let q = 3.0_f64.sqrt() * 1.83 / r.sloshing_depth;
        let bottom = 3.0_f64.sqrt() * 1000.0 * 0.5 * G * r.sloshing_depth * 0.5 * q.tanh();
        near(field.impulsive(0.0), bottom, 1e-9 * bottom, "p_i");
        if slender {
            near(
                field.impulsive(0.0) * std::f64::consts::PI * 1.83 * r.rigid_depth / r.rigid_force,
                1.064,
                0.5e-3,
                "lower part",
            );
        }
    }
}
