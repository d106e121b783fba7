//! A base that turns: `--quake-rotation` beside the key `analysis.quake_rotation`.

use std::path::Path;

use tank::refusal::Place;

use crate::cli::inputs::source;
use crate::error::Error;
use crate::input::records::load;
use crate::input::rotation;
use crate::job::Job;
use engines::engine;
use files::code::Code;

/// The option.
const OPTION: &str = "--quake-rotation";

/// Puts the rotation of a file into a job, in place of that of the tank file.
///
/// Errors: a file that cannot be read or is not such a table; no engine.
pub(super) fn add(job: &mut Job, path: &Path) -> Result<(), Error> {
    if job.engines.is_empty() {
        return Err(Error::conflict(format!(
            "{OPTION}: found no engine; code procedures leave the rotation out\n  help: use --fe harmonic"
        )));
    }
    let bytes = load::load(path)?;
    let fault = |found| {
        let text = format!("{OPTION} {}: found {found}, expected {}", path.display(), rotation::FORM);
        Error::input(Code::OptionValue, text)
    };
    job.linear.rotation = Some(rotation::read(&bytes, OPTION).map_err(fault)?);
    job.files.push(source("rotation of the base", path, &load::sha256(&bytes)));
    Ok(())
}

/// Errors: a rotation under a set of records or under none; an engine that does not turn the base of this tank.
pub(super) fn check(job: &Job, of_set: bool) -> Result<(), Error> {
    let Some(rotation) = job.linear.rotation.as_ref().filter(|_| !job.engines.is_empty()) else { return Ok(()) };
    let refuse = |what: &str| Err(Error::conflict(format!("{}: {what}", rotation.name)));
    if of_set {
        return refuse("found a set of records, expected one");
    }
    if job.case.ground_motion.is_none() {
        return refuse("found no record, expected one beside the rotation\n  help: give a record with --quake");
    }
    let refused = job.engines.iter().flat_map(|&id| engine(id).refuses(&job.task()));
    match refused.into_iter().find(|refusal| refusal.place == Place::Rotation) {
        Some(refusal) => refuse(&format!("{}\n  help: {}", refusal.message, refusal.help)),
        None => Ok(()),
    }
}
