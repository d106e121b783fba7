//! With `SOURCE_DATE_EPOCH` the files of two runs are equal byte for byte, wherever and whenever they are written, on any number of cores.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(folder: &Path, epoch: &str, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(arguments)
        .current_dir(folder)
        .env("SOURCE_DATE_EPOCH", epoch)
        .output()
        .unwrap()
}

/// Every file below a folder, by its path in it.
pub(crate) fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(place) = open.pop() {
        for entry in std::fs::read_dir(&place).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => open.push(path),
                false => {
                    let bytes = std::fs::read(&path).unwrap();
                    found.insert(path.strip_prefix(folder).unwrap().to_path_buf(), bytes);
                }
            }
        }
    }
    found
}

/// A new folder with these files.
pub(crate) fn folder_of(files: &BTreeMap<PathBuf, Vec<u8>>) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, bytes) in files {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    folder
}

/// Runs a command twice, in two folders with other names for the results and other numbers of cores, and a workbook of them where there
/// is one; returns the files.
fn twice(arguments: &[&str]) -> BTreeMap<PathBuf, Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let [first, second] = [("out", "1"), ("a/b c", "2")].map(|(out, threads)| {
        let home = tempfile::tempdir().unwrap();
        std::fs::copy(root.join("examples/05_oil_tank/tank.json"), home.path().join("tank.json")).unwrap();
        std::fs::copy(root.join("examples/records/elcentro.csv"), home.path().join("r.csv")).unwrap();
        let place = [arguments, &["--out", out, "--threads", threads]].concat();
        let done = run(home.path(), "1000000000", &place);
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(matches!(done.status.code(), Some(0 | 1 | 4)), "{arguments:?}: {said}");
        if home.path().join(out).join("results.json").exists() {
            let book = run(home.path(), "1000000000", &["report", out, "--format", "xlsx"]);
            assert!(book.status.success(), "{}", String::from_utf8_lossy(&book.stderr));
        }
        files(&home.path().join(out))
    });
    assert_eq!(first.keys().collect::<Vec<_>>(), second.keys().collect::<Vec<_>>());
    for (name, bytes) in &first {
        assert!(*bytes == second[name], "{arguments:?}: {} differs", name.display());
    }
    first
}

#[test]
fn two_runs_write_the_same_bytes() {
    let found = twice(&["compare", "tank.json", "--quake", "r.csv"]);
    for name in ["results.json", "report.html", "series.csv", "manifest.json", "report.xlsx"] {
        assert!(found.contains_key(Path::new(name)), "{name}");
    }
    assert!(found.keys().any(|name| name.starts_with("figures")));
    // 10⁹ s after 1970 it was 2001-09-09, 01:46:40.
    let page = String::from_utf8(found[Path::new("report.html")].clone()).unwrap();
    assert!(page.contains("2001-09-09T01:46:40Z") && !page.contains("Wall time"));
    assert!(twice(&["check", "tank.json"]).len() > 5);
}

#[test]
fn another_text_than_a_time_is_refused() {
    let home = tempfile::tempdir().unwrap();
    for bad in ["now", "-1", "1.5", "1e9", "300000000000", "a\n::error::b"] {
        let done = run(home.path(), bad, &["check", "tank.json"]);
        let said = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{said}");
        assert!(said.contains("SOURCE_DATE_EPOCH: found") && said.contains("seconds since 1970"), "{said}");
    }
    // An empty one counts as none.
    let done = run(home.path(), "", &["init"]);
    assert!(done.status.success());
}
