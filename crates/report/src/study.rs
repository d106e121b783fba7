//! The page of a study: a farm of tanks under a set of records. It has no times and no paths: the same rows give the same bytes.

mod figures;
mod tables;

use serde::Serialize;
use tera::Context;

use crate::Report;
use crate::figure::Figure;
use crate::frame::{self, Cover, Page, Pair, Part, Verdict};
use crate::sections::FigureView;
use crate::style;
use crate::table::Table;
use crate::template::Templates;
use crate::words::study as words;
use files::error::Error;
use results::{Study, VerdictStatus};
use tank::units::{Preferred, Unit};

/// Most tanks whose curves are drawn; the table has all.
const DRAWN: usize = 24;
/// Longest name that is kept on one line of a table [characters]: with it every table fits on a page of paper.
const SHORT: usize = 18;

/// A part of a section; one of its fields has content.
#[derive(Default, Serialize)]
struct Block {
    heading: String,
    text: String,
    items: Vec<String>,
    table: Option<Table>,
    /// Whether the first column of the table is of short names, which stay on one line.
    names: bool,
    figures: Vec<FigureView>,
}

/// A section as the template sees it.
#[derive(Serialize)]
struct SectionView {
    id: &'static str,
    title: &'static str,
    blocks: Vec<Block>,
}

/// The sections as they are built, with the figures so far.
#[derive(Default)]
struct Builder {
    sections: Vec<SectionView>,
    figures: Vec<Figure>,
}

impl Builder {
    fn section(&mut self, id: &'static str, title: &'static str) {
        self.sections.push(SectionView { id, title, blocks: Vec::new() });
    }

    fn add(&mut self, block: Block) {
        if let Some(section) = self.sections.last_mut() {
            section.blocks.push(block);
        }
    }

    fn heading(&mut self, heading: &str) {
        self.add(Block { heading: heading.into(), ..Block::default() });
    }

    fn text(&mut self, text: impl Into<String>) {
        self.add(Block { text: text.into(), ..Block::default() });
    }

    fn items(&mut self, items: Vec<String>) {
        if !items.is_empty() {
            self.add(Block { items, ..Block::default() });
        }
    }

    fn table(&mut self, caption: &str, table: Table) {
        if !table.rows.is_empty() {
            let short = |row: &Vec<String>| row.first().is_some_and(|name| name.chars().count() <= SHORT);
            self.add(Block {
                names: table.rows.iter().all(short),
                table: Some(Table { caption: caption.into(), ..table }),
                ..Block::default()
            });
        }
    }

    fn figures(&mut self, figures: Vec<Figure>) {
        if !figures.is_empty() {
            self.add(Block { figures: figures.iter().map(FigureView::of).collect(), ..Block::default() });
            self.figures.extend(figures);
        }
    }
}

/// The page with its figures.
///
/// Errors: a template or a drawing that fails.
pub fn report(study: &Study) -> Result<Report, Error> {
    let _style = style::of(study.project.as_ref());
    let unit = study.unit.as_deref().and_then(|text| Unit::find(text, study.dimension));
    let _unit = Preferred::of(unit);
    let mut page = Builder::default();
    tanks(study, &mut page);
    faults(study, &mut page);
    states(study, &mut page);
    if !study.curves.is_empty() {
        curves(study, &mut page)?;
    }
    if study.tanks.len() > 1 && !study.curves.is_empty() {
        losses(study, &mut page)?;
    }
    if !study.records.is_empty() {
        records(study, &mut page)?;
    }
    basis(study, &mut page);
    let templates = Templates::new(None)?;
    let css = templates.css("figure.css").to_owned();
    let project = study.project.as_ref();
    let mut parts = vec![
        Cover {
            name: study.name.clone(),
            subtitle: words::SUBTITLE.into(),
            project: frame::document(project),
            signatures: frame::signatures(project),
            verdict: verdict(study),
            warnings: words::warnings(study).iter().map(|warning| warning.to_string()).collect(),
            facts: facts(study),
            sketch: Vec::new(),
        }
        .part(&templates)?,
    ];
    for section in &page.sections {
        let mut context = Context::new();
        context.insert("s", section);
        parts.push(Part {
            id: section.id,
            title: section.title.into(),
            html: templates.render("study.html", &context)?,
        });
    }
    let whole = Page { name: &study.name, running: "seismic study", project, parts: &parts, css: &css };
    Report::of(&whole, &page.figures, &templates)
}

