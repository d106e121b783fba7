//! The opened folder. What lies outside is neither read nor written, whether a path climbs, is absolute or follows a link.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Component, Path, PathBuf};
use std::time::SystemTime;

use serde::Serialize;
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::office::Refused;

/// Levels of folders that are searched for files.
const DEPTH: usize = 5;
/// Most files and folders that are listed.
const MOST: usize = 5_000;
/// Largest JSON file whose kind is looked at [bytes].
const LARGEST: u64 = 4 << 20;

/// A folder.
#[derive(Clone, Debug)]
pub struct Folder(PathBuf);

/// What a folder holds.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Contents {
    files: Vec<Item>,
    results: Vec<Found>,
    /// Whether there is more than is listed.
    more: bool,
}

#[derive(Debug, Serialize)]
struct Item {
    path: String,
    kind: &'static str,
    size: u64,
    /// Seconds since 1970.
    modified: u64,
    /// Another one after a change.
    stamp: String,
}

/// A folder of results.
#[derive(Debug, Serialize)]
struct Found {
    path: String,
    kind: String,
    name: Option<String>,
    created: Option<String>,
    status: Option<String>,
    scene: bool,
    /// Names that its manifest lists.
    files: Vec<String>,
    modified: u64,
}

impl Folder {
    /// Errors: the path does not lead to a folder.
    pub fn open(path: &Path) -> std::io::Result<Folder> {
        let root = path.canonicalize()?;
        match root.is_dir() {
            true => Ok(Folder(root)),
            false => Err(std::io::Error::from(std::io::ErrorKind::NotADirectory)),
        }
    }

    /// Its absolute path.
    pub fn root(&self) -> &Path {
        &self.0
    }

