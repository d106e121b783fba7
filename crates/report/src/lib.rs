//! The report: a function of the results folder alone.
//!
//! ```text
//! results.json ─┐
//!               ├─ sections (text, tables, figures) ─ templates ─ report.html
//! series.csv  ──┘                                               └ figures/*.svg
//! ```
//!
//! `report.html` is one self-contained file: no script, figures as inline SVG with title, description and data
//! table, styles inline, dark mode and A4 print by CSS. It is deterministic; only the element `#volatile` may differ
//! between two runs.
//!
//! | module | does |
//! |---|---|
//! | [`sections`] | selects the content, one file a section |
//! | [`level`] | how much of it |
//! | [`document`] | the page for text processors |
//! | [`contents`] | page numbers where a page is printed |
//! | [`figure`] | draws |
//! | `frame` | cover, contents and running head of every page |
//! | [`ida`] | the page of an incremental dynamic analysis |
//! | [`push`] | that of a pushover |
//! | [`study`] | that of a study |
//! | [`math`] | sets formulas |
//! | [`message`] | sentences and titles of parts, by id |
//! | [`number`] | prints numbers |
//! | [`language`], [`style`] | German pages; language and units of a page |
//! | [`words`] | every sentence |
//! | [`template`] | holds the templates, embedded or the user's |
//! | [`workbook`] | writes the results as a workbook |

pub mod contents;
pub mod document;
mod extremes;
pub mod figure;
mod frame;
pub mod ida;
pub mod language;
pub mod level;
pub mod math;
pub mod message;
pub mod methods;
pub mod number;
mod numbering;
pub mod push;
pub mod sections;
pub mod study;
pub mod style;
pub mod table;
pub mod template;
pub mod words;
pub mod workbook;

use std::path::{Path, PathBuf};

pub use level::Level;
pub use numbering::number as numbered;

use figure::Figure;
use files::code::Code;
use files::error::Error;
use files::text::visible;
use number::{fixed, percent, with_unit};
use results::{self, EngineId, Fact, Results, Series, describe, put};
use sections::Source;
use table::{Table, columns};
use tank::units::Dimension;
use template::Templates;

pub use results::{FIGURES_FOLDER, REPORT_FILE};

/// A report in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// `report.html`.
    pub html: String,
    /// Figures as files of their own: name and SVG.
    pub figures: Vec<(String, String)>,
}

/// The report of the `results.json` and `series.csv` in `folder`.
///
/// `templates`: a folder whose files replace the embedded templates of the same name.
///
/// Errors: results that cannot be read, or of which parts were not computed; a template that cannot be rendered.
pub fn of_folder(folder: &Path, templates: Option<&Path>, level: Level) -> Result<Report, Error> {
    build(&whole(folder)?, &results::read_series(folder)?, &Templates::new(templates)?, level)
}

/// The results in a folder.
///
/// Errors: results that cannot be read, or of which parts were not computed.
fn whole(folder: &Path) -> Result<Results, Error> {
    let results = results::read(folder)?;
    if !results.not_computed.is_empty() {
        return Err(Error::File {
            code: Code::NotResults,
            path: folder.join(results::RESULTS_FILE),
            what: format!(
                "holds selected parts alone, a report needs all of them; not computed: {}; run `tankcheck compare` without --select",
                results::LeftOut::names(&results.not_computed)
            ),
        });
    }
    Ok(results)
}

/// Renders the report of a folder of results into the same folder; returns the path of the report.
///
/// Errors: as [`of_folder`]; a file that cannot be written.
pub fn render(folder: &Path, templates: Option<&Path>, level: Level) -> Result<PathBuf, Error> {
    of_folder(folder, templates, level)?.write(folder)
}

/// The same of a run that has just written the folder, whose histories are at hand as the file keeps them
/// ([`Series::as_written`]): reading them again takes time and room.
///
/// Errors: as [`render`].
pub fn render_run(folder: &Path, series: &Series, templates: Option<&Path>, level: Level) -> Result<PathBuf, Error> {
    build(&whole(folder)?, series, &Templates::new(templates)?, level)?.write(folder)
}

