//! The verdict: what the checks of the deciding methods amount to.
//!
//! | status | meaning |
//! |---|---|
//! | `holds` | every limit state that the deciding codes require was checked and holds, or is an accepted gap, which is listed |
//! | `fails` | at least one fails |
//! | `incomplete` | none fails, at least one was not checked, a deciding method checked nothing, or a run did not reach its end |
//! | `not_assessed` | no deciding method gave a check |

use serde::{Deserialize, Serialize};
use tank::assessment::{Check, CheckStatus, Excitation};
use tank::check::TankPart;
use tank::listed;

use crate::Method;
use crate::compare::Incomplete;

listed! {
    /// What the checks of the deciding methods amount to.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum VerdictStatus {
        /// As in `results.json`.
        id: &'static str,
    }
    /// Everything required was checked and holds.
    Holds: "holds";
    /// A limit state fails.
    Fails: "fails";
    /// Nothing fails, and something required was not checked.
    Incomplete: "incomplete";
    /// Nothing was checked.
    #[default]
    NotAssessed: "not_assessed";
}

/// A method under an excitation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Deciding {
    /// Id of the method.
    pub method: String,
    /// What shakes the tank.
    pub excitation: Excitation,
}

impl Deciding {
    fn is(&self, method: &Method) -> bool {
        self.method == method.id && self.excitation == method.excitation
    }
}

/// Number of checks by status.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Checked, hold.
    pub holds: usize,
    /// Checked, fail.
    pub fails: usize,
    /// Required, not checked.
    pub not_checked: usize,
    /// Not required of this tank.
    pub not_applicable: usize,
    /// Not checked, accepted with a reason.
    pub accepted: usize,
    /// Those that hold, but would not with their demand raised by its estimated discretisation error.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub within_error: usize,
}

#[allow(clippy::trivially_copy_pass_by_ref)] // As serde asks for it.
fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Counts {
    fn add(&mut self, status: CheckStatus) {
        *match status {
            CheckStatus::Holds => &mut self.holds,
            CheckStatus::Fails => &mut self.fails,
            CheckStatus::NotChecked => &mut self.not_checked,
            CheckStatus::NotApplicable => &mut self.not_applicable,
            CheckStatus::Accepted => &mut self.accepted,
        } += 1;
    }

    /// Comparisons of a demand with a capacity.
    pub fn compared(&self) -> usize {
        self.holds + self.fails
    }

    fn status(&self) -> VerdictStatus {
        match self {
            counts if counts.fails > 0 => VerdictStatus::Fails,
            counts if counts.compared() == 0 => VerdictStatus::NotAssessed,
            counts if counts.not_checked > 0 => VerdictStatus::Incomplete,
            _ => VerdictStatus::Holds,
        }
    }
}

/// A check and the method that made it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Governing {
    /// Method id.
    pub method: String,
    /// Excitation.
    pub excitation: Excitation,
    /// The check.
    pub check: Check,
}

/// Checks of methods that do not decide.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Aside {
    /// Their number by status.
    pub counts: Counts,
    /// The comparison with the largest utilisation.
    pub governing: Option<Governing>,
}

/// A code that the site names, of which a check fails, and which does not decide because the user names others.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Overruled {
    /// Method id.
    pub method: String,
    /// Its checks under the design spectrum.
    pub checks: Aside,
}

