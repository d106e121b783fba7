//! The report: a function of the results folder alone.

use std::path::Path;

use crate::error::Error;

/// Reads `results.json` and `series.csv` in `folder` and writes `report.html` and `figures/*.svg` there.
///
/// `templates`: a folder whose files replace the embedded templates of the same name.
/// Returns the path of the report.
pub fn render(folder: &Path, templates: Option<&Path>) -> Result<std::path::PathBuf, Error> {
    let _ = (folder, templates);
    Err(Error::Report("not connected yet".into()))
}
