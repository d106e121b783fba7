//! Accepted results of the examples in `reports/`, with the kept rows of their histories.

use std::path::{Path, PathBuf};

use report::template::Templates;
use report::{Level, Report};
use results::{Results, Series};

/// The folder `reports` of the repository.
pub(crate) fn reports() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reports")
}

/// Names of all verifications: paths below `reports`.
pub(crate) fn names() -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![reports()];
    while let Some(folder) = open.pop() {
        if folder.join("results.json").is_file() {
            let name = folder.strip_prefix(reports()).expect("below");
            found.push(name.to_string_lossy().into_owned());
        }
        let entries = std::fs::read_dir(folder).expect("a folder");
        open.extend(entries.map(|e| e.expect("an entry").path()).filter(|p| p.is_dir()));
    }
    found.sort();
    assert!(found.len() >= 15, "only {} results", found.len());
    found
}

/// Results and histories.
pub(crate) fn read(name: &str) -> (Results, Series) {
    let histories = reports().join("../tests/golden/histories").join(name);
    let results = results::read(&reports().join(name)).expect("results");
    let series = results::read_series(&histories).expect("histories");
    assert_eq!(series.time.is_empty(), results.runs.is_empty(), "{name}");
    (results, series)
}

/// Their report, in the language and units that are wished for.
pub(crate) fn page(name: &str, level: Level) -> Report {
    let (results, series) = read(name);
    let templates = Templates::new(None).expect("embedded templates");
    report::build(&results, &series, &templates, level).expect("renders")
}
