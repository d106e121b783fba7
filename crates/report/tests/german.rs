//! The German reports of the examples have no English sentence left.
//!
//! `TANKCHECK_SHOW=folder cargo test -p report --test german` writes the pages and, as `missing.txt`, what the catalogue
//! lacks. Remedy: two lines in a file of `crates/report/src/language/german/`.

mod kept;

use std::collections::BTreeSet;
use std::path::Path;

use report::Level;
use report::language::untranslated;
use report::style::{self, Wish};
use tank::Language;
use tank::units::System;

/// Texts that are the same in both languages: names of tanks, records, files and persons.
const NAMES: &str = include_str!("german/names.txt");

fn show(name: &str, text: &str) {
    if let Ok(folder) = std::env::var("TANKCHECK_SHOW") {
        let path = Path::new(&folder).join(name);
        std::fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        std::fs::write(path, text).expect("writable");
    }
}

#[test]
fn no_english_is_left() {
    let _wish = style::wish(Wish { language: Some(Language::German), units: None });
    let mut missing = BTreeSet::new();
    for name in kept::names() {
        let page = kept::page(&name, Level::Full);
        let name = name.replace('/', "_");
        show(&format!("{name}.html"), &page.html);
        assert!(page.html.contains("<html lang=\"de\">"));
        let mut found = untranslated();
        found.extend(english(&page.html));
        show(&format!("missing_{name}.txt"), &found.join("\n"));
        missing.extend(found);
    }
    let ida = results::read_ida(&kept::reports().join("06_sandwich_strip/ida/ida.json")).expect("an analysis");
    let ida = report::ida::report(&ida).expect("renders").html;
    show("ida.html", &ida);
    let push = results::read_push(&kept::reports().join("07_steel_cylinder/push/push.json")).expect("a pushover");
    let push = report::push::report(&push).expect("renders").html;
    show("push.html", &push);
    let mut found = untranslated();
    found.extend(english(&ida).into_iter().chain(english(&push)));
    show("missing_analyses.txt", &found.join("\n"));
    missing.extend(found);
    let names: BTreeSet<&str> = NAMES.lines().filter(|l| !l.is_empty() && !l.starts_with('#')).collect();
    missing.retain(|text| !names.contains(text.as_str()));
    let list: Vec<String> = missing.into_iter().collect();
    show("missing.txt", &list.join("\n"));
    assert!(list.is_empty(), "{} texts without German:\n{}", list.len(), list.join("\n"));
}

/// Texts of a page that have English words, for entries that let a part of a sentence through.
fn english(html: &str) -> Vec<String> {
    let words = [
        "the", "of", "and", "with", "is", "are", "not", "from", "which", "by", "to", "base", "site", "record", "shell",
        "weight", "wall", "annex", "table", "that", "for", "its", "than",
    ];
    let has = |line: &&str| line.split([' ', ',', '.', ';', ':', '(', ')']).any(|w| words.contains(&w));
    let shown = plain(html);
    // Sources and remarks of measured values are those of the tank file.
    let found = shown.lines().map(str::trim).filter(has).filter(|l| !l.contains("Brüggemann"));
    found.map(|line| format!("English: {line}")).collect()
}

/// Symbols of SI that no number of a US report stands in front of.
#[test]
fn us_units_reach_every_number() {
    let _wish = style::wish(Wish { language: None, units: Some(System::Us) });
    let mut all = Vec::new();
    for name in kept::names() {
        let page = kept::page(&name, Level::Full);
        let name = name.replace('/', "_");
        show(&format!("us_{name}.html"), &page.html);
        let shown = plain(&page.html);
        let mut left = BTreeSet::new();
        for unit in [
            "mm", "m", "kN", "MN", "kN·m", "MN·m", "kPa", "MPa", "GPa", "kg", "t", "kg/m³", "m/s²", "kJ", "MJ", "MN/m³",
        ] {
            for (at, _) in shown.match_indices(&format!(" {unit}")) {
                let before = shown[..at].chars().next_back();
                let after = shown[at + 1 + unit.len()..].chars().next();
                if before.is_some_and(|c| c.is_ascii_digit())
                    && after.is_none_or(|c| !c.is_alphanumeric() && !matches!(c, '·' | '/' | '²' | '³' | '='))
                {
                    let from = shown[..at].char_indices().rev().nth(40).map_or(0, |(i, _)| i);
                    left.insert(shown[from..at + 1 + unit.len()].to_owned());
                }
            }
            for (at, _) in shown.match_indices(&format!("[{unit}]")) {
                let from = shown[..at].char_indices().rev().nth(40).map_or(0, |(i, _)| i);
                left.insert(shown[from..at + 2 + unit.len()].to_owned());
            }
        }
        // Units of several factors of which one was converted.
        for half in ["kip m", "lbf m", "klb m", "lb m", "kip s/m", "lbf s/m", "kip·m", "lbf·m"] {
            left.extend(shown.contains(half).then(|| half.to_owned()));
        }
        all.extend(left.into_iter().map(|text| format!("{name}: {text:?}")));
    }
    assert!(all.is_empty(), "{} values in SI:\n{}", all.len(), all.join("\n"));
}

/// Parts that are not read: styles, formulas with what is put into them, texts of the user, and clauses, which are quoted.
const UNREAD: [(&str, &str); 8] = [
    ("class=\"calc\"", "</td>"),
    ("<style", "</style>"),
    ("<title>", "</title>"),
    ("<h1>", "</h1>"),
    ("<code>", "</code>"),
    ("<math", "</math>"),
    ("class=\"clause\"", "<"),
    ("class=\"given\"", "</td>"),
];

/// The text of a page, tags as line breaks, all blanks as one.
fn plain(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        out.push_str(&rest[..at]);
        out.push('\n');
        rest = &rest[at..];
        let tag = rest.find('>').map_or(rest.len(), |e| e + 1);
        // The end of what is not read is sought behind the tag.
        let unread = UNREAD.iter().find(|(open, _)| rest[..tag].contains(open));
        let end = unread.and_then(|(_, close)| rest[tag..].find(close).map(|e| tag + e));
        rest = &rest[end.unwrap_or(tag)..];
    }
    out.push_str(rest);
    out.replace('\u{a0}', " ")
}

/// In the system of both, each value has its second one, once.
#[test]
fn both_systems_side_by_side() {
    let _wish = style::wish(Wish { language: None, units: Some(System::Both) });
    let page = kept::page("05_oil_tank", Level::Standard);
    show("both.html", &page.html);
    let shown = plain(&page.html);
    assert!(shown.contains("m (ft)") && shown.contains("MPa (ksi)"));
    for twice in ["ft) (", "in) (", "ksi) (", "kip) ("] {
        let found: Vec<&str> = shown.lines().filter(|l| l.contains(twice)).collect();
        assert!(found.is_empty(), "{found:#?}");
    }
}
