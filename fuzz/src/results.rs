//! Results folders: any bytes as `results.json` (and, after a zero byte, `series.csv`) give results or a message.
//!
//! Results that are read come back from write, `diff` finds them equal to themselves, and the report renders: well-formed
//! figures, no `NaN`, no markup from the texts. `ida.json` and `push.json` are read by the same target.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use report::template::Templates;
use report::{self, Report};
use results::numdiff;
use results::{self, IDA_FILE, IDA_FORMAT, PUSH_FILE, PUSH_FORMAT};

/// Runs the target on one input.
pub fn run(bytes: &[u8]) {
    let middle = bytes.iter().position(|b| *b == 0);
    let (json, csv) = middle.map_or((bytes, &b""[..]), |at| (&bytes[..at], &bytes[at + 1..]));
    let text = String::from_utf8_lossy(json);
    if text.contains(IDA_FORMAT) {
        return ida(json);
    }
    if text.contains(PUSH_FORMAT) {
        return push(json);
    }
    let folder = Folder::new();
    folder.put(results::RESULTS_FILE, json);
    if !csv.is_empty() {
        folder.put(results::SERIES_FILE, csv);
    }
    let Some(found) = shown(results::read(&folder.0)) else { return };
    let Some(series) = shown(results::read_series(&folder.0)) else { return };
    let copies = [Folder::new(), Folder::new()];
    results::write(&copies[0].0, &found, &series).expect("results that were read can be written");
    let first = results::read(&copies[0].0).expect("written results can be read");
    let again = results::read_series(&copies[0].0).expect("written results can be read");
    results::write(&copies[1].0, &first, &again).expect("results that were read can be written");
    let second = results::read(&copies[1].0).expect("written results can be read");
    assert_eq!(first, second, "written twice, the results differ");
    let bytes = |k: usize| std::fs::read(copies[k].0.join(results::RESULTS_FILE)).expect("readable");
    assert_eq!(bytes(0), bytes(1));
    // A table without lines is not written.
    if !series.time.is_empty() || series.ids.is_empty() {
        let diff = numdiff::folders(&folder.0, &copies[0].0, &numdiff::Options::default()).expect("both can be read");
        let moved = diff.moved.first().map(|d| (&d.path, d.change));
        assert!(moved.is_none(), "moved by writing: {moved:?}");
    }
    if let Some(report) = shown(report::build(&found, &series, templates(), report::Level::Full)) {
        sound(&report);
    }
}

fn ida(json: &[u8]) {
    let folder = Folder::new();
    let path = folder.put(IDA_FILE, json);
    let Some(found) = shown(results::read_ida(&path)) else { return };
    let copy = Folder::new();
    let path = copy.0.join(IDA_FILE);
    results::write_ida(&path, &found).expect("results that were read can be written");
    results::read_ida(&path).expect("written results can be read");
    results::ida_csv(&found);
    if let Some(report) = shown(report::ida::report(&found)) {
        sound(&report);
    }
}

fn push(json: &[u8]) {
    let folder = Folder::new();
    let path = folder.put(PUSH_FILE, json);
    let Some(found) = shown(results::read_push(&path)) else { return };
    let copy = Folder::new();
    let path = copy.0.join(PUSH_FILE);
    results::write_push(&path, &found).expect("results that were read can be written");
    results::read_push(&path).expect("written results can be read");
    if let Some(report) = shown(report::push::report(&found)) {
        sound(&report);
    }
}

/// The value, or `None` with a message.
fn shown<T>(outcome: Result<T, files::error::Error>) -> Option<T> {
    match outcome {
        Ok(value) => Some(value),
        Err(error) => {
            assert!(!error.to_string().trim().is_empty(), "a failure without a message");
            None
        }
    }
}

/// The built-in templates, read once.
pub fn templates() -> &'static Templates {
    static TEMPLATES: OnceLock<Templates> = OnceLock::new();
    TEMPLATES.get_or_init(|| Templates::new(None).expect("the built-in templates are sound"))
}

/// Figures that parse and hold numbers; no script, whatever the texts are.
pub fn sound(report: &Report) {
    assert!(!report.html.contains("<script"), "markup from a text");
    for (name, svg) in &report.figures {
        let document = roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{name}: {e}"));
        for node in document.descendants().filter(roxmltree::Node::is_element) {
            for attribute in node.attributes() {
                let (key, value) = (attribute.name(), attribute.value());
                let place = [
                    "d",
                    "points",
                    "transform",
                    "x",
                    "y",
                    "x1",
                    "x2",
                    "y1",
                    "y2",
                    "cx",
                    "cy",
                    "r",
                    "width",
                    "height",
                    "viewBox",
                ];
                let number = !value.contains("NaN") && !value.contains("inf");
                assert!(!place.contains(&key) || number, "{name}: {key}=\"{value}\"");
            }
        }
    }
}

/// A temporary folder, removed at the end.
pub struct Folder(pub PathBuf);

impl Folder {
    /// An empty folder.
    pub fn new() -> Folder {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let name = format!("tankcheck-fuzz-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let path = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&path).expect("the temporary folder is writable");
        Folder(path)
    }

    /// Writes a file.
    pub fn put(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(Path::new(name));
        std::fs::write(&path, bytes).expect("the temporary folder is writable");
        path
    }
}

impl Default for Folder {
    fn default() -> Self {
        Folder::new()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A file left in a temporary folder is not a failure.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
