//! What a report must hold, whatever the numbers: content, escaping, figures, determinism.

use std::collections::BTreeSet;

use report::template::Templates;
use report::{Report, build};
use results::compare::Incomplete;
use results::nonlinear::{BaseMoment, Columns, Departure, DepartureKind, End, Energies, Nonlinear, Passed};
use results::{EngineId, Results, Series, SeriesInfo};
use tank::units::Dimension;

use crate::sample::{Kind, sample};

const TITLE: &str = "Broad tank of Manos and Clough, 1982";
/// Every kind of report.
const EVERY: [Kind; 6] = [
    Kind::Compare,
    Kind::Check,
    Kind::Rectangle,
    Kind::Both,
    Kind::Solid,
    Kind::Nonlinear,
];

fn rendered(results: &Results, series: &Series) -> Report {
    let templates = Templates::new(None).expect("the embedded templates parse");
    build(results, series, &templates).expect("the sample renders")
}

fn report(kind: Kind) -> Report {
    let (results, series) = sample(kind, TITLE);
    rendered(&results, &series)
}

/// Ids of the sections in their order.
fn sections(html: &str) -> Vec<&str> {
    html.split("<section id=\"")
        .skip(1)
        .filter_map(|s| s.split('"').next())
        .collect()
}

/// The inline figures.
fn figures(html: &str) -> Vec<&str> {
    html.split("<svg ")
        .skip(1)
        .map(|rest| {
            let end = rest.find("</svg>").expect("an svg element is closed");
            let start = rest.as_ptr() as usize - html.as_ptr() as usize - "<svg ".len();
            &html[start..start + "<svg ".len() + end + "</svg>".len()]
        })
        .collect()
}

/// A number whose mesh error is above a fifth is marked in the table and among the errors, and every warning is shown with its
/// markup escaped; without any, neither word is there.
#[test]
fn warnings_and_unusable_numbers_are_shown() {
    let plain = report(Kind::Compare).html;
    assert!(!plain.contains("unusable") && !plain.contains("<h3>Warnings</h3>"));
    let (mut results, series) = sample(Kind::Compare, TITLE);
    let fe = results.methods.iter().position(|m| m.id == "fe").expect("an engine");
    let row = (results.comparison.rows.iter_mut())
        .find(|r| r.quantity == "base_shear")
        .expect("a base shear");
    row.cells[fe].as_mut().expect("a value").unusable = true;
    let run = results.runs.first_mut().expect("a run");
    run.mesh_error.insert("base_shear".into(), 0.34);
    results.warnings = vec!["record `<b>`: found a time step of 0.2 s, usual are 0.002 to 0.02 s".into()];
    let html = rendered(&results, &series).html;
    assert_eq!(html.matches("✗ unusable").count(), 1);
    assert!(html.contains("34\u{a0}%, unusable"));
    assert!(
        html.contains("<h3>Warnings</h3>") && html.contains("&lt;b&gt;") && html.contains("found a time step of 0.2 s")
    );
}

#[test]
fn compare_shows_every_section_in_order() {
    assert_eq!(
        sections(&report(Kind::Compare).html),
        [
            "summary",
            "comparison",
            "partings",
            "reported",
            "checks",
            "tank",
            "input",
            "motion",
            "spectra",
            "modes",
            "profiles",
            "histories",
            "sheets",
            "engine",
            "limits",
            "provenance"
        ]
    );
}

