//! Tables as plain data: the templates give them their form.

use serde::ser::{Serialize, SerializeStruct, Serializer};
use tank::units::{Dimension, System, Unit, in_unit};

use crate::number::fixed;

/// A table with units in its head. Templates see it in the units of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Caption; empty where the surrounding text replaces it.
    pub caption: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, each with one text a column.
    pub rows: Vec<Vec<String>>,
}

/// Head of a column.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Column {
    /// Title.
    pub title: String,
    /// Unit, empty if there is none.
    pub unit: String,
    /// Whether the column holds numbers (right-aligned).
    pub numeric: bool,
}

impl Column {
    /// A column of words.
    pub fn words(title: &str) -> Column {
        Column { title: title.into(), ..Column::default() }
    }

    /// A column of numbers with their unit.
    pub fn numbers(title: &str, unit: &str) -> Column {
        Column { title: title.into(), unit: unit.into(), numeric: true }
    }
}

/// Columns by title: `"Quantity"` of words, `"Time" => "s"` of numbers with their unit.
macro_rules! columns {
    ($($title:expr $(=> $unit:expr)?),* $(,)?) => {
        vec![$($crate::table::column!($title $(, $unit)?)),*]
    };
}

/// One of [`columns`].
macro_rules! column {
    ($title:expr) => {
        $crate::table::Column::words($title)
    };
    ($title:expr, $unit:expr) => {
        $crate::table::Column::numbers($title, $unit)
    };
}

pub(crate) use {column, columns};

impl Table {
    /// An empty table with these columns.
    pub fn new(columns: Vec<Column>) -> Table {
        Table { columns, ..Table::default() }
    }

    /// Appends a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }
}

/// A table that is made of items column by column, an item a row.
pub struct Rows<'a, T> {
    items: &'a [T],
    /// The table so far.
    pub table: Table,
}

impl<'a, T> Rows<'a, T> {
    /// A table without columns yet.
    pub fn of(items: &'a [T]) -> Rows<'a, T> {
        Rows { items, table: Table { rows: vec![Vec::new(); items.len()], ..Table::default() } }
    }

    /// Adds a column of words.
    pub fn words(&mut self, title: &str, cell: impl Fn(&T) -> String) {
        self.column(Column::words(title), cell);
    }

    /// Adds a column of numbers with their unit.
    pub fn numbers(&mut self, title: &str, unit: &str, cell: impl Fn(&T) -> String) {
        self.column(Column::numbers(title, unit), cell);
    }

    fn column(&mut self, column: Column, cell: impl Fn(&T) -> String) {
        for (row, item) in self.table.rows.iter_mut().zip(self.items) {
            row.push(cell(item));
        }
        self.table.columns.push(column);
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let table = match System::current() {
            System::Si => std::borrow::Cow::Borrowed(self),
            system => std::borrow::Cow::Owned(self.converted(system)),
        };
        let mut out = serializer.serialize_struct("Table", 3)?;
        out.serialize_field("caption", &table.caption)?;
        out.serialize_field("columns", &table.columns)?;
        out.serialize_field("rows", &table.rows)?;
        out.end()
    }
}

impl Table {
    /// The table with its columns of SI units in those of `system`: for columns whose unit is written down, not chosen
    /// by [`crate::number::Scale`]. Where a column of words holds the units of its rows, row by row.
    #[must_use]
    pub fn converted(&self, system: System) -> Table {
        let mut out = self.clone();
        for c in 0..self.columns.len() {
            let column = &self.columns[c];
            // A head may name its unit itself, `z [m]`.
            let head = column.title.strip_suffix(']').and_then(|t| t.rsplit_once(" ["));
            let written = match head {
                Some((_, symbol)) if column.unit.is_empty() => symbol,
                _ => &column.unit,
            };
            let Some(unit) = si(written) else { continue };
            let values = || self.rows.iter().filter_map(|r| value(r.get(c)?)).map(|v| v * unit.factor());
            let to = System::Us.column_unit(values(), unit.dimension);
            for row in &mut out.rows {
                if let Some(cell) = row.get_mut(c) {
                    change(cell, unit, to, system);
                }
            }
            let shown = symbol(unit, to, system);
            match head {
                Some((title, _)) if column.unit.is_empty() => out.columns[c].title = format!("{title} [{shown}]"),
                _ => out.columns[c].unit = shown,
            }
        }
        let of_units = |c: &Column| !c.numeric && c.unit.is_empty() && c.title == "Unit";
        if let Some(at) = self.columns.iter().position(of_units) {
            for row in &mut out.rows {
                let Some(unit) = row.get(at).and_then(|u| si(u)) else { continue };
                let numeric = |c: usize| self.columns.get(c).is_some_and(|c| c.numeric && c.unit.is_empty());
                let values = row.iter().enumerate().filter(|(c, _)| numeric(*c)).filter_map(|(_, v)| value(v));
                let to = System::Us.column_unit(values.map(|v| v * unit.factor()), unit.dimension);
                for (c, cell) in row.iter_mut().enumerate() {
                    if numeric(c) {
                        change(cell, unit, to, system);
                    }
                }
                row[at] = symbol(unit, to, system);
            }
        }
        out
    }
}

/// The unit of SI with this symbol that other systems print otherwise.
fn si(symbol: &str) -> Option<&'static Unit> {
    let mut units = Dimension::ALL.into_iter().filter(|d| System::Us.differs(*d));
    let of = |d: Dimension| d.units().find(|u| u.symbol == symbol && u.is_power_of_ten());
    units.find_map(of).filter(|u| u.symbol != "g")
}

