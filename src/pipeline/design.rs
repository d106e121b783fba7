//! Columns under a set of records: the design values in place of those of one record.

use std::collections::BTreeMap;

use codes::time_history::Findings;
use tank::assessment::{Check, Excitation};
use tank::{Case, Quantity};

use super::quantities::with_crest;
use results::{Method, RecordSet, Value};

/// What the rule of the code of the site says of the records of a run.
#[derive(Clone, Debug)]
pub struct Records {
    /// Their number.
    pub count: usize,
    /// The one factor for all of them with which the rule just holds, at the periods that the spectrum covers.
    pub factor: f64,
    /// Why the rule was not asked around all periods.
    pub unasked: Option<String>,
}

/// What a set of records makes of the columns under the record.
#[derive(Clone, Debug)]
pub struct Design {
    /// Demands of the engine against capacities, over all records.
    pub findings: Findings,
    /// Design values of the engine.
    pub values: BTreeMap<Quantity, f64>,
    /// Quantities and checks of the procedures, by id.
    pub procedures: BTreeMap<String, (BTreeMap<String, Value>, Vec<Check>)>,
    /// Remark on the columns, one sentence.
    pub note: String,
    /// The set.
    pub set: RecordSet,
    /// The set against the spectrum of the site; none where it names no code.
    pub records: Option<Records>,
}

/// Gives the columns of the procedures under the record the values of the set.
pub(super) fn procedures(methods: &mut [Method], design: &Design) {
    for method in methods.iter_mut().filter(|m| m.excitation == Excitation::Record) {
        if let Some((values, checks)) = design.procedures.get(&method.id) {
            method.quantities.clone_from(values);
            method.checks.clone_from(checks);
            method.notes.insert(0, design.note.clone());
        }
    }
}

/// The same for the column of the engine, whose checks come from the findings.
pub(super) fn engine(method: &mut Method, design: &Design, case: &Case) {
    let mut values = with_crest(case, &design.values);
    // Periods and masses are those of the tank: of the run that is shown, where the mass of the wall is separated from that of the liquid.
    values.retain(|id, _| Quantity::from_id(id).is_some_and(Quantity::is_response));
    let own = std::mem::take(&mut method.quantities).into_iter();
    values.extend(own.filter(|(id, _)| Quantity::from_id(id).is_some_and(|quantity| !quantity.is_response())));
    method.quantities = values;
    method.notes.insert(0, design.note.clone());
}
