//! Number and spacing of anchors.
//!
//! EN 1998-4 gives neither. Good practice is that of API 650: at least four, six where the earthquake pulls at them, and one every 3 m
//! (10 ft) along the wall. A single anchor carries no moment, whatever its capacity.

use super::limit_states::{ANCHOR_COUNT, ANCHOR_SPACING, ANCHORS, COUNT, SPACING};
use super::work::Work;
use crate::api650::edition2020::anchors::{LARGEST_SPACING, LEAST};
use crate::sheet::Sheet;
use tank::assessment::{Check, CheckStatus};
use tank::units::Dimension::{Dimensionless, Length};
use tank::{Anchors, Support, Tank};

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
            true => (CheckStatus::NotChecked, "`tank.anchors` is missing", Some("tank.anchors")),
            false => (CheckStatus::NotApplicable, "the tank stands without anchors", None),
        };
        for id in [ANCHOR_COUNT.id, ANCHOR_SPACING.id] {
            work.without_comparison(id, status, reason, input);
        }
        return;
    };
    let words = Words { clauses: [COUNT, SPACING], good_practice: true };
    let checks = layout(&mut work.sheet, &work.case.tank, &anchors, pulls, &words);
    work.out.checks.extend(checks);
}

/// What the lines and checks say of where they come from.
pub(crate) struct Words<'a> {
    /// Clauses of number and spacing.
    pub(crate) clauses: [&'a str; 2],
    /// Whether they are good practice, not clauses.
    pub(crate) good_practice: bool,
}

/// Number and spacing of given anchors against those required.
///
/// * `pulls`: whether the earthquake pulls at them
pub(crate) fn layout(sheet: &mut Sheet, tank: &Tank, anchors: &Anchors, pulls: bool, words: &Words<'_>) -> [Check; 2] {
    let [of_count, of_spacing] = words.clauses;
    let count = f64::from(anchors.count);
    sheet.section("Number and spacing of the anchors");
    sheet.input("n_A", "number of anchors", count, Dimensionless, "tank.anchors.count");
    let (least, note) = match (pulls, words.good_practice) {
        (true, true) => (LEAST[1], "good practice, not a clause of EN 1998-4: six where the earthquake pulls at them"),
        (true, false) => (LEAST[1], "six where the earthquake pulls at them"),
        (false, true) => (LEAST[0], "good practice, not a clause of EN 1998-4; the earthquake does not pull at them"),
        (false, false) => (LEAST[0], "the earthquake does not pull at them"),
    };
    let (name, source) = ("least number of anchors", "4, and 6 where the earthquake governs");
    let least = sheet.look_up("n_min", name, source, least, Dimensionless, of_count);
    sheet.given(&[("U", tank.perimeter(), Length)]);
    let name = "spacing of the anchors along the wall";
    let spacing = sheet.calc("a_A", name, "U/n_A", Length, of_spacing);
    let (name, source) = ("largest spacing", "the larger of its values in metres and in feet");
    let largest = sheet.look_up("a_max", name, source, LARGEST_SPACING, Length, of_spacing);
    let name = "Least number of anchors over that given";
    let number = Check::new(ANCHOR_COUNT.id, name, least, count, Dimensionless, of_count, note);
    let name = "Spacing of the anchors";
    let note = if words.good_practice { "good practice, not a clause of EN 1998-4" } else { "" };
    let apart = Check::new(ANCHOR_SPACING.id, name, spacing, largest, Length, of_spacing, note);
    [number, apart]
}
