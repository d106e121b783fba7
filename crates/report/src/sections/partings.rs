//! Where and why the methods part.

use serde::Serialize;
use tank::Quantity;

use super::{Section, Source};
use files::error::Error;

#[derive(Serialize)]
struct Group {
    quantity: String,
    items: Vec<Item>,
}

#[derive(Serialize)]
struct Item {
    what: String,
    why: String,
}

/// Makes the section.
pub fn make(source: &Source) -> Result<Option<Section>, Error> {
    let mut groups: Vec<Group> = Vec::new();
    for parting in &source.results.comparison.partings {
        let id = &parting.quantity;
        let quantity = Quantity::from_id(id).map_or(id.as_str(), |q| q.title());
        if groups.last().is_none_or(|g| g.quantity != quantity) {
            groups.push(Group {
                quantity: quantity.into(),
                items: Vec::new(),
            });
        }
        if let Some(group) = groups.last_mut() {
            group.items.push(Item {
                what: parting.what.clone(),
                why: parting.why.clone(),
            });
        }
    }
    if groups.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("partings", "Where and why the methods part");
    section.set("groups", &groups);
    Ok(Some(section))
}
