//! Limit states of EN 1998-4 for tanks on the ground, and whether each applies.
//!
//! The ultimate limit state of EN 1998-4:2006 2.1.2 and 4.5 asks for the wall (hoop tension, stability), the base (anchors, uplift,
//! sliding, overturning, bearing of the ground), the liquid surface, and the pipes; 2.1.3 for damage limitation. Walls that are not
//! metal shells are designed by EN 1992. Clauses are recalled, not copied; `docs/theory/eurocode8.md` says which were compared.
//! They are those of the edition of 2006; the pre-standard numbers alike.

use super::demand::Edition;
use crate::api650::edition2020::limit_states::snow;
use crate::limit_state::{ASKED, LimitStateDef, Part, common};
use tank::assessment::LimitState;
use tank::assessment::Requirement::{self, Missing, NotApplicable, NotImplemented, Required};
use tank::case::{Case, GroundType};
use tank::check::TankPart;
use tank::units::Dimension::*;
use tank::{Family, Shape, Support};

/// Source of the least number of anchors.
pub(super) const COUNT: &str = "good practice, API 650:2020 5.12.2";
/// Source of their largest spacing.
pub(super) const SPACING: &str = "good practice, API 650:2020 5.12.3";

/// All, in the order of the checks.
pub(super) const TABLE: &[LimitStateDef] = &[
    FREEBOARD,
    HOOP,
    ELASTIC_BUCKLING,
    ELEPHANT_FOOT,
    WALL_BENDING,
    WALL_SHEAR,
    CRACKS,
    ANCHORS,
    ANCHOR_COUNT,
    ANCHOR_SPACING,
    OVERTURNING,
    UPLIFT,
    SLIDING,
    BEARING,
    PIPES,
    DAMAGE,
    MATERIAL,
    OTHER_DIRECTION,
    SOIL,
    SNOW,
    ROOF_COLUMNS,
];

pub(crate) const FREEBOARD: LimitStateDef = common::FREEBOARD.by("EN 1998-4:2006 A.2.1.4");

pub(crate) const HOOP: LimitStateDef = LimitStateDef {
    id: "hoop_yield",
    name: "Hoop tension of the wall",
    clause: "EN 1998-4:2006 A.10.3",
    applies: metal_shells,
    demand: "circumferential membrane stress of each course under liquid at rest and earthquake",
    capacity: "yield strength of the course",
    dimension: Stress,
    page: 30,
    ..ASKED
};

