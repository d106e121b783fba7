//! Cantilever of bricks.
//!
//! Source:    dissertation 6.4.1, figure 6.5: P_v 3.0, P_h 30.0 kN, E 3.0e7 kN/m², ν 0, ρ 2.5 t/m³, w 6.25 cm, u 0.025 cm,
//!            ω₁ 56.4 rad/s; the geometry is not printed and follows from these: L = 2.50 m, b = h = 0.10 m
//! Model:     one row of n bricks along x, bending in (x, z); u_y is held, without effect since ν = 0
//! Reference: w = P L³/(3 E I) · 1/(1 + (l/h)²/2): the brick's ε_xx is constant along its length, so that a brick under
//!            bending stores the parasitic shear energy ½ G A (κ l)²/12 = ½ E I κ² · ½ (l/h)² for ν = 0; l brick, h depth
//! Tolerance: 0.2 % of the ratio: it leaves out the beam's own shear (3 E I/(G A_s L²) = 0.1 % here)

use std::sync::Arc;

use super::forced::harmonic;
use super::solve;
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};
use fem::analysis::damping::Rayleigh;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::linalg::{Kind, Matrix, Ordering, Symbolic, Symmetric};
use fem::model::{Builder, Model};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "brick-cantilever",
    title: "Cantilever of bricks",
    model: "Dissertation 6.4.1, figure 6.5: `solid8`, L = 2.50 m, section 0.10 × 0.10 m, E = 3·10⁷ kN/m², ν = 0; \
            static, modes, harmonic tip force.",
    ids: &[
        ("C1", "deflection under a transverse force"),
        ("C2", "extension under an axial force"),
        ("C3", "frequencies"),
        ("C4", "locking ratio of the brick"),
        ("C6", "harmonic tip force, three kinds of damping"),
    ],
    parts: &[Part::Fast(statics), Part::Fast(frequencies), Part::Fast(harmonic)],
};

/// Source of the printed numbers.
pub(super) const PRINTED: &str = "dissertation 6.4.1";

pub(super) const LENGTH: f64 = 2.5;

pub(super) const DEPTH: f64 = 0.1;

pub(super) const MODULUS: f64 = 3.0e7;

pub(super) const DENSITY: f64 = 2.5;

pub(super) const TRANSVERSE: f64 = 3.0;

pub(super) const AXIAL: f64 = 30.0;

pub(super) struct Cantilever {
    pub(super) model: Model,
    pub(super) assembler: Assembler,
    pub(super) tip: [usize; 4],
}

