//! The whole flow of an incremental dynamic analysis: job → tank → runs → `ida.json`, `ida.csv`, report.
//!
//! Every run that is finished goes to `ida.partial.json` at once, and runs under way keep checkpoints, so that an analysis
//! that is killed can be resumed; a run does not depend on the others, and a resumed analysis gives the same numbers.

use std::path::{Path, PathBuf};

use fem::analysis::checkpoint::inspect;
use fem::progress::Progress;

use crate::error::Error;
use crate::fe::nonlinear::{CheckpointFile, Incremental};
use crate::job::IdaJob;
use crate::pipeline::OutputFolder;
use crate::report::{self, FIGURES_FOLDER, REPORT_FILE};
use crate::results::{
    IDA_FILE, IDA_FORMAT, IDA_PARTIAL_FILE, Ida, IdaRun, Volatile, describe, ida_csv, read_ida, write_ida,
};

/// Name of the table of runs.
const CSV_FILE: &str = "ida.csv";

/// What names of checkpoints of runs under way begin with, before the scale.
const CHECKPOINT: &str = "checkpoint-";

/// Whether an analysis writes an entry of this name.
pub fn owns(name: &str) -> bool {
    name.starts_with(CHECKPOINT) || [IDA_FILE, IDA_PARTIAL_FILE, CSV_FILE, REPORT_FILE, FIGURES_FOLDER].contains(&name)
}

/// Runs a job; `volatile` stamps the results.
///
/// Errors: a tank or option that the nonlinear engine does not know; a folder that holds another analysis or cannot be
/// written; a failure of the engine. Collapse of the wall is none.
pub fn run(job: &IdaJob, volatile: impl Fn() -> Volatile, progress: &dyn Progress) -> Result<Ida, Error> {
    let key = job.job.key();
    // Whatever is wrong with the folder is said before anything is computed.
    let folder = OutputFolder::of(&job.out, owns, "--out")?;
    let kept = if job.resume { kept(&job.out, &key)? } else { Vec::new() };
    let tank = Incremental::new(&job.job.case, &job.job.nonlinear, progress)?;
    let mut ida = Ida {
        format: IDA_FORMAT.into(),
        volatile: volatile(),
        key,
        name: job.job.case.name.clone(),
        files: job.job.files.clone(),
        model: tank.facts()?,
        assumptions: tank.assumptions(),
        moment: tank.moment(),
        runs: kept,
        incomplete: true,
    };
    let missing: Vec<f64> = job
        .scales
        .iter()
        .copied()
        .filter(|scale| !ida.runs.iter().any(|run| run.scale == *scale))
        .collect();
    std::fs::create_dir_all(&job.out).map_err(|e| fault(&job.out, e))?;
    let partial = job.out.join(IDA_PARTIAL_FILE);
    if job.resume {
        for path in checkpoints(&job.out)? {
            inspect(&path).map_err(|e| Error::File {
                what: format!(
                    "{}; remove the file: the run of its scale then begins anew, and the others are kept",
                    e.cause()
                ),
                path,
            })?;
        }
    } else {
        // Of an earlier analysis, which the folder is taken from.
        for path in checkpoints(&job.out)? {
            std::fs::remove_file(&path).map_err(|e| fault(&path, e))?;
        }
    }
    let key = ida.key.clone();
    let checkpoint = |scale: f64| {
        Some(CheckpointFile {
            path: job.out.join(format!("{CHECKPOINT}{scale}")),
            key: key.clone(),
            resume: job.resume,
        })
    };
    let mut unwritten = None;
    tank.run(&missing, job.jobs, &checkpoint, progress, |run| {
        insert(&mut ida.runs, run);
        // The first failure is kept; the runs go on, their results are still in memory.
        unwritten = unwritten.take().or(write_ida(&partial, &ida).err());
    })?;
    if let Some(error) = unwritten {
        return Err(error);
    }
    let done = |scale: &f64| ida.runs.iter().any(|run| run.scale == *scale);
    ida.incomplete = !job.scales.iter().all(done);
    ida.volatile = volatile();
    write(&folder, &ida)?;
    if ida.incomplete {
        for path in checkpoints(&job.out)? {
            let name = path.file_name().unwrap_or_default();
            std::fs::copy(&path, folder.path().join(name)).map_err(|e| fault(&path, e))?;
        }
    }
    folder.commit()?;
    Ok(ida)
}

fn insert(runs: &mut Vec<IdaRun>, run: IdaRun) {
    let at = runs.partition_point(|r| r.scale < run.scale);
    runs.insert(at, run);
}

/// Runs that the folder has of this very analysis.
fn kept(folder: &Path, key: &str) -> Result<Vec<IdaRun>, Error> {
    let mut runs: Vec<IdaRun> = Vec::new();
    for name in [IDA_FILE, IDA_PARTIAL_FILE] {
        let path = folder.join(name);
        if !path.exists() {
            continue;
        }
        let found = read_ida(&path)?;
        if found.key != key {
            return Err(Error::File {
                path,
                what: "belongs to another tank, record, option or version: choose another folder with --out, or leave --resume \
                       out to begin anew"
                    .into(),
            });
        }
        for run in found.runs {
            if !runs.iter().any(|r| r.scale == run.scale) {
                insert(&mut runs, run);
            }
        }
    }
    Ok(runs)
}

fn fault(path: &Path, e: std::io::Error) -> Error {
    Error::File {
        path: path.into(),
        what: describe(&e),
    }
}

/// Checkpoints in a folder.
fn checkpoints(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| fault(folder, e))? {
        let entry = entry.map_err(|e| fault(folder, e))?;
        if entry.file_name().to_string_lossy().starts_with(CHECKPOINT) {
            found.push(entry.path());
        }
    }
    Ok(found)
}

fn write(folder: &OutputFolder, ida: &Ida) -> Result<(), Error> {
    write_ida(&folder.path().join(IDA_FILE), ida)?;
    let put = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).map_err(|e| fault(&path, e))
    };
    put(CSV_FILE, &ida_csv(ida))?;
    report::ida::report(ida)?.write(folder.path())?;
    Ok(())
}
