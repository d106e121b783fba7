//! Rendered faults.

use super::*;

const TANK: &str = "{\n  \"tank\": { \"radius\": \"1.83 kg\" }\n}\n";

fn fault() -> Fault {
    let start = TANK.find("\"1.83").unwrap();
    Fault::new(Code::OutOfRange, "a mass where a length belongs")
        .at(start..start + 9)
        .path("tank.radius")
        .found("\"1.83 kg\"")
        .allowed("a length")
        .help("write metres")
}

#[test]
fn shows_file_line_column_path_found_expected_help() {
    let text = Faults::from(fault()).render(&Source::new("in/tank.json", TANK), false);
    println!("{text}");
    for part in [
        "error[T0215]: a mass where a length belongs",
        "--> in/tank.json:2:23",
        "\"radius\": \"1.83 kg\"",
        "^^^^^^^^^ found \"1.83 kg\"",
        "path: tank.radius",
        "expected: a length",
        "help: write metres",
        "1 fault in in/tank.json",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    assert!(!text.contains('\u{1b}'));
}

#[test]
fn colours_only_when_asked() {
    assert!(Faults::from(fault()).render(&Source::new("t", TANK), true).contains("\u{1b}["));
}

#[test]
fn faults_come_in_the_order_of_the_file() {
    let mut faults = Faults::new();
    faults.push(Fault::new(Code::OutOfRange, "third"));
    faults.push(Fault::new(Code::OutOfRange, "second").at(5..6));
    faults.push(Fault::new(Code::OutOfRange, "first").at(0..1));
    let text = faults.render(&Source::new("t", TANK), false);
    let place = |what: &str| text.find(what).unwrap();
    assert!(place("first") < place("second") && place("second") < place("third"));
    assert!(text.contains("3 faults in t"));
}

#[test]
fn lines_of_records() {
    let source = Source::new("r.csv", "a\r\nbcd\n\nlast");
    assert_eq!(source.line_span(2), 3..6);
    assert_eq!(source.line_span(3), 7..7);
    assert_eq!(source.line_span(4), 8..12);
    assert_eq!(source.line_span(9), 12..12);
    assert_eq!(source.line_column(4), (2, 2));
    let text = Faults::from(Fault::new(Code::OutOfRange, "no number").at(source.line_span(2)).found("bcd"))
        .render(&source, false);
    assert!(text.contains("r.csv:2:1") && text.contains("2 | bcd"), "{text}");
}

#[test]
fn of_many_faults_the_first_of_the_file_are_shown_and_all_counted() {
    let text = "x".repeat(9_000);
    let mut faults = Faults::new();
    for i in (0..9_000).rev() {
        faults.push(Fault::new(Code::OutOfRange, format!("fault {i} of many")).at(i..i + 1));
    }
    assert_eq!((faults.count(), faults.list().len() < 2 * KEPT_FAULTS), (9_000, true));
    let text = faults.render(&Source::new("t", text), false);
    for i in 0..SHOWN_FAULTS {
        assert_eq!(text.matches(&format!("error[T0215]: fault {i} of many")).count(), 1, "{i}");
    }
    assert!(!text.contains("fault 50 of many"));
    assert!(text.contains("9000 faults in t, the first 50 shown, 8950 more; nothing was computed"), "{text}");
}

#[test]
fn long_and_hostile_lines_keep_their_place() {
    let long = format!("{}WRONG{}", "é".repeat(3_000), "y".repeat(3_000));
    let text = Faults::from(Fault::new(Code::OutOfRange, "m").at(6_001..6_006).found("WRONG"))
        .render(&Source::new("t.json", format!("\n{long}")), false);
    assert!(text.contains("--> t.json:2:3001"), "{text}");
    assert!(text.contains("éWRONGyyy") && text.contains("^^^^^ found WRONG"), "{text}");
    assert!(!text.contains(":::") && text.lines().count() == 8, "{text}");
    let hostile = "{ \"a\u{1b}[31m\u{202e}\u{9b}b\": 17 }";
    let at = hostile.find("17").unwrap();
    let text = Faults::from(Fault::new(Code::OutOfRange, "m").at(at..at + 2)).render(&Source::new("t", hostile), false);
    assert!(text.contains("--> t:1:16"), "{text}");
    assert!(text.contains(r"a\u{1b}[31m\u{202e}\u{9b}b"), "{text}");
    let (line, marks) = (text.lines().nth(3).unwrap(), text.lines().nth(4).unwrap());
    assert_eq!(line.find("17"), marks.find("^^"), "{text}");
    assert!(!text.chars().any(text::hostile));
}

#[test]
fn hostile_text_and_spans_are_harmless() {
    let text = format!("{}é{}\u{1b}[31m", "x".repeat(100_000), "y".repeat(100_000));
    let source = Source::new("bad\u{1b}[2Jname", &text);
    for span in [0..5, 100_000..100_002, 100_001..100_001, 200_000..300_000, 9_999_999..10_000_000] {
        let fault = Fault::new(Code::OutOfRange, "m\u{1b}[31m\nm").at(span).found("z".repeat(100_000)).path("p\r\n");
        let text = Faults::from(fault).render(&source, false);
        assert!(!text.chars().any(text::hostile));
        assert!(text.len() < 4_000, "{}", text.len());
    }
}
