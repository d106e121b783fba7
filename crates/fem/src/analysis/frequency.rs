//! Frequency domain, on a reduced basis.
//!
//! ```text
//! Y(s) = −[K̂ + i sgn(Ω) L̂ + s Ĉ + s² M̂]⁻¹ Σ P̂_k A_k(s)          s = σ + iΩ          P̂_k = Φᵀ M ι_k
//! ```
//!
//! with K̂ = Φᵀ K Φ … : the modes of a system (all matrices diagonal, unless the damping couples them), any other basis, or
//! the unit vectors of a small model. L̂ is hysteretic damping, 2 ξ K̂ for the ratio ξ in every mode, which only the frequency
//! domain can represent. Linear systems only.
//!
//! The discrete transform continues its input periodically. Either zeros are added until the response has died away, at least
//! 4.6/(ξ_min ω_min) seconds (to 1 %; 380 s at 0.5 % and 2.4 rad/s), or the transform is taken along σ > 0 (**exponential
//! window**): the motion times e^{−σt} decays whatever the damping, and the response is multiplied by e^{σt} again. With
//! σ T = ln 10⁶ the remainder of the previous period is 10⁻⁶ of it, and rounding grows to 10⁻¹⁰.
//!
//! Use: [`Reduced::transfer`], the steady state under harmonic motion, of the linear engines; [`Reduced::respond`], an independent solution
//! to check modal superposition and direct integration with.
//!
//! Source: Clough & Penzien 1993, chapter 6; exponential window: Kausel & Roësset 1992.

use fourier::{ComplexToReal, RealToComplex, Transforms};
use nalgebra::{Complex, DMatrix, DVector};

use super::modal::ModalBasis;
use super::motion::{Grid, Motion};
use super::observable::{Observable, apply};
use super::observer::{Extreme, History};
use super::system::System;
use super::transient::Load;
use super::{AnalysisError, check_length};
use crate::linalg::{Matrix, dot};

/// How the transform is kept from repeating itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Window {
    /// Zeros of at least this length [s] after the end of the grid.
    Zeros(f64),
    /// e^{−σt} with σ T = ln(10) × this number of digits, from 2 to 10.
    Exponential(f64),
}

impl Window {
    /// Zeros that let a mode of ratio ξ and circular frequency ω [rad/s] decay to 1 %.
    pub fn zeros_for(ratio: f64, omega: f64) -> Window {
        Window::Zeros(4.6 / (ratio * omega))
    }
}

/// A system on a basis.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// K̂.
    pub stiffness: DMatrix<f64>,
    /// L̂ of hysteretic damping.
    pub hysteretic: DMatrix<f64>,
    /// Ĉ.
    pub damping: DMatrix<f64>,
    /// M̂.
    pub mass: DMatrix<f64>,
    /// P̂_k.
    pub load: [DVector<f64>; 3],
    /// Φ, a column a basis vector.
    pub basis: Matrix,
    influence: [Vec<f64>; 3],
    residual: [Vec<f64>; 3],
    diagonal: bool,
}

impl Reduced {
    /// In modal coordinates with the ratio of every mode, viscous and hysteretic, and the dashpots of the basis; missing mass as in [`ModalBasis`].
    ///
    /// Errors: ratios of wrong number.
    pub fn modal(basis: &ModalBasis, viscous: &[f64], hysteretic: &[f64]) -> Result<Reduced, AnalysisError> {
        let m = basis.len();
        check_length("viscous ratios", viscous.len(), m)?;
        check_length("hysteretic ratios", hysteretic.len(), m)?;
        let diagonal = |f: &dyn Fn(usize) -> f64| DMatrix::from_diagonal(&DVector::from_fn(m, |j, _| f(j)));
        let w = &basis.omega;
        let mut damping = diagonal(&|j| 2.0 * viscous[j] * w[j]);
        if let Some(coupling) = &basis.coupling {
            damping += DMatrix::from_fn(m, m, |i, j| coupling.get(i, j));
        }
        Ok(Reduced {
            stiffness: diagonal(&|j| w[j] * w[j]),
            hysteretic: diagonal(&|j| 2.0 * hysteretic[j] * w[j] * w[j]),
            damping,
            mass: DMatrix::identity(m, m),
            load: [0, 1, 2].map(|k| DVector::from_fn(m, |j, _| basis.participation[j][k])),
            basis: basis.vectors.clone(),
            influence: basis.influence.clone(),
            residual: basis.residual.clone(),
            diagonal: basis.coupling.is_none(),
        })
    }

