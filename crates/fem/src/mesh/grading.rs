//! Places of nodes along one direction: uniform, graded, from given breaks.

use super::MeshError;

/// Checks the ends and the number of elements.
fn check(from: f64, to: f64, count: usize) -> Result<(), MeshError> {
    if count == 0 {
        return Err(MeshError::Range {
            what: "number of elements",
            found: "0".to_owned(),
            allowed: "1 or more",
        });
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
        return Err(MeshError::Range {
            what: "grading ratio",
            found: ratio.to_string(),
            allowed: "a positive number",
        });
    }
    let step = if count > 1 {
        ratio.powf(1.0 / (count - 1) as f64)
    } else {
        1.0
    };
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

/// `count` elements that shrink towards `to`: x = to − (to − from)(1 − s)^exponent at equal steps of s.
///
/// Heights of a liquid are graded to its surface with exponent 1.3. Errors: no element, ends that do not ascend, exponent
/// below 1.
pub fn towards_end(from: f64, to: f64, count: usize, exponent: f64) -> Result<Vec<f64>, MeshError> {
    check(from, to, count)?;
    if !(exponent >= 1.0 && exponent.is_finite()) {
        return Err(MeshError::Range {
            what: "grading exponent",
            found: exponent.to_string(),
            allowed: "1 or more",
        });
    }
    let place = |i: usize| to - (to - from) * (1.0 - i as f64 / count as f64).powf(exponent);
    let mut places: Vec<f64> = (0..count).map(place).collect();
    places[0] = from;
    places.push(to);
    Ok(places)
}

/// Elements no longer than `length` between breaks that must be met (course joints, the liquid's level).
///
/// Errors: fewer than two breaks, breaks that do not ascend, length not positive.
pub fn between_breaks(breaks: &[f64], length: f64) -> Result<Vec<f64>, MeshError> {
    super::check_ascending("breaks", breaks, 2)?;
    if !(length > 0.0 && length.is_finite()) {
        return Err(MeshError::Range {
            what: "length of elements",
            found: length.to_string(),
            allowed: "a positive number",
        });
    }
    let mut places = vec![breaks[0]];
    for w in breaks.windows(2) {
        // A hair of slack, so that 1.0/0.1 makes 10 elements.
        let count = ((w[1] - w[0]) / length - 1e-9).ceil().max(1.0) as usize;
        places.extend(&uniform(w[0], w[1], count)?[1..]);
    }
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
        // 1 − (1 − s)²: 0, 7/16, 3/4, 15/16, 1.
        assert_eq!(
            towards_end(0.0, 1.0, 4, 2.0).unwrap(),
            vec![0.0, 0.4375, 0.75, 0.9375, 1.0]
        );
        let broken = between_breaks(&[0.0, 1.0, 1.25], 0.1).unwrap();
        assert_eq!(broken.len(), 1 + 10 + 3);
        assert_eq!(broken[10], 1.0);
    }

    #[test]
    fn bad_input_is_refused() {
        assert!(uniform(0.0, 1.0, 0).is_err());
        assert!(uniform(1.0, 1.0, 3).is_err());
        assert!(uniform(0.0, f64::NAN, 3).is_err());
        assert!(geometric(0.0, 1.0, 3, -1.0).is_err());
        assert!(geometric(0.0, 1.0, 3, 0.0).is_err());
        assert!(towards_end(0.0, 1.0, 3, 0.5).is_err());
        assert!(between_breaks(&[0.0], 0.1).is_err());
        assert!(between_breaks(&[0.0, -1.0], 0.1).is_err());
        assert!(between_breaks(&[0.0, 1.0], 0.0).is_err());
    }
}
