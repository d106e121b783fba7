//! `records`: files, and which component each is.

use std::path::{Path, PathBuf};

use super::keys::{Components, Records};
use super::{matching, name_of};
use crate::input::records::{self, Processing, ReadOptions, ReadRecord};
use crate::input::tank::read::{Field, Opt};
use crate::input::tank::resolver::{Resolver, range_fault, record_unit};
use files::code::Code;
use files::error::Error;
use oscillator::record::Record;

/// An earthquake of a study: one file, or one a component.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordEntry {
    /// Its name in the rows, unique in the study.
    pub id: String,
    /// Along x.
    pub along: PathBuf,
    /// Along y.
    pub across: Option<PathBuf>,
    /// Upwards.
    pub up: Option<PathBuf>,
    options: ReadOptions,
}

/// The ground motion of an earthquake, processed as a tank file asks for, before the scale of the study.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaking {
    /// Along x.
    pub along: Record,
    /// Along y.
    pub across: Option<Record>,
    /// Upwards.
    pub up: Option<Record>,
    /// Longest period of which every horizontal component says something [s], where a file gives the corner of its filter.
    pub usable: Option<f64>,
}

impl RecordEntry {
    /// Reads its files.
    ///
    /// Errors: those of the readers.
    pub fn read(&self) -> Result<Shaking, Error> {
        let one = |path: &PathBuf| records::read(path, &self.options);
        let along = one(&self.along)?;
        let across = self.across.as_ref().map(one).transpose()?;
        let up = self.up.as_ref().map(one).transpose()?;
        let horizontal = std::iter::once(&along).chain(&across);
        Ok(Shaking {
            usable: horizontal.filter_map(ReadRecord::usable_period).reduce(f64::min),
            along: along.record,
            across: across.map(|read| read.record),
            up: up.map(|read| read.record),
        })
    }
}

impl Shaking {
    /// Processed as a tank file asks for; the other components follow the factor of the first.
    ///
    /// Errors: an impossible processing.
    pub fn processed(&self, processing: &Processing) -> Result<Shaking, Error> {
        let along = records::process(&self.along, processing)?;
        let factor = along.pga() / self.along.pga().max(f64::MIN_POSITIVE);
        let other = Processing { scale_to: None, scale_by: Some(factor), ..*processing };
        let other = |record: &Option<Record>| record.as_ref().map(|r| records::process(r, &other)).transpose();
        Ok(Shaking {
            across: other(&self.across)?,
            up: other(&self.up)?,
            usable: self.usable.map(|period| period * processing.time_factor.unwrap_or(1.0)),
            along,
        })
    }
}

/// The records of the file.
pub(super) fn records(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Records>>>, folder: &Path) -> Vec<RecordEntry> {
    let mut all: Vec<RecordEntry> = Vec::new();
    let Some(field) = &option.given else { return all };
    r.sized(field, "items");
    for item in field.value.iter().flatten() {
        let Some(given) = &item.value else { continue };
        let options =
            ReadOptions { unit: record_unit(r, &given.units), dt: r.optional(&given.dt), ..ReadOptions::default() };
        let paths = matching(r, &given.files, folder);
        let components = given.components.value();
        let parts = components.map(|c| Parts::of(r, c));
        for path in paths {
            let Some((along, across, up)) = components_of(r, &given.files, &path, parts.as_ref()) else { continue };
            let id = name_of(&path, folder);
            if all.iter().any(|other| other.id == id) {
                let message = format!("the record `{id}` is named twice");
                let allowed = "each record once";
                let fault = range_fault(Code::Repeated, item, &message, allowed);
                r.faults.push(fault.found("{ … }"));
                continue;
            }
            all.push(RecordEntry { id, along, across, up, options: options.clone() });
        }
    }
    all
}

/// Parts of the names.
struct Parts {
    along: String,
    across: Option<String>,
    up: Option<String>,
}

impl Parts {
    fn of(r: &mut Resolver<'_>, given: &Components) -> Parts {
        let mut text = |field: &Field<String>| r.text(field);
        Parts {
            along: text(&given.along).unwrap_or_default(),
            across: given.across.given.as_ref().and_then(&mut text),
            up: given.up.given.as_ref().and_then(&mut text),
        }
    }
}

/// The files of an earthquake along x, along y and upwards; none for a file that is another component. Parts that begin with `#` are channels of
/// one file.
type Files = (PathBuf, Option<PathBuf>, Option<PathBuf>);

fn components_of(r: &mut Resolver<'_>, field: &Field<String>, path: &Path, parts: Option<&Parts>) -> Option<Files> {
    let Some(parts) = parts.filter(|parts| !parts.along.is_empty()) else {
        return Some((path.to_path_buf(), None, None));
    };
    if parts.along.starts_with('#') {
        let channel = |part: &String| -> PathBuf {
            let mut name = path.as_os_str().to_os_string();
            name.push(part);
            name.into()
        };
        return Some((channel(&parts.along), parts.across.as_ref().map(channel), parts.up.as_ref().map(channel)));
    }
    let name = path.file_name()?.to_string_lossy().into_owned();
    if !name.contains(&parts.along) {
        return None;
    }
    let mut other = |part: &Option<String>| -> Option<PathBuf> {
        let other = path.with_file_name(name.replacen(&parts.along, part.as_ref()?, 1));
        if !other.is_file() {
            let message = format!("{name} has no other component {}", other.display());
            r.refuse(Code::Contradiction, field, &message, "a file for every component");
        }
        Some(other)
    };
    let across = other(&parts.across);
    Some((path.to_path_buf(), across, other(&parts.up)))
}
