//! Sliding against closed forms, rocking against quadrature and a fixed base.

use super::*;
use crate::law::{Law, Spring};
use crate::{Bands, Curve, Edge, Heave, Plan, Plate, Point, Rim, Rocking, Strip};

const G: f64 = 9.81;

fn block(mass: f64) -> Body {
    Body { modes: Vec::new(), mass, first_moment: 0.0, second_moment: 0.0 }
}

fn slide(ground: &[f64], step: f64, coefficient: f64) -> History {
    drag(ground, step, coefficient, Vec::new())
}

fn drag(ground: &[f64], step: f64, coefficient: f64, springs: Vec<Spring>) -> History {
    delayed(ground, step, coefficient, springs, 0.0)
}

fn delayed(ground: &[f64], step: f64, coefficient: f64, springs: Vec<Spring>, delay: f64) -> History {
    let mass = 1000.0;
    march(&Run {
        body: &block(mass),
        law: None,
        ring: None,
        heave: None,
        waves: None,
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: Some(Friction { coefficient, weight: mass * G, vertical: Vec::new(), springs, delay }),
        rigid_pressure: [0.0; 2],
        step,
        ground,
    })
    .unwrap()
}

/// On one spring so stiff that it gives way by 1e-5 of the slip before it slips, the block slides by the closed form of the pulse, within 1 %: until
/// it slips the spring holds less than friction does.
#[test]
fn a_stiff_spring_slides_as_friction_does() {
    let (a, t0, mu, step) = (0.5 * G, 0.3, 0.2, 1e-4);
    let pulse: Vec<f64> = (0..12_000).map(|i| if (i as f64) * step < t0 - 0.5 * step { a } else { 0.0 }).collect();
    let limit = mu * 1000.0 * G;
    let expected = a * a * t0 * t0 / (2.0 * mu * G) - a * t0 * t0 / 2.0;
    let spring = Spring { stiffness: limit / (1e-5 * expected), limit };
    let history = drag(&pulse, step, mu, vec![spring]);
    let found = history.slip.last().copied().unwrap();
    assert!((found.abs() / expected - 1.0).abs() < 1e-2, "{found} {expected}");
    assert!(history.slid && history.balance < 1e-3, "{}", history.balance);
}

