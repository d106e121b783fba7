//! The fuzz targets with random changes of their first inputs: `fuzz/` without a fuzzer.
//!
//! Goal:     no input makes a reader, the pipeline or the report panic or violate the properties stated in `fuzz/src`
//! Model:    each target runs its seeds, the inputs of `fuzz/finds/<target>`, and seeds changed at random
//! Expected: see the targets; a find is written to `target/fuzz-finds/<target>` and named in the message
//!
//! `TANKCHECK_FUZZ_SECONDS=60 cargo test --test fuzz` runs each target so long, with another seed each time (printed), or with
//! that of `TANKCHECK_FUZZ_SEED`; without it a fixed number of inputs from a fixed seed.

#[allow(unreachable_pub, reason = "the items of a library")]
#[path = "../../fuzz/src/lib.rs"]
#[allow(dead_code)]
mod targets;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use targets::mutate::{Rng, mutate};
use targets::{Target, find};

/// Inputs of a run without time.
const INPUTS: u64 = 150;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Runs a target on one input; a find is kept and named.
fn attempt(target: &Target, bytes: &[u8]) {
    if let Err(panic) = catch_unwind(AssertUnwindSafe(|| (target.run)(bytes))) {
        let folder = root().join("target/fuzz-finds").join(target.name);
        std::fs::create_dir_all(&folder).expect("target is writable");
        let mut hash = fem::analysis::checkpoint::Hash::default();
        hash.bytes(bytes);
        let path = folder.join(format!("{:016x}", hash.value()));
        std::fs::write(&path, bytes).expect("target is writable");
        eprintln!("the input is kept in {}", path.display());
        std::panic::resume_unwind(panic);
    }
}

fn finds(target: &Target) -> Vec<PathBuf> {
    let folder = root().join("fuzz/finds").join(target.name);
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()).collect();
    paths.sort();
    paths
}

fn fuzz(name: &str) {
    let target = find(name);
    let seeds = (target.seeds)(root());
    assert!(seeds.len() > 2, "{name} has {} seeds", seeds.len());
    for path in finds(&target) {
        println!("{}", path.display());
        attempt(&target, &std::fs::read(&path).expect("readable"));
    }
    seeds.iter().for_each(|seed| attempt(&target, seed));
    let seconds: Option<u64> = std::env::var("TANKCHECK_FUZZ_SECONDS").ok().and_then(|s| s.parse().ok());
    let given = std::env::var("TANKCHECK_FUZZ_SEED").ok().map(|s| s.parse().expect("a number"));
    let seed = match (given, seconds) {
        (Some(seed), _) => seed,
        (None, None) => 1982,
        (None, Some(_)) => std::time::UNIX_EPOCH.elapsed().map_or(1, |t| t.as_nanos() as u64),
    };
    let mut rng = Rng::new(seed);
    let start = Instant::now();
    let mut inputs = 0;
    while seconds.map_or(inputs < INPUTS, |s| start.elapsed() < Duration::from_secs(s)) {
        let mut data = seeds[rng.below(seeds.len())].clone();
        mutate(&mut data, target.most, &mut rng);
        attempt(&target, &data);
        inputs += 1;
    }
    println!("{name}: {inputs} inputs in {:.1} s, seed {seed}", start.elapsed().as_secs_f64());
}

#[test]
fn tank() {
    fuzz("tank");
}

#[test]
fn columns() {
    fuzz("columns");
}

#[test]
fn peer() {
    fuzz("peer");
}

#[test]
fn agencies() {
    fuzz("agencies");
}

#[test]
fn results() {
    fuzz("results");
}

#[test]
fn checkpoint() {
    fuzz("checkpoint");
}

#[test]
fn pipeline() {
    fuzz("pipeline");
}