    /// The place of a relative path, whether there is something or not.
    ///
    /// Errors: a place outside, or one whose name begins with a dot.
    pub fn inside(&self, relative: &str) -> Result<PathBuf, Refused> {
        let outside = || Refused::new(format!("`{relative}` is not below the opened folder"));
        let path = Path::new(relative);
        let plain = |part: Component<'_>| match part {
            Component::Normal(name) => name.to_str().is_some_and(|name| !name.starts_with('.') || name == "."),
            _ => false,
        };
        if relative.is_empty() || relative.contains(['\\', '\0', ':']) || !path.components().all(plain) {
            return Err(outside());
        }
        let place = self.0.join(path);
        // What exists of it, links followed, must lie inside.
        let mut known = place.as_path();
        let real = loop {
            match known.canonicalize() {
                Ok(real) => break real,
                // A link to nothing would be written through.
                Err(_) if known.is_symlink() => return Err(outside()),
                Err(_) => known = known.parent().ok_or_else(outside)?,
            }
        };
        if real.starts_with(&self.0) { Ok(place) } else { Err(outside()) }
    }

    /// A path on a command line, relative to the folder or absolute, must lie inside.
    ///
    /// Errors: as [`Folder::inside`].
    pub(crate) fn admits(&self, path: &Path) -> Result<(), Refused> {
        let relative = path.strip_prefix(&self.0).unwrap_or(path);
        // `FILE#CHANNEL` names a channel; the name of the file ends before `#`.
        let text = relative.to_string_lossy();
        let name = text.split('#').next().unwrap_or_default();
        let trimmed = name.strip_prefix("./").unwrap_or(name).trim_end_matches('/');
        self.inside(trimmed).map(|_| ())
    }

    /// A place that another file names must lie inside, as it is written and as the system follows it.
    ///
    /// Errors: as [`Folder::inside`].
    pub(crate) fn holds(&self, place: &Path) -> Result<(), Refused> {
        let mut written = PathBuf::new();
        for part in place.components() {
            match part {
                Component::ParentDir if written.pop() => {}
                Component::CurDir => {}
                part => written.push(part),
            }
        }
        self.admits(&written)?;
        match place.canonicalize() {
            Ok(real) if !real.starts_with(&self.0) => {
                Err(Refused::new(format!("`{}` is not below the opened folder", place.display())))
            }
            _ => Ok(()),
        }
    }

    /// Stamp of a file, which changes with its contents and needs no reading; none where there is no file.
    pub(crate) fn stamp(&self, relative: &str) -> Result<Option<String>, Refused> {
        let about = self.inside(relative)?.metadata().ok().filter(std::fs::Metadata::is_file);
        Ok(about.map(|about| stamp(&about)))
    }

    /// Whether a file lies in a folder of results.
    pub(crate) fn computed(&self, relative: &str) -> bool {
        let above = Path::new(relative).ancestors().skip(1);
        above.into_iter().any(|folder| self.0.join(folder).join(files::MANIFEST_FILE).is_file())
    }

    /// A number for what the folder holds, as deep as [`Folder::contents`] looks: another one after a file has come, gone or changed.
    pub(crate) fn state(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        let mut left = MOST;
        self.look(Path::new(""), 0, &mut left, &mut hasher);
        hasher.finish()
    }

    fn look(&self, below: &Path, depth: usize, left: &mut usize, hasher: &mut DefaultHasher) {
        let Ok(entries) = std::fs::read_dir(self.0.join(below)) else { return };
        for entry in entries.flatten() {
            if *left == 0 {
                return;
            }
            *left -= 1;
            let name = entry.file_name();
            let Some(name) = name.to_str().filter(|name| !name.starts_with('.')) else { continue };
            let (path, Ok(about)) = (below.join(name), entry.metadata()) else { continue };
            (&path, about.len(), about.modified().ok()).hash(hasher);
            if !about.is_dir() {
                continue;
            }
            // The manifest of a results folder is written last, so its time stands for the whole folder.
            match self.0.join(&path).join(files::MANIFEST_FILE).metadata() {
                Ok(manifest) => manifest.modified().ok().hash(hasher),
                Err(_) if depth < DEPTH => self.look(&path, depth + 1, left, hasher),
                Err(_) => {}
            }
        }
    }

    /// Paths of the files that may name others.
    pub(crate) fn naming(&self) -> Vec<String> {
        let kept = |item: &Item| matches!(item.kind, "tank" | "set" | "study");
        self.contents().files.into_iter().filter(kept).map(|item| item.path).collect()
    }

    /// Tank files, records, sets and results, by their paths.
    pub(crate) fn contents(&self) -> Contents {
        let mut found = Contents::default();
        self.search(Path::new(""), 0, &mut found);
        found.files.sort_by(|a, b| a.path.cmp(&b.path));
        found.results.sort_by(|a, b| b.modified.cmp(&a.modified).then_with(|| a.path.cmp(&b.path)));
        found
    }

    fn search(&self, below: &Path, depth: usize, found: &mut Contents) {
        let Ok(entries) = std::fs::read_dir(self.0.join(below)) else { return };
        for entry in entries.flatten() {
            if found.files.len() + found.results.len() >= MOST {
                found.more = true;
                return;
            }
            let name = entry.file_name();
            let Some(name) = name.to_str().filter(|name| !name.starts_with('.')) else { continue };
            let (path, Ok(kind)) = (below.join(name), entry.file_type()) else { continue };
            if kind.is_dir() {
                match self.result(&path) {
                    Some(result) => found.results.push(result),
                    None if depth < DEPTH => self.search(&path, depth + 1, found),
                    None => found.more = true,
                }
            } else if kind.is_file()
                && let Some(item) = self.item(&path, name)
            {
                found.files.push(item);
            }
        }
    }

    fn item(&self, path: &Path, name: &str) -> Option<Item> {
        let place = self.0.join(path);
        let about = place.metadata().ok()?;
        let end = name.rsplit_once('.').map_or("", |(_, end)| end).to_ascii_lowercase();
        let kind = match end.as_str() {
            "json" | "jsonc" if about.len() <= LARGEST => kind_of(&files::read_text(&place).ok()?),
            "csv" | "tsv" | "txt" | "dat" | "asc" | "at2" | "v1" | "v2" | "v1a" | "v2a" | "v1c" | "v2c" | "smc"
            | "sac" | "th" | "acc" | "knt" | "ew" | "ns" | "ud" | "ew1" | "ns1" | "ud1" | "ew2" | "ns2" | "ud2" => {
                "record"
            }
            _ => "other",
        };
        let modified = seconds(about.modified().ok());
        Some(Item { path: slashed(path), kind, size: about.len(), modified, stamp: stamp(&about) })
    }

    /// A folder with a manifest.
    fn result(&self, path: &Path) -> Option<Found> {
        let place = self.0.join(path);
        let manifest = place.join(files::MANIFEST_FILE);
        let about = manifest.metadata().ok()?;
        let listed: Value = serde_json::from_str(&files::read_text(&manifest).ok()?).ok()?;
        let kind = listed.get("kind")?.as_str()?.to_owned();
        let data = data_file(&listed);
        let head = data.and_then(|name| serde_json::from_str::<Value>(&files::read_text(&place.join(name)).ok()?).ok());
        let text = |path: &str| {
            let value = head.as_ref().and_then(|head| head.pointer(path));
            value.and_then(Value::as_str).map(str::to_owned)
        };
        Some(Found {
            path: slashed(path),
            kind,
            name: text("/name"),
            created: text("/volatile/created"),
            status: text("/verdict/status"),
            scene: owns(&listed, "scene.json"),
            files: names(&listed).map(str::to_owned).collect(),
            modified: seconds(about.modified().ok()),
        })
    }

    /// A file that the manifest of a folder of results lists, or the manifest.
    ///
    /// Errors: a folder without a manifest, a file that it does not list.
    pub(crate) fn owned(&self, folder: &str, name: &str) -> Result<PathBuf, Refused> {
        let none = || Refused::new(format!("`{folder}` holds no result `{name}`"));
        let place = self.inside(folder)?;
        let text = files::read_text(&place.join(files::MANIFEST_FILE)).map_err(|_| none())?;
        let listed: Value = serde_json::from_str(&text).map_err(|_| none())?;
        if name != files::MANIFEST_FILE && !owns(&listed, name) {
            return Err(none());
        }
        self.inside(&format!("{folder}/{name}"))
    }

    /// The file with the numbers of a folder of results.
    ///
    /// Errors: as [`Folder::owned`].
    pub(crate) fn data(&self, folder: &str) -> Result<PathBuf, Refused> {
        let none = || Refused::new(format!("`{folder}` holds no results"));
        let place = self.inside(folder)?;
        let text = files::read_text(&place.join(files::MANIFEST_FILE)).map_err(|_| none())?;
        let listed: Value = serde_json::from_str(&text).map_err(|_| none())?;
        let name = data_file(&listed).ok_or_else(none)?.to_owned();
        self.inside(&format!("{folder}/{name}"))
    }
}