/// A cell as a number.
fn value(cell: &str) -> Option<f64> {
    let plain: String = cell.chars().filter(|c| *c != '\u{202f}').collect();
    plain.replace('−', "-").parse().ok()
}

/// A cell in another unit, with digits for what it had.
fn change(cell: &mut String, from: &Unit, to: &Unit, system: System) {
    let Some(number) = value(cell) else { return };
    let decimals = cell.split_once('.').map_or(0, |(_, d)| d.len()) as i32;
    let step = in_unit(from.factor(), to);
    // A step of the last digit stays one.
    let more = (-step.log10()).ceil() as i32;
    let converted = fixed(number * step, (decimals + more).clamp(0, 9) as usize);
    match system {
        System::Both => cell.push_str(&format!(" ({converted})")),
        System::Si | System::Us => *cell = converted,
    }
}

fn symbol(from: &Unit, to: &Unit, system: System) -> String {
    match system {
        System::Both => format!("{} ({})", from.symbol, to.symbol),
        System::Si | System::Us => to.symbol.into(),
    }
}

/// At most `count` indices of `0..len`, evenly spread, with the first and the last.
pub fn spread(len: usize, count: usize) -> Vec<usize> {
    if len <= count {
        return (0..len).collect();
    }
    (0..count).map(|i| i * (len - 1) / (count - 1).max(1)).collect()
}

/// As [`spread`] for the rows of `columns`, with the rows of the smallest and the largest value of each besides.
pub fn spread_with_extremes(len: usize, count: usize, columns: &[&[f64]]) -> Vec<usize> {
    let mut rows = spread(len, count);
    for column in columns {
        let column = &column[..len.min(column.len())];
        let finite = || (0..column.len()).filter(|&i| column[i].is_finite());
        let order = |a: &usize, b: &usize| column[*a].total_cmp(&column[*b]);
        rows.extend(finite().min_by(order));
        rows.extend(finite().max_by(order));
    }
    rows.sort_unstable();
    rows.dedup();
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Thinning 3509 samples keeps a single peak in the table of the figure.
    #[test]
    fn extremes_stay_in_thinned_rows() {
        let mut values = vec![0.0; 3509];
        (values[1234], values[2345], values[7]) = (4.38, -1.5, f64::NAN);
        let rows = spread_with_extremes(values.len(), 24, &[&values, &[1.0, 2.0, 0.5]]);
        for row in [0, 1, 2, 1234, 2345, 3508] {
            assert!(rows.contains(&row), "{row}");
        }
        assert!(rows.len() <= 24 + 4 && rows.windows(2).all(|w| w[0] < w[1]));
        assert!(spread_with_extremes(0, 24, &[&[]]).is_empty());
    }

    /// 1 ft = 0.3048 m, 1 in = 25.4 mm.
    #[test]
    fn written_units_follow_the_system() {
        let mut table =
            Table::new(vec![Column::numbers("z", "m"), Column::numbers("w", "mm"), Column::numbers("n", "")]);
        table.row(vec!["3.048".into(), "25.40".into(), "7".into()]);
        table.row(vec!["0.000".into(), "–".into(), "8".into()]);
        let us = table.converted(System::Us);
        assert_eq!((us.columns[0].unit.as_str(), us.columns[1].unit.as_str()), ("ft", "in"));
        assert_eq!(us.rows, [["10.000", "1.0000", "7"], ["0.000", "–", "8"]]);
        let both = table.converted(System::Both);
        assert_eq!(both.columns[0].unit, "m (ft)");
        assert_eq!(both.rows[0][1], "25.40 (1.0000)");
        let mut named = Table::new(vec![Column::words("z [m]")]);
        named.row(vec!["3.048".into()]);
        let us = named.converted(System::Us);
        assert_eq!((us.columns[0].title.as_str(), us.rows[0][0].as_str()), ("z [ft]", "10.000"));
    }

    #[test]
    fn rows_with_their_own_units() {
        let mut table = Table::new(vec![Column::words("Measure"), Column::words("Unit"), Column::numbers("a", "")]);
        table.row(vec!["x".into(), "m/s²".into(), "3.048".into()]);
        table.row(vec!["x".into(), "g".into(), "0.5".into()]);
        assert_eq!(table.converted(System::Us).rows, [["x", "ft/s²", "10.000"], ["x", "g", "0.5"]]);
    }
}
