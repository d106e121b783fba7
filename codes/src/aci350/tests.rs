//! Control values of `other-codes.md` sections 3 and 13 to their printed digits, limits and a failure.

use tank::assessment::Excitation;
use tank::case::Api650Site;
use tank::quantity::Quantity;
use tank::{Shape, Support, WallBase};

use super::Aci3502006;
use crate::api650::ground_motion::tests::site;
use crate::procedure::{CodeError, Procedure};
use crate::samples::{near, steel};
use crate::two_mass::tests::{assessed, basin, line, printed, tank};

/// S_DS = 1.0 g, S_D1 = 0.6 g, seismic use group 2 (I = 1.25).
fn hard() -> Api650Site {
    Api650Site { ss: 1.0, s1: 0.4, q: 1.0, fa: Some(1.0), fv: Some(1.5), sug: 2, ..site() }
}

/// The box: L 18, B 9, H_L 4, H_w 4.5, t_w 0.40 m, f_c' 28 MPa, 9.81 and 24 kN/m³. Half of each printed digit.
#[test]
fn box_of_the_control_values() {
    let mut case = basin();
    case.site.api650 = Some(hard());
    let out = assessed(&Aci3502006, &case);
    let g = case.gravity / 1e3;
    for (symbol, kilonewtons) in [("m", 6356.9), ("m_i", 1629.9), ("m_c", 4574.8)] {
        near(line(&out, symbol) * g, kilonewtons, 0.05, symbol);
    }
    near(line(&out, "m′_w"), 4405.0, 0.5, "m_w");
    near(line(&out, "m′_i"), 9233.0, 0.5, "m_i");
    near(line(&out, "k") / 1e3, 75_244.0, 0.5, "k");
    printed(
        &out,
        &[
            ("r", 4.5, 5e-12),
            ("h_i", 1.500, 5e-4),
            ("h_c", 2.078, 5e-4),
            ("h_i′", 7.300, 5e-4),
            ("h_c′", 9.635, 5e-4),
            ("h", 1.742, 5e-4),
            ("T_i", 0.0846, 5e-5),
            ("T_c", 6.153, 5e-4),
            ("ε", 0.468, 5e-4),
        ],
    );
}

/// D 9, H_L 4: W_i/W_L 0.4928, h_i 1.50, T_c 3.259 s.
#[test]
fn circle_of_the_control_values() {
    let mut case = tank(Shape::Cylinder { radius: 4.5 }, 4.0, (4.5, 0.3), 25e9);
    case.site.api650 = Some(hard());
    let out = assessed(&Aci3502006, &case);
    near(line(&out, "m_i") / line(&out, "m"), 0.4928, 5e-5, "m_i/m");
    printed(&out, &[("h_i", 1.50, 5e-3), ("T_c", 3.259, 5e-4)]);
    // C_w of H/D = 4/9 by hand, and with it T of section 1: between 7.12 (H/R 0.5) and 6.04 (H/R 1).
    let x: f64 = 4.0 / 9.0;
    let c_w = 0.09375 + x * (0.2039 + x * (-0.1034 + x * (-0.1253 + x * (0.1267 - x * 0.03186))));
    near(line(&out, "C_w"), c_w, 1e-12, "C_w");
}

/// The coefficient of the period with walls of 2400 kg/m³, T = C √ρ H/(√(s/R) √E), as section 1 prints it: three digits.
#[test]
fn period_of_the_shell() {
    for (slenderness, printed) in [(0.5, 7.12), (1.0, 6.04), (1.5, 5.79), (2.0, 5.94), (3.0, 6.78)] {
        let depth = 5.0 * slenderness;
        let mut case = tank(Shape::Cylinder { radius: 5.0 }, depth, (1.1 * depth, 0.25), 30e9);
        case.tank.courses[0].material.density = 2400.0;
        case.liquid.density = 1000.0;
        case.site.api650 = Some(hard());
        let t_i = line(&assessed(&Aci3502006, &case), "T_i");
        let coefficient = t_i * (0.25_f64 / 5.0).sqrt() * 30e9_f64.sqrt() / (1000_f64.sqrt() * depth);
        near(coefficient, printed, 5e-3, &format!("H/R = {slenderness}"));
    }
    let mut broad = tank(Shape::Cylinder { radius: 30.0 }, 5.0, (6.0, 0.3), 30e9);
    broad.site.api650 = Some(hard());
    let out = assessed(&Aci3502006, &broad);
    assert!(!out.values.contains_key(&Quantity::ImpulsivePeriod));
    near(line(&out, "C_i"), 1.0, 1e-12, "S_DS without a period");
}

