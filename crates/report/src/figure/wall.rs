//! The developed wall as a drawing: where its cells stand, its frame, the surface of the liquid, the colour bar.

use tank::units::Dimension;

use super::chart::titled;
use super::perimeter::Perimeter;
use super::svg::{Anchor, Svg};
use super::width::{FONT, text_width};
use super::{HALF, WIDE, ticks};
use crate::number::{Scale, fixed, plain};
use results::nonlinear::{Columns, WallGrid};

/// Left edge of the plot.
pub const LEFT: f64 = 46.0;
/// Upper edge of the plot of a map.
pub const TOP: f64 = 22.0;
/// Height of the plot around a tank.
pub const PLOT: f64 = 190.0;
/// Room below the plot.
pub const BELOW: f64 = 36.0;
/// Room for the colour bar.
pub const BAR: f64 = 84.0;
/// Colour steps: the classes `v0` to `v15` of `templates/fields.css`.
pub const STEPS: usize = 16;

/// Height of the plot of walls side by side.
const TALL: f64 = 230.0;
/// Room between two walls.
const GAP: f64 = 22.0;

/// A cell as drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Number in the grid.
    pub number: usize,
    /// Column as drawn, from the left.
    pub column: usize,
    /// Left and right edge.
    pub x: (f64, f64),
    /// Upper and lower edge.
    pub y: (f64, f64),
    /// Whether it is the mirror image.
    pub mirrored: bool,
}

/// A grid laid out in a figure.
pub struct Layout<'a> {
    grid: &'a WallGrid,
    /// All cells, columns from the left, each from the base up.
    pub cells: Vec<Cell>,
    /// Left and right edge of the plot.
    pub x: (f64, f64),
    /// Upper and lower edge of the plot.
    pub y: (f64, f64),
    /// Size of the figure.
    pub size: (f64, f64),
    /// User units a metre along the wall and upwards: they differ, directions are drawn accordingly.
    pub stretch: (f64, f64),
}

