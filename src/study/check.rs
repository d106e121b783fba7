//! What is damaged in the folder of a study.

use std::path::Path;

use fem::progress::Progress;
use serde::Serialize;

use super::plan::{Plan, Task};
use super::store::{self, Found};
use super::{curves::beside_each_other, folder};

/// Tasks that one core checks at a time.
const TOGETHER: usize = 16;

/// A damaged file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Damage {
    /// Its path in the folder, with `/` between its parts.
    pub file: String,
    /// Number of the task whose result belongs there.
    pub task: Option<usize>,
    /// What is wrong.
    pub what: String,
}

/// The results of a study, each read whole and compared with the plan.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Checked {
    /// Tasks.
    pub tasks: usize,
    /// Those with a sound result.
    pub sound: usize,
    /// Those without a result.
    pub missing: usize,
    /// Those that failed.
    pub failed: usize,
    /// Results of no task of this plan: of earlier plans.
    pub of_earlier_plans: usize,
    /// What is damaged.
    pub damaged: Vec<Damage>,
    /// Folders with the name of a staging folder, which this program neither uses nor removes.
    pub unmarked: Vec<String>,
}

/// Checks the folder of a study; nothing is changed.
pub fn check(home: &Path, (plan, tasks): (&Plan, &[Task]), progress: &dyn Progress) -> Checked {
    progress.stage("checking results", tasks.len() as u64);
    let one = |task: &Task| {
        let found = store::find(home, plan, task);
        progress.advance(1);
        let found = match found {
            Found::Whole(_) => Found::Whole(Vec::new()),
            other => other,
        };
        (task.task, store::name(&task.key), found)
    };
    let parts: Vec<&[Task]> = tasks.chunks(TOGETHER).collect();
    let found = beside_each_other(&parts, |part: &&[Task]| part.iter().map(one).collect());
    let mut checked = Checked { tasks: tasks.len(), ..Checked::default() };
    for (task, file, found) in found {
        match found {
            Found::Whole(_) => checked.sound += 1,
            Found::Missing => checked.missing += 1,
            Found::Failed => checked.failed += 1,
            Found::Damaged(what) => checked.damaged.push(Damage { file, task: Some(task), what }),
        }
    }
    let mut others = store::survey(home).results;
    for task in tasks {
        others.remove(&task.key);
    }
    checked.of_earlier_plans = others.len();
    checked.damaged.extend(folder::differing(home).map(|file| Damage {
        file,
        task: None,
        what: "was changed or removed since it was written".into(),
    }));
    let name = |path: std::path::PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    checked.unmarked = files::unmarked(home).into_iter().map(name).collect();
    checked
}
