//! The Python package and the archive around the program of this build (`python/`, `packaging/archive`). The wheel: `.ci/run`.

use std::path::Path;
use std::process::Command;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// `python/tests` from the source tree, with the program of this build.
pub(crate) fn the_python_package_runs_the_program(python: &Path) {
    passes(
        Command::new(python)
            .args(["-m", "unittest", "discover", "--start-directory", "python/tests"])
            .env("PYTHONPATH", format!("{ROOT}/python"))
            .env("PYTHONDONTWRITEBYTECODE", "1")
            .env("TANKCHECK_BINARY", env!("CARGO_BIN_EXE_tankcheck")),
    );
}

/// The archive of this build has what a release has, and the sum that is written with it.
pub(crate) fn the_archive_is_complete(_: &Path) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    passes(
        Command::new("packaging/archive")
            .args(["--binary", env!("CARGO_BIN_EXE_tankcheck"), "--out"])
            .arg(folder.path()),
    );
    let mut listing = Command::new("sh");
    listing
        .args(["-c", "sha256sum --quiet --check SHA256SUMS && tar -tzf tankcheck-*.tar.gz"])
        .current_dir(folder.path());
    let files = passes(&mut listing);
    for file in [
        "/tankcheck",
        "/README.md",
        "/licences/LICENSE-MIT",
        "/licences/THIRD-PARTY.txt",
        "/completions/_tankcheck",
        "/man/tankcheck.1",
        "/man/tankcheck-compare.1",
    ] {
        assert!(files.lines().any(|line| line.ends_with(file)), "{file} is missing:\n{files}");
    }
}

/// Output of a command of the repository's root; panics with all of it if the command fails.
fn passes(command: &mut Command) -> String {
    if command.get_current_dir().is_none() {
        command.current_dir(ROOT);
    }
    let done = command.output().expect("the command starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(done.status.success(), "{command:?}\n{}{}", text(&done.stdout), text(&done.stderr));
    text(&done.stdout)
}
