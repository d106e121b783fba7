//! A wall in the model of a strip.

use std::ops::Range;

use fem::analysis::observable::Observable;
use fem::dofs::Dof;
use fem::element::spring::{Direction, PointMass, Spring};
use fem::model::Builder;

use super::parameters::{StripError, StripTank};
use super::shells::{self, Nodes};

/// Group of the beams or shells.
pub(super) const WALL: &str = "wall";

/// A wall. Its unknowns are in its own axes, x outwards: the wall at −L is modelled as one at +L.
pub struct PlacedWall {
    /// Its nodes upwards; of shells one a level, on the leaf that bends.
    pub nodes: Vec<usize>,
    /// Nodes of the wet face, all of each level, upwards.
    pub(super) wet: Vec<Vec<usize>>,
    /// Nodes at the base of wall and liquid.
    pub(super) feet: Vec<usize>,
    /// Numbers of its elements in the model, from the bottom.
    pub(super) elements: Range<usize>,
    /// Numbers of all of its nodes.
    pub(super) owned: Range<usize>,
    /// Component of its outward axis along x of the tank.
    pub sign: f64,
    /// Reactions of the linear strip at the base, along [`BASE`](super::parts::BASE); known once the model is built.
    pub(super) base: [Observable; 3],
    /// What they have of a unit acceleration of the ground, along the wall's own axes.
    pub(super) carried: [[f64; 3]; 3],
}

impl PlacedWall {
    /// Adds wall, carried masses and base.
    ///
    /// Errors: those of the elements.
    pub(super) fn add_to(builder: &mut Builder, tank: &StripTank, sign: f64) -> Result<PlacedWall, StripError> {
        let [node, first] = builder.counts();
        let Nodes { axis, wet, leaf, feet } = shells::place(builder, tank, WALL)?;
        carry(builder, tank, &leaf)?;
        Ok(PlacedWall {
            nodes: axis,
            wet,
            feet,
            elements: first..first + tank.sections.len(),
            owned: node..builder.counts()[0],
            sign,
            base: Default::default(),
            carried: Default::default(),
        })
    }

    /// Clamps the foot, or puts it on its spring.
    ///
    /// Errors: a stiffness that is not positive.
    pub(super) fn stand(&self, builder: &mut Builder, tank: &StripTank) -> Result<(), StripError> {
        let foot = self.nodes[0];
        let Some(stiffness) = tank.base_spring else {
            builder.hold(foot, Dof::Ry);
            return Ok(());
        };
        builder.hold(foot, Dof::Rx);
        builder.hold(foot, Dof::Rz);
        builder.element("base", Spring::to_ground(foot, Direction::Rotation([0.0, 1.0, 0.0]), stiffness)?);
        Ok(())
    }

    /// Acceleration of the ground in the wall's own axes.
    pub(super) fn own(&self, ground: [f64; 3]) -> [f64; 3] {
        [self.sign * ground[0], ground[1], ground[2]]
    }
}

/// Adds the masses that the wall carries, each to the two levels next to it in the shares that hold its moment.
///
/// Errors: a negative mass.
fn carry(builder: &mut Builder, tank: &StripTank, leaf: &[Vec<usize>]) -> Result<(), StripError> {
    for &(mass, height) in &tank.carried {
        let upper = tank.levels.partition_point(|z| *z < height).clamp(1, leaf.len() - 1);
        let (below, above) = (tank.levels[upper - 1], tank.levels[upper]);
        let share = (height - below) / (above - below);
        for (level, part) in [(upper - 1, 1.0 - share), (upper, share)].into_iter().filter(|(_, part)| *part != 0.0) {
            for &node in &leaf[level] {
                builder.element(WALL, PointMass::new(node, mass * part / leaf[level].len() as f64)?);
            }
        }
    }
    Ok(())
}
