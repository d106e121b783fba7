//! A wall of the strip as rows of layered shells.

use fem::element::SectionState;
use fem::element::wall::place::Build;

/// Breadth of the strip [m]: everything is per metre of tank.
pub(super) const BREADTH: f64 = 1.0;
/// Points of a shell.
pub(super) const POINTS: usize = 4;

/// Shells of an element of the wall.
#[derive(Clone)]
pub struct ShellRow {
    /// One shell, or two with a layer between them.
    pub build: Build,
    /// Layers of the leaf that bends; points of its section from this number on are bars.
    pub layers: usize,
}

/// A wall of shells instead of fibre beams.
#[derive(Clone)]
pub struct ShellWall {
    /// Elements from the bottom; one fewer than levels.
    pub rows: Vec<ShellRow>,
    /// Number of the leaf that bends, from the wet one.
    pub main: usize,
    /// Distance from the wet to the other reference surface [m]; 0 of one shell.
    pub gap: f64,
}

impl std::fmt::Debug for ShellWall {
    /// Sections are not shown.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ShellWall {{ {} rows, leaf {}, gap {} m }}", self.rows.len(), self.main, self.gap)
    }
}

impl ShellWall {
    /// Whether a material point of this number belongs to the leaf that bends.
    pub(super) fn bends(&self, point: usize) -> bool {
        point / POINTS == self.main
    }

    /// Mean curvature and moment up the wall of the lower points of the leaf that bends, of the sign of a fibre wall.
    pub(super) fn lowest(&self, sections: &[SectionState]) -> [f64; 2] {
        let own = sections.chunks(POINTS).nth(self.main).unwrap_or_default();
        let lowest = own.iter().map(|s| s.position[2]).fold(f64::INFINITY, f64::min);
        let low = own.iter().filter(|s| s.position[2] < lowest + 1e-9);
        let count = low.clone().count().max(1) as f64;
        // Axis 2 is the upward one.
        let mean = |of: &dyn Fn(&SectionState) -> f64| low.clone().map(of).sum::<f64>() / count;
        [mean(&|s| s.strain[4]), BREADTH * mean(&|s| s.resultants[4])]
    }
}
