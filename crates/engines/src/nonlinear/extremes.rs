//! Extremes of both signs, at both sides of the tank, and at both faces of its wall.

use fem::analysis::march::Range;
use results::nonlinear::{At, CellMap, Columns, TwoSided, WallGrid};
use tank::units::Dimension;

/// Largest change from the value at rest to either side; `None` before the first instant.
pub(crate) fn of_range(title: String, dimension: Dimension, rest: f64, range: &Range) -> Option<TwoSided> {
    let at = |value: f64, time: f64| At { value: value - rest, time: Some(time) };
    (range.min.is_finite() && range.max.is_finite()).then(|| TwoSided {
        title,
        dimension,
        rest,
        min: Some(at(range.min, range.min_time)),
        max: at(range.max, range.max_time),
    })
}

/// Largest widths of cracks and gaps in each half of the wall, from their maps.
pub(crate) fn of_maps(maps: &[CellMap], grid: &WallGrid) -> Vec<TwoSided> {
    let columns = grid.columns.count().max(1);
    let widths = maps.iter().filter(|map| map.dimension == Dimension::Length);
    let side = |map: &CellMap, back: bool| {
        let cells = map.values.iter().enumerate();
        let own = cells.filter(|(cell, _)| is_back(&grid.columns, cell % columns) == back);
        TwoSided {
            title: format!("{}, {}", map.title, name(&grid.columns, back)),
            dimension: map.dimension,
            rest: 0.0,
            min: None,
            max: At { value: own.map(|(_, v)| *v).fold(0.0, f64::max), time: None },
        }
    };
    widths.flat_map(|map| [side(map, false), side(map, true)]).collect()
}

/// Whether a column is in the half of the wall about θ = 180°.
fn is_back(columns: &Columns, column: usize) -> bool {
    match columns {
        Columns::Sectors { edges, .. } => match (edges.get(column), edges.get(column + 1)) {
            (Some(a), Some(b)) => (0.5 * (a + b)).cos() < 0.0,
            _ => false,
        },
        Columns::Walls { .. } => column > 0,
    }
}

fn name(columns: &Columns, back: bool) -> &'static str {
    match (columns, back) {
        (Columns::Sectors { .. }, false) => "half about θ = 0°",
        (Columns::Sectors { .. }, true) => "half about θ = 180°",
        (Columns::Walls { .. }, false) => "wall at θ = 0°",
        (Columns::Walls { .. }, true) => "wall at θ = 180°",
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn map(values: &[f64]) -> CellMap {
        CellMap {
            id: "crack_width_inner".into(),
            title: "crack".into(),
            dimension: Dimension::Length,
            values: values.to_vec(),
            mark: None,
            note: String::new(),
        }
    }

    fn grid(columns: Columns) -> WallGrid {
        WallGrid { columns, z: vec![0.0, 1.0, 2.0], surface: 1.5 }
    }

    #[test]
    fn both_halves_have_their_own_width() {
        let half = grid(Columns::Sectors {
            radius: 1.0,
            edges: [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| x * PI).to_vec(),
            mirrored: true,
        });
        let found = of_maps(&[map(&[1.0, 2.0, 5.0, 3.0, 0.0, 4.0, 0.0, 0.0])], &half);
        assert_eq!(found.iter().map(|x| x.max.value).collect::<Vec<_>>(), [4.0, 5.0]);
        let walls = grid(Columns::Walls { names: vec!["a".into(), "b".into()] });
        let found = of_maps(&[map(&[1.0, 2.0, 3.0, 0.0])], &walls);
        assert_eq!(found.iter().map(|x| x.max.value).collect::<Vec<_>>(), [3.0, 2.0]);
    }

    #[test]
    fn changes_are_from_the_state_at_rest() {
        let mut range = Range::EMPTY;
        for (value, time) in [(2.0, 0.0), (-1.0, 0.1), (5.0, 0.2)] {
            range.include(value, time);
        }
        let found = of_range("x".into(), Dimension::Length, 2.0, &range).unwrap();
        assert_eq!((found.min.unwrap().value, found.max.value), (-3.0, 3.0));
        assert_eq!(found.max.time, Some(0.2));
        assert_eq!(of_range("x".into(), Dimension::Length, 2.0, &Range::EMPTY), None);
    }
}
