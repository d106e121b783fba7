//! Intensity measures of a record, on which scales and fragility curves stand.
//!
//! ```text
//! PGA = max |a|        PGV = max |v|        PGD = max |d|          of the record from rest, without baseline correction
//! S_a(T, ξ) = ω² max |u|                                            pseudo-acceleration of an oscillator
//! S_a,avg(T) = (Π S_a(T_k, ξ))^(1/N)      T_k evenly spaced from 0.2 T to 3 T, N = 10      (Eads, Miranda & Lignos 2015)
//! ```
//!
//! All are proportional to the accelerations.

use crate::record::Record;
use crate::spectrum::{self, Method};

/// Periods of an average spectral acceleration.
const AVERAGED: usize = 10;

/// An intensity measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intensity {
    /// Peak ground acceleration [m/s²].
    Pga,
    /// Peak ground velocity [m/s].
    Pgv,
    /// Peak ground displacement [m].
    Pgd,
    /// Spectral pseudo-acceleration [m/s²].
    Sa {
        /// Period [s].
        period: f64,
        /// Damping ratio.
        damping: f64,
    },
    /// Geometric mean of the spectral pseudo-acceleration from 0.2 T to 3 T [m/s²].
    AverageSa {
        /// Period T [s].
        period: f64,
        /// Damping ratio.
        damping: f64,
    },
}

impl Intensity {
    /// Its value for a record.
    pub fn of(self, record: &Record) -> f64 {
        match self {
            Intensity::Pga => record.pga(),
            Intensity::Pgv => record.measures().pgv,
            Intensity::Pgd => record.measures().pgd,
            Intensity::Sa { period, damping } => spectrum::ordinates(record, period, damping).psa,
            Intensity::AverageSa { period, damping } => {
                let at = |k: usize| period * (0.2 + 2.8 * k as f64 / (AVERAGED - 1) as f64);
                let periods: Vec<f64> = (0..AVERAGED).map(at).collect();
                let found = spectrum::spectrum(record, &periods, &[damping], Method::Exact);
                let logs: f64 = found.ordinates[0].iter().map(|o| o.psa.ln()).sum();
                (logs / AVERAGED as f64).exp()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// a = sin 2πt over ten whole periods: PGA 1, PGV 1/π (the motion starts from rest: v = (1 − cos)/(2π)); a stiff oscillator follows
    /// the ground. The samples cut 1e-4 of a peak.
    #[test]
    fn a_harmonic_record() {
        let record = Record {
            name: "harmonic".into(),
            dt: 0.005,
            acceleration: (0..=2000).map(|k| (2.0 * PI * 0.005 * f64::from(k)).sin()).collect(),
            processing: Vec::new(),
        };
        assert!((Intensity::Pga.of(&record) - 1.0).abs() < 1e-9);
        assert!((Intensity::Pgv.of(&record) * PI - 1.0).abs() < 1e-4);
        // d = t/(2π) − sin(2πt)/(4π²), at the end of ten seconds.
        assert!((Intensity::Pgd.of(&record) * PI / 5.0 - 1.0).abs() < 1e-4);
        let stiff = Intensity::Sa { period: 0.01, damping: 0.05 };
        assert!((stiff.of(&record) - 1.0).abs() < 1e-3);
        // Every measure is proportional to the record.
        let twice = Record { acceleration: record.acceleration.iter().map(|a| 2.0 * a).collect(), ..record.clone() };
        let (period, damping) = (0.7, 0.05);
        for measure in [
            Intensity::Pga,
            Intensity::Pgv,
            Intensity::Pgd,
            Intensity::Sa { period, damping },
            Intensity::AverageSa { period, damping },
        ] {
            assert!((measure.of(&twice) / measure.of(&record) - 2.0).abs() < 1e-12);
        }
    }

    /// After an impulse v an oscillator swings freely: u = v/ω exp(−ξφ/√(1 − ξ²)) with cos φ = ξ at its first peak, so that S_a is
    /// proportional to 1/T. The pulse of 2 ms cuts (ωΔt)²/24 = 3e-4 of it at 0.15 s.
    #[test]
    fn an_impulse() {
        let (dt, period) = (0.002, 0.75);
        let mut acceleration = vec![0.0; 1500];
        acceleration[1] = 1.0;
        let record = Record { name: "impulse".into(), dt, acceleration, processing: Vec::new() };
        for damping in [0.01, 0.05] {
            let decay = f64::exp(-damping * f64::acos(damping) / (1.0 - damping * damping).sqrt());
            let exact = |period: f64| 2.0 * PI / period * dt * decay;
            let single = Intensity::Sa { period, damping }.of(&record);
            assert!((single / exact(period) - 1.0).abs() < 1e-3, "{single}");
            // (Π 1/T_k)^(1/10) with T_k/T = (1.8 + 2.8 k)/9, k = 0 to 9: 0.2, 0.511, …, 3.
            let shares = [1.8, 4.6, 7.4, 10.2, 13.0, 15.8, 18.6, 21.4, 24.2, 27.0].map(|ninths: f64| ninths / 9.0);
            let mean = shares.iter().product::<f64>().powf(0.1);
            let average = Intensity::AverageSa { period, damping }.of(&record);
            assert!((average / exact(period * mean) - 1.0).abs() < 1e-3, "{average}");
        }
    }
}
