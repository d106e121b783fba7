//! Overturning of a strip 5 m long.
//!
//! Source:    17 000 kg·9.81 m/s²·2.5 m = 416.925 kNm per metre
//! Goal:      the limit from both sides, vertical motion, an anchored box
//! Tolerance: 1e-6

use super::super::En2006;
use super::super::example::{check, line, site};
use crate::Procedure;
use crate::samples::{close, concrete_rectangle};
use tank::Support;
use tank::assessment::{Assessment, Excitation};

fn strip(ag: f64, vertical: bool) -> Assessment {
    let mut case = concrete_rectangle(1.0, true, site());
    case.tank.support = Support::Unanchored;
    let site = case.site.ec8.as_mut().unwrap();
    (site.ag, site.vertical) = (ag * 9.81, vertical);
    En2006.assess(&case, Excitation::Site).unwrap()
}

#[test]
fn both_sides_of_the_limit() {
    // M′ is linear in a_g.
    let per_g = line(&strip(1.0, false), "M′");
    for (u, holds) in [(0.999, true), (1.001, false)] {
        let a = strip(u * 416_925.0 / per_g, false);
        let overturning = check(&a, "overturning");
        close(overturning.capacity.unwrap() / 416_925.0, 1.0, 1e-6);
        close(overturning.utilisation.unwrap() / u, 1.0, 1e-6);
        assert_eq!(overturning.holds(), holds);
    }
}

/// a_vg = 0.9·1.2·0.25 g = 0.27 g: 416.925·(1 − 0.081) = 383.154 kNm.
#[test]
fn vertical_motion_lightens_the_box() {
    let a = strip(0.25, true);
    close(check(&a, "overturning").capacity.unwrap() / 383_154.1, 1.0, 1e-6);
}

#[test]
fn an_anchored_box_does_not_overturn() {
    let a = En2006
        .assess(&concrete_rectangle(1.0, true, site()), Excitation::Site)
        .unwrap();
    assert!(a.checks.iter().all(|c| c.limit_state != "overturning"));
}
