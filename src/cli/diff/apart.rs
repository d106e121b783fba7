//! Whether both results are of one tank.

use std::collections::{BTreeMap, BTreeSet};

use results::Results;

/// Parts of a tank file that describe the tank.
const OF_TANK: [&str; 4] = ["tank.", "liquid.", "materials.", "gravity"];

/// Two tanks that are not the same: names, and how many of their values differ. Nothing else that moved says more.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub(super) struct Apart {
    old: String,
    new: String,
    /// Values of tank, liquid and materials that differ.
    values: usize,
}

impl Apart {
    /// None where the tanks are the same.
    pub(super) fn between(old: &Results, new: &Results) -> Option<Apart> {
        let of_tank = |path: &str| OF_TANK.iter().any(|part| path.starts_with(part));
        let values = differing(old, new).iter().filter(|(path, _)| of_tank(path)).count();
        (values > 0 || old.name != new.name).then(|| Apart { old: old.name.clone(), new: new.name.clone(), values })
    }

    /// In a sentence.
    pub(super) fn words(&self) -> String {
        let values = match self.values {
            0 => "the same values".to_owned(),
            1 => "1 value of tank, liquid and materials differs".to_owned(),
            n => format!("{n} values of tank, liquid and materials differ"),
        };
        let names = match self.old == self.new {
            true => format!("`{}`", self.new),
            false => format!("`{}` -> `{}`", self.old, self.new),
        };
        format!("two different tanks: {names}, {values}")
    }
}

/// Input that differs: path, and what stands there in both.
pub(super) fn differing(old: &Results, new: &Results) -> BTreeMap<String, [Option<String>; 2]> {
    let map = |results: &'_ Results| -> BTreeMap<String, String> {
        let lines = results.input.iter();
        lines.map(|line| (line.path.clone(), line.text.clone())).collect()
    };
    let (old, new) = (map(old), map(new));
    let paths: BTreeSet<&String> = old.keys().chain(new.keys()).collect();
    let moved = paths.into_iter().filter(|path| old.get(*path) != new.get(*path));
    moved.map(|path| (path.clone(), [old.get(path).cloned(), new.get(path).cloned()])).collect()
}
