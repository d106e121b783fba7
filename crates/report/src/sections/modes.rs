//! Coupled modes of tank and liquid: table and shapes.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::{Figure, Room, shapes};
use crate::number::{Scale, fixed, percent, significant};
use crate::table::{Column, Table, spread};
use crate::words::{self, capital};
use files::error::Error;
use results::{Mode, Run};

/// Modes of one kind and harmonic in the table at most.
const ROWS: usize = 6;

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(fe) = source.results.reference().filter(|fe| !fe.modes.is_empty()) else {
        return Ok(None);
    };
    let rows: Vec<&Mode> = fe.modes.iter().filter(|m| m.number <= ROWS).collect();
    let mut section = Section::new("modes");
    section.set("modes", &table(source, &rows));
    section.set("unlisted", &words::sections::unlisted(fe.modes.len() - rows.len()));
    section.set_figures("figures", drawn(fe).into_iter().map(|m| shape(source, m)).collect());
    Ok(Some(section))
}

fn table(source: &Source, modes: &[&Mode]) -> Table {
    let mass = Scale::of(Dimension::Mass, modes.iter().map(|m| m.effective_mass));
    let height = Scale::of(Dimension::Length, modes.iter().map(|m| m.effective_height));
    let mut table = Table::new(vec![
        Column::numbers("m", ""),
        Column::words("Kind"),
        Column::numbers("No.", ""),
        Column::numbers("Period", "s"),
        Column::numbers("Frequency", "Hz"),
        Column::numbers("Damping", ""),
        Column::numbers("Effective mass", mass.symbol()),
        Column::numbers("of liquid", ""),
        Column::numbers("Effective height", height.symbol()),
    ]);
    for m in modes {
        let moves = m.effective_mass.abs() > 1e-9 * source.results.tank.liquid_mass;
        table.row(vec![
            m.harmonic.to_string(),
            m.kind.clone(),
            m.number.to_string(),
            significant(m.period, 4),
            significant(1.0 / m.period, 4),
            percent(m.damping),
            if moves {
                mass.text(m.effective_mass)
            } else {
                "–".into()
            },
            if moves {
                percent(m.effective_mass / source.results.tank.liquid_mass)
            } else {
                "–".into()
            },
            if moves {
                height.text(m.effective_height)
            } else {
                "–".into()
            },
        ]);
    }
    table
}

/// The first three sloshing and the first two structural modes of the harmonic that is shaken.
fn drawn(fe: &Run) -> Vec<&Mode> {
    let pick = |kind: &'static str, most: usize| {
        fe.modes
            .iter()
            .filter(move |m| m.harmonic == 1 && m.kind == kind && !m.shape.z.is_empty())
            .take(most)
    };
    pick("sloshing", 3).chain(pick("structural", 2)).collect()
}

fn shape(source: &Source, mode: &Mode) -> Figure {
    let summary = &source.results.tank;
    let title = format!("{} mode {}", capital(&mode.kind), mode.number);
    let mut table = Table::new(vec![
        Column::words("Place"),
        Column::numbers("at", "m"),
        Column::numbers("Relative displacement", ""),
    ]);
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
    let (size, markup) = shapes::draw(
        mode,
        summary.tank.shape.half_length(),
        summary.tank.wall_height(),
        summary.liquid.fill_height,
    );
    Figure {
        id: format!("mode_{}_{}_{}", mode.harmonic, mode.kind, mode.number),
        title,
        titled: false,
        caption: format!(
            "T = {}\u{a0}s, {}\u{a0}Hz",
            significant(mode.period, 4),
            significant(1.0 / mode.period, 4)
        ),
        description: words::figures::mode(mode),
        size,
        markup,
        table,
        room: Room::Third,
    }
}
