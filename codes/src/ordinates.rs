//! Pseudo-accelerations of a record, which procedures take in place of a design spectrum.
//!
//! An oscillator is linear: under a record times a factor its response is that under the record, times the factor. Where procedures assess a tank
//! under one motion times several factors, [`Shared`] integrates each oscillator once.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use oscillator::record::Record;
use oscillator::spectrum::{Method, ordinates, spectrum};
use tank::case::GroundMotion;

/// Impulsive range of periods [s] over which [`plateau`] looks for the largest ordinate.
pub(crate) const IMPULSIVE_RANGE: (f64, f64) = (0.05, 0.5);

/// Pseudo-acceleration of an oscillator under a record [m/s²].
///
/// * `period`: [s]
/// * `damping`: ratio
pub(crate) fn psa(record: &Record, period: f64, damping: f64) -> f64 {
    let of = |record: &Record| (period, ordinates(record, period, damping).psa);
    shared(record, [period, damping], of).1
}

/// Largest spectral acceleration of a record in the impulsive range: (period [s], pseudo-acceleration [m/s²]).
///
/// API 650 wants the plateau of the spectrum for the impulsive part, whatever the tank's period. Here it is the
/// largest of the peak ground acceleration (T = 0) and of S_a at 41 periods in equal ratios from 0.05 to 0.5 s, which
/// covers the impulsive periods of steel tanks; neighbouring periods are 6 % apart.
pub(crate) fn plateau(record: &Record, damping: f64) -> (f64, f64) {
    shared(record, [PLATEAU, damping], |record| {
        let (first, last) = IMPULSIVE_RANGE;
        let periods: Vec<f64> = (0..=40).map(|i| first * (last / first).powf(f64::from(i) / 40.0)).collect();
        let row = &spectrum(record, &periods, &[damping], Method::Exact).ordinates[0];
        let peak = (0.0, record.pga());
        periods.iter().zip(row).fold(peak, |best, (&period, o)| if o.psa > best.1 { (period, o.psa) } else { best })
    })
}

/// In place of a period: the largest of the impulsive range.
const PLATEAU: f64 = -1.0;

/// Component, period and damping → period and ordinate under the motion itself.
type Known = HashMap<(bool, [u64; 2]), (f64, f64)>;

/// The ordinates of a motion, each found once for all factors on it.
pub struct Shared {
    motion: Rc<GroundMotion>,
    known: Rc<RefCell<Known>>,
}

/// A motion that procedures take now, and what it is a multiple of.
struct Now {
    /// Addresses of its records along x and upwards.
    records: [Option<usize>; 2],
    factor: f64,
    motion: Rc<GroundMotion>,
    known: Rc<RefCell<Known>>,
}

thread_local! {
    /// What this thread computes within [`Shared::during`].
    static NOW: RefCell<Option<Now>> = const { RefCell::new(None) };
}

fn address(record: &Record) -> usize {
    std::ptr::from_ref(record).addr()
}

impl Shared {
    /// Those of a motion.
    pub fn new(motion: GroundMotion) -> Shared {
        Shared { motion: Rc::new(motion), known: Rc::default() }
    }

    /// Runs procedures on this thread; ordinates of the records of `scaled` are those of this motion times the factor.
    ///
    /// * `scaled`: the motion of this value times the factor, as in the case of the procedures: other records are integrated
    pub fn during<T>(&self, scaled: &GroundMotion, factor: f64, compute: impl FnOnce() -> T) -> T {
        let now = Now {
            records: [Some(address(&scaled.horizontal)), scaled.vertical.as_ref().map(address)],
            factor,
            motion: Rc::clone(&self.motion),
            known: Rc::clone(&self.known),
        };
        let before = NOW.with_borrow_mut(|place| place.replace(now));
        let found = compute();
        NOW.with_borrow_mut(|place| *place = before);
        found
    }
}

