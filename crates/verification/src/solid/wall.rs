//! Wall of example 8.4: concrete, layer and liner under the pressure of the liquid; and the concrete alone.
//!
//! Source:    dissertation, figure 8.9: concrete 0.30 m, E 3.4e7 kN/m², ν 0.2, γ 25 kN/m³; liner 6 mm, 2.1e8, 0.3; layer
//!            5 cm; wall 3.00 m, liquid 2.57 m of 10 kN/m³; strip 1 m, plane strain
//! Model:     beams at both edges of the strip, each with half its stiffness; between them solid8 with stiffness along its
//!            normal only, whose faces are the axes of the beams
//! Reference: two Bernoulli beams with k = e_normal/0.05 m between them. With s = E I_c w_c + E I_l w_l, d = w_l − w_c:
//!            s'''' = p (the cantilever), d'''' + 4 β⁴ d = p/E I_l, 4 β⁴ = k (1/E I_c + 1/E I_l); clamped below, free above
//! Tolerance: the error that the refinement in the rows shows; β is 4 … 250 1/m, the mesh is graded to the base

use nalgebra::{SMatrix, SVector};

use super::solve;
use crate::elements::beam2::{Beam2, BeamSection};
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};
use fem::assembly::Assembler;
use fem::dofs::{Dof, KINDS};
use fem::element::interlayer;
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::mesh::grading;
use fem::model::{Builder, Model};
use fem::shape::{gauss, line};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "layered-wall",
    title: "Layered wall of example 8.4",
    model: "Concrete 0.30 m, layer 0.05 m, liner 6 mm; 3.00 m high, 2.57 m of liquid of 10 kN/m³, strip of 1 m \
            in plane strain; beams with `solid8` of stiffness along its normal between them.",
    ids: &[
        ("C9", "concrete, layer and liner under the liquid"),
        ("C10", "concrete wall alone under the liquid and its weight"),
    ],
    parts: &[Part::Fast(layered), Part::Fast(alone)],
};

pub(super) const HEIGHT: f64 = 3.0;

pub(super) const DEPTH: f64 = 2.57;

const GAMMA: f64 = 10.0;

pub(super) const LAYER: f64 = 0.05;

/// Half of the tank's breadth.
const HALF: f64 = 2.5;

/// E, ν, thickness, weight.
pub(super) const CONCRETE: [f64; 4] = [3.4e7, 0.2, 0.3, 25.0];

pub(super) const LINER: [f64; 4] = [2.1e8, 0.3, 0.006, 78.5];

const GRAVITY: f64 = 9.81;

/// Plane-strain E I of a strip of unit depth.
fn bending([e, nu, t, _]: [f64; 4]) -> f64 {
    e * t.powi(3) / 12.0 / (1.0 - nu * nu)
}

/// Whether beams and shells are flexible in shear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shear {
    /// Bernoulli.
    Stiff,
    /// Timoshenko, 5/6 G t.
    Flexible,
}

/// Half of the strip as a beam; bends along e₂ (about e₃).
fn half([e, nu, t, weight]: [f64; 4], shear: Shear) -> BeamSection {
    let plane = 1.0 - nu * nu;
    let shear_stiffness = match shear {
        Shear::Stiff => f64::INFINITY,
        Shear::Flexible => 0.5 * 5.0 / 6.0 * e * t / (2.0 * (1.0 + nu)),
    };
    BeamSection {
        axial: 0.5 * e * t / plane,
        bending_2: 0.5 * e * t / plane / 12.0,
        bending_3: 0.5 * bending([e, nu, t, weight]),
        torsion: 0.0,
        shear: [shear_stiffness; 2],
        mass: 0.5 * weight / GRAVITY * t,
        polar_inertia: 0.0,
    }
}

pub(super) fn pressure(z: f64) -> f64 {
    GAMMA * (DEPTH - z).max(0.0)
}

/// A strip of beams at the places x, each a column of nodes at two edges: `columns[x][edge][level]`.
struct Strip {
    model: Model,
    assembler: Assembler,
    z: Vec<f64>,
    columns: Vec<[Vec<usize>; 2]>,
    /// Number of beams; they come first.
    beams: usize,
}

