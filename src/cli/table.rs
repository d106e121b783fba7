//! Plain tables for the terminal.

use files::text;
use report;

/// How a row stands out: a sign before it, and its colour on a terminal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Mark {
    /// It does not.
    #[default]
    None,
    /// It fails.
    Fails,
    /// It was not checked, though required.
    Open,
}

impl Mark {
    /// The sign, one column wide; also where there are no colours.
    pub(crate) fn sign(self) -> char {
        match self {
            Mark::None => ' ',
            Mark::Fails => '✗',
            Mark::Open => '?',
        }
    }
}

/// A row of cells.
#[derive(Clone, Debug, Default)]
struct Row {
    cells: Vec<String>,
    mark: Mark,
}

/// A table with one head row; the first column is left-aligned, all others right-aligned.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    rows: Vec<Row>,
    /// Widest line [characters]; none where the output is not a terminal.
    limit: Option<usize>,
    /// Whether the last column is words, which go under their row where the table is too wide.
    last_is_words: bool,
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
        self.marked(Mark::None, cells);
    }

    /// Adds a row that stands out.
    pub(crate) fn marked(&mut self, mark: Mark, cells: impl IntoIterator<Item = impl Into<String>>) {
        let cells = cells.into_iter().map(|cell| {
            let cell: String = cell.into();
            text::line(&cell).into_owned()
        });
        let cells = cells.collect();
        self.rows.push(Row { cells, mark });
    }

    /// The table in lines of at most `limit` characters, as far as its first column leaves room: columns that have none follow in a
    /// further table with the first column again.
    pub(crate) fn fitted(mut self, limit: Option<usize>) -> Table {
        self.limit = limit;
        self
    }

    /// The last column is words: where there is no room for it, its cells follow below their rows.
    pub(crate) fn with_words(mut self) -> Table {
        self.last_is_words = true;
        self
    }

    fn columns(&self) -> usize {
        self.rows.iter().map(|row| row.cells.len()).max().unwrap_or(0)
    }

    fn width(&self, column: usize) -> usize {
        let cells = self.rows.iter().filter_map(|row| row.cells.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    }

    /// The columns of each part, the first always with them.
    fn parts(&self, columns: usize, room: usize) -> Vec<Vec<usize>> {
        let mut parts = Vec::new();
        let mut part = vec![0];
        let mut wide = self.width(0);
        for column in 1..columns {
            let more = GAP.len() + self.width(column);
            if part.len() > 1 && wide + more > room {
                parts.push(std::mem::replace(&mut part, vec![0]));
                wide = self.width(0);
            }
            part.push(column);
            wide += more;
        }
        parts.push(part);
        parts
    }
}

/// Between two columns.
const GAP: &str = "  ";

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let marks = self.rows.iter().any(|row| row.mark != Mark::None);
        let signs = if marks { 2 } else { 0 };
        let room = self.limit.map_or(usize::MAX, |limit| limit.saturating_sub(signs));
        let all = self.columns();
        let whole = (0..all).map(|c| self.width(c)).sum::<usize>() + GAP.len() * all.saturating_sub(1);
        let below = self.last_is_words && all > 2 && whole > room;
        let columns = if below { all - 1 } else { all };
        for (number, part) in self.parts(columns, room).iter().enumerate() {
            if number > 0 {
                writeln!(f)?;
            }
            let total = part.iter().map(|&c| self.width(c)).sum::<usize>() + GAP.len() * (part.len() - 1);
            for (i, row) in self.rows.iter().enumerate() {
                let mut line = String::new();
                if marks {
                    line.push(row.mark.sign());
                    line.push(' ');
                }
                for &c in part {
                    let cell = row.cells.get(c).map_or("", String::as_str);
                    let pad = " ".repeat(self.width(c) - cell.chars().count());
                    if c == 0 {
                        line.push_str(cell);
                        line.push_str(&pad);
                    } else {
                        line.push_str(GAP);
                        line.push_str(&pad);
                        line.push_str(cell);
                    }
                }
                writeln!(f, "{}", line.trim_end())?;
                if i == 0 {
                    writeln!(f, "{}", "─".repeat(total + signs))?;
                }
                let words = row.cells.get(all - 1).filter(|words| below && i > 0 && !words.is_empty());
                if let Some(words) = words {
                    writeln!(f, "{}    {words}", " ".repeat(signs))?;
                }
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

    fn checks() -> Table {
        let mut table = Table::new(["check", "ratio", "where"]);
        table.marked(Mark::Fails, ["buckling", "1.2", "z = 0 m"]);
        table.marked(Mark::Open, ["pipes", "–", ""]);
        table.row(["hoop", "0.5", "z = 3 m"]);
        table.with_words()
    }

    #[test]
    fn failing_rows_have_a_sign() {
        let text = checks().to_string();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "  check     ratio    where");
        assert_eq!(lines[2], "✗ buckling    1.2  z = 0 m");
        assert_eq!(lines[3], "? pipes         –");
        assert_eq!(lines[4], "  hoop        0.5  z = 3 m");
        // Without marks there is no room for signs.
        let mut plain = Table::new(["check"]);
        plain.row(["hoop"]);
        assert!(plain.to_string().starts_with("check\n"));
    }

    #[test]
    fn words_that_have_no_room_go_below_their_row() {
        let text = checks().fitted(Some(20)).to_string();
        assert!(text.contains("✗ buckling    1.2\n      z = 0 m\n? pipes         –\n  hoop"), "{text}");
        assert!(text.lines().all(|line| line.chars().count() <= 20), "{text}");
    }

    #[test]
    fn columns_that_have_no_room_follow_with_the_first_one() {
        let mut table = Table::new(["quantity", "housner", "ec8-2006", "fe"]);
        table.row(["T [s]", "2.1", "2.2", "2.3"]);
        let text = table.fitted(Some(23)).to_string();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "quantity  housner");
        assert_eq!(lines[4], "quantity  ec8-2006   fe");
        assert_eq!(lines[6], "T [s]          2.2  2.3");
    }
}
