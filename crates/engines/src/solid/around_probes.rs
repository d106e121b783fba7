//! Probes of an imperfect wall around the tank.

use fem::dofs::Dof;
use results::Channel;

use super::project::Projector;
use super::rows::Row;
use crate::FeError;
use crate::probe::Probe;

/// Harmonics that are always reported, from 0.
const REPORTED: u32 = 8;
/// Most levels at which a harmonic is observed.
const LEVELS: usize = 24;

/// What a probe observes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum What {
    /// Radial displacement of a harmonic at a height [m].
    Displacement {
        /// n.
        n: u32,
        /// z.
        z: f64,
    },
    /// Axial membrane stress of a harmonic at the base.
    Stress {
        /// n.
        n: u32,
    },
    /// Axial membrane stress at the base, at an angle [rad].
    Base {
        /// θ.
        theta: f64,
    },
}

/// The probes of one direction of ground motion.
///
/// Errors: an element without stiffness.
pub(super) fn probes(projector: &Projector<'_>) -> Result<Vec<(What, Probe)>, FeError> {
    let tank = projector.tank;
    let sectors = tank.division.sectors;
    let waves = tank.imperfections.waves(tank.height());
    let most = waves.last().map_or(0, |n| n + 1).max(REPORTED).min((sectors / 2) as u32 - 1);
    let twins = !tank.imperfections.is_symmetric(tank.height());
    let angle = |s: usize| std::f64::consts::TAU * s as f64 / sectors as f64;
    let weights = |n: u32, sine: bool| -> Vec<f64> {
        let factor = if n == 0 { 1.0 } else { 2.0 } / sectors as f64;
        let of = |s: usize| {
            let (s, c) = (f64::from(n) * angle(s)).sin_cos();
            factor * if sine { s } else { c }
        };
        (0..sectors).map(of).collect()
    };
    let probe = |row: &Row| projector.projected(Probe::new(Channel::Top), row);
    let mut out = Vec::new();
    let step = tank.wall.z.len().div_ceil(LEVELS);
    let levels = (1..tank.wall.z.len()).filter(|l| l % step == 0 || l + 1 == tank.wall.z.len());
    for level in levels {
        for n in 0..=most {
            for sine in [false, true].into_iter().filter(|sine| twins || !sine) {
                let mut row = Row::default();
                for (s, weight) in weights(n, sine).into_iter().enumerate() {
                    let (sine, cosine) = angle(s).sin_cos();
                    for (dof, direction) in [(Dof::Ux, cosine), (Dof::Uy, sine)] {
                        let own = tank.model.row(tank.wall.rows[level][s], dof);
                        row.displacement.extend(own.into_iter().map(|(e, c)| (e, weight * direction * c)));
                    }
                }
                let z = tank.wall.z[level];
                out.push((What::Displacement { n, z }, probe(&row)));
            }
        }
    }
    let thickness = tank.wall.thickness[0];
    let edges = (0..sectors)
        .map(|s| Ok(projector.observer.edge_reaction_at(s, Dof::Uz)?.scaled(-1.0 / thickness)))
        .collect::<Result<Vec<Row>, FeError>>()?;
    for n in 0..=most {
        for sine in [false, true].into_iter().filter(|sine| twins || !sine) {
            let mut row = Row::default();
            for (edge, weight) in edges.iter().zip(weights(n, sine)) {
                let part = edge.clone().scaled(weight);
                row.displacement.extend(part.displacement);
                row.acceleration.extend(part.acceleration);
                row.held += part.held;
            }
            out.push((What::Stress { n }, probe(&row)));
        }
    }
    out.extend(edges.iter().enumerate().map(|(s, row)| {
        let theta = angle(s);
        (What::Base { theta }, probe(row))
    }));
    Ok(out)
}
