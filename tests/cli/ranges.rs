//! Ranges of the codes and values that contradict each other.
//!
//! Source:    the clause in each range; tables 3.1 of EN 1998-1 and 20.3-1 of ASCE 7; strengths of EN 1993-1-1
//! Goal:      outside the range of its clause a value is refused with the clause; an unusual one is used, with a warning; two values of
//!            the same thing that do not agree are named together
//! Tolerance: none

use files::code::Code;
use serde_json::{Value, json};
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use crate::verdict::merge;

/// A usual tank under both codes.
fn usual() -> Value {
    json!({
        "name": "usual",
        "tank": {
            "shape": "cylinder", "radius": "10 m", "support": "anchored",
            "courses": [ { "height": "10 m", "thickness": "14 mm", "material": "steel" } ],
            "bottom": { "thickness": "8 mm", "material": "steel" },
            "anchors": { "count": 40, "capacity": "200 kN" }
        },
        "liquid": { "density": "1000 kg/m3", "fill_height": "8.5 m" },
        "materials": { "steel": { "grade": "S235" } },
        "site": {
            "ec8": { "ground": "B", "spectrum": 1, "ag": "0.1 g" },
            "api650": { "ss": 0.3, "s1": 0.1, "site_class": "C", "sug": 1, "tl": 4.0 }
        }
    })
}

/// `{ "a": { "b": value } }` of the path "a.b".
fn at(path: &str, value: &Value) -> Value {
    path.rsplit('.').fold(value.clone(), |inner, key| json!({ key: inner }))
}

/// Warnings of the usual tank with a change, or the refusal.
fn read(changes: &[Value]) -> Result<Vec<(Code, String)>, String> {
    let mut file = usual();
    changes.iter().for_each(|change| merge(&mut file, change));
    let source = Source::new("tank.json", file.to_string());
    let read = parse(&source).map_err(|faults| faults.render(&source, false))?;
    let coded = |w: &files::code::Warning| Some((w.code()?, w.text().to_owned()));
    Ok(read.warnings.iter().filter_map(coded).collect())
}

#[test]
fn a_usual_tank_has_no_warning() {
    assert_eq!(read(&[]), Ok(Vec::new()));
}

#[test]
fn outside_the_range_of_the_clause_is_refused_with_it() {
    for (path, value, clause) in [
        ("site.ec8.importance", json!(0.12), "EN 1998-4:2006 2.1.4"),
        ("site.ec8.importance", json!(2.5), "EN 1998-4:2006 2.1.4"),
        ("site.ec8.behaviour_factor", json!(0.9), "EN 1998-4:2006 4.4"),
        ("site.ec8.behaviour_factor", json!(3), "EN 1998-4:2006 4.4"),
        ("site.ec8.reduction_factor", json!(0.01), "EN 1998-1:2004 2.2.3"),
        ("damping.impulsive", json!(0.3), "EN 1998-1:2004 3.2.2.2"),
        ("damping.sloshing", json!(0.3), "EN 1998-4:2006 2.3.3"),
        ("site.api650.q", json!(0.01), "API 650 E.4.6.1"),
        ("site.api650.fa", json!(0.1), "ASCE 7-16 tables"),
        ("site.api650.tl", json!(0.1), "ASCE 7 maps"),
        ("site.api650.joint_efficiency", json!(0.1), "API 650 5.6"),
        ("site.api650.friction", json!(0.5), "API 650 E.7.6"),
        ("site.api650.design_pressure", json!("20 kPa"), "API 650 annex F"),
    ] {
        let refusal = read(&[at(path, &value)]).expect_err(path);
        for part in [path, clause, "T0215"] {
            assert!(refusal.contains(part), "{path}: {part}: {refusal}");
        }
    }
    let refusal = read(&[at("tank.pressure.internal", &json!("20 kPa"))]).expect_err("annex F");
    assert!(refusal.contains("annex F"), "{refusal}");
    let alone = json!({ "tank": { "pressure": { "internal": "20 kPa" } }, "site": { "api650": null } });
    assert!(read(&[alone]).is_ok());
}

