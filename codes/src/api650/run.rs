//! API 650 as the judge of a run: the capacities of the current annex E.

use tank::assessment::Requirement::{self, NotImplemented};
use tank::assessment::{Check, CheckStatus};
use tank::case::{Case, Site};
use tank::units::Dimension::{Dimensionless, Force, Length, Stress};
use tank::{Course, Support};

use super::edition1993::Api6501993;
use super::edition2020::limit_states::{
    ANCHORAGE, ANCHORS as ANCHOR_TENSION, ANNULAR_WELD, BEARING, COMPRESSION, COUNT, FOUNDATION, HOOP, INTERNALS,
    MATERIAL, NEIGHBOURS, PIPING, PRESSURE, SNOW, SPACING, STUDY, SUPPORT, UPPER_COMPRESSION, VACUUM, carbon_steel,
};
use super::edition2020::{Api6502020, details_of_base, hoop_check};
use super::hold_down;
use crate::code::{Answer, Code, Friction, Open, Placed, WallLimit, WallStress, without_strength};
use crate::limit_state::{ASKED, LimitStateDef, Part};
use crate::procedure::Procedure;
use crate::record_set::standard::Standard;
use crate::sheet::{Sheet, with_unit};
use crate::time_history::limit_states::{ANCHORS, FREEBOARD, ROOF, SLIDING, TENSION, UPLIFT, shells};

/// API 650.
#[derive(Clone, Copy, Debug)]
pub struct Api650;

/// Largest friction (E.7.6).
const LARGEST_FRICTION: f64 = 0.4;

const TABLE: &[Placed] = &[
    (10, FREEBOARD.by("API 650:2020 E.7.2")),
    (11, ROOF.by("API 650:2020 E.7.2")),
    (40, HOOP.when(shells)),
    (41, SHELL),
    (41, OTHER_SHELL),
    (50, DESIGN_PRESSURE),
    (80, ANCHORS.by("API 650:2020 E.6.2.1.2")),
    (81, UPLIFT.by("API 650:2020 E.6.2.1.1")),
    (82, LimitStateDef { parts: &[SLIDING_OF_RUN], ..SLIDING.by("API 650:2020 E.7.6") }),
    (91, MCE),
    (92, TENSION.by("ASCE 7-16 17.2.4.6")),
    (100, FOUNDATION.when(|_| NotImplemented)),
    (100, PIPING.when(|_| NotImplemented)),
];

const ANSWERS: &[(&str, Answer)] = &[
    (UPPER_COMPRESSION.id, Answer::Run(SHELL.id)),
    (ANCHORAGE.id, Answer::Run(UPLIFT.id)),
    (ANNULAR_WELD.id, Answer::Code),
    (ANCHOR_TENSION.id, Answer::Run(ANCHORS.id)),
    (COUNT.id, Answer::Code),
    (SPACING.id, Answer::Code),
    (BEARING.id, Answer::Open(BEARING_OF_RUN)),
    (SUPPORT.id, Answer::Code),
    (MATERIAL.id, Answer::Code),
    (PRESSURE.id, Answer::Run(DESIGN_PRESSURE.id)),
    (VACUUM.id, Answer::Code),
    (INTERNALS.id, Answer::Code),
    (NEIGHBOURS.id, Answer::Code),
    (SNOW.id, Answer::Code),
    (STUDY.id, Answer::Code),
];

const BEARING_OF_RUN: LimitStateDef = LimitStateDef {
    id: "bearing_api",
    name: "Pressure on the ground, API 650",
    capacity: "not compared by the engines: the procedure of API 650 does",
    page: 381,
    ..BEARING
};

const SHELL: LimitStateDef = LimitStateDef {
    name: "Compression of the shell",
    clause: "API 650:2020 E.6.2.2.3",
    applies: shells,
    exists: carbon_steel,
    ..COMPRESSION
};

const OTHER_SHELL: LimitStateDef = LimitStateDef {
    clause: "API 650:2020 annex AL",
    applies: other_metals,
    exists: |case| !carbon_steel(case),
    ..SHELL
};

const SLIDING_OF_RUN: Part = Part {
    id: "sliding_api",
    name: "Sliding on the foundation, API 650",
    demand: "horizontal force on the foundation of a run",
    capacity: "resistance of API 650 E.7.6, with its friction and vertical acceleration",
    dimension: Force,
};

const DESIGN_PRESSURE: LimitStateDef = LimitStateDef {
    id: "design_pressure",
    name: "Hoop stress and anchors with the design pressure",
    clause: "API 650:2020 F.7",
    applies: |_| NotImplemented,
    exists: |case| case.site.api650.is_some_and(|site| site.design_pressure > 0.0),
    demand: "hoop stress and anchors with the design pressure",
    capacity: "not compared by the engines",
    dimension: Stress,
    page: 190,
    ..ASKED
};

