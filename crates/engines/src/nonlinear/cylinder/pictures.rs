//! States of wall and bottom for pictures.

use fem::analysis::AnalysisError;
use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::analysis::march::Instant;
use fem::dofs::Dof;
use fem::element::Inspect;
use fem::state::Gather;
use results::{Resultants, Snapshot, Snapshots};

use super::model::CylinderModel;

/// Integration points of a cell of one shell.
const POINTS: f64 = 4.0;
/// Numbers of [`Resultants`].
const RESULTANTS: usize = 7;

/// Keeps states at intervals. Half a tank gives half a picture.
pub(crate) struct Pictures<'a> {
    tank: &'a CylinderModel,
    /// Time between two states [s].
    every: f64,
    /// Time of the next one [s].
    next: f64,
    /// Mesh and states so far.
    pub states: Snapshots,
}

impl<'a> Pictures<'a> {
    /// Every so many seconds, from the state at rest on.
    pub(super) fn new(tank: &'a CylinderModel, every: f64) -> Pictures<'a> {
        let (standing, columns) = (tank.standing.as_ref(), tank.cells.columns());
        Pictures {
            tank,
            every,
            next: 0.0,
            states: Snapshots {
                nodes: tank.model.nodes().to_vec(),
                wall: tank.footprint.cells.iter().map(|c| tank.wall.inner_cell(*c)).collect(),
                thickness: tank
                    .footprint
                    .cells
                    .iter()
                    .enumerate()
                    .map(|(k, _)| tank.rows[k / columns].thickness)
                    .collect(),
                bottom: standing.map_or_else(Vec::new, |s| s.quadrilaterals(tank)),
                whole: true,
                half: tank.cells.half,
                ..Snapshots::default()
            },
        }
    }

    /// Looks at a sample of the record.
    ///
    /// Errors: a section that fails.
    pub(super) fn see(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        if now.time < self.next * (1.0 - 1e-9) {
            return Ok(());
        }
        while self.next <= now.time * (1.0 + 1e-9) {
            self.next += self.every;
        }
        let model = &self.tank.model;
        let displacement: Vec<[f64; 3]> = (0..model.nodes().len())
            .map(|node| {
                let u = model.at_node(&now.state.committed.u, node);
                [Dof::Ux, Dof::Uy, Dof::Uz].map(|d| u[d.index()])
            })
            .collect();
        let (ground, plastic) = match &self.tank.standing {
            Some(standing) => (self.pressures(&displacement), standing.plastic_by_cell(self.tank, now.state)?),
            None => (Vec::new(), Vec::new()),
        };
        let resultants = self.resultants(now)?;
        self.states.states.push(Snapshot {
            time: now.time,
            displacement,
            resultants,
            ground,
            plastic,
            ..Snapshot::default()
        });
        Ok(())
    }

    /// Pressure of the ground by node, 0 of those that are not of the bottom.
    fn pressures(&self, displacement: &[[f64; 3]]) -> Vec<f64> {
        let mut out = vec![0.0; displacement.len()];
        let Some(standing) = &self.tank.standing else { return out };
        for &node in self.states.bottom.iter().flatten() {
            out[node] = standing.pressure(displacement[node][2]);
        }
        out
    }

    /// Means over the points of each shell, sums over the shells, cell by cell.
    fn resultants(&self, now: &Instant<'_>) -> Result<Vec<Resultants>, AnalysisError> {
        let (model, mut gather) = (&self.tank.model, Gather::default());
        let columns = self.tank.cells.columns();
        let mut out = vec![Resultants::default(); self.states.wall.len()];
        for (row, elements) in self.tank.wall.rows.iter().enumerate() {
            for (column, &e) in elements.iter().enumerate() {
                let element = &*model.elements()[e];
                let motion = gather.motion(model, &now.state.committed, element);
                let states = element
                    .sections(motion, &now.state.old[now.state.history(e)])
                    .map_err(|source| AnalysisError::Element { number: e, source })?;
                let mean = |i: usize| states.iter().map(|s| s.resultants[i]).sum::<f64>() / POINTS;
                if let Some(to) = out.get_mut(row * columns + column) {
                    *to = Resultants {
                        n_phi: mean(0),
                        n_v: mean(1),
                        n_phi_v: mean(2),
                        m_phi: mean(3),
                        m_v: mean(4),
                        m_phi_v: mean(5),
                        q_v: mean(7),
                    };
                }
            }
        }
        Ok(out)
    }

    /// Stores the states.
    pub(super) fn save(&self, to: &mut Writer) {
        to.number(self.next);
        to.count(self.states.states.len());
        for state in &self.states.states {
            to.number(state.time);
            to.numbers(state.displacement.as_flattened());
            let all = state.resultants.iter();
            let numbers: Vec<f64> =
                all.flat_map(|r| [r.n_phi, r.n_v, r.n_phi_v, r.m_phi, r.m_v, r.m_phi_v, r.q_v]).collect();
            to.numbers(&numbers);
            to.numbers(&state.ground);
            to.numbers(&state.plastic);
        }
    }

    /// Reads them back.
    ///
    /// Errors: a file that ends.
    pub(super) fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.next = from.number()?;
        self.states.states.clear();
        for _ in 0..from.count()? {
            let time = from.number()?;
            let displacement = from.numbers("displacements of a picture")?;
            let resultants = from.numbers("resultants of a picture")?;
            self.states.states.push(Snapshot {
                time,
                displacement: displacement.as_chunks::<3>().0.to_vec(),
                resultants: resultants.as_chunks::<RESULTANTS>().0.iter().map(of_numbers).collect(),
                ground: from.numbers("pressures of a picture")?,
                plastic: from.numbers("rotations of a picture")?,
                ..Snapshot::default()
            });
        }
        Ok(())
    }
}

fn of_numbers(&[n_phi, n_v, n_phi_v, m_phi, m_v, m_phi_v, q_v]: &[f64; RESULTANTS]) -> Resultants {
    Resultants { n_phi, n_v, n_phi_v, m_phi, m_v, m_phi_v, q_v }
}
