//! Measured and published values next to the computed ones.

use serde::Serialize;

use super::{Section, Source};
use crate::number::{Scale, ratio};
use files::error::Error;
use results::compare::MEASURED;

#[derive(Serialize)]
struct Row {
    quantity: String,
    unit: &'static str,
    value: String,
    computed: String,
    ratio: String,
    source: String,
    note: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let computed = |id: &str| source.fe().and_then(|m| m.quantities.get(id)).map(|v| v.value);
    let mut rows = Vec::new();
    let mut remarks: Vec<String> = Vec::new();
    for method in source.results.methods.iter().filter(|m| m.id == MEASURED) {
        remarks.extend(method.notes.iter().cloned());
    }
    for reported in &source.results.comparison.published {
        let id = reported.quantity.id();
        let fe = computed(id);
        let scale = Scale::of(reported.quantity.dimension(), [reported.value, fe.unwrap_or(0.0)]);
        rows.push(Row {
            quantity: reported.quantity.title().into(),
            unit: scale.symbol(),
            value: scale.text(reported.value),
            computed: fe.map_or("–".into(), |v| scale.text(v)),
            ratio: fe
                .filter(|v| *v != 0.0)
                .map_or("–".into(), |v| ratio(reported.value / v)),
            source: reported.source.clone(),
            note: reported.note.clone().unwrap_or_default(),
        });
    }
    if rows.is_empty() && remarks.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("reported");
    section.set("has_fe", &source.fe().is_some());
    section.set("rows", &rows);
    section.set("remarks", &remarks);
    Ok(Some(section))
}
