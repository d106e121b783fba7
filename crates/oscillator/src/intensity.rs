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
        let stiff = Intensity::Sa {
            period: 0.01,
            damping: 0.05,
        };
        assert!((stiff.of(&record) - 1.0).abs() < 1e-3);
        // Every measure is proportional to the record.
        let twice = Record {
            acceleration: record.acceleration.iter().map(|a| 2.0 * a).collect(),
            ..record.clone()
        };
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
}
