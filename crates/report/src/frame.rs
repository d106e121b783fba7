//! The frame of every page: cover, contents, numbered sections, running head.

use serde::Serialize;
use tank::units::Dimension;
use tank::{Project, Shape};
use tera::Context;

use crate::figure::Figure;
use crate::number::{given, ratio, with_unit};
use crate::sections::{self, FigureView, Section};
use crate::template::Templates;
use crate::words::summary as words;
use files::error::Error;
use results::{SourceFile, TankSummary};

/// A label and its value.
#[derive(Serialize)]
pub(crate) struct Pair {
    label: String,
    value: String,
}

impl Pair {
    /// A pair of a label and a value.
    pub(crate) fn new(label: &str, value: String) -> Pair {
        Pair { label: label.into(), value }
    }
}

/// The box of the verdict.
#[derive(Serialize)]
pub(crate) struct Verdict {
    /// Colour: `ok`, `open`, `fail`, `none`.
    pub class: &'static str,
    /// Sign in front of the headline.
    pub sign: &'static str,
    /// One line.
    pub headline: String,
    /// What decides, one sentence each.
    pub lines: Vec<String>,
}

/// The first page of an analysis that is not a verification.
#[derive(Serialize)]
pub(crate) struct Cover {
    /// Title of the case.
    pub name: String,
    /// What was done.
    pub subtitle: String,
    /// Entries of the document that are given.
    pub project: Vec<Pair>,
    /// Who signs.
    pub signatures: Vec<Pair>,
    /// The verdict.
    pub verdict: Verdict,
    /// What a reader has to know before the numbers.
    pub warnings: Vec<String>,
    /// Key figures.
    pub facts: Vec<Pair>,
    /// The sketch; none of a study of several tanks.
    pub sketch: Vec<FigureView>,
}

impl Cover {
    /// Rendered as the first part of a page.
    ///
    /// Errors: a template that fails.
    pub(crate) fn part(&self, templates: &Templates) -> Result<Part, Error> {
        let mut context = Context::new();
        context.insert("c", self);
        context.insert("heads", &words::SIGNATURE_HEADS);
        Ok(Part {
            id: "summary",
            title: crate::words::sections::heading("summary").into(),
            html: templates.render("cover.html", &context)?,
        })
    }
}

/// A rendered section.
#[derive(Serialize)]
pub(crate) struct Part {
    /// Id and anchor.
    pub id: &'static str,
    /// Heading; that of the first part is not printed.
    pub title: String,
    /// Content.
    pub html: String,
}

/// The parts of a page of an analysis as they are rendered: cover, tank, the analysis' own, provenance.
pub(crate) struct Body<'a> {
    templates: &'a Templates,
    /// Rendered parts.
    pub parts: Vec<Part>,
    /// Figures of cover and tank.
    pub figures: Vec<Figure>,
}

impl<'a> Body<'a> {
    /// Cover and data of the tank.
    ///
    /// Errors: a template that fails.
    pub(crate) fn new(templates: &'a Templates, cover: Cover, tank: Option<&TankSummary>) -> Result<Body<'a>, Error> {
        let mut body = Body {
            templates,
            parts: vec![cover.part(templates)?],
            figures: tank.map(sections::sketch).into_iter().collect(),
        };
        if let Some(tank) = tank {
            body.section(sections::tank_data(tank, false))?;
        }
        Ok(body)
    }

    /// A part of the analysis' own template, which has its id as `part`.
    ///
    /// Errors: a template that fails.
    pub(crate) fn part(
        &mut self,
        template: &str,
        (id, title): (&'static str, &'static str),
        context: &mut Context,
    ) -> Result<(), Error> {
        context.insert("part", id);
        let html = self.templates.render(template, context)?;
        let title = title.into();
        self.parts.push(Part { id, title, html });
        Ok(())
    }

    /// Files, version, time and command line.
    ///
    /// Errors: a template that fails.
    pub(crate) fn provenance(
        &mut self,
        files: &[SourceFile],
        format: &str,
        volatile: &results::Volatile,
    ) -> Result<(), Error> {
        self.section(sections::provenance_of(files, format, volatile))
    }

    fn section(&mut self, section: Section) -> Result<(), Error> {
        let template = format!("sections/{}.html", section.id);
        self.parts.push(Part {
            id: section.id,
            title: section.title,
            html: self.templates.render(&template, &section.context)?,
        });
        self.figures.extend(section.figures);
        Ok(())
    }
}

/// A page.
pub(crate) struct Page<'a> {
    /// Title of the case.
    pub name: &'a str,
    /// What it is, in the running head.
    pub running: &'a str,
    /// The document, for the running head.
    pub project: Option<&'a Project>,
    /// Cover, then the sections.
    pub parts: &'a [Part],
    /// Styles of the figures.
    pub css: &'a str,
}

impl Page<'_> {
    /// The whole page; figures and tables have their numbers.
    ///
    /// Errors: a template that fails.
    pub(crate) fn html(&self, templates: &Templates) -> Result<String, Error> {
        let mut page = Context::new();
        page.insert("name", self.name);
        page.insert("running", self.running);
        page.insert("mark", &self.project.map_or(String::new(), Project::mark));
        page.insert("sections", self.parts);
        // The font of formulas burdens only the pages that have them.
        let formulas = |part: &Part| part.html.contains("<math") || part.html.contains("class=\"words\"");
        let font = self.parts.iter().any(formulas);
        page.insert("font", if font { templates.css("math.css") } else { "" });
        page.insert("style", templates.css("style.css"));
        page.insert("figure_style", self.css);
        Ok(crate::numbering::number(&templates.render("report.html", &page)?))
    }
}

/// The document: what, for whom, which number; only what is given.
pub(crate) fn document(project: Option<&Project>) -> Vec<Pair> {
    let project = project.cloned().unwrap_or_default();
    let given = [project.name, project.client, project.document, project.revision, project.date];
    let labels = words::COVER.into_iter().zip(given);
    labels.filter_map(|(label, value)| Some(Pair::new(label, value?))).collect()
}

/// Who signs: role and name, which may be blank. None without a block `project`.
pub(crate) fn signatures(project: Option<&Project>) -> Vec<Pair> {
    let Some(project) = project else { return Vec::new() };
    let names = [&project.author, &project.checker, &project.approver];
    (words::SIGNATURES.into_iter().zip(names))
        .map(|(label, name)| Pair::new(label, name.clone().unwrap_or_default()))
        .collect()
}

/// Key figures of the tank.
pub(crate) fn tank(summary: &TankSummary) -> Vec<Pair> {
    let depth = summary.liquid.fill_height;
    let mut facts = Vec::new();
    let mut add = |label: &str, value: String| facts.push(Pair::new(label, value));
    match summary.tank.shape {
        Shape::Cylinder { radius } => {
            add("Radius R", given(radius, Dimension::Length));
            add("Liquid depth H", given(depth, Dimension::Length));
            add("H / R", ratio(depth / radius));
        }
        Shape::Rectangle { length, breadth, strip } => {
            add("Length 2L", given(length, Dimension::Length));
            if !strip {
                add("Breadth", given(breadth, Dimension::Length));
            }
            add("Liquid depth H", given(depth, Dimension::Length));
            add("H / L", ratio(2.0 * depth / length));
        }
    }
    let strip = matches!(summary.tank.shape, Shape::Rectangle { strip: true, .. });
    add(words::liquid_mass(strip), with_unit(summary.liquid_mass, Dimension::Mass));
    facts
}
