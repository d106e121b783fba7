//! The wall of an unanchored tank on its bottom: plates on ground that pushes but does not pull, as in a pushover.
//!
//! ```text
//! rest      weight, ρ g (H − z) on the wall and ρ g H on the plate, in load steps
//! motion    the liquid's pressure on wall and plate ([`super::floor`]); ρ g H times 1 + a_v/g with vertical motion
//! no slip   ∫ (u_r cos θ − u_θ sin θ) dθ = 0 at the foot; in its plane the plate moves on the ground without friction
//! slip      with friction: |t| ≤ μ r at every node and under the disc within the inmost ring
//! anchors   n springs that pull, spread evenly over the nodes of the foot
//! base      V = held ring and foot, or friction ,  M = Σ r x of ground and liquid's floor
//! ```

use std::f64::consts::{PI, TAU};

use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::analysis::march::{Quantity, Reaction};
use fem::dofs::{Dof, KINDS};
use fem::element::ElementError;
use fem::element::anchor::Anchor;
use fem::element::shell::load::NodalLoads;
use fem::element::wall::place::{PlacedWall, WallMesh};
use fem::model::Builder;
use fem::state::{Gather, State};
use tank::options::nonlinear::{Contact, NonlinearOptions};
use tank::{Case, LayerKind, Support};

use super::floor::{LiquidFloor, Share};
use super::model::CylinderModel;
use super::recorded::row;
use crate::FeError;
use crate::error::failed;
use crate::nonlinear::arcs::{cosine_shares, shares};
use crate::nonlinear::bottom::{self, Placed, Plate};

/// Group of the anchors.
pub(super) const ANCHOR: &str = "anchor";

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

/// Stiffness that holds the foot over E t of the lowest course: so stiff that it moves by less than 10⁻³ of what the wall does.
const HELD: f64 = 1e3;

/// The bottom of a model.
pub(crate) struct Standing {
    placed: Placed,
    angles: Vec<f64>,
    radii: Vec<f64>,
    foot: usize,
    /// Elements of the wall at θ = 0 and π from the foot on, with their bending.
    wall: [Vec<(usize, [f64; 2])>; 2],
    /// Modulus of the ground [N/m³].
    modulus: f64,
    /// What carries the base shear.
    holds: Holds,
    /// Anchors at the foot with the numbers of their elements, node by node; none without anchors.
    anchors: Vec<(usize, Anchor)>,
    /// Number of anchors at every node of the foot.
    bolts: Vec<f64>,
    /// Shares of the plate in the springs of the liquid's floor.
    floor: Vec<Share>,
}

/// What carries the base shear.
enum Holds {
    /// A spring that keeps the foot in place, with the weights of its force along x.
    Key(usize, Vec<f64>),
    /// Friction, with the element of ground under the disc within the inmost ring.
    Friction(usize),
}

/// Whether the tank of a case may slide in the nonlinear history: with a coefficient of friction and without anchors.
pub(super) fn slides(case: &Case) -> bool {
    let friction = case.tank.foundation.as_ref().and_then(|f| f.friction);
    case.tank.support == Support::Unanchored && friction.is_some_and(|mu| mu > 0.0)
}

/// Anchors with all that a spring needs: number, stiffness, force at which one yields [N].
fn anchors(case: &Case) -> Option<(f64, f64, f64)> {
    let own = case.tank.anchors.filter(|_| case.tank.support == Support::Anchored)?;
    Some((f64::from(own.count), own.stiffness?, own.yield_force.or(own.capacity)?))
}

