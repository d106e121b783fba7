//! `accepted`: gaps of the deciding codes that the user accepts.

use ::tank::check;
use files::code::Code;

use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::{Resolver, range_fault};

object! {
    /// A limit state that is not checked and accepted all the same. It is printed with its reason.
    Accepted {
        /// Id of the limit state, as `check` prints it; of one code only with its id, such as "ec8-2006/sliding".
        check ("sliding"): Field<String>,
        /// Why the gap is acceptable, who says so.
        reason ("keyed foundation, sheet 12 of the statics, J. Doe 2026"): Field<String>,
    }
}

/// Accepted gaps, each once and with a reason.
pub(super) fn accepted(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Accepted>>>) -> Vec<check::Accepted> {
    let mut all: Vec<check::Accepted> = Vec::new();
    for given in option.value().into_iter().flatten().filter_map(|g| g.value.as_ref()) {
        let (Some(check), Some(reason)) = (r.text(&given.check), r.text(&given.reason)) else {
            continue;
        };
        if all.iter().any(|a| a.check == check) {
            r.faults.push(range_fault(
                Code::Repeated,
                &given.check,
                "duplicate limit state",
                "each limit state once",
            ));
        }
        if reason.trim().is_empty() {
            r.faults.push(range_fault(
                Code::Incomplete,
                &given.reason,
                "the reason is empty",
                "a sentence",
            ));
        }
        all.push(check::Accepted { check, reason });
    }
    all
}
