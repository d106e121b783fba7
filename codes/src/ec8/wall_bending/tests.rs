//! Source:    PCA, "Rectangular Concrete Tanks", and IS 3370-4:1967 table 3 (top free, other edges fixed, triangular load, recalled);
//!            Roark, "Formulas for Stress and Strain", table 11.4 case 10a (recalled); PCA, "Circular Concrete Tanks without
//!            Prestressing", section 7 (as in the tests of PyNite); Timoshenko and Woinowsky-Krieger, "Theory of Plates and Shells",
//!            art. 117; cantilever and clamped beam
//! Goal:      moments and reactions of walls
//! Tolerance: rounding of the printed coefficients; 1 % more for PCA's, whose method and ν are not stated where they are quoted; 7 % for
//!            moments and 5 % for reactions from finite differences
//! Note:      Timoshenko's tables 44 and 45 (finite differences, ν = 1/6) lie up to 20 % above: free edge 0.00042 q a⁴/D for a
//!            triangular load at b/a = 1.5, here 0.000361; finite elements of others find 15 % less than the table as well

use super::*;
use crate::samples::{self, material};

fn course(height: f64, thickness: f64, nu: f64) -> Course {
    samples::course(height, thickness, material("concrete", 30e9, nu, 2500.0))
}

/// A wall of width 2 m.
fn panel(height: f64, nu: f64, functions: usize, least: f64) -> Wall {
    Wall::with(&[course(height, 0.3, nu)], Plan::Box { half_width: 1.0 }, functions, least)
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected} ± {tolerance}");
}

/// Clamping moment at the middle of the base over q a², a the height, for width over height of 3, 2, 1.
#[test]
fn triangular_load_against_pca() {
    for (ratio, expected) in [(3.0, 0.126), (2.0, 0.086), (1.0, 0.035)] {
        let h = 2.0 / ratio;
        let wall = panel(h, 0.2, FUNCTIONS, ELEMENTS);
        let state = wall.under(|z| 1.0 - z / h);
        near(state.base.0 / (h * h), expected, 0.0005 + 0.01 * expected);
    }
}

/// Case 10a, ν = 0.3, a = b: σ = 0.321 q b²/t² at the middle of the base, R = 0.457 q b there, 0.259 q b²/t² at the middle of the free
/// edge, 0.511 q b²/t² at the upper end of the sides: there the moment has its peak a little below the corner, which a coarse
/// mesh rounds off: the splines lie above it.
#[test]
fn uniform_load_against_roark() {
    let wall = panel(2.0, 0.3, FUNCTIONS, ELEMENTS);
    let state = wall.under(|_| 1.0);
    near(state.base.0 / 4.0, 0.321 / 6.0, 0.07 * 0.321 / 6.0);
    near(state.base.1 / 2.0, 0.457, 0.05 * 0.457);
    near(-state.at(0.0, 2.0).m_x / 4.0, 0.259 / 6.0, 0.07 * 0.259 / 6.0);
    let peak = (0..=48).map(|i| state.at(1.0, f64::from(i) / 24.0).m_x).fold(0.0, f64::max);
    let ratio = peak / 4.0 / (0.511 / 6.0);
    assert!((1.0..1.15).contains(&ratio), "{ratio}");
}

/// Convergence: 6, 8, 12 functions and 24, 48, 96 elements change base, sides and free edge by less than 0.5 %, the peak near the upper
/// corner, where the moment of a plate clamped beside a free edge is singular, by less than 3 %; the moments of the splines at the base tend to the reaction.
#[test]
fn convergence() {
    for h in [0.6, 1.0, 2.0] {
        let values = |functions, least| {
            let wall = panel(h, 0.2, functions, least);
            let s = wall.under(|z| 1.0 - 0.5 * z / h);
            let peak = (0..=96).map(|i| s.at(1.0, h * f64::from(i) / 96.0).m_x).fold(0.0, f64::max);
            [s.base.0, s.base.1, s.at(1.0, 0.5 * h).m_x, s.at(0.0, h).m_x, s.at(0.0, 0.0).m_z, peak]
        };
        let fine = values(12, 96.0);
        for (functions, least) in [(FUNCTIONS, ELEMENTS), (FUNCTIONS, 96.0), (12, ELEMENTS)] {
            for (k, (a, b)) in values(functions, least).into_iter().zip(fine).enumerate() {
                let tolerance = [0.005, 0.01, 0.005, 0.005, 0.005, 0.03][k];
                assert!((a / b - 1.0).abs() < tolerance, "{h} {functions} {least} {k}: {a} {b}");
            }
        }
        assert!((fine[4] / fine[0] - 1.0).abs() < 0.002, "{} {}", fine[4], fine[0]);
    }
}

