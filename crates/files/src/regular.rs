//! Regular files only: a pipe or a device has no end, and opening a pipe waits for its writer.

use std::fs::{File, FileType, Metadata};
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// What is at a path instead of a file that can be read to its end, with its article; none for such a file.
///
/// A pipe that the shell has opened (`<(…)`, `/dev/stdin`) is read: it ends with its writer, as standard input does.
///
/// Errors: nothing is there, or it cannot be looked at.
pub fn special(path: &Path) -> Result<Option<&'static str>> {
    let found = std::fs::metadata(path)?;
    let of_shell = ["/dev/fd", "/proc/self/fd"].iter().any(|folder| path.starts_with(folder));
    Ok(match kind(&found) {
        Some(PIPE) if of_shell || path == Path::new("/dev/stdin") => None,
        other => other,
    })
}

/// Opens a regular file.
///
/// Errors: as [`std::fs::File::open`]; what is not a regular file.
pub fn open(path: &Path) -> Result<File> {
    match kind(&std::fs::metadata(path)?) {
        None => File::open(path),
        Some(what) => Err(Error::new(ErrorKind::InvalidInput, format!("found {what}, expected a file"))),
    }
}

/// Bytes of a regular file.
///
/// Errors: as [`std::fs::read`]; what is not a regular file.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    open(path)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Text of a regular file.
///
/// Errors: as [`std::fs::read_to_string`]; what is not a regular file.
pub fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read(path)?).map_err(|e| Error::new(ErrorKind::InvalidData, e))
}

const PIPE: &str = "a named pipe";

fn kind(found: &Metadata) -> Option<&'static str> {
    match found.file_type() {
        file if file.is_file() => None,
        file if file.is_dir() => Some("a folder"),
        file => Some(device(file)),
    }
}

#[cfg(unix)]
fn device(file: FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    match file {
        file if file.is_fifo() => PIPE,
        file if file.is_socket() => "a socket",
        _ => "a device",
    }
}

#[cfg(not(unix))]
fn device(_: FileType) -> &'static str {
    "a device"
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn files_are_read_and_nothing_else_is_opened() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name);
        std::fs::write(place("a"), "text").unwrap();
        let pipe = place("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let _socket = std::os::unix::net::UnixListener::bind(place("socket")).unwrap();
        std::os::unix::fs::symlink(&pipe, place("link")).unwrap();
        for (path, what) in [
            (place("a"), None),
            (place("."), Some("a folder")),
            (pipe, Some("a named pipe")),
            (place("link"), Some("a named pipe")),
            (place("socket"), Some("a socket")),
            ("/dev/zero".into(), Some("a device")),
        ] {
            assert_eq!(special(&path).unwrap(), what, "{}", path.display());
            assert_eq!(read(&path).is_ok(), what.is_none(), "{}", path.display());
        }
        assert_eq!(read_text(&place("a")).unwrap(), "text");
        assert_eq!(special(&place("none")).unwrap_err().kind(), ErrorKind::NotFound);
    }
}
