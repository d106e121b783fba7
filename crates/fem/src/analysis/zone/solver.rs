//! Factors of a matrix with a zone.

use std::sync::Arc;

use super::{NONE, Outside, Zone};
use crate::linalg::{Fronts, Keep, LinalgError, Symmetric};

/// Factors of a matrix with a zone.
pub struct ZoneSolver {
    zone: Arc<Zone>,
    /// Factor of E, or of its sections, with B.
    outside: Vec<Fronts>,
    /// S without the elements of the zone, and C.
    rest: Vec<f64>,
    matrix: Symmetric,
    inside: Fronts,
    threads: usize,
}

impl ZoneSolver {
    /// Memory for the factors, kept as `keep` says.
    ///
    /// Errors: not enough of it.
    pub fn new(zone: &Arc<Zone>, keep: Keep, threads: usize) -> Result<ZoneSolver, LinalgError> {
        let inner = &zone.inner;
        Ok(ZoneSolver {
            outside: match &zone.outside {
                Outside::Dissected(own) => vec![Fronts::new(&own.pattern, own.size, keep)?],
                Outside::Harmonic(own) => own.fronts(keep)?,
            },
            rest: vec![0.0; inner.places()],
            matrix: Symmetric::zeros(inner.clone()),
            inside: Fronts::new(inner, inner.size(), keep)?,
            zone: zone.clone(),
            threads,
        })
    }

    /// Whether the outside is its mean over all turns: a solution then guides an iteration.
    pub fn is_mean(&self) -> bool {
        matches!(self.zone.outside, Outside::Harmonic(_))
    }

    /// Keeps the next factor of the zone, and with `outside` that of the outside, in this precision.
    pub fn keep_as(&mut self, keep: Keep, outside: bool) {
        self.inside.keep_as(keep);
        if outside {
            self.outside.iter_mut().for_each(|own| own.keep_as(keep));
        }
    }

    /// Factors `base` + `factor` `own` + the operators, `shares` times their mass and stiffness; `own` is that of the elements of the zone.
    ///
    /// Errors: a zero pivot, not enough memory; the solver must not be used then.
    pub fn renew(
        &mut self,
        base: &Symmetric,
        own: Option<(f64, &Symmetric)>,
        shares: &[[f64; 2]],
    ) -> Result<(), LinalgError> {
        self.renew_outside(base, shares)?;
        self.renew_zone(own)
    }

    /// Factors the outside alone; [`ZoneSolver::renew_zone`] comes before a solution.
    ///
    /// Errors: a zero pivot, not enough memory; the solver must not be used then.
    pub fn renew_outside(&mut self, base: &Symmetric, shares: &[[f64; 2]]) -> Result<(), LinalgError> {
        let zone = self.zone.clone();
        self.rest.fill(0.0);
        for &[from, to] in &zone.inner_places {
            self.rest[to as usize] = base.values[from as usize];
        }
        let c = match &zone.outside {
            Outside::Dissected(own) => {
                let mut outer = Symmetric::zeros(own.pattern.clone());
                own.places.iter().for_each(|&[from, to]| outer.values[to as usize] = base.values[from as usize]);
                self.outside[0].factor(&outer, self.threads)?
            }
            Outside::Harmonic(own) => own.factor(base, shares, &mut self.outside, self.threads)?,
        };
        let mut places = zone.border.iter();
        for b in 0..c.cols {
            for (value, &p) in c.column(b)[b..].iter().zip(places.by_ref()) {
                self.rest[p as usize] += value;
            }
        }
        Ok(())
    }

    /// Factors the zone alone, for other values of its elements.
    ///
    /// Errors: a zero pivot, not enough memory; the solver must not be used then.
    pub fn renew_zone(&mut self, own: Option<(f64, &Symmetric)>) -> Result<(), LinalgError> {
        let ZoneSolver { zone, rest, matrix, inside, threads, .. } = self;
        matrix.values.copy_from_slice(rest);
        if let Some((factor, own)) = own {
            for &[from, to] in &zone.inner_places {
                matrix.values[to as usize] += factor * own.values[from as usize];
            }
        }
        inside.factor(matrix, *threads).map(|_| ())
    }

    /// x = A⁻¹ b, as exact as the factors are kept.
    pub fn solve(&self, b: &[f64], x: &mut Vec<f64>) {
        let zone = &*self.zone;
        let mut inner = vec![0.0; zone.inner.size()];
        for (&i, b) in zone.inner_of.iter().zip(b).filter(|(i, _)| **i != NONE) {
            inner[i as usize] = *b;
        }
        x.clear();
        x.resize(b.len(), 0.0);
        let mut seam = vec![0.0; zone.touched.len()];
        match &zone.outside {
            Outside::Dissected(own) => {
                let fronts = &self.outside[0];
                let mut outer = vec![0.0; own.pattern.size()];
                for (&o, b) in own.of[..].iter().zip(b).filter(|(o, _)| (**o as usize) < own.size) {
                    outer[o as usize] = *b;
                }
                fronts.forward(&mut outer, self.threads);
                seam.copy_from_slice(&outer[own.size..]);
                self.within(&mut inner, &mut seam);
                outer[own.size..].copy_from_slice(&seam);
                fronts.backward(&mut outer, self.threads);
                for (&o, x) in own.of.iter().zip(&mut *x).filter(|(o, _)| (**o as usize) < own.size) {
                    *x = outer[o as usize];
                }
            }
            Outside::Harmonic(own) => {
                let columns = own.forward(&self.outside, b, &mut seam, self.threads);
                self.within(&mut inner, &mut seam);
                own.backward(&self.outside, columns, &seam, x, self.threads);
            }
        }
        for (&i, x) in zone.inner_of.iter().zip(x).filter(|(i, _)| **i != NONE) {
            *x = inner[i as usize];
        }
    }

    /// Solves for the zone, with what the outside has left on its seam; returns the displacements there.
    fn within(&self, inner: &mut [f64], seam: &mut [f64]) {
        for (&at, left) in self.zone.touched.iter().zip(&*seam) {
            inner[at as usize] += left;
        }
        self.inside.forward(inner, self.threads);
        self.inside.backward(inner, self.threads);
        for (&at, x) in self.zone.touched.iter().zip(seam) {
            *x = inner[at as usize];
        }
    }
}
