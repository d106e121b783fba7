//! The desk in a real browser, as an engineer uses it: enter, check, record, run, look, compare; by keyboard; narrow and wide, light and dark, English
//! and German.
//!
//! Goal:     what the page shows is what the program computes, and nothing that is typed is lost
//! Expected: the tank that was typed is example 05; the verdicts are those of the command line; see each test
//!
//! `TANKCHECK_LOOK=folder` keeps the pictures.

mod browser;

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use browser::Browser;
use serde_json::{Value, json};

/// A desk of a folder of its own.
struct Desk {
    program: Child,
    folder: tempfile::TempDir,
    address: String,
}

impl Desk {
    /// * `files`: of the repository, each with its name in the folder
    fn open(files: &[(&str, &str)]) -> Desk {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for (from, to) in files {
            fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join(from), folder.path().join(to)).expect("copied");
        }
        let mut program = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(["desk", "--no-browser"])
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("tankcheck runs");
        let mut line = String::new();
        BufReader::new(program.stdout.take().expect("piped")).read_line(&mut line).expect("an address");
        let address = line.trim().strip_prefix("desk: ").expect("an address").to_owned();
        Desk { program, folder, address }
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join(name)).expect("saved")
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

/// The element of a selector.
fn one(selector: &str) -> String {
    format!("document.querySelector({})", json!(selector))
}

/// The control of a value of the form.
fn control(path: &str) -> String {
    one(&format!("[data-path={}]", json!(path)))
}

/// A button with a text.
fn button(text: &str) -> String {
    format!(
        "[...document.querySelectorAll('button')].find(b => b.offsetParent && b.textContent.trim() === {})",
        json!(text)
    )
}

/// Waits for the verdict of the last change.
fn verdict(page: &mut Browser, status: &str) {
    page.wait(&format!("{}?.dataset.status === {}", one(".check-verdict"), json!(status)));
}

/// Types a value where it belongs; folds are opened and parts added as an engineer would.
fn enter(page: &mut Browser, path: &str, value: &Value) {
    reveal(page, path);
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let select = page.value(&format!("{}.tagName", control(path))) == json!("SELECT");
    page.value(&format!("{}.focus()", control(path)));
    if select {
        let chosen = format!(
            "(() => {{ const e = {}; e.value = {}; e.dispatchEvent(new Event('change', {{ bubbles: true }})) }})()",
            control(path),
            json!(text)
        );
        page.value(&chosen);
    } else {
        page.value(&format!("{}.select?.()", control(path)));
        page.types(&text);
        page.key("Tab", 0);
    }
}

/// Opens the folds and presses the offers on the way to a value, where it is not shown yet.
fn reveal(page: &mut Browser, path: &str) {
    for _ in 0..12 {
        if page.value(&format!("!!{}", control(path))) == json!(true) {
            return;
        }
        let script = format!("window.reveal?.({path}) ?? (window.reveal = {REVEAL})({path})", path = json!(path));
        page.value(&script);
        std::thread::sleep(std::time::Duration::from_millis(60));
    }
    page.wait(&control(path));
}

/// Folds are opened; the outermost part of the path that is missing is described or added.
const REVEAL: &str = r#"async (path) => {
    for (const fold of document.querySelectorAll('.tank-form details:not([open])')) fold.open = true;
    await new Promise(done => setTimeout(done, 30));
    const ends = [...path.matchAll(/[.[]/g)].map(m => m.index).filter(Boolean);
    for (const end of ends) {
        const part = document.querySelector(`[data-path=${CSS.escape(path.slice(0, end))}]`);
        if (part?.tagName === 'BUTTON') { part.click(); return true; }
        if (part?.tagName === 'SELECT' && part.value !== '+' && [...part.options].some(o => o.value === '+')) {
            part.value = '+';
            part.dispatchEvent(new Event('change', { bubbles: true }));
            return true;
        }
    }
    return false;
}"#;

/// The leaves of a value with their paths.
fn leaves(path: &str, value: &Value, found: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(members) => {
            for (key, value) in members {
                let plain = key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
                let inner = match (path, plain) {
                    ("", _) => key.clone(),
                    (_, true) => format!("{path}.{key}"),
                    (_, false) => format!("{path}[{}]", json!(key)),
                };
                leaves(&inner, value, found);
            }
        }
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(i, item)| leaves(&format!("{path}[{i}]"), item, found))
        }
        value => found.push((path.to_owned(), value.clone())),
    }
}

