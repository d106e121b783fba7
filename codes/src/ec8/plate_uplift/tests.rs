//! Uplift of the bottom plate of the oil tank.
//!
//! Source:    formulas of A.9 with numbers by hand; `base::Stands`, which an independent program checks; equilibrium of the whole base
//! Goal:      length, rotation and stress on the sheet; each limit from both sides; what happens without data and without uplift
//! Tolerance: 1e-6 where the sheet's own w and L enter, else the digits printed here

use super::super::En2006;
use super::super::example::{check, line, oil_tank, site, steel};
use crate::Procedure;
use crate::samples::{bottom_plate, close};
use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};
use tank::{RimSupport, Support};

/// The oil tank without anchors on a bottom of 10 mm.
///
/// * `ag`: a_gR [g]
fn unanchored(ag: f64) -> Case {
    let mut case = oil_tank();
    case.tank.support = Support::Unanchored;
    // The widths below are those of strips that lift as a plane foot does.
    case.tank.roof.holds = RimSupport::Round;
    case.tank.bottom = Some(bottom_plate(steel()));
    case.site.ec8 = Some(Ec8Site { ag: ag * 9.81, ..site() });
    case
}

fn assess(case: &Case) -> Assessment {
    En2006.assess(case, Excitation::Site).unwrap()
}

fn lines(a: &Assessment, symbol: &str) -> Vec<f64> {
    a.steps.iter().filter(|s| s.symbol == symbol).map(|s| s.value).collect()
}

/// p = 900·9.81·12 = 105 948 Pa; the membrane N³ = E s_b p² L²/(6 (1 − ν²)). On 33, 100, 300 and, as nothing is said of the foundation,
/// 10 000 MN/m³. The strip lifts over less than the mechanism without membrane force, 3.41421·√(5875/105 948) = 0.80 m, and what sinks
/// into soft ground, some (4 D/k)^(1/4) = 0.22 m.
#[test]
fn lines_of_the_oil_tank() {
    let a = assess(&unanchored(0.08));
    let (uplifts, lengths) = (lines(&a, "w"), lines(&a, "L"));
    assert_eq!((uplifts.len(), lengths.len(), lines(&a, "θ").len()), (4, 4, 4));
    assert!(uplifts.windows(2).all(|w| w[0] > w[1]), "{uplifts:?}");
    let mut largest = 0.0_f64;
    for ((w, length), rotation) in uplifts.iter().zip(&lengths).zip(lines(&a, "θ")) {
        assert!(*length > 0.0 && *length < 0.80 + 0.22, "{w} {length}");
        close(rotation / (2.0 * w / length - w / 30.0), 1.0, 1e-6);
        largest = largest.max(rotation);
    }
    close(check(&a, "uplift_rotation").demand.unwrap() / largest, 1.0, 1e-9);
    close(check(&a, "uplift_rotation").capacity.unwrap(), 0.20, 0.0);
    let length = lengths.iter().copied().fold(0.0, f64::max);
    let membrane = (210e9 * 0.010 * 105_948.0_f64.powi(2) * length * length / (6.0 * 0.91)).cbrt() / 0.010;
    close(check(&a, "uplift_membrane").demand.unwrap() / membrane, 1.0, 1e-6);
    assert!(check(&a, "uplift_rotation").holds() && check(&a, "uplift_membrane").holds());
    // The strip itself turns by less than the parabola of the clause.
    for (own, clause) in lines(&a, "θ_p").into_iter().zip(lines(&a, "θ")) {
        assert!(own < clause, "{own} {clause}");
    }
    // Compression: the larger of the equilibrium curve and of the base.
    let toe = lines(&a, "n_t").into_iter().fold(line(&a, "N_u"), f64::max);
    close(line(&a, "N_u/N_a") / (toe / line(&a, "N_a")), 1.0, 1e-9);
}

/// σ_rb³ = E p² L²/(6 (1 − ν²) s_b²) from the sheet's largest L, just below and just above the strength of the plate.
#[test]
fn membrane_stress_from_both_sides() {
    let mut seen = [false; 2];
    for f_y in [90e6, 100e6, 108e6, 120e6, 130e6] {
        let mut case = unanchored(0.085);
        let bottom = case.tank.bottom.as_mut().unwrap();
        bottom.material.yield_strength = Some(f_y);
        let a = assess(&case);
        let length = lines(&a, "L").into_iter().fold(0.0, f64::max);
        let expected = (210e9 * (105_948.0 * length / 0.010).powi(2) / (6.0 * 0.91)).cbrt();
        let stress = check(&a, "uplift_membrane");
        close(stress.demand.unwrap() / expected, 1.0, 1e-6);
        assert_eq!(stress.holds(), expected <= f_y, "{stress:?}");
        assert_eq!(stress.limit_state, "uplift");
        seen[usize::from(stress.holds())] = true;
    }
    assert_eq!(seen, [true; 2]);
}

