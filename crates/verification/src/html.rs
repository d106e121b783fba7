//! The verification manual as a single page, and its convergence figures.

use serde::Serialize;
use tera::Context;

use crate::{Error, Manual, manual};
use report::figure::Figure;
use report::figure::chart::{Axis, Chart, Line};
use report::sections::FigureView;
use report::table::{Column, Table};
use report::template::Templates;
use tank::units::Dimension;

/// Number of colours in the palette.
const CURVES: usize = 6;
/// Letters of a legend entry at most.
const LETTERS: usize = 60;
/// Name of the template.
const PAGE: &str = "verification.html";

/// Relative errors over the number of elements (or the mesh size), both logarithmic; `studies` holds a name and the
/// points (mesh, error) each.
///
/// Errors: a drawing that fails.
pub(crate) fn convergence(id: &str, title: &str, studies: &[(String, &[(f64, f64)])]) -> Result<Figure, Error> {
    // A vanishing error has no logarithm: it is drawn at rounding.
    let place = |n: f64, error: f64| (n.max(f64::MIN_POSITIVE).log10(), error.abs().max(1e-16).log10());
    let lines: Vec<Line> = studies
        .iter()
        .take(CURVES)
        .enumerate()
        .map(|(k, (what, points))| Line {
            points: points.iter().map(|&(n, error)| place(n, error)).collect(),
            class: format!("k-s{}", k + 1),
            label: shortened(what),
        })
        .collect();
    let all = || lines.iter().flat_map(|l| &l.points);
    let mut chart = Chart::new(
        620.0,
        Axis::linear(
            "log₁₀ of the number of elements, or of the mesh size",
            Dimension::Dimensionless,
            all().map(|p| p.0),
            5,
        ),
        Axis::linear("log₁₀ of the relative error", Dimension::Dimensionless, all().map(|p| p.1), 7),
    );
    chart.lines = lines;
    let mut table = Table::new(vec![
        Column::words("What"),
        Column::numbers("Elements or mesh size", ""),
        Column::numbers("Relative error", ""),
    ]);
    for (what, points) in studies {
        for (n, error) in *points {
            table.row(vec![what.clone(), n.to_string(), format!("{error:.2e}")]);
        }
    }
    let left_out = match studies.len().saturating_sub(CURVES) {
        0 => String::new(),
        n => format!(" {n} more studies stand in the table."),
    };
    let figure = chart.with_plot_height(240.0).figure(id, format!("{title}: convergence"), table)?;
    Ok(figure.captioned(left_out.trim()).described(format!(
        "Relative error over the mesh of {} studies: {}.{left_out}",
        studies.len(),
        studies.iter().map(|(what, _)| what.as_str()).collect::<Vec<_>>().join("; ")
    )))
}

fn shortened(text: &str) -> String {
    if text.chars().count() <= LETTERS {
        return text.into();
    }
    text.chars().take(LETTERS - 1).chain(['…']).collect()
}

/// A benchmark as the template sees it.
#[derive(Serialize)]
struct BenchmarkView {
    id: String,
    title: String,
    model: String,
    sources: Vec<String>,
    table: Table,
    figures: Vec<FigureView>,
}

/// The manual as one HTML page, a sheet a benchmark.
///
/// Errors: a template or a drawing that fails.
pub fn html(found: &Manual) -> Result<String, Error> {
    let mut views = Vec::new();
    for benchmark in manual::pages(&found.rows) {
        let mut table = Table::new(vec![
            Column::words("Row"),
            Column::words("What"),
            Column::numbers("Reference", ""),
            Column::numbers("Computed", ""),
            Column::numbers("Error", ""),
            Column::numbers("Tolerance", ""),
            Column::words("Reference is"),
            Column::words(""),
        ]);
        let mut sources: Vec<String> = Vec::new();
        for row in &benchmark.rows {
            let source = format!("{}: {}", row.kind, row.source);
            if !sources.contains(&source) {
                sources.push(source);
            }
            let state = match (row.fails(), row.compares()) {
                (true, _) => "✗ outside",
                (_, true) => "comparison only",
                _ => "✓",
            };
            let told = if row.remark.is_empty() { state.to_owned() } else { format!("{state}; {}", row.remark) };
            table.row(manual::cells(row).into_iter().chain([told]).collect());
        }
        views.push(BenchmarkView {
            figures: benchmark.figure()?.iter().map(FigureView::of).collect(),
            id: benchmark.id.into(),
            title: benchmark.title.into(),
            model: benchmark.model.into(),
            sources,
            table,
        });
    }
    let templates = Templates::new(None)?.with(PAGE, include_str!("page.html"))?;
    let mut page = Context::new();
    page.insert("benchmarks", &views);
    let counted = found.rows.iter().filter(|r| r.counts()).count();
    let outside = found.rows.iter().filter(|r| r.fails()).count();
    let rows = format!(
        "{} rows, of which {counted} count as verification (neither regressions nor rows for comparison only); {outside} outside \
         their tolerance.",
        found.rows.len()
    );
    page.insert("rows", &rows);
    let version = env!("CARGO_PKG_VERSION");
    let subtitle = format!("tankcheck {version}: computed values next to references from outside the program");
    page.insert("subtitle", &subtitle);
    let not_run: Vec<String> =
        found.not_run.iter().map(|n| format!("{}: {} (needs {})", n.id, n.what, n.needs)).collect();
    page.insert("not_run", &not_run);
    page.insert("style", templates.css("style.css"));
    page.insert("figure_style", templates.css("figure.css"));
    Ok(report::numbered(&templates.render(PAGE, &page)?))
}
