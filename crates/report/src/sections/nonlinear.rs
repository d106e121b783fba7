//! The nonlinear run: its end, its events, its difference from the linear run, the state of the wall.

mod charts;

use serde::Serialize;
use tank::Quantity;
use tank::units::Dimension;

use super::overlay::{self, Second};
use super::{Section, Source, engine, histories};
use crate::extremes;
use crate::figure::{Figure, cells, cracks};
use crate::number::{Scale, fixed, plain, ratio, significant};
use crate::table::{Table, columns};
use crate::words::capital;
use crate::words::verdict::LIQUID_PARTED;
use crate::words::{after_record, labels, outcome};
use files::error::Error;
use results::channel::OnWall;
use results::nonlinear::{BaseMoment, Count, End, Event, Nonlinear};
use results::{EngineId, FE, Run, SeriesInfo};

/// Histories of both engines drawn over each other.
const OVERLAID: [overlay::Kind; 4] =
    [overlay::WAVE, overlay::BASE_SHEAR, overlay::BASE_MOMENT, |channel| channel.on_wall() == Some(OnWall::Moment)];
/// Histories that the linear engine does not have, drawn at most.
const MOST: usize = 8;

/// How the run ended, as the template shows it.
#[derive(Serialize)]
struct Outcome {
    class: &'static str,
    sign: &'static str,
    headline: String,
    text: Vec<String>,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(fe) = source.results.beside(EngineId::Nonlinear) else { return Ok(None) };
    let mut section = Section::new("nonlinear");
    let (difference, bounds) = difference(source);
    section.set("difference", &difference);
    section.set("bounds", &bounds);
    engine::fill(&mut section, fe);
    let run = fe.nonlinear.as_ref();
    if let Some(run) = run {
        check(run)?;
    }
    let marks = marks(&fe.events);
    section.set("outcome", &run.map(|run| outcome(run, fe)).into_iter().collect::<Vec<_>>());
    section.set("events", &run.map_or_else(Table::default, |_| events(&fe.events)));
    section.set("moments", &run.map_or_else(Table::default, |run| moments(&run.moments)));
    let both = run.map(|run| (None, run.extremes.as_slice()));
    section.set("extremes", &extremes::table(both.into_iter()));
    section.set("numbered", &!marks.is_empty());
    section.set("after", &after_record::sentence(fe, source.series.time.last().copied()));
    section.set_figures("overlays", overlays(source, &marks)?);
    let pictures = run.map_or_else(Drawn::default, pictures);
    section.set_figures("crack_figures", pictures.figures);
    section.set("no_cracks", &pictures.words);
    let maps = run.map_or_else(Drawn::default, maps);
    section.set_figures("map_figures", maps.figures);
    section.set("flat_maps", &maps.words);
    section.set_figures("loop_figures", charts::loops(run)?);
    section.set_figures("envelope_figures", charts::envelopes(source.results.reference(), fe)?);
    section.set_figures("energy_figures", charts::energies(run, &marks)?);
    section.set_figures("own_figures", own(source, fe)?);
    section.set("cost", &run.map_or_else(Table::default, |run| cost(&run.cost)));
    Ok(Some(section))
}

/// Whether every map has a value a cell and every crack its cell.
fn check(run: &Nonlinear) -> Result<(), Error> {
    let cells = run.grid.cells();
    if let Some(map) = run.maps.iter().find(|m| m.values.len() != cells) {
        return Err(Error::Report(format!(
            "nonlinear: map `{}` has {} values, the wall {cells} cells",
            map.id,
            map.values.len()
        )));
    }
    let mut cracks = run.cracks.iter().flat_map(|p| &p.cracks);
    if let Some(crack) = cracks.find(|c| c.cell >= cells) {
        return Err(Error::Report(format!("nonlinear: a crack in cell {}, the wall has {cells} cells", crack.cell)));
    }
    Ok(())
}