pub(crate) const ELASTIC_BUCKLING: LimitStateDef = LimitStateDef {
    id: "buckling_elastic",
    name: "Elastic buckling of the wall",
    clause: "EN 1998-4:2006 A.10.2",
    applies: metal_shells,
    demand: "axial compression of the wall (membrane stress)",
    capacity: "elastic buckling stress of the course, raised by the interior pressure and lowered by the imperfection of its quality class",
    dimension: Stress,
    page: 80,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const ELEPHANT_FOOT: LimitStateDef = LimitStateDef {
    id: "buckling_elastic_plastic",
    name: "Elastic-plastic collapse of the wall",
    clause: "EN 1998-4:2006 A.10.3",
    applies: metal_shells,
    demand: "axial compression at the foot of a course (membrane stress)",
    capacity: "stress at which the wall bulges outward (elephant's foot); it falls with the hoop stress of the same instant",
    dimension: Stress,
    page: 90,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const WALL_BENDING: LimitStateDef = LimitStateDef {
    id: "wall_tension_and_bending",
    name: "Tension and bending of the wall",
    clause: "EN 1992-1-1:2004 6.1",
    applies: designed,
    demand: "axial force with bending moment of the wall per length, concrete with its bars or plate of metal",
    capacity: "resistance of the section at the same eccentricity",
    dimension: LineForce,
    page: 120,
    parts: &[BENDING_HORIZONTAL, BENDING_VERTICAL],
    ..ASKED
};

pub(crate) const BENDING_HORIZONTAL: Part = Part {
    id: "wall_tension_and_bending_horizontal",
    name: "Tension and bending of the wall, horizontal section",
    demand: "axial force or moment of the horizontal section per length",
    capacity: "what the horizontal bars and the concrete resist at the same eccentricity",
    dimension: LineForce,
};

pub(crate) const BENDING_VERTICAL: Part = Part {
    id: "wall_tension_and_bending_vertical",
    name: "Tension and bending of the wall, vertical section",
    demand: "axial force or moment of the vertical section per length",
    capacity: "what the vertical bars and the concrete resist at the same eccentricity",
    dimension: LineForce,
};

pub(crate) const WALL_SHEAR: LimitStateDef = LimitStateDef {
    id: "wall_shear",
    name: "Shear of the wall",
    clause: "EN 1992-1-1:2004 6.2.2",
    applies: concrete,
    demand: "shear force of the wall across its thickness per length",
    capacity: "resistance without stirrups; axial tension lowers it",
    dimension: LineForce,
    page: 130,
    parts: &[WALL_JOINT],
    ..ASKED
};

pub(crate) const WALL_JOINT: Part = Part {
    id: "wall_joint",
    name: "Shear along the joint at the base of the wall",
    demand: "shear of the earthquake along a sliding joint at the base of the wall, at the sides of the tank",
    capacity: "friction under the weight of wall and roof",
    dimension: LineForce,
};

pub(crate) const CRACKS: LimitStateDef = LimitStateDef {
    id: "crack_width",
    name: "Crack width (leak tightness)",
    clause: "EN 1992-1-1:2004 7.3.4, EN 1992-3:2006 7.3.1",
    applies: concrete,
    demand: "width of cracks under service actions",
    capacity: "width allowed by the tightness class",
    dimension: Length,
    page: 140,
    ..ASKED
};

pub(crate) const ANCHORS: LimitStateDef = common::ANCHORS.by("EN 1998-4:2006 4.5.1.3").when(anchored);

pub(crate) const ANCHOR_COUNT: LimitStateDef = common::ANCHOR_COUNT.by(COUNT).when(anchored);

pub(crate) const ANCHOR_SPACING: LimitStateDef = common::ANCHOR_SPACING.by(SPACING).when(anchored);

pub(crate) const OVERTURNING: LimitStateDef = LimitStateDef {
    id: "overturning",
    name: "Overturning of the tank",
    clause: "EN 1998-4:2006 4.5.1.2",
    applies: unanchored,
    demand: "overturning moment of the earthquake just above the bottom; of a box that is one with a concrete bottom, below it",
    capacity: "cylinder: π/2·D²·(w_t + w_L), with the weight of wall and roof and the pull of the bottom plate, per length of wall; box: its weight times half its length",
    dimension: Moment,
    page: 330,
    needs: &[TankPart::Roof, TankPart::Foundation, TankPart::Bottom],
    ..ASKED
};

pub(crate) const UPLIFT: LimitStateDef = LimitStateDef {
    id: "uplift",
    name: "Uplift, membrane stress and rotation of the bottom plate",
    clause: "EN 1998-4:2006 A.9",
    applies: lifts,
    demand: "uplift of the wall, with membrane stress and rotation of the bottom plate",
    capacity: "ends in uplift_membrane, uplift_rotation and uplift_width, or in uplift_equilibrium",
    dimension: Dimensionless,
    page: 340,
    needs: &[TankPart::Bottom],
    parts: &[UPLIFT_MEMBRANE, UPLIFT_ROTATION, UPLIFT_WIDTH, UPLIFT_EQUILIBRIUM],
    ..ASKED
};

pub(crate) const UPLIFT_MEMBRANE: Part = Part {
    id: "uplift_membrane",
    name: "Membrane stress of the lifted bottom plate",
    demand: "radial membrane stress of the lifted bottom plate",
    capacity: "yield strength of the plate",
    dimension: Stress,
};

pub(crate) const UPLIFT_ROTATION: Part = Part {
    id: "uplift_rotation",
    name: "Rotation of the joint of wall and bottom plate",
    demand: "rotation of the joint of wall and bottom plate",
    capacity: "0.20 rad",
    dimension: Angle,
};

pub(crate) const UPLIFT_WIDTH: Part = Part {
    id: "uplift_width",
    name: "Lifted length of the bottom plate",
    demand: "lifted length of the bottom plate",
    capacity: "width of the plate under the wall (annular plate)",
    dimension: Length,
};

pub(crate) const UPLIFT_EQUILIBRIUM: Part = Part {
    id: "uplift_equilibrium",
    name: "Moment that weight and bottom plate hold",
    demand: "overturning moment",
    capacity: "largest moment that weight and bottom plate hold at any rotation up to 0.1 rad",
    dimension: Moment,
};

pub(crate) const SLIDING: LimitStateDef = common::SLIDING.by("EN 1998-5:2004 5.4.1.1");

pub(crate) const BEARING: LimitStateDef =
    LimitStateDef { clause: "EN 1998-5:2004 5.4.1.1", parts: &[BEARING_RING, BEARING_TOE], ..common::BEARING };

pub(crate) const BEARING_RING: Part = Part {
    id: "bearing_ring",
    name: "Pressure under the ring wall at the toe",
    demand: "pressure of a ring wall on the ground at the toe of a wall that lifts",
    capacity: "bearing resistance of the ground, given",
    dimension: Stress,
};

pub(crate) const BEARING_TOE: Part = Part {
    id: "bearing_toe",
    name: "Force of the toe on the ground under the bottom plate",
    demand: "compression of a wall that lifts at its toe, on soil",
    capacity: "force that the ground bears over the width to which the bottom plate spreads it",
    dimension: LineForce,
};

pub(crate) const PIPES: LimitStateDef = LimitStateDef {
    id: "pipes",
    name: "Differential displacement of pipes",
    clause: "EN 1998-4:2006 4.5.2.3",
    demand: "displacement of tank and wall where a pipe joins, against its support",
    capacity: "displacement that the pipe can follow, given",
    dimension: Length,
    page: 490,
    ..ASKED
};

pub(crate) const DAMAGE: LimitStateDef = LimitStateDef {
    id: "damage_limitation",
    name: "Damage limitation state",
    clause: "EN 1998-4:2006 2.1.3",
    demand: "response to the frequent earthquake, ν times that of the ultimate limit state",
    capacity: "ends in damage_freeboard, damage_hoop, damage_wall and damage_crack_width",
    dimension: Dimensionless,
    page: 510,
    parts: &[DAMAGE_FREEBOARD, DAMAGE_HOOP, DAMAGE_WALL, DAMAGE_CRACKS],
    ..ASKED
};

pub(crate) const DAMAGE_FREEBOARD: Part = Part {
    id: "damage_freeboard",
    name: "Freeboard, damage limitation",
    demand: "rise of the surface under the frequent earthquake",
    capacity: "height of the wall above the liquid at rest",
    dimension: Length,
};

pub(crate) const DAMAGE_HOOP: Part = Part {
    id: "damage_hoop",
    name: "Hoop stress below yield, damage limitation",
    demand: "hoop stress under the frequent earthquake",
    capacity: "yield strength",
    dimension: Stress,
};

pub(crate) const DAMAGE_WALL: Part = Part {
    id: "damage_wall",
    name: "Stress of the wall, damage limitation",
    demand: "stress of a metal wall that bends, under the frequent earthquake",
    capacity: "yield strength",
    dimension: Stress,
};

pub(crate) const DAMAGE_CRACKS: Part = Part {
    id: "damage_crack_width",
    name: "Crack width, damage limitation",
    demand: "width of cracks under the frequent earthquake",
    capacity: "width allowed by the tightness class",
    dimension: Length,
};

pub(crate) const MATERIAL: LimitStateDef = common::MATERIAL.by("EN 1998-4:2006 1.1").when(material);

pub(crate) const OTHER_DIRECTION: LimitStateDef = LimitStateDef {
    id: "other_direction",
    name: "Shaking along the breadth of a box",
    clause: "EN 1998-1:2004 4.3.3.5.1",
    applies: other_direction,
    demand: "largest utilisation of a box shaken along its breadth",
    capacity: "1",
    dimension: Dimensionless,
    page: 440,
    ..ASKED
};

pub(crate) const SOIL: LimitStateDef = LimitStateDef {
    id: "soil_structure_interaction",
    name: "Soil-structure interaction on very soft ground",
    clause: "EN 1998-5:2004 6",
    applies: soft_ground,
    demand: "what soft ground does to periods and damping",
    capacity: "not compared: asked for below 100 m/s of shear waves, and not implemented",
    dimension: Dimensionless,
    page: 390,
    ..ASKED
};

pub(crate) const SNOW: LimitStateDef = common::SNOW.by("EN 1998-1:2004 3.2.4").when(snow);

pub(crate) const ROOF_COLUMNS: LimitStateDef = LimitStateDef {
    id: "roof_columns",
    name: "Columns under the roof",
    clause: "EN 1998-4:2006 4.5.1",
    applies: |_| NotImplemented,
    exists: |case| case.tank.roof.on_columns > 0.0,
    demand: "bending and compression of the columns in the moving liquid",
    capacity: "not compared: not implemented",
    dimension: Dimensionless,
    page: 415,
    ..ASKED
};

/// All limit states of a case.
pub(super) fn all(case: &Case, edition: Edition) -> Vec<LimitState> {
    let of = |state: &LimitStateDef| state.under(edition.alike(state.clause), case);
    TABLE.iter().filter(|state| (state.exists)(case)).map(of).collect()
}

/// A cylinder, and a wall of metal.
fn shape(case: &Case) -> (bool, bool) {
    (matches!(case.tank.shape, Shape::Cylinder { .. }), case.tank.is_metal())
}

fn metal_shells(case: &Case) -> Requirement {
    match shape(case) {
        (true, true) => Required,
        (false, _) => NotApplicable("the walls of a box bend as plates; the clause is for cylinders".into()),
        (true, false) => NotApplicable("the clause is for metal shells; the wall is not metal".into()),
    }
}

/// Walls designed as plates or sections. What a wall that is neither metal nor concrete needs stays open as `wall_material`.
fn designed(case: &Case) -> Requirement {
    let foreign = case.tank.wall_materials().any(|m| {
        let known = m.family.is_some_and(|family| family != Family::Concrete);
        known && !m.is_metal()
    });
    match (foreign, shape(case)) {
        (true, _) => NotApplicable("the wall is neither metal nor concrete: `wall_material`".into()),
        (false, (true, true)) => NotApplicable("the wall is a metal shell and carries membrane forces".into()),
        (false, _) => Required,
    }
}

fn concrete(case: &Case) -> Requirement {
    match shape(case) {
        (false, true) => NotApplicable("the wall is of metal; the clause is for concrete".into()),
        _ => designed(case),
    }
}

fn anchored(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => Required,
        Support::Unanchored => NotApplicable("the tank is unanchored".into()),
    }
}

fn unanchored(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => NotApplicable("the tank is anchored".into()),
        Support::Unanchored => Required,
    }
}

