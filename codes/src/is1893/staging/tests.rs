//! Masses of published models of elevated tanks; periods against the determinant of the coupled masses; resultants by hand; R by kind; the other
//! procedures.

use std::f64::consts::{PI, TAU};

use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::Case;
use tank::national::{Is1893Site, Soil, Zone};
use tank::quantity::Quantity;
use tank::{Shape, Staging, StagingKind};

use crate::is1893::Is18932014;
use crate::procedure::Procedure;
use crate::samples::{case, course, near};
use crate::two_mass::tests::{assessed, concrete, line};

fn staging(kind: StagingKind) -> Staging {
    Staging { kind, stiffness: 17e6, mass: 110e3, height: 16.0, floor_mass: 75e3, floor_centre: -0.2, columns: Some(6) }
}

/// A cylinder of concrete on a staging: zone IV, medium soil, g = 9.81 m/s².
fn elevated(diameter: f64, depth: f64, kind: StagingKind) -> Case {
    let shape = Shape::Cylinder { radius: 0.5 * diameter };
    let mut case = case(shape, vec![course(depth + 0.5, 0.2, concrete(27e9, 24.5e3))], depth, None);
    case.tank.roof.mass = 32e3;
    case.tank.staging = Some(staging(kind));
    let site = Is1893Site { zone: Zone::IV, soil: Soil::Medium, importance: 1.5, response_reduction: None };
    case.site.is1893 = Some(site);
    case
}

/// Two public OpenSees models of tanks on frames of four columns, "mass_impulsive_water" and "mass_convective_water" (kg) for 750 m³ and 100 m³
/// and the height of the convective mass with base pressure. Diameters are those that give both masses, 12.45 and 7.5 m; half of each printed
/// digit.
#[test]
fn masses_of_published_models() {
    for (diameter, volume, impulsive, convective) in
        [(12.45, 750.0, 403_432.0, 330_800.0), (7.5, 100.0, 34_626.3, 61_293.9)]
    {
        let depth = volume / (0.25 * PI * diameter * diameter);
        let out = assessed(&Is18932014, &elevated(diameter, depth, StagingKind::DuctileRcFrame));
        // Diameters of three digits: 1e-5 of the masses.
        near(line(&out, "m_i") / impulsive, 1.0, 2e-5, "m_i");
        near(line(&out, "m_c") / convective, 1.0, 2e-5, "m_c");
        if volume == 100.0 {
            near(line(&out, "h_c′"), 2.7562, 1e-4, "h_c′");
        }
        // Their K_c is 0.836 m g/h tanh²u, 0.836 a rounded 0.23·3.68 = 0.8464: the period is 0.6 % longer.
        let spring = 0.836 * volume * 1e3 * 9.81 / depth * line(&out, "u").tanh().powi(2);
        let printed = if volume == 100.0 { 234.37e3 } else { 899.045e3 };
        // Half of the fifth digit of 234.37 kN/m, and the diameter.
        near(spring / printed, 1.0, 3.2e-5, "K_c");
        let period = TAU * (convective / printed).sqrt();
        near(period / line(&out, "T_c"), (0.8464_f64 / 0.836).sqrt(), 1e-4, "T_c");
    }
}

/// A staging as slow as the sloshing, on which the base shear of uncoupled masses is 0.61 of that of the coupled ones: its wave is not judged.
#[test]
fn a_staging_near_the_sloshing_leaves_the_wave_open() {
    let mut tank = elevated(8.6, 4.3, StagingKind::DuctileRcFrame);
    let freeboard = |tank: &Case| assessed(&Is18932014, tank).checks.into_iter().find(|c| c.id == "freeboard").unwrap();
    assert!(freeboard(&tank).compared());
    tank.tank.staging.as_mut().unwrap().stiffness = 1e6;
    let open = freeboard(&tank);
    assert!(open.status == CheckStatus::NotChecked && open.reason.contains("at least 2.5"), "{open:?}");
}

/// The determinant of the masses m_i + m_s and m_c on K_s and m_c ω_c² is zero at both periods.
#[test]
fn coupled_periods() {
    for stiffness in [1e6, 17e6, 400e6] {
        let mut case = elevated(8.6, 4.3, StagingKind::DuctileRcFrame);
        case.tank.staging.as_mut().unwrap().stiffness = stiffness;
        let out = assessed(&Is18932014, &case);
        let of = |symbol| line(&out, symbol);
        let (mass, sloshing) = (of("m_i") + of("m_s"), of("m_c"));
        let spring = sloshing * (TAU / of("T_c")).powi(2);
        for symbol in ["T_1", "T_2"] {
            let square = (TAU / of(symbol)).powi(2);
            let product = (stiffness + spring - square * mass) * (spring - square * sloshing);
            near(product / (spring * spring), 1.0, 1e-6, symbol);
        }
        assert_eq!(out.notes.iter().any(|note| note.starts_with("Sloshing and staging")), of("T_c") < 2.5 * of("T_i"));
    }
}

