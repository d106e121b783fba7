//! Absurd values: impossible ones are rejected with value and range; unusual ones are computed with a warning that
//! names the usual range; no number that is not finite is printed with exit code 0.

use std::path::Path;
use std::process::Output;

use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use crate::compare::{stderr, tankcheck};

const TANK: &str = r#"{
  "name": "plain",
  "tank": { "shape": "cylinder", "radius": "10 m", "support": "anchored",
    "courses": [ { "height": "8 m", "thickness": "10 mm", "material": "steel" } ],
    "roof": { "mass": "5 t", "height": "8.5 m" } },
  "liquid": { "density": "1000 kg/m3", "fill_height": "7 m" },
  "materials": { "steel": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3",
    "yield_strength": "235 MPa" } },
  "gravity": "9.81 m/s2",
  "record": { "scale_by": 1.5 }
}"#;

fn spoiled(from: &str, to: &str) -> String {
    assert_eq!(TANK.matches(from).count(), 1, "`{from}` stands once");
    TANK.replace(from, to)
}

/// Warnings of the tank with one passage replaced.
fn warnings(from: &str, to: &str) -> Vec<String> {
    let source = Source::new("tank.json", spoiled(from, to));
    parse(&source)
        .unwrap_or_else(|f| panic!("{}", f.render(&source, false)))
        .warnings
        .iter()
        .map(|warning| warning.text().to_owned())
        .collect()
}

fn refusal(from: &str, to: &str) -> String {
    let source = Source::new("tank.json", spoiled(from, to));
    parse(&source).expect_err("a refusal").render(&source, false)
}

#[test]
fn unusual_tanks_are_computed_with_a_warning() {
    assert_eq!(warnings("plain", "plain"), [""; 0]);
    for (from, to, parts) in [
        ("235 MPa", "2.05 GPa", ["materials.steel.yield_strength", "found 2.05 GPa", "up to 2"]),
        ("\"210 GPa\"", "\"20.1 GPa\"", ["materials.steel.yield_strength", "found 235 MPa", "1 % of Young's modulus"]),
        ("\"210 GPa\"", "\"3.3 GPa\"", ["materials.steel.yield_strength", "found 235 MPa", "5 % of Young's modulus"]),
        ("7850 kg/m3", "499 kg/m3", ["materials.steel.density", "found 499", "500 to 20000 kg/m3"]),
        ("7850 kg/m3", "20001 kg/m3", ["materials.steel.density", "found 2", "500 to 20000 kg/m3"]),
        ("7 m", "99 mm", ["liquid.fill_height", "H/R = 9.90e-3", "usual is 0.3 to 3"]),
        ("\"8.5 m\"", "\"18.1 m\"", ["tank.roof.height", "found 18.1 m", "up to 18.00 m"]),
        ("\"10 m\"", "\"69 cm\"", ["liquid.fill_height", "H/R = 10.1", "usual is 0.3 to 3"]),
    ] {
        let found = warnings(from, to);
        let named: Vec<&String> = found.iter().filter(|w| parts.iter().all(|p| w.contains(p))).collect();
        assert_eq!(named.len(), 1, "{from} -> {to}: {found:?}");
    }
    // On the usual side of each limit there is none.
    for (from, to) in [
        ("235 MPa", "2 GPa"),
        ("\"210 GPa\"", "\"23.5 GPa\""),
        ("\"210 GPa\"", "\"4.7 GPa\""),
        ("7850 kg/m3", "500 kg/m3"),
        ("7850 kg/m3", "20000 kg/m3"),
        ("7 m", "10 cm"),
        ("\"8.5 m\"", "\"18 m\""),
        ("\"10 m\"", "\"70 cm\""),
    ] {
        assert_eq!(warnings(from, to), [""; 0], "{from} -> {to}");
    }
}

