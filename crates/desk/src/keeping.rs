//! Files of the folder that are renamed and removed from the page, and what files name.

use std::collections::BTreeSet;
use std::path::{Path as FilePath, PathBuf};
use std::sync::Arc;

use axum::Json;
use axum::extract::{Query, State};
use axum::http::StatusCode;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::api::{Desk, Fault, Own, absent, beside, unwritten};
use crate::office::{Named, Question, Refused};

/// Largest file that may name others [bytes].
const LARGEST: u64 = 4 << 20;

#[derive(Deserialize)]
pub(crate) struct Removed {
    path: String,
    /// Its stamp, as the page has seen it.
    was: String,
    /// Whether it goes though other files name it.
    #[serde(default)]
    named: bool,
}

pub(crate) async fn remove(State(desk): Own, Query(asked): Query<Removed>) -> Result<Json<Value>, Fault> {
    beside(move || {
        let place = unchanged(&desk, &asked.path, &asked.was)?;
        let users = if asked.named { Vec::new() } else { users(&desk, &place) };
        if !users.is_empty() {
            return Err(in_use(&asked.path, &users));
        }
        std::fs::remove_file(&place).map_err(|e| unwritten(&asked.path, &e.to_string()))?;
        Ok(Json(json!({})))
    })
    .await?
}

#[derive(Deserialize)]
pub(crate) struct Renamed {
    path: String,
    to: String,
    was: String,
    /// Whether the files that name it get the new name.
    #[serde(default)]
    named: bool,
}

pub(crate) async fn rename(State(desk): Own, Json(asked): Json<Renamed>) -> Result<Json<Value>, Fault> {
    beside(move || renamed(&desk, &asked)).await?
}

fn renamed(desk: &Arc<Desk>, asked: &Renamed) -> Result<Json<Value>, Fault> {
    let place = unchanged(desk, &asked.path, &asked.was)?;
    let target = desk.folder.inside(&asked.to)?;
    let end = |path: &str| path.rsplit_once('.').map(|(_, end)| end.to_lowercase());
    if end(&asked.to) != end(&asked.path) {
        let expected = end(&asked.path).unwrap_or_default();
        return Err(unfit(format!("`{}`: found another ending, expected `.{expected}`", asked.to)));
    }
    if desk.folder.computed(&asked.to) {
        return Err(unfit(format!("`{}` is in a folder of results", asked.to)));
    }
    if target.symlink_metadata().is_ok() {
        return Err(taken(&asked.to));
    }
    let users = users(desk, &place);
    if !users.is_empty() && !asked.named {
        return Err(in_use(&asked.path, &users));
    }
    // The new texts first: one that cannot be made leaves everything as it is.
    let texts =
        users.iter().map(|(path, named)| with_new_name(desk, path, named, &target)).collect::<Result<Vec<_>, _>>()?;
    if let Some(folder) = target.parent() {
        std::fs::create_dir_all(folder).map_err(|e| unwritten(&asked.to, &e.to_string()))?;
    }
    std::fs::rename(&place, &target).map_err(|e| unwritten(&asked.to, &e.to_string()))?;
    for (place, text) in &texts {
        files::write_whole(place, text.as_bytes())
            .map_err(|e| unwritten(&place.display().to_string(), &e.to_string()))?;
    }
    let changed: Vec<&String> = users.iter().map(|(path, _)| path).collect();
    Ok(Json(json!({ "path": asked.to, "changed": changed })))
}

/// A file and its text with another name for what it names.
fn with_new_name(desk: &Desk, path: &str, named: &[Named], target: &FilePath) -> Result<(PathBuf, String), Fault> {
    let place = desk.folder.inside(path)?;
    let mut text = files::read_text(&place).map_err(|e| unwritten(path, &e.to_string()))?;
    let new = relative(place.parent().unwrap_or(&place), target);
    for one in named {
        if one.text.contains(['*', '?', '[']) {
            return Err(unfit(format!(
                "`{path}` finds the file by the pattern `{}`\n  help: change the pattern first",
                one.text
            )));
        }
        let channel = one.text.find('#').map_or("", |at| &one.text[at..]);
        let value = Some(Value::from(format!("{new}{channel}")));
        let edit = Question::Edit { text, path: one.at.clone(), value };
        let answer =
            desk.office.answer(edit).map_err(|refused| Fault::of(StatusCode::UNPROCESSABLE_ENTITY, refused))?;
        text = answer.get("text").and_then(Value::as_str).unwrap_or_default().to_owned();
    }
    Ok((place, text))
}

