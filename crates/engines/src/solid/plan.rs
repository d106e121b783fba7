//! Plan of a rectangular tank: its ring of wall nodes and the block of its liquid.
//!
//! The walls are one ring of plates. Sector 0 begins in the middle of the wall at x = +L (θ = 0) and the ring runs
//! counter-clockwise, so that sector N/2 begins in the middle of the wall at x = −L (θ = 180°):
//!
//! ```text
//!            N/4 − …  ←  y = +B/2
//!        ┌───────────────────┐
//!  N/2 → │ x = −L      x = +L│ ← 0
//!        └───────────────────┘
//! ```
//!
//! Liquid and walls share the division of the plan, not the one over the height.

use std::collections::BTreeMap;

use fem::mesh::{Face, MeshError, Rectangle, Volume};

/// Node lines of the plan, symmetric about both axes; the middle ones lie on the axes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plan {
    x: Vec<f64>,
    y: Vec<f64>,
}

/// −end … 0 … end from 0 … end.
fn whole(half: &[f64]) -> Vec<f64> {
    let left = half.iter().skip(1).rev().map(|v| -v);
    left.chain(half.iter().copied()).collect()
}

impl Plan {
    /// The plan whose halves have their nodes at `x` and `y` [m], each from 0.
    pub(super) fn new(x: &[f64], y: &[f64]) -> Plan {
        Plan { x: whole(x), y: whole(y) }
    }

    /// Places (i, j) of the nodes of the walls, in the order of the ring.
    fn ring(&self) -> Vec<[usize; 2]> {
        let (i, j) = (self.x.len() - 1, self.y.len() - 1);
        let mut ring: Vec<[usize; 2]> = (j / 2..j).map(|k| [i, k]).collect();
        ring.extend((1..=i).rev().map(|k| [k, j]));
        ring.extend((1..=j).rev().map(|k| [0, k]));
        ring.extend((0..i).map(|k| [k, 0]));
        ring.extend((0..j / 2).map(|k| [i, k]));
        ring
    }

    /// Number of nodes in the ring.
    pub(super) fn sectors(&self) -> usize {
        2 * (self.x.len() - 1 + self.y.len() - 1)
    }

    /// Positions of the nodes of the walls at `heights` [m], level by level; their faces, normal outwards, level by level and sector
    /// by sector; their numbers, `rows[level][sector]`.
    pub(super) fn walls(&self, heights: &[f64]) -> (Vec<[f64; 3]>, Vec<Face>, Vec<Vec<usize>>) {
        let ring = self.ring();
        let sectors = ring.len();
        let place = |level: usize, s: usize| {
            let [i, j] = ring[s % sectors];
            [self.x[i], self.y[j], heights[level]]
        };
        let number = |level: usize, s: usize| level * sectors + s % sectors;
        let levels = heights.len();
        let nodes = (0..levels).flat_map(|l| (0..sectors).map(move |s| (l, s))).map(|(l, s)| place(l, s)).collect();
        let rows = (0..levels).map(|l| (0..sectors).map(|s| number(l, s)).collect()).collect();
        (nodes, self.faces(levels, number, place), rows)
    }

    /// Faces between the levels and sectors of the walls.
    fn faces(
        &self,
        levels: usize,
        number: impl Fn(usize, usize) -> usize,
        place: impl Fn(usize, usize) -> [f64; 3],
    ) -> Vec<Face> {
        let mut faces = Vec::with_capacity((levels - 1) * self.sectors());
        for level in 0..levels - 1 {
            for s in 0..self.sectors() {
                let corners = [(level, s), (level, s + 1), (level + 1, s + 1), (level + 1, s)];
                faces
                    .push(Face { nodes: corners.map(|(l, s)| number(l, s)), chart: corners.map(|(l, s)| place(l, s)) });
            }
        }
        faces
    }

    /// The liquid between `heights` [m]; its nodes have no axis.
    ///
    /// Errors: places that do not ascend.
    pub(super) fn volume(&self, heights: &[f64]) -> Result<Volume, MeshError> {
        let block = Rectangle { x: self.x.clone(), y: self.y.clone(), z: heights.to_vec() }.block()?;
        let ring = self.ring();
        let sectors = ring.len();
        let number = |level: usize, s: usize| {
            let [i, j] = ring[s % sectors];
            i + self.x.len() * (j + self.y.len() * level)
        };
        let wall = self.faces(heights.len(), number, |level, s| block.nodes[number(level, s)]);
        Ok(Volume {
            wall,
            wall_nodes: (0..heights.len()).map(|l| (0..sectors).map(|s| number(l, s)).collect()).collect(),
            axis: Vec::new(),
            bottom_nodes: block.bottom.nodes,
            bottom: block.bottom.faces,
            surface_nodes: block.surface.nodes,
            surface: block.surface.faces,
            nodes: block.nodes,
            cells: block.cells,
        })
    }