impl Strip {
    /// `walls`: place and material of each, from the liquid outwards; `e_normal` of the layer between two.
    fn new(walls: &[(f64, [f64; 4])], e_normal: f64, z: Vec<f64>, shear: Shear) -> Result<Strip, Failure> {
        let mut builder = Builder::new();
        let mut columns = Vec::new();
        for &(x, _) in walls {
            let edge =
                |builder: &mut Builder, y: f64| -> Vec<usize> { z.iter().map(|&z| builder.node([x, y, z])).collect() };
            let column = [edge(&mut builder, 0.0), edge(&mut builder, 1.0)];
            for nodes in &column {
                for (level, &node) in nodes.iter().enumerate() {
                    for dof in [Dof::Uy, Dof::Rx, Dof::Rz] {
                        builder.hold(node, dof);
                    }
                    if level == 0 {
                        for dof in [Dof::Ux, Dof::Uz, Dof::Ry] {
                            builder.hold(node, dof);
                        }
                    }
                }
            }
            columns.push(column);
        }
        let mut beams = 0;
        for (&(_, material), column) in walls.iter().zip(&columns) {
            for pair in column.iter().flat_map(|nodes| nodes.windows(2)) {
                let nodes = [pair[0], pair[1]];
                let ends = nodes.map(|n| builder.position(n));
                // e₂ = x, e₃ = e₁ × e₂ = y: bending about y.
                builder.element("wall", Beam2::new(nodes, ends, [1.0, 0.0, 0.0], half(material, shear))?);
                beams += 1;
            }
        }
        for pair in columns.windows(2) {
            for level in 1..z.len() {
                let face = |c: &[Vec<usize>; 2]| [c[0][level - 1], c[1][level - 1], c[1][level], c[0][level]];
                let (inner, outer) = (face(&pair[0]), face(&pair[1]));
                let nodes: [usize; 8] = std::array::from_fn(|k| if k < 4 { inner[k] } else { outer[k - 4] });
                let corners = nodes.map(|n| builder.position(n));
                let layer = Solid8::new(nodes, corners, Elastic::normal_only(e_normal, 0.0), Kinematics::Linear)?;
                builder.element("layer", layer);
            }
        }
        let model = builder.build()?;
        interlayer::check(&model)?;
        let assembler = Assembler::new(&model);
        Ok(Strip { model, assembler, z, columns, beams })
    }

    /// Consistent forces of the liquid's pressure on the first wall, half on each edge.
    fn liquid(&self) -> Vec<[f64; KINDS]> {
        let mut forces = vec![[0.0; KINDS]; self.model.nodes().len()];
        for level in 1..self.z.len() {
            let (from, to) = (self.z[level - 1], self.z[level]);
            let h = to - from;
            for &(xi, w) in gauss::FOUR {
                let p = 0.5 * pressure(from + 0.5 * h * (1.0 + xi)) * w * 0.5 * h;
                let [n, ..] = line::hermite(xi, h);
                for nodes in &self.columns[0] {
                    for (end, node) in [nodes[level - 1], nodes[level]].into_iter().enumerate() {
                        forces[node][0] += p * n[2 * end];
                        // Slope dw/dz is the rotation about y.
                        forces[node][4] += p * n[2 * end + 1];
                    }
                }
            }
        }
        forces
    }

    /// Displacements under the liquid's pressure and, if wanted, the weight; and the reactions at the feet of each wall:
    /// (V, N, M) [kN, kN, kNm].
    fn solve(&self, weight: bool) -> Result<(Vec<f64>, Vec<[f64; 3]>), Failure> {
        let forces = self.liquid();
        let mut load = self.model.vector(|node| forces[node]);
        if weight {
            let own = self.assembler.body_force(&self.model, [0.0, 0.0, -GRAVITY]);
            load.iter_mut().zip(own).for_each(|(p, w)| *p += w);
        }
        let u = solve(&self.model, &self.assembler, &load)?;
        let internal = self.assembler.nodal_forces(&self.model, &u, |e| e < self.beams)?;
        // Weight of the lowest element that goes straight into the support.
        let reactions = self.columns.iter().map(|column| {
            let mut sum = [0.0; 3];
            for node in column.iter().map(|c| c[0]) {
                for (k, dof) in [0, 2, 4].into_iter().enumerate() {
                    sum[k] += internal[node][dof] - forces[node][dof];
                }
                if weight {
                    let first = 0.5 * (self.z[1] - self.z[0]);
                    sum[1] += first * half(CONCRETE, Shear::Stiff).mass * GRAVITY;
                }
            }
            sum
        });
        Ok((u, reactions.collect()))
    }

    fn deflection(&self, u: &[f64], wall: usize, level: usize) -> [f64; 2] {
        let at = self.model.at_node(u, self.columns[wall][0][level]);
        [at[0], at[4]]
    }
}

