//! The report in a browser: headless Chromium prints it and measures it.
//!
//! Goal:     a plausible number of pages, no heading at a page's end, no text cut off on screen, phone and paper
//! Model:    the sample of `sample.rs`, `compare` and `check`
//! Expected: see each test

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::sample::{self, Kind};

/// Points of a millimetre.
const MM: f64 = 72.0 / 25.4;

/// Runs Chromium on a page; returns its standard output.
fn browse(program: &Path, profile: &Path, page: &Path, args: &[&str]) -> String {
    let output = Command::new(program)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-quic",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
        ])
        .arg(format!("--user-data-dir={}", profile.display()))
        .args(args)
        .arg(format!("file://{}", page.display()))
        .stderr(Stdio::null())
        .output()
        .expect("Chromium starts");
    assert!(output.status.success(), "Chromium fails on {}", page.display());
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn rendered(folder: &Path, kind: Kind, level: report::Level) -> PathBuf {
    sample::write(folder, kind, "Broad tank of Manos and Clough, 1982");
    report::render(folder, None, level).expect("the sample renders")
}

/// Every kind of page: verifications in full, which have the sections of every other level, and one at the standard level; an incremental
/// analysis, a pushover, a study.
fn kinds(folder: &Path) -> Vec<(String, String)> {
    let mut pages = Vec::new();
    for (kind, level) in [
        (Kind::Compare, report::Level::Standard),
        (Kind::Compare, report::Level::Full),
        (Kind::Check, report::Level::Full),
        (Kind::Rectangle, report::Level::Full),
        (Kind::Nonlinear, report::Level::Full),
    ] {
        let page = std::fs::read_to_string(rendered(folder, kind, level)).expect("readable");
        pages.push((format!("{kind:?} {level:?}"), page));
    }
    let kept = Path::new(env!("CARGO_MANIFEST_DIR"));
    let ida = results::read_ida(&kept.join("reports/06_sandwich_strip/ida/ida.json")).expect("kept results");
    pages.push(("ida".into(), report::ida::report(&ida).expect("a page").html));
    let mut push = results::read_push(&kept.join("reports/07_steel_cylinder/push/push.json")).expect("kept results");
    push.tank = Some(sample::sample(Kind::Compare, "Broad tank").0.tank);
    pages.push(("push".into(), report::push::report(&push).expect("a page").html));
    pages.push(("study".into(), crate::study::page()));
    pages
}

pub(crate) fn it_prints_to_clean_pages(program: &Path) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (kind, pages) in [(Kind::Compare, 15..=40), (Kind::Check, 5..=20), (Kind::Nonlinear, 15..=60)] {
        let report = rendered(folder.path(), kind, report::Level::Full);
        let pdf = folder.path().join("report.pdf");
        let to = format!("--print-to-pdf={}", pdf.display());
        let args = ["--no-pdf-header-footer", "--generate-pdf-document-outline", &to];
        browse(program, &folder.path().join("profile"), &report, &args);
        let bytes = std::fs::read(&pdf).expect("the PDF exists");
        let text = String::from_utf8_lossy(&bytes);

        let boxes: Vec<&str> = text.split("/MediaBox [").skip(1).filter_map(|r| r.split(']').next()).collect();
        assert!(pages.contains(&boxes.len()), "{kind:?}: {} pages", boxes.len());
        for media in boxes {
            let sides: Vec<f64> = media.split_whitespace().filter_map(|n| n.parse().ok()).collect();
            assert!((sides[2] - 210.0 * MM).abs() < 1.0 && (sides[3] - 297.0 * MM).abs() < 1.0, "{media}");
        }
        // The outline holds every heading with its page and height. Below each there is room for text: the margin of 11 mm
        // and at least 10 mm, 20 mm for the numbered headings of sections.
        let mut headings = 0;
        for item in text.split("<</Title ").skip(1) {
            let item = item.split("endobj").next().unwrap_or("");
            let Some(place) = item.split("/XYZ ").nth(1) else { continue };
            let height: f64 =
                place.split_whitespace().nth(1).and_then(|n| n.parse().ok()).expect("a destination has a height");
            headings += 1;
            let title = item.split("/Dest").next().unwrap_or("");
            let numbered = title.trim_start().trim_start_matches('(').starts_with(|c: char| c.is_ascii_digit());
            let least = if numbered { 31.0 } else { 21.0 };
            assert!(height > least * MM, "{kind:?}: heading {title} at {height} pt");
        }
        assert!(headings > 10, "{headings} headings");
    }
}

