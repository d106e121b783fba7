//! What is outside of a zone, by circumferential harmonics.
//!
//! ```text
//! ⎡ E  Bᵀ ⎤ = G ⎡ Ê  B̂ᵀ ⎤ Gᵀ          Ê, B̂: one section for each harmonic, the mean over all turns and the reflection
//! ⎣ B  ·  ⎦     ⎣ B̂  ·  ⎦
//! C = G Ĉ Gᵀ ,  Ĉ = −B̂ Ê⁻¹ B̂ᵀ
//! x_E = H Ê⁻¹ (Hᵀ b_E − B̂ᵀ Gᵀ x_S) ,   b_S − B E⁻¹ b_E = b_S − G B̂ Ê⁻¹ Hᵀ b_E
//! ```
//!
//! with G and H of [`crate::ring`], HᵀG = 1. A round wall that is elastic is its mean but for the change of its geometric stiffness; where it
//! yields at one side E differs from it, as it differs from a tangent that is kept. Memory grows with the number of cells, and a factor of all sections costs
//! less than one of the zone; the dense block of the liquid over all wetted nodes took n²/2 entries and n³/3 operations.

use super::NONE;
use crate::analysis::AnalysisError;
use crate::analysis::rings::{Order, RingLayout, Without};
use crate::assembly::Assembler;
use crate::cores::each;
use crate::linalg::{Fronts, Keep, LinalgError, Matrix, Symmetric};
use crate::model::Model;
use crate::ring::{RingOperator, Weight};

/// Sections of the outside and of the rows that the zone touches, which come last.
pub(super) struct Sections {
    layout: RingLayout,
    operators: Vec<RingOperator>,
    /// Of harmonics without and with amplitudes.
    orders: [Order; 2],
    /// Which of the orders a harmonic has.
    order_of: Vec<usize>,
    /// Rows that the zone touches, with the numbers of their unknowns among those touched, by meridian.
    seams: Vec<(usize, Vec<u32>)>,
    /// Other rows.
    own: Vec<usize>,
    /// Number of unknowns that are touched.
    touched: usize,
}

impl Sections {
    /// * `touched`: unknowns of the zone that the outside touches, numbered in their order
    ///
    /// Errors: those of [`RingLayout::new`].
    pub(super) fn new(model: &Model, assembler: &Assembler, without: Without<'_>) -> Result<Sections, AnalysisError> {
        let layout = RingLayout::of(model, assembler, Some(without))?;
        let mut number = vec![NONE; model.dofs().len()];
        let touched = (0..number.len()).filter(|&e| without.touched[e]).enumerate().map(|(k, e)| number[e] = k as u32);
        let touched = touched.count();
        let (mut seams, mut own) = (Vec::new(), Vec::new());
        for row in 0..layout.size() {
            let numbers = layout.equations(row).iter().map(|&e| number.get(e as usize).copied().unwrap_or(NONE));
            let numbers: Vec<u32> = numbers.collect();
            match numbers.iter().all(|n| *n == NONE) {
                true => own.push(row),
                false => seams.push((row, numbers)),
            }
        }
        let last: Vec<usize> = seams.iter().map(|s| s.0).collect();
        let order = |sloshing: usize| Order::new(&layout, sloshing, [&own, &last]);
        Ok(Sections {
            operators: assembler.operators(model).map(|placed| placed.operator.clone()).collect(),
            orders: [order(0), order(1)],
            order_of: (0..layout.ring().harmonics()).map(|m| usize::from(layout.has_amplitudes(m))).collect(),
            layout,
            seams,
            own,
            touched,
        })
    }

    /// Number of unknowns that are eliminated.
    pub(super) fn size(&self) -> usize {
        let free = |row: &usize| self.layout.equations(*row).iter().filter(|e| **e != NONE).count();
        self.own.iter().map(free).sum::<usize>() + self.layout.amplitudes().len()
    }

