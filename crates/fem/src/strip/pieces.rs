//! Joints of a wall of shells: pieces between two levels whose closed part is cut, instead of one joint at each level.

use super::contact::{JOINT, Touch};
use super::{StripError, StripTank};
use crate::dofs::Dof;
use crate::element::liquid_joint::JointPoint;
use crate::element::liquid_joint::clipped::ClippedJoint;
use crate::model::{Builder, Model};
use crate::state::{Gather, State};

/// A piece.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Number of the element in the model.
    element: usize,
    joint: ClippedJoint,
    /// Its lower level.
    level: usize,
    /// Share of the upper level in the upper end: 1, or less where the surface stands between the levels.
    upper: f64,
}

/// Adds pieces between the nodes of the wall at each level, of the face and of the amplitudes; `relief`: ρ g u_z of each amplitude at a
/// height [Pa/m].
///
/// Errors: a penalty that is not positive.
pub(super) fn add(
    builder: &mut Builder,
    tank: &StripTank,
    wall: &[Vec<usize>],
    [face, amplitudes]: [&[usize]; 2],
    penalty: f64,
    relief: impl Fn(usize, f64) -> f64,
) -> Result<Vec<Piece>, StripError> {
    let mut out = Vec::new();
    for level in 0..face.len() - 1 {
        let (from, to) = (tank.levels[level], tank.levels[level + 1]);
        let wet = to.min(tank.liquid.depth) - from;
        let upper = wet / (to - from);
        // Unknowns: both nodes of the face, the wall's at both levels, amplitudes; e of both levels as rows over them.
        let mut unknowns = vec![(face[level], Dof::Ux), (face[level + 1], Dof::Ux)];
        let mut rows = [vec![(0, 1.0)], vec![(1, 1.0)]];
        for (row, nodes) in rows.iter_mut().zip(&wall[level..=level + 1]) {
            for &node in nodes {
                row.push((unknowns.len(), -1.0 / nodes.len() as f64));
                unknowns.push((node, Dof::Ux));
            }
        }
        let first = unknowns.len();
        unknowns.extend(amplitudes.iter().map(|&n| (n, Dof::Amplitude)));
        let end = |share: f64, z: f64| {
            let of = |row: &[(usize, f64)], factor: f64| -> Vec<(usize, f64)> {
                row.iter().map(|&(i, c)| (i, factor * c)).collect()
            };
            let mut closing = of(&rows[0], 1.0 - share);
            closing.extend(of(&rows[1], share));
            closing.retain(|&(_, c)| c != 0.0);
            JointPoint {
                closing,
                relief: (0..amplitudes.len()).map(|n| (first + n, -relief(n, z))).collect(),
                stiffness: penalty,
            }
        };
        let joint = ClippedJoint::new(&unknowns, [end(0.0, from), end(upper, from + wet)], wet)?;
        out.push(Piece {
            element: builder.element(JOINT, joint.clone()),
            joint,
            level,
            upper,
        });
    }
    Ok(out)
}

/// States at the levels above the base, whose lengths of wall are `shares` [m].
pub(super) fn look(pieces: &[Piece], shares: &[f64], model: &Model, state: &State) -> Vec<Touch> {
    let mut gather = Gather::default();
    let none = Touch {
        pressure: 0.0,
        gap: 0.0,
        penetration: 0.0,
    };
    let mut out = vec![none; shares.len()];
    for piece in pieces {
        let motion = gather.motion(model, &state.committed, &piece.joint);
        let [low, high] = piece
            .joint
            .look(motion.values, &state.old[state.history(piece.element)]);
        let own = &mut out[piece.level];
        own.pressure += piece.upper * high.force / shares[piece.level];
        own.gap = high.gap;
        own.penetration = high.closing.max(0.0);
        // The base has no entry: its force goes into the ground.
        if piece.level > 0 {
            let below = low.force + (1.0 - piece.upper) * high.force;
            out[piece.level - 1].pressure += below / shares[piece.level - 1];
        }
    }
    out
}
