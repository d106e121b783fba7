//! Measured and published values next to the computed ones.

use serde::Serialize;

use super::{Section, Source};
use crate::number::{Scale, ratio};
use crate::words::apart;
use files::error::Error;
use results::compare::{MEASURED, Why};

/// A measured value that is not compared.
#[derive(Serialize)]
struct Apart {
    quantity: String,
    unit: &'static str,
    value: String,
    source: String,
    note: String,
    reason: String,
}

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
    let comparison = &source.results.comparison;
    let mut others = Vec::new();
    for found in &comparison.measured_apart {
        let scale = Scale::of(found.value.quantity.dimension(), [found.value.value]);
        others.push(Apart {
            quantity: found.value.quantity.title().into(),
            unit: scale.symbol(),
            value: scale.text(found.value.value),
            source: found.value.source.clone(),
            note: found.value.note.clone().unwrap_or_default(),
            reason: apart::why(&found.reason),
        });
    }
    for (i, reported) in comparison.published.iter().enumerate() {
        let belongs = comparison.published_apart.get(i).is_none_or(Option::<Why>::is_none);
        let id = reported.quantity.id();
        let fe = computed(id);
        let scale = Scale::of(reported.quantity.dimension(), [reported.value, fe.unwrap_or(0.0)]);
        rows.push(Row {
            quantity: reported.quantity.title().into(),
            unit: scale.symbol(),
            value: scale.text(reported.value),
            computed: fe.map_or("–".into(), |v| scale.text(v)),
            ratio: fe.filter(|v| belongs && *v != 0.0).map_or("–".into(), |v| ratio(reported.value / v)),
            source: reported.source.clone(),
            note: reported.note.clone().unwrap_or_default(),
        });
    }
    if rows.is_empty() && remarks.is_empty() && others.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("reported");
    section.set("has_fe", &source.fe().is_some());
    section.set("rows", &rows);
    section.set("remarks", &remarks);
    section.set("others", &others);
    Ok(Some(section))
}
