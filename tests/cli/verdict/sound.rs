//! Tanks that hold: everything required was checked, or is an accepted gap.

use results::VerdictStatus::Holds;
use serde_json::json;

use super::*;

const EC8: &str = "ec8-2006";
const API: &str = "api650-2020";

/// A tank that holds; the deciding method is one of those.
fn sound(name: &'static str, why: &'static str, method: &'static str, changes: Vec<Value>) -> Tank {
    Tank::new(name, why, Expected::Verdict(Holds, method, ANY), changes)
}

/// All of them.
pub(super) fn tanks() -> Vec<Tank> {
    let mut tanks = steel();
    tanks.extend(others());
    tanks.extend(api_rest::sound_tanks());
    tanks.extend(details::sound_tanks());
    tanks.extend(unanchored::sound());
    tanks.extend(spectra::sound());
    tanks
}

fn steel() -> Vec<Tank> {
    vec![
        sound("sound-both-codes", "the base tank", EC8, vec![]),
        sound("sound-ec8", "one code", EC8, vec![only_ec8()]),
        sound("sound-api", "one code", API, vec![only_api()]),
        sound("sound-unanchored", "the bottom plate holds it", API, vec![unanchored()]),
        sound(
            "sound-slim-anchored",
            "strong anchors",
            EC8,
            vec![slim(), json!({ "site": { "ec8": { "ag": "0.2 g" } } })],
        ),
        sound("sound-thick", "twice the thickness", API, vec![wall(&[28.0, 24.0, 20.0, 20.0])]),
        sound("sound-half-full", "half the pressure", EC8, vec![filled(5.0)]),
        sound("sound-light-liquid", "less pressure", EC8, vec![json!({ "liquid": { "density": "700 kg/m3" } })]),
        sound("sound-roof", "a roof of 30 t: 4.7 kN/m, 0.5 MPa", API, vec![roof(30.0)]),
        sound(
            "sound-behaviour-factor",
            "q = 1.5 lowers the impulsive part",
            EC8,
            vec![only_ec8(), json!({ "site": { "ec8": { "behaviour_factor": 1.5 } } })],
        ),
        sound(
            "sound-quality",
            "better fabrication raises the buckling stress",
            EC8,
            vec![only_ec8(), json!({ "site": { "ec8": { "construction_quality": 2.5 } } })],
        ),
        sound(
            "sound-iterative",
            "the iterated mode shape",
            EC8,
            vec![only_ec8(), json!({ "procedures": { "ec8": { "impulsive": "iterative" } } })],
        ),
        sound(
            "sound-second-spectrum",
            "the spectrum of type 2 has a shorter plateau",
            EC8,
            vec![only_ec8(), json!({ "site": { "ec8": { "spectrum": 2 } } })],
        ),
        sound(
            "sound-brim-without-group",
            "API 650 E.7.2 asks for no freeboard in seismic use group I with S_DS below 0.33 g",
            API,
            vec![only_api(), filled(10.0), json!({ "site": { "api650": { "sug": 1 } } })],
        ),
        sound(
            "sound-site-study",
            "site class F with its study",
            API,
            vec![only_api(), json!({ "site": { "api650": { "site_class": "F", "fa": 1.2, "fv": 1.7 } } })],
        ),
        sound(
            "sound-later-tables",
            "site coefficients of ASCE 7-16",
            API,
            vec![only_api(), json!({ "site": { "api650": { "asce7": 2016 } } })],
        ),
    ]
}

fn others() -> Vec<Tank> {
    let aluminium = json!({ "materials": { "steel": { "youngs_modulus": "69 GPa", "density": "2700 kg/m3" } } });
    vec![
        sound("sound-aluminium", "EN 1998-4 A.10 contains the modulus", EC8, vec![only_ec8(), aluminium]),
        sound("sound-concrete", "the wall is designed apart", EC8, vec![only_ec8(), concrete()]),
        sound(
            "sound-concrete-unanchored",
            "4 MN of wall and a flat liquid do not overturn",
            EC8,
            vec![only_ec8(), concrete(), unanchored(), filled(4.0)],
        ),
        sound(
            "sound-box",
            "the wall is designed apart; the box stands without anchors",
            EC8,
            vec![only_ec8(), concrete_box()],
        ),
        sound("sound-box-under-both-codes", "API 650 is not for boxes, Eurocode 8 is", EC8, vec![concrete_box()]),
        sound(
            "sound-strip",
            "the wall is checked apart; 20 m of length do not overturn",
            EC8,
            vec![only_ec8(), concrete_box(), unanchored(), json!({ "tank": { "breadth": null, "strip": true } })],
        ),
        sound("sound-under-a-record", "the record is an assessment of its own", API, vec![]).shaken(),
    ]
}
