//! `tank.json`: text → tree (`syntax`) → mirror of the file (`read`) → case in SI (`resolver`), by the declarations of `keys`.
//!
//! Every station collects its faults and continues as far as possible, so that all faults of a file are shown at once.

pub(in crate::input) mod bytes;
pub(in crate::input) mod choice;
mod edit;
mod file;
pub(in crate::input) mod given;
mod hints;
pub(in crate::input) mod keys;
mod page;
mod places;
pub(in crate::input) mod read;
pub(in crate::input) mod resolver;
pub(in crate::input) mod schema;
pub(in crate::input) mod shape;
pub(in crate::input) mod stated;
pub(in crate::input) mod syntax;
#[cfg(test)]
mod tests;
pub(in crate::input) mod values;
pub(in crate::input) mod variant;

use std::path::Path;

use crate::input::diagnostic::{Faults, Source};
use files::error::Error;

pub use edit::edited;
pub use file::TankFile;
pub use keys::solid_defaults;
pub use page::markdown;
pub use places::Places;
pub use schema::json_schema;
pub use variant::variant;

/// Reads and resolves a tank file (`-` reads standard input). All faults are reported at once in [`Error::Input`].
pub fn read(path: &Path) -> Result<TankFile, Error> {
    let (source, sha256) = bytes::read(path)?;
    match parse(&source) {
        Ok(file) => Ok(TankFile { sha256, ..file }),
        Err(faults) => Err(faults.into_error(&source)),
    }
}

/// Reads and resolves the text of a tank file; the hash is left empty. All faults are returned at once.
pub fn parse(source: &Source) -> Result<TankFile, Faults> {
    let mut faults = Faults::new();
    let file = syntax::parse(source, &mut faults).and_then(|root| resolved(root, source, &mut faults));
    match file {
        Some(file) if faults.is_empty() => Ok(TankFile { source: source.clone(), ..file }),
        _ => Err(faults),
    }
}

/// Resolves the tree of a tank file; other files that it names are next to it.
fn resolved(mut root: syntax::Node, source: &Source, faults: &mut Faults) -> Option<TankFile> {
    // Editors find the schema by this key.
    if let syntax::Kind::Object(members) = &mut root.kind {
        members.retain(|m| m.key != "$schema");
    }
    let file = <keys::TankFile as read::FromNode>::from_node(&root, faults)?;
    let folder = Path::new(&source.name).parent().unwrap_or(Path::new(""));
    keys::resolve(&file, folder, faults)
}
