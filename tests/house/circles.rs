//! Circles: files that import each other are understood only together. No circle has more than three files.
//!
//! An import leads to the file that defines the item; a `pub use` on the way is a table of contents and no import.

use std::collections::{BTreeMap, BTreeSet};

use crate::sources::{Crate, Module, paths, uses, workspace};

/// Largest circle allowed [files].
const LARGEST: usize = 3;

/// Name of a re-exported item → the module that defines it.
type Exports = BTreeMap<Module, BTreeMap<String, Module>>;

/// The module that a path leads to, and the rest of the path.
fn locate(found: &Crate, from: &Module, path: &str) -> Option<(Module, Vec<String>)> {
    let mut parts = path.split("::").map(str::trim).peekable();
    let mut module = match *parts.peek()? {
        "crate" => {
            parts.next();
            Vec::new()
        }
        "self" | "super" => {
            let mut module = from.clone();
            while let Some(&part) = parts.peek() {
                match part {
                    "self" => {}
                    "super" => drop(module.pop()),
                    _ => break,
                }
                parts.next();
            }
            module
        }
        child if found.files.contains_key(&[from.clone(), vec![child.to_owned()]].concat()) => from.clone(),
        _ => return None,
    };
    while let Some(&part) = parts.peek() {
        module.push(part.to_owned());
        if !found.files.contains_key(&module) {
            module.pop();
            break;
        }
        parts.next();
    }
    found.files.contains_key(&module).then(|| (module, parts.map(str::to_owned).collect()))
}

fn exports(found: &Crate) -> Exports {
    let mut all = Exports::new();
    for (module, source) in &found.files {
        for path in uses(&source.text, true) {
            if let (Some((target, _)), Some(name)) = (locate(found, module, &path), path.rsplit("::").next()) {
                all.entry(module.clone()).or_default().insert(name.to_owned(), target);
            }
        }
    }
    all
}

/// Who imports whom.
fn imports(found: &Crate) -> BTreeMap<Module, BTreeSet<Module>> {
    let exports = exports(found);
    let of = |(module, source): (&Module, &crate::sources::Source)| {
        let named = uses(&source.text, false).into_iter().chain(paths(&source.text));
        let targets = named
            .filter_map(|path| locate(found, module, &path))
            .map(|(mut target, rest)| {
                let mut steps = 0;
                while let Some(next) = rest.first().and_then(|item| exports.get(&target)?.get(item)) {
                    steps += 1;
                    if *next == target || steps > 4 {
                        break;
                    }
                    target = next.clone();
                }
                target
            })
            .filter(|target| target != module);
        (module.clone(), targets.collect())
    };
    found.files.iter().map(of).collect()
}

/// Modules that can be reached from one.
fn reach(imports: &BTreeMap<Module, BTreeSet<Module>>, from: &Module) -> BTreeSet<Module> {
    let mut seen = BTreeSet::new();
    let mut next: Vec<&Module> = imports[from].iter().collect();
    while let Some(module) = next.pop() {
        if seen.insert(module.clone()) {
            next.extend(&imports[module]);
        }
    }
    seen
}

/// Groups of files that import each other, directly or through others.
fn circles(imports: &BTreeMap<Module, BTreeSet<Module>>) -> BTreeSet<BTreeSet<Module>> {
    let reached: BTreeMap<&Module, BTreeSet<Module>> = imports.keys().map(|m| (m, reach(imports, m))).collect();
    let circle = |module: &Module| -> BTreeSet<Module> {
        let back = reached[module].iter().filter(|other| reached[other].contains(module));
        back.cloned().collect()
    };
    imports.keys().map(circle).filter(|c| c.len() > 1).collect()
}

#[test]
fn no_circle_has_more_than_three_files() {
    let mut large: Vec<String> = Vec::new();
    for found in workspace() {
        for circle in circles(&imports(&found)).iter().filter(|c| c.len() > LARGEST) {
            let names: Vec<String> = circle.iter().map(|m| m.join("/")).collect();
            large.push(format!("{}: {}", found.name, names.join(" ")));
        }
    }
    assert!(large.is_empty(), "{large:#?}");
}

#[test]
fn a_circle_is_found() {
    let module = |name: &str| vec![name.to_owned()];
    let edges = [("a", "b"), ("b", "c"), ("c", "a"), ("d", "a")];
    let mut imports: BTreeMap<Module, BTreeSet<Module>> =
        ["a", "b", "c", "d"].iter().map(|m| (module(m), BTreeSet::new())).collect();
    for (from, to) in edges {
        imports.entry(module(from)).or_default().insert(module(to));
    }
    let found = circles(&imports);
    assert_eq!(found.len(), 1);
    assert_eq!(found.first().map(BTreeSet::len), Some(3));
}
