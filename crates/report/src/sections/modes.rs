//! Coupled modes of tank and liquid: table and shapes.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::{Figure, shapes};
use crate::number::{Scale, fixed, percent, significant};
use crate::table::{Rows, Table, columns, spread};
use crate::words::{self, capital};
use files::error::Error;
use results::{Mode, Run};

/// Modes of one kind and harmonic in the table at most.
const ROWS: usize = 6;

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(fe) = source.results.reference().filter(|fe| !fe.modes.is_empty()) else { return Ok(None) };
    let rows: Vec<&Mode> = fe.modes.iter().filter(|m| m.number <= ROWS).collect();
    let mut section = Section::new("modes");
    section.set("modes", &table(source, &rows));
    section.set("unlisted", &words::sections::unlisted(fe.modes.len() - rows.len()));
    section.set_figures("figures", drawn(fe).into_iter().map(|m| shape(source, m)).collect());
    Ok(Some(section))
}

/// Largest ratio of the highest to the lowest frequency of a group of closely spaced modes. Source: US NRC Regulatory Guide 1.92,
/// revision 3, section C.1.1: 10 %.
const CLOSE: f64 = 1.1;

/// Number of the group of closely spaced modes of each mode, harmonic by harmonic; `None` for a mode by itself. A group begins with
/// its lowest mode.
fn groups(modes: &[&Mode]) -> Vec<Option<usize>> {
    let mut order: Vec<usize> = (0..modes.len()).collect();
    order.sort_by(|&a, &b| {
        let key = |i: usize| (modes[i].harmonic, modes[i].omega);
        let ((m, a), (n, b)) = (key(a), key(b));
        m.cmp(&n).then(a.total_cmp(&b))
    });
    let mut out = vec![None; modes.len()];
    let (mut next, mut at) = (1, 0);
    while at < order.len() {
        let first = modes[order[at]];
        let close = |&&i: &&usize| modes[i].harmonic == first.harmonic && modes[i].omega <= CLOSE * first.omega;
        let size = order[at..].iter().take_while(close).count().max(1);
        if size > 1 {
            order[at..at + size].iter().for_each(|&i| out[i] = Some(next));
            next += 1;
        }
        at += size;
    }
    out
}

fn table(source: &Source, modes: &[&Mode]) -> Table {
    let liquid = source.results.tank.liquid_mass;
    let mass = Scale::of(Dimension::Mass, modes.iter().map(|m| m.effective_mass));
    let height = Scale::of(Dimension::Length, modes.iter().map(|m| m.effective_height));
    let moving =
        |mode: &Mode, text: String| if mode.effective_mass.abs() > 1e-9 * liquid { text } else { "–".into() };
    let all: Vec<(&Mode, Option<usize>)> = modes.iter().copied().zip(groups(modes)).collect();
    let mut rows = Rows::of(&all);
    rows.numbers("m", "", |(m, _)| m.harmonic.to_string());
    rows.words("Kind", |(m, _)| m.kind.clone());
    rows.numbers("No.", "", |(m, _)| m.number.to_string());
    rows.numbers("Period", "s", |(m, _)| significant(m.period, 4));
    rows.numbers("Frequency", "Hz", |(m, _)| significant(1.0 / m.period, 4));
    rows.numbers("Damping", "", |(m, _)| percent(m.damping));
    rows.numbers("Effective mass", mass.symbol(), |(m, _)| moving(m, mass.text(m.effective_mass)));
    rows.numbers("of liquid", "", |(m, _)| moving(m, percent(m.effective_mass / liquid)));
    rows.numbers("Effective height", height.symbol(), |(m, _)| moving(m, height.text(m.effective_height)));
    if all.iter().any(|(_, group)| group.is_some()) {
        rows.numbers("Closely spaced", "", |(_, group)| group.map_or("–".into(), |g| g.to_string()));
    }
    rows.table
}

/// The first three sloshing and the first two structural modes of the harmonic that is shaken.
fn drawn(fe: &Run) -> Vec<&Mode> {
    let pick = |kind: &'static str, most: usize| {
        fe.modes.iter().filter(move |m| m.harmonic == 1 && m.kind == kind && m.number <= most && !m.shape.z.is_empty())
    };
    pick("sloshing", 3).chain(pick("structural", 2)).collect()
}

fn shape(source: &Source, mode: &Mode) -> Figure {
    let summary = &source.results.tank;
    let title = format!("{} mode {}", capital(&mode.kind), mode.number);
    let mut table = Table::new(columns!["Place", "at" => "m", "Relative displacement" => ""]);
    for i in spread(mode.shape.r.len(), 9) {
        table.row(vec![
            "surface, radius".into(),
            fixed(mode.shape.r[i], 3),
            fixed(mode.shape.surface.get(i).copied().unwrap_or(0.0), 4),
        ]);
    }
    for i in spread(mode.shape.z.len(), 9) {
        table.row(vec![
            "wall, height".into(),
            fixed(mode.shape.z[i], 3),
            fixed(mode.shape.wall.get(i).copied().unwrap_or(0.0), 4),
        ]);
    }
    let (size, markup) =
        shapes::draw(mode, summary.tank.shape.half_length(), summary.tank.wall_height(), summary.liquid.fill_height);
    Figure::new(format!("mode_{}_{}_{}", mode.harmonic, mode.kind, mode.number), title, (size, markup), table)
        .captioned(format!("T = {}\u{a0}s, {}\u{a0}Hz", significant(mode.period, 4), significant(1.0 / mode.period, 4)))
        .described(words::figures::mode(mode))
}

#[cfg(test)]
mod tests {
    use results::ModeShape;

    use super::*;

    fn mode(harmonic: u32, omega: f64) -> Mode {
        Mode {
            harmonic,
            axial: None,
            kind: "structural".into(),
            number: 1,
            omega,
            period: 1.0 / omega,
            damping: 0.0,
            participation: 0.0,
            effective_mass: 0.0,
            effective_height: 0.0,
            shape: ModeShape { z: Vec::new(), wall: Vec::new(), surface: Vec::new(), r: Vec::new() },
        }
    }

    /// 1.00, 1.05, 1.10 are one group, 1.15 lies beyond 1.1 times its first; other harmonics do not join.
    #[test]
    fn closely_spaced_modes_are_a_group() {
        let all = [(1, 1.0), (1, 1.15), (1, 1.05), (0, 1.02), (1, 1.1), (1, 3.0), (1, 3.2)].map(|(m, w)| mode(m, w));
        let all: Vec<&Mode> = all.iter().collect();
        assert_eq!(groups(&all), [Some(1), None, Some(1), None, Some(1), Some(2), Some(2)]);
    }
}
