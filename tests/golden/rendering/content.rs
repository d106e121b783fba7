//! Sections, figures and marks that a report of each kind contains.

use super::{TITLE, rendered, report, sections};
use crate::sample::{Kind, sample};

/// A number whose mesh error is above a fifth is marked in the table and among the errors, and every warning is shown with its
/// markup escaped; without any, neither word is there.
#[test]
fn warnings_and_unusable_numbers_are_shown() {
    let plain = report(Kind::Compare).html;
    assert!(!plain.contains("unusable") && !plain.contains("<h3>Warnings</h3>"));
    let (mut results, series) = sample(Kind::Compare, TITLE);
    let fe = results.methods.iter().position(|m| m.id == "fe").expect("an engine");
    let row = (results.comparison.rows.iter_mut()).find(|r| r.quantity == "base_shear").expect("a base shear");
    row.cells[fe].as_mut().expect("a value").unusable = true;
    let run = results.runs.first_mut().expect("a run");
    run.mesh_error.insert("base_shear".into(), 0.34);
    results.warnings = vec!["record `<b>`: found a time step of 0.2 s, usual are 0.002 to 0.02 s".to_owned().into()];
    let html = rendered(&results, &series).html;
    assert_eq!(html.matches("✗ unusable").count(), 1);
    assert!(html.contains("34\u{a0}%, unusable"));
    assert!(
        html.contains("<h3>Warnings</h3>") && html.contains("&lt;b&gt;") && html.contains("found a time step of 0.2 s")
    );
}

#[test]
fn compare_shows_its_sections_in_order() {
    let html = report(Kind::Compare).html;
    let expected = [
        "summary",
        "tank",
        "checks",
        "sheets",
        "comparison",
        "partings",
        "reported",
        "limits",
        "engine",
        "profiles",
        "modes",
        "histories",
        "motion",
        "spectra",
        "input",
        "provenance",
    ];
    // A section that is not listed here may stand between them.
    let mut shown = sections(&html);
    shown.retain(|id| expected.contains(id));
    assert_eq!(shown, expected);
}

#[test]
fn check_leaves_out_what_it_has_not_computed() {
    let html = report(Kind::Check).html;
    let ids = sections(&html);
    for absent in ["motion", "spectra", "modes", "histories", "engine", "limits", "partings"] {
        assert!(!ids.contains(&absent), "{absent}");
    }
    for present in ["summary", "comparison", "checks", "tank", "input", "sheets", "provenance"] {
        assert!(ids.contains(&present), "{present}");
    }
    assert!(!html.contains("Finite elements"));
}

#[test]
fn the_three_dimensional_run_shows_its_pictures() {
    for kind in [Kind::Both, Kind::Solid] {
        let html = report(kind).html;
        assert!(sections(&html).contains(&"spatial"), "{kind:?}");
        for figure in [
            "mesh_spatial",
            "mode_spatial_1",
            "mode_spatial_3",
            "moment_1",
            "moment_2",
            "map_1_pressure",
            "map_2_hoop_stress",
        ] {
            assert!(html.contains(&format!("id=\"fig-{figure}\"")), "{kind:?}: {figure}");
        }
        // The scale factors are printed: 12 % of 3.66 m over 0.137 m, rounded down.
        assert!(html.contains("of the free surface × 2;"), "{kind:?}");
        let both = kind == Kind::Both;
        assert_eq!(html.contains("Difference between the engines"), both);
        assert_eq!(html.contains("id=\"fig-both_base_shear\""), both);
        assert_eq!(html.contains("+2.00\u{a0}%"), both);
        assert!(html.contains(".fig .v15"), "the palette of the maps");
    }
    assert!(!report(Kind::Compare).html.contains(".fig .v15"));
}

#[test]
fn an_interrupted_run_is_no_verdict() {
    let (mut results, series) = sample(Kind::Both, TITLE);
    results.runs[1].incomplete = true;
    results.verdict.unfinished = true;
    let html = rendered(&results, &series).html;
    let summary = &html[..html.find("id=\"comparison\"").expect("a second section")];
    assert!(summary.contains("Incomplete") && summary.contains("verdict fail"));
    assert!(!summary.contains("verdict ok"));
}

#[test]
fn a_sheet_on_the_site_repeats_nothing_of_the_sheet_on_the_record() {
    let html = report(Kind::Compare).html;
    let sheet = |id: &str| {
        let start = html.find(&format!("id=\"sheet-{id}\"")).expect("the sheet exists");
        &html[start..start + html[start..].find("</details>").expect("it is closed")]
    };
    let (record, site) = (sheet("housner-record"), sheet("housner-site"));
    assert!(record.contains("inner radius") && !site.contains("inner radius"));
    assert!(record.contains("base shear") && site.contains("base shear"));
    assert!(site.contains("href=\"#sheet-housner-record\""));
}

#[test]
fn levels_contain_each_other() {
    let (results, series) = sample(Kind::Compare, "tank");
    let templates = report::template::Templates::new(None).expect("the built-in ones");
    let at = |level| report::build(&results, &series, &templates, level).expect("it renders").html;
    let [summary, standard, full] = [report::Level::Summary, report::Level::Standard, report::Level::Full].map(at);
    assert_eq!(sections(&summary), ["summary", "tank"]);
    for id in sections(&standard) {
        assert!(sections(&full).contains(&id), "{id}");
    }
    for id in ["input", "modes", "partings", "engine"] {
        assert!(!sections(&standard).contains(&id) && sections(&full).contains(&id), "{id}");
    }
    // Cover, and what decides.
    for text in ["TK-104-SV-001", "Harbour Storage Ltd", "Signature", "id=\"fig-sketch\""] {
        assert!(summary.contains(text), "{text}");
    }
    // Of the sheets only those of deciding methods, and no procedure without a number of its figure.
    assert!(!full.contains("class=\"fno\"></span>") && !full.contains("class=\"tno\"></span>"));
    for decided in &results.verdict.deciding {
        let id = format!("id=\"sheet-{}-{}\"", decided.method, decided.excitation.word());
        assert_eq!(standard.contains(&id), full.contains(&id), "{id}");
    }
}

/// What an engine assumes stands at every level that has its numbers; without a deciding procedure every procedure has its sheet.
#[test]
fn the_standard_level_keeps_what_its_numbers_rest_on() {
    let templates = report::template::Templates::new(None).expect("the built-in ones");
    for kind in [Kind::Compare, Kind::Nonlinear] {
        let (mut results, series) = sample(kind, TITLE);
        let standard = |results: &_| {
            let report = report::build(results, &series, &templates, report::Level::Standard);
            report.expect("it renders").html
        };
        let html = standard(&results);
        let runs: Vec<_> = results.methods.iter().filter(|m| m.is_run()).collect();
        assert!(runs.iter().any(|m| !m.assumptions.is_empty()));
        for run in runs {
            assert!(html.contains(&format!("id=\"sheet-{}-", run.id)), "{}", run.id);
        }
        results.verdict.deciding.clear();
        let html = standard(&results);
        for method in results.methods.iter().filter(|m| !m.steps.is_empty()) {
            assert!(html.contains(&format!("id=\"sheet-{}-", method.id)), "{}", method.id);
        }
    }
}
