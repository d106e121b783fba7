//! Walls: what a crate may import stands in its manifest, what a folder may name in its `use` lines and paths.

use std::collections::BTreeSet;

use crate::sources::{paths, uses, workspace};

/// A crate and the crates of the house that it may import.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("oscillator", &[]),
    ("linalg", &[]),
    ("fourier", &[]),
    ("materials", &[]),
    ("files", &[]),
    ("fragility", &["files"]),
    ("desk", &["files"]),
    ("tank", &["oscillator"]),
    ("base", &["tank"]),
    ("soil", &["oscillator"]),
    ("fem", &["fourier", "linalg", "materials", "oscillator"]),
    ("codes", &["base", "oscillator", "soil", "tank"]),
    ("results", &["files", "oscillator", "tank"]),
    ("engines", &["base", "fem", "fourier", "linalg", "materials", "oscillator", "results", "soil", "tank"]),
    ("report", &["files", "results", "tank"]),
    (
        "verification",
        &[
            "base",
            "codes",
            "engines",
            "fem",
            "files",
            "linalg",
            "materials",
            "oscillator",
            "report",
            "results",
            "soil",
            "tank",
            "tankcheck",
        ],
    ),
    (
        "tankcheck",
        &[
            "base",
            "codes",
            "desk",
            "engines",
            "fem",
            "files",
            "fragility",
            "materials",
            "oscillator",
            "report",
            "results",
            "soil",
            "tank",
        ],
    ),
];

/// A crate, a folder or file in it, and what it must not name.
const MUST_NOT_NAME: &[(&str, &str, &[&str])] = &[
    ("tankcheck", "input", &["engines::", "report::", "crate::cli", "crate::pipeline"]),
    ("tankcheck", "pipeline", &["crate::cli", "crate::input", "report::"]),
    ("tankcheck", "solve", &["crate::cli", "crate::input", "report::"]),
    ("tankcheck", "record_set", &["crate::cli", "crate::input", "report::"]),
    ("tankcheck", "study", &["crate::cli", "report::"]),
    ("engines", "solid", &["crate::harmonic"]),
    ("engines", "harmonic", &["crate::solid"]),
];

#[test]
fn manifests_keep_the_walls() {
    for found in workspace() {
        let allowed = MAY_IMPORT.iter().find(|(name, _)| *name == found.name);
        let (_, allowed) = allowed.unwrap_or_else(|| panic!("{}: a crate without a place in the plan", found.name));
        let allowed: BTreeSet<String> = allowed.iter().map(|&name| name.to_owned()).collect();
        let broken: Vec<_> = found.dependencies.difference(&allowed).collect();
        assert!(broken.is_empty(), "{} must not import {broken:?}", found.name);
    }
}

#[test]
fn folders_keep_the_walls() {
    let workspace = workspace();
    let mut broken = Vec::new();
    for (name, folder, forbidden) in MUST_NOT_NAME {
        let found = workspace.iter().find(|c| c.name == *name).expect("a crate of the workspace");
        let files = found.files.iter().filter(|(module, _)| module.first().is_some_and(|m| m == folder));
        let mut count = 0;
        for (_, source) in files {
            count += 1;
            let named = uses(&source.text, false).into_iter().chain(uses(&source.text, true));
            for path in named.chain(paths(&source.text)) {
                if forbidden.iter().any(|f| format!("{path}::").starts_with(&format!("{}::", f.trim_end_matches(':'))))
                {
                    broken.push(format!("{} names {path}", source.path.display()));
                }
            }
        }
        assert!(count > 0, "{name}: no folder {folder}");
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}
