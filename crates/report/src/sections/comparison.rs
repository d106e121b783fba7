//! The matrix quantities × methods with the ratios to the finite elements, and the headline quantities as bars.

use std::collections::BTreeSet;

use serde::Serialize;
use tank::Quantity;
use tank::assessment::Excitation;
use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::Figure;
use crate::figure::bars::{Bar, bars};
use crate::level::Level;
use crate::methods::{divided, divides, dividing, excitation, figure_order, look};
use crate::number::{Scale, ratio};
use crate::words::labels::OUTSIDE;
use crate::words::terminal;
use files::error::Error;
use results::{Cell, FE, Method, Results, Status};

/// Headline quantities: sloshing height, base moment, membrane stresses.
const HEADLINES: [Quantity; 4] =
    [Quantity::SloshingHeight, Quantity::BaseMoment, Quantity::HoopStress, Quantity::AxialMembraneStress];

/// Masses that are modal with finite elements.
const MODAL: [Quantity; 3] = [Quantity::ImpulsiveMass, Quantity::WallMass, Quantity::RoofMass];

#[derive(Serialize)]
struct Head {
    label: String,
    excitation: &'static str,
    fe: bool,
    /// First column of the site's group, set off by a rule.
    break_before: bool,
}

#[derive(Serialize)]
struct Row {
    title: String,
    unit: &'static str,
    cells: Vec<CellView>,
}

#[derive(Serialize)]
struct CellView {
    value: String,
    unusable: bool,
    /// Whether it is divided by the factor of a code.
    divided: bool,
    outside: Option<&'static str>,
    ratio: String,
    fe: bool,
    break_before: bool,
}

#[derive(Serialize)]
struct Absent {
    title: String,
    excitation: &'static str,
    clause: String,
    reason: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let results = source.results;
    let given = |m: &Method| !m.quantities.is_empty();
    let columns: Vec<usize> = figure_order(results).into_iter().filter(|&i| given(&results.methods[i])).collect();
    let absent = absent(results);
    if (columns.is_empty() || results.comparison.rows.is_empty()) && absent.is_empty() {
        return Ok(None);
    }
    let site = |i: usize| results.methods[i].excitation == Excitation::Site;
    let first_site = columns.iter().position(|&i| site(i)).filter(|&p| p > 0);
    let head: Vec<Head> = columns
        .iter()
        .enumerate()
        .map(|(p, &i)| Head {
            label: look(&results.methods[i]).label,
            excitation: excitation(&results.methods[i]),
            fe: results.methods[i].id == FE,
            break_before: Some(p) == first_site,
        })
        .collect();
    let ids: BTreeSet<&str> = columns.iter().map(|&i| results.methods[i].id.as_str()).collect();
    let by: Vec<String> = columns.iter().map(|&i| divided(results, &results.methods[i])).collect();
    let mut rows = Vec::new();
    for row in &results.comparison.rows {
        let cells: Vec<_> = columns.iter().map(|&i| row.cells.get(i).copied().flatten()).collect();
        // What one engine alone gives stands on the cover and in the section of the base.
        let of_base = Quantity::OF_BASE.iter().any(|quantity| quantity.id() == row.quantity);
        if of_base && cells.iter().flatten().count() == 1 {
            continue;
        }
        // The standard table leaves out what only one method gives: there is nothing to compare it with.
        let given: BTreeSet<&str> = columns
            .iter()
            .zip(&cells)
            .filter(|(_, c)| c.is_some())
            .map(|(i, _)| results.methods[*i].id.as_str())
            .collect();
        if source.level != Level::Full && given.len() < 2 && ids.len() > 1 {
            continue;
        }
        // The trough touches neither freeboard nor roof, and follows from the crest.
        if source.level != Level::Full && row.quantity == Quantity::SloshingTrough.id() {
            continue;
        }
        let scale = Scale::of(row.dimension, cells.iter().flatten().map(|c| c.value));
        rows.push(Row {
            title: row.title.clone(),
            unit: scale.symbol(),
            cells: cells
                .iter()
                .zip(head.iter().zip(&by))
                .map(|(cell, column)| view(*cell, column, (&scale, row.dimension)))
                .collect(),
        });
    }
    let mut section = Section::new("comparison");
    let directions = results.reference().map_or(&[][..], |run| &run.directions);
    section.set("components", &terminal::components(directions));
    section.set("dense", &(head.len() > 7));
    section.set("has_fe", &source.fe().is_some());
    let modal = |row: &results::ComparisonRow| MODAL.iter().any(|quantity| quantity.id() == row.quantity);
    let masses = source.fe().is_some() && results.comparison.rows.iter().any(modal);
    section.set("masses", &masses);
    section.set("divided", &dividing(results, &columns));
    section.set("head", &head);
    section.set("rows", &rows);
    section.set("absent", &absent);
    let mut cells = results.comparison.rows.iter().flat_map(|row| row.cells.iter().flatten());
    section.set("outside", &cells.any(|cell| cell.outside));
    // Below the full level the table has the numbers of the bars.
    let drawn = |site: bool| if source.level == Level::Full { headline_figures(results, site) } else { Vec::new() };
    section.set_figures("site_figures", drawn(true));
    section.set_figures("figures", drawn(false));
    Ok(Some(section))
}

