//! Calculation sheets: symbol = formula = numbers = value, or symbol from table = value; unit, clause. The sheet of a procedure on the spectrum of the
//! site shows only the lines that differ from its sheet on the record. Below the full level there are only the sheets of the engines and of the
//! procedures that decide (of all procedures where none does), each with all its lines; every symbol
//! has its value there, and formulas are not repeated with their numbers.

use serde::Serialize;
use tank::assessment::Excitation;

use super::{Section, Source};
use crate::level::Level;
use crate::math;
use crate::methods::excitation;
use crate::number::parts;
use crate::words::verdict::LIQUID_PARTED;
use crate::words::{outcome, sections};
use files::error::Error;
use results::compare::MEASURED;
use results::nonlinear::End;
use results::{EngineId, Method, Run, Status};
use tank::assessment::Step;

#[derive(Serialize)]
struct Sheet {
    id: String,
    /// Id of the method.
    #[serde(skip)]
    method: String,
    title: String,
    excitation: &'static str,
    not_applicable: Vec<String>,
    /// How many lines are left out because the sheet for the record has them, and its id.
    shared: String,
    base: String,
    parts: Vec<Part>,
    assumptions: Vec<String>,
    notes: Vec<String>,
    /// Document that clauses without a name are of; empty where each names its own.
    document: String,
}

#[derive(Serialize)]
struct Part {
    title: String,
    lines: Vec<LineView>,
}

#[derive(Serialize)]
struct LineView {
    /// Number within the sheet.
    number: usize,
    name: String,
    /// MathML, made by [`math`].
    symbol: String,
    formula: String,
    substitution: String,
    /// Source of a value without formula, as HTML.
    look_up: String,
    value: String,
    unit: &'static str,
    clause: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let full = source.level == Level::Full;
    let verdict = &source.results.verdict;
    // What an engine assumes and where it left its model stands at every level that has its numbers.
    let all = full || !source.results.methods.iter().any(|m| !m.is_run() && verdict.decides(m));
    let shown = |m: &&Method| {
        let said = !m.steps.is_empty() || !m.assumptions.is_empty() || !m.notes.is_empty();
        m.id != MEASURED && (said || m.status != Status::Computed) && (all || m.is_run() || verdict.decides(m))
    };
    let methods: Vec<&Method> = source.results.methods.iter().filter(shown).collect();
    let base = |method: &Method| methods.iter().copied().find(|r| is_base(r, method));
    let mut sheets: Vec<Sheet> = methods.iter().map(|m| sheet(m, base(m), full)).collect();
    let column = EngineId::Nonlinear.beside();
    if let (Some(run), Some(sheet)) = (
        source.results.beside(EngineId::Nonlinear),
        sheets.iter_mut().find(|s| s.method == column),
    ) {
        sheet.notes.splice(0..0, remarks(run));
    }
    if sheets.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("sheets");
    section.set("sheets", &sheets);
    section.set("full", &full);
    Ok(Some(section))
}

/// Remarks on a nonlinear run.
fn remarks(run: &Run) -> Vec<String> {
    let mut remarks = Vec::new();
    if let End::Left { departure, .. } = &run.end {
        remarks.push(outcome::stopped_remark(departure));
    }
    let departures = run.nonlinear.iter().flat_map(|n| &n.departures);
    let passed = departures.filter(|d| !d.kind.stops());
    remarks.extend(passed.map(outcome::remark));
    remarks.extend(run.parted().then(|| LIQUID_PARTED.to_owned()));
    remarks
}

fn sheet_id(method: &Method) -> String {
    format!("sheet-{}-{}", method.id, excitation(method))
}

/// Whether `base` is the same procedure as `method` on the record, where `method` is on the spectrum of the site.
fn is_base(base: &Method, method: &Method) -> bool {
    base.id == method.id && base.excitation == Excitation::Record && method.excitation == Excitation::Site
}

/// * `numbers`: whether the formulas stand with their numbers too
fn sheet(method: &Method, base: Option<&Method>, numbers: bool) -> Sheet {
    let known = base.map_or(&[][..], |b| &b.steps);
    let document = document(&method.steps);
    let mut number = 0;
    let mut shared = 0;
    let mut found: Vec<Part> = Vec::new();
    for step in &method.steps {
        if known.contains(step) {
            shared += 1;
            continue;
        }
        if found.last().is_none_or(|s| s.title != step.section) {
            found.push(Part {
                title: step.section.clone(),
                lines: Vec::new(),
            });
        }
        let (value, unit) = parts(step.value, step.dimension);
        let set = |text: &str| {
            if text.is_empty() {
                String::new()
            } else {
                math::formula(text)
            }
        };
        // Not "H/R = H/R".
        let formula = if step.formula == step.symbol {
            ""
        } else {
            step.formula.as_str()
        };
        let substitution = if step.substitution == step.formula || !(numbers || formula.is_empty()) {
            ""
        } else {
            step.substitution.as_str()
        };
        if let Some(part) = found.last_mut() {
            number += 1;
            part.lines.push(LineView {
                number,
                name: step.name.clone(),
                symbol: math::symbol(&step.symbol),
                formula: set(formula),
                substitution: set(substitution),
                look_up: if step.look_up.is_empty() {
                    String::new()
                } else {
                    math::words(&step.look_up)
                },
                value,
                unit,
                clause: within(&step.clause, document).to_owned(),
            });
        }
    }
    Sheet {
        id: sheet_id(method),
        method: method.id.clone(),
        title: method.title.clone(),
        excitation: excitation(method),
        not_applicable: match &method.status {
            Status::Computed => Vec::new(),
            Status::NotApplicable { clause, reason } => vec![format!("{clause}: {reason}")],
        },
        shared: sections::shared(shared),
        base: base.map_or(String::new(), sheet_id),
        parts: found,
        assumptions: method.assumptions.clone(),
        notes: method.notes.clone(),
        document: match document {
            "" => String::new(),
            document => sections::clauses_of(document),
        },
    }
}

/// The document that most of the clauses name, `EN 1998-4:2006` of `EN 1998-4:2006 A.3.2.1`; empty if that is less than a third of the lines.
fn document(steps: &[Step]) -> &str {
    let of = |clause: &'_ str| clause.rfind(' ').map(|end| clause[..end].to_owned());
    let mut found: Vec<(String, usize, &str)> = Vec::new();
    for step in steps {
        let Some(name) = of(&step.clause).filter(|name| name.contains(|c: char| c.is_ascii_digit())) else {
            continue;
        };
        match found.iter_mut().find(|f| f.0 == name) {
            Some(f) => f.1 += 1,
            None => found.push((name.clone(), 1, &step.clause[..name.len()])),
        }
    }
    let most = found.into_iter().max_by_key(|f| f.1);
    most.filter(|f| 3 * f.1 > steps.len()).map_or("", |f| f.2)
}

/// A clause without the name of the document.
fn within<'a>(clause: &'a str, document: &str) -> &'a str {
    match clause.strip_prefix(document).and_then(|rest| rest.strip_prefix(' ')) {
        Some(rest) if !document.is_empty() => rest,
        _ => clause,
    }
}
