//! Comparison of two results folders, number by number.
//!
//! Keys, array lengths, units and text must be equal; numbers may differ by a tolerance relative to the *peak of their
//! group*, not to their own value: a stress envelope that crosses zero is compared at the scale of its peak. A group is
//!
//! * a numeric array (a spectrum, a profile, a column of `series.csv`),
//! * the `static_`, `min` and `max` arrays of one envelope together,
//! * one field over all modes.
//!
//! Times of maxima have an absolute tolerance of their own: two equal peaks may change places. Numbers inside text (the
//! substituted formulas of calculation sheets) are compared as numbers, at the precision they are printed with.
//! The `volatile` object is skipped. What one of both has not computed because it was not selected is left out of both, and named;
//! so are histories of which the old folder keeps no `series.csv`.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value;

use crate as results;
use crate::{LeftOut, Omittable, Results};
use files::error::Error;

/// Tolerances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative to the peak of the group.
    pub rtol: f64,
    /// For times of maxima [s].
    pub time_tolerance: f64,
}

impl Default for Options {
    /// 1e-6: the engine's results differ by about 1e-9 between processors (other vector widths, other order of sums),
    /// and no method is accurate to 1e-6.
    fn default() -> Self {
        Options { rtol: 1e-6, time_tolerance: 0.02 }
    }
}

/// Residuals below this are rounding, whatever their ratio.
const ROUNDING: f64 = 1e-8;

/// One difference.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Path in the results (`methods[2].quantities.base_shear.value`), or `series.csv:base_shear[17]`.
    pub path: String,
    /// Old value, as text.
    pub old: String,
    /// New value, as text.
    pub new: String,
    /// |new − old| relative to the group's peak; infinite for text, keys and lengths.
    pub change: f64,
}

/// Outcome of a comparison.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Values compared.
    pub compared: usize,
    /// Numbers that are not equal but within tolerance, and the largest of their changes.
    pub drifted: usize,
    /// Largest change among the drifted numbers.
    pub largest_drift: f64,
    /// Differences beyond the tolerance, largest first.
    pub moved: Vec<Difference>,
    /// Parts that one of both has not computed or does not keep.
    pub not_compared: Vec<LeftOut>,
}

/// Compares two results folders: those of `compare` and `check`, of `ida`, or of `push`.
pub fn folders(old: &Path, new: &Path, options: &Options) -> Result<Report, Error> {
    let as_value = |value: Result<Value, serde_json::Error>| value.map_err(|e| Error::Report(e.to_string()));
    // Either has them, or both lack them.
    let mut left_out: Vec<LeftOut> = Vec::new();
    for results in [compared(old)?, compared(new)?].iter().flatten() {
        let more = results.not_computed.iter().filter(|part| !left_out.contains(part));
        let more: Vec<LeftOut> = more.cloned().collect();
        left_out.extend(more);
    }
    let load = |folder: &Path| -> Result<Value, Error> {
        let file = |name: &str| Some(folder.join(name)).filter(|path| path.is_file());
        if let Some(path) = file(results::IDA_FILE) {
            let mut value = as_value(serde_json::to_value(results::read_ida(&path)?))?;
            // It follows from the files, whose hashes are compared, and the version.
            if let Value::Object(map) = &mut value {
                map.remove("key");
            }
            return Ok(value);
        }
        if let Some(path) = file(results::PUSH_FILE) {
            return as_value(serde_json::to_value(results::read_push(&path)?));
        }
        as_value(serde_json::to_value(results::read(folder)?.without(&left_out)))
    };
    let mut report = values(&load(old)?, &load(new)?, options);
    if left_out.iter().all(|left| left.part != Omittable::Histories) {
        let [kept, found] = [results::read_series(old)?, results::read_series(new)?];
        if kept.time.is_empty() && !found.time.is_empty() {
            left_out.push(LeftOut::of(Omittable::Histories));
        } else {
            series(&kept, &found, options, &mut report);
        }
    }
    sort(&mut report);
    report.not_compared = left_out;
    Ok(report)
}

