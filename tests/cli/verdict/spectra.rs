//! Tanks under the user's spectrum, and codes left out of the run.
//!
//! The base tank has T_c1 = 4.9 s, 1.5 m of freeboard and η = √(10/5.5) = 1.35 for sloshing at 0.5 %.

use results::VerdictStatus::{Fails, Holds, Incomplete};
use serde_json::json;

use super::*;

const EC8: &str = "ec8-2006";
const API: &str = "api650-2020";

/// Eurocode 8 alone under a spectrum of the user.
fn own(spectrum: &Value) -> Value {
    json!({ "site": {
        "api650": null,
        "ec8": { "ground": null, "spectrum": null, "ag": null },
        "spectrum": spectrum
    }, "tank": { "foundation": { "kind": "soil", "shear_wave_velocity": "500 m/s" } } })
}

/// A table in g with 0.36 g at T_c1.
fn table() -> Value {
    json!({ "table": [[0, 0.3], [0.2, 0.6], [0.6, 0.6], [6, 0.3]], "unit": "g" })
}

/// Parameters of ground B of EN 1998-1, type 1, with another ground acceleration [g].
fn parameters(ag: f64) -> Value {
    json!({ "ag": format!("{ag} g"), "soil_factor": 1.2, "tb": 0.15, "tc": 0.5, "td": 2.0 })
}

/// API 650 with the zone factor alone.
fn zone() -> Value {
    json!({ "site": {
        "ec8": null,
        "api650": { "ss": null, "s1": null, "site_class": null, "sug": null, "tl": null, "zone_factor": 0.3 }
    } })
}

/// Tanks that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    let tank = |name, why, expected, change| Tank::new(name, why, expected, vec![change]);
    let mut tanks = vec![
        tank(
            "own-table-freeboard",
            "0.84 x 10 m x 1.35 x 0.36 g/g = 4.1 m > 1.5 m; under ground B with 0.1 g it holds",
            Expected::Verdict(Fails, EC8, "freeboard"),
            own(&table()),
        ),
        tank(
            "own-parameters-strong",
            "1 g on ground B in place of 0.1 g",
            Expected::Verdict(Fails, EC8, ANY),
            own(&parameters(1.0)),
        ),
        tank(
            "own-table-freeboard-api",
            "0.42 x 20 m x 1.5 x 0.36 = 4.5 m > 1.5 m",
            Expected::Verdict(Fails, API, "freeboard"),
            json!({ "site": { "ec8": null, "spectrum": table() } }),
        ),
        tank(
            "own-table-without-mapped-values",
            "the same without a lower limit",
            Expected::Verdict(Fails, API, "freeboard"),
            json!({ "site": {
                "ec8": null,
                "api650": { "ss": null, "s1": null, "site_class": null, "tl": null },
                "spectrum": table()
            } }),
        ),
        tank(
            "own-table-below-the-mapped-values",
            "A_f = 1.5 x 0.8 x (2/3 x 1.3 x 2 g) x 4/4.9² = 0.35: 2.9 m > 1.5 m, though the table asks for 0.02 g",
            Expected::Verdict(Fails, API, "freeboard"),
            json!({ "site": {
                "ec8": null,
                "api650": { "ss": 0.5, "s1": 2.0 },
                "spectrum": { "table": [[0, 0.01], [6, 0.01]], "unit": "g" }
            } }),
        ),
        tank(
            "own-table-too-short",
            "the table ends at 2 s, the sloshing period is 4.9 s: nothing is computed",
            Expected::NotAssessed,
            own(&json!({ "table": [[0, 0.01], [2, 0.01]], "unit": "g" })),
        ),
        tank(
            "code-left-out-of-the-run",
            "the site names EN 1998-4, `run` leaves it out, `decide` does not",
            Expected::Verdict(Incomplete, EC8, "not_run"),
            json!({ "procedures": { "run": ["housner", "api650-2020"] } }),
        ),
        tank(
            "zone-alone",
            "the zone method runs alone; a superseded edition does not decide",
            Expected::NotAssessed,
            zone(),
        ),
    ];
    let mut decides = zone();
    merge(&mut decides, &json!({ "procedures": { "decide": ["api650-1993"] } }));
    tanks.push(tank(
        "zone-alone-decides",
        "its comparisons are not all that the standard requires",
        Expected::Verdict(Incomplete, "api650-1993", "undeclared"),
        decides,
    ));
    tanks.extend(input());
    tanks
}

