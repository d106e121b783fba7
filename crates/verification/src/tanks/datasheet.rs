//! Weights of a complete datasheet: roof on columns with snow, rings, attachments, insulation.
//!
//! Source:    statics; API 650 E.2.2; EN 1998-1:2004 3.2.4 with EN 1990:2002 table A1.1
//! Model:     `tank::Tank`, the sheets of `api650-2020` and `ec8-2006`
//! Reference: the share of the wall by summing the plan square by square; all other numbers by hand from the numbers of the datasheet
//! Tolerance: 1e-4 of the sum over squares (2000 of them a radius), 1e-6 of sums by hand with seven digits

use codes::Procedure;
use codes::api650::edition2020::Api6502020;
use codes::ec8::En2006;
use tank::assessment::{Assessment, Excitation};
use tank::case::{Api650Site, Case, Ec8Site, GroundType, SiteClass};
use tank::{Attachment, Insulation, Ring, Roof, RoofKind, Shape, SnowLoad, Support, reference};

use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "datasheet-weights",
    title: "Weights of a complete datasheet",
    model: "Steel tank, R = 20 m, wall 12 m of five courses (14, 12, 10, 8, 8 mm), top angle of 24 cm² at 12 m, wind girder of 400 × 8 mm at \
            10.8 m, stairs of 2.4 t at 6 m, ladder of 300 kg at 7 m, platform of 800 kg at 12 m, insulation of 15 kg/m²; cone roof of 60 t with \
            a rise of 1.25 m on columns whose outermost ring is at 8 m, snow of 1.2 kPa; g = 9.81 m/s².",
    ids: &[
        ("WG1", "share of the roof's weight on the wall"),
        ("WG2", "masses and their moments"),
        ("WG3", "API 650: W_r, w_rs and w_t with snow"),
        ("WG4", "EN 1998: m_r with ψ_E, and the weight that holds down"),
    ],
    parts: &[Part::Fast(shares), Part::Fast(masses), Part::Fast(codes)],
};

/// Outermost columns over the radius.
const RATIO: f64 = 0.4;

/// The share by the lever rule, square by square of a quarter of the plan.
fn by_squares(ratio: f64) -> f64 {
    const SQUARES: u32 = 2000;
    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(SQUARES);
    let (mut on_wall, mut all) = (0.0, 0.0);
    for i in 0..SQUARES {
        for j in 0..SQUARES {
            let r = middle(i).hypot(middle(j));
            if r < 1.0 {
                all += 1.0;
                on_wall += ((r - ratio) / (1.0 - ratio)).max(0.0);
            }
        }
    }
    on_wall / all
}

fn shares() -> Answer {
    let mut rows: Vec<Row> = [0.0, 0.25, RATIO, 0.8]
        .into_iter()
        .map(|ratio| {
            let reference = (by_squares(ratio), "sum over the plan, lever rule", Reference::SecondFormulation);
            let what = format!("outermost columns at {ratio} R");
            Row::new("WG1", what, reference, Roof::share_of_wall(ratio), (1e-4, ""))
        })
        .collect();
    // A triangle of load on a simple beam brings two thirds to the end where it is largest.
    let reference = (2.0 / 3.0, "simple beam under a triangle of load", Reference::ClosedForm);
    let what = "one column in the middle, two thirds";
    rows.push(Row::new("WG1", what, reference, Roof::share_of_wall(0.0), (1e-12, "")));
    Ok(rows)
}

