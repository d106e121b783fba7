//! A linear part of a structure as one element: Craig & Bampton's reduction onto an interface and fixed-interface modes.
//!
//! ```text
//! u_i = Ψ u_b + Φ q      Ψ = −K_ii⁻¹ K_ib      K_ii φ = ω² M_ii φ,  φᵀ M_ii φ = 1
//! M_r = Tᵀ M T      K_r = Tᵀ K T = ⎡ K_bb + K_bi Ψ   0  ⎤
//!                                  ⎣ 0               ω² ⎦
//! ```
//!
//! Without modes it is Guyan's static condensation, exact in statics. Modes up to three times the highest frequency of
//! interest are the usual choice; with all of them nothing is lost. A part that only its interface supports carries a
//! rigid motion in Ψ, so that amplitudes rest in it and ground-motion loads come out right: supports belong to the
//! interface.
//!
//! Source: Guyan 1965; Craig & Bampton 1968.

use std::sync::Arc;

use super::{AnalysisError, failed};
use crate::assembly::Assembler;
use crate::dofs::Dof;
use crate::element::ElementError;
use crate::element::super_element::SuperElement;
use crate::linalg::{Kind, Matrix, Ordering, Search, Sparse, Symbolic, Symmetric, modes, transposed_product};
use crate::model::Model;

/// A reduced part.
#[derive(Clone, Debug, PartialEq)]
pub struct Substructure {
    /// Node and dof of each interface unknown.
    pub interface: Vec<(usize, Dof)>,
    /// Circular frequencies of the fixed-interface modes [rad/s].
    pub omega: Vec<f64>,
    /// M_r, over the interface and then the amplitudes.
    pub mass: Matrix,
    /// K_r.
    pub stiffness: Matrix,
}

impl Substructure {
    /// Reduces the linear model `model` onto `interface` and `count` modes.
    ///
    /// Errors: an interface dof that is no unknown; a part that moves though its interface is held; no convergence of the modes.
    pub fn new(model: &Model, interface: &[(usize, Dof)], count: usize) -> Result<Substructure, AnalysisError> {
        let assembler = Assembler::new(model);
        let (k, m) = assembler
            .stiffness_and_mass(model)
            .map_err(|source| AnalysisError::Element { number: 0, source })?;
        let mut border = Vec::new();
        for &(node, dof) in interface {
            match model.dofs().equation(node, dof) {
                Some(e) if !border.contains(&e) => border.push(e),
                _ => {
                    return Err(AnalysisError::Option {
                        option: "interface",
                        found: format!("{dof} of node {node}"),
                        allowed: "unknowns of the part, each once".into(),
                    });
                }
            }
        }
        let mut is_border = vec![false; k.size()];
        border.iter().for_each(|&e| is_border[e] = true);
        let inner: Vec<usize> = (0..k.size()).filter(|&e| !is_border[e]).collect();
        let mut t = Matrix::zeros(k.size(), border.len() + count.min(inner.len()));
        border.iter().enumerate().for_each(|(j, &e)| t.add(e, j, 1.0));
        let mut omega = Vec::new();
        if !inner.is_empty() {
            let (k_ii, m_ii) = (k.submatrix(&inner), m.submatrix(&inner));
            // Both on the pattern of K and M.
            let m_ii = Symmetric {
                pattern: k_ii.pattern.clone(),
                values: m_ii.values,
            };
            let symbolic = Symbolic::new(k_ii.pattern.clone(), &Ordering::MinimumDegree);
            let symbolic = Arc::new(symbolic.map_err(failed("the inner stiffness"))?);
            let factor = symbolic
                .factor(&k_ii, Kind::Definite)
                .map_err(failed("the inner stiffness"))?;
            let mut follow = Matrix::zeros(inner.len(), border.len());
            for (j, &e) in border.iter().enumerate() {
                let mut unit = vec![0.0; k.size()];
                unit[e] = -1.0;
                let image = k.times(&unit);
                for (v, &i) in follow.column_mut(j).iter_mut().zip(&inner) {
                    *v = image[i];
                }
            }
            factor.solve(&mut follow).map_err(failed("the constraint modes"))?;
            for j in 0..border.len() {
                inner.iter().zip(follow.column(j)).for_each(|(&i, v)| t.add(i, j, *v));
            }
            let pencil = Sparse::new(&k_ii, &m_ii, symbolic);
            let found = modes(&pencil, &Search::lowest(count.min(inner.len())));
            let found = found.map_err(failed("the fixed-interface modes"))?;
            omega = found.omega();
            for j in 0..omega.len() {
                let column = border.len() + j;
                inner
                    .iter()
                    .zip(found.vectors.column(j))
                    .for_each(|(&i, v)| t.add(i, column, *v));
            }
            t.cols = border.len() + omega.len();
            t.data.truncate(t.rows * t.cols);
        }
        let project = |a: &Symmetric| transposed_product(&t, &a.times_block(&t));
        Ok(Substructure {
            interface: interface.to_vec(),
            omega,
            mass: project(&m),
            stiffness: project(&k),
        })
    }

