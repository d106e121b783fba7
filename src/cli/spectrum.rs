//! `tankcheck spectrum`: response spectra of a record.

use std::fmt::Write;
use std::path::PathBuf;

use codes::STANDARD_GRAVITY;
use codes::spectrum::{Method, Spectrum, spectrum};
use serde_json::json;

use crate::cli::inputs::Reading;
use crate::cli::table::Table;
use crate::cli::{Format, Global, print};
use crate::error::{EXIT_OK, Error};
use crate::input::records::{self, AccelerationUnit, Processing};

/// Most oscillators in one call.
const MAX_OSCILLATORS: usize = 1_000_000;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck spectrum elcentro.csv --damping 0.5%,1%,2%,5% --periods 0.02..20
  tankcheck spectrum elcentro.csv --damping 0.005 --periods 2.1,6 --format json
  tankcheck spectrum elcentro.csv --scale-to '0.5 g' --time-factor 0.57735 --format csv

The maxima are those of the continuous response: between samples too, and in the free vibration after the end of the
record. sd, sv are relative to the ground; psv = ω sd, psa = ω² sd; sa is the absolute acceleration.")]
pub struct Args {
    /// The record (`-` reads standard input).
    #[arg(value_name = "RECORD")]
    record: PathBuf,
    /// Damping ratios, as `5%` or `0.05`, separated by commas.
    #[arg(long, value_name = "LIST", default_value = "5%", allow_hyphen_values = true)]
    damping: String,
    /// Periods [s]: a range `0.02..20` (evenly spaced in log T) or a list `0.1,0.5,2`.
    #[arg(
        long,
        value_name = "RANGE or LIST",
        default_value = "0.02..20",
        allow_hyphen_values = true
    )]
    periods: String,
    /// Number of periods of a range.
    #[arg(long, value_name = "N", default_value_t = 200)]
    points: usize,
    /// How the oscillators are integrated.
    #[arg(long, value_enum, default_value_t = How::Exact)]
    method: How,
    /// Scale the record to this peak, with its unit (`0.5 g`, `2 m/s2`).
    #[arg(long, value_name = "PEAK")]
    scale_to: Option<String>,
    /// Multiply the accelerations by this factor.
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    scale_by: Option<f64>,
    /// Multiply the time axis by this factor.
    #[arg(long, value_name = "FACTOR")]
    time_factor: Option<f64>,
    #[command(flatten)]
    reading: Reading,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Method of integration.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum How {
    /// Exact for acceleration that is linear between samples.
    Exact,
    /// Duhamel's integral by Simpson's rule.
    Duhamel,
    /// Newmark's average acceleration.
    Newmark,
}

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let dampings = list("--damping", &args.damping, damping)?;
    let periods = periods(&args.periods, args.points)?;
    if periods.len().saturating_mul(dampings.len()) > MAX_OSCILLATORS {
        let count = periods.len().saturating_mul(dampings.len());
        return Err(usage(
            "--points",
            &format!("{count} oscillators"),
            &format!("up to {MAX_OSCILLATORS}"),
        ));
    }
    let processing = Processing {
        scale_to: args.scale_to.as_deref().map(peak).transpose()?,
        scale_by: args.scale_by,
        time_factor: args.time_factor,
        resample: None,
    };
    let read = records::read(&args.record, &args.reading.options())?;
    let record = records::process(&read.record, &processing)?;
    let method = match args.method {
        How::Exact => Method::Exact,
        How::Duhamel => Method::Duhamel,
        How::Newmark => Method::Newmark,
    };
    let result = spectrum(&record, &periods, &dampings, method);
    match args.format {
        Format::Human => {
            let mut text = format!(
                "{}: {} samples at {} s, ",
                record.name,
                record.acceleration.len(),
                record.dt
            );
            let _ = writeln!(
                text,
                "peak {:.4} g; unit from {}",
                record.pga() / STANDARD_GRAVITY,
                read.unit_source
            );
            for step in &record.processing {
                let _ = writeln!(text, "{step}");
            }
            text.push_str(&human(&result));
            let _ = writeln!(text, "\n{}", method.statement());
            print(&text)?;
        }
        Format::Json => print(&format!("{}\n", to_json(&result)))?,
        Format::Csv => print(&csv(&result))?,
    }
    if args.format != Format::Human && !global.quiet {
        anstream::eprintln!("note: {}", method.statement());
    }
    Ok(EXIT_OK)
}

