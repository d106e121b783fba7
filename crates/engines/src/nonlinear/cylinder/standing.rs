//! The wall of an unanchored tank on its bottom: plates on ground that pushes but does not pull, as in a pushover.
//!
//! ```text
//! rest      weight, ρ g (H − z) on the wall and ρ g H on the plate, in load steps
//! motion    the liquid's pressure on the wall; on the plate it stays ρ g H (with vertical motion times 1 + a_v/g)
//! no slip   ∫ (u_r cos θ − u_θ sin θ) dθ = 0 at the foot; in its plane the plate moves on the ground without friction
//! base      V = held ring and foot ,  M = Σ r x of the ground
//! ```

use std::f64::consts::PI;

use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::analysis::march::{Quantity, Reaction};
use fem::dofs::{Dof, KINDS};
use fem::element::ElementError;
use fem::element::shell::load::NodalLoads;
use fem::element::wall::place::{PlacedWall, WallMesh};
use fem::model::Builder;
use fem::state::State;
use tank::options::nonlinear::{Contact, NonlinearOptions};
use tank::{Case, LayerKind, Support};

use super::model::CylinderModel;
use super::recorded::row;
use crate::FeError;
use crate::error::failed;
use crate::nonlinear::arcs::cosine_shares;
use crate::nonlinear::bottom::{self, Placed, Plate};

/// Stiffness that holds the foot over E t of the lowest course: so stiff that it moves by less than 10⁻³ of what the wall does.
const HELD: f64 = 1e3;

/// The bottom of a model.
pub(crate) struct Standing {
    placed: Placed,
    angles: Vec<f64>,
    radii: Vec<f64>,
    foot: usize,
    /// What keeps the foot in place, with the weights of its force along x.
    key: (usize, Vec<f64>),
}

/// Whether the history of a case has its bottom: unanchored, with a bottom plate of steel under half a wall of one shell that stays in
/// contact with the liquid.
pub(super) fn stands(case: &Case, options: &NonlinearOptions) -> bool {
    let one = |c: &tank::Course| c.build_up().iter().filter(|l| l.kind == LayerKind::Shell).count() == 1;
    case.tank.support == Support::Unanchored
        && bottom::missing(case).is_none()
        && options.symmetry
        && options.contact == Contact::Bonded
        && options.imperfections.is_empty()
        && case.tank.courses.iter().all(one)
}

/// Rings of cells of the bottom; none under a wall whose foot is clamped.
pub(super) fn rings(case: &Case, options: &NonlinearOptions) -> usize {
    let found = plate(case, options, case.tank.shape.half_length());
    found
        .ok()
        .flatten()
        .map_or(0, |plate| plate.radii.len().saturating_sub(1))
}

/// The plate of a case, `None` of a wall whose foot is clamped.
///
/// Errors: those of [`Plate::of`].
pub(super) fn plate(case: &Case, options: &NonlinearOptions, radius: f64) -> Result<Option<Plate>, FeError> {
    stands(case, options)
        .then(|| Plate::of(case, radius, options.bottom_mesh))
        .transpose()
}

impl Standing {
    /// Places the wall and the plate that is welded to it.
    ///
    /// Errors: those of the shells.
    pub(super) fn weld(
        plate: &Plate,
        case: &Case,
        builder: &mut Builder,
        mesh: &WallMesh<'_>,
        options: &NonlinearOptions,
    ) -> Result<(PlacedWall, Standing), FeError> {
        let foot = &mesh.footprint.levels[0];
        let columns = foot.len() - 1;
        let angles: Vec<f64> = (0..=columns).map(|k| PI * k as f64 / columns as f64).collect();
        let (mut rings, mut bending) = (Vec::new(), Vec::new());
        let refused = |e: FeError| ElementError::NoAnswer {
            kind: "bottom",
            reason: e.to_string(),
        };
        let mut more = |builder: &mut Builder, wall: &[usize]| {
            let own: Vec<usize> = foot.iter().map(|p| wall[*p]).collect();
            rings = plate.nodes(builder, &angles, &own);
            let Some(bottom) = &case.tank.bottom else {
                return Ok(Vec::new());
            };
            let (cells, soft) = plate.cells(bottom, &rings, &options.integration).map_err(refused)?;
            bending = soft;
            Ok(cells)
        };
        let (wall, cells) = mesh.place_with(builder, &mut more).map_err(failed)?;
        let placed = Placed {
            cells: cells.chunks(columns).map(<[usize]>::to_vec).collect(),
            rings,
            bending,
            ground: Vec::new(),
            rest: Vec::new(),
        };
        let standing = Standing {
            placed,
            angles,
            radii: plate.radii.clone(),
            foot: plate.foot,
            key: (0, Vec::new()),
        };
        Ok((wall, standing))
    }

