//! `--select`: which parts of the results are printed as JSON.
//!
//! `verdict`, `quantities` and `checks` are short forms, one line an item, for scripts that read a handful of numbers; the others are parts of
//! `results.json` as they stand there. What no selected part needs is not computed where nothing else is written of it ([`SelectArg::needless`]).

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};
use tank::assessment::{Check, CheckStatus};

use crate::cli::{Format, json as whole};
use crate::error::Error;
use files::code::Code;
use files::text;
use report::words;
use results::{Method, Omittable, Overruled, Results, finite};

/// Everything, as in `results.json`.
const ALL: &str = "all";
/// The short forms.
const SHORT: [&str; 3] = ["verdict", "quantities", "checks"];
/// Parts of `results.json`.
const PARTS: [&str; 14] = [
    "files",
    "input",
    "project",
    "tank",
    "records",
    "record_set",
    "spectra",
    "methods",
    "runs",
    "parts",
    "comparison",
    "warnings",
    "volatile",
    "not_computed",
];
/// Parts that are the same in a run without envelopes, histories and further grounds.
const LIGHT: [&str; 11] = [
    "verdict",
    "quantities",
    "checks",
    "files",
    "input",
    "project",
    "tank",
    "records",
    "warnings",
    "volatile",
    "not_computed",
];
/// The one of these that counts what holds within the mesh error.
const WITH_ERROR: &str = "verdict";
/// Format of what is printed.
const FORMAT: &str = "tankcheck-summary/1";

/// The option.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct SelectArg {
    /// Parts of the JSON, separated by commas: verdict, quantities, checks (short forms), any part of results.json, or all.
    #[arg(long, value_delimiter = ',', value_name = "PART")]
    pub select: Vec<String>,
}

impl SelectArg {
    /// Whether parts are named.
    pub(crate) fn is_given(&self) -> bool {
        !self.select.is_empty()
    }

    /// Rejects faults of the option before anything is computed.
    ///
    /// Errors: an unknown part; a form of the output other than JSON.
    pub(crate) fn admit(&self, format: Format) -> Result<(), Error> {
        if self.is_given() && format != Format::Json {
            return Err(Error::conflict("--select: parts are selected of --format json\n  help: add --format json"));
        }
        let known = || SHORT.into_iter().chain(PARTS).chain([ALL]);
        match self.select.iter().find(|part| !known().any(|k| k == part.trim())) {
            None => Ok(()),
            Some(unknown) => Err(Error::input(
                Code::UnknownId,
                format!(
                    "--select: found `{}`, expected parts of {}",
                    text::line(unknown),
                    known().collect::<Vec<_>>().join(", ")
                ),
            )),
        }
    }

    /// What of a run none of the named parts needs; nothing where no part is named. All short forms are the same without it.
    pub(crate) fn needless(&self) -> Vec<Omittable> {
        let mut wanted = self.select.iter().map(|part| part.trim());
        if !self.is_given() || wanted.clone().any(|part| !LIGHT.contains(&part)) {
            return Vec::new();
        }
        let mut parts = vec![Omittable::Envelopes, Omittable::Histories, Omittable::Grounds];
        if wanted.all(|part| part != WITH_ERROR) {
            parts.push(Omittable::MeshError);
        }
        parts
    }

    /// The JSON of the named parts, or of `usual`.
    ///
    /// Errors: a number that is not finite.
    pub(crate) fn json(&self, results: &Results, usual: &[&str]) -> Result<String, Error> {
        let wanted: Vec<&str> = match self.is_given() {
            true => self.select.iter().map(|part| part.trim()).collect(),
            false => usual.to_vec(),
        };
        if wanted == [ALL] {
            return whole(results);
        }
        finite::check("the result", results)?;
        let value = serde_json::to_value(results).map_err(|e| Error::report(e.to_string()))?;
        let mut parts = match value {
            Value::Object(parts) => parts,
            _ => Map::new(),
        };
        let mut lines = vec![line("format", &json!(FORMAT)), line("name", &json!(results.name))];
        for part in wanted {
            lines.push(match part {
                "verdict" => line(part, &verdict(results)),
                "quantities" => items(part, &quantities(results)),
                "checks" => checks(results),
                "warnings" => line(part, &json!(results.warnings)),
                // A part that these results do not have is null.
                other => line(other, &parts.remove(other).unwrap_or_default()),
            });
        }
        Ok(format!("{{\n{}\n}}\n", text::json(&lines.join(",\n"))))
    }
}