/// A spring that has slipped stands at its limit but for rounding. Whether the dashpot beside it acts in the next step must not hang on that:
/// the ground motion in other units, the same but for its last digit, slides the block as far. 1e-9: rounding, and no step magnifies it.
#[test]
fn the_last_digit_of_the_ground_decides_nothing() {
    let springs: Vec<Spring> = (1..=40).map(|i| Spring { stiffness: 1e4 / f64::from(i), limit: 50.0 }).collect();
    let step = 2e-3;
    let wave = |i: usize| {
        let t = i as f64 * step;
        4.0 * (-0.3 * t).exp() * ((9.0 * t).sin() + 0.4 * (31.0 * t).cos())
    };
    let ground: Vec<f64> = (0..4000).map(wave).collect();
    let grams: Vec<f64> = ground.iter().map(|a| a / 9.80665 * 9.80665).collect();
    assert!(ground != grams);
    let [a, b] = [ground, grams].map(|g| delayed(&g, step, 0.2, springs.clone(), 2e-3).slip);
    let most = a.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
    let apart = a.iter().zip(&b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    assert!(most > 0.0 && apart < 1e-9 * most, "{apart} of {most}");
}

/// Springs that slip one after another lose 8 ∫ V ds − 4 V s in a cycle to ±s (Masing): steady motion at half the frequency of the springs
/// before they slip. 1 %: a thousand steps a cycle. Nothing slides as a whole.
#[test]
fn a_chain_of_springs_loses_what_masing_says() {
    let springs: Vec<Spring> = (1..=8).map(|i| Spring { stiffness: 4e5 / 8.0, limit: 120.0 * f64::from(i) }).collect();
    let omega = 0.5 * (4e5_f64 / 1000.0).sqrt();
    let period = 1000;
    let step = std::f64::consts::TAU / omega / period as f64;
    let run = |cycles: usize| {
        let ground: Vec<f64> = (0..=cycles * period).map(|i| 1.5 * (omega * step * i as f64).sin()).collect();
        drag(&ground, step, 1.0, springs.clone())
    };
    let (before, after) = (run(80), run(81));
    let last = &after.slip[80 * period..];
    let (low, high) = last.iter().fold((f64::MAX, f64::MIN), |(l, h), s| (l.min(*s), h.max(*s)));
    let s = 0.5 * (high - low);
    let way = |spring: &Spring| (s - spring.limit / spring.stiffness).max(0.0);
    let lost: f64 = springs.iter().map(|p| 4.0 * p.limit * way(p)).sum();
    let found = after.energy.friction - before.energy.friction;
    assert!(lost > 0.0 && !after.slid && after.balance < 1e-3, "{lost} {}", after.balance);
    assert!((found / lost - 1.0).abs() < 1e-2, "{found} {lost}");
}

/// A pulse A over t₀ leaves a slip of A² t₀²/(2 μ g) − A t₀²/2 against its direction. Both ends of the pulse are a step long, which is
/// 3e-3 of it at 1 ms; the tolerance is that of the ends at 0.1 ms.
#[test]
fn a_rectangular_pulse_slips_by_its_closed_form() {
    let (a, t0, mu) = (0.5 * G, 0.3, 0.2);
    let step = 1e-4;
    let pulse: Vec<f64> = (0..12_000).map(|i| if (i as f64) * step < t0 - 0.5 * step { a } else { 0.0 }).collect();
    let found = slide(&pulse, step, mu).slip.last().copied().unwrap();
    let expected = a * a * t0 * t0 / (2.0 * mu * G) - a * t0 * t0 / 2.0;
    assert!((found.abs() / expected - 1.0).abs() < 1e-3, "{found} {expected}");
}

/// Steady slip under A sin ωt has the range 2 A/ω² √(1 − (π η/2)²), η = μ g/A below 0.537.
#[test]
fn harmonic_motion_slips_by_its_closed_form() {
    let (a, omega) = (0.4 * G, std::f64::consts::TAU * 2.0);
    let step = 2e-4;
    for eta in [0.1, 0.3, 0.5] {
        let motion: Vec<f64> = (0..200_000).map(|i| a * (omega * step * i as f64).sin()).collect();
        let history = slide(&motion, step, eta * a / G);
        let last = &history.slip[history.slip.len() - 2_500..];
        let range = last.iter().copied().fold(f64::MIN, f64::max) - last.iter().copied().fold(f64::MAX, f64::min);
        let expected = 2.0 * a / (omega * omega) * (1.0 - (std::f64::consts::FRAC_PI_2 * eta).powi(2)).sqrt();
        assert!((range / expected - 1.0).abs() < 1e-3, "{eta}: {range} {expected}");
        assert!(history.balance < 1e-3, "{}", history.balance);
    }
}

/// Doubled ground motion and friction slip twice as far.
#[test]
fn slip_is_homogeneous() {
    let motion: Vec<f64> = (0..4000).map(|i| 3.0 * (0.013 * i as f64).sin() * (0.0017 * i as f64).cos()).collect();
    let double: Vec<f64> = motion.iter().map(|a| 2.0 * a).collect();
    let (one, two) = (slide(&motion, 1e-3, 0.1), slide(&double, 1e-3, 0.2));
    for (a, b) in one.slip.iter().zip(&two.slip) {
        assert!((2.0 * a - b).abs() < 1e-12);
    }
}

/// Example 05's base, elastic, on 100 MN/m³, and its impulsive mass on one spring.
fn base(weight: f64, modulus: f64) -> Law {
    let plate = Plate { thickness: 0.01, young_modulus: 2.05e11, poisson_ratio: 0.3, yield_stress: None };
    let pressure = 128e3;
    let edge = Edge {
        radius: 20.0,
        thickness: 0.025,
        young_modulus: 2.05e11,
        poisson_ratio: 0.3,
        pressure,
        gradient: 870.0 * G,
    };
    let strip = Strip::new(Bands::uniform(plate), Rim::Wall(edge), 20.0, modulus, pressure, Plan::Strip).unwrap();
    let reach = 0.08 * (1e8 / modulus).min(1.0) + 0.02;
    let curve = Curve::of(&strip, weight, -reach, 0.25).unwrap();
    let rocking = Rocking::new(20.0, weight, vec![(pressure, curve)]).unwrap();
    Law::new(&rocking, 2e-3).unwrap()
}

const MASS: f64 = 7.479e6;
const ARM: f64 = 6.065;

fn impulsive() -> Body {
    let omega = std::f64::consts::TAU / 0.2181;
    Body {
        modes: vec![BodyMode {
            omega,
            damping: 0.02,
            translation: MASS.sqrt(),
            rotation: MASS.sqrt() * ARM,
            pressure: 0.0,
        }],
        mass: MASS,
        first_moment: MASS * ARM,
        second_moment: MASS * ARM * ARM,
    }
}

fn rock(body: &Body, law: Option<&Law>, ground: &[f64], step: f64) -> History {
    march(&Run {
        body,
        law,
        ring: None,
        heave: None,
        waves: None,
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: None,
        rigid_pressure: [0.0; 2],
        step,
        ground,
    })
    .unwrap()
}

/// After a short pulse the undamped body swings freely. Its period at a given energy is 4 ∫ du/√(2 (E₀ − E(u))/m), where the total
/// displacement u of the mass is that of its spring and of the base together, u = V/k + h ψ with V h = M(ψ).
#[test]
fn free_rocking_has_the_period_of_its_quadrature() {
    let law = base(21_350.0, 1e8);
    let mut body = impulsive();
    body.modes[0].damping = 0.0;
    let stiffness = MASS * body.modes[0].omega.powi(2);
    for peak in [2.0, 4.0] {
        let step = 2.5e-4;
        let motion: Vec<f64> = (0..12_000).map(|i| if i < 160 { peak } else { 0.0 }).collect();
        let history = rock(&body, Some(&law), &motion, step);
        assert!(history.balance < 1e-3, "{}", history.balance);
        let late = &history.rotation[4_000..];
        let crossings: Vec<f64> = late
            .windows(2)
            .enumerate()
            .filter(|(_, w)| w[0] < 0.0 && w[1] >= 0.0)
            .map(|(i, w)| i as f64 - w[0] / (w[1] - w[0]))
            .collect();
        let period = step * (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
        let largest = late.iter().copied().fold(0.0, f64::max);
        // ψ = ψ₀ sin χ removes the singularity of the quadrature.
        let moment = |psi: f64| law.respond(psi, 0.0, 0.0, &[]);
        let energy = |psi: f64| law.work(psi) + 0.5 * (moment(psi).moment / ARM).powi(2) / stiffness;
        let total = energy(largest);
        let n = 400;
        let quarter: f64 = (0..n)
            .map(|i| {
                let chi = std::f64::consts::FRAC_PI_2 * (i as f64 + 0.5) / n as f64;
                let psi = largest * chi.sin();
                let du = moment(psi).tangent / (ARM * stiffness) + ARM;
                du * largest * chi.cos() / (2.0 * (total - energy(psi)) / MASS).sqrt()
            })
            .sum::<f64>()
            * std::f64::consts::FRAC_PI_2
            / n as f64;
        // Method of second order, (ω h)²/12 = 1e-6 in the period; its loss of amplitude shortens it by less than 1e-3.
        assert!((period / (4.0 * quarter) - 1.0).abs() < 1e-3, "{period} {}", 4.0 * quarter);
    }
}

/// A body that sticks and slides many times while its wall vibrates: energy closes within 1e-3 at 1 ms, and half the step moves the loss in
/// friction by less than 1 %.
#[test]
fn sliding_of_a_flexible_body_converges() {
    let body = impulsive();
    let slide = |parts: u32| {
        let step = 1e-3 / f64::from(parts);
        let motion: Vec<f64> = (0..6000 * parts)
            .map(|i| step * f64::from(i))
            .map(|t| 2.5 * ((19.0 * t).sin() + (7.0 * t).sin()))
            .collect();
        march(&Run {
            body: &body,
            law: None,
            ring: None,
            heave: None,
            waves: None,
            hysteretic: 0.0,
            dashpot: 0.0,
            friction: Some(Friction {
                coefficient: 0.2,
                weight: 2.0 * MASS * G,
                vertical: Vec::new(),
                springs: Vec::new(),
                delay: 0.0,
            }),
            rigid_pressure: [0.0; 2],
            step,
            ground: &motion,
        })
        .unwrap()
    };
    let (coarse, fine) = (slide(1), slide(2));
    assert!(coarse.balance < 1e-3, "{}", coarse.balance);
    let [a, b] = [&coarse, &fine].map(|history| history.energy.friction);
    assert!(b > 0.0 && (a / b - 1.0).abs() < 1e-2, "{a} {b}");
}

/// On ground as hard as rock under a wall so heavy that nothing lifts, the body moves as on a fixed base.
#[test]
fn a_heavy_wall_on_rock_does_not_rock() {
    let law = base(2e6, 1e11);
    let body = impulsive();
    let motion: Vec<f64> = (0..4000).map(|i| 2.0 * (0.02 * i as f64).sin()).collect();
    let (free, fixed) = (rock(&body, Some(&law), &motion, 1e-3), rock(&body, None, &motion, 1e-3));
    let peak = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    assert!((peak(&free.shear) / peak(&fixed.shear) - 1.0).abs() < 2e-2);
    assert!(peak(&free.rotation) < law.first_uplift());
}

/// A dashpot that opens with the contact falls as the base turns, faster than its own tangent grows: Newton's method alone swings or creeps
/// there. Every step has its equilibrium, and energy closes within 1e-2 at steps of 1 ms, of which the contact closes in a few.
#[test]
fn a_dashpot_on_hard_ground_finds_every_step() {
    let law = base(21_350.0, 1e10);
    let body = impulsive();
    let motion: Vec<f64> = (0..6000)
        .map(|i| 1e-3 * f64::from(i))
        .map(|t| 3.0 * ((19.0 * t).sin() + (41.0 * t).sin() + (7.0 * t).sin()))
        .collect();
    for dashpot in [1e9, 1e10, 1e11] {
        let history = march(&Run {
            body: &body,
            law: Some(&law),
            ring: None,
            heave: None,
            waves: None,
            hysteretic: 0.0,
            dashpot,
            friction: None,
            rigid_pressure: [0.0; 2],
            step: 1e-3,
            ground: &motion,
        });
        let history = history.unwrap_or_else(|error| panic!("{dashpot}: {error}"));
        assert!(history.energy.base_radiated > 0.0);
        assert!(history.balance < 1e-2, "{dashpot}: {}", history.balance);
    }
}

/// A block on a spring with a dashpot beside it, under a constant acceleration a: its first peak is (a/ω²) (1 + exp(−π ξ/√(1 − ξ²))), ξ = τ ω/2.
/// 1 %: 600 steps to a period, whose forces lag by a third of one.
#[test]
fn a_block_on_a_dashpot_overshoots_by_its_closed_form() {
    let (omega, xi, a) = (10.0, 0.2, 0.5);
    let spring = Spring { stiffness: 1000.0 * omega * omega, limit: 1000.0 * G };
    let step = 1e-3;
    let history = delayed(&[a; 500], step, 1.0, vec![spring], 2.0 * xi / omega);
    let found = history.slip.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
    let decay = (-std::f64::consts::PI * xi / (1.0_f64 - xi * xi).sqrt()).exp();
    let expected = a / (omega * omega) * (1.0 + decay);
    assert!((found / expected - 1.0).abs() < 1e-2, "{found} {expected}");
    assert!(!history.slid && history.balance < 1e-2, "{}", history.balance);
}

/// Bottom pressure and shear of one mode on a fixed base are the same motion: p_b = p q̈ + r A and I = Γ q̈ + m A at the instants of the forces.
#[test]
fn the_pressure_of_a_mode_follows_its_shear() {
    let mut body = impulsive();
    body.modes[0].pressure = 3.0;
    body.mass *= 1.5;
    let ground: Vec<f64> = (0..400).map(|i| 2.0 * (0.03 * f64::from(i)).sin()).collect();
    let history = march(&Run {
        body: &body,
        law: None,
        ring: None,
        heave: None,
        waves: None,
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: None,
        rigid_pressure: [250.0, 0.0],
        step: 1e-3,
        ground: &ground,
    })
    .unwrap();
    let most = history.pressure.iter().fold(0.0_f64, |m, p| m.max(p.abs()));
    assert!(most > 1e3);
    for i in 1..ground.len() {
        let a = (1.0 - BEGIN) * ground[i] + BEGIN * ground[i - 1];
        let modal = (history.shear[i] - body.mass * a) / MASS.sqrt();
        let wanted = 3.0 * modal + 250.0 * a;
        assert!((history.pressure[i] - wanted).abs() < 1e-9 * most, "{i}");
    }
}

/// Values of a straight line at t − h/3 are those at t, but for the last one, which has none after it.
#[test]
fn accelerations_move_to_the_ends_of_the_steps() {
    let mut values: Vec<f64> = (0..6).map(|i| 2.0 * (f64::from(i) - 1.0 / 3.0)).collect();
    at_ends(&mut values);
    for (i, value) in values.iter().enumerate().take(5).skip(1) {
        assert!((value - 2.0 * i as f64).abs() < 1e-12, "{i}: {value}");
    }
}

/// The ground the other way round moves everything the other way round: heave, suction, springs that slip and friction on both sides. Its energies are the
/// same, and the balance closes with the loops of the base.
#[test]
fn a_mirrored_ground_mirrors_the_history() {
    let curve = |share: f64| {
        let point = |w: f64| Point {
            uplift: w,
            hold_down: if w < 0.0 { 1e7 * w } else { share * 1.2e5 * w.sqrt() },
            rotation: 0.0,
            rim_moment: 0.0,
            axial_force: 0.0,
            lifted_width: 0.0,
            plastic_rotation: 0.0,
        };
        let places = (-80..=80).map(|i| 0.6 * (f64::from(i) / 80.0).powi(3));
        (1e5 * share, Curve::through(places.map(point).collect()))
    };
    let rocking = Rocking::new(10.0, 15e3, [1.0, 1.5, 0.5].map(curve).to_vec()).unwrap();
    let law = Law::new(&rocking, 8e-3).unwrap();
    let heave = Heave::new(96e3, &rocking, &law).unwrap().damped(1e-3);
    let (mass, arm) = (1.5e6_f64, 4.0);
    let body = Body {
        modes: vec![BodyMode {
            omega: 25.0,
            damping: 0.02,
            translation: mass.sqrt(),
            rotation: mass.sqrt() * arm,
            pressure: 8.0,
        }],
        mass,
        first_moment: mass * arm,
        second_moment: mass * arm * arm + 1e7,
    };
    let springs = [3.0, 5.0].map(|k| Spring { stiffness: k * 1e7, limit: 2.3e6 });
    let run = |sign: f64| {
        let motion = |t: f64| sign * 1.5 * ((9.0 * t).sin() + 0.7 * (14.0 * t).sin());
        let ground: Vec<f64> = (0..=1500).map(|i| motion(1e-3 * f64::from(i))).collect();
        march(&Run {
            body: &body,
            law: Some(&law),
            ring: None,
            heave: Some(&heave),
            waves: None,
            hysteretic: 0.3,
            dashpot: 1e8,
            friction: Some(Friction {
                coefficient: 0.3,
                weight: 4.6e6 / 0.3,
                vertical: Vec::new(),
                springs: springs.to_vec(),
                delay: 1e-3,
            }),
            rigid_pressure: [2e3, 0.0],
            step: 1e-3,
            ground: &ground,
        })
        .unwrap()
    };
    let (one, other) = (run(1.0), run(-1.0));
    let peak = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    assert!(peak(&one.pressure) > 1e4 && peak(&one.rotation) > 1e-3 && peak(&one.slip) > 1e-3);
    for (a, b, sign) in [
        (&one.rotation, &other.rotation, -1.0),
        (&one.slip, &other.slip, -1.0),
        (&one.pressure, &other.pressure, -1.0),
        (&one.moment, &other.moment, -1.0),
        (&one.shear, &other.shear, -1.0),
        (&one.centre, &other.centre, 1.0),
    ] {
        let apart = a.iter().zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - sign * b).abs()));
        assert!(apart < 1e-6 * peak(a), "{apart} {}", peak(a));
    }
    assert!((one.energy.input / other.energy.input - 1.0).abs() < 1e-6);
    assert!(one.energy.base_hysteretic > 1e-3 * one.energy.input, "{:?}", one.energy);
    assert!(one.balance < 1e-2, "{}", one.balance);
}