/// Example 05 is typed into an empty form; the text that is saved is that tank, and the verdict is that of the command line.
pub(crate) fn a_tank_is_entered_from_an_empty_form(chromium: &Path) {
    let desk = Desk::open(&[]);
    let mut page = Browser::start(chromium);
    page.look(1920, 1080, false);
    page.open(&desk.address);
    page.click(&button("Empty form"));
    page.wait(&control("name"));
    let example =
        fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/05_oil_tank/tank.json")).expect("read");
    let mut example: Value = serde_json::from_str(&example).expect("JSON");
    example["notes"] = json!("typed");
    let mut values = Vec::new();
    leaves("", &example, &mut values);
    assert!(values.len() > 60);
    // A material is named before a course can be of it.
    page.value(&format!("(() => {{ const i = {}; i.focus() }})()", one(".field-adding input")));
    page.types("A 283 C");
    page.key("Enter", 0);
    // The form has looked its grade up; example 05 states its values.
    page.wait(&control("materials[\"A 283 C\"].grade"));
    page.value(&format!("{0}.focus(), {0}.select()", control("materials[\"A 283 C\"].grade")));
    page.key("Backspace", 0);
    page.key("Enter", 0);
    for (path, value) in &values {
        enter(&mut page, path, value);
    }
    verdict(&mut page, "fails");
    page.picture("desk-05");
    page.value("document.activeElement.blur()");
    page.key("s", 2);
    page.wait("document.querySelector('dialog[open] input')");
    page.key("Enter", 0);
    page.wait("!document.querySelector('dialog[open]')");
    page.wait(&format!("{}.disabled", button("Save")));
    let saved: Value = serde_json::from_str(&desk.text("tank.json")).expect("JSON");
    let mut typed = Vec::new();
    leaves("", &saved, &mut typed);
    // 6 and 6.0 are one number.
    let same = |a: &Value, b: &Value| a == b || a.is_number() && a.as_f64() == b.as_f64();
    let others = |of: &[(String, Value)], all: &[(String, Value)]| -> Vec<String> {
        let known =
            |(path, value): &&(String, Value)| all.iter().any(|(other, there)| path == other && same(value, there));
        of.iter().filter(|leaf| !known(leaf)).map(|(path, value)| format!("{path}: {value}")).collect()
    };
    let lost = (others(&values, &typed), others(&typed, &values));
    assert!(lost.0.is_empty() && lost.1.is_empty(), "not in the file: {:?}; only there: {:?}", lost.0, lost.1);
    assert!(page.faults.is_empty(), "{:?}", page.faults);
}

/// A value is changed, the verdict follows; undo and redo; the file keeps its comments; another window's edit is asked about.
pub(crate) fn the_verdict_follows_what_is_typed(chromium: &Path) {
    let desk = Desk::open(&[("examples/12_water_tank/tank.json", "tank.json")]);
    let path = desk.folder.path().join("tank.json");
    let before = format!("// As built.\n{}", desk.text("tank.json"));
    fs::write(&path, &before).expect("writable");
    let mut page = Browser::start(chromium);
    page.look(1920, 1080, false);
    page.open(&format!("{}#tank/tank.json", desk.address));
    verdict(&mut page, "holds");
    let thickness = "tank.courses[0].thickness";
    // By keyboard: the field has the focus, the value is replaced, the verdict fails.
    page.value(&format!("{}.focus()", control(thickness)));
    page.value(&format!("{}.select()", control(thickness)));
    page.types("2 mm");
    let waited = page.wait(&format!("{}.dataset.status === 'fails'", one(".check-verdict")));
    println!("keystroke to a new verdict: {waited:?}");
    page.key("Enter", 0);
    // The sheet of the worst check has its numbers.
    page.click(&one(
        ".check-row[data-status=fails] button, button.check-row[data-status=fails], [data-status=fails].check-row",
    ));
    page.wait("document.querySelector('.tank-with-sheet math, .tank-sheet math')");
    page.picture("desk-sheet");
    page.key("Escape", 0);
    page.value("document.activeElement.blur()");
    page.key("z", 2);
    verdict(&mut page, "holds");
    page.key("Z", 10);
    verdict(&mut page, "fails");
    // A fault stands at its field with the words of the terminal.
    page.value(&format!("{}.focus(), {}.select()", control("liquid.fill_height"), control("liquid.fill_height")));
    page.types("85 m");
    page.key("Enter", 0);
    page.wait(&format!(
        "{}.closest('.field-row').querySelector('.field-faults:not([hidden])').innerText.length > 10",
        control("liquid.fill_height")
    ));
    page.value("document.activeElement.blur()");
    page.key("z", 2);
    page.key("s", 2);
    page.wait(&format!("{}.disabled", button("Save")));
    assert_eq!(desk.text("tank.json"), before.replacen("\"9 mm\"", "\"2 mm\"", 1));
    // Another window has saved meanwhile.
    fs::write(&path, "{ \"name\": \"theirs\" }\n").expect("writable");
    page.value(&format!("{}.focus(), {}.select()", control(thickness), control(thickness)));
    page.types("3 mm");
    page.key("Enter", 0);
    page.key("s", 2);
    page.wait("document.querySelector('dialog[open]')");
    assert_eq!(desk.text("tank.json"), "{ \"name\": \"theirs\" }\n");
    assert!(page.faults.iter().all(|fault| fault.contains("409")), "{:?}", page.faults);
}