    /// Memory for the factors.
    ///
    /// Errors: not enough of it.
    pub(super) fn fronts(&self, keep: Keep) -> Result<Vec<Fronts>, LinalgError> {
        let [plain, sloshing] = self.orders.each_ref().map(|order| order.fronts(keep));
        let both = [plain?, sloshing?];
        Ok(self.order_of.iter().map(|&k| both[k].another()).collect())
    }

    /// Factors the outside; returns the lower triangle of C with the operators' own entries there, over the touched unknowns.
    ///
    /// Errors: a zero pivot, not enough memory.
    pub(super) fn factor(
        &self,
        base: &Symmetric,
        shares: &[[f64; 2]],
        fronts: &mut [Fronts],
        threads: usize,
    ) -> Result<Matrix, LinalgError> {
        let layout = &self.layout;
        let (mean, wide, amplitudes) = (layout.mean(base), layout.wide(base), layout.amplitude_diagonal(base));
        let one = |m: usize, fronts: &mut Fronts| -> Result<Matrix, LinalgError> {
            let order = &self.orders[self.order_of[m]];
            let mut section = layout.section(m, &mean);
            layout.add_wide(&mut section, m, &wide);
            for (number, (operator, [on_mass, on_stiffness])) in self.operators.iter().zip(shares).enumerate() {
                let block = &operator.blocks()[m];
                layout.add_block(&mut section, number, *on_mass, &block.mass);
                if let Some(k) = &block.stiffness {
                    layout.add_block(&mut section, number, *on_stiffness, k);
                }
            }
            let mut own = Matrix::zeros(self.seams.len(), self.seams.len());
            for (b, (column, _)) in self.seams.iter().enumerate() {
                for (a, (row, _)) in self.seams.iter().enumerate().skip(b) {
                    own.add(a, b, section.get(*row.max(column), *row.min(column)));
                }
            }
            layout.close(&mut section, m, &amplitudes);
            let c = fronts.factor(&order.ordered(&section), 1)?;
            own.data.iter_mut().zip(&c.data).for_each(|(own, c)| *own += c);
            Ok(own)
        };
        let found = each(threads, fronts, one).into_iter().collect::<Result<Vec<Matrix>, LinalgError>>()?;
        Ok(self.spread(&found))
    }

    /// G Ĉ Gᵀ, lower triangle.
    fn spread(&self, c: &[Matrix]) -> Matrix {
        let ring = self.layout.ring();
        let (families, mut room) = (ring.families(), ring.room());
        let mut out = Matrix::zeros(self.touched, self.touched);
        let mut unit = vec![0.0; ring.meridians()];
        let (mut waves, mut field) = (vec![[0.0; 2]; ring.harmonics()], vec![0.0; ring.meridians()]);
        for (b, (column, numbers)) in self.seams.iter().enumerate() {
            for (l, &j) in numbers.iter().enumerate().filter(|(_, j)| **j != NONE) {
                unit[l] = 1.0;
                let odd = self.layout.is_odd(*column);
                ring.analyse(&unit, odd, Weight::Forces, &mut room, |m, f, c| waves[m][f] = c);
                unit[l] = 0.0;
                for (a, (row, numbers)) in self.seams.iter().enumerate() {
                    let wave = |m: usize, f: usize| match f < families {
                        true => c[m].get(a.max(b), a.min(b)) * waves[m][f],
                        false => 0.0,
                    };
                    ring.synthesise(self.layout.is_odd(*row), Weight::Forces, &mut room, wave, &mut field);
                    for (&i, value) in numbers.iter().zip(&field).filter(|(i, _)| **i != NONE && **i >= j) {
                        out.add(i as usize, j as usize, *value);
                    }
                }
            }
        }
        out
    }

