//! Strip 8.4 of the dissertation with fibre walls: statics, linear and nonlinear response to El Centro.
//!
//! | rows | quantity | reference |
//! |---|---|---|
//! | C10 | section forces and deflections at rest | cantilever under hydrostatic pressure |
//! | section | cracking and yield moment of the base | beam theory |
//! | C11 | linear response under different dampings | independent prototype, table 8.14 |
//! | C8 | contact that opens, in the march of nonlinear walls | Moreau's scheme on the same matrices |
//! | C15 | liquid of displacement elements between both walls | the condensed liquid |
//! | C14 | walls of layered shells in time | the same strip of fibres |
//! | C12 | incremental dynamic analysis | independent prototype, table 8.16 |
//!
//! Rows with a record take it as an argument: the version that the dissertation describes (0.348 g) may not be
//! redistributed.

use std::sync::Arc;

use materials::elastic::Elastic;
use materials::{Law, LawError};

use crate::Failure;
use engines::strip::liquid::StripLiquid;
use engines::strip::{Contact, StripError, StripTank, levels};
use fem::element::ElementError;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam::Options;

pub(crate) mod at_rest;
pub(crate) mod chain;
pub(crate) mod contact;
pub(crate) mod incremental;
pub(crate) mod linear_response;
pub(crate) mod section;
pub(crate) mod shells;

/// The dissertation's g; γ = 10 kN/m³ of the water and 25 kN/m³ of the concrete are exact with it.
const G: f64 = 9.81;

const HALF_WIDTH: f64 = 2.5;

const DEPTH: f64 = 2.57;

const HEIGHT: f64 = 3.0;

const THICKNESS: f64 = 0.3;

/// E/(1 − ν²) of the concrete [Pa].
const PLANE_MODULUS: f64 = 34e9 / (1.0 - 0.2 * 0.2);

/// Concrete by its weight [kg/m³].
const CONCRETE: f64 = 25e3 / G;

/// Liner 6 mm and layer 50 mm: they move with the concrete, their weight is not in its normal force [kg/m²].
const ATTACHED: f64 = 8000.0 * 0.006 + 1500.0 * 0.05;

/// Sloshing modes.
const SLOSHING: usize = 12;

/// The tank with one section all along its walls.
fn tank(section: FibreSection, wet: usize, ratio: f64, options: Options) -> Result<StripTank, StripError> {
    let dry = (wet / 5).max(1);
    let section = Arc::new(section);
    Ok(StripTank {
        levels: levels([DEPTH, HEIGHT], [wet, dry], ratio)?,
        sections: vec![section; wet + dry],
        shells: None,
        options,
        carried: Vec::new(),
        base_spring: None,
        liquid: StripLiquid { gravity: G, ..StripLiquid::new(HALF_WIDTH, DEPTH, 1e4 / G) },
        sloshing: SLOSHING,
        contact: Contact::Bonded,
        mesh: None,
    })
}

/// The tank with elastic walls without bars and `elements` wet elements.
///
/// Errors: parameters out of range.
pub fn elastic_tank(elements: usize, options: Options) -> Result<StripTank, StripError> {
    tank(elastic_section()?, elements, 1.0, options)
}

/// The tank with the reinforced walls of the dissertation: `elements` wet elements and `layers` of concrete that softens over
/// the strain `softening`.
///
/// Errors: parameters out of range.
pub fn reinforced_tank(
    elements: usize,
    layers: usize,
    softening: f64,
    options: Options,
) -> Result<StripTank, StripError> {
    tank(section::reinforced(layers, softening)?, elements, 1.0, options)
}

/// The same with walls of liner, layer and cracking concrete as layered shells.
///
/// Errors: parameters out of range.
pub fn with_cracking_shells(tank: StripTank, layers: usize, softening: f64) -> Result<StripTank, Failure> {
    shells::of_shells(tank, shells::Wall::Cracking, layers, softening)
}

/// A wall of one law, without bars, in `layers` layers.
fn plain_section(law: Arc<dyn Law<1>>, layers: usize) -> Result<FibreSection, StripError> {
    Ok(FibreSection::new(CONCRETE * THICKNESS)?.with_attached_mass(ATTACHED)?.rectangle(
        law,
        [1.0, THICKNESS],
        0.0,
        layers,
    )?)
}

fn law_error(source: LawError) -> StripError {
    let kind = "strip 8.4";
    ElementError::Law { kind, source }.into()
}

fn elastic_section() -> Result<FibreSection, StripError> {
    let law = Elastic::new(PLANE_MODULUS, 0.0).map_err(law_error)?;
    plain_section(Arc::new(law), 2)
}
