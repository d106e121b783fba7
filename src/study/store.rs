//! Results of tasks: `results/ab/<key>.jsonl`.
//!
//! A result is written to a temporary file, synchronised and renamed. Its last line has the number of lines before it and their
//! SHA-256; a file without it was cut off, or is of another program, and counts as missing. An error is a file `<key>.err.json` beside it.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::rows::Line;
use crate::error::Error;
use files::code::Code;
use files::error::describe;

/// End of the name of a result.
const LINES: &str = ".jsonl";

/// Folder of the results.
pub const RESULTS: &str = "results";

/// The last line of a result.
#[derive(Serialize, Deserialize)]
struct Closing {
    lines: usize,
    sha256: String,
}

/// Why a task has no result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// Number of the task.
    pub task: usize,
    /// Message.
    pub message: String,
    /// Machine on which it failed.
    pub host: String,
}

/// State of the result of a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Whole.
    Done,
    /// Not there.
    Missing,
    /// There, and not whole: cut off or changed.
    Torn,
    /// The task failed, and nobody asked to try again.
    Failed,
}

fn path(folder: &Path, key: &str, end: &str) -> PathBuf {
    let two = key.get(..2).unwrap_or("00");
    folder.join(RESULTS).join(two).join(format!("{key}{end}"))
}

fn unwritten(path: &Path, error: &std::io::Error) -> Error {
    Error::Files(files::error::Error::Unwritten {
        path: path.into(),
        what: describe(error),
    })
}

/// End of the name of the mark of a task that is being computed: `<key>.<host>.<process>.<thread>.run`, empty.
const RUNNING: &str = ".run";

/// Name of this machine, process and thread within a name of a file.
fn place() -> String {
    let thread = format!("{:?}", std::thread::current().id());
    let digits: String = thread.chars().filter(char::is_ascii_digit).collect();
    format!("{}.{}.{digits}", host(), std::process::id())
}

/// The mark of a task that this process computes; dropping it removes the file.
pub struct Mark(PathBuf);

impl Drop for Mark {
    fn drop(&mut self) {
        // Without it `status` counts a task as running that is not: no result depends on it.
        let _ = fs::remove_file(&self.0);
    }
}

/// Marks a task as running. Nothing is locked: two processes may compute the same task.
///
/// Errors: a folder that cannot be written, before anything is computed.
pub fn begin(folder: &Path, key: &str) -> Result<Mark, Error> {
    let path = path(folder, key, &format!(".{}{RUNNING}", place()));
    let write = || -> std::io::Result<()> {
        fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
        File::create(&path).map(drop)
    };
    match write() {
        Ok(()) => Ok(Mark(path)),
        Err(error) => Err(unwritten(&path, &error)),
    }
}

/// Size of the result of a task [bytes]; 0 without one.
pub fn size(folder: &Path, key: &str) -> u64 {
    fs::metadata(path(folder, key, LINES)).map_or(0, |m| m.len())
}

/// What stands in the folder of the results beside whole results.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Survey {
    /// Keys of tasks that processes of this machine compute now.
    pub here: BTreeSet<String>,
    /// Keys of tasks that other machines compute, or computed when they ended.
    pub elsewhere: BTreeSet<String>,
    /// Size of all files [bytes].
    pub bytes: u64,
    /// Marks of processes of this machine that have ended.
    ended: Vec<PathBuf>,
}

impl Survey {
    /// Removes the marks of processes that have ended.
    pub fn tidy(&self) {
        for path in &self.ended {
            // Another process may have removed it, and no result depends on it.
            let _ = fs::remove_file(path);
        }
    }
}

