//! Weights of a roof with snow on columns, by hand from the numbers of the tank alone.

use std::f64::consts::PI;

use crate::api650::edition1993::Api6501993;
use crate::api650::edition2020::Api6502020;
use crate::ec8::{En2006, Env1998};
use crate::procedure::Procedure;
use tank::assessment::{Assessment, CheckStatus, Excitation, Requirement};
use tank::case::{Case, ZoneSite};
use tank::{Attachment, Insulation, Ring, Roof, RoofKind, SnowLoad, Support};

const SNOW: f64 = 1200.0;
/// ρ = 6/15: (1 − 0.4)(2 + 0.4)/3.
const SHARE: f64 = 0.48;

fn line(a: &Assessment, symbol: &str) -> f64 {
    let step = a.steps.iter().find(|step| step.symbol == symbol);
    step.unwrap_or_else(|| panic!("no line {symbol}")).value
}

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} instead of {expected}");
}

/// The roof of 35 t under 1.2 kPa of snow, its outermost columns at 6 m of 15 m.
fn covered(case: Case) -> Case {
    let mut case = case;
    let bare = case.tank.roof.mass;
    case.tank.roof = Roof {
        kind: RoofKind::Cone,
        columns: Some(6.0),
        on_columns: 1.0 - Roof::share_of_wall(0.4),
        snow: Some(SnowLoad { load: SNOW, combination: 0.2, bare, mass: 0.0 }),
        live_load: Some(1000.0),
        ..case.tank.roof
    };
    case
}

fn said(a: &Assessment, part: &str) -> bool {
    a.assumptions.iter().any(|text| text.contains(part))
}

#[test]
fn api_has_a_tenth_of_the_snow_and_the_part_on_the_shell() {
    let case = covered(crate::api650::example::case());
    let (g, area) = (case.gravity, PI * 225.0);
    let w_r = g * 35e3 + 0.1 * SNOW * area;
    let w_s = g * case.tank.wall_mass();
    let a = Api6502020.assess(&case, Excitation::Site).unwrap();
    near(line(&a, "W_r"), w_r);
    near(line(&a, "f_s"), SHARE);
    near(line(&a, "W_rs"), SHARE * w_r);
    near(line(&a, "w_t"), (w_s + SHARE * w_r) / (PI * 30.0));
    // The whole roof moves with the shell, and all of it presses on the ground.
    near(line(&a, "V_i"), line(&a, "A_i") * (w_s + w_r + line(&a, "W_f") + line(&a, "W_i")));
    assert!(said(&a, "W_r of API 650:2020 E.2.2 has none") && said(&a, "Columns carry 52 %"));
    assert!(!said(&a, "The shell carries the whole roof"));
    // The procedure replaces the share in the case by its own.
    let again = Api6502020.assess(&case.with_snow(0.7), Excitation::Site).unwrap();
    assert_eq!(a.values, again.values);
    let states = Api6502020.limit_states(&case);
    let state = |id: &str| states.iter().find(|state| state.id == id).unwrap().requirement.clone();
    assert!(matches!(state("snow"), Requirement::NotApplicable(why) if why.contains("snow load")));
    assert_eq!(state("internals"), Requirement::NotImplemented);
}

#[test]
fn the_ninth_edition_has_the_same_weights() {
    let mut case = covered(crate::api650::example::case());
    case.site.zone = Some(ZoneSite { zone_factor: 0.3, soil_factor: 1.2, importance: 1.0 });
    let a = Api6501993.assess(&case, Excitation::Site).unwrap();
    let w_r = case.gravity * 35e3 + 0.1 * SNOW * PI * 225.0;
    near(line(&a, "W_r"), w_r);
    near(line(&a, "w_t"), (case.gravity * case.tank.wall_mass() + SHARE * w_r) / (PI * 30.0));
    assert!(said(&a, "leaves the portion of the snow in W_r to the purchaser"));
}

#[test]
fn eurocode_counts_snow_in_the_mass_and_not_in_what_holds() {
    for procedure in [&En2006 as &dyn Procedure, &Env1998] {
        let mut case = covered(crate::ec8::example::oil_tank());
        case.tank.support = Support::Unanchored;
        case.site.ec8.as_mut().unwrap().friction = Some(0.4);
        let (g, area) = (case.gravity, PI * 225.0);
        let snow = 0.2 * SNOW * area / g;
        let a = procedure.assess(&case, Excitation::Site).unwrap();
        near(line(&a, "m_r"), 35e3 + snow);
        near(line(&a, "m_rs"), SHARE * (35e3 + snow));
        near(line(&a, "m_rh"), 35e3);
        let a_v = if line(&a, "w_t") > 0.0 { weight_factor(&a, &case) } else { 1.0 };
        near(line(&a, "w_t"), a_v * (case.tank.wall_mass() + SHARE * 35e3) * g / (2.0 * PI * 15.0));
        assert!(said(&a, "category H") && said(&a, "Columns carry 52 %"));
        let states = procedure.limit_states(&case);
        let columns = states.iter().find(|state| state.id == "roof_columns").unwrap();
        assert_eq!(columns.requirement, Requirement::NotImplemented);
        assert!(procedure.limit_states(&crate::ec8::example::oil_tank()).iter().all(|s| s.id != "roof_columns"));
    }
}

/// 1 − 0.3 A_v/g of the line w_t; A_v is on the sheet where the vertical motion counts.
fn weight_factor(a: &Assessment, case: &Case) -> f64 {
    let vertical = a.steps.iter().find(|step| step.symbol == "A_v");
    vertical.map_or(1.0, |step| 1.0 - 0.3 * step.value / case.gravity)
}

/// Rings, attachments and insulation of a complete tank: W_s and X_s, course by course.
#[test]
fn what_the_wall_carries_counts_with_the_shell() {
    let mut case = crate::api650::example::case();
    let steel = case.tank.courses[0].material.clone();
    let bare: Vec<(f64, f64)> =
        case.tank.courses.iter().map(|c| (c.height, c.thickness * c.material.density)).collect();
    case.tank.rings = vec![Ring { height: 12.0, area: 24e-4, inertia: 820e-8, material: steel }];
    case.tank.attachments = vec![Attachment { name: "stairs".into(), mass: 1200.0, height: 5.0 }];
    case.tank.insulation = Some(Insulation { mass: 15.0, height: None });
    Insulation { mass: 15.0, height: None }.cover(&mut case.tank.courses);
    let around = 30.0 * PI;
    let (mut mass, mut moment, mut base) = (1200.0, 1200.0 * 5.0, 0.0);
    for (height, per_area) in bare {
        let course = around * height * (per_area + 15.0);
        mass += course;
        moment += course * (base + 0.5 * height);
        base += height;
    }
    let ring = around * 24e-4 * 7850.0;
    (mass, moment) = (mass + ring, moment + 12.0 * ring);
    let a = Api6502020.assess(&case, Excitation::Site).unwrap();
    near(line(&a, "W_s"), case.gravity * mass);
    near(line(&a, "X_s"), moment / mass);
    for part in ["that of its rings", "attachments, 1200 kg", "insulation, 15 kg/m² of wall"] {
        assert!(said(&a, part), "{part}: {:?}", a.assumptions);
    }
    let open = |a: &Assessment| a.checks.iter().filter(|check| check.status == CheckStatus::NotChecked).count();
    assert_eq!(open(&a), open(&Api6502020.assess(&crate::api650::example::case(), Excitation::Site).unwrap()));
}
