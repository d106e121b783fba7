//! `tankcheck report`: render the report of a results folder again, without computing, also for print, text processors and spreadsheets.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::cli::style::StyleArg;
use crate::cli::terminal::{say, warn};
use crate::cli::{Global, browser, print};
use crate::error::{EXIT_OK, Error};
use crate::study::folder;
use files::code::{Code, Warning};
use files::text::line;
use files::{self, OutputFolder};
use report::document::document;
use report::{self, Level, Report};
use results::{COMPARE_REPORT, FORMS, REPORT_FILE, SERIES_FILE};
use tank::Language;
use tank::units::System;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck report out/
  tankcheck report out/ --report full
  tankcheck report out/ --lang de --report-units both
  tankcheck report out/ --pdf                     out/report.pdf, through an installed Chromium (CHROME names another one)
  tankcheck report out/ --pdf=TK-104.pdf
  tankcheck report farm/ --pdf                    the page of a study, of `ida` or of `push`, as it is
  tankcheck report out/ --format docx,xlsx        out/report.docx (through pandoc), out/report.xlsx
  tankcheck report out/ --interactive             out/interactive.html: scene, charts and tables in one file with scripts, for sending
  tankcheck report out/ --templates our-letterhead/")]
pub(crate) struct Args {
    /// Results folder written by `tankcheck compare` or `tankcheck check`; with --pdf also that of a study, of `ida` or of `push`.
    folder: PathBuf,
    #[command(flatten)]
    level: LevelArg,
    /// Forms next to report.html, separated by commas.
    #[arg(long, value_enum, value_name = "FORM", value_delimiter = ',')]
    format: Vec<Form>,
    /// Print the report through an installed Chromium [default file: report.pdf in the folder].
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    pdf: Option<Option<PathBuf>>,
    /// Also write interactive.html: the viewer of `tankcheck desk` with this result in one file, which needs no network.
    #[arg(long)]
    interactive: bool,
    #[command(flatten)]
    style: StyleArg,
    /// Folder of templates that replace the built-in ones of the same name (report.html, style.css, sections/….html).
    #[arg(long, value_name = "FOLDER")]
    templates: Option<PathBuf>,
}

/// Form of a report.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// The page, which is always written.
    Html,
    /// A4, printed by an installed Chromium.
    Pdf,
    /// A text document, converted by an installed pandoc.
    Docx,
    /// A workbook: a sheet a method, checks, profiles, histories.
    Xlsx,
    /// A page with scripts: the viewer of the desk with this result.
    Interactive,
}

impl Form {
    /// Name of its file in the folder.
    fn file(self) -> &'static str {
        match self {
            Form::Html => REPORT_FILE,
            Form::Pdf => FORMS[0],
            Form::Docx => FORMS[1],
            Form::Xlsx => FORMS[2],
            Form::Interactive => FORMS[3],
        }
    }
}

/// Option `--report`, of all commands that write one.
#[derive(clap::Args, Clone, Copy, Debug)]
pub(crate) struct LevelArg {
    /// How much the report says.
    #[arg(long, value_enum, default_value_t, value_name = "LEVEL")]
    report: ReportLevel,
}

impl LevelArg {
    /// The level.
    pub(crate) fn level(self) -> Level {
        match self.report {
            ReportLevel::Summary => Level::Summary,
            ReportLevel::Standard => Level::Standard,
            ReportLevel::Full => Level::Full,
        }
    }
}

