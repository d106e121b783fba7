//! Bytes of a file, within limits, and their text.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::input::diagnostic::Fault;
use crate::input::records::MAX_BYTES;
use crate::input::stdin;
use files::code::Code;
use files::error::Error;

/// Reads the file, or standard input for `-`.
pub(crate) fn load(path: &Path) -> Result<Vec<u8>, Error> {
    let fail = |code: Code, what: String| Error::File { code, path: path.into(), what };
    if path == Path::new("-") {
        return read_limited(stdin::take()?, path);
    }
    let unreadable = |e: std::io::Error| {
        let what = format!("cannot read the record: {}", files::error::describe(&e));
        fail(Code::FileUnreadable, what)
    };
    if let Some(what) = files::special(path).map_err(unreadable)? {
        return Err(fail(
            Code::FileUnreadable,
            format!("found {what}, expected a record file (CSV, two-column text, PEER .AT2)"),
        ));
    }
    let size = std::fs::metadata(path).map_err(unreadable)?.len();
    if size > MAX_BYTES {
        return Err(fail(Code::TooLarge, too_large(size)));
    }
    read_limited(File::open(path).map_err(unreadable)?, path)
}

fn read_limited(reader: impl Read, path: &Path) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    let outcome = reader.take(MAX_BYTES + 1).read_to_end(&mut bytes);
    let (code, what) = match outcome {
        Err(e) => (Code::FileUnreadable, format!("cannot read the record: {}", files::error::describe(&e))),
        Ok(n) if n as u64 > MAX_BYTES => (Code::TooLarge, too_large(n as u64)),
        Ok(_) => return Ok(bytes),
    };
    Err(Error::File { code, path: path.into(), what })
}

fn too_large(bytes: u64) -> String {
    format!(
        "found a file of {} MB or more, expected a record of up to {} MB and {} samples; cut it to the strong motion",
        bytes >> 20,
        MAX_BYTES >> 20,
        super::MAX_SAMPLES
    )
}

/// Text of the bytes: UTF-8 with or without byte order mark, otherwise Latin-1 (only words can differ, not numbers).
///
/// # Errors
/// An empty file, UTF-16, bytes that are not text.
pub(crate) fn decode(bytes: &[u8]) -> Result<String, Fault> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Fault::new(Code::FileUnreadable, "the file is UTF-16 text")
            .allowed("UTF-8 or ASCII")
            .help("save it as UTF-8"));
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    // Tab, line feed, form feed, carriage return and the end-of-file mark of DOS (0x1a) occur in text files.
    let control = |&b: &u8| (b < 0x20 && !matches!(b, b'\t' | b'\n' | 0x0c | b'\r' | 0x1a)) || b == 0x7f;
    if let Some(at) = bytes.iter().position(control) {
        return Err(Fault::new(Code::FileUnreadable, "the file is not text")
            .found(format!("byte 0x{:02x} at position {at}", bytes[at]))
            .allowed("CSV, two-column text or PEER .AT2"));
    }
    if bytes.iter().all(|b| b.is_ascii_whitespace() || *b == 0x1a) {
        let found = if bytes.is_empty() { "0 bytes".into() } else { format!("{} bytes of white space", bytes.len()) };
        return Err(Fault::new(Code::EmptyFile, "the file is empty")
            .found(found)
            .allowed("CSV, two-column text or PEER .AT2"));
    }
    // Old Macintosh line ends and the DOS mark are replaced byte for byte, so that places stay valid.
    let plain = |text: String| {
        let text = text.replace('\u{1a}', " ");
        if text.contains('\n') { text } else { text.replace('\r', "\n") }
    };
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => plain(text.into()),
        Err(_) => plain(bytes.iter().map(|&b| char::from(b)).collect()),
    })
}

/// SHA-256, hexadecimal.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}
