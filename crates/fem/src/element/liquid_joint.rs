//! Joint between a wall and a liquid whose wetted face has its own displacement: the wall presses the liquid, and nothing
//! pulls it.
//!
//! ```text
//! e = Σ (a − w)·n N          closing at an integration point: liquid a, wall w
//! F = k e                    as long as  k e + s·x ≥ 0 : the joint is closed
//! F = −s·x + r k (e + s·x/k)  else: the liquid has left the wall       r = 10⁻¹²
//! ```
//!
//! F is the whole pressure (times the area of the point), that of rest included: the hydrostatic load stands on the liquid's
//! face. s·x = −ρ g A u_z is the change of a particle's pressure by its own motion, so that the joint opens where the pressure of
//! the *displaced* particle would fall below zero and not wherever the surface has fallen below a place of the wall. It is
//! taken at the beginning of the step, which keeps the tangent symmetric. Without s the judgement is the plain one of the
//! undeformed height.
//!
//! F never falls with e, so that it has a convex potential and Newton's method on the set of closed points ends. Time steps
//! take the force at their end ([`Contact::acts_at_end`]): a trapezoidal rule gains energy at every touch.
//!
//! Source: Moreau 1999; Alart & Curnier 1991; theory sheet of this project (pressure of the displaced particle).

use super::{Contact, Element, ElementError, LocalMatrix, Motion, Response, Trial, positive, require};
use crate::dofs::Dof;

const KIND: &str = "liquid_joint";

/// Stiffness of an open point relative to the closed one: enough to keep a matrix regular. 10⁻⁸ changes histories with many touches
/// visibly, as any difference grows by a third in each of them.
pub const RESIDUAL: f64 = 1e-12;

/// Stiffness of the joint over that of the wall, so that the liquid gives way by a thousandth of what the wall does.
pub const PENALTY: f64 = 1e3;

/// An integration point of the joint.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPoint {
    /// Closing e as a row over the unknowns.
    pub closing: Vec<(usize, f64)>,
    /// s: change of the pressing force by the motion, as a row over the unknowns [N/m].
    pub relief: Vec<(usize, f64)>,
    /// k: penalty [N/m³] times the area of the point [m²].
    pub stiffness: f64,
}

/// State of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// e [m].
    pub closing: f64,
    /// F [N].
    pub force: f64,
    /// Distance of liquid and wall [m], 0 as long as they touch.
    pub gap: f64,
}

/// The element.
#[derive(Clone, Debug)]
pub struct LiquidJoint {
    nodes: Vec<usize>,
    dofs: Vec<Dof>,
    points: Vec<JointPoint>,
    opens: bool,
}

impl LiquidJoint {
    /// Joint over these unknowns, components along the axes of the nodes' frames.
    ///
    /// * `opens`: `false` keeps every point closed, F = k e
    ///
    /// Errors: no unknown or no point; a row that leaves the unknowns; a stiffness that is not positive.
    pub fn new(unknowns: &[(usize, Dof)], points: Vec<JointPoint>, opens: bool) -> Result<LiquidJoint, ElementError> {
        let found = format_args!("{} unknowns, {} points", unknowns.len(), points.len());
        require(!unknowns.is_empty() && !points.is_empty(), KIND, "points", found, "one or more of each")?;
        for point in &points {
            for &(i, c) in point.closing.iter().chain(&point.relief) {
                let good = i < unknowns.len() && c.is_finite();
                let found = format_args!("{c} on unknown {i}");
                require(good, KIND, "row", found, "finite, on unknowns of the element")?;
            }
            require(positive(point.stiffness), KIND, "stiffness", point.stiffness, "> 0 N/m")?;
        }
        Ok(LiquidJoint {
            nodes: unknowns.iter().map(|u| u.0).collect(),
            dofs: unknowns.iter().map(|u| u.1).collect(),
            points,
            opens,
        })
    }

    /// Its points.
    pub fn points(&self) -> &[JointPoint] {
        &self.points
    }

    /// States of the points at `values` of the unknowns, with the `history` that was committed with them.
    pub fn look(&self, values: &[f64], history: &[f64]) -> Vec<PointForce> {
        let points = self.points.iter().zip(history);
        points
            .map(|(point, &relief)| {
                let closing = dot(&point.closing, values);
                let (force, _) = self.force(point, closing, relief);
                let open = self.opens && point.stiffness * closing + relief < 0.0;
                PointForce { closing, force, gap: if open { force / point.stiffness - closing } else { 0.0 } }
            })
            .collect()
    }

    /// F and dF/de.
    fn force(&self, point: &JointPoint, closing: f64, relief: f64) -> (f64, f64) {
        let k = point.stiffness;
        let pressing = k * closing + relief;
        if pressing >= 0.0 || !self.opens { (k * closing, k) } else { (-relief + RESIDUAL * pressing, RESIDUAL * k) }
    }
}

fn dot(row: &[(usize, f64)], x: &[f64]) -> f64 {
    row.iter().map(|&(i, c)| c * x[i]).sum()
}

impl Element for LiquidJoint {
    crate::answers!(KIND, nodes; own_axes massless contact);

