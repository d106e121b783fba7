//! What each limit state and check compares, by id, for `tankcheck explain`. Name and clause are those that the procedures declare.

use tank::units::Dimension::{self, *};

/// A limit state, or one of the checks in which it ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// Id of the check as in `results.json`.
    pub id: &'static str,
    /// The limit state that it belongs to; its own id where it is one.
    pub state: &'static str,
    /// What the demand is.
    pub demand: &'static str,
    /// What it is compared with, and what that depends on.
    pub capacity: &'static str,
    /// Dimension of both.
    pub dimension: Dimension,
}

const fn state(id: &'static str, demand: &'static str, capacity: &'static str, dimension: Dimension) -> Meaning {
    part((id, id), demand, capacity, dimension)
}

const fn part(
    (id, state): (&'static str, &'static str),
    demand: &'static str,
    capacity: &'static str,
    dimension: Dimension,
) -> Meaning {
    Meaning {
        id,
        state,
        demand,
        capacity,
        dimension,
    }
}

/// Names of the checks in which limit states end.
const NAMES: [(&str, &str); 17] = [
    (
        "wall_tension_and_bending_horizontal",
        "Tension and bending of the wall, horizontal section",
    ),
    (
        "wall_tension_and_bending_vertical",
        "Tension and bending of the wall, vertical section",
    ),
    ("wall_joint", "Shear along the joint at the base of the wall"),
    ("uplift_membrane", "Membrane stress of the lifted bottom plate"),
    ("uplift_rotation", "Rotation of the joint of wall and bottom plate"),
    ("uplift_width", "Lifted length of the bottom plate"),
    ("uplift_equilibrium", "Moment that weight and bottom plate hold"),
    ("sliding_api", "Sliding on the foundation, API 650"),
    ("bearing_ring", "Pressure under the ring wall at the toe"),
    ("bearing_toe", "Force of the toe on the ground under the bottom plate"),
    ("piping_uplift", "Pipes, upward displacement"),
    ("piping_settlement", "Pipes, downward displacement"),
    ("piping_horizontal", "Pipes, horizontal displacement"),
    ("damage_freeboard", "Freeboard, damage limitation"),
    ("damage_hoop", "Hoop stress below yield, damage limitation"),
    ("damage_wall", "Stress of the wall, damage limitation"),
    ("damage_crack_width", "Crack width, damage limitation"),
];

impl Meaning {
    /// Name of a check that is part of a limit state; that of a limit state is declared by its procedure.
    pub fn name(&self) -> Option<&'static str> {
        NAMES.iter().find(|(id, _)| *id == self.id).map(|(_, name)| *name)
    }
}

