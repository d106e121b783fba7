//! Parts of several engines in one section.

use std::path::Path;

use report::Level;
use report::template::Templates;
use results::part::{Amount, Axis, Block, Chart, Fact, Form, Line, Look, Message, Scale, Table};
use results::{Part, Results, Series};
use tank::units::Dimension;

/// Accepted results of an example.
fn kept(name: &str) -> Results {
    let reports = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reports");
    results::read(&reports.join(name)).expect("results")
}

/// A sentence, a curve and a row with this value.
fn part(value: f64) -> Part {
    let sentence = Message::new("curve").with("title", "t").with("low", Amount::ratio(value)).with("high", 50.0);
    let x = Axis::new("frequency", Dimension::Frequency, Scale::Free);
    let y = Axis::new("ratio-base_shear", Dimension::Dimensionless, Scale::Zero);
    let line = Line::new(Fact::None, Look::Thin, vec![[0.5, value], [1.0, 2.0 * value]]);
    let columns = [
        ("quantity", Dimension::Dimensionless, Form::Words),
        ("static", Dimension::Dimensionless, Form::Significant(4)),
    ];
    Part {
        id: "transfer".into(),
        blocks: vec![
            Block::Text(sentence),
            Block::Text(Message::new("transfer-linear")),
            Block::Chart(Chart::new("base_shear", x, y, vec![line])),
            Block::Table(Table::new("peaks", &columns, vec![vec!["base_shear".into(), value.into()]])),
        ],
    }
}

#[test]
fn engines_stand_together() {
    let mut results = kept("07_steel_cylinder/nonlinear");
    for (run, value) in results.runs.iter_mut().zip([11.5, 12.25]) {
        run.parts = vec![part(value)];
    }
    let templates = Templates::new(None).expect("embedded templates");
    let page = report::build(&results, &Series::default(), &templates, Level::Standard).expect("renders").html;
    let count = |text: &str| page.matches(text).count();
    // Sentences that differ, each with its engine; one that does not, once.
    assert_eq!(count("By the harmonic engine: t, from 11.50 to 50."), 1);
    assert_eq!(count("By the nonlinear engine: t, from 12.25 to 50."), 1);
    assert_eq!(count("Linear theory: the amplitudes hold"), 1);
    // One figure with a curve an engine, and its legend.
    assert_eq!(count("id=\"fig-transfer_base_shear\""), 1);
    let figure = page.split("id=\"fig-transfer_base_shear\"").nth(1).expect("a figure");
    let figure = figure.split("<figcaption>").next().expect("a drawing");
    assert!(figure.contains(">harmonic<") && figure.contains(">nonlinear<"), "{figure}");
    assert_eq!(figure.matches("class=\"ln k-fe thin\"").count(), 2, "a line and its sample");
    // A row an engine, which stands in front.
    let cells = page.replace("</td><td class=\"n\">", " | ").replace("</td><td>", " | ");
    assert!(cells.contains("<td>harmonic | Base shear | 11.50"), "rows");
    assert!(cells.contains("<td>nonlinear | Base shear | 12.25"), "rows");
}

/// A user's template of a part replaces that of all parts, in a folder that replaces a built-in one.
#[test]
fn a_part_may_have_a_template_of_its_own() {
    let mut results = kept("07_steel_cylinder");
    results.runs[0].parts = vec![part(11.5)];
    let home = tempfile::tempdir().expect("a temporary folder");
    let sections = home.path().join("sections");
    std::fs::create_dir(&sections).expect("writable");
    for (name, text) in [("part.html", "<p>all parts</p>"), ("transfer.html", "<p>{{ blocks | length }} blocks</p>")] {
        std::fs::write(sections.join(name), text).expect("writable");
    }
    let templates = Templates::new(Some(home.path())).expect("templates");
    let page = report::build(&results, &Series::default(), &templates, Level::Standard).expect("renders").html;
    assert!(page.contains("<p>4 blocks</p>") && !page.contains("all parts"));
}
