//! Source:    statics by hand and brute force over time, angle and place, written down again here
//! Goal:      the governing demand, capacity, time, height and angle of each limit state
//! Tolerance: rounding, but where an angle is searched for in steps of 15° or exactly

use std::collections::BTreeMap;

use tank::assessment::{Check, CheckStatus};
use tank::case::Case;
use tank::demand::{Demands, OnWall, Peak, Place, Surface};
use tank::{Anchors, Shape, Support};

use super::limit_states::UPLIFT;
use super::*;
use crate::samples::{case, course, steel};

mod free;
mod isolators;
mod plates;
mod scales;

const FY: f64 = 235e6;
const R: f64 = 10.0;

/// Two courses of steel, 14 mm and 8 mm, 5 m each, 8.5 m of water; no site.
fn steel_tank() -> Case {
    let mut plate = steel();
    plate.yield_strength = Some(FY);
    plate.allowable_stress = Some(137e6);
    let courses = vec![course(5.0, 0.014, plate.clone()), course(5.0, 0.008, plate)];
    case(Shape::Cylinder { radius: R }, courses, 8.5, None)
}

/// One place whose histories are the given ones, in MPa and kPa, at instants 1 s apart.
struct Given {
    hoop: (f64, Vec<f64>, Vec<f64>),
    axial: (f64, Vec<f64>, Vec<f64>),
    shear: Vec<f64>,
    pressure: (f64, Vec<f64>, Vec<f64>),
    bending: (f64, Vec<f64>),
}

impl Given {
    fn demands(&self, z: f64, course: usize) -> Demands {
        let mut states = Vec::new();
        let mut keep = |values: &[f64], unit: f64| {
            states.push(values.iter().map(|v| v * unit).collect::<Vec<f64>>());
            vec![(states.len() - 1, 1.0)]
        };
        let mut on_wall = |of: &(f64, Vec<f64>, Vec<f64>), unit: f64| OnWall {
            rest: of.0 * unit,
            even: keep(&of.1, unit),
            odd: keep(&of.2, unit),
        };
        let hoop = on_wall(&self.hoop, 1e6);
        let axial = on_wall(&self.axial, 1e6);
        let pressure = on_wall(&self.pressure, 1e3);
        let still = vec![0.0; self.hoop.1.len()];
        let bending = on_wall(&(self.bending.0, still.clone(), self.bending.1.clone()), 1e6);
        let shear = keep(&self.shear, 1e6);
        Demands {
            times: (0..still.len()).map(|k| k as f64).collect(),
            places: vec![Place {
                z,
                course,
                turned: 0.0,
                hoop,
                axial,
                bending: Some(bending),
                shear: Some(shear),
                pressure: Some(pressure),
            }],
            wave: Some(Peak { value: 0.4, time: 3.0, theta: std::f64::consts::PI }),
            states,
            ..Demands::default()
        }
    }
}

/// Histories without order, by a linear congruence.
fn noise(seed: u64, amplitude: f64) -> Vec<f64> {
    let mut state = seed;
    let next = |_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        amplitude * ((state >> 33) as f64 / f64::from(1u32 << 30) - 1.0)
    };
    (0..400).map(next).collect()
}

fn shaken(seed: u64) -> Given {
    let of =
        |rest: f64, k: u64, amplitude: f64| (rest, noise(seed + k, 0.3 * amplitude), noise(seed + k + 1, amplitude));
    Given {
        hoop: of(60.0, 10, 45.0),
        axial: of(-2.0, 20, 25.0),
        shear: noise(seed + 30, 40.0),
        pressure: of(83.0, 40, 60.0),
        bending: (90.0, noise(seed + 50, 70.0)),
    }
}

/// The site of the worked example of API 650: friction 0.4, joint efficiency 1.
fn api_site() -> tank::case::Api650Site {
    crate::api650::example::case().site.api650.expect("an API site")
}

fn found<'a>(findings: &'a Findings, id: &str) -> &'a Check {
    let check = findings.checks.iter().find(|check| check.id == id);
    check.unwrap_or_else(|| panic!("no check {id}: {:?}", findings.checks))
}

fn assessed(case: &Case, demands: &Demands) -> Findings {
    assess(case, &counted(case, &[]), demands, &BTreeMap::new())
}