/// All, in the order of a report: surface, wall, base, surroundings.
pub const ALL: &[Meaning] = &[
    state(
        "freeboard",
        "largest rise of the liquid surface at the wall, d_max or δ_s",
        "height of the wall, or of the roof, above the liquid at rest; API 650 asks for a part of δ_s in some seismic use groups",
        Length,
    ),
    state(
        "roof_impact",
        "largest rise of the liquid surface at the wall",
        "height of the roof above the liquid at rest; what a wave does that reaches the roof is not computed",
        Length,
    ),
    state(
        "hoop_yield",
        "circumferential membrane stress of each course under liquid at rest and earthquake",
        "yield strength of the course",
        Stress,
    ),
    state(
        "hoop_stress",
        "product hoop stress and seismic hoop stress of each course",
        "the lesser of 1.33 times the allowable product stress times joint efficiency, and 0.9 F_y times joint efficiency",
        Stress,
    ),
    state(
        "pressure_hoop",
        "hoop stress with the design pressure above the liquid",
        "as hoop_stress",
        Stress,
    ),
    state(
        "equivalent_stress",
        "equivalent (von Mises) membrane stress of the wall at every place and instant",
        "yield strength",
        Stress,
    ),
    state(
        "equivalent_stress_at_base",
        "range of the equivalent stress on a face of the wall at its foot, with bending",
        "twice the yield strength (plastic shakedown)",
        Stress,
    ),
    state(
        "buckling_elastic",
        "axial compression of the wall (membrane stress)",
        "elastic buckling stress of the course, raised by the interior pressure and lowered by the imperfection of its quality class",
        Stress,
    ),
    state(
        "buckling_elastic_plastic",
        "axial compression at the foot of a course (membrane stress)",
        "stress at which the wall bulges outward (elephant's foot); it falls with the hoop stress of the same instant",
        Stress,
    ),
    state(
        "shell_compression",
        "longitudinal compression at the foot of the bottom course",
        "allowable compression F_C, from G H D²/t² and at most 0.5 F_ty",
        Stress,
    ),
    state(
        "upper_compression",
        "longitudinal compression at the foot of each course above the bottom one",
        "its allowable compression F_C, as shell_compression",
        Stress,
    ),
    state(
        "wall_tension_and_bending",
        "axial force with bending moment of the wall per length, concrete with its bars or plate of metal",
        "resistance of the section at the same eccentricity",
        LineForce,
    ),
    part(
        ("wall_tension_and_bending_horizontal", "wall_tension_and_bending"),
        "axial force or moment of the horizontal section per length",
        "what the horizontal bars and the concrete resist at the same eccentricity",
        LineForce,
    ),
    part(
        ("wall_tension_and_bending_vertical", "wall_tension_and_bending"),
        "axial force or moment of the vertical section per length",
        "what the vertical bars and the concrete resist at the same eccentricity",
        LineForce,
    ),
    state(
        "wall_shear",
        "shear force of the wall across its thickness per length",
        "resistance without stirrups; axial tension lowers it",
        LineForce,
    ),
    part(
        ("wall_joint", "wall_shear"),
        "shear of the earthquake along a sliding joint at the base of the wall, at the sides of the tank",
        "friction under the weight of wall and roof",
        LineForce,
    ),
    state(
        "crack_width",
        "width of cracks under service actions",
        "width allowed by the tightness class",
        Length,
    ),
    state(
        "wall_strength",
        "stresses of a wall that is not a metal shell",
        "not compared by the engines: the procedures of Eurocode 8 design such walls",
        Stress,
    ),
    state(
        "wall_material",
        "the family of the wall's materials",
        "not compared: each code is written for some families",
        Dimensionless,
    ),
    state(
        "vacuum",
        "buckling of the shell by the vacuum above the liquid",
        "not compared: API 650 annex V is not implemented",
        Stress,
    ),
    state(
        "plane_walls",
        "walls of a box computed as cantilevers, one strip for all",
        "not compared: a narrow box carries as plates, and a run by strips is then outside its model",
        Dimensionless,
    ),
    state(
        "design_pressure",
        "hoop stress and anchors with the design pressure",
        "not compared by the engines",
        Stress,
    ),
    state(
        "gas_pressure",
        "stresses with the pressure above the liquid",
        "not compared by the engines; the procedures do",
        Stress,
    ),
    state(
        "anchorage",
        "largest tension of an anchor: pull of the wall times the spacing",
        "capacity of an anchor, given",
        Force,
    ),
    state(
        "anchor_tension",
        "largest tension of an anchor from overturning, less the weight of shell and roof",
        "capacity of an anchor, given",
        Force,
    ),
    state(
        "anchor_attachment",
        "three times the design tension of an anchor, 3 P_AB",
        "capacity of its attachment to the shell, given",
        Force,
    ),
    state(
        "anchor_count",
        "least number of anchors, 4, and 6 where the earthquake pulls at them",
        "number of anchors, given",
        Dimensionless,
    ),
    state(
        "connections",
        "4 P_AB of an anchor, or the distance from the shell that connections through the bottom need, L + 300 mm",
        "capacity of the attachment, or that distance, given",
        Force,
    ),
    state(
        "anchor_spacing",
        "distance of the anchors along the shell",
        "largest spacing of the standard, 10 ft (printed as 3 m (10 ft); the larger counts)",
        Length,
    ),
    state(
        "anchorage_ratio",
        "anchorage ratio J, moment over what weight and bottom plate hold down",
        "1.54; up to 0.785 the shell does not lift",
        Dimensionless,
    ),
    state(
        "annulus_width",
        "width of the annular plate that the hold-down needs",
        "width of the plate inside the shell, given",
        Length,
    ),
    state(
        "annular_weld",
        "lap welds between the annular plates, 1 or 0",
        "none in seismic use group III from S_DS = 0.5 g on, nor in annular plates thicker than 10 mm",
        Dimensionless,
    ),
    state(
        "shell_support",
        "supports of the shell on concrete that the clause excludes, 1 or 0",
        "none: shims and grout of an anchored tank; grout, a pad or butt-welded plates of a self-anchored one",
        Dimensionless,
    ),
    state(
        "shear_transfer",
        "shear stress of the welds between shell and bottom, 2 V/(π D) on two fillets",
        "80 % of the yield strength of the weaker plate",
        Stress,
    ),
    state(
        "stability",
        "moment over what weight and bottom plate hold down, M/(D²·(w_t + w_L))",
        "1.57",
        Dimensionless,
    ),
    state(
        "overturning",
        "overturning moment of the earthquake just above the bottom; of a box that is one with a concrete bottom, below it",
        "cylinder: π/2·D²·(w_t + w_L), with the weight of wall and roof and the pull of the bottom plate, per length of wall; box: its weight times half its length",
        Moment,
    ),
    state(
        "uplift",
        "uplift of the wall, with membrane stress and rotation of the bottom plate",
        "ends in uplift_membrane, uplift_rotation and uplift_width, or in uplift_equilibrium",
        Dimensionless,
    ),
    part(
        ("uplift_membrane", "uplift"),
        "radial membrane stress of the lifted bottom plate",
        "yield strength of the plate",
        Stress,
    ),
    part(
        ("uplift_rotation", "uplift"),
        "rotation of the joint of wall and bottom plate",
        "0.20 rad",
        Angle,
    ),
    part(
        ("uplift_width", "uplift"),
        "lifted length of the bottom plate",
        "width of the plate under the wall (annular plate)",
        Length,
    ),
    part(
        ("uplift_equilibrium", "uplift"),
        "overturning moment",
        "largest moment that weight and bottom plate hold at any rotation up to 0.1 rad",
        Moment,
    ),
    state(
        "uplift_tension",
        "plastic rotation of the joint of the bottom plate in a run in which the base lifts; tension at the foot of a clamped wall otherwise",
        "0.20 rad; a clamped unanchored wall that pulls is outside its model",
        Angle,
    ),
    state(
        "sliding",
        "horizontal force on the foundation",
        "friction times the weight with its vertical acceleration",
        Force,
    ),
    part(
        ("sliding_api", "sliding"),
        "horizontal force on the foundation of a run",
        "resistance of API 650 E.7.6, with its friction and vertical acceleration",
        Force,
    ),
    state(
        "foundation",
        "overturning moment on the foundation",
        "moment that ring wall or slab with the liquid above it holds, with a factor of 2",
        Moment,
    ),
    state(
        "bearing",
        "pressure of the foundation on the ground",
        "bearing resistance of the ground, given; of a wall that lifts also bearing_ring or bearing_toe",
        Stress,
    ),
    part(
        ("bearing_ring", "bearing"),
        "pressure of a ring wall on the ground at the toe of a wall that lifts",
        "bearing resistance of the ground, given",
        Stress,
    ),
    part(
        ("bearing_toe", "bearing"),
        "compression of a wall that lifts at its toe, on soil",
        "force that the ground bears over the width to which the bottom plate spreads it",
        LineForce,
    ),
    state(
        "soil_structure_interaction",
        "what soft ground does to periods and damping",
        "not compared: asked for below 100 m/s of shear waves, and not implemented",
        Dimensionless,
    ),
    state(
        "site_study",
        "ground motion study that ASCE 7-16 asks for on soft sites",
        "not compared: the user's spectrum or site coefficients stand for it",
        Dimensionless,
    ),
    state(
        "snow",
        "share of the snow in the mass of the roof",
        "not compared: answered by the tank file",
        Mass,
    ),
    state(
        "internals",
        "equipment within the liquid that wall or bottom carry",
        "not compared: answered by the tank file",
        Force,
    ),
    state(
        "adjacent_structures",
        "displacements of structures that are connected to the tank",
        "not compared: answered by the tank file",
        Length,
    ),
    state(
        "other_direction",
        "largest utilisation of a box shaken along its breadth",
        "1",
        Dimensionless,
    ),
    state(
        "ground_motion",
        "factor with which the records just hold for the design spectrum of the site",
        "1; a single record, or a set that is too small, is not checked where it is strong enough",
        Dimensionless,
    ),
    state(
        "isolator_displacement",
        "largest displacement of the isolators, times 1.2 by EN 1998-1 10.3",
        "displacement that bearings, joints and pipes have room for, given",
        Length,
    ),
    state(
        "isolator_displacement_mce",
        "displacement of the isolators in the maximum considered earthquake of ASCE 7, with the torsion of the plan",
        "not compared: the record is the design earthquake",
        Length,
    ),
    state(
        "isolator_tension",
        "part of its force at rest that the outermost bearing loses, 1 − N/N_0",
        "1, beyond which it is in tension",
        Dimensionless,
    ),
    state(
        "pipes",
        "displacement of tank and wall where a pipe joins, against its support",
        "displacement that the pipe can follow, given",
        Length,
    ),
    state(
        "piping",
        "displacements for which pipes must be flexible (table E.8; of its values in mm and inches the lesser counts)",
        "displacements that the pipes allow, given; ends in piping_uplift, piping_settlement and piping_horizontal",
        Length,
    ),
    part(
        ("piping_uplift", "piping"),
        "upward displacement for which the pipes must be flexible",
        "upward displacement that they allow, given",
        Length,
    ),
    part(
        ("piping_settlement", "piping"),
        "downward displacement for which the pipes must be flexible",
        "downward displacement that they allow, given",
        Length,
    ),
    part(
        ("piping_horizontal", "piping"),
        "horizontal displacement for which the pipes must be flexible",
        "horizontal displacement that they allow, given",
        Length,
    ),
    state(
        "damage_limitation",
        "response to the frequent earthquake, ν times that of the ultimate limit state",
        "ends in damage_freeboard, damage_hoop, damage_wall and damage_crack_width",
        Dimensionless,
    ),
    part(
        ("damage_freeboard", "damage_limitation"),
        "rise of the surface under the frequent earthquake",
        "height of the wall above the liquid at rest",
        Length,
    ),
    part(
        ("damage_hoop", "damage_limitation"),
        "hoop stress under the frequent earthquake",
        "yield strength",
        Stress,
    ),
    part(
        ("damage_wall", "damage_limitation"),
        "stress of a metal wall that bends, under the frequent earthquake",
        "yield strength",
        Stress,
    ),
    part(
        ("damage_crack_width", "damage_limitation"),
        "width of cracks under the frequent earthquake",
        "width allowed by the tightness class",
        Length,
    ),
];

