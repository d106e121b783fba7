//! The whole flow of a verification in one function, and the output folder.

use std::path::Path;

use crate::error::Error;
use crate::results::{self, describe};

/// Copies the files of a results folder over another one.
pub fn copy_results(from: &Path, to: &Path) -> Result<(), Error> {
    let fault = |path: &Path, e: std::io::Error| Error::File {
        path: path.into(),
        what: describe(&e),
    };
    for entry in OUTPUT {
        let (source, target) = (from.join(entry), to.join(entry));
        if source.is_dir() {
            std::fs::create_dir_all(&target).map_err(|e| fault(&target, e))?;
            for file in std::fs::read_dir(&source).map_err(|e| fault(&source, e))? {
                let file = file.map_err(|e| fault(&source, e))?;
                let copy = target.join(file.file_name());
                std::fs::copy(file.path(), &copy).map_err(|e| fault(&copy, e))?;
            }
        } else if source.is_file() {
            std::fs::copy(&source, &target).map_err(|e| fault(&target, e))?;
        }
    }
    Ok(())
}

/// What a verification writes into its output folder.
pub const OUTPUT: [&str; 4] = [results::RESULTS_FILE, results::SERIES_FILE, "report.html", "figures"];
