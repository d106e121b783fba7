//! Why a measured or published value is not compared.

use results::compare::{Differs, Why};
use tank::units::{Dimension, display};

/// The reason, without a capital and a full stop.
pub fn why(reason: &Why) -> String {
    match reason {
        Why::NotNamed => "does not say under which ground motion it was measured".into(),
        Why::NoRecord => "belongs to a ground motion, and no record was given".into(),
        Why::OtherFile => "belongs to another record file (`motion.sha256` differs)".into(),
        Why::OtherMotion { differs } => {
            let all: Vec<String> = differs.iter().map(differing).collect();
            format!("belongs to another ground motion: {}", all.join(", "))
        }
    }
}

/// `peak of the record 3.413 m/s² there, 3.126 m/s² here`.
fn differing(measure: &Differs) -> String {
    let (what, dimension) = match measure.key.as_str() {
        "peak" => ("peak of the record", Dimension::Acceleration),
        "step" => ("time step of the record", Dimension::Time),
        "duration" => ("duration of the record", Dimension::Time),
        "applied_peak" => ("peak after scaling", Dimension::Acceleration),
        _ => ("time step after stretching", Dimension::Time),
    };
    let value = |v: f64| display(v, dimension);
    format!("{what} {} there, {} here", value(measure.named), value(measure.found))
}
