//! Displacement of pipes of the oil tank.
//!
//! Source:    d_g = 0.025·0.25·9.81·1.2·1.15·0.6·2 m = 101.5 mm on ground C of type 1 (γ_I = 1.2) by hand; 50 m of 500 m: 10.15 mm
//! Goal:      the limit from both sides, the uplift of an unanchored wall, what is missing
//! Tolerance: 1e-6

use super::super::example::{check, line, oil_tank, steel};
use super::super::{En2006, Env1998};
use crate::Procedure;
use crate::samples::{bottom_plate, close, concrete_rectangle};
use tank::assessment::{CheckStatus, Excitation};
use tank::case::Case;
use tank::{Bottom, Pipes, Support};

fn with(mut case: Case, distance: Option<f64>, allowed: Option<f64>) -> Case {
    case.tank.pipes = Some(Pipes { support_distance: distance, allowable_displacement: allowed, ..Pipes::default() });
    case
}

const D_G: f64 = 0.025 * 1.2 * 0.25 * 9.81 * 1.15 * 0.6 * 2.0;

#[test]
fn ground_alone() {
    for (allowed, holds) in [(0.1 * D_G * 0.999, false), (0.1 * D_G * 1.001, true)] {
        let a = En2006.assess(&with(oil_tank(), Some(50.0), Some(allowed)), Excitation::Site).unwrap();
        let pipes = check(&a, "pipes");
        assert_eq!(pipes.holds(), holds, "{pipes:?}");
        close(pipes.demand.unwrap() / (0.1 * D_G), 1.0, 1e-6);
    }
    // ENV: twice the factor, S = 0.9, T_C = 0.8 s, T_D = 3 s.
    let a = Env1998.assess(&with(oil_tank(), Some(50.0), Some(1.0)), Excitation::Site).unwrap();
    close(line(&a, "d_g") / (0.05 * 1.2 * 0.25 * 9.81 * 0.9 * 0.8 * 3.0), 1.0, 1e-6);
}

#[test]
fn uplift_adds() {
    let mut case = with(oil_tank(), Some(50.0), Some(0.010));
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom { subgrade_modulus: Some(1e8), ..bottom_plate(steel()) });
    case.site.ec8.as_mut().unwrap().ag = 0.08 * 9.81;
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let pipes = check(&a, "pipes");
    // Softest ground first; the second is that of the file, which decides.
    let uplifts: Vec<f64> = a.steps.iter().filter(|s| s.symbol == "w").map(|s| s.value).collect();
    let expected = uplifts[1] + 0.1 * D_G * 0.08 / 0.25;
    close(pipes.demand.unwrap() / expected, 1.0, 1e-6);
    assert!(!pipes.holds());
    // A tank that overturns, or whose plate is not known, has no known uplift.
    case.tank.bottom = None;
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    assert_eq!(check(&a, "pipes").status, CheckStatus::NotChecked);
}

#[test]
fn data_are_asked_for() {
    let rectangle = concrete_rectangle(1.0, true, super::super::example::site());
    for case in [oil_tank(), rectangle] {
        for (case, input) in [
            (case.clone(), "tank.pipes"),
            (with(case.clone(), None, Some(0.1)), "tank.pipes.support_distance"),
            (with(case.clone(), Some(10.0), None), "tank.pipes.allowable_displacement"),
        ] {
            let a = En2006.assess(&case, Excitation::Site).unwrap();
            let gap = check(&a, "pipes");
            assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some(input)));
        }
    }
}