/// Value of a quantity at an instant and an angle, from the given numbers.
fn at(of: &(f64, Vec<f64>, Vec<f64>), k: usize, theta: f64) -> f64 {
    of.0 + of.1[k] + of.2[k] * theta.cos()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} {expected}");
}

/// A.10.2 and A.10.3 with the formulas of the annex typed again, over all instants and 181 angles.
#[test]
fn buckling_governs_where_brute_force_finds_it() {
    let case = steel_tank();
    let (e, s, r) = (210e9, 0.014, R);
    let classical = 0.6 * e * s / r;
    let elastic = |p: f64| {
        let x = 1.24 * 0.06 * (r / s).sqrt();
        let knock = 1.0 - x * ((1.0 + 2.0 / x).sqrt() - 1.0);
        let slender = FY / (knock * classical);
        let sigma_o = if slender <= 2.0 { FY * (1.0 - slender / 4.0) } else { knock * classical };
        let bar = p.max(0.0) * r / (s * classical);
        let sigma_p = if bar < 5.0 {
            classical * (1.0 - ((1.0 - bar / 5.0) * (1.0 - sigma_o / classical)).powi(2)).sqrt()
        } else {
            classical
        };
        0.19 * classical + 0.81 * sigma_p
    };
    let collapse = |p: f64| {
        let ratio = r / s / 400.0;
        classical
            * (1.0 - (p.max(0.0) * r / (s * FY)).powi(2))
            * (1.0 - 1.0 / (1.12 + ratio.powf(1.15)))
            * (ratio + FY / 250e6)
            / (ratio + 1.0)
    };
    for seed in [1, 2, 3, 4] {
        let given = shaken(seed);
        let findings = assessed(&case, &given.demands(0.0, 0));
        let limits: [(&str, &dyn Fn(f64) -> f64); 2] =
            [("buckling_elastic", &elastic), ("buckling_elastic_plastic", &collapse)];
        for (id, capacity) in limits {
            let mut worst = 0.0_f64;
            for k in 0..given.shear.len() {
                for i in 0..=180 {
                    let theta = f64::from(i).to_radians();
                    let (sigma, p) = (-at(&given.axial, k, theta) * 1e6, at(&given.pressure, k, theta) * 1e3);
                    worst = worst.max(sigma / capacity(p));
                }
            }
            let check = found(&findings, id);
            let utilisation = check.utilisation.unwrap();
            // The search goes in steps of 15°, which hold both sides: between two of them a smooth maximum is off by less than 1 %.
            assert!(utilisation <= worst * (1.0 + 1e-12) && utilisation >= 0.99 * worst, "{id}: {utilisation} {worst}");
            // What is printed belongs together.
            let (k, theta) = (check.time_s.unwrap() as usize, check.theta.unwrap());
            close(check.demand.unwrap(), -at(&given.axial, k, theta) * 1e6, 1e-9);
            close(check.capacity.unwrap(), capacity(at(&given.pressure, k, theta) * 1e3), 1e-9);
        }
    }
}

/// Hoop stress at a side; the equivalent stress at 3601 angles, shear included.
#[test]
fn stresses_govern_where_brute_force_finds_them() {
    let case = steel_tank();
    for seed in [5, 6, 7, 8] {
        let given = shaken(seed);
        let findings = assessed(&case, &given.demands(0.0, 0));
        let (mut hoop, mut equivalent) = (0.0_f64, 0.0_f64);
        for k in 0..given.shear.len() {
            for i in 0..=3600 {
                let theta = (f64::from(i) / 20.0).to_radians();
                let (a, b) = (at(&given.hoop, k, theta), at(&given.axial, k, theta));
                let shear = given.shear[k] * theta.sin();
                hoop = hoop.max(a);
                equivalent = equivalent.max((a * a + b * b - a * b + 3.0 * shear * shear).sqrt());
            }
        }
        close(found(&findings, "hoop_yield").demand.unwrap(), hoop * 1e6, 1e-12);
        // 0.05° from a smooth maximum: 1e-6.
        close(found(&findings, "equivalent_stress").demand.unwrap(), equivalent * 1e6, 1e-5);
    }
}

