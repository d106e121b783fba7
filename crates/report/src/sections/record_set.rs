//! The set of records: design value, scatter, spectrum against its target.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Chart, Mark, Rule};
use crate::figure::{Figure, HALF, WIDE};
use crate::level::Level;
use crate::number::{Scale, count, fixed, percent, significant, utilisation};
use crate::table::{Column, Rows, Table, columns, spread};
use crate::words::record_set::{self as words, captions, heads, legend};
use files::error::Error;
use results::{Compatibility, FE, RecordSet, SetPeriod, SetQuantity, SetRun, SetScatter};

/// Quantities that are drawn and stand in the table of the records.
const GOVERNING: [&str; 4] = ["sloshing_height", "base_shear", "overturning_moment", "hoop_stress"];

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(set) = &source.results.record_set else { return Ok(None) };
    let mut section = Section::new("record_set");
    let mut lines = vec![words::design(set), words::shown(set)];
    lines.extend(words::factor(set));
    section.set("lines", &lines);
    section.set("name", &set.name);
    let mut figures = Vec::new();
    let mut said = Vec::new();
    if let Some(found) = &set.compatibility {
        said = words::compatibility(set, found);
        section.set("spectrum", &spectrum_table(found));
        for period in &found.periods {
            figures.push(spectrum(set, found, period, source.results.tank.gravity)?);
        }
    } else {
        section.set("no_target", &words::no_target(set));
    }
    section.set("compatibility", &said);
    section.set_figures("spectra", figures);
    section.set("quantities", &quantities(set, source.level == Level::Full));
    section.set("scatter", words::SCATTER);
    let drawn = governing(set).into_iter().map(|row| quantity(set, row));
    section.set_figures("figures", drawn.collect::<Result<Vec<_>, Error>>()?);
    section.set("checks", &checks(set));
    section.set("records", &records(source, set));
    section.set("limits", words::LIMITS);
    let base = source.results.reference().is_some_and(|run| run.base.is_some());
    section.set("base", if base { words::BASE } else { "" });
    Ok(Some(section))
}

/// The method whose values are shown: the engine, or else the first.
fn method(set: &RecordSet) -> &str {
    match set.quantities.iter().any(|q| q.method == FE) {
        true => FE,
        false => set.quantities.first().map_or(FE, |q| q.method.as_str()),
    }
}

fn governing(set: &RecordSet) -> Vec<&SetQuantity> {
    let of = |id: &&str| {
        let mut rows = set.quantities.iter();
        rows.find(|q| q.method == method(set) && q.quantity == **id)
    };
    GOVERNING.iter().filter_map(of).collect()
}

/// Values of a quantity under each record.
fn values(set: &RecordSet, row: &SetQuantity) -> Vec<f64> {
    let of = |run: &SetRun| run.values.get(&row.method)?.get(&row.quantity).copied();
    set.records.iter().map(|run| of(run).unwrap_or(f64::NAN)).collect()
}

fn quantity(set: &RecordSet, row: &SetQuantity) -> Result<Figure, Error> {
    let values = values(set, row);
    let n = values.len();
    let scatter = &row.scatter;
    let x = Axis::whole(heads::NUMBER, n);
    let y = Axis::linear("", row.dimension, values.iter().copied().chain([0.0, scatter.design]), 5);
    let mut chart = Chart::new(HALF, x, y);
    let across = |value: f64| vec![(0.5, value), (n as f64 + 0.5, value)];
    if scatter.design > scatter.mean {
        chart.line(across(scatter.mean), "k-s2 thin", "mean");
    }
    chart.line(across(scatter.design), "k-fe", legend::DESIGN);
    chart.marks = values
        .iter()
        .enumerate()
        .filter(|(_, v)| v.is_finite())
        .map(|(i, v)| Mark { at: (i as f64 + 1.0, *v), label: String::new(), class: "own k-s3".into() })
        .collect();
    let scale = Scale::of(row.dimension, values.iter().copied());
    let mut table = Table::new(columns!["No." => "", "Record", &row.title => scale.symbol()]);
    for (i, (run, value)) in set.records.iter().zip(&values).enumerate() {
        table.row(vec![count(i + 1), run.id.clone(), scale.text(*value)]);
    }
    let title = words::quantity_title(&row.title);
    Ok(chart
        .with_plot_height(150.0)
        .figure(format!("set_{}", row.quantity), &title, table)?
        .captioned(words::quantity_caption(scatter.cov))
        .described(title))
}