/// Accelerations by hand: C_i = S_DS, C_c = 1.5 S_D1/T_c below 1.6/T_S = 2.667 s and 2.4 S_DS/T_c² above; both meet there.
#[test]
fn accelerations_by_hand() {
    let mut case = basin();
    case.site.api650 = Some(hard());
    let out = assessed(&Aci3502006, &case);
    let t_c = line(&out, "T_c");
    near(line(&out, "C_i"), 1.0, 1e-12, "C_i");
    near(line(&out, "C_c"), 2.4 / (t_c * t_c), 1e-12, "C_c");
    near(line(&out, "A_i"), 1.25 / 2.0, 1e-12, "A_i");
    near(line(&out, "A_c"), 1.25 * 2.4 / (t_c * t_c), 1e-12, "A_c");
    // C_t I b/R_i = 0.4·1.25·(2/3)/2 = 0.1667 is below 0.2 S_DS.
    near(line(&out, "A_v"), 0.2, 1e-12, "A_v");
    near(line(&out, "d_max"), 9.0 * line(&out, "C_c") * 1.25, 1e-9, "d_max");
    // Continuity of C_c (derived in the sheet of formulas).
    let t_s: f64 = 0.6;
    near(1.5 * 0.6 / (1.6 / t_s), 2.4 / (1.6 / t_s).powi(2), 1e-12, "at 1.6/T_S");
}

/// The kinds of base: R_i 2.0, 3.25 and 1.5, and the period of a flexible base as one mass on its joint.
#[test]
fn kinds_of_base() {
    let mut case = tank(Shape::Cylinder { radius: 8.0 }, 5.0, (5.5, 0.3), 28e9);
    case.site.api650 = Some(hard());
    near(line(&assessed(&Aci3502006, &case), "R_i"), 2.0, 0.0, "fixed");
    case.tank.wall_base = WallBase::Hinged;
    near(line(&assessed(&Aci3502006, &case), "R_i"), 2.0, 0.0, "hinged");
    case.tank.wall_base = WallBase::Sliding { stiffness: Some(40e6), friction: None };
    let out = assessed(&Aci3502006, &case);
    near(line(&out, "R_i"), 3.25, 0.0, "flexible");
    // The joint's stiffness against the motion of the ring, half of it along: k_a π R.
    let mass = line(&out, "m_w") + line(&out, "m_i");
    let period = std::f64::consts::TAU * (mass / (40e6 * std::f64::consts::PI * 8.0)).sqrt();
    near(line(&out, "T_i"), period, 1e-9 * period, "T_i");
    case.tank.support = Support::Unanchored;
    near(line(&assessed(&Aci3502006, &case), "R_i"), 1.5, 0.0, "unanchored");
    case.tank.wall_base = WallBase::Sliding { stiffness: None, friction: Some(0.5) };
    let error = Aci3502006.assess(&case, Excitation::Site).unwrap_err().to_string();
    assert!(error.contains("`tank.wall_base.stiffness` is missing"), "{error}");
}

