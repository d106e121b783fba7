//! Printing a page through an installed browser, without a trace: profile and page are in a temporary folder.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use super::pdf;
use crate::cli::terminal::say;
use crate::error::Error;
use files::code::Code;
use files::text::line;
use report::contents;

/// Variable that names the browser.
pub(crate) const VARIABLE: &str = "CHROME";
/// Programs that print, as they are called.
const PROGRAMS: [&str; 7] =
    ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome", "chrome", "microsoft-edge", "msedge"];
/// Where they are when no path leads to them.
const PLACES: [&str; 3] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
];
/// Longest time of one printing.
const PATIENCE: Duration = Duration::from_secs(300);

/// A number as wide as most are, in the first printing.
const USUAL: usize = 88;
/// Most printings with numbers: a wider one may move a page, once.
const PRINTINGS: usize = 4;

/// How long a browser may take to end after it has printed.
const FAREWELL: Duration = Duration::from_secs(5);

/// The browser: that of `CHROME`, or the first one installed.
///
/// Errors: `CHROME` names a program that does not start; none is installed.
pub(crate) fn find() -> Result<PathBuf, Error> {
    if let Some(named) = std::env::var_os(VARIABLE).filter(|name| !name.is_empty()) {
        let named = PathBuf::from(named);
        return match starts(&named) {
            true => Ok(named),
            false => Err(Error::input(
                Code::ProgramMissing,
                format!(
                    "{VARIABLE}: found `{}`, expected a Chromium that starts\n  help: give its whole path, or unset {VARIABLE} to use \
                     an installed one",
                    line(&named.to_string_lossy())
                ),
            )),
        };
    }
    let known = PROGRAMS.iter().chain(&PLACES).map(PathBuf::from);
    known.into_iter().find(|program| starts(program)).ok_or_else(|| {
        Error::input(
            Code::ProgramMissing,
            format!(
                "--pdf: no Chromium is installed, which prints the report\n  help: install one (Debian: `apt install chromium`; Fedora: \
                 `dnf install chromium`; macOS: `brew install --cask chromium`; Windows: Edge or Chrome), name it with {VARIABLE}=PATH, or \
                 open report.html in any browser and print it"
            ),
        )
    })
}

/// Whether a program is installed.
fn starts(program: &Path) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Prints a page with page numbers in its contents; returns the PDF.
///
/// A first printing shows the pages, the next ones have their numbers, until these are those of their own pages.
///
/// Errors: as [`print_once`].
pub(crate) fn print(program: &Path, html: &str) -> Result<Vec<u8>, Error> {
    let Some(mut page) = contents::numbered(html, |_| Some(USUAL)) else { return print_once(program, html) };
    let mut numbers: Option<BTreeMap<String, usize>> = None;
    for _ in 0..PRINTINGS {
        let printed = print_once(program, &page)?;
        let Some(found) = pdf::pages(&printed) else { break };
        if numbers.as_ref() == Some(&found) {
            return Ok(printed);
        }
        page = contents::numbered(html, |id| found.get(id).copied()).unwrap_or_default();
        numbers = Some(found);
    }
    say!("note: the contents have no page numbers: where this browser put its pages was not found");
    print_once(program, html)
}

/// Prints a page as it is; returns the PDF.
///
/// Errors: a temporary folder that cannot be made; a browser that fails, ends without a PDF or takes more than five minutes.
fn print_once(program: &Path, html: &str) -> Result<Vec<u8>, Error> {
    let folder = tempfile::Builder::new()
        .prefix("tankcheck-")
        .tempdir()
        .map_err(|e| Error::report(format!("no temporary folder for the browser: {e}")))?;
    let (page, pdf) = (folder.path().join("report.html"), folder.path().join("report.pdf"));
    let missing = |e: std::io::Error| Error::report(format!("{}: {e}", page.display()));
    std::fs::write(&page, html).map_err(missing)?;
    let mut ended = run(program, folder.path(), &page, &pdf, false)?;
    // Within a container, or as root, browsers refuse their own sandbox; the page has no script and loads nothing.
    if !ended.0.success() && ended.1.to_lowercase().contains("sandbox") {
        ended = run(program, folder.path(), &page, &pdf, true)?;
    }
    let (status, said) = ended;
    let bytes = std::fs::read(&pdf).unwrap_or_default();
    if complete(&bytes) {
        return Ok(bytes);
    }
    let last = said.lines().rfind(|l| !l.trim().is_empty()).unwrap_or("it said nothing");
    Err(Error::report(format!("{} printed no PDF ({status}): {}", line(&program.to_string_lossy()), line(last))))
}

/// Whether a file is a whole PDF.
fn complete(bytes: &[u8]) -> bool {
    let end = &bytes[bytes.len().saturating_sub(16)..];
    bytes.starts_with(b"%PDF") && end.windows(5).any(|part| part == b"%%EOF")
}

/// Runs the browser; returns how it ended and what it said.
fn run(program: &Path, folder: &Path, page: &Path, pdf: &Path, bare: bool) -> Result<(ExitStatus, String), Error> {
    let said = folder.join("messages");
    let failed = |e: std::io::Error| Error::report(format!("{}: {e}", line(&program.to_string_lossy())));
    let mut command = Command::new(program);
    command.args([
        "--headless",
        "--disable-gpu",
        "--disable-quic",
        "--disable-sync",
        "--disable-extensions",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-breakpad",
        "--no-first-run",
        "--no-default-browser-check",
        "--no-pdf-header-footer",
        "--generate-pdf-document-outline",
    ]);
    if bare {
        command.arg("--no-sandbox");
    }
    command
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("--print-to-pdf={}", pdf.display()))
        .arg(address(page))
        .env("XDG_CONFIG_HOME", folder)
        .env("XDG_CACHE_HOME", folder)
        .env("TMPDIR", folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(std::fs::File::create(&said).map_err(failed)?);
    let mut child = command.spawn().map_err(failed)?;
    let started = Instant::now();
    let mut printed: Option<Instant> = None;
    let status = loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            break status;
        }
        // Some browsers do not end although they have printed.
        if printed.is_none() && std::fs::read(pdf).is_ok_and(|bytes| complete(&bytes)) {
            printed = Some(Instant::now());
        }
        if printed.is_some_and(|since| since.elapsed() > FAREWELL) {
            let _ = child.kill();
            break child.wait().map_err(failed)?;
        }
        if started.elapsed() > PATIENCE {
            // It may have ended meanwhile.
            let _ = child.kill();
            let _ = child.wait();
            return Err(Error::report(format!(
                "{} has not printed within {} s and was stopped",
                line(&program.to_string_lossy()),
                PATIENCE.as_secs()
            )));
        }
        std::thread::sleep(Duration::from_millis(50));
    };
    let said = std::fs::read(&said).unwrap_or_default();
    Ok((status, String::from_utf8_lossy(&said).into_owned()))
}

/// A path as an address: everything but letters, digits and a few signs as its bytes.
fn address(path: &Path) -> String {
    let text = path.to_string_lossy().replace('\\', "/");
    let mut out = String::from(if text.starts_with('/') { "file://" } else { "file:///" });
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'-' | b'_' | b'.' | b':' => out.push(char::from(byte)),
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_addresses() {
        assert_eq!(address(Path::new("/a b/ü#.html")), "file:///a%20b/%C3%BC%23.html");
        assert_eq!(address(Path::new("C:\\a\\b.html")), "file:///C:/a/b.html");
    }
}
