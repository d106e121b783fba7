//! Procedures: other crates take them from `codes::ALL` and do not name their ids, so a new procedure changes no other crate.

use std::path::Path;

use crate::sources::workspace;

/// Files outside `codes` that name an id, and why.
const EXCEPTIONS: &[(&str, &str)] =
    &[("src/cli/check.rs", "example of a command line in the help text"), ("src/selftest.rs", "a row for each code")];

/// Whether a line of code names an id: in quotes, or anywhere if the id is not an identifier.
fn names(line: &str, id: &str) -> bool {
    let comment = line.trim_start().starts_with("//");
    !comment && (line.contains(&format!("\"{id}\"")) || (id.contains('-') && line.contains(id)))
}

#[test]
fn ids_of_procedures_stand_in_codes_only() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    for krate in workspace().iter().filter(|krate| krate.name != "codes") {
        for source in krate.files.values() {
            let text = std::fs::read_to_string(root.join(&source.path)).expect("readable");
            let code = text.split("\nmod tests {").next().unwrap_or_default();
            let named = |line: &&str| codes::ALL.iter().any(|procedure| names(line, procedure.id()));
            if let Some(line) = code.lines().find(named) {
                found.push((source.path.display().to_string(), line.trim().to_owned()));
            }
        }
    }
    let files: Vec<&str> = found.iter().map(|(path, _)| path.as_str()).collect();
    let exceptions: Vec<&str> = EXCEPTIONS.iter().map(|(path, _)| *path).collect();
    assert_eq!(files, exceptions, "{found:#?}");
}

#[test]
fn an_id_is_found() {
    assert!(names(r#"    "housner" => 1,"#, "housner"));
    assert!(names("check --procedures ec8-2006", "ec8-2006"));
    assert!(!names("    housner: Options,", "housner"));
    assert!(!names("/// `ec8-2006`", "ec8-2006"));
}
