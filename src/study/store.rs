//! Results of tasks: `results/ab/<key>.jsonl`.
//!
//! A result is written to a temporary file, synchronised and renamed. Its last line has the key of the task, the number of lines before it and their
//! SHA-256. A file without it was cut off, one with another key is the result of another task, one whose rows are not those of the plan is neither: all
//! are damaged, and count as missing. An error is a file `<key>.err.json` beside it.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::belongs;
use super::plan::{Plan, Task};
use super::rows::Line;
use crate::error::Error;
use files::error::describe;

/// End of the name of a result.
const LINES: &str = ".jsonl";

/// Folder of the results.
pub const RESULTS: &str = "results";

/// The last line of a result.
#[derive(Serialize, Deserialize)]
struct Closing {
    key: String,
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

/// What stands where the result of a task belongs.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    /// Its result.
    Whole(Vec<Line>),
    /// Nothing.
    Missing,
    /// Nothing: the task failed, and nobody asked to try again.
    Failed,
    /// Something else, and why.
    Damaged(String),
}

impl Found {
    /// Whether it is the result.
    pub fn whole(&self) -> bool {
        matches!(self, Found::Whole(_))
    }
}

/// Path of the result of a task in the folder of the study, with `/` between its parts.
pub fn name(key: &str) -> String {
    format!("{RESULTS}/{}/{key}{LINES}", key.get(..2).unwrap_or("00"))
}

fn path(folder: &Path, key: &str, end: &str) -> PathBuf {
    let two = key.get(..2).unwrap_or("00");
    folder.join(RESULTS).join(two).join(format!("{key}{end}"))
}

fn unwritten(path: &Path, error: &std::io::Error) -> Error {
    Error::Files(files::error::Error::Unwritten { path: path.into(), what: describe(error) })
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
    /// Keys of the files of results, of this plan and of earlier ones.
    pub results: BTreeSet<String>,
    /// Marks and half-written files of processes of this machine that have ended.
    ended: Vec<PathBuf>,
}

