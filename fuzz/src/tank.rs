//! `tank.json`: any bytes give a case or faults that can be shown.
//!
//! A file that is read means the same when it is printed without comments, with its keys in another order, or with its
//! lengths in millimetres; every quantity in it comes back from print in every unit of its dimension.

use engines::nonlinear::push;
use engines::{ALL, Task};
use tank::refusal::Refusal;
use tank::units::{self, Dimension};
use tankcheck::input::TankFile;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;
use tankcheck::job;

use super::document::Json;

/// Runs the target on one input.
pub fn run(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let Some(file) = read(&text) else { return };
    promises(&file);
    let document = Json::parse(&text).expect("the reader accepts only JSON with comments");
    let meant = meaning(&file);
    for (how, other) in variants(&document) {
        let text = other.print();
        let again = read(&text).unwrap_or_else(|| panic!("{how}: refused\n{text}"));
        assert_eq!(meaning(&again), meant, "{how} means something else:\n{text}");
    }
    let mut quantities = document;
    quantities.each("", &mut |_, node| {
        if let Json::Text(text) = node {
            round_trips(text);
        }
    });
}

/// The file, or `None` for faults, which must be presentable.
pub fn read(text: &str) -> Option<TankFile> {
    let source = Source::new("tank.json", text);
    match parse(&source) {
        Ok(file) => Some(file),
        Err(faults) => {
            assert!(!faults.is_empty(), "refused without a fault");
            assert!(faults.render(&source, false).contains("error"), "a fault without a message");
            None
        }
    }
}

/// The refusals of an analysis.
type Refuses<'a> = Box<dyn Fn(&Task<'_>) -> Vec<Refusal> + 'a>;

/// Properties of a resolved file.
fn promises(file: &TankFile) {
    let (tank, liquid) = (&file.case.tank, &file.case.liquid);
    assert!(tank.courses.iter().all(|c| c.height > 0.0 && c.thickness > 0.0 && c.thickness.is_finite()));
    assert!(liquid.fill_height > 0.0 && liquid.fill_height <= tank.wall_height() * 1.000_001);
    assert!(liquid.density > 0.0 && liquid.density.is_finite());
    assert!(file.case.gravity > 0.0 && file.case.damping.impulsive.is_finite());
    let asked = ALL.iter().map(|&engine| Box::new(move |task: &Task<'_>| engine.refuses(task)) as Refuses<'_>);
    for refuses in asked.chain([Box::new(push::refuses) as Refuses<'_>]) {
        let refused = job::refused(file, refuses);
        assert!(refused.is_empty() || refused.render(&file.source, false).contains("error"));
    }
}

/// Other ways to write a document.
pub fn variants(document: &Json) -> [(&'static str, Json); 3] {
    [
        ("without comments", document.clone()),
        ("keys in reverse order", document.reversed()),
        ("lengths in millimetres", in_millimetres(document)),
    ]
}

/// The same with lengths in m written in mm: `"1.83 m"` is `"1.83e3 mm"`.
pub fn in_millimetres(document: &Json) -> Json {
    // Free text may look like a length.
    const WORDS: [&str; 5] = ["name", "source", "note", "material", "title"];
    let mut document = document.clone();
    document.each("", &mut |key, node| {
        let Json::Text(text) = node else { return };
        let Some(number) = text.trim().strip_suffix('m').map(str::trim_end) else { return };
        if WORDS.contains(&key)
            || number.parse::<f64>().is_err()
            || !number.ends_with(|c: char| c.is_ascii_digit() || c == '.')
        {
            return;
        }
        let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
        if let Ok(exponent) = exponent.parse::<i32>() {
            *text = format!("{mantissa}e{} mm", exponent.saturating_add(3));
        }
    });
    document
}

/// The content of a file as text; the order of named things does not count.
fn meaning(file: &TankFile) -> String {
    let mut case = file.case.clone();
    let mut named: Vec<String> = Vec::new();
    named.extend(case.measured.drain(..).map(|m| format!("{m:?}")));
    named.extend(case.published.drain(..).map(|p| format!("{p:?}")));
    named.extend(file.echo.iter().map(|e| format!("{} {}", e.path, e.default)));
    named.extend(file.remarks.iter().cloned());
    named.sort();
    format!(
        "{case:?}\n{:?}\n{:?}\n{:?}\n{:?}\n{:?}\n{named:?}",
        file.record, file.procedures, file.fe, file.solid, file.nonlinear
    )
}

/// A quantity comes back from print in every unit of its dimension.
fn round_trips(text: &str) {
    for dimension in Dimension::ALL {
        let Ok(value) = units::parse(text, dimension) else { continue };
        for unit in dimension.units() {
            let printed = units::display_in(value, unit, 17);
            let there = units::in_unit(value, unit);
            // Beyond the range of the other unit, or where doubles lose digits.
            if !there.is_finite() || there.abs() < 1e-290 || value.abs() < 1e-290 {
                continue;
            }
            let back = units::parse(&printed, dimension).unwrap_or_else(|e| panic!("{printed}: {e}"));
            assert!((back - value).abs() <= 1e-15 * value.abs(), "{text} → {printed} → {back:e}");
        }
    }
}
