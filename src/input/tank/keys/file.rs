//! The top level of the file.

use ::tank::{Liquid, Project};

use super::accepted::Accepted;
use super::damping::Damping;
use super::linear::Analysis;
use super::materials::Material;
use super::procedures::Procedures;
use super::record::Record;
use super::reported::{Measured, Published};
use super::site::Site;
use super::tank::Tank;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::values::{Acceleration, Named};
use ::tank::keys::{Absent, Limits, default};

object! {
    /// A liquid storage tank to be verified for earthquakes.
    ///
    /// Every value with a dimension is a text with its unit, such as "1.83 m"; bare numbers are dimensionless. Comments
    /// and trailing commas are allowed.
    TankFile {
        /// Title of the report.
        name ("Fire-water tank"): Field<String>,
        /// Cover of the report.
        project: Opt<Given<Project>>,
        /// Remarks for the report, free text.
        notes ("as built 1974"): Opt<String>,
        /// Acceleration of free fall.
        gravity ("9.81 m/s2"): Opt<Acceleration> [Limits::from(0.1).to(100.0).usual(9.7, 9.9)]
            = default(Acceleration(tank::STANDARD_GRAVITY))
                .shown("9.80665 m/s2")
                .because("standard gravity, ISO 80000-3"),
        /// The tank.
        tank: Field<Tank>,
        /// The stored liquid.
        liquid: Field<Given<Liquid>>,
        /// Materials by name.
        materials: Field<Named<Material>>,
        /// Processing of the accelerogram given with --quake.
        record: Opt<Record>,
        /// Damping ratios, as fractions of critical damping.
        damping: Opt<Damping>,
        /// Site data for design spectra, one object for each code.
        site: Opt<Site>,
        /// Choices within the code procedures.
        procedures: Opt<Procedures>,
        /// Gaps of the deciding codes that are accepted, each with its reason: limit states that are not checked.
        accepted: Opt<Vec<Field<Accepted>>>,
        /// Options of the finite-element analysis.
        analysis: Opt<Analysis> = Absent::Follows("modal integration on the default mesh"),
        /// Measured values for comparison with the computed ones, by quantity; each under the ground motion that it names.
        measured: Opt<Measured>,
        /// Published values for this tank.
        published: Opt<Vec<Field<Published>>>,
    }
}
