//! What a run found on one subject (isolators, soil, …), as typed facts: words, units and pages are made of it once, by the report.
//!
//! Titles follow from ids. That of the column `force` of the table `band` in the part `isolation` is the message
//! `isolation-band-force`, else `isolation-force`, else `force`; so are those of rows, tables, charts, axes and lines.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

use crate::channel::Channel;
use crate::value::{Value, unit_symbol};

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

/// A sentence or a label by its id, with what is put into it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Message {
    /// Id of its text.
    pub id: String,
    /// Facts by the names under which the text has them.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, Fact>,
}

/// What a sentence or a cell holds.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Fact {
    /// Nothing.
    #[default]
    None,
    /// A number in the unit of its column; a count in a sentence.
    Number(f64),
    /// An id: of a row's title in a cell, of a choice in a sentence.
    Word(String),
    /// A number with its unit.
    Amount(Amount),
    /// A sentence or a label.
    Message(Message),
}

/// A number with its unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Amount {
    /// Value in SI.
    pub value: f64,
    /// Dimension, written as the symbol of its unit in SI.
    #[serde(with = "unit_symbol")]
    pub unit: Dimension,
    /// How it is printed.
    #[serde(default, skip_serializing_if = "is_default")]
    pub form: Form,
}

/// How a number is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// Four significant digits in an engineer's unit; in a column with a unit, as many decimals as its largest value.
    #[default]
    Usual,
    /// A given value, without idle zeros.
    Given,
    /// With this many decimals, in the unit of SI.
    Fixed(u8),
    /// With this many significant digits.
    Significant(u8),
    /// As a percentage.
    Percent,
    /// An angle in degrees with this many decimals.
    Degrees(u8),
    /// Not a number: words, to the left in a column.
    Words,
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

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

fn plain() -> Dimension {
    Dimension::Dimensionless
}

fn is_plain(unit: &Dimension) -> bool {
    *unit == plain()
}

/// Values against each other. Charts of one line that several engines have under one id are drawn into one figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Chart {
    /// Id; with the subject in front that of the file of the figure.
    pub id: String,
    /// Title; by default that of the id.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<Message>,
    /// The rest of the caption.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub caption: Option<Message>,
    /// Room.
    #[serde(default, skip_serializing_if = "is_default")]
    pub room: Room,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Filled areas, drawn first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub areas: Vec<Line>,
    /// Curves.
    pub lines: Vec<Line>,
    /// Values of x with their symbols.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub marks: Vec<(f64, String)>,
}

/// Room of a chart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Room {
    /// Half the width of the text.
    #[default]
    Half,
    /// The same, higher.
    Tall,
    /// The width of the text.
    Wide,
}

/// An axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Id.
    pub id: String,
    /// Dimension, written as the symbol of its unit in SI.
    #[serde(with = "unit_symbol")]
    pub unit: Dimension,
    /// What it holds.
    #[serde(default, skip_serializing_if = "is_default")]
    pub scale: Scale,
}

/// What an axis holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scale {
    /// The values.
    #[default]
    Free,
    /// The values and zero.
    Zero,
    /// From one value to another.
    Range([f64; 2]),
    /// The logarithms of the values.
    Log,
    /// The same with labels at powers of ten, at most this many below the largest value.
    Decades(u8),
}

/// A curve, or the corners of an area.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Text of the legend.
    #[serde(default, skip_serializing_if = "Fact::is_none")]
    pub label: Fact,
    /// Its look.
    #[serde(default, skip_serializing_if = "is_default")]
    pub look: Look,
    /// Points in SI.
    pub points: Vec<[f64; 2]>,
}

/// What a curve stands for, which gives it its look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Look {
    /// The result.
    #[default]
    Main,
    /// A result of many points.
    Thin,
    /// Another one beside it.
    Other,
}

/// Histories of one dimension over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Id, also of the file of the figure.
    pub id: String,
    /// Id of the axis upwards.
    pub axis: String,
    /// At most two columns of `series.csv`; the legend calls them x and y.
    pub channels: Vec<String>,
}

