//! The sections of the report, in their order. A section is a function from the results to a template and its context;
//! a section without content is left out.

mod around;
mod attribution;
mod base;
mod checks;
mod comparison;
mod datasheet;
mod directions;
mod engine;
mod histories;
mod input;
mod internal_forces;
mod limits;
mod modes;
mod motion;
mod motion_of_base;
mod nonlinear;
mod overlay;
mod part;
mod partings;
mod profiles;
mod provenance;
mod record_set;
mod reported;
mod section;
mod sheets;
mod spatial;
mod spectra;
mod summary;
mod tank;

use crate::level::Level;
use files::error::Error;

pub(crate) use self::provenance::of as provenance_of;
pub use self::sheets::alone as sheet;
pub(crate) use self::tank::{of as tank_data, sketch};
pub use section::{FigureView, Section, Source};

/// Makes a section; `None` without content.
pub type Maker = fn(&Source) -> Result<Option<Section>, Error>;

/// What makes a section: its module, or that of all parts.
macro_rules! maker {
    ($id:ident) => {
        $id::make
    };
    ($id:ident part) => {
        |source| part::section(source, stringify!($id))
    };
}

/// Lists the sections in report order, each with the level from which it is in the report.
macro_rules! sections {
    ($($id:ident $($part:ident)?: $level:ident),+ $(,)?) => {
        /// All sections in report order.
        pub const ALL: &[(Maker, Level)] = &[$((maker!($id $($part)?), Level::$level)),+];
    };
}

sections![
    summary: Summary,
    tank: Summary,
    checks: Standard,
    sheets: Standard,
    comparison: Standard,
    partings: Full,
    reported: Standard,
    attribution: Full,
    limits: Standard,
    engine: Full,
    record_set: Standard,
    profiles: Standard,
    internal_forces: Standard,
    directions: Standard,
    standing part: Full,
    isolation part: Standard,
    base: Standard,
    soil part: Standard,
    nonlinear: Standard,
    large_wave part: Standard,
    roof_wave part: Standard,
    tilt part: Standard,
    modes: Full,
    transfer part: Standard,
    spatial: Standard,
    around: Standard,
    histories: Standard,
    motion: Standard,
    spectra: Standard,
    input: Full,
    provenance: Standard,
];

/// Templates of sections by name.
macro_rules! templates {
    ($($id:literal),+ $(,)?) => {
        &[$((
            concat!("sections/", $id, ".html"),
            include_str!(concat!("../../../templates/sections/", $id, ".html")),
        )),+]
    };
}

/// The templates of sections, that of all parts among them.
pub(crate) const TEMPLATES: &[(&str, &str)] = templates![
    "summary",
    "tank",
    "limits",
    "engine",
    "motion",
    "spectra",
    "record_set",
    "checks",
    "comparison",
    "partings",
    "attribution",
    "reported",
    "profiles",
    "histories",
    "internal_forces",
    "directions",
    "base",
    "nonlinear",
    "modes",
    "spatial",
    "around",
    "sheets",
    "input",
    "provenance",
    "part",
];
