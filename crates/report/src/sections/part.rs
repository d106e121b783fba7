//! A part of the runs as a section: its sentences, values, tables and charts, the same for every subject.
//!
//! What several engines have under one id stands together: rows of tables below each other, charts of one line in one figure, sentences
//! that differ one after the other, each with its engine.

use std::mem::discriminant;

use serde::Serialize;
use tank::units::Dimension;

use super::motion_of_base::{self, Motion};
use super::section::FigureView;
use super::{Section, Source};
use crate::figure::chart::{self, Band, Rule};
use crate::figure::decimate::decimate;
use crate::figure::{Figure, HALF, WIDE};
use crate::message::{NONE, amount, caption, text, title};
use crate::number::{self, fixed, percent, significant};
use crate::table::{self, spread};
use files::error::Error;
use results::part::{Amount, Axis, Block, Chart, Column, Fact, Finding, Form, History, Line, Look, Message, Room};
use results::part::{Scale, Table};
use results::{Channel, Part};

/// A block as the template sees it.
#[derive(Serialize)]
#[serde(tag = "kind", content = "shown", rename_all = "lowercase")]
enum Shown {
    Text(String),
    Note(String),
    List(Vec<String>),
    Table(table::Table),
    Figures(Vec<FigureView>),
}

/// An engine: its name in the language of the page, and the class of its curves.
type Engine = (String, &'static str);

/// Makes the section of a part.
pub(super) fn section(source: &Source, id: &'static str) -> Result<Option<Section>, Error> {
    let runs = source.results.runs.iter().enumerate();
    let of_runs = runs.filter_map(|(i, run)| {
        let name = title("engine", "", run.engine.id());
        Some(((name, run.engine.figure_key(i)), run.part(id)?))
    });
    let of_all = source.results.parts.iter().filter(|part| part.id == id);
    let found: Vec<(Engine, &Part)> = of_runs.chain(of_all.map(|part| ((String::new(), ""), part))).collect();
    if found.is_empty() {
        return Ok(None);
    }
    let mut section = Section::titled(id, text(&Message::new(id)));
    let mut blocks: Vec<Shown> = Vec::new();
    for same in grouped(&found) {
        for shown in show(source, id, &same, &mut section)? {
            match (blocks.last_mut(), shown) {
                // Figures stand side by side where they can.
                (Some(Shown::Figures(row)), Shown::Figures(more)) => row.extend(more),
                (_, shown) => blocks.push(shown),
            }
        }
    }
    section.set("blocks", &blocks);
    Ok(Some(section))
}

/// The blocks of all engines, those of one kind and id together.
fn grouped<'a>(found: &'a [(Engine, &'a Part)]) -> Vec<Vec<(&'a Engine, &'a Block)>> {
    let key = |block: &'a Block| {
        let id = match block {
            Block::Text(message) | Block::Note(message) => &message.id,
            Block::List { items } => items.first().map_or("", |first| &first.id),
            Block::Values { id, .. } => id,
            Block::Table(table) | Block::Series(table) => &table.id,
            Block::Chart(chart) => &chart.id,
            Block::History(history) => &history.id,
        };
        (discriminant(block), id)
    };
    let mut groups: Vec<Vec<(&Engine, &Block)>> = Vec::new();
    for (engine, part) in found {
        for block in &part.blocks {
            match groups.iter_mut().find(|group| key(group[0].1) == key(block)) {
                Some(group) => group.push((engine, block)),
                None => groups.push(vec![(engine, block)]),
            }
        }
    }
    groups
}

fn show(source: &Source, part: &str, same: &[(&Engine, &Block)], section: &mut Section) -> Result<Vec<Shown>, Error> {
    let one = same.iter().all(|(_, block)| *block == same[0].1);
    let said = |kind: fn(String) -> Shown| -> Vec<Shown> {
        let of = |(engine, block): &(&Engine, &Block)| match block {
            Block::Text(own) | Block::Note(own) if one => Some(text(own)),
            Block::Text(own) | Block::Note(own) => {
                let engine = engine.0.as_str();
                Some(text(&Message::new("by-engine").with("engine", engine).with("text", own.clone())))
            }
            _ => None,
        };
        let shown = same.iter().filter_map(of).take(if one { 1 } else { same.len() });
        shown.map(kind).collect()
    };
    let tables: Vec<(&Engine, table::Table)> = same
        .iter()
        .filter_map(|(engine, block)| match block {
            Block::Values { id, values: found } => Some((*engine, values(part, id, found))),
            Block::Table(own) => Some((*engine, tabled(part, own))),
            _ => None,
        })
        .collect();
    let charts: Vec<(&Engine, &Chart)> = same
        .iter()
        .filter_map(|(engine, block)| match block {
            Block::Chart(own) => Some((*engine, own)),
            _ => None,
        })
        .collect();
    Ok(match same[0].1 {
        Block::Text(_) => said(Shown::Text),
        Block::Note(_) => said(Shown::Note),
        Block::List { items } => vec![Shown::List(items.iter().map(text).collect())],
        Block::Values { .. } | Block::Table(_) => vec![Shown::Table(joined(tables))],
        Block::Chart(_) => vec![Shown::Figures(section.show(curves(part, &charts)?))],
        Block::History(own) => match over_time(source, part, own)? {
            Some(figure) => vec![Shown::Figures(section.show(figure))],
            None => Vec::new(),
        },
        Block::Series(_) => Vec::new(),
    })
}

/// Tables of several engines below each other.
fn joined(tables: Vec<(&Engine, table::Table)>) -> table::Table {
    let several = tables.len() > 1;
    let mut out: Option<table::Table> = None;
    for (engine, mut own) in tables {
        if several {
            own.columns.insert(0, table::Column::words(&title("engine", "", "engine")));
            own.rows.iter_mut().for_each(|row| row.insert(0, engine.0.clone()));
        }
        match &mut out {
            Some(first) => first.rows.append(&mut own.rows),
            None => out = Some(own),
        }
    }
    out.unwrap_or_default()
}

/// Values beside their references.
fn values(part: &str, id: &str, found: &[Finding]) -> table::Table {
    let any = |has: fn(&Finding) -> bool| found.iter().any(has);
    let (timed, compared) = (any(|f| f.time.is_some()), any(|f| f.held.is_some()));
    let titled = |column| title(part, id, column);
    let numbers = |column, unit| table::Column::numbers(&titled(column), unit);
    let mut columns = vec![table::Column::words(&titled("quantity")), numbers("value", "")];
    columns.extend(timed.then(|| numbers("time", "s")));
    if compared {
        columns.extend(["held", "ratio"].map(|column| numbers(column, "")));
    }
    let mut table = table::Table::new(columns);
    table.caption = caption(part, id).unwrap_or_default();
    let or_none = |text: Option<String>| text.unwrap_or_else(|| NONE.into());
    for finding in found {
        let own = finding.amount();
        let mut row = vec![title(part, id, &finding.id), amount(&own)];
        if timed {
            row.push(or_none(finding.time.map(|time| fixed(time, 3))));
        }
        if compared {
            row.push(or_none(finding.held.map(|value| amount(&Amount { value, ..own }))));
            row.push(or_none(finding.held.map(|held| fixed(own.value / held, 3))));
        }
        table.row(row);
    }
    table
}

/// How a column prints its plain numbers.
struct Print<'a> {
    column: &'a Column,
    scale: number::Scale,
}

