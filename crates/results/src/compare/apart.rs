//! Measured and published values that do not belong to the ground motion of the run: they are listed, not compared.

use serde::{Deserialize, Serialize};
use tank::Quantity;
use tank::case::{NamedMotion, Reported};

/// Measures of two motions count as equal within this, the accuracy of three printed digits.
const PRINTED: f64 = 0.01;

/// The ground motion of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaken {
    /// SHA-256 of the record file, if there is one.
    pub sha256: Option<String>,
    /// Peak of the record as recorded [m/s²].
    pub peak: f64,
    /// Time step of the record as recorded [s].
    pub step: f64,
    /// Duration of the record as recorded [s].
    pub duration: f64,
    /// Peak after scaling [m/s²].
    pub applied_peak: f64,
    /// Time step after stretching [s].
    pub applied_step: f64,
}

/// Why a value is not compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "why", rename_all = "snake_case")]
pub enum Why {
    /// The file does not name the ground motion of the value.
    NotNamed,
    /// There is no record.
    NoRecord,
    /// It belongs to another record file.
    OtherFile,
    /// It belongs to another motion: where the two differ.
    OtherMotion {
        /// The measures that differ.
        differs: Vec<Differs>,
    },
}

/// A measure in which two motions differ.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Differs {
    /// Key of `motion` in the tank file.
    pub key: String,
    /// Value that the file names (SI).
    pub named: f64,
    /// Value of the run (SI).
    pub found: f64,
}

/// A measured value that is not compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Apart {
    /// The value.
    pub value: Reported,
    /// Why.
    pub reason: Why,
}

/// Whether a quantity is a property of tank and liquid, the same under any ground motion.
fn is_property(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::SloshingPeriod | Quantity::ImpulsivePeriod | Quantity::ImpulsiveMass | Quantity::ConvectiveMass
    )
}

/// Why a value does not belong to the ground motion `shaken` of a run; `None` if it does, or needs none.
pub fn apart(value: &Reported, shaken: Option<&Shaken>) -> Option<Why> {
    if is_property(value.quantity) {
        return None;
    }
    let Some(named) = &value.motion else { return Some(Why::NotNamed) };
    let Some(shaken) = shaken else { return Some(Why::NoRecord) };
    if named.sha256.is_some() && named.sha256 != shaken.sha256 {
        return Some(Why::OtherFile);
    }
    let differs = differences(named, shaken);
    (!differs.is_empty()).then_some(Why::OtherMotion { differs })
}

fn differences(named: &NamedMotion, shaken: &Shaken) -> Vec<Differs> {
    let measures = [
        ("peak", named.peak, shaken.peak),
        ("step", named.step, shaken.step),
        ("duration", named.duration, shaken.duration),
        ("applied_peak", named.applied_peak, shaken.applied_peak),
        ("applied_step", named.applied_step, shaken.applied_step),
    ];
    let differs = |(key, named, found): (&str, Option<f64>, f64)| {
        let named = named?;
        // Nothing equals a named 0, which the reader rejects.
        let same = (found - named).abs() <= PRINTED * named.abs();
        (!same).then(|| Differs { key: key.into(), named, found })
    };
    measures.into_iter().filter_map(differs).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shaken() -> Shaken {
        Shaken {
            sha256: Some("ab".repeat(32)),
            peak: 3.126,
            step: 0.02,
            duration: 31.18,
            applied_peak: 4.903,
            applied_step: 0.011547,
        }
    }

    fn value(quantity: Quantity, motion: Option<NamedMotion>) -> Reported {
        Reported { quantity, value: 0.134, source: "a test".into(), note: None, motion }
    }

    /// The table of the dissertation: 0.348 g at 0.02 s, as applied 0.5 g at 0.0115 s. The record of the textbooks has 0.319 g.
    #[test]
    fn a_value_belongs_to_its_own_motion() {
        let g = 9.80665;
        let caltech = NamedMotion {
            peak: Some(0.348 * g),
            step: Some(0.02),
            applied_peak: Some(0.5 * g),
            applied_step: Some(0.0115),
            ..NamedMotion::default()
        };
        let wave = value(Quantity::SloshingHeight, Some(caltech));
        match apart(&wave, Some(&shaken())) {
            Some(Why::OtherMotion { differs }) => {
                let keys: Vec<&str> = differs.iter().map(|d| d.key.as_str()).collect();
                assert_eq!(keys, ["peak"]);
            }
            other => panic!("{other:?}"),
        }
        let own = Shaken { peak: 0.3484 * g, duration: 53.74, ..shaken() };
        assert_eq!(apart(&wave, Some(&own)), None);
        // The same record at another scale is another motion.
        let doubled = Shaken { applied_peak: 2.0 * own.applied_peak, ..own };
        assert!(matches!(apart(&wave, Some(&doubled)), Some(Why::OtherMotion { .. })));
        assert_eq!(apart(&wave, None), Some(Why::NoRecord));
    }

    #[test]
    fn a_hash_names_a_file() {
        let named = |sha256: String| {
            value(Quantity::BaseShear, Some(NamedMotion { sha256: Some(sha256), ..NamedMotion::default() }))
        };
        assert_eq!(apart(&named("ab".repeat(32)), Some(&shaken())), None);
        assert_eq!(apart(&named("cd".repeat(32)), Some(&shaken())), Some(Why::OtherFile));
    }

    /// A value without a motion is apart, but for periods and masses.
    #[test]
    fn a_property_needs_no_motion() {
        assert_eq!(apart(&value(Quantity::SloshingPeriod, None), None), None);
        assert_eq!(apart(&value(Quantity::ConvectiveMass, None), Some(&shaken())), None);
        assert_eq!(apart(&value(Quantity::HoopStress, None), Some(&shaken())), Some(Why::NotNamed));
    }
}
