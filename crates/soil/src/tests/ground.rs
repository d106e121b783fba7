//! A structure on a disc against closed forms: springs alone, soil that does not yield, and soil without mass.

use std::f64::consts::{PI, TAU};

use crate::body::{self, Body, Mode};
use crate::chain::Chain;
use crate::disc::{Disc, Impedance, Soil};
use crate::structure::{OnSoil, Structure};

/// k = 4·10⁷ N/m.
const STRUCTURE: Structure = Structure { mass: 1e5, height: 3.0, period: TAU / 20.0, damping: 0.02 };

/// G = 2·10⁷ Pa: K_x = 3.2·10⁸/1.75 N/m, K_θ = 1.28·10⁹/2.25 N m, so that k/K_x + k h²/K_θ = 0.21875 + 0.6328125.
const SOIL: Soil = Soil { density: 2000.0, shear_wave_velocity: 100.0, poisson_ratio: 0.25, damping: 0.0, depth: None };

const FLEXIBILITY: f64 = 0.851_562_5;

/// The same springs without inertia and radiation, which is √(G ρ) to an area.
const MASSLESS: Soil = Soil { density: 2e-9, shear_wave_velocity: 1e8, ..SOIL };

const STIFF: Soil = Soil { shear_wave_velocity: 1e6, ..SOIL };

fn on(soil: Soil, structure: Structure) -> OnSoil {
    OnSoil::new(structure, Disc::new(2.0, soil).unwrap()).unwrap()
}

fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() < tolerance, "{found}, not {wanted}");
}

/// The structure as a body of one mode, on a slab (mass, moment of inertia).
fn body(structure: &Structure, slab: [f64; 2]) -> Body {
    let Structure { mass, height, .. } = *structure;
    Body {
        modes: vec![Mode {
            omega: TAU / structure.period,
            damping: structure.damping,
            translation: mass.sqrt(),
            rotation: mass.sqrt() * height,
        }],
        mass,
        first_moment: mass * height,
        second_moment: mass * height * height,
        slab_mass: slab[0],
        slab_inertia: slab[1],
    }
}

/// The deformation by both marches.
fn marches(on: &OnSoil, slab: [f64; 2], ground: &[f64], h: f64, parts: usize) -> [Vec<f64>; 2] {
    let chain = Chain::new(on, slab).unwrap().march(ground, h, parts);
    let found = body::march(&body(&on.structure, slab), &on.disc, ground, h, parts).unwrap();
    let scale = on.structure.mass.sqrt();
    [chain, found.modes[0].iter().map(|q| q[1] / scale).collect()]
}

/// T̃ = T √(1 + k/K_x + k h²/K_θ). What a small damping of the wall leaves is ξ (T/T̃)³, of the soil ξ_g (1 − (T/T̃)²) (Veletsos & Meek 1974).
#[test]
fn springs_in_series() {
    close(on(SOIL, STRUCTURE).flexibility(), FLEXIBILITY, 1e-14);
    let ratio = (1.0 + FLEXIBILITY).sqrt();
    for (wall, ground, wanted) in [(1e-4, 0.0, 1e-4 / ratio.powi(3)), (0.0, 1e-4, 1e-4 * (1.0 - ratio.powi(-2)))] {
        let structure = Structure { damping: wall, ..STRUCTURE };
        let on = on(Soil { damping: ground, ..SOIL }, structure);
        let found = on.effective(Impedance::Static).unwrap();
        close(found.period, STRUCTURE.period * ratio, 1e-7);
        close(found.damping, wanted, 1e-6);
        assert!((on.foundation_damping(found) - (wanted - wall / ratio.powi(3))).abs() < 1e-10);
    }
}

/// On a ground that does not yield every definition gives the structure itself.
#[test]
fn rigid_ground_leaves_the_structure() {
    let on = on(STIFF, STRUCTURE);
    let mode = Chain::new(&on, [0.0; 2]).unwrap().complex_mode().unwrap();
    for found in [on.effective(Impedance::Cone).unwrap(), on.peak(Impedance::Cone).unwrap(), mode] {
        close(found.period, STRUCTURE.period, 1e-6);
        close(found.damping, STRUCTURE.damping, 1e-6);
    }
    // The amplification of an oscillator, 1/√((1 − r²)² + (2 ξ r)²).
    for r in [0.3_f64, 1.0, 2.5] {
        let wanted = (1.0 - r * r).hypot(2.0 * 0.02 * r).recip();
        close(on.deformation(20.0 * r, Impedance::Cone), wanted, 1e-6);
    }
}

