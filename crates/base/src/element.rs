//! A beam of the strip, or a ring of a round plate.
//!
//! ```text
//! w cubic, u linear          ε = u′ + 1/(2h) ∫ w′² dx ,  κ = w″           ring: ε_φ = u/r ,  κ_φ = w′/r ,  weight r/R
//! ground: pressure k ⟨−w⟩ upwards           liquid: pressure p downwards
//! ```
//!
//! The membrane strain is one value an element: a cubic w and a linear u cannot agree point by point, and would lock.
//! x runs from the centre to the rim, so that w′ = θ. Ground and pressure are integrated with three Gauss points, on which contact
//! opens and closes.

use crate::plate::{Plate, Section};

/// Unknowns: u, w, θ of the inner node, then of the outer one.
pub(crate) const SIZE: usize = 6;

/// Gauss points of an element and their weights on 0 to 1.
pub(crate) const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];

/// What the length of an element alone gives: its cubics at the Gauss points, and the rows of its rise.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cubics {
    /// Length h [m].
    pub(crate) length: f64,
    points: [[[f64; 4]; 3]; 3],
    rise: [[f64; 4]; 4],
}

impl Cubics {
    pub(crate) fn new(length: f64) -> Cubics {
        Cubics { length, points: GAUSS.map(|(x, _)| shape(x, length)), rise: rise(length) }
    }
}

/// One element.
pub(crate) struct Element<'a> {
    /// Its length and cubics.
    pub(crate) cubics: &'a Cubics,
    /// Its plate.
    pub(crate) plate: &'a Plate,
    /// Radius of its inner node and of the rim [m], of a round plate.
    pub(crate) round: Option<(f64, f64)>,
    /// Modulus of the ground [N/m³].
    pub(crate) modulus: f64,
    /// Pressure of the liquid on the plate, downwards [Pa].
    pub(crate) pressure: f64,
}

/// Internal less external forces, and their tangent.
pub(crate) struct Answer {
    pub(crate) force: [f64; SIZE],
    /// Its lower half.
    pub(crate) tangent: [[f64; SIZE]; SIZE],
    /// Sections at the Gauss points.
    pub(crate) sections: [Section; 3],
    /// Curvatures there [1/m].
    pub(crate) curvature: [f64; 3],
}

/// Unknowns of the deflection: w and θ of both nodes.
const BENT: [usize; 4] = [1, 2, 4, 5];

/// Sums over the sections of an element.
#[derive(Default)]
struct Sums {
    /// N and its tangent.
    n: f64,
    ee: f64,
    /// Forces of w and θ, their coupling with N, and their tangent.
    force: [f64; 4],
    mixed: [f64; 4],
    stiff: [[f64; 4]; 4],
    coupled: bool,
}

impl Sums {
    /// Adds them to forces and to the lower half of the tangent, which is all that is read.
    #[inline(always)]
    fn assemble(&self, answer: &mut Answer, stretch: &[f64; SIZE], bend: &[[f64; 4]; 4]) {
        let Sums { n, ee, .. } = *self;
        for a in 0..SIZE {
            answer.force[a] += n * stretch[a];
            let pulled = ee * stretch[a];
            for b in 0..=a {
                answer.tangent[a][b] += pulled * stretch[b];
            }
        }
        if self.coupled {
            let mixed = wide(&self.mixed);
            for a in 0..SIZE {
                for b in 0..=a {
                    answer.tangent[a][b] += stretch[a] * mixed[b] + mixed[a] * stretch[b];
                }
            }
        }
        for (a, i) in BENT.into_iter().enumerate() {
            answer.force[i] += self.force[a];
            for (b, j) in BENT.into_iter().enumerate().take(a + 1) {
                answer.tangent[i][j] += self.stiff[a][b] + n * bend[a][b];
            }
        }
    }
}

/// w, w′, w″ of the cubics at `x` of 0 to 1, as rows over the unknowns of the deflection.
fn shape(x: f64, h: f64) -> [[f64; 4]; 3] {
    let (x2, x3) = (x * x, x * x * x);
    [
        [1.0 - 3.0 * x2 + 2.0 * x3, h * (x - 2.0 * x2 + x3), 3.0 * x2 - 2.0 * x3, h * (x3 - x2)],
        [6.0 * (x2 - x) / h, 1.0 - 4.0 * x + 3.0 * x2, 6.0 * (x - x2) / h, 3.0 * x2 - 2.0 * x],
        [(12.0 * x - 6.0) / (h * h), (6.0 * x - 4.0) / h, (6.0 - 12.0 * x) / (h * h), (6.0 * x - 2.0) / h],
    ]
}

/// ∫ N′ᵀ N′ dx/h of the cubics N over an element of length h: half of its square form is the strain that the deflection adds.
fn rise(h: f64) -> [[f64; 4]; 4] {
    let (a, b) = (1.2 / (h * h), 0.1 / h);
    let (c, d) = (4.0 / 30.0, -1.0 / 30.0);
    [[a, b, -a, b], [b, c, -b, d], [-a, -b, a, -b], [b, d, -b, c]]
}

