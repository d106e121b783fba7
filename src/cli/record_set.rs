//! Several records for one verification: `--quake` more than once, or `--set`.

use std::path::{Path, PathBuf};

use codes::record_set::standard::{Combine, Standard};
use files::code::{Code, Warning};
use tank::case::{GroundMotion, Site};
use tank::hazard::SpectrumTable;

use super::inputs::{Inputs, source};
use super::quake::Rule;
use crate::error::Error;
use crate::input::records::{self, Processing, ReadOptions, ReadRecord};
use crate::input::set::{self, SetEntry, SetInput};
use crate::input::{study, target};
use crate::job::Job;
use crate::record_set::{Earthquake, SetJob};
use files::text;

/// Fewest records of a set.
const FEWEST: usize = 3;

/// Options of a set.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct SetArgs {
    /// A set of records: set.json (`tankcheck schema --set`); or give --quake three times or more.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["quake", "quake_y", "vertical"])]
    set: Option<PathBuf>,
    /// Rule of a set [default: that of the site].
    #[arg(long, value_enum, value_name = "CODE")]
    rule: Option<Rule>,
    /// Design value of a set [default: by rule and number of records].
    #[arg(long, value_enum)]
    combine: Option<CombineArg>,
    /// Target spectrum of a set: a CSV table [default: the spectrum of the site].
    #[arg(long, value_name = "FILE")]
    target: Option<PathBuf>,
    /// Multiply the set by the one factor with which the rule for its spectrum just holds.
    #[arg(long)]
    fit: bool,
}

/// Design value of a set.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum CombineArg {
    /// Mean of the maxima.
    Mean,
    /// Largest of the maxima.
    Worst,
}

/// What a set is made of, before its tank is known.
pub(crate) struct Given {
    input: SetInput,
    /// Name of the set file.
    file: Option<PathBuf>,
    allow_implausible: bool,
}

