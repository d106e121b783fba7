//! A value in each cell of the developed wall: colours, a colour bar, and a line around the cells beyond a mark.
//!
//! Colours are those of the maps ([`super::map`]). The mark (yield, rupture) is a double line, dark and light, that shows
//! on every colour.

use tank::units::Dimension;

use super::svg::{Svg, n};
use super::wall::{self, BAR, Layout, STEPS, TOP};
use super::{Figure, ticks};
use crate::number::{Scale, fixed, plain, significant};
use crate::table::{Column, Table, columns, spread};
use crate::words::capital;
use crate::words::figures::wall as words;
use results::nonlinear::{CellMap, Columns, WallGrid};

/// Below this a bare number (a strain) is printed in thousandths.
const SMALL: f64 = 0.05;

/// How the values of a map are printed: strains in thousandths, all others in an engineer's unit.
struct Shown {
    factor: f64,
    unit: &'static str,
    decimals: usize,
}

impl Shown {
    fn of(map: &CellMap) -> Shown {
        let largest = map.values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let scale = Scale::single(map.dimension, [largest]);
        let (factor, unit) = match map.dimension {
            Dimension::Dimensionless if largest < SMALL => (1e3, "‰"),
            _ => (scale.convert(1.0), scale.symbol()),
        };
        // Four significant digits of the largest value.
        let exponent = (factor * largest).log10().floor() as i32;
        Shown { factor, unit, decimals: (3 - exponent).clamp(0, 6) as usize }
    }

    fn number(&self, value: f64) -> String {
        if value == 0.0 { "0".into() } else { fixed(self.factor * value, self.decimals) }
    }

    fn with_unit(&self, value: f64) -> String {
        match self.unit {
            "" => self.number(value),
            unit => format!("{}\u{a0}{unit}", self.number(value)),
        }
    }
}

/// Range of the colours: from zero on where the values allow it.
fn range(values: &[f64]) -> (f64, f64) {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if low >= 0.0 && low < 0.5 * high { (0.0, high) } else { (low, high) }
}

/// A uniform map in one sentence.
pub fn sentence(map: &CellMap) -> String {
    let value = map.values.first().copied().unwrap_or(0.0);
    let text = (value != 0.0).then(|| Shown::of(map).with_unit(value));
    words::uniform(&capital(&map.title), text.as_deref())
}

