//! Accelerograms through the command line: output of `quake info` and `spectrum`, and messages for rejected files.

use std::path::{Path, PathBuf};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";

/// Runs `compare` with this record: it must end with exit code 2 and a message with the file and all of `words`, without
/// standard output or an output folder.
fn refused(record: &Path, words: &[&str]) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let text = |path: &Path| path.to_str().expect("a temporary path is text").to_owned();
    let run = tankcheck(&["compare", TANK, "--quake", &text(record), "--out", &text(&out)]);
    let message = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{message}");
    let name = record.file_name().expect("a name").to_string_lossy();
    assert!(message.contains(name.as_ref()), "the file is not named in: {message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
    assert!(run.stdout.is_empty());
    assert_eq!(std::fs::read_dir(home.path()).expect("readable").count(), 0, "something was left behind");
}

/// A record file with this content in a temporary folder.
fn file(home: &Path, name: &str, content: &[u8]) -> PathBuf {
    let path = home.join(name);
    std::fs::write(&path, content).expect("writable");
    path
}

#[test]
fn bad_records_are_refused_with_file_and_place() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let head = "time_s,acceleration_m_s2\n";
    let record = |name: &str, rows: &str| file(home.path(), name, format!("{head}{rows}").as_bytes());
    refused(&record("one.csv", "0,0.1\n"), &["1 sample"]);
    refused(&record("nan.csv", "0,0\n0.01,NaN\n0.02,0.1\n"), &[":3", "NaN"]);
    refused(&record("inf.csv", "0,0\n0.01,inf\n0.02,0.1\n"), &[":3", "inf"]);
    refused(&record("step.csv", "0,0\n0.01,0.1\n0.03,0.2\n0.04,0.1\n"), &["step"]);
    refused(&record("back.csv", "0,0\n0.01,0.1\n0.005,0.2\n"), &[":4"]);
    refused(&record("word.csv", "0,0\n0.01,abc\n0.02,0.1\n"), &[":3", "abc"]);
    refused(&record("huge_peak.csv", "0,0\n0.01,600\n0.02,0.1\n"), &["--allow-implausible"]);
    refused(&file(home.path(), "empty.csv", b""), &["empty"]);
    refused(&file(home.path(), "garbage.csv", &[0, 159, 146, 150, 7, 0, 255, 254, 1, 2]), &["not text"]);
    refused(&file(home.path(), "unit.csv", b"0,0\n0.01,0.1\n0.02,0\n"), &["--units"]);
    refused(&home.path().join("missing.csv"), &["no such file"]);
    std::fs::create_dir(home.path().join("folder")).expect("writable");
    refused(&home.path().join("folder"), &["folder"]);
}

#[test]
fn a_count_that_does_not_match_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let at2 = "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, component\nACCELERATION TIME HISTORY IN UNITS OF G\n\
               NPTS=    9, DT=   .0100 SEC\n  .100E-02  .200E-02  .300E-02  .400E-02  .500E-02\n  .600E-02  .700E-02\n";
    refused(&file(home.path(), "short.at2", at2.as_bytes()), &["NPTS", "9", "7"]);
}

#[test]
fn three_million_samples_are_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let mut content = b"acceleration_m_s2\n".to_vec();
    content.extend_from_slice("0.1\n".repeat(3_000_000).as_bytes());
    refused(&file(home.path(), "long.csv", &content), &["too long", "2000000"]);
}

