//! The page of an incremental dynamic analysis.

use tank::units::Dimension;
use tera::Context;

use super::Report;
use super::sections::FigureView;
use super::template::Templates;
use crate::figure::chart::{Axis, Chart, Line, Mark};
use crate::figure::{Figure, HALF, Room};
use crate::number::{Scale, fixed, significant, with_unit};
use crate::table::{Column, Table};
use crate::words::verdict::LIQUID_PARTED;
use files::error::Error;
use results::{Ida, IdaRun};

/// A demand that is drawn.
struct Curve {
    id: &'static str,
    title: &'static str,
    dimension: Dimension,
    value: fn(&IdaRun) -> f64,
}

/// Demands that are drawn: those of every tank, and those that are not nothing.
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
        of("ida_wave", same("Largest wave at the wall"), Dimension::Length, |r| {
            r.wave
        }),
        of(
            "ida_wall_displacement",
            [
                "Largest displacement of the top of the wall",
                "Largest radial displacement of the wall",
            ],
            Dimension::Length,
            |r| r.wall_displacement,
        ),
        of(
            "ida_base_moment",
            ["Largest moment at the base of a wall", "Largest moment at the base"],
            ida.moment,
            |r| r.base_moment,
        ),
    ];
    let further = [
        of(
            "ida_bar_stress",
            same("Largest stress of a bar"),
            Dimension::Stress,
            |r| r.bar_stress,
        ),
        of(
            "ida_crack_height",
            same("Height of the highest crack"),
            Dimension::Length,
            |r| r.highest_crack,
        ),
        of(
            "ida_plastic_strain",
            same("Largest plastic strain of plates or concrete"),
            Dimension::Dimensionless,
            |r| r.plastic_strain,
        ),
        of(
            "ida_hysteretic_energy",
            [
                "Energy dissipated in a wall, per metre",
                "Energy dissipated in the wall",
            ],
            Dimension::Energy,
            |r| r.hysteretic_energy,
        ),
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
    let &Curve {
        id,
        title,
        dimension,
        value,
    } = curve;
    let runs = &ida.runs;
    let with_zero = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> { values.chain([0.0]).collect() };
    let x = Axis::linear(
        "peak ground acceleration",
        Dimension::Acceleration,
        with_zero(&mut runs.iter().map(|r| r.pga)),
        6,
    );
    let y = Axis::linear("", dimension, with_zero(&mut runs.iter().map(value)), 5);
    let mut chart = Chart::new((HALF, 0.0), x, y);
    chart.lines = vec![Line {
        points: runs.iter().map(|r| (r.pga, value(r))).collect(),
        class: "k-fe".into(),
        label: String::new(),
    }];
    chart.marks = runs
        .iter()
        .map(|r| Mark {
            at: (r.pga, value(r)),
            label: match (&r.collapse, r.departures.is_empty()) {
                (Some(_), _) => "≥, collapse".into(),
                (None, false) => "left the model".into(),
                (None, true) => String::new(),
            },
            class: "k-fe".into(),
        })
        .collect();
    let chart = chart.with_plot_height(170.0);
    let mut table = Table::new(vec![
        Column::numbers("Scale", ""),
        Column::numbers("Peak ground acceleration", "m/s²"),
        Column::words(title),
    ]);
    for run in runs {
        let bound = if run.collapse.is_some() { "≥ " } else { "" };
        let mark = if run.departures.is_empty() {
            ""
        } else {
            ", left the model"
        };
        table.row(vec![
            significant(run.scale, 4),
            significant(run.pga, 4),
            format!("{bound}{}{mark}", with_unit(value(run), dimension)),
        ]);
    }
    Ok(Figure {
        id: id.into(),
        title: title.into(),
        caption: [
            (
                runs.iter().any(|r| r.collapse.is_some()),
                "Runs that found no equilibrium are lower bounds.",
            ),
            (
                runs.iter().any(|r| !r.departures.is_empty()),
                "Runs that left the model are no results: the table of runs says when and why.",
            ),
        ]
        .iter()
        .filter(|(shown, _)| *shown)
        .map(|(_, sentence)| *sentence)
        .collect::<Vec<_>>()
        .join(" "),
        titled: false,
        description: format!("{title} over the peak ground acceleration, {} runs.", runs.len()),
        size: chart.size,
        markup: chart.draw()?,
        table,
        room: Room::Half,
    })
}

