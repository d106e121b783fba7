//! Where the record ends, and what is largest only after it.

use crate::number::fixed;
use results::Run;

/// Histories named at most.
const MOST: usize = 4;

/// End of the record and of the run, at most `end` [s]; empty where the run ends with its record.
pub fn sentence(run: &Run, end: Option<f64>) -> String {
    let (Some(record), Some(end)) = (run.record_end, end.filter(|_| !run.incomplete)) else { return String::new() };
    if end <= record {
        return String::new();
    }
    let mut text =
        format!("The record ends at {} s; the tank then vibrates freely, up to {} s.", fixed(record, 2), fixed(end, 2));
    let late = run.histories.iter().filter(|h| h.time > record && h.peak > 0.0);
    let late: Vec<&str> = late.map(|h| h.title.as_str()).collect();
    if !late.is_empty() {
        let more = match late.len().saturating_sub(MOST) {
            0 => String::new(),
            n => format!(", and {n} more"),
        };
        let named = late[..late.len().min(MOST)].join("; ");
        text.push_str(&format!(" Largest only after the record: {named}{more}."));
    }
    text
}
