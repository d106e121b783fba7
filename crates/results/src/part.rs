//! What a run found on one subject (isolators, soil, …), as typed facts: words, units and pages are made of it once, by the report.
//!
//! Titles follow from ids. That of the column `force` of the table `band` in the part `isolation` is the message
//! `isolation-band-force`, else `isolation-force`, else `force`; so are those of rows, tables, charts, axes and lines.

mod chart;
mod fact;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

use crate::value::{Value, unit_symbol};
use fact::is_default;

pub use chart::{Axis, Chart, History, Line, Look, Room, Scale};
pub use fact::{Amount, Fact, Form, Message};

/// The facts on one subject.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Subject, the first word of the ids of its messages.
    pub id: String,
    /// Blocks in the order of the page.
    pub blocks: Vec<Block>,
}

/// A piece of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[allow(clippy::large_enum_variant, reason = "a part has a few dozen blocks")]
pub enum Block {
    /// A paragraph.
    Text(Message),
    /// A remark in small type.
    Note(Message),
    /// Sentences, one an item.
    List {
        /// The sentences.
        items: Vec<Message>,
    },
    /// Values with their time, their place and their reference, as far as there are any.
    Values {
        /// Id.
        id: String,
        /// The values.
        values: Vec<Finding>,
    },
    /// A table.
    Table(Table),
    /// Values against each other.
    Chart(Chart),
    /// Columns of `series.csv` over time.
    History(History),
    /// Numbers for scripts, which no page shows.
    Series(Table),
}

/// A value that is compared, with its time and place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Id.
    pub id: String,
    /// Value and unit.
    #[serde(flatten)]
    pub value: Value,
    /// How it is printed.
    #[serde(default, skip_serializing_if = "is_default")]
    pub form: Form,
    /// When [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
    /// Where, θ [°].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub degrees: Option<f64>,
    /// Where, above the base plate [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// The same of the tank on a base that does not move (SI).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held: Option<f64>,
}

/// A table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Id.
    pub id: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, a fact a column.
    pub rows: Vec<Vec<Fact>>,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Id.
    pub id: String,
    /// Dimension of its plain numbers, written as the symbol of its unit in SI.
    #[serde(default = "plain", skip_serializing_if = "is_plain", with = "unit_symbol")]
    pub unit: Dimension,
    /// How they are printed.
    #[serde(default, skip_serializing_if = "is_default")]
    pub form: Form,
}

fn plain() -> Dimension {
    Dimension::Dimensionless
}

fn is_plain(unit: &Dimension) -> bool {
    *unit == plain()
}

impl Part {
    /// All values that are compared.
    pub fn values(&self) -> impl Iterator<Item = &Finding> {
        self.blocks.iter().flat_map(|block| match block {
            Block::Values { values, .. } => values.as_slice(),
            _ => &[],
        })
    }

    /// A value by its id.
    pub fn value(&self, id: &str) -> Option<&Finding> {
        self.values().find(|value| value.id == id)
    }

    /// Values on a base that does not move, by id of the quantity; empty of a part without.
    pub fn held(&self) -> BTreeMap<String, f64> {
        let pair = |found: &Finding| Some((found.id.clone(), found.held?));
        self.values().filter_map(pair).collect()
    }

    /// A number that a remark names.
    pub fn said(&self, message: &str, name: &str) -> Option<f64> {
        let of = |block: &Block| match block {
            Block::Note(note) if note.id == message => note.args.get(name).and_then(Fact::value),
            _ => None,
        };
        self.blocks.iter().find_map(of)
    }

    /// A number of a table, in the row whose first cell is `row`.
    pub fn cell(&self, table: &str, row: &str, column: &str) -> Option<f64> {
        let table = self.table(table)?;
        let first = |cells: &&Vec<Fact>| matches!(cells.first(), Some(Fact::Word(id)) if id == row);
        let at = table.columns.iter().position(|own| own.id == column)?;
        table.rows.iter().find(first)?.get(at)?.value()
    }

    /// A table or series by its id.
    pub fn table(&self, id: &str) -> Option<&Table> {
        self.blocks.iter().find_map(|block| match block {
            Block::Table(table) | Block::Series(table) if table.id == id => Some(table),
            _ => None,
        })
    }

    /// The points of a line of a chart, by the id in its legend.
    pub fn line(&self, chart: &str, label: &str) -> Option<&[[f64; 2]]> {
        let found = self.blocks.iter().find_map(|block| match block {
            Block::Chart(own) if own.id == chart => Some(own),
            _ => None,
        });
        let own = |line: &&Line| matches!(&line.label, Fact::Word(id) if id == label);
        found?.lines.iter().find(own).map(|line| line.points.as_slice())
    }
}

impl Finding {
    /// A value without time and place.
    pub fn new(id: &str, value: f64, dimension: Dimension) -> Finding {
        Finding {
            id: id.into(),
            value: Value { value, dimension },
            form: Form::Usual,
            time: None,
            degrees: None,
            z: None,
            held: None,
        }
    }

    /// Value, unit and form.
    pub fn amount(&self) -> Amount {
        Amount::new(self.value.value, self.value.dimension).form(self.form)
    }
}

impl Block {
    /// Values as a table.
    pub fn values(id: &str, values: Vec<Finding>) -> Block {
        Block::Values { id: id.into(), values }
    }

    /// Sentences without facts, `<subject>-<id>`.
    pub fn list(subject: &str, ids: &[&str]) -> Block {
        Block::List { items: ids.iter().map(|id| Message::new(&format!("{subject}-{id}"))).collect() }
    }
}

impl Table {
    /// A table of columns by id, dimension and form.
    pub fn new(id: &str, columns: &[(&str, Dimension, Form)], rows: Vec<Vec<Fact>>) -> Table {
        let column = |&(id, unit, form): &(&str, Dimension, Form)| Column { id: id.into(), unit, form };
        Table { id: id.into(), columns: columns.iter().map(column).collect(), rows }
    }

    /// Energies by id [J], each with its share of the first, the input.
    pub fn energies<const N: usize>(all: [(&str, f64); N]) -> Table {
        let input = all.first().map_or(0.0, |first| first.1);
        let row = |(id, value): (&str, f64)| {
            let share = (input != 0.0).then(|| value / input);
            vec![id.into(), value.into(), share.into()]
        };
        let columns = [
            ("energy", Dimension::Dimensionless, Form::Words),
            ("value", Dimension::Energy, Form::Usual),
            ("share", Dimension::Dimensionless, Form::Percent),
        ];
        Table::new("energies", &columns, all.map(row).to_vec())
    }

    /// The numbers of a column.
    pub fn column(&self, id: &str) -> Vec<f64> {
        let at = self.columns.iter().position(|column| column.id == id);
        let cells = |at: usize| self.rows.iter().filter_map(move |row| row.get(at)?.value());
        at.into_iter().flat_map(cells).collect()
    }
}
