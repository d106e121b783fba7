//! Checkpoint arguments of the nonlinear engine, shared by `compare` and `push`.

use files::code::Code;
use std::path::{Path, PathBuf};

use fem::analysis::checkpoint::{CheckpointError, MAGIC, inspect, unfinished};

use crate::cli::Global;
use crate::cli::terminal::say;
use crate::error::Error;
use crate::job::Job;
use engines::nonlinear::CheckpointFile;
use report::number::plain;
use results::nonlinear::End;
use results::{EngineId, Results};

/// Checkpoint options.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct NonlinearArgs {
    /// Checkpoint file of a nonlinear run; removed when the run is finished [default: the output folder with
    /// `.checkpoint` appended].
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Continue a nonlinear run from its checkpoint; start from the beginning if there is none.
    #[arg(long)]
    resume: bool,
}

impl NonlinearArgs {
    /// Applies these options to the job; `out` is the output folder. Errors: options without a
    /// nonlinear run; those of [`NonlinearArgs::file`].
    pub(crate) fn apply(&self, job: &mut Job, out: &Path) -> Result<(), Error> {
        if !job.engines.contains(&EngineId::Nonlinear) {
            let unused = self.checkpoint.as_ref().map(|_| "--checkpoint");
            return match unused.or(self.resume.then_some("--resume")) {
                Some(option) => refuse(
                    Code::OptionConflict,
                    &format!("{option} applies to the nonlinear engine only"),
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
    /// * `key`: hash of its input Errors: a path where a checkpoint cannot be written; a checkpoint
    ///   that cannot be resumed.
    pub(crate) fn file(&self, out: &Path, key: String) -> Result<CheckpointFile, Error> {
        let path = self.checkpoint.clone().unwrap_or_else(|| beside(out));
        let shown = path.display();
        if path.is_dir() {
            return refuse(
                Code::OptionValue,
                &format!("--checkpoint: `{shown}` is a folder, expected a file"),
                "name a file",
            );
        }
        match path.parent() {
            Some(parent) if self.checkpoint.is_some() && !parent.as_os_str().is_empty() && !parent.is_dir() => {
                return refuse(
                    Code::OptionValue,
                    &format!("--checkpoint: folder `{}` does not exist", parent.display()),
                    "create it, or name a file in another folder",
                );
            }
            _ => {}
        }
        let file = CheckpointFile { path, key, resume: self.resume };
        for path in file.files() {
            // A killed run leaves the first part of a checkpoint.
            let parts = [(unfinished(&path), true), (path, false)];
            for (path, part) in parts {
                let own = |head: Vec<u8>| if part { MAGIC.starts_with(&head) } else { head == MAGIC };
                if !begins(&path)?.is_none_or(own) {
                    return refuse(
                        Code::FileTaken,
                        &format!("--checkpoint: `{}` is not a checkpoint", path.display()),
                        "name another file; tankcheck does not overwrite this one",
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

fn refuse<T>(code: Code, what: &str, help: &str) -> Result<T, Error> {
    Err(Error::input(code, format!("{what}\n  help: {help}")))
}

/// Rejects a checkpoint that cannot be resumed. The engine checks later that it belongs to this run.
fn sound(path: &Path) -> Result<(), Error> {
    match inspect(path) {
        Ok(()) => Ok(()),
        Err(CheckpointError::File { reason, .. }) => {
            Err(Error::Files(files::error::Error::File { code: Code::FileUnreadable, path: path.into(), what: reason }))
        }
        Err(fault) => refuse(
            Code::Checkpoint,
            &format!("--resume: the checkpoint `{}` is {}", path.display(), fault.cause()),
            "remove --resume to start over and overwrite it, or name another file with --checkpoint",
        ),
    }
}

/// `out/` → `out.checkpoint`.
fn beside(out: &Path) -> PathBuf {
    // A folder without a name (`.`) has one as an absolute path.
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
    let fault = |e: std::io::Error| Error::Files(files::error::Error::unreadable(path, &e));
    if !path.exists() {
        return Ok(None);
    }
    if let Some(what) = files::special(path).map_err(fault)? {
        return Err(fault(std::io::Error::other(format!("found {what}, expected a checkpoint"))));
    }
    let mut head = Vec::new();
    let file = std::fs::File::open(path).map_err(fault)?;
    file.take(MAGIC.len() as u64).read_to_end(&mut head).map_err(fault)?;
    Ok(Some(head))
}

/// Prints the start of the nonlinear run of a job.
pub(crate) fn announce(job: &Job, global: &Global) {
    if let (Some(file), Some(motion)) = (&job.checkpoint, &job.case.ground_motion) {
        let what = format!("nonlinear run of {} s", plain(motion.horizontal.duration(), 2));
        announce_start(&what, file, job.nonlinear.checkpoint, global);
    }
}

/// Prints where a run starts and how often it writes a checkpoint.
/// * `every`: computing time between two checkpoints [s]
pub(crate) fn announce_start(what: &str, file: &CheckpointFile, every: f64, global: &Global) {
    if global.quiet {
        return;
    }
    let shown = file.path.display();
    let start = match (file.resume, file.path.exists()) {
        // The engine compares it with the model, which is not built yet.
        (true, true) => format!("resumes from `{shown}` if that is a checkpoint of this run"),
        (true, false) => format!("starts from the beginning; checkpoint `{shown}` does not exist"),
        (false, true) => format!("starts over and overwrites `{shown}`; use --resume to continue"),
        (false, false) => "starts".into(),
    };
    say!("{what}: {start}; a checkpoint every {} s of computing", plain(every, 0));
}

/// How the nonlinear run of these results ended.
fn end(results: &Results) -> Option<&End> {
    Some(&results.beside(EngineId::Nonlinear)?.end)
}

/// Removes the checkpoint of a finished run.
pub(crate) fn tidy(job: &Job, results: &Results) {
    if let (Some(file), Some(End::Completed | End::Collapsed { .. } | End::Left { .. })) =
        (&job.checkpoint, end(results))
    {
        file.remove();
    }
}

/// Prints how to continue an interrupted nonlinear run.
pub(crate) fn advise(job: &Job, results: &Results, global: &Global) {
    if let (Some(file), false) =
        (&job.checkpoint, matches!(end(results), Some(End::Completed | End::Collapsed { .. } | End::Left { .. })))
    {
        advise_resume(file, global);
    }
}

/// Prints how to continue an interrupted run, if it has a checkpoint.
pub(crate) fn advise_resume(file: &CheckpointFile, global: &Global) {
    if !global.quiet && file.path.exists() {
        say!("checkpoint: {}; repeat the command with --resume to continue", file.path.display());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checkpoint_is_next_to_the_output_folder() {
        for (out, file) in [("out", "out.checkpoint"), ("out/", "out.checkpoint"), ("a/b.c/", "a/b.c.checkpoint")] {
            assert_eq!(beside(Path::new(out)), Path::new(file));
        }
        let here = beside(Path::new("."));
        assert!(here.is_absolute() && here.to_string_lossy().ends_with(".checkpoint"));
    }
}