fn tank() -> Case {
    let steel = reference::material(210e9, 0.3, 7850.0);
    let courses = [14.0, 12.0, 10.0, 8.0, 8.0].map(|mm| (2.4, mm * 1e-3));
    let mut case = reference::case(Shape::Cylinder { radius: 20.0 }, &courses, &steel, (900.0, 10.5));
    let tank = &mut case.tank;
    tank.support = Support::Unanchored;
    let ring = |height, area: f64, inertia| Ring { height, area, inertia, material: steel.clone() };
    tank.rings = vec![ring(12.0, 24e-4, 820e-8), ring(10.8, 0.4 * 8e-3, 8e-3 * 0.4_f64.powi(3) / 12.0)];
    let attachment = |name: &str, mass, height| Attachment { name: name.into(), mass, height };
    tank.attachments =
        vec![attachment("stairs", 2400.0, 6.0), attachment("ladder", 300.0, 7.0), attachment("platform", 800.0, 12.0)];
    let insulation = Insulation { mass: 15.0, height: None };
    insulation.cover(&mut tank.courses);
    tank.insulation = Some(insulation);
    tank.roof = Roof {
        mass: 60e3,
        kind: RoofKind::Cone,
        rise: Some(1.25),
        columns: Some(8.0),
        on_columns: 1.0 - Roof::share_of_wall(RATIO),
        snow: Some(SnowLoad { load: 1200.0, combination: 0.2, bare: 60e3, mass: 0.0 }),
        ..Roof::default()
    };
    case.site.ec8 = Some(Ec8Site {
        ground: GroundType::B,
        spectrum: 1,
        ag: 0.2 * reference::GRAVITY,
        importance: 1.0,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: Some(0.4),
        reduction_factor: None,
        bearing_capacity: None,
    });
    case.site.api650 = Some(Api650Site {
        ss: 0.9,
        s1: 0.4,
        s0: None,
        site_class: SiteClass::D,
        asce7: 2010,
        fa: None,
        fv: None,
        q: 2.0 / 3.0,
        sug: 1,
        tl: 8.0,
        av: None,
        design_pressure: 0.0,
        joint_efficiency: 1.0,
        friction: 0.4,
        foundation_weight: None,
        bearing_capacity: None,
        zone_factor: None,
        soil_factor: 1.5,
        importance_1993: 1.0,
    });
    case
}

/// A row against a number by hand.
fn by_hand(id: &str, what: &str, reference: f64, computed: f64, unit: &'static str) -> Row {
    Row::new(id, what, (reference, "by hand", Reference::ClosedForm), computed, (1e-6, unit))
}

fn masses() -> Answer {
    let tank = tank().tank;
    let (mass, moment) = tank.mass_above(0.0);
    Ok(vec![
        by_hand("WG2", "insulation, 15 kg/m² · 2π·20 m · 12 m", 22_619.467_11, tank.insulation_mass(), "kg"),
        by_hand("WG2", "wall with rings, attachments and insulation", 154_753.863_3, tank.wall_mass(), "kg"),
        by_hand("WG2", "height of its centre", 5.635_194_181, tank.wall_centroid(), "m"),
        by_hand("WG2", "height of the roof, 12 m + 1.25 m/3", 12.416_666_67, tank.roof_height(), "m"),
        by_hand("WG2", "wall and roof, what moves", 154_753.863_3 + 60e3, mass, "kg"),
        by_hand("WG2", "its moment about the bottom", 872_068.069_8 + 60e3 * 12.416_666_67, moment, "kg·m"),
        by_hand("WG2", "wall and roof, what the wall carries", 154_753.863_3 + 28.8e3, tank.weight_above(0.0), "kg"),
    ])
}

/// Value of a line of a sheet.
fn line(sheet: &Assessment, symbol: &str) -> Answer<f64> {
    let step = sheet.steps.iter().find(|step| step.symbol == symbol);
    step.map(|step| step.value).ok_or_else(|| Failure::from(format!("no line {symbol}")))
}

fn codes() -> Answer {
    let case = tank();
    let assess = |procedure: &dyn Procedure| {
        procedure.assess(&case, Excitation::Site).map_err(|error| Failure::from(error.to_string()))
    };
    let (api, eurocode) = (assess(&Api6502020)?, assess(&En2006)?);
    Ok(vec![
        by_hand("WG3", "W_r = g·60 t + 0.1·1.2 kPa·π·(20 m)²", 739_396.447_4, line(&api, "W_r")?, "N"),
        by_hand("WG3", "W_rs = 0.48·W_r", 354_910.294_7, line(&api, "W_rs")?, "N"),
        by_hand("WG3", "w_t = (W_s + W_rs)/(π·40 m)", 14_905.224_04, line(&api, "w_t")?, "N/m"),
        by_hand("WG4", "m_r = 60 t + 0.2·1.2 kPa·π·(20 m)²/g", 90_743.414_35, line(&eurocode, "m_r")?, "kg"),
        by_hand("WG4", "w_t, without snow", 14_329.224_04, line(&eurocode, "w_t")?, "N/m"),
    ])
}
