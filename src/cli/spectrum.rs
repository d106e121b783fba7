//! `tankcheck spectrum`: response spectra of a record.

use std::fmt::Write;
use std::path::PathBuf;

use fem::progress::Progress;
use oscillator::record::Record;
use oscillator::spectrum::{Method, POINTS_PER_PERIOD, Spectrum, spectrum};
use serde_json::json;
use tank::STANDARD_GRAVITY;

use crate::cli::budget;
use crate::cli::inputs::Reading;
use crate::cli::progress::Watch;
use crate::cli::table::Table;
use crate::cli::terminal::{print_coloured, say, warn};
use crate::cli::{Format, Global, print};
use crate::error::{EXIT_OK, Error};
use crate::input::records::{self, AccelerationUnit, Processing};
use engines::estimate::{Estimate, Lever, MEMORY_LIMIT_MIB, NUMBER, PROGRAM, WORTH_SAYING};
use files::text;

/// Largest number of oscillators in one call.
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
pub(crate) struct Args {
    /// The record (`-` reads standard input).
    #[arg(value_name = "RECORD")]
    record: PathBuf,
    /// Damping ratios, as `5%` or `0.05`, separated by commas.
    #[arg(long, value_name = "LIST", default_value = "5%", allow_hyphen_values = true)]
    damping: String,
    /// Periods [s]: a range `0.02..20` (evenly spaced in log T) or a list `0.1,0.5,2`.
    #[arg(long, value_name = "RANGE|LIST", default_value = "0.02..20", allow_hyphen_values = true)]
    periods: String,
    /// Number of periods of a range.
    #[arg(long, value_name = "N", default_value_t = 200)]
    points: usize,
    /// Integration of the oscillators.
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
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let dampings = list("--damping", &args.damping, damping)?;
    let periods = periods(&args.periods, args.points)?;
    if periods.len().saturating_mul(dampings.len()) > MAX_OSCILLATORS {
        let count = periods.len().saturating_mul(dampings.len());
        return Err(usage("--points", &format!("{count} oscillators"), &format!("up to {MAX_OSCILLATORS}")));
    }
    let processing = Processing {
        scale_to: args.scale_to.as_deref().map(peak).transpose()?,
        scale_by: args.scale_by,
        time_factor: args.time_factor,
        resample: None,
    };
    let read = records::read(&args.record, &args.reading.options())?;
    let record = records::process(&read.record, &processing)?;
    let origin = format!("--{}", processing.scaled_by().replace('_', "-"));
    records::plausible::check(&record, &origin, args.reading.allow_implausible)?;
    for warning in records::plausible::doubts(&record, &processing) {
        warn("", &warning);
    }
    let method = match args.method {
        How::Exact => Method::Exact,
        How::Duhamel => Method::Duhamel,
        How::Newmark => Method::Newmark,
    };
    let estimate = estimate(&record, &periods, &dampings, method);
    budget::admit(&estimate, MEMORY_LIMIT_MIB, false, global)?;
    let result = match estimate.seconds > WORTH_SAYING {
        false => spectrum(&record, &periods, &dampings, method),
        true => in_parts(&record, &periods, &dampings, method, &Watch::new(global, "spectrum")),
    };
    if let Some(error) = not_finite(&result) {
        return Err(error);
    }
    match args.format {
        Format::Human => {
            let mut text =
                format!("{}: {} samples at {} s, ", text::line(&record.name), record.acceleration.len(), record.dt);
            let _ = writeln!(text, "peak {:.4} g; unit from {}", record.pga() / STANDARD_GRAVITY, read.unit_source);
            for step in &record.processing {
                let _ = writeln!(text, "{step}");
            }
            text.push_str(&human(&result));
            let _ = writeln!(text, "\n{}", method.statement());
            print(&text)?;
        }
        Format::Json => print_coloured(&format!("{}\n", to_json(&result)))?,
        Format::Csv => print_coloured(&csv(&result))?,
    }
    if args.format != Format::Human && !global.quiet {
        say!("note: {}", method.statement());
    }
    Ok(EXIT_OK)
}

/// Time per step of one oscillator [s]: the kernel for eight at a time, and the reference methods.
const STEP_TIME: [f64; 2] = [2e-9, 3e-8];
/// Numbers that a reference method stores per point: ground, displacement, velocity, acceleration.
const AT_POINT: f64 = 4.0;
/// Number of parts of a long spectrum, for its progress.
const PARTS: usize = 200;

