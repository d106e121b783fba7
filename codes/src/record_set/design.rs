//! The design value of a set: mean of the maxima, or the largest of them, value by value and check by check.
//!
//! ```text
//! E_d = 1/n Σ max_t |E_i(t)|        mean: 7 records or more (EN 1998-1), 11 or more (ASCE/SEI 7-16)
//! E_d = max_i max_t |E_i(t)|        worst: fewer
//! ```
//!
//! Of a check the response is its utilisation: demand and capacity of the same instant and place, both under one record. Where the capacity does
//! not depend on the record this is the design value of the demand over the capacity.

use std::collections::BTreeMap;

use tank::Quantity;
use tank::assessment::{Check, CheckStatus};
use tank::check;

use super::standard::Combine;

/// A number under each record.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Design value.
    pub design: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation over the mean, n − 1; none of a mean of 0.
    pub cov: Option<f64>,
    /// Smallest, and the number of its record.
    pub min: (f64, usize),
    /// Largest, and the number of its record.
    pub max: (f64, usize),
}

impl Scatter {
    /// Scatter of values by record, from 0; none without values.
    pub fn of(values: &[(usize, f64)], combine: Combine) -> Option<Scatter> {
        let &(first, value) = values.first()?;
        let count = values.len() as f64;
        let mean = values.iter().map(|(_, v)| v).sum::<f64>() / count;
        let square: f64 = values.iter().map(|(_, v)| (v - mean).powi(2)).sum();
        let extreme = |better: fn(f64, f64) -> bool| {
            values.iter().fold((value, first), |best, &(i, v)| if better(v, best.0) { (v, i) } else { best })
        };
        let (min, max) = (extreme(|v, best| v < best), extreme(|v, best| v > best));
        Some(Scatter {
            design: match combine {
                Combine::Mean => mean,
                Combine::Worst => max.0,
            },
            cov: (values.len() > 1 && mean != 0.0).then(|| (square / (count - 1.0)).sqrt() / mean.abs()),
            mean,
            min,
            max,
        })
    }
}

/// Scatter of the quantities that every record gives.
pub fn scatter(values: &[BTreeMap<Quantity, f64>], combine: Combine) -> BTreeMap<Quantity, Scatter> {
    let Some(first) = values.first() else { return BTreeMap::new() };
    let of = |&quantity: &Quantity| {
        let each = values.iter().enumerate().map(|(i, v)| Some((i, *v.get(&quantity)?)));
        Some((quantity, Scatter::of(&each.collect::<Option<Vec<_>>>()?, combine)?))
    };
    first.keys().filter_map(of).collect()
}

/// A check under each record.
#[derive(Clone, Debug, PartialEq)]
pub struct Combined {
    /// The check of the set.
    pub check: Check,
    /// Scatter of its utilisation over the records that compare; none where the check of the set is without a comparison.
    pub scatter: Option<Scatter>,
    /// Utilisation under each record; none without a comparison, infinite without a capacity.
    pub utilisations: Vec<Option<f64>>,
}

/// Checks by record, number by number, and which of equal ids.
type Key<'a> = (&'a str, usize);

fn keyed(checks: &[Check]) -> Vec<(Key<'_>, &Check)> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let mut found = Vec::new();
    for check in checks {
        let number = seen.entry(check.id.as_str()).or_default();
        *number += 1;
        found.push(((check.id.as_str(), *number), check));
    }
    found
}

/// The checks of a set, worst first.
///
/// A check that one record leaves open is open for the set, unless another record makes the worst of them fail. Records under which a limit state does
/// not apply do not count.
///
/// * `runs`: checks under each record
/// * `names`: of the records
pub fn checks(runs: &[Vec<Check>], names: &[&str], combine: Combine) -> Vec<Combined> {
    let keyed: Vec<Vec<(Key<'_>, &Check)>> = runs.iter().map(|checks| keyed(checks)).collect();
    let mut keys: Vec<Key<'_>> = Vec::new();
    for (key, _) in keyed.iter().flatten() {
        if !keys.contains(key) {
            keys.push(*key);
        }
    }
    let of = |key: &Key<'_>| {
        let each: Vec<Option<&Check>> =
            keyed.iter().map(|run| run.iter().find(|(k, _)| k == key).map(|(_, check)| *check)).collect();
        one(&each, names, combine)
    };
    let mut all: Vec<Combined> = keys.iter().filter_map(of).collect();
    let order: Vec<Check> = check::complete(&[], all.iter().map(|c| c.check.clone()).collect());
    all.sort_by_key(|found| order.iter().position(|check| *check == found.check));
    all
}

