//! The modes of tanks under spectra.
//!
//! Source:    hand calculation; masses of potential flow in a rigid cylinder (Housner's problem, exact); bounds of time histories
//! Goal:      shear, moment and wave of the response-spectrum method
//! Tolerance: at each test

mod vertical;

use oscillator::record::Record;
use oscillator::spectrum::ordinates;
use tank::case::{Ec8Site, GroundMotion, GroundType};
use tank::options::LinearOptions;
use tank::{Case, Shape};

use super::*;
use crate::harmonic::test_tanks;
use crate::{Simulation, simulate};

/// A site, so that the engine keeps its modes; its numbers are of no account here.
fn with_site(mut case: Case) -> Case {
    case.site.ec8 = Some(Ec8Site {
        ground: GroundType::A,
        spectrum: 1,
        ag: 1.0,
        importance: 1.0,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    });
    case
}

fn quick() -> LinearOptions {
    LinearOptions { mesh_error: false, ..LinearOptions::default() }
}

fn options(combination: ModalCombination, parts: PartCombination) -> SpectrumOptions {
    SpectrumOptions { combination, parts, ..SpectrumOptions::DEFAULT }
}

const CQC: SpectrumOptions = SpectrumOptions::DEFAULT;

fn units(run: &Simulation) -> &ModalUnits {
    run.units.as_ref().expect("a case with a site")
}

