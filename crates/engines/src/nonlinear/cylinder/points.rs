//! State of all material points of the wall, cell by cell.

use fem::element::{Inspect, Inspection};
use fem::state::{Gather, State};
use materials::concrete::crack_band;
use serde::{Deserialize, Serialize};

use super::model::CylinderModel;
use super::section::Part;
use results::nonlinear::Crack;

/// State of the cells; lists are empty where the wall has no such material.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Look {
    /// Largest stress of plates over their yield stress.
    pub utilisation: Vec<f64>,
    /// Largest plastic strain of plates.
    pub plastic_strain: Vec<f64>,
    /// Largest compressive stress of concrete over its strength.
    pub compression: Vec<f64>,
    /// Largest stress of bars, tension or compression [Pa].
    pub bar_stress: Vec<f64>,
    /// Largest plastic strain of bars.
    pub bar_plastic_strain: Vec<f64>,
    /// Widest crack of each cell, on the inner and the outer face [m]: so far.
    pub crack_width: [Vec<f64>; 2],
    /// Largest opening strain of any crack so far.
    pub crack_strain: f64,
    /// Cracks of the inner and the outer face.
    pub cracks: [Vec<Crack>; 2],
    /// Cells in which plates pass their strength, bars their strain at rupture.
    pub torn: Vec<usize>,
    /// The same of bars.
    pub ruptured: Vec<usize>,
}

/// Something that happens once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Happening {
    /// A crack opens.
    Crack,
    /// A plate yields.
    Yield,
    /// A bar yields.
    BarYield,
    /// A plate passes its tensile strength.
    Tears,
    /// A bar passes its strain at rupture.
    BarRupture,
    /// Concrete reaches its compressive strength.
    Crushing,
}

/// Stress at which a plate counts as yielding: rounding of the return is far below it.
const YIELDS: f64 = 1e-9;
/// Share of the strength at which concrete counts as crushing: its law is ideally plastic beyond.
const CRUSHES: f64 = 0.999;

/// Looks at the committed state.
pub(super) fn look(tank: &CylinderModel, state: &State) -> Look {
    let cells = tank.cells.rows() * tank.cells.columns();
    let has = |f: &dyn Fn(&Part) -> bool| tank.rows.iter().flat_map(|r| r.parts.iter().flatten()).any(f);
    let room = |there: bool| if there { vec![0.0; cells] } else { Vec::new() };
    let (steel, concrete, bars) = (
        has(&|p| matches!(p, Part::Steel(_))),
        has(&|p| matches!(p, Part::Concrete { .. })),
        has(&|p| matches!(p, Part::Bar(_))),
    );
    let mut out = Look {
        utilisation: room(steel),
        plastic_strain: room(steel),
        compression: room(concrete),
        bar_stress: room(bars),
        bar_plastic_strain: room(bars),
        crack_width: [room(concrete), room(concrete)],
        ..Look::default()
    };
    let mut gather = Gather::default();
    for (row, elements) in tank.wall.rows.iter().enumerate() {
        let parts = &tank.rows[row].parts;
        let faces = faces(parts);
        for (column, &e) in elements.iter().enumerate() {
            let cell = row * tank.cells.columns() + column;
            let element = &*tank.model.elements()[e];
            let motion = gather.motion(&tank.model, &state.committed, element);
            // Widest cracks of each face: of the point where they are widest.
            let mut widest: [Option<[Option<Crack>; 2]>; 2] = [None, None];
            element.material_points(motion, &state.old[state.history(e)], &mut |p| {
                let leaf = p.point / 4;
                let Some(part) = parts.get(leaf).and_then(|l| l.get(p.layer)) else { return };
                out.see(cell, part, p);
                if let Part::Concrete { band, .. } = part {
                    let strains = p.state.cracks.iter().flatten().map(|c| c.largest);
                    out.crack_strain = strains.fold(out.crack_strain, f64::max);
                    for (face, place) in faces.iter().enumerate() {
                        if *place == Some((leaf, p.layer)) {
                            let own = cracks(cell, *band, p);
                            let size =
                                |c: &[Option<Crack>; 2]| c.iter().flatten().map(|c| c.largest).fold(0.0, f64::max);
                            if widest[face].is_none_or(|w| size(&own) > size(&w)) {
                                widest[face] = Some(own);
                            }
                        }
                    }
                }
            });
            for (face, found) in widest.into_iter().enumerate() {
                for crack in found.into_iter().flatten().flatten() {
                    let width = &mut out.crack_width[face][cell];
                    *width = width.max(crack.largest);
                    out.cracks[face].push(crack);
                }
            }
        }
    }
    out
}

