//! What the engines assume of stiffening rings and attachments, in words.

use tank::Tank;

const RINGS: &str = "Stiffening rings resist extension and bending in their plane, with their axes in the surface of the wall; torsion, bending \
    out of the plane and eccentricity are left out.";
const ELASTIC_RINGS: &str = "Stiffening rings are linear elastic springs between the nodes of the wall; that a ring turns as a whole is left out.";
const ATTACHMENTS: &str = "Ladders, platforms and nozzles are masses at their heights, spread evenly around the wall.";

/// The assumptions, one sentence each; `nonlinear` engines say what their rings do not follow.
pub(crate) fn assumptions(tank: &Tank, nonlinear: bool) -> Vec<String> {
    let rings = !tank.rings.is_empty();
    let all = [(rings, RINGS), (rings && nonlinear, ELASTIC_RINGS), (!tank.attachments.is_empty(), ATTACHMENTS)];
    all.into_iter().filter(|(there, _)| *there).map(|(_, text)| text.to_owned()).collect()
}
