//! The limit state of the records under which an engine decides: whether they stand for the spectrum of the site.
//!
//! | records | ending |
//! |---|---|
//! | need a factor above 1 for the rule of the code, one or many | fails, cannot be accepted |
//! | hold for it, and are too few | open |
//! | hold for it, and are enough | holds |
//! | stand for no site, or for one that names no code | open |
//!
//! The target is always the spectrum of the site; a set that is also compared with a table is asked again. Around a period that the
//! spectrum of the site does not cover the rule cannot be asked: what is weak elsewhere fails all the same, and nothing holds.

use codes::record_set::Horizontal;
use codes::time_history;
use tank::Quantity;
use tank::assessment::{Check, CheckStatus};
use tank::units::{Dimension, display};

use super::design::Records;
use crate::job::Job;
use crate::study::rule::{self, Question, Wanted};
use engines::Simulation;

/// Asks the rule; none where the site names no code.
///
/// * `wanted`: periods of the tank
/// * `records`: as applied
pub fn ask(job: &Job, wanted: &[Wanted], records: &[Horizontal<'_>]) -> Option<Records> {
    let (_, code) = time_history::ground_motion(&job.case)?;
    let asked = |wanted: &[Wanted]| {
        let question = Question { code, table: None, target: "site", site: &job.case.site, wanted };

        rule::answer(&question, records)
    };
    let of = |factor: f64, unasked: Option<String>| Records { count: records.len(), factor, unasked };
    if wanted.is_empty() {
        let none = "no procedure and no engine gives a period of this tank".to_owned();
        return Some(of(asked(&[]).map_or(0.0, |answer| answer.factor), Some(none)));
    }
    Some(match asked(wanted) {
        Ok(answer) => of(answer.factor, None),
        Err(error) => {
            let covered: Vec<Wanted> = wanted.iter().copied().filter(|w| asked(&[*w]).is_ok()).collect();
            let factor = asked(&covered).map_or(0.0, |answer| answer.factor);
            of(factor, Some(rule::reason(&error)))
        }
    })
}

/// The same of the one record of a run.
pub(super) fn of_one(job: &Job, simulation: &Simulation) -> Option<Records> {
    let motion = job.case.ground_motion.as_ref()?;
    let own = |quantity: Quantity| Some((*simulation.values.get(&quantity)?, "finite elements"));
    let of_engine = || {
        let periods = [own(Quantity::ImpulsivePeriod), own(Quantity::SloshingPeriod)];
        rule::both(&job.case, periods)
    };
    let wanted = rule::periods(&job.case, &job.decision).unwrap_or_else(|_| of_engine());
    let record = Horizontal { along: &motion.horizontal, across: motion.transverse.as_ref() };
    ask(job, &wanted, &[record])
}

/// Whether an engine decides.
///
/// * `id`: its column
pub(super) fn asked(job: &Job, id: &str) -> bool {
    job.decision.decide.iter().any(|decides| decides == id)
}

/// How the limit state ends.
pub(super) fn check(job: &Job, records: &Records) -> Option<Check> {
    let (state, code) = time_history::ground_motion(&job.case)?;
    let open = |reason: &str| Check::without_comparison(&state, CheckStatus::NotChecked, reason, None);
    // The digits that a product loses.
    let weak = records.factor > 1.0 + 1e-9;
    if !weak {
        if let Some(reason) = &records.unasked {
            return Some(open(reason));
        }
        let fewest = code.fewest();
        match records.count {
            1 => {
                let reason =
                    format!("one record is not enough: the clause asks for at least {fewest} (`compare --set`)");
                return Some(open(&reason));
            }
            count if count < fewest => {
                return Some(open(&format!("{count} records: the clause asks for at least {fewest}")));
            }
            _ => {}
        }
    }
    let factor = display(records.factor, Dimension::Dimensionless);
    let note = match (weak, records.count) {
        (false, _) => "factor with which the set just holds for its spectrum".into(),
        (true, 1) => format!("the record is too weak for the spectrum of the site: it would hold times {factor}"),
        (true, _) => format!("the set is too weak for the spectrum of the site: it would hold times {factor}"),
    };
    // A component without motion has no factor.
    let (demand, capacity) = match records.factor.is_finite() {
        true => (if weak { records.factor } else { records.factor.min(1.0) }, 1.0),
        false => (1.0, 0.0),
    };
    Some(Check::new(state.id, state.name, demand, capacity, Dimension::Dimensionless, code.clause(), &note))
}