/// Sound ones.
pub(super) fn sound() -> Vec<Tank> {
    let tank = |name, why, method, change| Tank::new(name, why, Expected::Verdict(Holds, method, ANY), vec![change]);
    vec![
        tank("sound-own-parameters", "those of the base tank's ground", EC8, own(&parameters(0.1))),
        tank(
            "sound-own-table",
            "a weak table",
            EC8,
            own(&json!({ "table": [[0, 0.1], [0.2, 0.25], [0.6, 0.25], [2, 0.08], [6, 0.01]], "unit": "g" })),
        ),
        tank(
            "sound-one-code-decides",
            "the other one is left out of `decide` as well",
            EC8,
            json!({ "procedures": { "run": ["ec8-2006"], "decide": ["ec8-2006"] } }),
        ),
    ]
}

/// Malformed spectra.
fn input() -> Vec<Tank> {
    let refused = |name, why, path, spectrum: Value| Tank::new(name, why, Expected::Input(path), vec![own(&spectrum)]);
    let rows = |rows: Value| json!({ "table": rows, "unit": "g" });
    let mut reversed = parameters(0.1);
    reversed["tc"] = json!(0.1);
    let mut both = parameters(0.1);
    merge(&mut both, &table());
    let mut incomplete = parameters(0.1);
    merge(&mut incomplete, &json!({ "td": null }));
    vec![
        refused(
            "spectrum-unsorted",
            "periods increase",
            "site.spectrum.table[2]",
            rows(json!([[0, 0.1], [0.5, 0.2], [0.4, 0.2]])),
        ),
        refused(
            "spectrum-negative",
            "accelerations are positive",
            "site.spectrum.table[1]",
            rows(json!([[0, 0.1], [0.5, -0.2]])),
        ),
        refused(
            "spectrum-not-a-number",
            "a text is no number",
            "site.spectrum.table[1]",
            rows(json!([[0, 0.1], [0.5, "NaN"]])),
        ),
        refused(
            "spectrum-with-units-in-rows",
            "the unit stands beside the table",
            "site.spectrum.table[0]",
            rows(json!([["0 s", "1 kPa"], [0.5, 0.2]])),
        ),
        refused("spectrum-of-one-row", "nothing to interpolate", "site.spectrum.table", rows(json!([[0, 0.1]]))),
        refused(
            "spectrum-without-ground-acceleration",
            "the first row is that of T = 0",
            "site.spectrum.table[0]",
            rows(json!([[0.1, 0.1], [0.5, 0.2]])),
        ),
        refused(
            "spectrum-of-three-columns",
            "a row has two numbers",
            "site.spectrum.table[0]",
            rows(json!([[0, 0.1, 0.2], [0.5, 0.2]])),
        ),
        refused("spectrum-out-of-range", "20 g", "site.spectrum.table[1]", rows(json!([[0, 0.1], [0.5, 20]]))),
        refused(
            "spectrum-without-unit",
            "g or m/s²?",
            "site.spectrum.table",
            json!({ "table": [[0, 0.1], [0.5, 0.2]] }),
        ),
        refused(
            "spectrum-wrong-unit",
            "a pressure is no acceleration",
            "site.spectrum.unit",
            json!({ "table": [[0, 0.1], [0.5, 0.2]], "unit": "kPa" }),
        ),
        refused("spectrum-file-missing", "no such file", "site.spectrum.file", json!({ "file": "nowhere.csv" })),
        refused("spectrum-corners-reversed", "T_B < T_C", "site.spectrum.tc", reversed),
        refused("spectrum-incomplete", "T_D is missing", "no td", incomplete),
        refused("spectrum-twice", "a table or parameters", "site.spectrum.ag", both),
        Tank::new(
            "two-components-on-a-box",
            "the other direction is another tank",
            Expected::Input("site.ec8.components"),
            vec![concrete_box(), json!({ "site": { "ec8": { "components": "100-30" } } })],
        ),
        Tank::new(
            "spectrum-and-ground-type",
            "one of both",
            Expected::Input("site.ec8.ground"),
            vec![json!({ "site": { "spectrum": table() } })],
        ),
        Tank::new(
            "ground-type-missing",
            "without a spectrum of the user it is needed",
            Expected::Input("site.ec8.ground"),
            vec![json!({ "site": { "ec8": { "ground": null } } })],
        ),
        Tank::new(
            "mapped-values-incomplete",
            "T_L is needed with S_s",
            Expected::Input("site.api650.tl"),
            vec![json!({ "site": { "api650": { "tl": null } } })],
        ),
    ]
}
