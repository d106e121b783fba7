//! Calculation sheets: symbol = formula = numbers = value, or symbol from table = value; unit, clause. The sheet of a procedure on the spectrum of the
//! site shows only the lines that differ from its sheet on the record.

use serde::Serialize;
use tank::assessment::Excitation;

use super::{Section, Source};
use crate::math;
use crate::methods::excitation;
use crate::number::parts;
use crate::words::verdict::LIQUID_PARTED;
use crate::words::{outcome, sections};
use files::error::Error;
use results::compare::MEASURED;
use results::nonlinear::End;
use results::{EngineId, Method, Run, Status};

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
}

#[derive(Serialize)]
struct Part {
    title: String,
    lines: Vec<LineView>,
}

#[derive(Serialize)]
struct LineView {
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
    let mut sheets: Vec<Sheet> = source
        .results
        .methods
        .iter()
        .filter(|m| {
            let said = !m.steps.is_empty() || !m.assumptions.is_empty() || !m.notes.is_empty();
            m.id != MEASURED && (said || m.status != Status::Computed)
        })
        .map(|m| sheet(m, source.results.methods.iter().find(|r| is_base(r, m))))
        .collect();
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

fn sheet(method: &Method, base: Option<&Method>) -> Sheet {
    let known = base.map_or(&[][..], |b| &b.steps);
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
        let substitution = if step.substitution == step.formula {
            ""
        } else {
            step.substitution.as_str()
        };
        if let Some(part) = found.last_mut() {
            part.lines.push(LineView {
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
                clause: step.clause.clone(),
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
    }
}