/// The verdict of the farm is that of its worst tank; a tank without a result is not a tank that holds.
fn verdict(study: &Study) -> Verdict {
    let count = |status: VerdictStatus| study.tanks.iter().filter(|t| t.verdict == Some(status)).count();
    let holds = count(VerdictStatus::Holds);
    let (class, sign) = if count(VerdictStatus::Fails) > 0 {
        ("fail", "✗")
    } else if holds == study.tanks.len() {
        ("ok", "✓")
    } else {
        ("open", "?")
    };
    Verdict { class, sign, headline: words::headline(study), lines: words::governing(study) }
}

fn facts(study: &Study) -> Vec<Pair> {
    let pair = |(label, value): (&str, String)| Pair::new(label, value);
    words::facts(study).into_iter().map(pair).collect()
}

fn tanks(study: &Study, page: &mut Builder) {
    page.section("tanks", "Tanks and governing checks");
    page.text(words::tanks(study));
    page.table("Tanks under their own design spectra", tables::tanks(study));
    page.items(words::open(study));
    page.table("Further values of the table of tanks, as given", tables::given(study));
    page.items(words::not_given(&tables::not_given(study)));
}

fn states(study: &Study, page: &mut Builder) {
    page.section("states", "Damage states");
    page.text(words::ABOUT_STATES);
    page.table("Damage states, the demands that lead into them, and their sources", tables::states(study));
}

fn curves(study: &Study, page: &mut Builder) -> Result<(), Error> {
    page.section("fragility", "Fragility");
    page.text(words::curves::method(study));
    page.text(words::curves::bands(study));
    page.table("Fragility curves of the tanks", tables::curves(study, &study.curves));
    page.items(words::curves::gaps(study));
    page.items(words::curves::remarks(&study.curves));
    let drawn = figures::tanks(study, DRAWN)?;
    if drawn.len() < study.tanks.len() {
        page.text(words::curves::drawn(drawn.len(), study.tanks.len()));
    }
    page.figures(drawn);
    Ok(())
}

fn losses(study: &Study, page: &mut Builder) -> Result<(), Error> {
    page.section("losses", "Losses of the farm");
    if let Some(reason) = &study.no_losses {
        page.text(words::no_losses(reason));
        return Ok(());
    }
    page.text(words::ABOUT_LOSSES);
    page.figures(figures::losses(study)?);
    page.table("Losses of the farm by intensity", tables::losses(study));
    page.items(words::never_judged(study));
    if !study.system.is_empty() {
        page.heading("At least one tank");
        page.text(words::about_system(study));
        page.table("Fragility curves of the farm", tables::curves(study, &study.system));
        page.items(words::curves::remarks(&study.system));
    }
    Ok(())
}

fn records(study: &Study, page: &mut Builder) -> Result<(), Error> {
    page.section("records", "Records");
    match &study.rule {
        Some(rule) => {
            page.text(words::rule(rule));
            page.table("Mean spectrum of the records against the target", tables::rule(rule));
        }
        None => page.text(words::NO_RULE),
    }
    page.heading("Single records");
    page.text(words::ABOUT_RECORDS);
    page.table("Records", tables::records(study));
    page.figures(figures::traces(study)?);
    Ok(())
}

fn faults(study: &Study, page: &mut Builder) {
    page.section("faults", "What failed and what was not checked");
    page.text(words::basis::faults(study));
    page.table("Rows without a finished run", tables::faults(study));
    page.table("Demands of the damage states that were not checked, at least in some rows", tables::gaps(study));
}

fn basis(study: &Study, page: &mut Builder) {
    page.section("basis", "Basis and cost");
    page.items(words::basis::stands_on(study));
    page.table("Tasks and rows", tables::cost(study));
}

#[cfg(test)]
mod tests;