/// Without mass and radiation of the soil the chain is an oscillator of the period T̃ and the damping ξ (T/T̃)³; with a slab and no arm it is
/// two masses in a row: m m_b ω⁴ − (k (m + m_b) + K_x m) ω² + k K_x = 0.
#[test]
fn modes_on_springs_without_mass() {
    let thin = Structure { damping: 1e-4, ..STRUCTURE };
    let found = Chain::new(&on(MASSLESS, thin), [0.0; 2]).unwrap().complex_mode().unwrap();
    let ratio = (1.0 + FLEXIBILITY).sqrt();
    close(found.period, STRUCTURE.period * ratio, 1e-6);
    close(found.damping, 1e-4 / ratio.powi(3), 1e-3);

    let flat = Structure { height: 1e-6, damping: 0.0, ..STRUCTURE };
    let found = Chain::new(&on(MASSLESS, flat), [4e4, 0.0]).unwrap().complex_mode().unwrap();
    let (m, slab, k, ground) = (1e5, 4e4, 4e7, 3.2e8 / 1.75_f64);
    let half = 0.5 * (k * (m + slab) + ground * m) / (m * slab);
    let square = half - (half * half - k * ground / (m * slab)).sqrt();
    close(found.period, TAU / square.sqrt(), 1e-6);
}

/// Under a constant acceleration a from rest, u = −(a/ω²)(1 − cos ω̃t): the soil changes the period, not the force. 200 steps to a period
/// lengthen it by 8e-5.
#[test]
fn step_response_on_springs_without_mass() {
    let structure = Structure { damping: 0.0, ..STRUCTURE };
    let on = on(MASSLESS, structure);
    let period = STRUCTURE.period * (1.0 + FLEXIBILITY).sqrt();
    let samples = 41;
    for found in marches(&on, [0.0; 2], &vec![3.0; samples], period / 20.0, 10) {
        assert_eq!(found.len(), samples);
        for (i, u) in found.iter().enumerate() {
            let wanted = -3.0 / 400.0 * (1.0 - (TAU * i as f64 / 20.0).cos());
            assert!((u - wanted).abs() < 2e-5, "{i}: {u} {wanted}");
        }
    }
}

/// The steady state of a march is the deformation of the complex stiffness: 100 periods on radiating soil, 200 steps to a
/// period.
#[test]
fn steady_state_of_the_marches() {
    for omega in [6.0, 14.0, 25.0] {
        let on = on(SOIL, Structure { damping: 0.1, ..STRUCTURE });
        let wanted = on.deformation(omega, Impedance::Cone) / 400.0;
        let h = TAU / omega / 200.0;
        let ground: Vec<f64> = (0..20_000).map(|i| (omega * h * f64::from(i)).sin()).collect();
        for found in marches(&on, [0.0; 2], &ground, h, 1) {
            let most = found[19_800..].iter().fold(0.0_f64, |most, u| most.max(u.abs()));
            close(most, wanted, 1e-3);
        }
    }
}

/// A slab, trapped soil, and steps between samples: two formulations of one body, one in displacements, one in accelerations.
#[test]
fn both_marches_agree() {
    let soil = Soil { poisson_ratio: 0.45, ..SOIL };
    let ground: Vec<f64> = (0..300).map(|i| (0.11 * f64::from(i)).sin() * (0.37 * f64::from(i)).cos()).collect();
    let [chain, body] = marches(&on(soil, STRUCTURE), [6e4, 9e4], &ground, 0.02, 3);
    let most = chain.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    let apart = chain.iter().zip(&body).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(most > 1e-3 && apart < 1e-9 * most, "{apart} {most}");
}