/// Equilibrium of a wide wall: the middle is a cantilever, q h²/2 and q h (h²/6, h/2 for a triangle); a tall wall is a clamped beam,
/// q (2B)²/12, −q (2B)²/24 and q B.
#[test]
fn limits_of_a_box_wall() {
    let strip = Wall::new(&[course(4.0, 0.3, 0.2)], Plan::Strip);
    let state = strip.under(|_| 5e3);
    near(state.base.0, 40e3, 1e-3);
    near(state.base.1, 20e3, 1e-3);
    near(state.at(0.0, 2.0).m_z, 10e3, 10.0);
    let state = strip.under(|z| 5e3 * (1.0 - z / 4.0));
    near(state.base.0, 40e3 / 3.0, 1e-3);
    near(state.base.1, 10e3, 1e-3);
    near(state.at(0.0, 1.0).m_z, 5e3 * 27.0 / 24.0, 10.0);
    let tall = Wall::new(&[course(12.0, 0.3, 0.2)], Plan::Box { half_width: 1.0 });
    let state = tall.under(|_| 5e3);
    near(state.at(1.0, 6.0).m_x, 5e3 / 3.0, 5.0);
    near(state.at(0.0, 6.0).m_x, -5e3 / 6.0, 5.0);
    near(state.at(1.0, 6.0).v_x, 5e3, 15.0);
}

/// Loads on the sides and the base add up: ∫ v_x dz on both sides and the shear of the base carry the load (base line load at ξ = 0
/// only, so that the wall is tall and the sides carry all but a little above z = 2).
#[test]
fn sides_carry_a_tall_wall() {
    let tall = Wall::new(&[course(12.0, 0.3, 0.2)], Plan::Box { half_width: 1.0 });
    let state = tall.under(|_| 5e3);
    let sum: f64 = (0..200).map(|i| state.at(1.0, 3.0 + 7.0 * (f64::from(i) + 0.5) / 200.0).v_x * 7.0 / 200.0).sum();
    near(sum, 35e3, 0.005 * 35e3);
}

/// Steps of the thickness: moments of a statically determinate strip do not depend on them.
#[test]
fn stepped_strip() {
    let wall = Wall::new(&[course(2.0, 0.4, 0.2), course(2.0, 0.3, 0.2)], Plan::Strip);
    let state = wall.under(|z| if z < 3.0 { 5e3 } else { 0.0 });
    near(state.base.0, 5e3 * 4.5, 1.0);
    near(state.at(0.0, 2.5).m_z, 5e3 * 0.125, 10.0);
}

/// Long cylinder clamped at its base under hydrostatic pressure: M_0 = (1 − 1/(βH)) p R s/√(12(1−ν²)),
/// Q_0 = p R s/√(12(1−ν²)) (2β − 1/H), and p R away from the base; βH = 12.9, so that the far end is exp(−12.9) away.
#[test]
fn long_cylinder_against_timoshenko() {
    let (r, s, h, nu) = (10.0f64, 0.1f64, 10.0f64, 0.2f64);
    let beta = (3.0 * (1.0 - nu * nu) / (r * r * s * s)).powf(0.25);
    let wall = Wall::new(&[course(h, s, nu)], Plan::Cylinder { radius: r, base: WallBase::Fixed });
    let state = wall.under(|z| 1e4 * (h - z));
    let scale = 1e5 * r * s / (12.0 * (1.0 - nu * nu)).sqrt();
    near(state.base.0 / (scale * (1.0 - 1.0 / (beta * h))), 1.0, 1e-4);
    near(state.base.1 / (scale * (2.0 * beta - 1.0 / h)), 1.0, 1e-4);
    for z in [4.0, 6.0] {
        near(state.hoop(z) / (1e4 * (h - z) * r), 1.0, 0.01);
    }
    near(state.at(0.0, 0.0).m_z / state.base.0, 1.0, 0.01);
}

