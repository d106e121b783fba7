//! A tank file with some values from a row of a table.
//!
//! Values from the table have places beyond the end of the tank file, so that the faults of the reader are found in the table again.

use files::code::Code;
use std::ops::Range;

use super::stated::NONE;
use super::syntax::{self, Kind, Member, Node, join};
use super::{TankFile, resolved};
use crate::input::csv::{self, Cell, Table};
use crate::input::diagnostic::{Fault, Faults};

/// A step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Key(String),
    Index(usize),
}

/// A cell that removes the key of its column from the tank of its row, with everything below it.
pub(crate) const REMOVES: &str = "null";

/// The tank of a row: the tank file with the values of the row. An empty cell keeps the value of the file, `null` removes it.
///
/// * `base`: the tank file
/// * `row`: a row of the table
///
/// Errors: the faults of the tank, at their places in the table: those of a value at its cell, those of a name at its column,
/// all others at the row.
pub fn variant(base: &TankFile, table: &Table, row: &[Cell]) -> Result<TankFile, Faults> {
    let mut faults = Faults::new();
    let beyond = base.source.text.len() + 1;
    let place = |span: &Range<usize>| span.start + beyond..span.end + beyond;
    let file = syntax::parse(&base.source, &mut faults).and_then(|mut root| {
        for (column, cell) in table.head.iter().zip(row).filter(|(_, cell)| !cell.text.is_empty()) {
            let Some(steps) = steps(&column.text) else {
                faults.push(unknown(column, "not a path").at(place(&column.span)));
                continue;
            };
            if cell.text == REMOVES {
                if let Err(message) = remove(&mut root, &steps) {
                    faults.push(unknown(column, message).at(place(&column.span)));
                }
                continue;
            }
            if let Err(message) = set(&mut root, &steps, cell, &place(&column.span), place(&cell.span)) {
                faults.push(unknown(column, &message).at(place(&column.span)));
            }
        }
        if faults.is_empty() { resolved(root, &base.source, &mut faults) } else { None }
    });
    match file {
        Some(file) if faults.is_empty() => {
            Ok(TankFile { source: base.source.clone(), sha256: base.sha256.clone(), ..file })
        }
        _ => {
            let mut found = Faults::new();
            for fault in faults.list() {
                let (span, own) = match &fault.span {
                    Some(span) if span.start >= beyond => (span.start - beyond..span.end - beyond, true),
                    _ => (csv::span(row), false),
                };
                let mut fault = fault.clone().at(span);
                if !own && fault.code == Code::DoesNotApply && fault.help.is_none() {
                    let help = format!(
                        "`{0}` is in the template; a column `{0}` with the cell {REMOVES} in this row removes it",
                        fault.path
                    );
                    fault = fault.help(help);
                }
                found.push(fault);
            }
            Err(found)
        }
    }
}

/// A column that is not a place of the tank file.
fn unknown(column: &Cell, message: &str) -> Fault {
    Fault::new(Code::TableColumn, format!("the path `{}`: {message}", column.text)).found(column.text.clone()).allowed(
        "a path of the tank file, such as tank.radius, tank.courses[0].thickness or materials[\"A 283\"].density",
    )
}

/// The steps of `tank.courses[0].thickness`; keys with other characters than letters, digits, `_` and `-` stand in `["…"]`.
pub(super) fn steps(path: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    let mut rest = path;
    while !rest.is_empty() {
        if let Some(inner) = rest.strip_prefix("[\"") {
            let (key, after) = inner.split_once("\"]")?;
            steps.push(Step::Key(key.to_owned()));
            rest = after;
        } else if let Some(inner) = rest.strip_prefix('[') {
            let (index, after) = inner.split_once(']')?;
            steps.push(Step::Index(index.parse().ok()?));
            rest = after;
        } else {
            let key = match (steps.is_empty(), rest.strip_prefix('.')) {
                (true, None) => rest,
                (false, Some(key)) => key,
                _ => return None,
            };
            let end = key.find(['.', '[']).unwrap_or(key.len());
            let (name, after) = key.split_at(end);
            if name.is_empty() {
                return None;
            }
            steps.push(Step::Key(name.to_owned()));
            rest = after;
        }
    }
    (!steps.is_empty()).then_some(steps)
}