/// Leaf and layer of the concrete next to the inner and to the outer face.
fn faces(parts: &[Vec<Part>]) -> [Option<(usize, usize)>; 2] {
    let mut all = parts.iter().enumerate().flat_map(|(leaf, list)| {
        let of = move |(layer, part): (usize, &Part)| matches!(part, Part::Concrete { .. }).then_some((leaf, layer));
        list.iter().enumerate().filter_map(of)
    });
    let first = all.next();
    [first, all.last().or(first)]
}

/// Cracks of a point as a picture shows them.
fn cracks(cell: usize, band: [f64; 2], p: &Inspection) -> [Option<Crack>; 2] {
    p.state.cracks.map(|c| {
        c.map(|c| Crack {
            cell,
            // Along the crack, not along its normal.
            angle: c.angle + std::f64::consts::FRAC_PI_2,
            width: crack_band(band, c.angle) * c.opening,
            largest: crack_band(band, c.angle) * c.largest,
        })
    })
}

impl Look {
    fn see(&mut self, cell: usize, part: &Part, p: &Inspection) {
        let raise = |list: &mut Vec<f64>, value: f64| {
            if let Some(own) = list.get_mut(cell) {
                *own = own.max(value);
            }
        };
        let [a, b, c] = p.stress;
        match part {
            Part::Elastic => {}
            Part::Steel(strength) => {
                raise(&mut self.utilisation, p.state.utilisation);
                raise(&mut self.plastic_strain, p.state.plastic_strain);
                let equivalent = (a * a + b * b - a * b + 3.0 * c * c).sqrt();
                if strength.is_some_and(|s| equivalent > s) && self.torn.last() != Some(&cell) {
                    self.torn.push(cell);
                }
            }
            Part::Concrete { strength, .. } => {
                let lowest = 0.5 * (a + b) - (0.25 * (a - b) * (a - b) + c * c).sqrt();
                raise(&mut self.compression, -lowest / strength);
            }
            Part::Bar(rupture) => {
                raise(&mut self.bar_stress, a.abs());
                raise(&mut self.bar_plastic_strain, p.state.plastic_strain);
                if rupture.is_some_and(|r| p.strain[0].abs() > r) && self.ruptured.last() != Some(&cell) {
                    self.ruptured.push(cell);
                }
            }
        }
    }

    /// Takes in the larger of every value; cracks are those of the later look.
    pub(crate) fn envelop(&mut self, later: &Look) {
        let raise = |to: &mut Vec<f64>, from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(t, f)| *t = t.max(*f));
        };
        raise(&mut self.utilisation, &later.utilisation);
        raise(&mut self.plastic_strain, &later.plastic_strain);
        raise(&mut self.compression, &later.compression);
        raise(&mut self.bar_stress, &later.bar_stress);
        raise(&mut self.bar_plastic_strain, &later.bar_plastic_strain);
        for face in 0..2 {
            raise(&mut self.crack_width[face], &later.crack_width[face]);
        }
        self.cracks.clone_from(&later.cracks);
        self.crack_strain = self.crack_strain.max(later.crack_strain);
    }

    /// Events so far, each with its worst cell.
    pub(crate) fn happenings(&self) -> Vec<(Happening, usize)> {
        let worst = |list: &[f64], least: f64| {
            let largest = (0..list.len()).max_by(|&i, &j| list[i].total_cmp(&list[j]));
            largest.filter(|&i| list[i] > least)
        };
        let found = [
            (Happening::Crack, worst(&self.crack_width[0], 0.0).or(worst(&self.crack_width[1], 0.0))),
            (Happening::Yield, worst(&self.plastic_strain, YIELDS)),
            (Happening::BarYield, worst(&self.bar_plastic_strain, YIELDS)),
            (Happening::Crushing, worst(&self.compression, CRUSHES)),
            (Happening::Tears, self.torn.first().copied()),
            (Happening::BarRupture, self.ruptured.first().copied()),
        ];
        found.into_iter().filter_map(|(what, cell)| Some((what, cell?))).collect()
    }
}
