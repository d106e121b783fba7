//! Submit scripts: the task engine runs one command per task, and needs nothing else.

use std::fmt::Write;

/// An engine of tasks.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheduler {
    /// HyperQueue: `hq.sh`.
    Hq,
    /// Slurm: `slurm.sh`, an array job.
    Slurm,
    /// PBS: `pbs.sh`, an array job.
    Pbs,
    /// Snakemake: `Snakefile` with one rule.
    Snakemake,
}

/// Array elements of a batch system start in about a second each: tasks are put together so that there are at most so many.
const MOST_ELEMENTS: usize = 1000;

impl Scheduler {
    /// Name of its file in the folder of the study.
    pub fn file(self) -> &'static str {
        match self {
            Scheduler::Hq => "hq.sh",
            Scheduler::Slurm => "slurm.sh",
            Scheduler::Pbs => "pbs.sh",
            Scheduler::Snakemake => "Snakefile",
        }
    }

    /// The file. It runs in the folder of the study.
    ///
    /// * `arguments`: the user's arguments for the scheduler, kept as they are
    pub fn script(self, tasks: usize, arguments: &str) -> String {
        let elements = tasks.min(MOST_ELEMENTS);
        let mut text = String::new();
        let _ = match self {
            Scheduler::Hq => write!(
                text,
                "#!/bin/sh\n# Submits one HyperQueue task for each task of the study; the number comes from HQ_TASK_ID.\nset -e\ncd \"$(dirname \"$0\")\"\n\
                 exec hq submit --array 1-{tasks} --cpus 1 {arguments} -- tankcheck study run . --task auto --quiet\n"
            ),
            Scheduler::Slurm => write!(
                text,
                "#!/bin/sh\n# Submit in this folder: sbatch {arguments} slurm.sh\n#SBATCH --array=1-{elements}\n#SBATCH --cpus-per-task=1\n\
                 #SBATCH --output=slurm-%A.log\n#SBATCH --open-mode=append\n{}\
                 exec tankcheck study run . --shard \"$SLURM_ARRAY_TASK_ID/{elements}\" --jobs 1 --quiet\n",
                directives("#SBATCH", arguments)
            ),
            Scheduler::Pbs => write!(
                text,
                "#!/bin/sh\n#PBS -J 1-{elements}\n#PBS -l select=1:ncpus=1\n{}cd \"$PBS_O_WORKDIR\" || exit 2\n\
                 exec tankcheck study run . --shard \"$PBS_ARRAY_INDEX/{elements}\" --jobs 1 --quiet\n",
                directives("#PBS", arguments)
            ),
            Scheduler::Snakemake => write!(
                text,
                "# snakemake -j N {arguments}\nELEMENTS = {elements}\n\nrule all:\n    input: \"rows.csv\"\n\nrule part:\n    \
                 output: touch(\"done/{{part}}\")\n    shell: f\"tankcheck study run . --shard {{{{wildcards.part}}}}/{{ELEMENTS}} --jobs 1 --quiet\"\n\n\
                 rule merge:\n    input: expand(\"done/{{part}}\", part=range(1, ELEMENTS + 1))\n    output: \"rows.csv\"\n    \
                 shell: \"tankcheck study merge .\"\n"
            ),
        };
        text
    }
}

fn directives(word: &str, arguments: &str) -> String {
    match arguments.trim() {
        "" => String::new(),
        given => format!("{word} {given}\n"),
    }
}

/// The number of the task that a task engine gives its process.
pub fn of_environment() -> Option<usize> {
    let number = |name: &str| std::env::var(name).ok()?.trim().parse().ok();
    ["HQ_TASK_ID", "SLURM_ARRAY_TASK_ID", "PBS_ARRAY_INDEX"].into_iter().find_map(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The user's arguments are not split: an account with a blank in quotes stays whole.
    #[test]
    fn arguments_are_kept_as_they_are() {
        let given = "--account='a b' --partition=short";
        for scheduler in [Scheduler::Hq, Scheduler::Slurm, Scheduler::Pbs] {
            assert!(scheduler.script(5000, given).contains(given), "{scheduler:?}");
        }
        assert!(Scheduler::Slurm.script(5000, "").contains("--array=1-1000\n"));
    }
}
