//! Goal: checks at and next to the limit, and without capacity.

use super::*;

fn check(demand: f64, capacity: f64) -> Check {
    Check::new("id", "name", demand, capacity, Dimension::Stress, "clause", "note")
}

/// Utilisation 1 − ε, 1 and 1 + ε, down to the neighbouring numbers of 1.
#[test]
fn holds_up_to_a_utilisation_of_one() {
    for capacity in [1e-9, 1.0, 235e6, 1e12] {
        for epsilon in [f64::EPSILON, 1e-9, 1e-6, 0.01, 0.049] {
            let below = check(capacity * (1.0 - epsilon), capacity);
            assert!(below.holds && below.utilisation < 1.0, "{below:?}");
            let above = check(capacity * (1.0 + epsilon), capacity);
            assert!(!above.holds && above.utilisation > 1.0, "{above:?}");
        }
        let at = check(capacity, capacity);
        assert!(at.holds && at.utilisation == 1.0, "{at:?}");
    }
    assert_eq!(check(3.0, 4.0).utilisation, 0.75);
    assert_eq!(check(4.0, 3.0).utilisation, 4.0 / 3.0);
    assert!(check(0.0, 1.0).holds && check(-1.0, 1.0).holds);
}

/// Without a capacity every check fails, even for a demand of zero.
#[test]
fn a_capacity_of_zero_or_less_never_holds() {
    for capacity in [0.0, -0.0, -1e-300, -5.0, f64::NAN] {
        for demand in [0.0, 1.0, -1.0] {
            let c = check(demand, capacity);
            assert!(!c.holds && c.utilisation == f64::INFINITY, "{c:?}");
        }
    }
    assert!(check(0.0, f64::MIN_POSITIVE).holds);
    assert!(!check(f64::NAN, 1.0).holds && !check(f64::INFINITY, 1.0).holds);
}

#[test]
fn a_check_keeps_what_it_was_given() {
    let c = check(2.0, 4.0);
    assert_eq!((c.id.as_str(), c.name.as_str()), ("id", "name"));
    assert_eq!((c.clause.as_str(), c.note.as_str()), ("clause", "note"));
    assert_eq!((c.demand, c.capacity, c.dimension), (2.0, 4.0, Dimension::Stress));
}

/// `null` in JSON is infinite, a number is itself.
#[test]
fn utilisation_survives_json() {
    for (demand, capacity) in [(2.0, 4.0), (4.0, 3.0), (1.0, 0.0)] {
        let before = check(demand, capacity);
        let text = serde_json::to_string(&before).unwrap();
        assert_eq!(text.contains("\"utilisation\":null"), capacity == 0.0, "{text}");
        assert_eq!(serde_json::from_str::<Check>(&text).unwrap(), before);
    }
}