/// Forces and moments of the pressures over the depth are those of the masses: Q = ∫ p over the wetted walls, M with the arm; 1e-3 of the
/// integral by the midpoint rule with 4000 steps.
#[test]
fn pressures_have_the_forces_of_the_masses() {
    use crate::mechanical::{Lumped, Plan};
    use crate::two_mass::{Masses, Work, pressure::Field, pressure::Shape as Form};
    for shape in [Shape::Cylinder { radius: 7.0 }, Shape::Rectangle { length: 14.0, breadth: 6.0, strip: false }] {
        for depth in [4.0, 20.0] {
            let case = tank(shape, depth, (depth + 1.0, 0.4), 25e9);
            let plan = Plan::from(shape);
            let lever = if depth < 10.0 { 0.375 } else { 0.45 } * depth;
            let mass = case.liquid_mass();
            let part = |share: f64, lever: f64| Lumped { mass: share * mass, lever, lever_with_base: lever };
            // The second convective lever is above 2/3 of the depth.
            let masses = Masses {
                impulsive: part(0.5, lever),
                convective: part(0.4, if depth < 10.0 { 0.6 } else { 0.8 } * depth),
            };
            let work = Work {
                case: &case,
                excitation: Excitation::Site,
                sheet: crate::sheet::Sheet::new(),
                out: Default::default(),
                plan,
                length: 14.0,
                doubt: None,
            };
            let field = Field::new(&work, Form::Linear, &masses);
            // Breadth that collects the pressure: π R of cos θ, 3/4 π R·(3/2) of the sloshing shape at θ = 0, both walls of a box.
            let [of_i, of_c] = match plan {
                Plan::Circle => [std::f64::consts::PI * 7.0, 9.0 / 8.0 * std::f64::consts::PI * 7.0],
                Plan::Rectangle => [12.0, 12.0],
            };
            let steps = 4000;
            let (mut force, mut moment) = ([0.0; 2], [0.0; 2]);
            for i in 0..steps {
                let z = depth * (f64::from(i) + 0.5) / f64::from(steps);
                for (k, p) in [field.impulsive(z) * of_i, field.convective(z) * of_c].into_iter().enumerate() {
                    force[k] += p * depth / f64::from(steps);
                    moment[k] += p * z * depth / f64::from(steps);
                }
            }
            near(force[0] / masses.impulsive.mass, 1.0, 1e-3, "impulsive force");
            near(force[1] / masses.convective.mass, 1.0, 1e-3, "convective force");
            near(moment[0] / (masses.impulsive.mass * lever), 1.0, 1e-3, "impulsive moment");
            let arm = if depth < 10.0 { 0.6 } else { 2.0 / 3.0 } * depth;
            near(moment[1] / (masses.convective.mass * arm), 1.0, 1e-3, "convective moment");
        }
    }
}

/// A tank of steel is refused with its material, one without site data with the key, one under a table without S_DS.
#[test]
fn refusals() {
    let mut case = basin();
    let refused = |case: &_| match Aci3502006.assess(case, Excitation::Site) {
        Err(error @ (CodeError::NotApplicable(_) | CodeError::Data { .. })) => error.to_string(),
        other => panic!("{other:?}"),
    };
    assert!(refused(&case).contains("`site.api650` is not given"));
    case.site.api650 = Some(hard());
    case.tank.courses[0].material = steel();
    let found = refused(&case);
    assert!(found.contains("walls of concrete; `steel` is carbon steel"), "{found}");
}

/// Recalled clauses are those that the sheet prints as such; under a record those of the site do not count.
#[test]
fn recalled_clauses() {
    let mut case = basin();
    case.site.api650 = Some(hard());
    let out = assessed(&Aci3502006, &case);
    let printed: std::collections::BTreeSet<&str> =
        out.steps.iter().filter_map(|s| s.clause.strip_suffix(crate::sheet::RECALLED)).collect();
    assert_eq!(printed.into_iter().map(str::to_owned).collect::<Vec<_>>(), {
        let mut all = out.recalled.clone();
        all.sort();
        all
    });
    assert!(out.recalled.iter().any(|clause| clause.contains("4.1.1(a)")));
}
