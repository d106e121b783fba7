use tank::Language;
use tank::units::System;

use super::catalogue::Catalogue;
use super::text::is_neutral;
use super::{CATALOGUE, INPUT_CATALOGUE, of_input, page, say, untranslated};
use crate::style::{self, Wish};

fn wish(language: Language, units: System) -> (style::Wished, style::Scope) {
    let wish = style::wish(Wish { language: Some(language), units: Some(units) });
    (wish, style::of(None))
}

const SAMPLE: &[(&str, &str)] = &[(
    "sample",
    "base shear\nGesamterdbebenkraft\n\n{} by method: {}.\n{1} je Verfahren: {2}.\n\nAt z = {#}, {}.\nBei z = {}, {}.\n\n\
     file {=}\nDatei {}\n\nHousner\nHousner\n\n{}, site\n{}, Standort\n\n{} {#}\n{} {}\n\n{}; {}\n{}; {}\n",
)];

#[test]
fn the_catalogue_has_no_faults() {
    assert_eq!(CATALOGUE.faults, Vec::<String>::new());
    assert_eq!(INPUT_CATALOGUE.faults, Vec::<String>::new());
}

#[test]
fn faults_of_a_file_are_named() {
    let faulty = Catalogue::new(&[("x", "a {}\n{} {3}\n\nb\n\nc\nd\n\nc\ne\n")]);
    assert_eq!(
        faulty.faults,
        ["x:1: `{} {3}` has a hole that `a {}` lacks", "x:4: `b` without its German", "x:9: `c` is `d` and `e`"]
    );
}

#[test]
fn holes_are_filled_with_translations() {
    let catalogue = Catalogue::new(SAMPLE);
    for (english, german) in [
        ("Base shear", "Gesamterdbebenkraft"),
        ("Base shear, site", "Gesamterdbebenkraft, Standort"),
        ("At z = 1.50 m, base shear.", "Bei z = 1,50\u{a0}m, Gesamterdbebenkraft."),
        (
            "Base shear by method: Housner 1.2 kN; Housner, site 3.",
            "Gesamterdbebenkraft je Verfahren: Housner 1,2\u{a0}kN; Housner, Standort 3.",
        ),
        ("file a.1.csv", "Datei a.1.csv"),
        (
            "Base shear by method: 2. At z = 3 m, base shear.",
            "Gesamterdbebenkraft je Verfahren: 2. Bei z = 3\u{a0}m, Gesamterdbebenkraft.",
        ),
    ] {
        let mut missing = Vec::new();
        assert_eq!(catalogue.translate(english, &mut missing), german);
        assert_eq!(missing, Vec::<String>::new());
    }
}

#[test]
fn what_is_missing_stays_and_is_named() {
    let catalogue = Catalogue::new(SAMPLE);
    let mut missing = Vec::new();
    let german = catalogue.translate("Base shear by method: strange thing 1.5.", &mut missing);
    assert_eq!(german, "Gesamterdbebenkraft je Verfahren: strange thing 1,5.");
    assert_eq!(missing, ["strange thing 1.5"]);
}

/// A text about an input file is German or not translated at all; paragraphs stay, and so does what is to be typed.
#[test]
fn texts_about_input_are_translated_whole() {
    for (english, german) in [
        (
            "Inner radius of a cylinder, which needs it. At least 0.1 mm, at most 1000 m.",
            "Innenradius eines Zylinders, der ihn benötigt. Mindestens 0,1 mm, höchstens 1000 m.",
        ),
        (
            "A liquid storage tank to be verified for earthquakes.\n\nComments and trailing commas are allowed.",
            "Ein Lagertank für Flüssigkeiten, der auf Erdbeben nachzuweisen ist.\n\nKommentare und Kommas am Ende sind erlaubt.",
        ),
        ("the key `radius` is missing", "der Schlüssel `radius` fehlt"),
    ] {
        assert_eq!(of_input(english).as_deref(), Some(german));
    }
    assert_eq!(of_input("The tank. A sentence that nobody has translated."), None);
}

#[test]
fn symbols_and_units_need_no_entry() {
    for text in ["12.5 kN·m", "σ_v / f_y", "T_c1 = 2.1 s", "S235", "`tank.radius`", "EN 1998-4:2006 A.3", "H/R"] {
        assert!(is_neutral(text), "{text}");
    }
    for text in ["wall", "12 checks", "at 5 s"] {
        assert!(!is_neutral(text), "{text}");
    }
}

/// Only texts change: code, paths, ids, styles and coordinates do not.
#[test]
fn a_page_keeps_its_markup() {
    let (_wish, _scope) = wish(Language::German, System::Si);
    let html = "<html lang=\"en\"><p id=\"base shear\">Base shear <code>base.shear 1.5</code></p>\
                <svg viewBox=\"0 0 1.5 2.5\"><path d=\"M1.5 2\"/><text x=\"1.5\">1.5</text></svg>\
                <math><mn>1.5</mn><mo>,</mo></math><td>S<sub>d</sub> 16\u{202f}312.5</td>";
    let german = "<html lang=\"de\"><p id=\"base shear\">Gesamterdbebenkraft <code>base.shear 1.5</code></p>\
                  <svg viewBox=\"0 0 1.5 2.5\"><path d=\"M1.5 2\"/><text x=\"1.5\">1,5</text></svg>\
                  <math><mn>1,5</mn><mo>;</mo></math><td>S<sub>d</sub> 16\u{202f}312,5</td>";
    let html = html.replace("Base shear <code>", "Base shear</p><p><code>");
    let german = german.replace("Gesamterdbebenkraft <code>", "Gesamterdbebenkraft</p><p><code>");
    assert_eq!(page(html), german);
    untranslated();
}

#[test]
fn an_english_page_in_si_is_not_touched() {
    let (_wish, _scope) = wish(Language::English, System::Si);
    let html = "<p>Base  shear &#x27; 1.5 m</p>";
    assert_eq!(page(html.into()), html);
}

#[test]
fn us_units_reach_sentences_but_not_what_the_user_wrote() {
    let (_wish, _scope) = wish(Language::English, System::Us);
    assert_eq!(say("at 0.3048 m"), "at 12 in");
    assert_eq!(
        page("<h1>Tank 10 m</h1><p>at 3.048 m</p><td class=\"given\">10 m</td>".into()),
        "<h1>Tank 10 m</h1><p>at 10 ft</p><td class=\"given\">10 m</td>"
    );
}

/// A character of the private use area in a text of the user is no formula.
#[test]
fn foreign_characters_stay() {
    let (_wish, _scope) = wish(Language::German, System::Si);
    assert_eq!(page("<p>\u{e005}</p>".into()), "<p>\u{e005}</p>");
}
