//! Every `impl Element for …` of the crate has an entry.

use std::collections::BTreeSet;
use std::path::Path;

use crate::registry::all;

#[test]
fn every_element_has_an_entry() {
    let mut found = BTreeSet::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut found);
    let entries: BTreeSet<String> = all().iter().map(|s| s.of.to_owned()).collect();
    assert!(found.len() >= 18, "the sources of the crate have {} elements", found.len());
    let missing: Vec<_> = found.difference(&entries).collect();
    assert!(missing.is_empty(), "no entry in tests/laws/registry: {missing:?}");
    let unknown: Vec<_> = entries.difference(&found).collect();
    assert!(unknown.is_empty(), "entries without an element: {unknown:?}");
}

/// Types with an implementation outside the files of unit tests.
fn read(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" {
            read(&path, found);
        } else if path.is_file() && name.ends_with(".rs") && name != "tests.rs" {
            let text = std::fs::read_to_string(&path).unwrap();
            let types = text.lines().filter_map(|line| line.trim_start().split_once(" Element for "));
            let own = types.filter(|(start, _)| start.starts_with("impl") && !start.contains("//"));
            let name = |rest: &str| rest.split(|c: char| !c.is_alphanumeric()).next().unwrap_or("").to_owned();
            found.extend(own.map(|(_, rest)| name(rest)));
        }
    }
}