/// The box above everything else.
fn outcome(run: &Nonlinear, fe: &Run) -> Outcome {
    let fail = |headline: String, text: Vec<String>| Outcome { class: "fail", sign: "✗", headline, text };
    let bounds = || outcome::BOUNDS.to_owned();
    let departures = || run.departures.iter().map(outcome::departure);
    let parted = || fe.parted().then(|| LIQUID_PARTED.to_owned());
    match &fe.end {
        End::Completed if fe.incomplete => fail("Incomplete".into(), vec![bounds()]),
        End::Completed => match run.departures.first() {
            Some(first) => {
                let mut text = vec![outcome::BEYOND_MODEL.to_owned()];
                text.extend(departures());
                text.extend(parted());
                fail(outcome::left_model(first.time, false), text)
            }
            None => {
                let mut text = vec![outcome::CONVERGED.to_owned()];
                text.extend(parted());
                Outcome { class: "none", sign: "✓", headline: outcome::COMPLETED.into(), text }
            }
        },
        End::Left { time, departure } => {
            let mut text = vec![outcome::stopped(departure)];
            let others = run.departures.iter().filter(|d| !d.kind.stops());
            text.extend(others.map(outcome::departure));
            text.extend(parted());
            text.push(outcome::UNTIL_THEN.into());
            fail(outcome::left_model(*time, true), text)
        }
        End::Interrupted { time } => fail(outcome::interrupted(*time), vec![bounds()]),
        End::Collapsed { time, load_factor, reason, place } => {
            let mut text: Vec<String> = load_factor.map(outcome::carried).into_iter().collect();
            text.extend((!place.is_empty()).then(|| outcome::worst_place(place)));
            text.extend((!reason.is_empty()).then(|| outcome::reason(reason)));
            text.extend(departures());
            text.extend(parted());
            text.extend(load_factor.is_none().then(bounds));
            fail(outcome::collapse(*time), text)
        }
    }
}

/// Parts of the largest moments at the base.
fn moments(found: &[BaseMoment]) -> Table {
    let all = found.iter().flat_map(|m| [m.reaction, m.section, m.damping, m.inertia, m.load, m.largest_section]);
    let scale = Scale::of(Dimension::LineMoment, all);
    let unit = scale.symbol();
    let mut table = Table::new(columns![
        "Wall", "Time" => "s", "Reaction" => unit, "Section" => unit, "Damping" => unit, "Inertia" => unit,
        "Static pressure" => unit, labels::LARGEST_OF_SECTION => unit,
    ]);
    for m in found {
        table.row(vec![
            m.place.clone(),
            fixed(m.time, 3),
            scale.text(m.reaction),
            scale.text(m.section),
            scale.text(m.damping),
            scale.text(m.inertia),
            scale.text(m.load),
            scale.text(m.largest_section),
        ]);
    }
    table
}

/// Times of the events with their numbers, those of the static state left out.
fn marks(events: &[Event]) -> Vec<(f64, String)> {
    let numbered = events.iter().enumerate();
    numbered.filter(|(_, e)| e.time > 0.0).map(|(i, e)| (e.time, (i + 1).to_string())).collect()
}

fn events(events: &[Event]) -> Table {
    let mut table = Table::new(columns!["No." => "", "Event", "Time" => "s", "Place", "Remark"]);
    for (i, event) in events.iter().enumerate() {
        table.row(vec![
            (i + 1).to_string(),
            capital(&event.title),
            if event.time > 0.0 { fixed(event.time, 3) } else { "static".into() },
            event.place.clone(),
            event.note.clone(),
        ]);
    }
    table
}