/// Puts a value at a place of the tree; objects and keys that are missing are added.
fn set(node: &mut Node, steps: &[Step], cell: &Cell, head: &Range<usize>, place: Range<usize>) -> Result<(), String> {
    let (noun, path) = (node.noun(), node.path.clone());
    // A part that the template says is not there.
    if let (Some(Step::Key(_)), Kind::Text(word)) = (steps.first(), &node.kind)
        && word == NONE
    {
        node.kind = Kind::Object(Vec::new());
    }
    match (steps.split_first(), &mut node.kind) {
        (None, Kind::List(_) | Kind::Object(_)) => Err(format!("{noun}, expected one value")),
        (None, kind) => {
            *kind = value(&cell.text, kind);
            node.span = place;
            Ok(())
        }
        (Some((Step::Key(key), rest)), Kind::Object(members)) => {
            let known = members.iter().position(|m| m.key == *key);
            let member = match known {
                Some(known) => &mut members[known],
                None => {
                    members.push(Member {
                        key: key.clone(),
                        key_span: head.clone(),
                        value: Node {
                            span: head.clone(),
                            path: join(&path, key),
                            kind: match rest {
                                [] => Kind::Null,
                                _ => Kind::Object(Vec::new()),
                            },
                        },
                    });
                    let last = members.len() - 1;
                    &mut members[last]
                }
            };
            set(&mut member.value, rest, cell, head, place)
        }
        (Some((Step::Index(index), rest)), Kind::List(items)) => {
            let count = items.len();
            match items.get_mut(*index) {
                Some(item) => set(item, rest, cell, head, place),
                None => Err(format!("found index {index}, expected 0 to {}", count.saturating_sub(1))),
            }
        }
        (Some((Step::Key(key), _)), _) => Err(format!("{noun} does not have the key `{key}`")),
        (Some((Step::Index(index), _)), _) => Err(format!("{noun} does not have an item {index}")),
    }
}

/// Removes a key from the tree. A missing key is not a fault.
fn remove(node: &mut Node, steps: &[Step]) -> Result<(), &'static str> {
    match (steps, &mut node.kind) {
        ([Step::Key(key)], Kind::Object(members)) => {
            members.retain(|member| member.key != *key);
            Ok(())
        }
        ([Step::Key(key), rest @ ..], Kind::Object(members)) => match members.iter_mut().find(|m| m.key == *key) {
            Some(member) => remove(&mut member.value, rest),
            None => Ok(()),
        },
        ([Step::Index(index), rest @ ..], Kind::List(items)) if !rest.is_empty() => match items.get_mut(*index) {
            Some(item) => remove(item, rest),
            None => Ok(()),
        },
        _ => Err("only keys of objects can be removed"),
    }
}

/// The value of a cell in the place of another: a text stays a text, other values are numbers or true and false where they can be.
fn value(text: &str, before: &Kind) -> Kind {
    match (before, text) {
        (Kind::Text(_), _) => Kind::Text(text.to_owned()),
        (_, "true") => Kind::Bool(true),
        (_, "false") => Kind::Bool(false),
        _ if serde_json::from_str::<serde_json::Number>(text).is_ok() => Kind::Number(text.to_owned()),
        _ => Kind::Text(text.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths() {
        let key = |name: &str| Step::Key(name.into());
        assert_eq!(steps("name"), Some(vec![key("name")]));
        assert_eq!(
            steps("tank.courses[2].thickness"),
            Some(vec![key("tank"), key("courses"), Step::Index(2), key("thickness")])
        );
        assert_eq!(
            steps("materials[\"A 283 C\"].density"),
            Some(vec![key("materials"), key("A 283 C"), key("density")])
        );
        for wrong in ["", ".a", "a..b", "a[x]", "a[0", "a[0]b", "a["] {
            assert_eq!(steps(wrong), None, "{wrong}");
        }
    }
}