/// Two modes and a rest by hand: 2 · 3 and 4 · 1, rest 5 · 0.5, at frequencies so far apart that CQC is SRSS.
#[test]
fn by_hand() {
    let mode = |kind, omega: f64| KeptMode { kind, number: 1, omega, damping: 1e-6, mass: 1.0 };
    let unit = Unit { modes: vec![4.0, 2.0], rest: 5.0, static_value: 0.0 };
    let tank = ModalUnits {
        modes: vec![mode(Kind::Sloshing, 1.0), mode(Kind::Structural, 4.0)],
        scalars: vec![(Channel::BaseShear, unit)],
        lines: Vec::new(),
        level: 1.0,
        vertical: None,
    };
    // The structural period, 1.6 s, lies behind the maximum at 0.1 s: no rigid share.
    let structural = |period: f64, _: f64| match period {
        0.0 => 0.5,
        t if t < 0.105 => 5.0,
        _ => 3.0,
    };
    let one = |_: f64, _: f64| 1.0;
    let action = Action { structural: &structural, sloshing: &one, wave: &one };
    let shear = |options: &SpectrumOptions| tank.respond(&action, options, true).values[&Quantity::BaseShear];
    let (i, c) = ((36.0_f64 + 6.25).sqrt(), 4.0);
    use ModalCombination as M;
    use PartCombination as P;
    for (found, expected) in [
        (shear(&CQC), i.hypot(c)),
        (shear(&options(M::Srss, P::Modal)), i.hypot(c)),
        (shear(&options(M::Srss, P::Srss)), i.hypot(c)),
        (shear(&options(M::Srss, P::Abs)), i + c),
        (shear(&options(M::Abs, P::Modal)), 6.0 + 2.5 + 4.0),
        (shear(&options(M::Abs, P::Srss)), 8.5_f64.hypot(4.0)),
        (shear(&SpectrumOptions { missing_mass: false, ..CQC }), 6.0_f64.hypot(4.0)),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
}

/// Zeros of J₁′ and the sloshing masses of a rigid cylinder over that of the liquid, m_n = 2 tanh(λ γ)/(γ λ (λ² − 1)), γ = H/R.
fn sloshing_masses(ratio: f64) -> [f64; 10] {
    let zeros = [
        1.841_184, 5.331_443, 8.536_316, 11.706_005, 14.863_589, 18.015_528, 21.164_370, 24.311_327, 27.457_051,
        30.601_923,
    ];
    zeros.map(|l: f64| 2.0 * (l * ratio).tanh() / (ratio * l * (l * l - 1.0)))
}

/// A rigid tank: shear m_i S_a(0) and m_1 S_a(T_1), wave 0.837 R S_a(T_1)/g, whatever the rule for modes. The wall is so stiff that its
/// modes, some 1e-3 s, see S_a(0) within 0.2 %; masses on the default mesh err by 0.1 % to 0.2 % (the highest of the ten sloshing modes most).
#[test]
fn a_rigid_tank_has_the_masses_of_potential_flow() {
    for (radius, depth) in [(10.0, 8.0), (5.0, 12.0), (20.0, 8.0)] {
        let wall = (1.05 * depth, 0.05);
        let case = with_site(test_tanks::case(Shape::Cylinder { radius }, &[wall], (1e16, 0.3, 1.0), (1000.0, depth)));
        let run = simulate(&case, &quick()).unwrap();
        let mass = 1000.0 * std::f64::consts::PI * radius * radius * depth;
        let convective = sloshing_masses(depth / radius);
        let impulsive = mass * (1.0 - convective.iter().sum::<f64>());
        let rising = |period: f64, _: f64| 1.0 + period.min(0.15);
        let (nothing, half) = (|_: f64, _: f64| 0.0, |_: f64, _: f64| 0.5);
        // Longer than the second sloshing mode on deep liquid, 2π √(R/(5.331 g)).
        let apart = 1.2 * std::f64::consts::TAU * (radius / (5.331 * 9.81)).sqrt();
        let first = |period: f64, _: f64| if period > apart { 0.5 } else { 0.0 };
        for rule in [ModalCombination::Cqc, ModalCombination::Srss, ModalCombination::Abs] {
            let options = options(rule, PartCombination::Modal);
            let of = |structural: Ordinates<'_>, sloshing: Ordinates<'_>| {
                let action = Action { structural, sloshing, wave: &half };
                units(&run).respond(&action, &options, true)
            };
            let shear = of(&rising, &nothing).values[&Quantity::BaseShear];
            assert!((shear / impulsive - 1.0).abs() < 5e-3, "{rule:?} {radius}: {}", shear / impulsive);
            let own = of(&nothing, &first).values[&Quantity::BaseShear];
            let periods: Vec<f64> = units(&run).modes.iter().map(KeptMode::period).filter(|t| *t > apart).collect();
            assert_eq!(periods.len(), 1, "{periods:?}");
            assert!((own / (0.5 * mass * convective[0]) - 1.0).abs() < 2e-3, "{rule:?} {radius}");
        }
        // The first mode alone: 2 R/(λ² − 1) S_a/g.
        let action = Action { structural: &nothing, sloshing: &nothing, wave: &first };
        let wave = units(&run).respond(&action, &CQC, true).values[&Quantity::SloshingHeight];
        let expected = 2.0 / (1.841_184_f64.powi(2) - 1.0) * radius * 0.5 / 9.81;
        assert!((wave / expected - 1.0).abs() < 2e-3, "{radius}: {}", wave / expected);
    }
}

/// Everything that follows the ground is the whole mass: modes and rest of the shear, to the mass balance of the engine.
#[test]
fn modes_and_rest_are_the_whole_mass() {
    let case = with_site(test_tanks::broad());
    let run = simulate(&case, &quick()).unwrap();
    let shear = units(&run).scalar(Channel::BaseShear).unwrap();
    let whole = shear.modes.iter().sum::<f64>() + shear.rest;
    let mass = case.liquid_mass() + case.tank.wall_mass();
    let balance = run.result.mass_balance[0].error;
    assert!((whole / mass - 1.0 - balance).abs() < 1e-9 && balance.abs() < 1e-3, "{whole} {mass}");
}

/// Under the spectrum of a record, the history of the same modes lies between bounds that hold for any signs: the largest part less all
/// others, and the sum of all. Spectra give ω² max |u|, the history of forces (ω² + 2 ξ ω d/dt) u: 2 ξ² = 0.1 % more at most for each
/// lightly damped mode, 2 % for none; the history is sampled at 1/20 of a period (1.2 %). CQC lies between, as the sum of squares.
#[test]
fn histories_lie_between_bounds() {
    let acceleration = (0..1500).map(|k| f64::from(k) * 0.01).map(|t| {
        let envelope = (t / 2.0).min(1.0) * (-0.15 * t).exp();
        envelope * ((3.1 * t).sin() + 0.8 * (17.0 * t).sin() + 0.6 * (41.0 * t + 1.0).sin())
    });
    let record =
        Record { name: "three waves".into(), dt: 0.01, acceleration: acceleration.collect(), processing: Vec::new() };
    let mut case = with_site(test_tanks::broad());
    case.ground_motion = Some(GroundMotion { horizontal: record.clone(), transverse: None, vertical: None });
    let run = simulate(&case, &quick()).unwrap();
    let of_record = |period: f64, damping: f64| ordinates(&record, period, damping).psa;
    let action = Action { structural: &of_record, sloshing: &of_record, wave: &of_record };
    let all = units(&run).respond(&action, &options(ModalCombination::Abs, PartCombination::Modal), true);
    let cqc = units(&run).respond(&action, &CQC, true);
    for quantity in [
        Quantity::SloshingHeight,
        Quantity::BaseShear,
        Quantity::BaseMoment,
        Quantity::OverturningMoment,
        Quantity::HoopStress,
    ] {
        let (history, sum) = (run.values[&quantity], all.values[&quantity]);
        assert!(history < 1.02 * sum, "{quantity:?}: {history} {sum}");
        assert!(cqc.values[&quantity] <= sum * (1.0 + 1e-12), "{quantity:?}");
    }
    for (quantity, channel) in
        [(Quantity::SloshingHeight, Channel::Wave(Side::Front)), (Quantity::BaseShear, Channel::BaseShear)]
    {
        let unit = units(&run).scalar(channel).unwrap();
        let parts = unit.modes.iter().zip(&all.accelerations).map(|(r, a)| (r * a).abs());
        let largest = parts.fold(0.0, f64::max);
        let history = run.values[&quantity];
        let others = all.values[&quantity] - largest;
        assert!(history > 0.98 * (largest - others), "{quantity:?}: {history} {largest} {others}");
    }
}
