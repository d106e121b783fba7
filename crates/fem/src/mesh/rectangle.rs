//! Rectangular tank: block of hexahedra.
//!
//! node = i + n_x (j + n_y k) at (x_i, y_j, z_k); the local directions r, s, t of a hexahedron run along x, y, z. One
//! element along y makes a strip of finite breadth.

use super::{Face, Hexahedron, MeshError, check_ascending};

/// Places of the nodes of a rectangular mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Rectangle {
    /// x of the node planes [m], ascending.
    pub x: Vec<f64>,
    /// y of the node planes [m], ascending.
    pub y: Vec<f64>,
    /// z of the node planes [m], ascending.
    pub z: Vec<f64>,
}

/// Faces and nodes of one side of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Side {
    /// Faces, normal outwards.
    pub faces: Vec<Face>,
    /// Nodes, ascending.
    pub nodes: Vec<usize>,
}

/// Block of hexahedra.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Positions of the nodes, global Cartesian [m].
    pub nodes: Vec<[f64; 3]>,
    /// Hexahedra.
    pub cells: Vec<Hexahedron>,
    /// Sides −x, +x.
    pub x_walls: [Side; 2],
    /// Sides −y, +y.
    pub y_walls: [Side; 2],
    /// Side −z.
    pub bottom: Side,
    /// Side +z.
    pub surface: Side,
}

impl Rectangle {
    /// The block.
    ///
    /// Errors: no element in a direction, places that do not ascend.
    pub fn block(&self) -> Result<Block, MeshError> {
        check_ascending("x", &self.x, 2)?;
        check_ascending("y", &self.y, 2)?;
        check_ascending("z", &self.z, 2)?;
        let count = [self.x.len(), self.y.len(), self.z.len()];
        let number = |c: [usize; 3]| c[0] + count[0] * (c[1] + count[1] * c[2]);
        let place = |c: [usize; 3]| [self.x[c[0]], self.y[c[1]], self.z[c[2]]];
        let mut block = Block {
            nodes: Vec::with_capacity(count.iter().product()),
            cells: Vec::with_capacity(count.iter().map(|n| n - 1).product()),
            x_walls: [0, 1].map(|end| self.side(0, end, number, place)),
            y_walls: [0, 1].map(|end| self.side(1, end, number, place)),
            bottom: self.side(2, 0, number, place),
            surface: self.side(2, 1, number, place),
        };
        for k in 0..count[2] {
            for j in 0..count[1] {
                for i in 0..count[0] {
                    block.nodes.push(place([i, j, k]));
                    if i + 1 < count[0] && j + 1 < count[1] && k + 1 < count[2] {
                        let corners = [
                            [i, j, k],
                            [i + 1, j, k],
                            [i + 1, j + 1, k],
                            [i, j + 1, k],
                            [i, j, k + 1],
                            [i + 1, j, k + 1],
                            [i + 1, j + 1, k + 1],
                            [i, j + 1, k + 1],
                        ];
                        block.cells.push(Hexahedron { nodes: corners.map(number), chart: corners.map(place) });
                    }
                }
            }
        }
        Ok(block)
    }

    /// The side normal to `axis` at its beginning (`end` = 0) or end (1).
    fn side(
        &self,
        axis: usize,
        end: usize,
        number: impl Fn([usize; 3]) -> usize,
        place: impl Fn([usize; 3]) -> [f64; 3],
    ) -> Side {
        let count = [self.x.len(), self.y.len(), self.z.len()];
        // e_axis = e_p × e_q, so the order p, q is counter-clockwise seen from +axis.
        let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
        let at = |i: usize, j: usize| {
            let mut c = [0; 3];
            (c[axis], c[p], c[q]) = (end * (count[axis] - 1), i, j);
            c
        };
        let mut side = Side::default();
        for j in 0..count[q] {
            for i in 0..count[p] {
                side.nodes.push(number(at(i, j)));
                if i + 1 < count[p] && j + 1 < count[q] {
                    let mut corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    if end == 0 {
                        corners.reverse();
                    }
                    side.faces.push(Face { nodes: corners.map(&number), chart: corners.map(&place) });
                }
            }
        }
        side.nodes.sort_unstable();
        side
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn sample() -> Rectangle {
        Rectangle { x: vec![-1.0, 0.0, 0.5, 2.0], y: vec![0.0, 0.7, 1.0], z: vec![0.0, 0.5] }
    }

    /// Twice the area vector of a quadrilateral.
    fn normal(face: &Face) -> Vector3<f64> {
        let p = face.chart.map(Vector3::from);
        (p[2] - p[0]).cross(&(p[3] - p[1]))
    }

    #[test]
    fn volumes_sides_and_sets() {
        let block = sample().block().unwrap();
        assert_eq!((block.nodes.len(), block.cells.len()), (4 * 3 * 2, 3 * 2));
        let mut volume = 0.0;
        for cell in &block.cells {
            let p = cell.chart.map(Vector3::from);
            let own = (p[1] - p[0]).cross(&(p[3] - p[0])).dot(&(p[4] - p[0]));
            assert!(own > 0.0);
            volume += own;
            for (node, place) in cell.nodes.iter().zip(&cell.chart) {
                assert_eq!(block.nodes[*node], *place);
            }
        }
        assert!((volume - 1.5).abs() < 1e-14);
        let sides = [
            (&block.x_walls[0], 0, -1.0, 0.5, -1.0, 6),
            (&block.x_walls[1], 0, 1.0, 0.5, 2.0, 6),
            (&block.y_walls[0], 1, -1.0, 1.5, 0.0, 8),
            (&block.y_walls[1], 1, 1.0, 1.5, 1.0, 8),
            (&block.bottom, 2, -1.0, 3.0, 0.0, 12),
            (&block.surface, 2, 1.0, 3.0, 0.5, 12),
        ];
        for (side, axis, sign, area, level, nodes) in sides {
            assert_eq!(side.nodes.len(), nodes);
            assert!(side.nodes.iter().all(|&n| block.nodes[n][axis] == level));
            let sum: Vector3<f64> = side.faces.iter().map(|f| 0.5 * normal(f)).sum();
            assert!((sum[axis] - sign * area).abs() < 1e-14, "{axis} {sum}");
            for face in &side.faces {
                assert!(sign * normal(face)[axis] > 0.0);
                for (node, place) in face.nodes.iter().zip(&face.chart) {
                    assert_eq!(block.nodes[*node], *place);
                }
            }
        }
    }

    #[test]
    fn bad_places_are_rejected() {
        assert!(Rectangle { x: vec![0.0], ..sample() }.block().is_err());
        assert!(Rectangle { y: vec![], ..sample() }.block().is_err());
        let bad = Rectangle { z: vec![0.0, 0.0], ..sample() };
        assert!(bad.block().is_err());
    }
}