fn owns(manifest: &Value, name: &str) -> bool {
    manifest.get("files").is_some_and(|files| files.get(name).is_some())
}

/// Names of the files that a manifest lists.
fn names(manifest: &Value) -> impl Iterator<Item = &str> {
    manifest.get("files").and_then(Value::as_object).into_iter().flat_map(|files| files.keys().map(String::as_str))
}

/// `results.json`, or the first other file of numbers.
fn data_file(manifest: &Value) -> Option<&str> {
    let own = ["results.json", "push.json", "ida.json", "study.json", "base.json"];
    own.into_iter()
        .find(|name| owns(manifest, name))
        .or_else(|| names(manifest).find(|name| name.ends_with(".json") && *name != "scene.json"))
}

/// What a JSON file is, by the keys that only such a file has.
fn kind_of(text: &str) -> &'static str {
    let has = |key: &str| text.contains(&format!("\"{key}\""));
    match () {
        () if has("tank") && has("liquid") => "tank",
        () if has("records") && has("tanks") => "study",
        () if has("records") => "set",
        () => "other",
    }
}

fn slashed(path: &Path) -> String {
    path.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/")
}

fn seconds(time: Option<SystemTime>) -> u64 {
    time.and_then(|time| time.duration_since(SystemTime::UNIX_EPOCH).ok()).map_or(0, |span| span.as_secs())
}

