//! Section of a course across one direction of bars.

use crate::en1992::section::{Bars, Section};
use tank::case::ConcreteOptions;
use tank::{BarDirection, Behaviour, Course, LayerKind, Material};

/// What is missing for a check: the reason and the path in `tank.json`, if input can supply it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Missing {
    pub reason: String,
    pub input: Option<String>,
}

fn missing(input: String) -> Missing {
    Missing { reason: format!("`{input}` is missing"), input: Some(input) }
}

/// Material of the concrete of a course, and its characteristic strength where it is known [Pa].
pub(super) fn concrete(course: &Course) -> (&Material, Option<f64>) {
    let material = match course.layers.as_slice() {
        [layer] => &layer.material,
        _ => &course.material,
    };
    let strength = match material.behaviour {
        Behaviour::Concrete(concrete) => concrete.characteristic_strength,
        _ => None,
    };
    (material, strength)
}

/// The section of the course number `index` (from 0).
pub(super) fn of(
    course: &Course,
    index: usize,
    direction: BarDirection,
    options: &ConcreteOptions,
) -> Result<Section, Missing> {
    let bars = match course.layers.as_slice() {
        [] => &[],
        [layer] if layer.kind == LayerKind::Shell => layer.reinforcement.as_slice(),
        _ => {
            return Err(Missing {
                reason: format!("not implemented: wall of several layers (course {})", index + 1),
                input: None,
            });
        }
    };
    let (material, strength) = concrete(course);
    let path = format!("materials.{}", material.name);
    let Behaviour::Concrete(_) = material.behaviour else { return Err(missing(format!("{path}.grade"))) };
    let Some(strength) = strength else {
        return Err(missing(format!("{path}.behaviour.concrete.characteristic_strength")));
    };
    let mut section = Section {
        thickness: course.total_thickness(),
        strength,
        modulus: material.youngs_modulus,
        bars: Vec::new(),
        factors: (options.gamma_c, options.gamma_s),
    };
    for layer in bars.iter().filter(|b| b.direction == direction) {
        let Some(yield_strength) = layer.material.yield_strength else {
            return Err(missing(format!("materials.{}.yield_strength", layer.material.name)));
        };
        section.bars.push(Bars {
            depth: layer.depth,
            area: layer.area,
            diameter: layer.diameter,
            yield_strength,
            modulus: layer.material.youngs_modulus,
        });
    }
    if section.bars.is_empty() {
        let what = match direction {
            BarDirection::Hoop => "horizontal",
            BarDirection::Vertical => "vertical",
        };
        let input = reinforcement(course, index);
        return Err(Missing { reason: format!("no {what} bars are given: `{input}` is missing"), input: Some(input) });
    }
    Ok(section)
}

/// Path of the bars of a course.
pub(super) fn reinforcement(course: &Course, index: usize) -> String {
    match course.layers.len() {
        // A course of one material with bars is stored as one layer.
        0 | 1 => format!("tank.courses[{index}].reinforcement"),
        _ => format!("tank.courses[{index}].layers"),
    }
}