fn line(key: &str, value: &Value) -> String {
    format!("  {}: {value}", json!(key))
}

fn items(key: &str, items: &[Value]) -> String {
    let lines: Vec<String> = items.iter().map(|item| format!("    {item}")).collect();
    format!("  {}: [\n{}\n  ]", json!(key), lines.join(",\n"))
}

/// Method and excitation, as a key.
fn column(method: &Method) -> String {
    format!("{}/{}", method.id, method.excitation.word())
}

/// Six digits: what a script compares, and what a line has room for.
fn short(value: f64) -> Value {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    json!(rounded)
}

fn verdict(results: &Results) -> Value {
    let verdict = &results.verdict;
    let deciding: Vec<String> =
        verdict.deciding.iter().map(|d| format!("{}/{}", d.method, d.excitation.word())).collect();
    let missing: Vec<&str> = verdict.missing.iter().map(|m| m.check.limit_state.as_str()).collect();
    let governing = verdict.governing.as_ref().map(|g| {
        json!({
            "method": g.method,
            "check": g.check.id,
            "status": g.check.status,
            "utilisation": g.check.utilisation.map(short),
        })
    });
    let gap = |gap: &results::Governing| {
        let approval = gap.check.accepted.as_ref();
        json!({
            "method": gap.method,
            "check": gap.check.limit_state,
            "by": approval.map(|a| &a.by),
            "date": approval.map(|a| &a.date),
            "reason": gap.check.reason,
        })
    };
    let overruled = |code: &Overruled| {
        json!({
            "method": code.method,
            "fails": code.checks.counts.fails,
            "not_checked": code.checks.counts.not_checked,
        })
    };
    json!({
        "status": verdict.status,
        "headline": words::verdict::headline(verdict),
        "accepted": verdict.accepted.iter().map(gap).collect::<Vec<_>>(),
        "deciding": deciding,
        "counts": verdict.counts,
        "governing": governing,
        "unstated": verdict.unstated,
        "overruled": verdict.overruled.iter().map(overruled).collect::<Vec<_>>(),
        "not_checked": missing,
        "unfinished": verdict.unfinished,
    })
}

/// Each quantity with the values of all methods.
fn quantities(results: &Results) -> Vec<Value> {
    let mut found: BTreeMap<&str, (&str, Map<String, Value>)> = BTreeMap::new();
    for method in &results.methods {
        for (id, value) in &method.quantities {
            let unit = value.dimension.si_symbol();
            let (_, values) = found.entry(id).or_insert_with(|| (unit, Map::new()));
            values.insert(column(method), short(value.value));
        }
    }
    let one =
        |(id, (unit, values)): (&str, (&str, Map<String, Value>))| json!({ "id": id, "unit": unit, "values": values });
    found.into_iter().map(one).collect()
}

/// The checks of the deciding methods, of all methods where none decides; what is not required is left out.
fn checks(results: &Results) -> String {
    let decides = |m: &&Method| results.verdict.decides(m);
    let any = results.methods.iter().any(|m| decides(&m) && !m.checks.is_empty());
    let methods = results.methods.iter().filter(|m| !any || decides(m)).filter(|m| !m.checks.is_empty());
    let one =
        |check: &Check| json!({ "id": check.id, "status": check.status, "utilisation": check.utilisation.map(short) });
    let of = |method: &Method| {
        let required = method.checks.iter().filter(|c| c.status != CheckStatus::NotApplicable);
        let lines: Vec<String> = required.map(|check| format!("      {}", one(check))).collect();
        format!("    {}: [\n{}\n    ]", json!(column(method)), lines.join(",\n"))
    };
    let blocks: Vec<String> = methods.map(of).collect();
    format!("  \"checks\": {{\n{}\n  }}", blocks.join(",\n"))
}

/// What `check` prints.
pub(crate) const USUAL: [&str; 4] = ["verdict", "quantities", "checks", "warnings"];
/// What `compare` prints.
pub(crate) const WHOLE: [&str; 1] = [ALL];