/// Motion along x and y at every 0.1° of the whole circumference: what goes with cos θ under x goes with sin θ under y, the shear with
/// sin θ and −cos θ. Amplitudes are exact; the equivalent stress is searched every 5°, at the best instant every 0.1°: another instant
/// may be larger by what 2.5° change of a square of a harmonic, 1 − cos 5° = 0.4 %.
#[test]
fn two_components_govern_where_brute_force_finds_them() {
    let mut case = steel_tank();
    case.tank.anchors =
        Some(Anchors { count: 20, capacity: Some(40e3), attachment_capacity: None, ..Anchors::default() });
    for seed in [15, 16, 17] {
        let (x, y) = (shaken(seed), shaken(seed + 1000));
        let mut demands = x.demands(0.0, 0);
        demands.transverse = y.demands(0.0, 0).states;
        let findings = assessed(&case, &demands);
        let (mut hoop, mut pull, mut equivalent) = (0.0_f64, 0.0_f64, 0.0_f64);
        for k in 0..x.shear.len() {
            for i in 0..3600 {
                let theta = (f64::from(i) / 10.0).to_radians();
                let (c, s) = (theta.cos(), theta.sin());
                let of = |x: &(f64, Vec<f64>, Vec<f64>), y: &(f64, Vec<f64>, Vec<f64>)| {
                    x.0 + x.1[k] + x.2[k] * c + y.2[k] * s
                };
                let (a, b) = (of(&x.hoop, &y.hoop), of(&x.axial, &y.axial));
                let shear = x.shear[k] * s - y.shear[k] * c;
                (hoop, pull) = (hoop.max(a), pull.max(b));
                equivalent = equivalent.max((a * a + b * b - a * b + 3.0 * shear * shear).sqrt());
            }
        }
        // 0.05° from a maximum: 4e-7.
        close(found(&findings, "hoop_yield").demand.unwrap(), hoop * 1e6, 1e-6);
        let demand = found(&findings, "equivalent_stress").demand.unwrap();
        assert!(demand <= equivalent * 1e6 * (1.0 + 1e-6) && demand >= 0.996 * equivalent * 1e6);
        // F_a = σ_z t 2 π R/20.
        let force = pull * 1e6 * 0.014 * std::f64::consts::TAU * R / 20.0;
        close(found(&findings, "anchorage").demand.unwrap(), force, 1e-6);
    }
}

/// A wall that bends to ± b: the range from the empty tank or between the extremes, σ_b and ν σ_b of one sign.
#[test]
fn the_range_at_the_base_counts_both_extremes() {
    let nothing = (0.0, vec![0.0; 3], vec![0.0; 3]);
    let given = Given {
        hoop: nothing.clone(),
        axial: nothing.clone(),
        shear: vec![0.0; 3],
        pressure: nothing,
        bending: (100.0, vec![0.0, 150.0, -250.0]),
    };
    let findings = assessed(&steel_tank(), &given.demands(0.0, 0));
    let check = found(&findings, "equivalent_stress_at_base");
    // At θ = 0 from 250 to −150 MPa, at θ = 180° from −50 to 350 MPa: 400 MPa √(1 + 0.09 − 0.3).
    close(check.demand.unwrap(), 400e6 * 0.79_f64.sqrt(), 1e-9);
    close(check.capacity.unwrap(), 2.0 * FY, 1e-12);
}

/// Pull of 3 MPa × 14 mm − 2 MPa × 14 mm of weight every 2π 10 m/20: 44 kN; no anchors: the input is named; weight enough: none pull.
#[test]
fn anchors_carry_the_pull_of_their_spacing() {
    let still = |rest: f64| (rest, vec![0.0; 2], vec![0.0; 2]);
    let given = |odd: f64| Given {
        hoop: still(0.0),
        axial: (-2.0, vec![0.0; 2], vec![0.0, odd]),
        shear: vec![0.0; 2],
        pressure: still(83.0),
        bending: (0.0, vec![0.0; 2]),
    };
    let mut case = steel_tank();
    case.tank.anchors =
        Some(Anchors { count: 20, capacity: Some(40e3), attachment_capacity: None, ..Anchors::default() });
    let findings = assessed(&case, &given(-3.0).demands(0.0, 0));
    let check = found(&findings, "anchorage");
    close(check.demand.unwrap(), 14e3 * std::f64::consts::PI, 1e-9);
    assert_eq!(check.status, CheckStatus::Fails);
    close(check.theta.unwrap(), std::f64::consts::PI, 1e-12);
    assert_eq!(check.time_s, Some(1.0));
    case.tank.anchors = None;
    let missing = assessed(&case, &given(-3.0).demands(0.0, 0));
    let missing = found(&missing, "anchorage");
    assert_eq!((missing.status, missing.input.as_deref()), (CheckStatus::NotChecked, Some("tank.anchors")));
    let heavy = assessed(&case, &given(1.9).demands(0.0, 0));
    assert_eq!(found(&heavy, "anchorage").status, CheckStatus::NotApplicable);
    // The same wall unanchored leaves the model, and nothing but the freeboard holds.
    case.tank.support = Support::Unanchored;
    let lifted = assessed(&case, &given(-3.0).demands(0.0, 0));
    assert!(lifted.outside.is_some());
    assert_eq!(found(&lifted, UPLIFT.id).status, CheckStatus::NotChecked);
    let holds: Vec<&str> = lifted.checks.iter().filter(|c| c.holds()).map(|c| c.id.as_str()).collect();
    assert_eq!(holds, ["freeboard"]);
    let rests = assessed(&case, &given(1.9).demands(0.0, 0));
    assert_eq!((&rests.outside, found(&rests, UPLIFT.id).status), (&None, CheckStatus::NotApplicable));
}

