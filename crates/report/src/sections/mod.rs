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
mod section;
mod sheets;
mod spatial;
mod spectra;
mod summary;
mod tank;

use files::error::Error;

pub use section::{FigureView, Section, Source};

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
