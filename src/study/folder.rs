//! The folder of a study: which files are those of a plan and of a merge, and reading and writing those of a plan.
//!
//! Both sets share the manifest of the folder. Each is moved into it as a whole, and keeps the files of the other; results are in files of their own.

use std::path::{Path, PathBuf};

use super::plan::{FORMAT, Plan, Task, list};
use super::{key, merge};
use crate::error::Error;
use files::code::Code;
use files::error::describe;
use files::{Kind, OutputFolder, write_whole};

/// Name of the plan.
pub const PLAN: &str = "plan.json";
/// Name of the list of tasks.
pub const TASKS: &str = "tasks.jsonl";

/// The files of a plan. A script is kept until it is written again.
pub const PLANNED: Kind = Kind {
    id: "study",
    option: "`study plan --out`",
    names: |name| [PLAN, TASKS].contains(&name),
    keeps: |name| ![PLAN, TASKS].contains(&name),
};

/// The files of a merge.
pub const MERGED: Kind = Kind { names: merge::writes, keeps: |name| !merge::writes(name), ..PLANNED };

/// The first file of a plan or a merge that was changed or removed since it was written. Scripts may be.
pub fn differing(folder: &Path) -> Option<String> {
    files::differing(folder, |name| (PLANNED.names)(name) || merge::writes(name))
}

/// Writes a plan into its folder. Results there are kept: those whose keys are unchanged count.
///
/// * `script`: name and text of a submit script
///
/// Errors: a folder with files of something else; those of the file system.
pub fn write(folder: &Path, plan: &Plan, tasks: &[Task], script: Option<(&str, String)>) -> Result<(), Error> {
    let taken = |what: &str| {
        Error::Files(files::error::Error::Taken {
            path: folder.into(),
            what: what.into(),
            help: "name another folder with --out".into(),
        })
    };
    if folder.join(PLAN).is_file() {
        let earlier = read(folder).map(|(plan, _)| plan);
        match earlier {
            Ok(earlier) if earlier.name != plan.name => {
                return Err(taken(&format!("has the study `{}`", earlier.name)));
            }
            _ => {}
        }
    } else if folder.is_dir() && std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some()) {
        return Err(taken("is not empty and has no study"));
    }
    let out = OutputFolder::prepare(folder, PLANNED)?;
    let text = serde_json::to_string_pretty(plan).map_err(|e| Error::report(e.to_string()))?;
    let texts = [(PLAN, text + "\n"), (TASKS, list(tasks)?)];
    for (name, text) in texts.into_iter().chain(script) {
        write_whole(&out.path().join(name), text.as_bytes())?;
    }
    Ok(out.commit()?)
}

/// Reads a plan and its tasks.
///
/// Errors: a folder without a plan; files that are not a plan, or do not belong together.
pub fn read(folder: &Path) -> Result<(Plan, Vec<Task>), Error> {
    let _reading = files::settle(folder);
    let fault = |path: PathBuf, what: String| {
        let code = Code::NotResults;
        Error::Files(files::error::Error::File { code, path, what })
    };
    let load = |name: &str| {
        let path = folder.join(name);
        files::read(&path).map_err(|e| {
            let what = match e.kind() {
                std::io::ErrorKind::NotFound => {
                    "no plan here; `tankcheck study plan STUDY --out FOLDER` makes one".into()
                }
                _ => describe(&e),
            };
            fault(path, what)
        })
    };
    let broken =
        |name: &str, e: serde_json::Error| fault(folder.join(name), format!("not a plan of this program: {e}"));
    #[derive(serde::Deserialize)]
    struct Head {
        format: String,
    }
    let text = load(PLAN)?;
    let head: Head = serde_json::from_slice(&text).map_err(|e| broken(PLAN, e))?;
    if head.format != FORMAT {
        return Err(fault(
            folder.join(PLAN),
            format!("found the format `{}`, expected `{FORMAT}`; plan again in another folder", head.format),
        ));
    }
    let plan: Plan = serde_json::from_slice(&text).map_err(|e| broken(PLAN, e))?;
    let text = load(TASKS)?;
    if key::hex(&text) != plan.tasks_sha256 {
        let what = format!("is not the list of tasks of {PLAN}; plan again");
        return Err(fault(folder.join(TASKS), what));
    }
    let tasks: Vec<Task> = serde_json::Deserializer::from_slice(&text)
        .into_iter()
        .collect::<Result<_, _>>()
        .map_err(|e| broken(TASKS, e))?;
    match tasks.iter().all(|task| fits(&plan, task)) {
        true => Ok((plan, tasks)),
        false => Err(fault(folder.join(PLAN), format!("does not have the tanks and records of {TASKS}; plan again"))),
    }
}

/// Whether a plan has the tanks and records of a task.
fn fits(plan: &Plan, task: &Task) -> bool {
    let tank = |&(tank, sample): &(usize, u32)| plan.tanks.get(tank).is_some_and(|t| t.keys.len() > sample as usize);
    task.tanks.iter().all(tank) && plan.records.get(task.records()).is_some()
}
