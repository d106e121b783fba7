//! Form of a report: well-formed, escaped, deterministic and complete, also with unusual numbers and templates of a user.

use std::collections::BTreeSet;

use report::build;
use report::template::Templates;
use results::SeriesInfo;
use tank::assessment::CheckStatus;
use tank::units::Dimension;

use super::{EVERY, TITLE, figures, rendered, report, sections};
use crate::sample::{Kind, sample};

#[test]
fn every_heading_is_followed_by_content() {
    for kind in EVERY {
        let html = report(kind).html;
        for level in 2..=4 {
            for rest in html.split(&format!("</h{level}>")).skip(1) {
                let next = rest.trim_start();
                let same_or_higher = (2..=level).any(|l| next.starts_with(&format!("<h{l}")));
                assert!(
                    !same_or_higher && !next.starts_with("</section") && !next.starts_with("</details"),
                    "{kind:?}: empty heading before {}",
                    &next[..next.len().min(80)]
                );
            }
        }
    }
}

#[test]
fn text_of_the_input_is_escaped_everywhere() {
    let hostile = "<script>alert(1)</script>\"'</style></title>&amp; \\22";
    let (mut results, series) = sample(Kind::Compare, hostile);
    results.tank.tank.courses[0].material.name = hostile.into();
    results.records[0].name = hostile.into();
    results.records[0].processing = vec![hostile.into()];
    results.spectra[0].title = hostile.into();
    results.input[0].text = hostile.into();
    results.input[0].path = hostile.into();
    results.files[0].name = hostile.into();
    results.volatile.command = hostile.into();
    results.comparison.published[0].source = hostile.into();
    results.comparison.differences[0].method = hostile.into();
    let fe = results.runs.first_mut().expect("compare has an engine");
    fe.limits[1].note = hostile.into();
    fe.histories[3].title = hostile.into();
    fe.envelopes[0].title = hostile.into();
    fe.mesh[0].text = hostile.into();
    for method in &mut results.methods {
        method.title = hostile.into();
        method.notes = vec![hostile.into()];
        for step in &mut method.steps {
            step.formula = hostile.into();
            step.look_up = hostile.into();
            step.symbol = hostile.into();
            step.clause = hostile.into();
        }
        for check in &mut method.checks {
            check.name = hostile.into();
            check.note = hostile.into();
        }
        for profile in &mut method.profiles {
            profile.id = hostile.into();
        }
    }
    let report = rendered(&results, &series);
    assert!(!report.html.contains("<script"));
    assert_eq!(report.html.matches("</style>").count(), 1);
    assert_eq!(report.html.matches("</title>").count(), 1 + figures(&report.html).len());
    for (name, svg) in &report.figures {
        assert!(!name.contains(['/', '\\', '<']), "{name}");
        roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

#[test]
fn the_report_stands_alone() {
    let html = report(Kind::Compare).html;
    assert!(html.contains("default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:"));
    // The font of formulas, once and within the page.
    let font = "url(data:font/woff2;base64,";
    assert_eq!(html.matches(font).count(), 1);
    assert_eq!(html.matches("url(").count(), 1);
    for foreign in ["src=", "href=\"http", "@import", "<script", "<link"] {
        assert!(!html.contains(foreign), "{foreign}");
    }
    let size = html.split_once(font).and_then(|(_, rest)| rest.find(')')).expect("the font ends");
    assert!((10_000..60_000).contains(&size), "{size} bytes of font");
    assert!(html.len() < 1_500_000, "{} bytes", html.len());
}

#[test]
fn figures_are_well_formed_described_and_have_their_data() {
    for kind in EVERY {
        let report = report(kind);
        let inline = figures(&report.html);
        assert_eq!(inline.len(), report.figures.len(), "{kind:?}");
        let mut ids = BTreeSet::new();
        for svg in inline {
            let document = roxmltree::Document::parse(svg).expect("inline figures are well-formed");
            let root = document.root_element();
            assert_eq!(root.attribute("role"), Some("img"));
            let child = |name: &str| root.children().find(|n| n.has_tag_name(name)).and_then(|n| n.text());
            let title = child("title").expect("a title");
            let description = child("desc").expect("a description");
            assert!(!title.is_empty() && description.len() > 20, "{title}: {description}");
            for node in document.descendants() {
                if let Some(id) = node.attribute("id") {
                    assert!(ids.insert(id.to_owned()), "id {id} twice");
                }
                for looks in ["fill", "stroke", "color"] {
                    assert!(node.attribute(looks).is_none(), "{title}: looks belong into the style sheet");
                }
            }
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{title}");
        }
        for figure in report.html.split("<figure ").skip(1) {
            let figure = figure.split("</figure>").next().unwrap_or("");
            assert!(figure.contains("<td"), "{}", &figure[..80]);
        }
        for (name, svg) in &report.figures {
            let document = roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(document.root_element().tag_name().namespace(), Some("http://www.w3.org/2000/svg"));
        }
    }
}

#[test]
fn ids_are_unique_and_links_lead_somewhere() {
    let html = report(Kind::Compare).html;
    let mut ids = BTreeSet::new();
    for rest in html.split(" id=\"").skip(1) {
        let id = rest.split('"').next().unwrap_or("");
        assert!(ids.insert(id), "id {id} twice");
    }
    for rest in html.split("href=\"#").skip(1) {
        let target = rest.split('"').next().unwrap_or("");
        assert!(ids.contains(target), "#{target}");
    }
}

#[test]
fn rendering_is_deterministic() {
    let (results, series) = sample(Kind::Compare, TITLE);
    assert_eq!(rendered(&results, &series), report(Kind::Compare));
}

#[test]
fn volatile_fields_stand_in_one_element_only() {
    let (results, series) = sample(Kind::Compare, TITLE);
    let mut later = results.clone();
    later.volatile.version = "9.9.9".into();
    later.volatile.created = "2031-01-01T00:00:00Z".into();
    later.volatile.command = "something else".into();
    later.volatile.seconds = 77.0;
    let without = |html: &str| {
        let start = html.find("id=\"volatile\"").expect("the element exists");
        let end = start + html[start..].find("</dl>").expect("it is closed");
        format!("{}{}", &html[..start], &html[end..])
    };
    let (a, b) = (rendered(&results, &series), rendered(&later, &series));
    assert_ne!(a.html, b.html);
    assert_eq!(without(&a.html), without(&b.html));
    assert_eq!(a.figures, b.figures);
}

#[test]
fn peaks_of_long_histories_survive_and_the_file_stays_small() {
    let (mut results, mut series) = sample(Kind::Compare, TITLE);
    let n = 60_000;
    series.time = (0..n).map(|i| i as f64 * 0.005).collect();
    for (k, column) in series.columns.iter_mut().enumerate() {
        *column = (0..n).map(|i| ((i * (k + 1)) as f64 * 0.7).sin()).collect();
        column[31_234] = 7.5;
    }
    let fe = results.runs.first_mut().expect("compare has an engine");
    for i in 0..20 {
        let id = format!("station_{i}");
        series.columns.push(series.columns[3].clone());
        series.ids.push(id.clone());
        fe.histories.push(SeriesInfo {
            title: id.clone(),
            id,
            dimension: Dimension::Length,
            static_value: 0.0,
            peak: 7.5,
            time: 156.17,
        });
    }
    let html = rendered(&results, &series).html;
    assert!(html.len() < 1_500_000, "{} bytes", html.len());
    assert!(html.contains("at 156.17 s"));
    assert!(html.contains("further histories are listed below"));
}

#[test]
fn awkward_numbers_do_no_harm() {
    let (mut results, mut series) = sample(Kind::Compare, TITLE);
    for column in &mut series.columns {
        column.fill(0.0);
    }
    let check = &mut results.methods[0].checks[0];
    (check.status, check.capacity, check.utilisation) = (CheckStatus::Fails, Some(0.0), None);
    results.methods[1].profiles[0].values.fill(0.0);
    results.methods[1].profiles[1].values[3] = f64::NAN;
    results.methods[2].steps[3].value = f64::NAN;
    results.spectra[0].psv.fill(0.0);
    let fe = results.runs.first_mut().expect("compare has an engine");
    fe.envelopes[0].min.clear();
    fe.modes[0].shape.surface.truncate(2);
    fe.limits.clear();
    let html = rendered(&results, &series).html;
    assert!(!sections(&html).contains(&"limits"));
    for svg in figures(&html) {
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
    assert!(html.contains('∞'));
}

#[test]
fn broken_fields_are_an_error_and_no_panic() {
    let (mut results, series) = sample(Kind::Solid, TITLE);
    let fields = results.runs.first_mut().and_then(|fe| fe.fields.as_mut()).expect("a spatial run has fields");
    fields.modes[0].displacement.pop();
    let templates = Templates::new(None).expect("the embedded templates parse");
    let error = build(&results, &series, &templates, report::Level::Full).expect_err("a node without displacement");
    assert!(error.to_string().contains("fields"), "{error}");
}

#[test]
fn a_template_of_the_users_replaces_the_built_in_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let sections = folder.path().join("sections");
    std::fs::create_dir(&sections).expect("writable");
    let (results, series) = sample(Kind::Check, TITLE);
    let with = |text: &str| {
        std::fs::write(sections.join("summary.html"), text).expect("writable");
        let templates = Templates::new(Some(folder.path()))?;
        build(&results, &series, &templates, report::Level::Full)
    };
    let report = with("<h1>Letterhead: {{ name }}</h1><p>{{ verdict.headline }}</p>").expect("it renders");
    assert!(report.html.contains("<h1>Letterhead: Broad tank"));
    let fault = |text: &str| with(text).expect_err("a fault").to_string();
    let empty = fault("<div>{# nothing #}</div>");
    assert!(empty.contains("summary") && empty.contains("no content"), "{empty}");
    let unknown = fault("{{ nothing_like_that }}");
    assert!(unknown.contains("nothing_like_that"), "{unknown}");
    let broken = fault("{% if %}");
    assert!(broken.contains("summary.html"), "{broken}");
}

#[test]
fn render_writes_report_and_figures_and_says_what_is_missing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let missing = report::render(folder.path(), None, report::Level::Full).expect_err("there is no results.json");
    assert!(missing.to_string().contains("results.json"), "{missing}");
    crate::sample::write(folder.path(), Kind::Compare, TITLE);
    let path = report::render(folder.path(), None, report::Level::Full).expect("it renders");
    assert_eq!(path, folder.path().join("report.html"));
    let written = std::fs::read_to_string(&path).expect("readable");
    assert!(written.starts_with("<!DOCTYPE html>"));
    let count = std::fs::read_dir(folder.path().join("figures")).expect("figures").count();
    assert_eq!(count, figures(&written).len());
    // Rendering again gives the same bytes.
    report::render(folder.path(), None, report::Level::Full).expect("it renders");
    assert_eq!(written, std::fs::read_to_string(&path).expect("readable"));
}
