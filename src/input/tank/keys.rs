//! The keys of `tank.json`: each file declares those of one section and resolves them to values in SI.
//!
//! Keys and meaning are a contract: extend freely, do not rename.

mod accepted;
mod after_record;
mod bar_layout;
mod bars;
mod base;
mod carried;
mod contradictions;
mod corrosion;
mod cross;
mod damping;
mod details;
mod file;
mod frequency;
mod grades;
mod ids;
mod imperfections;
mod instant;
mod isolators;
mod joint;
mod linear;
mod materials;
mod named;
mod nonlinear;
mod places;
mod plates;
mod plausible;
mod procedures;
pub(in crate::input) mod project;
mod rayleigh;
mod record;
mod reported;
mod response;
mod roof;
mod site;
mod solid;
mod spectrum;
mod staging;
mod tank;
mod temperature;
mod unsaid;
mod unusual;
mod wall;

use std::path::Path;

use ::tank::case::Case;
use ::tank::check::Decision;
use codes::time_history::snow_share;

pub(super) use file::TankFile;
pub use solid::solid_defaults;

use crate::input::diagnostic::{Faults, Source};
use crate::input::tank::file::TankFile as Resolved;
use crate::input::tank::resolver::Resolver;

/// Resolves the file; returns `None` or adds a fault if it does not define a case.
///
/// * `folder`: of the file, from which it names others
pub(super) fn resolve(file: &TankFile, folder: &Path, faults: &mut Faults) -> Option<Resolved> {
    let mut r = Resolver::new(faults);
    let name = r.text(&file.name);
    let project = project::project(&mut r, &file.project);
    if let Some(notes) = &file.notes.given {
        r.echo_given(notes);
    }
    let gravity = r.or_default(&file.gravity);
    let materials = materials::materials(&mut r, &file.materials, &plates::plates(file));
    let tank = tank::tank(&mut r, &file.tank, &materials);
    let liquid = file.liquid.value.as_ref().and_then(|given| given.resolve(&mut r));
    cross::checks(&mut r, file, tank.as_ref(), liquid);
    plausible::tank(&mut r, file, tank.as_ref(), liquid);
    let used = cross::used(file);
    cross::unused(&mut r, file, &used);
    // Checks of the courses above see them bare.
    let mut tank = tank.map(|tank| carried::insulated(&mut r, tank));
    let temperature = temperature::design(&mut r, file, &used, &materials);
    if let Some(tank) = &mut tank {
        tank.details.design_temperature = temperature;
    }
    let record = record::record(&mut r, &file.record);
    let damping = damping::damping(&mut r, &file.damping, tank.as_ref());
    let site = site::site(&mut r, &file.site, tank.as_ref(), folder);
    let (procedures, run) = procedures::procedures(&mut r, &file.procedures);
    let [unstated, without] = unsaid::unsaid(&file.tank, tank.as_ref());
    let decision = Decision {
        decide: procedures::deciding(&mut r, &file.procedures),
        accepted: accepted::accepted(&mut r, &file.accepted),
        unstated,
        without,
    };
    let analysis = file.analysis.value();
    let mut fe = linear::analysis(&mut r, analysis, tank.as_ref(), damping);
    fe.rotation = linear::rotation(&mut r, analysis, folder);
    let mut solid = solid::solid(&mut r, analysis.and_then(|a| a.solid.value()));
    let mut nonlinear =
        nonlinear::nonlinear(&mut r, analysis.and_then(|a| a.nonlinear.value()), tank.as_ref(), damping);
    let imperfect = imperfections::imperfections(&mut r, analysis.map(|a| &a.imperfections), tank.as_ref(), folder);
    solid.imperfections.clone_from(&imperfect);
    nonlinear.imperfections = imperfect;
    nonlinear.rotation_penalty = solid.rotation_penalty;
    solid.initial_stress = analysis.and_then(|a| r.optional(&a.initial_stress));
    let measured = reported::measured(&mut r, &file.measured);
    let published = reported::published(&mut r, &file.published);
    let case = Case {
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
    };
    // Each procedure counts the share of its own code.
    let case = case.with_snow(snow_share(&case, &decision.decide)).into_owned();
    contradictions::warn(&mut r, &case, &decision.without);
    unusual::warn(&mut r, &case, &fe, &nonlinear);
    bar_layout::warn(&mut r, &case.tank);
    let (echo, remarks, warnings) = (r.echo, r.remarks, r.warnings);
    Some(Resolved {
        case,
        project,
        record,
        echo,
        procedures: run,
        decision,
        fe,
        solid,
        nonlinear,
        remarks,
        warnings,
        sha256: String::new(),
        source: Source::new("", ""),
        places: places::of(file),
    })
}
