//! `tankcheck quake`: properties of an accelerogram, and records of harmonic motion.

mod convert;
mod harmonic;
mod set;
mod synth;
mod target;

use std::path::PathBuf;

pub(crate) use set::Rule;

use oscillator::known::known;
use serde::Serialize;
use tank::STANDARD_GRAVITY;

use crate::cli::inputs::Reading;
use crate::cli::table::Table;
use crate::cli::terminal::warn;
use crate::cli::{Format, Global, no_csv, show};
use crate::error::{EXIT_OK, Error};
use crate::input::records::{self, ReadRecord};
use results::finite;

/// Arguments.
#[derive(clap::Args)]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    /// Peaks, intensity and duration of a record, and its format as read.
    Info(Info),
    /// Write a record of any format as CSV.
    Convert(convert::Convert),
    /// Write a record of harmonic motion.
    Harmonic(harmonic::Harmonic),
    /// Check whether a set of records stands for a spectrum.
    Set(set::Set),
    /// Write synthetic records whose spectrum follows a target.
    Synth(synth::Synth),
}

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake info elcentro.csv
  tankcheck quake info RSN6_IMPVALL.I_I-ELC180.AT2 --format json
  tankcheck quake info column.txt --dt 0.01 --units gal
  tankcheck quake info station.V2 --channel 2

Formats: CSV or plain text; PEER .AT2; ESM and ITACA; K-NET and KiK-net; USGS SMC; COSMOS; CSMIP, USC and Caltech; GeoNet; AFAD; CWA; UNAM; BHRC; SAC.
docs/records.md describes them. Of a file with several channels, --channel or FILE#CHANNEL takes one.
The unit comes from the header or from --units, never from the size of the numbers.")]
struct Info {
    /// The record (`-` reads standard input).
    #[arg(value_name = "RECORD")]
    record: PathBuf,
    #[command(flatten)]
    reading: Reading,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// The facts of a record, SI.
#[derive(Serialize)]
pub(crate) struct Facts<'a> {
    name: &'a str,
    format: &'a str,
    unit: String,
    unit_source: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    channel: Option<&'a str>,
    notes: &'a [String],
    low_cut_frequency_hz: Option<f64>,
    usable_period_s: Option<f64>,
    samples: usize,
    dt: f64,
    duration: f64,
    pga: f64,
    pga_g: f64,
    pgv: f64,
    pgd: f64,
    arias: f64,
    cav: f64,
    significant_duration: f64,
    significant_start: f64,
    final_velocity: f64,
    final_displacement: f64,
    sha256: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    known_as: Option<&'static str>,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    let info = match args.command {
        Command::Info(info) => info,
        Command::Harmonic(harmonic) => {
            harmonic.run()?;
            return Ok(EXIT_OK);
        }
        Command::Convert(convert) => {
            convert.run()?;
            return Ok(EXIT_OK);
        }
        Command::Set(set) => return set.run(),
        Command::Synth(synth) => return synth.run(),
    };
    let read = records::read(&info.record, &info.reading.options())?;
    let facts = facts(&read);
    finite::check("the measures of the record", &facts)?;
    for warning in records::plausible::doubts(&read.record, &records::Processing::default()) {
        warn("", &warning);
    }
    show(info.format, || human(&facts), || &facts, no_csv)?;
    Ok(EXIT_OK)
}

pub(crate) fn facts(read: &ReadRecord) -> Facts<'_> {
    let measures = read.record.measures();
    Facts {
        name: &read.record.name,
        format: &read.format,
        unit: read.unit.to_string(),
        unit_source: &read.unit_source,
        channel: read.channel.as_deref(),
        notes: &read.notes,
        low_cut_frequency_hz: read.low_cut_frequency,
        usable_period_s: read.usable_period(),
        samples: read.record.acceleration.len(),
        dt: read.record.dt,
        duration: read.record.duration(),
        pga: measures.pga,
        pga_g: measures.pga / STANDARD_GRAVITY,
        pgv: measures.pgv,
        pgd: measures.pgd,
        arias: measures.arias,
        cav: measures.cav,
        significant_duration: measures.significant_duration,
        significant_start: measures.significant_start,
        final_velocity: measures.final_velocity,
        final_displacement: measures.final_displacement,
        sha256: &read.sha256,
        known_as: known(&read.record).map(|known| known.name),
    }
}

fn human(facts: &Facts) -> String {
    let mut table = Table::new([facts.name, "", ""]);
    let mut row = |name: &str, value: String, unit: &str| table.row([name, &value, unit]);
    row("peak ground acceleration", format!("{:.4}", facts.pga_g), "g     ");
    row("", format!("{:.4}", facts.pga), "m/s²  ");
    row("peak ground velocity", format!("{:.4}", facts.pgv), "m/s   ");
    row("peak ground displacement", format!("{:.4}", facts.pgd), "m     ");
    row("Arias intensity", format!("{:.4}", facts.arias), "m/s   ");
    row("cumulative absolute velocity", format!("{:.4}", facts.cav), "m/s   ");
    row("significant duration D5-95", format!("{:.3}", facts.significant_duration), "s     ");
    row("  from", format!("{:.3}", facts.significant_start), "s     ");
    row("velocity at the end", format!("{:.4}", facts.final_velocity), "m/s   ");
    row("displacement at the end", format!("{:.4}", facts.final_displacement), "m     ");
    row("duration", format!("{:.3}", facts.duration), "s     ");
    row("time step", format!("{}", facts.dt), "s     ");
    row("samples", format!("{}", facts.samples), "      ");
    let mut text = format!("{table}\nformat   {}\n", facts.format);
    if let Some(channel) = facts.channel {
        text.push_str(&format!("channel  {channel}\n"));
    }
    text.push_str(&format!("unit     {}, from {}\n", facts.unit, facts.unit_source));
    text.push_str(&format!("sha256   {}\n", facts.sha256));
    if let Some(known) = facts.known_as {
        text.push_str(&format!("known as {known}\n"));
    }
    if let (Some(corner), Some(longest)) = (facts.low_cut_frequency_hz, facts.usable_period_s) {
        text.push_str(&format!(
            "filter   low cut at {corner} Hz: nothing can be said of periods beyond {longest:.3} s\n"
        ));
    }
    for note in facts.notes {
        text.push_str(&format!("note     {note}\n"));
    }
    text.push_str("note     velocity and displacement are exact integrals from rest, without baseline correction\n");
    if facts.final_velocity.abs() > 0.02 * facts.pgv {
        text.push_str(&format!(
            "note     the ground does not come to rest ({:.1} % of the peak velocity at the end): the record is not \
             baseline-corrected, and its displacement drifts\n",
            100.0 * facts.final_velocity.abs() / facts.pgv
        ));
    }
    text
}
