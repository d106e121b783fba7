//! The quantities recorded at every step, and their numbers.

use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::analysis::march::{Quantity, Reaction};
use fem::analysis::observable::Observable;
use fem::dofs::{Dof, KINDS};

use super::model::CylinderModel;

/// Numbers of the recorded quantities.
pub(super) const BASE_SHEAR: usize = 0;
/// Moment about the y axis at the base.
pub(super) const BASE_MOMENT: usize = 1;
/// Elevation of the surface at the wall, θ = 0.
pub(super) const WAVE_FRONT: usize = 2;
/// The same at θ = π.
pub(super) const WAVE_BACK: usize = 3;
/// Radial displacement of the top of the wall, θ = 0.
pub(super) const TOP_FRONT: usize = 4;
/// Displacement along x of the wall's node that bulges most in the static state.
pub(super) const BELLY_FRONT: usize = 5;

/// [`TOP_FRONT`] and [`BELLY_FRONT`] at θ = π, outwards.
pub(super) const TOP_BACK: usize = 6;
/// See [`TOP_BACK`].
pub(super) const BELLY_BACK: usize = 7;

/// Height of the foot over the ground at θ = 0 and θ = π, and rotation of the foot; only of an unanchored wall, which has no [`super::two`].
pub(super) const UPLIFT_FRONT: usize = 8;
/// See [`UPLIFT_FRONT`].
pub(super) const UPLIFT_BACK: usize = 9;
/// See [`UPLIFT_FRONT`].
pub(super) const BASE_ROTATION: usize = 10;
/// Mean displacement of the foot along x; see [`UPLIFT_FRONT`].
pub(super) const SLIP: usize = 11;

/// Force of the base on the ground against motion along the `axis` x (0) or y (1), or the `moment` of that motion; that of half a tank
/// doubled.
///
/// Errors: those of the elements.
pub(super) fn base_reaction(
    tank: &CylinderModel,
    name: &str,
    axis: usize,
    moment: bool,
) -> Result<Quantity, AnalysisError> {
    if let Some(standing) = &tank.standing {
        return standing.reaction(tank, name, moment);
    }
    let base: Vec<usize> = tank.footprint.levels[0]
        .iter()
        .flat_map(|&p| [Some(&tank.wall.inner), Some(&tank.wall.outer)].map(|l| l.and_then(|l| l.get(p)).copied()))
        .flatten()
        // The force of the liquid at the base of the wall goes into the ground there.
        .chain(tank.wetted[..tank.footprint.levels[0].len()].iter().copied())
        .collect();
    let (copies, nodes) = (tank.cells.copies(), tank.model.nodes());
    let field = |node: usize| {
        let mut field = [0.0; KINDS];
        if !base.contains(&node) {
            return field;
        }
        match (moment, axis) {
            (false, 0) => field[Dof::Ux.index()] = copies,
            (false, _) => field[Dof::Uy.index()] = copies,
            // The rotation that moves what is above the base along the axis.
            (true, 0) => {
                field[Dof::Uz.index()] = -copies * nodes[node][0];
                field[Dof::Ry.index()] = copies;
            }
            (true, _) => {
                field[Dof::Uz.index()] = -copies * nodes[node][1];
                field[Dof::Rx.index()] = -copies;
            }
        }
        field
    };
    let rayleigh = |e: usize| -> Rayleigh { tank.rayleigh[tank.model.group_of(e)] };
    let reaction = Reaction::new(tank.problem(), name, field, rayleigh)?;
    Ok(Quantity::Reaction(match &tank.slab {
        Some(slab) => slab.carry(reaction, tank, (axis, moment)),
        None => reaction,
    }))
}

/// A linear functional of the displacements.
pub(super) fn row(name: &str, row: Vec<(usize, f64)>) -> Quantity {
    Quantity::Linear(Observable { name: name.into(), displacement: row, ..Observable::default() })
}

/// Recorded quantities, those of half a tank doubled where they are sums.
pub(super) fn quantities(tank: &CylinderModel) -> Result<Vec<Quantity>, AnalysisError> {
    let levels = &tank.footprint.levels;
    let at = |level: usize| tank.wall.inner[levels[level][0]];
    let belly = levels.len() / 3;
    // Half a wall has its last meridian at θ = π, a whole one its middle one.
    let back = |level: usize| -> Vec<(usize, f64)> {
        let around = &levels[level];
        let opposite = if tank.cells.half { around.len() - 1 } else { around.len() / 2 };
        let row = tank.model.row(tank.wall.inner[around[opposite]], Dof::Ux);
        row.into_iter().map(|(e, c)| (e, -c)).collect()
    };
    let mut all = vec![
        base_reaction(tank, "base shear", 0, false)?,
        base_reaction(tank, "base moment", 0, true)?,
        row("wave at θ = 0°", tank.elevation(0.0)),
        row("wave at θ = 180°", tank.elevation(std::f64::consts::PI)),
        row("top of the wall", tank.model.row(at(levels.len() - 1), Dof::Ux)),
        row("lower third of the wall", tank.model.row(at(belly), Dof::Ux)),
        row("top of the wall, θ = 180°", back(levels.len() - 1)),
        row("lower third of the wall, θ = 180°", back(belly)),
    ];
    if let Some(standing) = &tank.standing {
        all.extend(standing.rows(tank));
    }
    Ok(all)
}
