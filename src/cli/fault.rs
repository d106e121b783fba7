//! Panic handler: a fault of the program itself, in any thread, ends the run with one line and exit code 3. The line
//! gives the place of the fault, the input files that reproduce it and the address for reports. Partial files are
//! removed; complete files, including a checkpoint, stay.

use std::panic::PanicHookInfo;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::cli::terminal::say;
use crate::error::EXIT_COMPUTATION;
use files::code::Code;

/// Set by the first thread that panics.
static FAULT: AtomicBool = AtomicBool::new(false);

/// Installs the panic hook, which ends the process at the first panic.
pub(crate) fn install() {
    std::panic::set_hook(Box::new(|info| {
        // One line is enough: while the first thread ends the process, all others wait.
        while FAULT.swap(true, Ordering::SeqCst) {
            std::thread::park();
        }
        files::discard_unfinished();
        say!("{}", message(info, std::env::args().skip(1)));
        std::process::exit(i32::from(EXIT_COMPUTATION));
    }));
}

/// The line of a fault.
fn message(info: &PanicHookInfo<'_>, arguments: impl Iterator<Item = String>) -> String {
    let payload = info.payload();
    let what = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no message");
    let place =
        info.location().map_or_else(|| "an unknown place".to_owned(), |at| format!("{}:{}", at.file(), at.line()));
    line(what, &place, arguments)
}

/// `error[T0711]: internal fault at src/a.rs:7: what; please report it to … with the command and the files tank.json`.
fn line(what: &str, place: &str, arguments: impl Iterator<Item = String>) -> String {
    let arguments: Vec<String> = arguments.collect();
    let files: Vec<String> = arguments
        .iter()
        .map(|argument| argument.split_once('=').map_or(argument.as_str(), |(_, value)| value))
        .filter(|value| Path::new(value).is_file())
        .map(|file| format!("`{}`", file.escape_debug()))
        .collect();
    let input = if files.is_empty() { String::new() } else { format!(" and {}", files.join(", ")) };
    format!(
        "{}: internal fault at {place}: {}; please report it to {} with the command `tankcheck {}`{input} (tankcheck {})",
        Code::Internal.head(),
        what.escape_debug(),
        maintainers(env!("CARGO_PKG_REPOSITORY")),
        arguments.join(" ").escape_debug(),
        env!("CARGO_PKG_VERSION")
    )
}

/// Address for reports of faults.
fn maintainers(repository: &str) -> &str {
    match repository {
        "" => "the maintainers",
        address => address,
    }
}

#[cfg(test)]
mod tests {
    use std::process::{Command, Output};

    use super::*;
    use files::OutputFolder;
    use results::COMPARE;

    /// Marks the process of the test below as the child.
    const CHILD: &str = "TANKCHECK_TEST_OF_FAULTS";

    /// Runs as a separate process: prepares an output folder and panics in a thread of the given name.
    #[test]
    fn child() {
        let Ok(home) = std::env::var(CHILD) else { return };
        install();
        let folder = OutputFolder::prepare(&Path::new(&home).join("out"), COMPARE).expect("a new folder");
        std::fs::write(folder.path().join("report.html"), "half").expect("staging is writable");
        let worker = std::thread::spawn(|| {
            let none: Vec<u8> = Vec::new();
            none[std::hint::black_box(3)]
        });
        let _ = worker.join();
        unreachable!("the process ends with its first panic");
    }

    fn run_child(home: &Path) -> Output {
        Command::new(std::env::current_exe().expect("this program"))
            .args(["--exact", "cli::fault::tests::child", "--nocapture"])
            .env(CHILD, home)
            .output()
            .expect("the child runs")
    }

    #[test]
    fn a_panic_in_a_worker_is_one_line_exit_code_3_and_no_staging() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let child = run_child(home.path());
        let text = String::from_utf8_lossy(&child.stderr);
        assert_eq!(child.status.code(), Some(3), "{text}");
        assert_eq!(text.lines().count(), 1, "{text}");
        for part in [
            "error[T0711]: internal fault at ",
            "fault.rs:",
            "index out of bounds",
            "please report it to",
            "with the command",
        ] {
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
        let left: Vec<_> = std::fs::read_dir(home.path()).expect("readable").flatten().collect();
        assert!(left.is_empty(), "{left:?}");
    }

    #[test]
    fn the_line_names_the_files_of_the_command_and_nothing_breaks_it() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let tank = home.path().join("tank.json");
        std::fs::write(&tank, "{}").expect("writable");
        let given = ["compare", &format!("{}", tank.display()), "--out", "a\u{1b}[2J"].map(String::from);
        let text = line("first\nsecond", "src/fe/mod.rs:7", given.into_iter());
        assert_eq!(text.lines().count(), 1, "{text}");
        assert!(text.contains("at src/fe/mod.rs:7: first\\nsecond"), "{text}");
        assert!(text.contains(&format!("and `{}`", tank.display())), "{text}");
        assert!(!text.contains('\u{1b}'), "{text}");
    }

    #[test]
    fn a_repository_is_named_where_there_is_one() {
        assert_eq!(maintainers(""), "the maintainers");
        assert_eq!(maintainers("https://example.org/tankcheck"), "https://example.org/tankcheck");
    }
}
