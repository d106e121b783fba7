//! Where and why the methods part.

use codes::Quantity;
use serde::Serialize;

use super::{Section, Source};
use crate::error::Error;

#[derive(Serialize)]
struct View {
    quantity: String,
    what: String,
    why: String,
}

/// Makes the section.
pub fn make(source: &Source) -> Result<Option<Section>, Error> {
    let partings: Vec<View> = source
        .results
        .comparison
        .partings
        .iter()
        .map(|p| View {
            quantity: Quantity::from_id(&p.quantity).map_or(p.quantity.clone(), |q| q.title().into()),
            what: p.what.clone(),
            why: p.why.clone(),
        })
        .collect();
    if partings.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("partings", "Where and why the methods part");
    section.set("partings", &partings);
    Ok(Some(section))
}
