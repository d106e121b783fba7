//! Corroded walls and plates: what counts as built, and what counts net.
//!
//! Stresses and resistances use the thickness less the corrosion; masses, weights, stiffnesses and periods the thickness as built. An
//! allowance may not be used up yet, so the inertia is that of the whole wall; where its weight holds the tank down, the whole weight is
//! not on the safe side, and the assumption of the sheet says so.

use tank::Tank;
use tank::units::Dimension::Length;

use crate::sheet::Sheet;

/// The choice, for the assumptions of a sheet.
pub(crate) const ASSUMPTION: &str = "Stresses and resistances use the thickness less the corrosion; masses, weights (also those that hold \
                                     the tank down) and periods the thickness as built.";

/// Lines of the net thickness of each corroded course, and of the bottom plate; none where nothing corrodes.
///
/// * `symbol`: of a wall thickness ("t")
pub(crate) fn lines(sheet: &mut Sheet, tank: &Tank, symbol: &str, clause: &str) {
    if !tank.corrodes() {
        return;
    }
    sheet.section("Corrosion");
    let courses = tank.courses.iter().enumerate().map(|(index, course)| {
        let number = index + 1;
        let (name, path) = (format!("course {number}"), format!("tank.courses[{index}]"));
        (number.to_string(), name, path, course.thickness, course.corrosion)
    });
    let bottom = tank.bottom.iter().map(|plate| {
        let (name, path) = ("the bottom plate".to_string(), "tank.bottom".to_string());
        ("b".to_string(), name, path, plate.thickness, plate.corrosion)
    });
    for (index, name, path, thickness, corrosion) in courses.chain(bottom).filter(|part| part.4 > 0.0) {
        let (built, lost) = (format!("{symbol}_n{index}"), format!("c_{index}"));
        sheet.input(&built, &format!("thickness of {name} as built"), thickness, Length, &path);
        sheet.input(&lost, &format!("corrosion of {name}"), corrosion, Length, &path);
        let net = format!("net thickness of {name}");
        let formula = format!("{built} - {lost}");
        sheet.calc(&format!("{symbol}_{index}"), &net, &formula, Length, clause);
    }
}

#[cfg(test)]
mod tests;