fn spectrum(set: &RecordSet, found: &Compatibility, period: &SetPeriod, gravity: f64) -> Result<Figure, Error> {
    let points = |values: &[f64], factor: f64| -> Vec<(f64, f64)> {
        let each = period.periods.iter().zip(values);
        each.map(|(t, a)| (*t, factor * a / gravity)).collect()
    };
    let curves = period.records.iter().chain([&period.target, &period.mean]);
    let positive = curves.flatten().map(|a| a / gravity).filter(|a| *a > 0.0);
    let (least, largest) = positive.fold((f64::INFINITY, 0.0_f64), |(l, m), a| (l.min(a), m.max(a)));
    // A tenth of a decade of air; the range that counts is that of the axis.
    let x = Axis::log("Period T", Dimension::Time, (period.range[0], period.range[1]));
    let mut y = Axis::log("", Dimension::Dimensionless, (0.8 * least, 1.25 * largest));
    y.title = heads::PSA.into();
    let mut chart = Chart::new(WIDE, x, y);
    chart.rules.push(Rule { x: period.period, label: format!("T = {} s", significant(period.period, 3)) });
    for (i, record) in period.records.iter().enumerate() {
        chart.line(points(record, 1.0), "k-ground hist", if i == 0 { "records" } else { "" });
    }
    for (values, factor, class, label) in [
        (&period.target, 1.0, "k-s3", "target".to_owned()),
        (&period.target, found.share, "k-s3 thin dotted", words::share(found.share)),
        (&period.mean, 1.0, "k-fe", legend::MEAN.to_owned()),
    ] {
        chart.line(points(values, factor), class, label);
    }
    let mut columns = columns!["Period" => "s", "Target" => "g", "Mean" => "g"];
    columns.extend(set.records.iter().map(|r| Column::numbers(&r.id, "g")));
    let mut table = Table::new(columns);
    for i in spread(period.periods.len(), 30) {
        let cell = |values: &Vec<f64>| values.get(i).map_or("–".into(), |a| significant(a / gravity, 3));
        let mut row = vec![significant(period.periods[i], 3), cell(&period.target), cell(&period.mean)];
        row.extend(period.records.iter().map(cell));
        table.row(row);
    }
    Ok(chart
        .with_plot_height(190.0)
        .figure(format!("set_spectrum_{}", period.which), words::spectrum_title(period), table)?
        .captioned(words::spectrum_caption(period, found.share))
        .described(words::spectrum_description(period)))
}

fn spectrum_table(found: &Compatibility) -> Table {
    let mut table = Table::new(columns![
        "Period", "T" => "s", "Damping" => "", "From" => "s", "To" => "s", heads::RATIO => "", "At" => "s", "Result",
    ]);
    table.caption = captions::SPECTRUM.into();
    for period in &found.periods {
        table.row(vec![
            words::which(period).into(),
            significant(period.period, 4),
            percent(period.damping),
            significant(period.range[0], 3),
            significant(period.range[1], 3),
            fixed(period.smallest_ratio, 3),
            significant(period.at_period, 3),
            if period.holds { "✓ holds" } else { "✗ fails" }.into(),
        ]);
    }
    table
}

fn cov(scatter: &SetScatter) -> String {
    scatter.cov.map_or("–".into(), percent)
}

