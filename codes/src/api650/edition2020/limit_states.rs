//! Limit states of API 650 annex E, and whether each applies.
//!
//! Whatever the annex asks for is here: checked, open, or answered by the tank file. The list "Not implemented" of
//! `docs/theory/api650.md` follows from it.

use crate::limit_state::{ASKED, LimitStateDef, Part, common};
use tank::assessment::LimitState;
use tank::assessment::Requirement::{self, Missing, NotApplicable, NotImplemented, Required};
use tank::case::{Case, SiteClass};
use tank::check::TankPart;
use tank::units::Dimension::{Dimensionless, Force, Length, Moment, Stress};
use tank::{Family, FoundationKind, Presence, RoofKind, Snow, Support};

/// All, in the order of the checks.
pub(super) const TABLE: &[LimitStateDef] = &[
    HOOP,
    COMPRESSION,
    UPPER_COMPRESSION,
    ANCHORAGE,
    ANNULUS,
    ANNULAR_WELD,
    ANCHORS,
    ATTACHMENT,
    COUNT,
    SPACING,
    SLIDING,
    SHEAR,
    FOUNDATION,
    BEARING,
    SUPPORT,
    MATERIAL,
    PRESSURE,
    VACUUM,
    FREEBOARD,
    PIPING,
    CONNECTIONS,
    INTERNALS,
    NEIGHBOURS,
    SNOW,
    STUDY,
];

pub(crate) const HOOP: LimitStateDef = LimitStateDef {
    id: "hoop_stress",
    name: "Hoop stress of the shell",
    clause: "API 650:2020 E.6.2.4",
    demand: "product hoop stress and seismic hoop stress of each course",
    capacity: "the lesser of 1.33 times the allowable product stress times joint efficiency, and 0.9 F_y times joint efficiency",
    dimension: Stress,
    page: 40,
    ..ASKED
};

