//! Fields on equally spaced meridians and their circumferential harmonics.
//!
//! ```text
//! even components (u_r, u_z, the turn of the meridian)      family 0: cos mθ      family 1: sin mθ
//! odd components  (u_θ, the turn of the parallel)           family 0: sin mθ      family 1: −cos mθ
//! F_kc = √(2/N) cos mθ_k, √(2/N) sin mθ_k                    √(1/N) for m = 0 and m = N/2
//! ```
//!
//! so that an operator that every turn by 2π/N and the reflection θ → −θ leave as they are has one real block for each m, the
//! same for both families. The half 0 ≤ θ ≤ π stands for fields that the reflection leaves as they are, continued to
//! the full circle by T; it has family 0 alone. With D = 1 on the two end meridians and 2 on all others
//!
//! ```text
//! ½ Tᵀ (F B Fᵀ) T = G B Gᵀ            G = D F/√2        [`Weight::Forces`]
//! (½ Tᵀ (F B Fᵀ) T)⁻¹ = H B⁻¹ Hᵀ      H = √2 F          [`Weight::Displacements`]
//! ```
//!
//! F is applied as a fast Fourier transform of the full circle.

use fourier::{Complex64, Transforms};

mod operator;

pub use operator::{RingAmplitude, RingBlock, RingOperator};

/// Whether harmonics are taken as G or as H.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// G: of a matrix, onto forces.
    Forces,
    /// H: of an inverse, onto displacements.
    Displacements,
}

/// Equally spaced meridians, on the full circle or from 0 to π.
#[derive(Clone)]
pub struct Ring {
    sectors: usize,
    half: bool,
    plan: Transforms,
}

/// Rings of nodes about the z axis: on the meridians of `ring`, with frames e_r, e_θ, e_z and rotation frames e_θ, e_z, e_r.
#[derive(Clone, Debug)]
pub struct NodeRings {
    /// The meridians.
    pub ring: Ring,
    /// Nodes of each ring, by meridian.
    pub nodes: Vec<Vec<usize>>,
}

/// Working space of the transforms of one thread.
pub struct Room {
    real: Vec<f64>,
    waves: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl std::fmt::Debug for Ring {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Ring").field("sectors", &self.sectors).field("half", &self.half).finish()
    }
}

impl Ring {
    /// `sectors` meridians on the full circle, or the half of them; `None` if half of an odd number, or fewer than 3.
    pub fn new(sectors: usize, half: bool) -> Option<Ring> {
        if sectors < 3 || (half && !sectors.is_multiple_of(2)) {
            return None;
        }
        let plan = Transforms::new(sectors);
        Some(Ring { sectors, half, plan })
    }

    /// Sectors of the full circle.
    pub fn sectors(&self) -> usize {
        self.sectors
    }

    /// Whether only 0 ≤ θ ≤ π is there.
    pub fn is_half(&self) -> bool {
        self.half
    }

    /// Meridians that are there.
    pub fn meridians(&self) -> usize {
        if self.half { self.sectors / 2 + 1 } else { self.sectors }
    }

    /// Number of harmonics m.
    pub fn harmonics(&self) -> usize {
        self.sectors / 2 + 1
    }

    /// Number of families.
    pub fn families(&self) -> usize {
        if self.half { 1 } else { 2 }
    }

    /// Norm of the column m of F.
    pub fn scale(&self, m: usize) -> f64 {
        let single = m == 0 || 2 * m == self.sectors;
        (if single { 1.0 } else { 2.0 } / self.sectors as f64).sqrt()
    }

    /// Working space.
    pub fn room(&self) -> Room {
        let scratch = self.plan.forward.get_scratch_len().max(self.plan.inverse.get_scratch_len());
        Room {
            real: vec![0.0; self.sectors],
            waves: vec![Complex64::default(); self.harmonics()],
            scratch: vec![Complex64::default(); scratch],
        }
    }

    /// Gᵀ x or Hᵀ x of one field: `put(m, family, coefficient)` receives every harmonic.
    pub fn analyse(
        &self,
        x: &[f64],
        odd: bool,
        weight: Weight,
        room: &mut Room,
        mut put: impl FnMut(usize, usize, f64),
    ) {
        let n = self.sectors;
        let mut norm = 1.0;
        if self.half {
            let last = n / 2;
            let ends = if weight == Weight::Displacements { 2.0 } else { 1.0 };
            norm = 0.5_f64.sqrt();
            let mirrored = if odd { -1.0 } else { 1.0 };
            for k in 1..last {
                room.real[k] = x[k];
                room.real[n - k] = mirrored * x[k];
            }
            room.real[0] = if odd { 0.0 } else { ends * x[0] };
            room.real[last] = if odd { 0.0 } else { ends * x[last] };
        } else {
            room.real.copy_from_slice(x);
        }
        // Lengths are those of the plan.
        let done = self.plan.forward.process_with_scratch(&mut room.real, &mut room.waves, &mut room.scratch);
        debug_assert!(done.is_ok());
        for (m, wave) in room.waves.iter().enumerate() {
            let scale = norm * self.scale(m);
            let (cosine, sine) = (scale * wave.re, -scale * wave.im);
            let [first, second] = if odd { [sine, -cosine] } else { [cosine, sine] };
            put(m, 0, first);
            if !self.half {
                put(m, 1, second);
            }
        }
    }

