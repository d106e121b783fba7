//! A bar of one degree of freedom a node with a von Mises law: the element of the tower.

use materials::von_mises::VonMises;
use materials::{Law, Response as Stress};

use fem::dofs::Dof;
use fem::element::{Element, ElementError, Inspect, Response, Trial};

/// Bar between two nodes along x; history: that of the law, then the energy dissipated.
pub(super) struct Bar {
    pub(super) nodes: [usize; 2],
    pub(super) area: f64,
    pub(super) length: f64,
    pub(super) law: VonMises,
}

impl Bar {
    pub(super) fn points(&self) -> usize {
        Law::<1>::history_len(&self.law)
    }

    pub(super) fn strain(&self, values: &[f64]) -> [f64; 1] {
        [(values[1] - values[0]) / self.length]
    }

    /// Elastic energy and that stored by hardening [J]: σ²/(2 E) + K a²/2 for isotropic linear hardening.
    pub(super) fn stored(
        &self,
        values: &[f64],
        history: &[f64],
        [young, hardening]: [f64; 2],
    ) -> Result<f64, ElementError> {
        let mut spare = vec![0.0; self.points()];
        let stress = self.respond_at(values, &history[..self.points()], &mut spare)?.stress[0];
        let a = history[0];
        Ok(self.area * self.length * (0.5 * stress * stress / young + 0.5 * hardening * a * a))
    }

    pub(super) fn respond_at(&self, values: &[f64], old: &[f64], new: &mut [f64]) -> Result<Stress<1>, ElementError> {
        self.law.respond(&self.strain(values), old, new).map_err(|source| ElementError::Law { kind: "bar", source })
    }
}

impl Element for Bar {
    fem::answers!("bar", nodes, Dof::slice(0..1); massless inspect);

    fn history_len(&self) -> usize {
        self.points() + 1
    }

    fn init_history(&self, slots: &mut [f64]) {
        let (own, energy) = slots.split_at_mut(self.points());
        Law::<1>::init_history(&self.law, own);
        energy.fill(0.0);
    }

    fn respond(&self, Trial { motion, old, new, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let n = self.points();
        let found = self.respond_at(motion.values, &old[..n], &mut new[..n])?;
        new[n] = old[n] + found.dissipation * self.area * self.length;
        for (i, a) in [-1.0, 1.0].into_iter().enumerate() {
            out.force[i] += a * self.area * found.stress[0];
            for (j, b) in [-1.0, 1.0].into_iter().enumerate() {
                out.tangent.add(i, j, a * b * self.area / self.length * found.tangent[0][0]);
            }
        }
        Ok(())
    }
}

impl Inspect for Bar {
    fn dissipated(&self, history: &[f64]) -> f64 {
        history[self.points()]
    }
}
