//! The whole flow of a pushover: job → shells → `push.json`, report.

use fem::progress::Progress;

use crate::error::Error;
use crate::fe::nonlinear::push::pushover;
use crate::job::PushJob;
use crate::output::{Kind, OutputFolder, kept_complete};
use crate::report::{self, FIGURES_FOLDER, REPORT_FILE};
use crate::results::{PUSH_FILE, PUSH_FORMAT, Push, Volatile, finite, read_push, write_push};

/// Results of a pushover.
const PUSH: Kind = Kind {
    id: "push",
    option: "--out",
    names: |name| [PUSH_FILE, REPORT_FILE, FIGURES_FOLDER].contains(&name),
    keeps: |_| false,
};

/// Runs a job; `volatile` stamps the results.
///
/// Errors: a tank or option that a pushover does not know; a folder that holds something else or cannot be written; a wall
/// that does not carry its liquid at rest. That it fails under the pushing is none.
pub fn run(job: &PushJob, volatile: impl Fn() -> Volatile, progress: &dyn Progress) -> Result<Push, Error> {
    // Whatever is wrong with the folder is said before anything is computed.
    let folder = OutputFolder::prepare_alone(&job.out, PUSH)?;
    let case = &job.job.case;
    let pushed = pushover(
        case,
        &job.job.nonlinear,
        &job.options,
        job.checkpoint.as_ref(),
        progress,
    )?;
    let push = Push {
        format: PUSH_FORMAT.into(),
        volatile: volatile(),
        name: case.name.clone(),
        gravity: case.gravity,
        files: job.job.files.clone(),
        model: pushed.model,
        assumptions: pushed.assumptions,
        shells: pushed.shells,
        limits: pushed.limits,
        incomplete: !pushed.interruption.is_empty(),
        doubts: [job.job.warnings.clone(), pushed.doubts].concat(),
        interruption: pushed.interruption,
    };
    finite::check("pushover", &push)?;
    let earlier = read_push(&job.out.join(PUSH_FILE));
    if push.incomplete && earlier.is_ok_and(|earlier| !earlier.incomplete) {
        progress.warn(&kept_complete(&job.out));
        return Ok(push);
    }
    write_push(&folder.path().join(PUSH_FILE), &push)?;
    report::push::report(&push)?.write(&folder.path())?;
    folder.commit()?;
    if let Some(file) = job.checkpoint.as_ref().filter(|_| !push.incomplete) {
        file.remove();
    }
    Ok(push)
}
