//! `analysis`: options of the linear engines.

use std::path::Path;

use files::code::Code;
use oscillator::record::Record;
use results::InputValue;
use tank::options::frequency::FrequencyOptions;
use tank::options::linear::{
    CaugheyPairs, DampingModel, Dashpots, Heave, Integrator, LiquidModel, WallDirection, WallPlace,
};
use tank::options::{LinearOptions, NonlinearOptions};
use tank::{Shape, Support, Tank, case};

use super::frequency::frequency;
use super::imperfections::Imperfection;
use super::instant::{Moment, instants};
use super::nonlinear::{ByGroup, by_group};
use super::rayleigh::{RatioAt, Rayleigh, ratio_at, rayleigh};
use super::response::{ResponseSpectrum, response};
use super::solid::Solid;
use crate::input::records::load;
use crate::input::rotation;
use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::{Resolver, like_field, range_fault};
use crate::input::tank::values::{Angle, Length, Number, Time, Whole};
use tank::keys::{Absent, Limits, default, without};

/// Defaults.
const DEFAULT: &LinearOptions = &LinearOptions::DEFAULT;
/// Gauges and stations; the tank bounds them further.
const PLACES: Limits = Limits::from(0.0).to(1000.0).items(0, 100);
/// Coefficients of Rayleigh damping.
const COEFFICIENT: Limits = Limits::from(-1e6).to(1e6);

/// Times of snapshots [s].
const SNAPSHOTS: Limits = Limits::from(0.0).to(1e5).items(0, 20);
/// Angles of a tilt test [rad]: up to 45°.
const TILT: Limits = Limits::above(0.0).to(std::f64::consts::FRAC_PI_4);
/// Most rings of dashpots.
const MOST_RINGS: usize = 20;
/// Most stations of internal forces, six histories each.
const MOST_STATIONS: usize = 50;
/// Pairs of Caughey's series.
const PAIRS: Limits = Limits::from(0.0).items(2, CaugheyPairs::MOST);

object! {
    /// Options of the finite-element analysis.
    Analysis {
        /// Time integration.
        integrator: Opt<Integrator> = default(DEFAULT.integrator),
        /// Factor on the number of elements in each direction.
        refine (2): Opt<Number> [Limits::from(0.25).to(16.0)] = default(Number(DEFAULT.refine)),
        /// Number of sloshing modes that count for the wave height.
        wave_modes (5): Opt<Whole> [Limits::count(1, 50)] = default(Whole(DEFAULT.wave_modes as u32)),
        /// Liquid of the harmonic engine; beside a linear one whose wave is not small a nonlinear one is computed.
        liquid: Opt<LiquidModel> = default(DEFAULT.liquid),
        /// Whether the discretisation error is estimated on a second mesh.
        mesh_error (false): Opt<bool> = default(DEFAULT.mesh_error),
        /// Wave gauges besides the one at the wall: distances from the centre in the direction of shaking.
        gauges: Opt<Vec<Field<Length>>> [PLACES],
        /// Stress stations: heights above the base with histories of hoop, axial and bending stress.
        stations: Opt<Vec<Field<Length>>> [PLACES],
        /// Places of a cylinder's wall with histories of its membrane forces and moments by the linear engines.
        force_stations: Opt<Vec<Field<Given<WallPlace>>>> [Limits::ANY.items(0, MOST_STATIONS)]
            = Absent::Without("no histories of internal forces"),
        /// Times at which the three-dimensional engine draws the deformed tank, pressure and hoop stress, besides the extremes; a time, or
        /// the peak of a history by name.
        snapshots: Opt<Vec<Field<Moment>>> [SNAPSHOTS],
        /// Rotational acceleration of the base about y beside the record, positive where the top moves along x: a CSV file with the columns time_s and
        /// rotation_rad_s2 in equal steps from 0; relative to the tank file. The keys of `record` do not scale it. Of an anchored tank in the harmonic
        /// engine.
        quake_rotation ("rotation.csv"): Opt<String> = Absent::Without("the base does not turn with the record"),
        /// Angle of a static tilt test by the linear engines: tank and liquid at rest on a base tilted by it.
        tilt ("10 deg"): Opt<Angle> [TILT] = without("no tilt test"),
        /// Inertia of wall and roof that the foot of an unanchored cylinder with `tank.bottom` lifts and drops as it rocks, by the harmonic engine.
        heave: Opt<Given<Heave>> = Absent::Without("the foot lifts wall and roof without inertia"),
        /// Damping of the ground under the rim of an unanchored cylinder with `tank.bottom` while the rim is in contact, of critical at the impulsive mode
        /// of the wall, besides what soil with shear waves radiates, by the harmonic engine.
        ground_damping (0.05): Opt<Number> [Limits::from(0.0).to(0.5).usual(0.0, 0.2)] = default(Number(DEFAULT.ground_damping)),
        /// Damping model.
        damping: Opt<AnalysisDamping> = Absent::Follows("the modal ratios of damping"),
        /// Deviations of a cylinder's wall from the perfect shape, which are added, in the three-dimensional and the nonlinear
        /// engine. All others compute the perfect cylinder.
        imperfections: Opt<Vec<Field<Imperfection>>> [Limits::ANY.items(0, 100)]
            = Absent::Without("the wall is a perfect cylinder"),
        /// Whether the wall of the three-dimensional engine moves about its state under weight and liquid, whose hoop force
        /// stiffens it against waves around the tank.
        initial_stress (true): Opt<bool> = Absent::Follows("true with imperfections, else false"),
        /// Response-spectrum method under the design spectrum of `site`.
        spectrum: Opt<ResponseSpectrum>,
        /// Transfer functions of the linear engines under harmonic base motion.
        frequency: Opt<Given<FrequencyOptions>>,
        /// Options of the three-dimensional engine (--fe solid, --fe both).
        solid: Opt<Solid>,
        /// Options of the nonlinear engine.
        nonlinear: Opt<Given<NonlinearOptions>>,
    }

