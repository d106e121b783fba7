//! Columns and block of a set: the design values of quantities and checks over its records, with their scatter.

use std::collections::BTreeMap;

use codes::record_set::design::{self, Combined, Scatter};
use codes::record_set::standard::Combine;
use codes::time_history::Findings;
use tank::Quantity;
use tank::assessment::Check;

use super::{Earthquake, SetJob, Under};
use crate::pipeline::{self, Design, Records};
use results::{Compatibility, FE, Method, RecordSet, SetCheck, SetQuantity, SetRun, SetScatter, Value};

/// The set against the spectra.
pub(super) struct Rules {
    /// Against its target.
    pub compatibility: Option<Compatibility>,
    /// Why there is no target; may be empty.
    pub no_target: String,
    /// Against the spectrum of the site.
    pub of_site: Option<Records>,
}

/// Columns and block of the set, with the record `shown`.
pub(super) fn of_set(set: &SetJob, runs: &[Under], shown: usize, rules: Rules) -> Design {
    let ids: Vec<&str> = set.records.iter().map(|r| r.id.as_str()).collect();
    let combine = set.combine;
    let values: Vec<BTreeMap<Quantity, f64>> = runs.iter().map(|r| r.values.clone()).collect();
    let scatter = design::scatter(&values, combine);
    let raw: Vec<Vec<Check>> = runs.iter().map(|r| r.findings.checks.clone()).collect();
    let checks = design::checks(&raw, &ids, combine);
    let (mut quantities, procedures) = procedures(runs, &ids, combine);
    quantities.extend(rows(FE, &scatter, &ids));
    let note = format!(
        "Quantities and checks of this column are the {} of {} records ({}); sheets and profiles are those of the record {}.",
        match combine {
            Combine::Mean => "mean of the maxima",
            Combine::Worst => "largest of the maxima",
        },
        runs.len(),
        set.code.design_clause(),
        ids[shown]
    );
    Design {
        values: design_values(&scatter),
        findings: Findings {
            checks: checks.iter().map(|c| c.check.clone()).collect(),
            outside: runs.iter().find_map(|r| r.findings.outside),
            ..runs[shown].findings.clone()
        },
        procedures,
        note,
        set: RecordSet {
            name: set.name.clone(),
            rule: set.code.id().into(),
            combine: combine.id().into(),
            clause: set.code.design_clause().into(),
            fewest_for_mean: set.code.fewest_for_mean(),
            factor: set.factor,
            shown: ids[shown].into(),
            records: set.records.iter().zip(runs).map(of_record).collect(),
            quantities,
            checks: checks.iter().map(|c| of_check(c, &ids)).collect(),
            compatibility: rules.compatibility,
            no_target: rules.no_target,
        },
        records: rules.of_site,
    }
}

/// Design values and checks of a procedure.
type Procedure = (BTreeMap<String, Value>, Vec<Check>);

/// Scatter of the procedures that have a column under every record, and their design values by id.
fn procedures(runs: &[Under], ids: &[&str], combine: Combine) -> (Vec<SetQuantity>, BTreeMap<String, Procedure>) {
    let mut quantities = Vec::new();
    let mut procedures = BTreeMap::new();
    for method in runs.first().map_or(&[][..], |r| &r.methods) {
        let own = runs.iter().filter_map(|r| r.methods.iter().find(|m| m.id == method.id));
        let each: Vec<&Method> = own.collect();
        if each.len() != runs.len() || each.iter().any(|m| m.quantities.is_empty() && m.checks.is_empty()) {
            continue;
        }
        let values: Vec<BTreeMap<Quantity, f64>> = each.iter().map(|m| of_method(m)).collect();
        let scatter = design::scatter(&values, combine);
        let checks: Vec<Vec<Check>> = each.iter().map(|m| m.checks.clone()).collect();
        let checks = design::checks(&checks, ids, combine).into_iter().map(|c| c.check);
        let value = |(q, value): (Quantity, f64)| {
            let dimension = q.dimension();
            (q.id().to_owned(), Value { value, dimension })
        };
        let column = design_values(&scatter).into_iter().map(value).collect();
        quantities.extend(rows(&method.id, &scatter, ids));
        procedures.insert(method.id.clone(), (column, checks.collect()));
    }
    (quantities, procedures)
}

