//! The finite-element model: mesh, integration, balances, discretisation error.

use serde::Serialize;
use tank::Quantity;
use tank::units::Dimension;

use super::{Section, Source};
use crate::number::{Scale, percent, significant};
use crate::table::{Table, columns};
use crate::words::{capital, labels, sections};
use files::error::Error;
use results::{MESH_ERROR_LIMIT, Run};

#[derive(Serialize)]
struct Pair {
    label: String,
    text: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(fe) = source.results.reference() else { return Ok(None) };
    let mut section = Section::new("engine");
    fill(&mut section, fe);
    Ok(Some(section))
}

/// Sets the values of a run that the template `sections/engine.html` shows.
pub(super) fn fill(section: &mut Section, fe: &Run) {
    let pairs = |list: &[results::Labelled]| -> Vec<Pair> {
        list.iter().map(|l| Pair { label: capital(&l.label), text: l.text.clone() }).collect()
    };
    section.set("engine_words", &sections::sentences("engine"));
    section.set("engine", fe.engine.id());
    section.set("mesh", &pairs(&fe.mesh));
    section.set("integration", &pairs(&fe.integration));

    let mut damping = Table::new(columns!["ω" => "rad/s", "Kind", "Resulting damping" => "", "Remark"]);
    for row in &fe.damping_table {
        damping.row(vec![significant(row.omega, 4), row.kind.clone(), percent(row.ratio), row.note.clone()]);
    }
    let [damped, refined, balanced, conserved] = labels::engine_tables(fe.engine.name());
    damping.caption = damped;
    section.set("damping", &damping);

    let mut mesh_error = Table::new(columns!["Quantity", labels::MESH_ERROR => ""]);
    for (id, error) in &fe.mesh_error {
        let title = Quantity::from_id(id).map_or(id.as_str(), |q| q.title());
        let mark = if *error > MESH_ERROR_LIMIT { ", unusable" } else { "" };
        mesh_error.row(vec![title.into(), percent(*error) + mark]);
    }
    mesh_error.caption = refined;
    section.set("mesh_error", &mesh_error);

    let mut balance = Table::new(columns!["Balance", "Relative error" => ""]);
    for row in &fe.mass_balance {
        balance.row(vec![capital(&row.label), percent(row.error)]);
    }
    balance.caption = balanced;
    section.set("balance", &balance);

    let mut energy = Table::default();
    if let Some(e) = &fe.energy {
        let scale = Scale::of(Dimension::Energy, [e.input, e.kinetic, e.elastic, e.damping]);
        energy = Table::new(columns![labels::ENERGY_AT_END, "Value" => scale.symbol()]);
        let values = [e.input, e.kinetic, e.elastic, e.damping];
        for (label, value) in labels::ENERGIES.into_iter().zip(values) {
            energy.row(vec![label.into(), scale.text(value)]);
        }
        energy.caption = conserved;
        section.set("residual", &sections::residual(&percent(e.error)));
    }
    section.set("energy", &energy);
}