/// A record is dropped, a run started with it, its scene played, another cancelled, two results compared.
pub(crate) fn a_record_is_dropped_run_and_looked_at(chromium: &Path) {
    let desk = Desk::open(&[
        ("examples/01_broad_tank/tank.json", "tank.json"),
        ("examples/12_water_tank/tank.json", "other.json"),
    ]);
    let mut page = Browser::start(chromium);
    page.look(1920, 1080, false);
    page.open(&format!("{}#tank/tank.json", desk.address));
    verdict(&mut page, "accepted");
    page.key("2", 1);
    page.wait(&one(".rec-drop"));
    let record = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/records/elcentro.csv");
    page.drop_file(&one(".rec-drop"), &record);
    page.click(&button("Use with this tank"));
    assert_eq!(fs::read(desk.folder.path().join("elcentro.csv")).expect("kept"), fs::read(&record).expect("read"));
    page.wait("document.querySelector('.rec-detail canvas')");
    page.picture("desk-record");
    page.key("3", 1);
    page.click(&one(".runs button.primary, #room-runs button.primary"));
    page.wait("document.querySelector('.run[data-state=done]')");
    let results: Value = serde_json::from_str(&desk.text("out/results.json")).expect("JSON");
    page.click("[...document.querySelectorAll('.run[data-state=done] button')].find(b => b.textContent === 'Look')");
    page.wait(&format!("document.body.innerText.includes({})", results["name"]));
    page.click("[...document.querySelectorAll('[role=tab]')].find(b => b.textContent === 'Scene')");
    page.wait("document.querySelector('#room-look canvas')");
    std::thread::sleep(std::time::Duration::from_millis(500));
    let still = page.picture("desk-scene");
    page.click(&button("Play"));
    std::thread::sleep(std::time::Duration::from_millis(1500));
    let moved = page.picture("desk-scene-later");
    assert!(still != moved, "the scene stands still");
    // A run that would last is cancelled.
    page.key("3", 1);
    page.click(&one("[data-option=kind-push]"));
    page.value(&format!(
        "(() => {{ const e = {}; e.value = 'other.json'; e.dispatchEvent(new Event('input', {{ bubbles: true }})) }})()",
        one("#room-runs [data-option=tank]")
    ));
    page.click(&one("#room-runs form button.primary"));
    page.wait("document.querySelector('.run[data-state=running]')");
    page.click(
        "[...document.querySelectorAll('.run[data-state=running] button')].find(b => b.textContent === 'Cancel')",
    );
    page.wait("document.querySelector('.run[data-state=cancelled]')");
    assert!(!desk.folder.path().join("push/push.json").exists());
    // The same tank on the spectrum of the site alone, beside the first.
    page.click(&one("[data-option=kind-compare]"));
    page.value(&format!(
        "(() => {{ const e = {}; e.value = ''; e.dispatchEvent(new Event('input', {{ bubbles: true }})) }})()",
        one("#room-runs [data-option=along]")
    ));
    page.click(&one("#room-runs form button.primary"));
    page.wait("document.querySelectorAll('.run[data-state=done]').length === 2");
    page.open(&format!("{}#look/out", desk.address));
    let beside = "[...document.querySelectorAll('#room-look label')].find(l => l.textContent.includes('Compare with')).querySelector('select')";
    page.wait(&format!("{beside}.options.length > 1"));
    page.value(&format!(
        "(() => {{ const e = {beside}; e.value = e.options[1].value; \
         e.dispatchEvent(new Event('input', {{ bubbles: true }})); e.dispatchEvent(new Event('change', {{ bubbles: true }})) }})()"
    ));
    page.wait("document.querySelectorAll('.look-table tbody tr').length > 5");
    page.picture("desk-two");
    assert!(page.faults.is_empty(), "{:?}", page.faults);
}