/// Looks at the folder of the results. No time is read: whether a process lives is asked of the system, where it tells (`/proc`).
pub fn survey(folder: &Path) -> Survey {
    let mut found = Survey::default();
    let (here, tells) = (host(), Path::new("/proc/self").exists());
    let parts = fs::read_dir(folder.join(RESULTS)).into_iter().flatten().flatten();
    for entry in parts.flat_map(|part| fs::read_dir(part.path()).into_iter().flatten().flatten()) {
        found.bytes += entry.metadata().map_or(0, |m| m.len());
        let name = entry.file_name().to_string_lossy().into_owned();
        let Some(mark) = name.strip_suffix(RUNNING) else {
            continue;
        };
        let mut words = mark.split('.');
        let (Some(key), Some(machine), Some(process)) = (words.next(), words.next(), words.next()) else {
            continue;
        };
        if machine != here || !tells {
            found.elsewhere.insert(key.into());
        } else if Path::new("/proc").join(process).exists() {
            found.here.insert(key.into());
        } else {
            found.ended.push(entry.path());
        }
    }
    found
}

/// Writes a file whole, through a name that no other process uses.
fn publish(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let part = folder.join(format!("{name}.{}{}", place(), files::PART));
    let write = || -> std::io::Result<()> {
        fs::create_dir_all(folder)?;
        let mut file = File::create(&part)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&part, path)
    };
    write().map_err(|error| {
        // The first error says more than one of removing what could not be written.
        let _ = fs::remove_file(&part);
        unwritten(path, &error)
    })
}

/// Name of this machine, for names of files and messages alone.
fn host() -> String {
    let name = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    let plain: String = name
        .trim()
        .chars()
        .filter(|c| c.is_ascii_alphanumeric() || *c == '-')
        .collect();
    match plain.is_empty() {
        true => "host".into(),
        false => plain,
    }
}

/// Writes the result of a task, and removes the record of an earlier failure; returns its size [bytes].
///
/// Errors: a disk that is full, a folder that cannot be written, a number that is not finite.
pub fn write(folder: &Path, key: &str, lines: &[Line]) -> Result<usize, Error> {
    let mut text = Vec::new();
    for line in lines {
        serde_json::to_writer(&mut text, line).map_err(|e| Error::report(e.to_string()))?;
        text.push(b'\n');
    }
    let closing = Closing {
        lines: lines.len(),
        sha256: super::key::hex(&text),
    };
    serde_json::to_writer(&mut text, &closing).map_err(|e| Error::report(e.to_string()))?;
    text.push(b'\n');
    publish(&path(folder, key, LINES), &text)?;
    clear(folder, key)?;
    Ok(text.len())
}

/// Records the failure of a task.
///
/// Errors: those of the file system.
pub fn fail(folder: &Path, key: &str, task: usize, message: &str) -> Result<(), Error> {
    let failure = Failure {
        task,
        message: message.into(),
        host: host(),
    };
    let text = serde_json::to_vec_pretty(&failure).map_err(|e| Error::report(e.to_string()))?;
    publish(&path(folder, key, ".err.json"), &text)
}

/// Forgets a failure.
///
/// Errors: those of the file system.
pub fn clear(folder: &Path, key: &str) -> Result<(), Error> {
    let path = path(folder, key, ".err.json");
    match fs::remove_file(&path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(unwritten(&path, &error)),
        _ => Ok(()),
    }
}

/// The recorded failure of a task.
pub fn failure(folder: &Path, key: &str) -> Option<Failure> {
    let text = files::read(&path(folder, key, ".err.json")).ok()?;
    serde_json::from_slice(&text).ok()
}

/// State of the result of a task; its bytes are read and hashed.
pub fn state(folder: &Path, key: &str) -> State {
    let file = path(folder, key, LINES);
    match files::read(&file) {
        Ok(bytes) if whole(&bytes).is_some() => State::Done,
        Ok(_) => State::Torn,
        Err(_) if path(folder, key, ".err.json").is_file() => State::Failed,
        Err(_) => State::Missing,
    }
}

/// The lines before the closing one; none of a file that is not whole.
fn whole(bytes: &[u8]) -> Option<&[u8]> {
    let body = bytes.strip_suffix(b"\n")?;
    let start = body.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    let closing: Closing = serde_json::from_slice(&body[start..]).ok()?;
    let lines = &bytes[..start];
    let count = lines.iter().filter(|b| **b == b'\n').count();
    (count == closing.lines && super::key::hex(lines) == closing.sha256).then_some(lines)
}

