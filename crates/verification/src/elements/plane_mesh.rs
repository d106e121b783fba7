//! Vertical strip of a rectangular tank: plane mesh in (x, z), y = 0.
//!
//! ```text
//! z ▲   surface
//!   │  k─k+1─ …        node = i + (number of x) · j
//!   │  │  │
//!   │  0──1── …        cells: 1 2 3 4 counter-clockwise, seen from −y
//!   └────────► x
//! ```

use fem::mesh::{Face, MeshError, check_ascending};

/// Places of the nodes of a strip.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// x of the node columns [m], ascending.
    pub x: Vec<f64>,
    /// z of the node rows [m], ascending.
    pub z: Vec<f64>,
}

/// Plane mesh of a strip.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Positions of the nodes, global Cartesian [m].
    pub nodes: Vec<[f64; 3]>,
    /// Quadrilaterals.
    pub cells: Vec<Face>,
    /// Lines of the surface, towards greater x.
    pub surface: Vec<[usize; 2]>,
    /// Nodes at the least x, from below.
    pub left_nodes: Vec<usize>,
    /// Nodes at the greatest x, from below.
    pub right_nodes: Vec<usize>,
    /// Nodes at the least z.
    pub bottom_nodes: Vec<usize>,
    /// Nodes at the greatest z.
    pub surface_nodes: Vec<usize>,
}

impl Strip {
    /// The plane mesh.
    ///
    /// Errors: no element in a direction, places that do not ascend.
    pub fn plane(&self) -> Result<Plane, MeshError> {
        check_ascending("x", &self.x, 2)?;
        check_ascending("z", &self.z, 2)?;
        let (columns, rows) = (self.x.len(), self.z.len());
        let number = |i: usize, j: usize| i + columns * j;
        let place = |i: usize, j: usize| [self.x[i], 0.0, self.z[j]];
        let mut plane = Plane {
            nodes: Vec::with_capacity(columns * rows),
            cells: Vec::with_capacity((columns - 1) * (rows - 1)),
            surface: (0..columns - 1).map(|i| [number(i, rows - 1), number(i + 1, rows - 1)]).collect(),
            left_nodes: (0..rows).map(|j| number(0, j)).collect(),
            right_nodes: (0..rows).map(|j| number(columns - 1, j)).collect(),
            bottom_nodes: (0..columns).map(|i| number(i, 0)).collect(),
            surface_nodes: (0..columns).map(|i| number(i, rows - 1)).collect(),
        };
        for j in 0..rows {
            for i in 0..columns {
                plane.nodes.push(place(i, j));
            }
        }
        for j in 0..rows - 1 {
            for i in 0..columns - 1 {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                plane
                    .cells
                    .push(Face { nodes: corners.map(|(i, j)| number(i, j)), chart: corners.map(|(i, j)| place(i, j)) });
            }
        }
        Ok(plane)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Area by the shoelace formula, in (x, z).
    fn area(face: &Face) -> f64 {
        (0..4)
            .map(|a| {
                let (p, q) = (face.chart[a], face.chart[(a + 1) % 4]);
                0.5 * (p[0] * q[2] - q[0] * p[2])
            })
            .sum()
    }

    #[test]
    fn areas_and_sets() {
        let strip = Strip { x: vec![-1.0, 0.0, 0.5, 2.0], z: vec![0.0, 0.4, 1.0] };
        let plane = strip.plane().unwrap();
        assert_eq!((plane.nodes.len(), plane.cells.len(), plane.surface.len()), (12, 6, 3));
        assert!(plane.cells.iter().all(|c| area(c) > 0.0));
        assert!((plane.cells.iter().map(area).sum::<f64>() - 3.0).abs() < 1e-14);
        for cell in &plane.cells {
            for (node, place) in cell.nodes.iter().zip(&cell.chart) {
                assert_eq!(plane.nodes[*node], *place);
            }
        }
        assert!(plane.left_nodes.iter().all(|&n| plane.nodes[n][0] == -1.0));
        assert!(plane.right_nodes.iter().all(|&n| plane.nodes[n][0] == 2.0));
        assert!(plane.bottom_nodes.iter().all(|&n| plane.nodes[n][2] == 0.0));
        assert!(plane.surface_nodes.iter().all(|&n| plane.nodes[n][2] == 1.0));
        assert_eq!((plane.left_nodes.len(), plane.bottom_nodes.len()), (3, 4));
        let length: f64 = plane.surface.iter().map(|l| plane.nodes[l[1]][0] - plane.nodes[l[0]][0]).sum();
        assert_eq!(length, 3.0);
    }

    #[test]
    fn bad_places_are_rejected() {
        for (x, z) in [
            (vec![], vec![0.0, 1.0]),
            (vec![0.0], vec![0.0, 1.0]),
            (vec![0.0, 1.0], vec![1.0, 0.0]),
            (vec![0.0, f64::NAN], vec![0.0, 1.0]),
        ] {
            assert!(Strip { x, z }.plane().is_err());
        }
    }
}