/// A record as read: along x, y, upwards.
type Components = Vec<(&'static str, PathBuf, ReadRecord)>;

impl SetArgs {
    /// The set of the command line; none for a single record or none.
    ///
    /// Errors: an option of sets without a set; a file that cannot be read; two records; numbers of components that do not match.
    pub(crate) fn given(&self, inputs: &Inputs) -> Result<Option<Given>, Error> {
        let mut found = match &self.set {
            Some(path) => Some(set::read(path)?),
            None if inputs.quake.len() > 1 => Some(listed(inputs)?),
            None => None,
        };
        let Some(input) = &mut found else {
            let options = [
                ("--rule", self.rule.is_some()),
                ("--combine", self.combine.is_some()),
                ("--target", self.target.is_some()),
                ("--fit", self.fit),
            ];
            return match options.iter().find(|(_, given)| *given) {
                None => Ok(None),
                Some((option, _)) => Err(Error::conflict(format!(
                    "{option} applies to a set of records only\n  help: give --quake three times or more, or --set set.json"
                ))),
            };
        };
        let count = input.entries.len();
        if count < FEWEST {
            return Err(Error::missing(format!(
                "--quake: found {count} records, expected one, or a set of {FEWEST} or more ({})\n  help: add records, or run them one \
                     by one; the second component of one earthquake is --quake-y",
                Standard::En1998.clause()
            )));
        }
        if let Some(rule) = self.rule {
            input.code = Some(rule.code());
        }
        if let Some(combine) = self.combine {
            input.combine = Some(match combine {
                CombineArg::Mean => Combine::Mean,
                CombineArg::Worst => Combine::Worst,
            });
        }
        if let Some(path) = &self.target {
            input.table = Some(target::read(path, inputs.reading.options().unit)?);
            input.target = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        }
        input.fit |= self.fit;
        Ok(found.map(|input| Given {
            input,
            file: self.set.clone(),
            allow_implausible: inputs.reading.allow_implausible,
        }))
    }
}

/// The records of repeated `--quake`, `--quake-y` and `--vertical`.
fn listed(inputs: &Inputs) -> Result<SetInput, Error> {
    let count = inputs.quake.len();
    let others = |option: &str, paths: &[PathBuf]| -> Result<Vec<Option<PathBuf>>, Error> {
        match paths.len() {
            0 => Ok(vec![None; count]),
            n if n == count => Ok(paths.iter().cloned().map(Some).collect()),
            n => Err(Error::conflict(format!(
                "{option}: found {n} files beside {count} of --quake, expected none, or one for each in the same order"
            ))),
        }
    };
    let across = others("--quake-y", &inputs.quake_y)?;
    let up = others("--vertical", &inputs.vertical)?;
    let options = inputs.reading.options();
    let entries = inputs.quake.iter().zip(across).zip(up);
    let entries = entries.map(|((along, across), up)| SetEntry {
        name: None,
        along: along.clone(),
        across,
        up,
        scale: 1.0,
        options: options.clone(),
    });
    Ok(SetInput {
        name: String::new(),
        code: None,
        combine: None,
        table: None::<SpectrumTable>,
        target: "site".into(),
        factor: 1.0,
        fit: false,
        entries: entries.collect(),
        sha256: String::new(),
    })
}

/// The code of a site: EN 1998 where nothing speaks for another.
fn code_of(site: &Site) -> Standard {
    match (&site.ec8, &site.api650) {
        (None, Some(_)) => Standard::Asce716,
        _ => Standard::En1998,
    }
}

impl Given {
    /// Reads the records for a tank. All that cannot be read are reported at once.
    ///
    /// * `job`: the job without ground motion
    ///
    /// Errors: a record that cannot be read or processed; the same record twice; different components; a mean of fewer records than the rule asks
    /// for.
    pub(crate) fn job(self, mut job: Job, processing: &Processing) -> Result<SetJob, Error> {
        let input = self.input;
        let code = input.code.unwrap_or_else(|| code_of(&job.case.site));
        let count = input.entries.len();
        if input.combine == Some(Combine::Mean) && count < code.fewest_for_mean() {
            return Err(Error::conflict(format!(
                "--combine mean: found {count} records, expected {} or more ({})\n  help: add records, or use --combine worst",
                code.fewest_for_mean(),
                code.design_clause()
            )));
        }
        let (mut read, mut broken) = (Vec::new(), Vec::new());
        for entry in &input.entries {
            match components(entry, self.allow_implausible) {
                Ok(found) => read.push((entry, found)),
                Err(error) => broken.push(error),
            }
        }
        if !broken.is_empty() {
            return Err(Error::Files(study::together(broken)));
        }
        distinct(&read)?;
        let names = names(&read);
        let mut records = Vec::new();
        for ((entry, found), id) in read.iter().zip(names) {
            let scaled = entry.scale * input.factor;
            let (record, warnings) = earthquake(&id, found, scaled, processing, self.allow_implausible)?;
            job.warnings.extend(warnings.into_iter().map(|w| w.about(&format!("record {id}"))));
            records.push(record);
        }
        if processing.scale_to.is_some() {
            job.warnings.push(Warning::new(
                Code::UnusualRecord,
                "`record.scale_to`: every record of the set is scaled to the same peak, before the factor of the set; remove it to keep the scatter of \
                 the records",
            ));
        }
        if let Some(path) = &self.file {
            job.files.push(source("set of records", path, &input.sha256));
        }
        Ok(SetJob {
            job,
            name: input.name,
            records,
            code,
            combine: input.combine.unwrap_or_else(|| code.combine(count)),
            table: input.table,
            target: input.target,
            factor: input.factor,
            fit: input.fit,
        })
    }
}

/// Reads the components of an entry; all that cannot be read are in one error.
fn components(entry: &SetEntry, allow_implausible: bool) -> Result<Components, files::error::Error> {
    let options = ReadOptions { allow_implausible, ..entry.options.clone() };
    let all = [("x", Some(&entry.along)), ("y", entry.across.as_ref()), ("vertical", entry.up.as_ref())];
    let (mut found, mut broken) = (Vec::new(), Vec::new());
    for (direction, path) in all.into_iter().filter_map(|(d, path)| Some((d, path?))) {
        match records::read(path, &options) {
            Ok(read) => found.push((direction, path.clone(), read)),
            Err(error) => broken.push(error),
        }
    }
    if broken.is_empty() { Ok(found) } else { Err(study::together(broken)) }
}

/// Rejects a record that is there twice, and records of different components.
fn distinct(read: &[(&SetEntry, Components)]) -> Result<(), Error> {
    let shown = |path: &Path| text::line(&path.display().to_string()).into_owned();
    // A file may hold several components.
    let content = |read: &ReadRecord| (read.sha256.clone(), read.channel.clone());
    let all: Vec<(&PathBuf, _)> =
        read.iter().flat_map(|(_, found)| found.iter().map(|(_, path, read)| (path, content(read)))).collect();
    for (i, (path, one)) in all.iter().enumerate() {
        let sha = &one.0;
        if let Some((earlier, _)) = all[..i].iter().find(|(_, other)| other == one) {
            return Err(Error::input(
                Code::Repeated,
                format!(
                    "the same record twice in a set: `{}` has the content of `{}` (SHA-256 {}…), expected different records\n  help: remove one \
                 of them",
                    shown(path),
                    shown(earlier),
                    &sha[..12.min(sha.len())]
                ),
            ));
        }
    }
    let directions = |found: &Components| found.iter().map(|(d, ..)| *d).collect::<Vec<_>>().join(", ");
    if let Some((_, first)) = read.first() {
        let wanted = directions(first);
        if let Some((entry, found)) = read.iter().find(|(_, found)| directions(found) != wanted) {
            return Err(Error::input(
                Code::Contradiction,
                format!(
                    "the records of a set have different components: `{}` has {}, expected {wanted} as the first, `{}`\n  help: give all of \
                 them the same components",
                    shown(&entry.along),
                    directions(found),
                    shown(&first[0].1)
                ),
            ));
        }
    }
    Ok(())
}

/// A name for each: given, that of the file, or its path where two files have one name.
fn names(read: &[(&SetEntry, Components)]) -> Vec<String> {
    let of = |entry: &SetEntry| {
        let stem = || entry.along.file_stem().map(|s| s.to_string_lossy().into_owned());
        let name = entry.name.clone().or_else(stem).unwrap_or_default();
        text::line(&name).into_owned()
    };
    let plain: Vec<String> = read.iter().map(|(entry, _)| of(entry)).collect();
    let unique = |name: &String| plain.iter().filter(|n| *n == name).count() == 1;
    let numbered = plain.iter().zip(read).map(|(name, (entry, _))| match unique(name) {
        true => name.clone(),
        false => text::line(&entry.along.display().to_string()).into_owned(),
    });
    numbered.collect()
}

/// A record processed as the tank file asks for, times a factor; its other components follow the factor of the first.
fn earthquake(
    id: &str,
    found: &Components,
    factor: f64,
    processing: &Processing,
    allow_implausible: bool,
) -> Result<(Earthquake, Vec<Warning>), Error> {
    let (mut warnings, mut processed) = (Vec::new(), Vec::new());
    let mut scale = 1.0;
    for (i, (direction, path, read)) in found.iter().enumerate() {
        let own = match i {
            0 => *processing,
            _ => Processing { scale_to: None, scale_by: Some(scale), ..*processing },
        };
        let mut record = records::process(&read.record, &own)?;
        if i == 0 {
            scale = record.pga() / read.record.pga().max(f64::MIN_POSITIVE);
        }
        let factor_of_set =
            Processing { scale_by: Some(factor).filter(|f| (f - 1.0).abs() > 0.0), ..Processing::default() };
        record = records::process(&record, &factor_of_set)?;
        let origin = format!("{} ({direction})", path.display());
        records::plausible::check(&record, &text::line(&origin), allow_implausible)?;
        warnings.extend(records::plausible::doubts(&record, &own));
        processed.push(record);
    }
    let mut components = found.iter().zip(processed).map(|((direction, ..), record)| (*direction, record));
    let mut take = |wanted: &str| {
        let next = components.clone().next().filter(|(d, _)| *d == wanted);
        next.and_then(|_| components.next()).map(|(_, record)| record)
    };
    let (horizontal, transverse, vertical) = (take("x"), take("y"), take("vertical"));
    let Some(horizontal) = horizontal else {
        let text = format!("the record {id} has no component along x");
        return Err(Error::missing(text));
    };
    let role = |direction: &str| match direction {
        "x" => "record",
        "y" => "record along y",
        _ => "vertical record",
    };
    Ok((
        Earthquake {
            id: id.into(),
            motion: GroundMotion { horizontal, transverse, vertical },
            raw: found.iter().map(|(_, _, read)| read.record.clone()).collect(),
            usable: found.iter().map(|(_, _, read)| read.usable_after(processing)).collect(),
            files: found.iter().map(|(direction, path, read)| source(role(direction), path, &read.sha256)).collect(),
        },
        warnings,
    ))
}
