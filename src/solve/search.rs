//! The search for the last value of a variable at which a verdict still holds: sampling, then bisection.
//!
//! The samples show whether the answer changes once; only then does bisection find the change. A change between two
//! neighbouring samples and back is not seen.

/// Relative distance of the value from the change: bisection ends at nine tenths of it, rounding uses the rest.
pub const TOLERANCE: f64 = 1e-4;
/// Share of the tolerance for bisection.
const BISECTION: f64 = 0.9 * TOLERANCE;
/// Digits of the value; their relative step is at most a tenth of the tolerance.
const DIGITS: i32 = 6;

/// Answer at one value.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer<T> {
    /// No check fails.
    Holds(T),
    /// A check fails.
    Fails(T),
    /// There is no verdict at this value, for this reason.
    Outside(String),
}

/// End of the search.
#[derive(Clone, Debug, PartialEq)]
pub enum Found<T> {
    /// The last value that holds, with its answer, and the answer just beyond it.
    Edge {
        /// Value, rounded to the side that holds.
        value: f64,
        /// Answer there.
        at: T,
        /// Answer beyond: [`Answer::Fails`] or [`Answer::Outside`].
        beyond: Answer<T>,
    },
    /// All samples hold; the value is the last of them.
    Everywhere {
        /// Value.
        value: f64,
        /// Answer there.
        at: T,
    },
    /// No sample holds; the first one that has an answer.
    Nowhere {
        /// Value.
        value: f64,
        /// Answer there.
        at: T,
    },
    /// The answer changes more than once: each sample and whether it holds.
    Several(Vec<(f64, bool)>),
    /// No sample has an answer, for this reason.
    Unanswered(String),
}

/// End of the search and its cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Search<T> {
    /// End.
    pub found: Found<T>,
    /// Number of evaluations.
    pub evaluations: usize,
}

/// Searches the last value that holds.
///
/// * `samples`: at least two values, strictly monotone, from the favourable to the unfavourable end
/// * `answer`: the answer at a value
///
/// Samples without an answer at the favourable end are left out; elsewhere they do not hold.
pub fn search<T>(samples: &[f64], mut answer: impl FnMut(f64) -> Answer<T>) -> Search<T> {
    let mut answers: Vec<(f64, Answer<T>)> = samples.iter().map(|&value| (value, answer(value))).collect();
    let mut evaluations = answers.len();
    let first = answers.iter().position(|(_, a)| !matches!(a, Answer::Outside(_)));
    let Some(first) = first else {
        let reason = answers.into_iter().find_map(|(_, a)| match a {
            Answer::Outside(reason) => Some(reason),
            _ => None,
        });
        return Search { found: Found::Unanswered(reason.unwrap_or_default()), evaluations };
    };
    answers.drain(..first);
    let holds = |a: &Answer<T>| matches!(a, Answer::Holds(_));
    let holding = answers.iter().take_while(|(_, a)| holds(a)).count();
    let found = if answers.iter().skip(holding).any(|(_, a)| holds(a)) {
        Found::Several(answers.iter().map(|(value, a)| (*value, holds(a))).collect())
    } else {
        let beyond = (holding < answers.len()).then(|| answers.swap_remove(holding));
        let last = holding.checked_sub(1).map(|i| answers.swap_remove(i));
        match (last, beyond) {
            (Some((value, Answer::Holds(at))), None) => Found::Everywhere { value, at },
            (Some((value, Answer::Holds(at))), Some(beyond)) => {
                bisect((value, at), beyond, &mut answer, &mut evaluations)
            }
            (_, Some((value, Answer::Fails(at)))) => Found::Nowhere { value, at },
            // Not reached: the first answer is not `Outside`, and both cases of a last one that holds are above.
            _ => Found::Unanswered(String::new()),
        }
    };
    Search { found, evaluations }
}

/// Bisection between a value that holds and one that does not; then the value is rounded to the side that holds.
fn bisect<T>(
    mut inner: (f64, T),
    mut outer: (f64, Answer<T>),
    answer: &mut impl FnMut(f64) -> Answer<T>,
    evaluations: &mut usize,
) -> Found<T> {
    let largest = outer.0 > inner.0;
    while (outer.0 - inner.0).abs() > BISECTION * inner.0.abs() {
        let middle = 0.5 * (inner.0 + outer.0);
        *evaluations += 1;
        match answer(middle) {
            Answer::Holds(at) => inner = (middle, at),
            other => outer = (middle, other),
        }
    }
    let rounded = rounded(inner.0, DIGITS, !largest);
    if rounded != inner.0 {
        *evaluations += 1;
        if let Answer::Holds(at) = answer(rounded) {
            inner = (rounded, at);
        }
    }
    Found::Edge { value: inner.0, at: inner.1, beyond: outer.1 }
}

