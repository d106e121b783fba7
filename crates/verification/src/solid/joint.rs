//! The joint: partly closed faces, and two blocks pressed together.
//!
//! Source:    theory sheet on solid and contact, C7
//! Model:     one joint on the square 2 × 2 m; two blocks 1 × 1 × 0.5 m of 2 × 2 × 1 bricks whose inner nodes are moved off
//!            the grid, with a joint between them, pressed by 1 MPa, free to widen
//! Reference: ∫ N_a k_n x dA over the closed half by hand: k_n (5, 1, 1, 5)/12; the uniform pressure itself
//! Tolerance: rounding of the integrals; 1e-8 of the pressure, whose rounding grows with the penalty (k_n h/E = 10³)

use nalgebra::UnitQuaternion;

use super::{column, opening, solve};
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};
use fem::assembly::{Assembler, local_values};
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::contact8::{Contact8, ContactLaw, Opening};
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::element::{Element, Inspect, Motion, Response, Trial, Want};
use fem::mesh::Face;
use fem::model::{Builder, Model};
use fem::shape::quad4;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "contact-joint",
    title: "Joint between two bodies",
    model: "`contact8`: integrals over a partly closed face of 2 × 2 m; two blocks of bricks pressed by 1 MPa.",
    ids: &[("C7", "joint partly closed, blocks pressed together, joint that opens")],
    parts: &[Part::Fast(rows), Part::Fast(opening::rows), Part::Fast(column::rows)],
};

/// Young's modulus [Pa], Poisson's ratio, pressure [Pa], height of a block [m].
const MODULUS: f64 = 3e10;

const POISSON: f64 = 0.2;

const PRESSURE: f64 = 1e6;

const HEIGHT: f64 = 0.5;

const UP: [[f64; 3]; 4] = [[0.0, 0.0, 1.0]; 4];

/// Forces on the top nodes, per k_n, of a joint on the square that transmits no tension.
fn half_closed(gaps: [f64; 4]) -> Result<[f64; 4], Failure> {
    let face = Face { nodes: [4, 5, 6, 7], chart: quad4::CORNERS.map(|[x, y]| [x, y, 0.0]) };
    let law = ContactLaw { opening: Opening::Unilateral { residual: 0.0 }, ..ContactLaw::bonded(1.0) };
    let joint = Contact8::new(&face, Chart::Cartesian, [0, 1, 2, 3], [4, 5, 6, 7], UP, law)?;
    let mut values = [0.0; 24];
    for a in 0..4 {
        values[3 * a + 2] = gaps[a];
    }
    let motion = Motion { values: &values, rotations: &[UnitQuaternion::identity(); 8] };
    let mut response = Response::sized(24);
    joint.respond(Trial { motion, old: &[], new: &mut [], want: Want::FORCE }, &mut response)?;
    Ok(std::array::from_fn(|a| response.force[3 * a + 2]))
}

/// Two blocks and the joint between them.
pub(super) struct Blocks {
    pub(super) model: Model,
    pub(super) assembler: Assembler,
    load: Vec<f64>,
    joints: Vec<usize>,
    top: usize,
}

