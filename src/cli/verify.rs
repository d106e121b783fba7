//! `tankcheck verify`: the self-test.

use serde_json::{Value, json};

use crate::cli::table::Table;
use crate::cli::{Format, Global, show, spinner};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::selftest::{ROWS, Row};
use files::text::cell;
use tank::units::significant;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck verify
  tankcheck verify --list             the rows with the sources of their references, without running them
  tankcheck verify --format json

This is a self-test: a row or two for each code and engine. The whole verification, its manual (docs/verification) and the
options PATTERN, --slow, --records and --write belong to a program of the source: cargo run --release -p verification -- --help

Exit codes: 0 every row is within its tolerance; 1 a row is not.")]
pub(crate) struct Args {
    /// List the rows and run none.
    #[arg(long)]
    list: bool,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let watch = spinner(global, "self-test");
    let lines: Vec<Line> = ROWS.iter().map(|row| Line::of(row, !args.list)).collect();
    watch.finish_and_clear();
    let value = || lines.iter().map(Line::json).collect::<Vec<_>>();
    show(args.format, || human(&lines), value, || Ok(csv(&lines)))?;
    Ok(if lines.iter().any(Line::fails) { EXIT_CHECK_FAILED } else { EXIT_OK })
}

/// A row, and what it computed or why it did not; `None` if it was only listed.
struct Line {
    row: &'static Row,
    computed: Option<Result<f64, String>>,
}

impl Line {
    fn of(row: &'static Row, run: bool) -> Line {
        let computed = run.then(|| match (row.compute)() {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(value) => Err(format!("the value is {value}")),
            Err(error) => Err(error.to_string()),
        });
        Line { row, computed }
    }

    fn value(&self) -> Option<f64> {
        self.computed.as_ref()?.as_ref().ok().copied()
    }

    fn fails(&self) -> bool {
        self.computed.is_some() && !self.value().is_some_and(|value| self.row.holds(value))
    }

    /// `ok`, `OUTSIDE` with the reason of a row without a value, nothing for a row that did not run.
    fn state(&self) -> String {
        match &self.computed {
            None => String::new(),
            Some(Err(why)) => format!("OUTSIDE: {why}"),
            Some(Ok(_)) if self.fails() => "OUTSIDE".into(),
            Some(Ok(_)) => "ok".into(),
        }
    }

    fn json(&self) -> Value {
        let row = self.row;
        let mut out = json!({
            "id": row.id, "what": row.what, "reference": row.reference, "unit": row.unit, "tolerance": row.tolerance,
            "reference_source": row.source,
        });
        if let Some(computed) = &self.computed {
            out["computed"] = json!(self.value());
            out["error"] = json!(self.value().map(|value| row.error(value)));
            out["holds"] = json!(!self.fails());
            out["failure"] = json!(computed.as_ref().err());
        }
        out
    }
}

fn human(lines: &[Line]) -> String {
    let ran = lines.iter().any(|line| line.computed.is_some());
    let mut table = match ran {
        true => Table::new(["", "what", "reference", "computed", "error", "tolerance", ""]),
        false => Table::new(["", "what", "reference", "tolerance", "source"]),
    };
    for line in lines {
        let row = line.row;
        let with_unit = |value: f64| {
            let text = format!("{} {}", significant(value, 6), row.unit);
            text.trim_end_matches(" 1").to_owned()
        };
        let [id, what, source] = [row.id, row.what, row.source].map(str::to_owned);
        let (reference, tolerance) = (with_unit(row.reference), format!("{:.1e}", row.tolerance));
        if !ran {
            table.row([id, what, reference, tolerance, source]);
            continue;
        }
        let computed = line.value().map_or("none".into(), with_unit);
        let error = line.value().map_or("–".into(), |value| format!("{:.1e}", row.error(value)));
        table.row([id, what, reference, computed, error, tolerance, line.state()]);
    }
    let outside = lines.iter().filter(|line| line.fails()).count();
    let outcome = if ran { format!(", {outside} outside their tolerance") } else { String::new() };
    format!("{table}\n{} rows{outcome}; the whole manual: cargo run --release -p verification\n", lines.len())
}

fn csv(lines: &[Line]) -> String {
    let mut text = String::from("id,what,source,reference,unit,tolerance,computed,state\n");
    for line in lines {
        let Row { id, what, source, reference, unit, tolerance, .. } = line.row;
        let computed = line.value().map_or(String::new(), |value| format!("{value:e}"));
        let state = line.state();
        let [what, source, state] = [what, source, state.as_str()].map(cell);
        text.push_str(&format!("{id},{what},{source},{reference:e},{unit},{tolerance:e},{computed},{state}\n"));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selftest::Answer;

    fn row(compute: fn() -> Answer) -> &'static Row {
        Box::leak(Box::new(Row {
            id: "a",
            what: "b, c",
            source: "by hand",
            reference: -2.0,
            tolerance: 0.01,
            unit: "m",
            compute,
        }))
    }

    #[test]
    fn a_value_outside_and_a_model_without_an_answer_fail() {
        type Case = (fn() -> Answer, bool, &'static str);
        let rows: [Case; 4] = [
            (|| Ok(-2.019), false, "ok\n"),
            (|| Ok(-2.021), true, "OUTSIDE\n"),
            (|| Err("singular".into()), true, "OUTSIDE: singular\n"),
            (|| Ok(f64::NAN), true, "OUTSIDE: the value is NaN\n"),
        ];
        for (compute, fails, state) in rows {
            let lines = [Line::of(row(compute), true)];
            assert_eq!(lines[0].fails(), fails, "{state}");
            assert!(human(&lines).contains(state) && csv(&lines).ends_with(state), "{}", csv(&lines));
            assert_eq!(lines[0].json()["holds"], !fails);
            let listed = Line::of(row(compute), false);
            assert!(!listed.fails() && listed.json().get("holds").is_none());
        }
    }
}