fn lifts(case: &Case) -> Requirement {
    match (unanchored(case), shape(case)) {
        (Required, (_, false)) => {
            NotApplicable("the bottom is a slab, not a metal plate that lifts: it turns as a whole".into())
        }
        (Required, (false, true)) => NotImplemented,
        (of_support, _) => of_support,
    }
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
            None => return Missing(format!("materials.{}.family", material.name)),
            Some(Family::CarbonSteel | Family::Stainless | Family::Aluminium) => metal += 1,
            Some(Family::Concrete) => {}
            Some(_) => return NotImplemented,
        }
    }
    match metal {
        0 => NotApplicable("the wall is concrete".into()),
        _ if metal == walls => NotApplicable("the wall is steel or aluminium".into()),
        // Metal on concrete, or metal and concrete in layers.
        _ => NotImplemented,
    }
}

/// A box has two directions; a square one, a cylinder and a strip one.
fn other_direction(case: &Case) -> Requirement {
    match case.tank.shape {
        Shape::Cylinder { .. } => NotApplicable("a cylinder has no direction".into()),
        Shape::Rectangle { strip: true, .. } => NotApplicable("a strip of a long tank is shaken across it".into()),
        Shape::Rectangle { length, breadth, .. } if length == breadth => NotApplicable("the box is square".into()),
        Shape::Rectangle { .. } => Required,
    }
}

/// Clause 6 asks for the interaction on ground with less than 100 m/s. Ground types A to C have more than 180 m/s.
fn soft_ground(case: &Case) -> Requirement {
    let velocity = case.tank.foundation.and_then(|foundation| foundation.shear_wave_velocity);
    let stiff = |ground: GroundType| matches!(ground, GroundType::A | GroundType::B | GroundType::C);
    // Beside the user's spectrum the ground type is not an input.
    let ground = (case.site.ec8).filter(|_| case.site.spectrum.is_none());
    match (velocity, ground) {
        (Some(velocity), _) if velocity < VERY_SOFT => NotImplemented,
        (Some(_), _) => NotApplicable("shear waves are faster than 100 m/s".into()),
        (None, Some(site)) if stiff(site.ground) => {
            NotApplicable("shear waves of the ground type are faster than 100 m/s".into())
        }
        (None, _) => Missing("tank.foundation.shear_wave_velocity".into()),
    }
}
