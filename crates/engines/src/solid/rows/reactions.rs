//! Rows of reactions and moments at the base.

use std::collections::BTreeMap;

use fem::chart::Chart;
use fem::dofs::{Dof, KINDS};
use fem::element::{local_size, reference_mass, reference_stiffness};
use fem::shape::{gauss, quad4};

use super::super::model::{JOINT, LIQUID};
use super::{Observer, Row, sparse, tilt};
use crate::FeError;
use crate::error::failed;
use tank::options::solid::Liquid;

impl Observer<'_> {
    /// Reaction of a dof of the clamped edge at θ = 0 over the length of edge that belongs to the node [N/m or N].
    ///
    /// Errors: an element without stiffness.
    pub(in crate::solid) fn edge_reaction(&self, dof: Dof) -> Result<Row, FeError> {
        self.edge_reaction_at(0, dof)
    }

    /// The same at another node of the edge.
    ///
    /// Errors: an element without stiffness.
    pub(in crate::solid) fn edge_reaction_at(&self, sector: usize, dof: Dof) -> Result<Row, FeError> {
        let tank = self.tank;
        let node = tank.wall.rows[0][sector];
        let ground = self.ground();
        let (mut elastic, mut inertia, mut held) = (BTreeMap::new(), BTreeMap::new(), 0.0);
        let elements = tank.wall.elements.iter().chain(&tank.wall.loaded);
        for element in elements.map(|&e| &*tank.model.elements()[e]) {
            let Some(corner) = element.nodes().iter().position(|&n| n == node) else { continue };
            let before: usize = (0..corner).map(|a| element.dofs(a).len()).sum();
            let Some(place) = element.dofs(corner).iter().position(|&d| d == dof) else { continue };
            let (i, n) = (before + place, local_size(element));
            let k = reference_stiffness(element).map_err(failed)?;
            let m = reference_mass(element);
            for (matrix, out) in [(&k, &mut elastic), (&m, &mut inertia)] {
                let local: Vec<f64> = (0..n).map(|j| matrix.get(i, j)).collect();
                for (e, c) in tank.model.spread(element, &local) {
                    *out.entry(e).or_insert(0.0) += c;
                }
            }
            let mut j = 0;
            for (a, &other) in element.nodes().iter().enumerate() {
                for d in element.dofs(a) {
                    if tank.model.is_held(other, *d) {
                        held += m.get(i, j) * ground[d.index()];
                    }
                    j += 1;
                }
            }
        }
        let row =
            Row { displacement: elastic.into_iter().collect(), acceleration: inertia.into_iter().collect(), held };
        Ok(row.scaled(1.0 / tank.edge))
    }

    /// Moment above the base plate: inertia of wall and roof, and the liquid's pressure on the wall.
    ///
    /// Errors: an element without stiffness.
    pub(in crate::solid) fn base_moment(&self) -> Result<Row, FeError> {
        let tank = self.tank;
        let nodes = tank.model.nodes();
        match tank.liquid {
            // The mass matrix holds the pressure.
            Liquid::Potential => Ok(self.inertia(&|node| tilt(nodes[node]))),
            Liquid::Displacement => {
                let count = tank.wall.rows.len() * tank.division.sectors;
                let wall = |node: usize| if node < count { tilt(nodes[node]) } else { [0.0; KINDS] };
                let joint = tank.assembler.stiffness_of(&tank.model, |e| tank.is_in(e, &[JOINT])).map_err(failed)?;
                let mut row = self.inertia(&wall);
                row.displacement = sparse(&joint.times(&tank.model.vector(wall)));
                Ok(row)
            }
        }
    }

    /// Moment of the pressure on the bottom, ∫ p x dA with the sign of an inertia force.
    ///
    /// Errors: an element without stiffness.
    pub(in crate::solid) fn bottom_moment(&self) -> Result<Row, FeError> {
        if self.tank.liquid == Liquid::Displacement {
            return self.bottom_reaction();
        }
        let mut row: BTreeMap<usize, f64> = BTreeMap::new();
        for face in &self.tank.volume.bottom {
            for &(s, ws) in gauss::THREE {
                for &(r, wr) in gauss::THREE {
                    let (n, d) = (quad4::value(r, s), quad4::slope(r, s));
                    let (mut x, mut j) = ([0.0; 2], [[0.0; 2]; 2]);
                    for (a, c) in face.chart.iter().enumerate() {
                        for i in 0..2 {
                            x[i] += n[a] * c[i];
                            j[0][i] += d[a][0] * c[i];
                            j[1][i] += d[a][1] * c[i];
                        }
                    }
                    let plane = (j[0][0] * j[1][1] - j[0][1] * j[1][0]).abs() * wr * ws;
                    let (area, arm) = match self.tank.chart {
                        Chart::Cylindrical => (plane * x[0], x[0] * x[1].cos()),
                        Chart::Cartesian => (plane, x[0]),
                    };
                    for (a, &node) in face.nodes.iter().enumerate() {
                        for (e, c) in self.row(node, Dof::Phi) {
                            *row.entry(e).or_insert(0.0) += self.tank.density * area * n[a] * arm * c;
                        }
                    }
                }
            }
        }
        Ok(Row { acceleration: row.into_iter().collect(), ..Row::default() })
    }

    /// The same from the reactions of the liquid's bottom nodes, −Σ x R_z.
    fn bottom_reaction(&self) -> Result<Row, FeError> {
        let tank = self.tank;
        let nodes = tank.model.nodes();
        let lever: BTreeMap<usize, f64> = tank.volume.bottom_nodes.iter().map(|&n| (n, -nodes[n][0])).collect();
        let (mut elastic, mut inertia) = (vec![0.0; tank.model.dofs().len()], vec![0.0; tank.model.dofs().len()]);
        for (e, element) in tank.model.elements().iter().enumerate() {
            if !tank.is_in(e, &[LIQUID]) || !element.nodes().iter().any(|n| lever.contains_key(n)) {
                continue;
            }
            let n = local_size(&**element);
            let mut weights = vec![0.0; n];
            let mut k = 0;
            for (a, node) in element.nodes().iter().enumerate() {
                for dof in element.dofs(a) {
                    if *dof == Dof::Uz {
                        weights[k] = lever.get(node).copied().unwrap_or(0.0);
                    }
                    k += 1;
                }
            }
            let stiffness = reference_stiffness(&**element).map_err(failed)?.to_matrix();
            let mass = reference_mass(&**element).to_matrix();
            for (matrix, out) in [(&stiffness, &mut elastic), (&mass, &mut inertia)] {
                for (i, c) in tank.model.spread(&**element, &matrix.times(&weights)) {
                    out[i] += c;
                }
            }
        }
        Ok(Row { displacement: sparse(&elastic), acceleration: sparse(&inertia), held: 0.0 })
    }
}