/// The meaning of a check or limit state.
pub fn of(id: &str) -> Option<&'static Meaning> {
    ALL.iter().find(|meaning| meaning.id == id)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::api650::ground_motion::tests::site as api_site;
    use crate::samples::{case, course, steel};
    use crate::time_history::{Codes, limit_states};
    use tank::{Shape, Support};

    #[test]
    fn every_limit_state_has_a_meaning() {
        let ids: BTreeSet<&str> = ALL.iter().map(|meaning| meaning.id).collect();
        assert_eq!(ids.len(), ALL.len());
        for meaning in ALL {
            assert!(of(meaning.state).is_some(), "{}", meaning.id);
        }
        let cylinder = Shape::Cylinder { radius: 10.0 };
        let strip = false;
        let (length, breadth) = (5.0, 3.0);
        let rectangle = Shape::Rectangle { length, breadth, strip };
        for (shape, support, api) in [
            (cylinder, Support::Anchored, false),
            (cylinder, Support::Unanchored, true),
            (rectangle, Support::Unanchored, false),
        ] {
            let mut case = case(shape, vec![course(9.0, 0.01, steel())], 8.0, None);
            case.tank.support = support;
            case.tank.pressure.internal = 1e3;
            case.site.api650 = api.then(api_site);
            let states = crate::ALL.iter().flat_map(|procedure| procedure.limit_states(&case));
            for state in states.chain(limit_states(&case, Codes::of(&case, &[]))) {
                assert!(ids.contains(state.id), "{}", state.id);
            }
        }
    }
}
