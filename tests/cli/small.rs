//! Values far below those of any tank or instrument: bad input with its range.

use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use crate::compare::{stderr, tankcheck};

const TANK: &str = r#"{
  "name": "plain",
  "tank": { "shape": "cylinder", "radius": "10 m", "support": "anchored",
    "courses": [ { "height": "8 m", "thickness": "10 mm", "material": "steel" } ],
    "foundation": { "kind": "slab", "friction": 0.4 },
    "anchors": { "count": 24, "capacity": "120 kN" } },
  "liquid": { "density": "1000 kg/m3", "fill_height": "7 m" },
  "materials": { "steel": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3",
    "yield_strength": "235 MPa" } },
  "site": { "ec8": { "ag": "0.2 g", "ground": "B", "spectrum": 1 } },
  "record": { "scale_by": 1.5 }
}"#;

fn spoiled(from: &str, to: &str) -> String {
    assert_eq!(TANK.matches(from).count(), 1, "`{from}` stands once");
    TANK.replace(from, to)
}

#[test]
fn values_of_no_tank_are_refused_with_the_range() {
    for (from, to, parts) in [
        ("7 m", "1e-12 m", ["liquid.fill_height", "too small", "at least 1 mm"]),
        (
            "7 m",
            "9.9 mm",
            ["liquid.fill_height", "shallower than any tank's", "at least 10.00 mm, a thousandth of the radius"],
        ),
        ("\"8 m\"", "\"1e-9 m\"", ["tank.courses[0].height", "too small", "at least 1 mm"]),
        ("10 mm", "1e-12 m", ["tank.courses[0].thickness", "too small", "at least 0.001 mm"]),
        ("\"10 m\"", "\"1e-9 m\"", ["tank.radius", "too small", "at least 1 mm"]),
        ("7850 kg/m3", "1e-9 kg/m3", ["materials.steel.density", "too small", "at least 1 kg/m3"]),
        ("1000 kg/m3", "1e-9 kg/m3", ["liquid.density", "too small", "greater than 50 kg/m3"]),
        ("235 MPa", "235 Pa", ["materials.steel.yield_strength", "too small", "at least 1 kPa"]),
        ("\"scale_by\": 1.5", "\"scale_to\": \"1e-300 g\"", ["record.scale_to", "too small", "1e-300 g"]),
        ("120 kN", "1e-9 N", ["tank.anchors.capacity", "too small", "at least 1 N"]),
        ("0.4", "1e-9", ["tank.foundation.friction", "too small", "at least 0.001"]),
        ("0.2 g", "1e-9 g", ["site.ec8.ag", "too small", "at least 0.001 m/s2"]),
    ] {
        let source = Source::new("tank.json", spoiled(from, to));
        let text = parse(&source).expect_err("a refusal").render(&source, false);
        for part in parts {
            assert!(text.contains(part), "`{part}` is missing in\n{text}");
        }
    }
    // The least that is read: a film of water in a small tank, a foil, one centimetre in a large tank.
    for (from, to) in
        [("7 m", "1 cm"), ("\"8 m\"", "\"7 m\""), ("7850 kg/m3", "1 kg/m3"), ("235 MPa", "1 kPa"), ("120 kN", "1 N")]
    {
        let source = Source::new("tank.json", spoiled(from, to));
        if let Err(faults) = parse(&source) {
            panic!("{from} -> {to}: {}", faults.render(&source, false));
        }
    }
}

struct Home(tempfile::TempDir);

impl Home {
    fn write(&self, name: &str, text: &str) -> String {
        let path = self.0.path().join(name);
        std::fs::write(&path, text).expect("writable");
        path.to_str().expect("plain").into()
    }
}

fn refused(arguments: &[&str], parts: &[&str]) {
    let run = tankcheck(arguments);
    let text = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{arguments:?}: {text}");
    for part in parts {
        assert!(text.contains(part), "{arguments:?}: `{part}` is missing in\n{text}");
    }
}

/// Steps and peaks of a record far below those of any instrument, in a file and in options.
#[test]
fn records_without_a_plausible_step_or_peak_are_refused() {
    let home = Home(tempfile::tempdir().expect("a temporary folder"));
    let steps = |rows: &str| home.write("steps.csv", rows);
    let of = |dt: f64| -> String {
        let rows = (0..20).map(|i| format!("{:e},{}\n", dt * f64::from(i), f64::from(i % 3) - 1.0));
        format!("time_s,acceleration_m_s2\n{}", rows.collect::<String>())
    };
    for dt in [1e-12, 1e-300, 9e-6] {
        let file = steps(&of(dt));
        refused(&["quake", "info", &file], &["T0404", "at least 0.00001 s, at most 10 s"]);
    }
    let peer =
        |dt: &str| format!("PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= {dt} SEC\n.1 .2 .1 -.1\n");
    let file = home.write("p.at2", &peer("1e-12"));
    refused(&["quake", "info", &file], &["T0404", "at least 0.00001 s, at most 10 s"]);
    let file = home.write("one.csv", "acceleration_g\n0.1\n0.2\n-0.1\n");
    refused(&["quake", "info", &file, "--dt", "1e-12"], &["--dt: found", "at least 0.00001, at most 10"]);
    let file = home.write("large.csv", "time_s,acceleration_g\n0,0\n0.01,1e300\n0.02,0\n");
    refused(&["quake", "info", &file], &["T0407", "out of range"]);
    // A sound step and a factor that leaves nothing of the motion.
    let quake = home.write("quake.csv", &of(0.02));
    let tank = home.write("tank.json", &spoiled("1.5", "1e-12"));
    refused(&["check", &tank, "--quake", &quake], &["scale_by", "at least 1e-9 m/s2"]);
}
