//! `set.json`: the records of a set, and what is asked of it.

mod keys;

use std::path::{Path, PathBuf};

use ::tank::hazard::SpectrumTable;
use codes::record_set::standard::{Combine, Standard};
use files::code::Code;

use crate::input::diagnostic::{Faults, Source};
use crate::input::records::{self, ReadOptions};
use crate::input::tank::bytes;
use crate::input::tank::read::{Field, FromNode, Opt};
use crate::input::tank::resolver::{Resolver, record_unit};
use crate::input::tank::{schema, syntax};
use crate::input::target;
use files::error::Error;
use keys::{SetCode, SetCombine, SetFile, SetRecord};

/// An earthquake of a set: one file a component.
#[derive(Clone, Debug, PartialEq)]
pub struct SetEntry {
    /// Its name; none for that of its file.
    pub name: Option<String>,
    /// Along x.
    pub along: PathBuf,
    /// Along y.
    pub across: Option<PathBuf>,
    /// Upwards.
    pub up: Option<PathBuf>,
    /// Factor on it.
    pub scale: f64,
    /// How it is read.
    pub options: ReadOptions,
}

/// A resolved set file.
#[derive(Clone, Debug, PartialEq)]
pub struct SetInput {
    /// Title.
    pub name: String,
    /// Standard whose rules are asked; none for that of the site.
    pub code: Option<Standard>,
    /// Design value, where it is asked for.
    pub combine: Option<Combine>,
    /// Target; none for the spectrum of the site.
    pub table: Option<SpectrumTable>,
    /// Name of the target.
    pub target: String,
    /// Factor on all records.
    pub factor: f64,
    /// Whether the set is scaled to the rule.
    pub fit: bool,
    /// The records.
    pub entries: Vec<SetEntry>,
    /// SHA-256 of the file; empty without one.
    pub sha256: String,
}

/// Reads and resolves a set file. All its faults are reported at once.
///
/// Errors: a file that cannot be read; faults of its keys and values; a record or table that is no file, a table that cannot be read.
pub fn read(path: &Path) -> Result<SetInput, Error> {
    let (source, sha256) = bytes::read(path)?;
    let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
    let mut faults = Faults::new();
    let mut broken = None;
    let found = parse(&source, &folder, &mut faults, &mut broken);
    match (found, broken) {
        (_, _) if !faults.is_empty() => Err(faults.into_error(&source)),
        (_, Some(error)) => Err(error),
        (Some(set), None) => Ok(SetInput { sha256, ..set }),
        (None, None) => Err(faults.into_error(&source)),
    }
}

/// The JSON Schema of `set.json`, draft 2020-12.
pub fn json_schema() -> serde_json::Value {
    schema::of::<SetFile>("set.json", "SetFile", |_| {})
}

fn parse(source: &Source, folder: &Path, faults: &mut Faults, broken: &mut Option<Error>) -> Option<SetInput> {
    let mut root = syntax::parse(source, faults)?;
    if let syntax::Kind::Object(members) = &mut root.kind {
        members.retain(|m| m.key != "$schema");
    }
    let file = SetFile::from_node(&root, faults)?;
    let mut r = Resolver::new(faults);
    if let Some(notes) = &file.notes.given {
        r.echo_given(notes);
    }
    let name = file.name.given.as_ref().and_then(|field| r.text(field));
    let code = file.code.given.as_ref().and_then(|field| field.value).map(|code| match code {
        SetCode::En1998 => Standard::En1998,
        SetCode::Asce716 => Standard::Asce716,
    });
    let combine = file.combine.given.as_ref().and_then(|field| field.value).map(|combine| match combine {
        SetCombine::Mean => Combine::Mean,
        SetCombine::Worst => Combine::Worst,
    });
    let target = file.target.given.as_ref().and_then(|field| r.text(field));
    let target = target.unwrap_or_else(|| "site".into());
    let table = match target.as_str() {
        "site" => None,
        name => match target::read(&folder.join(name), None) {
            Ok(table) => Some(table),
            Err(error) => {
                *broken = Some(error);
                None
            }
        },
    };
    let factor = r.or_default(&file.factor);
    let fit = r.or_default(&file.fit);
    r.sized(&file.records, "records");
    let mut entries: Vec<SetEntry> = Vec::new();
    for item in file.records.value.iter().flatten() {
        if let Some(given) = &item.value {
            entries.extend(entry(&mut r, given, folder));
        }
    }
    Some(SetInput {
        name: name.unwrap_or_default(),
        code,
        combine,
        table,
        target,
        factor,
        fit,
        entries,
        sha256: String::new(),
    })
}

fn entry(r: &mut Resolver<'_>, given: &SetRecord, folder: &Path) -> Option<SetEntry> {
    let options =
        ReadOptions { unit: record_unit(r, &given.units), dt: r.optional(&given.dt), ..ReadOptions::default() };
    let along = file(r, &given.along, folder);
    let mut other = |option: &Opt<String>| option.given.as_ref().and_then(|field| file(r, field, folder));
    let (across, up) = (other(&given.across), other(&given.up));
    Some(SetEntry {
        name: given.name.given.as_ref().and_then(|field| r.text(field)),
        scale: r.or_default(&given.scale),
        along: along?,
        across,
        up,
        options,
    })
}

/// A file, or a channel of one, relative to the set file.
fn file(r: &mut Resolver<'_>, field: &Field<String>, folder: &Path) -> Option<PathBuf> {
    let path = folder.join(r.text(field)?);
    if !records::located(&path).0.is_file() {
        let message = "no such file";
        let allowed = "a record, or FILE#CHANNEL, relative to the set file";
        r.refuse(Code::FileUnreadable, field, message, allowed);
        return None;
    }
    Some(path)
}
