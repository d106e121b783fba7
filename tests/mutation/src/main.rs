//! Runs a fixed-seed sample of cargo-mutants' mutants from one build.
//!
//! `cargo mutants` builds the crate once a mutant; on a small machine that is minutes each. This tool takes the very list
//! of `cargo mutants --list --json`, draws a sample with a fixed seed, writes all mutants of the sample into one copy of
//! the source, each behind a switch, builds it once, and runs the tests once a mutant with its switch on:
//!
//! ```text
//! a + b    becomes    (if crate::mutation_switch::on(7) { a - b } else { a + b })
//! ```
//!
//! The mutant's text is that of cargo-mutants: its replacement put into the whole expression around the operator, so that
//! precedence is the same as in the file. Mutants that the compiler rejects are unviable and removed, as in cargo-mutants.
//! Mutants of constants cannot be switched and are listed for `cargo mutants` itself.
//!
//! `tests/mutation/run` is the command; `docs/verification/mutation.md` holds method and scores.

mod run;
mod sample;
mod weave;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "usage: mutation sample LIST.json SIZE SEED OUT.json
       mutation build ROOT SAMPLE.json STATE.json -- CARGO-TEST-ARGUMENTS
       mutation run SAMPLE.json STATE.json OUTCOMES.tsv TESTS.tsv DIRECTORY BINARY... -- TEST-ARGUMENTS
       mutation report SAMPLE.json STATE.json OUTCOMES.tsv";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (own, passed) = match arguments.iter().position(|a| a == "--") {
        Some(at) => (&arguments[..at], &arguments[at + 1..]),
        None => (&arguments[..], &[][..]),
    };
    let own: Vec<&str> = own.iter().map(String::as_str).collect();
    let result = match own.as_slice() {
        ["sample", list, size, seed, out] => sample::draw(Path::new(list), size, seed, Path::new(out)),
        ["build", root, sample, state] => weave::build(Path::new(root), Path::new(sample), Path::new(state), passed),
        ["run", sample, state, outcomes, tests, directory, binaries @ ..] if !binaries.is_empty() => run::run(
            Path::new(sample),
            Path::new(state),
            Path::new(outcomes),
            Path::new(tests),
            Path::new(directory),
            binaries,
            passed,
        ),
        ["report", sample, state, outcomes] => run::report(Path::new(sample), Path::new(state), Path::new(outcomes)),
        _ => Err(USAGE.into()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