/// A long cylinder of one thickness on each joint, p = γ (H − z); Timoshenko and Woinowsky-Krieger art. 114 to 117, w_zzzz + 4β⁴ w = p/D. With the
/// particular solution w_p = p R²/(E s), whose slope at the foot is that of a line, the edge solution of Q_0 and M_0 gives
///
/// ```text
/// hinged      M_0 = 0      Q_0 = 2 β³ D w_p(0)                     w(0) = 0
/// sliding     M_0 = 0      w(0) = w_p(0) 2 β³ D/(2 β³ D + k)       Q_0 = k w(0)
/// n(z)        E s/R (w_p − Q_0 e^(−βz) cos βz/(2 β³ D))            m(z) = −Q_0 e^(−βz) sin βz/β
/// ```
///
/// exact for an infinite wall: the far end is exp(−12.9) away.
#[test]
fn long_cylinder_on_each_joint() {
    let (r, s, h, nu, e) = (10.0f64, 0.1f64, 10.0f64, 0.2f64, 30e9f64);
    let beta = (3.0 * (1.0 - nu * nu) / (r * r * s * s)).powf(0.25);
    let foot = 2.0 * beta.powi(3) * e * s.powi(3) / (12.0 * (1.0 - nu * nu));
    let free = |z: f64| 1e4 * (h - z) * r * r / (e * s);
    for (k, base) in
        [(f64::INFINITY, WallBase::Hinged), (0.0, sliding(Some(0.0))), (5e7, sliding(Some(5e7))), (0.0, sliding(None))]
    {
        let wall = Wall::new(&[course(h, s, nu)], Plan::Cylinder { radius: r, base });
        let state = wall.under(|z| 1e4 * (h - z));
        let q = free(0.0) * if k.is_finite() { foot * k / (foot + k) } else { foot };
        let scale = free(0.0) * foot;
        near(state.base.0 / scale, 0.0, 1e-6);
        near(state.base.1 / scale, q / scale, 1e-4);
        for z in [0.0f64, 0.3, 0.9, 2.0, 5.0] {
            let edge = (-beta * z).exp();
            let n = e * s / r * (free(z) - q / foot * edge * (beta * z).cos());
            near(state.hoop(z) / 1e6, n / 1e6, 1e-4);
            let m = -q / beta * edge * (beta * z).sin();
            near(state.at(0.0, z).m_z * beta / scale, m * beta / scale, 2e-3);
        }
        if k == 0.0 {
            // A force at the foot: w = 1/(2 β³ D).
            near(wall.pulled().at(0.0, 0.0).w * foot, 1.0, 1e-4);
        }
    }
}

fn sliding(stiffness: Option<f64>) -> WallBase {
    WallBase::Sliding { stiffness, friction: None }
}

/// H = 20 ft, D = 54 ft, t = 10 in, 62.5 lb/ft³: largest moment 14 804/(1.3·1.7) = 6699 lb·ft/ft at the base, −3756/(1.3·1.7) = −1700
/// above it, hoop about 20 000 lb/ft, from tables with three digits and an interpolation (2 %; the moment above
/// the base has two digits, 3 %).
#[test]
fn short_cylinder_against_pca() {
    let (h, r, t) = (20.0, 27.0, 10.0 / 12.0);
    let wall = Wall::new(&[course(h, t, 0.2)], Plan::Cylinder { radius: r, base: WallBase::Fixed });
    let state = wall.under(|z| 62.5 * (h - z));
    near(state.base.0, 14_804.0 / 2.21, 0.02 * 6699.0);
    let heights = || (0..=200).map(|i| 0.1 * f64::from(i));
    let least = heights().map(|z| state.at(0.0, z).m_z).fold(0.0, f64::min);
    near(least, -3756.0 / 2.21, 0.03 * 1700.0);
    let hoop = heights().map(|z| state.hoop(z)).fold(0.0, f64::max);
    near(hoop, 20_000.0, 400.0);
}

/// Points over the whole width with weights [m], the mirrored half in the weight; a strip is 1 m wide.
fn width_points(plan: Plan) -> Vec<(f64, f64)> {
    match plan {
        Plan::Box { half_width } => across_points().map(|(xi, w)| (xi, 2.0 * half_width * w)).collect(),
        _ => vec![(0.0, 1.0)],
    }
}

