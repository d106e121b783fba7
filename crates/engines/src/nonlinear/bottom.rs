//! The bottom of an unanchored tank: plates as shells on ground that pushes but does not pull.
//!
//! ```text
//! rings     from the projection over the foot of the wall inwards to half of the radius; within it the plate stays on the ground
//! ground    r = k A <−u_z> at the nodes, friction |t| ≤ μ r; the inmost ring is held in its plane: the tank does not slide as a whole
//! pressure  ρ g H as follower, and p_b(r) cos θ a of the impulsive liquid; the sum is never below zero
//! p_b(r) = ρ Σ 2 (−1)^n/(H α_n²) I₁(α_n r)/I₁′(α_n R) ,  α_n = (2 n + 1) π/(2 H)           rigid tank, z = 0
//! ```
//!
//! Rings are 2 t wide at the foot, where the plate forms a hinge, and grow by 15 % to half of the length (4 D/k)^(1/4) over which it sinks
//! into the ground, as far as it lifts; then they grow on. The wall is welded to the plate: a fold with six unknowns.
//!
//! Source: theory sheet of this project; Haroun & Housner 1981 (series).

pub(super) mod hinge;
pub(super) mod hold;

use std::f64::consts::PI;

use base::{Base, Missing};
use fem::dofs::Dof;
use fem::element::ground::Ground;
use fem::element::shell::load::{FollowerPressure, NodalLoads};
use fem::element::shell::surface::ShellCell;
use fem::element::spring::{Direction, PointMass, Spring};
use fem::element::super_element::SuperElement;
use fem::element::wall::place::Build;
use fem::linalg::Matrix;
use fem::model::Builder;
use nalgebra::Matrix3;
use tank::{Behaviour, Bottom, Case, FRICTION, Layer, LayerKind};

use super::arcs::shares;
use super::cylinder::section::row;
use super::laws::unsupported;
use crate::FeError;
use crate::error::failed;
use crate::floor_pressure::impulsive_pressure;
use tank::options::nonlinear::Integration;

/// Group of the plates.
pub(super) const BOTTOM: &str = "bottom";
/// Group of the ground.
pub(super) const GROUND: &str = "ground";
/// Group of what keeps the foot from sliding.
pub(super) const KEY: &str = "key";
/// First ring inside the foot over the thickness of the plate.
const FIRST: f64 = 2.0;
/// Growth of the rings.
const GROWTH: f64 = 1.15;
/// Distance from the foot within which rings stay short enough for a touch-down [m].
const FINE: f64 = 2.0;
/// Rings of the projection.
const OUTSIDE: usize = 2;
/// Stiffness by angle that ties the inmost ring to a disc that slides, over E t of its plate: a ring that carries E t per radian moves by a
/// hundredth of that against it.
const RIGID: f64 = 100.0;
/// Stiffness along x of a disc without friction over that of the ground below it.
const WEAK: f64 = 1e-6;
/// Radius within which the plate stays on the ground, over that of the tank.
const CORE: f64 = 0.5;

/// The bottom of a plan.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plate {
    /// Radii of the rings of nodes, falling [m].
    pub(super) radii: Vec<f64>,
    /// Number of that of the wall.
    pub(super) foot: usize,
    /// p_b at the radii [Pa per m/s²]; 0 outside the wall.
    pub(super) impulsive: Vec<f64>,
    /// Coefficient of friction between plate and ground; none where it is left out.
    pub(super) friction: Option<f64>,
    /// The strips of the fast engines, of the same plates on the same ground.
    pub(super) base: Base,
}

/// The bottom of a model.
pub(super) struct Placed {
    /// Nodes `rings[radius][angle]`.
    pub(super) rings: Vec<Vec<usize>>,
    /// Elements `cells[ring][sector]`.
    pub(super) cells: Vec<Vec<usize>>,
    /// Number of the element of ground under every node, in the order of `rings`.
    pub(super) ground: Vec<Vec<usize>>,
    /// Pressure at rest on every node, downwards, in the order of `rings` [N].
    pub(super) rest: Vec<Vec<f64>>,
    /// 1/D′ and ν/D′, D′ = E t³/12, of every cell, in the order of the elements [1/(N m)].
    pub(super) bending: Vec<[f64; 2]>,
}

