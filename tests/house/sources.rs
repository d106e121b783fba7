//! The workspace as text: its crates, their files, and the paths that each file names.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A module path inside a crate, `["solid", "mesh"]`; empty for the root.
pub(crate) type Module = Vec<String>;

/// A crate of the workspace.
pub(crate) struct Crate {
    /// Name of the package.
    pub name: String,
    /// Names of the workspace's crates among its dependencies.
    pub dependencies: BTreeSet<String>,
    /// Its files without tests, by module.
    pub files: BTreeMap<Module, Source>,
}

/// A file without comments, strings and tests.
pub(crate) struct Source {
    /// Where it is, relative to the root of the workspace.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
}

/// All crates of the workspace.
pub(crate) fn workspace() -> Vec<Crate> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders = vec![root.to_path_buf(), root.join("codes")];
    folders.extend(folders_in(&root.join("crates")));
    let manifests: Vec<(PathBuf, String)> = folders
        .into_iter()
        .map(|folder| {
            let text = std::fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest");
            (folder, text)
        })
        .collect();
    let names: BTreeSet<String> = manifests.iter().map(|(_, text)| package(text)).collect();
    assert!(names.len() > 8, "{names:?}");
    manifests
        .iter()
        .map(|(folder, text)| Crate {
            name: package(text),
            dependencies: dependencies(text).filter(|d| names.contains(d)).collect(),
            files: sources(root, &folder.join("src")),
        })
        .collect()
}

fn folders_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").flatten();
    let mut found: Vec<PathBuf> = entries.map(|e| e.path()).filter(|p| p.is_dir()).collect();
    found.sort();
    found
}

fn package(manifest: &str) -> String {
    let after = manifest.split("[package]").nth(1).expect("a package");
    let line = after.lines().find(|l| l.starts_with("name")).expect("a name");
    line.split('"').nth(1).expect("a quoted name").to_owned()
}

/// Names under `[dependencies]`; what only tests and benchmarks use is not held by walls.
fn dependencies(manifest: &str) -> impl Iterator<Item = String> {
    let section = manifest.split("\n[dependencies]\n").nth(1).unwrap_or_default();
    section
        .lines()
        .take_while(|l| !l.starts_with('['))
        .filter_map(|l| l.split(['.', ' ', '=']).next())
        .filter(|name| !name.is_empty() && !name.starts_with('#'))
        .map(str::to_owned)
}

fn sources(root: &Path, src: &Path) -> BTreeMap<Module, Source> {
    let mut found = BTreeMap::new();
    let mut folders = vec![src.to_path_buf()];
    while let Some(folder) = folders.pop() {
        folders.extend(folders_in(&folder));
        let files = std::fs::read_dir(&folder).expect("a folder").flatten().map(|e| e.path());
        for path in files.filter(|p| p.extension().is_some_and(|e| e == "rs")) {
            let relative = path.strip_prefix(src).expect("below src").with_extension("");
            let mut module: Module = relative.iter().map(|p| p.to_string_lossy().into_owned()).collect();
            if module.iter().any(|part| part.contains("test") && part != "selftest") {
                continue;
            }
            assert!(!relative.ends_with("mod"), "{}: a module stands in `x.rs` beside `x/`", path.display());
            // A program beside a library is a module of its own.
            let root_of = |name: &str| module == [name] && (name == "lib" || !src.join("lib.rs").exists());
            if root_of("lib") || root_of("main") {
                module.pop();
            }
            let text = code(&std::fs::read_to_string(&path).expect("readable"));
            let path = path.strip_prefix(root).expect("below the root").to_path_buf();
            found.insert(module, Source { path, text });
        }
    }
    found
}

/// The text without comments, the contents of strings, and everything from the first module of tests on.
fn code(text: &str) -> String {
    let text = text.split("\nmod tests {").next().unwrap_or_default();
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let mut quoted = false;
        let mut before = ' ';
        let mut rest = line.chars().peekable();
        while let Some(c) = rest.next() {
            match c {
                '/' if !quoted && rest.peek() == Some(&'/') => break,
                '"' if before != '\\' && before != '\'' => quoted = !quoted,
                _ if quoted => {}
                _ => out.push(c),
            }
            before = c;
        }
        out.push('\n');
    }
    out
}

/// Every path that a `use` declaration names, `crate::a::{b, c::d}` as `crate::a::b` and `crate::a::c::d`.
pub(crate) fn uses(text: &str, exported: bool) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices("use ") {
        let line = text[..at].rsplit('\n').next().unwrap_or_default().trim();
        let public = line.starts_with("pub");
        if !(line.is_empty() || public) || public != exported {
            continue;
        }
        let Some(end) = text[at..].find(';') else { continue };
        let tree: String = text[at + 4..at + end].split_whitespace().collect::<Vec<_>>().join(" ");
        expand("", &tree, &mut found);
    }
    found
}

fn expand(before: &str, tree: &str, found: &mut Vec<String>) {
    let tree = tree.trim();
    let Some(open) = tree.find('{') else {
        let path = tree.split(" as ").next().unwrap_or_default().trim();
        if !path.is_empty() {
            found.push(format!("{before}{path}"));
        }
        return;
    };
    let before = format!("{before}{}", &tree[..open]);
    let inner = &tree[open + 1..tree.rfind('}').unwrap_or(tree.len())];
    let (mut depth, mut start) = (0, 0);
    for (i, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                expand(&before, &inner[start..i], found);
                start = i + 1;
            }
            _ => {}
        }
    }
    expand(&before, &inner[start..], found);
}

/// Paths named outside `use` declarations: `a::b::c`.
pub(crate) fn paths(text: &str) -> BTreeSet<String> {
    let part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    statements(text)
        .flat_map(|line| line.split(move |c| !part(c)))
        .filter(|word| word.contains("::") && !word.starts_with(':'))
        .map(|word| word.trim_end_matches(':').to_owned())
        .collect()
}

/// The lines that belong to no `use` declaration.
fn statements(text: &str) -> impl Iterator<Item = &str> {
    let mut inside = false;
    text.lines().filter(move |line| {
        let words = line.trim_start();
        let visible = words.strip_prefix("pub").map_or(words, |rest| {
            let rest = rest.strip_prefix('(').and_then(|r| r.split_once(')')).map_or(rest, |(_, r)| r);
            rest.trim_start()
        });
        let begins = visible.starts_with("use ");
        let keep = !inside && !begins;
        inside = (inside || begins) && !line.contains(';');
        keep
    })
}