/// The thickness of a foundation counts under a slab on soil alone; elsewhere its loss is said.
#[test]
fn the_thickness_of_a_foundation_is_used_on_soil_alone() {
    let foundation = |kind: &str| {
        format!("\"height\": \"8.5 m\" }}, \"foundation\": {{ \"kind\": \"{kind}\", \"thickness\": \"0.5 m\" }} }}")
    };
    let on_soil = foundation("slab").replace("0.5 m\"", "0.5 m\", \"shear_wave_velocity\": \"250 m/s\"");
    let from = "\"height\": \"8.5 m\" } }";
    for kind in ["ring_wall", "slab"] {
        let found = warnings(from, &foundation(kind));
        assert!(matches!(&found[..], [one] if one.starts_with("tank.foundation.thickness: not used")), "{found:?}");
    }
    let found = warnings("\"height\": \"8.5 m\" } }", &on_soil);
    assert!(found.iter().all(|one| !one.contains("thickness")), "{found:?}");
}

#[test]
fn impossible_tanks_are_refused_with_the_range() {
    for (from, to, parts) in [
        (
            "235 MPa",
            "21.1 GPa",
            ["the yield strength is larger than any material's", "found \"21.1 GPa\"", "at most 21.00 GPa"],
        ),
        ("235 MPa", "1e300 Pa", ["materials.steel.yield_strength", "too large", "1e300 Pa"]),
        ("210 GPa", "2.1e8 GPa", ["materials.steel.youngs_modulus", "too large", "2.1e8 GPa"]),
        ("\"8.5 m\"", "\"6.9 m\"", ["below the surface of the liquid", "found \"6.9 m\"", "at least 7.000 m"]),
        ("\"8.5 m\"", "\"80.1 m\"", ["far above the wall", "found \"80.1 m\"", "at most 80.00 m"]),
        ("\"10 m\"", "\"0.9 mm\"", ["tank.radius", "found \"0.9 mm\"", "at least 1 mm"]),
        ("9.81 m/s2", "1e-9 m/s2", ["gravity", "too small", "at least 0.1 m/s2"]),
        ("9.81 m/s2", "101 m/s2", ["gravity", "too large", "at most 100 m/s2"]),
        ("7850 kg/m3", "1e300 kg/m3", ["materials.steel.density", "too large", "1e300"]),
        ("1.5", "1e308", ["record.scale_by", "too large", "1e308"]),
        ("\"scale_by\": 1.5", "\"scale_to\": \"1e300 g\"", ["record.scale_to", "too large", "1e300 g"]),
    ] {
        let text = refusal(from, to);
        for part in parts {
            assert!(text.contains(part), "`{part}` is missing in\n{text}");
        }
    }
    let pitch = r#""analysis": { "damping": { "rayleigh": { "first": { "at": "1e300 rad/s", "ratio": 0.02 },
        "second": { "at": "2 Hz", "ratio": 0.02 } } } }, "name": "plain""#;
    let text = refusal("\"name\": \"plain\"", pitch);
    assert!(text.contains("frequency or period out of range") && text.contains("1e-6 to 1e6 rad/s"), "{text}");
}

/// The files of the repository are usual tanks.
#[test]
fn examples_have_no_warning() {
    let mut seen = 0;
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("examples")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("readable") {
            let path = entry.expect("readable").path();
            // Results, study files and sets of records do not describe a tank.
            if ["expected", "study.json", "set.json"].iter().any(|name| path.ends_with(name)) {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "json") {
                let tank = tankcheck::input::read_tank(&path).unwrap_or_else(|e| panic!("{e}"));
                // What isolators do not enter is said of every tank on them, and who knows a staging of every tank on one.
                let of_every = ["`tank.isolators` enters", "`tank.staging` is known to"];
                let doubtful = tank.warnings.iter().map(|w| w.text());
                let doubtful = doubtful.filter(|text| !of_every.iter().any(|start| text.starts_with(start)));
                assert_eq!(doubtful.collect::<Vec<_>>(), [""; 0], "{}", path.display());
                seen += 1;
            }
        }
    }
    assert!(seen >= 12, "{seen}");
}

struct Home(tempfile::TempDir);

impl Home {
    fn new() -> Home {
        Home(tempfile::tempdir().expect("a temporary folder"))
    }

    fn write(&self, name: &str, text: &str) -> String {
        let path = self.0.path().join(name);
        std::fs::write(&path, text).expect("writable");
        path.to_str().expect("plain").into()
    }

    fn place(&self, name: &str) -> String {
        self.0.path().join(name).to_str().expect("plain").into()
    }
}

