//! The folders of `compare`: what is written into them, and what of earlier results it replaces.

use std::path::Path;

use super::Args;
use crate::cli::nonlinear;
use crate::cli::terminal as stream;
use crate::error::Error;
use crate::job::Job;
use crate::pipeline::{self, Outcome};
use files::OutputFolder;
use files::code::{Code, Warning};
use report;
use results::{self, scene, vtu};

/// Where a run writes.
pub(super) struct Folders {
    /// Results and report.
    pub out: OutputFolder,
    /// States for ParaView.
    pub vtu: Option<OutputFolder>,
}

impl Folders {
    pub(super) fn prepare(args: &Args, job: &Job) -> Result<Folders, Error> {
        if args.vtu.as_ref() == Some(&args.out) {
            return Err(Error::conflict(format!(
                "--vtu and --out are the same folder, `{}`\n  help: use a separate folder for each",
                args.out.display()
            )));
        }
        let prepare = match job.checkpoint {
            Some(_) => OutputFolder::prepare_alone,
            None => OutputFolder::prepare,
        };
        let out = prepare(&args.out, results::COMPARE)?;
        let vtu = args.vtu.as_ref().map(|target| OutputFolder::prepare(target, vtu::FOLDER));
        Ok(Folders { out, vtu: vtu.transpose()? })
    }

    /// Writes results, report and states; returns the names of [`OutputFolder::stale`].
    pub(super) fn write(self, args: &Args, job: &Job, outcome: &mut Outcome) -> Result<Vec<String>, Error> {
        if !args.no_report {
            pipeline::draw(job, &mut outcome.results)?;
        }
        let Outcome { results, series, snapshots } = outcome;
        results::write(&self.out.path(), results, series)?;
        if !args.no_report {
            let series = std::mem::take(series).as_written();
            report::render_run(&self.out.path(), &series, args.templates.as_deref(), args.level.level())?;
        }
        if let Some((engine, snapshots)) = snapshots {
            if args.scene {
                scene::write(&self.out.path(), &results.tank, (*engine, snapshots))?;
            }
            if let Some(vtu) = &self.vtu {
                vtu::write(&vtu.path(), snapshots)?;
            }
        }
        let stale = self.out.stale();
        self.out.commit()?;
        // Without a state the folder is not changed.
        if let Some(vtu) = self.vtu.filter(|_| snapshots.is_some()) {
            vtu.commit()?;
        }
        nonlinear::tidy(job, results);
        Ok(stale)
    }
}

/// Before a run: what of the earlier results in its folder the new ones will not have, so that Ctrl-C keeps it.
pub(super) fn announce_loss(out: &Path, folder: &OutputFolder, job: &Job) {
    let Ok(earlier) = results::read(out) else { return };
    let runs = earlier.runs.iter().filter(|run| !job.engines.contains(&run.engine));
    let mut lost: Vec<String> = runs.map(|run| format!("a {} run", run.engine.name())).collect();
    let horizontal = earlier.records.first().filter(|_| job.case.ground_motion.is_none());
    lost.extend(horizontal.map(|record| format!("the run under the record {}", record.name)));
    let parts = job.without.iter().filter(|part| earlier.has(**part));
    lost.extend(parts.map(|part| part.name().to_owned()));
    // Nothing is written yet, so that these are all that the earlier run owns.
    lost.extend(folder.stale().into_iter().filter(|name| results::FORMS.contains(&name.as_str())));
    if lost.is_empty() {
        return;
    }
    let text = format!(
        "{}: this run replaces earlier results with {}; to keep them, stop it (Ctrl-C) and name another folder with --out",
        out.display(),
        lost.join(", ")
    );
    stream::warn("", &Warning::new(Code::Replaced, text));
}

/// Names what of an earlier run is gone.
///
/// * `stale`: of [`OutputFolder::stale`], before its commit
pub(crate) fn replaced(out: &Path, stale: &[String]) {
    if !stale.is_empty() {
        let text = format!(
            "{}: {} of the earlier results removed, of which the new ones have none",
            out.display(),
            stale.join(", ")
        );
        stream::warn("", &Warning::new(Code::Replaced, text));
    }
}