/// A cell in its column, whose values are divided by something or, where that is empty, are not.
fn view(cell: Option<Cell>, (head, by): (&Head, &String), (scale, dimension): (&Scale, Dimension)) -> CellView {
    CellView {
        value: cell.map_or("–".into(), |c| scale.text(c.value)),
        unusable: cell.is_some_and(|c| c.unusable),
        divided: cell.is_some() && divides(dimension) && !by.is_empty(),
        outside: cell.filter(|c| c.outside).map(|_| OUTSIDE),
        ratio: cell.and_then(|c| c.ratio).filter(|_| !head.fe).map_or(String::new(), ratio),
        fe: head.fe,
        break_before: head.break_before,
    }
}

/// Methods that do not apply.
fn absent(results: &Results) -> Vec<Absent> {
    results
        .methods
        .iter()
        .filter_map(|m| match &m.status {
            Status::Computed => None,
            Status::NotApplicable { clause, reason } => Some(Absent {
                title: m.title.clone(),
                excitation: excitation(m),
                clause: clause.clone(),
                reason: reason.clone(),
            }),
        })
        .collect()
}

/// Bars under the record, or under the spectrum of the site: design values and those of a record are not drawn side by side.
fn headline_figures(results: &Results, site: bool) -> Vec<Figure> {
    let order: Vec<usize> = figure_order(results)
        .into_iter()
        .filter(|&i| look(&results.methods[i]).site == site && results.methods[i].beyond_scope.is_none())
        .collect();
    let mut figures = Vec::new();
    let freeboard = results.tank.freeboard();
    let dividing = dividing(results, &order).join(" ");
    for quantity in HEADLINES {
        let Some(row) = results.comparison.rows.iter().find(|r| r.quantity == quantity.id()) else { continue };
        let values: Vec<Bar> = order
            .iter()
            .filter_map(|&i| {
                let cell = row.cells.get(i).copied().flatten()?;
                Some(Bar {
                    look: look(results.methods.get(i)?),
                    value: cell.value,
                    ratio: cell.ratio,
                    outside: cell.outside,
                    overtops: quantity == Quantity::SloshingHeight && cell.value > freeboard,
                    divided: divides(row.dimension) && !divided(results, results.methods.get(i)?).is_empty(),
                })
            })
            .collect();
        let by = if values.iter().any(|bar| bar.divided) { dividing.as_str() } else { "" };
        figures.extend(bars(
            &format!("bars_{}{}", row.quantity, if site { "_site" } else { "" }),
            (&row.title, by),
            row.dimension,
            &values,
            row.cells.iter().flatten().map(|c| c.value),
        ));
    }
    figures
}