    /// Adds the ground, the pressure at rest and the supports.
    ///
    /// Errors: those of the elements.
    pub(super) fn found(
        &mut self,
        plate: &Plate,
        case: &Case,
        builder: &mut Builder,
        options: &NonlinearOptions,
        pressure: &mut NodalLoads,
    ) -> Result<(), FeError> {
        let rings = &self.placed.rings;
        let kinds = [options.follower_pressure, false];
        self.placed.ground = plate.place(builder, &self.angles, rings, kinds, pressure)?;
        let lowest = case.tank.courses[0].build_up();
        let stiff: f64 = lowest.iter().map(|l| l.material.youngs_modulus * l.thickness).sum();
        self.key = bottom::keep_in_place(builder, &self.angles, &rings[self.foot], HELD * stiff)?;
        Ok(())
    }

    /// Nodes of the foot.
    fn foot(&self) -> &[usize] {
        &self.placed.rings[self.foot]
    }

    /// See [`super::recorded::base_reaction`]; along x.
    pub(super) fn reaction(&self, tank: &CylinderModel, name: &str, moment: bool) -> Result<Quantity, AnalysisError> {
        let copies = tank.cells.copies();
        let held = self.placed.rings.last();
        let field = |node: usize| {
            let mut field = [0.0; KINDS];
            if held.is_some_and(|ring| ring.contains(&node)) {
                let along = if moment { Dof::Ry } else { Dof::Ux };
                field[along.index()] = copies;
            }
            field
        };
        let rayleigh = |e: usize| -> Rayleigh { tank.rayleigh[tank.model.group_of(e)] };
        let reaction = Reaction::new(tank.problem(), name, field, rayleigh)?;
        let ground = match moment {
            false => {
                let (element, along) = &self.key;
                vec![(*element, along.iter().map(|w| copies * w).collect())]
            }
            true => {
                let rings = self.placed.ground.iter().zip(&self.radii);
                let at = |(ring, radius): (&Vec<usize>, &f64)| -> Vec<(usize, Vec<f64>)> {
                    let nodes = ring.iter().zip(&self.angles);
                    nodes
                        .map(|(&e, angle)| (e, vec![0.0, 0.0, -copies * radius * angle.cos()]))
                        .collect()
                };
                rings.flat_map(at).collect()
            }
        };
        Ok(Quantity::Reaction(reaction.with_ground(ground)))
    }

    /// Heights of the foot at θ = 0 and π, and its rotation about y, positive where θ = 0 goes down [rad].
    pub(super) fn rows(&self, tank: &CylinderModel) -> [Quantity; 3] {
        let (model, foot) = (&tank.model, self.foot());
        let up = |node: usize, factor: f64| {
            let own = model.row(node, Dof::Uz).into_iter();
            own.map(move |(e, c)| (e, factor * c))
        };
        let tilt = foot.iter().zip(cosine_shares(&self.angles));
        let turn = tilt.flat_map(|(n, c)| up(*n, -2.0 * c / (PI * tank.radius)));
        [
            row("uplift at θ = 0°", up(foot[0], 1.0).collect()),
            row("uplift at θ = 180°", up(foot[foot.len() - 1], 1.0).collect()),
            row("rotation of the base", turn.collect()),
        ]
    }

    /// Plastic rotations of the joints at θ = 0 and π [rad].
    ///
    /// Errors: a section that fails.
    pub(super) fn plastic(&self, tank: &CylinderModel, state: &State) -> Result<[f64; 2], FeError> {
        let at = |back| bottom::plastic_rotation(&tank.model, &self.placed, self.foot, back, state);
        Ok([at(false)?, at(true)?])
    }
}
