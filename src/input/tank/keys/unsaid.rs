//! Parts of the tank that a file leaves unsaid, or says that there are none of.

use ::tank::Support;
use ::tank::check::TankPart;

use super::tank::Tank;
use crate::input::tank::read::Field;

/// Parts of which nothing is said, and those of which the file says that there are none. An unanchored tank has no anchors to speak of, a wall
/// that is monolithic with its floor neither anchors nor a bottom plate, and a tank on a staging no foundation of its own.
pub(super) fn unsaid(field: &Field<Tank>, resolved: Option<&::tank::Tank>) -> [Vec<TankPart>; 2] {
    let Some(t) = &field.value else { return Default::default() };
    let anchored = t.support.value == Some(Support::Anchored);
    let elevated = t.staging.given.is_some();
    let monolithic = resolved.is_some_and(::tank::Tank::is_monolithic);
    let said = [
        (TankPart::Roof, t.roof.given.is_some(), t.roof.none.is_some()),
        (TankPart::Foundation, t.foundation.given.is_some() || elevated, t.foundation.none.is_some()),
        (TankPart::Bottom, t.bottom.given.is_some() || monolithic, t.bottom.none.is_some()),
        (TankPart::Anchors, t.anchors.given.is_some() || !anchored || monolithic, t.anchors.none.is_some()),
        (TankPart::Pipes, t.pipes.given.is_some(), t.pipes.none.is_some()),
    ];
    let unstated = said.iter().filter(|(_, given, none)| !given && !none);
    let without = said.iter().filter(|(_, _, none)| *none);
    [unstated.map(|(part, ..)| *part).collect(), without.map(|(part, ..)| *part).collect()]
}
