//! Maps and cracks of the walls, cell by cell.

use tank::units::Dimension;
use tank::{Behaviour, Concrete, Layer};

use super::history::Picture;
use super::run::WallRun;
use super::section::{course_at, main_leaf};
use super::walls::{FACES, WALLS, Walls};
use results::nonlinear::{CellMap, Crack, CrackPicture};

impl Walls<'_> {
    /// Layers of the leaf that bends in element `e`.
    fn leaf(&self, e: usize) -> Vec<Layer> {
        let levels = &self.model.tank.levels;
        let layers = course_at(self.case, 0.5 * (levels[e] + levels[e + 1])).build_up();
        // The strip was built from these layers, so that this succeeds.
        main_leaf(&layers).map(<[Layer]>::to_vec).unwrap_or_default()
    }

    /// The concrete at a face of element `e`.
    fn concrete(&self, e: usize, face: usize) -> Option<Concrete> {
        let leaf = self.leaf(e);
        let layer = if face == 0 { leaf.first() } else { leaf.last() };
        match layer?.material.behaviour {
            Behaviour::Concrete(concrete) => Some(concrete),
            _ => None,
        }
    }

    /// Whether any wall can crack.
    pub(super) fn cracks_at_all(&self) -> bool {
        (0..self.model.tank.sections.len()).any(|e| self.leaf(e).iter().any(is_concrete))
    }

    /// A value of each cell, row by row from the base.
    fn cells(&self, value: impl Fn(&WallRun, usize) -> f64) -> Vec<f64> {
        let value = &value;
        (0..self.model.tank.sections.len()).flat_map(|e| self.runs.iter().map(move |run| value(run, e))).collect()
    }

    pub(super) fn maps(&self) -> Vec<CellMap> {
        let mut maps = self.crack_maps();
        maps.push(map(
            "utilisation",
            "utilisation of the wall",
            Dimension::Dimensionless,
            self.cells(|run, e| run.history.cells[e].utilisation),
            Some(1.0),
            "Largest stress over strength of any fibre; in tension over the remaining strength.",
        ));
        let leaves: Vec<Vec<Layer>> = (0..self.model.tank.sections.len()).map(|e| self.leaf(e)).collect();
        if leaves.iter().flatten().any(|l| l.material.behaviour != Behaviour::Elastic) {
            maps.push(map(
                "plastic_strain",
                "plastic strain of the wall",
                Dimension::Dimensionless,
                self.cells(|run, e| run.history.cells[e].plastic_strain),
                None,
                "Largest plastic strain of any fibre.",
            ));
        }
        maps.extend(self.bar_maps(&leaves));
        maps.push(self.separation_map());
        maps
    }

    /// Widths and depths of cracks, of a wall that can crack.
    fn crack_maps(&self) -> Vec<CellMap> {
        let mut maps = Vec::new();
        if !self.cracks_at_all() {
            return maps;
        }
        for (face, name) in FACES.into_iter().enumerate() {
            maps.push(map(
                "crack_width",
                &format!("largest crack width, {name}"),
                Dimension::Length,
                self.cells(|run, e| self.width(e, face, cracks(&run.history.pictures[1], face, e)[1])),
                None,
                "Opening strain times the length over which it is smeared.",
            ));
        }
        maps.push(map(
            "crack_depth",
            "share of the section that has cracked",
            Dimension::Dimensionless,
            self.cells(|run, e| run.history.cells[e].cracked),
            None,
            "Fibres that have cracked at least once, of all fibres of the section.",
        ));
        maps
    }

    /// Stress and plastic strain of the bars of the leaf that bends, element by element, if there are any.
    fn bar_maps(&self, leaves: &[Vec<Layer>]) -> Vec<CellMap> {
        let bars = leaves.iter().flatten().flat_map(|l| &l.reinforcement);
        let yields: Vec<Option<f64>> = bars
            .map(|bars| match bars.material.behaviour {
                Behaviour::Reinforcement(bar) => Some(bar.yield_strength),
                _ => None,
            })
            .collect();
        if yields.is_empty() {
            return Vec::new();
        }
        let least = yields.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        vec![
            map(
                "bar_stress",
                "largest stress of a bar",
                Dimension::Stress,
                self.cells(|run, e| run.history.cells[e].bar_stress),
                least.is_finite().then_some(least),
                "Absolute value, of all vertical bars; the mark is their yield strength.",
            ),
            map(
                "bar_plastic_strain",
                "plastic strain of a bar",
                Dimension::Dimensionless,
                self.cells(|run, e| run.history.cells[e].bar_plastic_strain),
                None,
                "Largest of all vertical bars.",
            ),
        ]
    }

    /// Gap between liquid and wall where it may open; else the lowest pressure at the wall.
    fn separation_map(&self) -> CellMap {
        if self.runs[0].history.openings.is_some() {
            return map(
                "separation",
                "largest gap between liquid and wall",
                Dimension::Length,
                self.cells(|run, e| {
                    // The lowest joint is at level 1.
                    let gaps = run.history.openings.iter().flat_map(|o| o.widest());
                    let own = gaps.skip(e.saturating_sub(1)).take(if e == 0 { 1 } else { 2 });
                    own.fold(0.0, f64::max)
                }),
                None,
                "Widest gap at the ends of the element; 0 where the liquid has stayed in contact.",
            );
        }
        map(
            "separation",
            "lowest pressure of the liquid at the wall",
            Dimension::Stress,
            self.cells(|run, e| {
                let seen = run.history.separation.lowest_pressures().nth(e);
                seen.map_or(0.0, |(_, p)| if p.is_finite() { p } else { 0.0 })
            }),
            Some(0.0),
            "Gauge pressure of the particle that is there at rest, in the middle of the element; below 0 the liquid would \
             separate from the wall if air entered. 0 above the surface.",
        )
    }

    /// Width of a crack of this opening strain [m].
    fn width(&self, e: usize, face: usize, strain: f64) -> f64 {
        let levels = &self.model.tank.levels;
        let length = levels[e + 1] - levels[e];
        self.concrete(e, face).map_or(0.0, |c| strain * c.band(length))
    }

    pub(super) fn cracks(&self) -> Vec<CrackPicture> {
        if !self.cracks_at_all() {
            return Vec::new();
        }
        let mut pictures = Vec::new();
        let mut push = |title: String, face: usize, time: f64, walls: &[usize], which: usize| {
            let mut found = Vec::new();
            for &wall in walls {
                let picture = &self.runs[wall].history.pictures[which];
                for e in 0..picture.faces[face].len() {
                    let [now, largest] = cracks(picture, face, e).map(|strain| self.width(e, face, strain));
                    if largest > 0.0 {
                        found.push(Crack { cell: 2 * e + wall, angle: 0.0, width: now, largest });
                    }
                }
            }
            found.sort_by_key(|c| c.cell);
            pictures.push(CrackPicture { title, face: FACES[face].into(), time, cracks: found });
        };
        for (wall, name) in WALLS.into_iter().enumerate() {
            let picture = &self.runs[wall].history.pictures[0];
            for face in 0..FACES.len() {
                push(format!("largest base moment, {name}"), face, picture.time, &[wall], 0);
            }
        }
        for face in 0..FACES.len() {
            push("end".into(), face, self.time(), &[0, 1], 1);
        }
        pictures
    }
}

fn map(id: &str, title: &str, dimension: Dimension, values: Vec<f64>, mark: Option<f64>, note: &str) -> CellMap {
    CellMap { id: id.into(), title: title.into(), dimension, values, mark, note: note.into() }
}

fn is_concrete(layer: &Layer) -> bool {
    matches!(layer.material.behaviour, Behaviour::Concrete(_))
}

/// Opening strains at a face of element `e`; none before the first step.
fn cracks(picture: &Picture, face: usize, e: usize) -> [f64; 2] {
    picture.faces[face].get(e).copied().unwrap_or([0.0; 2])
}