/// The results of `compare` and `check` in a folder; none of one with others.
fn compared(folder: &Path) -> Result<Option<Results>, Error> {
    let others = [results::IDA_FILE, results::PUSH_FILE];
    if others.iter().any(|name| folder.join(name).is_file()) { Ok(None) } else { results::read(folder).map(Some) }
}

/// Compares two JSON documents in the form of `results.json`.
pub fn values(old: &Value, new: &Value, options: &Options) -> Report {
    let mut peaks = BTreeMap::new();
    collect_peaks(old, &mut String::new(), &mut peaks);
    let mut report = Report::default();
    walk(old, new, &mut String::new(), &Scale { peaks: &peaks, options: *options }, &mut report);
    sort(&mut report);
    report
}

fn sort(report: &mut Report) {
    report.moved.sort_by(|a, b| b.change.total_cmp(&a.change).then_with(|| a.path.cmp(&b.path)));
}

struct Scale<'a> {
    peaks: &'a BTreeMap<String, f64>,
    options: Options,
}

/// The group whose peak scales the tolerance of the number at `path`.
fn group(path: &str) -> String {
    let without_index = match path.rfind('[') {
        Some(at) if path.ends_with(']') => &path[..at],
        _ => path,
    };
    if let Some((run, inside)) = of_run(without_index) {
        if inside.starts_with("envelopes[") {
            for array in [".static_", ".min", ".max"] {
                if let Some(envelope) = without_index.strip_suffix(array) {
                    return envelope.to_owned();
                }
            }
        }
        if let Some((_, field)) = inside.strip_prefix("modes[").and_then(|rest| rest.split_once(']')) {
            return format!("{run}.modes{field}");
        }
    }
    without_index.to_owned()
}

/// A path in a run as the run (`runs[1]`) and the place in it.
fn of_run(path: &str) -> Option<(&str, &str)> {
    path.starts_with("runs[").then(|| path.split_once('.')).flatten()
}

/// Runs `visit` on the children of a container with `path` extended to each.
fn with_key<R>(path: &mut String, key: &str, visit: impl FnOnce(&mut String) -> R) -> R {
    let length = path.len();
    if !path.is_empty() && !key.starts_with('[') {
        path.push('.');
    }
    path.push_str(key);
    let result = visit(path);
    path.truncate(length);
    result
}

fn collect_peaks(value: &Value, path: &mut String, peaks: &mut BTreeMap<String, f64>) {
    match value {
        Value::Number(number) => {
            let peak = peaks.entry(group(path)).or_insert(0.0);
            *peak = peak.max(number.as_f64().unwrap_or(0.0).abs());
        }
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                with_key(path, &format!("[{i}]"), |path| collect_peaks(item, path, peaks));
            }
        }
        Value::Object(map) => {
            for (key, item) in map {
                with_key(path, key, |path| collect_peaks(item, path, peaks));
            }
        }
        _ => {}
    }
}

fn walk(old: &Value, new: &Value, path: &mut String, scale: &Scale, report: &mut Report) {
    match (old, new) {
        (Value::Object(a), Value::Object(b)) => {
            for (key, item) in a {
                if path.is_empty() && key == "volatile" {
                    continue;
                }
                with_key(path, key, |path| match b.get(key) {
                    Some(other) => walk(item, other, path, scale, report),
                    None => push(report, path, "present", "missing"),
                });
            }
            for key in b.keys().filter(|key| !a.contains_key(*key)) {
                with_key(path, key, |path| push(report, path, "missing", "present"));
            }
        }
        (Value::Array(a), Value::Array(b)) => {
            if a.len() != b.len() {
                push(report, path, &format!("{} entries", a.len()), &format!("{} entries", b.len()));
                return;
            }
            for (i, (x, y)) in a.iter().zip(b).enumerate() {
                with_key(path, &format!("[{i}]"), |path| walk(x, y, path, scale, report));
            }
        }
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap_or(f64::NAN), b.as_f64().unwrap_or(f64::NAN));
            let allowed = allowed_difference(path, a, b, scale);
            let peak = scale.peaks.get(&group(path)).copied().unwrap_or(0.0);
            number(report, path, (a, b), allowed, peak);
        }
        (Value::String(a), Value::String(b)) => {
            report.compared += 1;
            if a != b && !same_text(a, b, scale.options.rtol) {
                push(report, path, a, b);
            }
        }
        _ => {
            report.compared += 1;
            if old != new {
                push(report, path, &old.to_string(), &new.to_string());
            }
        }
    }
}