#[test]
fn check_leaves_out_what_it_has_not_computed() {
    let html = report(Kind::Check).html;
    let ids = sections(&html);
    for absent in [
        "motion",
        "spectra",
        "modes",
        "histories",
        "engine",
        "limits",
        "partings",
    ] {
        assert!(!ids.contains(&absent), "{absent}");
    }
    for present in [
        "summary",
        "comparison",
        "checks",
        "tank",
        "input",
        "sheets",
        "provenance",
    ] {
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
fn the_nonlinear_run_shows_what_became_of_the_wall() {
    let html = report(Kind::Nonlinear).html;
    assert!(sections(&html).contains(&"nonlinear"));
    for figure in [
        "nonlinear_base_shear",
        "nonlinear_wave_height",
        "cracks_1",
        "cracks_3",
        "cells_1_plastic_strain",
        "cells_2_utilisation",
        "loop_1_moment_curvature_theta_0",
        "loop_2_shear_displacement",
        "envelope_nonlinear_hoop_stress",
        "history_nonlinear_largest_crack",
        "energies",
    ] {
        assert!(html.contains(&format!("id=\"fig-{figure}\"")), "{figure}");
    }
    // What there is no picture of is said in words.
    for absent in ["cracks_4", "cells_4_separation", "loop_3_still"] {
        assert!(!html.contains(&format!("id=\"fig-{absent}\"")), "{absent}");
    }
    assert!(html.contains("Outer face: no crack, at rest, t = 0.00\u{a0}s."));
    assert!(html.contains("Separation: zero everywhere."));
    for text in [
        "First yield of a bar",
        "0.81",
        "14\u{202f}873",
        "Nonlinear elements",
        "to the end of the ground motion",
    ] {
        assert!(html.contains(text), "{text}");
    }
    assert!(html.contains(".fig .cr.c0") && !report(Kind::Compare).html.contains(".fig .cr.c0"));
}

#[test]
fn a_collapse_is_told_first_and_its_numbers_are_bounds() {
    let (mut results, mut series) = sample(Kind::Nonlinear, TITLE);
    results.runs[1].end = End::Collapsed {
        time: 7.312,
        load_factor: None,
        reason: "the step was halved 12 times".into(),
        place: "θ = 0°, base <b>".into(),
    };
    results.verdict.incomplete = true;
    results.verdict.cause = Some(Incomplete::NoEquilibrium { time: 7.312 });
    let end = series.time.iter().position(|t| *t > 7.315).expect("a longer record");
    for (id, column) in series.ids.iter().zip(&mut series.columns) {
        if id.starts_with(EngineId::Nonlinear.prefix()) {
            column[end..].fill(f64::NAN);
        }
    }
    let html = rendered(&results, &series).html;
    let summary = &html[..html.find("id=\"comparison\"").expect("a second section")];
    assert!(summary.contains("Collapse: the nonlinear run") && summary.contains("verdict fail"));
    for text in [
        "no equilibrium after t = 7.312 s",
        "θ = 0°, base &lt;b&gt;.",
        "Reason: the step was halved 12 times.",
        "lower bounds",
        "<td class=\"n\">≥ ",
        "The nonlinear run ends at 7.31 s.",
    ] {
        assert!(html.contains(text), "{text}");
    }
    for svg in figures(&html) {
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}

/// A run that passed a limit of its model is marked above everything else, whether it went on or was stopped there, and shows what
/// the moment at the base is made of.
#[test]
fn a_run_that_left_its_model_is_marked() {
    let departure = Departure {
        kind: DepartureKind::BarStrain,
        time: 4.321,
        theta: Some(0.0),
        height: 0.012,
        passed: Some(Passed {
            value: 0.03,
            limit: 0.025,
        }),
    };
    let moments = BaseMoment {
        place: "wall at θ = 0°".into(),
        time: 4.5,
        reaction: -1.245e6,
        section: -0.8e6,
        damping: -0.1e6,
        inertia: -0.35e6,
        load: 5e3,
        largest_section: 0.44e6,
    };
    let stopped = End::Left {
        time: 4.4,
        departure: Departure {
            kind: DepartureKind::StoredEnergy,
            height: 3.0,
            ..departure.clone()
        },
    };
    for (end, words) in [
        (End::Completed, "The run left its model at t = 4.321 s"),
        (stopped, "Stopped: the run left its model at t = 4.400 s"),
    ] {
        let (mut results, series) = sample(Kind::Nonlinear, TITLE);
        results.runs[1].end = end;
        let run = results.runs[1].nonlinear.as_mut().expect("a nonlinear run");
        run.departures = vec![departure.clone()];
        run.moments = vec![moments.clone()];
        let html = rendered(&results, &series).html;
        for text in [
            words,
            "wall at θ = 0°, z = 12.0 mm: a bar is strained by 3.00 %, its strain at rupture is 2.50 %",
            "Largest of the section",
        ] {
            assert!(html.contains(text), "{text}");
        }
        assert!(!html.contains("to the end of the ground motion</strong>"));
        let at = html.find("Largest of the section").expect("the table");
        let table = &html[at..at + html[at..].find("</table>").expect("its end")];
        for cell in ["1245", "440", "350"] {
            assert!(table.replace('\u{202f}', "").contains(cell), "{cell}: {table}");
        }
    }
}

#[test]
fn a_strip_shows_its_walls_side_by_side() {
    let (mut results, series) = sample(Kind::Nonlinear, TITLE);
    let run = results.runs[1].nonlinear.as_mut();
    let run = run.expect("a nonlinear run");
    run.grid.columns = Columns::Walls {
        names: vec!["left wall".into(), "right wall".into()],
    };
    let cells = run.grid.cells();
    for map in &mut run.maps {
        map.values.truncate(cells);
    }
    for picture in &mut run.cracks {
        picture.cracks.retain(|c| c.cell < cells);
    }
    let html = rendered(&results, &series).html;
    for text in ["right wall", "id=\"fig-cracks_1\"", "id=\"fig-cells_3_bar_stress\""] {
        assert!(html.contains(text), "{text}");
    }
    assert!(!html.contains("mirror image"));
}

#[test]
fn a_nonlinear_run_without_anything_is_no_broken_section() {
    let (mut results, series) = sample(Kind::Nonlinear, TITLE);
    results.runs[1].events.clear();
    let run = results.runs[1].nonlinear.as_mut().expect("a nonlinear run");
    run.maps.clear();
    run.cracks.clear();
    run.loops.clear();
    run.cost.clear();
    run.energies = Energies::default();
    let short = rendered(&results, &series).html;
    assert!(short.contains("id=\"nonlinear\"") && !short.contains("id=\"fig-energies\""));
    results.runs[1].nonlinear = None;
    assert!(rendered(&results, &series).html.contains("id=\"nonlinear\""));
}

#[test]
fn a_map_without_a_value_for_each_cell_is_an_error_and_no_panic() {
    let templates = Templates::new(None).expect("the embedded templates parse");
    let spoil = |spoil: &dyn Fn(&mut Nonlinear)| {
        let (mut results, series) = sample(Kind::Nonlinear, TITLE);
        let run = results.runs[1].nonlinear.as_mut();
        spoil(run.expect("a nonlinear run"));
        build(&results, &series, &templates).expect_err("a fault").to_string()
    };
    assert!(spoil(&|run| run.maps[0].values.truncate(3)).contains("plastic_strain"));
    assert!(spoil(&|run| run.cracks[0].cracks[0].cell = 100_000).contains("100000"));
    assert!(spoil(&|run| run.energies.kinetic.truncate(3)).contains("energies"));
}

#[test]
fn an_interrupted_run_is_no_verdict() {
    let (mut results, series) = sample(Kind::Both, TITLE);
    results.runs[1].incomplete = true;
    results.verdict.incomplete = true;
    let html = rendered(&results, &series).html;
    let summary = &html[..html.find("id=\"comparison\"").expect("a second section")];
    assert!(summary.contains("Incomplete") && summary.contains("verdict fail"));
    assert!(!summary.contains("checks hold"));
}

#[test]
fn broken_fields_are_an_error_and_no_panic() {
    let (mut results, series) = sample(Kind::Solid, TITLE);
    let fields = results
        .runs
        .first_mut()
        .and_then(|fe| fe.fields.as_mut())
        .expect("a spatial run has fields");
    fields.modes[0].displacement.pop();
    let templates = Templates::new(None).expect("the embedded templates parse");
    let error = build(&results, &series, &templates).expect_err("a node without displacement");
    assert!(error.to_string().contains("fields"), "{error}");
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
    assert!(html.contains("default-src 'none'; style-src 'unsafe-inline'; img-src data:"));
    for foreign in ["src=", "href=\"http", "url(", "@import", "<script", "<link"] {
        assert!(!html.contains(foreign), "{foreign}");
    }
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
                    assert!(
                        node.attribute(looks).is_none(),
                        "{title}: looks belong into the style sheet"
                    );
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
            assert_eq!(
                document.root_element().tag_name().namespace(),
                Some("http://www.w3.org/2000/svg")
            );
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
    assert_eq!(report(Kind::Compare), report(Kind::Compare));
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
    results.methods[0].checks[0].utilisation = f64::INFINITY;
    results.methods[0].checks[0].capacity = 0.0;
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
fn a_template_of_the_users_replaces_the_built_in_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let sections = folder.path().join("sections");
    std::fs::create_dir(&sections).expect("writable");
    let (results, series) = sample(Kind::Check, TITLE);
    let with = |text: &str| {
        std::fs::write(sections.join("summary.html"), text).expect("writable");
        let templates = Templates::new(Some(folder.path()))?;
        build(&results, &series, &templates)
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
    let missing = report::render(folder.path(), None).expect_err("there is no results.json");
    assert!(missing.to_string().contains("results.json"), "{missing}");
    crate::sample::write(folder.path(), Kind::Compare, TITLE);
    let path = report::render(folder.path(), None).expect("it renders");
    assert_eq!(path, folder.path().join("report.html"));
    let written = std::fs::read_to_string(&path).expect("readable");
    assert!(written.starts_with("<!DOCTYPE html>"));
    let count = std::fs::read_dir(folder.path().join("figures"))
        .expect("figures")
        .count();
    assert_eq!(count, figures(&written).len());
    // Rendering again gives the same bytes.
    report::render(folder.path(), None).expect("it renders");
    assert_eq!(written, std::fs::read_to_string(&path).expect("readable"));
}
