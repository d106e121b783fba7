//! Limit states of an engine under the record, and whether each applies.
//!
//! Those that the codes that count ask for ([`crate::code`]), as far as a demand of the engine exists; what else they ask for stays open.

use tank::assessment::Requirement::{self, NotApplicable, NotImplemented, Required};
use tank::case::Case;
use tank::check::TankPart;
use tank::units::Dimension::*;
use tank::{Shape, Support};

use crate::code::Placed;
use crate::limit_state::{ASKED, LimitStateDef, common};

/// Those that no code has to ask for.
pub(super) const TABLE: &[Placed] = &[(20, EQUIVALENT), (21, BENDING), (60, OTHER_WALL), (70, PLATES)];

pub(crate) use common::{BEARING, FREEBOARD, SLIDING};

pub(crate) const ANCHORS: LimitStateDef = common::ANCHORS.when(pulls);

pub(crate) const ROOF: LimitStateDef = LimitStateDef {
    id: "roof_impact",
    name: "Impact of the wave on the roof",
    demand: "largest rise of the liquid surface at the wall",
    capacity: "height of the roof above the liquid at rest; what a wave does that reaches the roof is not computed",
    dimension: Length,
    page: 20,
    ..ASKED
};

pub(crate) const EQUIVALENT: LimitStateDef = LimitStateDef {
    id: "equivalent_stress",
    name: "Equivalent membrane stress of the wall",
    clause: "EN 1993-1-6:2007 6.2.1",
    applies: shells,
    demand: "equivalent (von Mises) membrane stress of the wall at every place and instant",
    capacity: "yield strength",
    dimension: Stress,
    page: 60,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const BENDING: LimitStateDef = LimitStateDef {
    id: "equivalent_stress_at_base",
    name: "Equivalent stress with bending at the base",
    clause: "EN 1993-1-6:2007 7.4",
    applies: shells,
    demand: "range of the equivalent stress on a face of the wall at its foot, with bending",
    capacity: "twice the yield strength (plastic shakedown)",
    dimension: Stress,
    page: 70,
    ..ASKED
};

pub(crate) const OTHER_WALL: LimitStateDef = LimitStateDef {
    id: "wall_strength",
    name: "Strength of a wall that is not a metal shell",
    clause: "EN 1992-1-1 6.1, 6.2, EN 1992-3 7.3, EN 1993-4-2",
    applies: other_walls,
    demand: "stresses of a wall that is not a metal shell",
    capacity: "not compared by the engines: the procedures of Eurocode 8 design such walls",
    dimension: Stress,
    page: 150,
    ..ASKED
};

pub(crate) const PLATES: LimitStateDef = LimitStateDef {
    id: "plane_walls",
    name: "Walls of the box as cantilevers",
    clause: "theory of plates",
    exists: |case| case.tank.breadth_to_height().is_some(),
    demand: "walls of a box computed as cantilevers, one strip for all",
    capacity: "not compared: a narrow box carries as plates, and a run by strips is then outside its model",
    dimension: Dimensionless,
    page: 180,
    ..ASKED
};

pub(crate) const UPLIFT: LimitStateDef = LimitStateDef {
    id: "uplift_tension",
    name: "Uplift of the unanchored wall",
    applies: lifts,
    demand: "plastic rotation of the joint of the bottom plate in a run in which the base lifts; tension at the foot of a clamped wall otherwise",
    capacity: "0.20 rad; a clamped unanchored wall that pulls is outside its model",
    dimension: Angle,
    page: 350,
    ..ASKED
};

pub(crate) const ISOLATORS: LimitStateDef = LimitStateDef {
    id: "isolator_displacement",
    name: "Displacement of the isolators",
    exists: |case| case.tank.isolators.is_some(),
    demand: "largest displacement of the isolators, times 1.2 by EN 1998-1 10.3",
    capacity: "displacement that bearings, joints and pipes have room for, given",
    dimension: Length,
    page: 460,
    ..ASKED
};

pub(crate) const TENSION: LimitStateDef = LimitStateDef {
    id: "isolator_tension",
    name: "Tension of the outermost bearing",
    exists: |case| case.tank.isolators.is_some(),
    demand: "part of its force at rest that the outermost bearing loses, 1 − N/N_0",
    capacity: "1, beyond which it is in tension",
    dimension: Dimensionless,
    page: 480,
    ..ASKED
};

pub(crate) const GROUND_MOTION: LimitStateDef = LimitStateDef {
    id: "ground_motion",
    name: "Records against the design spectrum of the site",
    demand: "factor with which the records just hold for the design spectrum of the site",
    capacity: "1; a single record, or a set that is too small, is not checked where it is strong enough",
    dimension: Dimensionless,
    page: 450,
    ..ASKED
};

fn cylinder(case: &Case) -> bool {
    matches!(case.tank.shape, Shape::Cylinder { .. })
}

/// Required of metal shells.
pub(crate) fn shells(case: &Case) -> Requirement {
    match cylinder(case) && case.tank.is_metal() {
        true => Required,
        false => NotApplicable("the clause is for metal shells".into()),
    }
}

fn other_walls(case: &Case) -> Requirement {
    match shells(case) {
        Required => NotApplicable("the wall is a metal shell".into()),
        _ => NotImplemented,
    }
}

/// What the wall of a cylinder does at its base is computed.
fn at_base(case: &Case) -> Requirement {
    if cylinder(case) { Required } else { NotImplemented }
}

fn pulls(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => at_base(case),
        Support::Unanchored => NotApplicable("the tank is unanchored".into()),
    }
}

fn lifts(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => NotApplicable("the tank is anchored".into()),
        Support::Unanchored => at_base(case),
    }
}
