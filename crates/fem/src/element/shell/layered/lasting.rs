//! Free strains and creep of a section: what the state at rest leaves behind.
//!
//! ```text
//! while loads last       ε = (E(ζ) − s ε₀)/(1 + φ)                          strain of a law, s from 0 to 1 with the load steps
//! afterwards             ε = E(ζ) − φ/(1 + φ) E_∞(ζ) − ε₀/(1 + φ)          E_∞ at the end of the lasting loads
//! ```
//!
//! ε₀ is the strain that a layer would have without stress: temperature, shrinkage; in bars with a prestress σ_p it is −σ_p/E. Layers
//! creep by the factor 1 + φ on all strains of their law (EN 1992-1-1, 5.8.6 (4)), which is the effective modulus E/(1 + φ) where they are elastic;
//! when the lasting loads end, what has crept stays and stresses do not change. Bars and transverse shear do not creep.
//!
//! The state of a point stands at the end of its history: s, the s of the committed strains, 1 while loads last, and E_∞ as ε, κ.

use super::{Layer, LayeredSection, Rod, add_layer, at_depth, at_rest, check};
use crate::element::{ElementError, Stage};

/// Free strain and creep of a ply.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlyState {
    /// ε₀ at its lower and at its upper face, linear between them and equal in all directions of the plane.
    pub free: [f64; 2],
    /// Creep coefficient φ ≥ 0.
    pub creep: f64,
}

// Slots of a point, after those of layers and bars.
const SHARE: usize = 0;
const COMMITTED: usize = 1;
const LASTS: usize = 2;
const STRAIN: usize = 3; // ε, κ
const LEN: usize = 9;

/// Constants of a section with free strains or creep.
#[derive(Clone, Debug)]
pub(super) struct Lasting {
    /// First slot.
    start: usize,
    /// [`LayeredSection::constant`] and [`LayeredSection::whole`] while loads last.
    pub(super) tangents: [[[f64; 8]; 8]; 2],
    /// Resultants that hold these parts at zero strain against their free strains; of a whole point both are `[1]`.
    restrained: [[f64; 8]; 2],
}

/// What lasts at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    share: f64,
    lasts: bool,
    strain: [f64; 8],
}

impl Point {
    /// Factor on the strain increments of a layer that creeps by `ease` = 1/(1 + φ).
    pub(super) fn rate(&self, ease: f64) -> f64 {
        if self.lasts { ease } else { 1.0 }
    }
}

impl Layer {
    /// Strain of its law at the strain of the section.
    pub(super) fn strain(&self, strain: &[f64; 8], lasting: Option<&Point>) -> [f64; 3] {
        let at = at_depth(strain, self.depth);
        let Some(point) = lasting else { return at };
        let free = self.ease * point.share * self.free;
        let crept = at_depth(&point.strain, self.depth);
        std::array::from_fn(|i| {
            let own = if point.lasts { self.ease * at[i] } else { at[i] - (1.0 - self.ease) * crept[i] };
            if i < 2 { own - free } else { own }
        })
    }
}

impl Rod {
    /// Strain of its law at the strain of the section.
    pub(super) fn own_strain(&self, strain: &[f64; 8], lasting: Option<&Point>) -> f64 {
        self.strain(strain) - lasting.map_or(0.0, |point| point.share * self.free)
    }
}

impl Lasting {
    /// State of a point in its history; `committed`: the one in which its committed strains were reached.
    pub(super) fn point(&self, history: &[f64], committed: bool) -> Point {
        let own = &history[self.start..];
        Point {
            share: own[if committed { COMMITTED } else { SHARE }],
            lasts: own[LASTS] == 1.0,
            strain: std::array::from_fn(|i| if i < 6 { own[STRAIN + i] } else { 0.0 }),
        }
    }