/// Whether the history of a case has its bottom: unanchored or on anchors whose stiffness is given, with a bottom plate of steel under half a
/// wall of one shell that stays in contact with the liquid.
pub(super) fn stands(case: &Case, options: &NonlinearOptions) -> bool {
    let one = |c: &tank::Course| c.build_up().iter().filter(|l| l.kind == LayerKind::Shell).count() == 1;
    (case.tank.support == Support::Unanchored || anchors(case).is_some())
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
        let height = |level: usize| mesh.footprint.points[mesh.footprint.levels[level][0]][2];
        let meridian = |cell: fn(&[usize]) -> Option<&usize>| -> Vec<(usize, [f64; 2])> {
            let rows = wall.rows.iter().enumerate();
            rows.filter_map(|(row, cells)| {
                let middle = 0.5 * (height(row) + height(row + 1));
                Some((*cell(cells)?, bottom::wall_bending(&case.tank, middle)))
            })
            .collect()
        };
        let standing = Standing {
            wall: [meridian(<[usize]>::first), meridian(<[usize]>::last)],
            placed,
            angles,
            radii: plate.radii.clone(),
            foot: plate.foot,
            modulus: plate.base.modulus,
            holds: Holds::Key(0, Vec::new()),
            anchors: Vec::new(),
            bolts: Vec::new(),
            floor: Vec::new(),
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
        let slides = slides(case);
        let kinds = [options.follower_pressure, slides, slides];
        self.placed.ground = plate.place(builder, &self.angles, rings, kinds, pressure)?;
        if options.plane_foot {
            bottom::keep_plane(builder, &self.angles, &rings[self.foot])?;
        }
        if let Some((count, stiffness, strength)) = anchors(case) {
            let bolts: Vec<f64> = shares(&self.angles).iter().map(|share| count * share / TAU).collect();
            let own = case.tank.anchors.as_ref();
            for (&node, number) in rings[self.foot].iter().zip(&bolts) {
                let anchor = Anchor::new(node, number * stiffness, number * strength)
                    .and_then(|a| a.with_gap(own.and_then(|o| o.gap).unwrap_or(0.0)))
                    .and_then(|a| match own.and_then(|o| o.rupture_elongation) {
                        Some(rupture) => a.with_rupture(rupture),
                        None => Ok(a),
                    });
                let anchor = anchor.map_err(failed)?;
                self.anchors.push((builder.element(ANCHOR, anchor.clone()), anchor));
            }
            self.bolts = bolts;
        }
        if let (true, Some(bottom), Some(inmost)) = (slides, &case.tank.bottom, rings.last()) {
            let disc = plate.core(builder, bottom, (&self.angles, inmost), pressure)?;
            self.holds = Holds::Friction(disc);
            return Ok(());
        }
        let lowest = case.tank.courses[0].build_up();
        let stiff: f64 = lowest.iter().map(|l| l.material.youngs_modulus * l.thickness).sum();
        let (key, along) = bottom::keep_in_place(builder, &self.angles, &rings[self.foot], HELD * stiff)?;
        self.holds = Holds::Key(key, along);
        Ok(())
    }

    /// Joins the liquid's floor to the plate.
    ///
    /// Errors: those of the elements.
    pub(super) fn wet(
        &mut self,
        plate: &Plate,
        builder: &mut Builder,
        floor: &LiquidFloor,
        with_gaps: bool,
    ) -> Result<(), FeError> {
        self.floor = floor.join(plate, builder, &self.placed.rings, &self.angles, with_gaps)?;
        Ok(())
    }

    /// Nodes of the foot.
    fn foot(&self) -> &[usize] {
        &self.placed.rings[self.foot]
    }

    /// See [`super::recorded::base_reaction`]; along x.
    pub(super) fn reaction(&self, tank: &CylinderModel, name: &str, moment: bool) -> Result<Quantity, AnalysisError> {
        let copies = tank.cells.copies();
        let held = self.placed.rings.last().filter(|_| moment || !self.slides());
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
                let foot = self.anchors.iter().zip(&self.angles).map(|((e, _), angle)| {
                    let lever = self.radii[self.foot] * angle.cos();
                    (*e, vec![0.0, 0.0, -copies * lever])
                });
                let at = |(ring, radius): (&Vec<usize>, &f64)| -> Vec<(usize, Vec<f64>)> {
                    let nodes = ring.iter().zip(&self.angles);
                    nodes
                        .map(|(&e, angle)| (e, vec![0.0, 0.0, -copies * radius * angle.cos()]))
                        .collect()
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

    /// Pressure of the ground under a point of the plate that is `height` [m] above it [Pa].
    pub(super) fn pressure(&self, height: f64) -> f64 {
        self.modulus * (-height).max(0.0)
    }

    /// Plastic rotation across every cell along the radius, in the order of [`Standing::quadrilaterals`] [rad].
    ///
    /// Errors: a section that fails.
    pub(super) fn plastic_by_cell(&self, tank: &CylinderModel, state: &State) -> Result<Vec<f64>, AnalysisError> {
        let cells = self.placed.cells.iter().flatten();
        let part = |cell: &usize| bottom::plastic_part(&tank.model, *cell, self.placed.soft(*cell), state);
        cells.map(|cell| Ok(part(cell)?.unwrap_or(0.0))).collect()
    }

    /// Whether the tank may slide.
    pub(super) fn slides(&self) -> bool {
        matches!(self.holds, Holds::Friction(_))
    }

    /// The anchor that pulls most; none without anchors.
    pub(super) fn pulled(&self, tank: &CylinderModel, state: &State) -> Option<Pulled> {
        let mut gather = Gather::default();
        let all = self.anchors.iter().zip(&self.bolts).zip(&self.angles);
        let each = all.map(|(((e, anchor), number), angle)| {
            let motion = gather.motion(&tank.model, &state.committed, anchor);
            let height = motion.values[2];
            let seen = anchor.look(motion.values, &state.old[state.history(*e)]);
            Pulled {
                force: seen.force / number,
                plastic: seen.plastic,
                height,
                angle: *angle,
            }
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
            let plate = bottom::plastic_rotation(&tank.model, &self.placed, self.foot, back, state)?;
            let column = self.wall[usize::from(back)].iter().copied();
            Ok([plate, bottom::wall_rotation(&tank.model, column, state)?])
        };
        Ok([at(false)?, at(true)?])
    }
}
