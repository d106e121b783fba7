//! Spring between two nodes, or between a node and the ground; and point mass.
//!
//! ```text
//! elongation    e = d · (u_b − u_a)        to the ground: e = d · u_a
//! spring        f = k e                    K = k e' e'ᵀ          e' = ∂e/∂u
//! point mass    M = m 1₃
//! ```
//!
//! The direction d is fixed (small displacements).

use super::{Element, ElementError, Inspect, LocalMatrix, Response, Sample, Trial, not_negative, require};
use crate::dofs::Dof;

/// Motion that a spring resists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Displacement along a unit vector, global Cartesian.
    Translation([f64; 3]),
    /// Rotation about a unit vector, global Cartesian.
    Rotation([f64; 3]),
}

/// Elongation between two nodes or against the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Link {
    nodes: [usize; 2],
    /// 1 (to the ground) or 2.
    count: usize,
    dofs: &'static [Dof],
    direction: [f64; 3],
}

impl Link {
    fn new(kind: &'static str, nodes: &[usize], direction: Direction) -> Result<Link, ElementError> {
        let (dofs, vector): (&'static [Dof], _) = match direction {
            Direction::Translation(d) => (&Dof::ALL[0..3], d),
            Direction::Rotation(d) => (&Dof::ALL[3..6], d),
        };
        let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        // Another length scales the stiffness by its square.
        let found = format_args!("{vector:?} of length {length}");
        require((length - 1.0).abs() <= 1e-9, kind, "direction", found, "unit vectors")?;
        Ok(Link { nodes: [nodes[0], nodes[nodes.len() - 1]], count: nodes.len(), dofs, direction: vector })
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes[..self.count]
    }

    /// ∂e/∂u: towards the second node if there is one.
    fn row(&self) -> Vec<f64> {
        let along = self.direction;
        match self.count {
            1 => along.to_vec(),
            _ => along.map(|d| -d).into_iter().chain(along).collect(),
        }
    }

    fn elongation(&self, values: &[f64]) -> f64 {
        self.row().iter().zip(values).map(|(d, u)| d * u).sum()
    }

    fn add(&self, factor: f64, out: &mut LocalMatrix) {
        let row = self.row();
        for (j, b) in row.iter().enumerate() {
            for (i, a) in row.iter().enumerate() {
                out.add(i, j, factor * a * b);
            }
        }
    }
}

/// Linear spring.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    link: Link,
    stiffness: f64,
}

impl Spring {
    /// Between two nodes; `stiffness` k [N/m or N m/rad], ≥ 0.
    ///
    /// Errors: a parameter out of range.
    pub fn between(a: usize, b: usize, direction: Direction, stiffness: f64) -> Result<Spring, ElementError> {
        Spring::new(&[a, b], direction, stiffness)
    }

    /// Between a node and the ground.
    ///
    /// Errors: a parameter out of range.
    pub fn to_ground(node: usize, direction: Direction, stiffness: f64) -> Result<Spring, ElementError> {
        Spring::new(&[node], direction, stiffness)
    }

    fn new(nodes: &[usize], direction: Direction, stiffness: f64) -> Result<Spring, ElementError> {
        require(not_negative(stiffness), "spring", "stiffness", stiffness, "≥ 0")?;
        let link = Link::new("spring", nodes, direction)?;
        Ok(Spring { link, stiffness })
    }
}

impl Element for Spring {
    fn kind(&self) -> &'static str {
        "spring"
    }

    fn nodes(&self) -> &[usize] {
        self.link.nodes()
    }

    fn dofs(&self, _node: usize) -> &'static [Dof] {
        self.link.dofs
    }

    fn is_linear(&self) -> bool {
        true
    }

    fn has_mass(&self) -> bool {
        false
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        if want.force {
            let force = self.stiffness * self.link.elongation(motion.values);
            for (f, d) in out.force.iter_mut().zip(self.link.row()) {
                *f += force * d;
            }
        }
        if want.tangent {
            self.link.add(self.stiffness, &mut out.tangent);
        }
        Ok(())
    }

    fn inspect(&self) -> Option<&dyn Inspect> {
        Some(self)
    }
}

impl Inspect for Spring {
    /// `force` k e [N or N m]; its position is not known to the element.
    fn samples(&self) -> Vec<Sample> {
        vec![Sample {
            name: "force",
            position: [f64::NAN; 3],
            row: self.link.row().iter().map(|d| self.stiffness * d).collect(),
            of_acceleration: false,
        }]
    }
}

/// Mass at a node, without rotary inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct PointMass {
    node: [usize; 1],
    mass: f64,
}

impl PointMass {
    /// `mass` m [kg], ≥ 0.
    ///
    /// Errors: a parameter out of range.
    pub fn new(node: usize, mass: f64) -> Result<PointMass, ElementError> {
        require(not_negative(mass), "point mass", "mass", mass, "≥ 0")?;
        Ok(PointMass { node: [node], mass })
    }
}

impl Element for PointMass {
    crate::answers!("point mass", node, Dof::TRANSLATIONS; linear);

    fn mass(&self, out: &mut LocalMatrix) {
        for i in 0..3 {
            out.add(i, i, self.mass);
        }
    }

    fn respond(&self, _: Trial<'_>, _out: &mut Response) -> Result<(), ElementError> {
        Ok(())
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        for i in 0..3 {
            out[i] += self.mass * acceleration[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{local_size, reference_mass, reference_stiffness};

    const DIAGONAL: Direction = Direction::Translation([0.6, 0.0, 0.8]);

    #[test]
    fn spring_between_nodes_and_to_the_ground() {
        let spring = Spring::between(3, 5, DIAGONAL, 100.0).unwrap();
        let k = reference_stiffness(&spring).unwrap();
        assert_eq!(local_size(&spring), 6);
        // Second node 0.1 along x: e = 0.06, f = 6; its x component is 3.6, and −3.6 at the first node.
        assert!((0.1 * k.get(3, 3) - 3.6).abs() < 1e-14 && (0.1 * k.get(0, 3) + 3.6).abs() < 1e-14);
        assert!((0.1 * k.get(5, 3) - 4.8).abs() < 1e-14 && k.get(4, 3) == 0.0);
        let ground = Spring::to_ground(3, Direction::Rotation([0.0, 1.0, 0.0]), 7.0).unwrap();
        assert_eq!(ground.dofs(0), &[Dof::Rx, Dof::Ry, Dof::Rz]);
        assert_eq!(reference_stiffness(&ground).unwrap().get(1, 1), 7.0);
    }

    #[test]
    fn point_mass() {
        let mass = PointMass::new(0, 2.0).unwrap();
        assert_eq!(reference_mass(&mass).get(2, 2), 2.0);
        let mut weight = [0.0; 3];
        mass.body_force([0.0, 0.0, -9.81], &mut weight);
        assert!((weight[2] + 19.62).abs() < 1e-14);
    }

    #[test]
    fn bad_parameters_are_rejected() {
        assert!(Spring::to_ground(0, DIAGONAL, -1.0).is_err());
        assert!(Spring::to_ground(0, Direction::Translation([1.0, 1.0, 0.0]), 1.0).is_err());
        assert!(PointMass::new(0, f64::NAN).is_err());
    }
}