/// How much a report says.
#[derive(clap::ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
enum ReportLevel {
    /// Cover with verdict, failing and open checks; datasheet.
    Summary,
    /// Also checks, sheets of the deciding procedures, comparison, main figures.
    #[default]
    Standard,
    /// Also all sheets and checks, the input key by key, modes, more figures.
    Full,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _global: &Global) -> Result<u8, Error> {
    let _style = args.style.apply();
    let mut forms: Vec<Form> = args.format.iter().copied().filter(|form| *form != Form::Html).collect();
    let aside = args.pdf.clone().flatten();
    if args.pdf == Some(None) {
        forms.push(Form::Pdf);
    }
    if args.interactive {
        forms.push(Form::Interactive);
    }
    forms.dedup();
    if let Some(page) = Page::of(&args.folder) {
        return page.print(&args, &forms);
    }
    for name in files::edited(&args.folder, COMPARE_REPORT) {
        match forms.iter().any(|form| form.file() == name) {
            true => return Err(taken(args.folder.join(&name), "has changed since tankcheck wrote it")),
            false if FORMS.contains(&name.as_str()) => {}
            false => {
                let text = format!("{name} has changed since tankcheck wrote it; the report shows the changed file");
                warn("", &Warning::new(Code::ChangedResults, text));
            }
        }
    }
    if let Some(file) = aside.as_ref().filter(|file| file.symlink_metadata().is_ok()) {
        return Err(taken(file.clone(), "exists"));
    }
    // Missing programs are named before anything is written.
    let chromium = if forms.contains(&Form::Pdf) || aside.is_some() { Some(browser::find()?) } else { None };
    let report = report::of_folder(&args.folder, args.templates.as_deref(), args.level.level())?;
    let folder = OutputFolder::prepare(&args.folder, COMPARE_REPORT)?;
    report.write(&folder.path())?;
    let pdf = match &chromium {
        Some(program) => browser::print(program, &report.html)?,
        None => Vec::new(),
    };
    for form in &forms {
        let bytes = match form {
            Form::Html => continue,
            Form::Pdf => pdf.clone(),
            Form::Docx => converted(&report)?,
            Form::Xlsx => {
                let (results, series) = (results::read(&args.folder)?, results::read_series(&args.folder)?);
                report::workbook::workbook(&results, &series)?
            }
            Form::Interactive => interactive(&args.folder, &report)?.into_bytes(),
        };
        results::put(&folder.path().join(form.file()), &bytes)?;
    }
    folder.commit()?;
    print(&format!("{}\n", args.folder.join(REPORT_FILE).display()))?;
    for form in &forms {
        print(&format!("{}\n", args.folder.join(form.file()).display()))?;
    }
    let stale: Vec<&str> = (FORMS.iter().copied())
        .filter(|name| forms.iter().all(|form| form.file() != *name) && args.folder.join(name).is_file())
        .collect();
    if !stale.is_empty() {
        say!("note: still of the earlier report: {}; --pdf and --format write them again", stale.join(", "));
    }
    if let Some(file) = aside {
        results::put(&file, &pdf)?;
        print(&format!("{}\n", file.display()))?;
    }
    Ok(EXIT_OK)
}

/// A page that is complete in itself: `report` does not render it again, it prints it.
struct Page {
    /// Whose folder it is.
    what: &'static str,
    /// The command that writes the page.
    command: &'static str,
}

impl Page {
    /// The page of a folder; none in one with the results of a verification, or with nothing that is known.
    fn of(folder: &Path) -> Option<Page> {
        let page = |(file, what, command): (&str, &'static str, &'static str)| {
            folder.join(file).is_file().then_some(Page { what, command })
        };
        let known = [
            (folder::PLAN, "a study", "study merge"),
            (results::IDA_FILE, "an incremental dynamic analysis", "ida"),
            (results::PUSH_FILE, "a pushover", "push"),
        ];
        if folder.join(results::RESULTS_FILE).exists() { None } else { known.into_iter().find_map(page) }
    }

    /// Prints it as PDF; returns the exit code.
    ///
    /// Errors: another form than PDF, or none; a page that was not written yet; a file that exists; no browser.
    fn print(&self, args: &Args, forms: &[Form]) -> Result<u8, Error> {
        let folder = line(&args.folder.display().to_string()).into_owned();
        let (what, command) = (self.what, self.command);
        let asked = args.pdf.is_some() || forms.contains(&Form::Pdf);
        let help = match (args.folder.join(REPORT_FILE).is_file(), asked) {
            (true, true) if forms.iter().all(|form| *form == Form::Pdf) => None,
            (true, _) => Some(format!(
                "`tankcheck {command}` has written its page: open {REPORT_FILE} in a browser; --pdf prints it"
            )),
            (false, _) => Some(format!("`tankcheck {command}` writes the page {REPORT_FILE}")),
        };
        if let Some(help) = help {
            return Err(Error::input(
                Code::NotResults,
                format!(
                    "{folder}: is the folder of {what}, expected one of `tankcheck compare` or `tankcheck check`\n  help: {help}"
                ),
            ));
        }
        let file = match &args.pdf {
            Some(Some(file)) => file.clone(),
            _ => args.folder.join(Form::Pdf.file()),
        };
        if file.symlink_metadata().is_ok() {
            return Err(taken(file, "exists"));
        }
        let program = browser::find()?;
        let page = args.folder.join(REPORT_FILE);
        let html = files::read_text(&page).map_err(|e| files::error::Error::unreadable(&page, &e))?;
        results::put(&file, &browser::print(&program, &html)?)?;
        print(&format!("{}\n", file.display()))?;
        Ok(EXIT_OK)
    }
}

