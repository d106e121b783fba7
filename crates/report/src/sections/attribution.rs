//! Factor by factor from the finite elements to each procedure.

use serde::Serialize;
use tank::Quantity;
use tank::assessment::Excitation;
use tank::factor::Factor;

use super::{Section, Source};
use crate::figure::Figure;
use crate::figure::waterfall::{Fall, waterfall};
use crate::level::Level;
use crate::methods::{figure_order, look};
use crate::number::significant;
use crate::table::{Column, Table, columns};
use crate::words::factors;
use files::error::Error;
use results::Method;
use results::compare::Attribution;

/// Quantities with a waterfall.
const HEADLINES: [Quantity; 4] =
    [Quantity::SloshingHeight, Quantity::BaseShear, Quantity::OverturningMoment, Quantity::HoopStress];

/// The factors of a quantity under one excitation.
#[derive(Serialize)]
struct Factors {
    title: String,
    table: Table,
}

/// A method and its attribution.
type Attributed<'a> = (&'a Method, &'a Attribution);

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let mut figures = Vec::new();
    let mut tables = Vec::new();
    // Below the full level there are the procedures that decide, if one does.
    let verdict = &source.results.verdict;
    let codes = |id: &str| source.results.comparison.attribution.iter().any(|a| a.method == id);
    for quantity in Quantity::ALL {
        for excitation in [Excitation::Record, Excitation::Site] {
            let mut columns = columns(source, quantity, excitation);
            if source.level < Level::Full && verdict.deciding.iter().any(|d| codes(&d.method)) {
                columns.retain(|(method, _)| verdict.deciding.iter().any(|d| d.method == method.id));
            }
            if columns.is_empty() {
                continue;
            }
            let title = factors::title(quantity.title(), excitation == Excitation::Site);
            if HEADLINES.contains(&quantity) {
                figures.extend(figure(quantity, excitation, &columns));
            }
            tables.push(Factors { title, table: table(&columns) });
        }
    }
    if tables.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("attribution");
    // On screen they are folded, on paper they are left out.
    if source.level < Level::Full {
        tables.clear();
        if figures.is_empty() {
            return Ok(None);
        }
    }
    section.set_figures("figures", figures);
    section.set("tables", &tables);
    Ok(Some(section))
}

/// The attributions of a quantity, in the order of figures.
fn columns<'a>(source: &Source<'a>, quantity: Quantity, excitation: Excitation) -> Vec<Attributed<'a>> {
    let results = source.results;
    let all = &results.comparison.attribution;
    let own = |method: &'a Method| {
        let found = all.iter().find(|a| {
            a.method == method.id
                && a.excitation == method.excitation
                && a.excitation == excitation
                && a.quantity == quantity
        });
        found.map(|a| (method, a))
    };
    let order = figure_order(results).into_iter();
    order.filter_map(|i| own(&results.methods[i])).collect()
}

fn figure(quantity: Quantity, excitation: Excitation, columns: &[Attributed]) -> Option<Figure> {
    let falls: Vec<Fall> = columns
        .iter()
        .map(|(method, attribution)| Fall {
            look: look(method),
            steps: attribution.steps.iter().map(|step| (step.factor_id.name().to_owned(), step.factor)).collect(),
            ratio: attribution.ratio,
        })
        .collect();
    let site = excitation == Excitation::Site;
    let id = format!("attribution-{}{}", quantity.id().replace('_', "-"), if site { "-site" } else { "" });
    waterfall(&id, &short_title(quantity, site), &falls)
}

fn short_title(quantity: Quantity, site: bool) -> String {
    let name = crate::words::capital(&crate::words::quantity(quantity));
    factors::short_title(&name, site)
}

/// Factors by method, in the order of exchange, and their product.
fn table(columns: &[Attributed]) -> Table {
    let mut heads = columns![factors::FACTOR];
    heads.extend(columns.iter().map(|(method, _)| Column::numbers(&look(method).full_label(), "")));
    let mut table = Table::new(heads);
    for factor in Factor::ALL {
        let of = |a: &Attribution| a.steps.iter().find(|s| s.factor_id == factor).map(|s| s.factor);
        let cells: Vec<Option<f64>> = columns.iter().map(|(_, a)| of(a)).collect();
        if cells.iter().any(Option::is_some) {
            let mut row = vec![factor.name().to_owned()];
            row.extend(cells.iter().map(|c| c.map_or("1".into(), |f| significant(f, 4))));
            table.row(row);
        }
    }
    let mut product = vec![factors::PRODUCT.to_owned()];
    product.extend(columns.iter().map(|(_, a)| significant(a.ratio, 4)));
    table.row(product);
    table
}
