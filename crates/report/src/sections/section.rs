//! Common to all sections: source, context of the template, figures.

use results::compare::MEASURED;
use results::{FE, Method, Results, Series};
use serde::Serialize;
use tera::Context;

use crate::figure::{Figure, Room};
use crate::level::Level;
use crate::table::Table;
use crate::words;

/// Source of the sections.
pub struct Source<'a> {
    /// `results.json`.
    pub results: &'a Results,
    /// `series.csv`.
    pub series: &'a Series,
    /// How much is said.
    pub level: Level,
}

/// A section ready to be rendered.
pub struct Section {
    /// Id and anchor.
    pub id: &'static str,
    /// Heading.
    pub title: String,
    /// Context of the template `sections/<id>.html`, of a part `sections/part.html`.
    pub context: Context,
    /// Figures, for `figures/`.
    pub figures: Vec<Figure>,
}

impl Section {
    /// A section with its sentences, without content yet.
    pub(super) fn new(id: &'static str) -> Section {
        let mut section = Section::titled(id, words::sections::heading(id).into());
        section.set("words", &words::sections::sentences(id));
        section
    }

    /// A section with this heading, without content yet.
    pub(super) fn titled(id: &'static str, title: String) -> Section {
        Section { id, title, context: Context::new(), figures: Vec::new() }
    }

    /// Keeps a figure for `figures/`; returns its view.
    pub(super) fn show(&mut self, figure: Figure) -> Vec<FigureView> {
        let view = FigureView::of(&figure);
        self.figures.push(figure);
        vec![view]
    }

    /// Hands a value to the template.
    pub(super) fn set<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) {
        self.context.insert(key, value);
    }

    /// Hands figures to the template.
    pub(super) fn set_figures(&mut self, key: &'static str, figures: Vec<Figure>) {
        let views: Vec<FigureView> = figures.iter().map(FigureView::of).collect();
        self.context.insert(key, &views);
        self.figures.extend(figures);
    }
}

/// A figure as the templates see it.
#[derive(Serialize)]
pub struct FigureView {
    id: String,
    title: String,
    caption: String,
    svg: String,
    room: Room,
    table: Table,
}

impl FigureView {
    /// The view of a figure.
    pub fn of(figure: &Figure) -> FigureView {
        FigureView {
            id: figure.id.clone(),
            title: figure.title.clone(),
            caption: figure.caption.clone(),
            svg: figure.inline(),
            room: figure.room,
            table: figure.table.clone(),
        }
    }
}

impl<'a> Source<'a> {
    /// The finite-element method, where it ran.
    pub(super) fn fe(&self) -> Option<&'a Method> {
        let mut columns = self.results.methods.iter().filter(|m| m.id == FE);
        // The column under the record is the first.
        columns.next()
    }

    /// A quantity of the finite elements, or else of the first deciding method that gives it, or of any, in SI.
    pub(super) fn best(&self, quantity: &str) -> Option<f64> {
        let of = |m: &Method| m.quantities.get(quantity).map(|v| v.value);
        let methods = || self.results.methods.iter().filter(|m| m.id != MEASURED);
        let deciding = || methods().filter(|m| self.results.verdict.decides(m)).find_map(of);
        self.fe().and_then(of).or_else(deciding).or_else(|| methods().find_map(of))
    }

    /// A column of the series, to the end of its run.
    pub(super) fn column(&self, id: &str) -> Option<&'a [f64]> {
        let i = self.series.ids.iter().position(|c| c == id)?;
        let values = self.series.columns.get(i)?;
        let end = values.iter().rposition(|v| v.is_finite()).map_or(0, |last| last + 1);
        Some(&values[..end])
    }
}
