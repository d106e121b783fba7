//! Processings of accelerograms that differ by tens of per cent at long periods and go by one name.
//!
//! A processing is told by step, number of samples, peak, its instant and Arias intensity, which copies in other units and with fewer digits keep; a hash of
//! a file would not.

use crate::record::Record;

/// A processing of an accelerogram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Earthquake, station, component and processing.
    pub name: &'static str,
    /// Time step [s].
    pub dt: f64,
    /// Number of samples.
    pub samples: usize,
    /// Largest |a| [m/s²].
    pub peak: f64,
    /// Its sample.
    pub at: usize,
    /// Arias intensity [m/s].
    pub arias: f64,
}

/// El Centro 1940, Caltech, volume 2, which tests and papers of the seventies and eighties used.
pub const EL_CENTRO: Known =
    of("Imperial Valley 1940, El Centro, S00E, Caltech volume 2 (IIA001)", (0.02, 2688), (3.417, 106), 1.7356);
/// Parkfield 1966, Cholame-Shandon 5.
pub const PARKFIELD: Known =
    of("Parkfield 1966, Cholame-Shandon 5, N85E, Caltech volume 2 (IIB034)", (0.02, 2198), (4.257, 375), 0.8186);
/// San Fernando 1971, Pacoima Dam.
pub const PACOIMA: Known =
    of("San Fernando 1971, Pacoima Dam, 164, NGA-West2 (RSN77)", (0.01, 4172), (11.9547, 775), 8.6906);
/// El Centro 1940, NGA-West2.
pub const EL_CENTRO_NGA: Known =
    of("Imperial Valley 1940, El Centro, 180, NGA-West2 (RSN6)", (0.01, 5372), (2.7537, 218), 1.5419);

/// All of them.
pub const KNOWN: [Known; 7] = [
    EL_CENTRO,
    of("Imperial Valley 1940, El Centro, NS, Peknold, as textbooks print it", (0.02, 1560), (3.1266, 102), 1.7236),
    of("Imperial Valley 1940, El Centro, 180, PEER 1999", (0.01, 4000), (3.0683, 215), 1.6787),
    EL_CENTRO_NGA,
    PARKFIELD,
    of("Parkfield 1966, Cholame-Shandon 5, 085, NGA-West2 (RSN30)", (0.01, 4402), (4.3522, 753), 0.8536),
    PACOIMA,
];

/// Copies with three digits differ by a thousandth in peak and intensity; the closest processings of one record by two hundredths.
const APART: f64 = 3e-3;

const fn of(name: &'static str, (dt, samples): (f64, usize), (peak, at): (f64, usize), arias: f64) -> Known {
    Known { name, dt, samples, peak, at, arias }
}

impl Known {
    /// Whether a record is a copy of this processing, with either sign.
    pub fn is(&self, record: &Record) -> bool {
        let near = |found: f64, own: f64| (found / own - 1.0).abs() < APART;
        let at = record.acceleration.get(self.at).copied().unwrap_or_default();
        record.acceleration.len() == self.samples
            && near(record.dt, self.dt)
            && near(record.pga(), self.peak)
            && near(at.abs(), self.peak)
            && near(record.measures().arias, self.arias)
    }
}

/// The processing that a record is a copy of.
pub fn known(record: &Record) -> Option<&'static Known> {
    KNOWN.iter().find(|known| known.is(record))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A record with all numbers of a processing is a copy; one that is scaled, shifted, shorter or at another step is not.
    #[test]
    fn a_copy_has_all_of_a_processing() {
        let of = |flat: f64, at: usize| {
            let mut acceleration = vec![flat; EL_CENTRO.samples];
            acceleration[at] = -EL_CENTRO.peak;
            Record { name: String::new(), dt: EL_CENTRO.dt, acceleration, processing: Vec::new() }
        };
        // By bisection: the level beside the peak that has the intensity.
        let (mut low, mut high) = (0.0, 2.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *if of(middle, EL_CENTRO.at).measures().arias < EL_CENTRO.arias { &mut low } else { &mut high } = middle;
        }
        let copy = of(low, EL_CENTRO.at);
        assert_eq!(known(&copy), Some(&EL_CENTRO));
        let scaled = copy.acceleration.iter().map(|a| 1.01 * a).collect();
        let shorter = copy.acceleration[..2687].to_vec();
        for other in [
            Record { acceleration: scaled, ..copy.clone() },
            Record { acceleration: shorter, ..copy.clone() },
            Record { dt: 0.01, ..copy.clone() },
            of(low, EL_CENTRO.at + 1),
            of(1.02 * low, EL_CENTRO.at),
        ] {
            assert_eq!(known(&other), None);
        }
    }

    #[test]
    fn no_two_are_one() {
        for (i, a) in KNOWN.iter().enumerate() {
            assert!(KNOWN[..i].iter().all(|b| a.samples != b.samples), "{a:?}");
        }
    }
}
