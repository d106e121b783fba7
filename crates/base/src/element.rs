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
pub(crate) const GAUSS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_3, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

/// One element.
pub(crate) struct Element<'a> {
    /// Length h [m].
    pub(crate) length: f64,
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
    pub(crate) tangent: [[f64; SIZE]; SIZE],
    /// Sections at the Gauss points.
    pub(crate) sections: [Section; 3],
    /// Curvatures there [1/m].
    pub(crate) curvature: [f64; 3],
}

/// w, w′, w″ of the cubics at `x` of 0 to 1, as rows over the unknowns.
fn shape(x: f64, h: f64) -> [[f64; SIZE]; 3] {
    let (x2, x3) = (x * x, x * x * x);
    [
        [
            0.0,
            1.0 - 3.0 * x2 + 2.0 * x3,
            h * (x - 2.0 * x2 + x3),
            0.0,
            3.0 * x2 - 2.0 * x3,
            h * (x3 - x2),
        ],
        [
            0.0,
            6.0 * (x2 - x) / h,
            1.0 - 4.0 * x + 3.0 * x2,
            0.0,
            6.0 * (x - x2) / h,
            3.0 * x2 - 2.0 * x,
        ],
        [
            0.0,
            (12.0 * x - 6.0) / (h * h),
            (6.0 * x - 4.0) / h,
            0.0,
            (6.0 - 12.0 * x) / (h * h),
            (6.0 * x - 2.0) / h,
        ],
    ]
}

fn dot(a: &[f64; SIZE], b: &[f64; SIZE]) -> f64 {
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
    fn weight(&self, x: f64) -> (f64, f64) {
        match self.round {
            None => (1.0, f64::INFINITY),
            Some((inner, rim)) => ((inner + x * self.length) / rim, inner + x * self.length),
        }
    }

    /// Response to the displacements `q`; `old` and `new` are the plastic strains of its three sections.
    pub(crate) fn respond(&self, q: &[f64; SIZE], old: &[f64], new: &mut [f64]) -> Answer {
        let h = self.length;
        // ½ ∫ w′² dx/h and its derivatives, exact with three points for a quartic.
        let mut rise = 0.0;
        let mut slope = [0.0; SIZE];
        let mut bend = [[0.0; SIZE]; SIZE];
        for (x, g) in GAUSS {
            let row = shape(x, h)[1];
            let w = dot(&row, q);
            rise += 0.5 * g * w * w;
            for i in 0..SIZE {
                slope[i] += g * w * row[i];
                for j in 0..SIZE {
                    bend[i][j] += g * row[i] * row[j];
                }
            }
        }
        let strain = (q[3] - q[0]) / h + rise;
        let mut stretch = slope;
        stretch[0] -= 1.0 / h;
        stretch[3] += 1.0 / h;

        let mut answer = Answer {
            force: [0.0; SIZE],
            tangent: [[0.0; SIZE]; SIZE],
            sections: [Section::default(); 3],
            curvature: [0.0; 3],
        };
        let fibres = old.len() / 3;
        for (i, (x, g)) in GAUSS.into_iter().enumerate() {
            let [w_row, slope_row, bend_row] = shape(x, h);
            let (share, r) = self.weight(x);
            let da = g * h * share;
            let range = i * fibres..(i + 1) * fibres;
            let curvature = dot(&bend_row, q);
            let mut section = self
                .plate
                .respond(strain, curvature, &old[range.clone()], &mut new[range]);
            answer.curvature[i] = curvature;
            if self.round.is_some() {
                let nu = self.plate.poisson_ratio;
                let u_row = [(1.0 - x) / r, 0.0, 0.0, x / r, 0.0, 0.0];
                let turn_row = slope_row.map(|v| v / r);
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
            add(&mut answer, da, &stretch, section.n, &stretch, section.ee);
            add(&mut answer, da, &bend_row, section.m, &bend_row, section.kk);
            add(&mut answer, da, &stretch, 0.0, &bend_row, section.ek);
            add(&mut answer, da, &bend_row, 0.0, &stretch, section.ek);
            for a in 0..SIZE {
                for b in 0..SIZE {
                    answer.tangent[a][b] += da * section.n * bend[a][b];
                }
            }
            let sinks = dot(&w_row, q).min(0.0);
            let stiffness = if sinks < 0.0 { self.modulus } else { 0.0 };
            add(
                &mut answer,
                da,
                &w_row,
                self.pressure + self.modulus * sinks,
                &w_row,
                stiffness,
            );
            answer.sections[i] = section;
        }
        answer
    }

    /// Deflection at a Gauss point [m].
    pub(crate) fn deflection(&self, q: &[f64; SIZE], x: f64) -> f64 {
        dot(&shape(x, self.length)[0], q)
    }
}
