//! Upright cylinder: liquid volume with its axis, and wall.
//!
//! Chart coordinates are (r, θ, z). Local directions of a hexahedron: r along the radius, s along θ, t along z. The nodes
//! of a level on the axis are one node; the hexahedra around it are wedges whose inner face is collapsed, but each keeps
//! its own θ there.

use std::f64::consts::TAU;

use super::{Face, Hexahedron, MeshError, check_ascending};
use crate::chart::Chart;

/// Places of the nodes of a cylinder mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    /// Radii of the node rings [m], ascending from 0 to R.
    pub radii: Vec<f64>,
    /// Number of sectors in the full circle.
    pub sectors: usize,
    /// Heights of the node levels [m], ascending.
    pub heights: Vec<f64>,
}

/// Liquid volume of a cylinder.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// Positions of the nodes, global Cartesian [m].
    pub nodes: Vec<[f64; 3]>,
    /// Hexahedra.
    pub cells: Vec<Hexahedron>,
    /// Faces at r = R, normal outwards.
    pub wall: Vec<Face>,
    /// Faces at the lowest level, normal downwards.
    pub bottom: Vec<Face>,
    /// Faces at the highest level, normal upwards.
    pub surface: Vec<Face>,
    /// Nodes on the axis, from below.
    pub axis: Vec<usize>,
    /// Nodes at r = R: `wall_nodes[level][sector]`, θ = sector · 2π/sectors.
    pub wall_nodes: Vec<Vec<usize>>,
    /// Nodes of the lowest level.
    pub bottom_nodes: Vec<usize>,
    /// Nodes of the highest level.
    pub surface_nodes: Vec<usize>,
}

/// Mantle of a cylinder.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Positions of the nodes, global Cartesian [m].
    pub nodes: Vec<[f64; 3]>,
    /// Quadrilaterals, normal outwards; local r along θ, s along z.
    pub cells: Vec<Face>,
    /// Node numbers: `rows[level][sector]`.
    pub rows: Vec<Vec<usize>>,
}

impl Cylinder {
    /// Angle of a ray of nodes [rad].
    pub fn theta(&self, sector: usize) -> f64 {
        TAU * sector as f64 / self.sectors as f64
    }

    /// Radius R [m].
    pub fn radius(&self) -> f64 {
        self.radii.last().copied().unwrap_or(0.0)
    }

    fn check(&self) -> Result<(), MeshError> {
        if self.sectors < 3 {
            return Err(MeshError::Range { what: "sectors", found: self.sectors.to_string(), allowed: "3 or more" });
        }
        check_ascending("heights", &self.heights, 2)
    }

    /// The liquid volume.
    ///
    /// Errors: fewer than 3 sectors, radii that do not ascend from 0, heights that do not ascend.
    // Long: one numbering of nodes, read by the cells and by every face that follows.
    pub fn volume(&self) -> Result<Volume, MeshError> {
        self.check()?;
        check_ascending("radii", &self.radii, 2)?;
        if self.radii[0] != 0.0 {
            return Err(MeshError::Range {
                what: "radii",
                found: format!("first radius {}", self.radii[0]),
                allowed: "0, the axis",
            });
        }
        let (rings, sectors, levels) = (self.radii.len() - 1, self.sectors, self.heights.len());
        let per_level = 1 + rings * sectors;
        let number = |level: usize, ring: usize, sector: usize| {
            level * per_level + if ring == 0 { 0 } else { 1 + (ring - 1) * sectors + sector % sectors }
        };
        let place =
            |level: usize, ring: usize, sector: usize| [self.radii[ring], self.theta(sector), self.heights[level]];
        let mut nodes = Vec::with_capacity(levels * per_level);
        for level in 0..levels {
            nodes.push([0.0, 0.0, self.heights[level]]);
            for ring in 1..=rings {
                for sector in 0..sectors {
                    nodes.push(Chart::Cylindrical.position(place(level, ring, sector)));
                }
            }
        }
        let mut volume = Volume {
            nodes,
            cells: Vec::new(),
            wall: Vec::new(),
            bottom: Vec::new(),
            surface: Vec::new(),
            axis: (0..levels).map(|l| number(l, 0, 0)).collect(),
            wall_nodes: (0..levels).map(|l| (0..sectors).map(|s| number(l, rings, s)).collect()).collect(),
            bottom_nodes: (0..per_level).collect(),
            surface_nodes: ((levels - 1) * per_level..levels * per_level).collect(),
        };
        let face = |corners: [(usize, usize, usize); 4]| Face {
            nodes: corners.map(|(l, r, s)| number(l, r, s)),
            chart: corners.map(|(l, r, s)| place(l, r, s)),
        };
        for l in 0..levels - 1 {
            for r in 0..rings {
                for s in 0..sectors {
                    let corners = [
                        (l, r, s),
                        (l, r + 1, s),
                        (l, r + 1, s + 1),
                        (l, r, s + 1),
                        (l + 1, r, s),
                        (l + 1, r + 1, s),
                        (l + 1, r + 1, s + 1),
                        (l + 1, r, s + 1),
                    ];
                    volume.cells.push(Hexahedron {
                        nodes: corners.map(|(l, r, s)| number(l, r, s)),
                        chart: corners.map(|(l, r, s)| place(l, r, s)),
                    });
                    if l == 0 {
                        let c = [(0, r, s), (0, r, s + 1), (0, r + 1, s + 1), (0, r + 1, s)];
                        volume.bottom.push(face(c));
                    }
                    if l + 2 == levels {
                        let top = l + 1;
                        let c = [(top, r, s), (top, r + 1, s), (top, r + 1, s + 1), (top, r, s + 1)];
                        volume.surface.push(face(c));
                    }
                    if r + 1 == rings {
                        let c = [(l, rings, s), (l, rings, s + 1), (l + 1, rings, s + 1), (l + 1, rings, s)];
                        volume.wall.push(face(c));
                    }
                }
            }
        }
        Ok(volume)
    }

