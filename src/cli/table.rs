//! Plain tables for the terminal.

use files::text;
use report;

/// A table with one head row; the first column is left-aligned, all others right-aligned.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these column heads.
    pub(crate) fn new(head: impl IntoIterator<Item = impl Into<String>>) -> Table {
        let mut table = Table::default();
        table.row(head);
        table
    }

    /// A table of the report, units in its heads.
    pub(crate) fn of(data: &report::table::Table) -> Table {
        let head = data.columns.iter().map(|c| match c.unit.as_str() {
            "" => c.title.clone(),
            unit => format!("{} [{unit}]", c.title),
        });
        let mut table = Table::new(head);
        for row in &data.rows {
            table.row(row.iter().map(String::as_str));
        }
        table
    }

    /// The transposed table: one line per column of the report's table.
    pub(crate) fn turned(data: &report::table::Table) -> Table {
        let line = |c: usize| {
            let column = &data.columns[c];
            let head = match column.unit.as_str() {
                "" => column.title.clone(),
                unit => format!("{} [{unit}]", column.title),
            };
            let cells = data.rows.iter().map(move |row| row.get(c).cloned().unwrap_or_default());
            std::iter::once(head).chain(cells).collect::<Vec<String>>()
        };
        let mut table = Table::default();
        for cells in (0..data.columns.len()).map(line) {
            table.row(cells);
        }
        table
    }

    /// Adds a row; every cell is one line, with the user's text escaped.
    pub(crate) fn row(&mut self, cells: impl IntoIterator<Item = impl Into<String>>) {
        let cells = cells.into_iter().map(|cell| {
            let cell: String = cell.into();
            text::line(&cell).into_owned()
        });
        self.rows.push(cells.collect());
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |c: usize| {
            self.rows
                .iter()
                .filter_map(|r| r.get(c))
                .map(|s| s.chars().count())
                .max()
                .unwrap_or(0)
        };
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for (i, row) in self.rows.iter().enumerate() {
            let mut line = String::new();
            for (c, cell) in row.iter().enumerate() {
                let pad = " ".repeat(widths[c] - cell.chars().count());
                if c == 0 {
                    line.push_str(cell);
                    line.push_str(&pad);
                } else {
                    line.push_str("  ");
                    line.push_str(&pad);
                    line.push_str(cell);
                }
            }
            writeln!(f, "{}", line.trim_end())?;
            if i == 0 {
                let total = widths.iter().sum::<usize>() + 2 * columns.saturating_sub(1);
                writeln!(f, "{}", "─".repeat(total))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let mut table = Table::new(["quantity", "fe"]);
        table.row(["T", "2.1 s"]);
        assert_eq!(table.to_string(), "quantity     fe\n───────────────\nT         2.1 s\n");
    }

    #[test]
    fn columns_become_lines() {
        use report::table::{Column, Table as Data};
        let mut data = Data::new(vec![Column::words("tank"), Column::numbers("T", "s")]);
        data.row(vec!["a".into(), "2.1".into()]);
        assert_eq!(Table::turned(&data).to_string(), "tank     a\n──────────\nT [s]  2.1\n");
    }
}