impl Placed {
    /// 1/D′ and ν/D′ of a cell [1/(N m)].
    pub(super) fn soft(&self, cell: usize) -> [f64; 2] {
        self.bending[cell - self.cells[0][0]]
    }
}

/// Why the bottom of a case is not modelled, in words, and what is allowed.
pub(crate) fn missing(case: &Case) -> Option<(&'static str, &'static str)> {
    match Base::of(case) {
        Err(Missing::Cylinder) => Some(("a nonlinear bottom is that of a cylinder", "\"cylinder\"")),
        Err(Missing::Plate) => Some((
            "the nonlinear bottom of an unanchored tank needs its bottom plate",
            "\"anchored\", or a `tank.bottom`",
        )),
        Err(Missing::Metal) => Some((
            "the nonlinear bottom of an unanchored tank is for bottoms of steel plates",
            "\"anchored\", or a `tank.bottom` of steel",
        )),
        Ok(_) => {
            let steel = case.tank.bottom.as_ref().is_some_and(|b| matches!(b.material.behaviour, Behaviour::Steel(_)));
            (!steel).then_some((
                "the nonlinear bottom of an unanchored tank needs a bottom plate that yields",
                "a material of `tank.bottom` whose behaviour is \"steel\", or \"anchored\"",
            ))
        }
    }
}

impl Plate {
    /// * `mesh`: refinement of the rings ([`tank::options::NonlinearOptions::bottom_mesh`])
    ///
    /// Errors: a case without such a bottom.
    pub(super) fn of(case: &Case, radius: f64, mesh: f64) -> Result<Plate, FeError> {
        if let Some((reason, _)) = missing(case) {
            return unsupported(reason);
        }
        let (Ok(base), Some(bottom)) = (Base::of(case), &case.tank.bottom) else {
            return unsupported("the nonlinear bottom of an unanchored tank needs its bottom plate");
        };
        let plate = base.plate();
        let sinking = (4.0 * plate.bending_stiffness() / base.modulus).powf(0.25);
        let mut inside = vec![0.0];
        let (mut x, mut width) = (0.0, FIRST * plate.thickness / mesh);
        let growth = GROWTH.powf(1.0 / mesh);
        // A change of thickness lies on a ring.
        let joint = bottom.sketch.and(bottom.width).filter(|w| *w < (1.0 - CORE) * radius);
        while x < (1.0 - CORE) * radius {
            let longest = if x < FINE { (0.5 * sinking).max(FIRST * plate.thickness) } else { 0.1 * radius } / mesh;
            let next = x + width;
            x = match joint {
                Some(at) if x < at * (1.0 - 1e-9) && next > at - 0.3 * width => at,
                _ => next,
            };
            inside.push(x);
            width = (growth * width).min(longest);
        }
        let outside = if bottom.projection > 0.0 { OUTSIDE } else { 0 };
        let out = (0..outside).map(|i| radius + bottom.projection * (1.0 - i as f64 / OUTSIDE as f64));
        let radii: Vec<f64> = out.chain(inside.iter().map(|x| radius - x)).collect();
        let pressure = |r: &f64| {
            if *r > radius * (1.0 + 1e-9) { 0.0 } else { impulsive_pressure(case, radius, *r) }
        };
        Ok(Plate {
            friction: case.tank.foundation.map_or(Some(FRICTION), |f| f.friction),
            impulsive: radii.iter().map(pressure).collect(),
            foot: outside,
            radii,
            base,
        })
    }

    /// Width of the rings inside the wall [m].
    pub(super) fn width(&self) -> f64 {
        self.radii[self.foot] - self.radii[self.radii.len() - 1]
    }

    /// p_b at the foot [Pa per m/s²].
    pub(super) fn suction(&self) -> f64 {
        self.impulsive[self.foot]
    }

