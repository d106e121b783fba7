//! `tank.roof`: kinds, columns, roofs on the liquid, snow and live load.

use std::f64::consts::PI;

use tank::{Roof, RoofKind, Snow};

use super::{default, read, refused, small};

fn with(roof: &str) -> String {
    small("").replace("\"anchored\",", &format!("\"anchored\", \"roof\": {{ {roof} }},"))
}

fn roof(keys: &str) -> Roof {
    read(&with(keys)).case.tank.roof
}

#[test]
fn kinds_and_the_height_of_their_mass() {
    let height = |keys: &str| read(&with(keys)).case.tank.roof_height();
    let cone = r#""type": "cone", "mass": "30 t", "rise": "1.5 m""#;
    assert_eq!(roof(cone).kind, RoofKind::Cone);
    assert!((height(cone) - 8.5).abs() < 1e-12);
    assert!((height(&cone.replace("cone", "dome")) - 8.75).abs() < 1e-12);
    assert_eq!(height(&format!("{cone}, \"height\": \"8.2 m\"")), 8.2);
    assert_eq!(height(r#""mass": "30 t""#), 8.0);
    let inner = roof(r#""type": "dome", "mass": "30 t", "internal_floating": "8 t", "rim": "0.6 m""#);
    assert_eq!((inner.mass, inner.afloat, inner.rim, inner.on_wall()), (30e3, 8e3, 0.6, 30e3));
}

/// (1 − ρ)(2 + ρ)/3 with ρ = 4/10 is 0.48; one column in the middle leaves 2/3.
#[test]
fn columns_carry_a_share_of_the_weight() {
    let on = |ring: &str| read(&with(&format!(r#""type": "cone", "mass": "30 t", "columns": "{ring}""#)));
    let file = on("4 m");
    let tank = &file.case.tank;
    assert!((tank.roof.on_wall() / (0.48 * 30e3) - 1.0).abs() < 1e-12, "{:?}", tank.roof);
    assert_eq!(tank.roof.columns, Some(4.0));
    assert!((tank.mass_above(8.0).0 - 30e3).abs() < 1e-9 && (tank.weight_above(8.0) - 14.4e3).abs() < 1e-6);
    assert!(file.remarks.iter().any(|remark| remark.contains("columns carry 52 %")), "{:?}", file.remarks);
    assert!((on("0 m").case.tank.roof.on_wall() / 20e3 - 1.0).abs() < 1e-12);
    assert!((roof(r#""mass": "30 t", "shell_share": 0.4"#).on_wall() / 12e3 - 1.0).abs() < 1e-12);
}

/// Without a site the share is that of EN 1998, with API 650 alone a tenth; a load answers the open share of the snow.
#[test]
fn snow_has_the_share_of_the_codes_that_judge() {
    let area = PI * 100.0;
    let snow = r#""mass": "30 t", "snow": "1.2 kPa""#;
    let file = read(&with(snow));
    assert_eq!(default(&file, "tank.roof.snow_combination").0, "0.2");
    let kg = |share: f64| 30e3 + share * 1200.0 * area / 9.80665;
    assert!((file.case.tank.roof.mass / kg(0.2) - 1.0).abs() < 1e-12);
    assert_eq!(file.case.tank.details.snow, None);
    let low = roof(&format!("{snow}, \"snow_combination\": 0.05, \"live_load\": \"1 kPa\""));
    assert!((low.mass / kg(0.05) - 1.0).abs() < 1e-12);
    assert_eq!(low.live_load, Some(1000.0));
    let api = r#", "site": { "api650": { "ss": 0.5, "s1": 0.2, "site_class": "D", "sug": 1, "tl": 4.0 } }"#;
    let sited = |site: &str| {
        let text = small(site).replace("\"anchored\",", &format!("\"anchored\", \"roof\": {{ {snow} }},"));
        read(&text).case
    };
    assert!((sited(api).tank.roof.mass / kg(0.1) - 1.0).abs() < 1e-12);
    let both =
        api.replace("\"api650\"", "\"ec8\": { \"ground\": \"B\", \"spectrum\": 1, \"ag\": \"0.2 g\" }, \"api650\"");
    let case = sited(&both);
    assert!((case.tank.roof.mass / kg(0.2) - 1.0).abs() < 1e-12);
    // Another share takes the place of the first.
    assert!((case.with_snow(0.1).tank.roof.mass / kg(0.1) - 1.0).abs() < 1e-12);
    assert_eq!(case.with_snow(0.0).tank.roof.mass, 30e3);
    let words = |word: &str| read(&with(&format!(r#""mass": "30 t", "snow": "{word}""#))).case.tank;
    assert_eq!((words("none").details.snow, words("none").roof.snow), (Some(Snow::None), None));
    assert_eq!(words("included").details.snow, Some(Snow::Included));
}

#[test]
fn bad_input_has_a_message() {
    let said = |keys: &str, parts: &[&str]| {
        let text = refused(&with(keys));
        for part in parts {
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
        assert!(text.contains("1 fault in tank.json"), "{text}");
    };
    for (key, kind, what) in [
        (r#""columns": "0 m""#, "floating", "columns does not apply to a floating roof"),
        (r#""shell_share": 0.5"#, "open", "shell_share does not apply to an open tank"),
        (r#""internal_floating": "8 t""#, "open", "internal_floating does not apply to an open tank"),
        (r#""internal_floating": "8 t""#, "floating", "internal_floating does not apply to a floating roof"),
        (r#""snow": "1.2 kPa""#, "open", "a snow load does not apply to an open tank"),
        (r#""snow": "1.2 kPa""#, "floating", "a snow load does not apply to a floating roof"),
        (r#""live_load": "1 kPa""#, "open", "live_load does not apply to an open tank"),
        (r#""rise": "1 m""#, "open", "rise does not apply"),
        (r#""rise": "1 m""#, "fixed", "rise does not apply"),
        (r#""rim": "1 m""#, "cone", "rim does not apply"),
        (r#""columns": "0 m""#, "dome", "columns do not apply to a dome"),
        (r#""columns": "10 m""#, "cone", "the columns are not within the tank"),
        (r#""rise": "11 m""#, "dome", "higher than the radius"),
        (r#""snow_combination": 0.2"#, "cone", "does not apply to a roof without a snow load"),
        (r#""snow": "1.2 m""#, "cone", "not of a stress"),
        (r#""snow": "-1 kPa""#, "cone", "must not be negative"),
        (r#""snow": "much""#, "cone", "unknown choice `much`"),
        (r#""snow": 1.2"#, "cone", "the unit is missing"),
        (r#""shell_share": 1.2"#, "cone", "too large"),
        (r#""columns": "0 m", "shell_share": 0.5"#, "cone", "given twice"),
        (r#""internal_floating": "3000 t""#, "cone", "heavier than the liquid"),
    ] {
        said(&format!(r#""type": "{kind}", "mass": "12 t", {key}"#), &[what]);
    }
    said(r#""type": "cone", "mass": "12 t", "slope": "1:16""#, &["the slope times the radius"]);
    let text = refused(
        &with(r#""mass": "12 t", "columns": "2 m""#)
            .replace("\"cylinder\", \"radius\": \"10 m\"", "\"rectangle\", \"length\": \"10 m\", \"breadth\": \"8 m\""),
    );
    assert!(text.contains("columns on a circle") && text.contains("shell_share"), "{text}");
}