    /// On the columns of `basis`, with the damping of the system and the hysteretic ratio ξ.
    ///
    /// Errors: a basis of wrong length.
    pub fn on_basis(system: &System, basis: &Matrix, hysteretic: f64) -> Result<Reduced, AnalysisError> {
        check_length("basis", basis.rows, system.size())?;
        let m = basis.cols;
        let reduce = |times: &dyn Fn(&[f64]) -> Vec<f64>| {
            let mut out = DMatrix::zeros(m, m);
            for j in 0..m {
                let image = times(basis.column(j));
                for i in 0..m {
                    out[(i, j)] = dot(basis.column(i), &image);
                }
            }
            out
        };
        let stiffness = reduce(&|x| system.stiffness.times(x));
        Ok(Reduced {
            hysteretic: 2.0 * hysteretic * &stiffness,
            damping: reduce(&|x| system.damping.times(&system.mass, &system.stiffness, x)),
            mass: reduce(&|x| system.mass.times(x)),
            stiffness,
            load: [0, 1, 2].map(|k| DVector::from_vec(basis.transposed_times(&system.inertia[k]))),
            basis: basis.clone(),
            influence: system.influence.clone(),
            residual: Default::default(),
            diagonal: false,
        })
    }

    /// All unknowns of a small system, without reduction.
    ///
    /// Errors: none but those of [`Reduced::on_basis`].
    pub fn full(system: &System, hysteretic: f64) -> Result<Reduced, AnalysisError> {
        let n = system.size();
        let mut unit = Matrix::zeros(n, n);
        (0..n).for_each(|i| unit.add(i, i, 1.0));
        Reduced::on_basis(system, &unit, hysteretic)
    }

    /// Y(s) for the load P.
    fn solve(&self, s: Complex<f64>, load: &DVector<Complex<f64>>) -> Option<DVector<Complex<f64>>> {
        let m = load.len();
        let sign = if s.im == 0.0 { 0.0 } else { s.im.signum() };
        let entry = |i: usize, j: usize| {
            s * s * self.mass[(i, j)]
                + s * self.damping[(i, j)]
                + Complex::new(self.stiffness[(i, j)], sign * self.hysteretic[(i, j)])
        };
        if self.diagonal {
            return Some(DVector::from_fn(m, |j, _| load[j] / entry(j, j)));
        }
        DMatrix::from_fn(m, m, entry).lu().solve(load)
    }

    /// Complex amplitudes of observables per unit of ground acceleration a(t) = Re e^{iΩt} along a component, frequency by frequency:
    /// y(t) = Re H e^{iΩt}.
    ///
    /// * `axis`: component of the ground motion
    /// * `omega`: Ω [rad/s], 0 for the static response
    ///
    /// A lone mode has H = −Γ d·φ/(ω² − Ω² + 2 i ξ ω Ω) for a displacement, 1/(2 ξ) of its static response at Ω = ω.
    ///
    /// Errors: a system that is singular at a frequency, an amplitude that is not finite (an undamped resonance).
    pub fn transfer(
        &self,
        observables: &[Observable],
        axis: usize,
        omega: &[f64],
    ) -> Result<Vec<Vec<Complex<f64>>>, AnalysisError> {
        let projected: Vec<_> = observables.iter().map(|o| self.project(o)).collect();
        let right = self.load[axis].map(|p| Complex::new(-p, 0.0));
        let mut all = vec![Vec::with_capacity(omega.len()); observables.len()];
        for &omega in omega {
            let s = Complex::new(0.0, omega);
            let singular = || refuse(format!("a singular system at {omega} rad/s"), "damping, or no resonance");
            let y = self.solve(s, &right).ok_or_else(singular)?;
            for (out, p) in all.iter_mut().zip(&projected) {
                let value = amplitude(p, &y, s) + p.ground[axis];
                if !(value.re.is_finite() && value.im.is_finite()) {
                    return Err(singular());
                }
                out.push(value);
            }
        }
        Ok(all)
    }

    /// Histories of `observables` at the samples of the grid, extremes at its sub-steps.
    ///
    /// Errors: nodal forces, a window out of range, a system that is singular at a frequency.
    pub fn respond(
        &self,
        load: &Load,
        grid: Grid,
        window: Window,
        observables: &[Observable],
    ) -> Result<Vec<History>, AnalysisError> {
        if !load.forces.is_empty() {
            return Err(refuse("nodal forces".into(), "ground motion; forces by direct integration"));
        }
        let period = Period::new(grid, window)?;
        let Transforms { forward, inverse } = Transforms::new(period.length);
        let motions = load.ground.iter().enumerate().filter_map(|(k, motion)| Some((k, motion.as_ref()?)));
        let spectra: Vec<_> = motions.map(|(k, motion)| (k, period.spectrum(motion, &*forward))).collect();
        let projected: Vec<_> = observables.iter().map(|o| self.project(o)).collect();
        let mut outputs = vec![inverse.make_input_vec(); observables.len()];
        for f in 0..=period.length / 2 {
            let s = period.frequency(f);
            let mut right = DVector::from_element(self.mass.nrows(), Complex::new(0.0, 0.0));
            let mut ground = [Complex::new(0.0, 0.0); 3];
            for (k, a) in &spectra {
                ground[*k] = a[f];
                for (r, p) in right.iter_mut().zip(self.load[*k].iter()) {
                    *r -= a[f] * *p;
                }
            }
            let Some(y) = self.solve(s, &right) else {
                return Err(refuse(format!("a singular system at {} rad/s", s.im), "damping, or no resonance"));
            };
            for (out, p) in outputs.iter_mut().zip(&projected) {
                let follows: Complex<f64> = ground.iter().zip(&p.ground).map(|(a, b)| a * *b).sum();
                out[f] = follows + amplitude(p, &y, s);
            }
        }
        outputs.into_iter().map(|out| period.history(out, &*inverse)).collect()
    }

