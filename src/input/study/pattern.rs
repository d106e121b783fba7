//! Files that match a pattern with `*`, `?`, `[…]` and `**`, with a bound on the entries of folders that are looked at.

use std::path::{Component, Path, PathBuf};

use glob::Pattern;

/// Most files of a pattern.
pub(super) const MOST_FILES: usize = 10_000;
/// Most entries of folders that a pattern may look at.
pub(super) const MOST_ENTRIES: usize = 100_000;

/// Why a pattern gives no files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::input) enum Refused {
    /// It is not a pattern.
    Faulty(String),
    /// More than [`MOST_FILES`].
    Files,
    /// More than [`MOST_ENTRIES`].
    Entries,
}

/// Whether a text is a pattern, not the name of one file.
pub(in crate::input) fn is_pattern(text: &str) -> bool {
    text.contains(['*', '?', '['])
}

/// The regular files that match, sorted. Folders that cannot be read have none.
///
/// * `text`: relative to the folder
///
/// Errors: a faulty or unbounded pattern.
pub(in crate::input) fn files(folder: &Path, text: &str) -> Result<Vec<PathBuf>, Refused> {
    let mut walk = Walk { parts: Vec::new(), entries: 0, found: Vec::new() };
    let mut from = folder.to_path_buf();
    for part in Path::new(text).components() {
        let name = part.as_os_str().to_string_lossy();
        match part {
            Component::Normal(_) if name == "**" => walk.parts.push(Part::Any),
            Component::Normal(_) if is_pattern(&name) => {
                let pattern = Pattern::new(&name).map_err(|e| Refused::Faulty(e.to_string()))?;
                walk.parts.push(Part::Pattern(pattern));
            }
            _ if walk.parts.is_empty() => from.push(part),
            _ => walk.parts.push(Part::Name(part.as_os_str().into())),
        }
    }
    walk.follow(&from, 0)?;
    let mut found = walk.found;
    found.sort();
    found.dedup();
    Ok(found)
}

enum Part {
    Name(PathBuf),
    Pattern(Pattern),
    /// Any number of folders.
    Any,
}

struct Walk {
    parts: Vec<Part>,
    entries: usize,
    found: Vec<PathBuf>,
}

impl Walk {
    /// Follows the parts from one of them on.
    fn follow(&mut self, path: &Path, from: usize) -> Result<(), Refused> {
        match self.parts.get(from) {
            None if path.is_file() => {
                self.found.push(path.to_path_buf());
                if self.found.len() > MOST_FILES { Err(Refused::Files) } else { Ok(()) }
            }
            None => Ok(()),
            Some(Part::Name(name)) => {
                let next = path.join(name);
                self.follow(&next, from + 1)
            }
            Some(Part::Pattern(pattern)) => {
                let pattern = pattern.clone();
                for (name, _) in self.list(path)? {
                    if pattern.matches(&name) {
                        self.follow(&path.join(&name), from + 1)?;
                    }
                }
                Ok(())
            }
            Some(Part::Any) => {
                self.follow(path, from + 1)?;
                // A link may lead back to a folder above it.
                for (name, folder) in self.list(path)? {
                    if folder {
                        self.follow(&path.join(&name), from)?;
                    }
                }
                Ok(())
            }
        }
    }

    /// Names in a folder, and whether each is a folder itself, not a link to one.
    fn list(&mut self, folder: &Path) -> Result<Vec<(String, bool)>, Refused> {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let mut names = Vec::new();
        self.entries += 1;
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            self.entries += 1;
            if self.entries > MOST_ENTRIES {
                return Err(Refused::Entries);
            }
            let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
            names.push((entry.file_name().to_string_lossy().into_owned(), is_folder));
        }
        Ok(names)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path, pattern: &str) -> Vec<String> {
        let files = files(folder, pattern).unwrap();
        let name = |path: &PathBuf| path.strip_prefix(folder).unwrap().to_string_lossy().into_owned();
        files.iter().map(name).collect()
    }

    #[test]
    fn patterns_find_regular_files() {
        let home = tempfile::tempdir().unwrap();
        let home = home.path();
        for file in ["a.csv", "b.csv", "b.txt", "sub/c.csv", "sub/deep/d.csv"] {
            let path = home.join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "").unwrap();
        }
        std::fs::create_dir(home.join("folder.csv")).unwrap();
        assert_eq!(names(home, "*.csv"), ["a.csv", "b.csv"]);
        assert_eq!(names(home, "[!a].*"), ["b.csv", "b.txt"]);
        assert_eq!(names(home, "*/c.csv"), ["sub/c.csv"]);
        assert_eq!(names(home, "sub/../?.txt").len(), 1);
        assert_eq!(names(home, "**/*.csv"), ["a.csv", "b.csv", "sub/c.csv", "sub/deep/d.csv"]);
        assert_eq!(names(home, "**/deep/*"), ["sub/deep/d.csv"]);
        assert!(matches!(files(home, "[a"), Err(Refused::Faulty(_))));
    }

    /// Any number of `**` walks the folders again and again: the bound holds for all of them together.
    #[test]
    fn a_pattern_is_bounded() {
        let home = tempfile::tempdir().unwrap();
        let mut deep = home.path().to_path_buf();
        for k in 0..24 {
            deep.push(format!("{k}"));
        }
        std::fs::create_dir_all(&deep).unwrap();
        let began = std::time::Instant::now();
        let stars = "**/".repeat(12) + "x";
        assert_eq!(files(home.path(), &stars), Err(Refused::Entries));
        assert!(began.elapsed().as_secs() < 20);
    }
}
