//! The keys of `tank.json`: each file declares those of one section and resolves them to values in SI.
//!
//! Keys and meaning are a contract: extend freely, do not rename.

mod damping;
mod grades;
mod linear;
mod materials;
mod nonlinear;
mod places;
mod plausible;
mod procedures;
mod record;
mod reported;
mod site;
mod solid;
mod tank;
mod wall;

use ::tank::case::Case;

pub use places::Places;
pub use solid::solid_defaults;

use super::key::{Absent, Limits, default};
use super::read::{Field, Opt, object};
use super::resolver::Resolver;
use super::values::{Acceleration, Named};
use crate::input;
use crate::input::diagnostic::{Faults, Source};

object! {
    /// A liquid storage tank to be verified for earthquakes.
    ///
    /// Every value with a dimension is a text with its unit, such as "1.83 m"; bare numbers are dimensionless. Comments
    /// and trailing commas are allowed.
    TankFile {
        /// Title of the report.
        name ("Fire-water tank"): Field<String>,
        /// Remarks for the report, free text.
        notes ("as built 1974"): Opt<String>,
        /// Acceleration of free fall.
        gravity ("9.81 m/s2"): Opt<Acceleration> [Limits::from(0.1).to(100.0)]
            = default(Acceleration(::tank::STANDARD_GRAVITY))
                .shown("9.80665 m/s2")
                .because("standard gravity, ISO 80000-3"),
        /// The tank.
        tank: Field<tank::Tank>,
        /// The stored liquid.
        liquid: Field<tank::Liquid>,
        /// Materials by name.
        materials: Field<Named<materials::Material>>,
        /// What to do to the accelerogram given with --quake.
        record: Opt<record::Record>,
        /// Damping ratios, as fractions of critical damping.
        damping: Opt<damping::Damping>,
        /// Site data for design spectra, one object for each code.
        site: Opt<site::Site>,
        /// Choices within the code procedures.
        procedures: Opt<procedures::Procedures>,
        /// Options of the finite-element analysis.
        analysis: Opt<linear::Analysis> = Absent::Follows("modal integration on the default mesh"),
        /// Measured values to stand beside the computed ones, by quantity.
        measured: Opt<reported::Measured>,
        /// Values others have published for this tank.
        published: Opt<Vec<Field<reported::Published>>>,
    }
}

/// Resolves the file; `None` (or any fault) if it gives no case.
pub(super) fn resolve(file: &TankFile, faults: &mut Faults) -> Option<input::TankFile> {
    let mut r = Resolver::new(faults);
    let name = r.text(&file.name);
    if let Some(notes) = &file.notes.given {
        r.echo_given(notes);
    }
    let gravity = r.or_default(&file.gravity);
    let materials = materials::materials(&mut r, &file.materials);
    let tank = tank::tank(&mut r, &file.tank, &materials);
    let liquid = tank::liquid(&mut r, &file.liquid);
    tank::cross_checks(&mut r, file, tank.as_ref(), liquid);
    plausible::tank(&mut r, file, tank.as_ref(), liquid);
    tank::unused(&mut r, file);
    let record = record::record(&mut r, &file.record);
    let damping = damping::damping(&mut r, &file.damping, tank.as_ref());
    let site = site::site(&mut r, &file.site);
    let (procedures, run) = procedures::procedures(&mut r, &file.procedures);
    let fe = linear::analysis(&mut r, &file.analysis, tank.as_ref());
    let solid = solid::solid(&mut r, &file.analysis);
    let nonlinear = nonlinear::nonlinear(&mut r, &file.analysis, tank.as_ref(), damping);
    let measured = reported::measured(&mut r, &file.measured);
    let published = reported::published(&mut r, &file.published);
    let (echo, remarks, warnings) = (r.echo, r.remarks, r.warnings);
    Some(input::TankFile {
        case: Case {
            name: name?,
            tank: tank?,
            liquid: liquid?,
            gravity,
            ground_motion: None,
            damping,
            site,
            procedures,
            measured,
            published,
        },
        record,
        echo,
        procedures: run,
        fe,
        solid,
        nonlinear,
        remarks,
        warnings,
        sha256: String::new(),
        source: Source::new("", ""),
        places: Places::of(file),
    })
}