/// The lines of the result of a task; none if it is missing or not whole.
///
/// Errors: a line that this program did not write.
pub fn read(folder: &Path, key: &str) -> Result<Option<Vec<Line>>, Error> {
    let file = path(folder, key, LINES);
    let Ok(bytes) = files::read(&file) else { return Ok(None) };
    let Some(lines) = whole(&bytes) else { return Ok(None) };
    let mut all = Vec::new();
    for line in BufReader::new(lines).lines() {
        let line = line.map_err(|e| unreadable(&file, &e.to_string()))?;
        all.push(serde_json::from_str(&line).map_err(|e| unreadable(&file, &e.to_string()))?);
    }
    Ok(Some(all))
}

fn unreadable(file: &Path, what: &str) -> Error {
    Error::Files(files::error::Error::File {
        code: Code::NotResults,
        path: file.into(),
        what: format!("not a result of this program: {what}"),
    })
}

/// Hash of the merged rows.
pub(super) struct Rolling(Sha256);

impl Rolling {
    pub(super) fn new() -> Rolling {
        Rolling(Sha256::new())
    }

    pub(super) fn add(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    pub(super) fn hex(self) -> String {
        self.0.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::rows::{Row, RowStatus};

    fn line() -> Line {
        Line::Row(Box::new(Row {
            factor: 0.1 + 0.2,
            ..Row::blank("a", 0, "r", RowStatus::Ok)
        }))
    }

    #[test]
    fn a_result_is_whole_or_ignored() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, key) = (folder.path(), "abcd");
        assert_eq!(state(folder, key), State::Missing);
        write(folder, key, &[line(), line()]).unwrap();
        assert_eq!(state(folder, key), State::Done);
        assert_eq!(read(folder, key).unwrap().unwrap(), [line(), line()]);
        let file = folder.join("results/ab/abcd.jsonl");
        let bytes = fs::read(&file).unwrap();
        // Cut anywhere, or with a flipped digit, it does not count.
        for end in 0..bytes.len() {
            fs::write(&file, &bytes[..end]).unwrap();
            assert_eq!(state(folder, key), State::Torn, "cut at {end}");
            assert_eq!(read(folder, key).unwrap(), None);
        }
        let mut changed = bytes.clone();
        let at = bytes.windows(3).position(|w| w == b"0.3").unwrap();
        changed[at + 2] = b'4';
        fs::write(&file, &changed).unwrap();
        assert_eq!(state(folder, key), State::Torn);
    }

    /// A mark of this process is running, one of a process that cannot be (numbers end at 2²²) has ended, one of another machine is told apart.
    #[cfg(target_os = "linux")]
    #[test]
    fn marks_of_running_tasks() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let mark = begin(folder, "abcd").unwrap();
        let ended = folder.join(format!("results/ab/abce.{}.4194999.1.run", host()));
        fs::write(&ended, "").unwrap();
        fs::write(folder.join("results/ab/abcf.other-machine-x.1.1.run"), "").unwrap();
        let found = survey(folder);
        assert!(found.here.contains("abcd") && found.here.len() == 1);
        assert!(found.elsewhere.contains("abcf") && found.elsewhere.len() == 1);
        found.tidy();
        assert!(!ended.exists());
        drop(mark);
        assert!(survey(folder).here.is_empty());
        assert_eq!(state(folder, "abcd"), State::Missing);
    }

    #[test]
    fn a_failure_is_kept_until_it_is_cleared() {
        let folder = tempfile::tempdir().unwrap();
        fail(folder.path(), "abcd", 3, "no equilibrium").unwrap();
        assert_eq!(state(folder.path(), "abcd"), State::Failed);
        assert_eq!(failure(folder.path(), "abcd").unwrap().task, 3);
        clear(folder.path(), "abcd").unwrap();
        assert_eq!(state(folder.path(), "abcd"), State::Missing);
    }
}