fn usage(option: &str, found: &str, allowed: &str) -> Error {
    Error::Input(format!("error: {option}: found `{found}`, allowed {allowed}"))
}

/// A comma-separated list.
fn list(option: &str, text: &str, item: impl Fn(&str) -> Option<f64>) -> Result<Vec<f64>, Error> {
    let allowed = match option {
        "--damping" => "ratios from 0 to below 100 %, such as `0.5%,5%` or `0.005,0.05`",
        _ => {
            "a range such as `0.02..20` with 0 < first < last, or a list such as `0.1,0.5,2` of periods ≥ 0 in seconds"
        }
    };
    text.split(',')
        .map(|part| item(part.trim()).ok_or_else(|| usage(option, part.trim(), allowed)))
        .collect()
}

/// `5%`, `5 %` or `0.05`, below critical.
fn damping(text: &str) -> Option<f64> {
    let ratio = match text.strip_suffix('%') {
        // One division keeps 0.5% the double next to 0.005.
        Some(percent) => percent.trim().parse::<f64>().ok()? / 100.0,
        None => text.parse().ok()?,
    };
    (0.0..1.0).contains(&ratio).then_some(ratio)
}

fn period(text: &str) -> Option<f64> {
    let text = text.strip_suffix('s').unwrap_or(text).trim();
    text.parse().ok().filter(|t: &f64| t.is_finite() && *t >= 0.0)
}

/// A range of `points` periods or a list.
fn periods(text: &str, points: usize) -> Result<Vec<f64>, Error> {
    let Some((first, last)) = text.split_once("..") else {
        return list("--periods", text, period);
    };
    let bounds = list("--periods", &format!("{first},{last}"), |t| {
        period(t).filter(|t| *t > 0.0)
    })?;
    let (first, last) = (bounds[0], bounds[1]);
    if first >= last || bounds.len() != 2 {
        return Err(usage(
            "--periods",
            text,
            "a range such as `0.02..20` with 0 < first < last",
        ));
    }
    if !(2..=MAX_OSCILLATORS).contains(&points) {
        return Err(usage(
            "--points",
            &points.to_string(),
            &format!("2 to {MAX_OSCILLATORS}"),
        ));
    }
    let ratio = (last / first).ln() / (points - 1) as f64;
    // The ends are exactly what was asked for.
    Ok((0..points)
        .map(|i| {
            if i + 1 == points {
                last
            } else {
                first * (ratio * i as f64).exp()
            }
        })
        .collect())
}

/// An acceleration with its unit [m/s²].
fn peak(text: &str) -> Result<f64, Error> {
    let split = text
        .find(|c: char| !(c.is_ascii_digit() || ".+-eE ".contains(c)))
        .unwrap_or(text.len());
    let (number, unit) = text.split_at(split);
    let value = number.trim().parse::<f64>().ok().filter(|v| v.is_finite() && *v > 0.0);
    match (value, AccelerationUnit::parse(unit)) {
        (Some(value), Some(unit)) => Ok(value * unit.si()),
        _ => Err(usage(
            "--scale-to",
            text,
            "an acceleration greater than 0 with its unit, such as `0.5 g` or `2 m/s2`",
        )),
    }
}

