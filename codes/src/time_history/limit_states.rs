//! Limit states of an engine under the record, and whether each applies.
//!
//! Those that the codes named by `site` ask for, as far as a demand of the engine exists; what else they ask for stays open. Without
//! `site` the wall is judged by EN 1998-4 with its lowest quality of construction.

use tank::assessment::LimitState;
use tank::assessment::Requirement::{self, NotApplicable, NotImplemented, Required};
use tank::case::Case;
use tank::{Shape, Support};

use crate::api650::edition2020::limit_states::carbon_steel;
use crate::ec8::demand::Edition;
use crate::record_set::standard::Standard;

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
pub(super) const UPLIFT: &str = "uplift_tension";
/// Walls of a box that bend as plates.
pub(super) const PLATES: &str = "plane_walls";
/// Displacement of isolators.
pub(super) const ISOLATORS: &str = "isolator_displacement";
/// Tension of bearings.
pub(super) const TENSION: &str = "isolator_tension";
/// Bearing of the ground.
pub(super) const BEARING: &str = "bearing";
/// Sliding.
pub(super) const SLIDING: &str = "sliding";
/// Walls that are not metal shells.
pub(super) const OTHER_WALL: &str = "wall_strength";

/// Source of the strength of shells.
pub(super) const EN_1993: &str = "EN 1993-1-6:2007";
/// Edition of API 650.
pub(super) const API: &str = "API 650:2020";

/// Codes whose capacities count; at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Codes {
    /// Eurocode 8.
    pub(super) ec8: bool,
    /// API 650.
    pub(super) api: bool,
}

impl Codes {
    /// Those that the site names; Eurocode 8 without a site. If procedures of one of them alone decide, that one.
    ///
    /// * `decide`: ids of the methods that decide
    pub fn of(case: &Case, decide: &[String]) -> Codes {
        let named = |code: &str| decide.iter().any(|id| id.starts_with(code));
        let (ec8, api) = (case.site.ec8.is_some(), case.site.api650.is_some());
        let all = Codes { ec8: ec8 || !api, api };
        match (ec8 && named("ec8"), api && named("api650")) {
            (true, false) => Codes { api: false, ..all },
            (false, true) => Codes { ec8: false, ..all },
            _ => all,
        }
    }
}

/// A list of limit states under construction.
struct List<'a> {
    case: &'a Case,
    codes: Codes,
    states: Vec<LimitState>,
}

/// Clause of EN 1998-4 annex A.
fn annex(number: &str) -> String {
    Edition::En2006.clause(number)
}

/// Clause of EN 1998-4 itself.
fn main(number: &str) -> String {
    Edition::En2006.main(number)
}