fn one(each: &[Option<&Check>], names: &[&str], combine: Combine) -> Option<Combined> {
    let name = |i: usize| names.get(i).copied().unwrap_or_default();
    let first = each.iter().flatten().next()?;
    let utilisations: Vec<Option<f64>> = each.iter().map(|check| check.and_then(Check::ratio)).collect();
    let without = |check: Check| Combined { check, scatter: None, utilisations: utilisations.clone() };
    let compared: Vec<(usize, &Check)> =
        each.iter().enumerate().filter_map(|(i, c)| Some((i, (*c)?))).filter(|(_, c)| c.compared()).collect();
    let of_status = |status: CheckStatus| {
        let found = each.iter().enumerate().filter_map(|(i, c)| Some((i, (*c)?)));
        found.into_iter().find(|(_, c)| c.status == status)
    };
    let fails_anyway = combine == Combine::Worst && compared.iter().any(|(_, c)| c.status == CheckStatus::Fails);
    if !fails_anyway {
        let absent = each.iter().position(Option::is_none).filter(|_| !compared.is_empty());
        for status in [CheckStatus::NotChecked, CheckStatus::Accepted] {
            if let Some((i, open)) = of_status(status) {
                let reason = match each.iter().flatten().all(|c| c.reason == open.reason) {
                    true => open.reason.clone(),
                    false => format!("record {}: {}", name(i), open.reason),
                };
                return Some(without(Check { reason, ..open.clone() }));
            }
        }
        if let Some(i) = absent {
            let reason = format!("the run under the record {} does not give it", name(i));
            return Some(without(first.left_open(reason)));
        }
    }
    if compared.is_empty() {
        return Some(without((*first).clone()));
    }
    let ratios: Vec<(usize, f64)> = compared.iter().filter_map(|(i, c)| Some((*i, c.ratio()?))).collect();
    let scatter = Scatter::of(&ratios, combine)?;
    let check = match combine {
        Combine::Worst => {
            let (i, worst) = compared.iter().find(|(i, _)| *i == scatter.max.1)?;
            let note = [format!("largest of {} records, {}", compared.len(), name(*i)), worst.note.clone()];
            Check {
                note: note.into_iter().filter(|n| !n.is_empty()).collect::<Vec<_>>().join("; "),
                ..(*worst).clone()
            }
        }
        Combine::Mean => mean(&compared, &scatter, name),
    };
    Some(Combined { check, scatter: Some(scatter).filter(|s| s.max.0.is_finite()), utilisations })
}

