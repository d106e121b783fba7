//! The page of an incremental dynamic analysis.

use tank::units::Dimension;
use tera::Context;

use super::Report;
use super::sections::{self, FigureView};
use super::template::Templates;
use crate::figure::chart::{Axis, Chart};
use crate::figure::{Figure, HALF};
use crate::frame::{self, Body, Cover, Page, Pair, Verdict};
use crate::number::{Scale, fixed, significant, with_unit};
use crate::style;
use crate::table::{Rows, Table, columns};
use crate::words::ida as words;
use crate::words::ida::heads;
use crate::words::sections::{heading, sentences};
use files::error::Error;
use results::{Ida, IdaRun};

/// A demand that is drawn.
struct Curve {
    id: &'static str,
    title: &'static str,
    dimension: Dimension,
    value: fn(&IdaRun) -> f64,
}

/// Demands that are drawn: those of every tank, and others that are not zero.
fn curves(ida: &Ida) -> Vec<Curve> {
    let strip = ida.moment == Dimension::LineMoment;
    let of = |id, titles: [&'static str; 2], dimension, value| Curve {
        id,
        title: titles[usize::from(!strip)],
        dimension,
        value,
    };
    let same = |title| [title, title];
    let mut curves = vec![
        of("ida_wave", same(words::WAVE), Dimension::Length, |r| r.wave),
        of("ida_wall_displacement", words::DISPLACEMENT, Dimension::Length, |r| r.wall_displacement),
        of("ida_base_moment", words::BASE_MOMENT, ida.moment, |r| r.base_moment),
    ];
    let further = [
        of("ida_bar_stress", same(words::BAR_STRESS), Dimension::Stress, |r| r.bar_stress),
        of("ida_crack_height", same(words::CRACK_HEIGHT), Dimension::Length, |r| r.highest_crack),
        of("ida_plastic_strain", same(words::PLASTIC_STRAIN), Dimension::Dimensionless, |r| r.plastic_strain),
        of("ida_hysteretic_energy", words::HYSTERETIC, Dimension::Energy, |r| r.hysteretic_energy),
    ];
    let seen = |curve: &Curve| ida.runs.iter().any(|r| (curve.value)(r) > 0.0);
    curves.extend(further.into_iter().filter(seen));
    curves
}

/// The figures, a curve each over the peak ground acceleration.
///
/// Errors: a drawing that fails.
fn figures(ida: &Ida) -> Result<Vec<Figure>, Error> {
    curves(ida).iter().map(|curve| figure(ida, curve)).collect()
}

fn figure(ida: &Ida, curve: &Curve) -> Result<Figure, Error> {
    let &Curve { id, title, dimension, value } = curve;
    let runs = &ida.runs;
    let with_zero = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> { values.chain([0.0]).collect() };
    let x = Axis::linear(words::PGA, Dimension::Acceleration, with_zero(&mut runs.iter().map(|r| r.pga)), 6);
    let y = Axis::linear("", dimension, with_zero(&mut runs.iter().map(value)), 5);
    let mut chart = Chart::new(HALF, x, y);
    chart.line(runs.iter().map(|r| (r.pga, value(r))).collect(), "k-fe", "");
    // Only the first and the last of neighbours with the same label have it: the others would lie over each other.
    let label = |i: usize| runs.get(i).map(words::mark);
    for (i, r) in runs.iter().enumerate() {
        let between = i > 0 && label(i - 1) == label(i) && label(i + 1) == label(i);
        chart.mark((r.pga, value(r)), if between { "" } else { words::mark(r) }, "k-fe");
    }
    let mut table = Table::new(columns!["Scale" => "", words::PGA_HEAD => "m/s²", title]);
    for run in runs {
        table.row(vec![
            significant(run.scale, 4),
            significant(run.pga, 4),
            words::value(run, &with_unit(value(run), dimension)),
        ]);
    }
    Ok(chart
        .with_plot_height(170.0)
        .figure(id, title, table)?
        .captioned(words::caption(ida))
        .described(words::description(title, runs.len())))
}

/// The text of a value that not every run has.
fn dash<T>(value: Option<T>, text: impl Fn(T) -> String) -> String {
    value.map_or("–".to_owned(), text)
}

