//! Tables as plain data: the templates give them their form.

use serde::Serialize;

/// A table with units in its head.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Table {
    /// Caption; empty where the surrounding text replaces it.
    pub caption: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, each with one text a column.
    pub rows: Vec<Vec<String>>,
}

/// Head of a column.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
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
        Column {
            title: title.into(),
            ..Column::default()
        }
    }

    /// A column of numbers with their unit.
    pub fn numbers(title: &str, unit: &str) -> Column {
        Column {
            title: title.into(),
            unit: unit.into(),
            numeric: true,
        }
    }
}

impl Table {
    /// An empty table with these columns.
    pub fn new(columns: Vec<Column>) -> Table {
        Table {
            columns,
            ..Table::default()
        }
    }

    /// Appends a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }
}

/// At most `count` indices of `0..len`, evenly spread, with the first and the last.
pub fn spread(len: usize, count: usize) -> Vec<usize> {
    if len <= count {
        return (0..len).collect();
    }
    (0..count).map(|i| i * (len - 1) / (count - 1).max(1)).collect()
}