    /// Damping model of the finite-element analysis instead of modal ratios; give one of them. Dashpots act besides it.
    AnalysisDamping {
        /// Stiffness-proportional in the wall, a ratio for every sloshing mode, as of the nonlinear engine.
        by_group: Opt<ByGroup>,
        /// Caughey's series through pairs of frequency and ratio; beyond them the ratio of the nearest.
        caughey: Opt<Vec<Field<RatioAt>>> [PAIRS],
        /// Rayleigh damping fitted to two ratios.
        rayleigh: Opt<Rayleigh>,
        /// Rayleigh damping with given coefficients of either sign.
        coefficients: Opt<Coefficients>,
        /// Dashpots between the ground and the wall of a cylinder in the linear engines, besides the damping model; they couple the modes.
        dashpots: Opt<Vec<Field<Given<Dashpots>>>> [Limits::ANY.items(0, MOST_RINGS)] = Absent::Without("no dashpots"),
    }

    /// Coefficients of Rayleigh damping C = a_M M + a_K K.
    Coefficients {
        /// a_M in 1/s, a bare number.
        mass (0.1): Field<Number> [COEFFICIENT],
        /// a_K.
        stiffness ("0.001 s"): Field<Time> [COEFFICIENT],
    }
}

choice!(WallDirection, Integrator, LiquidModel);

/// Options of the linear engines. Defaults are those of the engine and not echoed one by one.
///
/// * `ratios`: damping ratios of the case
pub(super) fn analysis(
    r: &mut Resolver<'_>,
    given: Option<&Analysis>,
    tank: Option<&Tank>,
    ratios: case::Damping,
) -> LinearOptions {
    let Some(given) = given else {
        r.echo_default("analysis", "not given", "modal integration on the default mesh");
        return DEFAULT.clone();
    };
    let (half, what) = match tank.map(|t| t.shape) {
        Some(Shape::Cylinder { radius }) => (radius, "the radius"),
        Some(Shape::Rectangle { length, .. }) => (length / 2.0, "half the length"),
        None => (f64::NAN, ""),
    };
    let height = tank.map_or(f64::NAN, Tank::wall_height);
    LinearOptions {
        integrator: r.or_default(&given.integrator),
        refine: r.or_default(&given.refine),
        wave_modes: r.or_default(&given.wave_modes) as usize,
        liquid: r.or_default(&given.liquid),
        mesh_error: r.or_default(&given.mesh_error),
        gauges: places(r, &given.gauges, half, what),
        stations: places(r, &given.stations, height, "the height of the wall"),
        force_stations: force_stations(r, &given.force_stations, tank),
        snapshots: instants(r, &given.snapshots),
        tilt: given.tilt.given.as_ref().and_then(|_| r.optional(&given.tilt)),
        heave: heave(r, &given.heave, tank),
        ground_damping: r.or_default(&given.ground_damping),
        dashpots: given.damping.value().map_or_else(Vec::new, |d| dashpots(r, &d.dashpots, tank)),
        damping: match &given.damping.given {
            Some(damping) => damping_model(r, damping, ratios),
            None => {
                r.echo_default("analysis.damping", "modal", "the ratios of `damping`");
                DampingModel::Modal
            }
        },
        spectrum: response(r, given.spectrum.given.as_ref().and_then(|f| f.value.as_ref())),
        frequency: frequency(r, &given.frequency),
        rotation: None,
    }
}

