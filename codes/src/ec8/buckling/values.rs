//! The formulas as values, for the tests.

use super::*;

/// Limit of elastic buckling under axial compression with interior pressure, A.10.2 [Pa].
///
/// * `youngs_modulus`: E [Pa]; `yield_strength`: f_y [Pa]; `thickness`: s, `radius`: R [m]
/// * `pressure`: smallest interior pressure of the combination [Pa]; suction counts as zero
/// * `quality`: a = 1, 1.5 or 2.5
pub(crate) fn elastic(
    youngs_modulus: f64,
    yield_strength: f64,
    thickness: f64,
    radius: f64,
    pressure: f64,
    quality: f64,
) -> f64 {
    let wall = Wall { youngs_modulus, yield_strength, thickness, radius, quality };
    limit(elastic_lines, &wall, pressure)
}

/// Limit of elastic-plastic collapse ("elephant's foot"), A.10.3 [Pa]; zero where the hoop stress reaches f_y.
///
/// * `pressure`: largest interior pressure of the combination [Pa], suction counts as zero; the rest as in [`elastic`]
pub(crate) fn elastic_plastic(
    youngs_modulus: f64,
    yield_strength: f64,
    thickness: f64,
    radius: f64,
    pressure: f64,
) -> f64 {
    let wall = Wall { youngs_modulus, yield_strength, thickness, radius, quality: 1.0 };
    limit(collapse_lines, &wall, pressure)
}