/// How a run ended, in a cell: a run that passed a limit of its model is never shown without its mark.
fn end(run: &IdaRun) -> String {
    let mut words = Vec::new();
    if let Some(collapse) = &run.collapse {
        words.push(format!("collapse at {} s", fixed(collapse.time, 2)));
    }
    if let Some(first) = run.departures.first() {
        words.push(format!("left the model at {} s", fixed(first.time, 2)));
    }
    match words.is_empty() {
        true => "completed".into(),
        false => words.join("; "),
    }
}

/// How runs left the model, and what their moments at the base are made of, one sentence each.
pub fn departures(ida: &Ida) -> Vec<String> {
    let marked = ida.runs.iter().filter(|run| !run.departures.is_empty());
    marked
        .map(|run| {
            let how: Vec<String> = run.departures.iter().map(|d| {
                format!("after {} s, {}: {}", fixed(d.time, 3), d.place, d.reason)
            }).collect();
            let moment = |value: f64| with_unit(value, ida.moment);
            let parts = run.moment_parts.as_ref().map_or(String::new(), |m| {
                format!(
                    " Largest moment at the base {}, of which the section {}, damping {}, inertia {}; largest moment of the lowest section {}.",
                    moment(m.reaction.abs()),
                    moment(m.section * m.reaction.signum()),
                    moment(m.damping * m.reaction.signum()),
                    moment(m.inertia * m.reaction.signum()),
                    moment(m.largest_section)
                )
            });
            format!("Scale {}: {}.{parts}", significant(run.scale, 4), how.join("; "))
        })
        .collect()
}

/// One line a run.
pub fn table(ida: &Ida) -> Table {
    let of = |dimension, value: fn(&IdaRun) -> f64| Scale::of(dimension, ida.runs.iter().map(value));
    let wave = of(Dimension::Length, |r| r.wave);
    let displacement = of(Dimension::Length, |r| r.wall_displacement);
    let moment = of(ida.moment, |r| r.base_moment);
    let sections = ida.runs.iter().any(|r| r.section_moment.is_some());
    let stress = of(Dimension::Stress, |r| r.bar_stress);
    let cracks = ida.runs.iter().any(|r| r.first_crack.is_some());
    let parts = ida.runs.iter().any(|r| r.parting.is_some());
    let bars = ida.runs.iter().any(|r| r.bar_stress > 0.0);
    let plastic = ida.runs.iter().any(|r| r.plastic_strain > 0.0);
    let mut columns = vec![
        Column::numbers("Scale", ""),
        Column::numbers("PGA", "m/s²"),
        Column::words("End"),
        Column::numbers("Wave", wave.symbol()),
        Column::numbers("Wall displacement", displacement.symbol()),
        Column::numbers("Base moment", moment.symbol()),
    ];
    if sections {
        columns.push(Column::numbers("Moment of the section", moment.symbol()));
    }
    if cracks {
        columns.push(Column::numbers("First crack at", "s"));
        columns.push(Column::numbers("with base moment", moment.symbol()));
        columns.push(Column::numbers("Highest crack", "m"));
    }
    if parts {
        let parted = ida.runs.iter().filter_map(|r| r.parting).any(|p| p.open);
        let title = if parted {
            "Liquid parts at"
        } else {
            "Liquid would part at"
        };
        columns.push(Column::numbers(title, "s"));
        columns.push(Column::numbers("at the height", "m"));
    }
    if bars {
        columns.push(Column::numbers("Bar stress", stress.symbol()));
    }
    if plastic {
        columns.push(Column::numbers("Plastic strain", ""));
    }
    columns.push(Column::numbers("Damping of the wall mode", "%"));
    columns.push(Column::numbers("Halved steps", ""));
    columns.push(Column::numbers("Energy residual", ""));
    let mut table = Table::new(columns);
    for run in &ida.runs {
        let crack = |text: &dyn Fn(f64, f64) -> String| {
            run.first_crack.map_or("–".to_owned(), |c| text(c.time, c.base_moment))
        };
        let mut row = vec![
            significant(run.scale, 4),
            significant(run.pga, 4),
            end(run),
            wave.text(run.wave),
            displacement.text(run.wall_displacement),
            moment.text(run.base_moment),
        ];
        if sections {
            row.push(run.section_moment.map_or("–".to_owned(), |m| moment.text(m)));
        }
        if cracks {
            row.push(crack(&|time, _| fixed(time, 2)));
            row.push(crack(&|_, m| moment.text(m)));
            row.push(fixed(run.highest_crack, 2));
        }
        if parts {
            row.push(run.parting.map_or("–".to_owned(), |p| fixed(p.time, 2)));
            row.push(run.parting.map_or("–".to_owned(), |p| fixed(p.height, 2)));
        }
        if bars {
            row.push(stress.text(run.bar_stress));
        }
        if plastic {
            row.push(significant(run.plastic_strain, 2));
        }
        row.push(significant(100.0 * run.wall_damping, 3));
        row.push(run.halvings.to_string());
        row.push(format!("{:.0e}", run.energy_residual));
        table.row(row);
    }
    table
}

