//! A large file with faults throughout is answered: the reader does not compare all of it with all of it.
//!
//! Source:    the reader's own contract: a file of 1 MiB is answered at once
//! Goal:      an end to reading and rendering, and a message of bounded length
//! Expected:  128 KiB answered within 5 seconds of processor time, fifty faults and the number of the rest
//! Tolerance: a second in practice; a nanosecond for each pair of bytes would take 17 seconds. A faster quadratic reader passes

use std::time::{Duration, Instant};

use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

const GOOD: &str = r#""name": "t",
  "tank": { "shape": "cylinder", "radius": "10 m", "support": "anchored",
    "courses": [ { "height": "8 m", "thickness": "10 mm", "material": "steel" } ] },
  "liquid": { "density": "1000 kg/m3", "fill_height": "7 m" },
  "materials": { "steel": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3" } }"#;

/// Processor time of this thread where the system provides it, so that other programs do not count; else the clock time.
fn now(start: Instant) -> Duration {
    std::fs::read_to_string("/proc/thread-self/schedstat")
        .ok()
        .and_then(|text| text.split_whitespace().next()?.parse().ok())
        .map_or_else(|| start.elapsed(), Duration::from_nanos)
}

/// Time to read and render a text, the message and its number of faults.
fn answer(text: String) -> (Duration, String) {
    let start = Instant::now();
    let source = Source::new("tank.json", text);
    let before = now(start);
    let message = match parse(&source) {
        Ok(_) => String::new(),
        Err(faults) => faults.render(&source, false),
    };
    (now(start) - before, message)
}

/// A file of about `size` bytes: members that repeat, the text around them.
fn file(size: usize, before: &str, member: impl Fn(usize) -> String, after: &str) -> String {
    let mut text = before.to_owned();
    let mut i = 0;
    while text.len() + after.len() + 64 < size {
        if i > 0 {
            text.push(',');
        }
        text.push_str(&member(i));
        i += 1;
    }
    text + after
}

type Make = fn(usize) -> String;

const CASES: &[(&str, Make)] = &[
    ("unknown keys in one line", |n| file(n, &format!("{{ {GOOD},"), |i| format!("\"k{i}\":1"), "}")),
    ("unknown keys like known ones", |n| file(n, &format!("{{ {GOOD},"), |i| format!("\"gravit{i}\":1"), "}")),
    ("unknown keys, a line each", |n| file(n, &format!("{{ {GOOD},"), |i| format!("\n\"key {i}\": [{i}]"), "}")),
    ("duplicate keys, a line each", |n| file(n, &format!("{{ {GOOD},"), |_| "\n\"notes\":1".into(), "}")),
    ("incomplete materials", |n| file(n, "{\"materials\":{", |i| format!("\"m{i}\":{{}}"), "}}")),
    ("incomplete courses", |n| file(n, "{\"tank\":{\"courses\":[", |_| "{}".into(), "]}}")),
    ("wrong kinds in a list", |n| file(n, "{\"published\":[", |_| "1".into(), "]}")),
    ("unknown quantities", |n| {
        file(n, "{\"measured\":{", |i| format!("\"q{i}\":{{\"value\":\"1 m\",\"source\":\"s\"}}"), "}}")
    }),
    ("unknown procedures", |n| {
        file(n, &format!("{{ {GOOD}, \"procedures\":{{\"run\":["), |i| format!("\"p{i}\""), "]}}")
    }),
    ("procedures named again and again", |n| {
        file(n, &format!("{{ {GOOD}, \"procedures\":{{\"run\":["), |_| "\"housner\"".into(), "]}}")
    }),
    ("a long key above many values", |n| file(n, &format!("{{\"{}\":[", "k".repeat(n / 2)), |_| "1".into(), "]}")),
    ("long keys above long keys", |n| {
        let key = "k".repeat(n / 40);
        let open: String = (0..20).map(|_| format!("{{\"{key}\":")).collect();
        file(n, &format!("{open}["), |_| "{\"a\":1}".into(), &("]".to_owned() + &"}".repeat(20)))
    }),
    ("one long unknown key", |n| format!("{{ {GOOD}, \"{}\":1}}", "name".repeat(n / 4 - 200))),
    ("one long unknown unit", |n| format!("{{ {}}}", GOOD.replace("10 m\"", &format!("10 {}\"", "m".repeat(n - 600))))),
    ("one long unknown grade", |n| {
        format!(
            "{{ {}}}",
            GOOD.replace("\"youngs_modulus\"", &format!("\"grade\": \"{}\", \"youngs_modulus\"", "S".repeat(n - 600)))
        )
    }),
    ("a material of a long name in many courses", |n| {
        let good = GOOD.replace("\"steel\": {", &format!("\"{}\": {{", "s".repeat(n / 2)));
        let (head, tail) = good.split_once("\"courses\": [").unwrap();
        let course = "{ \"height\": \"8 m\", \"thickness\": \"10 mm\", \"material\": \"x\" }";
        let list = vec![course; (n / 2 / course.len()).min(200)].join(",");
        format!("{{ {head}\"courses\": [ {list}, {tail} }}")
    }),
    ("comments", |n| format!("{{ {GOOD}, \"x\": 1 {} }}", "/* c */ // d\n".repeat(n / 14 - 60))),
    ("brackets", |n| "[".repeat(n)),
    ("commas", |n| format!("{{ {GOOD} {} }}", ",".repeat(n - 600))),
    ("numbers that run on", |n| format!("{{ {GOOD}, \"x\": {} }}", "1.".repeat(n / 2 - 600))),
];

#[test]
fn a_file_of_faults_is_answered_with_fifty_and_the_number_of_the_rest() {
    const SIZE: usize = 1 << 17;
    for (name, make) in CASES {
        let text = make(SIZE);
        assert!((SIZE / 2..=SIZE).contains(&text.len()), "{name}: {} bytes", text.len());
        let (time, message) = answer(text);
        assert!(time < Duration::from_secs(5), "{name}: {time:?}");
        let shown = message.lines().filter(|l| l.starts_with("error")).count();
        // The last of them is the sum.
        assert!((2..=51).contains(&shown), "{name}: {shown} shown");
        assert!(message.len() < 200_000, "{name}: {} bytes", message.len());
        if shown == 51 {
            let sum = message.lines().rfind(|l| l.starts_with("error: ")).unwrap_or_default();
            let numbers: Vec<usize> = sum.split(|c: char| !c.is_ascii_digit()).filter_map(|w| w.parse().ok()).collect();
            assert_eq!((numbers.len(), numbers[1]), (3, 50), "{name}: {sum}");
            assert_eq!(numbers[0], numbers[1] + numbers[2], "{name}: {sum}");
        }
    }
}
