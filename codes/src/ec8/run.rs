//! Eurocode 8 as the judge of a run: EN 1998-4:2006 with the wall of its annex A.10.

use tank::Course;
use tank::assessment::CheckStatus;
use tank::assessment::Requirement::{self, NotApplicable, NotImplemented, Required};
use tank::case::{Case, Site};
use tank::units::Dimension::Stress;

use super::bearing::RESISTANCE;
use super::buckling::{Wall, collapse_lines, elastic_lines};
use super::limit_states::{
    ANCHOR_COUNT, ANCHOR_SPACING, BEARING, CRACKS, DAMAGE, ELASTIC_BUCKLING, ELEPHANT_FOOT, HOOP, MATERIAL,
    OVERTURNING, PIPES, SNOW, SOIL, WALL_BENDING, WALL_SHEAR,
};
use super::plate_uplift::ROTATION;
use super::{En2006, Env1998};
use crate::code::{Answer, Code, Friction, Limit, Open, Placed, WallLimit, WallStress, without_strength};
use crate::limit_state::{ASKED, LimitStateDef};
use crate::procedure::Procedure;
use crate::record_set::standard::Standard;
use crate::time_history::limit_states::{
    ANCHORS, FREEBOARD, ISOLATORS, OTHER_WALL, ROOF, SLIDING, TENSION, UPLIFT, shells,
};

/// EN 1998.
#[derive(Clone, Copy, Debug)]
pub struct Eurocode8;

/// Quality of construction without `site.ec8`: normal, the lowest.
const NORMAL: f64 = 1.0;
/// Path of the friction.
const FRICTION: &str = "site.ec8.friction";
/// Magnification γ_x of the displacement of isolators (EN 1998-1:2004 10.3(2), recommended value).
const MAGNIFICATION: f64 = 1.2;

const TABLE: &[Placed] = &[
    (10, FREEBOARD.by("EN 1998-4:2006 A.2.1.4")),
    (11, ROOF.by("EN 1998-4:2006 A.2.1.4")),
    (30, HOOP.when(shells)),
    (31, ELASTIC_BUCKLING.when(shells)),
    (32, ELEPHANT_FOOT.when(shells)),
    (51, GAS_PRESSURE),
    (80, ANCHORS.by("EN 1998-4:2006 4.5.1.3")),
    (81, UPLIFT.by("EN 1998-4:2006 A.9")),
    (82, SLIDING.by("EN 1998-5:2004 5.4.1.1")),
    (90, ISOLATORS.by("EN 1998-1:2004 10.3, 10.10")),
    (92, TENSION.by("EN 1998-1:2004 10.10")),
    (100, BEARING.when(on_ground)),
    (100, PIPES.when(|_| NotImplemented)),
    (100, DAMAGE.when(other_action)),
];

/// The uplift of a wall that lifts is not among them: a run gives the rotation of the joint, not membrane stress and lifted width.
const ANSWERS: &[(&str, Answer)] = &[
    (WALL_BENDING.id, Answer::Run(OTHER_WALL.id)),
    (WALL_SHEAR.id, Answer::Run(OTHER_WALL.id)),
    (CRACKS.id, Answer::Run(OTHER_WALL.id)),
    (ANCHOR_COUNT.id, Answer::Code),
    (ANCHOR_SPACING.id, Answer::Code),
    (OVERTURNING.id, Answer::Run(UPLIFT.id)),
    (MATERIAL.id, Answer::Code),
    (SOIL.id, Answer::Code),
    (SNOW.id, Answer::Code),
];

const GAS_PRESSURE: LimitStateDef = LimitStateDef {
    id: "gas_pressure",
    name: "Stresses with the pressure above the liquid",
    clause: "EN 1998-4:2006 A.10.2",
    applies: |_| NotImplemented,
    exists: |case| !case.tank.pressure.is_none(),
    demand: "stresses with the pressure above the liquid",
    capacity: "not compared by the engines; the procedures do",
    dimension: Stress,
    page: 200,
    ..ASKED
};

