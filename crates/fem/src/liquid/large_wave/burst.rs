//! Crest and trough of a burst of sines over the wave of linear theory.

use std::f64::consts::TAU;

use super::expansion::{Liquid, Properties};
use super::motion::Motion;
use super::run::{Stop, run};
use super::{Basis, Shape};

/// Sine acceleration of whole cycles along x, followed by two periods at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Burst {
    /// Number of cycles.
    pub cycles: f64,
    /// Frequency over that of the first mode.
    pub tuning: f64,
}

/// Three cycles in resonance: the number of cycles hardly matters at a given linear wave.
pub const RESONANCE: Burst = Burst { cycles: 3.0, tuning: 1.0 };

impl Burst {
    /// Largest crest and deepest trough at the wall over the largest linear wave, where that is `rise` [m].
    ///
    /// * `own`: the liquid; its order is that of the nonlinear run
    ///
    /// Errors: where the nonlinear march stopped.
    pub fn ratios(self, basis: &Basis, own: Properties, rise: f64) -> Result<[f64; 2], Stop> {
        let linear = Liquid::new(basis.clone(), Properties { order: 1, ..own });
        let unit = self.extremes(&linear, 1.0)?;
        let unit = unit[0].max(unit[1]);
        let large = Liquid::new(basis.clone(), own);
        Ok(self.extremes(&large, rise / unit)?.map(|value| value / rise))
    }

    /// Crest and trough [m] for an amplitude of the acceleration [m/s²].
    fn extremes(self, liquid: &Liquid, amplitude: f64) -> Result<[f64; 2], Stop> {
        let first = liquid.basis().modes().iter().position(|m| m.harmonic == 1).unwrap_or(1);
        let omega = self.tuning * liquid.omega()[first];
        let end = self.cycles * TAU / omega;
        let drive = move |time: f64| Motion::along_x(if time < end { amplitude * (omega * time).sin() } else { 0.0 });
        let half = match liquid.basis().shape() {
            Shape::Cylinder { radius } => radius,
            Shape::Strip { length, .. } => 0.5 * length,
        };
        let run = run(liquid, &drive, end + 2.0 * TAU / omega, None, |motion| motion);
        if let Some(stop) = run.stop {
            return Err(stop);
        }
        let sides = [half, -half].map(|x| run.extremes(liquid, [x, 0.0]));
        Ok([sides[0][0].1.max(sides[1][0].1), -sides[0][1].1.min(sides[1][1].1)])
    }

    /// The factor c of crest = η (1 + c η/R) where the crest is higher than the linear wave η by the share `higher`.
    ///
    /// R is the radius, or half the length.
    ///
    /// Errors: where a march stopped.
    pub fn factor(self, basis: &Basis, own: Properties, higher: f64) -> Result<f64, Stop> {
        let half = match basis.shape() {
            Shape::Cylinder { radius } => radius,
            Shape::Strip { length, .. } => 0.5 * length,
        };
        let mut share = 0.02;
        for _ in 0..6 {
            let excess = self.ratios(basis, own, share * half)?[0] - 1.0;
            share *= (higher / excess).clamp(0.2, 5.0);
        }
        Ok(higher / share)
    }
}
