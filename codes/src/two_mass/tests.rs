//! Worked control values of the chain, for the tests of its codes too.

use tank::assessment::{Assessment, Excitation};
use tank::case::Case;
use tank::{Behaviour, Material, Shape};

use crate::procedure::Procedure;
use crate::samples::{case, course};

/// Concrete of a modulus [Pa] and weight per volume [N/m³] at g = 9.80665 m/s².
pub(crate) fn concrete(modulus: f64, weight: f64) -> Material {
    Material {
        name: "concrete".into(),
        family: Some(tank::Family::Concrete),
        youngs_modulus: modulus,
        poisson_ratio: 0.2,
        density: weight / tank::STANDARD_GRAVITY,
        yield_strength: None,
        allowable_stress: None,
        behaviour: Behaviour::default(),
        volume_change: Default::default(),
    }
}

/// Water of 9.81 kN/m³ in a concrete tank, without a record; g = 9.80665 m/s².
pub(crate) fn tank(shape: Shape, depth: f64, (height, thickness): (f64, f64), modulus: f64) -> Case {
    let mut case = case(shape, vec![course(height, thickness, concrete(modulus, 24e3))], depth, None);
    case.gravity = tank::STANDARD_GRAVITY;
    case.liquid.density = 9810.0 / tank::STANDARD_GRAVITY;
    case
}

/// The box of the control values: 18 m × 9 m, 4 m deep, walls of 4.5 m and 0.40 m, f_c' = 28 MPa.
pub(crate) fn basin() -> Case {
    let shape = Shape::Rectangle { length: 18.0, breadth: 9.0, strip: false };
    tank(shape, 4.0, (4.5, 0.40), 4700.0 * 28_f64.sqrt() * 1e6)
}

/// The assessment under the spectrum of the site.
pub(crate) fn assessed(procedure: &dyn Procedure, case: &Case) -> Assessment {
    procedure.assess(case, Excitation::Site).unwrap()
}

/// The value of the last line of a symbol.
pub(crate) fn line(out: &Assessment, symbol: &str) -> f64 {
    out.steps.iter().rev().find(|s| s.symbol == symbol).unwrap_or_else(|| panic!("no line {symbol}")).value
}

/// Fails unless values agree with printed ones within half of the last digit, or a little more where a printed value was itself computed from
/// rounded ones.
#[track_caller]
pub(crate) fn printed(out: &Assessment, values: &[(&str, f64, f64)]) {
    for &(symbol, expected, half) in values {
        let found = line(out, symbol);
        assert!((found - expected).abs() <= half * (1.0 + 1e-9), "{symbol}: {found} instead of {expected} ± {half}");
    }
}

/// Mass of a wall: the area between its faces times height and density, at half of the height.
#[test]
fn mass_of_a_thick_wall() {
    let basin = basin();
    let box_area = 18.8 * 9.8 - 18.0 * 9.0;
    let round = tank(Shape::Cylinder { radius: 9.0 }, 4.0, (4.5, 0.40), 25e9);
    let ring = std::f64::consts::PI * (9.4 * 9.4 - 9.0 * 9.0);
    for (case, area) in [(basin, box_area), (round, ring)] {
        let (mass, centre) = case.tank.thick_wall();
        let expected = area * 4.5 * case.tank.courses[0].material.density;
        assert!((mass / expected - 1.0).abs() < 1e-12 && (centre - 2.25).abs() < 1e-12, "{mass} {expected} {centre}");
    }
}