impl Blocks {
    /// With the penalty k_n = `factor` E/h.
    pub(super) fn new(factor: f64) -> Result<Blocks, Failure> {
        let mut builder = Builder::new();
        // Nodes of a level: 3 × 3, the middle one and those in the middle of the sides moved.
        let plan: Vec<[f64; 2]> = (0..9)
            .map(|k| {
                let (i, j) = (k % 3, k / 3);
                let shift = |moves: bool, by: f64| if moves { by } else { 0.0 };
                [
                    0.5 * i as f64 + shift(i == 1, 0.08 - 0.05 * j as f64),
                    0.5 * j as f64 + shift(j == 1, 0.06 * i as f64 - 0.09),
                ]
            })
            .collect();
        for z in [0.0, HEIGHT, HEIGHT, 2.0 * HEIGHT] {
            for &[x, y] in &plan {
                let node = builder.node([x, y, z]);
                if x == 0.0 {
                    builder.hold(node, Dof::Ux);
                }
                if y == 0.0 {
                    builder.hold(node, Dof::Uy);
                }
                if z == 0.0 {
                    builder.hold(node, Dof::Uz);
                }
            }
        }
        let cells: Vec<[usize; 4]> = [0, 1, 3, 4].iter().map(|&k| [k, k + 1, k + 4, k + 3]).collect();
        let material = Elastic::isotropic(MODULUS, POISSON, 0.0);
        for base in [0, 18] {
            for cell in &cells {
                let mut nodes = [0; 8];
                for a in 0..4 {
                    nodes[a] = base + cell[a];
                    nodes[4 + a] = base + 9 + cell[a];
                }
                let corners = nodes.map(|n| builder.position(n));
                builder.element("block", Solid8::new(nodes, corners, material, Kinematics::Linear)?);
            }
        }
        let mut joints = Vec::new();
        let mut forces = vec![0.0; 36];
        for cell in &cells {
            let (bottom, top) = (cell.map(|n| 9 + n), cell.map(|n| 18 + n));
            let face = Face { nodes: bottom, chart: bottom.map(|n| builder.position(n)) };
            let law = ContactLaw::bonded(factor * MODULUS / HEIGHT);
            let joint = Contact8::new(&face, Chart::Cartesian, top, bottom, UP, law)?;
            joints.push(builder.element("joint", joint));
            // ∫ N_a p dA over the same quadrilateral on top.
            for &(r, wr) in fem::shape::gauss::TWO {
                for &(s, ws) in fem::shape::gauss::TWO {
                    let slopes = quad4::slope(r, s);
                    let along = |d: usize, i: usize| (0..4).map(|a| slopes[a][d] * plan[cell[a]][i]).sum::<f64>();
                    let area = along(0, 0) * along(1, 1) - along(0, 1) * along(1, 0);
                    for (a, n) in quad4::value(r, s).iter().enumerate() {
                        forces[27 + cell[a]] -= wr * ws * area * n * PRESSURE;
                    }
                }
            }
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let load = model.vector(|node| {
            let mut f = [0.0; fem::dofs::KINDS];
            f[2] = forces[node];
            f
        });
        Ok(Blocks { model, assembler, load, joints, top: 35 })
    }

    /// Largest relative deviation of the joint's pressure from the one applied, and displacement of the top over that
    /// without a joint.
    pub(super) fn press(&self) -> Result<(f64, f64), Failure> {
        let u = solve(&self.model, &self.assembler, &self.load)?;
        let mut worst = 0.0_f64;
        for &e in &self.joints {
            let element = &*self.model.elements()[e];
            let values = local_values(&self.model, element, &u);
            for sample in element.samples().iter().filter(|s| s.name == "contact_pressure") {
                let pressure: f64 = sample.row.iter().zip(&values).map(|(c, u)| c * u).sum();
                worst = worst.max((pressure / PRESSURE - 1.0).abs());
            }
        }
        let top = self.model.at_node(&u, self.top)[2];
        Ok((worst, top / (-PRESSURE * 2.0 * HEIGHT / MODULUS)))
    }
}

/// C7.
pub(super) fn rows() -> Answer {
    let mut rows = Vec::new();
    let found = half_closed([-1.0, 1.0, 1.0, -1.0])?;
    for (a, exact) in [-5.0, -1.0, -1.0, -5.0].into_iter().enumerate() {
        rows.push(Row::new(
            "C7",
            format!("force per k_n at corner {} of the half-closed square", a + 1),
            (exact / 12.0, "∫ N_a x dA over x < 0, by hand", Reference::ClosedForm),
            found[a],
            (1e-12, "m³"),
        ));
    }
    for (what, gap, exact) in [("closed", -1.0, -1.0), ("open", 1.0, 0.0)] {
        rows.push(Row::new(
            "C7",
            format!("force per k_n at a corner, uniformly {what}"),
            (exact, "a quarter of the area, by hand", Reference::ClosedForm),
            half_closed([gap; 4])?[0],
            (1e-12, "m³"),
        ));
    }
    let (worst, shortening) = Blocks::new(1e3)?.press()?;
    rows.push(Row::new(
        "C7",
        "two blocks pressed together: deviation of the joint's pressure",
        (0.0, "uniform pressure", Reference::ClosedForm),
        worst,
        (1e-8, ""),
    ));
    // The joint adds p/k_n to 2 p h/E: a share of 1/(2 k_n h/E).
    rows.push(Row::new(
        "C7",
        "two blocks pressed together: shortening over that without joint",
        (1.0 + 0.5e-3, "1 + E/(2 k_n h)", Reference::ClosedForm),
        shortening,
        (1e-9, ""),
    ));
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table of docs/theory/solid-and-contact.md, 2.3: the joint in series increases the displacement by E/(2 k_n h), and
    /// the error of the pressure by rounding is below the condition number times the machine's precision. The displacement
    /// keeps an error of 7e-9 at the stiffest joints.
    #[test]
    fn penalty_on_two_blocks() {
        for power in -1..=9 {
            let factor = 10_f64.powi(power);
            let blocks = Blocks::new(factor).unwrap();
            let (worst, shortening) = blocks.press().unwrap();
            let k = blocks.assembler.stiffness(&blocks.model).unwrap().to_dense();
            let values = nalgebra::DMatrix::from_column_slice(k.rows, k.rows, &k.data).symmetric_eigenvalues();
            let condition = values.max() / values.min();
            println!("1e{power}: {worst:.1e} {:.1e} {condition:.1e}", shortening - 1.0);
            let rounding = condition * f64::EPSILON;
            assert!(worst < rounding, "{power}: {worst} {condition}");
            assert!((shortening - 1.0 - 0.5 / factor).abs() < 1e-8 + rounding, "{power}: {shortening}");
        }
    }
}
