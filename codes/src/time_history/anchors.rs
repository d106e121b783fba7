//! A run that decides alone checks number and spacing of the anchors: they do not depend on the motion.

use tank::Support;
use tank::assessment::CheckStatus;

use super::limit_states::ANCHORS;
use super::work::Work;
use crate::ec8::anchor_layout::{self, Words};
use crate::limit_state::common::{ANCHOR_COUNT, ANCHOR_SPACING};

/// Adds both checks; needs that of the tension.
pub(super) fn layout(work: &mut Work<'_>) {
    let tank = &work.case.tank;
    if tank.support != Support::Anchored {
        return;
    }
    let mut tension = work.checks.iter().filter(|check| check.limit_state == ANCHORS.id);
    // A run that does not give the tension may pull.
    let pulls = tension.all(|check| check.status != CheckStatus::NotApplicable);
    let always = work.codes.iter().any(|code| code.always_anchors());
    let Some(anchors) = tank.anchors.filter(|anchors| anchors.count > 0) else {
        let (status, reason, input) = match pulls || always {
            true => (CheckStatus::NotChecked, "`tank.anchors` is missing", Some("tank.anchors")),
            false => (CheckStatus::NotApplicable, "the tank stands without anchors", None),
        };
        for id in [ANCHOR_COUNT.id, ANCHOR_SPACING.id] {
            work.without(id, status, reason, input);
        }
        return;
    };
    let [count, spacing] = [ANCHOR_COUNT.id, ANCHOR_SPACING.id].map(|id| work.clause(id));
    let words = Words { clauses: [&count, &spacing], good_practice: !always };
    let checks = anchor_layout::layout(&mut work.sheet, tank, &anchors, pulls, &words);
    work.checks.extend(checks);
}