/// Measures the report in frames of several widths and on paper; collects clipped content.
const MEASURE: &str = r##"
<script>
const faults = [];
function measure(frame) {
  const page = frame.contentDocument, name = frame.id, root = page.documentElement;
  const say = (what, node) => faults.push(name + ": " + what + ": " + (node.textContent || node.tagName).trim().slice(0, 60));
  if (root.scrollWidth > root.clientWidth) say("page scrolls sideways by " + (root.scrollWidth - root.clientWidth), root);
  const paper = name === "paper";
  const scrolls = node => !paper && node.closest(".scroll, .canvas, .calc");
  const width = root.clientWidth;
  for (const svg of page.querySelectorAll("svg.fig")) {
    const box = svg.getBoundingClientRect();
    if (!box.width) continue;
    for (const text of svg.querySelectorAll("text")) {
      const t = text.getBoundingClientRect();
      if (t.left < box.left - 1 || t.right > box.right + 1 || t.top < box.top - 1 || t.bottom > box.bottom + 1)
        say("text outside its figure " + svg.querySelector("title").textContent, text);
    }
    // Texts over each other by more than two units and about half a line.
    const unit = box.width / svg.viewBox.baseVal.width;
    const texts = [...svg.querySelectorAll("text")].filter(t => t.textContent.trim()).map(t => [t, t.getBoundingClientRect()]);
    for (let i = 0; i < texts.length; i++) for (let j = 0; j < i; j++) {
      const a = texts[i][1], b = texts[j][1];
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left), height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (width > 2 * unit && height > .45 * Math.min(a.height, b.height))
        say("texts overlap in " + svg.querySelector("title").textContent + ": " + texts[j][0].textContent.trim().slice(0, 30) + " / ", texts[i][0]);
    }
  }
  for (const cell of page.querySelectorAll("td, th, dd, p, h1, h2, h3, summary, math")) {
    const c = cell.getBoundingClientRect();
    if (!c.width || cell.closest("details:not([open])")) continue;
    if (c.right > width + 1 && !scrolls(cell)) say("text beyond the right edge", cell);
    if (cell.tagName === "math") {
      const column = cell.closest("td, .line, li, p, summary, h4");
      if (column && c.right > column.getBoundingClientRect().right + 1 && name !== "phone") say("formula wider than its column", cell);
    }
  }
}
addEventListener("load", () => {
  document.querySelectorAll("iframe").forEach(measure);
  document.querySelectorAll("iframe").forEach(f => f.remove());
  document.querySelector("script").remove();
  document.body.dataset.checked = "yes";
  document.body.dataset.faults = faults.join(" | ");
});
</script>
"##;

pub(crate) fn nothing_is_cut_off_on_screen_phone_and_paper(program: &Path) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (kind, html) in kinds(folder.path()) {
        // On paper: the print rules for every medium, and no screen rules; 210 mm less the margins is 676 px.
        let paper = html.replace("@media print", "@media all").replace("@media screen", "@media not all");
        let attribute = |text: &str| text.replace('&', "&amp;").replace('"', "&quot;");
        let mut page = String::from("<!DOCTYPE html><meta charset=\"utf-8\"><body>");
        page.push_str(MEASURE);
        for (id, width, text) in
            [("phone", 390, &html), ("screen", 1280, &html), ("tablet", 800, &html), ("paper", 676, &paper)]
        {
            page.push_str(&format!(
                "<iframe id=\"{id}\" width=\"{width}\" height=\"900\" style=\"border:0\" srcdoc=\"{}\"></iframe>",
                attribute(text)
            ));
        }
        let path = folder.path().join("measure.html");
        std::fs::write(&path, page).expect("writable");
        let dom = browse(program, &folder.path().join("profile"), &path, &["--dump-dom", "--window-size=1400,1000"]);
        assert!(dom.contains("data-checked=\"yes\""), "{kind}: the page was not measured");
        let faults = dom.split("data-faults=\"").nth(1).and_then(|r| r.split('"').next()).unwrap_or("?");
        assert!(faults.is_empty(), "{kind}:\n{}", faults.replace(" | ", "\n"));
    }
}

/// Writes the samples and their reports for looking at them: `TANKCHECK_LOOK=folder cargo test --test tools look`
pub(crate) fn look(folder: &Path) {
    let names = [
        (Kind::Compare, "Broad tank of Manos and Clough, 1982", "compare"),
        (Kind::Check, "Broad tank, codes alone", "check"),
        (Kind::Rectangle, "Concrete strip", "rectangle"),
        (Kind::Both, "Broad tank, two engines", "both"),
        (Kind::Solid, "Broad tank, three-dimensional", "solid"),
        (Kind::Nonlinear, "Broad tank, nonlinear", "nonlinear"),
    ];
    for (kind, name, sub) in names {
        let out = folder.join(sub);
        std::fs::create_dir_all(&out).expect("the folder can be made");
        sample::write(&out, kind, name);
        let start = std::time::Instant::now();
        let path = report::render(&out, None, report::Level::Full).expect("the sample renders");
        let size = std::fs::metadata(&path).expect("the report exists").len();
        println!("{} {} bytes {:?}", path.display(), size, start.elapsed());
    }
}