/// Draws a map; `None` without cells, with a missing value, or with the same value everywhere.
pub fn figure(id: &str, grid: &WallGrid, map: &CellMap) -> Option<Figure> {
    let layout = Layout::of(grid, TOP, BAR)?;
    if map.values.len() != grid.cells() || map.values.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let (low, high) = range(&map.values);
    if high <= low {
        return None;
    }
    let shown = Shown::of(map);
    let mut svg = Svg::new();
    svg.append(&colours(&layout, |number| ((map.values[number] - low) / (high - low) * STEPS as f64) as usize));
    let mark = map.mark.filter(|mark| *mark > low && *mark <= high);
    if let Some(mark) = mark {
        let data = outline(&layout, grid.rows(), |number| map.values[number] >= mark);
        for class in ["mk", "mk in"] {
            svg.append(&format!(r#"<path class="{class}" d="{data}"/>"#));
        }
    }
    layout.frame(&mut svg, "wm");
    let (levels, decimals) = ticks(shown.factor * low, shown.factor * high, 8);
    let drawn = (shown.factor * low, shown.factor * high);
    wall::bar(&mut svg, layout.size.0, layout.y, drawn, &levels, decimals, shown.unit);
    let mut caption = map.note.clone();
    if let Some(mark) = map.mark {
        let text = shown_mark(&shown, mark);
        let beyond = map.values.iter().filter(|v| **v >= mark).count();
        if !caption.is_empty() && !caption.ends_with(' ') {
            caption.push(' ');
        }
        caption.push_str(&words::mark(&text, beyond, map.values.len()));
    }
    Some(
        Figure::new(id, capital(&map.title), (layout.size, svg.into_markup()), table(grid, map, &shown))
            .captioned(caption)
            .described(describe(grid, map, &shown)),
    )
}

/// A mark with its unit and without idle zeros.
fn shown_mark(shown: &Shown, mark: f64) -> String {
    match shown.unit {
        "" => plain(mark, 4),
        unit => format!("{}\u{a0}{unit}", plain(shown.factor * mark, 4)),
    }
}

/// Cells of one colour above each other as one rectangle, all rectangles of one colour as one path.
fn colours(layout: &Layout, step: impl Fn(usize) -> usize) -> String {
    let mut paths = vec![String::new(); STEPS];
    let mut cells = layout.cells.iter().peekable();
    while let Some(first) = cells.next() {
        let colour = step(first.number).min(STEPS - 1);
        let mut top = first.y.0;
        while let Some(next) = cells.next_if(|c| c.column == first.column && step(c.number).min(STEPS - 1) == colour) {
            top = next.y.0;
        }
        // A hair of overlap: no seams between neighbours.
        let (left, right, top) = (n(first.x.0), n(first.x.1 + 0.3), n(top - 0.3));
        paths[colour].push_str(&format!("M{left} {top}H{right}V{}H{left}Z", n(first.y.1)));
    }
    let path = |(colour, data): (usize, String)| format!(r#"<path class="v v{colour}" d="{data}"/>"#);
    let filled = paths.into_iter().enumerate().filter(|(_, data)| !data.is_empty());
    filled.map(path).collect()
}

/// Edges between the cells that are marked and those that are not.
fn outline(layout: &Layout, rows: usize, marked: impl Fn(usize) -> bool) -> String {
    let cells = &layout.cells;
    let mut data = String::new();
    for (i, cell) in cells.iter().enumerate() {
        let inside = marked(cell.number);
        let differs = |j: usize| marked(cells[j].number) != inside;
        // The neighbour above, and the one to the right where the two touch.
        if i % rows + 1 < rows && differs(i + 1) {
            data.push_str(&format!("M{} {}H{}", n(cell.x.0), n(cell.y.0), n(cell.x.1)));
        }
        let right = i + rows;
        if right < cells.len() && (cells[right].x.0 - cell.x.1).abs() < 1e-6 && differs(right) {
            data.push_str(&format!("M{} {}V{}", n(cell.x.1), n(cell.y.0), n(cell.y.1)));
        }
    }
    data
}

/// Largest value and where it is.
fn describe(grid: &WallGrid, map: &CellMap, shown: &Shown) -> String {
    let best = |better: fn(f64, f64) -> bool| {
        (0..map.values.len()).fold(0, |b, i| if better(map.values[i], map.values[b]) { i } else { b })
    };
    let (most, least) = (best(|a, b| a > b), best(|a, b| a < b));
    let at = |i: usize| [shown.with_unit(map.values[i]), wall::place(grid, i)];
    let (largest, smallest) = (at(most), at(least));
    words::cells(&map.title, largest.each_ref().map(String::as_str), smallest.each_ref().map(String::as_str))
}

/// Values at some columns and rows, highest row first.
fn table(grid: &WallGrid, map: &CellMap, shown: &Shown) -> Table {
    let count = grid.columns.count();
    let chosen = spread(count, 9);
    let title = |i: usize| match &grid.columns {
        Columns::Sectors { edges, .. } => {
            format!("θ = {}°", significant(0.5 * (edges[i] + edges[i + 1]).to_degrees(), 4))
        }
        Columns::Walls { names } => names[i].clone(),
    };
    let mut columns = columns!["z" => "m"];
    columns.extend(chosen.iter().map(|&i| Column::numbers(&title(i), shown.unit)));
    let mut table = Table::new(columns);
    for j in spread(grid.rows(), 21).into_iter().rev() {
        let mut row = vec![fixed(0.5 * (grid.z[j] + grid.z[j + 1]), 3)];
        row.extend(chosen.iter().map(|&i| shown.number(map.values[j * count + i])));
        table.row(row);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> WallGrid {
        WallGrid {
            columns: Columns::Sectors {
                radius: 5.0,
                edges: (0..=6).map(|i| (30.0 * f64::from(i)).to_radians()).collect(),
                mirrored: true,
            },
            z: (0..=4).map(f64::from).collect(),
            surface: 3.2,
        }
    }

    fn map(value: impl Fn(usize) -> f64) -> CellMap {
        CellMap {
            id: "plastic_strain".into(),
            title: "Plastic strain".into(),
            dimension: Dimension::Dimensionless,
            values: (0..24).map(value).collect(),
            mark: Some(4e-3),
            note: "Largest over the thickness.".into(),
        }
    }

    #[test]
    fn strains_are_printed_in_thousandths_and_the_mark_is_told() {
        let figure = figure("a", &grid(), &map(|i| 1e-3 * (i / 6) as f64 * (1.0 + i as f64 / 24.0))).expect("a map");
        assert!(figure.markup.contains("[‰]") && figure.markup.contains("class=\"mk in\""));
        assert!(figure.caption.contains("Double line: 4\u{a0}‰; 25\u{a0}% of the cells"), "{}", figure.caption);
        assert!(figure.description.contains("largest 5.875\u{a0}‰ at θ = ±165°, z = 3.50"), "{}", figure.description);
        assert_eq!((figure.table.rows.len(), figure.table.columns.len()), (4, 7));
    }

    /// A single marked cell has four edges, drawn once each; its mirror image has four more.
    #[test]
    fn the_outline_runs_around_the_marked_cells() {
        let grid = grid();
        let layout = Layout::of(&grid, TOP, BAR).expect("cells");
        let around = outline(&layout, 4, |number| number == 8);
        assert_eq!(around.matches('M').count(), 8, "{around}");
        assert!(outline(&layout, 4, |_| true).is_empty());
    }

    #[test]
    fn nothing_to_draw_is_said_in_words() {
        let zero = map(|_| 0.0);
        assert!(figure("a", &grid(), &zero).is_none());
        assert_eq!(sentence(&zero), "Plastic strain: zero everywhere.");
        assert_eq!(sentence(&map(|_| 2e-3)), "Plastic strain: 2.000\u{a0}‰ everywhere.");
        assert!(figure("a", &grid(), &map(|i| if i == 3 { f64::NAN } else { 1.0 })).is_none());
        let mut short = map(|i| i as f64);
        short.values.pop();
        assert!(figure("a", &grid(), &short).is_none());
    }
}
