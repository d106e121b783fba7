//! Energies of a record.

use super::March;
use crate::analysis::transient::Energy;
use crate::linalg::dot;

impl March<'_> {
    /// Kinetic and elastic energy of record `c`.
    pub(super) fn stored(&self, c: usize) -> (f64, f64) {
        let range = c * self.n..(c + 1) * self.n;
        let kinetic = 0.5 * dot(&self.v[range.clone()], &self.mv[range.clone()]);
        (kinetic, 0.5 * dot(&self.u[range.clone()], &self.ku[range]))
    }

    /// Appends the energies of record `c`.
    pub(in crate::analysis::transient) fn energies(&self, c: usize, energy: &mut Energy) {
        let (kinetic, elastic) = self.stored(c);
        energy.input.push(self.input[c]);
        energy.kinetic.push(kinetic - self.initial[c].0);
        energy.elastic.push(elastic - self.initial[c].1);
        energy.damping.push(self.damped[c]);
    }
}