#[test]
fn an_unusual_value_is_named() {
    for (path, value) in [
        ("site.ec8.importance", json!(0.7)),
        ("site.ec8.importance", json!(1.95)),
        ("site.ec8.reduction_factor", json!(0.3)),
        ("site.ec8.friction", json!(0.1)),
        ("site.ec8.bearing_capacity", json!("10 kPa")),
        ("damping.impulsive", json!(0.15)),
        ("damping.sloshing", json!(0.03)),
        ("site.api650.q", json!(0.8)),
        ("site.api650.tl", json!(24.0)),
        ("site.api650.joint_efficiency", json!(0.5)),
        ("liquid.density", json!("3000 kg/m3")),
        ("gravity", json!("1.62 m/s2")),
        ("tank.anchors.count", json!(10_000)),
        ("tank.anchors.count", json!(158)),
        ("tank.anchors.capacity", json!("1 kN")),
        ("tank.anchors.capacity", json!("900 MN")),
        ("tank.anchors.attachment_capacity", json!("900 MN")),
        ("tank.anchors.yield_force", json!("900 MN")),
        ("tank.pipes.uplift", json!("9 m")),
        ("tank.pipes.horizontal", json!("0.6 m")),
        ("tank.pipes.support_distance", json!("900 m")),
        ("procedures.ec8.combination", json!("srss")),
        ("damping.impulsive", json!(0.1)),
        ("damping.impulsive", json!(0.06)),
    ] {
        let warnings = read(&[at(path, &value)]).unwrap_or_else(|fault| panic!("{path}: {fault}"));
        let named = |(code, text): &(Code, String)| *code == Code::UnusualInput && text.starts_with(path);
        assert!(warnings.iter().any(named), "{path}: {warnings:?}");
    }
    for (path, value) in [
        ("site.ec8.importance", json!(0.8)),
        ("site.ec8.importance", json!(1.6)),
        ("site.ec8.reduction_factor", json!(0.4)),
        ("damping.impulsive", json!(0.05)),
        ("site.api650.q", json!(1)),
        ("site.api650.q", json!(0.667)),
        ("site.api650.tl", json!(16)),
        // One every 0.4 m on 62.83 m.
        ("tank.anchors.count", json!(157)),
        ("tank.anchors.capacity", json!("2 MN")),
        ("tank.anchors.attachment_capacity", json!("6 MN")),
        ("tank.pipes.uplift", json!("0.5 m")),
        ("procedures.ec8.combination", json!("abs")),
        ("procedures.housner.combination", json!("srss")),
    ] {
        let warnings = read(&[at(path, &value)]).unwrap_or_else(|fault| panic!("{path}: {fault}"));
        assert!(warnings.iter().all(|(code, _)| *code != Code::UnusualInput), "{path}: {warnings:?}");
    }
}

#[test]
fn values_that_contradict_each_other_are_named_together() {
    let slab = |more: Value| {
        let mut slab = json!({ "kind": "slab" });
        merge(&mut slab, &more);
        json!({ "tank": { "foundation": slab } })
    };
    let both = |ec8: Value, api: Value| json!({ "site": { "ec8": ec8, "api650": api } });
    let steel = |more: Value| json!({ "materials": { "steel": more } });
    let tank = |more: Value| json!({ "tank": more });
    for (change, one, other) in [
        (slab(json!({ "shear_wave_velocity": "80 m/s" })), "shear_wave_velocity", "site.ec8.ground"),
        (slab(json!({ "shear_wave_velocity": "80 m/s" })), "shear_wave_velocity", "site.api650.site_class"),
        (both(json!({ "ground": "A" }), json!({ "site_class": "E" })), "site.ec8.ground", "site_class"),
        (both(json!({ "ag": "0.4 g" }), json!({})), "site.ec8.ag", "site.api650.ss"),
        (both(json!({ "importance": 1.6 }), json!({})), "site.ec8.importance", "site.api650.sug"),
        (
            both(json!({ "bearing_capacity": "1 MPa" }), json!({ "bearing_capacity": "200 kPa" })),
            "site.ec8.bearing_capacity",
            "site.api650.bearing_capacity",
        ),
        (both(json!({}), json!({ "s1": 0.5 })), "site.api650.s1", "site.api650.ss"),
        (both(json!({}), json!({ "s0": 0.5 })), "site.api650.s0", "site.api650.ss"),
        (steel(json!({ "yield_strength": "355 MPa" })), "yield_strength", "S235"),
        (steel(json!({ "density": "2700 kg/m3" })), "density", "S235"),
        (steel(json!({ "allowable_stress": "300 MPa" })), "allowable_stress", "yield_strength"),
        (tank(json!({ "roof": { "mass": "0 t", "snow": "included" } })), "tank.roof.snow", "tank.roof.mass"),
        (
            tank(json!({ "roof": { "mass": "3 t", "type": "open" }, "pressure": { "internal": "1 kPa" } })),
            "tank.pressure",
            "tank.roof.type",
        ),
        (
            tank(json!({ "anchors": { "attachment_capacity": "50 kN" } })),
            "attachment_capacity",
            "tank.anchors.capacity",
        ),
        (both(json!({ "friction": 0.5 }), json!({})), "site.ec8.friction", "tank.foundation.friction"),
    ] {
        let mean = slab(json!({ "friction": 0.45 }));
        let warnings = read(&[mean, change.clone()]).unwrap_or_else(|fault| panic!("{change}: {fault}"));
        let named =
            |(code, text): &(Code, String)| *code == Code::Inconsistent && text.contains(one) && text.contains(other);
        assert!(warnings.iter().any(named), "{one}, {other}: {warnings:?}");
    }
    // Waves at the strains of the earthquake are slower than at rest; both ends of a class belong to it.
    for velocity in ["180 m/s", "360 m/s", "760 m/s"] {
        assert_eq!(read(&[slab(json!({ "shear_wave_velocity": velocity }))]), Ok(Vec::new()), "{velocity}");
    }
}

