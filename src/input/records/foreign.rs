//! Formats that are recognised and refused by their name, with the way to convert them.

use crate::input::diagnostic::Fault;
use files::code::Code;

/// A format and the test for its first bytes.
struct Foreign {
    name: &'static str,
    looks: fn(&[u8]) -> bool,
    help: &'static str,
}

const CSV: &str = "convert its acceleration to a CSV file with the header `time_s,acceleration_m_s2`";
const COUNTS: &str = "its samples are counts: remove the response with ObsPy or gmprocess, and write m/s² as CSV with the header \
                      `time_s,acceleration_m_s2`";
const UNPACK: &str = "unpack it and give the record in it";

const FOREIGN: &[Foreign] = &[
    Foreign { name: "a miniSEED volume", looks: is_mini_seed, help: COUNTS },
    Foreign {
        name: "a SEED volume",
        looks: |b| {
            b.len() > 8 && b[..6].iter().all(u8::is_ascii_digit) && matches!(&b[6..8], b"V " | b"A " | b"S " | b"T ")
        },
        help: COUNTS,
    },
    Foreign {
        name: "a GSE file",
        looks: |b| b.starts_with(b"WID1") || b.starts_with(b"WID2") || b.starts_with(b"BEGIN"),
        help: COUNTS,
    },
    Foreign {
        name: "a time series of IRIS web services",
        looks: |b| b.starts_with(b"TIMESERIES "),
        help: "its samples may be counts: write m/s² as CSV with the header `time_s,acceleration_m_s2`",
    },
    Foreign {
        name: "a GeoCSV file",
        looks: |b| b.starts_with(b"# dataset: GeoCSV"),
        help: "its samples may be counts: write m/s² as CSV with the header `time_s,acceleration_m_s2`",
    },
    Foreign {
        name: "a ZIP archive or an Excel workbook",
        looks: |b| b.starts_with(b"PK\x03\x04"),
        help: "unpack it, or save the sheet as CSV",
    },
    Foreign { name: "an Excel workbook", looks: |b| b.starts_with(b"\xd0\xcf\x11\xe0"), help: "save the sheet as CSV" },
    Foreign { name: "a gzip archive", looks: |b| b.starts_with(b"\x1f\x8b"), help: UNPACK },
    Foreign { name: "an HDF5 file (ASDF)", looks: |b| b.starts_with(b"\x89HDF"), help: CSV },
    Foreign { name: "a MATLAB file", looks: |b| b.starts_with(b"MATLAB 5.0"), help: CSV },
    Foreign { name: "a NumPy array", looks: |b| b.starts_with(b"\x93NUMPY"), help: CSV },
    Foreign { name: "a PDF document", looks: |b| b.starts_with(b"%PDF"), help: CSV },
    Foreign {
        name: "a web page or an XML document",
        looks: |b| {
            [&b"<!DOCTYPE"[..], b"<!doctype", b"<html", b"<HTML", b"<?xml"].iter().any(|begin| b.starts_with(begin))
        },
        help: "download the record itself",
    },
    Foreign { name: "a JSON document", looks: |b| b.starts_with(b"{"), help: CSV },
];

/// Version 2: six digits or blanks, then the quality; version 3: its letters.
fn is_mini_seed(b: &[u8]) -> bool {
    let number = |b: &u8| b.is_ascii_digit() || matches!(b, b' ' | 0);
    let second = b.len() > 8 && b[..6].iter().all(number) && b[..6].iter().any(u8::is_ascii_digit);
    (second && matches!(b[6], b'D' | b'R' | b'Q' | b'M') && matches!(b[7], b' ' | 0)) || b.starts_with(b"MS\x03")
}

/// The fault for a known format that is not read; `None` for any other.
pub fn recognise(bytes: &[u8]) -> Option<Fault> {
    let foreign = FOREIGN.iter().find(|f| (f.looks)(bytes))?;
    Some(
        Fault::new(Code::RecordFormat, format!("this is {}, which is not supported", foreign.name))
            .allowed(FORMATS)
            .help(foreign.help),
    )
}

/// The formats that are read.
const FORMATS: &str =
    "CSV or plain text, PEER .AT2, ESM, K-NET, SMC, COSMOS, CSMIP, USC, GeoNet, AFAD, CWA, UNAM, BHRC, SAC";