    /// Tangent of the constant part now, and the resultants to be taken off: those of what is free or has crept.
    pub(super) fn constants<'a>(
        &'a self,
        point: &Point,
        whole: bool,
        short: &'a [[f64; 8]; 8],
    ) -> (&'a [[f64; 8]; 8], [f64; 8]) {
        let (lasting, restrained) = (&self.tangents[usize::from(whole)], &self.restrained[usize::from(whole)]);
        let mut off = restrained.map(|n| point.share * n);
        if point.lasts {
            return (lasting, off);
        }
        for ((off, k), k_lasting) in off.iter_mut().zip(short).zip(lasting) {
            *off += k.iter().zip(k_lasting).zip(&point.strain).map(|((k, l), e)| (k - l) * e).sum::<f64>();
        }
        (short, off)
    }

    /// Writes the trial history.
    pub(super) fn carry(&self, strain: &[f64; 8], old: &[f64], new: &mut [f64]) {
        let (old, new) = (&old[self.start..], &mut new[self.start..]);
        new.copy_from_slice(old);
        new[COMMITTED] = old[SHARE];
        if old[LASTS] == 1.0 {
            new[STRAIN..].copy_from_slice(&strain[..6]);
        }
    }

    /// Changes the stage in a committed history.
    pub(super) fn set(&self, stage: Stage, history: &mut [f64]) {
        let own = &mut history[self.start..];
        match stage {
            Stage::Lasting(share) => (own[SHARE], own[LASTS]) = (share, 1.0),
            Stage::Short => own[LASTS] = 0.0,
        }
    }
}

impl LayeredSection {
    /// The same with free strains and creep of its `plies`, and free strains of its `bars`, all in the order in which they were given; they act
    /// by [`Stage`]. After [`LayeredSection::with_shear_factor`].
    ///
    /// Errors: another number of plies or bars; a value that is not finite, a negative creep coefficient.
    pub fn lasting(mut self, plies: &[PlyState], bars: &[f64]) -> Result<LayeredSection, ElementError> {
        check(plies.len() == self.plies.len(), "number of states of plies", plies.len() as f64, "that of the plies")?;
        check(bars.len() == self.rods.len(), "number of free strains of bars", bars.len() as f64, "that of the bars")?;
        for (state, range) in plies.iter().zip(&self.plies) {
            check(state.free.iter().all(|e| e.is_finite()), "free strain", state.free[0], "finite")?;
            check(state.creep >= 0.0 && state.creep.is_finite(), "creep coefficient", state.creep, "≥ 0 and finite")?;
            let [bottom, top] = range.faces;
            for layer in &mut self.layers[range.layers.clone()] {
                let part = (layer.depth - bottom) / (top - bottom);
                layer.free = state.free[0] + part * (state.free[1] - state.free[0]);
                layer.ease = 1.0 / (1.0 + state.creep);
            }
        }
        for (rod, &free) in self.rods.iter_mut().zip(bars) {
            check(free.is_finite(), "free strain of bars", free, "finite")?;
            rod.free = free;
        }
        let start = self.reserve(LEN).start;
        self.lasting = Some(self.constants(start)?);
        Ok(self)
    }

    fn constants(&self, start: usize) -> Result<Lasting, ElementError> {
        let mut own = Lasting { start, tangents: [[[0.0; 8]; 8]; 2], restrained: [[0.0; 8]; 2] };
        for i in 6..8 {
            own.tangents.iter_mut().for_each(|k| k[i][i] = self.constant[i][i]);
        }
        for layer in self.layers.iter().filter(|l| l.linear || l.ranged) {
            let moduli = match layer.law.elastic_range().filter(|_| layer.ranged) {
                Some(range) => range.moduli(),
                None => at_rest(&*layer.law)?.tangent,
            };
            let held: [f64; 3] =
                std::array::from_fn(|i| layer.weight * layer.ease * layer.free * (moduli[i][0] + moduli[i][1]));
            for part in (if layer.linear { 0 } else { 1 })..2 {
                add_layer(&moduli, layer.depth, layer.weight * layer.ease, &mut own.tangents[part]);
                for (i, n) in held.iter().enumerate() {
                    own.restrained[part][i] += n;
                    own.restrained[part][3 + i] += layer.depth * n;
                }
            }
        }
        for rod in self.rods.iter().filter(|r| r.linear) {
            let modulus = at_rest(&*rod.law)?.tangent[0][0];
            for part in 0..2 {
                rod.add_tangent(modulus, &mut own.tangents[part]);
                for (n, b) in own.restrained[part].iter_mut().zip(rod.weights()) {
                    *n += rod.area * modulus * rod.free * b;
                }
            }
        }
        Ok(own)
    }
}