/// A positive number rounded down, or up, to these significant digits. A number that has no more of them stays.
pub fn rounded(value: f64, digits: i32, up: bool) -> f64 {
    if !(value.is_finite() && value > 0.0) {
        return value;
    }
    let exponent = value.log10().floor() as i32 + 1 - digits;
    // A power of ten with a positive exponent is exact; dividing by it rounds once.
    let power = 10_f64.powi(exponent.abs());
    let scaled = if exponent < 0 { value * power } else { value / power };
    let nearest = scaled.round();
    let whole = match (scaled - nearest).abs() <= 1e-9 * nearest {
        true => nearest,
        false if up => scaled.ceil(),
        false => scaled.floor(),
    };
    if exponent < 0 { whole / power } else { whole * power }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Holds up to `edge`; the answer is the utilisation.
    fn up_to(edge: f64) -> impl FnMut(f64) -> Answer<f64> {
        move |x| if x <= edge { Answer::Holds(x / edge) } else { Answer::Fails(x / edge) }
    }

    fn grid(from: f64, to: f64) -> Vec<f64> {
        (0..=10).map(|i| from + (to - from) * f64::from(i) / 10.0).collect()
    }

    #[test]
    fn the_root_is_found_from_the_side_that_holds() {
        // x² ≤ 2.
        let root = 2_f64.sqrt();
        let mut calls = 0;
        let found = search(&grid(0.1, 5.1), |x| {
            calls += 1;
            if x * x <= 2.0 { Answer::Holds(x * x) } else { Answer::Fails(x * x) }
        });
        assert_eq!(found.evaluations, calls);
        // Eleven samples 0.5 apart; bisection to 0.9e-4 · 1.414 takes log2(0.5 / 1.27e-4) = 11.9, one for the rounding.
        assert_eq!(calls, 11 + 12 + 1);
        let Found::Edge { value, at, beyond } = found.found else { panic!("{:?}", found.found) };
        assert!(value <= root && value >= root * (1.0 - TOLERANCE), "{value}");
        assert_eq!(at, value * value);
        assert!(matches!(beyond, Answer::Fails(square) if square > 2.0));
        assert_eq!(value, rounded(value, DIGITS, false));
    }

    /// The smallest value: samples descend.
    #[test]
    fn a_smallest_value_is_rounded_up() {
        let root = 1.0 / 3.0;
        let found = search(&grid(9.0, 0.1), |x| if x >= root { Answer::Holds(()) } else { Answer::Fails(()) });
        let Found::Edge { value, .. } = found.found else { panic!("{:?}", found.found) };
        assert!(value >= root && value <= root * (1.0 + TOLERANCE), "{value}");
    }

    #[test]
    fn without_a_change_there_is_no_edge() {
        let found = search(&grid(1.0, 2.0), up_to(9.0));
        assert_eq!(found.found, Found::Everywhere { value: 2.0, at: 2.0 / 9.0 });
        assert_eq!(found.evaluations, 11);
        let found = search(&grid(1.0, 2.0), up_to(0.5));
        assert_eq!(found.found, Found::Nowhere { value: 1.0, at: 2.0 });
    }

    #[test]
    fn two_changes_are_reported() {
        // Holds below 1.3 and above 1.7.
        let found = search(&grid(1.0, 2.0), |x| match (1.3..1.7).contains(&x) {
            true => Answer::Fails(()),
            false => Answer::Holds(()),
        });
        let Found::Several(samples) = found.found else { panic!("{:?}", found.found) };
        assert_eq!(samples.len(), 11);
        assert_eq!((samples[0].1, samples[5].1, samples[10].1), (true, false, true));
        // A favourable end that fails is one too many as well.
        let found = search(&grid(1.0, 2.0), |x| match (1.3..1.7).contains(&x) {
            true => Answer::Holds(()),
            false => Answer::Fails(()),
        });
        assert!(matches!(found.found, Found::Several(_)));
    }

    #[test]
    fn values_without_an_answer() {
        // None below 1.25 and above 1.65.
        let found = search(&grid(1.0, 2.0), |x| match (1.25..=1.65).contains(&x) {
            true => Answer::Holds(()),
            false => Answer::Outside("scope".into()),
        });
        let Found::Edge { value, beyond, .. } = found.found else { panic!("{:?}", found.found) };
        assert!((1.65 * (1.0 - TOLERANCE)..=1.65).contains(&value), "{value}");
        assert_eq!(beyond, Answer::Outside("scope".into()));
        let found = search(&grid(1.0, 2.0), |_| Answer::<()>::Outside("scope".into()));
        assert_eq!(found.found, Found::Unanswered("scope".into()));
    }

    #[test]
    fn rounding() {
        assert_eq!(rounded(12.345678, 6, false), 12.3456);
        assert_eq!(rounded(12.345678, 6, true), 12.3457);
        assert_eq!(rounded(0.00203, 6, true), 0.00203);
        assert_eq!(rounded(0.00203, 6, false), 0.00203);
        assert_eq!(rounded(1_234_567.0, 3, false), 1_230_000.0);
        assert_eq!(rounded(9.999_999_9, 3, true), 10.0);
    }
}