impl<'a> Layout<'a> {
    /// Lays a grid out below `top`, with `right` free at its right; `None` without cells or area.
    pub fn of(grid: &'a WallGrid, top: f64, right: f64) -> Option<Layout<'a>> {
        let ascending = |v: &[f64]| v.iter().all(|x| x.is_finite()) && v.windows(2).all(|w| w[1] > w[0]);
        if grid.cells() == 0 || !ascending(&grid.z) {
            return None;
        }
        let (z0, z1) = (grid.z[0], grid.z[grid.z.len() - 1]);
        let (width, height) = match &grid.columns {
            Columns::Sectors { .. } => (WIDE, PLOT),
            Columns::Walls { names } if names.len() > 2 => (WIDE, TALL),
            Columns::Walls { .. } => (HALF, TALL),
        };
        let (x, y) = ((LEFT, width - right), (top, top + height));
        let level = |z: f64| y.1 - (z - z0) / (z1 - z0) * height;
        // Columns from the left: number in the grid, edges, whether mirrored.
        let mut columns: Vec<(usize, (f64, f64), bool)> = Vec::new();
        let upwards = height / (z1 - z0);
        let along = match &grid.columns {
            Columns::Sectors { radius, edges, mirrored } => {
                if !ascending(edges) || !radius.is_finite() || *radius <= 0.0 {
                    return None;
                }
                let first = edges[0];
                let last = if *mirrored { std::f64::consts::TAU - first } else { edges[edges.len() - 1] };
                if last < edges[edges.len() - 1] {
                    return None;
                }
                let place = |theta: f64| x.0 + (theta - first) / (last - first) * (x.1 - x.0);
                let image = |theta: f64| std::f64::consts::TAU - theta;
                let sectors = edges.windows(2).enumerate();
                columns.extend(sectors.map(|(i, e)| (i, (place(e[0]), place(e[1])), false)));
                if *mirrored {
                    let images = edges.windows(2).enumerate().rev();
                    columns.extend(images.map(|(i, e)| (i, (place(image(e[1])), place(image(e[0]))), true)));
                }
                (x.1 - x.0) / ((last - first) * radius)
            }
            Columns::Walls { names } => {
                let count = names.len() as f64;
                let wide = (x.1 - x.0 - GAP * (count - 1.0)) / count;
                let left = |i: usize| x.0 + i as f64 * (wide + GAP);
                columns.extend((0..names.len()).map(|i| (i, (left(i), left(i) + wide), false)));
                upwards
            }
        };
        let mut cells = Vec::with_capacity(grid.cells());
        for (column, (number, x, mirrored)) in columns.into_iter().enumerate() {
            cells.extend(grid.z.windows(2).enumerate().map(|(row, z)| Cell {
                number: row * grid.columns.count() + number,
                column,
                x,
                y: (level(z[1]), level(z[0])),
                mirrored,
            }));
        }
        Some(Layout { grid, cells, x, y, size: (width, y.1 + BELOW), stretch: (along, upwards) })
    }

    /// Edges of the separate parts of the plot: one around a tank, one a wall.
    pub fn parts(&self) -> Vec<(f64, f64)> {
        match &self.grid.columns {
            Columns::Sectors { .. } => vec![self.x],
            Columns::Walls { .. } => {
                let rows = self.grid.rows();
                self.cells.iter().step_by(rows.max(1)).map(|c| c.x).collect()
            }
        }
    }

    /// Height of the surface in the figure, if the plot holds it.
    pub fn surface(&self) -> Option<f64> {
        let (z0, z1) = (self.grid.z[0], self.grid.z[self.grid.z.len() - 1]);
        let inside = self.grid.surface > z0 && self.grid.surface < z1;
        inside.then_some(self.y.1 - (self.grid.surface - z0) * self.stretch.1)
    }

    /// Frames, ticks and titles; the surface as a line of this class.
    pub fn frame(&self, svg: &mut Svg, surface: &str) {
        for part in self.parts() {
            let corners = [(part.0, self.y.0), (part.1, self.y.0), (part.1, self.y.1), (part.0, self.y.1)];
            svg.path(&corners, true, "ax");
            if let Some(level) = self.surface() {
                svg.line((part.0, level), (part.1, level), surface);
            }
        }
        if let Some(level) = self.surface() {
            let tip = (self.x.1 + 6.0, level);
            svg.path(&[tip, (tip.0 - 4.0, tip.1 - 7.0), (tip.0 + 4.0, tip.1 - 7.0)], true, "tri");
        }
        heights(svg, (self.grid.z[0], self.grid.z[self.grid.z.len() - 1]), self.x.0, self.y);
        match &self.grid.columns {
            Columns::Sectors { edges, mirrored, .. } => {
                let last = if *mirrored { std::f64::consts::TAU - edges[0] } else { edges[edges.len() - 1] };
                angles(svg, (edges[0], last), self.x, self.y.1);
                if *mirrored {
                    let middle = 0.5 * (self.x.0 + self.x.1);
                    svg.line((middle, self.y.0), (middle, self.y.1), "rl");
                }
            }
            Columns::Walls { names } => {
                for (name, part) in names.iter().zip(self.parts()) {
                    let middle = 0.5 * (part.0 + part.1);
                    svg.text((middle, self.y.1 + 16.0), Anchor::Middle, "at", name);
                }
            }
        }
    }

    /// Where a cell is, in words.
    pub fn place(&self, number: usize) -> String {
        place(self.grid, number)
    }
}

/// Where the middle of a cell is, in words.
pub fn place(grid: &WallGrid, number: usize) -> String {
    let count = grid.columns.count().max(1);
    let (row, column) = (number / count, number % count);
    let middle = |v: &[f64], i: usize| match (v.get(i), v.get(i + 1)) {
        (Some(a), Some(b)) => 0.5 * (a + b),
        _ => f64::NAN,
    };
    let z = fixed(middle(&grid.z, row), 2);
    match &grid.columns {
        Columns::Sectors { edges, mirrored, .. } => {
            let theta = middle(edges, column).to_degrees();
            let sign = if *mirrored { "±" } else { "" };
            format!("θ = {sign}{}°, z = {z}\u{a0}m", plain(theta, 1))
        }
        Columns::Walls { names } => format!("{}, z = {z}\u{a0}m", names.get(column).map_or("", String::as_str)),
    }
}

/// Ticks of the heights at the left edge of a plot, and their title above it.
pub fn heights(svg: &mut Svg, z: (f64, f64), left: f64, y: (f64, f64)) {
    let scale = Scale::single(Dimension::Length, [z.0, z.1]);
    let (levels, decimals) = ticks(scale.convert(z.0), scale.convert(z.1), 5);
    for height in levels {
        let level = y.1 - (height / scale.convert(1.0) - z.0) / (z.1 - z.0) * (y.1 - y.0);
        svg.line((left - 3.0, level), (left, level), "ax");
        svg.text((left - 6.0, level + 3.8), Anchor::End, "tk", &plain(height, decimals));
    }
    svg.text((1.0, y.0 - 9.0), Anchor::Start, "at", &titled("Height z", scale.symbol()));
}

/// Ticks of the angles below a plot, and their title.
pub fn angles(svg: &mut Svg, theta: (f64, f64), x: (f64, f64), bottom: f64) {
    for degrees in (-360..=360).step_by(45) {
        let angle = f64::from(degrees).to_radians();
        if angle < theta.0 - 1e-6 || angle > theta.1 + 1e-6 {
            continue;
        }
        let at = x.0 + (angle - theta.0) / (theta.1 - theta.0) * (x.1 - x.0);
        svg.line((at, bottom), (at, bottom + 3.0), "ax");
        svg.text((at, bottom + 14.0), Anchor::Middle, "tk", &fixed(f64::from(degrees), 0));
    }
    svg.text((x.1, bottom + 30.0), Anchor::End, "at", crate::words::labels::ANGLE_AXIS);
}

/// Ticks of the positions along the walls of a box below a plot from `y.0` to `y.1`, their title, corners and names of the walls.
pub fn positions(svg: &mut Svg, along: (f64, f64), x: (f64, f64), y: (f64, f64), walls: Perimeter) {
    let at = |s: f64| x.0 + (s - along.0) / (along.1 - along.0) * (x.1 - x.0);
    let scale = Scale::single(Dimension::Length, [along.0, along.1]);
    let (levels, decimals) = ticks(scale.convert(along.0), scale.convert(along.1), 8);
    for position in levels {
        let place = at(position / scale.convert(1.0));
        svg.line((place, y.1), (place, y.1 + 3.0), "ax");
        svg.text((place, y.1 + 14.0), Anchor::Middle, "tk", &plain(position, decimals));
    }
    let corners = walls.corners();
    for (i, (corner, name)) in corners.into_iter().zip(Perimeter::WALLS).enumerate() {
        svg.line((at(corner), y.0), (at(corner), y.1), "rl");
        let end = corners.get(i + 1).copied().unwrap_or(along.1);
        svg.text((at(0.5 * (corner + end)), y.0 - 5.0), Anchor::Middle, "at", name);
    }
    svg.text((x.1, y.1 + 30.0), Anchor::End, "at", &titled(crate::words::labels::WALLS_AXIS, scale.symbol()));
}

/// The colour bar at the right of a plot from `y.0` down to `y.1` in a figure of this width.
pub fn bar(svg: &mut Svg, width: f64, y: (f64, f64), range: (f64, f64), levels: &[f64], decimals: usize, unit: &str) {
    let left = width - BAR + 18.0;
    let step = (y.1 - y.0) / STEPS as f64;
    for k in 0..STEPS {
        let top = y.1 - (k + 1) as f64 * step;
        svg.rect((left, top), (14.0, step + 0.3), &format!("v v{k}"));
    }
    let corners = [(left, y.0), (left + 14.0, y.0), (left + 14.0, y.1), (left, y.1)];
    svg.path(&corners, true, "ax");
    for &level in levels {
        let at = y.1 - (y.1 - y.0) * (level - range.0) / (range.1 - range.0);
        svg.line((left, at), (left + 17.0, at), "ax");
        svg.text((left + 20.0, at + 3.8), Anchor::Start, "tk", &plain(level, decimals));
    }
    if unit.is_empty() {
        return;
    }
    let wide = text_width(unit) * FONT;
    svg.text(((left + wide + 14.0).min(width), y.0 - 9.0), Anchor::End, "at", &format!("[{unit}]"));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sectors(mirrored: bool) -> WallGrid {
        let end = if mirrored { 180.0_f64 } else { 360.0 };
        WallGrid {
            columns: Columns::Sectors {
                radius: 10.0,
                edges: (0..=4).map(|i| (end * f64::from(i) / 4.0).to_radians()).collect(),
                mirrored,
            },
            z: vec![0.0, 1.0, 3.0],
            surface: 2.0,
        }
    }

    #[test]
    fn a_mirrored_half_is_drawn_twice() {
        let (half, whole) = (sectors(true), sectors(false));
        let half = Layout::of(&half, TOP, 0.0).expect("cells");
        let whole = Layout::of(&whole, TOP, 0.0).expect("cells");
        assert_eq!((half.cells.len(), whole.cells.len()), (16, 8));
        // The first and the last column are images of one another.
        let (first, last) = (half.cells[0], half.cells[14]);
        assert_eq!((first.number, last.number), (0, 0));
        assert!(last.mirrored && !first.mirrored);
        assert!((first.x.1 - first.x.0 - (last.x.1 - last.x.0)).abs() < 1e-9);
        assert!((last.x.1 - half.x.1).abs() < 1e-9 && (first.x.0 - half.x.0).abs() < 1e-9);
        // Cells follow on each other without gaps.
        for pair in half.cells.chunks(2).collect::<Vec<_>>().windows(2) {
            assert!((pair[0][0].x.1 - pair[1][0].x.0).abs() < 1e-9);
        }
        assert_eq!(half.place(0), "θ = ±22.5°, z = 0.50\u{a0}m");
        let level = half.surface().expect("inside");
        assert!((level - (half.y.1 - 2.0 / 3.0 * PLOT)).abs() < 1e-9);
    }

    #[test]
    fn walls_stand_side_by_side() {
        let grid = WallGrid {
            columns: Columns::Walls { names: vec!["left".into(), "right".into()] },
            z: vec![0.0, 1.0, 2.0, 3.0],
            surface: 9.0,
        };
        let layout = Layout::of(&grid, TOP, BAR).expect("cells");
        assert_eq!((layout.cells.len(), layout.parts().len()), (6, 2));
        assert_eq!(layout.cells[3].number, 1);
        assert!(layout.cells[3].x.0 > layout.cells[2].x.1);
        assert!(layout.surface().is_none());
        assert_eq!(layout.place(5), "right, z = 2.50\u{a0}m");
    }

    #[test]
    fn no_cells_no_layout() {
        let mut grid = sectors(true);
        grid.z = vec![1.0];
        assert!(Layout::of(&grid, TOP, 0.0).is_none());
        let mut grid = sectors(true);
        grid.z = vec![1.0, 1.0];
        assert!(Layout::of(&grid, TOP, 0.0).is_none());
        let mut grid = sectors(true);
        grid.columns = Columns::Walls { names: vec![] };
        assert!(Layout::of(&grid, TOP, 0.0).is_none());
    }
}