/// One line a run: the columns of every tank, and others of which a run has something.
pub fn table(ida: &Ida) -> Table {
    let of = |dimension, value: fn(&IdaRun) -> f64| Scale::of(dimension, ida.runs.iter().map(value));
    let any = |has: fn(&IdaRun) -> bool| ida.runs.iter().any(has);
    let wave = of(Dimension::Length, |r| r.wave);
    let displacement = of(Dimension::Length, |r| r.wall_displacement);
    let moment = of(ida.moment, |r| r.base_moment);
    let stress = of(Dimension::Stress, |r| r.bar_stress);
    let mut all = Rows::of(&ida.runs);
    all.numbers("Scale", "", |r| significant(r.scale, 4));
    all.numbers("PGA", "m/s²", |r| significant(r.pga, 4));
    all.words("End", words::end);
    all.numbers("Wave", wave.symbol(), |r| wave.text(r.wave));
    all.numbers("Wall displacement", displacement.symbol(), |r| displacement.text(r.wall_displacement));
    all.numbers("Base moment", moment.symbol(), |r| moment.text(r.base_moment));
    if any(|r| r.section_moment.is_some()) {
        all.numbers(heads::SECTION, moment.symbol(), |r| dash(r.section_moment, |m| moment.text(m)));
    }
    if any(|r| r.first_crack.is_some()) {
        all.numbers(heads::FIRST_CRACK[0], "s", |r| dash(r.first_crack, |c| fixed(c.time, 2)));
        all.numbers(heads::FIRST_CRACK[1], moment.symbol(), |r| dash(r.first_crack, |c| moment.text(c.base_moment)));
        all.numbers("Highest crack", "m", |r| fixed(r.highest_crack, 2));
    }
    if any(|r| r.parting.is_some()) {
        let parted = any(|r| r.parting.is_some_and(|p| p.open));
        let title = heads::SEPARATION[usize::from(parted)];
        all.numbers(title, "s", |r| dash(r.parting, |p| fixed(p.time, 2)));
        all.numbers(heads::SEPARATION[2], "m", |r| dash(r.parting, |p| fixed(p.height, 2)));
    }
    if any(|r| r.bar_stress > 0.0) {
        all.numbers("Bar stress", stress.symbol(), |r| stress.text(r.bar_stress));
    }
    if any(|r| r.plastic_strain > 0.0) {
        all.numbers("Plastic strain", "", |r| significant(r.plastic_strain, 2));
    }
    if any(|r| r.open_share.is_some()) {
        all.numbers("Open share", "%", |r| dash(r.open_share, |share| significant(100.0 * share, 3)));
    }
    if any(|r| !r.limits.is_empty()) {
        all.words(heads::OUTSIDE, words::exceeded);
    }
    all.numbers(heads::DAMPING, "%", |r| significant(100.0 * r.wall_damping, 3));
    all.numbers("Halved steps", "", |r| r.halvings.to_string());
    all.numbers("Energy residual", "", |r| format!("{:.0e}", r.energy_residual));
    all.table
}

/// A table as two of the same rows: the second has the first column and the last three, how a run was computed.
fn split(table: Table) -> [Table; 2] {
    const COMPUTED: usize = 3;
    let at = table.columns.len().saturating_sub(COMPUTED);
    let mut second = Table::new([&table.columns[..1], &table.columns[at..]].concat());
    let mut first = Table::new(table.columns[..at].to_vec());
    for row in table.rows {
        second.row([&row[..1], &row[at..]].concat());
        first.row(row[..at].to_vec());
    }
    [first, second]
}

/// The first page.
fn cover(ida: &Ida) -> Cover {
    let collapsed = ida.runs.iter().any(|run| run.collapse.is_some());
    let (class, sign) = match (ida.incomplete, collapsed) {
        (true, _) => ("fail", "✗"),
        (false, true) => ("open", "!"),
        (false, false) => ("none", "–"),
    };
    let mut facts = ida.tank.as_ref().map_or_else(Vec::new, frame::tank);
    facts.extend(words::cover::facts(ida).into_iter().map(|(l, v)| Pair::new(l, v)));
    let sketch = ida.tank.as_ref().map(|tank| FigureView::of(&sections::sketch(tank)));
    Cover {
        name: ida.name.clone(),
        subtitle: heading("ida").into(),
        project: frame::document(ida.project.as_ref()),
        signatures: frame::signatures(ida.project.as_ref()),
        verdict: Verdict { class, sign, headline: words::cover::headline(ida), lines: words::cover::lines(ida) },
        warnings: {
            let interrupted = sentences("ida").get("interrupted").filter(|_| ida.incomplete).map(|s| (*s).into());
            let beyond = crate::words::record_set::beyond_of_ida(ida).into_iter().map(|line| line + ".");
            interrupted.into_iter().chain(beyond).collect()
        },
        facts,
        sketch: sketch.into_iter().collect(),
    }
}

/// The page with its figures.
///
/// Errors: a template or a drawing that fails.
pub fn report(ida: &Ida) -> Result<Report, Error> {
    let _style = style::of(ida.project.as_ref());
    let figures = figures(ida)?;
    let templates = Templates::new(None)?;
    let mut context = Context::new();
    let views: Vec<FigureView> = figures.iter().map(FigureView::of).collect();
    context.insert("words", &sentences("ida"));
    let [runs, computed] = split(table(ida));
    context.insert("runs", &runs);
    context.insert("computed", &computed);
    context.insert("model", &super::facts(&ida.model));
    context.insert("assumptions", &ida.assumptions);
    context.insert("collapses", &words::collapses(ida));
    context.insert("partings", &words::partings(ida));
    context.insert("departures", &words::departures(ida));
    context.insert("outside", &words::outside(ida));
    let extremes = super::extremes::table(ida.runs.iter().map(|r| (Some(r.scale), r.extremes.as_slice())));
    context.insert("extremes", &extremes);
    context.insert("moments", &ida.runs.iter().any(|r| r.section_moment.is_some()));
    context.insert("figures", &views);
    let mut body = Body::new(&templates, cover(ida), ida.tank.as_ref())?;
    for part in words::cover::PARTS {
        if part.0 != "extremes" || !extremes.rows.is_empty() {
            body.part("ida.html", part, &mut context)?;
        }
    }
    body.provenance(&ida.files, &ida.format, &ida.volatile)?;
    let css = templates.css("figure.css");
    let page = Page {
        name: &ida.name,
        running: words::cover::RUNNING,
        project: ida.project.as_ref(),
        parts: &body.parts,
        css,
    };
    Report::of(&page, body.figures.iter().chain(&figures), &templates)
}