/// A row over all unknowns.
#[inline(always)]
fn wide(row: &[f64; 4]) -> [f64; SIZE] {
    [0.0, row[0], row[1], 0.0, row[2], row[3]]
}

#[inline(always)]
fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn add(answer: &mut Answer, weight: f64, row: &[f64; SIZE], force: f64, other: &[f64; SIZE], stiffness: f64) {
    for i in 0..SIZE {
        answer.force[i] += weight * row[i] * force;
        for j in 0..SIZE {
            answer.tangent[i][j] += weight * stiffness * row[i] * other[j];
        }
    }
}

impl Element<'_> {
    #[inline(always)]
    fn weight(&self, x: f64) -> (f64, f64) {
        match self.round {
            None => (1.0, f64::INFINITY),
            Some((inner, rim)) => ((inner + x * self.cubics.length) / rim, inner + x * self.cubics.length),
        }
    }

    /// Response to the displacements `q`; `old` and `new` are the plastic strains of its three sections, and which of them have yielded.
    #[inline(always)]
    pub(crate) fn respond(&self, q: &[f64; SIZE], old: (&[f64], &[bool]), new: (&mut [f64], &mut [bool])) -> Answer {
        let h = self.cubics.length;
        let bent = BENT.map(|i| q[i]);
        // ½ ∫ w′² dx/h and its derivatives.
        let bend = &self.cubics.rise;
        let slope = bend.each_ref().map(|row| dot(row, &bent));
        let strain = (q[3] - q[0]) / h + 0.5 * dot(&slope, &bent);
        let stretch = [-1.0 / h, slope[0], slope[1], 1.0 / h, slope[2], slope[3]];

        let mut answer = Answer {
            force: [0.0; SIZE],
            tangent: [[0.0; SIZE]; SIZE],
            sections: [Section::default(); 3],
            curvature: [0.0; 3],
        };
        let fibres = old.0.len() / 3;
        let mut sums = Sums::default();
        for (i, (x, g)) in GAUSS.into_iter().enumerate() {
            let [w_row, slope_row, bend_row] = &self.cubics.points[i];
            let (share, r) = self.weight(x);
            let da = g * h * share;
            let range = i * fibres..(i + 1) * fibres;
            let curvature = dot(bend_row, &bent);
            let before = (&old.0[range.clone()], old.1[i]);
            let after = (&mut new.0[range], &mut new.1[i]);
            let mut section = self.plate.respond(strain, curvature, before, after);
            answer.curvature[i] = curvature;
            if self.round.is_some() {
                let nu = self.plate.poisson_ratio;
                let u_row = [(1.0 - x) / r, 0.0, 0.0, x / r, 0.0, 0.0];
                let (turn_row, bend_row) = (wide(&slope_row.map(|v| v / r)), wide(bend_row));
                let (hoop, turn) = (dot(&u_row, q), dot(&turn_row, q));
                let (c, d) = (section.ee, section.kk);
                section.n += c * nu * hoop;
                section.m += d * nu * turn;
                add(&mut answer, da, &u_row, c * (hoop + nu * strain), &u_row, c);
                add(&mut answer, da, &u_row, 0.0, &stretch, c * nu);
                add(&mut answer, da, &stretch, 0.0, &u_row, c * nu);
                add(&mut answer, da, &turn_row, d * (turn + nu * curvature), &turn_row, d);
                add(&mut answer, da, &turn_row, 0.0, &bend_row, d * nu);
                add(&mut answer, da, &bend_row, 0.0, &turn_row, d * nu);
            }
            let sinks = dot(w_row, &bent).min(0.0);
            let ground = if sinks < 0.0 { da * self.modulus } else { 0.0 };
            let load = da * (self.pressure + self.modulus * sinks);
            let (moment, couple, bending) = (da * section.m, da * section.ek, da * section.kk);
            sums.coupled |= couple != 0.0;
            sums.n += da * section.n;
            sums.ee += da * section.ee;
            for a in 0..4 {
                sums.force[a] += moment * bend_row[a] + load * w_row[a];
                sums.mixed[a] += couple * bend_row[a];
                let (k, s) = (bending * bend_row[a], ground * w_row[a]);
                for b in 0..=a {
                    sums.stiff[a][b] += k * bend_row[b] + s * w_row[b];
                }
            }
            answer.sections[i] = section;
        }
        sums.assemble(&mut answer, &stretch, bend);
        answer
    }

    /// Deflection at a Gauss point, by its number [m].
    pub(crate) fn deflection(&self, q: &[f64; SIZE], point: usize) -> f64 {
        dot(&self.cubics.points[point][0], &BENT.map(|i| q[i]))
    }
}