impl Survey {
    /// Removes what processes left that have ended.
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
        if let Some(key) = name.strip_suffix(LINES) {
            found.results.insert(key.into());
        }
        let runs = name.strip_suffix(RUNNING);
        let Some(mark) = runs.or_else(|| name.strip_suffix(files::PART)) else { continue };
        let mut words = mark.rsplit('.').skip(1);
        let (Some(process), Some(machine)) = (words.next(), words.next()) else { continue };
        let key = mark.split('.').next().unwrap_or_default();
        let ended = machine == here && tells && !Path::new("/proc").join(process).exists();
        match (ended, runs) {
            (true, _) => found.ended.push(entry.path()),
            (false, None) => {}
            (false, Some(_)) if machine == here && tells => drop(found.here.insert(key.into())),
            (false, Some(_)) => drop(found.elsewhere.insert(key.into())),
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
    let plain: String = name.trim().chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-').collect();
    if plain.is_empty() { "host".into() } else { plain }
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
    let closing = Closing { key: key.into(), lines: lines.len(), sha256: super::key::hex(&text) };
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
    let failure = Failure { task, message: message.into(), host: host() };
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

/// Reads what stands where the result of a task belongs.
pub fn find(folder: &Path, plan: &Plan, task: &Task) -> Found {
    let found = match files::read(&path(folder, &task.key, LINES)) {
        Ok(bytes) => whole(&bytes, &task.key),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            return match failure(folder, &task.key) {
                Some(_) => Found::Failed,
                None => Found::Missing,
            };
        }
        Err(error) => Err(describe(&error)),
    };
    match found {
        Ok(lines) => match belongs::stranger(plan, task, &lines) {
            None => Found::Whole(lines),
            Some(what) => Found::Damaged(what),
        },
        Err(what) => Found::Damaged(what),
    }
}

/// The lines before the closing one.
///
/// Errors: why the file is not the whole result of the task.
fn whole(bytes: &[u8], key: &str) -> Result<Vec<Line>, String> {
    let torn = || "is cut off or changed".to_owned();
    let body = bytes.strip_suffix(b"\n").ok_or_else(torn)?;
    let start = body.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    let closing: Closing = serde_json::from_slice(&body[start..]).map_err(|_| torn())?;
    let lines = &bytes[..start];
    if super::key::hex(lines) != closing.sha256 {
        return Err(torn());
    }
    if closing.key != key {
        return Err(format!("is the result of another task, {}", closing.key));
    }
    let all = serde_json::Deserializer::from_slice(lines).into_iter();
    let all: Vec<Line> = all.collect::<Result<_, _>>().map_err(|e| format!("is not a result of this program: {e}"))?;
    if all.len() == closing.lines { Ok(all) } else { Err(torn()) }
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
    use crate::study::plan::tests::{lines, plan, task};

    #[test]
    fn a_result_is_whole_or_damaged() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, plan, task) = (folder.path(), plan(), task(1));
        let found = || find(folder, &plan, &task);
        assert_eq!(found(), Found::Missing);
        write(folder, &task.key, &lines(&plan, &task)).unwrap();
        assert_eq!(found(), Found::Whole(lines(&plan, &task)));
        let file = folder.join(name(&task.key));
        let bytes = fs::read(&file).unwrap();
        // Cut anywhere, or with a flipped digit, it does not count.
        for end in 0..bytes.len() {
            fs::write(&file, &bytes[..end]).unwrap();
            assert_eq!(found(), Found::Damaged("is cut off or changed".into()), "cut at {end}");
        }
        let mut changed = bytes.clone();
        let at = bytes.windows(3).position(|w| w == b"0.3").unwrap();
        changed[at + 2] = b'4';
        fs::write(&file, &changed).unwrap();
        assert!(matches!(found(), Found::Damaged(_)));
    }

    /// A file copied over that of another task, one whose lines are those of another task, a folder and a pipe: each says what it is.
    #[test]
    fn a_result_belongs_to_its_task() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, plan) = (folder.path(), plan());
        let [one, two] = [task(1), task(2)];
        for task in [&one, &two] {
            write(folder, &task.key, &lines(&plan, task)).unwrap();
        }
        let damage = || match find(folder, &plan, &two) {
            Found::Damaged(what) => what,
            other => panic!("{other:?}"),
        };
        let file = folder.join(name(&two.key));
        fs::copy(folder.join(name(&one.key)), &file).unwrap();
        assert_eq!(damage(), format!("is the result of another task, {}", one.key));
        write(folder, &two.key, &lines(&plan, &one)).unwrap();
        assert!(damage().contains("expected the tank `b`"), "{}", damage());
        let mut short = lines(&plan, &two);
        short.pop();
        write(folder, &two.key, &short).unwrap();
        assert!(damage().contains("ends at line 2, expected"), "{}", damage());
        fs::remove_file(&file).unwrap();
        fs::create_dir(&file).unwrap();
        assert!(damage().contains("found a folder"), "{}", damage());
    }

    /// A mark of this process is running, one of a process that cannot be (numbers end at 2²²) has ended, one of another machine is told apart.
    #[cfg(target_os = "linux")]
    #[test]
    fn marks_of_running_tasks() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let mark = begin(folder, "abcd").unwrap();
        let ended = ["run", "part"].map(|end| folder.join(format!("results/ab/abce.jsonl.{}.4194999.1.{end}", host())));
        for path in &ended {
            fs::write(path, "").unwrap();
        }
        fs::write(folder.join("results/ab/abcf.other-machine-x.1.1.run"), "").unwrap();
        let found = survey(folder);
        assert!(found.here.contains("abcd") && found.here.len() == 1);
        assert!(found.elsewhere.contains("abcf") && found.elsewhere.len() == 1);
        found.tidy();
        assert!(ended.iter().all(|path| !path.exists()));
        drop(mark);
        assert!(survey(folder).here.is_empty());
    }

    #[test]
    fn a_failure_is_kept_until_it_is_cleared() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, plan, task) = (folder.path(), plan(), task(1));
        fail(folder, &task.key, 3, "no equilibrium").unwrap();
        assert_eq!(find(folder, &plan, &task), Found::Failed);
        assert_eq!(failure(folder, &task.key).unwrap().task, 3);
        clear(folder, &task.key).unwrap();
        assert_eq!(find(folder, &plan, &task), Found::Missing);
    }
}
