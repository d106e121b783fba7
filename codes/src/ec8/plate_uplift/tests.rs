//! Uplift of the bottom plate of the oil tank.
//!
//! Source:    formulas of A.9 with numbers by hand; closed forms of strip and membrane
//! Goal:      length, rotation and stress on the sheet; each limit from both sides; what happens without data and without uplift
//! Tolerance: 1e-6 where the sheet's own w enters, else the digits printed here

use super::super::En2006;
use super::super::example::{check, line, oil_tank, site, steel};
use crate::Procedure;
use crate::samples::close;
use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};
use tank::{Bottom, Support};

/// The oil tank without anchors on a bottom of 10 mm.
///
/// * `ag`: a_gR [g]
fn unanchored(ag: f64) -> Case {
    let mut case = oil_tank();
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom {
        thickness: 0.010,
        sketch: None,
        projection: 0.0,
        corrosion: 0.0,
        width: None,
        subgrade_modulus: None,
        material: steel(),
    });
    case.site.ec8 = Some(Ec8Site {
        ag: ag * 9.81,
        ..site()
    });
    case
}

fn assess(case: &Case) -> Assessment {
    En2006.assess(case, Excitation::Site).unwrap()
}

fn lines(a: &Assessment, symbol: &str) -> Vec<f64> {
    a.steps.iter().filter(|s| s.symbol == symbol).map(|s| s.value).collect()
}

/// p = 900·9.81·12 = 105 948 Pa, M_p = 235e6·1e-4/4 = 5875 N, D = 210e9·1e-6/10.92 = 19 230.8 N·m. With both hinges L = 3.41421·√(5875/105 948)
/// = 0.80399 m, from w = 3.719·5875²/(105 948·19 230.8) = 63.0 mm on; between M_p²/(2 p D) = 8.5 mm and this L follows from w. The
/// membrane N³ = E s_b p² L²/(6 (1 − ν²)).
#[test]
fn lines_of_the_oil_tank() {
    let a = assess(&unanchored(0.08));
    let w = check_uplift(&a);
    let (p, m, d) = (105_948.0_f64, 5875.0_f64, 19_230.77);
    close(line(&a, "D_b") / d, 1.0, 1e-6);
    close(line(&a, "M_p") / m, 1.0, 1e-12);
    assert!(w > 0.0085 && w < 0.063, "{w}");
    let length = line(&a, "L");
    close(
        (p * length.powi(4) / 24.0 - m * length * length / 6.0) / (d * w),
        1.0,
        1e-6,
    );
    let rotation = 2.0 * w / length - w / 30.0;
    close(check(&a, "uplift_rotation").demand.unwrap() / rotation, 1.0, 1e-9);
    close(check(&a, "uplift_rotation").capacity.unwrap(), 0.20, 0.0);
    let membrane = (210e9 * 0.010 * p * p * length * length / (6.0 * 0.91)).cbrt() / 0.010;
    close(check(&a, "uplift_membrane").demand.unwrap() / membrane, 1.0, 1e-9);
    assert!(check(&a, "uplift_rotation").holds() && check(&a, "uplift_membrane").holds());
    // Compression: the larger of the equilibrium curve and of the rim.
    let toe = lines(&a, "n_t").into_iter().fold(line(&a, "N_u"), f64::max);
    close(line(&a, "N_u/N_a") / (toe / line(&a, "N_a")), 1.0, 1e-9);
}

/// The largest uplift of both grounds; it belongs to the soft one.
fn check_uplift(a: &Assessment) -> f64 {
    let found = lines(a, "w");
    assert_eq!(found.len(), 2);
    assert!(found[0] > found[1], "{found:?}");
    found[0]
}

/// Of the mechanism σ_rb³ = (2 + √2)²/(24 (1 − ν²)) E p f_y = 0.53374 E p f_y, whatever its thickness: f_y =
/// (0.53374 E p)^(1/2) = 109.0 MPa is the least strength.
#[test]
fn membrane_stress_of_the_mechanism() {
    for (f_y, holds) in [(108e6, false), (110e6, true)] {
        let mut case = unanchored(0.085);
        let bottom = case.tank.bottom.as_mut().unwrap();
        bottom.material.yield_strength = Some(f_y);
        let a = assess(&case);
        let stress = check(&a, "uplift_membrane");
        let expected = (0.533_74 * 210e9 * 105_948.0 * f_y).cbrt();
        close(stress.demand.unwrap() / expected, 1.0, 1e-5);
        assert_eq!(stress.holds(), holds, "{stress:?}");
        assert_eq!(stress.limit_state, "uplift");
    }
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
    let over = assess(&unanchored(0.25));
    assert!(!check(&over, "overturning").holds());
    assert!(!check(&over, "uplift_equilibrium").holds());
}

#[test]
fn little_motion_lifts_nothing() {
    let a = assess(&unanchored(0.005));
    let rotation = check(&a, "uplift_rotation");
    assert_eq!((rotation.demand, rotation.holds()), (Some(0.0), true));
    assert!(a.steps.iter().all(|s| s.symbol != "L"));
}

/// A known ground replaces both; a plate narrower than L fails.
#[test]
fn ground_and_width_of_the_plate() {
    let mut case = unanchored(0.08);
    let both = assess(&case);
    let bottom = case.tank.bottom.as_mut().unwrap();
    bottom.subgrade_modulus = Some(1e10);
    bottom.width = Some(0.3);
    let stiff = assess(&case);
    assert_eq!(lines(&stiff, "w"), lines(&both, "w")[1..]);
    assert!(!check(&stiff, "uplift_width").holds());
    case.tank.bottom.as_mut().unwrap().width = Some(1.0);
    assert!(check(&assess(&case), "uplift_width").holds());
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
        assert_eq!(
            (gap.status, gap.input.as_deref()),
            (CheckStatus::NotChecked, Some(input))
        );
    };
    gap(&case, "materials.plate.yield_strength");
    case.tank.bottom = None;
    gap(&case, "tank.bottom");
}