    /// Forward substitution of b; adds −B E⁻¹ b_E to `left`, over the touched unknowns. Returns the columns of the sections, family by family.
    pub(super) fn forward(&self, fronts: &[Fronts], b: &[f64], left: &mut [f64], threads: usize) -> Vec<Vec<f64>> {
        let layout = &self.layout;
        let ring = layout.ring();
        let (families, harmonics) = (ring.families(), ring.harmonics());
        let mut waves = vec![Vec::new(); self.own.len()];
        each(threads, &mut waves, |number, out: &mut Vec<f64>| {
            let row = self.own[number];
            let value = |&e: &u32| b.get(e as usize).copied().unwrap_or(0.0);
            let field: Vec<f64> = layout.equations(row).iter().map(value).collect();
            out.resize(families * harmonics, 0.0);
            let put = |m: usize, f: usize, c: f64| out[f * harmonics + m] = c;
            ring.analyse(&field, layout.is_odd(row), Weight::Displacements, &mut ring.room(), put);
        });
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); families * harmonics];
        each(threads, &mut columns, |number, out: &mut Vec<f64>| {
            let (m, order) = (number % harmonics, &self.orders[self.order_of[number % harmonics]]);
            out.resize(order.of.len(), 0.0);
            for (&row, wave) in self.own.iter().zip(&waves) {
                out[order.of[row]] = wave[number];
            }
            for &(e, a) in layout.amplitudes().iter().filter(|(_, a)| a.harmonic + a.family * harmonics == number) {
                out[order.of[layout.size() + a.slot]] = b[e];
            }
            fronts[m].forward(out, 1);
        });
        let mut room = ring.room();
        let mut field = vec![0.0; ring.meridians()];
        for (row, numbers) in &self.seams {
            let wave = |m: usize, f: usize| match f < families {
                true => columns[f * harmonics + m][self.orders[self.order_of[m]].of[*row]],
                false => 0.0,
            };
            ring.synthesise(layout.is_odd(*row), Weight::Forces, &mut room, wave, &mut field);
            for (&i, value) in numbers.iter().zip(&field).filter(|(i, _)| **i != NONE) {
                left[i as usize] += value;
            }
        }
        columns
    }

    /// Backward substitution into the unknowns of x that are outside, from the columns of [`Sections::forward`] and the touched unknowns.
    pub(super) fn backward(
        &self,
        fronts: &[Fronts],
        mut columns: Vec<Vec<f64>>,
        touched: &[f64],
        x: &mut [f64],
        threads: usize,
    ) {
        let layout = &self.layout;
        let ring = layout.ring();
        let harmonics = ring.harmonics();
        let mut room = ring.room();
        for (row, numbers) in &self.seams {
            let field: Vec<f64> = numbers.iter().map(|&i| touched.get(i as usize).copied().unwrap_or(0.0)).collect();
            let put = |m: usize, f: usize, c: f64| {
                columns[f * harmonics + m][self.orders[self.order_of[m]].of[*row]] = c;
            };
            ring.analyse(&field, layout.is_odd(*row), Weight::Forces, &mut room, put);
        }
        each(threads, &mut columns, |number, own: &mut Vec<f64>| fronts[number % harmonics].backward(own, 1));
        for &(e, a) in layout.amplitudes() {
            let order = &self.orders[self.order_of[a.harmonic]];
            x[e] = columns[a.family * harmonics + a.harmonic][order.of[layout.size() + a.slot]];
        }
        let mut fields = vec![Vec::new(); self.own.len()];
        each(threads, &mut fields, |number, out: &mut Vec<f64>| {
            let row = self.own[number];
            out.resize(ring.meridians(), 0.0);
            let wave = |m: usize, f: usize| columns[f * harmonics + m][self.orders[self.order_of[m]].of[row]];
            ring.synthesise(layout.is_odd(row), Weight::Displacements, &mut ring.room(), wave, out);
        });
        for (&row, field) in self.own.iter().zip(&fields) {
            for (&e, value) in layout.equations(row).iter().zip(field).filter(|(e, _)| **e != NONE) {
                x[e as usize] = *value;
            }
        }
    }
}
