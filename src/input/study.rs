//! `study.json`: which tanks, which records, which scales.
//!
//! The file names other files, relative to itself. [`read`] resolves what stands in it; [`StudyInput::faults`] reads every tank and every
//! record it names, so that a plan reports all faults at once; a task reads its own tank and records alone.

mod keys;
pub(in crate::input) mod pattern;
mod records;
mod rule;
mod sample;
mod scales;
mod tanks;

use std::path::{Component, Path, PathBuf};

use crate::curves::runs::Method;
use crate::input::diagnostic::{Faults, Source};
use crate::input::tank::bytes;
use crate::input::tank::keys::project::project;
use crate::input::tank::read::{Field, FromNode};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::{schema, syntax};
use files::code::Code;
use files::error::Error;
use keys::{CurveMethod, StudyEngine, StudyFile};
use pattern::Refused;
use results::EngineId;

pub use records::{RecordEntry, Shaking};
pub use rule::{Rule, RulePeriods};
pub use sample::{Distribution, Sampled, Sampling};
pub use scales::{Axis, Period, Scales};
pub use tanks::TankEntry;

/// A way into a damage state: a demand that reaches a limit.
#[derive(Clone, Debug, PartialEq)]
pub struct DamageLimit {
    /// Name of the state.
    pub state: String,
    /// Limit state of the engine whose largest utilisation is compared, or [`COLLAPSE`].
    pub demand: String,
    /// Utilisation at which the state begins.
    pub limit: f64,
    /// Source of the limit.
    pub source: String,
}

/// The demand of a run without equilibrium.
pub const COLLAPSE: &str = "collapse";

/// A resolved study file.
#[derive(Clone, Debug)]
pub struct StudyInput {
    /// Title.
    pub name: String,
    /// The tanks, before sampling.
    pub tanks: Vec<TankEntry>,
    /// The records; empty for the design spectra alone.
    pub records: Vec<RecordEntry>,
    /// Scales of every record.
    pub scales: Scales,
    /// Sampled parameters.
    pub sampling: Option<Sampling>,
    /// Engine; none for the codes alone.
    pub engine: Option<EngineId>,
    /// Procedures to run, if the study names them.
    pub procedures: Option<Vec<String>>,
    /// Damage states, as given; none for the default set.
    pub damage: Option<Vec<DamageLimit>>,
    /// Cover of the report.
    pub project: Option<::tank::Project>,
    /// How curves are found.
    pub method: Method,
    /// Rule for the set of records.
    pub rule: Option<Rule>,
    /// Hazard curve: file.
    pub hazard: Option<PathBuf>,
    /// Records of a task.
    pub block: usize,
    /// The file.
    pub source: Source,
    /// SHA-256 of the file.
    pub sha256: String,
}

/// Reads and resolves a study file. All its faults are reported at once.
///
/// Errors: a file that cannot be read; faults of its keys and values; a pattern without files; a tank file or table that cannot be read.
pub fn read(path: &Path) -> Result<StudyInput, Error> {
    let (source, sha256) = bytes::read(path)?;
    let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
    let mut faults = Faults::new();
    let mut broken = Vec::new();
    let found = parse(&source, &folder, &mut faults, &mut broken);
    match found {
        Some(study) if faults.is_empty() && broken.is_empty() => Ok(StudyInput { sha256, ..study }),
        _ => {
            let mut all: Vec<Error> = Vec::new();
            if !faults.is_empty() {
                all.push(faults.into_error(&source));
            }
            all.extend(broken);
            // The faults of the tanks as well, which `plan` looks for in a study without other faults.
            let mut tables = Vec::new();
            for tank in found.iter().flat_map(|study| &study.tanks) {
                tank.nominal(&mut tables);
            }
            all.extend(tables.into_iter().map(|(source, faults)| faults.into_error(&source)));
            Err(together(all))
        }
    }
}

/// The JSON Schema of `study.json`, draft 2020-12.
pub fn json_schema() -> serde_json::Value {
    schema::of::<StudyFile>("study.json", "StudyFile", |_| {})
}

/// Several errors of input as one.
pub(crate) fn together(mut errors: Vec<Error>) -> Error {
    match errors.len() {
        1 => errors.remove(0),
        _ => {
            let text = |error: &Error| match error {
                Error::Faults(text) => text.trim_end().to_owned(),
                other => other.code().map_or_else(|| other.to_string(), |code| format!("{}: {other}", code.head())),
            };
            Error::Faults(errors.iter().map(text).collect::<Vec<_>>().join("\n\n"))
        }
    }
}

