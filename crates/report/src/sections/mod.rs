//! The sections of the report, in their order. A section is a function from the results to a template and its context;
//! one that has nothing to show is left out.

mod checks;
mod comparison;
mod engine;
mod histories;
mod input;
mod limits;
mod modes;
mod motion;
mod nonlinear;
mod overlay;
mod partings;
mod profiles;
mod provenance;
mod reported;
mod sheets;
mod spatial;
mod spectra;
mod summary;
mod tank;

use serde::Serialize;
use tera::Context;

use crate::figure::{Figure, Room};
use crate::table::Table;
use crate::words;
use files::error::Error;
use results::{FE, Method, Results, Series};

/// What a section is made from.
pub struct Source<'a> {
    /// `results.json`.
    pub results: &'a Results,
    /// `series.csv`.
    pub series: &'a Series,
}

/// A section ready to be rendered.
pub struct Section {
    /// Id and anchor.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// Context of the template `sections/<id>.html`.
    pub context: Context,
    /// Figures, for `figures/`.
    pub figures: Vec<Figure>,
}

/// Makes a section, or `None` where there is nothing to show.
pub type Maker = fn(&Source) -> Result<Option<Section>, Error>;

/// All sections in report order.
pub const ALL: &[Maker] = &[
    summary::make,
    comparison::make,
    partings::make,
    reported::make,
    checks::make,
    tank::make,
    input::make,
    motion::make,
    spectra::make,
    modes::make,
    profiles::make,
    histories::make,
    nonlinear::make,
    spatial::make,
    sheets::make,
    engine::make,
    limits::make,
    provenance::make,
];

impl Section {
    /// A section without content yet.
    fn new(id: &'static str) -> Section {
        Section {
            id,
            title: words::headings::section(id),
            context: Context::new(),
            figures: Vec::new(),
        }
    }

    /// Hands a value to the template.
    fn set<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) {
        self.context.insert(key, value);
    }

    /// Hands figures to the template.
    fn set_figures(&mut self, key: &'static str, figures: Vec<Figure>) {
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
    titled: bool,
    svg: String,
    room: Room,
    table: Table,
}

impl FigureView {
    /// Of a figure.
    pub fn of(figure: &Figure) -> FigureView {
        FigureView {
            id: figure.id.clone(),
            title: figure.title.clone(),
            caption: figure.caption.clone(),
            titled: figure.titled,
            svg: figure.inline(),
            room: figure.room,
            table: figure.table.clone(),
        }
    }
}

impl<'a> Source<'a> {
    /// The finite-element method, where it ran.
    fn fe(&self) -> Option<&'a Method> {
        self.results.methods.iter().find(|m| m.id == FE)
    }

    /// A quantity of the finite elements, or else of the first method that gives it, in SI.
    fn best(&self, quantity: &str) -> Option<f64> {
        let of = |m: &Method| m.quantities.get(quantity).map(|v| v.value);
        self.fe()
            .and_then(of)
            .or_else(|| self.results.methods.iter().filter(|m| m.id != "measured").find_map(of))
    }

    /// A column of the series.
    fn column(&self, id: &str) -> Option<&'a [f64]> {
        let i = self.series.ids.iter().position(|c| c == id)?;
        self.series.columns.get(i).map(Vec::as_slice)
    }
}