/// F_C of the annex at the head of the instant: 83 t/(2.5 D) + 7.5 √(G H), at most 0.5 F_y, with GHD²/t² below 44.
#[test]
fn compression_under_api_650_takes_the_pressure_of_the_instant() {
    let given = shaken(11);
    let mut case = steel_tank();
    case.site.api650 = Some(api_site());
    let findings = assessed(&case, &given.demands(0.0, 0));
    let mut worst = 0.0_f64;
    for k in 0..given.shear.len() {
        for i in 0..=12 {
            let theta = (15.0 * f64::from(i)).to_radians();
            let head = at(&given.pressure, k, theta).max(0.0) / 9.81;
            let (t, d) = (14.0, 2.0 * R);
            let allowed =
                if head * d * d / (t * t) >= 44.0 { 83.0 * t / d } else { 83.0 * t / (2.5 * d) + 7.5 * head.sqrt() };
            worst = worst.max(-at(&given.axial, k, theta) / allowed.min(117.5));
        }
    }
    close(found(&findings, "shell_compression").utilisation.unwrap(), worst, 1e-9);
    // 1.33 × 137 MPa.
    close(found(&findings, "hoop_stress").capacity.unwrap(), 182.21e6, 1e-9);
    // Without Eurocode 8 its limit states are not asked for.
    assert!(findings.checks.iter().all(|check| check.id != "buckling_elastic"));
}

/// μ M (g + a_v): 0.4 × 2.67 Gg … of the worst instant, which is not that of the largest shear.
#[test]
fn sliding_takes_the_weight_of_the_instant() {
    let mut case = steel_tank();
    case.tank.support = Support::Unanchored;
    case.site.api650 = Some(api_site());
    let mass = std::f64::consts::PI * (R * R * 8.5 * 1000.0 + 2.0 * R * 7850.0 * (5.0 * 0.014 + 5.0 * 0.008));
    let demands = Demands {
        times: vec![0.0, 1.0, 2.0],
        states: vec![vec![0.0, 8e6, -7e6], vec![0.0, 2.0, -4.0]],
        base_shear: Some(vec![(0, 1.0)]),
        vertical: Some(vec![(1, 1.0)]),
        ..Demands::default()
    };
    let findings = assessed(&case, &demands);
    let check = found(&findings, "sliding_api");
    // 8/(9.81 + 2) = 0.68 < 7/(9.81 − 4) = 1.20.
    assert_eq!((check.time_s, check.limit_state.as_str()), (Some(2.0), "sliding"));
    close(check.demand.unwrap(), 7e6, 1e-12);
    close(check.capacity.unwrap(), 0.4 * mass * (9.81 - 4.0), 1e-9);
}