/// What to think of runs in which the liquid parts from a wall, or would, one sentence each.
pub fn partings(ida: &Ida) -> Vec<String> {
    let first = |open: bool| {
        let runs = ida.runs.iter().filter(|r| r.parting.is_some_and(|p| p.open == open));
        runs.min_by(|a, b| a.scale.total_cmp(&b.scale))
    };
    let from = |run: &IdaRun| format!("From the scale {} on", significant(run.scale, 4));
    let mut out = Vec::new();
    if let Some(run) = first(false) {
        out.push(format!(
            "{} the pressure of the liquid falls below that of the air under the surface: it would part from the wall where air \
             can enter, and the model keeps it there. The option contact \"opening\" lets it go.",
            from(run)
        ));
    }
    if let Some(run) = first(true) {
        out.push(format!("{}: {LIQUID_PARTED}", from(run)));
    }
    out
}

/// The page with its figures.
///
/// Errors: a template or a drawing that fails.
pub fn report(ida: &Ida) -> Result<Report, Error> {
    let figures = figures(ida)?;
    let collapses: Vec<String> = ida
        .runs
        .iter()
        .filter_map(|run| {
            let collapse = run.collapse.as_ref()?;
            Some(format!(
                "Scale {}: no equilibrium after {} s. {}",
                significant(run.scale, 4),
                fixed(collapse.time, 3),
                collapse.reason
            ))
        })
        .collect();
    let templates = Templates::new(None)?;
    let mut page = Context::new();
    let views: Vec<FigureView> = figures.iter().map(FigureView::of).collect();
    page.insert("name", &ida.name);
    page.insert("incomplete", &ida.incomplete);
    page.insert("runs", &table(ida));
    page.insert("model", &super::facts(&ida.model));
    page.insert("files", &super::files(&ida.files));
    page.insert("assumptions", &ida.assumptions);
    page.insert("collapses", &collapses);
    page.insert("partings", &partings(ida));
    page.insert("departures", &departures(ida));
    page.insert("moments", &ida.runs.iter().any(|r| r.section_moment.is_some()));
    page.insert("figures", &views);
    page.insert("version", &ida.volatile.version);
    page.insert("created", &ida.volatile.created);
    page.insert("command", &ida.volatile.command);
    page.insert("style", templates.css("style.css"));
    page.insert("figure_style", templates.css("figure.css"));
    let css = templates.css("figure.css");
    let drawn = figures.iter().map(|f| (format!("{}.svg", f.id), f.standalone(css)));
    Ok(Report::new(&templates.render("ida.html", &page)?, drawn.collect()))
}