fn parse(source: &Source, folder: &Path, faults: &mut Faults, broken: &mut Vec<Error>) -> Option<StudyInput> {
    let mut root = syntax::parse(source, faults)?;
    if let syntax::Kind::Object(members) = &mut root.kind {
        members.retain(|m| m.key != "$schema");
    }
    let file = StudyFile::from_node(&root, faults)?;
    let mut r = Resolver::new(faults);
    let name = r.text(&file.name);
    let cover = project(&mut r, &file.project);
    if let Some(notes) = &file.notes.given {
        r.echo_given(notes);
    }
    let tanks = tanks::tanks(&mut r, &file.tanks, folder, broken);
    let records = records::records(&mut r, &file.records, folder);
    let scales = scales::scales(&mut r, &file.scales);
    let sampling = sample::sampling(&mut r, &file.sample);
    let engine = match r.or_default(&file.engine) {
        StudyEngine::Harmonic => Some(EngineId::Harmonic),
        StudyEngine::Solid => Some(EngineId::Solid),
        StudyEngine::Nonlinear => Some(EngineId::Nonlinear),
        StudyEngine::None => None,
    };
    let procedures = procedures(&mut r, &file);
    let damage = file.damage.given.as_ref().map(|given| damage(&mut r, given));
    let hazard = file.hazard.given.as_ref().and_then(|field| {
        let path = folder.join(r.text(field)?);
        if !path.is_file() {
            let message = "no such file";
            let allowed = "a CSV file with the columns im and rate";
            r.refuse(Code::FileUnreadable, field, message, allowed);
        }
        Some(path)
    });
    let block = r.or_default(&file.block) as usize;
    let method = method(&mut r, &file, scales.as_ref());
    let rule = match &file.rule.given {
        Some(field) if records.is_empty() && file.records.given.is_none() => {
            let fault = range_fault(Code::Incomplete, field, "a rule without records", "`records`");
            r.faults.push(fault.found("{ … }"));
            None
        }
        Some(field) => rule::rule(&mut r, field, folder, broken),
        None => None,
    };
    scales::admit(&mut r, &file.scales, engine);
    Some(StudyInput {
        name: name?,
        tanks,
        records,
        scales: scales?,
        sampling: sampling?,
        engine,
        procedures,
        damage,
        project: cover,
        method,
        rule,
        hazard,
        block,
        source: source.clone(),
        sha256: String::new(),
    })
}

/// How curves are found: as given, or by the scales.
fn method(r: &mut Resolver<'_>, file: &StudyFile, scales: Option<&Scales>) -> Method {
    let levels = scales.is_some_and(|scales| !scales.levels.is_empty());
    let Some(field) = &file.method.given else {
        r.not_given(&file.method);
        return if levels { Method::Stripes } else { Method::Cloud };
    };
    match field.value {
        Some(CurveMethod::Cloud) => Method::Cloud,
        Some(CurveMethod::Capacities) if !levels => {
            let message = "capacities without levels";
            let allowed = "`scales.levels`, the same for every record";
            r.refuse(Code::Incomplete, field, message, allowed);
            Method::Capacities
        }
        Some(CurveMethod::Capacities) => Method::Capacities,
        Some(CurveMethod::Stripes) | None => Method::Stripes,
    }
}

fn procedures(r: &mut Resolver<'_>, file: &StudyFile) -> Option<Vec<String>> {
    let list = file.procedures.value()?;
    let known: Vec<&str> = codes::ALL.iter().map(|p| p.id()).collect();
    for field in list {
        if field.value.as_ref().is_some_and(|id| !known.contains(&id.as_str())) {
            let fault = range_fault(Code::UnknownChoice, field, "an unknown procedure", &known.join(", "));
            r.faults.push(fault);
        }
    }
    Some(list.iter().filter_map(|field| field.value.clone()).collect())
}

fn damage(r: &mut Resolver<'_>, given: &Field<Vec<Field<keys::Damage>>>) -> Vec<DamageLimit> {
    r.sized(given, "damage states");
    let mut all = Vec::new();
    for item in given.value.iter().flatten().filter_map(|item| item.value.as_ref()) {
        let limit = r.or_default(&item.limit);
        let source = item.source.value().cloned().unwrap_or_default();
        if let (Some(state), Some(demand)) = (r.text(&item.state), r.text(&item.demand)) {
            all.push(DamageLimit { state, demand, limit, source });
        }
    }
    all
}

/// Files that match a pattern relative to a folder, sorted; a name without `*`, `?` and `[` is one file.
fn matching(r: &mut Resolver<'_>, field: &Field<String>, folder: &Path) -> Vec<PathBuf> {
    let Some(text) = r.text(field) else { return Vec::new() };
    let path = folder.join(&text);
    let mut fault = |code: Code, message: &str, allowed: &str| {
        r.refuse(code, field, message, allowed);
        Vec::new()
    };
    if !pattern::is_pattern(&text) {
        return match path.is_file() {
            true => vec![path],
            false => fault(Code::FileUnreadable, "no such file", "a file relative to the study file"),
        };
    }
    match pattern::files(folder, &text) {
        Ok(files) if files.is_empty() => fault(Code::FileUnreadable, "no file matches", "a pattern that matches files"),
        Ok(files) => files,
        Err(Refused::Faulty(error)) => {
            fault(Code::BadForm, &format!("a faulty pattern: {error}"), "a pattern with * and ?")
        }
        Err(Refused::Files) => fault(
            Code::TooLarge,
            "the pattern matches too many files",
            &format!("at most {} files", pattern::MOST_FILES),
        ),
        Err(Refused::Entries) => fault(
            Code::TooLarge,
            "the pattern looks at too many files and folders",
            &format!("a pattern that looks at no more than {} of them", pattern::MOST_ENTRIES),
        ),
    }
}

/// Name of a file for rows: relative to the folder of the study, without extension, with `/` between folders.
fn name_of(path: &Path, folder: &Path) -> String {
    // A pattern that begins with `./` finds files without it.
    let plain = |path: &Path| -> PathBuf { path.components().filter(|part| *part != Component::CurDir).collect() };
    let (path, folder) = (plain(path), plain(folder));
    let relative = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
    relative.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect::<Vec<_>>().join("/")
}