/// The checks are three keys away, and one stop; a table says where columns stand; a record is renamed with the set that names it, and another removed.
pub(crate) fn records_are_kept_by_keyboard(chromium: &Path) {
    let files = [("examples/12_water_tank/tank.json", "tank.json"), ("examples/records/elcentro.csv", "elcentro.csv")];
    let desk = Desk::open(&files);
    let write = |name: &str, text: &str| fs::write(desk.folder.path().join(name), text).expect("writable");
    let rows: String =
        (0..50).map(|i| format!("{} 7 {}\n", 0.01 * f64::from(i), (f64::from(i) * 0.7).sin() * 0.1)).collect();
    write("columns.txt", &rows);
    write("set.json", "{ \"records\": [{ \"along\": \"elcentro.csv\" }] }\n");
    let mut page = Browser::start(chromium);
    page.look(1300, 1000, false);
    page.open(&format!("{}#tank/tank.json", desk.address));
    verdict(&mut page, "holds");
    // From the top: bar, form, checks; then down the list, and out of it by one Tab.
    page.value(&format!("{}.focus()", one("#file")));
    (0..3).for_each(|_| page.key("F6", 0));
    page.wait("document.activeElement.closest('#tank-side')");
    page.value(&format!("{}.focus()", one(".check-list [tabindex='0']")));
    page.key("ArrowDown", 0);
    page.key("ArrowDown", 0);
    page.wait("document.activeElement.matches('.check-row')");
    let stops = "[...document.querySelectorAll('.check-row, .check-method')].filter(e => e.tabIndex === 0).length";
    assert_eq!(page.value(stops), json!(1));
    page.key("Tab", 0);
    assert_eq!(page.value("document.activeElement.matches('.check-row, .check-method')"), json!(false));
    page.key("F6", 8);
    page.wait("document.activeElement.closest('.tank-data')");
    // Three columns without a head: the reader asks which they are.
    page.key("2", 1);
    page.click("[...document.querySelectorAll('.rec-items button')].find(b => b.title === 'columns.txt')");
    page.wait(&one(".rec-form [name=columns]"));
    page.value(&format!("{}.focus()", one(".rec-form [name=columns]")));
    page.types("1,3");
    page.value(&format!("{}.value = 'g'", one(".rec-form [name=units]")));
    page.key("Enter", 0);
    page.wait(&format!("{}?.innerText.includes('0.0996 g')", one(".rec-detail dl.facts")));
    // Renamed, with the set.
    page.click("[...document.querySelectorAll('.rec-items button')].find(b => b.title === 'elcentro.csv')");
    page.wait("document.querySelector('.rec-detail h1')?.textContent === 'elcentro.csv'");
    // The buttons move down while the file is read.
    page.wait(&format!("{}?.innerText.includes('3.13 m/s²')", one(".rec-detail dl.facts")));
    page.value(&format!("{}.click()", button("Rename")));
    page.wait("document.activeElement.selectionEnd === 8");
    page.types("far/imperial valley");
    page.key("Enter", 0);
    page.click(&button("Rename, and change them"));
    page.wait("document.querySelector('.rec-detail h1')?.textContent.startsWith('far/imperial') || document.querySelector('.rec-detail .hint')?.textContent.startsWith('far/')");
    assert!(!desk.folder.path().join("elcentro.csv").exists());
    assert_eq!(desk.text("set.json"), "{ \"records\": [{ \"along\": \"far/imperial valley.csv\" }] }\n");
    // Removed: what names it is asked about, and no other file goes.
    page.wait(&format!("{}?.innerText.includes('3.13 m/s²')", one(".rec-detail dl.facts")));
    page.value(&format!("{}.click()", button("Remove")));
    page.click("document.querySelector('dialog[open] button.danger')");
    page.wait("document.querySelector('dialog[open]')?.innerText.includes('set.json')");
    page.click(&button("Cancel"));
    assert!(desk.folder.path().join("far/imperial valley.csv").exists());
    page.click("[...document.querySelectorAll('.rec-items button')].find(b => b.title === 'columns.txt')");
    page.wait("document.querySelector('.rec-detail h1')?.textContent === 'columns.txt'");
    page.value(&format!("{}.click()", button("Remove")));
    page.click("document.querySelector('dialog[open] button.danger')");
    page.wait("![...document.querySelectorAll('.rec-items button')].some(b => b.title === 'columns.txt')");
    assert!(!desk.folder.path().join("columns.txt").exists());
    assert!(page.faults.iter().all(|fault| fault.contains("409") || fault.contains("422")), "{:?}", page.faults);
}

