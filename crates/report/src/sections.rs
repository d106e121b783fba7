//! The sections of the report, in their order. A section is a function from the results to a template and its context;
//! a section without content is left out.

mod around;
mod attribution;
mod base;
mod checks;
mod comparison;
mod directions;
mod engine;
mod histories;
mod input;
mod internal_forces;
mod isolation;
mod limits;
mod modes;
mod motion;
mod motion_of_base;
mod nonlinear;
mod overlay;
mod partings;
mod profiles;
mod provenance;
mod record_set;
mod reported;
mod section;
mod sheets;
mod soil;
mod spatial;
mod spectra;
mod standing;
mod summary;
mod tank;
mod tilt;
mod transfer;

use crate::level::Level;
use files::error::Error;

pub(crate) use self::provenance::of as provenance_of;
pub(crate) use self::tank::{of as tank_data, sketch};
pub use section::{FigureView, Section, Source};

/// Makes a section; `None` without content.
pub type Maker = fn(&Source) -> Result<Option<Section>, Error>;

/// Lists the sections in report order, each with the level from which it is in the report, and its template.
macro_rules! sections {
    ($($id:ident: $level:ident),+ $(,)?) => {
        /// All sections in report order.
        pub const ALL: &[(Maker, Level)] = &[$(($id::make, Level::$level)),+];

        /// Their templates by name.
        pub(crate) const TEMPLATES: &[(&str, &str)] = &[$((
            concat!("sections/", stringify!($id), ".html"),
            include_str!(concat!("../../../templates/sections/", stringify!($id), ".html")),
        )),+];
    };
}

sections![
    summary: Summary,
    tank: Standard,
    limits: Standard,
    engine: Standard,
    motion: Standard,
    spectra: Standard,
    record_set: Standard,
    checks: Standard,
    comparison: Standard,
    partings: Full,
    attribution: Standard,
    reported: Standard,
    profiles: Standard,
    histories: Standard,
    internal_forces: Standard,
    directions: Standard,
    standing: Standard,
    isolation: Standard,
    base: Standard,
    soil: Standard,
    nonlinear: Standard,
    tilt: Standard,
    modes: Full,
    transfer: Standard,
    spatial: Standard,
    around: Standard,
    sheets: Standard,
    input: Full,
    provenance: Standard,
];