/// What is found of a record, or of the record that it is a multiple of: a period, and an ordinate in proportion to the record.
fn shared(record: &Record, key: [f64; 2], find: impl FnOnce(&Record) -> (f64, f64)) -> (f64, f64) {
    let unit = NOW.with_borrow(|now| {
        let now = now.as_ref()?;
        let place = now.records.iter().position(|at| *at == Some(address(record)))?;
        Some((place > 0, now.factor, Rc::clone(&now.motion), Rc::clone(&now.known)))
    });
    let Some((vertical, factor, motion, known)) = unit else { return find(record) };
    let key = (vertical, key.map(f64::to_bits));
    let remembered = known.borrow().get(&key).copied();
    let (period, ordinate) = remembered.unwrap_or_else(|| {
        let unit = match &motion.vertical {
            Some(up) if vertical => up,
            _ => &motion.horizontal,
        };
        let found = find(unit);
        known.borrow_mut().insert(key, found);
        found
    });
    (period, factor * ordinate)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(factor: f64, shift: i32) -> Record {
        let at = |k: i32| factor * ((0.31 * f64::from(k + shift)).sin() + 0.7 * (0.07 * f64::from(k)).cos());
        Record { name: "two tones".into(), dt: 0.01, acceleration: (0..800).map(at).collect(), processing: Vec::new() }
    }

    fn motion(factor: f64) -> GroundMotion {
        GroundMotion { horizontal: record(factor, 0), transverse: None, vertical: Some(record(0.6 * factor, 5)) }
    }

    /// A harmonic motion of 0.2 s: the plateau is its resonance, 1/(2ξ) in the steady state.
    #[test]
    fn plateau_of_a_harmonic_motion() {
        let record = Record {
            name: "sine".into(),
            dt: 0.002,
            acceleration: (0..15_000).map(|i| (f64::from(i) * 0.002 * std::f64::consts::TAU / 0.2).sin()).collect(),
            processing: vec![],
        };
        let (period, psa) = plateau(&record, 0.02);
        // 41 periods meet 0.2 s within 3 %, where the amplification is between 13 and 25.
        assert!((period / 0.2 - 1.0).abs() < 0.03, "{period}");
        assert!(psa > 12.0 && psa < 25.2, "{psa}");
        let still = Record { acceleration: vec![0.0, 0.3, 0.0], dt: 10.0, ..record };
        assert!(plateau(&still, 0.02).1 >= 0.3);
    }

    /// Both components at several factors have what integrating the scaled record gives, to rounding (1e-12 of an integral over 800 steps).
    #[test]
    fn a_multiple_of_a_record_has_the_multiple_of_its_spectrum() {
        let shared = Shared::new(motion(1.0));
        for factor in [0.3, 1.0, 4.7] {
            let scaled = motion(factor);
            for one in [&scaled.horizontal, scaled.vertical.as_ref().unwrap()] {
                let all = || [psa(one, 0.4, 0.02), psa(one, 6.0, 0.005), plateau(one, 0.05).1];
                let periods = (plateau(one, 0.05).0, shared.during(&scaled, factor, || plateau(one, 0.05).0));
                assert_eq!(periods.0.to_bits(), periods.1.to_bits());
                for (found, wanted) in shared.during(&scaled, factor, all).into_iter().zip(all()) {
                    assert!((found / wanted - 1.0).abs() < 1e-12, "{found} {wanted}");
                }
            }
        }
        // Each oscillator of each component once.
        assert_eq!(shared.known.borrow().len(), 6);
    }

    /// A record that is not one of the motion is integrated.
    #[test]
    fn another_record_is_not_taken_for_the_motion() {
        let shared = Shared::new(motion(1.0));
        let (scaled, other) = (motion(2.0), record(1.0, 9));
        let wanted = psa(&other, 0.4, 0.02);
        assert_eq!(shared.during(&scaled, 2.0, || psa(&other, 0.4, 0.02)).to_bits(), wanted.to_bits());
        assert!(shared.known.borrow().is_empty());
    }
}
