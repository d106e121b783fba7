//! Limit states of EN 1998-4 for tanks on the ground, and whether each applies.
//!
//! The ultimate limit state of EN 1998-4:2006 2.1.2 and 4.5 asks for the wall (hoop tension, stability), the base (anchors, uplift,
//! sliding, overturning, bearing of the ground), the liquid surface, and the pipes; 2.1.3 for damage limitation. Walls that are not
//! metal shells are designed by EN 1992. Clauses are recalled, not copied; `docs/theory/eurocode8.md` says which were compared.

use super::anchor_layout;
use super::demand::Edition;
use crate::api650::edition2020::limit_states::snow;
use tank::assessment::{LimitState, Requirement};
use tank::case::{Case, GroundType};
use tank::{Family, Shape, Support};

/// Freeboard.
pub(super) const FREEBOARD: &str = "freeboard";
/// Hoop tension of a metal wall.
pub(super) const HOOP: &str = "hoop_yield";
/// Elastic buckling of a metal wall under axial compression.
pub(super) const ELASTIC_BUCKLING: &str = "buckling_elastic";
/// Elastic-plastic collapse at the base (elephant's foot).
pub(super) const ELEPHANT_FOOT: &str = "buckling_elastic_plastic";
/// Tension of the anchors.
pub(super) const ANCHORS: &str = "anchorage";
/// Overturning of an unanchored tank.
pub(super) const OVERTURNING: &str = "overturning";

/// Uplift of the bottom plate.
pub(super) const UPLIFT: &str = "uplift";

/// Bearing of the ground.
pub(super) const BEARING: &str = "bearing";

/// Differential displacement of pipes.
pub(super) const PIPES: &str = "pipes";

/// Sliding on the foundation.
pub(super) const SLIDING: &str = "sliding";

/// Damage limitation.
pub(super) const DAMAGE: &str = "damage_limitation";

/// Tension and bending of a wall that is not a metal shell.
pub(super) const WALL_BENDING: &str = "wall_tension_and_bending";
/// Shear of such a wall.
pub(super) const WALL_SHEAR: &str = "wall_shear";
/// Number of the anchors.
pub(super) const ANCHOR_COUNT: &str = "anchor_count";
/// Spacing of the anchors.
pub(super) const ANCHOR_SPACING: &str = "anchor_spacing";
/// A box shaken along its breadth.
pub(super) const OTHER_DIRECTION: &str = "other_direction";
/// Crack width of a wall of concrete.
pub(super) const CRACKS: &str = "crack_width";

/// All limit states of a case.
pub(super) fn all(case: &Case, edition: Edition) -> Vec<LimitState> {
    let cylinder = matches!(case.tank.shape, Shape::Cylinder { .. });
    let metal = case.tank.is_metal();
    let shell = cylinder && metal;
    let anchored = case.tank.support == Support::Anchored;
    let mut states = Vec::new();
    let mut add = |id, name, clause: String, requirement| {
        states.push(LimitState {
            id,
            name,
            clause,
            requirement,
        });
    };
    let metal_shells = |required: Requirement| match (cylinder, metal) {
        (true, true) => required,
        (false, _) => {
            Requirement::NotApplicable("the walls of a box bend as plates; the clause is for cylinders".into())
        }
        (true, false) => Requirement::NotApplicable("the clause is for metal shells; the wall is not metal".into()),
    };
    let plates = |required: Requirement| match shell {
        true => Requirement::NotApplicable("the wall is a metal shell and carries membrane forces".into()),
        false => required,
    };
    add(FREEBOARD, "Freeboard", edition.clause("2.1.4"), Requirement::Required);
    let hoop = metal_shells(Requirement::Required);
    add(HOOP, "Hoop tension of the wall", edition.clause("10.3"), hoop);
    let buckling = metal_shells(Requirement::Required);
    add(
        ELASTIC_BUCKLING,
        "Elastic buckling of the wall",
        edition.clause("10.2"),
        buckling.clone(),
    );
    add(
        ELEPHANT_FOOT,
        "Elastic-plastic collapse of the wall",
        edition.clause("10.3"),
        buckling,
    );
    let resistance = plates(Requirement::Required);
    // `wall_material` is open if the wall is neither metal nor concrete.
    let foreign = case.tank.wall_materials().any(|m| {
        let known = m.family.is_some_and(|family| family != Family::Concrete);
        known && !m.is_metal()
    });
    let designed = |required: Requirement| match foreign {
        true => Requirement::NotApplicable("the wall is neither metal nor concrete: `wall_material`".into()),
        false => required,
    };
    let resistance = designed(resistance);
    let concrete = |required: Requirement| match (cylinder, metal) {
        (false, true) => Requirement::NotApplicable("the wall is of metal; the clause is for concrete".into()),
        _ => designed(plates(required)),
    };
    let name = "Tension and bending of the wall";
    add(WALL_BENDING, name, "EN 1992-1-1:2004 6.1".into(), resistance);
    for (id, name, clause) in [
        (WALL_SHEAR, "Shear of the wall", "EN 1992-1-1:2004 6.2.2"),
        (
            CRACKS,
            "Crack width (leak tightness)",
            "EN 1992-1-1:2004 7.3.4, EN 1992-3:2006 7.3.1",
        ),
    ] {
        add(id, name, clause.into(), concrete(Requirement::Required));
    }
    let pulls = match anchored {
        true => Requirement::Required,
        false => Requirement::NotApplicable("the tank is unanchored".into()),
    };
    add(
        ANCHORS,
        "Tension of the anchors",
        edition.main("4.5.1.3"),
        pulls.clone(),
    );
    for (id, name, clause) in [
        (ANCHOR_COUNT, "Number of the anchors", anchor_layout::COUNT),
        (ANCHOR_SPACING, "Spacing of the anchors", anchor_layout::SPACING),
    ] {
        add(id, name, clause.into(), pulls.clone());
    }
    let lifts = |required: Requirement| match anchored {
        true => Requirement::NotApplicable("the tank is anchored".into()),
        false => required,
    };
    add(
        OVERTURNING,
        "Overturning of the tank",
        edition.main("4.5.1.2"),
        lifts(Requirement::Required),
    );
    add(
        UPLIFT,
        "Uplift, membrane stress and rotation of the bottom plate",
        edition.clause("9"),
        match (cylinder, metal) {
            (_, false) => lifts(Requirement::NotApplicable(
                "the bottom is a slab, not a metal plate that lifts: it turns as a whole".into(),
            )),
            (true, true) => lifts(Requirement::Required),
            (false, true) => lifts(Requirement::NotImplemented),
        },
    );
    let ground = "EN 1998-5:2004 5.4.1";
    add(
        SLIDING,
        "Sliding on the foundation",
        format!("{ground}.1"),
        Requirement::Required,
    );
    add(
        BEARING,
        "Bearing of the ground",
        format!("{ground}.1"),
        Requirement::Required,
    );
    add(
        PIPES,
        "Differential displacement of pipes",
        edition.main("4.5.2.3"),
        Requirement::Required,
    );
    add(
        DAMAGE,
        "Damage limitation state",
        edition.main("2.1.3"),
        Requirement::Required,
    );
    for (id, name, clause, requirement) in [
        (
            "wall_material",
            "Material of the wall",
            edition.main("1.1"),
            material(case),
        ),
        (
            OTHER_DIRECTION,
            "Shaking along the breadth of a box",
            "EN 1998-1:2004 4.3.3.5.1".into(),
            other_direction(case),
        ),
        (
            "soil_structure_interaction",
            "Soil-structure interaction on very soft ground",
            "EN 1998-5:2004 6".into(),
            soft_ground(case),
        ),
        ("snow", "Snow on the roof", "EN 1998-1:2004 3.2.4".into(), snow(case)),
    ] {
        add(id, name, clause, requirement);
    }
    states
}

