//! Tests that need another program: where it is absent they are counted as ignored, with the reason.
//!
//! Chromium (`CHROMIUM` names another binary) prints and measures the report; python3 with meshio reads the ParaView files; `unshare` makes file
//! systems that are full or read-only; python3 with hyperqueue (`HYPERQUEUE_PYTHON` names another interpreter), snakemake (`SNAKEMAKE`) and Slurm
//! of Debian run studies, python3 with pandas and pyarrow (`PANDAS_PYTHON`) reads their rows; python3 runs the package of `python/`, collects the
//! licences of an archive and reads the workbook, which LibreOffice opens too; pandoc makes a text document; pdftotext
//! of poppler finds the pages of a printed report; xmllint and python3 with jsonschema
//! hold test reports against their schemas.

mod desk;
mod forms;
mod report_print;
#[path = "../golden/sample/mod.rs"]
mod sample;
mod study;
mod vtu;
mod wheel;
mod workbook;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use libtest_mimic::{Arguments, Completion, Trial};

/// The program, or why the test cannot run.
type Tool = fn() -> Result<PathBuf, &'static str>;

fn main() -> ExitCode {
    let trials = vec![
        trial("desk::a_tank_is_entered", chromium, desk::a_tank_is_entered_from_an_empty_form),
        trial("desk::the_verdict_follows_what_is_typed", chromium, desk::the_verdict_follows_what_is_typed),
        trial("desk::a_record_is_dropped_run_and_looked_at", chromium, desk::a_record_is_dropped_run_and_looked_at),
        trial("desk::records_are_kept_by_keyboard", chromium, desk::records_are_kept_by_keyboard),
        trial("desk::every_room_fits_in_both_languages", chromium, desk::every_room_fits_in_both_languages),
        trial("report_print::it_prints_to_clean_pages", chromium, report_print::it_prints_to_clean_pages),
        trial(
            "report_print::nothing_is_cut_off_on_screen_phone_and_paper",
            chromium,
            report_print::nothing_is_cut_off_on_screen_phone_and_paper,
        ),
        trial("forms::pages_are_few", chromium, forms::pages_are_few),
        trial("forms::the_program_prints", chromium, forms::the_program_prints),
        trial(
            "forms::contents_have_the_pages_of_their_sections",
            pdftotext,
            forms::contents_have_the_pages_of_their_sections,
        ),
        trial("forms::pandoc_makes_a_clean_document", pandoc, forms::pandoc_makes_a_clean_document),
        trial("forms::pictures_are_metafiles", pandoc, forms::pictures_are_metafiles),
        trial("workbook::the_workbook_has_the_values", python, workbook::the_workbook_has_the_values),
        trial("workbook::the_workbook_takes_every_text", python, workbook::the_workbook_takes_every_text),
        trial("workbook::libreoffice_opens_the_workbook", libreoffice, workbook::libreoffice_opens_the_workbook),
        trial("forms::junit_keeps_its_schema", xmllint, forms::junit_keeps_its_schema),
        trial("forms::sarif_keeps_its_schema", jsonschema, forms::sarif_keeps_its_schema),
        trial("report_print::look", looked_at, report_print::look),
        trial("study::a_read_only_folder_is_one_message", unshare, study::a_read_only_folder_is_one_message),
        trial("study::a_full_disk_loses_nothing", unshare, study::a_full_disk_loses_nothing),
        trial("study::hyperqueue_is_killed_and_resumed", hyperqueue, study::hyperqueue_is_killed_and_resumed),
        trial("study::a_slurm_array_is_killed_and_resumed", slurm, study::a_slurm_array_is_killed_and_resumed),
        trial("study::pandas_reads_the_rows", pandas, study::pandas_reads_the_rows),
        trial("study::snakemake_runs_the_written_rule", snakemake, study::snakemake_runs_the_written_rule),
        trial("vtu::meshio_reads_what_is_written", meshio, vtu::meshio_reads_what_is_written),
        trial("wheel::the_python_package_runs_the_program", python, wheel::the_python_package_runs_the_program),
        trial("wheel::the_archive_is_complete", archiver, wheel::the_archive_is_complete),
    ];
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

fn trial(name: &str, tool: Tool, run: fn(&Path)) -> Trial {
    Trial::ignorable_test(name, move || {
        Ok(match tool() {
            Ok(program) => {
                run(&program);
                Completion::Completed
            }
            Err(reason) => Completion::ignored_with(reason),
        })
    })
}

/// Whether a program starts and succeeds.
fn succeeds(program: &Path, arguments: &[&str]) -> bool {
    let mut command = Command::new(program);
    command.args(arguments).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|s| s.success())
}