    /// G x̂ or H x̂ of one field into `out`; `get(m, family)` returns the coefficients.
    pub fn synthesise(
        &self,
        odd: bool,
        weight: Weight,
        room: &mut Room,
        get: impl Fn(usize, usize) -> f64,
        out: &mut [f64],
    ) {
        let n = self.sectors;
        for m in 0..self.harmonics() {
            let single = m == 0 || 2 * m == n;
            let (first, second) = (get(m, 0), if self.half { 0.0 } else { get(m, 1) });
            let (cosine, sine) = if odd { (-second, first) } else { (first, second) };
            let part = if single { 1.0 } else { 0.5 } * self.scale(m);
            room.waves[m] = Complex64::new(part * cosine, if single { 0.0 } else { -part * sine });
        }
        let done = self.plan.inverse.process_with_scratch(&mut room.waves, &mut room.real, &mut room.scratch);
        debug_assert!(done.is_ok());
        if self.half {
            let last = n / 2;
            let root = 2.0_f64.sqrt();
            let ends = if weight == Weight::Displacements { root } else { 0.5 * root };
            for k in 0..=last {
                out[k] = if k == 0 || k == last { ends } else { root } * room.real[k];
            }
        } else {
            out.copy_from_slice(&room.real);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// F as its definition has it, on the full circle, odd and even components.
    #[test]
    fn harmonics_by_definition() {
        for sectors in [9, 12] {
            let ring = Ring::new(sectors, false).unwrap();
            let mut room = ring.room();
            let x: Vec<f64> = (0..sectors).map(|k| ((k * 7 % 5) as f64).sin() + 0.3).collect();
            for odd in [false, true] {
                let mut found = vec![[0.0; 2]; ring.harmonics()];
                ring.analyse(&x, odd, Weight::Forces, &mut room, |m, f, c| found[m][f] = c);
                for (m, pair) in found.iter().enumerate() {
                    let sum = |of: fn(f64) -> f64| -> f64 {
                        let term = |(k, x): (usize, &f64)| x * of(TAU * ((m * k) % sectors) as f64 / sectors as f64);
                        ring.scale(m) * x.iter().enumerate().map(term).sum::<f64>()
                    };
                    let (c, s) = (sum(f64::cos), sum(f64::sin));
                    let expected = if odd { [s, -c] } else { [c, s] };
                    assert!((pair[0] - expected[0]).abs() < 1e-13 && (pair[1] - expected[1]).abs() < 1e-13);
                }
                let mut back = vec![0.0; sectors];
                ring.synthesise(odd, Weight::Forces, &mut room, |m, f| found[m][f], &mut back);
                for (a, b) in back.iter().zip(&x) {
                    assert!((a - b).abs() < 1e-13, "F is orthogonal");
                }
            }
        }
    }

    /// On the half, G and H are inverse to each other: H Gᵀ = 1 on even components and, off the plane, on odd ones.
    #[test]
    fn halves_are_inverse() {
        let ring = Ring::new(10, true).unwrap();
        let mut room = ring.room();
        for odd in [false, true] {
            let mut x: Vec<f64> = (0..ring.meridians()).map(|k| (1.3 * k as f64).cos() + 0.2).collect();
            if odd {
                (x[0], x[5]) = (0.0, 0.0);
            }
            for [to, from] in [[Weight::Forces, Weight::Displacements], [Weight::Displacements, Weight::Forces]] {
                let mut found = vec![0.0; ring.harmonics()];
                ring.analyse(&x, odd, to, &mut room, |m, _, c| found[m] = c);
                let mut back = vec![0.0; x.len()];
                ring.synthesise(odd, from, &mut room, |m, _| found[m], &mut back);
                for (a, b) in back.iter().zip(&x) {
                    assert!((a - b).abs() < 1e-13, "{a} {b}");
                }
            }
        }
    }

    #[test]
    fn odd_halves_are_rejected() {
        assert!(Ring::new(9, true).is_none() && Ring::new(2, false).is_none());
    }
}
