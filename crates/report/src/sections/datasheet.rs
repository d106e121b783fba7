//! The input as a datasheet: what the file gives and what is assumed for it, by subject; and the courses of the wall with their hoop forces.

use serde::Serialize;
use tank::assessment::{CourseHoop, TOTAL_HOOP};
use tank::units::Dimension;

use super::Source;
use super::profiles::pairs;
use crate::figure::chart::{Axis, Chart};
use crate::figure::{Figure, HALF};
use crate::methods::{Look, look};
use crate::number::{Scale, fixed, utilisation};
use crate::table::{Table, columns, spread};
use crate::words::datasheet as words;
use crate::words::{capital, verdict};
use files::error::Error;
use results::{FE, Method, Results};

/// Values of one subject.
#[derive(Serialize)]
pub(super) struct Group {
    title: String,
    entries: Vec<Entry>,
}

/// A value as the file has it.
#[derive(Serialize)]
struct Entry {
    /// Name; empty where only the key names it.
    label: &'static str,
    key: String,
    value: String,
    default: bool,
}

/// Subjects: title, and how the keys begin.
const SUBJECTS: [(&str, &str); 11] = [
    ("Tank", "tank."),
    ("Liquid", "liquid."),
    ("Material", "materials"),
    ("Site, EN 1998", "site.ec8."),
    ("Site, API 650", "site.api650."),
    ("Site, IS 1893-2", "site.is1893."),
    ("Site, national", "site.national."),
    ("Site", "site."),
    ("Damping", "damping."),
    ("Record", "record."),
    ("Methods", "procedures."),
];

/// The groups of a file; values that are not given stand in the list of the whole input alone.
pub(super) fn groups(results: &Results) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for line in &results.input {
        let tables = ["tank.courses", "tank.rings", "tank.attachments"];
        let listed = line.text == "not given" || tables.iter().any(|table| line.path.starts_with(table));
        let Some((title, start)) = SUBJECTS.iter().find(|(_, start)| line.path.starts_with(start)).filter(|_| !listed)
        else {
            continue;
        };
        let key = line.path[start.len()..].trim_start_matches('.');
        // `materials["A 283 C"].density`, `materials.steel.density`: a group for each.
        let (title, key) =
            match key.rsplit_once("\"].").or_else(|| key.split_once('.')).filter(|_| *start == "materials") {
                Some((name, key)) => (format!("{title} {}", name.trim_start_matches("[\"")), key),
                None => ((*title).to_owned(), key),
            };
        let entry =
            Entry { label: words::label(key), key: key.to_owned(), value: line.text.clone(), default: line.default };
        match groups.iter_mut().find(|group| group.title == title) {
            Some(group) => group.entries.push(entry),
            None => groups.push(Group { title, entries: vec![entry] }),
        }
    }
    let rank = |title: &str| SUBJECTS.iter().position(|(subject, _)| title.starts_with(subject));
    groups.sort_by_key(|group| rank(&group.title));
    let accepted: Vec<Entry> = (results.verdict.accepted.iter())
        .map(|gap| Entry {
            label: "",
            key: gap.check.limit_state.clone(),
            value: verdict::approver(&gap.check),
            default: false,
        })
        .collect();
    if !accepted.is_empty() {
        groups.push(Group { title: words::ACCEPTANCE.into(), entries: accepted });
    }
    groups
}

/// The deciding methods that give the hoop stresses of the courses, and the engine.
fn methods(results: &Results) -> Vec<&Method> {
    let none = results.verdict.deciding.is_empty();
    let shown = |m: &&Method| !m.courses.is_empty() && (none || results.verdict.decides(m) || m.id == FE);
    results.methods.iter().filter(shown).collect()
}