/// Nothing is cut off or left without words: every room at 390 and 1920 pixels, light and dark, in English and German.
pub(crate) fn every_room_fits_in_both_languages(chromium: &Path) {
    let files = [
        ("examples/05_oil_tank/tank.json", "tank.json"),
        ("examples/records/elcentro.csv", "elcentro.csv"),
        ("examples/05_oil_tank/set.json", "set.json"),
    ];
    let desk = Desk::open(&files);
    let run = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["compare", "tank.json", "--quake", "elcentro.csv", "--out", "out", "-q"])
        .current_dir(desk.folder.path())
        .output()
        .expect("tankcheck runs");
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", String::from_utf8_lossy(&run.stderr));
    let mut page = Browser::start(chromium);
    let rooms = ["tank/tank.json", "records/elcentro.csv", "runs", "look/out"];
    for (language, dark) in [("en", false), ("de", true)] {
        page.look(1920, 1080, dark);
        page.open(&desk.address);
        page.wait(&one("#settings select"));
        page.value(&format!(
            "(() => {{ const e = document.querySelector('#settings select'); e.value = '{language}'; e.dispatchEvent(new Event('change', {{ bubbles: true }})) }})()"
        ));
        for width in [1920, 390] {
            page.look(width, 1000, dark);
            for room in rooms {
                page.open("about:blank");
                page.open(&format!("{}#{room}", desk.address));
                page.wait("document.querySelector('.room:not([hidden])')?.innerText.length > 40");
                std::thread::sleep(std::time::Duration::from_millis(700));
                page.picture(&format!("desk-{language}-{width}-{}", room.split('/').next().unwrap_or_default()));
                let over = page.value("document.documentElement.scrollWidth - innerWidth");
                assert!(over.as_f64().is_some_and(|over| over < 1.0), "{room} at {width}: {over} too wide");
                // A text that is missing shows its id.
                let ids = page.value("[...document.body.innerText.matchAll(/\\b(tank|form|doc|rec|set|run|look|scene|check)-[a-z]+(-[a-z]+)*\\b/g)].map(m => m[0]).filter(m => !/\\.(json|csv)/.test(m))");
                assert_eq!(ids, json!([]), "{room} in {language}");
                let words = page.value("document.documentElement.lang");
                assert_eq!(words, json!(language));
            }
        }
    }
    help_and_faults_are_german(&mut page, &desk);
    assert!(page.faults.is_empty(), "{:?}", page.faults);
}

/// The German page explains a key and names a fault in German; nothing of its form is marked as English. The page is left as it was.
fn help_and_faults_are_german(page: &mut Browser, desk: &Desk) {
    page.look(1920, 1000, false);
    page.open("about:blank");
    page.open(&format!("{}#tank/tank.json", desk.address));
    let radius = control("tank.radius");
    page.wait(&radius);
    page.click(&format!("{radius}.closest('.field-row').querySelector('.field-ask')"));
    let help = format!("{radius}.closest('.field-row').querySelector('.field-help:not([hidden])')?.innerText ?? ''");
    page.wait(&help);
    let help = page.value(&help);
    let starts = "Innenradius eines Zylinders, der ihn benötigt. Mindestens 1 mm, höchstens 1000 m.";
    assert!(help.as_str().is_some_and(|text| text.starts_with(starts)), "{help}");
    page.value(&format!("{radius}.focus(), {radius}.select()"));
    page.types("2 kg");
    page.key("Enter", 0);
    let fault = format!("{radius}.closest('.field-row').querySelector('.field-faults:not([hidden])')?.innerText ?? ''");
    page.wait(&fault);
    let fault = page.value(&fault);
    for part in [
        "die Einheit kg steht für: eine Masse; erwartet ist eine Länge",
        "erwartet: eine Länge wie \"1.83 m\" (Einheiten:",
    ] {
        assert!(fault.as_str().is_some_and(|text| text.contains(part)), "{fault}");
    }
    page.picture("desk-german-help");
    let marked = page.value("[...document.querySelectorAll('.room:not([hidden]) [lang=en]')].map(e => e.textContent)");
    assert_eq!(marked, json!([]));
    page.value("document.activeElement.blur()");
    page.key("z", 2);
    page.wait(&format!("!{radius}.closest('.field-row').querySelector('.field-faults:not([hidden])')"));
}
