//! A body in its modes on isolators by Runge and Kutta's fourth order with steps of 0.25 ms: a second formulation of `soil::isolated`.
//!
//! The yielding force is a rate, k ḋ while |h| < q or while it unloads; no equation is solved.

use ::soil::isolated::Mode;
use ::soil::isolator::Isolator;

use super::GRAVITY;

/// Longest step [s].
const STEP: f64 = 2.5e-4;

/// A run along x.
pub(super) struct Other<'a> {
    /// Mass of tank, liquid and slab [kg].
    pub mass: f64,
    /// Modes on a fixed base.
    pub modes: &'a [Mode],
    /// Isolators.
    pub isolators: &'a [Isolator],
    /// Time between samples [s].
    pub step: f64,
    /// Ground acceleration at each sample [m/s²], and that upwards, empty without; linear between.
    pub ground: &'a [f64],
    pub vertical: &'a [f64],
}

/// Largest values.
pub(super) struct Peaks {
    /// Displacement [m] and force [N] of the isolators.
    pub displacement: f64,
    pub force: f64,
    /// Displacement [m] and absolute acceleration [m/s²] of each mode.
    pub modes: Vec<[f64; 2]>,
}

/// Force of the isolators without h, stiffness and strength of h, for a displacement and velocity and the share of gravity that
/// acts.
fn law(run: &Other<'_>, [d, v]: [f64; 2], gravity: f64) -> [f64; 3] {
    let weight = run.mass * GRAVITY;
    let (mut force, mut stick, mut strength) = (0.0, 0.0, 0.0);
    for isolator in run.isolators {
        match *isolator {
            Isolator::LeadRubber { strength: q, initial_stiffness, yielded_stiffness } => {
                force += yielded_stiffness * d;
                stick += initial_stiffness - yielded_stiffness;
                strength += q;
            }
            Isolator::FrictionPendulum { radius, friction, slip } => {
                force += gravity * weight / radius * d;
                stick += friction.fast * weight / slip;
                strength += friction.at(v.abs()) * gravity * weight;
            }
            Isolator::Elastomer { stiffness, damping } => {
                force += stiffness * d + 2.0 * damping * (stiffness * run.mass).sqrt() * v;
            }
            Isolator::Damper { coefficient, exponent } => {
                force += coefficient * v.abs().powf(exponent) * v.signum();
            }
        }
    }
    [force, stick, strength]
}

impl Other<'_> {
    /// Runs from rest.
    pub(super) fn peaks(&self) -> Peaks {
        let parts = (self.step / STEP).ceil() as usize;
        let h = self.step / parts as f64;
        let n = self.modes.len();
        // d, ḋ, h, then y and ẏ of each mode.
        let mut s = vec![0.0; 3 + 2 * n];
        let mut peaks = Peaks { displacement: 0.0, force: 0.0, modes: vec![[0.0; 2]; n] };
        let up = |i: usize| self.vertical.get(i).map_or(1.0, |a| 1.0 + a / GRAVITY);
        for i in 1..self.ground.len() {
            for part in 0..parts {
                let at = |x: f64| {
                    let share = (part as f64 + x) / parts as f64;
                    let between = |from: f64, to: f64| from + (to - from) * share;
                    [between(self.ground[i - 1], self.ground[i]), between(up(i - 1), up(i))]
                };
                let add = |k: &[f64], f: f64| s.iter().zip(k).map(|(s, k)| s + f * k).collect::<Vec<f64>>();
                let k1 = self.rate(&s, at(0.0));
                let k2 = self.rate(&add(&k1, 0.5 * h), at(0.5));
                let k3 = self.rate(&add(&k2, 0.5 * h), at(0.5));
                let k4 = self.rate(&add(&k3, h), at(1.0));
                for (j, s) in s.iter_mut().enumerate() {
                    *s += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
                }
                let [force, _, strength] = law(self, [s[0], s[1]], at(1.0)[1]);
                s[2] = s[2].clamp(-strength, strength);
                peaks.displacement = peaks.displacement.max(s[0].abs());
                peaks.force = peaks.force.max((force + s[2]).abs());
                for ((mode, y), peak) in self.modes.iter().zip(s[3..].chunks_exact(2)).zip(&mut peaks.modes) {
                    peak[0] = peak[0].max(y[0].abs());
                    peak[1] = peak[1].max(pull(mode, y).abs());
                }
            }
        }
        peaks
    }

    fn rate(&self, s: &[f64], [ground, gravity]: [f64; 2]) -> Vec<f64> {
        let [force, stick, strength] = law(self, [s[0], s[1]], gravity);
        let modal: f64 =
            (self.modes.iter().zip(s[3..].chunks_exact(2))).map(|(mode, y)| mode.mass * pull(mode, y)).sum();
        let rigid = self.mass - self.modes.iter().map(|mode| mode.mass).sum::<f64>();
        // Rigid mass: m_r A = Σ m (2 ξ ω ẏ + ω² y) − F.
        let a = (modal - force - s[2]) / rigid;
        let loads = s[2] * s[1] > 0.0;
        let held = if s[2].abs() >= strength && loads { 0.0 } else { stick * s[1] };
        let mut rate = vec![s[1], a - ground, held];
        for (mode, y) in self.modes.iter().zip(s[3..].chunks_exact(2)) {
            rate.extend([y[1], -pull(mode, y) - a]);
        }
        rate
    }
}

/// 2 ξ ω ẏ + ω² y.
fn pull(mode: &Mode, y: &[f64]) -> f64 {
    2.0 * mode.damping * mode.omega * y[1] + mode.omega * mode.omega * y[0]
}
