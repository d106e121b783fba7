//! Cracks on the developed wall: a short stroke along each, its weight by the width.
//!
//! ```text
//!  ┌──┬──┬──┬──┐
//!  │  │ ╱│ ╱│  │      ── open, weight by width      ┄┄ closed
//!  ├──┼──┼──┼──┤
//!  │──│──│─╲│  │
//!  └──┴──┴──┴──┘
//! ```
//!
//! Height and circumference have different scales: strokes are the images of the directions, like everything in the
//! picture.

use super::svg::{Anchor, Svg, n};
use super::wall::{self, Cell, Layout};
use super::width::{FONT, text_width};
use super::{Figure, WIDE};
use crate::number::{fixed, significant};
use crate::table::{Table, columns};
use crate::words::figures::wall as words;
use crate::words::{capital, labels};
use results::nonlinear::{Columns, Crack, CrackPicture, WallGrid};

/// Widths at which the strokes become heavier [m]: up to 0.2 mm a wall may still be called tight (EN 1992-3, 7.3.1), 0.3 to
/// 0.4 mm are the limits of buildings (EN 1992-1-1, table 7.1N).
const WEIGHTS: [f64; 5] = [0.05e-3, 0.1e-3, 0.2e-3, 0.4e-3, 1e-3];
/// A crack narrower than this is closed [m].
const CLOSED: f64 = 1e-6;
/// Part of its cell that a stroke fills.
const FILL: f64 = 0.84;
/// Cracks listed at most.
const LISTED: usize = 24;
/// Cells below this size are drawn without their edges.
const GRID: f64 = 9.0;
/// Room a row of the legend takes.
const ROW: f64 = 16.0;

/// Class of a stroke: 0 to 5 by width, or `None` if it is closed.
fn weight(crack: &Crack) -> Option<usize> {
    (crack.width > CLOSED).then(|| WEIGHTS.iter().filter(|w| crack.width > **w).count())
}

/// A width with three digits.
fn millimetres(width: f64) -> String {
    format!("{}\u{a0}mm", significant(1e3 * width, 3))
}

/// A picture without cracks, in one sentence.
pub fn sentence(picture: &CrackPicture) -> String {
    words::no_crack(&face(picture), &when(picture))
}

fn when(picture: &CrackPicture) -> String {
    let time = format!("t = {}\u{a0}s", fixed(picture.time, 2));
    match picture.title.as_str() {
        "" => time,
        title => format!("{title}, {time}"),
    }
}

/// Face with a capital.
fn face(picture: &CrackPicture) -> String {
    match picture.face.as_str() {
        "" => "Wall".into(),
        face => capital(face),
    }
}

