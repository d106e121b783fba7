//! The worked example of the tests: an oil tank, R = 15 m, H = 12 m, six courses, fixed roof.

use oscillator::record::Record;
use tank::assessment::Assessment;
use tank::case::{Case, GroundMotion};
use tank::{Material, Roof, Shape, Support};

use super::ground_motion::tests::site;
pub(super) use crate::samples::near as close;
use crate::samples::{self, bottom_plate, course};

/// Steel with E = 210 GPa, F_y = F_ty = 235 MPa; S_d = 157 MPa serves the hoop check only.
pub(super) fn steel() -> Material {
    Material { yield_strength: Some(235e6), allowable_stress: Some(157e6), ..samples::steel() }
}

/// The tank with g = 9.81 m/s², self-anchored, site of [`site`], no record.
pub(crate) fn case() -> Case {
    let courses = [0.014, 0.012, 0.010, 0.008, 0.008, 0.008].map(|thickness| course(2.4, thickness, steel()));
    let mut case = samples::case(Shape::Cylinder { radius: 15.0 }, courses.to_vec(), 12.0, None);
    case.liquid.density = 900.0;
    case.site.api650 = Some(site());
    case.tank.support = Support::Unanchored;
    case.tank.roof = Roof { mass: 35_000.0, height: Some(15.2), ..Roof::default() };
    case.tank.bottom = Some(bottom_plate(steel()));
    case
}

/// The case with a decaying oscillation of 0.3 g around 2.5 Hz as its record.
pub(super) fn with_record(mut case: Case) -> Case {
    let acceleration = (0..1000)
        .map(|i| f64::from(i) * 0.02)
        .map(|t| 0.3 * 9.81 * (15.7 * t).sin() * (-0.2 * t).exp() + 0.1 * 9.81 * (1.1 * t).sin() * (-0.1 * t).exp())
        .collect();
    let horizontal = Record { name: "burst".into(), dt: 0.02, acceleration, processing: vec![] };
    case.ground_motion = Some(GroundMotion { horizontal, transverse: None, vertical: None });
    case
}

/// Value of the first line with this symbol.
pub(super) fn line(out: &Assessment, symbol: &str) -> f64 {
    out.steps.iter().find(|s| s.symbol == symbol).unwrap_or_else(|| panic!("no line {symbol}")).value
}
