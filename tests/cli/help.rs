//! `--help`: placeholders of files and folders have one spelling in all commands.

use std::collections::BTreeSet;
use std::process::Command;

/// Every command that has arguments.
const COMMANDS: [&str; 24] = [
    "compare",
    "check",
    "ida",
    "push",
    "study plan",
    "study run",
    "study status",
    "study merge",
    "fragility",
    "base",
    "modes",
    "spectrum",
    "quake info",
    "quake convert",
    "quake set",
    "quake synth",
    "quake harmonic",
    "report",
    "templates export",
    "diff",
    "verify",
    "explain",
    "init",
    "schema",
];

/// Spellings of before, and others that a writer of help may think of.
const OTHERS: [&str; 12] =
    ["DIR", "DIRECTORY", "PATH", "CSV", "JSON", "S", "SEC", "HZ", "QUAKE", "MOTION", "OUT", "TANK or CSV"];

#[test]
fn placeholders_have_one_spelling() {
    let mut found: BTreeSet<String> = BTreeSet::new();
    for command in COMMANDS {
        let args: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let done = Command::new(env!("CARGO_BIN_EXE_tankcheck")).args(args).output().unwrap();
        assert!(done.status.success(), "{command}");
        let text = String::from_utf8(done.stdout).unwrap();
        for part in text.split('<').skip(1).filter_map(|rest| rest.split_once('>')) {
            assert!(!OTHERS.contains(&part.0), "{command}: <{}>", part.0);
            found.insert(part.0.to_owned());
        }
    }
    for wanted in ["TANK", "RECORD", "STUDY", "FOLDER", "FILE", "SECONDS"] {
        assert!(found.contains(wanted), "{wanted}: {found:?}");
    }
}