impl List<'_> {
    fn add(&mut self, id: &'static str, name: &'static str, clause: String, requirement: Requirement) {
        self.states.push(LimitState {
            id,
            name,
            clause,
            requirement,
        });
    }

    /// The clauses of the codes that count.
    fn both(&self, ec8: String, api: &str) -> String {
        match (self.codes.ec8, self.codes.api) {
            (true, true) => format!("{ec8}, {API} {api}"),
            (true, false) => ec8,
            (false, _) => format!("{API} {api}"),
        }
    }

    fn cylinder(&self) -> bool {
        matches!(self.case.tank.shape, Shape::Cylinder { .. })
    }

    fn surface(&mut self) {
        for (id, name) in [(FREEBOARD, "Freeboard"), (ROOF, "Impact of the wave on the roof")] {
            self.add(id, name, self.both(annex("2.1.4"), "E.7.2"), Required);
        }
    }

    fn wall(&mut self) {
        let (case, codes) = (self.case, self.codes);
        let shell = self.cylinder() && case.tank.is_metal();
        let of_shells = |required: Requirement| match shell {
            true => required,
            false => NotApplicable("the clause is for metal shells".into()),
        };
        let required = of_shells(Required);
        let mut add = |id, name, clause: String| self.add(id, name, clause, required.clone());
        add(
            EQUIVALENT,
            "Equivalent membrane stress of the wall",
            format!("{EN_1993} 6.2.1"),
        );
        add(
            BENDING,
            "Equivalent stress with bending at the base",
            format!("{EN_1993} 7.4"),
        );
        if codes.ec8 {
            add(HOOP, "Hoop tension of the wall", annex("10.3"));
            add(ELASTIC, "Elastic buckling of the wall", annex("10.2"));
            add(COLLAPSE, "Elastic-plastic collapse of the wall", annex("10.3"));
        }
        if codes.api {
            add(API_HOOP, "Hoop stress of the shell", format!("{API} E.6.2.4"));
            let (clause, required) = match carbon_steel(case) {
                true => (format!("{API} E.6.2.2.3"), Required),
                false => (format!("{API} annex AL"), NotImplemented),
            };
            self.add(API_COMPRESSION, "Compression of the shell", clause, of_shells(required));
        }
        if codes.api && case.site.api650.is_some_and(|site| site.design_pressure > 0.0) {
            let name = "Hoop stress and anchors with the design pressure";
            self.add("design_pressure", name, format!("{API} F.7"), NotImplemented);
        }
        if codes.ec8 && !case.tank.pressure.is_none() {
            let name = "Stresses with the pressure above the liquid";
            self.add("gas_pressure", name, annex("10.2"), NotImplemented);
        }
        let other = match shell {
            true => NotApplicable("the wall is a metal shell".into()),
            false => NotImplemented,
        };
        let clause = "EN 1992-1-1 6.1, 6.2, EN 1992-3 7.3, EN 1993-4-2".to_owned();
        self.add(
            OTHER_WALL,
            "Strength of a wall that is not a metal shell",
            clause,
            other,
        );
    }

    /// Only of boxes: no other tank has walls that a strip may not stand for.
    fn plates(&mut self) {
        if self.case.tank.breadth_to_height().is_some() {
            let name = "Walls of the box as cantilevers";
            self.add(PLATES, name, "theory of plates".into(), Required);
        }
    }

    fn base(&mut self) {
        let cylinder = match self.cylinder() {
            true => Required,
            false => NotImplemented,
        };
        let (pulls, lifts) = match self.case.tank.support {
            Support::Anchored => (cylinder, NotApplicable("the tank is anchored".into())),
            Support::Unanchored => (NotApplicable("the tank is unanchored".into()), cylinder),
        };
        let clause = self.both(main("4.5.1.3"), "E.6.2.1.2");
        self.add(ANCHORS, "Tension of the anchors", clause, pulls);
        let clause = self.both(annex("9"), "E.6.2.1.1");
        self.add(UPLIFT, "Uplift of the unanchored wall", clause, lifts);
        let clause = self.both("EN 1998-5:2004 5.4.1.1".into(), "E.7.6");
        self.add(SLIDING, "Sliding on the foundation", clause, Required);
    }

    /// Only of tanks on them.
    fn isolators(&mut self) {
        if self.case.tank.isolators.is_none() {
            return;
        }
        if self.codes.ec8 {
            let clause = "EN 1998-1:2004 10.3, 10.10".to_owned();
            self.add(ISOLATORS, "Displacement of the isolators", clause, Required);
        }
        if self.codes.api {
            let name = "Displacement of the isolators in the maximum considered earthquake";
            self.add(
                "isolator_displacement_mce",
                name,
                "ASCE 7-16 17.5.3".into(),
                NotImplemented,
            );
        }
        let ec8 = self.codes.ec8.then_some("EN 1998-1:2004 10.10");
        let api = self.codes.api.then_some("ASCE 7-16 17.2.4.6");
        let clause: Vec<&str> = ec8.into_iter().chain(api).collect();
        self.add(TENSION, "Tension of the outermost bearing", clause.join(", "), Required);
    }

    /// What the codes ask for and the engine has no demand for.
    fn others(&mut self) {
        if self.codes.ec8 {
            let ground = "EN 1998-5:2004 5.4.1.1".to_owned();
            let bearing = match self.case.tank.isolators {
                Some(_) => NotImplemented,
                None => Required,
            };
            self.add(BEARING, "Bearing of the ground", ground, bearing);
            let name = "Differential displacement of pipes";
            self.add("pipes", name, main("4.5.2.3"), NotImplemented);
            let reason = "the record is one ground motion; the damage limitation state has a seismic action of its own";
            let name = "Damage limitation state";
            self.add("damage_limitation", name, main("2.1.3"), NotApplicable(reason.into()));
        }
        if self.codes.api {
            let name = "Overturning of the foundation";
            self.add("foundation", name, format!("{API} E.6.2.3"), NotImplemented);
            let name = "Flexibility of the piping";
            self.add("piping", name, format!("{API} E.7.3"), NotImplemented);
        }
    }
}

/// What the code of a site asks of the records under which an engine decides, and the code whose rule that is; none without a site.
pub fn ground_motion(case: &Case) -> Option<(LimitState, Standard)> {
    let code = match (&case.site.ec8, &case.site.api650) {
        (Some(_), _) => Standard::En1998,
        (None, Some(_)) => Standard::Asce716,
        (None, None) => return None,
    };
    let state = LimitState {
        id: "ground_motion",
        name: "Records against the design spectrum of the site",
        clause: code.clause().into(),
        requirement: Required,
    };
    Some((state, code))
}

/// All limit states of a case.
pub fn limit_states(case: &Case, codes: Codes) -> Vec<LimitState> {
    let mut list = List {
        case,
        codes,
        states: Vec::new(),
    };
    list.surface();
    list.wall();
    list.plates();
    list.base();
    list.isolators();
    list.others();
    list.states
}