pub(crate) const COMPRESSION: LimitStateDef = LimitStateDef {
    id: "shell_compression",
    name: "Compression of the bottom course",
    clause: "API 650:2020 E.6.2.2",
    demand: "longitudinal compression at the foot of the bottom course",
    capacity: "allowable compression F_C, from G H D²/t² and at most 0.5 F_ty",
    dimension: Stress,
    page: 100,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const UPPER_COMPRESSION: LimitStateDef = LimitStateDef {
    id: "upper_compression",
    name: "Compression of the courses above",
    clause: "API 650:2020 E.6.2.2",
    applies: several_courses,
    demand: "longitudinal compression at the foot of each course above the bottom one",
    capacity: "its allowable compression F_C, as shell_compression",
    dimension: Stress,
    page: 110,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const ANCHORAGE: LimitStateDef = LimitStateDef {
    id: "anchorage_ratio",
    name: "Anchorage ratio J",
    clause: "API 650:2020 E.6.2.1.1",
    applies: self_anchored,
    demand: "anchorage ratio J, moment over what weight and bottom plate hold down",
    capacity: "1.54; up to 0.785 the shell does not lift",
    dimension: Dimensionless,
    page: 270,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const ANNULUS: LimitStateDef = LimitStateDef {
    id: "annulus_width",
    name: "Width of the annular plate",
    clause: "API 650:2020 E.6.2.1.1.2",
    applies: self_anchored,
    demand: "width of the annular plate that the hold-down needs",
    capacity: "width of the plate inside the shell, given",
    dimension: Length,
    page: 280,
    ..ASKED
};

pub(crate) const ANNULAR_WELD: LimitStateDef = LimitStateDef {
    id: "annular_weld",
    name: "Weld of the annular plates",
    clause: "API 650:2020 E.6.2.1.1",
    applies: self_anchored,
    demand: "lap welds between the annular plates, 1 or 0",
    capacity: "none in seismic use group III from S_DS = 0.5 g on, nor in annular plates thicker than 10 mm",
    dimension: Dimensionless,
    page: 290,
    ..ASKED
};

pub(crate) const ANCHORS: LimitStateDef = LimitStateDef {
    id: "anchor_tension",
    name: "Tension of the anchors",
    clause: "API 650:2020 E.6.2.1.2",
    applies: anchored,
    demand: "largest tension of an anchor from overturning, less the weight of shell and roof",
    capacity: "capacity of an anchor, given",
    dimension: Force,
    page: 220,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const ATTACHMENT: LimitStateDef = LimitStateDef {
    id: "anchor_attachment",
    name: "Attachment of the anchors, 3 P_AB",
    clause: "API 650:2020 E.6.2.1.2",
    applies: anchored,
    demand: "three times the design tension of an anchor, 3 P_AB",
    capacity: "capacity of its attachment to the shell, given",
    dimension: Force,
    page: 230,
    ..ASKED
};

pub(crate) const COUNT: LimitStateDef = common::ANCHOR_COUNT.by("API 650:2020 5.12.2").when(anchored);

pub(crate) const SPACING: LimitStateDef = common::ANCHOR_SPACING.by("API 650:2020 5.12.3").when(anchored);

pub(crate) const SLIDING: LimitStateDef = common::SLIDING.by("API 650:2020 E.7.6").when(self_anchored);

pub(crate) const SHEAR: LimitStateDef = LimitStateDef {
    id: "shear_transfer",
    name: "Shear between shell and bottom",
    clause: "API 650:2020 E.7.7",
    demand: "shear stress of the welds between shell and bottom, 2 V/(π D) on two fillets",
    capacity: "80 % of the yield strength of the weaker plate",
    dimension: Stress,
    page: 310,
    ..ASKED
};

pub(crate) const FOUNDATION: LimitStateDef = LimitStateDef {
    id: "foundation",
    name: "Overturning of the foundation",
    clause: "API 650:2020 E.6.2.3",
    demand: "overturning moment on the foundation",
    capacity: "moment that ring wall or slab with the liquid above it holds, with a factor of 2",
    dimension: Moment,
    page: 370,
    needs: &[TankPart::Foundation],
    ..ASKED
};

pub(crate) const BEARING: LimitStateDef = common::BEARING.named("Pressure on the ground").by("API 650:2020 E.6.2.3");

pub(crate) const SUPPORT: LimitStateDef = LimitStateDef {
    id: "shell_support",
    name: "Support of the shell on concrete",
    clause: "API 650:2020 E.7.9",
    applies: support,
    demand: "supports of the shell on concrete that the clause excludes, 1 or 0",
    capacity: "none: shims and grout of an anchored tank; grout, a pad or butt-welded plates of a self-anchored one",
    dimension: Dimensionless,
    page: 300,
    ..ASKED
};

pub(crate) const MATERIAL: LimitStateDef = common::MATERIAL
    .named("Wall of another material than carbon steel")
    .by("API 650:2020 annexes S, AL")
    .when(material);

pub(crate) const PRESSURE: LimitStateDef = LimitStateDef {
    id: "pressure_hoop",
    name: "Hoop stress with the design pressure",
    clause: "API 650:2020 E.6.2.4",
    applies: pressed,
    demand: "hoop stress with the design pressure above the liquid",
    capacity: "as hoop_stress",
    dimension: Stress,
    page: 50,
    ..ASKED
};

pub(crate) const VACUUM: LimitStateDef = LimitStateDef {
    id: "vacuum",
    name: "Buckling of the shell by vacuum",
    clause: "API 650:2020 annex V",
    applies: vacuum,
    demand: "buckling of the shell by the vacuum above the liquid",
    capacity: "not compared: API 650 annex V is not implemented",
    dimension: Stress,
    page: 170,
    ..ASKED
};

pub(crate) const FREEBOARD: LimitStateDef = common::FREEBOARD.by("API 650:2020 E.7.2");

pub(crate) const PIPING: LimitStateDef = LimitStateDef {
    id: "piping",
    name: "Flexibility of the piping",
    clause: "API 650:2020 E.7.3",
    demand: "displacements for which pipes must be flexible (table E.8; of its values in mm and inches the lesser counts)",
    capacity: "displacements that the pipes allow, given; ends in piping_uplift, piping_settlement and piping_horizontal",
    dimension: Length,
    page: 500,
    parts: &[PIPING_UPLIFT, PIPING_SETTLEMENT, PIPING_HORIZONTAL],
    ..ASKED
};

pub(crate) const PIPING_UPLIFT: Part = Part {
    id: "piping_uplift",
    name: "Pipes, upward displacement",
    demand: "upward displacement for which the pipes must be flexible",
    capacity: "upward displacement that they allow, given",
    dimension: Length,
};

pub(crate) const PIPING_SETTLEMENT: Part = Part {
    id: "piping_settlement",
    name: "Pipes, downward displacement",
    demand: "downward displacement for which the pipes must be flexible",
    capacity: "downward displacement that they allow, given",
    dimension: Length,
};

pub(crate) const PIPING_HORIZONTAL: Part = Part {
    id: "piping_horizontal",
    name: "Pipes, horizontal displacement",
    demand: "horizontal displacement for which the pipes must be flexible",
    capacity: "horizontal displacement that they allow, given",
    dimension: Length,
};

pub(crate) const CONNECTIONS: LimitStateDef = LimitStateDef {
    id: "connections",
    name: "Connections of anchors and bottom",
    clause: "API 650:2020 E.7.4",
    demand: "4 P_AB of an anchor, or the distance from the shell that connections through the bottom need, L + 300 mm",
    capacity: "capacity of the attachment, or that distance, given",
    dimension: Force,
    page: 250,
    ..ASKED
};

pub(crate) const INTERNALS: LimitStateDef = LimitStateDef {
    id: "internals",
    name: "Equipment within the liquid",
    clause: "API 650:2020 E.7.5",
    applies: internals,
    demand: "equipment within the liquid that wall or bottom carry",
    capacity: "not compared: answered by the tank file",
    dimension: Force,
    page: 420,
    ..ASKED
};

pub(crate) const NEIGHBOURS: LimitStateDef = LimitStateDef {
    id: "adjacent_structures",
    name: "Connections with other structures",
    clause: "API 650:2020 E.7.8",
    applies: neighbours,
    demand: "displacements of structures that are connected to the tank",
    capacity: "not compared: answered by the tank file",
    dimension: Length,
    page: 430,
    ..ASKED
};

pub(crate) const SNOW: LimitStateDef =
    common::SNOW.named("Snow in the weight of the roof").by("API 650:2020 E.2.2").when(snow);

pub(crate) const STUDY: LimitStateDef = LimitStateDef {
    id: "site_study",
    name: "Ground motion study of the site",
    clause: "API 650:2020 E.4, ASCE 7-16 11.4.8",
    applies: study,
    demand: "ground motion study that ASCE 7-16 asks for on soft sites",
    capacity: "not compared: the user's spectrum or site coefficients stand for it",
    dimension: Dimensionless,
    page: 400,
    ..ASKED
};

/// Whether every course is a plate of this family, without layers.
fn all_of(case: &Case, families: &[Family]) -> bool {
    let of = |family: Option<Family>| family.is_some_and(|f| families.contains(&f));
    let mut courses = case.tank.courses.iter();
    courses.all(|c| c.layers.is_empty() && of(c.material.family))
}

/// Whether every course is a plate of carbon steel.
pub(crate) fn carbon_steel(case: &Case) -> bool {
    all_of(case, &[Family::CarbonSteel])
}

/// The material of the wall: the annex is written for carbon steel, annexes S and AL for two more families.
fn material(case: &Case) -> Requirement {
    let unknown = case.tank.wall_materials().find(|m| m.family.is_none());
    if let Some(material) = unknown {
        return Missing(format!("materials.{}.family", material.name));
    }
    if carbon_steel(case) {
        return NotApplicable("the wall is carbon steel".into());
    }
    match all_of(case, &[Family::CarbonSteel, Family::Stainless, Family::Aluminium]) {
        true => NotApplicable(
            "annexes S (stainless steel) and AL (aluminium) cover the wall: the allowable compression is scaled with the modulus; the \
             strengths given must be those of the annex at the design temperature"
                .into(),
        ),
        false => NotImplemented,
    }
}

/// An answer of the file about something the clause is for.
fn presence(answer: Option<Presence>, path: &str, none: &str) -> Requirement {
    match answer {
        Some(Presence::None) => NotApplicable(none.into()),
        Some(Presence::Present) => NotImplemented,
        None => Missing(path.into()),
    }
}

/// Snow: a share of it belongs to the weight of the roof that the shell carries.
pub(crate) fn snow(case: &Case) -> Requirement {
    let roof = &case.tank.roof;
    if roof.snow.is_some() {
        return NotApplicable("the mass of the roof contains the share of the snow load of the tank file".into());
    }
    match (roof.kind, roof.mass > 0.0, case.tank.details.snow) {
        (RoofKind::Floating, ..) => NotApplicable("the roof floats: the wall does not carry its snow".into()),
        (RoofKind::Open, ..) | (_, false, None) => NotApplicable("no roof of mass stands on the wall".into()),
        (_, _, Some(Snow::None)) => NotApplicable("no snow, by the tank file".into()),
        (_, _, Some(Snow::Included)) => {
            NotApplicable("the mass of the roof contains the share of the snow, by the tank file".into())
        }
        (_, true, None) => Missing("tank.roof.snow".into()),
    }
}

/// ASCE 7-16 asks for a ground motion study on soft sites; its exceptions are not examined.
fn study(case: &Case) -> Requirement {
    let none = |reason: &str| NotApplicable(reason.into());
    let Some(site) = &case.site.api650 else { return none("`site.api650` is not given") };
    if case.site.spectrum.is_some() {
        return none("the user's spectrum stands for the study");
    }
    if site.fa.is_some() && site.fv.is_some() {
        return none("F_a and F_v are those of a site study");
    }
    if site.asce7 != 2016 {
        return none("the rule came with the tables of ASCE 7-16");
    }
    let soft = matches!(site.site_class, SiteClass::D | SiteClass::E) && site.s1 >= 0.2;
    let short = site.site_class == SiteClass::E && site.ss >= 1.0;
    match soft || short {
        true => Missing("site.spectrum".into()),
        false => none("the rule begins at S_1 = 0.2 g on site classes D and E, and at S_s = 1 g on site class E"),
    }
}

/// All limit states of a case within the scope of the standard.
pub(super) fn all(case: &Case) -> Vec<LimitState> {
    let of = |state: &LimitStateDef| state.under(state.clause.into(), case);
    TABLE.iter().map(of).collect()
}

fn anchored(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => Required,
        Support::Unanchored => NotApplicable("the tank is self-anchored".into()),
    }
}

fn self_anchored(case: &Case) -> Requirement {
    match case.tank.support {
        Support::Anchored => NotApplicable("the tank is mechanically anchored".into()),
        Support::Unanchored => Required,
    }
}

fn several_courses(case: &Case) -> Requirement {
    match case.tank.courses.len() {
        1 => NotApplicable("the shell has one course".into()),
        _ => Required,
    }
}

fn pressed(case: &Case) -> Requirement {
    let design = case.site.api650.is_some_and(|site| site.design_pressure > 0.0);
    match case.tank.pressure.internal > 0.0 || design {
        true => Required,
        false => NotApplicable("there is no design pressure".into()),
    }
}

fn vacuum(case: &Case) -> Requirement {
    if case.tank.pressure.vacuum > 0.0 { NotImplemented } else { NotApplicable("there is no vacuum".into()) }
}

fn support(case: &Case) -> Requirement {
    match (case.tank.foundation.map(|f| f.kind), case.tank.support) {
        (Some(FoundationKind::Soil), Support::Unanchored) => {
            NotApplicable("the self-anchored tank stands on neither a ring wall nor a slab".into())
        }
        (None, Support::Unanchored) => Missing("tank.foundation".into()),
        _ => Required,
    }
}

fn internals(case: &Case) -> Requirement {
    // The clause names columns that support the roof.
    if case.tank.roof.on_columns > 0.0 {
        return NotImplemented;
    }
    let none = "wall and bottom carry no equipment within the liquid";
    presence(case.tank.details.internals, "tank.internals", none)
}

fn neighbours(case: &Case) -> Requirement {
    let none = "no structure is connected to the tank";
    presence(case.tank.details.adjacent_structures, "tank.adjacent_structures", none)
}