/// What a warning says of a pressure is what the methods do.
#[test]
fn a_vacuum_is_not_said_to_enter_api_650() {
    let text = |change: Value| read(&[change]).expect("a good tank").remove(0).1;
    let vacuum = text(at("tank.pressure.vacuum", &json!("0.3 kPa")));
    assert!(vacuum.contains("EN 1998-4 alone"), "{vacuum}");
    let internal = text(at("tank.pressure.internal", &json!("2 kPa")));
    assert!(internal.contains("EN 1998-4 and API 650"), "{internal}");
}

/// The family is given, that of the grade, or the only one with the modulus and density; its strengths follow from the grade.
#[test]
fn families() {
    let family = |change: Value| {
        let mut file = usual();
        merge(&mut file, &json!({ "materials": { "steel": null } }));
        merge(&mut file, &json!({ "materials": { "steel": change } }));
        let source = Source::new("tank.json", file.to_string());
        let read = parse(&source).unwrap_or_else(|f| panic!("{}", f.render(&source, false)));
        let material = read.case.tank.courses[0].material.clone();
        (material.family, material.allowable_stress)
    };
    let values = |e: &str, rho: &str| json!({ "youngs_modulus": e, "poisson_ratio": 0.3, "density": rho });
    use tank::Family::{Aluminium, CarbonSteel, OtherMetal, Polymer, Stainless};
    assert_eq!(family(json!({ "grade": "A240 304L" })), (Some(Stainless), Some(145e6)));
    assert_eq!(family(json!({ "grade": "A240 304" })), (Some(Stainless), Some(155e6)));
    assert_eq!(family(json!({ "grade": "1.4462" })), (Some(Stainless), None));
    assert_eq!(family(json!({ "grade": "A36" })), (Some(CarbonSteel), Some(160e6)));
    assert_eq!(family(json!({ "grade": "EN AW-5083" })), (Some(Aluminium), None));
    assert_eq!(family(json!({ "grade": "A553 I" })), (Some(OtherMetal), None));
    assert_eq!(family(values("210 GPa", "7850 kg/m3")).0, Some(CarbonSteel));
    assert_eq!(family(values("200 GPa", "7800 kg/m3")).0, None);
    assert_eq!(family(values("3 GPa", "1190 kg/m3")).0, Some(Polymer));
    let mut given = values("200 GPa", "7800 kg/m3");
    merge(&mut given, &json!({ "family": "stainless" }));
    assert_eq!(family(given).0, Some(Stainless));
}

/// A ring wall that cannot be under this tank, and anchors that hold to nothing.
#[test]
fn a_foundation_that_cannot_be_is_named() {
    let ring = |width: &str| json!({ "tank": { "foundation": { "kind": "ring_wall", "width": width } } });
    let warned = |change: &Value, what: &str| {
        let warnings = read(std::slice::from_ref(change)).expect("a good tank");
        warnings.iter().any(|(code, text)| *code == Code::Inconsistent && text.contains(what))
    };
    for (width, named) in [("13 mm", true), ("15 mm", false), ("1 m", false), ("8.1 m", true)] {
        let mut change = ring(width);
        merge(&mut change, &at("tank.radius", &json!("4 m")));
        assert_eq!(warned(&change, "tank.foundation.width"), named, "{width}");
    }
    let on_nothing = json!({ "tank": { "foundation": "none" } });
    assert!(warned(&on_nothing, "tank.anchors and tank.foundation"));
}

