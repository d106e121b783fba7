//! Limit states of an engine under the record, and whether each applies.
//!
//! Those that the codes named by `site` ask for, as far as a demand of the engine exists; what else they ask for stays open. Without
//! `site` the wall is judged by EN 1998-4 with its lowest quality of construction.

use tank::assessment::{LimitState, Requirement};
use tank::case::Case;
use tank::{Shape, Support};

use crate::api650::edition2020::limit_states::carbon_steel;
use crate::ec8::demand::Edition;

/// Freeboard.
pub(super) const FREEBOARD: &str = "freeboard";
/// Impact of the wave on the roof.
pub(super) const ROOF: &str = "roof_impact";
/// Hoop stress, Eurocode.
pub(super) const HOOP: &str = "hoop_yield";
/// Hoop stress, API.
pub(super) const API_HOOP: &str = "hoop_stress";
/// Equivalent membrane stress.
pub(super) const EQUIVALENT: &str = "equivalent_stress";
/// Range of the equivalent stress with bending at the base.
pub(super) const BENDING: &str = "equivalent_stress_at_base";
/// Elastic buckling, Eurocode.
pub(super) const ELASTIC: &str = "buckling_elastic";
/// Elastic-plastic collapse, Eurocode.
pub(super) const COLLAPSE: &str = "buckling_elastic_plastic";
/// Compression, API.
pub(super) const API_COMPRESSION: &str = "shell_compression";
/// Tension of the anchors.
pub(super) const ANCHORS: &str = "anchorage";
/// Tension at the base of a wall without anchors.
pub const OUTSIDE: &str = "uplift_tension";
/// Sliding.
pub(super) const SLIDING: &str = "sliding";
/// Walls that are not metal shells.
pub(super) const OTHER_WALL: &str = "wall_strength";

/// Source of the strength of shells.
pub(super) const EN_1993: &str = "EN 1993-1-6:2007";
/// Edition of API 650.
pub(super) const API: &str = "API 650:2020";

/// Codes whose capacities count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Codes {
    /// Eurocode 8.
    pub(super) ec8: bool,
    /// API 650.
    pub(super) api: bool,
}

impl Codes {
    /// Those that the site names; Eurocode 8 without a site.
    pub(super) fn of(case: &Case) -> Codes {
        let api = case.site.api650.is_some();
        Codes {
            ec8: case.site.ec8.is_some() || !api,
            api,
        }
    }
}

/// All limit states of a case.
pub fn limit_states(case: &Case) -> Vec<LimitState> {
    use Requirement::{NotApplicable, NotImplemented, Required};
    let codes = Codes::of(case);
    let cylinder = matches!(case.tank.shape, Shape::Cylinder { .. });
    let shell = cylinder && case.tank.is_metal();
    let anchored = case.tank.support == Support::Anchored;
    let en = |number: &str| Edition::En2006.clause(number);
    let main = |number: &str| Edition::En2006.main(number);
    let both = |ec8: String, api: &str| match (codes.ec8, codes.api) {
        (true, true) => format!("{ec8}, {API} {api}"),
        (true, false) => ec8,
        (false, _) => format!("{API} {api}"),
    };
    let mut states = Vec::new();
    let mut add = |id, name, clause: String, requirement| {
        states.push(LimitState {
            id,
            name,
            clause,
            requirement,
        });
    };
    let of_shells = |required: Requirement| match shell {
        true => required,
        false => NotApplicable("the clause is for metal shells".into()),
    };
    add(FREEBOARD, "Freeboard", both(en("2.1.4"), "E.7.2"), Required);
    add(
        ROOF,
        "Impact of the wave on the roof",
        both(en("2.1.4"), "E.7.2"),
        Required,
    );
    let membrane = format!("{EN_1993} 6.2.1");
    add(
        EQUIVALENT,
        "Equivalent membrane stress of the wall",
        membrane,
        of_shells(Required),
    );
    let cyclic = format!("{EN_1993} 7.4");
    add(
        BENDING,
        "Equivalent stress with bending at the base",
        cyclic,
        of_shells(Required),
    );
    if codes.ec8 {
        add(HOOP, "Hoop tension of the wall", en("10.3"), of_shells(Required));
        add(ELASTIC, "Elastic buckling of the wall", en("10.2"), of_shells(Required));
        let name = "Elastic-plastic collapse of the wall";
        add(COLLAPSE, name, en("10.3"), of_shells(Required));
    }
    if codes.api {
        add(
            API_HOOP,
            "Hoop stress of the shell",
            format!("{API} E.6.2.4"),
            of_shells(Required),
        );
        let (clause, required) = match carbon_steel(case) {
            true => (format!("{API} E.6.2.2.3"), Required),
            false => (format!("{API} annex AL"), NotImplemented),
        };
        add(API_COMPRESSION, "Compression of the shell", clause, of_shells(required));
        if case.site.api650.is_some_and(|site| site.design_pressure > 0.0) {
            let name = "Hoop stress and anchors with the design pressure";
            add("design_pressure", name, format!("{API} F.7"), NotImplemented);
        }
    }
    let other = match shell {
        true => NotApplicable("the wall is a metal shell".into()),
        false => NotImplemented,
    };
    let clause = "EN 1992-1-1 6.1, 6.2, EN 1992-3 7.3, EN 1993-4-2".to_owned();
    add(
        OTHER_WALL,
        "Strength of a wall that is not a metal shell",
        clause,
        other,
    );
    let (pulls, lifts) = match (cylinder, anchored) {
        (true, true) => (Required, NotApplicable("the tank is anchored".into())),
        (true, false) => (NotApplicable("the tank is unanchored".into()), Required),
        (false, true) => (NotImplemented, NotApplicable("the tank is anchored".into())),
        (false, false) => (NotApplicable("the tank is unanchored".into()), NotImplemented),
    };
    add(
        ANCHORS,
        "Tension of the anchors",
        both(main("4.5.1.3"), "E.6.2.1.2"),
        pulls,
    );
    add(
        OUTSIDE,
        "Uplift of the unanchored wall",
        both(en("9"), "E.6.2.1.1"),
        lifts,
    );
    add(
        SLIDING,
        "Sliding on the foundation",
        both("EN 1998-5:2004 5.4.1.1".into(), "E.7.6"),
        Required,
    );
    if codes.ec8 {
        add(
            "bearing",
            "Bearing of the ground",
            "EN 1998-5:2004 5.4.1.1".into(),
            NotImplemented,
        );
        add(
            "pipes",
            "Differential displacement of pipes",
            main("4.5.2.3"),
            NotImplemented,
        );
        let reason = "the record is one ground motion; the damage limitation state has a seismic action of its own";
        add(
            "damage_limitation",
            "Damage limitation state",
            main("2.1.3"),
            NotApplicable(reason.into()),
        );
    }
    if codes.api {
        add(
            "foundation",
            "Overturning of the foundation",
            format!("{API} E.6.2.3"),
            NotImplemented,
        );
        add(
            "piping",
            "Flexibility of the piping",
            format!("{API} E.7.3"),
            NotImplemented,
        );
    }
    states
}
