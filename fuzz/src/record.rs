//! Accelerograms: any bytes give a record or a message, with default options and with all of them given.
//!
//! Line ends, a byte order mark and blank lines at the end do not count; a record that is read comes back from every
//! format and unit it can be written in.

use std::fmt::Write;
use std::path::Path;

use oscillator::record::Record;
use tankcheck::input::records::{
    AccelerationUnit, MAX_PLAUSIBLE, Processing, ReadOptions, ReadRecord, at2, process, read_bytes,
};

/// Target of CSV and plain columns.
pub fn columns(bytes: &[u8]) {
    if !at2::sniff(&String::from_utf8_lossy(bytes)) {
        check(bytes);
    }
}

/// Target of PEER files.
pub fn peer(bytes: &[u8]) {
    if at2::sniff(&String::from_utf8_lossy(bytes)) {
        check(bytes);
    }
}

/// Target of the files of agencies: any channel, with and without the unit given.
pub fn agencies(bytes: &[u8]) {
    check(bytes);
    for channel in ["1", "2"] {
        let options = ReadOptions { channel: Some(channel.into()), ..ReadOptions::default() };
        if let Some(found) = read(bytes, &options) {
            promises(&found.record, &options);
            written(&found.record);
        }
    }
}

/// The record, or `None` with a message.
pub fn read(bytes: &[u8], options: &ReadOptions) -> Option<ReadRecord> {
    match read_bytes(bytes, Path::new("record.csv"), options) {
        Ok(read) => Some(read),
        Err(error) => {
            assert!(error.to_string().contains("error"), "a fault without a message");
            None
        }
    }
}

fn check(bytes: &[u8]) {
    let given = ReadOptions {
        unit: Some(AccelerationUnit::Gal),
        dt: Some(0.01),
        allow_implausible: true,
        ..ReadOptions::default()
    };
    for options in [ReadOptions::default(), given] {
        let Some(found) = read(bytes, &options) else { continue };
        promises(&found.record, &options);
        layout(bytes, &options, &found);
        written(&found.record);
        processed(&found.record);
    }
}

fn promises(record: &Record, options: &ReadOptions) {
    let a = &record.acceleration;
    assert!(a.len() >= 2 && record.dt > 0.0 && record.dt.is_finite(), "{} samples, dt {}", a.len(), record.dt);
    assert!(a.iter().all(|a| a.is_finite()) && record.pga() > 0.0, "no motion");
    assert!(options.allow_implausible || record.pga() <= MAX_PLAUSIBLE, "{} m/s²", record.pga());
    let measures = record.measures();
    assert!(record.pga() > 1e100 || measures.pga == record.pga(), "{measures:?}");
}

/// Changes by an editor or a file transfer.
fn layout(bytes: &[u8], options: &ReadOptions, found: &ReadRecord) {
    let with = |how: &str, bytes: &[u8]| {
        let again = read(bytes, options).unwrap_or_else(|| panic!("{how}: refused"));
        let same = again.record.acceleration == found.record.acceleration && again.record.dt == found.record.dt;
        assert!(same && again.unit == found.unit, "{how}: another record");
    };
    with("blank lines at the end", &[bytes, b"\n\n  \n"].concat());
    if bytes.iter().any(|b| *b >= 0x80 || matches!(b, b'\r' | 0x1a)) {
        return;
    }
    let text = String::from_utf8_lossy(bytes);
    with("byte order mark", &[b"\xef\xbb\xbf", bytes].concat());
    with("CRLF", text.replace('\n', "\r\n").as_bytes());
    if text.contains('\n') {
        with("CR", text.replace('\n', "\r").as_bytes());
    }
}

/// The record in every format and unit comes back.
fn written(record: &Record) {
    // Larger times have too few digits left to print.
    if !(1e-5..1e5).contains(&record.dt) || record.acceleration.len() > 5000 {
        return;
    }
    for (unit, size) in [("m_s2", 1.0), ("g", tank::STANDARD_GRAVITY), ("gal", 0.01)] {
        for (separator, comma) in [(",", false), (";", true), ("\t", false)] {
            same(record, &columns_of(record, unit, size, separator, comma), 2e-9);
        }
    }
    same(record, &peer_of(record), 0.0);
}

/// A CSV of the record; `size` of the unit [m/s²].
pub fn columns_of(record: &Record, unit: &str, size: f64, separator: &str, comma: bool) -> String {
    let mut text = format!("time_s{separator}acceleration_{unit}\n");
    for (i, a) in record.acceleration.iter().enumerate() {
        let line = format!("{}{separator}{:e}", i as f64 * record.dt, a / size);
        let _ = writeln!(text, "{}", if comma { line.replace('.', ",") } else { line });
    }
    text
}

/// A PEER file of the record.
fn peer_of(record: &Record) -> String {
    let mut text = format!(
        "PEER NGA STRONG MOTION DATABASE RECORD\nA, B\nACCELERATION TIME SERIES IN UNITS OF M/S2\nNPTS= {}, DT= {:e} SEC\n",
        record.acceleration.len(),
        record.dt
    );
    for line in record.acceleration.chunks(5) {
        line.iter().for_each(|a| _ = write!(text, " {a:e}"));
        text.push('\n');
    }
    text
}

fn same(record: &Record, text: &str, step: f64) {
    let options = ReadOptions { allow_implausible: true, ..ReadOptions::default() };
    let again = read(text.as_bytes(), &options).unwrap_or_else(|| panic!("refused:\n{text}")).record;
    assert!((again.dt - record.dt).abs() <= step * record.dt, "dt {} from {}\n{text}", again.dt, record.dt);
    assert_eq!(again.acceleration.len(), record.acceleration.len());
    for (a, b) in again.acceleration.iter().zip(&record.acceleration) {
        // Two roundings, to the unit and back.
        assert!((a - b).abs() <= 4.5e-16 * b.abs() + 1e-305, "{a:e} from {b:e}");
    }
}

/// Scaling does what its description states, and its results are finite numbers.
fn processed(record: &Record) {
    let identity = Processing { scale_by: Some(1.0), time_factor: Some(1.0), ..Processing::default() };
    match process(record, &identity) {
        Ok(same) => assert!(same.acceleration == record.acceleration && same.dt == record.dt),
        Err(error) => assert!(record.pga() > MAX_PLAUSIBLE, "an unchanged record was rejected: {error}"),
    }
    let twice = Processing { scale_by: Some(2.0), ..Processing::default() };
    if let Ok(double) = process(record, &twice) {
        let pairs = double.acceleration.iter().zip(&record.acceleration);
        assert!(pairs.into_iter().all(|(d, a)| *d == 2.0 * a));
    }
    let to = Processing { scale_to: Some(1.0), ..Processing::default() };
    if let Ok(unit) = process(record, &to) {
        assert!((unit.pga() - 1.0).abs() < 1e-9, "scaled to 1 m/s², found {}", unit.pga());
    }
}
