//! Which files a tank, set, study or plan names, without reading them.

use std::path::{Path, PathBuf};

use super::diagnostic::{Faults, Source};
use super::study::pattern;
use super::tank::syntax::{self, Kind, Node};

/// Keys whose texts are files relative to the file: tables of spectra, components of a set, tanks, records and hazard of a study, study of a plan.
const KEYS: [&str; 10] = ["along", "across", "up", "file", "files", "hazard", "study", "table", "target", "template"];

/// A file that another one names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mention {
    /// Path of the value, `records[0].along`.
    pub at: String,
    /// The value as written.
    pub text: String,
    /// The file, without the channel that may follow its name.
    pub file: PathBuf,
}

/// What a file names, in its order; a pattern is followed by the files that match. None of a text that is not JSON.
///
/// * `from`: the file itself
pub fn named(from: &Path, text: &str) -> Vec<Mention> {
    let folder = from.parent().unwrap_or(Path::new(""));
    let source = Source::new(from.to_string_lossy(), text);
    let mut found = Vec::new();
    if let Some(root) = syntax::parse(&source, &mut Faults::new()) {
        collect(&root, "", folder, &mut found);
    }
    found
}

fn collect(node: &Node, key: &str, folder: &Path, found: &mut Vec<Mention>) {
    match &node.kind {
        Kind::Object(members) => members.iter().for_each(|member| collect(&member.value, &member.key, folder, found)),
        Kind::List(items) => items.iter().for_each(|item| collect(item, key, folder, found)),
        Kind::Text(text) if KEYS.contains(&key) => {
            let name = text.split('#').next().unwrap_or_default();
            if name.is_empty() {
                return;
            }
            let mention = |file| Mention { at: node.path.clone(), text: text.clone(), file };
            found.push(mention(folder.join(name)));
            if pattern::is_pattern(name) {
                found.extend(pattern::files(folder, name).unwrap_or_default().into_iter().map(mention));
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_by_their_keys() {
        let place = tempfile::tempdir().unwrap();
        for name in ["a.csv", "b.csv", "c.txt"] {
            std::fs::write(place.path().join(name), "").unwrap();
        }
        let named = |text: &str| -> Vec<(String, String, String)> {
            let shown = |path: &Path| path.strip_prefix(place.path()).unwrap().to_string_lossy().into_owned();
            let all = named(&place.path().join("x.json"), text).into_iter();
            all.map(|one| (one.at, one.text, shown(&one.file))).collect()
        };
        let one = |at: &str, text: &str, file: &str| (at.to_owned(), text.to_owned(), file.to_owned());
        assert_eq!(
            named(
                "{ // a set\n \"name\": \"../no\", \"records\": [{ \"along\": \"in/r.V2#2\", \"up\": \"../v.csv\" }] }"
            ),
            [one("records[0].along", "in/r.V2#2", "in/r.V2"), one("records[0].up", "../v.csv", "../v.csv")]
        );
        assert_eq!(
            named(
                "{ \"records\": [{ \"files\": \"*.csv\", \"components\": { \"along\": \"#1\" } }], \"target\": \"site\" }"
            ),
            [
                one("records[0].files", "*.csv", "*.csv"),
                one("records[0].files", "*.csv", "a.csv"),
                one("records[0].files", "*.csv", "b.csv"),
                one("target", "site", "site"),
            ]
        );
        assert!(named("{ \"site\": { \"spectrum\": { \"table\": [[1, 2]] } } }").is_empty() && named("[").is_empty());
    }
}