fn taken(path: PathBuf, what: &str) -> Error {
    Error::Files(files::error::Error::Taken {
        path,
        what: what.into(),
        help: "move it away, or name another file with --pdf=FILE".into(),
    })
}

/// The viewer with the result of a folder; says how large it is, and what is left out.
///
/// Errors: results that cannot be read.
fn interactive(folder: &Path, report: &Report) -> Result<String, Error> {
    let results = results::read(folder)?;
    let text = |name: &str| {
        let place = folder.join(name);
        let read = |place: &Path| files::read_text(place).map_err(|e| files::error::Error::unreadable(place, &e));
        place.is_file().then(|| read(&place)).transpose()
    };
    let (series, scene) = (text(SERIES_FILE)?, text(results::scene::FILE)?);
    let json = serde_json::to_string(&results).map_err(|e| Error::report(e.to_string()))?;
    let project = results.project.as_ref();
    let _scope = report::style::of(project);
    let html = desk::interactive(&desk::Shown {
        name: &results.name,
        results: &json,
        series: series.as_deref(),
        scene: scene.as_deref(),
        figures: &report.figures,
        language: if report::style::language() == Language::German { "de" } else { "en" },
        units: if report::style::units(project) == System::Us { "us" } else { "si" },
    });
    match scene.map(|scene| scene.len()) {
        Some(bytes) if bytes > desk::MOST_SCENE => say!(
            "note: scene.json is left out: it has {} MB, {} fit; `tankcheck desk` shows it",
            bytes / 1_000_000,
            desk::MOST_SCENE / 1_000_000
        ),
        None => say!("note: the folder has no scene to play; `tankcheck compare --scene` keeps one"),
        Some(_) => {}
    }
    say!("note: {} has {:.1} MB", FORMS[3], html.len() as f64 / 1e6);
    Ok(html)
}

/// The report as a text document, by pandoc.
///
/// Errors: pandoc is not installed or fails; a temporary folder that cannot be made.
fn converted(report: &Report) -> Result<Vec<u8>, Error> {
    let failed = |what: String| Error::report(format!("docx: {what}"));
    let folder = tempfile::Builder::new().prefix("tankcheck-").tempdir().map_err(|e| failed(e.to_string()))?;
    let place = folder.path();
    let document = document(report);
    let put = |path: &Path, bytes: &[u8]| std::fs::write(path, bytes).map_err(|e| failed(e.to_string()));
    std::fs::create_dir(place.join("figures")).map_err(|e| failed(e.to_string()))?;
    put(&place.join("report.html"), document.html.as_bytes())?;
    for (name, bytes) in &document.figures {
        put(&place.join(name), bytes)?;
    }
    let run = Command::new("pandoc")
        .args([
            "--from=html",
            "--to=docx",
            "--standalone",
            "--toc",
            "--toc-depth=2",
            "--output=report.docx",
            "report.html",
        ])
        .current_dir(place)
        .stdin(Stdio::null())
        .output();
    let run = match run {
        Ok(run) => run,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => {
            return Err(Error::input(
                Code::ProgramMissing,
                "--format docx: pandoc is not installed, which converts the report\n  help: install it (Debian: `apt install pandoc`; \
                 macOS: `brew install pandoc`; Windows: `winget install pandoc`)"
                    .into(),
            ));
        }
        Err(e) => return Err(failed(e.to_string())),
    };
    if !run.status.success() {
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        let last = said.lines().rfind(|l| !l.trim().is_empty()).unwrap_or("it said nothing");
        return Err(failed(format!("pandoc failed ({}): {}", run.status, line(last))));
    }
    std::fs::read(place.join("report.docx")).map_err(|e| failed(e.to_string()))
}