impl Part {
    /// All values that are compared.
    pub fn values(&self) -> impl Iterator<Item = &Finding> {
        let of = |block| match block {
            &Block::Values { ref values, .. } => values.as_slice(),
            _ => &[],
        };
        self.blocks.iter().flat_map(of)
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

impl Message {
    /// A sentence without facts.
    pub fn new(id: &str) -> Message {
        Message {
            id: id.into(),
            args: BTreeMap::new(),
        }
    }

    /// The same with a fact.
    #[must_use]
    pub fn with(mut self, name: &str, fact: impl Into<Fact>) -> Message {
        self.args.insert(name.into(), fact.into());
        self
    }
}

impl Amount {
    /// A number in the usual form.
    pub fn new(value: f64, unit: Dimension) -> Amount {
        Amount {
            value,
            unit,
            form: Form::Usual,
        }
    }

    /// The same in another form.
    #[must_use]
    pub fn form(self, form: Form) -> Amount {
        Amount { form, ..self }
    }

    /// A number without a unit.
    pub fn ratio(value: f64) -> Amount {
        Amount::new(value, Dimension::Dimensionless)
    }

    /// A share in percent.
    pub fn percent(value: f64) -> Amount {
        Amount::ratio(value).form(Form::Percent)
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
        Block::List {
            items: ids.iter().map(|id| Message::new(&format!("{subject}-{id}"))).collect(),
        }
    }
}

impl Table {
    /// A table of columns by id, dimension and form.
    pub fn new(id: &str, columns: &[(&str, Dimension, Form)], rows: Vec<Vec<Fact>>) -> Table {
        let column = |&(id, unit, form): &(&str, Dimension, Form)| Column {
            id: id.into(),
            unit,
            form,
        };
        Table {
            id: id.into(),
            columns: columns.iter().map(column).collect(),
            rows,
        }
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

impl Chart {
    /// A chart of half the width.
    pub fn new(id: &str, x: Axis, y: Axis, lines: Vec<Line>) -> Chart {
        Chart {
            id: id.into(),
            title: None,
            caption: None,
            room: Room::Half,
            x,
            y,
            areas: Vec::new(),
            lines,
            marks: Vec::new(),
        }
    }
}

impl Axis {
    /// An axis.
    pub fn new(id: &str, unit: Dimension, scale: Scale) -> Axis {
        Axis {
            id: id.into(),
            unit,
            scale,
        }
    }
}

impl Line {
    /// A line.
    pub fn new(label: impl Into<Fact>, look: Look, points: Vec<[f64; 2]>) -> Line {
        Line {
            label: label.into(),
            look,
            points,
        }
    }
}

impl History {
    /// Channels of one dimension.
    pub fn new(id: &str, axis: &str, channels: &[Channel]) -> History {
        History {
            id: id.into(),
            axis: axis.into(),
            channels: channels.iter().map(|channel| channel.id()).collect(),
        }
    }
}

impl Fact {
    fn is_none(&self) -> bool {
        *self == Fact::None
    }

    /// Its number, with or without a unit.
    pub fn value(&self) -> Option<f64> {
        match self {
            Fact::Number(value) => Some(*value),
            Fact::Amount(amount) => Some(amount.value),
            _ => None,
        }
    }
}

impl From<f64> for Fact {
    fn from(value: f64) -> Fact {
        Fact::Number(value)
    }
}

impl From<&str> for Fact {
    fn from(id: &str) -> Fact {
        Fact::Word(id.into())
    }
}

impl From<Amount> for Fact {
    fn from(amount: Amount) -> Fact {
        Fact::Amount(amount)
    }
}

impl From<Message> for Fact {
    fn from(message: Message) -> Fact {
        Fact::Message(message)
    }
}

impl<T: Into<Fact>> From<Option<T>> for Fact {
    fn from(fact: Option<T>) -> Fact {
        fact.map_or(Fact::None, Into::into)
    }
}