#[test]
fn quake_info_tells_what_is_in_a_record() {
    let run = tankcheck(&["quake", "info", QUAKE, "--format", "json"]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let info: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
    let text = info.to_string();
    // The table's own peak, 0.31882 g, in m/s².
    let pga = info["pga"].as_f64().or_else(|| info["pga"]["value"].as_f64());
    assert!(pga.is_some_and(|pga| (pga - 0.31882 * 9.80665).abs() < 1e-4), "{text}");
}

#[test]
fn spectra_have_the_promised_form_in_one_call() {
    let arguments = ["spectrum", QUAKE, "--damping", "0.5%,1%,2%,5%", "--periods", "0.02..20", "--format", "json"];
    let run = tankcheck(&arguments);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let found: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
    let spectra = found["spectra"].as_array().expect("spectra");
    assert_eq!(spectra.iter().map(|s| s["damping"].as_f64()).collect::<Vec<_>>(), [0.005, 0.01, 0.02, 0.05].map(Some));
    for spectrum in spectra {
        let points = spectrum["points"].as_array().expect("points");
        assert_eq!(points.len(), 200);
        for point in points {
            let value = |key: &str| point[key].as_f64().expect("a number");
            let omega = 2.0 * std::f64::consts::PI / value("period");
            assert!((value("psv") / (omega * value("sd")) - 1.0).abs() < 1e-9);
            assert!((value("psa") / (omega * omega * value("sd")) - 1.0).abs() < 1e-9);
            assert!(value("sv") > 0.0 && value("sa") > 0.0);
        }
    }
    let list = tankcheck(&["spectrum", QUAKE, "--damping", "5%", "--periods", "0.1,0.5,2", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_slice(&list.stdout).expect("JSON");
    let periods: Vec<f64> =
        found["spectra"][0]["points"].as_array().expect("points").iter().filter_map(|p| p["period"].as_f64()).collect();
    assert_eq!(periods, [0.1, 0.5, 2.0]);
}

#[test]
fn senseless_dampings_and_periods_are_refused() {
    for (option, value) in [("--damping", "150%"), ("--damping", "abc"), ("--periods", "2..1"), ("--periods", "-1")] {
        let argument = format!("{option}={value}");
        let run = tankcheck(&["spectrum", QUAKE, &argument]);
        assert_eq!(run.status.code(), Some(2), "{argument}: {}", stderr(&run));
        assert!(run.stdout.is_empty());
    }
}

/// What `convert` writes is read back bit by bit, with its source in comments; a file that exists stays.
#[test]
fn a_converted_record_is_the_record() {
    let folder = tempfile::tempdir().unwrap();
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/records/elcentro.csv");
    let out = folder.path().join("out.csv");
    let out = out.to_str().unwrap();
    let quake = |arguments: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_tankcheck"));
        command.arg("quake").args(arguments).output().unwrap()
    };
    assert!(quake(&["convert", source, "--out", out]).status.success());
    let facts = |path: &str| -> serde_json::Value {
        serde_json::from_slice(&quake(&["info", path, "--format", "json"]).stdout).unwrap()
    };
    let (one, other) = (facts(source), facts(out));
    for key in ["samples", "dt", "pga", "pgv", "pgd", "arias", "cav"] {
        assert_eq!(one[key], other[key], "{key}");
    }
    // The table of the example is not the record of the test, which has 0.348 g.
    let peknold = "Imperial Valley 1940, El Centro, NS, Peknold, as textbooks print it";
    assert_eq!((&one["known_as"], &other["known_as"]), (&peknold.into(), &peknold.into()));
    let text = std::fs::read_to_string(out).unwrap();
    assert!(text.contains(&format!("# known as: {peknold}\n")));
    assert!(text.starts_with("# record: ") && text.contains(one["sha256"].as_str().unwrap()));
    assert!(text.contains("# source: elcentro.csv\n"));
    let shown = quake(&["convert", source, "--out", "-"]);
    assert_eq!(String::from_utf8(shown.stdout).unwrap(), text);
    assert!(!std::path::Path::new("-").exists());
    let again = quake(&["convert", source, "--out", out]);
    assert_eq!(again.status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(out).unwrap(), text);
}

/// A file of every agency keeps its samples and the corner of its filter through `convert`.
#[test]
fn files_of_agencies_are_converted() {
    let folder = tempfile::tempdir().unwrap();
    let quake = |arguments: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_tankcheck"));
        command.arg("quake").args(arguments).output().unwrap()
    };
    let facts = |arguments: &[&str]| -> serde_json::Value { serde_json::from_slice(&quake(arguments).stdout).unwrap() };
    for (name, samples, corner) in [
        ("esm.asc", 4, Some(0.2)),
        ("knet.ns", 10, None),
        ("usgs.smc", 10, None),
        ("cosmos.v2", 9, Some(0.3)),
        ("csmip.v2", 3, Some(0.1)),
    ] {
        let source = format!("{}/tests/records/{name}", env!("CARGO_MANIFEST_DIR"));
        let out = folder.path().join(format!("{name}.csv"));
        let out = out.to_str().unwrap();
        let several = if name.starts_with("csmip") { &["--channel", "1"][..] } else { &[] };
        let converted = quake(&[&["convert", source.as_str(), "--out", out], several].concat());
        assert!(converted.status.success(), "{name}: {converted:?}");
        let one = facts(&[&["info", source.as_str(), "--format", "json"], several].concat());
        let other = facts(&["info", out, "--format", "json"]);
        assert_eq!(one["samples"], samples, "{name}");
        for key in ["samples", "dt", "pga", "pgv", "pgd", "low_cut_frequency_hz"] {
            assert_eq!(one[key], other[key], "{name} {key}");
        }
        assert_eq!(one["low_cut_frequency_hz"].as_f64(), corner, "{name}");
    }
}

/// Channels of one file are components of one earthquake: `FILE#CHANNEL` in every place of a record.
#[test]
fn channels_of_a_file_are_its_components() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let text = |path: &Path| path.to_str().expect("a temporary path is text").to_owned();
    let columns: String = (0..400)
        .map(|k| {
            let t = f64::from(k) * 0.01;
            let a = (6.0 * t).sin() * (-t).exp();
            format!("{t:.2},{:.6},{:.6},{:.6}\n", 0.2 * a, 0.1 * a, 0.05 * a)
        })
        .collect();
    let station = file(home.path(), "station.csv", format!("time_s,N-S (g),E-W (g),U-D (g)\n{columns}").as_bytes());
    let of = |channel: &str| format!("{}#{channel}", text(&station));
    let info = |arguments: &[&str]| -> serde_json::Value {
        let run = tankcheck(&[&["quake", "info", "--format", "json"], arguments].concat());
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        serde_json::from_slice(&run.stdout).expect("JSON")
    };
    assert_eq!(info(&[&of("2")]), info(&[&text(&station), "--channel", "E-W"]));
    assert_eq!(info(&[&of("u-d"), "--channel", "1"])["channel"], "U-D (g)");
    refused(&station, &["several channels", "1: N-S (g); 2: E-W (g); 3: U-D (g)", "FILE#CHANNEL"]);
    let out = home.path().join("out");
    let run = tankcheck(&[
        "compare",
        TANK,
        "--quake",
        &of("1"),
        "--quake-y",
        &of("2"),
        "--vertical",
        &of("3"),
        "--out",
        &text(&out),
    ]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let results: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("results.json")).expect("results")).expect("JSON");
    let names = results.to_string();
    assert!(names.contains("station.csv#1") && names.contains("station.csv#3"), "the channels are not named");
    // A set of components of one file is a set of different records, and twice the same channel is not.
    let set = |across: &str| {
        let entry =
            |k: u32| format!("{{ \"name\": \"r{k}\", \"along\": \"s{k}.csv#1\", \"across\": \"s{k}.csv#{across}\" }}");
        for k in 1..=3 {
            let content = format!(
                "time_s,N-S (g),E-W (g)\n{}",
                columns
                    .replace(",0.0", &format!(",0.0{k}"))
                    .lines()
                    .map(|line| {
                        let cells: Vec<&str> = line.split(',').collect();
                        format!("{},{},{}\n", cells[0], cells[1], cells[2])
                    })
                    .collect::<String>()
            );
            std::fs::write(home.path().join(format!("s{k}.csv")), content).expect("writable");
        }
        let list: Vec<String> = (1..=3).map(entry).collect();
        let path = file(home.path(), "set.json", format!("{{ \"records\": [{}] }}", list.join(", ")).as_bytes());
        let out = home.path().join(format!("set-{across}"));
        let tank = "examples/05_oil_tank/tank.json";
        tankcheck(&["compare", tank, "--fe", "none", "--set", &text(&path), "--out", &text(&out)])
    };
    let twice = set("1");
    assert_eq!(twice.status.code(), Some(2));
    assert!(stderr(&twice).contains("the same record twice"), "{}", stderr(&twice));
    let run = set("2");
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let none = tankcheck(&["quake", "info", &of("4")]);
    assert!(none.status.code() == Some(2) && stderr(&none).contains("no such channel"), "{}", stderr(&none));
}