/// Two beams with elastic layer: see the head of the file.
pub(super) struct TwoBeams {
    beta: f64,
    particular: f64,
    /// Coefficients below and above the liquid's surface, each with two functions that decay upwards from the piece's
    /// foot and two that decay downwards from its head.
    coefficients: SVector<f64, 8>,
}

impl TwoBeams {
    pub(super) fn new(e_normal: f64) -> Result<TwoBeams, Failure> {
        let (ei_c, ei_l) = (bending(CONCRETE), bending(LINER));
        let four_beta4 = e_normal / LAYER * (1.0 / ei_c + 1.0 / ei_l);
        let mut found = TwoBeams {
            beta: (0.25 * four_beta4).powf(0.25),
            particular: 1.0 / (ei_l * four_beta4),
            coefficients: SVector::zeros(),
        };
        let mut a = SMatrix::<f64, 8, 8>::zeros();
        let mut b = SVector::<f64, 8>::zeros();
        // Scaled by β to keep the rows alike.
        let scale = |k: usize| found.beta.powi(-(k as i32));
        let p = |z: f64, k: usize| match k {
            0 => found.particular * GAMMA * (DEPTH - z),
            1 => -found.particular * GAMMA,
            _ => 0.0,
        };
        for k in 0..2 {
            // d = d' = 0 at the foot.
            a.fixed_view_mut::<1, 4>(k, 0).copy_from(&(found.basis(0, 0.0, k) * scale(k)).transpose());
            b[k] = -p(0.0, k) * scale(k);
            // d'' = d''' = 0 at the top.
            a.fixed_view_mut::<1, 4>(2 + k, 4).copy_from(&(found.basis(1, HEIGHT, 2 + k) * scale(2 + k)).transpose());
        }
        for k in 0..4 {
            a.fixed_view_mut::<1, 4>(4 + k, 0).copy_from(&(found.basis(0, DEPTH, k) * scale(k)).transpose());
            a.fixed_view_mut::<1, 4>(4 + k, 4).copy_from(&(-found.basis(1, DEPTH, k) * scale(k)).transpose());
            b[4 + k] = -p(DEPTH, k) * scale(k);
        }
        found.coefficients = a.lu().solve(&b).ok_or("the two beams have no solution")?;
        Ok(found)
    }

    /// k-th derivatives of e^{−βy} cos βy, e^{−βy} sin βy, y from the foot of the piece, and of the same from its head.
    fn basis(&self, piece: usize, z: f64, k: usize) -> SVector<f64, 4> {
        let (foot, head) = [(0.0, DEPTH), (DEPTH, HEIGHT)][piece];
        // d/dy of e^{(−1 + i) β y} multiplies by (−1 + i) β = √2 β e^{3πi/4}.
        let derivative = |y: f64, sign: f64| {
            let angle = self.beta * y + 0.75 * std::f64::consts::PI * k as f64;
            let size = (sign * std::f64::consts::SQRT_2 * self.beta).powi(k as i32) * (-self.beta * y).exp();
            [size * angle.cos(), size * angle.sin()]
        };
        let ([a, b], [c, d]) = (derivative(z - foot, 1.0), derivative(head - z, -1.0));
        SVector::from([a, b, c, d])
    }

    /// k-th derivative of d at z ≤ the liquid's surface.
    pub(super) fn difference(&self, z: f64, k: usize) -> f64 {
        let homogeneous = self.basis(0, z, k).dot(&self.coefficients.fixed_rows::<4>(0).into_owned());
        let particular = match k {
            0 => self.particular * pressure(z),
            1 => -self.particular * GAMMA,
            _ => 0.0,
        };
        homogeneous + particular
    }

    /// Base moments of concrete and liner: both sum to γ H³/6, and d'' = M_l/E I_l − M_c/E I_c.
    pub(super) fn moments(&self) -> [f64; 2] {
        let (ei_c, ei_l) = (bending(CONCRETE), bending(LINER));
        let total = GAMMA * DEPTH.powi(3) / 6.0;
        let curvature = (total + ei_c * self.difference(0.0, 2)) / (ei_c + ei_l);
        [total - ei_l * curvature, ei_l * curvature]
    }
}

/// Levels graded to the base, with one at the liquid's surface.
fn levels(count: usize) -> Result<Vec<f64>, Failure> {
    let mut z = grading::geometric(0.0, DEPTH, count, 300.0)?;
    z.extend(grading::uniform(DEPTH, HEIGHT, 6)?.into_iter().skip(1));
    Ok(z)
}

