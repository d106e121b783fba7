//! Layers, embedment and damping of the soil under a slab.

use serde_json::{Value, json};
use tank::{SoilLayer, Subsoil};

use super::{read, refused, small};

/// The smallest file on a slab on soil with these further keys.
fn with(keys: &Value) -> Value {
    let mut file: Value = serde_json::from_str(&small("")).expect("a document");
    file["tank"]["foundation"] =
        json!({ "kind": "slab", "thickness": "0.6 m", "shear_wave_velocity": "400 m/s", "soil_density": "2000 kg/m3" });
    for (key, value) in keys.as_object().expect("keys") {
        file["tank"]["foundation"][key] = value.clone();
    }
    file
}

#[test]
fn layers_take_what_they_do_not_say_from_the_half_space() {
    let layers = json!([{ "thickness": "6 m", "shear_wave_velocity": "180 m/s" },
        { "thickness": "4 m", "shear_wave_velocity": "250 m/s", "density": "1800 kg/m3", "poisson_ratio": 0.4, "damping": 0.08 }]);
    let keys = json!({ "soil_damping": 0.03, "embedment": "1.5 m", "soil_layers": layers });
    let found = read(&with(&keys).to_string()).case.tank.subsoil;
    let first = SoilLayer {
        thickness: 6.0,
        shear_wave_velocity: 180.0,
        density: 2000.0,
        poisson_ratio: 1.0 / 3.0,
        damping: 0.03,
    };
    let second =
        SoilLayer { thickness: 4.0, shear_wave_velocity: 250.0, density: 1800.0, poisson_ratio: 0.4, damping: 0.08 };
    assert_eq!(found, Subsoil { damping: 0.03, embedment: 1.5, layers: vec![first, second] });
    assert!(read(&with(&json!({})).to_string()).case.tank.subsoil.is_plain());
}

#[test]
fn what_no_slab_moves_on_is_refused() {
    let keys = [
        ("soil_damping", json!(0.05)),
        ("embedment", json!("1 m")),
        ("soil_layers", json!([{ "thickness": "6 m", "shear_wave_velocity": "180 m/s" }])),
    ];
    for (key, value) in keys {
        let mut free = with(&json!({ key: value }));
        free["tank"]["support"] = json!("unanchored");
        let said = refused(&free.to_string());
        assert!(said.contains(&format!("tank.foundation.{key}")) && said.contains("a slab that moves"), "{said}");
    }
    for (keys, part) in [
        (json!({ "embedment": "-1 m" }), "tank.foundation.embedment"),
        (json!({ "soil_damping": 0.5 }), "tank.foundation.soil_damping"),
        (json!({ "soil_layers": [{ "thickness": "6 m" }] }), "tank.foundation.soil_layers[0]"),
        (
            json!({ "soil_layers": [{ "thickness": "0 m", "shear_wave_velocity": "200 m/s" }] }),
            "tank.foundation.soil_layers[0].thickness",
        ),
    ] {
        let said = refused(&with(&keys).to_string());
        assert!(said.contains(part), "`{part}` is missing in {said}");
    }
}
