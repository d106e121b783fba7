//! `tankcheck quake harmonic`: a record of harmonic base motion.

use std::path::PathBuf;

use crate::cli::print;
use crate::error::Error;
use crate::input::records;
use files::write_whole;

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake harmonic --amplitude 0.1g --frequency 0.5 --duration 60 --ramp 4 -o harmonic.csv
  tankcheck compare tank.json --quake harmonic.csv --out out/
  tankcheck compare tank.json --quake harmonic:amplitude=0.1g,frequency=0.5,duration=60,ramp=4 --out out/")]
pub(super) struct Harmonic {
    /// Amplitude with its unit: of the acceleration (0.1g), or of a displacement (5mm), which starts with its velocity.
    #[arg(long, value_name = "AMPLITUDE")]
    amplitude: String,
    /// Frequency [Hz].
    #[arg(long, value_name = "FREQUENCY")]
    frequency: f64,
    /// Duration [s].
    #[arg(long, value_name = "SECONDS")]
    duration: f64,
    /// Time within which the amplitude of an acceleration grows at the start and falls at the end [s].
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    ramp: f64,
    /// Time step [s] [default: a 200th of a period, at most 0.01 s].
    #[arg(long, value_name = "SECONDS")]
    dt: Option<f64>,
    /// File that is written; it must not exist. Standard output without it.
    #[arg(long, short, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Harmonic {
    /// Writes the record.
    ///
    /// Errors: values out of range, a file that exists or cannot be written.
    pub(super) fn run(&self) -> Result<(), Error> {
        let motion = records::Harmonic {
            amplitude: self.amplitude.clone(),
            frequency: self.frequency,
            duration: self.duration,
            ramp: self.ramp,
            dt: self.dt,
        };
        let text = motion.record().map_err(Error::Files)?;
        let Some(path) = &self.out else { return print(&text) };
        if path.exists() {
            let text = format!("--out: found `{}`, which exists, expected the name of a new file", path.display());
            return Err(Error::value(text));
        }
        write_whole(path, text.as_bytes()).map_err(Error::Files)
    }
}