/// Bars of 20 mm in a wall of 300 mm: in each case one value is beyond what concrete holds.
#[test]
fn bars_that_concrete_cannot_hold_are_named() {
    let warnings = |bars: Value| {
        let mut layer = json!({ "direction": "hoop", "material": "bars" });
        merge(&mut layer, &bars);
        let course =
            json!({ "height": "10 m", "thickness": "300 mm", "material": "concrete", "reinforcement": [layer] });
        let change = json!({
            "tank": { "courses": [course] },
            "materials": { "concrete": { "grade": "C30/37" }, "bars": { "grade": "B500B" } },
        });
        let found = read(&[change]).unwrap_or_else(|fault| panic!("{fault}"));
        found
            .into_iter()
            .filter(|(_, text)| text.contains("bars"))
            .map(|(code, text)| (code, text.replace("tank.courses: ", "")))
            .collect::<Vec<_>>()
    };
    let bars =
        |spacing: &str, from_inner: &str| json!({ "diameter": "20 mm", "spacing": spacing, "from_inner": from_inner });
    assert_eq!(warnings(bars("150 mm", "50 mm")), []);
    for (bars, code, what) in [
        // π 20²/4 / 25 mm = 12 566 mm²/m of 300 000.
        (bars("25 mm", "50 mm"), Code::UnusualTank, "4.2 % of the section"),
        (bars("39 mm", "50 mm"), Code::UnusualTank, "19.0 mm apart"),
        (json!({ "diameter": "32 mm", "spacing": "31 mm", "from_inner": "50 mm" }), Code::Inconsistent, "overlap"),
        (bars("150 mm", "9 mm"), Code::Inconsistent, "stand out"),
        (bars("150 mm", "295 mm"), Code::Inconsistent, "stand out"),
        (bars("150 mm", "15 mm"), Code::UnusualTank, "cover of 5.00 mm"),
    ] {
        let found = warnings(bars.clone());
        assert!(found.iter().any(|(found, text)| *found == code && text.contains(what)), "{bars}: {found:?}");
    }
}

/// The user's spectrum, as table and as parameters: plausible as a_g of the code is.
#[test]
fn an_unusual_spectrum_is_named() {
    let named = |spectrum: Value| {
        let change = json!({ "site": { "spectrum": spectrum, "ec8": { "ground": null, "spectrum": null, "ag": null }, "api650": null } });
        let warnings = read(&[change]).unwrap_or_else(|fault| panic!("{fault}"));
        warnings.iter().any(|(code, text)| *code == Code::UnusualInput && text.starts_with("site.spectrum"))
    };
    let table =
        |plateau: f64| json!({ "unit": "g", "table": [[0.0, 0.4 * plateau], [0.2, plateau], [10.0, 0.01 * plateau]] });
    for (plateau, unusual) in [(0.04, true), (0.06, false), (2.9, false), (3.1, true)] {
        assert_eq!(named(table(plateau)), unusual, "{plateau}");
    }
    let parameters = |tb: f64, ag: &str| json!({ "ag": ag, "soil_factor": 1.2, "tb": tb, "tc": 0.5, "td": 2.0 });
    for (tb, ag, unusual) in [(0.15, "0.2 g", false), (0.001, "0.2 g", true), (0.15, "0.01 g", true)] {
        assert_eq!(named(parameters(tb, ag)), unusual, "{tb}, {ag}");
    }
}

/// Engines with a damping of their own; what the key of the case names is not named twice. A wall of concrete has 5 % and more.
#[test]
fn a_damping_of_a_metal_wall_is_named_once() {
    let named = |changes: &[Value]| -> Vec<String> {
        let warnings = read(changes).unwrap_or_else(|fault| panic!("{fault}"));
        let damping = warnings.iter().filter(|(code, _)| *code == Code::UnusualInput);
        damping.map(|(_, text)| text.split(':').next().unwrap_or_default().to_owned()).collect()
    };
    let pair = |at: &str, ratio: f64| json!({ "at": at, "ratio": ratio });
    let rayleigh = |ratio: f64| {
        at(
            "analysis.damping.rayleigh",
            &json!({ "first": pair("2 Hz", ratio), "second": pair("20 Hz", 0.02), "allow_negative": true }),
        )
    };
    assert_eq!(named(&[rayleigh(0.1)]), ["analysis.damping"]);
    assert_eq!(named(&[rayleigh(0.05)]), [""; 0]);
    for ratio in [0.06, 0.1, 0.15] {
        assert_eq!(named(&[at("damping.impulsive", &json!(ratio))]), ["damping.impulsive"], "{ratio}");
    }
    let course = json!({ "height": "10 m", "thickness": "300 mm", "material": "concrete" });
    let concrete = json!({ "tank": { "courses": [course] }, "materials": { "concrete": { "grade": "C30/37" } } });
    assert_eq!(named(&[concrete, at("damping.impulsive", &json!(0.1))]), [""; 0]);
}
