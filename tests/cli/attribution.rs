//! Attributions of `compare`: every one closes, and every headline quantity of a procedure has one.

use serde_json::Value;
use tank::factor::Factor;

use crate::compare::{stderr, tankcheck};

const QUAKE: &str = "examples/records/elcentro.csv";
/// Quantities with the exchange of ingredients.
const HEADLINES: [&str; 6] =
    ["sloshing_height", "base_shear", "base_moment", "overturning_moment", "hoop_stress", "axial_membrane_stress"];

fn results(tank: &str) -> Value {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let out = out.to_str().expect("a temporary path is text");
    let run = tankcheck(&["compare", tank, "--quake", QUAKE, "--out", out, "--format", "json"]);
    serde_json::from_slice(&run.stdout).unwrap_or_else(|e| panic!("{e}: {}", stderr(&run)))
}

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().map_or(&[], Vec::as_slice)
}

/// The product of the factors is the procedure's value over the engine's, to rounding of some twenty products.
fn closes(tank: &str) {
    let results = results(tank);
    let methods = list(&results, "methods");
    let fe = methods.iter().find(|m| m["id"] == "fe").expect("the engine is a method");
    let found = list(&results["comparison"], "attribution");
    for a in found {
        let quantity = a["quantity"].as_str().expect("an id");
        let method =
            methods.iter().find(|m| m["id"] == a["method"] && m["excitation"] == a["excitation"]).expect("its method");
        let value = |m: &Value| m["quantities"][quantity]["value"].as_f64().expect("its value");
        let ratio = value(method) / value(fe);
        let mut product = 1.0;
        let mut order: Vec<Factor> = Vec::new();
        for step in list(a, "steps") {
            product *= step["factor"].as_f64().expect("a factor");
            order.push(serde_json::from_value(step["factor_id"].clone()).expect("a known factor"));
        }
        let what = format!("{tank}: {quantity} of {} under {}", a["method"], a["excitation"]);
        assert!((product / ratio - 1.0).abs() < 1e-9, "{what}: {product} {ratio}");
        assert!((a["ratio"].as_f64().expect("a ratio") / ratio - 1.0).abs() < 1e-12, "{what}");
        // Ladders go through all their rungs; the exchange of ingredients follows the list.
        if HEADLINES.contains(&quantity) {
            assert!(order.windows(2).all(|pair| pair[0] < pair[1]), "{what}: {order:?}");
        }
    }
    for method in methods {
        let id = method["id"].as_str().expect("an id");
        if id.starts_with("fe") || id == "measured" {
            continue;
        }
        for quantity in HEADLINES {
            let given = |m: &Value| m["quantities"][quantity]["value"].is_f64();
            let expected = given(method) && given(fe);
            let made = found.iter().any(|a| {
                a["method"] == method["id"] && a["excitation"] == method["excitation"] && a["quantity"] == quantity
            });
            assert_eq!(made, expected, "{tank}: {quantity} of {id} under {}", method["excitation"]);
        }
    }
}

#[test]
fn attributions_close_under_a_record() {
    closes("examples/01_broad_tank/tank.json");
}

#[test]
fn attributions_close_under_record_and_site() {
    closes("examples/05_oil_tank/tank.json");
}
