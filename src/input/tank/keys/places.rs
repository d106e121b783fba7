//! Places of the file that an engine may reject.

use std::collections::BTreeMap;

use tank::refusal::Place;

use super::file::TankFile;
use super::materials::laws::Behaviour;
use crate::input::tank::places::Places;
use crate::input::tank::read::Field;

/// Collects the places.
pub(super) fn of(file: &TankFile) -> Places {
    let mut all = BTreeMap::new();
    if let Some(tank) = &file.tank.value {
        all.insert(Place::Shape, tank.shape.place());
        all.insert(Place::Support, tank.support.place());
        if let Some(joint) = tank.wall_base.place() {
            all.insert(Place::WallBase, joint);
        }
        if let Some(staging) = tank.staging.place() {
            all.insert(Place::Staging, staging);
        }
        if let Some(roof) = &tank.roof.given {
            let mass = roof.value.as_ref().map(|r| r.mass.place());
            all.insert(Place::Roof, mass.unwrap_or_else(|| roof.place()));
        }
        for (index, course) in tank.courses.value.iter().flatten().enumerate() {
            let layers = course.value.as_ref().and_then(|c| c.layers.place());
            all.insert(Place::Course(index), layers.unwrap_or_else(|| course.place()));
        }
    }
    for (name, material) in file.materials.value.iter().flat_map(|named| &named.0) {
        let given = material.value.as_ref().and_then(|m| m.behaviour.given.as_ref());
        let kinds = match given.and_then(|f| f.value.as_ref()) {
            Some(Behaviour::Kinds(kinds)) => Some(kinds),
            _ => None,
        };
        // A concrete grade implies the behaviour of concrete.
        let whole = given.map_or_else(|| material.place(), Field::place);
        let law = kinds.and_then(|k| k.concrete.value()).and_then(|concrete| concrete.law.place());
        let concrete = kinds.and_then(|k| k.concrete.place()).unwrap_or_else(|| whole.clone());
        let interlayer = kinds.and_then(|k| k.interlayer.place());
        let volume_change = material.value.as_ref().and_then(|m| m.volume_change.place());
        all.insert(Place::VolumeChange(name.clone()), volume_change.unwrap_or_else(|| material.place()));
        all.insert(Place::Law(name.clone()), law.unwrap_or_else(|| concrete.clone()));
        all.insert(Place::Concrete(name.clone()), concrete);
        all.insert(Place::Interlayer(name.clone()), interlayer.unwrap_or(whole));
    }
    let nonlinear = file.analysis.value().and_then(|a| a.nonlinear.value());
    if let Some(elements) = nonlinear.and_then(|n| n.elements.value()) {
        all.insert(Place::Rows, elements.height.place());
        if let Some(circumference) = elements.circumference.place() {
            all.insert(Place::Sectors, circumference);
        }
    }
    if let Some(temperature) = nonlinear.and_then(|n| n.temperature.place()) {
        all.insert(Place::Temperature, temperature);
    }
    let solid = file.analysis.value().and_then(|a| a.solid.value());
    if let Some(liquid) = solid.and_then(|s| s.liquid.place()) {
        all.insert(Place::Liquid, liquid);
    }
    if let Some(penalty) = solid.and_then(|s| s.rotation_penalty.place()) {
        all.insert(Place::RotationPenalty, penalty);
    }
    if let Some(imperfections) = file.analysis.value().and_then(|a| a.imperfections.place()) {
        all.insert(Place::Imperfections, imperfections);
    }
    if let Some(rotation) = file.analysis.value().and_then(|a| a.quake_rotation.place()) {
        all.insert(Place::Rotation, rotation);
    }
    let damping = file.analysis.value().and_then(|a| a.damping.value());
    if let Some(dashpots) = damping.and_then(|d| d.dashpots.place()) {
        all.insert(Place::Dashpots, dashpots);
    }
    Places::new(all)
}
