//! Where the file says what an engine may object to.

use std::collections::BTreeMap;

use super::range_fault;
use crate::input::diagnostic::Fault;
use crate::input::tank::behaviour::Behaviour;
use crate::input::tank::read::Field;
use crate::input::tank::schema;
use tank::refusal::{Place, Refusal};

/// Places in a file.
#[derive(Clone, Debug, Default)]
pub struct Places(BTreeMap<Place, Field<()>>);

impl Places {
    /// Of a file.
    pub(super) fn of(file: &schema::TankFile) -> Places {
        let mut all = BTreeMap::new();
        if let Some(tank) = &file.tank.value {
            all.insert(Place::Shape, tank.shape.place());
            all.insert(Place::Support, tank.support.place());
            if let Some(roof) = &tank.roof {
                let mass = roof.value.as_ref().map(|r| r.mass.place());
                all.insert(Place::Roof, mass.unwrap_or_else(|| roof.place()));
            }
            for (index, course) in tank.courses.value.iter().flatten().enumerate() {
                let layers = course.value.as_ref().and_then(|c| c.layers.as_ref()).map(Field::place);
                all.insert(Place::Course(index), layers.unwrap_or_else(|| course.place()));
            }
        }
        for (name, material) in file.materials.value.iter().flat_map(|named| &named.0) {
            let given = material.value.as_ref().and_then(|m| m.behaviour.as_ref());
            let kinds = match given.and_then(|f| f.value.as_ref()) {
                Some(Behaviour::Kinds(kinds)) => Some(kinds),
                _ => None,
            };
            // A grade has the behaviour of concrete without saying so.
            let whole = given.map_or_else(|| material.place(), Field::place);
            let concrete = kinds.and_then(|k| k.concrete.as_ref());
            let law = concrete
                .and_then(|c| c.value.as_ref())
                .and_then(|c| c.law.as_ref())
                .map(Field::place);
            let concrete = concrete.map_or_else(|| whole.clone(), Field::place);
            let interlayer = kinds.and_then(|k| k.interlayer.as_ref()).map(Field::place);
            all.insert(Place::Law(name.clone()), law.unwrap_or_else(|| concrete.clone()));
            all.insert(Place::Concrete(name.clone()), concrete);
            all.insert(Place::Interlayer(name.clone()), interlayer.unwrap_or(whole));
        }
        let elements = file
            .analysis
            .as_ref()
            .and_then(|f| f.value.as_ref())
            .and_then(|a| a.nonlinear.as_ref())
            .and_then(|f| f.value.as_ref())
            .and_then(|n| n.elements.as_ref())
            .and_then(|f| f.value.as_ref());
        if let Some(elements) = elements {
            all.insert(Place::Rows, elements.height.place());
            if let Some(circumference) = &elements.circumference {
                all.insert(Place::Sectors, circumference.place());
            }
        }
        Places(all)
    }

    /// A refusal of an engine as a fault of the file.
    pub fn fault(&self, refusal: &Refusal) -> Fault {
        let mut fault = match self.0.get(&refusal.place) {
            Some(place) => range_fault(place, &refusal.message, &refusal.allowed),
            None => Fault::new(&refusal.message).allowed(&refusal.allowed),
        };
        if !refusal.found.is_empty() {
            fault = fault.found(&refusal.found);
        }
        if !refusal.help.is_empty() {
            fault = fault.help(&refusal.help);
        }
        fault
    }
}