/// Quantities of both engines with their ratio, and whether the nonlinear ones are lower bounds.
fn difference(source: &Source) -> (Table, bool) {
    let results = source.results;
    let column = |id: &str| results.methods.iter().position(|m| m.id == id);
    let (Some(linear), Some(nonlinear)) = (column(FE), column(EngineId::Nonlinear.beside())) else {
        return (Table::default(), false);
    };
    let run = results.beside(EngineId::Nonlinear);
    let bounds = run.is_some_and(|run| run.incomplete || run.end != End::Completed);
    let mut table = Table::new(columns![
        "Quantity", "Unit", "Linear" => "", "Nonlinear" => "", "Nonlinear / linear" => "",
    ]);
    for row in &results.comparison.rows {
        let cell = |i: usize| row.cells.get(i).copied().flatten();
        let (a, b) = (cell(linear), cell(nonlinear));
        if b.is_none() {
            continue;
        }
        let scale = Scale::of(row.dimension, [a, b].into_iter().flatten().map(|c| c.value));
        let text = |c: Option<results::Cell>| c.map_or("–".to_owned(), |c| scale.text(c.value));
        // Periods and masses belong to the initial wall: they are not extremes of the history.
        let least = if bounds && !Quantity::from_id(&row.quantity).is_some_and(of_the_structure) { "≥ " } else { "" };
        table.row(vec![
            row.title.clone(),
            scale.symbol().into(),
            text(a),
            format!("{least}{}", text(b)),
            b.and_then(|b| b.ratio).map_or("–".into(), ratio),
        ]);
    }
    (table, bounds)
}

/// Whether a quantity belongs to tank and liquid, not to a history: periods and masses.
fn of_the_structure(quantity: Quantity) -> bool {
    matches!(quantity.dimension(), Dimension::Time | Dimension::Mass)
}

/// Histories of both engines.
fn overlays(source: &Source, marks: &[(f64, String)]) -> Result<Vec<Figure>, Error> {
    let Some(fe) = source.results.reference() else { return Ok(Vec::new()) };
    let second = Second {
        prefix: EngineId::Nonlinear.prefix(),
        id: "nonlinear",
        title: labels::BOTH_RUNS,
        class: "k-fe-nonlinear hist",
        names: ["linear", "nonlinear"],
        rules: marks,
    };
    overlay::overlays(source, &fe.histories, &OVERLAID, &second)
}

/// Histories that only the nonlinear engine has.
fn own(source: &Source, fe: &Run) -> Result<Vec<Figure>, Error> {
    let linear = source.results.reference().map_or(&[][..], |fe| &fe.histories);
    let own = |s: &&SeriesInfo| linear.iter().all(|l| l.id != s.id);
    let mut figures = Vec::new();
    for info in fe.histories.iter().filter(own).take(MOST) {
        let id = format!("{}{}", fe.engine.prefix(), info.id);
        let Some(column) = source.column(&id) else { continue };
        let run = column.iter().take_while(|v| v.is_finite()).count();
        // A quantity that never moves is in the table of peaks only.
        if column[..run].iter().all(|v| *v == 0.0) {
            continue;
        }
        let id = format!("history_{id}");
        figures.extend(histories::history(
            source,
            &id,
            &info.title,
            info.dimension,
            &column[..run],
            Some(info),
            "k-fe-nonlinear whole",
        )?);
    }
    Ok(figures)
}

/// Figures, and sentences in place of those that were not drawn.
#[derive(Default)]
struct Drawn {
    figures: Vec<Figure>,
    words: Vec<String>,
}

fn pictures(run: &Nonlinear) -> Drawn {
    let mut drawn = Drawn::default();
    for (i, picture) in run.cracks.iter().enumerate() {
        match cracks::figure(&format!("cracks_{}", i + 1), &run.grid, picture) {
            Some(figure) => drawn.figures.push(figure),
            None => drawn.words.push(cracks::sentence(picture)),
        }
    }
    drawn
}

fn maps(run: &Nonlinear) -> Drawn {
    let mut drawn = Drawn::default();
    for (i, map) in run.maps.iter().enumerate() {
        match cells::figure(&format!("cells_{}_{}", i + 1, map.id), &run.grid, map) {
            Some(figure) => drawn.figures.push(figure),
            None => drawn.words.push(cells::sentence(map)),
        }
    }
    drawn
}

fn cost(counts: &[Count]) -> Table {
    let mut table = Table::new(columns!["Count", "Number" => "", "Unit"]);
    for count in counts {
        let scale = Scale::of(count.dimension, [count.value]);
        let number = scale.convert(count.value);
        let text = if number.fract() == 0.0 && number.abs() < 1e15 { plain(number, 0) } else { significant(number, 3) };
        table.row(vec![capital(&count.label), text, scale.symbol().into()]);
    }
    table
}