/// The contract: `{"spectra":[{"damping":0.05,"points":[{"period":…,"sd":…,…}]}]}` in SI.
fn to_json(result: &Spectrum) -> serde_json::Value {
    let spectra: Vec<_> = result
        .dampings
        .iter()
        .zip(&result.ordinates)
        .map(|(damping, row)| {
            let points: Vec<_> = result
                .periods
                .iter()
                .zip(row)
                .map(|(period, o)| {
                    json!({ "period": period, "sd": o.sd, "psv": o.psv, "psa": o.psa, "sv": o.sv, "sa": o.sa })
                })
                .collect();
            json!({ "damping": damping, "points": points })
        })
        .collect();
    json!({ "spectra": spectra })
}

fn csv(result: &Spectrum) -> String {
    let mut text = String::from("damping,period_s,sd_m,psv_m_s,psa_m_s2,sv_m_s,sa_m_s2\n");
    for (damping, row) in result.dampings.iter().zip(&result.ordinates) {
        for (period, o) in result.periods.iter().zip(row) {
            let _ = writeln!(
                text,
                "{damping},{period},{},{},{},{},{}",
                o.sd, o.psv, o.psa, o.sv, o.sa
            );
        }
    }
    text
}

fn human(result: &Spectrum) -> String {
    let mut text = String::new();
    for (damping, row) in result.dampings.iter().zip(&result.ordinates) {
        let _ = writeln!(text, "\ndamping {} %", significant(100.0 * damping));
        let mut table = Table::new([
            "T [s]",
            "sd [m]",
            "psv [m/s]",
            "psa [m/s²]",
            "psa [g]",
            "sv [m/s]",
            "sa [m/s²]",
        ]);
        for (period, o) in result.periods.iter().zip(row) {
            let values = [*period, o.sd, o.psv, o.psa, o.psa / STANDARD_GRAVITY, o.sv, o.sa];
            table.row(values.map(significant));
        }
        text.push_str(&table.to_string());
    }
    text
}

/// Four significant digits.
fn significant(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let decimals = 3 - value.abs().log10().floor() as i32;
    if (-2..=8).contains(&decimals) {
        format!("{value:.*}", decimals.max(0) as usize)
    } else {
        format!("{value:.3e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_ratios() {
        assert_eq!(damping("0.5%"), Some(0.005));
        assert_eq!(damping("5 %"), Some(0.05));
        assert_eq!(damping("0.02"), Some(0.02));
        assert_eq!(damping("0"), Some(0.0));
        for bad in ["100%", "-1%", "1", "5", "nan", "", "%", "5%%"] {
            assert_eq!(damping(bad), None, "{bad}");
        }
    }

    #[test]
    fn period_ranges_and_lists() {
        assert_eq!(periods("0.1,0.5,2", 200).unwrap(), [0.1, 0.5, 2.0]);
        let range = periods("0.02..20", 4).unwrap();
        assert_eq!((range[0], range[3]), (0.02, 20.0));
        assert!((range[1] - 0.2).abs() < 1e-12 && (range[2] - 2.0).abs() < 1e-12);
        for bad in [
            "20..0.02", "0..1", "1..", "..", "a,b", "", "-1", "1..2..3", "1,,2", "inf",
        ] {
            assert!(periods(bad, 10).is_err(), "{bad}");
        }
        assert!(periods("1..2", 1).is_err());
    }

    #[test]
    fn peaks_with_unit() {
        assert_eq!(peak("2 m/s2").unwrap(), 2.0);
        assert_eq!(peak("0.5g").unwrap(), 0.5 * STANDARD_GRAVITY);
        assert_eq!(peak("100 gal").unwrap(), 1.0);
        for bad in ["2", "g", "-1 g", "1 m", "", "1e999 g"] {
            assert!(peak(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn four_digits() {
        assert_eq!(significant(0.0123456), "0.01235");
        assert_eq!(significant(123.456), "123.5");
        assert_eq!(significant(1e-12), "1.000e-12");
        assert_eq!(significant(0.0), "0");
    }
}