/// Estimate of a spectrum: the reference methods refine the record to [`POINTS_PER_PERIOD`] points per period.
fn estimate(record: &Record, periods: &[f64], dampings: &[f64], method: Method) -> Estimate {
    let samples = record.acceleration.len() as f64;
    let oscillates = || periods.iter().filter(|t| **t > 0.0);
    let parts = |period: f64| match method {
        Method::Exact => 1.0,
        Method::Duhamel | Method::Newmark => (POINTS_PER_PERIOD * record.dt / period).ceil().max(1.0),
    };
    let most = oscillates().fold(0.0, |most, &t| f64::max(most, parts(t)));
    let steps = samples * dampings.len() as f64 * oscillates().map(|&t| parts(t)).sum::<f64>();
    let (kept, time, other) = match method {
        Method::Exact => (0.0, STEP_TIME[0], "request fewer periods"),
        _ => (AT_POINT, STEP_TIME[1], "remove the shortest periods, or use --method exact"),
    };
    let oscillators = periods.len() * dampings.len();
    Estimate {
        run: "spectrum",
        size: format!("{oscillators} oscillators, {samples:.0} samples"),
        parts: vec![
            ("the program", PROGRAM),
            ("record and ordinates", NUMBER * (4.0 * samples + 20.0 * oscillators as f64)),
            ("refined record", NUMBER * kept * samples * most),
        ],
        samples,
        steps: samples * most,
        seconds: steps * time,
        inelastic: None,
        lever: Lever { smaller: Vec::new(), other: other.into() },
    }
}

/// [`spectrum`] in parts, with progress.
fn in_parts(record: &Record, periods: &[f64], dampings: &[f64], method: Method, watch: &Watch) -> Spectrum {
    let part = periods.len().div_ceil(PARTS).next_multiple_of(8);
    watch.stage("periods", periods.len() as u64);
    let mut whole = Spectrum {
        periods: periods.to_vec(),
        dampings: dampings.to_vec(),
        ordinates: vec![Vec::with_capacity(periods.len()); dampings.len()],
    };
    for periods in periods.chunks(part) {
        let found = spectrum(record, periods, dampings, method);
        for (all, row) in whole.ordinates.iter_mut().zip(found.ordinates) {
            all.extend(row);
        }
        watch.advance(periods.len() as u64);
    }
    whole
}

fn usage(option: &str, found: &str, allowed: &str) -> Error {
    Error::value(format!("{option}: found `{found}`, expected {allowed}"))
}

/// A comma-separated list.
fn list(option: &str, text: &str, item: impl Fn(&str) -> Option<f64>) -> Result<Vec<f64>, Error> {
    let allowed = match option {
        "--damping" => "ratios from 0 to below 100 %, such as `0.5%,5%` or `0.005,0.05`",
        _ => {
            "a range such as `0.02..20` with 0 < first < last, or a list such as `0.1,0.5,2` of periods ≥ 0 in seconds"
        }
    };
    text.split(',').map(|part| item(part.trim()).ok_or_else(|| usage(option, part.trim(), allowed))).collect()
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
    let Some((first, last)) = text.split_once("..") else { return list("--periods", text, period) };
    let bounds = list("--periods", &format!("{first},{last}"), |t| period(t).filter(|t| *t > 0.0))?;
    let (first, last) = (bounds[0], bounds[1]);
    if first >= last || bounds.len() != 2 {
        return Err(usage("--periods", text, "a range such as `0.02..20` with 0 < first < last"));
    }
    if !(2..=MAX_OSCILLATORS).contains(&points) {
        return Err(usage("--points", &points.to_string(), &format!("2 to {MAX_OSCILLATORS}")));
    }
    let ratio = (last / first).ln() / (points - 1) as f64;
    // The ends are exactly the given ones.
    Ok((0..points).map(|i| if i + 1 == points { last } else { first * (ratio * i as f64).exp() }).collect())
}