    /// Adds nodes; returns them. `foot` are those of the wall; where an imperfection moves them the rings follow.
    pub(super) fn nodes(&self, builder: &mut Builder, angles: &[f64], foot: &[usize]) -> Vec<Vec<usize>> {
        let deviation = |node: usize| {
            let [x, y, _] = builder.position(node);
            x.hypot(y) - self.radii[self.foot]
        };
        let moved: Vec<f64> = foot.iter().map(|node| deviation(*node)).collect();
        let ring = |(i, &r): (usize, &f64)| -> Vec<usize> {
            if i == self.foot {
                return foot.to_vec();
            }
            let at = angles.iter().zip(&moved).map(|(angle, moved)| {
                let ((s, c), r) = (angle.sin_cos(), r + moved);
                let node = builder.node([r * c, r * s, 0.0]);
                builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
                node
            });
            at.collect()
        };
        self.radii.iter().enumerate().map(ring).collect()
    }

    /// Cells, ring after ring, and [`Placed::bending`].
    pub(super) fn cells(
        &self,
        bottom: &Bottom,
        rings: &[Vec<usize>],
        integration: &Integration,
    ) -> Result<(Vec<ShellCell>, Vec<[f64; 2]>), FeError> {
        let (mut cells, mut bending) = (Vec::new(), Vec::new());
        for (r, pair) in self.radii.windows(2).zip(rings.windows(2)) {
            let distance = self.radii[self.foot] - 0.5 * (r[0] + r[1]);
            let thickness = match (bottom.sketch, bottom.width) {
                (Some(sketch), Some(width)) if distance > width => sketch,
                _ => bottom.thickness,
            };
            let layer = Layer {
                kind: LayerKind::Shell,
                thickness,
                material: bottom.material.clone(),
                reinforcement: Vec::new(),
            };
            let Build::Shell(leaf) = row(&[layer], [r[0] - r[1]; 2], integration, None)?.build else {
                return unsupported("a bottom of one plate");
            };
            let soft = 12.0 / (bottom.material.youngs_modulus * thickness.powi(3));
            for k in 0..pair[0].len() - 1 {
                bending.push([soft, bottom.material.poisson_ratio * soft]);
                cells.push(ShellCell {
                    nodes: [pair[1][k], pair[0][k], pair[0][k + 1], pair[1][k + 1]],
                    section: leaf.section.clone(),
                    group: BOTTOM.into(),
                });
            }
        }
        Ok((cells, bending))
    }

