//! Capacities of records, found between two intensities, and what is said of those that are not.

use std::collections::{BTreeMap, BTreeSet};

use super::Seen;

/// The intensity at which a run of a record reaches the state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Capacity {
    At(f64),
    /// The first intensity, in the state.
    Below(f64),
    /// The last intensity, without the state.
    Beyond(f64),
}

/// Capacities of every record and sample.
pub(super) fn capacities(records: &[Vec<Seen>], notes: &mut Vec<String>) -> Vec<Vec<Capacity>> {
    let levels: BTreeSet<u64> = records.iter().flatten().map(|run| run.im.to_bits()).collect();
    let lowest = levels.first().map_or(0.0, |bits| f64::from_bits(*bits));
    let (mut stepped, mut across, mut below) = (0, 0, Vec::new());
    let mut between: BTreeSet<[u64; 2]> = BTreeSet::new();
    let mut all: Vec<Vec<Capacity>> = Vec::new();
    for runs in records {
        let mut samples: BTreeMap<u32, Vec<Seen>> = BTreeMap::new();
        for run in runs {
            samples.entry(run.sample).or_default().push(*run);
        }
        let mut found = Vec::new();
        for runs in samples.values_mut() {
            runs.sort_by(|a, b| a.im.total_cmp(&b.im));
            let Some(first) = runs.iter().position(|run| run.reached) else {
                found.extend(runs.last().map(|run| Capacity::Beyond(run.im)));
                continue;
            };
            if first == 0 {
                below.push(runs[0].im);
                found.push(Capacity::Below(runs[0].im));
                continue;
            }
            let (before, after) = (&runs[first - 1], &runs[first]);
            let at = crossing(before, after);
            let ends = [before.im, after.im].map(f64::to_bits);
            between.insert(ends);
            across += usize::from(levels.range(ends[0]..ends[1]).count() > 1);
            stepped += usize::from(at.is_none());
            // Without a demand on both sides the capacity is that below, which errs on the side of damage.
            found.push(Capacity::At(at.unwrap_or(before.im)));
        }
        all.push(found);
    }
    notes.extend(not_bracketed(&below, lowest));
    let beyond = all.iter().flatten().filter(|c| matches!(c, Capacity::Beyond(_))).count();
    if beyond > 0 {
        let of = all.iter().map(Vec::len).sum::<usize>();
        notes.push(format!("{beyond} of {of} records do not reach the state: the capacity is somewhere above"));
    }
    if across > 0 {
        notes.push(match across {
            1 => "1 capacity is interpolated across a level at which its record was not judged".to_owned(),
            _ => format!("{across} capacities are interpolated across levels at which their records were not judged"),
        });
    }
    if stepped > 0 {
        notes.push(match stepped {
            1 => "1 capacity is the last intensity before a run without a finite demand".to_owned(),
            _ => format!("{stepped} capacities are the last intensities before runs without a finite demand"),
        });
    }
    let crossed = all.iter().flatten().filter(|capacity| matches!(capacity, Capacity::At(_)));
    if between.len() == 1 && crossed.count() > 1 {
        notes.push(
            "all capacities that were found lie between the same two levels, where demands are interpolated; levels between them would confirm the scatter"
                .into(),
        );
    }
    all
}

/// What is said of records whose capacities are below their first judged intensity.
///
/// * `lowest`: lowest intensity of all records
fn not_bracketed(below: &[f64], lowest: f64) -> Vec<String> {
    let first = below.iter().filter(|im| **im <= lowest).count();
    let later = below.len() - first;
    let text = |count: usize, one: &str, more: &str, help: &str| {
        let records = match count {
            0 => return None,
            1 => one.to_owned(),
            _ => format!("{count} {more}"),
        };
        Some(format!("{records}: the capacity is somewhere below; {help}"))
    };
    let texts = [
        text(
            first,
            "1 record reaches the state at the lowest intensity",
            "records reach the state at the lowest intensity",
            "lower levels would find it",
        ),
        text(
            later,
            "1 record reaches the state at the lowest intensity at which it was judged",
            "records reach the state at the lowest intensity at which they were judged",
            "runs at lower ones are missing or have a demand that was not checked",
        ),
    ];
    texts.into_iter().flatten().collect()
}

/// Where the ratio is 1 between two runs, linear in logarithms; none without two ratios greater than 0.
fn crossing(before: &Seen, after: &Seen) -> Option<f64> {
    let (low, high) = (before.ratio.filter(|r| *r > 0.0)?, after.ratio?);
    let share = -low.ln() / (high / low).ln();
    (0.0..=1.0).contains(&share).then(|| before.im * (after.im / before.im).powf(share))
}