    /// The mantle at r = R.
    ///
    /// Errors: fewer than 3 sectors, no radius, heights that do not ascend.
    pub fn wall(&self) -> Result<Wall, MeshError> {
        self.check()?;
        let (sectors, levels, radius) = (self.sectors, self.heights.len(), self.radius());
        if radius <= 0.0 || !radius.is_finite() {
            return Err(MeshError::Range { what: "radius", found: radius.to_string(), allowed: "a positive number" });
        }
        let place = |l: usize, s: usize| [radius, self.theta(s), self.heights[l]];
        let number = |l: usize, s: usize| l * sectors + s % sectors;
        let mut wall = Wall {
            nodes: Vec::new(),
            cells: Vec::new(),
            rows: (0..levels).map(|l| (0..sectors).map(|s| number(l, s)).collect()).collect(),
        };
        for l in 0..levels {
            for s in 0..sectors {
                wall.nodes.push(Chart::Cylindrical.position(place(l, s)));
            }
        }
        for l in 0..levels - 1 {
            for s in 0..sectors {
                let corners = [(l, s), (l, s + 1), (l + 1, s + 1), (l + 1, s)];
                wall.cells
                    .push(Face { nodes: corners.map(|(l, s)| number(l, s)), chart: corners.map(|(l, s)| place(l, s)) });
            }
        }
        Ok(wall)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{gauss, hex8};

    fn sample() -> Cylinder {
        Cylinder { radii: vec![0.0, 0.7, 1.5, 2.0], sectors: 12, heights: vec![0.0, 1.0, 2.5] }
    }

    /// In the cylindrical chart the volume is exact: π R² H.
    #[test]
    fn volume_and_counts() {
        let volume = sample().volume().unwrap();
        assert_eq!(volume.nodes.len(), 3 * (1 + 3 * 12));
        assert_eq!(volume.cells.len(), 2 * 3 * 12);
        assert_eq!((volume.wall.len(), volume.bottom.len(), volume.surface.len()), (24, 36, 36));
        let mut sum = 0.0;
        for cell in &volume.cells {
            for &(r, wr) in gauss::TWO {
                for &(s, ws) in gauss::TWO {
                    for &(t, wt) in gauss::TWO {
                        let n = hex8::value(r, s, t);
                        let d = hex8::slope(r, s, t);
                        let mut x = [0.0; 3];
                        let mut j = nalgebra::Matrix3::<f64>::zeros();
                        for a in 0..8 {
                            for i in 0..3 {
                                x[i] += n[a] * cell.chart[a][i];
                                for k in 0..3 {
                                    j[(k, i)] += d[a][k] * cell.chart[a][i];
                                }
                            }
                        }
                        let det = j.determinant();
                        assert!(det > 0.0);
                        sum += wr * ws * wt * det * Chart::Cylindrical.volume_factor(x);
                    }
                }
            }
        }
        let exact = std::f64::consts::PI * 4.0 * 2.5;
        assert!((sum / exact - 1.0).abs() < 1e-12, "{sum} {exact}");
    }

    /// Cartesian corners of every hexahedron are right-handed, and every cell reproduces its nodes' places.
    #[test]
    fn cells_are_right_handed_in_space() {
        let volume = sample().volume().unwrap();
        for cell in &volume.cells {
            let p = cell.nodes.map(|n| nalgebra::Vector3::from(volume.nodes[n]));
            for (a, c) in cell.chart.iter().enumerate() {
                assert!((nalgebra::Vector3::from(Chart::Cylindrical.position(*c)) - p[a]).norm() < 1e-12);
            }
            // Edge vectors at corner 2 (never on the axis).
            let det = (p[1] - p[0]).cross(&(p[2] - p[1])).dot(&(p[5] - p[1]));
            assert!(det > 1e-6);
        }
    }

    #[test]
    fn bad_counts_are_rejected() {
        let bad = Cylinder { sectors: 0, ..sample() };
        assert!(bad.volume().is_err() && bad.wall().is_err());
        let bad = Cylinder { heights: vec![0.0, -1.0], ..sample() };
        assert!(bad.volume().is_err());
        let bad = Cylinder { radii: vec![0.1, 1.0], ..sample() };
        assert!(bad.volume().is_err());
    }
}
