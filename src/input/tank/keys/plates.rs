//! The thickest plate of each material: strengths of steel depend on it.

use std::collections::BTreeMap;

use super::file::TankFile;
use crate::input::tank::read::{Field, Opt};
use crate::input::tank::resolver::Si;
use crate::input::tank::values::Length;

/// Largest nominal thickness [m] by the name of the material.
///
/// Courses, layers and bottom plates, as built: a product standard counts the thickness before corrosion.
pub(super) fn plates(file: &TankFile) -> BTreeMap<&str, f64> {
    let mut plates = BTreeMap::new();
    let Some(tank) = &file.tank.value else { return plates };
    for course in tank.courses.value.iter().flatten().filter_map(|c| c.value.as_ref()) {
        if let Some(material) = &course.material.given {
            add(&mut plates, material, of(&course.thickness));
        }
        for layer in course.layers.value().into_iter().flatten().filter_map(|l| l.value.as_ref()) {
            add(&mut plates, &layer.material, layer.thickness.value.map(Si::si));
        }
    }
    for ring in tank.rings.value().into_iter().flatten().filter_map(|ring| ring.value.as_ref()) {
        add(&mut plates, &ring.material, of(&ring.thickness));
    }
    if let Some(bottom) = tank.bottom.value() {
        add(&mut plates, &bottom.material, bottom.thickness.value.map(Si::si));
        add(&mut plates, &bottom.material, of(&bottom.annular_thickness));
    }
    plates
}

fn of(option: &Opt<Length>) -> Option<f64> {
    option.value().map(|length| length.si())
}

fn add<'f>(plates: &mut BTreeMap<&'f str, f64>, material: &'f Field<String>, thickness: Option<f64>) {
    if let (Some(name), Some(thickness)) = (&material.value, thickness) {
        let thickest = plates.entry(name).or_insert(0.0);
        *thickest = thickest.max(thickness);
    }
}