    fn project(&self, row: &Observable) -> super::modal::Projected {
        let on = |sparse: &[(usize, f64)]| -> Vec<f64> {
            (0..self.basis.cols).map(|j| apply(sparse, self.basis.column(j))).collect()
        };
        let mut ground = row.total_ground(&self.influence);
        for (g, r) in ground.iter_mut().zip(&self.residual) {
            if !r.is_empty() {
                *g -= apply(&row.displacement, r);
            }
        }
        super::modal::Projected {
            displacement: on(&row.displacement),
            velocity: on(&row.velocity),
            acceleration: on(&row.acceleration),
            ground,
        }
    }
}

/// The time of a transform: the steps of a grid, followed by zeros or decaying by e^{−σ t}.
struct Period {
    grid: Grid,
    /// Samples of the grid and of the transform.
    count: usize,
    length: usize,
    /// σ [1/s].
    sigma: f64,
}

impl Period {
    /// Errors: a window out of range.
    fn new(grid: Grid, window: Window) -> Result<Period, AnalysisError> {
        let (h, count) = (grid.h(), grid.steps() + 1);
        let (length, sigma) = match window {
            Window::Zeros(t) if t >= 0.0 && t.is_finite() => (count + (t / h).ceil() as usize, 0.0),
            Window::Exponential(digits) if (2.0..=10.0).contains(&digits) => {
                (count, digits * std::f64::consts::LN_10 / (count as f64 * h))
            }
            other => return Err(refuse(format!("{other:?}"), "zeros ≥ 0 s, or 2 to 10 digits")),
        };
        Ok(Period { grid, count, length: smooth(length), sigma })
    }

    /// s of a transform's term.
    fn frequency(&self, f: usize) -> Complex<f64> {
        // The highest frequency of an even length is real: its sine vanishes at the samples.
        Complex::new(self.sigma, std::f64::consts::TAU * f as f64 / (self.length as f64 * self.grid.h()))
    }

    fn spectrum(&self, motion: &Motion, forward: &dyn RealToComplex<f64>) -> Vec<Complex<f64>> {
        let mut a = vec![0.0; self.length];
        for (i, a) in a.iter_mut().enumerate().take(self.count) {
            // Where the record jumps (at its ends, as a rule) a sample counts with the mean of both sides.
            let before = if i > 0 { motion.interval(i - 1).1 } else { 0.0 };
            *a = 0.5 * (before + motion.interval(i).0) * (-self.sigma * self.grid.h() * i as f64).exp();
        }
        let mut transform = forward.make_output_vec();
        (forward.process(&mut a, &mut transform)).expect("buffers were made by the plan");
        transform
    }

    /// The history of a spectrum.
    ///
    /// Errors: a value that is not finite.
    fn history(
        &self,
        mut spectrum: Vec<Complex<f64>>,
        inverse: &dyn ComplexToReal<f64>,
    ) -> Result<History, AnalysisError> {
        spectrum[0].im = 0.0;
        if let Some(last) = spectrum.last_mut().filter(|_| self.length.is_multiple_of(2)) {
            last.im = 0.0;
        }
        let mut y = inverse.make_output_vec();
        (inverse.process(&mut spectrum, &mut y)).expect("imaginary parts were cleared where they must be");
        let mut history = History { values: Vec::new(), extreme: Extreme::REST };
        for (i, y) in y.iter().enumerate().take(self.count) {
            let time = self.grid.time(i);
            let value = y / self.length as f64 * (self.sigma * self.grid.h() * i as f64).exp();
            if !value.is_finite() {
                let cause = "ground motion that is not finite, or an undamped resonance";
                return Err(AnalysisError::NotFinite { time, cause });
            }
            if i.is_multiple_of(self.grid.sub_steps) {
                history.values.push(value);
            }
            history.extreme.include(value, time);
        }
        Ok(history)
    }
}

/// What an observable takes of the coordinates y.
fn amplitude(p: &super::modal::Projected, y: &DVector<Complex<f64>>, s: Complex<f64>) -> Complex<f64> {
    let of = |j: usize| y[j] * (s * s * p.acceleration[j] + s * p.velocity[j] + p.displacement[j]);
    (0..y.len()).map(of).sum()
}

fn refuse(found: String, allowed: &str) -> AnalysisError {
    AnalysisError::Option { option: "frequency domain", found, allowed: allowed.into() }
}

/// The smallest even number ≥ `n` without prime factors above 5, which transforms fast.
fn smooth(n: usize) -> usize {
    let is_smooth = |mut m: usize| {
        for p in [2, 3, 5] {
            while m.is_multiple_of(p) {
                m /= p;
            }
        }
        m == 1
    };
    (n.max(2)..).find(|&m| m.is_multiple_of(2) && is_smooth(m)).unwrap_or(n)
}

#[cfg(test)]
mod tests;
