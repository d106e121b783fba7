//! Number and spacing of anchors.
//!
//! EN 1998-4 gives neither. Good practice is that of API 650: at least four, six where the earthquake pulls at them, and one every 3 m
//! (10 ft) along the wall. A single anchor carries no moment, whatever its capacity.

use super::limit_states::{ANCHOR_COUNT, ANCHOR_SPACING, ANCHORS, COUNT, SPACING};
use super::work::Work;
use crate::api650::edition2020::anchors::{LARGEST_SPACING, LEAST};
use tank::Support;
use tank::assessment::{Check, CheckStatus};
use tank::units::Dimension::{Dimensionless, Length};

/// Writes both checks of an anchored tank; needs the end of the check of tension.
pub(super) fn assess(work: &mut Work) {
    if work.case.tank.support != Support::Anchored {
        return;
    }
    let mut tension = work.out.checks.iter().filter(|check| check.limit_state == ANCHORS.id);
    let pulls = tension.any(|check| check.status != CheckStatus::NotApplicable && check.demand != Some(0.0));
    let given = work.case.tank.anchors.filter(|anchors| anchors.count > 0);
    let Some(anchors) = given else {
        let (status, reason, input) = match pulls {
            true => (
                CheckStatus::NotChecked,
                "`tank.anchors` is missing",
                Some("tank.anchors"),
            ),
            false => (CheckStatus::NotApplicable, "the tank stands without anchors", None),
        };
        for id in [ANCHOR_COUNT.id, ANCHOR_SPACING.id] {
            work.without_comparison(id, status, reason, input);
        }
        return;
    };
    let perimeter = work.case.tank.perimeter();
    let count = f64::from(anchors.count);
    let sheet = &mut work.sheet;
    sheet.section("Number and spacing of the anchors");
    sheet.input("n_A", "number of anchors", count, Dimensionless, "tank.anchors.count");
    let (least, note) = match pulls {
        true => (
            LEAST[1],
            "good practice, not a clause of EN 1998-4: six where the earthquake pulls at them",
        ),
        false => (
            LEAST[0],
            "good practice, not a clause of EN 1998-4; the earthquake does not pull at them",
        ),
    };
    let (name, source) = ("least number of anchors", "4, and 6 where the earthquake governs");
    let least = sheet.look_up("n_min", name, source, least, Dimensionless, COUNT);
    let terms = [("U", perimeter, Length), ("n_A", count, Dimensionless)];
    let name = "spacing of the anchors along the wall";
    let spacing = sheet.calc("a_A", name, "U/n_A", &terms, Length, SPACING);
    let (name, source) = ("largest spacing", "the larger of its values in metres and in feet");
    let largest = sheet.look_up("a_max", name, source, LARGEST_SPACING, Length, SPACING);
    let name = "Least number of anchors over that given";
    let number = Check::new(ANCHOR_COUNT.id, name, least, count, Dimensionless, COUNT, note);
    let name = "Spacing of the anchors";
    let note = "good practice, not a clause of EN 1998-4";
    let apart = Check::new(ANCHOR_SPACING.id, name, spacing, largest, Length, SPACING, note);
    work.out.checks.extend([number, apart]);
}