/// The verdict of the verification.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// What the checks of the deciding methods amount to.
    #[serde(default)]
    pub status: VerdictStatus,
    /// Their required limit states that were not checked and are accepted: who, when and why.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub accepted: Vec<Governing>,
    /// Methods that decide.
    #[serde(default)]
    pub deciding: Vec<Deciding>,
    /// Those among them that have no check: they did not run, or check nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub silent: Vec<Deciding>,
    /// Number of their checks by status.
    #[serde(default)]
    pub counts: Counts,
    /// Their comparison with the largest utilisation.
    pub governing: Option<Governing>,
    /// Their required limit states that were not checked.
    #[serde(default)]
    pub missing: Vec<Governing>,
    /// Parts of the tank of which its file says nothing: they count as none, and what needs them is open.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unstated: Vec<TankPart>,
    /// What assessments under the record amount to, where they do not decide.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub record: Option<Aside>,
    /// Codes that the site names and of which a check fails, where `procedures.decide` names others.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub overruled: Vec<Overruled>,
    /// Deciding methods whose values rest on clauses that are recalled and not compared with a source.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub recalled: Vec<String>,
    /// True if a finite-element run did not reach the end of the ground motion (interrupted, collapsed): its extremes are
    /// those of a part of it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unfinished: bool,
    /// Why it is unfinished; none where the user stopped a linear run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cause: Option<Incomplete>,
}

impl Verdict {
    /// Whether everything required was checked and holds, without an accepted gap.
    pub fn complete(&self) -> bool {
        self.status == VerdictStatus::Holds && !self.unfinished && self.counts.accepted == 0
    }

    /// Whether a method decides.
    pub fn decides(&self, method: &Method) -> bool {
        self.deciding.iter().any(|d| d.is(method))
    }
}

impl Aside {
    /// The checks of one method.
    pub fn of(method: &Method) -> Aside {
        let (counts, governing) = count(std::iter::once(method));
        Aside { counts, governing }
    }
}

/// The verdict on the checks of the methods that decide.
///
/// * `unfinished`: whether a run did not reach its end; no verdict then says `holds`
pub fn verdict(methods: &[Method], deciding: Vec<Deciding>, unfinished: bool, cause: Option<Incomplete>) -> Verdict {
    let decides = |method: &Method| deciding.iter().any(|d| d.is(method));
    let (counts, governing) = count(methods.iter().filter(|m| decides(m)));
    let speaks = |d: &Deciding| methods.iter().any(|m| d.is(m) && !m.checks.is_empty());
    let silent: Vec<Deciding> = deciding.iter().filter(|d| !speaks(d)).cloned().collect();
    let aside = |method: &&Method| !decides(method) && method.excitation == Excitation::Record;
    let (of_record, worst) = count(methods.iter().filter(aside));
    let of_status = |status: CheckStatus| -> Vec<Governing> {
        let deciding = methods.iter().filter(|m| decides(m));
        let all = deciding.flat_map(|m| m.checks.iter().map(move |check| (m, check)));
        let found = all.filter(|(_, check)| check.status == status);
        found.map(|(method, check)| named(method, check)).collect()
    };
    Verdict {
        status: match counts.status() {
            VerdictStatus::Holds if unfinished || !silent.is_empty() => VerdictStatus::Incomplete,
            status => status,
        },
        silent,
        counts,
        governing,
        missing: of_status(CheckStatus::NotChecked),
        accepted: of_status(CheckStatus::Accepted),
        record: (of_record.compared() > 0).then_some(Aside { counts: of_record, governing: worst }),
        unstated: Vec::new(),
        overruled: Vec::new(),
        recalled: methods.iter().filter(|m| decides(m) && !m.recalled.is_empty()).map(|m| m.id.clone()).collect(),
        deciding,
        unfinished,
        cause,
    }
}

fn named(method: &Method, check: &Check) -> Governing {
    Governing { method: method.id.clone(), excitation: method.excitation, check: check.clone() }
}

/// Number of checks by status, and the one with the largest utilisation.
fn count<'a>(methods: impl Iterator<Item = &'a Method>) -> (Counts, Option<Governing>) {
    let mut counts = Counts::default();
    let mut governing: Option<(f64, Governing)> = None;
    for method in methods {
        for check in &method.checks {
            counts.add(check.status);
            counts.within_error += usize::from(check.within_error);
            if let Some(ratio) = check.ratio()
                && governing.as_ref().is_none_or(|(largest, _)| ratio > *largest)
            {
                governing = Some((ratio, named(method, check)));
            }
        }
    }
    (counts, governing.map(|(_, g)| g))
}

