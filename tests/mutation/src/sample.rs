//! The sample: stratified by file, in an order that a seed fixes.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value;

/// Least number of mutants of a file in the sample, if it has that many.
const LEAST_PER_FILE: usize = 3;

/// A mutant of cargo-mutants' list.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// Number of its switch, from 1.
    pub id: usize,
    /// `codes/src/ec8/buckling.rs:35:9: replace * with + in classical`.
    pub name: String,
    /// File, relative to the workspace.
    pub file: String,
    /// First and last position (line from 1, column from 1 in characters; the end is exclusive).
    pub start: (usize, usize),
    /// End of the span.
    pub end: (usize, usize),
    /// Text that replaces the span.
    pub replacement: String,
    /// Kind as in cargo-mutants (`FnValue`, `BinaryOperator`, …).
    pub genre: String,
}

/// Folder below `src` (or `src/element`), else the file's name: the key of the list of scores.
pub fn module(file: &str) -> String {
    let inner = file.split_once("/src/").map_or(file, |(_, rest)| rest);
    let inner = inner.strip_prefix("element/").unwrap_or(inner);
    inner.split('/').next().unwrap_or(inner).trim_end_matches(".rs").to_string()
}

pub fn read(path: &Path) -> Result<Vec<Mutant>, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let list: Vec<Value> = serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))?;
    list.iter()
        .enumerate()
        .map(|(index, m)| {
            mutant(m, index + 1).ok_or_else(|| format!("{}: entry {index} is not a mutant", path.display()))
        })
        .collect()
}

fn mutant(value: &Value, id: usize) -> Option<Mutant> {
    let text = |key: &str| value[key].as_str().map(str::to_string);
    let at = |end: &str| {
        let place = &value["span"][end];
        Some((place["line"].as_u64()? as usize, place["column"].as_u64()? as usize))
    };
    Some(Mutant {
        id,
        name: text("name")?,
        file: text("file")?,
        start: at("start")?,
        end: at("end")?,
        replacement: text("replacement")?,
        genre: text("genre")?,
    })
}

/// FNV-1a over seed and text: the same order everywhere.
fn hash(seed: u64, text: &str) -> u64 {
    let mut h = 0xcbf2_9ce4_8422_2325_u64;
    for byte in seed.to_le_bytes().iter().chain(text.as_bytes()) {
        h = (h ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
    // The last bytes of FNV reach the high bits too little for an order.
    h ^= h >> 32;
    h.wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// The mutant without line and column, so that an edit elsewhere in the file leaves its place in the order.
fn key(m: &Value, seen: &mut BTreeMap<String, usize>) -> String {
    let name = m["name"].as_str().unwrap_or_default();
    let what = name.splitn(4, ':').nth(3).unwrap_or(name);
    let file = m["file"].as_str().unwrap_or_default();
    let text = format!("{file}:{what}");
    let count = seen.entry(text.clone()).or_default();
    *count += 1;
    format!("{text} #{count}")
}

/// Draws `size` mutants: from each file its share, at least [`LEAST_PER_FILE`]; their order is random with the seed, so
/// that a run cut short is a random sample itself.
pub fn draw(list: &Path, size: &str, seed: &str, out: &Path) -> Result<(), String> {
    let number = |text: &str| text.parse::<u64>().map_err(|e| format!("`{text}`: {e}"));
    let (size, seed) = (number(size)? as usize, number(seed)?);
    let text = std::fs::read_to_string(list).map_err(|e| format!("{}: {e}", list.display()))?;
    let all: Vec<Value> = serde_json::from_str(&text).map_err(|e| format!("{}: {e}", list.display()))?;
    let mut seen = BTreeMap::new();
    let mut files: BTreeMap<String, Vec<(u64, &Value)>> = BTreeMap::new();
    for m in &all {
        let file = m["file"].as_str().unwrap_or_default().to_string();
        let order = hash(seed, &key(m, &mut seen));
        files.entry(file).or_default().push((order, m));
    }
    let mut drawn: Vec<(u64, &Value)> = Vec::new();
    for mutants in files.values_mut() {
        mutants.sort_by_key(|(order, _)| *order);
        let share = (size * mutants.len()).div_ceil(all.len().max(1));
        drawn.extend(mutants.iter().take(share.max(LEAST_PER_FILE)));
    }
    drawn.sort_by_key(|(order, _)| *order);
    let sample: Vec<&Value> = drawn.iter().map(|(_, m)| *m).collect();
    let text = serde_json::to_string_pretty(&sample).map_err(|e| e.to_string())?;
    std::fs::write(out, text).map_err(|e| format!("{}: {e}", out.display()))?;
    println!("{} of {} mutants, {} files, seed {seed}", sample.len(), all.len(), files.len());
    Ok(())
}
