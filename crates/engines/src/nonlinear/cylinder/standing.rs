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

use fem::element::ElementError;
use fem::element::anchor::Anchor;
use fem::element::shell::load::NodalLoads;
use fem::element::wall::place::{PlacedWall, WallMesh};
use fem::model::Builder;
use tank::options::nonlinear::{Contact, NonlinearOptions};
use tank::{Case, FRICTION, LayerKind, Support};

use super::floor::{LiquidFloor, Share};
use crate::FeError;
use crate::error::failed;
use crate::nonlinear::arcs::shares;
use crate::nonlinear::bottom::{self, Placed, Plate};

/// Group of the anchors.
pub(super) const ANCHOR: &str = "anchor";

/// The bottom of a model.
pub(crate) struct Standing {
    pub(super) placed: Placed,
    pub(super) angles: Vec<f64>,
    pub(super) radii: Vec<f64>,
    pub(super) foot: usize,
    /// Elements of the wall at θ = 0 and π from the foot on, with their bending.
    pub(super) wall: [Vec<(usize, [f64; 2])>; 2],
    /// Modulus of the ground [N/m³].
    pub(super) modulus: f64,
    /// What carries the base shear.
    pub(super) holds: Holds,
    /// Anchors at the foot with the numbers of their elements, node by node; none without anchors.
    pub(super) anchors: Vec<(usize, Anchor)>,
    /// Number of anchors at every node of the foot.
    pub(super) bolts: Vec<f64>,
    /// Shares of the plate in the springs of the liquid's floor.
    pub(super) floor: Vec<Share>,
}

/// What carries the base shear.
pub(super) enum Holds {
    /// A spring that keeps the foot in place, with the weights of its force along x.
    Key(usize, Vec<f64>),
    /// Friction, with the element of ground under the disc within the inmost ring.
    Friction(usize),
}

/// Whether the tank of a case may slide in the nonlinear history: with a coefficient of friction and without anchors.
pub(super) fn slides(case: &Case) -> bool {
    let friction = case.tank.foundation.map_or(Some(FRICTION), |f| f.friction);
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
    found.ok().flatten().map_or(0, |plate| plate.radii.len().saturating_sub(1))
}

/// The plate of a case, `None` of a wall whose foot is clamped.
///
/// Errors: those of [`Plate::of`].
pub(super) fn plate(case: &Case, options: &NonlinearOptions, radius: f64) -> Result<Option<Plate>, FeError> {
    stands(case, options).then(|| Plate::of(case, radius, options.bottom_mesh)).transpose()
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
        let refused = |e: FeError| ElementError::NoAnswer { kind: "bottom", reason: e.to_string() };
        let mut more = |builder: &mut Builder, wall: &[usize]| {
            let own: Vec<usize> = foot.iter().map(|p| wall[*p]).collect();
            rings = plate.nodes(builder, &angles, &own);
            let Some(bottom) = &case.tank.bottom else { return Ok(Vec::new()) };
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
                Some((*cell(cells)?, bottom::hinge::wall_bending(&case.tank, middle)))
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
            bottom::hold::keep_plane(builder, &self.angles, &rings[self.foot])?;
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
                    })
                    .map_err(failed)?;
                self.anchors.push((builder.element(ANCHOR, anchor.clone()), anchor));
            }
            self.bolts = bolts;
        }
        if let (true, Some(bottom), Some(inmost)) = (slides, &case.tank.bottom, rings.last()) {
            let disc = plate.core(builder, bottom, (&self.angles, inmost), pressure)?;
            self.holds = Holds::Friction(disc);
            return Ok(());
        }
        let lowest = &case.tank.courses[0];
        let (key, along) = bottom::hold::keep_in_place(builder, &self.angles, &rings[self.foot], lowest)?;
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
    pub(super) fn foot(&self) -> &[usize] {
        &self.placed.rings[self.foot]
    }

    /// Pressure of the ground under a point of the plate that is `height` [m] above it [Pa].
    pub(super) fn pressure(&self, height: f64) -> f64 {
        self.modulus * (-height).max(0.0)
    }

    /// Whether the tank may slide.
    pub(super) fn slides(&self) -> bool {
        matches!(self.holds, Holds::Friction(_))
    }
}
