//! What the engines assume of stiffening rings, attachments and the rim under a roof.

use tank::{RimSupport, Shape, Tank};

const RINGS: &str = "Stiffening rings resist extension and bending in their plane, with their axes in the surface of the wall; torsion, bending \
    out of the plane and eccentricity are left out.";
const ELASTIC_RINGS: &str = "Stiffening rings are linear elastic springs between the nodes of the wall; that a ring turns as a whole is left out.";
const ATTACHMENTS: &str = "Ladders, platforms and nozzles are masses at their heights, spread evenly around the wall.";

const ROUND_RIM: &str = "The roof keeps the rim round, as a disc that is rigid in its plane and moves and tilts with the wall; along the axis it leaves \
    the rim free.";
/// Stiffness of a round rim by angle, over E t of the wall there: with ten times as much, uplift and toe of five tanks that are pushed change by
/// less than 10⁻⁴.
const ROUND: f64 = 100.0;

/// Stiffness by angle of a rim that the roof keeps round [N/m]; none where it does not.
pub(crate) fn round_rim(tank: &Tank) -> Option<f64> {
    let top = tank.courses.last()?;
    let round = tank.roof.holds == RimSupport::Round && matches!(tank.shape, Shape::Cylinder { .. });
    round.then_some(ROUND * top.material.youngs_modulus * top.thickness)
}

/// The assumptions, one sentence each; `nonlinear` engines say what their rings do not follow.
pub(crate) fn assumptions(tank: &Tank, nonlinear: bool) -> Vec<String> {
    let rings = !tank.rings.is_empty();
    let all = [
        (round_rim(tank).is_some(), ROUND_RIM),
        (rings, RINGS),
        (rings && nonlinear, ELASTIC_RINGS),
        (!tank.attachments.is_empty(), ATTACHMENTS),
    ];
    all.into_iter().filter(|(there, _)| *there).map(|(_, text)| text.to_owned()).collect()
}