/// 0.1 g over ten periods of 2 s; and 5 mm, whose integrals from rest are X sin ωt within the third of a step of its pulse, 0.5 %.
#[test]
fn harmonic_motion_needs_no_file() {
    let facts = |record: &str| -> serde_json::Value {
        let run = tankcheck(&["quake", "info", record, "--format", "json"]);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        serde_json::from_slice(&run.stdout).expect("JSON")
    };
    let number = |facts: &serde_json::Value, key: &str| facts[key].as_f64().expect("a number");
    let burst = facts("harmonic:amplitude=0.1g,period=2,cycles=10");
    assert!((number(&burst, "pga_g") - 0.1).abs() < 1e-9 && (number(&burst, "duration") - 20.0).abs() < 1e-9);
    let moved = facts("harmonic:amplitude=5mm,frequency=0.5,duration=20");
    assert!((number(&moved, "pgd") / 0.005 - 1.0).abs() < 0.02, "{}", number(&moved, "pgd"));
    for (record, word) in [
        ("harmonic:amplitude=0.1,period=2,cycles=10", "its unit"),
        ("harmonic:amplitude=0.1g,cycles=10", "frequency or period"),
        ("harmonic:amplitude=0.1g,period=2,cycles=10,pause=3", "pause=3"),
        ("harmonic:amplitude=5mm,period=2,cycles=10,ramp=1", "--ramp"),
    ] {
        let run = tankcheck(&["compare", TANK, "--quake", record, "--out", "/nonexistent/out"]);
        assert_eq!(run.status.code(), Some(2));
        assert!(stderr(&run).contains(word), "{}", stderr(&run));
    }
}

