//! Factors of a matrix with a zone.

use std::sync::Arc;

use super::{NONE, Zone};
use crate::linalg::{Fronts, Keep, LinalgError, Symmetric};

/// Factors of a matrix with a zone.
pub struct ZoneSolver {
    zone: Arc<Zone>,
    /// E and B, then their factor.
    outer: Symmetric,
    outside: Fronts,
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
            outer: Symmetric::zeros(zone.outer.clone()),
            outside: Fronts::new(&zone.outer, zone.sizes[0], keep)?,
            rest: vec![0.0; inner.places()],
            matrix: Symmetric::zeros(inner.clone()),
            inside: Fronts::new(inner, inner.size(), keep)?,
            zone: zone.clone(),
            threads,
        })
    }

    /// Keeps the next factor of the zone, and with `outside` that of the outside, in this precision.
    pub fn keep_as(&mut self, keep: Keep, outside: bool) {
        self.inside.keep_as(keep);
        if outside {
            self.outside.keep_as(keep);
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
        let outer = &mut self.outer.values;
        outer.fill(0.0);
        self.rest.fill(0.0);
        for &[from, to] in &zone.outer_places {
            outer[to as usize] = base.values[from as usize];
        }
        for &[from, to] in &zone.inner_places {
            self.rest[to as usize] = base.values[from as usize];
        }
        for (dense, share) in zone.operators.iter().zip(shares) {
            dense.outer.add(*share, outer);
            dense.inner.add(*share, &mut self.rest);
        }
        let c = self.outside.factor(&self.outer, self.threads)?;
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
        let [outside, size] = zone.sizes;
        let (mut outer, mut inner) = (vec![0.0; zone.outer.size()], vec![0.0; size]);
        for ((&o, &i), b) in zone.outer_of.iter().zip(&zone.inner_of).zip(b) {
            match i {
                NONE => outer[o as usize] = *b,
                i => inner[i as usize] = *b,
            }
        }
        self.outside.forward(&mut outer, self.threads);
        for (&at, left) in zone.touched.iter().zip(&outer[outside..]) {
            inner[at as usize] += left;
        }
        self.inside.forward(&mut inner, self.threads);
        self.inside.backward(&mut inner, self.threads);
        for (&at, x) in zone.touched.iter().zip(&mut outer[outside..]) {
            *x = inner[at as usize];
        }
        self.outside.backward(&mut outer, self.threads);
        x.clear();
        x.extend(zone.outer_of.iter().zip(&zone.inner_of).map(|(&o, &i)| match i {
            NONE => outer[o as usize],
            i => inner[i as usize],
        }));
    }
}