/// Scatter of the method shown, or of all.
fn quantities(set: &RecordSet, all: bool) -> Table {
    let mut table = Table::new(columns![
        "Quantity", "Method", "Unit", heads::DESIGN => "", "Mean" => "", heads::COV => "", "Smallest" => "",
        "Largest" => "", heads::LARGEST_UNDER,
    ]);
    table.caption = captions::QUANTITIES.into();
    let (own, others): (Vec<_>, Vec<_>) = set.quantities.iter().partition(|q| q.method == FE);
    let shown = |q: &&&SetQuantity| all || q.method == method(set);
    for row in own.iter().chain(&others).filter(shown) {
        let s = &row.scatter;
        let scale = Scale::of(row.dimension, [s.design, s.min, s.max]);
        table.row(vec![
            row.title.clone(),
            row.method.clone(),
            scale.symbol().into(),
            scale.text(s.design),
            scale.text(s.mean),
            cov(s),
            scale.text(s.min),
            scale.text(s.max),
            s.max_record.clone(),
        ]);
    }
    table
}

fn checks(set: &RecordSet) -> Table {
    let mut table = Table::new(columns![
        "Check", heads::DESIGN => "", "Mean" => "", heads::COV => "", "Smallest" => "", "Largest" => "",
        heads::LARGEST_UNDER,
    ]);
    table.caption = captions::CHECKS.into();
    for check in &set.checks {
        let name = crate::words::capital(&check.name);
        let Some(s) = &check.scatter else {
            if let Some(why) = words::without(check.status) {
                let dashes = (0..5).map(|_| "–".to_owned());
                table.row([name, why.to_owned()].into_iter().chain(dashes).collect());
            }
            continue;
        };
        table.row(vec![
            name,
            utilisation(s.design),
            utilisation(s.mean),
            cov(s),
            utilisation(s.min),
            utilisation(s.max),
            s.max_record.clone(),
        ]);
    }
    table
}

fn records(source: &Source, set: &RecordSet) -> Table {
    let gravity = source.results.tank.gravity;
    let all: Vec<(usize, &SetRun)> = set.records.iter().enumerate().collect();
    let mut rows = Rows::of(&all);
    rows.numbers("No.", "", |(i, _)| count(i + 1));
    rows.words("Record", |(_, run)| run.id.clone());
    rows.numbers("PGA", "g", |(_, run)| fixed(run.peaks[0] / gravity, 3));
    rows.numbers(heads::DURATION, "s", |(_, run)| significant(run.significant_duration, 3));
    if set.records.iter().any(|r| r.usable_period.is_some()) {
        rows.numbers(heads::USABLE, "s", |(_, run)| {
            let mark = if run.sloshing_beyond_usable { " ✗" } else { "" };
            run.usable_period.map_or("–".into(), |t| significant(t, 3) + mark)
        });
    }
    for quantity in governing(set) {
        let values = values(set, quantity);
        let scale = Scale::of(quantity.dimension, values.iter().copied());
        rows.numbers(&quantity.title, scale.symbol(), |(i, _)| scale.text(values[*i]));
    }
    if set.records.iter().any(|r| !r.utilisations.is_empty()) {
        rows.numbers("Largest utilisation", "", |(_, run)| worst(run).0);
        rows.words("Check", |(_, run)| crate::words::limit_state(worst(run).1));
    }
    if set.records.iter().any(|r| !r.limits_exceeded.is_empty()) {
        rows.words(heads::LIMITS, |(_, run)| {
            let exceeded = run.limits_exceeded.iter().map(|id| crate::words::limit_state(id));
            exceeded.collect::<Vec<_>>().join(", ")
        });
    }
    Table { caption: captions::RECORDS.into(), ..rows.table }
}

/// The largest utilisation of a record, and its check.
fn worst(run: &SetRun) -> (String, &str) {
    let largest = run.utilisations.iter().max_by(|a, b| a.1.total_cmp(b.1));
    match (run.without_capacity.first(), largest) {
        (Some(lost), _) => (words::NO_CAPACITY.to_owned(), lost.as_str()),
        (None, Some((id, u))) => (utilisation(*u), id.as_str()),
        (None, None) => ("–".to_owned(), "–"),
    }
}