fn chromium() -> Result<PathBuf, &'static str> {
    let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
    let usual = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"].map(PathBuf::from);
    let found = named.into_iter().chain(usual).find(|program| succeeds(program, &["--version"]));
    found.ok_or("skipped: Chromium is not installed (CHROMIUM names another binary)")
}

fn meshio() -> Result<PathBuf, &'static str> {
    let python = PathBuf::from("python3");
    match succeeds(&python, &["-c", "import meshio, numpy"]) {
        true => Ok(python),
        false => Err("skipped: python3 with meshio (PyPI) is not installed"),
    }
}

/// Namespaces of mounts and network: the kernel may refuse them.
fn unshare() -> Result<PathBuf, &'static str> {
    let unshare = PathBuf::from("unshare");
    let script = "mount -t tmpfs tmpfs /mnt";
    match succeeds(&unshare, &["--mount", "--net", "--map-root-user", "sh", "-c", script]) {
        true => Ok(unshare),
        false => Err("skipped: unshare (util-linux) is not installed, or the kernel refuses namespaces"),
    }
}

fn hyperqueue() -> Result<PathBuf, &'static str> {
    unshare()?;
    let python = std::env::var_os("HYPERQUEUE_PYTHON").map_or_else(|| PathBuf::from("python3"), PathBuf::from);
    match succeeds(&python, &["-c", "import hyperqueue"]) {
        true => Ok(python),
        false => Err(
            "skipped: python3 with hyperqueue (PyPI) is not installed (HYPERQUEUE_PYTHON names another interpreter)",
        ),
    }
}

fn snakemake() -> Result<PathBuf, &'static str> {
    let program = std::env::var_os("SNAKEMAKE").map_or_else(|| PathBuf::from("snakemake"), PathBuf::from);
    match succeeds(&program, &["--version"]) {
        true => Ok(program),
        false => Err("skipped: snakemake (PyPI) is not installed (SNAKEMAKE names another binary)"),
    }
}

/// A Slurm of one node needs root, its daemons and munge.
fn slurm() -> Result<PathBuf, &'static str> {
    let node = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tools/slurm-node"));
    match succeeds(&node, &["sinfo"]) {
        true => Ok(node),
        false => Err(
            "skipped: slurmctld, slurmd, slurm-client and munge (Debian) are not installed, or this user is not root",
        ),
    }
}

fn pandas() -> Result<PathBuf, &'static str> {
    let python = std::env::var_os("PANDAS_PYTHON").map_or_else(|| PathBuf::from("python3"), PathBuf::from);
    match succeeds(&python, &["-c", "import pandas, pyarrow"]) {
        true if cfg!(feature = "parquet") => Ok(python),
        true => Err("skipped: built without the feature `parquet`"),
        false => Err(
            "skipped: python3 with pandas and pyarrow (PyPI) is not installed (PANDAS_PYTHON names another interpreter)",
        ),
    }
}

fn python() -> Result<PathBuf, &'static str> {
    let python = PathBuf::from("python3");
    match succeeds(&python, &["-c", "import sys; sys.exit(sys.version_info < (3, 9))"]) {
        true => Ok(python),
        false => Err("skipped: python3 (3.9 or later) is not installed"),
    }
}

fn installed(program: &str, arguments: &[&str], reason: &'static str) -> Result<PathBuf, &'static str> {
    let program = PathBuf::from(program);
    if succeeds(&program, arguments) { Ok(program) } else { Err(reason) }
}

fn pdftotext() -> Result<PathBuf, &'static str> {
    chromium()?;
    installed("pdftotext", &["-v"], "skipped: pdftotext (poppler-utils) is not installed")
}

fn pandoc() -> Result<PathBuf, &'static str> {
    installed("pandoc", &["--version"], "skipped: pandoc is not installed")
}

fn libreoffice() -> Result<PathBuf, &'static str> {
    installed("soffice", &["--version"], "skipped: LibreOffice (libreoffice-calc) is not installed")
}

fn xmllint() -> Result<PathBuf, &'static str> {
    installed("xmllint", &["--version"], "skipped: xmllint (libxml2-utils) is not installed")
}

fn jsonschema() -> Result<PathBuf, &'static str> {
    installed("python3", &["-c", "import jsonschema"], "skipped: python3 with jsonschema (PyPI) is not installed")
}

fn archiver() -> Result<PathBuf, &'static str> {
    match python().is_ok() && succeeds(Path::new("tar"), &["--sort=name", "--version"]) {
        true => Ok(PathBuf::from("tar")),
        false => Err("skipped: python3 or GNU tar is not installed"),
    }
}

fn looked_at() -> Result<PathBuf, &'static str> {
    std::env::var_os("TANKCHECK_LOOK").map(PathBuf::from).ok_or("run on demand: TANKCHECK_LOOK names the folder")
}