/// Every line of the resultants by hand.
#[test]
fn resultants_by_hand() {
    let case = elevated(8.6, 4.3, StagingKind::DuctileRcFrame);
    let out = assessed(&Is18932014, &case);
    let of = |symbol| line(&out, symbol);
    let wall = PI * 8.8 * 4.8 * 0.2 * case.tank.courses[0].material.density;
    let own = wall + 32e3 + 75e3;
    near(of("m_s"), own + 110e3 / 3.0, 1e-6 * own, "m_s");
    let centre = 16.0 + (wall * 2.4 + 32e3 * 4.8 - 75e3 * 0.2) / own;
    near(of("h_cg"), centre, 1e-9, "h_cg");
    near(of("T_i"), TAU * ((of("m_i") + of("m_s")) / 17e6).sqrt(), 1e-12, "T_i");
    near(of("T_e"), TAU * (of("m_s") / 17e6).sqrt(), 1e-12, "T_e");
    let over_g = |period: f64| 0.24 / 2.0 * 1.5 / 2.5 * f64::min(2.5, 1.36 / period);
    near(of("A_i"), over_g(of("T_i")), 1e-12, "A_i");
    near(of("A_e"), over_g(of("T_e")), 1e-12, "A_e");
    near(of("A_c"), 1.75 * over_g(of("T_c")), 1e-12, "A_c");
    let [full, sloshing] = [of("A_i") * 9.81, of("A_c") * 9.81];
    near(of("Q"), (full * (of("m_i") + of("m_s"))).hypot(sloshing * of("m_c")), 1e-6, "Q");
    let impulsive = of("m_i") * (of("h_i′") + 16.0) + of("m_s") * centre;
    near(of("M′"), (full * impulsive).hypot(sloshing * of("m_c") * (of("h_c′") + 16.0)), 1e-5, "M′");
    near(of("Q_e"), of("A_e") * 9.81 * of("m_s"), 1e-6, "Q_e");
    near(of("M_e"), of("Q_e") * centre, 1e-5, "M_e");
    near(of("Q_xy"), 1.09_f64.sqrt() * of("Q"), 1e-6, "Q_xy");
    near(out.values[&Quantity::BaseShear], of("Q"), 1e-6, "base shear");
    near(out.values[&Quantity::OverturningMoment], of("M′"), 1e-5, "moment");
    near(of("d_max"), of("A_c") * 2.5 * 4.3, 1e-12, "d_max, not reduced");
    assert!(out.recalled.iter().any(|clause| clause == "IITK-GSDMA 2007 4.2.2"), "{:?}", out.recalled);
}

/// The larger is taken. Under this spectrum that is the full tank: where S_a falls as 1/T, A m grows as √m, and elsewhere as m. An empty tank
/// can govern under a record.
#[test]
fn the_larger_governs() {
    for stiffness in [0.4e6, 0.6e6, 2e6, 17e6, 300e6] {
        let mut case = elevated(8.6, 4.3, StagingKind::DuctileRcFrame);
        case.tank.staging.as_mut().unwrap().stiffness = stiffness;
        let out = assessed(&Is18932014, &case);
        let of = |symbol| line(&out, symbol);
        near(of("Q_max"), of("Q").max(of("Q_e")), 0.0, "Q_max");
        near(of("M_max"), of("M′").max(of("M_e")), 0.0, "M_max");
        assert!(of("Q") > of("Q_e"), "{stiffness}");
    }
}

/// R and damping by kind; a shaft needs the user's R; seven columns have a weak direction, eight have not.
#[test]
fn kinds() {
    let of = |kind| assessed(&Is18932014, &elevated(8.6, 4.3, kind));
    let both = |out: &Assessment| (line(out, "R"), line(out, "k_i"));
    assert_eq!(both(&of(StagingKind::DuctileRcFrame)), (2.5, 1.0));
    assert_eq!(both(&of(StagingKind::RcFrame)), (1.8, 1.0));
    assert_eq!(both(&of(StagingKind::SteelFrame)), (2.5, 1.4));
    let mut case = elevated(8.6, 4.3, StagingKind::RcShaft);
    let error = Is18932014.assess(&case, Excitation::Site).unwrap_err().to_string();
    assert!(error.contains("`site.is1893.response_reduction` is missing: for shafts"), "{error}");
    case.site.is1893.as_mut().unwrap().response_reduction = Some(1.5);
    assert!(assessed(&Is18932014, &case).steps.iter().any(|step| step.symbol == "Q_xy"));
    let mut case = elevated(8.6, 4.3, StagingKind::DuctileRcFrame);
    for (columns, weak) in [(7, true), (8, false)] {
        case.tank.staging.as_mut().unwrap().columns = Some(columns);
        assert_eq!(assessed(&Is18932014, &case).steps.iter().any(|step| step.symbol == "Q_xy"), weak);
    }
}

/// Every other procedure refuses the tank and says why.
#[test]
fn other_procedures_refuse() {
    let case = elevated(8.6, 4.3, StagingKind::DuctileRcFrame);
    for procedure in crate::ALL.iter().filter(|p| p.id() != "is1893-2014") {
        for excitation in [Excitation::Site, Excitation::Record] {
            let refused = procedure.assess(&case, excitation).unwrap_err().to_string();
            assert!(refused.contains("the tank stands on a staging"), "{}: {refused}", procedure.id());
            assert_eq!(procedure.applies(&case, excitation).unwrap_err().to_string(), refused);
        }
    }
}
