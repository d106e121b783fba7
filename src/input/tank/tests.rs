//! The reader as a whole: meaning of a file, defaults and their sources, arbitrary texts.

mod anchors;
mod carried;
mod corrosion;
mod dashpots;
mod force_stations;
mod frequency;
mod heave;
mod imperfections;
mod isolators;
mod roof;
mod schema;
mod snapshots;
mod spectrum;
mod subsoil;
mod temperature;

use proptest::prelude::*;
use serde_json::{Value, json};
use tank::Quantity;
use tank::case::{ConvectiveCoefficient, GroundType, SiteClass};
use tank::options::LinearOptions;
use tank::options::linear::{DampingModel, Integrator};
use tank::units::{Dimension, Unit};
use tank::{Shape, Support};

use super::{parse, values};
use crate::input::TankFile;
use crate::input::diagnostic::Source;

fn read(text: &str) -> TankFile {
    let source = Source::new("tank.json", text);
    parse(&source).unwrap_or_else(|faults| panic!("{}", faults.render(&source, false)))
}

fn refused(text: &str) -> String {
    let source = Source::new("tank.json", text);
    parse(&source).expect_err("a fault").render(&source, false)
}

/// The smallest file, with further members of the document.
fn small(more: &str) -> String {
    format!(
        r#"{{
  "name": "t",
  "tank": {{ "shape": "cylinder", "radius": "10 m", "support": "anchored",
            "courses": [ {{ "height": "8 m", "thickness": "10 mm", "material": "steel" }} ] }},
  "liquid": {{ "density": "1000 kg/m3", "fill_height": "7 m" }},
  "materials": {{ "steel": {{ "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3" }} }}{more}
}}"#
    )
}

/// Text and source of a line of the echo; the value must be a default.
fn default(file: &TankFile, path: &str) -> (String, String) {
    let line = file.echo.iter().find(|e| e.path == path).unwrap_or_else(|| panic!("{path} is not echoed"));
    assert!(line.default && !line.source.is_empty(), "{line:?}");
    (line.text.clone(), line.source.clone())
}

