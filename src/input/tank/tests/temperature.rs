//! A design temperature, and the values of the metals there.

use super::{read, refused, small};

/// The small tank at a temperature, whose steel has these values there.
fn tank(temperature: &str, hot: &str) -> String {
    let temperature = format!("\"anchored\", \"design_temperature\": \"{temperature}\",");
    small("").replace("\"anchored\",", &temperature).replace("\"steel\": {", &format!("\"steel\": {{ {hot}"))
}

const HOT: &str = "\"yield_strength\": \"240 MPa\", \"allowable_stress\": \"160 MPa\",
    \"hot\": { \"youngs_modulus\": \"190 GPa\", \"yield_strength\": \"210 MPa\" },";

/// API 650 M.3.2: S_d is the lesser of 160 MPa and 2/3 of 210 MPa.
#[test]
fn the_values_there_are_those_of_the_tank() {
    let hot = read(&tank("300 degF", HOT)).case.tank;
    let steel = &hot.courses[0].material;
    assert_eq!((steel.youngs_modulus, steel.yield_strength), (190e9, Some(210e6)));
    assert!(steel.allowable_stress.is_some_and(|s| (s - 140e6).abs() < 1.0), "{steel:?}");
    // 300 °F is 5/9 (300 − 32) °C.
    assert!(hot.details.design_temperature.is_some_and(|t| (t - 1340.0 / 9.0).abs() < 1e-9), "{:?}", hot.details);
}

#[test]
fn carbon_steel_needs_them_above_93_degrees() {
    assert!(read(&tank("93 degC", "")).case.tank.courses[0].material.yield_strength.is_none());
    let text = refused(&tank("94 degC", ""));
    assert!(text.contains("no values at the design temperature of the material `steel`"), "{text}");
    assert!(text.contains("at most 93.0 °C") && text.contains("1 fault in"), "{text}");
}

#[test]
fn contradictions() {
    let none = tank("120 degC", HOT).replace("\"design_temperature\": \"120 degC\",", "");
    assert!(
        refused(&none).contains("the key `design_temperature` is missing: the material `steel`"),
        "{}",
        refused(&none)
    );
    let strong = refused(&tank("120 degC", &HOT.replace("210", "250")));
    assert!(strong.contains("above that at room temperature") && strong.contains("at most 240"), "{strong}");
    assert!(refused(&tank("261 degC", HOT)).contains("260"));
}