/// A sine of this peak [m/s²] at 2 Hz.
fn record(peak: f64, dt: f64, samples: u32) -> String {
    let mut text = String::from("time_s,acceleration_m_s2\n");
    for i in 0..samples {
        let t = dt * f64::from(i);
        text.push_str(&format!("{t:.4},{:e}\n", peak * (12.566 * t + 0.3).sin()));
    }
    text
}

fn printed(run: &Output) -> String {
    let text = String::from_utf8_lossy(&run.stdout).into_owned() + &stderr(run);
    if run.status.code() == Some(0) {
        for word in ["NaN", "nan", "inf", "∞", "undefined"] {
            let alone = text.split(|c: char| !(c.is_alphanumeric() || c == '∞')).any(|w| w == word);
            assert!(!alone, "`{word}` with exit code 0:\n{text}");
        }
    }
    text
}

fn refused(arguments: &[&str], parts: &[&str]) {
    let run = tankcheck(arguments);
    let text = printed(&run);
    assert_eq!(run.status.code(), Some(2), "{arguments:?}: {text}");
    for part in parts {
        assert!(text.contains(part), "{arguments:?}: `{part}` is missing in\n{text}");
    }
}

#[test]
fn the_guard_of_5_g_holds_for_the_record_as_computed_with() {
    let home = Home::new();
    let quake = home.write("quake.csv", &record(10.0, 0.02, 40));
    let scaled = |factor: &str| home.write("tank.json", &spoiled("1.5", factor));
    let tank = scaled("4.8");
    let run = tankcheck(&["check", &tank, "--quake", &quake]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", printed(&run));
    let tank = scaled("5");
    refused(
        &["check", &tank, "--quake", &quake],
        &["record.scale_by", "implausible", "5.09", "up to 5 g", "--allow-implausible"],
    );
    let run = tankcheck(&["check", &tank, "--quake", &quake, "--allow-implausible"]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", printed(&run));
    refused(&["spectrum", &quake, "--scale-by", "5"], &["--scale-by", "implausible", "--allow-implausible"]);
    refused(&["spectrum", &quake, "--scale-to", "6 g"], &["--scale-to", "found 6 g"]);
    let plain = home.write("plain.json", TANK);
    refused(
        &["ida", &plain, "--quake", &quake, "--scale", "0.1,4", "--out", &home.place("ida")],
        &["--scale", "factor 4", "implausible"],
    );
    assert!(!Path::new(&home.place("ida")).exists());
}

#[test]
fn records_and_factors_beyond_all_bounds_are_refused_whatever_the_options() {
    let home = Home::new();
    let quake = home.write("quake.csv", &record(1.0, 0.02, 40));
    for peak in [1e300, 2e4, 1e-12, 1e-300] {
        let extreme = home.write("extreme.csv", &record(peak, 0.02, 40));
        for command in [&["quake", "info"][..], &["spectrum"]] {
            let arguments: Vec<&str> =
                command.iter().copied().chain([extreme.as_str(), "--allow-implausible"]).collect();
            refused(&arguments, &["peak ground acceleration", "out of range", "1000 g"]);
        }
    }
    for (option, value) in [
        ("--scale-by", "1e308"),
        ("--scale-by", "-1e308"),
        ("--scale-by", "1e5"),
        ("--scale-to", "1e300 g"),
        ("--time-factor", "1e300"),
        ("--time-factor", "1e4"),
    ] {
        refused(&["spectrum", &quake, option, value, "--allow-implausible"], &["out of range", "at most"]);
    }
    let plain = home.write("plain.json", TANK);
    for scale in ["1e308", "0,1e300", "0..1e308"] {
        refused(
            &["ida", &plain, "--quake", &quake, "--scale", scale, "--steps", "3", "--out", &home.place("ida")],
            &["--scale"],
        );
    }
    let single = home.write("single.txt", "0\n1\n-1\n0\n");
    for dt in ["1e300", "10.5", "NaN"] {
        refused(&["quake", "info", &single, "--units", "g", "--dt", dt], &["--dt", "at most 10"]);
    }
    // A film and a drop.
    for fill in ["1e-6 m", "1e-300 m"] {
        let film = home.write("film.json", &spoiled("7 m", fill));
        refused(&["check", &film, "--quake", &quake], &["liquid.fill_height", "at least 1 mm"]);
    }
    let years = home.write("years.csv", "time_s,acceleration_m_s2\n0,0\n1e300,1\n2e300,0\n");
    refused(&["quake", "info", &years], &["the time step is out of range", "at most 10 s"]);
    // In range but extreme: computed, and finite.
    for arguments in [
        &["spectrum", &quake, "--periods", "1e-300,1e300", "--damping", "0"][..],
        &["spectrum", &quake, "--periods", "1e-9,1e9", "--damping", "0.999999"],
    ] {
        printed(&tankcheck(arguments));
    }
    refused(&["spectrum", &quake, "--scale-by", "1e-300"], &["scale_by", "at least 1e-9 m/s2"]);
}

#[test]
fn unusual_records_are_computed_with_a_warning_and_milliseconds_are_refused() {
    let home = Home::new();
    let usual = home.write("usual.csv", &record(1.0, 0.02, 40));
    let two = home.write("two.csv", &record(1.0, 0.02, 2));
    let slow = home.write("slow.csv", &record(1.0, 0.11, 40));
    assert!(!printed(&tankcheck(&["quake", "info", &usual])).contains("warning"));
    for (file, part) in [(&two, "found 2 samples"), (&slow, "time step of 0.11 s")] {
        for command in [&["quake", "info"][..], &["spectrum"]] {
            let arguments: Vec<&str> = command.iter().copied().chain([file.as_str()]).collect();
            let run = tankcheck(&arguments);
            let message = stderr(&run);
            assert_eq!(run.status.code(), Some(0), "{message}");
            assert!(
                message.contains("warning[T09") && message.contains(part) && message.contains("usual"),
                "{message}"
            );
        }
    }
    let bare = |step: f64| {
        let lines: String = (0..40).map(|i| format!("{} {}\n", step * f64::from(i), i % 7)).collect();
        home.write("bare.txt", &lines)
    };
    for step in [0.5, 5.0, 10.0, 20.0] {
        let file = bare(step);
        refused(
            &["quake", "info", &file, "--units", "gal"],
            &["milliseconds", &format!("a step of {step}"), "time_ms", "bare.txt:2:"],
        );
    }
    let run = tankcheck(&["quake", "info", &bare(0.25), "--units", "gal"]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let named = home.write("named.csv", "t [ms],a [gal]\n0,0\n10,1\n20,-1\n30,0\n");
    let run = tankcheck(&["quake", "info", &named]);
    assert!(printed(&run).contains("0.01") && run.status.code() == Some(0));
}

/// One list of warnings: standard error, `results.json`, the report.
#[test]
fn warnings_reach_terminal_results_and_report() {
    let home = Home::new();
    let tank = home.write("tank.json", &spoiled("1.5", "-1.5").replace("235 MPa", "2.2 GPa"));
    let quake = home.write("quake.csv", &record(1.0, 0.02, 40));
    let out = home.place("out");
    let run = tankcheck(&["compare", &tank, "--quake", &quake, "--out", &out, "--quiet", "--no-mesh-error"]);
    let message = stderr(&run);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{message}");
    let results = results::read(Path::new(&out)).expect("readable");
    let page = std::fs::read_to_string(Path::new(&out).join("report.html")).expect("written");
    assert_eq!(results.warnings.len(), 2, "{:?}", results.warnings);
    for part in ["scale_by is negative", "unusual yield strength"] {
        assert!(results.warnings.iter().any(|w| w.contains(part)), "{:?}", results.warnings);
        assert_eq!(
            message.lines().filter(|l| l.starts_with("warning[T09") && l.contains(part)).count(),
            1,
            "{message}"
        );
        assert!(page.contains(part), "{part}");
    }
    // A usual tank does not have this key.
    let tank = home.write("tank.json", TANK);
    let out = home.place("usual");
    let run = tankcheck(&["compare", &tank, "--quake", &quake, "--out", &out, "--quiet", "--no-mesh-error"]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let text = std::fs::read_to_string(Path::new(&out).join("results.json")).expect("written");
    assert!(!text.contains("\"warnings\"") && !text.contains("\"unusable\""));
}
