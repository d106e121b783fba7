//! File or standard input → text, with its hash.

use std::io::Read;
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::input::diagnostic::Source;
use crate::input::stdin;
use files::code::Code;
use files::error::Error;

/// Largest file that is read [bytes].
pub(in crate::input) const MAX_BYTES: u64 = 1 << 20;

/// Reads the file (`-`: standard input) and returns its text without a byte-order mark, and its SHA-256.
pub(in crate::input) fn read(path: &Path) -> Result<(Source, String), Error> {
    let file = |code: Code, what: String| Error::File { code, path: path.into(), what };
    let fail = |what: String| file(Code::FileUnreadable, what);
    let mut bytes = Vec::new();
    if path == Path::new("-") {
        stdin::take()?
            .take(MAX_BYTES + 1)
            .read_to_end(&mut bytes)
            .map_err(|e| fail(format!("standard input cannot be read ({e})")))?;
    } else {
        if let Some(what) = files::special(path).map_err(|e| fail(missing(path, &e)))? {
            return Err(fail(format!("found {what}, expected a tank file such as tank.json")));
        }
        std::fs::File::open(path)
            .and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes))
            .map_err(|e| fail(format!("cannot be read ({e})")))?;
    }
    if bytes.len() as u64 > MAX_BYTES {
        return Err(file(
            Code::TooLarge,
            "found a file larger than 1 MiB, expected a tank file, JSON of a few kilobytes".into(),
        ));
    }
    let hash = Sha256::digest(&bytes);
    let sha256 = hash.iter().map(|b| format!("{b:02x}")).collect();
    Ok((Source::at(path, text(bytes).map_err(fail)?), sha256))
}

fn missing(path: &Path, error: &std::io::Error) -> String {
    if error.kind() != std::io::ErrorKind::NotFound {
        return format!("cannot be read ({error})");
    }
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        return format!("no such file (folder {} does not exist)", folder.display());
    }
    "no such file; `tankcheck init` writes one to start from".into()
}

/// The text of a UTF-8 file.
fn text(bytes: Vec<u8>) -> Result<String, String> {
    if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
        return Err("found UTF-16 text, expected UTF-8; save the file as UTF-8".into());
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text)),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            let line = error.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1;
            Err(format!(
                "line {line}, byte {}: found 0x{:02x}, expected UTF-8 text; save the file as UTF-8",
                at + 1,
                error.as_bytes()[at],
            ))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts() {
        assert_eq!(text(b"\xEF\xBB\xBF{}".to_vec()).unwrap(), "{}");
        assert!(text(b"\xFF\xFE{\0".to_vec()).unwrap_err().contains("UTF-16"));
        let error = text(b"{\n\"a\": \"\xB2\"".to_vec()).unwrap_err();
        assert!(error.contains("line 2, byte 9: found 0xb2"), "{error}");
    }

    #[test]
    fn files() {
        let folder = tempfile::tempdir().unwrap();
        let message = |name: &str| read(&folder.path().join(name)).unwrap_err().to_string();
        assert!(message("none.json").contains("no such file"));
        assert!(message("none/none.json").contains("does not exist"));
        assert!(message("").contains("folder"));
        std::fs::write(folder.path().join("big.json"), vec![b' '; MAX_BYTES as usize + 1]).unwrap();
        assert!(message("big.json").contains("larger than 1 MiB"));
        // SHA-256 of "{}" (FIPS 180-4, any other implementation).
        std::fs::write(folder.path().join("ok.json"), "{}").unwrap();
        let (source, hash) = read(&folder.path().join("ok.json")).unwrap();
        assert_eq!(source.text, "{}");
        assert_eq!(hash, "44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a");
    }
}
