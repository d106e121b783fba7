//! Readers whose time grows with the size of a file, and which open regular files alone.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use tankcheck::input::diagnostic::Source;
use tankcheck::input::{csv, fragility, records, tank};

/// CPU time of this thread [s]; the time of day where the system does not give it.
fn clock() -> f64 {
    let ticks = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = ticks.split(' ').next().and_then(|n| n.parse::<f64>().ok());
    nanoseconds.map_or_else(|| std::time::UNIX_EPOCH.elapsed().map_or(0.0, |t| t.as_secs_f64()), |n| 1e-9 * n)
}

/// The least time of some runs [s].
fn time(read: impl Fn(&str), text: &str) -> f64 {
    let runs = (0..3).map(|_| {
        let start = clock();
        read(text);
        clock() - start
    });
    runs.fold(f64::INFINITY, f64::min)
}

/// `(read, text)`: text of n items, which the reader refuses
type Case = (fn(&str), fn(usize) -> String);

fn tank_of(item: &str, n: usize, around: [&str; 2]) -> String {
    let items: Vec<String> = (0..n).map(|i| item.replace('#', &i.to_string())).collect();
    format!("{{{}{}{}}}", around[0], items.join(","), around[1])
}

fn parse_tank(text: &str) {
    let source = Source::new("tank.json", text);
    let faults = tank::parse(&source).expect_err("faults");
    assert!(faults.render(&source, false).len() < 100_000, "the message is bounded");
}

fn parse_table(text: &str) {
    let source = Source::new("t.csv", text);
    if let Err(faults) = csv::parse(&source) {
        assert!(faults.render(&source, false).len() < 100_000);
    }
}

fn parse_record(text: &str) {
    let read = records::read_bytes(text.as_bytes(), Path::new("r.csv"), &records::ReadOptions::default());
    assert!(read.expect_err("faults").to_string().len() < 100_000);
}

/// Four times the file takes about four times as long; a square takes 16. Allowed are 9, for caches and short times.
#[test]
fn time_grows_with_the_file() {
    let cases: [(&str, Case); 12] = [
        (
            "bad units",
            (parse_tank, |n| {
                tank_of("{\"height\":\"8 q\",\"thickness\":\"1 mmm\"}", n, ["\"tank\":{\"courses\":[", "]}"])
            }),
        ),
        (
            "bad lengths of imperfections",
            (parse_tank, |n| {
                tank_of("{\"n\":0,\"amplitude\":\"1 q\"}", n, ["\"analysis\":{\"imperfections\":[", "]}"])
            }),
        ),
        ("unknown keys", (parse_tank, |n| tank_of("\"radiu#\":1", n, ["\"tank\":{", "}"]))),
        ("duplicate keys", (parse_tank, |n| tank_of("\n\"name\":1", n, ["", ""]))),
        ("materials", (parse_tank, |n| tank_of("\"m#\":{\"density\":\"x\"}", n, ["\"materials\":{", "}"]))),
        ("acceptances", (parse_tank, |n| tank_of("{\"check\":\"c#\",\"reason\":\"no\"}", n, ["\"accepted\":[", "]"]))),
        (
            "quantities",
            (parse_tank, |n| {
                tank_of("{\"quantity\":\"sloshing_heigt\",\"value\":\"1 q\"}", n, ["\"published\":[", "]"])
            }),
        ),
        (
            "columns",
            (parse_table, |n| {
                let head: Vec<String> = (0..n).map(|i| format!("tank.x{i}")).collect();
                format!("{}\n{}1\n", head.join(","), "1,".repeat(n - 1))
            }),
        ),
        ("equal columns", (parse_table, |n| format!("{}x\n1\n", "x,".repeat(n)))),
        ("rows", (parse_table, |n| format!("a,b\n{}", "1\n".repeat(n)))),
        ("titles", (parse_record, |n| format!("{}0,1\n", "time of a title\n".repeat(n)))),
        ("lines", (parse_record, |n| format!("time_s,acceleration_g\n0,1\n{}", "x,y\n".repeat(n)))),
    ];
    for (what, (read, text)) in cases {
        let n = 8_000 * 10 / text(10).len();
        let [short, long] = [n, 4 * n].map(|n| time(read, &text(n)));
        assert!(long < 9.0 * short.max(2e-3), "{what}: {short:.4} s, four times as much {long:.4} s");
    }
}

