//! `tankcheck quake convert`: a record of any format as CSV.

use std::fmt::Write;
use std::path::PathBuf;

use crate::cli::inputs::Reading;
use crate::cli::print;
use crate::error::Error;
use crate::input::records::{self, AccelerationUnit, LOW_CUT, ReadRecord};
use files::code::Code;
use files::{text, write_whole};
use oscillator::known::known;

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake convert station.ASC --out station.csv
  tankcheck quake convert chan.V2 --channel 2 --to g --out up.csv
  tankcheck quake convert AKT0139608110312.EW -o ew.csv

The file begins with comments: the source with its hash, format, unit, filter and licence. The numbers are those of the source to the last digit of
a double; an offset is removed only where the format has one (K-NET), which is said.")]
pub(super) struct Convert {
    /// The record (`-` reads standard input).
    #[arg(value_name = "RECORD")]
    record: PathBuf,
    #[command(flatten)]
    reading: Reading,
    /// Unit of the output.
    #[arg(long, value_name = "UNIT", default_value = "m/s2")]
    to: AccelerationUnit,
    /// File that is written; it must not exist. Standard output without it, or for `-`.
    #[arg(long, short, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Convert {
    /// Writes the record.
    ///
    /// Errors: a record that cannot be read; a file that exists or cannot be written.
    pub(super) fn run(&self) -> Result<(), Error> {
        let out = self.out.as_ref().filter(|path| path.as_os_str() != "-");
        if let Some(path) = out.filter(|path| path.exists()) {
            return Err(Error::input(
                Code::FileTaken,
                format!("--out: found `{}`, which exists, expected the name of a new file", path.display()),
            ));
        }
        let read = records::read(&self.record, &self.reading.options())?;
        let source = self.record.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let text = csv(&read, &source, self.to);
        match out {
            Some(path) => Ok(write_whole(path, text.as_bytes())?),
            None => print(&text),
        }
    }
}

fn csv(read: &ReadRecord, source: &str, unit: AccelerationUnit) -> String {
    let mut said = String::new();
    let mut comment = |what: &str, value: &str| {
        let _ = writeln!(said, "# {what}: {}", text::line(value).replace(['\n', '\r'], " "));
    };
    comment("record", &read.record.name);
    comment("source", source);
    comment("format", &read.format);
    if let Some(channel) = &read.channel {
        comment("channel", channel);
    }
    comment("source sha256", &read.sha256);
    comment("unit of the source", &read.unit.to_string());
    if let Some(known) = known(&read.record) {
        comment("known as", known.name);
    }
    if let Some(corner) = read.low_cut_frequency {
        comment(LOW_CUT, &format!("{corner} Hz"));
    }
    for note in &read.notes {
        comment("note", note);
    }
    let _ = writeln!(said, "time_s,acceleration_{}", unit.to_string().replace('/', "_"));
    for (k, a) in read.record.acceleration.iter().enumerate() {
        // Twelve digits of the time are more than its origin has, and hide the rounding of the product.
        let time: f64 = format!("{:.11e}", k as f64 * read.record.dt).parse().unwrap_or_default();
        let _ = writeln!(said, "{time},{}", a / unit.si());
    }
    said
}