impl Cantilever {
    pub(super) fn new(bricks: usize, kinematics: Kinematics, damping: Rayleigh) -> Result<Cantilever, Failure> {
        let mut builder = Builder::new();
        let h = 0.5 * DEPTH;
        let section = [[-h, -h], [h, -h], [h, h], [-h, h]];
        for i in 0..=bricks {
            let x = LENGTH * i as f64 / bricks as f64;
            for [y, z] in section {
                let node = builder.node([x, y, z]);
                builder.hold(node, Dof::Uy);
                if i == 0 {
                    builder.hold(node, Dof::Ux);
                    builder.hold(node, Dof::Uz);
                }
            }
        }
        let material = Elastic::isotropic(MODULUS, 0.0, DENSITY).with_damping(damping.mass, damping.stiffness);
        for i in 0..bricks {
            let (a, b) = (4 * i, 4 * i + 4);
            let nodes = [a, b, b + 1, a + 1, a + 3, b + 3, b + 2, a + 2];
            let corners = nodes.map(|n| builder.position(n));
            builder.element("beam", Solid8::new(nodes, corners, material, kinematics)?);
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let tip = std::array::from_fn(|k| 4 * bricks + k);
        Ok(Cantilever { model, assembler, tip })
    }

    pub(super) fn linear(bricks: usize) -> Result<Cantilever, Failure> {
        let none = Rayleigh { mass: 0.0, stiffness: 0.0 };
        Cantilever::new(bricks, Kinematics::Linear, none)
    }

    /// A force at the tip, a quarter at each node.
    pub(super) fn tip_load(&self, force: [f64; 3]) -> Vec<f64> {
        self.model.vector(|node| {
            let mut load = [0.0; fem::dofs::KINDS];
            if self.tip.contains(&node) {
                (0..3).for_each(|i| load[i] = 0.25 * force[i]);
            }
            load
        })
    }

    /// Mean displacement of the tip.
    pub(super) fn tip_motion(&self, u: &[f64]) -> [f64; 3] {
        let mut mean = [0.0; 3];
        for node in self.tip {
            let at = self.model.at_node(u, node);
            (0..3).for_each(|i| mean[i] += 0.25 * at[i]);
        }
        mean
    }
}

pub(super) fn inertia() -> f64 {
    DEPTH.powi(4) / 12.0
}

/// w of the beam under P_v.
fn beam_deflection() -> f64 {
    TRANSVERSE * LENGTH.powi(3) / (3.0 * MODULUS * inertia())
}

/// 1/(1 + (l/h)²/2).
fn locking(bricks: usize) -> f64 {
    let ratio = LENGTH / bricks as f64 / DEPTH;
    1.0 / (1.0 + 0.5 * ratio * ratio)
}

/// C1, C2, C4.
pub(super) fn statics() -> Answer {
    let mut rows = Vec::new();
    let mut convergence = Vec::new();
    for bricks in [1, 5, 10, 25, 50, 100, 200, 400] {
        let beam = Cantilever::linear(bricks)?;
        let u = solve(&beam.model, &beam.assembler, &beam.tip_load([0.0, 0.0, TRANSVERSE]))?;
        let ratio = beam.tip_motion(&u)[2] / beam_deflection();
        convergence.push((bricks as f64, ratio - 1.0));
        rows.push(Row::new(
            "C4",
            format!("deflection over that of the beam, {bricks} bricks"),
            (locking(bricks), "1/(1 + (l/h)²/2), by hand", Reference::ClosedForm),
            ratio,
            (2e-3, ""),
        ));
    }
    // 400 bricks: the beam with its shear; the rest is locking, 0.2 %.
    let shear = TRANSVERSE * LENGTH / (5.0 / 6.0 * 0.5 * MODULUS * DEPTH * DEPTH);
    let fine = beam_deflection() * (1.0 + convergence[convergence.len() - 1].1);
    let mut c1 = Row::new(
        "C1",
        "deflection of the tip, 400 bricks",
        (beam_deflection() + shear, "P L³/(3 E I) + P L/(G A_s)", Reference::ClosedForm),
        fine,
        (3e-3, "m"),
    );
    c1.convergence = convergence.clone();
    rows.push(c1);
    // Half of the last digit, and the locking of 400 bricks; the print is that of a beam without shear.
    rows.push(Row::new(
        "C1",
        "deflection of the tip, 400 bricks",
        (0.0625, PRINTED, Reference::Dissertation),
        fine,
        (2.8e-3, "m"),
    ));
    let at_200 = beam_deflection() * (1.0 + convergence[6].1);
    rows.push(Row::new(
        "C1",
        "deflection of the tip, 200 bricks",
        (0.06207, "independent prototype of the same brick", Reference::SecondFormulation),
        at_200,
        (5e-4, "m"),
    ));
    // One brick as well as many: the field is in the element's space; refined once, rounding of a condition number of 1e9.
    for bricks in [1, 200] {
        let beam = Cantilever::linear(bricks)?;
        let u = solve(&beam.model, &beam.assembler, &beam.tip_load([AXIAL, 0.0, 0.0]))?;
        rows.push(Row::new(
            "C2",
            format!("extension, {bricks} bricks"),
            (AXIAL * LENGTH / (MODULUS * DEPTH * DEPTH), "P L/(E A)", Reference::ClosedForm),
            beam.tip_motion(&u)[0],
            (1e-9, "m"),
        ));
        // Half of the last digit.
        let printed = (2.5e-4, PRINTED, Reference::Dissertation);
        rows.push(Row::new("C2", format!("extension, {bricks} bricks"), printed, beam.tip_motion(&u)[0], (0.02, "m")));
    }
    Ok(rows)
}

/// Factor L Lᵀ of a matrix in the pattern of a model.
pub(super) fn symbolic(assembler: &Assembler) -> Result<Arc<Symbolic>, Failure> {
    Ok(Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?))
}