/// Size and time of a file.
fn stamp(about: &std::fs::Metadata) -> String {
    let time = about.modified().ok().and_then(|time| time.duration_since(SystemTime::UNIX_EPOCH).ok());
    format!("{}-{}", about.len(), time.map_or(0, |span| span.as_nanos()))
}

/// Hash of a file's bytes, as hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_outside_is_reached() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("opened");
        std::fs::create_dir_all(root.join("deep")).unwrap();
        std::fs::write(place.path().join("secret"), "x").unwrap();
        let folder = Folder::open(&root).unwrap();
        for path in
            ["../secret", "/etc/passwd", "deep/../../secret", "..", "", "a\\b", "C:x", "a\0b", ".ssh/id", "deep/.x"]
        {
            assert!(folder.inside(path).is_err(), "{path}");
        }
        for path in ["tank.json", "deep/new.json", "new/new.json"] {
            assert!(folder.inside(path).is_ok(), "{path}");
        }
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(place.path(), root.join("out")).unwrap();
            std::os::unix::fs::symlink(place.path().join("nothing"), root.join("broken")).unwrap();
            assert!(folder.inside("out/secret").is_err());
            assert!(folder.inside("out").is_err());
            assert!(folder.inside("broken").is_err());
        }
        assert!(folder.admits(Path::new("../secret")).is_err());
        assert!(folder.admits(&place.path().join("secret")).is_err());
        assert!(folder.admits(Path::new("./deep/")).is_ok());
        assert!(folder.admits(&folder.root().join("r.csv#2")).is_ok());
        // What another file names may climb, but not leave.
        let from = folder.root().join("deep");
        assert!(folder.holds(&from.join("../tank.json")).is_ok() && folder.holds(&from.join("./r.csv")).is_ok());
        for path in ["../../secret", "/etc/passwd", "../../opened-too/x", "../.x"] {
            assert!(folder.holds(&from.join(path)).is_err(), "{path}");
        }
        #[cfg(unix)]
        {
            // The system goes up from where a link leads, not from where it stands.
            std::fs::create_dir(place.path().join("other")).unwrap();
            std::fs::write(root.join("secret"), "own").unwrap();
            std::os::unix::fs::symlink(place.path().join("other"), root.join("way")).unwrap();
            assert!(folder.holds(&folder.root().join("way/../secret")).is_err());
        }
    }

    /// Changes down to the depth that is shown, and no deeper.
    #[test]
    fn changes_are_seen_where_files_are_shown() {
        let place = tempfile::tempdir().unwrap();
        let folder = Folder::open(place.path()).unwrap();
        let shown = place.path().join("a/b/c/d/e");
        std::fs::create_dir_all(shown.join("f")).unwrap();
        let mut last = folder.state();
        assert_eq!(folder.state(), last);
        let mut moved = |what: &str| {
            let now = folder.state();
            assert_ne!(now, last, "{what}");
            last = now;
        };
        std::fs::write(shown.join("tank.json"), "{ \"tank\": 1, \"liquid\": 2 }").unwrap();
        moved("come");
        assert_eq!(folder.contents().files.len(), 1);
        std::fs::write(shown.join("tank.json"), "{ \"tank\": 1, \"liquid\": 23 }").unwrap();
        moved("changed");
        std::fs::rename(shown.join("tank.json"), shown.join("other.json")).unwrap();
        moved("renamed");
        std::fs::remove_file(shown.join("other.json")).unwrap();
        moved("gone");
        // Of results the manifest alone is looked at.
        std::fs::create_dir(place.path().join("out")).unwrap();
        std::fs::write(place.path().join("out").join(files::MANIFEST_FILE), "{}").unwrap();
        moved("results");
        let now = folder.state();
        std::fs::create_dir(place.path().join("out/figures")).unwrap();
        let there = folder.state();
        std::fs::write(place.path().join("out/figures/wall.svg"), "x").unwrap();
        assert!(now != there && folder.state() == there);
    }
}
