//! The page of a study: a farm of tanks under a set of records. It has no times and no paths: the same rows give the same bytes.

mod figures;
mod tables;

use serde::Serialize;
use tera::Context;

use crate::Report;
use crate::figure::Figure;
use crate::numbering::number;
use crate::sections::FigureView;
use crate::style;
use crate::table::Table;
use crate::template::Templates;
use crate::words::study as words;
use crate::words::summary::{COVER, SIGNATURES};
use files::error::Error;
use results::{Study, VerdictStatus};

/// Most tanks whose curves are drawn; the table has all.
const DRAWN: usize = 24;

/// A part of a section; one of its fields has content.
#[derive(Default, Serialize)]
struct Block {
    heading: String,
    text: String,
    items: Vec<String>,
    table: Option<Table>,
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
    fn section(&mut self, (id, title): (&'static str, &'static str)) {
        self.sections.push(SectionView {
            id,
            title,
            blocks: Vec::new(),
        });
    }

    fn add(&mut self, block: Block) {
        if let Some(section) = self.sections.last_mut() {
            section.blocks.push(block);
        }
    }

    fn heading(&mut self, heading: &str) {
        self.add(Block {
            heading: heading.into(),
            ..Block::default()
        });
    }

    fn text(&mut self, text: impl Into<String>) {
        self.add(Block {
            text: text.into(),
            ..Block::default()
        });
    }

    fn items(&mut self, items: Vec<String>) {
        if !items.is_empty() {
            self.add(Block {
                items,
                ..Block::default()
            });
        }
    }

    fn table(&mut self, table: Table) {
        if !table.rows.is_empty() {
            self.add(Block {
                table: Some(table),
                ..Block::default()
            });
        }
    }

    fn figures(&mut self, figures: Vec<Figure>) {
        if !figures.is_empty() {
            self.add(Block {
                figures: figures.iter().map(FigureView::of).collect(),
                ..Block::default()
            });
            self.figures.extend(figures);
        }
    }
}

#[derive(Serialize)]
struct Pair {
    label: String,
    value: String,
}

#[derive(Serialize)]
struct Verdict {
    class: &'static str,
    sign: &'static str,
    headline: String,
    lines: Vec<String>,
}

/// The page with its figures.
///
/// Errors: a template or a drawing that fails.
pub fn report(study: &Study) -> Result<Report, Error> {
    let _style = style::of(study.project.as_ref());
    let mut page = Builder::default();
    tanks(study, &mut page);
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
    faults(study, &mut page);
    basis(study, &mut page);
    let templates = Templates::new(None)?;
    let css = templates.css("figure.css").to_owned();
    let mut context = Context::new();
    context.insert("name", &study.name);
    context.insert("subtitle", words::SUBTITLE);
    context.insert("running", words::RUNNING);
    context.insert(
        "mark",
        &study.project.as_ref().map_or(String::new(), tank::Project::mark),
    );
    context.insert("cover", &cover(study));
    context.insert("signatures", &signatures(study));
    context.insert("heads", &words::SIGNATURE_HEADS);
    context.insert("verdict", &verdict(study));
    context.insert("warnings", &words::warnings(study));
    context.insert("facts", &facts(study));
    context.insert("contents", words::CONTENTS);
    context.insert("sections", &page.sections);
    context.insert("style", templates.css("style.css"));
    context.insert("figure_style", &css);
    let drawn = page
        .figures
        .iter()
        .map(|f| (format!("{}.svg", f.id), f.standalone(&css)));
    Ok(Report::new(
        &number(&templates.render("study.html", &context)?),
        drawn.collect(),
    ))
}

/// Entries of the cover that are given.
fn cover(study: &Study) -> Vec<Pair> {
    let project = study.project.clone().unwrap_or_default();
    let given = [
        project.name,
        project.client,
        project.document,
        project.revision,
        project.date,
    ];
    let pair = |(label, value): (&str, Option<String>)| {
        Some(Pair {
            label: label.into(),
            value: value?,
        })
    };
    COVER.into_iter().zip(given).filter_map(pair).collect()
}

fn signatures(study: &Study) -> Vec<Pair> {
    let Some(project) = &study.project else {
        return Vec::new();
    };
    let names = [&project.author, &project.checker, &project.approver];
    let pair = |(label, name): (&str, &Option<String>)| Pair {
        label: label.into(),
        value: name.clone().unwrap_or_default(),
    };
    SIGNATURES.into_iter().zip(names).map(pair).collect()
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
    Verdict {
        class,
        sign,
        headline: words::headline(study),
        lines: words::governing(study),
    }
}

fn facts(study: &Study) -> Vec<Pair> {
    let pair = |(label, value): (&str, String)| Pair {
        label: label.into(),
        value,
    };
    words::facts(study).into_iter().map(pair).collect()
}

fn tanks(study: &Study, page: &mut Builder) {
    page.section(words::TANKS);
    page.text(words::tanks(study));
    page.table(tables::tanks(study));
}

fn states(study: &Study, page: &mut Builder) {
    page.section(words::STATES);
    page.text(words::ABOUT_STATES);
    page.table(tables::states(study));
}

fn curves(study: &Study, page: &mut Builder) -> Result<(), Error> {
    page.section(words::CURVES);
    page.text(words::curves::method(study));
    page.text(words::curves::bands(study));
    page.table(tables::curves(study, &study.curves));
    page.items(words::curves::remarks(&study.curves));
    let drawn = figures::tanks(study, DRAWN)?;
    if drawn.len() < study.tanks.len() {
        page.text(words::curves::drawn(drawn.len(), study.tanks.len()));
    }
    page.figures(drawn);
    Ok(())
}

fn losses(study: &Study, page: &mut Builder) -> Result<(), Error> {
    page.section(words::LOSSES);
    if let Some(reason) = &study.no_losses {
        page.text(words::no_losses(reason));
        return Ok(());
    }
    page.text(words::ABOUT_LOSSES);
    page.figures(figures::losses(study)?);
    page.table(tables::losses(study));
    if !study.system.is_empty() {
        page.heading(words::SYSTEM);
        page.text(words::ABOUT_SYSTEM);
        page.table(tables::curves(study, &study.system));
        page.items(words::curves::remarks(&study.system));
    }
    Ok(())
}

fn records(study: &Study, page: &mut Builder) -> Result<(), Error> {
    page.section(words::RECORDS);
    match &study.rule {
        Some(rule) => {
            page.text(words::rule(rule));
            page.table(tables::rule(rule));
        }
        None => page.text(words::NO_RULE),
    }
    page.heading(words::SINGLE);
    page.text(words::ABOUT_RECORDS);
    page.table(tables::records(study));
    page.figures(figures::traces(study)?);
    Ok(())
}

fn faults(study: &Study, page: &mut Builder) {
    page.section(words::FAULTS);
    page.text(words::basis::faults(study));
    page.table(tables::faults(study));
    page.items(words::basis::unchecked(study));
}

fn basis(study: &Study, page: &mut Builder) {
    page.section(words::BASIS);
    page.items(words::basis::stands_on(study));
    page.table(tables::cost(study));
}

#[cfg(test)]
mod tests;
