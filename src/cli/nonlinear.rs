//! Arguments of the nonlinear engine in `compare`: where a run is kept while it is under way, and whether it goes on.

use std::path::{Path, PathBuf};

use fem::analysis::checkpoint::{CheckpointError, MAGIC, inspect, unfinished};

use crate::cli::Global;
use crate::cli::terminal::say;
use crate::error::Error;
use crate::job::{Engines, Job};
use engines::nonlinear::CheckpointFile;
use report::number::plain;
use results::nonlinear::End;
use results::{Results, describe};

/// How a nonlinear run survives an interruption.
#[derive(clap::Args, Clone, Debug)]
pub struct NonlinearArgs {
    /// File that keeps a nonlinear run while it is under way; removed when it is done [default: the output folder with
    /// `.checkpoint` at its end].
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Go on with a nonlinear run where its checkpoint ends; from the beginning if there is none.
    #[arg(long)]
    resume: bool,
}

impl NonlinearArgs {
    /// Lays these options over the job's; `out` is the output folder.
    ///
    /// Errors: options without a nonlinear run; a place where no checkpoint can be written; nothing to go on from.
    pub fn apply(&self, job: &mut Job, out: &Path) -> Result<(), Error> {
        if job.engines != Engines::Nonlinear {
            let unused = self.checkpoint.as_ref().map(|_| "--checkpoint");
            return match unused.or(self.resume.then_some("--resume")) {
                Some(option) => refuse(
                    &format!("{option} belongs to the nonlinear engine"),
                    "add --fe nonlinear",
                ),
                None => Ok(()),
            };
        }
        job.checkpoint = Some(self.file(out, job.key())?);
        Ok(())
    }

    /// The checkpoint of a run with the output folder `out`.
    ///
    /// * `key`: hash of its input
    ///
    /// Errors: a place where no checkpoint can be written; one from which no run can go on.
    pub fn file(&self, out: &Path, key: String) -> Result<CheckpointFile, Error> {
        let path = self.checkpoint.clone().unwrap_or_else(|| beside(out));
        let shown = path.display();
        if path.is_dir() {
            return refuse(
                &format!("--checkpoint: `{shown}` is a folder, expected a file"),
                "name a file",
            );
        }
        match path.parent() {
            Some(parent) if self.checkpoint.is_some() && !parent.as_os_str().is_empty() && !parent.is_dir() => {
                return refuse(
                    &format!("--checkpoint: there is no folder `{}`", parent.display()),
                    "make it, or name a file in another one",
                );
            }
            _ => {}
        }
        let file = CheckpointFile {
            path,
            key,
            resume: self.resume,
        };
        for path in file.files() {
            // Half a checkpoint of a killed run is the beginning of one.
            let parts = [(unfinished(&path), true), (path, false)];
            for (path, part) in parts {
                let own = |head: Vec<u8>| if part { MAGIC.starts_with(&head) } else { head == MAGIC };
                if !begins(&path)?.is_none_or(own) {
                    return refuse(
                        &format!("--checkpoint: `{}` is a file that is no checkpoint", path.display()),
                        "name another file; this one is left alone",
                    );
                }
            }
        }
        if self.resume && file.path.exists() {
            sound(&file.path)?;
        }
        Ok(file)
    }
}

fn refuse<T>(what: &str, help: &str) -> Result<T, Error> {
    Err(Error::input(format!("error: {what}\n  help: {help}")))
}

/// Refuses a checkpoint from which no run can go on. Whether it is of this very run shows once the model is built.
fn sound(path: &Path) -> Result<(), Error> {
    match inspect(path) {
        Ok(()) => Ok(()),
        Err(CheckpointError::File { reason, .. }) => Err(Error::Files(files::error::Error::File {
            path: path.into(),
            what: reason,
        })),
        Err(fault) => refuse(
            &format!("--resume: the checkpoint `{}` is {}", path.display(), fault.cause()),
            "leave --resume out to start over, which overwrites it, or name another one with --checkpoint",
        ),
    }
}