impl Print<'_> {
    fn head(&self, title: &str) -> table::Column {
        let unit = match self.column.form {
            Form::Words => return table::Column::words(title),
            Form::Usual | Form::Given => self.scale.symbol(),
            Form::Percent => "",
            _ if self.column.unit == Dimension::Dimensionless => "",
            Form::Degrees(_) => "°",
            Form::Fixed(_) | Form::Significant(_) => self.column.unit.si_symbol(),
        };
        table::Column::numbers(title, unit)
    }

    fn number(&self, value: f64) -> String {
        match self.column.form {
            Form::Usual | Form::Words => self.scale.text(value),
            Form::Given => self.scale.given(value),
            Form::Percent => percent(value),
            Form::Degrees(decimals) => fixed(value.to_degrees(), decimals.into()),
            Form::Fixed(decimals) => fixed(value, decimals.into()),
            Form::Significant(digits) => significant(value, digits.into()),
        }
    }
}

fn tabled(part: &str, own: &Table) -> table::Table {
    let columns = own
        .columns
        .iter()
        .map(|column| Print { column, scale: number::Scale::of(column.unit, own.column(&column.id)) });
    let prints: Vec<Print> = columns.collect();
    let head = |print: &Print| print.head(&title(part, &own.id, &print.column.id));
    let mut table = table::Table::new(prints.iter().map(head).collect());
    table.caption = caption(part, &own.id).unwrap_or_default();
    for row in &own.rows {
        let cell = |(print, fact): (&Print, &Fact)| match fact {
            Fact::Number(value) => print.number(*value),
            fact => worded(part, &own.id, fact),
        };
        table.row(prints.iter().zip(row).map(cell).collect());
    }
    table
}