/// ω² [1/s²] of the first mode of a wall with the mass m(z) per area: Rayleigh's quotient ∫ m w/∫ m w² of the deflection under the
/// load m, which is how the whole wall follows a ground motion, and the first mode by inverse iteration from it, an upper bound each.
fn frequencies(wall: &Wall, mass: impl Fn(f64) -> f64) -> (f64, f64) {
    let points = width_points(wall.plan);
    let held = 2 * wall.functions;
    let mut unknowns = wall.under(&mass).unknowns;
    let mut before: Option<Vec<f64>> = None;
    let mut found = Vec::new();
    for _ in 0..12 {
        let state = State { wall, unknowns, base: (0.0, 0.0) };
        let mut force = vec![0.0; state.unknowns.len()];
        let (mut up, mut down, mut values) = (0.0, 0.0, Vec::new());
        for (e, element) in wall.elements.iter().enumerate() {
            for (t, weight) in along_points() {
                let z = element.base + t * element.length;
                for (xi, across) in &points {
                    let (w, m) = (state.at(*xi, z).w, mass(z) * weight * element.length * across);
                    up += m * w * before.as_ref().map_or(1.0, |b| b[values.len()]);
                    down += m * w * w;
                    values.push(w);
                    // Half the width, as in the stiffness.
                    let half = if wall.functions > 1 { 0.5 } else { 1.0 };
                    for (a, spline) in hermite(t, element.length).iter().enumerate() {
                        for i in 0..wall.functions {
                            force[(2 * e + a) * wall.functions + i] +=
                                half * m * w * spline[0] * wall.across(i, *xi)[0];
                        }
                    }
                }
            }
        }
        found.push(up / down);
        before = Some(values);
        force[..held].fill(0.0);
        wall.solve(&mut force[held..]);
        unknowns = force;
    }
    (found[0], found[found.len() - 1])
}

/// Plate clamped at its base and sides and strip beside it, each 0.3 m thick and 1 kg/m² heavy.
fn plate_and_strip(ratio: f64, nu: f64) -> (Wall, Wall) {
    let courses = [course(2.0 / ratio, 0.3, nu)];
    let of = |plan, functions| Wall::with(&courses, plan, functions, 24.0);
    (of(Plan::Box { half_width: 1.0 }, FUNCTIONS), of(Plan::Strip, 1))
}

/// ω h² √(m/D): 3.516 of a cantilever, and 24.02 of a square plate with one free edge, ν = 0.3 (Leissa, "The free vibration of
/// rectangular plates", 1973, recalled; Ritz with 36 terms). Tolerance 0.5 % for the iterated mode; a quotient lies above it, by
/// less than 1 % for the cantilever (3.530 by hand, from the deflection under a uniform load).
#[test]
fn first_frequency_of_cantilever_and_plate() {
    let (plate, strip) = plate_and_strip(1.0, 0.3);
    let rigidity = 30e9 * 0.3f64.powi(3) / (12.0 * (1.0 - 0.09));
    let factor = |square: f64| (square / rigidity).sqrt() * 4.0;
    let (quotient, first) = frequencies(&strip, |_| 1.0);
    near(factor(first), 3.516, 0.005 * 3.516);
    near(factor(quotient), 3.530, 0.001 * 3.530);
    let (quotient, first) = frequencies(&plate, |_| 1.0);
    near(factor(first), 24.02, 0.005 * 24.02);
    assert!(quotient >= first, "{quotient} {first}");
}

/// From the breadth [`tank::PLANE_WALLS`] on a strip has the moment at the middle of the base and the frequencies of the plate within
/// 10 %, with the mass of the wall and with that of the liquid (Westergaard's parabola), for concrete and steel; at one
/// height less it has not.
#[test]
fn a_strip_stands_for_a_broad_wall() {
    let ratios = |ratio: f64, nu: f64| {
        let (plate, strip) = plate_and_strip(ratio, nu);
        let h = 2.0 / ratio;
        let moment = |load: &dyn Fn(f64) -> f64| plate.under(load).base.0 / strip.under(load).base.0;
        let frequency = |mass: &dyn Fn(f64) -> f64| {
            let ((q, first), (q_0, first_0)) = (frequencies(&plate, mass), frequencies(&strip, mass));
            [(q / q_0).sqrt(), (first / first_0).sqrt()]
        };
        let moments = [moment(&|z| 1.0 - z / h), moment(&|_| 1.0)];
        let [dry, wet] = [frequency(&|_| 1.0), frequency(&|z| ((h - z) * h).sqrt())];
        [moments, dry, wet].concat()
    };
    for nu in [0.2, 0.3] {
        for more in [0.0, 1.0, 3.0] {
            let found = ratios(tank::PLANE_WALLS + more, nu);
            assert!(found.iter().all(|r| (0.9..1.1).contains(r)), "{found:?}");
        }
        let found = ratios(tank::PLANE_WALLS - 1.0, nu);
        assert!(found.iter().any(|r| !(0.9..1.1).contains(r)), "{found:?}");
    }
}
