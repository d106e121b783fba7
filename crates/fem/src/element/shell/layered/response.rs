//! Response of a section of layers and bars.

use super::lasting::Point;
use super::{Layer, LayeredSection, failed};
use crate::element::ElementError;
use crate::element::shell::section::SectionResponse;

// Slots of a point's own history.
const ENERGY: usize = 0;
pub(super) const WHOLE: usize = 1; // 1: whole
const STRAIN: usize = 2; // ε, κ
pub(super) const HEAD: usize = 8;

/// ∫ C dζ, ∫ ζ C dζ, ∫ ζ² C dζ of layers, each as its entries 11, 12, 13, 22, 23, 33.
type Blocks = [[f64; 6]; 3];

/// Places of the entries of a block.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

/// The strain of a whole point, that of its committed history.
fn strain_of(history: &[f64]) -> [f64; 8] {
    std::array::from_fn(|i| if i < 6 { history[STRAIN + i] } else { 0.0 })
}

impl Layer {
    /// Its part of a point's history; that of a whole point is written to `room`.
    ///
    /// * `committed`: what lasted when the history was committed
    pub(super) fn past<'h>(&self, history: &'h [f64], committed: Option<&Point>, room: &'h mut Vec<f64>) -> &'h [f64] {
        let own = &history[self.slots.clone()];
        if !(self.ranged && history[WHOLE] == 1.0) {
            return own;
        }
        room.clear();
        room.resize(own.len(), 0.0);
        if let Some(range) = self.law.elastic_range() {
            range.history(&self.strain(&strain_of(history), committed), room);
        }
        room
    }

    /// Whether the strain of the section leaves this layer in its elastic range.
    fn is_elastic(&self, strain: &[f64; 8], lasting: Option<&Point>) -> bool {
        let range = self.law.elastic_range();
        range.is_some_and(|range| range.holds(&self.strain(strain, lasting)))
    }
}

impl LayeredSection {
    /// Resultants and, if asked for, the tangent; writes the trial history.
    pub(super) fn integrate<const TANGENT: bool>(
        &self,
        strain: &[f64; 8],
        old: &[f64],
        new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError> {
        let point = self.lasting.as_ref().map(|lasting| lasting.point(old, false));
        let point = point.as_ref();
        let whole = self.history > 0
            && old[WHOLE] == 1.0
            && self.outermost.iter().all(|&number| self.layers[number].is_elastic(strain, point));
        let mut constant = if whole { &self.whole } else { &self.constant };
        let mut off = None;
        if let (Some(lasting), Some(point)) = (&self.lasting, point) {
            let (now, taken) = lasting.constants(point, whole, constant);
            (constant, off) = (now, Some(taken));
            lasting.carry(strain, old, new);
        }
        for (n, row) in out.resultants.iter_mut().zip(constant) {
            *n = row.iter().zip(strain).map(|(c, e)| c * e).sum();
        }
        if let Some(off) = off {
            out.resultants.iter_mut().zip(off).for_each(|(n, off)| *n -= off);
        }
        if TANGENT {
            out.tangent = *constant;
        }
        if self.history == 0 {
            return Ok(());
        }
        let mut dissipation = 0.0;
        if whole {
            self.stay(strain, new);
        } else {
            new[WHOLE] = 0.0;
            new[STRAIN..HEAD].fill(0.0);
        }
        if !whole || self.has_unranged() {
            dissipation += self.layers_of::<TANGENT>(strain, (old, new), out, whole, point)?;
        }
        for rod in self.rods.iter().filter(|r| !r.linear) {
            let (at, own) = (rod.own_strain(strain, point), rod.slots.clone());
            let response = rod.law.respond(&[at], &old[own.clone()], &mut new[own]).map_err(failed)?;
            let force = rod.area * response.stress[0];
            for (n, b) in out.resultants.iter_mut().zip(rod.weights()) {
                *n += force * b;
            }
            if TANGENT {
                rod.add_tangent(response.tangent[0][0], &mut out.tangent);
            }
            dissipation += rod.area * response.dissipation;
        }
        new[ENERGY] = old[ENERGY] + dissipation;
        Ok(())
    }

    /// History of a point that stays whole. The layers keep their initial history, so that equal states have equal histories.
    fn stay(&self, strain: &[f64; 8], new: &mut [f64]) {
        if new[WHOLE] != 1.0 {
            new[WHOLE] = 1.0;
            for layer in self.layers.iter().filter(|l| l.ranged) {
                layer.law.init_history(&mut new[layer.slots.clone()]);
            }
        }
        new[STRAIN..HEAD].copy_from_slice(&strain[..6]);
    }

    /// Whether a layer that is not linear has no elastic range.
    fn has_unranged(&self) -> bool {
        self.layers.iter().any(|l| !l.linear && !l.ranged)
    }

    /// Layers one by one, of a whole point those without an elastic range; returns the dissipation of the step.
    fn layers_of<const TANGENT: bool>(
        &self,
        strain: &[f64; 8],
        (old, new): (&[f64], &mut [f64]),
        out: &mut SectionResponse,
        whole: bool,
        lasting: Option<&Point>,
    ) -> Result<f64, ElementError> {
        let committed = self.lasting.as_ref().map(|lasting| lasting.point(old, true));
        let mut dissipation = 0.0;
        let mut blocks = Blocks::default();
        let mut room = Vec::new();
        for layer in self.layers.iter().filter(|l| !(l.linear || whole && l.ranged)) {
            let at = layer.strain(strain, lasting);
            let past = layer.past(old, committed.as_ref(), &mut room);
            let response = layer.law.respond(&at, past, &mut new[layer.slots.clone()]).map_err(failed)?;
            for (i, stress) in response.stress.iter().enumerate() {
                let force = layer.weight * stress;
                out.resultants[i] += force;
                out.resultants[3 + i] += layer.depth * force;
            }
            if TANGENT {
                let weight = layer.weight * lasting.map_or(1.0, |point| point.rate(layer.ease));
                add(&response.tangent, layer.depth, weight, &mut blocks);
            }
            dissipation += layer.weight * response.dissipation;
        }
        if TANGENT {
            spread(&blocks, &mut out.tangent);
        }
        Ok(dissipation)
    }
}

/// Adds a layer. The tangents of non-associated laws are not symmetric: their symmetric part.
#[inline]
fn add(c: &[[f64; 3]; 3], depth: f64, weight: f64, blocks: &mut Blocks) {
    let [a, b, d] = blocks;
    for (k, &(i, j)) in ENTRIES.iter().enumerate() {
        let w = 0.5 * weight * (c[i][j] + c[j][i]);
        a[k] += w;
        b[k] += w * depth;
        d[k] += w * depth * depth;
    }
}

/// tangent += [A, B; B, D].
fn spread(blocks: &Blocks, out: &mut [[f64; 8]; 8]) {
    let [a, b, d] = blocks;
    for (k, &(i, j)) in ENTRIES.iter().enumerate() {
        for (i, j) in [(i, j), (j, i)].into_iter().take(if i == j { 1 } else { 2 }) {
            out[i][j] += a[k];
            out[i][j + 3] += b[k];
            out[i + 3][j] += b[k];
            out[i + 3][j + 3] += d[k];
        }
    }
}