#[test]
fn a_rotation_is_refused_where_no_base_turns() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let good = file(home.path(), "good.csv", b"time_s,rotation_rad_s2\n0,0\n0.02,0.1\n0.04,0\n");
    let bad = file(home.path(), "bad.csv", b"time_s,acceleration_m_s2\n0,0\n0.02,0.1\n0.04,0\n");
    let drifts = file(home.path(), "drifts.csv", b"time_s,rotation_rad_s2\n0,0.1\n5,0.1\n10,0.1\n");
    let unanchored = "examples/01_broad_tank/unanchored/tank.json";
    let burst = "harmonic:amplitude=0.1g,period=2,cycles=5";
    for (tank, path, more, word) in [
        (TANK, &good, &["--fe", "solid"][..], "--fe harmonic"),
        (TANK, &good, &["--integrator", "newmark"], "modal integration"),
        (TANK, &good, &["--quake-y", QUAKE], "--quake-y"),
        (unanchored, &good, &[], "unanchored"),
        (TANK, &bad, &[], "time_s,rotation_rad_s2"),
        (TANK, &drifts, &["--no-mesh-error"], "0.1 rad"),
    ] {
        let out = home.path().join("out");
        let (path, out) = (path.to_str().expect("text"), out.to_str().expect("text"));
        let mut arguments = vec!["compare", tank, "--quake", burst, "--quake-rotation", path, "--out", out];
        arguments.extend(more);
        let run = tankcheck(&arguments);
        assert_eq!(run.status.code(), Some(2), "{word}: {}", stderr(&run));
        assert!(stderr(&run).contains(word), "`{word}` is missing in: {}", stderr(&run));
    }
}

