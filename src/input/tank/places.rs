//! Places in the file of values that an engine may reject.

use files::code::Code;
use std::collections::BTreeMap;

use tank::refusal::{Place, Refusal};

use super::read::Field;
use super::resolver::range_fault;
use crate::input::diagnostic::Fault;

/// Places in a file.
#[derive(Clone, Debug, Default)]
pub struct Places(BTreeMap<Place, Field<()>>);

impl Places {
    /// The value of the file, without its content, for each place.
    pub(super) fn new(all: BTreeMap<Place, Field<()>>) -> Places {
        Places(all)
    }

    /// A refusal of an engine as a fault of the file.
    pub fn fault(&self, refusal: &Refusal) -> Fault {
        let mut fault = match self.0.get(&refusal.place) {
            Some(place) => range_fault(Code::Unsupported, place, &refusal.message, &refusal.allowed),
            None => Fault::new(Code::Unsupported, &refusal.message).allowed(&refusal.allowed),
        };
        if !refusal.found.is_empty() {
            fault = fault.found(&refusal.found);
        }
        if !refusal.help.is_empty() {
            fault = fault.help(&refusal.help);
        }
        fault
    }
}
