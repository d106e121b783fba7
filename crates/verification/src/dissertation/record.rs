//! Table 8.3: the accelerogram of El Centro as the dissertation has it. The version of textbooks (0.319 g) and that of the NGA-West2 database
//! (0.281 g) fail here.

use crate::records::{EL_CENTRO, Records};
use crate::tanks::G;
use crate::{Answer, Reference, Row};

/// Peak and step of the record.
///
/// Errors: a record that is not there.
pub(super) fn rows(records: &Records) -> Answer {
    let record = records.get(EL_CENTRO)?;
    let row = |what, printed, found, tolerance, unit| {
        Row::new(
            "table-8.3",
            what,
            (printed, "dissertation, table 8.3", Reference::Dissertation),
            found,
            (tolerance, unit),
        )
    };
    Ok(vec![
        // Half of the last digit.
        row("El Centro 1940 NS: largest acceleration over g", 0.348, record.pga() / G, 1.5e-3, ""),
        row("El Centro 1940 NS: step", 0.02, record.dt, 1e-6, "s"),
    ])
}