/// Shear wave velocity below which the interaction of soil and structure is asked for [m/s].
const VERY_SOFT: f64 = 100.0;

/// The material of the wall: annex A is for steel, with the modulus and the strength of another metal where the formulas contain them,
/// and for concrete.
fn material(case: &Case) -> Requirement {
    let mut metal = 0;
    let mut walls = 0;
    for material in case.tank.wall_materials() {
        walls += 1;
        match material.family {
            None => return Requirement::Missing(format!("materials.{}.family", material.name)),
            Some(Family::CarbonSteel | Family::Stainless | Family::Aluminium) => metal += 1,
            Some(Family::Concrete) => {}
            Some(_) => return Requirement::NotImplemented,
        }
    }
    match metal {
        0 => Requirement::NotApplicable("the wall is concrete".into()),
        _ if metal == walls => Requirement::NotApplicable("the wall is steel or aluminium".into()),
        // Metal on concrete, or metal and concrete in layers.
        _ => Requirement::NotImplemented,
    }
}

/// A box has two directions; a square one, a cylinder and a strip one.
fn other_direction(case: &Case) -> Requirement {
    match case.tank.shape {
        Shape::Cylinder { .. } => Requirement::NotApplicable("a cylinder has no direction".into()),
        Shape::Rectangle { strip: true, .. } => {
            Requirement::NotApplicable("a strip of a long tank is shaken across it".into())
        }
        Shape::Rectangle { length, breadth, .. } if length == breadth => {
            Requirement::NotApplicable("the box is square".into())
        }
        Shape::Rectangle { .. } => Requirement::Required,
    }
}

/// Clause 6 asks for the interaction on ground with less than 100 m/s. Ground types A to C have more than 180 m/s.
fn soft_ground(case: &Case) -> Requirement {
    let velocity = case
        .tank
        .foundation
        .and_then(|foundation| foundation.shear_wave_velocity);
    let stiff = |ground: GroundType| matches!(ground, GroundType::A | GroundType::B | GroundType::C);
    // Beside the user's spectrum the ground type is not an input.
    let ground = (case.site.ec8).filter(|_| case.site.spectrum.is_none());
    match (velocity, ground) {
        (Some(velocity), _) if velocity < VERY_SOFT => Requirement::NotImplemented,
        (Some(_), _) => Requirement::NotApplicable("shear waves are faster than 100 m/s".into()),
        (None, Some(site)) if stiff(site.ground) => {
            Requirement::NotApplicable("shear waves of the ground type are faster than 100 m/s".into())
        }
        (None, _) => Requirement::Missing("tank.foundation.shear_wave_velocity".into()),
    }
}