/// The check of the mean utilisation.
fn mean<'a>(compared: &[(usize, &Check)], scatter: &Scatter, name: impl Fn(usize) -> &'a str) -> Check {
    let (_, first) = compared[0];
    let count = compared.len() as f64;
    let capacities: Vec<f64> = compared.iter().filter_map(|(_, c)| c.capacity).collect();
    let capacity = capacities.iter().sum::<f64>() / count;
    let same = |value: fn(&Check) -> Option<f64>| {
        let own = value(first);
        compared.iter().all(|(_, c)| value(c) == own).then_some(own).flatten()
    };
    let varies = capacities.iter().any(|c| (c / capacity - 1.0).abs() > 1e-9);
    let percent = |u: f64| format!("{:.0} %", 100.0 * u);
    let mut note = format!(
        "mean of {} records: {} ({}) to {} ({})",
        compared.len(),
        percent(scatter.min.0),
        name(scatter.min.1),
        percent(scatter.max.0),
        name(scatter.max.1)
    );
    if varies {
        note.push_str("; the capacity depends on the record: mean of the utilisations, beside the mean capacity");
    }
    let finite = scatter.mean.is_finite() && capacity > 0.0;
    let found = match finite {
        true => {
            Check::new(&first.id, &first.name, scatter.mean * capacity, capacity, first.dimension, &first.clause, &note)
        }
        false => {
            let demand = compared.iter().filter_map(|(_, c)| c.demand).sum::<f64>() / count;
            let none = format!("without a capacity under {}", name(scatter.max.1));
            Check::new(&first.id, &first.name, demand, 0.0, first.dimension, &first.clause, &none)
        }
    };
    // The quotient of the product is off by a digit.
    let status = if finite && scatter.mean <= 1.0 { CheckStatus::Holds } else { CheckStatus::Fails };
    let errors = compared.iter().map(|(_, c)| c.error);
    Check { status, utilisation: finite.then_some(scatter.mean), ..found }
        .of(&first.limit_state)
        .at(None, same(|c| c.z), same(|c| c.theta))
        .with_error(errors.flatten().reduce(f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::assessment::{LimitState, Requirement};
    use tank::units::Dimension;

    fn check(id: &str, demand: f64, capacity: f64) -> Check {
        Check::new(id, id, demand, capacity, Dimension::Stress, "clause", "note")
    }

    fn open(id: &'static str) -> Check {
        let state = LimitState { id, name: id, clause: "clause".into(), requirement: Requirement::Required };
        Check::without_comparison(&state, CheckStatus::NotChecked, "no strength", None)
    }

    /// 1, 2, 3, 6: mean 3, standard deviation √(14/3), by hand.
    #[test]
    fn mean_worst_and_scatter() {
        let values: Vec<(usize, f64)> = [1.0, 2.0, 6.0, 3.0].into_iter().enumerate().collect();
        let found = Scatter::of(&values, Combine::Mean).unwrap();
        assert_eq!((found.design, found.min, found.max), (3.0, (1.0, 0), (6.0, 2)));
        assert!((found.cov.unwrap() - (14.0_f64 / 3.0).sqrt() / 3.0).abs() < 1e-15);
        assert_eq!(Scatter::of(&values, Combine::Worst).unwrap().design, 6.0);
        assert_eq!(Scatter::of(&[], Combine::Mean), None);
    }

    #[test]
    fn a_quantity_that_a_record_lacks_has_no_design_value() {
        let one = |shear: f64| BTreeMap::from([(Quantity::BaseShear, shear), (Quantity::HoopStress, 1.0)]);
        let mut two = one(4.0);
        two.remove(&Quantity::HoopStress);
        let found = scatter(&[one(2.0), two], Combine::Mean);
        assert_eq!(found.keys().collect::<Vec<_>>(), [&Quantity::BaseShear]);
        assert_eq!(found[&Quantity::BaseShear].design, 3.0);
    }

    /// Demands 50, 90 and 130 of a capacity of 100: the mean holds, the worst fails.
    #[test]
    fn the_mean_may_hold_where_the_worst_fails() {
        let runs: Vec<Vec<Check>> = [50.0, 90.0, 130.0].map(|d| vec![check("a", d, 100.0)]).into();
        let names = ["x", "y", "z"];
        let mean = &checks(&runs, &names, Combine::Mean)[0];
        assert!(mean.check.holds() && (mean.check.utilisation.unwrap() - 0.9).abs() < 1e-15);
        assert!((mean.check.demand.unwrap() - 90.0).abs() < 1e-12 && mean.check.capacity == Some(100.0));
        assert!(mean.check.note.contains("50 % (x) to 130 % (z)"), "{}", mean.check.note);
        let worst = &checks(&runs, &names, Combine::Worst)[0];
        assert_eq!((worst.check.status, worst.check.demand), (CheckStatus::Fails, Some(130.0)));
        assert!(worst.check.note.contains("z") && worst.check.note.ends_with("note"));
        assert_eq!(worst.utilisations, [Some(0.5), Some(0.9), Some(1.3)]);
    }

    /// Where capacities differ the utilisation is the response: 0.5 and 1.0, not 100/150.
    #[test]
    fn the_capacity_of_the_same_instant_counts() {
        let runs = [vec![check("a", 50.0, 100.0)], vec![check("a", 50.0, 50.0)]];
        let found = &checks(&runs, &["x", "y"], Combine::Mean)[0].check;
        assert!((found.utilisation.unwrap() - 0.75).abs() < 1e-15);
        assert!((found.demand.unwrap() / found.capacity.unwrap() - 0.75).abs() < 1e-12);
        assert!(found.note.contains("depends on the record"));
    }

    /// A record without a capacity fails the mean as well; one that is open leaves the set open; a worst that fails stays one that fails.
    #[test]
    fn nothing_open_holds() {
        let names = ["x", "y"];
        let one = |runs: [Vec<Check>; 2], combine| checks(&runs, &names, combine).remove(0).check;
        let lost = one([vec![check("a", 1.0, 2.0)], vec![check("a", 1.0, 0.0)]], Combine::Mean);
        assert_eq!((lost.status, lost.utilisation), (CheckStatus::Fails, None));
        for combine in [Combine::Mean, Combine::Worst] {
            let found = one([vec![check("a", 1.0, 2.0)], vec![open("a")]], combine);
            assert_eq!(found.status, CheckStatus::NotChecked);
            assert!(found.reason.contains("record y"), "{}", found.reason);
            let absent = one([vec![check("a", 1.0, 2.0)], Vec::new()], combine);
            assert_eq!((absent.status, absent.utilisation), (CheckStatus::NotChecked, None));
            assert!(absent.reason.contains('y'), "{}", absent.reason);
        }
        let fails = [vec![check("a", 3.0, 2.0)], vec![open("a")]];
        assert_eq!(one(fails.clone(), Combine::Worst).status, CheckStatus::Fails);
        assert_eq!(one(fails, Combine::Mean).status, CheckStatus::NotChecked);
    }
}