/// What is missing is named; a wall that is not metal leaves its strength open; a wave above the wall strikes the roof.
#[test]
fn what_is_missing_is_named() {
    let given = shaken(1);
    let mut case = steel_tank();
    case.tank.courses[1].material.yield_strength = None;
    let findings = assessed(&case, &given.demands(0.0, 0));
    for id in ["hoop_yield", "buckling_elastic", "buckling_elastic_plastic", "equivalent_stress"] {
        let check = found(&findings, id);
        assert_eq!(check.status, CheckStatus::NotChecked, "{id}");
        assert_eq!(check.input.as_deref(), Some("materials.steel.yield_strength"), "{id}");
    }
    let slides = found(&findings, "sliding");
    assert_eq!((slides.status, slides.input.as_deref()), (CheckStatus::NotChecked, Some("site.ec8.friction")));
    assert_eq!(found(&findings, "roof_impact").status, CheckStatus::NotApplicable);
    case.liquid.fill_height = 9.7;
    case.tank.roof.mass = 1e4;
    let findings = assessed(&case, &given.demands(0.0, 0));
    assert_eq!(found(&findings, "freeboard").status, CheckStatus::Fails);
    assert_eq!(found(&findings, "roof_impact").status, CheckStatus::NotChecked);
}

/// Waves in a tank of 10 m of radius with room for 2.5 m. With c between 0.9 and 1 a linear wave of 2.2 m has a crest above 2.6 m, one of
/// 1.9 m below 2.3 m; an engine that follows large waves gives the crest itself.
#[test]
fn the_crest_is_judged() {
    let mut case = steel_tank();
    case.liquid.fill_height = 7.5;
    let check = |case: &Case, rise: f64, surface: Surface| {
        let wave = Some(Peak { value: rise, ..Peak::default() });
        let demands = Demands { wave, surface, ..shaken(1).demands(0.0, 0) };
        found(&assessed(case, &demands), "freeboard").clone()
    };
    assert_eq!(check(&case, 2.2, Surface::Linear).status, CheckStatus::Fails);
    assert!(check(&case, 2.2, Surface::Linear).demand.is_some_and(|crest| (2.6..2.75).contains(&crest)));
    assert_eq!(check(&case, 1.9, Surface::Linear).status, CheckStatus::Holds);
    assert_eq!(check(&case, 2.4, Surface::Nonlinear).status, CheckStatus::Holds);
    assert_eq!(check(&case, 2.6, Surface::Nonlinear).status, CheckStatus::Fails);
    assert_eq!(check(&case, 2.4, Surface::Stopped).status, CheckStatus::NotChecked);
    assert_eq!(check(&case, 2.6, Surface::Stopped).status, CheckStatus::Fails);
    // Shallow, c is above 2: a crest that the factor underestimates does not hold by it, and fails all the same.
    case.liquid.fill_height = 4.0;
    assert_eq!(check(&case, 2.0, Surface::Linear).status, CheckStatus::NotChecked);
    assert_eq!(check(&case, 6.5, Surface::Linear).status, CheckStatus::Fails);
    // At a tenth of the radius the table has no row: only small waves hold.
    case.liquid.fill_height = 1.0;
    assert_eq!(check(&case, 0.05, Surface::Linear).status, CheckStatus::Holds);
    assert_eq!(check(&case, 0.2, Surface::Linear).status, CheckStatus::NotChecked);
}

/// The mesh error acts on the seismic part: 60 of 75 MPa are static, 10 % of the rest are 2 % of the whole.
#[test]
fn errors_act_on_the_seismic_part() {
    let still = |rest: f64| (rest, vec![0.0; 2], vec![0.0; 2]);
    let given = Given {
        hoop: (60.0, vec![0.0; 2], vec![0.0, 15.0]),
        axial: still(-2.0),
        shear: vec![0.0; 2],
        pressure: still(83.0),
        bending: (0.0, vec![0.0; 2]),
    };
    let mut case = steel_tank();
    let errors = BTreeMap::from([("hoop_stress".to_owned(), 0.1)]);
    let check = |case: &Case| {
        let findings = assess(case, &counted(case, &[]), &given.demands(0.0, 0), &errors);
        found(&findings, "hoop_yield").clone()
    };
    let sure = check(&case);
    close(sure.error.unwrap(), 0.02, 1e-9);
    assert!(!sure.within_error);
    for course in &mut case.tank.courses {
        course.material.yield_strength = Some(76e6);
    }
    let close_call = check(&case);
    assert!(close_call.holds() && close_call.within_error, "{close_call:?}");
}