    /// Places among the nodes of a level of the liquid on the line y = 0, from the middle to x = +L and to x = −L.
    pub(super) fn lines(&self) -> [Vec<usize>; 2] {
        let (middle, row) = ((self.x.len() - 1) / 2, self.x.len() * ((self.y.len() - 1) / 2));
        [(0..=middle).map(|k| row + middle + k).collect(), (0..=middle).map(|k| row + middle - k).collect()]
    }
}

/// Numbers of the mirror images of all nodes at the planes x = 0 and y = 0.
///
/// Wall and liquid have nodes at the same places, which are kept apart by `groups`: the first node of each.
pub(super) fn mirrors(nodes: &[[f64; 3]], groups: &[usize]) -> Option<[Vec<usize>; 2]> {
    let group = |n: usize| groups.partition_point(|&first| first <= n);
    // Mirrored coordinates are exact; only the sign of zero differs.
    let key = |n: usize, p: [f64; 3]| (group(n), p.map(|c| (c + 0.0).to_bits()));
    let numbers: BTreeMap<_, usize> = nodes.iter().enumerate().map(|(n, &p)| (key(n, p), n)).collect();
    let image = |n: usize, axis: usize| {
        let mut p = nodes[n];
        p[axis] = -p[axis];
        numbers.get(&key(n, p)).copied()
    };
    let all = |axis: usize| (0..nodes.len()).map(|n| image(n, axis)).collect::<Option<Vec<usize>>>();
    Some([all(0)?, all(1)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn plan() -> Plan {
        Plan::new(&[0.0, 1.0, 1.5], &[0.0, 0.4, 0.7, 0.9])
    }

    #[test]
    fn the_ring_begins_in_the_middle_of_the_front_and_turns_once() {
        let plan = plan();
        let (nodes, faces, rows) = plan.walls(&[0.0, 0.3, 1.0]);
        assert_eq!((plan.sectors(), nodes.len(), faces.len()), (20, 60, 40));
        assert_eq!(nodes[rows[0][0]], [1.5, 0.0, 0.0]);
        assert_eq!(nodes[rows[2][10]], [-1.5, 0.0, 1.0]);
        // Normals outwards, the area that of the four walls.
        let mut area = 0.0;
        for face in &faces {
            let p = face.chart.map(Vector3::from);
            let normal = (p[2] - p[0]).cross(&(p[3] - p[1])) * 0.5;
            let middle = p.iter().sum::<Vector3<f64>>() / 4.0;
            let outwards = if middle.x.abs() > 1.4999 {
                Vector3::x() * middle.x.signum()
            } else {
                Vector3::y() * middle.y.signum()
            };
            assert!((normal.normalize() - outwards).norm() < 1e-12, "{face:?}");
            area += normal.norm();
        }
        assert!((area - 2.0 * (3.0 + 1.8)).abs() < 1e-12);
    }

    #[test]
    fn wall_and_liquid_meet_and_are_symmetric() {
        let plan = plan();
        let volume = plan.volume(&[0.0, 0.5]).unwrap();
        let (walls, _, rows) = plan.walls(&[0.0, 0.5]);
        for (a, b) in volume.wall_nodes.iter().flatten().zip(rows.iter().flatten()) {
            assert_eq!(volume.nodes[*a], walls[*b]);
        }
        for (side, sign) in plan.lines().iter().zip([1.0, -1.0]) {
            let x: Vec<f64> = side.iter().map(|&n| sign * volume.nodes[n][0]).collect();
            assert_eq!(x, [0.0, 1.0, 1.5]);
            assert!(side.iter().all(|&n| volume.nodes[n][1] == 0.0));
        }
        let [in_x, in_y] = mirrors(&volume.nodes, &[0]).unwrap();
        for (n, p) in volume.nodes.iter().enumerate() {
            assert_eq!((in_x[in_x[n]], in_y[in_y[n]]), (n, n));
            assert_eq!(volume.nodes[in_x[n]][0], -p[0]);
            assert_eq!(volume.nodes[in_y[n]][1], -p[1]);
        }
        assert!(mirrors(&[[1.0, 0.0, 0.0]], &[0]).is_none());
    }
}
