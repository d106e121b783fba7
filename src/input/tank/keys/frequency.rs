//! `analysis.frequency`: transfer functions of the linear engines.

use files::code::Code;
use tank::options::frequency::{FrequencyDamping, FrequencyOptions};

use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::Pitch;

choice!(FrequencyDamping);

/// Options of transfer functions; none if they are not asked for.
pub(super) fn frequency(r: &mut Resolver<'_>, given: &Opt<Given<FrequencyOptions>>) -> Option<FrequencyOptions> {
    let given = given.given.as_ref()?.value.as_ref()?;
    let found = given.resolve(r)?;
    let above =
        |field: &&Field<Pitch>| found.from.zip(found.to).is_some_and(|(from, to)| from >= to) && field.value.is_some();
    if let Some(field) = given.to.given.as_ref().filter(above) {
        let message = "the range of frequencies is empty";
        let allowed = "a frequency above `from`";
        r.refuse(Code::Contradiction, field, message, allowed);
    }
    Some(found)
}