/// A record of the set with its responses and checks.
fn of_record((record, under): (&Earthquake, &Under)) -> SetRun {
    let measures = record.motion.horizontal.measures();
    let usable = record.usable();
    let sloshing = under.values.get(&Quantity::SloshingPeriod).copied();
    let sloshing = sloshing.or_else(|| pipeline::sloshing_period(&under.methods));
    let checks = &under.findings.checks;
    SetRun {
        id: record.id.clone(),
        files: record.files.clone(),
        peaks: [measures.pga, measures.pgv, measures.pgd],
        significant_duration: measures.significant_duration,
        usable_period: usable,
        sloshing_beyond_usable: sloshing.zip(usable).is_some_and(|(t, usable)| t > usable),
        values: by_method(under),
        utilisations: utilisations(checks),
        without_capacity: without_capacity(checks),
        limits_exceeded: under.limits_exceeded.clone(),
    }
}

/// Values of a column by quantity.
fn of_method(method: &Method) -> BTreeMap<Quantity, f64> {
    let values = method.quantities.iter();
    values.filter_map(|(id, v)| Some((Quantity::from_id(id)?, v.value))).collect()
}

/// Design values; periods and masses are the same under every record.
fn design_values(scatter: &BTreeMap<Quantity, Scatter>) -> BTreeMap<Quantity, f64> {
    let value = |(q, s): (&Quantity, &Scatter)| (*q, if q.is_response() { s.design } else { s.mean });
    scatter.iter().map(value).collect()
}

/// Scatter of the responses of a method.
fn rows(method: &str, scatter: &BTreeMap<Quantity, Scatter>, ids: &[&str]) -> Vec<SetQuantity> {
    let responses = scatter.iter().filter(|(q, _)| q.is_response());
    let row = |(quantity, scatter): (&Quantity, &Scatter)| SetQuantity {
        method: method.into(),
        quantity: quantity.id().into(),
        title: quantity.title().into(),
        dimension: quantity.dimension(),
        scatter: numbers(scatter, ids),
    };
    responses.map(row).collect()
}

fn of_check(combined: &Combined, ids: &[&str]) -> SetCheck {
    SetCheck {
        id: combined.check.id.clone(),
        name: combined.check.name.clone(),
        status: combined.check.status,
        scatter: combined.scatter.as_ref().map(|s| numbers(s, ids)),
    }
}

fn numbers(scatter: &Scatter, ids: &[&str]) -> SetScatter {
    SetScatter {
        design: scatter.design,
        mean: scatter.mean,
        cov: scatter.cov,
        min: scatter.min.0,
        max: scatter.max.0,
        max_record: ids[scatter.max.1].into(),
    }
}

/// Responses by method and quantity.
fn by_method(under: &Under) -> BTreeMap<String, BTreeMap<String, f64>> {
    let responses = |values: BTreeMap<Quantity, f64>| -> BTreeMap<String, f64> {
        let kept = values.into_iter().filter(|(q, v)| q.is_response() && v.is_finite());
        kept.map(|(q, v)| (q.id().to_owned(), v)).collect()
    };
    let methods = under.methods.iter().map(|m| (m.id.clone(), responses(of_method(m))));
    let engine = (FE.to_owned(), responses(under.values.clone()));
    methods.chain([engine]).filter(|(_, values)| !values.is_empty()).collect()
}

/// Checks that fail without a capacity.
fn without_capacity(checks: &[Check]) -> Vec<String> {
    let lost = checks.iter().filter(|c| c.compared() && c.utilisation.is_none());
    lost.map(|c| c.id.clone()).collect()
}

/// Utilisation by check; of equal ids the largest.
fn utilisations(checks: &[Check]) -> BTreeMap<String, f64> {
    let mut found: BTreeMap<String, f64> = BTreeMap::new();
    for check in checks.iter().filter(|c| c.compared()) {
        if let Some(utilisation) = check.utilisation {
            let entry = found.entry(check.id.clone()).or_insert(utilisation);
            *entry = entry.max(utilisation);
        }
    }
    found
}