/// Draws a picture; `None` without cells or cracks, or with a crack outside the grid.
pub fn figure(id: &str, grid: &WallGrid, picture: &CrackPicture) -> Option<Figure> {
    let sound = |c: &Crack| c.cell < grid.cells() && c.angle.is_finite() && c.width.is_finite();
    if picture.cracks.is_empty() || !picture.cracks.iter().all(sound) {
        return None;
    }
    let width = Layout::of(grid, 0.0, 14.0)?.size.0;
    let entries = legend(picture, width);
    let rows = entries.last().map_or(0.0, |e| e.1 + 1.0);
    let layout = Layout::of(grid, ROW * rows + 20.0, 14.0)?;
    let mut svg = Svg::new();
    draw_legend(&mut svg, &entries);
    if let Some(level) = layout.surface() {
        for part in layout.parts() {
            svg.rect((part.0, level), (part.1 - part.0, layout.y.1 - level), "liq");
        }
    }
    mesh(&mut svg, &layout);
    let mut strokes: Vec<String> = vec![String::new(); WEIGHTS.len() + 2];
    let mut by_cell: Vec<Vec<&Crack>> = vec![Vec::new(); grid.cells()];
    picture.cracks.iter().for_each(|c| by_cell[c.cell].push(c));
    for cell in &layout.cells {
        for crack in &by_cell[cell.number] {
            let class = weight(crack).map_or(0, |w| w + 1);
            strokes[class].push_str(&stroke(cell, crack, &layout));
        }
    }
    for (class, data) in strokes.iter().enumerate().filter(|(_, data)| !data.is_empty()) {
        svg.append(&format!(r#"<path class="{}" d="{data}"/>"#, name(class)));
    }
    layout.frame(&mut svg, "ws");
    let open = picture.cracks.iter().filter(|c| weight(c).is_some()).count();
    let widest = picture.cracks.iter().map(|c| c.width).fold(0.0, f64::max);
    let mirrored = matches!(grid.columns, Columns::Sectors { mirrored: true, .. });
    Some(
        Figure::new(
            id,
            format!("{}, {}", face(picture), when(picture)),
            (layout.size, svg.into_markup()),
            table(grid, picture),
        )
        .captioned(words::cracks(open, picture.cracks.len() - open, &millimetres(widest), mirrored))
        .described(words::cracks_description(
            picture,
            &when(picture),
            open,
            grid.cells(),
            [reach(grid, picture, f64::min, 0), reach(grid, picture, f64::max, 1)],
        )),
    )
}

/// Lowest or highest edge of the cracked cells [m].
fn reach(grid: &WallGrid, picture: &CrackPicture, choose: fn(f64, f64) -> f64, edge: usize) -> f64 {
    let rows = picture.cracks.iter().map(|c| c.cell / grid.columns.count().max(1));
    let edges = rows.filter_map(|row| grid.z.get(row + edge).copied());
    edges.reduce(choose).unwrap_or(0.0)
}

/// CSS classes: 0 is closed, then the weights.
fn name(class: usize) -> String {
    match class {
        0 => "cr shut".into(),
        w => format!("cr c{}", w - 1),
    }
}

/// The stroke of a crack through the middle of its cell.
fn stroke(cell: &Cell, crack: &Crack, layout: &Layout) -> String {
    let angle = if cell.mirrored { -crack.angle } else { crack.angle };
    let direction = (angle.cos() * layout.stretch.0, angle.sin() * layout.stretch.1);
    let (wide, high) = (cell.x.1 - cell.x.0, cell.y.1 - cell.y.0);
    // As long as the cell lets it, whichever side it meets first.
    let reach = |room: f64, d: f64| if d.abs() > 1e-12 { room / d.abs() } else { f64::INFINITY };
    let half = 0.5 * FILL * reach(wide, direction.0).min(reach(high, direction.1));
    if !half.is_finite() {
        return String::new();
    }
    let middle = (0.5 * (cell.x.0 + cell.x.1), 0.5 * (cell.y.0 + cell.y.1));
    format!(
        "M{} {}L{} {}",
        n(middle.0 - half * direction.0),
        n(middle.1 + half * direction.1),
        n(middle.0 + half * direction.0),
        n(middle.1 - half * direction.1)
    )
}

/// Edges of the cells, where these are large enough for it.
fn mesh(svg: &mut Svg, layout: &Layout) {
    let small = |c: &Cell| c.x.1 - c.x.0 < GRID || c.y.1 - c.y.0 < 0.6 * GRID;
    if layout.cells.iter().any(small) {
        return;
    }
    let mut data = String::new();
    for cell in &layout.cells {
        data.push_str(&format!("M{} {}H{}V{}", n(cell.x.0), n(cell.y.0), n(cell.x.1), n(cell.y.1)));
    }
    svg.append(&format!(r#"<path class="gm" d="{data}"/>"#));
}

/// Samples of the legend: class, row, x, text.
fn legend(picture: &CrackPicture, width: f64) -> Vec<(usize, f64, f64, String)> {
    let mut present: Vec<usize> = picture.cracks.iter().map(|c| weight(c).map_or(0, |w| w + 1)).collect();
    present.sort_unstable();
    present.dedup();
    // Open ones by width, closed last.
    present.sort_by_key(|&c| if c == 0 { usize::MAX } else { c });
    let mut entries = Vec::new();
    let (mut x, mut row) = (1.0, 0.0);
    for class in present {
        let text = match class {
            0 => "closed".into(),
            w => words::width(w - 1, &WEIGHTS),
        };
        let wide = 30.0 + text_width(&text) * FONT + 14.0;
        if x + wide - 14.0 > width.min(WIDE) && x > 1.0 {
            (x, row) = (1.0, row + 1.0);
        }
        entries.push((class, row, x, text));
        x += wide;
    }
    entries
}

fn draw_legend(svg: &mut Svg, entries: &[(usize, f64, f64, String)]) {
    for (class, row, x, text) in entries {
        let y = ROW * row + 8.0;
        svg.line((*x + 2.0, y), (x + 22.0, y), &name(*class));
        svg.text((x + 30.0, y + 3.8), Anchor::Start, "lb", text);
    }
}

/// The widest cracks.
fn table(grid: &WallGrid, picture: &CrackPicture) -> Table {
    let mut order: Vec<&Crack> = picture.cracks.iter().collect();
    order.sort_by(|a, b| b.width.total_cmp(&a.width).then(b.largest.total_cmp(&a.largest)));
    let mut table = Table::new(columns![
        "Where", labels::CRACK_DIRECTION => "°", "Width" => "mm", labels::LARGEST_SO_FAR => "mm", "State",
    ]);
    if order.len() > LISTED {
        table.caption = words::widest(LISTED, order.len());
    }
    for crack in order.into_iter().take(LISTED) {
        table.row(vec![
            wall::place(grid, crack.cell),
            fixed(crack.angle.to_degrees(), 0),
            fixed(1e3 * crack.width, 3),
            fixed(1e3 * crack.largest, 3),
            if weight(crack).is_some() { "open" } else { "closed" }.into(),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::super::Room;
    use super::*;

    fn grid(mirrored: bool) -> WallGrid {
        WallGrid {
            columns: Columns::Sectors {
                radius: 10.0,
                edges: (0..=4).map(|i| (if mirrored { 45.0 } else { 90.0 } * f64::from(i)).to_radians()).collect(),
                mirrored,
            },
            z: vec![0.0, 1.0, 3.0],
            surface: 2.0,
        }
    }

    fn crack(cell: usize, angle: f64, width: f64) -> Crack {
        Crack { cell, angle, width, largest: 0.5e-3 }
    }

    fn picture(cracks: Vec<Crack>) -> CrackPicture {
        CrackPicture { title: "largest base moment".into(), face: "inner face".into(), time: 3.5, cracks }
    }

    /// Ends of the strokes of a class.
    fn strokes(figure: &Figure, class: &str) -> Vec<[f64; 4]> {
        let Some(path) = figure.markup.split(&format!("class=\"{class}\" d=\"M")).nth(2) else { return Vec::new() };
        let data = path.split('"').next().unwrap_or("");
        data.split('M')
            .map(|s| {
                let numbers: Vec<f64> = s.split([' ', 'L']).map(|v| v.parse().unwrap()).collect();
                [numbers[0], numbers[1], numbers[2], numbers[3]]
            })
            .collect()
    }

    #[test]
    fn strokes_keep_to_their_cells_and_are_mirrored() {
        let figure = figure("a", &grid(true), &picture(vec![crack(1, 0.5, 0.3e-3)])).expect("a crack");
        let found = strokes(&figure, "cr c3");
        assert_eq!(found.len(), 2);
        let slope = |s: [f64; 4]| (s[3] - s[1]) / (s[2] - s[0]);
        // Rising to the right (y goes down), and its mirror image.
        assert!(slope(found[0]) < 0.0 && (slope(found[0]) + slope(found[1])).abs() < 0.03);
        let binding = grid(true);
        let layout = Layout::of(&binding, 36.0, 14.0).expect("cells");
        // tan a times the ratio of the scales; coordinates are printed to a tenth of about 60.
        let drawn = 0.5_f64.tan() * layout.stretch.1 / layout.stretch.0;
        assert!((slope(found[0]) + drawn).abs() < 0.02 * drawn, "{} {drawn}", slope(found[0]));
        let cell = layout.cells[2];
        assert!(cell.number == 1 && found[0][0] > cell.x.0 && found[0][2] < cell.x.1);
        assert!(figure.caption.contains("1 open, 0 closed; widest 0.300\u{a0}mm"), "{}", figure.caption);
    }

    #[test]
    fn weights_and_closed_cracks_are_told_apart() {
        let cracks = vec![crack(0, 0.0, 0.0), crack(0, 1.5, 0.01e-3), crack(2, 0.0, 2e-3), crack(7, 1.0, 0.05e-3)];
        let figure = figure("a", &grid(false), &picture(cracks)).expect("cracks");
        for (class, number) in [("cr shut", 1), ("cr c0", 2), ("cr c5", 1)] {
            assert_eq!(strokes(&figure, class).len(), number, "{class}");
        }
        for text in ["closed", "up to 0.05 mm", "over 1 mm"] {
            assert!(figure.markup.contains(text), "{text}");
        }
        assert_eq!(figure.table.rows.len(), 4);
        assert_eq!(figure.table.rows[0][2], "2.000");
    }

    #[test]
    fn no_cracks_no_picture() {
        let none = picture(vec![]);
        assert!(figure("a", &grid(true), &none).is_none());
        assert_eq!(sentence(&none), "Inner face: no crack, largest base moment, t = 3.50\u{a0}s.");
        assert!(figure("a", &grid(true), &picture(vec![crack(99, 0.0, 1e-3)])).is_none());
        assert!(figure("a", &grid(true), &picture(vec![crack(0, f64::NAN, 1e-3)])).is_none());
    }

    #[test]
    fn walls_of_a_strip_stand_side_by_side() {
        let grid = WallGrid {
            columns: Columns::Walls { names: vec!["left wall".into(), "right wall".into()] },
            z: (0..=10).map(|i| 0.3 * f64::from(i)).collect(),
            surface: 2.5,
        };
        let figure = figure("a", &grid, &picture(vec![crack(0, 0.0, 1e-4), crack(3, 0.0, 0.0)])).expect("cracks");
        assert_eq!(figure.room, Room::Half);
        assert!(figure.markup.contains("right wall"));
        assert!(figure.table.rows[0][0].starts_with("left wall, z = 0.15"));
    }
}
