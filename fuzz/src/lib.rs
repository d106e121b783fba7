//! The fuzz targets: functions of bytes that panic where a promise of the program is broken.
//!
//! They are run by libFuzzer (`fuzz_targets/`) and, with random changes of the same first inputs, by `cargo test`
//! (`tests/fuzz`).

pub mod checkpoint;
pub mod document;
pub mod mutate;
pub mod pipeline;
pub mod record;
pub mod results;
pub mod seeds;
pub mod tank;

use std::path::Path;

/// A target.
#[derive(Clone, Copy)]
pub struct Target {
    /// Name, also of its corpus.
    pub name: &'static str,
    /// Runs it on one input.
    pub run: fn(&[u8]),
    /// First inputs, from the root of the repository.
    pub seeds: fn(&Path) -> Vec<Vec<u8>>,
    /// Longest input [bytes].
    pub most: usize,
}

/// All targets.
pub const ALL: [Target; 7] = [
    Target { name: "tank", run: tank::run, seeds: seeds::tanks, most: 20_000 },
    Target { name: "columns", run: record::columns, seeds: seeds::columns, most: 10_000 },
    Target { name: "peer", run: record::peer, seeds: |_| seeds::peer(), most: 10_000 },
    Target { name: "agencies", run: record::agencies, seeds: seeds::agencies, most: 10_000 },
    Target { name: "results", run: results::run, seeds: seeds::results, most: 400_000 },
    Target { name: "checkpoint", run: checkpoint::run, seeds: |_| checkpoint::seeds(), most: 10_000 },
    Target { name: "pipeline", run: pipeline::run, seeds: pipeline::seeds, most: 20_000 },
];

/// The target of this name.
pub fn find(name: &str) -> Target {
    ALL.into_iter().find(|t| t.name == name).unwrap_or_else(|| panic!("no target {name}"))
}

/// Writes the first inputs of a target into its corpus, where libFuzzer looks for them.
pub fn write_seeds(target: &Target, root: &Path) {
    let folder = root.join("fuzz/corpus").join(target.name);
    std::fs::create_dir_all(&folder).expect("the corpus is writable");
    for (k, seed) in (target.seeds)(root).iter().enumerate() {
        std::fs::write(folder.join(format!("seed-{k:02}")), seed).expect("the corpus is writable");
    }
}
