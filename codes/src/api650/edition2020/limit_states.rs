//! Limit states of API 650 annex E, and whether each applies.
//!
//! Whatever the annex asks for is here: checked, open, or answered by the tank file. The list "Not implemented" of
//! `docs/theory/api650.md` follows from it.

use super::super::basis::Basis;
use super::EDITION;
use tank::assessment::LimitState;
use tank::assessment::Requirement::{self, Missing, NotApplicable, NotImplemented, Required};
use tank::case::{Api650Site, Case, SiteClass};
use tank::{Family, FoundationKind, Presence, RoofKind, Snow, Support};

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
/// Weld of the annular plates.
pub(super) const ANNULAR_WELD: &str = "annular_weld";
/// Tension of the anchors.
pub(super) const ANCHORS: &str = "anchor_tension";
/// Attachment of the anchors.
pub(super) const ATTACHMENT: &str = "anchor_attachment";
/// Number of the anchors.
pub(super) const COUNT: &str = "anchor_count";
/// Spacing of the anchors.
pub(super) const SPACING: &str = "anchor_spacing";
/// Sliding.
pub(super) const SLIDING: &str = "sliding";
/// Shear between shell and bottom.
pub(super) const SHEAR: &str = "shear_transfer";
/// Overturning of the foundation.
pub(super) const FOUNDATION: &str = "foundation";
/// Pressure on the ground.
pub(super) const BEARING: &str = "bearing";
/// What the shell stands on.
pub(super) const SUPPORT: &str = "shell_support";
/// Freeboard.
pub(super) const FREEBOARD: &str = "freeboard";
/// Displacements of the pipes.
pub(super) const PIPING: &str = "piping";
/// Connections of anchors and through the bottom.
pub(super) const CONNECTIONS: &str = "connections";
/// Hoop stress with the design pressure.
pub(super) const PRESSURE: &str = "pressure_hoop";

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
    match (roof.kind, roof.mass > 0.0, case.tank.details.snow) {
        (RoofKind::Floating, ..) => NotApplicable("the roof floats: the wall does not carry its snow".into()),
        (RoofKind::Open, ..) | (RoofKind::Fixed, false, None) => {
            NotApplicable("no roof of mass stands on the wall".into())
        }
        (_, _, Some(Snow::None)) => NotApplicable("no snow, by the tank file".into()),
        (_, _, Some(Snow::Included)) => {
            NotApplicable("the mass of the roof contains the share of the snow, by the tank file".into())
        }
        (RoofKind::Fixed, true, None) => Missing("tank.roof.snow".into()),
    }
}

/// ASCE 7-16 asks for a ground motion study on soft sites; its exceptions are not examined.
fn study(site: Option<&Api650Site>, own: bool) -> Requirement {
    let none = |reason: &str| NotApplicable(reason.into());
    let Some(site) = site else {
        return none("`site.api650` is not given");
    };
    if own {
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

/// All limit states of a case; none outside the scope of the standard.
pub(super) fn all(case: &Case) -> Vec<LimitState> {
    if Basis::new(case, EDITION).is_err() {
        return Vec::new();
    }
    [base(case), surroundings(case)]
        .concat()
        .into_iter()
        .map(|(id, name, clause, requirement)| LimitState {
            id,
            name,
            clause: format!("{EDITION} {clause}"),
            requirement,
        })
        .collect()
}

/// Id, name, clause, requirement.
type Entry = (&'static str, &'static str, &'static str, Requirement);

/// Shell, base and foundation.
fn base(case: &Case) -> Vec<Entry> {
    let anchored = case.tank.support == Support::Anchored;
    let mechanical = || match anchored {
        true => Required,
        false => NotApplicable("the tank is self-anchored".into()),
    };
    let self_anchored = || match anchored {
        true => NotApplicable("the tank is mechanically anchored".into()),
        false => Required,
    };
    let pressed = case.tank.pressure.internal > 0.0 || case.site.api650.is_some_and(|site| site.design_pressure > 0.0);
    let pressure = match pressed {
        true => Required,
        false => NotApplicable("there is no design pressure".into()),
    };
    let vacuum = match case.tank.pressure.vacuum > 0.0 {
        true => NotImplemented,
        false => NotApplicable("there is no vacuum".into()),
    };
    let upper = match case.tank.courses.len() {
        1 => NotApplicable("the shell has one course".into()),
        _ => Required,
    };
    let support = match (case.tank.foundation.as_ref().map(|f| f.kind), anchored) {
        (Some(FoundationKind::Soil), false) => {
            NotApplicable("the self-anchored tank stands on neither a ring wall nor a slab".into())
        }
        (None, false) => Missing("tank.foundation".into()),
        _ => Required,
    };
    vec![
        (HOOP, "Hoop stress of the shell", "E.6.2.4", Required),
        (COMPRESSION, "Compression of the bottom course", "E.6.2.2", Required),
        (UPPER_COMPRESSION, "Compression of the courses above", "E.6.2.2", upper),
        (ANCHORAGE, "Anchorage ratio J", "E.6.2.1.1", self_anchored()),
        (ANNULUS, "Width of the annular plate", "E.6.2.1.1.2", self_anchored()),
        (ANNULAR_WELD, "Weld of the annular plates", "E.6.2.1.1", self_anchored()),
        (ANCHORS, "Tension of the anchors", "E.6.2.1.2", mechanical()),
        (
            ATTACHMENT,
            "Attachment of the anchors, 3 P_AB",
            "E.6.2.1.2",
            mechanical(),
        ),
        (COUNT, "Number of the anchors", "5.12.2", mechanical()),
        (SPACING, "Spacing of the anchors", "5.12.3", mechanical()),
        (SLIDING, "Sliding on the foundation", "E.7.6", self_anchored()),
        (SHEAR, "Shear between shell and bottom", "E.7.7", Required),
        (FOUNDATION, "Overturning of the foundation", "E.6.2.3", Required),
        (BEARING, "Pressure on the ground", "E.6.2.3", Required),
        (SUPPORT, "Support of the shell on concrete", "E.7.9", support),
        (
            "wall_material",
            "Wall of another material than carbon steel",
            "annexes S, AL",
            material(case),
        ),
        (PRESSURE, "Hoop stress with the design pressure", "E.6.2.4", pressure),
        ("vacuum", "Buckling of the shell by vacuum", "annex V", vacuum),
    ]
}

/// Liquid surface, loads and what is connected to the tank.
fn surroundings(case: &Case) -> Vec<Entry> {
    let details = &case.tank.details;
    let internals = presence(
        details.internals,
        "tank.internals",
        "wall and bottom carry no equipment within the liquid",
    );
    let neighbours = presence(
        details.adjacent_structures,
        "tank.adjacent_structures",
        "no structure is connected to the tank",
    );
    vec![
        (FREEBOARD, "Freeboard", "E.7.2", Required),
        (PIPING, "Flexibility of the piping", "E.7.3", Required),
        (CONNECTIONS, "Connections of anchors and bottom", "E.7.4", Required),
        ("internals", "Equipment within the liquid", "E.7.5", internals),
        (
            "adjacent_structures",
            "Connections with other structures",
            "E.7.8",
            neighbours,
        ),
        ("snow", "Snow in the weight of the roof", "E.2.2", snow(case)),
        (
            "site_study",
            "Ground motion study of the site",
            "E.4, ASCE 7-16 11.4.8",
            study(case.site.api650.as_ref(), case.site.spectrum.is_some()),
        ),
    ]
}