#[cfg(test)]
mod tests {
    use tank::assessment::{LimitState, Requirement};
    use tank::units::Dimension;

    use super::*;

    /// A deciding method that rests on recalled clauses is named; one beside it that does not, or does not decide, is not.
    #[test]
    fn recalled_clauses_are_told() {
        let method = |id: &str, recalled: &[&str]| Method {
            checks: vec![check("freeboard", 0.5)],
            recalled: recalled.iter().map(|clause| (*clause).to_owned()).collect(),
            ..Method::new(id, id, Excitation::Site)
        };
        let methods = [method("a", &["table 2"]), method("b", &[]), method("c", &["table 1"])];
        let deciding = ["a", "b"].map(|id| Deciding { method: id.into(), excitation: Excitation::Site });
        let found = verdict(&methods, deciding.to_vec(), false, None);
        assert_eq!((found.recalled, found.status), (vec!["a".to_owned()], VerdictStatus::Holds));
    }

    fn check(id: &str, utilisation: f64) -> Check {
        Check::new(id, id, utilisation, 1.0, Dimension::Force, "", "")
    }

    fn missing(status: CheckStatus) -> Check {
        let state =
            LimitState { id: "sliding", name: "Sliding", clause: String::new(), requirement: Requirement::Required };
        Check::without_comparison(&state, status, "no friction", None)
    }

    fn method(id: &str, excitation: Excitation, checks: Vec<Check>) -> Method {
        Method { checks, ..Method::new(id, id, excitation) }
    }

    fn decides(id: &str) -> Vec<Deciding> {
        vec![Deciding { method: id.into(), excitation: Excitation::Site }]
    }

    fn status(checks: Vec<Check>, unfinished: bool) -> VerdictStatus {
        let methods = [method("code", Excitation::Site, checks)];
        verdict(&methods, decides("code"), unfinished, None).status
    }

    #[test]
    fn a_tick_means_that_everything_required_was_checked() {
        let fine = || check("hoop", 0.5);
        assert_eq!(status(vec![fine()], false), VerdictStatus::Holds);
        assert_eq!(status(vec![fine(), check("axial", 1.1)], false), VerdictStatus::Fails);
        let gap = missing(CheckStatus::NotChecked);
        assert_eq!(status(vec![fine(), gap.clone()], false), VerdictStatus::Incomplete);
        assert_eq!(status(vec![check("axial", 1.1), gap.clone()], false), VerdictStatus::Fails);
        assert_eq!(status(vec![gap], false), VerdictStatus::NotAssessed);
        assert_eq!(status(vec![], false), VerdictStatus::NotAssessed);
        for harmless in [CheckStatus::Accepted, CheckStatus::NotApplicable] {
            assert_eq!(status(vec![fine(), missing(harmless)], false), VerdictStatus::Holds);
            assert_eq!(status(vec![missing(harmless)], false), VerdictStatus::NotAssessed);
        }
        assert_eq!(status(vec![fine()], true), VerdictStatus::Incomplete);
        assert_eq!(status(vec![check("axial", 1.1)], true), VerdictStatus::Fails);
    }

    /// The summary is green without a word only where everything required holds, nothing is accepted and every run reached its end.
    #[test]
    fn a_verdict_is_complete_without_accepted_gaps() {
        let complete = |checks: Vec<Check>, unfinished: bool| {
            let methods = [method("code", Excitation::Site, checks)];
            verdict(&methods, decides("code"), unfinished, None).complete()
        };
        let fine = || check("hoop", 0.5);
        assert!(complete(vec![fine(), missing(CheckStatus::NotApplicable)], false));
        assert!(!complete(vec![fine(), missing(CheckStatus::Accepted)], false));
        assert!(!complete(vec![fine(), missing(CheckStatus::NotChecked)], false));
        assert!(!complete(vec![fine(), check("axial", 1.1)], false));
        assert!(!complete(vec![fine()], true));
        // A table read from a file may say "holds" of a run that stopped.
        let methods = [method("code", Excitation::Site, vec![fine()])];
        let held = verdict(&methods, decides("code"), false, None);
        assert!(!Verdict { unfinished: true, ..held.clone() }.complete());
        assert!(held.decides(&methods[0]) && !held.decides(&method("code", Excitation::Record, vec![])));
        assert_eq!(held.record, None);
    }

