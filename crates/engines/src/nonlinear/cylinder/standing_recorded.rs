//! What a run records of the bottom: forces, motion and plastic rotations of the foot, anchors.

use std::f64::consts::PI;

use fem::analysis::AnalysisError;
use fem::analysis::march::{Quantity, Reaction};
use fem::dofs::{Dof, KINDS};
use fem::state::{Gather, State};

use super::model::CylinderModel;
use super::recorded::row;
use super::standing::{Holds, Standing};
use crate::nonlinear::arcs::{cosine_shares, shares};
use crate::nonlinear::bottom;

/// An anchor of the foot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Pulled {
    /// Its force [N].
    pub force: f64,
    /// Its plastic elongation [m].
    pub plastic: f64,
    /// Height of the foot there [m].
    pub height: f64,
    /// Where [rad].
    pub angle: f64,
}

impl Standing {
    /// See [`super::recorded::base_reaction`]; along x.
    pub(super) fn reaction(&self, tank: &CylinderModel, name: &str, moment: bool) -> Result<Quantity, AnalysisError> {
        let copies = tank.cells.copies();
        let held = self.placed.rings.last().filter(|_| moment || !self.slides());
        let field = |node: usize| {
            let mut field = [0.0; KINDS];
            if held.is_some_and(|ring| ring.contains(&node)) {
                field[if moment { Dof::Ry } else { Dof::Ux }.index()] = copies;
            }
            field
        };
        let reaction = Reaction::new(tank.problem(), name, field, |e| tank.rayleigh[tank.model.group_of(e)])?;
        let ground = match moment {
            false => match &self.holds {
                Holds::Key(element, along) => vec![(*element, along.iter().map(|w| copies * w).collect())],
                Holds::Friction(disc) => {
                    let all = self.placed.ground.iter().flatten().chain([disc]);
                    all.map(|&e| (e, vec![copies, 0.0, 0.0])).collect()
                }
            },
            true => {
                let rings = self.placed.ground.iter().zip(&self.radii);
                let floor = self.floor.iter().map(|share| {
                    let mut force = vec![0.0; share.size];
                    for &(place, ring) in &share.places {
                        force[place] = -copies * self.radii[ring] * share.angle.cos();
                    }
                    (share.element, force)
                });
                let lever = |angle: &f64| self.radii[self.foot] * angle.cos();
                let foot = self.anchors.iter().zip(&self.angles);
                let foot = foot.map(|((e, _), angle)| (*e, vec![0.0, 0.0, -copies * lever(angle)]));
                let at = |(ring, radius): (&Vec<usize>, &f64)| -> Vec<(usize, Vec<f64>)> {
                    let nodes = ring.iter().zip(&self.angles);
                    nodes.map(|(&e, angle)| (e, vec![0.0, 0.0, -copies * radius * angle.cos()])).collect()
                };
                rings.flat_map(at).chain(floor).chain(foot).collect()
            }
        };
        Ok(Quantity::Reaction(reaction.with_ground(ground)))
    }

    /// Heights of the foot at θ = 0 and π, its rotation about y, positive where θ = 0 goes down [rad], and its mean displacement along x [m].
    pub(super) fn rows(&self, tank: &CylinderModel) -> [Quantity; 4] {
        let (model, foot) = (&tank.model, self.foot());
        let up = |node: usize, factor: f64| {
            let own = model.row(node, Dof::Uz).into_iter();
            own.map(move |(e, c)| (e, factor * c))
        };
        let tilt = foot.iter().zip(cosine_shares(&self.angles));
        let turn = tilt.flat_map(|(n, c)| up(*n, -2.0 * c / (PI * tank.radius)));
        let slip = foot.iter().zip(shares(&self.angles)).flat_map(|(&node, share)| {
            let own = model.row(node, Dof::Ux).into_iter();
            own.map(move |(e, c)| (e, c * share / PI))
        });
        [
            row("uplift at θ = 0°", up(foot[0], 1.0).collect()),
            row("uplift at θ = 180°", up(foot[foot.len() - 1], 1.0).collect()),
            row("rotation of the base", turn.collect()),
            row("slip", slip.collect()),
        ]
    }

    /// Cells of the plate, ring after ring from the outside inwards, as nodes.
    pub(super) fn quadrilaterals(&self, tank: &CylinderModel) -> Vec<[usize; 4]> {
        let nodes = |e: &usize| -> Option<[usize; 4]> { tank.model.elements()[*e].nodes().try_into().ok() };
        self.placed.cells.iter().flatten().filter_map(nodes).collect()
    }

    /// Plastic rotation across every cell along the radius, in the order of [`Standing::quadrilaterals`] [rad].
    ///
    /// Errors: a section that fails.
    pub(super) fn plastic_by_cell(&self, tank: &CylinderModel, state: &State) -> Result<Vec<f64>, AnalysisError> {
        let cells = self.placed.cells.iter().flatten();
        let part = |cell: &usize| bottom::hinge::plastic_part(&tank.model, *cell, self.placed.soft(*cell), state);
        cells.map(|cell| Ok(part(cell)?.unwrap_or(0.0))).collect()
    }

    /// The anchor that pulls most; none without anchors.
    pub(super) fn pulled(&self, tank: &CylinderModel, state: &State) -> Option<Pulled> {
        let mut gather = Gather::default();
        let all = self.anchors.iter().zip(&self.bolts).zip(&self.angles);
        let each = all.map(|(((e, anchor), number), angle)| {
            let motion = gather.motion(&tank.model, &state.committed, anchor);
            let height = motion.values[2];
            let seen = anchor.look(motion.values, &state.old[state.history(*e)]);
            Pulled { force: seen.force / number, plastic: seen.plastic, height, angle: *angle }
        });
        each.max_by(|a, b| a.force.total_cmp(&b.force).then(a.height.total_cmp(&b.height)))
    }

    /// Plastic rotations of the joints at θ = 0 and π, of plate and wall together, positive where the plate lifts [rad].
    ///
    /// Errors: a section that fails.
    pub(super) fn plastic(&self, tank: &CylinderModel, state: &State) -> Result<[f64; 2], AnalysisError> {
        let [front, back] = self.plastic_parts(tank, state)?;
        Ok([front, back].map(|[plate, wall]| plate + wall))
    }

    /// The parts of the plate and of the wall, on both sides [rad].
    ///
    /// Errors: a section that fails.
    pub(super) fn plastic_parts(&self, tank: &CylinderModel, state: &State) -> Result<[[f64; 2]; 2], AnalysisError> {
        let at = |back: bool| -> Result<[f64; 2], AnalysisError> {
            let plate = bottom::hinge::plastic_rotation(&tank.model, &self.placed, self.foot, back, state)?;
            let column = self.wall[usize::from(back)].iter().copied();
            Ok([plate, bottom::hinge::wall_rotation(&tank.model, column, state)?])
        };
        Ok([at(false)?, at(true)?])
    }
}
