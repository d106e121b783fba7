use tank::units::Dimension;

use super::report;
use results::{
    EngineId, Study, StudyCurve, StudyFault, StudyLimit, StudyLoss, StudyRecord, StudyState, StudyTank, StudyTrace,
    VerdictStatus,
};

fn tank(id: &str, verdict: Option<VerdictStatus>) -> StudyTank {
    StudyTank {
        id: id.into(),
        samples: [1, 1],
        verdict,
        governing: Some(("code".into(), "uplift_tension".into(), 1.25)),
        periods: [Some(0.12), None],
        volume: Some(500.0),
        open: Vec::new(),
        size: Some([7.5, 6.5]),
        round: true,
        given: Vec::new(),
    }
}

fn curve(tank: Option<&str>, fit: Option<[f64; 2]>) -> StudyCurve {
    StudyCurve {
        tank: tank.map(str::to_owned),
        state: "DS1".into(),
        method: "stripes".into(),
        fit,
        reason: fit.is_none().then(|| "no run reached the state".into()),
        bounds: [fit.is_none().then_some(4.0), None],
        n: 14,
        median_band: fit.map(|_| [2.0, 3.0]),
        dispersion_band: None,
        common: None,
        rate: None,
        points: vec![(2.0, 7.0, 2.0, None), (4.0, 6.0, 6.0, Some([6.0 / 7.0, 1.0]))],
        line: fit.map_or_else(Vec::new, |_| vec![(1.0, 0.1), (2.0, 0.3), (4.0, 0.9)]),
        band: fit.map_or_else(Vec::new, |_| vec![(1.0, 0.0, 0.2), (4.0, 0.8, 1.0)]),
        partial: None,
        missing: 1,
        unjudged: 0,
        never_checked: Vec::new(),
        notes: Vec::new(),
    }
}

/// A farm with hostile names: three tanks, of which one has no result.
fn study() -> Study {
    Study {
        name: "Terminal <script>alert(1)</script>".into(),
        project: Some(tank::Project {
            document: Some("TK-1".into()),
            revision: Some("B".into()),
            ..tank::Project::default()
        }),
        engine: Some(EngineId::Harmonic),
        im: "PGA".into(),
        dimension: Dimension::Acceleration,
        unit: None,
        levels: vec![2.0, 4.0],
        samples: 1,
        tasks: 3,
        missing_tasks: 1,
        rows: [42, 28],
        by_status: vec![("ok".into(), 27), ("error".into(), 1)],
        sha256: "abc".into(),
        method: "stripes".into(),
        resamples: 500,
        hazard: false,
        tanks: vec![
            tank("A & B", Some(VerdictStatus::Fails)),
            tank("C", Some(VerdictStatus::Holds)),
            StudyTank { samples: [0, 0], governing: None, ..tank("D", None) },
        ],
        states: vec![StudyState {
            name: "DS1".into(),
            limits: vec![StudyLimit { demand: "sliding".into(), limit: 1.0, source: "a source".into(), runs: 8 }],
            by_worse: 3,
        }],
        gaps: Vec::new(),
        curves: vec![curve(Some("A & B"), Some([2.5, 0.4])), curve(Some("C"), None)],
        system: vec![curve(None, Some([2.4, 0.4]))],
        losses: vec![StudyLoss {
            im: 2.0,
            earthquakes: 7,
            not_judged: 0,
            at_least: vec![Some(0.3), Some(0.1), Some(0.0)],
            bounds: None,
            volume_bounds: None,
            independent: vec![Some(0.35), Some(0.05), Some(0.0)],
            volume: [Some(150.0), Some(500.0)],
        }],
        no_losses: None,
        records: vec![StudyRecord {
            id: "set/one".into(),
            duration: [20.0, 0.01],
            peaks: Some([3.0, 0.2, 0.05]),
            severity: Some(1.2),
            lost: [4, 14],
        }],
        traces: vec![StudyTrace {
            tank: "C".into(),
            state: "DS1".into(),
            records: vec![("set/one".into(), vec![(2.0, 0.7), (4.0, 1.4)])],
            deviation: Some(0.2),
        }],
        rule: None,
        faults: vec![StudyFault {
            status: "error".into(),
            message: "a NaN & more".into(),
            rows: 1,
            first: ["C".into(), "set/one".into()],
        }],
    }
}

