//! Limit states of API 650 annex E, and whether each applies.

use super::super::basis::{Basis, is_aluminium};
use super::EDITION;
use tank::Support;
use tank::assessment::{LimitState, Requirement};
use tank::case::Case;

/// Hoop stress of the shell.
pub(super) const HOOP: &str = "hoop_stress";
/// Compression of the bottom course.
pub(super) const COMPRESSION: &str = "shell_compression";
/// Compression of the courses above the bottom course.
pub(super) const UPPER_COMPRESSION: &str = "upper_compression";
/// Anchorage ratio of a self-anchored tank.
pub(super) const ANCHORAGE: &str = "anchorage_ratio";
/// Width of the annular plate.
pub(super) const ANNULUS: &str = "annulus_width";
/// Tension of the anchors.
pub(super) const ANCHORS: &str = "anchor_tension";
/// Attachment of the anchors.
pub(super) const ATTACHMENT: &str = "anchor_attachment";
/// Spacing of the anchors.
pub(super) const SPACING: &str = "anchor_spacing";
/// Sliding.
pub(super) const SLIDING: &str = "sliding";
/// Overturning of the foundation.
pub(super) const FOUNDATION: &str = "foundation";
/// Freeboard.
pub(super) const FREEBOARD: &str = "freeboard";
/// Displacements of the pipes.
pub(super) const PIPING: &str = "piping";
/// Hoop stress with the design pressure.
pub(super) const PRESSURE: &str = "pressure_hoop";

/// Least Young's modulus of carbon steel [Pa]: the allowable compression of E.6.2.2 is written for steel and does not contain the
/// modulus, so a softer wall would be checked on the unsafe side.
const STEEL: f64 = 180e9;

/// Whether every course is a plate of steel.
pub(crate) fn carbon_steel(case: &Case) -> bool {
    let mut courses = case.tank.courses.iter();
    courses.all(|c| c.layers.is_empty() && c.material.youngs_modulus >= STEEL)
}

/// Whether every course is steel or aluminium, and some are aluminium.
pub(crate) fn aluminium(case: &Case) -> bool {
    let mut courses = case.tank.courses.iter();
    !carbon_steel(case)
        && courses.all(|c| c.layers.is_empty() && (c.material.youngs_modulus >= STEEL || is_aluminium(&c.material)))
}

/// All limit states of a case; none outside the scope of the standard.
pub(super) fn all(case: &Case) -> Vec<LimitState> {
    if Basis::new(case, EDITION).is_err() {
        return Vec::new();
    }
    let anchored = case.tank.support == Support::Anchored;
    let mechanical = |required: Requirement| match anchored {
        true => required,
        false => Requirement::NotApplicable("the tank is self-anchored".into()),
    };
    let self_anchored = |required: Requirement| match anchored {
        true => Requirement::NotApplicable("the tank is mechanically anchored".into()),
        false => required,
    };
    let material = match (carbon_steel(case), aluminium(case)) {
        (true, _) => Requirement::NotApplicable("the wall is steel".into()),
        (false, true) => Requirement::NotApplicable(
            "the wall is aluminium: the allowable compression is scaled with the modulus; the strengths given must be those of annex AL"
                .into(),
        ),
        (false, false) => Requirement::NotImplemented,
    };
    let pressed = case.tank.pressure.internal > 0.0 || case.site.api650.is_some_and(|site| site.design_pressure > 0.0);
    let pressure = match pressed {
        true => Requirement::Required,
        false => Requirement::NotApplicable("there is no design pressure".into()),
    };
    use Requirement::Required;
    let upper = match case.tank.courses.len() {
        1 => Requirement::NotApplicable("the shell has one course".into()),
        _ => Required,
    };
    [
        (HOOP, "Hoop stress of the shell", "E.6.2.4", Required),
        (COMPRESSION, "Compression of the bottom course", "E.6.2.2", Required),
        (UPPER_COMPRESSION, "Compression of the courses above", "E.6.2.2", upper),
        (ANCHORAGE, "Anchorage ratio J", "E.6.2.1.1", self_anchored(Required)),
        (
            ANNULUS,
            "Width of the annular plate",
            "E.6.2.1.1.2",
            self_anchored(Required),
        ),
        (ANCHORS, "Tension of the anchors", "E.6.2.1.2", mechanical(Required)),
        (
            ATTACHMENT,
            "Attachment of the anchors, 3 P_AB",
            "E.6.2.1.2",
            mechanical(Required),
        ),
        (SPACING, "Spacing of the anchors", "5.12.3", mechanical(Required)),
        (SLIDING, "Sliding on the foundation", "E.7.6", self_anchored(Required)),
        (FOUNDATION, "Overturning of the foundation", "E.6.2.3", Required),
        (FREEBOARD, "Freeboard", "E.7.2", Required),
        (PIPING, "Flexibility of the piping", "E.7.3", Required),
        (
            "wall_material",
            "Wall of another material than carbon steel",
            "annex AL",
            material,
        ),
        (PRESSURE, "Hoop stress with the design pressure", "E.6.2.4", pressure),
    ]
    .into_iter()
    .map(|(id, name, clause, requirement)| LimitState {
        id,
        name,
        clause: format!("{EDITION} {clause}"),
        requirement,
    })
    .collect()
}
