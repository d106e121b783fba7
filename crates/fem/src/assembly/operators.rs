//! Products with the elements that are not assembled.

use super::{Assembler, NONE};
use crate::assembly::respond::Forces;
use crate::linalg::Symmetric;
use crate::model::Model;
use crate::ring::RingOperator;

/// An element that is not assembled, in its place.
pub struct PlacedOperator<'a> {
    /// Number of the element.
    pub element: usize,
    /// The operator over its local dofs.
    pub operator: &'a RingOperator,
    equations: &'a [u32],
}

impl PlacedOperator<'_> {
    /// Equation of a local dof, `None` if it is held.
    pub fn equation(&self, local: usize) -> Option<usize> {
        (self.equations[local] != NONE).then_some(self.equations[local] as usize)
    }

    fn gather(&self, x: &[f64]) -> Vec<f64> {
        let of = |&q: &u32| if q == NONE { 0.0 } else { x[q as usize] };
        self.equations.iter().map(of).collect()
    }
}

impl Assembler {
    /// Whether some element is not assembled.
    pub fn has_operators(&self) -> bool {
        self.unassembled.contains(&true)
    }

    /// The elements that are not assembled.
    pub fn operators<'a>(&'a self, model: &'a Model) -> impl Iterator<Item = PlacedOperator<'a>> {
        let all = self.unassembled.iter().enumerate().filter(|(_, operator)| **operator);
        all.filter_map(|(element, _)| {
            Some(PlacedOperator {
                element,
                operator: model.elements()[element].operator()?,
                equations: &self.equations[self.equation_starts[element]..self.equation_starts[element + 1]],
            })
        })
    }

    /// y ← y + (a M + b K) x of the elements that are not assembled, with (a, b) = `factors(number of the element)`.
    pub fn add_operator_products(&self, model: &Model, factors: impl Fn(usize) -> [f64; 2], x: &[f64], y: &mut [f64]) {
        for placed in self.operators(model) {
            let [on_mass, on_stiffness] = factors(placed.element);
            if on_mass == 0.0 && on_stiffness == 0.0 {
                continue;
            }
            let local = placed.gather(x);
            let mut image = vec![0.0; local.len()];
            if on_mass != 0.0 {
                placed.operator.add_mass(on_mass, &local, &mut image);
            }
            if on_stiffness != 0.0 {
                placed.operator.add_stiffness(on_stiffness, &local, &mut image);
            }
            for (&q, v) in placed.equations.iter().zip(&image).filter(|(q, _)| **q != NONE) {
                y[q as usize] += v;
            }
        }
    }

    /// y ← y + A x, with a sparse matrix and the elements that are not assembled; the latter beside it into `room` if there are two `threads`.
    pub(crate) fn add_whole_product(
        &self,
        model: &Model,
        (sparse, factors): (&Symmetric, &(impl Fn(usize) -> [f64; 2] + Sync)),
        x: &[f64],
        [y, room]: [&mut [f64]; 2],
        threads: usize,
    ) {
        room.fill(0.0);
        if threads < 2 {
            sparse.add_product(1.0, x, y);
            self.add_operator_products(model, factors, x, room);
        } else {
            rayon::join(|| sparse.add_product(1.0, x, y), || self.add_operator_products(model, factors, x, room));
        }
        y.iter_mut().zip(&*room).for_each(|(y, other)| *y += other);
    }

    /// y ← y + M x of the elements that are not assembled.
    pub fn add_operator_mass(&self, model: &Model, x: &[f64], y: &mut [f64]) {
        self.add_operator_products(model, |_| [1.0, 0.0], x, y);
    }

    /// Forces K u of the elements that are not assembled, on unknowns and supports.
    pub(super) fn add_operator_forces(&self, model: &Model, u: &[f64], forces: &mut Forces) {
        for placed in self.operators(model) {
            let local = placed.gather(u);
            let mut image = vec![0.0; local.len()];
            placed.operator.add_stiffness(1.0, &local, &mut image);
            let start = self.equation_starts[placed.element];
            for (k, v) in image.iter().enumerate() {
                match (self.equations[start + k], self.held[start + k]) {
                    (NONE, NONE) => {}
                    (NONE, support) => forces.support[support as usize] += v,
                    (equation, _) => forces.internal[equation as usize] += v,
                }
            }
        }
    }

    /// Damping of the amplitudes of element `e`.
    pub(super) fn add_diagonal_damping(&self, e: usize, operator: &RingOperator, out: &mut Symmetric) {
        let pattern = out.pattern.clone();
        let equations = &self.equations[self.equation_starts[e] + operator.wall()..self.equation_starts[e + 1]];
        for (&q, c) in equations.iter().zip(operator.damping()).filter(|(q, _)| **q != NONE) {
            out.values[pattern.starts[q as usize]] += c;
        }
    }
}
