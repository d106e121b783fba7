//! Places of nodes along one direction: uniform, graded, from given breaks.

use super::MeshError;

/// Checks the ends and the number of elements.
fn check(from: f64, to: f64, count: usize) -> Result<(), MeshError> {
    if count == 0 {
        return Err(MeshError::Range { what: "number of elements", found: "0".to_owned(), allowed: "1 or more" });
    }
    if !(from.is_finite() && to.is_finite() && to > from) {
        return Err(MeshError::Range {
            what: "end of the interval",
            found: format!("{to} after {from}"),
            allowed: "finite, beyond the beginning",
        });
    }
    Ok(())
}

/// `count` equal elements from `from` to `to`.
///
/// Errors: no element, ends that do not ascend.
pub fn uniform(from: f64, to: f64, count: usize) -> Result<Vec<f64>, MeshError> {
    geometric(from, to, count, 1.0)
}

/// `count` elements whose lengths are a geometric series; `ratio` = length of the last over length of the first.
///
/// Errors: no element, ends that do not ascend, ratio not positive.
pub fn geometric(from: f64, to: f64, count: usize, ratio: f64) -> Result<Vec<f64>, MeshError> {
    check(from, to, count)?;
    if !(ratio > 0.0 && ratio.is_finite()) {
        return Err(MeshError::Range { what: "grading ratio", found: ratio.to_string(), allowed: "a positive number" });
    }
    let step = if count > 1 { ratio.powf(1.0 / (count - 1) as f64) } else { 1.0 };
    let lengths: Vec<f64> = (0..count).map(|i| step.powi(i as i32)).collect();
    let sum: f64 = lengths.iter().sum();
    let mut places = Vec::with_capacity(count + 1);
    let mut run = 0.0;
    for length in &lengths {
        places.push(from + (to - from) * run / sum);
        run += length;
    }
    // The end is met exactly, whatever rounding did.
    places.push(to);
    Ok(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths() {
        assert_eq!(uniform(-1.0, 1.0, 4).unwrap(), vec![-1.0, -0.5, 0.0, 0.5, 1.0]);
        let graded = geometric(0.0, 5.0, 19, 1.0 / 6.0).unwrap();
        assert_eq!((graded[0], graded[19], graded.len()), (0.0, 5.0, 20));
        let (first, last) = (graded[1], 5.0 - graded[18]);
        assert!((first / last - 6.0).abs() < 1e-12);
        for w in graded.windows(3) {
            let step = (w[2] - w[1]) / (w[1] - w[0]);
            assert!((step - 6.0_f64.powf(-1.0 / 18.0)).abs() < 1e-12);
        }
        assert_eq!(geometric(2.0, 3.0, 1, 7.0).unwrap(), vec![2.0, 3.0]);
    }

    #[test]
    fn bad_input_is_rejected() {
        assert!(uniform(0.0, 1.0, 0).is_err());
        assert!(uniform(1.0, 1.0, 3).is_err());
        assert!(uniform(0.0, f64::NAN, 3).is_err());
        assert!(geometric(0.0, 1.0, 3, -1.0).is_err());
        assert!(geometric(0.0, 1.0, 3, 0.0).is_err());
    }
}