    /// Areas that belong to the nodes of every ring, per angle [m²/rad]: ∫ N r dr.
    fn areas(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.radii.len()];
        for (i, r) in self.radii.windows(2).enumerate() {
            let width = r[0] - r[1];
            out[i] += width * (2.0 * r[0] + r[1]) / 6.0;
            out[i + 1] += width * (r[0] + 2.0 * r[1]) / 6.0;
        }
        out
    }

    /// The same of the part under the liquid.
    pub(super) fn wet_areas(&self) -> Vec<f64> {
        let inside = Plate { radii: self.radii[self.foot..].to_vec(), ..self.clone() };
        let dry = vec![0.0; self.foot];
        dry.into_iter().chain(inside.areas()).collect()
    }

    /// Adds ground, with friction or without, pressure at rest and supports; the inmost ring is held in its plane, or `slides` with what is
    /// within it ([`Plate::core`]).
    ///
    /// * `dead` takes the pressure on the undeformed plate
    pub(super) fn place(
        &self,
        builder: &mut Builder,
        angles: &[f64],
        rings: &[Vec<usize>],
        [follower, rubs, slides]: [bool; 3],
        dead: &mut NodalLoads,
    ) -> Result<Vec<Vec<usize>>, FeError> {
        let mut ground = Vec::new();
        for (ring, area) in rings.iter().zip(self.areas()) {
            let mut row = Vec::new();
            for (&node, share) in ring.iter().zip(shares(angles)) {
                let ground = Ground::new(node, self.base.modulus, area * share);
                let element = match self.friction.filter(|_| rubs) {
                    Some(friction) => ground.and_then(|g| g.with_friction(friction)),
                    None => ground,
                };
                let element = element.map_err(failed)?;
                row.push(builder.element(GROUND, element));
            }
            ground.push(row);
        }
        let pressure = self.base.pressure;
        for pair in rings[self.foot..].windows(2) {
            for k in 0..pair[0].len() - 1 {
                let nodes = [pair[1][k], pair[0][k], pair[0][k + 1], pair[1][k + 1]];
                let positions = nodes.map(|n| builder.position(n));
                dead.pressure(&nodes, &positions, |_| -pressure);
                if follower {
                    let element = FollowerPressure::new(nodes, positions, -pressure).without_dead_part();
                    builder.element("pressure", element);
                }
            }
        }
        for (&node, angle) in rings[self.foot].iter().zip(angles) {
            // As on the wall: e_θ, e_z, e_r.
            let (s, c) = angle.sin_cos();
            builder.rotation_frame(node, Matrix3::new(-s, c, 0.0, 0.0, 0.0, 1.0, c, s, 0.0));
        }
        let ends = |ring: &Vec<usize>| [ring[0], ring[ring.len() - 1]];
        for (i, ring) in rings.iter().enumerate() {
            for node in ends(ring) {
                builder.hold(node, Dof::Uy);
                // The foot is a fold, with a third rotation: about e_r.
                let turns: &[Dof] = if i == self.foot { &[Dof::Ry, Dof::Rz] } else { &[Dof::Ry] };
                turns.iter().for_each(|&d| builder.hold(node, d));
            }
        }
        for &node in rings.last().into_iter().flatten() {
            let held: &[Dof] = if slides { &[Dof::Rx, Dof::Ry] } else { &[Dof::Ux, Dof::Uy, Dof::Rx, Dof::Ry] };
            held.iter().for_each(|&dof| builder.hold(node, dof));
        }
        Ok(ground)
    }

    /// What is within the inmost ring as a rigid disc that slides along x on the ground, pressed by its liquid: half of it. Returns the number of
    /// its element of ground.
    ///
    /// * `dead` takes the weight of the liquid on it
    ///
    /// Errors: those of the elements.
    pub(super) fn core(
        &self,
        builder: &mut Builder,
        bottom: &Bottom,
        (angles, ring): (&[f64], &[usize]),
        dead: &mut NodalLoads,
    ) -> Result<usize, FeError> {
        let radius = self.radii[self.radii.len() - 1];
        let area = 0.5 * PI * radius * radius;
        let node = builder.node([0.0; 3]);
        builder.hold(node, Dof::Uy);
        dead.force(node, [0.0, 0.0, -self.base.pressure * area]);
        let thickness = bottom.sketch.unwrap_or(bottom.thickness);
        let disc = PointMass::new(node, bottom.material.density * thickness * area).map_err(failed)?;
        builder.element("disc", disc);
        let stiff = RIGID * bottom.material.youngs_modulus * thickness;
        for ((&own, share), angle) in ring.iter().zip(shares(angles)).zip(angles) {
            let (s, c) = angle.sin_cos();
            let mut matrix = Matrix::zeros(3, 3);
            // u_r − x cos θ and u_θ + x sin θ.
            for row in [[1.0, 0.0, -c], [0.0, 1.0, s]] {
                for (i, a) in row.iter().enumerate() {
                    for (j, b) in row.iter().enumerate() {
                        matrix.add(i, j, stiff * share * a * b);
                    }
                }
            }
            let link = SuperElement::over(&[(own, Dof::Ux), (own, Dof::Uy), (node, Dof::Ux)])
                .and_then(|e| e.with_stiffness(matrix))
                .map_err(failed)?;
            builder.element(KEY, link);
        }
        // Before the ground is pressed nothing else holds along x.
        let weak = WEAK * self.base.modulus * area;
        let spring = Spring::to_ground(node, Direction::Translation([1.0, 0.0, 0.0]), weak).map_err(failed)?;
        builder.element(KEY, spring);
        let ground = Ground::new(node, self.base.modulus, area);
        let ground = match self.friction {
            Some(friction) => ground.and_then(|g| g.with_friction(friction)),
            None => ground,
        };
        Ok(builder.element(GROUND, ground.map_err(failed)?))
    }
}