/// The rotation of the base, from a file beside the tank file.
///
/// * `folder`: of the tank file
pub(super) fn rotation(r: &mut Resolver<'_>, given: Option<&Analysis>, folder: &Path) -> Option<Record> {
    let field = given?.quake_rotation.given.as_ref()?;
    let name = r.text(field)?;
    let bytes = load::load(&folder.join(&name)).map_err(|error| error.to_string());
    let read = bytes.and_then(|bytes| {
        let wrong = |found: String| format!("{name}: found {found}");
        Ok((rotation::read(&bytes, &field.path).map_err(wrong)?, load::sha256(&bytes)))
    });
    match read {
        Ok((record, sha256)) => {
            let count = record.acceleration.len();
            r.echo.push(InputValue {
                path: format!("{} (sha256 {}…)", field.path, &sha256[..16]),
                text: format!("{count} samples in steps of {} s, peak {:.4} rad/s2", record.dt, record.pga()),
                default: false,
                source: String::new(),
            });
            Some(record)
        }
        Err(message) => {
            r.faults.push(range_fault(Code::TableShape, field, &message, rotation::FORM));
            None
        }
    }
}

/// Inertia on the foot, of an unanchored cylinder alone.
fn heave(r: &mut Resolver<'_>, option: &Opt<Given<Heave>>, tank: Option<&Tank>) -> Option<Heave> {
    let field = option.given.as_ref()?;
    let given = field.value.as_ref()?;
    let refused = tank.and_then(|tank| match (tank.shape, tank.support, &tank.bottom) {
        (Shape::Cylinder { .. }, Support::Unanchored, Some(_)) => None,
        (Shape::Cylinder { .. }, Support::Unanchored, None) => {
            Some(("no foot lifts without a bottom plate", "a tank with `tank.bottom`"))
        }
        _ => Some(("only the foot of an unanchored cylinder lifts", "a cylinder with \"support\": \"unanchored\"")),
    });
    if let Some((message, allowed)) = refused {
        let fault = range_fault(Code::DoesNotApply, field, message, allowed);
        r.faults.push(fault.help("remove analysis.heave"));
    }
    given.resolve(r)
}

/// A list that only a cylinder may have, with faults where the tank is another, or the list too long.
///
/// * `what`: its items in a sentence, and counted
fn of_cylinder<'a, T>(
    r: &mut Resolver<'_>,
    option: &'a Opt<Vec<Field<T>>>,
    tank: Option<&Tank>,
    (what, items): (&str, &str),
) -> &'a [Field<T>] {
    let Some((field, list)) = option.given.as_ref().and_then(|f| Some((f, f.value.as_ref()?))) else { return &[] };
    if let Some(Shape::Rectangle { .. }) = tank.map(|t| t.shape) {
        let message = format!("{what} are for cylinders");
        let fault = range_fault(Code::DoesNotApply, field, &message, "a cylinder");
        r.faults.push(fault.help(format!("remove {}", field.path)));
    }
    r.at_most(field, items);
    list
}

/// Stations of internal forces, of a cylinder alone.
fn force_stations(
    r: &mut Resolver<'_>,
    option: &Opt<Vec<Field<Given<WallPlace>>>>,
    tank: Option<&Tank>,
) -> Vec<WallPlace> {
    let list = of_cylinder(r, option, tank, ("stations of internal forces", "stations"));
    let height = tank.map_or(f64::NAN, Tank::wall_height);
    let mut all: Vec<WallPlace> = Vec::new();
    for one in list {
        let Some(given) = &one.value else { continue };
        let Some(place) = given.resolve(r) else { continue };
        if place.z > height * (1.0 + 1e-9) {
            let allowed = format!("from 0 to {}, the height of the wall", like_field(&given.z, height));
            r.refuse(Code::OutOfRange, &given.z, "outside the tank", &allowed);
        }
        if all.iter().any(|o| o.z == place.z && o.degrees() == place.degrees()) {
            r.refuse(Code::Repeated, one, "two stations at one place", "different places");
        }
        all.push(place);
    }
    all
}