/// An acceleration with its unit [m/s²].
fn peak(text: &str) -> Result<f64, Error> {
    let split = text.find(|c: char| !(c.is_ascii_digit() || ".+-eE ".contains(c))).unwrap_or(text.len());
    let (number, unit) = text.split_at(split);
    let value = number.trim().parse::<f64>().ok().filter(|v| v.is_finite() && *v > 0.0);
    match (value, AccelerationUnit::parse(unit)) {
        (Some(value), Some(unit)) => Ok(value * unit.si()),
        _ => {
            Err(usage("--scale-to", text, "an acceleration greater than 0 with its unit, such as `0.5 g` or `2 m/s2`"))
        }
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

/// The first ordinate that is not finite.
fn not_finite(result: &Spectrum) -> Option<Error> {
    for (damping, row) in result.dampings.iter().zip(&result.ordinates) {
        for (period, o) in result.periods.iter().zip(row) {
            if let Some(value) = [o.sd, o.psv, o.psa, o.sv, o.sa].into_iter().find(|v| !v.is_finite()) {
                return Some(Error::Files(files::error::Error::NotFinite {
                    quantity: format!("the spectrum at {period} s and a damping of {damping}"),
                    value,
                }));
            }
        }
    }
    None
}

fn csv(result: &Spectrum) -> String {
    let mut text = String::from("damping,period_s,sd_m,psv_m_s,psa_m_s2,sv_m_s,sa_m_s2\n");
    let mut buffer = zmij::Buffer::new();
    for (damping, row) in result.dampings.iter().zip(&result.ordinates) {
        let damping = damping.to_string();
        for (period, o) in result.periods.iter().zip(row) {
            text.push_str(&damping);
            for value in [*period, o.sd, o.psv, o.psa, o.sv, o.sa] {
                text.push(',');
                shortest(&mut text, buffer.format(value), value);
            }
            text.push('\n');
        }
    }
    text
}

/// Appends a number as `{}` writes it, from its shortest `digits`, which may have an exponent or a zero after the point.
fn shortest(text: &mut String, digits: &str, value: f64) {
    match digits.contains(['e', 'N', 'i']) {
        true => _ = write!(text, "{value}"),
        false => text.push_str(digits.strip_suffix(".0").unwrap_or(digits)),
    }
}

fn human(result: &Spectrum) -> String {
    let mut text = String::new();
    for (damping, row) in result.dampings.iter().zip(&result.ordinates) {
        let _ = writeln!(text, "\ndamping {} %", significant(100.0 * damping));
        let mut table = Table::new(["T [s]", "sd [m]", "psv [m/s]", "psa [m/s²]", "psa [g]", "sv [m/s]", "sa [m/s²]"]);
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
    if (-2..=8).contains(&decimals) { format!("{value:.*}", decimals.max(0) as usize) } else { format!("{value:.3e}") }
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
    fn a_spectrum_in_parts_is_the_whole_one() {
        let record = Record {
            name: "r".into(),
            dt: 0.01,
            acceleration: (0..200).map(|k| (0.3 * f64::from(k)).sin()).collect(),
            processing: Vec::new(),
        };
        let periods = periods("0.02..20", 1000).unwrap();
        let global = Global { color: crate::cli::When::Never, quiet: true, threads: None };
        let whole = spectrum(&record, &periods, &[0.02, 0.05], Method::Exact);
        let parts = in_parts(&record, &periods, &[0.02, 0.05], Method::Exact, &Watch::new(&global, "test"));
        assert_eq!(whole.periods, parts.periods);
        for (a, b) in whole.ordinates.iter().flatten().zip(parts.ordinates.iter().flatten()) {
            assert!((a.sd / b.sd - 1.0).abs() < 1e-12, "{a:?} {b:?}");
        }
    }

    /// 64 points in a period of 1 ns for a record of two samples 1 s apart: 512 GB per stored number.
    #[test]
    fn refined_records_beyond_the_memory_are_refused() {
        let record = Record { name: "r".into(), dt: 1.0, acceleration: vec![0.0, 1.0], processing: Vec::new() };
        let of = |method| estimate(&record, &[1e-9, 0.5], &[0.05], method).hold(MEMORY_LIMIT_MIB);
        assert_eq!(of(Method::Exact), Ok(()));
        let text = of(Method::Newmark).unwrap_err().to_string();
        assert!(text.contains("time steps") || text.contains("MiB"), "{text}");
        assert!(text.contains("help: "), "{text}");
    }

    #[test]
    fn period_ranges_and_lists() {
        assert_eq!(periods("0.1,0.5,2", 200).unwrap(), [0.1, 0.5, 2.0]);
        let range = periods("0.02..20", 4).unwrap();
        assert_eq!((range[0], range[3]), (0.02, 20.0));
        assert!((range[1] - 0.2).abs() < 1e-12 && (range[2] - 2.0).abs() < 1e-12);
        for bad in ["20..0.02", "0..1", "1..", "..", "a,b", "", "-1", "1..2..3", "1,,2", "inf"] {
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
    fn numbers_of_csv_are_those_of_display() {
        for value in [0.0, -0.0, 1.0, -0.25, 0.1, 1e-5, 1.5e-7, 123456.789, 1e15, 1e16, 1e17, 1e300, f64::NAN] {
            let mut text = String::new();
            shortest(&mut text, zmij::Buffer::new().format(value), value);
            assert_eq!(text, value.to_string());
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
