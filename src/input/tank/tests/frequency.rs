//! `analysis.frequency`.

use tank::options::frequency::{FrequencyDamping, FrequencyOptions};

use super::{read, refused, small};

/// Frequencies in any form, defaults without keys, nothing without the object; an empty range and bad values are named with their path.
#[test]
fn frequency() {
    let of = |given: &str| small(&format!(r#", "analysis": {{ "frequency": {given} }}"#));
    assert_eq!(read(&small("")).fe.frequency, None);
    assert_eq!(read(&of("{}")).fe.frequency, Some(FrequencyOptions::DEFAULT));
    let tau = std::f64::consts::TAU;
    let found = read(&of(r#"{ "from": "10 s", "to": "20 Hz", "points": 1000, "damping": "hysteretic" }"#));
    let found = found.fe.frequency.expect("given");
    assert!((found.from.expect("given") - 0.1 * tau).abs() < 1e-12);
    assert!((found.to.expect("given") - 20.0 * tau).abs() < 1e-9);
    assert_eq!((found.points, found.damping), (1000, FrequencyDamping::Hysteretic));
    for (given, path, message) in [
        (r#"{ "from": "2 Hz", "to": "1 Hz" }"#, "frequency.to", "above `from`"),
        (r#"{ "from": "-2 Hz" }"#, "frequency.from", "positive"),
        (r#"{ "points": 1 }"#, "frequency.points", "from 2 to 20000"),
        (r#"{ "damping": "none" }"#, "frequency.damping", "hysteretic"),
    ] {
        let text = refused(&of(given));
        assert!(text.contains(path) && text.contains(message), "{text}");
    }
}
