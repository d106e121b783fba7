//! Calculation sheets: symbol = formula = numbers = value, unit, clause.

use serde::Serialize;

use super::{Section, Source};
use crate::error::Error;
use crate::report::math;
use crate::report::methods::excitation;
use crate::report::number::parts;
use crate::results::{Method, Status};

#[derive(Serialize)]
struct Sheet {
    id: String,
    title: String,
    excitation: &'static str,
    not_applicable: Vec<String>,
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
    value: String,
    unit: &'static str,
    clause: String,
}

/// Makes the section.
pub fn make(source: &Source) -> Result<Option<Section>, Error> {
    let sheets: Vec<Sheet> = source
        .results
        .methods
        .iter()
        .filter(|m| {
            let said = !m.steps.is_empty() || !m.assumptions.is_empty() || !m.notes.is_empty();
            m.id != "measured" && (said || m.status != Status::Computed)
        })
        .map(sheet)
        .collect();
    if sheets.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("sheets", "Calculation sheets");
    section.set("sheets", &sheets);
    Ok(Some(section))
}

fn sheet(method: &Method) -> Sheet {
    let mut sections: Vec<Part> = Vec::new();
    for step in &method.steps {
        if sections.last().is_none_or(|s| s.title != step.section) {
            sections.push(Part {
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
        let substitution = if step.substitution == step.formula {
            ""
        } else {
            step.substitution.as_str()
        };
        if let Some(part) = sections.last_mut() {
            part.lines.push(LineView {
                name: step.name.clone(),
                symbol: math::symbol(&step.symbol),
                formula: set(&step.formula),
                substitution: set(substitution),
                value,
                unit,
                clause: step.clause.clone(),
            });
        }
    }
    Sheet {
        id: format!("sheet-{}-{}", method.id, excitation(method)),
        title: method.title.clone(),
        excitation: excitation(method),
        not_applicable: match &method.status {
            Status::Computed => Vec::new(),
            Status::NotApplicable { clause, reason } => vec![format!("{clause}: {reason}")],
        },
        parts: sections,
        assumptions: method.assumptions.clone(),
        notes: method.notes.clone(),
    }
}