/// A plate wider than the bottom is a fault with its limit; one thicker than the wall is doubtful where the tank may lift, and nowhere else.
#[test]
fn the_plate_under_the_wall_fits_the_tank() {
    let with = |support: &str, bottom: &str| {
        small("").replace(
            "\"support\": \"anchored\",",
            &format!("\"support\": \"{support}\", \"bottom\": {{ {bottom}, \"material\": \"steel\" }},"),
        )
    };
    let wide = r#""thickness": "6 mm", "annular_thickness": "8 mm", "annular_width": "10.1 m""#;
    let text = refused(&with("unanchored", wide));
    for part in ["tank.bottom.annular_width", "10.1 m", "at most 10", "the radius"] {
        assert!(text.contains(part), "`{part}` is missing in {text}");
    }
    let thick = |support: &str| {
        let file = read(&with(support, r#""thickness": "12 mm""#));
        file.warnings.iter().any(|w| w.contains("thicker than the lowest course"))
    };
    assert!(thick("unanchored") && !thick("anchored"));
}

/// Every value of the contract's example, in SI.
#[test]
fn contract() {
    let file = read(
        r#"{ "name": "broad tank", // comments and trailing commas are allowed
          "tank": { "shape": "cylinder", "radius": "1.83 m", "support": "anchored",
                    "courses": [ { "height": "0.915 m", "thickness": "2.03 mm", "material": "aluminium" },
                                 { "height": "0.915 m", "thickness": "1.27 mm", "material": "aluminium" }, ],
                    "roof": { "mass": "0 kg" } },
          "liquid": { "density": "1000 kg/m3", "fill_height": "1.525 m" },
          "materials": { "aluminium": { "youngs_modulus": "69 GPa", "poisson_ratio": 0.32, "density": "2750 kg/m3",
                                        "yield_strength": "240 MPa" } },
          "record": { "scale_to": "0.5 g", "scale_by": 1.0, "time_factor": 0.57735 },
          "damping": { "sloshing": 0.005, "impulsive": "2 %" },
          "site": { "ec8": { "ground": "A", "spectrum": 1, "ag": "0.25 g", "importance": 1.0 },
                    "api650": { "ss": 0.5, "s1": "0.2 g", "site_class": "B", "sug": 1, "tl": 4.0 } },
          "measured": { "sloshing_height": { "value": "13.4 cm", "source": "Manos and Clough 1982" } } }"#,
    );
    let case = &file.case;
    assert_eq!(case.name, "broad tank");
    assert_eq!(case.tank.shape, Shape::Cylinder { radius: 1.83 });
    assert_eq!(case.tank.support, Support::Anchored);
    assert_eq!(case.tank.courses.len(), 2);
    assert_eq!((case.tank.courses[0].height, case.tank.courses[0].thickness), (0.915, 0.00203));
    assert_eq!(case.tank.courses[1].thickness, 0.00127);
    let material = &case.tank.courses[1].material;
    assert_eq!(material.name, "aluminium");
    assert_eq!((material.youngs_modulus, material.poisson_ratio, material.density), (69e9, 0.32, 2750.0));
    assert_eq!((material.yield_strength, material.allowable_stress), (Some(240e6), None));
    assert_eq!((case.liquid.density, case.liquid.fill_height), (1000.0, 1.525));
    assert_eq!(case.gravity, 9.80665);
    assert_eq!(file.record.scale_to, Some(4.903325));
    assert_eq!((file.record.scale_by, file.record.time_factor), (Some(1.0), Some(0.57735)));
    assert_eq!((case.damping.sloshing, case.damping.impulsive), (0.005, 0.02));
    let ec8 = case.site.ec8.unwrap();
    assert_eq!((ec8.ground, ec8.spectrum, ec8.ag), (GroundType::A, 1, 0.25 * 9.80665));
    let api = case.site.api650.unwrap();
    assert_eq!((api.ss, api.s1, api.site_class, api.sug, api.tl), (0.5, 0.2, SiteClass::B, 1, 4.0));
    assert_eq!(case.measured.len(), 1);
    assert_eq!((case.measured[0].quantity, case.measured[0].value), (Quantity::SloshingHeight, 0.134));
    assert!(file.remarks.is_empty() && file.procedures.is_empty());
    let line = file.echo.iter().find(|e| e.path == "tank.courses[0].thickness").unwrap();
    assert_eq!((line.text.as_str(), line.default), ("2.03 mm", false));
}

#[test]
fn defaults_and_where_they_come_from() {
    let file = read(&small(
        r#", "site": { "ec8": { "ground": "B", "spectrum": 2, "ag": "1 m/s2" },
                        "api650": { "ss": 1, "s1": 0.4, "site_class": "D", "sug": 2, "tl": "8 s" } }"#,
    ));
    assert_eq!(default(&file, "gravity").0, "9.80665 m/s2");
    assert!(default(&file, "damping.sloshing").1.contains("EN 1998-4:2006 2.3.3"));
    assert_eq!((file.case.damping.sloshing, file.case.damping.impulsive), (0.005, 0.02));
    let ec8 = file.case.site.ec8.unwrap();
    assert_eq!((ec8.importance, ec8.behaviour_factor, ec8.construction_quality, ec8.vertical), (1.0, 1.0, 1.0, true));
    assert_eq!((ec8.friction, ec8.reduction_factor), (None, None));
    let api = file.case.site.api650.unwrap();
    assert_eq!((api.asce7, api.q, api.tl, api.friction), (2010, 2.0 / 3.0, 8.0, 0.4));
    assert_eq!((api.s0, api.av, api.zone_factor, api.fa, api.soil_factor), (None, None, None, None, 1.5));
    assert_eq!(api.foundation_weight, None);
    assert!(default(&file, "site.api650.q").1.contains("E.4.6.1"));
    assert_eq!(default(&file, "procedures.run").0, "all");
    assert_eq!(default(&file, "tank.roof.mass").0, "0 kg");
    assert_eq!(file.fe, LinearOptions::default());
    let paths: std::collections::BTreeSet<&str> = file.echo.iter().map(|e| e.path.as_str()).collect();
    assert_eq!(paths.len(), file.echo.len(), "a path is echoed twice");
}