/// A cell or a label that is not a plain number.
fn worded(part: &str, block: &str, fact: &Fact) -> String {
    match fact {
        Fact::None | Fact::Number(_) => NONE.into(),
        Fact::Word(id) => title(part, block, id),
        Fact::Amount(own) => amount(own),
        Fact::Message(own) => text(own),
    }
}

/// A chart, with the lines of all engines where each has one, and the table of its points.
fn curves(part: &str, same: &[(&Engine, &Chart)]) -> Result<Figure, Error> {
    let (_, own) = same[0];
    let several = same.len() > 1 && own.lines.len() == 1;
    let titles = [&own.x, &own.y].map(|axis| title(part, &own.id, &axis.id));
    let shown = match &own.title {
        Some(message) => text(message),
        None => caption(part, &own.id).unwrap_or_default(),
    };
    let mut lines: Vec<chart::Line> = Vec::new();
    for ((engine, class), chart) in same.iter().take(if several { same.len() } else { 1 }) {
        lines.extend(chart.lines.iter().map(|line| chart::Line {
            points: drawn(line, &own.y),
            class: if several { format!("{class} thin") } else { class_of(&line.look) },
            label: match &line.label {
                _ if several => engine.clone(),
                Fact::None => String::new(),
                label => worded(part, &own.id, label),
            },
        }));
    }
    let areas = own.areas.iter().map(|area| Band {
        points: drawn(area, &own.y),
        class: class_of(&area.look),
        label: String::new(),
    });
    let bands: Vec<Band> = areas.collect();
    let all = |of: fn(&(f64, f64)) -> f64| {
        let areas = bands.iter().flat_map(|band| &band.points);
        lines.iter().flat_map(|line| &line.points).chain(areas).map(of).collect::<Vec<f64>>()
    };
    let (x, y) = (all(|p| p.0), all(|p| p.1));
    let (width, height) = match own.room {
        Room::Half => (HALF, 150.0),
        Room::Tall => (HALF, 185.0),
        Room::Wide => (WIDE, 150.0),
    };
    let data = points(part, own, [&titles[0], &titles[1]]);
    let mut drawing = chart::Chart::new(width, axis(&titles[0], &own.x, &x), axis(&titles[1], &own.y, &y));
    (drawing.lines, drawing.bands, drawing.rules) = (lines, bands, Rule::all(&own.marks));
    let values = own.lines.iter().flat_map(|line| &line.points);
    let described = match own.y.id.as_str() {
        // A value over the height.
        "height" => description(&shown, own.x.unit, values.map(|p| p[0])),
        _ => description(&shown, own.y.unit, values.map(|p| p[1])),
    };
    Ok(drawing
        .with_plot_height(height)
        .figure(format!("{part}_{}", own.id), shown, data)?
        .captioned(own.caption.as_ref().map_or_else(String::new, text))
        .described(described))
}

fn class_of(look: &Look) -> String {
    match look {
        Look::Main => "k-fe".into(),
        Look::Thin => "k-fe thin".into(),
        Look::Other => "k-other".into(),
        Look::Soft => "k-soft".into(),
        Look::Hard => "k-hard".into(),
        Look::Rock => "k-rock".into(),
        Look::Ground => "k-ground".into(),
        Look::Level => "k-ground thin".into(),
        Look::Yielded => "k-yielded".into(),
        Look::Method(key) => format!("{key} thin"),
    }
}

/// The points that are drawn: of a curve by frequency every peak, none below the axis.
fn drawn(line: &Line, y: &Axis) -> Vec<(f64, f64)> {
    let points = line.points.iter().map(|p| (p[0], p[1]));
    let Scale::Decades(decades) = y.scale else { return points.collect() };
    let floor = floor(line.points.iter().map(|p| p[1]), decades).log10();
    let (x, y): (Vec<f64>, Vec<f64>) = points.map(|(x, y)| (x.log10(), y.log10().max(floor))).unzip();
    let kept = decimate(&x, &y, (WIDE - 60.0) as usize);
    kept.into_iter().map(|(x, y)| (10f64.powf(x), 10f64.powf(y))).collect()
}