/// Places from 0 to a length of the tank (NaN if the tank is faulty: no upper limit).
fn places(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Length>>>, end: f64, what: &str) -> Vec<f64> {
    let mut all = Vec::new();
    let Some((field, list)) = option.given.as_ref().and_then(|f| Some((f, f.value.as_ref()?))) else { return all };
    r.at_most(field, "places");
    for place in list {
        let value = r.within(place, field.limits);
        if value > end * (1.0 + 1e-9) {
            let allowed = format!("from 0 to {}, {what}", like_field(place, end));
            r.refuse(Code::OutOfRange, place, "outside the tank", &allowed);
        }
        all.push(value);
    }
    all
}

fn damping_model(r: &mut Resolver<'_>, field: &Field<AnalysisDamping>, ratios: case::Damping) -> DampingModel {
    let Some(model) = &field.value else { return DampingModel::Modal };
    let found = match (&model.by_group.given, &model.caughey.given, &model.rayleigh.given, &model.coefficients.given) {
        (Some(one), None, None, None) => one.value.as_ref().map(|group| {
            let (wall, sloshing) = by_group(r, group, ratios);
            DampingModel::ByGroup { wall, sloshing }
        }),
        (None, Some(one), None, None) => one.value.as_ref().and_then(|pairs| caughey(r, one, pairs)),
        (None, None, Some(one), None) => one.value.as_ref().map(|given| {
            let (first, second, allow_negative) = rayleigh(r, given);
            DampingModel::Rayleigh { first, second, allow_negative }
        }),
        (None, None, None, Some(one)) => one
            .value
            .as_ref()
            .map(|c| DampingModel::Coefficients { mass: r.number(&c.mass), stiffness: r.number(&c.stiffness) }),
        (None, None, None, None) if model.dashpots.given.is_some() => Some(DampingModel::Modal),
        _ => {
            let message = "not exactly one damping model";
            let allowed = "one of by_group, caughey, rayleigh and coefficients";
            let fault = range_fault(Code::Exclusive, field, message, allowed);
            r.faults.push(fault.help("remove analysis.damping to use the modal ratios of `damping`"));
            None
        }
    };
    found.unwrap_or(DampingModel::Modal)
}

/// Rings of dashpots, of a cylinder alone.
fn dashpots(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Given<Dashpots>>>>, tank: Option<&Tank>) -> Vec<Dashpots> {
    let list = of_cylinder(r, option, tank, ("dashpots around the wall", "rings of dashpots"));
    let height = tank.map_or(f64::NAN, Tank::wall_height);
    let mut all = Vec::new();
    for given in list.iter().filter_map(|one| one.value.as_ref()) {
        let Some(ring) = given.resolve(r) else { continue };
        if ring.z > height * (1.0 + 1e-9) {
            let allowed = format!("above 0 to {}, the height of the wall", like_field(&given.z, height));
            r.refuse(Code::OutOfRange, &given.z, "outside the tank", &allowed);
        }
        all.push(ring);
    }
    all
}

/// The pairs of Caughey's series, two to six at different frequencies.
fn caughey(r: &mut Resolver<'_>, field: &Field<Vec<Field<RatioAt>>>, given: &[Field<RatioAt>]) -> Option<DampingModel> {
    let mut pairs: Vec<(f64, f64)> = Vec::new();
    for one in given {
        let pair = ratio_at(r, one);
        if pairs.iter().any(|(omega, _)| (omega - pair.0).abs() <= 1e-6 * pair.0) {
            let message = "two pairs have the same frequency";
            let allowed = "different frequencies";
            r.refuse(Code::Repeated, one, message, allowed);
        }
        pairs.push(pair);
    }
    r.sized(field, "pairs").then(|| DampingModel::Caughey(CaugheyPairs::new(&pairs)))
}