    /// The element, with the interface at nodes `place(node)` of another model whose frames there are the same, and one
    /// amplitude a mode.
    ///
    /// Errors: another number of amplitudes than of modes; those of the element.
    pub fn element(
        &self,
        place: impl Fn(usize) -> usize,
        amplitudes: &[(usize, Dof)],
    ) -> Result<SuperElement, ElementError> {
        if amplitudes.len() != self.omega.len() {
            return Err(ElementError::Parameter {
                kind: "super_element",
                parameter: "amplitudes",
                found: format!("{} for {} modes", amplitudes.len(), self.omega.len()),
                allowed: "one a mode",
            });
        }
        let own = self.interface.iter().map(|&(node, dof)| (place(node), dof));
        let unknowns: Vec<(usize, Dof)> = own.chain(amplitudes.iter().copied()).collect();
        SuperElement::over(&unknowns)?
            .with_mass(self.mass.clone())?
            .with_stiffness(self.stiffness.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::spring::{Direction, PointMass, Spring};
    use crate::linalg::generalized_eigen;
    use crate::model::Builder;

    const X: Direction = Direction::Translation([1.0, 0.0, 0.0]);

    fn link(builder: &mut Builder, from: usize, to: usize) {
        for node in from..=to {
            if node > from {
                let k = 100.0 + 30.0 * (node as f64).sin();
                builder.element("links", Spring::between(node - 1, node, X, k).unwrap());
                builder.element(
                    "masses",
                    PointMass::new(node, 1.0 + 0.3 * (2.0 * node as f64).cos()).unwrap(),
                );
            }
        }
    }

    fn chain(nodes: usize, grounded: bool) -> Builder {
        let mut builder = Builder::new();
        for k in 0..nodes {
            builder.node([k as f64, 0.0, 0.0]);
            builder.hold(k, Dof::Uy);
            builder.hold(k, Dof::Uz);
        }
        if grounded {
            builder.hold(0, Dof::Ux);
        }
        builder
    }

    fn omega(model: &Model) -> (Vec<f64>, Vec<f64>) {
        let assembler = Assembler::new(model);
        let (k, m) = assembler.stiffness_and_mass(model).unwrap();
        let eigen = generalized_eigen(&k.to_dense(), &m.to_dense(), None).unwrap();
        let inertia = assembler.inertia(model, crate::analysis::system::unit_x);
        let mass = (0..eigen.omega.len()).map(|j| crate::linalg::dot(eigen.vectors.column(j), &inertia).powi(2));
        (eigen.omega.clone(), mass.collect())
    }

    /// Chain of ten masses, the upper six reduced: with all their modes the frequencies and effective masses of the whole,
    /// with two the lowest ones closely; without, a rigid body of their mass.
    #[test]
    fn upper_part_of_a_chain() {
        let mut whole = chain(11, true);
        link(&mut whole, 0, 10);
        let (expected, masses) = omega(&whole.build().unwrap());
        let mut upper = chain(11, false);
        link(&mut upper, 4, 10);
        let upper = upper.build().unwrap();
        for (count, compared, tolerance) in [(6, 10, 1e-9), (2, 3, 1e-2)] {
            let part = Substructure::new(&upper, &[(4, Dof::Ux)], count).unwrap();
            assert_eq!(part.omega.len(), count);
            let mut lower = chain(5, true);
            link(&mut lower, 0, 4);
            let amplitudes: Vec<(usize, Dof)> = (0..count).map(|_| (lower.node([0.0; 3]), Dof::Amplitude)).collect();
            lower.element("upper", part.element(|node| node, &amplitudes).unwrap());
            let (found, effective) = omega(&lower.build().unwrap());
            for j in 0..compared {
                assert!(
                    (found[j] / expected[j] - 1.0).abs() < tolerance,
                    "{count} {j}: {} {}",
                    found[j],
                    expected[j]
                );
                // Effective masses are of the first order in the error of the mode.
                let scale = masses.iter().sum::<f64>();
                assert!(
                    (effective[j] - masses[j]).abs() < 3.0 * tolerance * scale,
                    "{count} {j}"
                );
            }
        }
        let rigid = Substructure::new(&upper, &[(4, Dof::Ux)], 0).unwrap();
        let mass: f64 = (5..11).map(|k| 1.0 + 0.3 * (2.0 * f64::from(k)).cos()).sum();
        assert!(rigid.stiffness.get(0, 0).abs() < 1e-12 && (rigid.mass.get(0, 0) - mass).abs() < 1e-12);
        assert!(Substructure::new(&upper, &[(0, Dof::Ux)], 0).is_err());
        let part = Substructure::new(&upper, &[(4, Dof::Ux)], 1).unwrap();
        assert!(part.element(|n| n, &[]).is_err());
    }
}
