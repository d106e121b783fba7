//! Calculation sheets: what stands elsewhere.

/// Units within formulas, of a report in other units than SI.
pub const SUBSTITUTED: &str = "Numbers substituted into formulas are in SI, in which the constants of the formulas hold; the values beside them are in the \
     units of this report.";

/// What a checker does with clauses.
pub const CLAUSES: &str = "Clauses are those of the edition named; some are cited from secondary sources. Compare a clause that decides with the standard.";

/// Lines of an engine that does not decide; empty without any.
pub fn left(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => "Does not decide: its one line is in the full report.".into(),
        count => format!("Does not decide: its {count} lines are in the full report."),
    }
}

/// Assumptions that an earlier sheet has, up to the link to it.
pub fn as_before(count: usize) -> String {
    format!("{count} further assumptions are those of")
}