#[test]
fn the_page_is_whole_safe_and_the_same_again() {
    let found = report(&study()).unwrap();
    let html = &found.html;
    // Names of users are text, and nothing runs or is loaded.
    assert!(!html.contains("<script") && html.contains("default-src 'none'"));
    assert!(html.contains("A &amp; B") && html.contains("<dd>TK-1</dd>"));
    // The running head is a CSS string, where only letters, digits and spaces stand for themselves.
    assert!(html.contains(r#"content: "TK\2d 1 rev\2e  B · "#));
    // A tank without a result is told, and the farm does not hold.
    assert!(html.contains("class=\"verdict fail\"") && html.contains("no result"));
    assert!(html.contains("1 of 3 tasks have no result"));
    assert!(html.contains("no run reached the state; median above"));
    for section in ["tanks", "states", "fragility", "losses", "records", "faults", "basis"] {
        assert!(html.contains(&format!("<section id=\"{section}\">")), "{section}");
        assert!(html.contains(&format!("href=\"#{section}\"")), "{section}");
    }
    // Two tanks, losses, volume, one tank record by record.
    assert_eq!(found.figures.len(), 5);
    assert!(html.contains("Figure\u{a0}5.") && !html.contains("class=\"fno\"></span>"));
    assert_eq!(report(&study()).unwrap(), found);
    for (name, svg) in &found.figures {
        roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

/// Without records there are neither curves nor losses, and no empty section.
#[test]
fn codes_alone() {
    let found = report(&Study {
        records: Vec::new(),
        curves: Vec::new(),
        system: Vec::new(),
        losses: Vec::new(),
        traces: Vec::new(),
        faults: Vec::new(),
        missing_tasks: 0,
        engine: None,
        tanks: vec![tank("C", Some(VerdictStatus::Holds))],
        ..study()
    })
    .unwrap();
    assert!(found.figures.is_empty() && found.html.contains("class=\"verdict ok\""));
    assert!(!found.html.contains("<section id=\"fragility\">"));
}

/// In German nothing of the page is English but the names and reasons of the study.
#[test]
fn in_german() {
    let _wish = crate::style::wish(crate::style::Wish { language: Some(tank::Language::German), units: None });
    let page = super::report(&study()).expect("renders").html;
    assert!(page.contains("Erdbebenstudie") && page.contains("lang=\"de\""));
    let names = ["C, set/one", "a NaN & more", "a source", "code", "error", "set/one"];
    let mut left = crate::language::untranslated();
    left.retain(|text| !names.contains(&text.as_str()));
    assert_eq!(left, Vec::<String>::new());
}

/// The study of a table of tanks, by capacities at levels in g: the page has the columns of the table, what was not checked, the levels as they are given,
/// curves that coincide and demands far above their limit; in German as well.
#[test]
fn a_table_of_tanks_and_capacities() {
    let of_table = || {
        let twin = |state: &str| StudyCurve {
            state: state.into(),
            method: "capacities".into(),
            ..curve(Some("A & B"), Some([2.5, 0.4]))
        };
        Study {
            unit: Some("g".into()),
            method: "capacities".into(),
            tanks: vec![StudyTank {
                open: vec![("ec8-2006".into(), "damage_limitation".into())],
                given: vec![("tank.radius".into(), "7.5 m".into()), ("liquid.density".into(), "850 kg/m3".into())],
                ..tank("A & B", Some(VerdictStatus::Incomplete))
            }],
            curves: vec![twin("DS1"), twin("DS2")],
            traces: vec![StudyTrace {
                tank: "A & B".into(),
                state: "DS1".into(),
                records: vec![("set/one".into(), vec![(2.0, 0.7), (4.0, 40.0)])],
                deviation: None,
            }],
            ..study()
        }
    };
    let page = report(&of_table()).unwrap().html;
    for wanted in [
        "Not checked of A &amp; B: damage limitation (ec8-2006).",
        "850 kg/m3",
        "Radius",
        "The curves of DS1 and DS2 coincide.",
        "Logarithmic axis",
        // 2.5 m/s² of the median.
        "0.2549",
    ] {
        assert!(page.contains(wanted), "{wanted}");
    }
    // The radius stands in its own column.
    assert!(!page.contains("tank.radius"));
    // The unit is that of this page alone.
    assert_eq!(tank::units::display(9.80665, Dimension::Acceleration), "9.81 m/s²");
    let _wish = crate::style::wish(crate::style::Wish { language: Some(tank::Language::German), units: None });
    report(&of_table()).unwrap();
    let names = ["C, set/one", "a NaN & more", "a source", "code", "error", "set/one", "850 kg/m3", "liquid.density"];
    let mut left = crate::language::untranslated();
    left.retain(|text| !names.contains(&text.as_str()));
    assert_eq!(left, Vec::<String>::new());
}