    fn dofs(&self, node: usize) -> &'static [Dof] {
        let own = self.dofs[node].index();
        Dof::slice(own..own + 1)
    }

    /// s·x of each point at the end of the last step.
    fn history_len(&self) -> usize {
        self.points.len()
    }

    fn respond(&self, Trial { motion, old, new, want }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        for ((point, &relief), after) in self.points.iter().zip(old).zip(new) {
            *after = dot(&point.relief, motion.values);
            let (force, slope) = self.force(point, dot(&point.closing, motion.values), relief);
            if want.force {
                point.closing.iter().for_each(|&(i, c)| out.force[i] += force * c);
            }
            if want.tangent {
                add(&mut out.tangent, slope, &point.closing);
            }
        }
        Ok(())
    }
}

impl Contact for LiquidJoint {
    fn acts_at_end(&self) -> bool {
        true
    }

    fn switches(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(bool)) {
        for (point, relief) in self.points.iter().zip(history) {
            see(point.stiffness * dot(&point.closing, motion.values) + relief >= 0.0);
        }
    }

    fn penetration(&self, motion: Motion<'_>) -> f64 {
        let closing = self.points.iter().map(|p| dot(&p.closing, motion.values));
        closing.fold(0.0, f64::max)
    }
}

/// A ← A + factor r rᵀ.
fn add(a: &mut LocalMatrix, factor: f64, row: &[(usize, f64)]) {
    for &(j, y) in row {
        for &(i, x) in row {
            a.add(i, j, factor * x * y);
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitQuaternion;

    use super::*;
    use crate::element::Want;

    fn joint(opens: bool) -> LiquidJoint {
        let point = |closing: [f64; 3], relief: f64, stiffness| JointPoint {
            closing: closing.into_iter().enumerate().collect(),
            relief: vec![(3, relief)],
            stiffness,
        };
        let unknowns = [(0, Dof::Ux), (0, Dof::Ry), (1, Dof::Ux), (2, Dof::Amplitude)];
        let points = vec![point([1.0, 0.3, -1.0], -40.0, 2e3), point([0.2, 1.0, -0.2], 25.0, 5e3)];
        LiquidJoint::new(&unknowns, points, opens).unwrap()
    }

    fn answer(joint: &LiquidJoint, values: &[f64], old: &[f64]) -> (Response, Vec<f64>) {
        let mut out = Response::sized(4);
        let mut new = old.to_vec();
        let rotations = vec![UnitQuaternion::identity(); 4];
        let motion = Motion { values, rotations: &rotations };
        joint.respond(Trial { motion, old, new: &mut new, want: Want::ALL }, &mut out).unwrap();
        (out, new)
    }

    /// Closed, open, and one of each: forces by hand, tangents against differences; the value kept for the next step is s·x.
    #[test]
    fn forces_and_tangents() {
        let joint = joint(true);
        let old = [-6.0, 3.0];
        for (values, expected) in [
            ([0.01, 0.0, 0.0, 0.2], [20.0, 10.0]),
            ([-0.01, 0.0, 0.0, 0.2], [6.0, -3.0]),
            ([0.0, 0.004, 0.0, 0.2], [6.0, 20.0]),
        ] {
            let seen = joint.look(&values, &old);
            for (p, f) in seen.iter().zip(expected) {
                // The residual stiffness is far below.
                assert!((p.force - f).abs() < 1e-6, "{seen:?}");
                assert_eq!(p.gap > 0.0, f == 6.0 || f == -3.0);
            }
            let (out, new) = answer(&joint, &values, &old);
            assert_eq!(new, vec![-40.0 * 0.2, 25.0 * 0.2]);
            let h = 1e-7;
            for j in 0..4 {
                let mut moved = [values, values];
                moved[0][j] += h;
                moved[1][j] -= h;
                let [a, b] = moved.map(|v| answer(&joint, &v, &old).0.force);
                for i in 0..4 {
                    let slope = (a[i] - b[i]) / (2.0 * h);
                    assert!((slope - out.tangent.get(i, j)).abs() < 1e-5, "{i} {j}");
                }
            }
        }
    }

    #[test]
    fn bonded_pulls() {
        let values = [-0.01, 0.0, 0.0, 0.0];
        let seen = joint(false).look(&values, &[-6.0, 3.0]);
        assert!((seen[0].force + 20.0).abs() < 1e-12 && seen[0].gap == 0.0);
    }

    #[test]
    fn bad_parameters_are_rejected() {
        let point = |row, stiffness| JointPoint { closing: vec![row], relief: Vec::new(), stiffness };
        let over = |point| LiquidJoint::new(&[(0, Dof::Ux)], vec![point], true);
        assert!(over(point((0, 1.0), 1.0)).is_ok());
        assert!(over(point((1, 1.0), 1.0)).is_err());
        assert!(over(point((0, f64::NAN), 1.0)).is_err());
        assert!(over(point((0, 1.0), 0.0)).is_err());
        assert!(LiquidJoint::new(&[(0, Dof::Ux)], Vec::new(), true).is_err());
    }
}