/// The courses, from the base up: thickness, and the hoop forces and stresses of each method; no table without them.
pub(super) fn courses(results: &Results) -> Option<Table> {
    let methods = methods(results);
    if methods.is_empty() {
        return None;
    }
    let courses = &results.tank.tank.courses;
    let found = || methods.iter().flat_map(|m| &m.courses);
    let forces = found().flat_map(|c| [c.hydrostatic, c.impulsive, c.convective, c.vertical]).flatten();
    let height = Scale::of(Dimension::Length, courses.iter().map(|c| c.height));
    let thickness = Scale::of(Dimension::Length, courses.iter().map(|c| c.thickness));
    let force = Scale::of(Dimension::LineForce, forces);
    let stress = Scale::of(Dimension::Stress, found().flat_map(|c| [Some(c.stress), c.limit]).flatten());
    let mut table = Table::new(columns![
        words::COURSE => "", "Height" => height.symbol(), "t" => thickness.symbol(), words::ALLOWANCE => thickness.symbol(),
        words::NET => thickness.symbol(), "Method", "z" => height.symbol(), "N_h" => force.symbol(), "N_i" => force.symbol(),
        "N_c" => force.symbol(), "N_v" => force.symbol(), "σ" => stress.symbol(), "Limit" => stress.symbol(), "Utilisation" => "",
    ]);
    for (index, course) in courses.iter().enumerate() {
        let own = |m: &&Method| m.courses.iter().find(|c| c.course == index + 1).map(|c| (look(m).label, *c));
        let rows: Vec<(String, CourseHoop)> = methods.iter().filter_map(own).collect();
        let lead = vec![
            (index + 1).to_string(),
            height.given(course.height),
            thickness.given(course.thickness),
            thickness.given(course.corrosion),
            thickness.given(course.net_thickness()),
        ];
        let dash = || "–".to_owned();
        let or_dash = |value: Option<f64>, scale: &Scale| value.map_or_else(dash, |value| scale.text(value));
        if rows.is_empty() {
            table.row(lead.iter().cloned().chain((0..9).map(|_| dash())).collect());
        }
        for (i, (label, c)) in rows.into_iter().enumerate() {
            let lead = if i == 0 { lead.clone() } else { vec![String::new(); lead.len()] };
            let forces = [c.hydrostatic, c.impulsive, c.convective, c.vertical].map(|n| or_dash(n, &force));
            let row = lead.into_iter().chain([label, height.text(c.z)]).chain(forces);
            let used = c.utilisation().map_or_else(dash, utilisation);
            table.row(row.chain([stress.text(c.stress), or_dash(c.limit, &stress), used]).collect());
        }
    }
    table.caption = words::COURSES.into();
    Some(table)
}

/// A limit course by course as a line with steps.
fn steps(results: &Results, method: &Method) -> Vec<(f64, f64)> {
    let mut foot = 0.0;
    let mut points = Vec::new();
    for (index, course) in results.tank.tank.courses.iter().enumerate() {
        let limit = method.courses.iter().find(|c| c.course == index + 1).and_then(|c| c.limit);
        points.extend(limit.into_iter().flat_map(|limit| [(limit, foot), (limit, foot + course.height)]));
        foot += course.height;
    }
    points
}

/// Hoop stress over the height, static and seismic, against its limit; no figure where no method has a limit.
pub(super) fn hoop(source: &Source) -> Result<Option<Figure>, Error> {
    let results = source.results;
    let methods = methods(results);
    let mut lines: Vec<(Look, Vec<(f64, f64)>)> = Vec::new();
    for method in &methods {
        let profile = method.profiles.iter().find(|p| p.id == TOTAL_HOOP);
        lines.extend(profile.map(|p| (look(method), pairs(&p.values, &p.z))));
    }
    let engine = results.reference().and_then(|run| run.envelopes.iter().find(|e| e.id == "hoop_stress"));
    if let Some((e, method)) = engine.zip(methods.iter().find(|m| m.id == FE)) {
        let total: Vec<f64> = e.static_.iter().zip(&e.max).map(|(rest, seismic)| rest + seismic).collect();
        lines.push((look(method), pairs(&total, &e.z)));
    }
    // The limit of the engine is that of a code, where one decides.
    let limited = methods.iter().filter(|m| m.id != FE || methods.len() == 1);
    let limits: Vec<(Look, Vec<(f64, f64)>)> =
        limited.map(|m| (look(m), steps(results, m))).filter(|(_, points)| !points.is_empty()).collect();
    if lines.is_empty() || limits.is_empty() {
        return Ok(None);
    }
    let all = lines.iter().chain(&limits).flat_map(|(_, points)| points);
    let x = Axis::linear(words::HOOP, Dimension::Stress, all.map(|p| p.0).chain([0.0]), 5);
    let y = Axis::exact("Height z", Dimension::Length, (0.0, results.tank.tank.wall_height()), 5);
    let mut chart = Chart::new(HALF, x, y);
    let scale = Scale::of(Dimension::Stress, lines.iter().flat_map(|(_, points)| points).map(|p| p.0));
    let mut table = Table::new(columns!["Method", "z" => "m", words::HOOP => scale.symbol()]);
    for (look, points) in &lines {
        for i in spread(points.len(), 12) {
            table.row(vec![look.label.clone(), fixed(points[i].1, 3), scale.text(points[i].0)]);
        }
        chart.line(points.clone(), look.class.clone(), look.label.clone());
    }
    for (look, points) in limits {
        chart.line(points, format!("{} limit", look.class), words::limit(&look.label));
    }
    let figure = chart.with_plot_height(78.0).figure("hoop_total", capital(words::HOOP), table)?;
    Ok(Some(figure.captioned(words::HOOP_CAPTION).described(words::HOOP_DESCRIPTION)))
}