/// A bad unit is explained with the nearest one, which must not cost more than some good values.
#[test]
fn bad_values_take_about_as_long_as_good_ones() {
    let of = |height: &str| {
        let course = format!("{{\"height\":\"{height}\",\"thickness\":\"{height}\",\"material\":\"s\"}}");
        tank_of(&course, 3000, ["\"tank\":{\"courses\":[", "]}"])
    };
    let [good, bad] = [of("8 mm"), of("8 qq")].map(|text| time(parse_tank, &text));
    assert!(bad < 20.0 * good, "good values {good:.4} s, bad ones {bad:.4} s");
}

#[test]
fn states_of_a_table_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.csv");
    let rows = |n: usize| -> String { (0..n).map(|i| format!("1,1,1,s{i}\n")).collect() };
    for (n, holds) in [(100, true), (101, false), (9999, false)] {
        std::fs::write(&path, format!("im,n,exceed,damage_state\n{}", rows(n))).unwrap();
        assert_eq!(fragility::stripes(&path).is_ok(), holds, "{n}");
    }
}

/// Runs in a folder; a run that does not end is an error.
#[cfg(unix)]
fn ends(folder: &Path, mut command: Command) -> (Option<i32>, String) {
    let mut child =
        command.current_dir(folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > Duration::from_secs(60) {
            child.kill().unwrap();
            panic!("{command:?} does not end");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let done = child.wait_with_output().unwrap();
    (done.status.code(), String::from_utf8_lossy(&done.stderr).into_owned())
}

#[cfg(unix)]
#[test]
fn regular_files_and_pipes_of_the_shell_alone_are_opened() {
    let folder = tempfile::tempdir().unwrap();
    let home = folder.path();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    std::fs::copy(root.join("examples/05_oil_tank/tank.json"), home.join("tank.json")).unwrap();
    std::fs::copy(root.join("examples/records/elcentro.csv"), home.join("r.csv")).unwrap();
    assert!(Command::new("mkfifo").arg(home.join("pipe")).status().unwrap().success());
    let _socket = std::os::unix::net::UnixListener::bind(home.join("socket")).unwrap();
    std::fs::create_dir(home.join("results")).unwrap();
    std::os::unix::fs::symlink("../pipe", home.join("results/results.json")).unwrap();
    std::fs::write(home.join("set.json"), r#"{ "records": [ { "along": "pipe" } ] }"#).unwrap();
    let tankcheck = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tankcheck"));
        command.args(arguments);
        ends(home, command)
    };
    for (place, what) in
        [("pipe", "a named pipe"), ("socket", "a socket"), ("/dev/zero", "a device"), (".", "a folder")]
    {
        for arguments in [
            &["check", place][..],
            &["compare", "tank.json", "--quake", place],
            &["compare", "tank.json", "--set", place],
            &["check", "tank.json", "--table", place],
            &["quake", "info", place],
            &["spectrum", place],
            &["study", "plan", place, "--out", "farm"],
            &["fragility", "--stripes", place],
            &["fragility", "--stripes", "tank.json", "--hazard", place],
            &["quake", "synth", "--target", place, "--duration", "30", "--out", "set"],
        ] {
            let (code, said) = tankcheck(arguments);
            assert_eq!(code, Some(2), "{arguments:?}: {said}");
            assert!(said.contains(&format!("found {what}")), "{arguments:?}: {said}");
        }
    }
    let (code, said) = tankcheck(&["report", "results"]);
    assert!(code == Some(2) && said.contains("a named pipe"), "{said}");
    let (code, said) = tankcheck(&["compare", "tank.json", "--set", "set.json"]);
    assert!(code == Some(2) && said.contains("no such file"), "{said}");
    let mut shell = Command::new("bash");
    shell.arg("-c").arg(format!(
        "{0} check <(cat tank.json) --format json && {0} quake info <(cat r.csv)",
        env!("CARGO_BIN_EXE_tankcheck")
    ));
    let (code, said) = ends(home, shell);
    assert!(matches!(code, Some(0 | 1 | 4)), "{said}");
    assert!(!said.contains("named pipe"), "{said}");
}
