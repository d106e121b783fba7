//! Order of elimination of a section, and its factor.

use std::sync::Arc;

use super::layout::RingLayout;
use crate::linalg::{Fronts, Keep, LinalgError, Matrix, Pattern, Symmetric};

/// Order of elimination of a section.
pub(in crate::analysis) struct Order {
    /// Position of each unknown.
    pub(in crate::analysis) of: Vec<usize>,
    pattern: Arc<Pattern>,
    /// Place of each place of the section.
    places: Vec<usize>,
    /// Unknowns that are eliminated.
    eliminated: usize,
}

impl Order {
    /// First the `rows`, from the last one up, what the liquid joins at their end; then the `seams`, which stay.
    pub(in crate::analysis) fn new(layout: &RingLayout, sloshing: usize, [rows, seams]: [&[usize]; 2]) -> Order {
        let section = layout.pattern(sloshing);
        let (size, count) = (section.size(), seams.len());
        let mut joined = vec![false; size];
        layout.levels().for_each(|row| joined[row] = true);
        let alone = rows.iter().rev().filter(|r| !joined[**r]);
        let others = rows.iter().filter(|r| joined[**r]);
        let sequence = alone.chain(others).copied().chain(layout.size()..size).chain(seams.iter().copied());
        let mut of = vec![0; size];
        sequence.enumerate().for_each(|(k, i)| of[i] = k);
        let mut pairs = Vec::with_capacity(section.places());
        for j in 0..size {
            let rows = &section.rows[section.starts[j]..section.starts[j + 1]];
            pairs.extend(rows.iter().map(|&i| [of[i].max(of[j]), of[i].min(of[j])]));
        }
        let border: Vec<usize> = (size - count..size).collect();
        let cliques = pairs.iter().map(|pair| &pair[..]).filter(|pair| pair[0] != pair[1]);
        let pattern = Pattern::from_cliques(size, cliques.chain(std::iter::once(&border[..])));
        let places = pairs.iter().filter_map(|&[i, j]| pattern.place(i, j)).collect();
        Order { eliminated: size - count, of, pattern: Arc::new(pattern), places }
    }

    /// Memory for a factor.
    ///
    /// Errors: not enough of it.
    pub(in crate::analysis) fn fronts(&self, keep: Keep) -> Result<Fronts, LinalgError> {
        Fronts::new(&self.pattern, self.eliminated, keep)
    }

    /// A section in this order.
    pub(in crate::analysis) fn ordered(&self, section: &Symmetric) -> Symmetric {
        let mut out = Symmetric::zeros(self.pattern.clone());
        self.places.iter().zip(&section.values).for_each(|(&to, value)| out.values[to] = *value);
        out
    }
}

/// Factor of a whole section.
pub(super) struct SectionFactor {
    order: Arc<Order>,
    fronts: Fronts,
}

impl SectionFactor {
    /// Memory for one.
    ///
    /// Errors: not enough of it.
    pub(super) fn new(order: &Arc<Order>) -> Result<SectionFactor, LinalgError> {
        Ok(SectionFactor { order: order.clone(), fronts: order.fronts(Keep::Double)? })
    }

    /// Factors a section.
    ///
    /// Errors: a matrix that is not positive definite; the factor is lost then.
    pub(super) fn renew(&mut self, section: &Symmetric) -> Result<(), LinalgError> {
        self.fronts.factor(&self.order.ordered(section), 1)?;
        match self.fronts.first_negative() {
            Some(pivot) => Err(LinalgError::NotPositiveDefinite { pivot, size: section.size() }),
            None => Ok(()),
        }
    }

    /// X ← A⁻¹ X.
    pub(super) fn solve(&self, x: &mut Matrix) {
        let mut own = vec![0.0; x.rows];
        for j in 0..x.cols {
            let column = x.column_mut(j);
            self.order.of.iter().zip(&*column).for_each(|(&to, value)| own[to] = *value);
            self.fronts.forward(&mut own, 1);
            self.fronts.backward(&mut own, 1);
            column.iter_mut().zip(&self.order.of).for_each(|(value, &from)| *value = own[from]);
        }
    }
}