/// The key of the tank file turns the base as the option does; what it excludes is said at its place.
#[test]
fn a_rotation_is_a_key_of_the_tank_file() {
    let home = tempfile::tempdir().expect("a temporary folder");
    file(home.path(), "turn.csv", b"time_s,rotation_rad_s2\n0,0\n0.2,0.1\n0.4,-0.2\n0.6,0.1\n0.8,0\n");
    let example = std::fs::read_to_string(TANK).expect("an example");
    let keyed = |keys: &str| example.replacen("\"analysis\": {", &format!("\"analysis\": {{ {keys},"), 1);
    let run = |text: &str, arguments: &[&str]| {
        let tank = file(home.path(), "tank.json", text.as_bytes());
        let out = home.path().join("out");
        let fixed = [
            "compare",
            tank.to_str().expect("text"),
            "--no-report",
            "--no-mesh-error",
            "--format",
            "json",
            "--select",
            "quantities",
        ];
        let fixed = fixed.into_iter().chain(["--out", out.to_str().expect("text")]);
        tankcheck(&fixed.chain(arguments.iter().copied()).collect::<Vec<_>>())
    };
    let burst = ["--quake", "harmonic:amplitude=0.1g,period=2,cycles=2"];
    let with = |more: &[&'static str]| burst.iter().chain(more).copied().collect::<Vec<_>>();
    let key = keyed("\"quake_rotation\": \"turn.csv\"");
    let turn = home.path().join("turn.csv");
    let option = burst.iter().copied().chain(["--quake-rotation", turn.to_str().expect("text")]).collect::<Vec<_>>();
    let quantities = |run: &std::process::Output| {
        String::from_utf8_lossy(&run.stdout).split("\"quantities\"").nth(1).map(str::to_owned)
    };
    let (by_key, by_option, still) = (run(&key, &burst), run(&example, &option), run(&example, &burst));
    assert!(quantities(&by_key).is_some(), "{}", stderr(&by_key));
    assert_eq!(quantities(&by_key), quantities(&by_option));
    assert_ne!(quantities(&by_key), quantities(&still));
    let set = [1, 2, 3].map(|i| format!("examples/10_tank_farm/records/synthetic-00{i}.csv"));
    for (text, arguments, words) in [
        (&keyed("\"quake_rotation\": \"nowhere.csv\""), with(&[]), ["analysis.quake_rotation", "nowhere.csv"]),
        (&keyed("\"quake_rotation\": \"tank.json\""), with(&[]), ["tank.json: found the head", "equal steps of time"]),
        (&key, with(&["--fe", "solid"]), ["analysis.quake_rotation", "use --fe harmonic"]),
        (&key, with(&["--fe", "nonlinear"]), ["analysis.quake_rotation", "use --fe harmonic"]),
        (&key, with(&["--quake-y", QUAKE]), ["analysis.quake_rotation", "remove --quake-y"]),
        (&key, with(&["--integrator", "newmark"]), ["analysis.quake_rotation", "modal integration"]),
        (
            &key,
            set.iter().flat_map(|path| ["--quake", path.as_str()]).collect(),
            ["analysis.quake_rotation", "a set of records"],
        ),
    ] {
        let run = run(text, &arguments);
        assert_eq!(run.status.code(), Some(2), "{words:?}: {}", stderr(&run));
        assert!(words.iter().all(|word| stderr(&run).contains(word)), "{words:?} are missing in: {}", stderr(&run));
    }
}
