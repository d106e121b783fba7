//! Separators of columns, and the cells of a line.

use super::number::split_glued;

/// Separator of the columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Semicolon,
    Comma,
    Tab,
    Spaces,
}

impl Separator {
    /// Decides by a line of numbers.
    pub(super) fn of(line: &str) -> Separator {
        if line.contains(';') {
            Separator::Semicolon
        } else if line.trim().contains('\t') {
            Separator::Tab
        } else if line.contains(',') && !decimal_commas(line) {
            Separator::Comma
        } else {
            Separator::Spaces
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Separator::Semicolon => "`;`",
            Separator::Comma => "`,`",
            Separator::Tab => "tabs",
            Separator::Spaces => "spaces",
        }
    }

    /// Cells and the byte at which each begins. Empty cells at both ends, with which spreadsheets pad, are left out.
    pub(super) fn cells<'a>(self, line: &'a str) -> Vec<(usize, &'a str)> {
        let place = |cell: &'a str| {
            let bare = cell.trim();
            let start = bare.as_ptr() as usize - line.as_ptr() as usize;
            match bare.strip_prefix('"').and_then(|c| c.strip_suffix('"')) {
                Some(inner) => (start + 1, inner.trim()),
                None => (start, bare),
            }
        };
        let cells: Vec<(usize, &str)> = match self {
            Separator::Semicolon => line.split(';').map(place).collect(),
            Separator::Comma => line.split(',').map(place).collect(),
            Separator::Tab => line.trim().split('\t').filter(|c| !c.trim().is_empty()).map(place).collect(),
            Separator::Spaces => return line.split_whitespace().map(place).flat_map(unglued).collect(),
        };
        let first = cells.iter().position(|c| !c.1.is_empty());
        let last = cells.iter().rposition(|c| !c.1.is_empty());
        match first.zip(last) {
            Some((first, last)) => cells[first..=last].to_vec(),
            None => Vec::new(),
        }
    }
}

/// Fields of fixed width that touch: each of them has a point.
fn unglued((start, cell): (usize, &str)) -> Vec<(usize, &str)> {
    let parts = split_glued(cell);
    match parts.iter().all(|(_, part)| part.contains('.')) {
        true => parts.into_iter().map(|(at, part)| (start + at, part)).collect(),
        false => vec![(start, cell)],
    }
}

/// Whether spaces separate numbers whose decimal mark is a comma: `0,00 -0,0123`.
fn decimal_commas(line: &str) -> bool {
    let words: Vec<&str> = line.split_whitespace().collect();
    let decimal = |word: &str| {
        let mut parts = word.split(',');
        let (whole, fraction) = (parts.next().unwrap_or(""), parts.next().unwrap_or(""));
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        digit(whole.chars().next_back()) && digit(fraction.chars().next()) && parts.next().is_none()
    };
    words.len() > 1 && words.iter().all(|w| !w.contains(',') || decimal(w))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_of_lines() {
        for (line, separator, cells) in [
            ("0.0,0.1,,", Separator::Comma, &["0.0", "0.1"][..]),
            (",,,", Separator::Comma, &[]),
            ("0,0;0,1;", Separator::Semicolon, &["0,0", "0,1"]),
            ("0,00  -0,0123", Separator::Spaces, &["0,00", "-0,0123"]),
            ("0, 0.1", Separator::Comma, &["0", "0.1"]),
            (" 123.45678-123.45678", Separator::Spaces, &["123.45678", "-123.45678"]),
            ("-.1E-02-.2E-02", Separator::Spaces, &["-.1E-02", "-.2E-02"]),
            ("2020-01-01 1", Separator::Spaces, &["2020-01-01", "1"]),
        ] {
            assert_eq!(Separator::of(line), separator, "{line}");
            let found: Vec<&str> = separator.cells(line).iter().map(|c| c.1).collect();
            assert_eq!(found, cells, "{line}");
        }
    }
}