/// The rotation grows with the action and passes 0.20 rad before the tank overturns; then nothing holds.
#[test]
fn rotation_and_equilibrium_fail() {
    let rotation = |ag: f64| check(&assess(&unanchored(ag)), "uplift_rotation").demand.unwrap();
    let demands: Vec<f64> = [0.05, 0.07, 0.09].map(rotation).to_vec();
    assert!(demands.windows(2).all(|d| d[1] > d[0]), "{demands:?}");
    let failing = assess(&unanchored(0.115));
    assert!(check(&failing, "overturning").holds(), "{:?}", failing.checks);
    assert!(!check(&failing, "uplift_rotation").holds());
    assert!(!check(&assess(&unanchored(0.25)), "overturning").holds());
    let over = assess(&unanchored(1.5));
    let equilibrium = check(&over, "uplift_equilibrium");
    assert!(!equilibrium.holds() && equilibrium.capacity.unwrap() > 0.0, "{equilibrium:?}");
}

#[test]
fn little_motion_lifts_nothing() {
    let a = assess(&unanchored(0.005));
    let rotation = check(&a, "uplift_rotation");
    assert_eq!((rotation.demand, rotation.holds()), (Some(0.0), true));
    assert!(a.steps.iter().all(|s| s.symbol != "L"));
}

/// A known ground leaves out that of an unknown foundation and decides alone, though softer ground turns more; a plate narrower than L fails.
#[test]
fn ground_and_width_of_the_plate() {
    let mut case = unanchored(0.08);
    let unknown = assess(&case);
    let bottom = case.tank.bottom.as_mut().unwrap();
    bottom.subgrade_modulus = Some(1e8);
    bottom.width = Some(0.3);
    let known = assess(&case);
    for (a, b) in lines(&known, "w").iter().zip(&lines(&unknown, "w")[..3]) {
        close(a / b, 1.0, 1e-8);
    }
    let rotations = lines(&known, "θ");
    assert_eq!(rotations.len(), 3);
    close(check(&known, "uplift_rotation").demand.unwrap() / rotations[1], 1.0, 1e-9);
    close(check(&unknown, "uplift_rotation").demand.unwrap() / rotations[0], 1.0, 1e-8);
    let note = |a: &Assessment| check(a, "uplift_rotation").note.clone();
    assert!(note(&known).contains("the ground that is given"), "{}", note(&known));
    assert!(note(&unknown).contains("gives no stiffness"), "{}", note(&unknown));
    assert!(line_max(&unknown) > line_max(&known));
    assert!(!check(&known, "uplift_width").holds());
    case.tank.bottom.as_mut().unwrap().width = Some(1.5);
    assert!(check(&assess(&case), "uplift_width").holds());
}

/// The velocity of shear waves is a given stiffness; a kind of foundation alone is not.
#[test]
fn a_foundation_without_stiffness_is_assumed() {
    let foundation = |velocity| tank::Foundation {
        width: None,
        kind: tank::FoundationKind::Soil,
        stiffness: None,
        shear_wave_velocity: velocity,
        soil_density: 1900.0,
        soil_poisson_ratio: 0.33,
        thickness: None,
        friction: None,
    };
    let mut case = unanchored(0.08);
    case.tank.foundation = Some(foundation(None));
    let assumed = assess(&case);
    let rotations = lines(&assumed, "θ");
    assert_eq!(rotations.len(), 3);
    close(check(&assumed, "uplift_rotation").demand.unwrap() / rotations[0], 1.0, 1e-9);
    case.tank.foundation = Some(foundation(Some(250.0)));
    let waves = assess(&case);
    close(check(&waves, "uplift_rotation").demand.unwrap() / lines(&waves, "θ")[1], 1.0, 1e-9);
}

fn line_max(a: &Assessment) -> f64 {
    lines(a, "n_t").into_iter().fold(0.0, f64::max)
}

#[test]
fn data_are_asked_for() {
    let mut case = unanchored(0.08);
    let bottom = case.tank.bottom.as_mut().unwrap();
    bottom.material.yield_strength = None;
    bottom.material.name = "plate".into();
    let gap = |case: &Case, input: &str| {
        let a = assess(case);
        let gap = check(&a, "uplift");
        assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some(input)));
    };
    gap(&case, "materials.plate.yield_strength");
    case.tank.bottom = None;
    gap(&case, "tank.bottom");
}