    /// A tick needs a check of every method that decides, also of an engine that did not run.
    #[test]
    fn a_deciding_method_without_checks_leaves_the_verdict_open() {
        let checked = method("code", Excitation::Site, vec![check("hoop", 0.5)]);
        let engine = Deciding { method: "fe".into(), excitation: Excitation::Record };
        let deciding = [decides("code"), vec![engine.clone()]].concat();
        for methods in [vec![checked.clone()], vec![checked, method("fe", Excitation::Record, vec![])]] {
            let found = verdict(&methods, deciding.clone(), false, None);
            assert_eq!(found.status, VerdictStatus::Incomplete);
            assert_eq!(found.silent, std::slice::from_ref(&engine));
        }
    }

    /// What does not decide changes no status; under the record it is counted aside.
    #[test]
    fn others_stand_aside() {
        let methods = [
            method("code", Excitation::Site, vec![check("hoop", 0.5), check("axial", 0.8)]),
            method("code", Excitation::Record, vec![check("hoop", 1.5), check("axial", 0.7)]),
            method("old", Excitation::Site, vec![check("hoop", 9.0)]),
        ];
        let found = verdict(&methods, decides("code"), false, None);
        assert_eq!((found.status, found.counts.holds), (VerdictStatus::Holds, 2));
        assert_eq!(found.governing.map(|g| g.check.id), Some("axial".into()));
        let aside = found.record.expect("checks under the record");
        assert_eq!((aside.counts.holds, aside.counts.fails), (1, 1));
        assert_eq!(aside.governing.map(|g| g.check.id), Some("hoop".into()));
    }

    #[test]
    fn what_was_not_checked_is_listed() {
        let methods = [method("code", Excitation::Site, vec![check("hoop", 0.5), missing(CheckStatus::NotChecked)])];
        let found = verdict(&methods, decides("code"), false, None);
        assert_eq!(found.missing.len(), 1);
        assert_eq!(found.missing[0].check.reason, "no friction");
    }

    /// A close call holds and is counted.
    #[test]
    fn checks_within_their_error_are_counted() {
        let close = check("hoop", 0.99).with_error(Some(0.02));
        let methods = [method("code", Excitation::Site, vec![close, check("axial", 0.5)])];
        let found = verdict(&methods, decides("code"), false, None);
        assert_eq!((found.status, found.counts.within_error), (VerdictStatus::Holds, 1));
        let text = serde_json::to_value(found.counts).unwrap();
        assert_eq!(text["within_error"], 1);
        let text = serde_json::to_value(Counts::default()).unwrap();
        assert_eq!(text.get("within_error"), None);
    }

    /// A capacity of zero has no utilisation and governs; of equal ones the first does.
    #[test]
    fn without_a_capacity_a_check_governs() {
        let methods = [method("code", Excitation::Site, vec![check("hoop", 0.5), check("axial", 0.5)])];
        let found = verdict(&methods, decides("code"), false, None);
        assert_eq!(found.governing.map(|g| g.check.id), Some("hoop".into()));
        let nothing = Check::new("anchors", "anchors", 1.0, 0.0, Dimension::Force, "", "");
        let methods = [method("code", Excitation::Site, vec![check("hoop", 50.0), nothing])];
        let found = verdict(&methods, decides("code"), false, None);
        assert_eq!(found.governing.map(|g| g.check.id), Some("anchors".into()));
    }
}
