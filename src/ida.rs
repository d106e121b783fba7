//! The whole flow of an incremental dynamic analysis: job → tank → runs → `ida.json`, `ida.csv`, report. Finished
//! runs are stored in `ida.partial.json` immediately, and unfinished runs keep checkpoints, so that a killed analysis
//! can be resumed. Runs are independent, and a resumed analysis gives the same numbers. These files are in
//! `unfinished/` of the output folder until the analysis is complete.

use std::path::Path;

use fem::analysis::checkpoint::inspect;
use fem::progress::Progress;
use tank::assessment::Excitation;

use crate::error::Error;
use crate::job::{IdaJob, Job};
use crate::pipeline;
use engines::nonlinear::{CheckpointFile, Incremental};
use files::{Kind, OutputFolder, WorkFolder, kept_complete};
use report::{self, FIGURES_FOLDER, REPORT_FILE};
use results::{
    IDA_FILE, IDA_FORMAT, IDA_PARTIAL_FILE, Ida, IdaRun, Volatile, finite, ida_csv, put, read_ida, write_ida,
};

/// Name of the table of runs.
const CSV_FILE: &str = "ida.csv";

/// Prefix of the names of checkpoints, before the scale.
const CHECKPOINT: &str = "checkpoint-";

/// Results of an analysis.
const IDA: Kind = Kind {
    id: "ida",
    option: "--out",
    names: |name| [IDA_FILE, CSV_FILE, REPORT_FILE, FIGURES_FOLDER].contains(&name),
    keeps: |_| false,
};

/// Whether a file of this name belongs to an unfinished analysis.
fn is_work(name: &str) -> bool {
    name.starts_with(CHECKPOINT) || name.starts_with(IDA_PARTIAL_FILE)
}

/// Runs a job; `volatile` stamps the results. Errors: a tank or option that the nonlinear engine does not support; a
/// folder that contains another analysis or cannot be written; a failure of the engine. Collapse is a result, not an
/// error.
pub fn run(job: &IdaJob, volatile: impl Fn() -> Volatile, progress: &dyn Progress) -> Result<Ida, Error> {
    let key = job.job.incremental_key();
    // Faults of the folder are reported before anything is computed.
    let folder = OutputFolder::prepare(&job.out, IDA)?;
    let work = WorkFolder::open(&job.out, IDA.id, is_work, job.resume)?;
    let partial = work.file(IDA_PARTIAL_FILE);
    let earlier = job.out.join(IDA_FILE);
    let mut runs = match kept(&earlier, &key) {
        _ if !job.resume => Vec::new(),
        // Complete results of another analysis next to unfinished work of this one.
        Err(_) if !work.names()?.is_empty() => Vec::new(),
        runs => runs?,
    };
    for run in kept(&partial, &key)? {
        if !has(&runs, run.scale) {
            insert(&mut runs, run);
        }
    }
    for name in work.names()?.iter().filter(|name| name.starts_with(CHECKPOINT)) {
        let path = work.file(name);
        inspect(&path).map_err(|e| {
            Error::Files(files::error::Error::Taken {
                what: e.cause().to_string(),
                help: "remove the file; the run of its scale starts over, and the others are kept".into(),
                path,
            })
        })?;
    }
    let tank = Incremental::new(&job.job.case, &job.job.nonlinear, progress)?;
    let mut ida = Ida {
        format: IDA_FORMAT.into(),
        volatile: volatile(),
        key,
        name: job.job.case.name.clone(),
        project: job.job.project.clone(),
        tank: Some(job.job.tank()),
        files: job.job.files.clone(),
        model: tank.facts()?,
        assumptions: [warnings(job), tank.assumptions()].concat(),
        moment: tank.moment(),
        runs,
        incomplete: true,
        sloshing_beyond_usable: beyond(&job.job)?,
    };
    let missing: Vec<f64> = job.scales.iter().copied().filter(|&scale| !has(&ida.runs, scale)).collect();
    let key = ida.key.clone();
    let checkpoint = |scale: f64| CheckpointFile {
        path: work.file(&format!("{CHECKPOINT}{scale}")),
        key: format!("{key} {scale}"),
        resume: job.resume,
    };
    tank.run(&missing, job.jobs, &|scale| Some(checkpoint(scale)), progress, |run| {
        let scale = run.scale;
        insert(&mut ida.runs, run);
        match write_ida(&partial, &ida) {
            Ok(()) => checkpoint(scale).remove(),
            // Its results are in memory and its checkpoint stays; the next run retries.
            Err(error) => progress.warn(&format!("{error}; the analysis continues")),
        }
    })?;
    ida.incomplete = !job.scales.iter().all(|&scale| has(&ida.runs, scale));
    ida.volatile = volatile();
    finite::check("incremental dynamic analysis", &ida)?;
    if ida.incomplete && !job.resume && read_ida(&earlier).is_ok_and(|earlier| !earlier.incomplete) {
        progress.warn(&kept_complete(&job.out));
        return Ok(ida);
    }
    let ida = write(&folder, &ida)?;
    folder.commit()?;
    if !ida.incomplete {
        work.done();
    }
    Ok(ida)
}

/// Usable period of the record and sloshing period of the tank [s], where the latter is longer.
///
/// Errors: a procedure that does not converge.
fn beyond(job: &Job) -> Result<Option<[f64; 2]>, Error> {
    let Some(usable) = job.usable_periods.first().copied().flatten() else { return Ok(None) };
    let sloshing = pipeline::sloshing_period(&pipeline::procedures::under(job, Excitation::Record)?);
    Ok(sloshing.filter(|period| *period > usable).map(|period| [usable, period]))
}

/// Warnings about the input, placed above the assumptions of the engine.
fn warnings(job: &IdaJob) -> Vec<String> {
    job.job.warnings.iter().map(|w| format!("Warning {w}")).collect()
}

/// Whether a run of this scale exists.
fn has(runs: &[IdaRun], scale: f64) -> bool {
    runs.iter().any(|run| same(run.scale, scale))
}

/// Whether two scales are equal to the ten digits stored in files.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

fn insert(runs: &mut Vec<IdaRun>, run: IdaRun) {
    let at = runs.partition_point(|r| r.scale < run.scale);
    runs.insert(at, run);
}

/// Runs of this analysis in a file; empty if the file does not exist.
fn kept(path: &Path, key: &str) -> Result<Vec<IdaRun>, Error> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let found = read_ida(path)?;
    match found.key == key {
        true => Ok(found.runs),
        false => Err(Error::Files(files::error::Error::Taken {
            path: path.into(),
            what: "belongs to another tank, record, option or version".into(),
            help: "name another folder with --out, or remove --resume to start over".into(),
        })),
    }
}

/// Writes an analysis; returns it as written. Table and report use the digits of the file, so that they are the same
/// for computed and for stored runs.
fn write(folder: &OutputFolder, ida: &Ida) -> Result<Ida, Error> {
    let path = folder.path().join(IDA_FILE);
    write_ida(&path, ida)?;
    let ida = read_ida(&path)?;
    put(&folder.path().join(CSV_FILE), ida_csv(&ida).as_bytes())?;
    report::ida::report(&ida)?.write(&folder.path())?;
    Ok(ida)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A range from 0 to 1.1 in twelve steps holds 0.30000000000000004, of which files keep ten digits.
    #[test]
    fn a_kept_run_is_found_by_its_rounded_scale() {
        assert!(same(0.1 + 0.2, 0.3) && same(0.0, 0.0) && same(1.1, 1.1));
        assert!(!same(0.3, 0.300_001) && !same(0.0, 1e-12));
    }
}