/// The two lowest ω [rad/s] by inverse iteration with two vectors, started from the beam's bending shapes.
fn lowest_two(beam: &Cantilever) -> Result<[f64; 2], Failure> {
    let (k, m) = (beam.assembler.stiffness(&beam.model)?, beam.assembler.mass(&beam.model));
    let factor = symbolic(&beam.assembler)?.factor(&k, Kind::Definite)?;
    let n = k.size();
    let mut x = Matrix::zeros(n, 2);
    for (j, power) in [2, 3].into_iter().enumerate() {
        let shape = beam.model.vector(|node| {
            let mut v = [0.0; fem::dofs::KINDS];
            v[2] = (beam.model.nodes()[node][0] / LENGTH).powi(power);
            v
        });
        x.column_mut(j).copy_from_slice(&shape);
    }
    let mut previous = [0.0; 2];
    for _ in 0..60 {
        let mut y = Matrix::zeros(n, 2);
        for j in 0..2 {
            let mx = m.times(x.column(j));
            y.column_mut(j).copy_from_slice(&mx);
        }
        factor.solve(&mut y)?;
        let project = |a: &Symmetric| {
            let products = [a.times(y.column(0)), a.times(y.column(1))];
            nalgebra::Matrix2::from_fn(|i, j| fem::linalg::dot(y.column(i), &products[j]))
        };
        let (kr, mr) = (project(&k), project(&m));
        let l = mr.cholesky().ok_or("the mass of two shapes is singular")?.l();
        let li = l.try_inverse().ok_or("the mass of two shapes is singular")?;
        let eigen = (li * kr * li.transpose()).symmetric_eigen();
        let vectors = li.transpose() * eigen.eigenvectors;
        let mut order = [0, 1];
        order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
        for (j, &from) in order.iter().enumerate() {
            for i in 0..n {
                x.column_mut(j)[i] = y.column(0)[i] * vectors[(0, from)] + y.column(1)[i] * vectors[(1, from)];
            }
        }
        let found = order.map(|i| eigen.eigenvalues[i].sqrt());
        // The third mode is 2.8 times higher than the second: 30 rounds reach 1e-12.
        if (0..2).all(|i| (found[i] - previous[i]).abs() < 1e-10 * found[i]) {
            return Ok(found);
        }
        previous = found;
    }
    Err("inverse iteration did not converge".into())
}

/// β_j L of the cantilever: cos x cosh x = −1.
pub(super) const ROOTS: [f64; 2] = [1.875_104_068_711_961, 4.694_091_132_974_175];

/// ω_j = (β L)² √(E I/(ρ A))/L².
pub(super) fn beam_frequency(root: f64) -> f64 {
    root * root * (MODULUS * inertia() / (DENSITY * DEPTH * DEPTH)).sqrt() / LENGTH.powi(2)
}

/// C3: with 400 bricks the locking raises ω by ¼ (l/h)² = 0.1 %; shear and rotary inertia lower ω₂ by 0.6 %. Both are
/// seen with the independent prototype's 200 bricks.
pub(super) fn frequencies() -> Answer {
    let mut convergence = Vec::new();
    for bricks in [50, 100, 200, 400] {
        convergence.push((bricks as f64, lowest_two(&Cantilever::linear(bricks)?)?));
    }
    let mut rows = Vec::new();
    for (j, prototype) in [56.423, 351.67].into_iter().enumerate() {
        rows.push(Row::new(
            "C3",
            format!("ω_{}, 200 bricks", j + 1),
            (prototype, "independent prototype of the same brick", Reference::SecondFormulation),
            convergence[2].1[j],
            (5e-4, "rad/s"),
        ));
    }
    // Timoshenko's beam with rotary inertia: 56.197.
    let mut fine = Row::new(
        "C3",
        "ω_1, 400 bricks",
        (56.197, "Timoshenko's beam with rotary inertia (theory sheet)", Reference::SecondFormulation),
        convergence[3].1[0],
        (2e-3, "rad/s"),
    );
    fine.convergence = convergence.iter().map(|(n, w)| (*n, w[0] / 56.197 - 1.0)).collect();
    rows.push(fine);
    // Half of the last digit, 0.09 %, and shear and rotary inertia, with which a beam has 56.20: 0.36 %.
    let printed = (56.4, PRINTED, Reference::Dissertation);
    rows.push(Row::new("C3", "ω_1, 400 bricks", printed, convergence[3].1[0], (4.5e-3, "rad/s")));
    Ok(rows)
}
