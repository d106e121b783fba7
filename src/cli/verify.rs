//! `tankcheck verify`: the self-test.

use serde_json::json;

use crate::cli::table::Table;
use crate::cli::{Format, Global, json, print};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::selftest::{ROWS, Row};
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
    if args.list {
        print(&list(args.format)?)?;
        return Ok(EXIT_OK);
    }
    let spinner = super::spinner(global, "self-test");
    let found: Vec<Found> = ROWS.iter().map(Found::of).collect();
    spinner.finish_and_clear();
    print(&match args.format {
        Format::Json => json(&found.iter().map(Found::json).collect::<Vec<_>>())?,
        Format::Csv => csv(&found),
        Format::Human => human(&found),
    })?;
    Ok(if found.iter().all(Found::holds) {
        EXIT_OK
    } else {
        EXIT_CHECK_FAILED
    })
}

/// A row that ran.
struct Found {
    row: &'static Row,
    computed: Result<f64, String>,
}

impl Found {
    fn of(row: &'static Row) -> Found {
        let computed = (row.compute)().map_err(|error| error.to_string());
        let finite = computed.and_then(|value| match value.is_finite() {
            true => Ok(value),
            false => Err("the value is not finite".into()),
        });
        Found { row, computed: finite }
    }

    fn holds(&self) -> bool {
        self.computed.as_ref().is_ok_and(|&value| self.row.holds(value))
    }

    fn json(&self) -> serde_json::Value {
        let value = self.computed.as_ref().ok();
        let mut row = described(self.row);
        row["computed"] = json!(value);
        row["error"] = json!(value.map(|&value| self.row.error(value)));
        row["holds"] = json!(self.holds());
        row["failure"] = json!(self.computed.as_ref().err());
        row
    }
}

fn described(row: &Row) -> serde_json::Value {
    json!({
        "id": row.id, "what": row.what, "reference": row.reference, "unit": row.unit, "tolerance": row.tolerance,
        "reference_source": row.source,
    })
}

/// The rows without values.
fn list(format: Format) -> Result<String, Error> {
    let text = match format {
        Format::Json => return json(&ROWS.iter().map(described).collect::<Vec<_>>()),
        Format::Csv => ROWS
            .iter()
            .map(|r| {
                format!(
                    "{},\"{}\",{:e},{},{:e},\"{}\"\n",
                    r.id, r.what, r.reference, r.unit, r.tolerance, r.source
                )
            })
            .fold("id,what,reference,unit,tolerance,source\n".to_owned(), |text, line| {
                text + &line
            }),
        Format::Human => ROWS
            .iter()
            .map(|r| format!("{}: {}\n    {}\n", r.id, r.what, r.source))
            .collect(),
    };
    Ok(text)
}

fn human(found: &[Found]) -> String {
    let mut table = Table::new(["", "what", "reference", "computed", "error", "tolerance", ""]);
    for Found { row, computed } in found {
        let unit = if row.unit == "1" { "" } else { row.unit };
        let percent = |share: f64| format!("{:.1e}", share);
        let (value, error, state) = match computed {
            Ok(value) if row.holds(*value) => (significant(*value, 6), percent(row.error(*value)), "ok".to_owned()),
            Ok(value) => (significant(*value, 6), percent(row.error(*value)), "OUTSIDE".to_owned()),
            Err(why) => ("none".to_owned(), "–".to_owned(), format!("OUTSIDE: {why}")),
        };
        let reference = format!("{} {unit}", significant(row.reference, 6))
            .trim_end()
            .to_owned();
        table.row([
            row.id.to_owned(),
            row.what.to_owned(),
            reference,
            value,
            error,
            percent(row.tolerance),
            state,
        ]);
    }
    let outside = found.iter().filter(|found| !found.holds()).count();
    format!(
        "{table}\n{} rows, {outside} outside their tolerance; the whole manual: cargo run --release -p verification\n",
        found.len()
    )
}

fn csv(found: &[Found]) -> String {
    let mut text = String::from("id,what,reference,computed,error,tolerance,unit,holds\n");
    for Found { row, computed } in found {
        let [value, error] = match computed {
            Ok(value) => [format!("{value:e}"), format!("{:e}", row.error(*value))],
            Err(_) => [String::new(), String::new()],
        };
        let holds = computed.as_ref().is_ok_and(|&value| row.holds(value));
        text.push_str(&format!(
            "{},\"{}\",{:e},{value},{error},{:e},{},{holds}\n",
            row.id, row.what, row.reference, row.tolerance, row.unit
        ));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(value: fn() -> crate::selftest::Answer) -> &'static Row {
        Box::leak(Box::new(Row {
            id: "a",
            what: "b",
            source: "by hand",
            reference: -2.0,
            tolerance: 0.01,
            unit: "m",
            compute: value,
        }))
    }

    #[test]
    fn a_value_outside_and_a_model_without_an_answer_do_not_hold() {
        let rows: [(fn() -> crate::selftest::Answer, bool, &str); 4] = [
            (|| Ok(-2.019), true, " ok\n"),
            (|| Ok(-2.021), false, " OUTSIDE\n"),
            (|| Err("singular".into()), false, "OUTSIDE: singular\n"),
            (|| Ok(f64::NAN), false, "OUTSIDE: the value is not finite\n"),
        ];
        for (value, holds, text) in rows {
            let found = [Found::of(row(value))];
            assert_eq!(found[0].holds(), holds, "{text}");
            assert!(human(&found).contains(text), "{}", human(&found));
            assert_eq!(found[0].json()["holds"], holds);
            assert!(csv(&found).ends_with(&format!(",m,{holds}\n")), "{}", csv(&found));
        }
    }
}