const MCE: LimitStateDef = LimitStateDef {
    id: "isolator_displacement_mce",
    name: "Displacement of the isolators in the maximum considered earthquake",
    clause: "ASCE 7-16 17.5.3",
    applies: |_| NotImplemented,
    exists: |case| case.tank.isolators.is_some(),
    demand: "displacement of the isolators in the maximum considered earthquake of ASCE 7, with the torsion of the plan",
    capacity: "not compared: the record is the design earthquake",
    dimension: Length,
    page: 470,
    ..ASKED
};

fn other_metals(case: &Case) -> Requirement {
    match shells(case) {
        Requirement::Required => NotImplemented,
        not => not,
    }
}

impl Code for Api650 {
    fn procedures(&self) -> &'static [&'static dyn Procedure] {
        &[&Api6501993, &Api6502020]
    }

    fn in_force(&self) -> &'static dyn Procedure {
        &Api6502020
    }

    fn named(&self, site: &Site) -> bool {
        site.api650.is_some()
    }

    fn of_run(&self) -> &'static [Placed] {
        TABLE
    }

    fn answers(&self) -> &'static [(&'static str, Answer)] {
        ANSWERS
    }

    fn apart(&self, case: &Case) -> Vec<Check> {
        details_of_base(case)
    }

    fn always_anchors(&self) -> bool {
        true
    }

    fn wall<'a>(&self, case: &'a Case, radius: f64) -> Vec<WallLimit<'a>> {
        let efficiency = case.site.api650.map_or(1.0, |site| site.joint_efficiency);
        let allowable = move |course: &Course| hoop_check::allowable(&course.material, efficiency);
        let mut limits = vec![WallLimit {
            state: HOOP,
            stress: WallStress::Hoop,
            missing: case.tank.courses.iter().find_map(|course| allowable(course).err()),
            limit: Box::new(move |sheet, course, _| {
                let source = "lesser of 1.33 S_d e and 0.9 F_y e";
                let name = "allowable hoop stress with the earthquake";
                let value = allowable(course).unwrap_or_default();
                sheet.look_up("σ_a", name, source, value, Stress, HOOP.clause)
            }),
        }];
        if carbon_steel(case) {
            limits.push(WallLimit {
                state: SHELL,
                stress: WallStress::Compression,
                missing: without_strength(case),
                limit: Box::new(move |sheet, course, p| compression(sheet, case, radius, course, p)),
            });
        }
        limits
    }

    fn friction(&self, case: &Case) -> Result<Friction, Open> {
        let clause = "API 650:2020 E.7.6";
        match (case.tank.support, case.site.api650) {
            (Support::Unanchored, Some(site)) => Ok(Friction {
                id: SLIDING_OF_RUN.id,
                name: SLIDING_OF_RUN.name,
                coefficient: site.friction.min(LARGEST_FRICTION),
                clause,
            }),
            _ => Err(Open {
                status: CheckStatus::NotApplicable,
                reason: format!("{clause}: the check is for self-anchored tanks"),
                input: None,
            }),
        }
    }

    fn joint_rotation(&self) -> Result<f64, &'static str> {
        Err("API 650 judges uplift by the anchorage ratio of its annex, not by a time history")
    }

    fn record_rules(&self) -> Standard {
        Standard::Asce716
    }

    fn notes(&self, _case: &Case) -> Vec<String> {
        vec![
            "API 650:2020 E.1: a dynamic analysis with interaction of liquid and wall may take the place of the annex if \
             the purchaser agrees and the tank is as safe as by the annex; E.4.3 and ASCE 7 keep a site-specific spectrum at \
             or above 80 % of the mapped one, and a design needs several records, not one."
                .into(),
        ]
    }
}

/// Lines of the allowable compression F_C at an interior pressure [Pa]; returns it [Pa].
fn compression(sheet: &mut Sheet, case: &Case, radius: f64, course: &Course, pressure: f64) -> f64 {
    let (clause, density) = (SHELL.clause, case.liquid.density);
    let depth = pressure.max(0.0) / (density * case.gravity);
    let source = format!("{} of interior pressure there and then", with_unit(pressure, Stress));
    sheet.look_up("H", "depth with that pressure", &source, depth, Length, clause);
    sheet.given(&[
        ("t_s", course.net_thickness(), Length),
        ("D", 2.0 * radius, Length),
        ("G", density / 1000.0, Dimensionless),
        ("F_ty", course.material.yield_strength.unwrap_or_default(), Stress),
    ]);
    let name = "pressure parameter of the shell, D and H in m, t_s in mm";
    let ratio = sheet.calc("G·H·D²/t_s²", name, hold_down::SLENDERNESS, Dimensionless, clause);
    let formula = hold_down::allowable(ratio, true, false).unwrap_or_default();
    sheet.calc("F_C", "allowable shell compression", formula, Stress, clause)
}