/// A path as it is written in a file of `folder`.
fn relative(folder: &FilePath, target: &FilePath) -> String {
    let (mut here, mut there) = (folder.components().peekable(), target.components().peekable());
    while here.peek().is_some() && here.peek() == there.peek() {
        here.next();
        there.next();
    }
    let parts = here.map(|_| "..".to_owned()).chain(there.map(|part| part.as_os_str().to_string_lossy().into_owned()));
    parts.collect::<Vec<_>>().join("/")
}

/// The place of a file that is still what the page has seen, and not a part of results.
fn unchanged(desk: &Desk, path: &str, was: &str) -> Result<PathBuf, Fault> {
    let place = desk.folder.inside(path)?;
    if desk.folder.computed(path) {
        return Err(unfit(format!("`{path}` is in a folder of results")));
    }
    match desk.folder.stamp(path)? {
        None => Err(absent(path)),
        Some(stamp) if stamp != was => {
            Err(Fault::of(StatusCode::CONFLICT, Refused::new(format!("`{path}` was changed since it was listed"))))
        }
        Some(_) => Ok(place),
    }
}

/// The files that name a file, with where they do.
fn users(desk: &Desk, place: &FilePath) -> Vec<(String, Vec<Named>)> {
    let real = |path: &FilePath| path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let own = real(place);
    let naming = desk.folder.naming().into_iter().filter_map(|path| {
        let from = desk.folder.inside(&path).ok()?;
        let mut named = desk.office.named(&from, &files::read_text(&from).ok()?);
        named.retain(|one| real(&one.file) == own);
        (!named.is_empty()).then_some((path, named))
    });
    naming.collect()
}

fn in_use(path: &str, users: &[(String, Vec<Named>)]) -> Fault {
    let names: Vec<&String> = users.iter().map(|(name, _)| name).collect();
    let listed = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let error = json!({ "message": format!("`{path}` is named by {listed}"), "help": Value::Null });
    Fault(StatusCode::CONFLICT, json!({ "error": error, "named": names }))
}

fn taken(path: &str) -> Fault {
    let refused = Refused::new(format!("there is another `{path}` in the folder\n  help: choose another name"));
    Fault::of(StatusCode::CONFLICT, refused)
}

fn unfit(message: String) -> Fault {
    Fault::of(StatusCode::UNPROCESSABLE_ENTITY, Refused::new(message))
}

impl Desk {
    /// All that a file names, and what those files name, must lie in the folder.
    ///
    /// Errors: the place of the name in the file itself, and the refusal.
    pub(crate) fn admits_named(&self, from: &FilePath, text: &str) -> Result<(), (String, Refused)> {
        let mut seen = BTreeSet::from([from.to_owned()]);
        for one in self.office.named(from, text) {
            self.admits_one(&one, &mut seen).map_err(|refused| (one.at.clone(), refused))?;
        }
        Ok(())
    }

    fn admits_one(&self, one: &Named, seen: &mut BTreeSet<PathBuf>) -> Result<(), Refused> {
        let outside = |_| Refused::new(format!("`{}` is not below the opened folder", one.text));
        self.folder.holds(&one.file).map_err(outside)?;
        if !seen.insert(one.file.clone()) {
            return Ok(());
        }
        self.inner(&one.file).iter().try_for_each(|inner| self.admits_one(inner, seen))
    }

    /// The same of a file or folder of a command line.
    ///
    /// Errors: the refusal.
    pub(crate) fn admits_below(&self, place: &FilePath) -> Result<(), Refused> {
        let place = self.folder.root().join(place);
        // A planned study names the file that it was planned from.
        let file = if place.is_dir() { place.join("plan.json") } else { place };
        let mut seen = BTreeSet::from([file.clone()]);
        self.inner(&file).iter().try_for_each(|one| self.admits_one(one, &mut seen))
    }

    /// What a JSON file names.
    fn inner(&self, file: &FilePath) -> Vec<Named> {
        let json = file.extension().is_some_and(|end| end == "json" || end == "jsonc");
        let short = || file.metadata().is_ok_and(|about| about.is_file() && about.len() <= LARGEST);
        if !json || !short() {
            return Vec::new();
        }
        files::read_text(file).map(|text| self.office.named(file, &text)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_written_from_the_folder_of_the_file() {
        let written = |folder: &str, target: &str| relative(FilePath::new(folder), FilePath::new(target));
        assert_eq!(written("/a", "/a/r.csv"), "r.csv");
        assert_eq!(written("/a/sets", "/a/records/r.csv"), "../records/r.csv");
        assert_eq!(written("/a/b/c", "/a/r.csv"), "../../r.csv");
    }
}