/// The overpressure of the tank is the design pressure of API 650 unless that is given; without either it is zero.
#[test]
fn pressure_of_the_tank_is_the_design_pressure() {
    let site = |more: &str| {
        let text = format!(
            r#", "site": {{ "api650": {{ "ss": 1.0, "s1": 0.4, "site_class": "B", "sug": 1, "tl": 6.0{more} }} }}"#
        );
        small(&text)
    };
    let closed = |text: String| {
        let pressure = r#""anchored", "pressure": { "internal": "2 kPa", "vacuum": "500 Pa" },"#;
        text.replace(r#""anchored","#, pressure)
    };
    let design = |file: &TankFile| file.case.site.api650.map(|site| site.design_pressure);
    let file = read(&closed(site("")));
    assert_eq!((file.case.tank.pressure.internal, file.case.tank.pressure.vacuum), (2000.0, 500.0));
    assert_eq!(design(&file), Some(2000.0));
    assert_eq!(default(&file, "site.api650.design_pressure").1, "tank.pressure.internal");
    assert!(file.warnings.iter().any(|w| w.contains("tank.pressure")), "{:?}", file.warnings);
    let own = read(&closed(site(r#", "design_pressure": "3 kPa""#)));
    assert_eq!(design(&own), Some(3000.0));
    let atmospheric = read(&site(""));
    assert_eq!(design(&atmospheric), Some(0.0));
    assert_eq!(default(&atmospheric, "tank.pressure").1, "atmospheric tank");
}

#[test]
fn soft_walls_are_damped_like_concrete() {
    let file = read(&small("").replace("210 GPa", "33 GPa").replace("10 mm", "200 mm"));
    assert_eq!(file.case.damping.impulsive, 0.05);
    assert!(default(&file, "damping.impulsive").1.contains("concrete"));
}

#[test]
fn rectangles() {
    let tank = |plan: &str| small("").replace("\"cylinder\", \"radius\": \"10 m\"", &format!("\"rectangle\", {plan}"));
    let shape = |plan: &str| read(&tank(plan)).case.tank.shape;
    assert_eq!(
        shape("\"length\": \"5 m\", \"breadth\": \"3 m\""),
        Shape::Rectangle { length: 5.0, breadth: 3.0, strip: false }
    );
    let strip = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    assert_eq!(shape("\"length\": \"5 m\", \"strip\": true"), strip);
    assert!(refused(&tank("\"length\": \"5 m\"")).contains("\"strip\": true"));
    assert!(refused(&tank("\"length\": \"5 m\", \"strip\": false")).contains("breadth"));
    assert!(
        refused(&tank("\"length\": \"5 m\", \"breadth\": \"1 m\", \"strip\": true"))
            .contains("breadth does not apply to a strip")
    );
    assert!(
        refused(&small("").replace("\"10 m\"", "\"10 m\", \"length\": \"2 m\""))
            .contains("length does not apply to a cylinder")
    );
}

#[test]
fn options() {
    let file = read(&small(
        r#", "procedures": { "run": ["ec8-2006", "housner"], "housner": { "convective": "1957" } },
            "analysis": { "integrator": "newmark", "wave_modes": 3, "gauges": ["9 m"], "stations": ["2.5 cm", "5 m"],
              "damping": { "rayleigh": { "first": { "at": "2 rad/s", "ratio": 0.01 },
                                         "second": { "at": "1 Hz", "ratio": "2 %" } } } }"#,
    ));
    assert_eq!(file.procedures, ["ec8-2006", "housner"]);
    assert_eq!(file.case.procedures.housner_convective, ConvectiveCoefficient::Housner1957);
    assert_eq!((file.fe.integrator, file.fe.wave_modes), (Integrator::Newmark, 3));
    assert_eq!((file.fe.gauges.as_slice(), file.fe.stations.as_slice()), ([9.0].as_slice(), [0.025, 5.0].as_slice()));
    let tau = 2.0 * std::f64::consts::PI;
    let expected = DampingModel::Rayleigh { first: (2.0, 0.01), second: (tau, 0.02), allow_negative: false };
    assert_eq!(file.fe.damping, expected);
    for (more, message) in [
        (r#", "analysis": { "gauges": ["11 m"] }"#, "the radius"),
        (r#", "analysis": { "stations": ["8.1 m"] }"#, "the height of the wall"),
        (r#", "analysis": { "damping": {} }"#, "one of by_group, caughey, rayleigh and coefficients"),
        (r#", "procedures": { "run": ["ec8-2005"] }"#, "did you mean \"ec8-2006\"?"),
        (r#", "procedures": { "run": ["housner", "housner"] }"#, "duplicate procedure"),
        (r#", "procedures": { "run": [] }"#, "at least one id"),
        (
            r#", "site": { "ec8": { "ground": "F", "spectrum": 1, "ag": "0.2 g" } }"#,
            "\"A\", \"B\", \"C\", \"D\" or \"E\"",
        ),
        (r#", "site": { "ec8": { "ground": "A", "spectrum": 3, "ag": "0.2 g" } }"#, "1 or 2"),
        (r#", "site": { "ec8": { "ground": "A", "spectrum": 1, "ag": 0.2 } }"#, "unit is missing"),
        (r#", "site": { "api650": { "ss": 1, "s1": 0.4, "site_class": "D", "sug": 4, "tl": 8 } }"#, "1, 2 or 3"),
        (r#", "site": { "api650": { "ss": 1, "s1": 0.4, "site_class": "D", "sug": 1, "tl": 0 } }"#, "positive"),
        (r#", "site": { "api650": { "ss": 1, "s1": 0.4, "site_class": "F", "sug": 1, "tl": 8 } }"#, "site study"),
        (
            r#", "site": { "api650": { "ss": 1, "s1": 0.4, "site_class": "D", "sug": 1, "tl": 8, "zone_factor": 0.25 } }"#,
            "0, 0.075, 0.15, 0.2, 0.3 or 0.4",
        ),
        (r#", "measured": { "slosh_height": { "value": "1 cm", "source": "me" } }"#, "did you mean `sloshing_height`?"),
        (r#", "measured": { "sloshing_height": { "value": "1 kg", "source": "me" } }"#, "a mass"),
        (r#", "measured": { "sloshing_height": { "value": "1 cm", "source": " " } }"#, "empty"),
        (
            r#", "measured": { "sloshing_height": { "value": "1 cm", "source": "me", "motion": { "peak": "1 g" } } }"#,
            "`sha256` of the record file, or `peak` and `step`",
        ),
        (
            r#", "measured": { "sloshing_height": { "value": "1 cm", "source": "me", "motion": { "sha256": "1234" } } }"#,
            "64 hexadecimal digits",
        ),
    ] {
        let text = refused(&small(more));
        assert!(text.contains(message) && text.contains("1 fault in"), "{message}\n{text}");
    }
}

#[test]
fn every_procedure_can_be_named() {
    for procedure in codes::ALL {
        let file = read(&small(&format!(r#", "procedures": {{ "run": ["{}"] }}"#, procedure.id())));
        assert_eq!(file.procedures, [procedure.id()]);
    }
}

/// The dissertation's pairs (8.1.4) require a negative mass coefficient, which is reported.
#[test]
fn negative_rayleigh_coefficients_need_consent() {
    let with = |more: &str| {
        small(&format!(
            r#", "analysis": {{ "damping": {{ "rayleigh": {{ "first": {{ "at": "3.02 rad/s", "ratio": 0.01 }},
               "second": {{ "at": "4.13 rad/s", "ratio": 0.02 }}{more} }} }} }}"#
        ))
    };
    let text = refused(&with(""));
    // By hand: -0.06003 and 0.013205. Printed there: -0.0604 and 0.013205; its own formula gives -0.0600.
    assert!(text.contains("a_M = -6.0") && text.contains("a_K = 1.32"), "{text}");
    assert!(matches!(
        read(&with(", \"allow_negative\": true")).fe.damping,
        DampingModel::Rayleigh { allow_negative: true, .. }
    ));
}

#[test]
fn periods_may_be_given_as_frequencies() {
    let value = |text: &str| {
        let more = format!(r#", "measured": {{ "sloshing_period": {{ "value": "{text}", "source": "me" }} }}"#);
        read(&small(&more)).case.measured[0].value
    };
    assert!((value("2 Hz") - 0.5).abs() < 1e-15);
    assert!((value("3.14159265358979 rad/s") - 2.0).abs() < 1e-14);
    assert_eq!(value("0.25 s"), 0.25);
}

#[test]
fn unused_materials_are_a_remark() {
    let file = read(&small("").replace(
        "\"materials\": {",
        "\"materials\": { \"gold\": { \"youngs_modulus\": \"79 GPa\", \"poisson_ratio\": 0.4, \"density\": \"19300 kg/m3\" },",
    ));
    assert_eq!(file.remarks, ["materials.gold: material `gold` is unused"]);
}

/// A file without options of an engine has the engine's defaults.
#[test]
fn defaults_are_those_of_the_engines() {
    use tank::options::{NonlinearOptions, SolidOptions};
    let file = read(&small(r#", "analysis": { "solid": {}, "nonlinear": {} }"#));
    assert_eq!(file.fe, LinearOptions::default());
    assert_eq!(file.solid, SolidOptions::default());
    assert_eq!(file.nonlinear, NonlinearOptions::new(file.case.damping));
    assert_eq!(file.case.procedures, tank::case::ProcedureOptions::default());
    let given = read(&small(r#", "analysis": { "nonlinear": { "integration": {}, "damping": { "by_group": {} } } }"#));
    assert_eq!(given.nonlinear, file.nonlinear);
}

/// A tank within all limits, with lengths in an arbitrary unit.
fn tanks() -> impl Strategy<Value = (Value, f64, Vec<(f64, f64)>, f64)> {
    let unit = prop::sample::select(vec!["m", "cm", "mm", "ft", "in"]);
    let courses = prop::collection::vec((0.2..3.0_f64, 100.0..3000.0_f64), 1..8);
    (0.05..50.0_f64, courses, 0.05..1.0_f64, unit).prop_map(|(radius, courses, fill, unit)| {
        let factor = Unit::find(unit, Dimension::Length).unwrap().factor();
        let written = |length: f64| format!("{:e} {unit}", length / factor);
        let courses: Vec<(f64, f64)> =
            courses.into_iter().map(|(height, slenderness)| (height, radius / slenderness)).collect();
        let fill = fill * courses.iter().map(|c| c.0).sum::<f64>();
        let list: Vec<Value> = courses
            .iter()
            .map(|(h, t)| json!({ "height": written(*h), "thickness": written(*t), "material": "a \"b\" µ" }))
            .collect();
        let document = json!({
            "name": "π",
            "tank": { "shape": "cylinder", "radius": written(radius), "support": "unanchored", "courses": list },
            "liquid": { "density": "0.9 t/m3", "fill_height": written(fill) },
            "materials": { "a \"b\" µ": { "youngs_modulus": "70 GPa", "poisson_ratio": 0, "density": "2.7 g/cm3" } },
        });
        (document, radius, courses, fill)
    })
}

proptest! {
    #[test]
    fn bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let source = Source::new("t", String::from_utf8_lossy(&bytes));
        if let Err(faults) = parse(&source) {
            prop_assert!(!faults.is_empty() && !faults.render(&source, false).is_empty());
        }
    }

    #[test]
    fn json_like_texts_never_panic(text in "([\\[\\]{},:\"/* \n0-9.eE+a-z\\\\é-]|\"tank\":|\"radius\"|NaN|//|/\\*){0,60}") {
        let source = Source::new("t", text);
        if let Err(faults) = parse(&source) {
            faults.render(&source, true);
        }
    }

    #[test]
    fn spoiled_files_never_panic(at in 0..900_usize, cut in 0..30_usize, put in "\\PC{0,6}") {
        let mut text = small(r#", "record": { "scale_to": "0.5 g" }, "damping": { "sloshing": 0.005 }"#);
        let at = at.min(text.len());
        text.replace_range(at..(at + cut).min(text.len()), &put);
        let source = Source::new("t", text);
        if let Err(faults) = parse(&source) {
            faults.render(&source, false);
        }
    }

    #[test]
    fn valid_tanks_round_trip((document, radius, courses, fill) in tanks()) {
        let file = read(&format!("{document:#}"));
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b.abs();
        let Shape::Cylinder { radius: found } = file.case.tank.shape else { panic!("not a cylinder") };
        prop_assert!(close(found, radius));
        prop_assert!(close(file.case.liquid.fill_height, fill));
        prop_assert_eq!(file.case.tank.courses.len(), courses.len());
        for (course, (height, thickness)) in file.case.tank.courses.iter().zip(courses) {
            prop_assert!(close(course.height, height) && close(course.thickness, thickness));
            prop_assert_eq!(&course.material.name, "a \"b\" µ");
        }
    }

    /// The reader accepts every text that matches the schema's patterns.
    #[test]
    fn schema_patterns_are_read(
        (dimension, text) in prop::sample::select(vec![
            Dimension::Length, Dimension::Mass, Dimension::Density, Dimension::Stress, Dimension::Force,
            Dimension::Acceleration, Dimension::Time, Dimension::Moment, Dimension::Dimensionless,
            Dimension::LineForce, Dimension::LineArea,
        ]).prop_flat_map(|d| {
            // Exponents of one digit: larger ones overflow, which the pattern cannot detect.
            let pattern = values::pattern(d).replace("[0-9]+)?", "[0-9])?");
            let pattern = pattern.trim_start_matches('^').trim_end_matches('$').to_owned();
            (Just(d), proptest::string::string_regex(&pattern).expect("a regular expression"))
        })
    ) {
        prop_assert!(tank::units::parse(&text, dimension).is_ok(), "{text}");
    }
}