/// Bearings stand on the ground in place of the tank.
fn on_ground(case: &Case) -> Requirement {
    match case.tank.isolators {
        Some(_) => NotImplemented,
        None => Required,
    }
}

fn other_action(_: &Case) -> Requirement {
    let reason = "the record is one ground motion; the damage limitation state has a seismic action of its own";
    NotApplicable(reason.into())
}

impl Code for Eurocode8 {
    fn procedures(&self) -> &'static [&'static dyn Procedure] {
        &[&Env1998, &En2006]
    }

    fn in_force(&self) -> &'static dyn Procedure {
        &En2006
    }

    fn named(&self, site: &Site) -> bool {
        site.ec8.is_some()
    }

    fn of_run(&self) -> &'static [Placed] {
        TABLE
    }

    fn answers(&self) -> &'static [(&'static str, Answer)] {
        ANSWERS
    }

    fn wall<'a>(&self, case: &'a Case, radius: f64) -> Vec<WallLimit<'a>> {
        let quality = case.site.ec8.map_or(NORMAL, |site| site.construction_quality);
        let strength = |course: &Course| course.material.yield_strength.unwrap_or_default();
        let wall = move |course: &Course| Wall {
            youngs_modulus: course.material.youngs_modulus,
            yield_strength: strength(course),
            thickness: course.net_thickness(),
            radius,
            quality,
        };
        let missing = without_strength(case);
        let limit = |state, stress, limit| WallLimit { state, stress, missing: missing.clone(), limit };
        let pressed = "interior pressure there and then, static and seismic";
        let run = "the run of the engine";
        let yielding: Limit<'a> = Box::new(move |sheet, course, _| {
            sheet.input("f_y", "yield strength", strength(course), Stress, "materials")
        });
        let buckling: Limit<'a> = Box::new(move |sheet, course, p| {
            sheet.input("p_min", pressed, p, Stress, run);
            elastic_lines(sheet, &wall(course), p, ELASTIC_BUCKLING.clause)
        });
        let collapse: Limit<'a> = Box::new(move |sheet, course, p| {
            let p = sheet.input("p_max", pressed, p.max(0.0), Stress, run);
            collapse_lines(sheet, &wall(course), p, ELEPHANT_FOOT.clause)
        });
        vec![
            limit(HOOP.named("Hoop stress below yield"), WallStress::Hoop, yielding),
            limit(ELASTIC_BUCKLING, WallStress::Compression, buckling),
            limit(ELEPHANT_FOOT, WallStress::Compression, collapse),
        ]
    }

    fn friction(&self, case: &Case) -> Result<Friction, Open> {
        match case.site.ec8.and_then(|site| site.friction) {
            Some(coefficient) => {
                Ok(Friction { id: SLIDING.id, name: SLIDING.name, coefficient, clause: "EN 1998-5:2004 5.4.1.1" })
            }
            None => Err(Open {
                status: CheckStatus::NotChecked,
                reason: format!("`{FRICTION}` is missing"),
                input: Some(FRICTION),
            }),
        }
    }

    fn joint_rotation(&self) -> Result<f64, &'static str> {
        Ok(ROTATION)
    }

    fn bearing_resistance(&self, case: &Case) -> Option<Result<f64, &'static str>> {
        let given = case.site.ec8.and_then(|site| site.bearing_capacity);
        Some(given.ok_or(RESISTANCE))
    }

    fn isolator_factor(&self) -> Option<f64> {
        Some(MAGNIFICATION)
    }

    fn record_rules(&self) -> Standard {
        Standard::En1998
    }

    fn asks_vertical(&self, site: &Site) -> bool {
        site.ec8.is_some_and(|site| site.vertical)
    }

    fn notes(&self, case: &Case) -> Vec<String> {
        match self.named(&case.site) {
            true => Vec::new(),
            false => vec![
                "`site` is not given: the wall is judged by EN 1998-4 A.10 with its lowest quality of construction (a = 1)."
                    .into(),
            ],
        }
    }
}