impl Report {
    /// A page with its figures.
    ///
    /// Errors: a template that fails.
    pub(crate) fn of<'f>(
        page: &frame::Page<'_>,
        figures: impl IntoIterator<Item = &'f Figure>,
        templates: &Templates,
    ) -> Result<Report, Error> {
        let figures = figures.into_iter().map(|f| (format!("{}.svg", file_name(&f.id)), f.standalone(page.css)));
        Ok(Report::new(&page.html(templates)?, figures.collect()))
    }

    /// A page and its figures, in the language and units of [`style`]. Text of the user cannot act on the page or on a terminal that
    /// shows it, see [`files::text`].
    pub fn new(html: &str, figures: Vec<(String, String)>) -> Report {
        let shown = |(name, svg): (String, String)| (name, language::page(visible(&svg).into_owned()));
        Report { html: language::page(visible(html).into_owned()), figures: figures.into_iter().map(shown).collect() }
    }

    /// Writes `report.html` and `figures/*.svg` into `folder`; returns the path of the report.
    ///
    /// Errors: a file that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, Error> {
        let figures = folder.join(FIGURES_FOLDER);
        // Not the folder above: an ending process may have removed it.
        match std::fs::create_dir(&figures) {
            Err(e) if e.kind() != std::io::ErrorKind::AlreadyExists => {
                return Err(Error::Unwritten { path: figures, what: describe(&e) });
            }
            _ => {}
        }
        for (name, svg) in &self.figures {
            put(&figures.join(name), svg.as_bytes())?;
        }
        let path = folder.join(REPORT_FILE);
        put(&path, self.html.as_bytes())?;
        Ok(path)
    }
}

/// Numbers of a model, one a row.
fn facts(model: &[Fact]) -> Table {
    let mut table = Table::new(columns!["Property", "Value"]);
    for fact in model {
        let value = match fact.kind.is_damping() {
            true => percent(fact.value),
            // A number of things.
            false if fact.dimension == Dimension::Dimensionless && fact.value >= 1.0 && fact.value.fract() == 0.0 => {
                fixed(fact.value, 0)
            }
            false => with_unit(fact.value, fact.dimension),
        };
        table.row(vec![fact.kind.name().into(), value]);
    }
    table
}

/// Renders results and histories.
///
/// Errors: a template that fails, a section that renders without content.
pub fn build(results: &Results, series: &Series, templates: &Templates, level: Level) -> Result<Report, Error> {
    let _style = style::of(results.project.as_ref());
    language::made::begin();
    let source = Source { results, series, level };
    let mut views = Vec::new();
    let mut figures: Vec<Figure> = Vec::new();
    for (make, from) in sections::ALL {
        if level < *from {
            continue;
        }
        let Some(section) = make(&source)? else { continue };
        let template = templates.of_section(section.id);
        let html = templates.render(&template, &section.context)?;
        if is_empty(&html) {
            return Err(Error::Report(format!("section `{}` has no content (template {template})", section.id)));
        }
        views.push(frame::Part { id: section.id, title: section.title, html });
        figures.extend(section.figures);
    }
    // The styles of spatial, coloured and nonlinear figures burden only the reports that have them.
    let mut css = templates.css("figure.css").to_owned();
    let nonlinear = results.beside(EngineId::Nonlinear).is_some();
    if views.iter().any(|v| ["spatial", "around"].contains(&v.id))
        || results.beside(EngineId::Solid).is_some()
        || nonlinear
        || figures.iter().any(|figure| figure.markup.contains(r#"class="v "#))
    {
        css.push_str(templates.css("fields.css"));
    }
    if nonlinear {
        css.push_str(templates.css("nonlinear.css"));
    }
    let page = frame::Page {
        name: &results.name,
        running: "seismic verification",
        project: results.project.as_ref(),
        parts: &views,
        css: &css,
    };
    Report::of(&page, &figures, templates)
}

/// The sketch of a tank to scale, as SVG within a page; its styles are those of the template `figure.css`.
pub fn sketch(tank: &results::TankSummary) -> String {
    language::page(visible(&sections::sketch(tank).inline()).into_owned())
}

/// The sheet of a method, or of one of its checks, as a piece of a page; see [`sections::sheet`].
///
/// Errors: a template that fails.
pub fn sheet(method: &results::Method, check: Option<&tank::assessment::Check>) -> Result<String, Error> {
    let html = sections::sheet(method, check, &Templates::new(None)?)?;
    Ok(language::page(visible(&html).into_owned()))
}

/// Whether markup has neither text nor figure.
fn is_empty(html: &str) -> bool {
    if html.contains("<svg") {
        return false;
    }
    let mut inside_tag = false;
    !html.chars().any(|c| {
        match c {
            '<' => inside_tag = true,
            '>' => {
                inside_tag = false;
                return false;
            }
            _ => {}
        }
        !inside_tag && !c.is_whitespace()
    })
}

/// An id as the name of a file: letters, digits, `-`, `_` and `.`, the rest as `_`.
fn file_name(id: &str) -> String {
    id.chars().map(|c| if c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.') { c } else { '_' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_without_text_is_empty() {
        assert!(is_empty("<div>\n <p></p></div>"));
        assert!(!is_empty("<p>x</p>"));
        assert!(!is_empty("<svg></svg>"));
    }

    #[test]
    fn ids_become_file_names() {
        assert_eq!(file_name("history_hoop@0.1/../x"), "history_hoop_0.1_.._x");
    }
}