/// `out/` → `out.checkpoint`.
fn beside(out: &Path) -> PathBuf {
    // A folder without a name of its own (`.`) has one from the root on.
    let whole = match out.file_name() {
        Some(_) => out.to_path_buf(),
        None => std::path::absolute(out).unwrap_or_else(|_| out.to_path_buf()),
    };
    let mut name = whole.file_name().unwrap_or("out".as_ref()).to_owned();
    name.push(".checkpoint");
    whole.with_file_name(name)
}

/// First bytes of a file as long as those of a checkpoint; `None` if there is no file.
fn begins(path: &Path) -> Result<Option<Vec<u8>>, Error> {
    use std::io::Read;
    let fault = |e: std::io::Error| {
        Error::Files(files::error::Error::File {
            path: path.into(),
            what: describe(&e),
        })
    };
    if !path.exists() {
        return Ok(None);
    }
    let mut head = Vec::new();
    let file = std::fs::File::open(path).map_err(fault)?;
    file.take(MAGIC.len() as u64).read_to_end(&mut head).map_err(fault)?;
    Ok(Some(head))
}

/// Says what the nonlinear run of a job is about to do.
pub fn announce(job: &Job, global: &Global) {
    if let (Some(file), Some(motion)) = (&job.checkpoint, &job.case.ground_motion) {
        let what = format!("nonlinear run of {} s", plain(motion.horizontal.duration(), 2));
        announce_start(&what, file, job.nonlinear.checkpoint, global);
    }
}

/// Says where a run starts, and how often it keeps a checkpoint.
///
/// * `every`: computing time between two of them [s]
pub fn announce_start(what: &str, file: &CheckpointFile, every: f64, global: &Global) {
    if global.quiet {
        return;
    }
    let shown = file.path.display();
    let start = match (file.resume, file.path.exists()) {
        (true, true) => format!("resumes from `{shown}`"),
        (true, false) => format!("starts from the beginning, there is no checkpoint `{shown}`"),
        (false, true) => format!("starts over and overwrites `{shown}`; use --resume to continue"),
        (false, false) => "starts".into(),
    };
    say!("{what}: {start}; a checkpoint every {} s of computing", plain(every, 0));
}

/// How the nonlinear run of these results ended.
fn end(results: &Results) -> Option<&End> {
    let run = results.fe_nonlinear.as_ref()?.nonlinear.as_ref()?;
    Some(&run.end)
}

/// Removes the checkpoint of a run that has come to its end.
pub fn tidy(job: &Job, results: &Results) {
    if let (Some(file), Some(End::Completed | End::Collapsed { .. } | End::Left { .. })) =
        (&job.checkpoint, end(results))
    {
        file.remove();
    }
}

/// Says how an interrupted nonlinear run goes on.
pub fn advise(job: &Job, results: &Results, global: &Global) {
    if let (Some(file), false) = (
        &job.checkpoint,
        matches!(
            end(results),
            Some(End::Completed | End::Collapsed { .. } | End::Left { .. })
        ),
    ) {
        advise_resume(file, global);
    }
}

/// Says how an interrupted run goes on, if it has left a checkpoint.
pub fn advise_resume(file: &CheckpointFile, global: &Global) {
    if !global.quiet && file.path.exists() {
        say!(
            "checkpoint: {}; the same command with --resume goes on",
            file.path.display()
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checkpoint_stands_beside_the_output_folder() {
        for (out, file) in [
            ("out", "out.checkpoint"),
            ("out/", "out.checkpoint"),
            ("a/b.c/", "a/b.c.checkpoint"),
        ] {
            assert_eq!(beside(Path::new(out)), Path::new(file));
        }
        let here = beside(Path::new("."));
        assert!(here.is_absolute() && here.to_string_lossy().ends_with(".checkpoint"));
    }
}
