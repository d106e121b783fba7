//! A box shaken along its breadth: the same checks with length and breadth exchanged.
//!
//! EN 1998-1 4.3.3.5.1 has both horizontal directions verified; (8) lets them act apart on structures that are regular in plan and
//! whose walls in both directions are the only primary seismic elements. Written for buildings, and taken for boxes here (recalled).

use super::limit_states::{self, OTHER_DIRECTION};
use super::work::Work;
use crate::sheet::without_lines;
use tank::Shape;
use tank::assessment::{Check, CheckStatus, Excitation};
use tank::check::complete;

const CLAUSE: &str = "EN 1998-1:2004 4.3.3.5.1";

/// Writes the check of a box that is not square. Needs the other checks.
pub(super) fn assess(work: &mut Work, excitation: Excitation) {
    let Shape::Rectangle { length, breadth, strip: false } = work.case.tank.shape else { return };
    if excitation != Excitation::Site || length == breadth {
        return;
    }
    let mut turned = work.case.clone();
    turned.tank.shape = Shape::Rectangle { length: breadth, breadth: length, strip: false };
    let found = without_lines(|| super::assess_one(&turned, excitation, work.edition));
    let checks = match found {
        Ok(out) => complete(&limit_states::all(&turned, work.edition), out.checks),
        Err(error) => {
            let reason = format!("not computed along the breadth: {error}");
            return work.without_comparison(OTHER_DIRECTION.id, CheckStatus::NotChecked, &reason, None);
        }
    };
    // What is open along the length as well has its own line.
    let own = complete(&limit_states::all(work.case, work.edition), work.out.checks.clone());
    let known = |check: &Check| {
        let open = |other: &Check| other.limit_state == check.limit_state && other.status == CheckStatus::NotChecked;
        check.limit_state == OTHER_DIRECTION.id || own.iter().any(open)
    };
    let worst = checks.iter().filter(|check| check.compared()).max_by(|a, b| {
        let of = |check: &Check| check.ratio().unwrap_or(0.0);
        of(a).total_cmp(&of(b))
    });
    let open = checks.iter().find(|check| check.status == CheckStatus::NotChecked && !known(check));
    let fails = worst.filter(|check| check.status == CheckStatus::Fails);
    match (fails, open, worst) {
        (None, Some(check), _) => {
            let reason = format!("along the breadth `{}` is not checked: {}", check.id, check.reason);
            work.without_comparison(OTHER_DIRECTION.id, CheckStatus::NotChecked, &reason, None);
        }
        (None, None, None) => {}
        (Some(check), ..) | (None, None, Some(check)) => {
            let (demand, capacity) = check.utilisation.map_or((1.0, 0.0), |ratio| (ratio, 1.0));
            let name = "Largest utilisation along the breadth";
            let note = format!("`{}` with length and breadth exchanged", check.id);
            work.check(OTHER_DIRECTION.named(name), demand, capacity, CLAUSE, &note);
        }
    }
}