/// Every limit state of every kind of tank ends as a check of its list, or is open by its requirement.
#[test]
fn checks_belong_to_declared_limit_states() {
    let given = shaken(1);
    let mut case = steel_tank();
    case.site.api650 = Some(api_site());
    for support in [Support::Anchored, Support::Unanchored] {
        case.tank.support = support;
        let states = limit_states(&case, &counted(&case, &[]));
        for check in assessed(&case, &given.demands(0.0, 0)).checks {
            assert!(states.iter().any(|s| s.id == check.limit_state), "{}", check.limit_state);
        }
    }
}

/// The codes of the site count, or the one whose procedures decide.
#[test]
fn the_deciding_code_gives_the_capacities() {
    let mut case = steel_tank();
    let ids = |case: &Case, decide: &[&str]| -> Vec<&'static str> {
        let decide: Vec<String> = decide.iter().map(|id| (*id).to_owned()).collect();
        let states = limit_states(case, &counted(case, &decide));
        let hoop = ["hoop_yield", "hoop_stress"];
        states.iter().map(|s| s.id).filter(|id| hoop.contains(id)).collect()
    };
    assert_eq!(ids(&case, &["fe"]), ["hoop_yield"]);
    case.site.api650 = Some(api_site());
    assert_eq!(ids(&case, &["fe"]), ["hoop_stress"]);
    // A code without site data gives nothing.
    assert_eq!(ids(&case, &["ec8-2006", "fe"]), ["hoop_stress"]);
    case.site.ec8 = Some(crate::ec8::example::site());
    assert_eq!(ids(&case, &["fe"]), ["hoop_yield", "hoop_stress"]);
    assert_eq!(ids(&case, &["ec8-2006", "fe"]), ["hoop_yield"]);
    assert_eq!(ids(&case, &["api650-2020", "fe"]), ["hoop_stress"]);
}

/// The hoop stress of the codes is that of a pressure: above the surface at 8.5 m the equivalent stress alone judges the rim.
#[test]
fn the_rim_has_no_hoop_stress_of_the_codes() {
    let mut case = steel_tank();
    case.site.api650 = Some(api_site());
    case.site.ec8 = Some(crate::ec8::example::site());
    let ids = |z: f64| -> Vec<&'static str> {
        let checks = assessed(&case, &shaken(5).demands(z, 1)).checks;
        let wanted = ["hoop_yield", "hoop_stress", "equivalent_stress"];
        let compared = |id: &&str| checks.iter().any(|c| c.id == *id && c.demand.is_some());
        wanted.into_iter().filter(compared).collect()
    };
    assert_eq!(ids(8.5), ["hoop_yield", "hoop_stress", "equivalent_stress"]);
    assert_eq!(ids(9.0), ["equivalent_stress"]);
}

/// The same forces in what corrosion leaves of the wall: a wall of 14 mm less 2 mm is judged as one of 12 mm whose stresses are 14/12 times,
/// in bending (14/12)² times as large. Both sides have one floating-point operation more or less: 1e-12.
#[test]
fn a_corroded_wall_is_judged_by_what_is_left() {
    let given = shaken(5);
    let mut corroded = steel_tank();
    corroded.tank.courses[0].corrosion = 0.002;
    let mut thin = steel_tank();
    thin.tank.courses[0].thickness = 0.012;
    let times = |of: &(f64, Vec<f64>, Vec<f64>), f: f64| {
        let all = |v: &[f64]| v.iter().map(|x| f * x).collect::<Vec<f64>>();
        (f * of.0, all(&of.1), all(&of.2))
    };
    let f = 14.0 / 12.0;
    let scaled = Given {
        hoop: times(&given.hoop, f),
        axial: times(&given.axial, f),
        shear: given.shear.iter().map(|x| f * x).collect(),
        pressure: times(&given.pressure, 1.0),
        bending: (f * f * given.bending.0, given.bending.1.iter().map(|x| f * f * x).collect()),
    };
    let (found_thick, found_thin) =
        (assessed(&corroded, &given.demands(0.0, 0)), assessed(&thin, &scaled.demands(0.0, 0)));
    for id in ["hoop_yield", "equivalent_stress", "buckling_elastic", "buckling_elastic_plastic"] {
        let (a, b) = (found(&found_thick, id), found(&found_thin, id));
        close(a.demand.unwrap_or_default(), b.demand.unwrap_or(1.0), 1e-12);
        close(a.capacity.unwrap_or_default(), b.capacity.unwrap_or(1.0), 1e-12);
    }
}