/// Absolute tolerance of the number at `path`.
fn allowed_difference(path: &str, a: f64, b: f64, scale: &Scale) -> f64 {
    let field = path.rsplit('.').next().unwrap_or(path);
    let inside = of_run(path).map_or("", |(_, inside)| inside);
    if inside.starts_with("histories[") && field == "time" {
        return scale.options.time_tolerance;
    }
    if (field == "error" || inside.starts_with("mesh_error")) && a.abs().max(b.abs()) < ROUNDING {
        return ROUNDING;
    }
    scale.options.rtol * scale.peaks.get(&group(path)).copied().unwrap_or(0.0)
}

fn number(report: &mut Report, path: &str, (a, b): (f64, f64), allowed: f64, peak: f64) {
    report.compared += 1;
    // Histories of a run that stopped early end in NaN.
    if a == b || (a.is_nan() && b.is_nan()) {
        return;
    }
    let difference = (b - a).abs();
    let change = if peak > 0.0 { difference / peak } else { f64::INFINITY };
    if difference <= allowed {
        report.drifted += 1;
        report.largest_drift = report.largest_drift.max(change);
    } else {
        report.moved.push(Difference { path: path.into(), old: format!("{a}"), new: format!("{b}"), change });
    }
}

fn push(report: &mut Report, path: &str, old: &str, new: &str) {
    report.compared += 1;
    report.moved.push(Difference { path: path.into(), old: old.into(), new: new.into(), change: f64::INFINITY });
}

/// Whether two texts are equal but for numbers that agree within `rtol` or one unit of their last printed digit.
fn same_text(a: &str, b: &str, rtol: f64) -> bool {
    let (a, b) = (tokens(a), tokens(b));
    a.len() == b.len()
        && a.iter().zip(&b).all(|(x, y)| {
            x == y
                || match (x.parse::<f64>(), y.parse::<f64>()) {
                    (Ok(p), Ok(q)) => {
                        let unit = last_digit(x).max(last_digit(y));
                        (p - q).abs() <= (rtol * p.abs()).max(1.001 * unit)
                    }
                    _ => false,
                }
        })
}

/// Splits a text into numbers and the text between them.
fn tokens(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let bytes = text.as_bytes();
    let (mut start, mut i) = (0, 0);
    while i < bytes.len() {
        if bytes[i].is_ascii_digit() {
            let begin = i;
            while i < bytes.len() && (bytes[i].is_ascii_digit() || bytes[i] == b'.') {
                i += 1;
            }
            if i < bytes.len() && bytes[i] == b'e' {
                let mut end = i + 1;
                if end < bytes.len() && (bytes[end] == b'-' || bytes[end] == b'+') {
                    end += 1;
                }
                if end < bytes.len() && bytes[end].is_ascii_digit() {
                    while end < bytes.len() && bytes[end].is_ascii_digit() {
                        end += 1;
                    }
                    i = end;
                }
            }
            tokens.push(&text[start..begin]);
            tokens.push(&text[begin..i]);
            start = i;
        } else {
            i += 1;
        }
    }
    tokens.push(&text[start..]);
    tokens
}

/// Value of one unit of the last printed digit of a number.
fn last_digit(text: &str) -> f64 {
    let (mantissa, exponent) = match text.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().unwrap_or(0)),
        None => (text, 0),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    10f64.powi(exponent - decimals)
}