/// Base moments of concrete and liner [kNm/m] and largest compression of the layer [m] by beams on `count` elements.
pub(super) fn beams(e_normal: f64, count: usize, shear: Shear) -> Result<[f64; 3], Failure> {
    let walls = [(0.0, LINER), (LAYER, CONCRETE)];
    let strip = Strip::new(&walls, e_normal, levels(count)?, shear)?;
    let (u, reactions) = strip.solve(false)?;
    let gap = |level: usize| strip.deflection(&u, 0, level)[0] - strip.deflection(&u, 1, level)[0];
    let pressed = (0..=count).map(gap).fold(0.0, f64::max);
    Ok([-reactions[1][2], -reactions[0][2], pressed])
}

/// C9.
pub(super) fn layered() -> Answer {
    let mut rows = Vec::new();
    for e_normal in [3e9, 3e6, 3e5, 3e4, 3e3, 3e2] {
        let exact = TwoBeams::new(e_normal)?;
        let [concrete, liner] = exact.moments();
        let mut found = Vec::new();
        let counts = [40, 80, 160];
        for count in counts {
            let z = levels(count)?;
            let exact_pressed = z[..=count].iter().map(|&z| exact.difference(z, 0)).fold(0.0, f64::max);
            found.push((beams(e_normal, count, Shear::Stiff)?, [concrete, liner, exact_pressed]));
        }
        let unit = ["kNm/m", "kNm/m", "m"];
        let names = ["base moment of the concrete", "base moment of the liner", "compression of the layer"];
        for (k, tolerance) in [1e-4, 5e-3, 1e-3].into_iter().enumerate() {
            let (values, reference) = found[counts.len() - 1];
            let mut row = Row::new(
                "C9",
                format!("{}, e_normal {e_normal:.0e} kN/m²", names[k]),
                (reference[k], "two Bernoulli beams on a layer", Reference::ClosedForm),
                values[k],
                (tolerance, unit[k]),
            );
            row.convergence = counts.iter().zip(&found).map(|(n, (v, r))| (*n as f64, v[k] / r[k] - 1.0)).collect();
            rows.push(row);
        }
    }
    Ok(rows)
}

/// C10. Beams are exact at their nodes under consistent loads, whatever the mesh; the settlement needs ∫ w dz, by the
/// trapezoidal rule with its end correction.
pub(super) fn alone() -> Answer {
    let strip = Strip::new(&[(0.0, CONCRETE)], 1.0, levels(20)?, Shear::Stiff)?;
    let (u, reactions) = strip.solve(true)?;
    let ei = bending(CONCRETE);
    let mut volume = 0.0;
    for level in 1..=20 {
        let h = strip.z[level] - strip.z[level - 1];
        let ([w0, s0], [w1, s1]) = (strip.deflection(&u, 0, level - 1), strip.deflection(&u, 0, level));
        volume += 0.5 * h * (w0 + w1) + h * h / 12.0 * (s0 - s1);
    }
    let top = strip.deflection(&u, 0, strip.z.len() - 1)[0];
    let (h2, h3) = (DEPTH * DEPTH, DEPTH.powi(3));
    let exact_top = GAMMA * h2 * h3 / (30.0 * ei) + (HEIGHT - DEPTH) * GAMMA * h2 * h2 / (24.0 * ei);
    let cantilever = |formula| (formula, Reference::ClosedForm);
    let rows = [
        ("base moment", GAMMA * h3 / 6.0, cantilever("γ H³/6"), -reactions[0][2], 2e-3, "kNm/m"),
        ("base shear", GAMMA * h2 / 2.0, cantilever("γ H²/2"), -reactions[0][0], 2e-3, "kN/m"),
        ("normal force at the base", 22.5, cantilever("γ_c t H_T"), reactions[0][1], 2e-3, "kN/m"),
        ("displacement of the top", exact_top, cantilever("γ H⁵/(30 E I) + (H_T − H) γ H⁴/(24 E I)"), top, 5e-3, "m"),
        (
            "settlement of the surface",
            GAMMA * h3 * h3 / (72.0 * ei * HALF),
            cantilever("γ H⁶/(72 E I L)"),
            volume / HALF,
            1e-2,
            "m",
        ),
    ];
    let rows = rows.into_iter().map(|(what, exact, (source, kind), found, tolerance, unit)| {
        Row::new("C10", what, (exact, source, kind), found, (tolerance, unit))
    });
    Ok(rows.collect())
}