/// The lower end of an axis of decades.
fn floor(values: impl Iterator<Item = f64>, decades: u8) -> f64 {
    let [low, high] = range(values);
    (low / 1.2).max(high / 10f64.powi(decades.into()))
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

fn axis(title: &str, own: &Axis, values: &[f64]) -> chart::Axis {
    let all = || values.iter().copied();
    match own.scale {
        Scale::Free => chart::Axis::linear(title, own.unit, all(), 5),
        Scale::Zero => chart::Axis::linear(title, own.unit, all().chain([0.0]), 5),
        Scale::Range([low, high]) => chart::Axis::exact(title, own.unit, (low, high), 5),
        Scale::Log => {
            let [low, high] = range(all());
            chart::Axis::log(title, own.unit, (low, high))
        }
        Scale::Decades(decades) => {
            let ends = (floor(all(), decades), 1.5 * range(all())[1]);
            chart::Axis::log(title, own.unit, ends).by_decades()
        }
    }
}

/// The numbers of a chart: lines over the same x or y side by side, others below each other.
fn points(part: &str, own: &Chart, titles: [&str; 2]) -> table::Table {
    let all = |k: usize| own.lines.iter().flat_map(move |line| line.points.iter().map(move |p| p[k]));
    let scales = [number::Scale::of(own.x.unit, all(0)), number::Scale::of(own.y.unit, all(1))];
    let numbers = |title: &str, k: usize| table::Column::numbers(title, scales[k].symbol());
    let number = |k: usize, value: f64| match [&own.x, &own.y][k].scale {
        // Values of many decades.
        Scale::Log | Scale::Decades(_) => significant(scales[k].convert(value), 4),
        _ => scales[k].text(value),
    };
    let label = |line: &Line| worded(part, &own.id, &line.label);
    let Some(first) = own.lines.first() else { return table::Table::default() };
    let shared = |k: usize| {
        let same = |line: &Line| line.points.iter().map(|p| p[k]).eq(first.points.iter().map(|p| p[k]));
        own.lines.iter().all(same)
    };
    if own.lines.len() > 1
        && let Some(k) = [1, 0].into_iter().find(|k| shared(*k))
    {
        let mut columns = vec![numbers(titles[k], k)];
        columns.extend(own.lines.iter().map(|line| numbers(&label(line), 1 - k)));
        let mut table = table::Table::new(columns);
        for i in spread(first.points.len(), 24) {
            let values = own.lines.iter().map(|line| number(1 - k, line.points[i][1 - k]));
            table.row(std::iter::once(number(k, first.points[i][k])).chain(values).collect());
        }
        return table;
    }
    let several = own.lines.len() > 1;
    let mut columns = vec![numbers(titles[0], 0), numbers(titles[1], 1)];
    if several {
        columns.insert(0, table::Column::words(&title(part, &own.id, "line")));
    }
    let mut table = table::Table::new(columns);
    for line in &own.lines {
        for i in spread(line.points.len(), if own.lines.len() > 3 { 8 } else { 24 }) {
            let numbers = (0..2).map(|k| number(k, line.points[i][k]));
            table.row(several.then(|| label(line)).into_iter().chain(numbers).collect());
        }
    }
    table
}

/// The range of a curve for those who do not see it.
fn description(title: &str, unit: Dimension, values: impl Iterator<Item = f64>) -> String {
    let [low, high] = range(values).map(|value| Amount::new(value, unit));
    text(&Message::new("curve").with("title", title).with("low", low).with("high", high))
}

fn over_time(source: &Source, part: &str, own: &History) -> Result<Option<Figure>, Error> {
    let channels: Vec<Channel> = own.channels.iter().filter_map(|id| Channel::from_id(id)).collect();
    let shown = caption(part, &own.id).unwrap_or_default();
    let labels = ["x", "y"].map(|id| title(part, &own.id, id));
    let motion = Motion {
        id: &own.id,
        title: &shown,
        axis: &title(part, &own.id, &own.axis),
        channels: &channels,
        labels: [&labels[0], &labels[1]],
    };
    motion_of_base::over_time(source, &motion)
}