fn series(old: &results::Series, new: &results::Series, options: &Options, report: &mut Report) {
    let file = results::SERIES_FILE;
    if old.ids != new.ids {
        push(report, &format!("{file}: columns"), &old.ids.join(","), &new.ids.join(","));
        return;
    }
    if old.time.len() != new.time.len() {
        push(report, &format!("{file}: rows"), &old.time.len().to_string(), &new.time.len().to_string());
        return;
    }
    let mut column = |id: &str, a: &[f64], b: &[f64]| {
        let peak = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for (i, (&x, &y)) in a.iter().zip(b).enumerate() {
            number(report, &format!("{file}:{id}[{i}]"), (x, y), options.rtol * peak, peak);
        }
    };
    column("time_s", &old.time, &new.time);
    for (id, (a, b)) in old.ids.iter().zip(old.columns.iter().zip(&new.columns)) {
        column(id, a, b);
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn moved(old: Value, new: Value) -> Vec<String> {
        values(&old, &new, &Options::default()).moved.into_iter().map(|d| d.path).collect()
    }

    #[test]
    fn equal_documents_are_the_same() {
        let a = json!({"volatile": {"created": "1"}, "x": [1.0, 2.0], "s": "T = 2.03 s"});
        let report = values(&a, &a, &Options::default());
        assert_eq!((report.moved.len(), report.drifted, report.compared), (0, 0, 3));
    }

    #[test]
    fn volatile_fields_are_skipped() {
        assert!(moved(json!({"volatile": {"created": "1"}}), json!({"volatile": {"created": "2"}})).is_empty());
    }

    #[test]
    fn array_entries_are_compared_at_the_scale_of_the_peak() {
        // 1e-5 is 100 % of the small entry but 1e-7 of the peak.
        let report = values(&json!({"p": [100.0, 0.0]}), &json!({"p": [100.0, 1e-5]}), &Options::default());
        assert_eq!((report.moved.len(), report.drifted), (0, 1));
        assert_eq!(moved(json!({"p": [100.0, 0.0]}), json!({"p": [100.0, 1e-3]})), ["p[1]"]);
    }

    #[test]
    fn scalars_are_compared_at_their_own_scale() {
        assert_eq!(moved(json!({"a": 1e9, "b": 1.0}), json!({"a": 1e9, "b": 1.00001})), ["b"]);
    }

    #[test]
    fn envelopes_share_one_peak_and_modes_one_per_field() {
        let old = json!({"runs": [{"envelopes": [{"min": [-1e6], "max": [0.0]}], "modes": [{"m": 5.0}, {"m": 1e-9}]}]});
        let new = json!({"runs": [{"envelopes": [{"min": [-1e6], "max": [0.5]}], "modes": [{"m": 5.0}, {"m": 2e-9}]}]});
        assert!(moved(old, new).is_empty());
    }

    #[test]
    fn missing_keys_lengths_units_and_text_are_moves() {
        assert_eq!(moved(json!({"a": 1}), json!({"b": 1})), ["a", "b"]);
        assert_eq!(moved(json!({"a": [1]}), json!({"a": [1, 2]})), ["a"]);
        assert_eq!(moved(json!({"unit": "N"}), json!({"unit": "kN"})), ["unit"]);
    }

    #[test]
    fn numbers_in_text_may_differ_by_their_last_digit_only() {
        assert!(moved(json!({"s": "R = 1.830 m"}), json!({"s": "R = 1.831 m"})).is_empty());
        assert_eq!(moved(json!({"s": "R = 1.830 m"}), json!({"s": "R = 1.833 m"})), ["s"]);
        assert_eq!(moved(json!({"s": "R = 1.830 m"}), json!({"s": "L = 1.830 m"})), ["s"]);
    }

    #[test]
    fn a_time_of_a_maximum_has_its_own_tolerance() {
        let at = |t: f64| json!({"runs": [{"histories": [{"time": t}]}]});
        assert!(moved(at(3.00), at(3.01)).is_empty());
        assert_eq!(moved(at(3.0), at(3.5)), ["runs[0].histories[0].time"]);
    }
}