/// Forces and moments about the foundation are in equilibrium at each sample, of two modes that leave a part of the mass to the base, and two halves of
/// a mode are the mode.
#[test]
fn a_body_is_in_equilibrium() {
    let whole = [(18.0, 200.0, 700.0), (45.0, 90.0, -150.0)];
    let mode = |(omega, translation, rotation): (f64, f64, f64)| Mode { omega, damping: 0.03, translation, rotation };
    let body = Body {
        modes: whole.map(mode).to_vec(),
        mass: 7e4,
        first_moment: 1.5e5,
        second_moment: 8e5,
        slab_mass: 3e4,
        slab_inertia: 4e4,
    };
    let half =
        |m: &Mode| Mode { translation: m.translation / 2.0_f64.sqrt(), rotation: m.rotation / 2.0_f64.sqrt(), ..*m };
    let halves = Body { modes: body.modes.iter().flat_map(|m| [half(m), half(m)]).collect(), ..body.clone() };
    let disc = Disc::new(2.0, MASSLESS).unwrap();
    let springs = disc.stiffness();
    let ground: Vec<f64> = (0..200).map(|i| 2.0 * (0.2 * f64::from(i)).sin()).collect();
    let [found, parted] = [&body, &halves].map(|b| body::march(b, &disc, &ground, 0.01, 2).unwrap());
    let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let (force, moment) = (springs.horizontal * most(&found.translation), springs.rocking * most(&found.rotation));
    assert!(force > 1e4 && moment > 1e4);
    for i in 1..ground.len() {
        let (a, turn) = (found.acceleration[i], found.rotational_acceleration[i]);
        let inertia =
            |row: fn(&Mode) -> f64| -> f64 { body.modes.iter().zip(&found.modes).map(|(m, q)| row(m) * q[i][0]).sum() };
        let sum = 1e5 * a + inertia(|m| m.translation) + 1.5e5 * turn + springs.horizontal * found.translation[i];
        assert!(sum.abs() < 1e-6 * force, "{i}: {sum} {force}");
        let sum = 8.4e5 * turn + inertia(|m| m.rotation) + 1.5e5 * a + springs.rocking * found.rotation[i];
        assert!(sum.abs() < 1e-6 * moment, "{i}: {sum} {moment}");
        assert!((found.translation[i] - parted.translation[i]).abs() < 1e-9 * force / springs.horizontal);
    }
}

/// The cone's internal rotation, eliminated from the chain, is the rocking impedance of the disc.
#[test]
fn the_internal_rotation_is_the_impedance() {
    for nu in [0.25, 0.45] {
        let on = on(Soil { poisson_ratio: nu, ..SOIL }, STRUCTURE);
        for omega in [1.0, 30.0, 200.0] {
            let (a, b) = (Chain::rocking_impedance(&on, omega), on.disc.rocking(omega, Impedance::Cone));
            assert!((a - b).norm() < 1e-12 * b.norm(), "{a} {b}");
        }
    }
}

/// m = Γ², h = |Γ^ψ/Γ|; a body carries its modes where their shares do not exceed its mass and its second moment.
#[test]
fn shares_of_a_mode() {
    let mode = Mode { omega: 10.0, damping: 0.05, translation: 2.0, rotation: -3.0 };
    let wanted = Structure { mass: 4.0, height: 1.5, period: 0.2 * PI, damping: 0.05 };
    assert_eq!(mode.structure(), wanted);
    let run = |mass: f64, second_moment: f64, slab: [f64; 2]| {
        let body = Body {
            modes: vec![mode],
            mass,
            first_moment: 0.0,
            second_moment,
            slab_mass: slab[0],
            slab_inertia: slab[1],
        };
        body::march(&body, &Disc::new(2.0, SOIL).unwrap(), &[0.0; 2], 0.01, 1).is_ok()
    };
    assert!(run(4.0, 9.0, [0.0; 2]));
    assert!(!run(3.99, 9.0, [0.0; 2]) && !run(4.0, 8.99, [0.0; 2]));
    assert!(!run(4.0, 9.0, [-1.0, 0.0]) && !run(4.0, 9.0, [0.0, -1.0]));
    assert!(
        Chain::new(&on(SOIL, STRUCTURE), [-1.0, 0.0]).is_err()
            && Chain::new(&on(SOIL, STRUCTURE), [0.0, -1.0]).is_err()
    );
}
