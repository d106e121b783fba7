//! First inputs: the examples, the kept results cut short, and inputs made by the targets.

use std::path::{Path, PathBuf};

use super::document::Json;

/// Most numbers of an array in a seed; parallel arrays stay parallel.
const NUMBERS: usize = 6;
/// Most objects of an array in a seed: at least as many as a comparison has methods.
const OBJECTS: usize = 14;
/// Most lines of a table in a seed.
const LINES: usize = 60;

/// Files below `folder` with one of these endings, in order.
fn below(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if endings.iter().any(|e| path.to_string_lossy().ends_with(e)) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn bytes(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Tank files: the examples and the output of `tankcheck init`.
pub fn tanks(root: &Path) -> Vec<Vec<u8>> {
    let examples = below(&root.join("examples"), &[".json"]);
    let init = below(&root.join("src/cli/init"), &[".json"]);
    examples.iter().chain(&init).map(|p| bytes(p)).collect()
}

/// Records in columns: the examples, cut short, and other ways to write them.
pub fn columns(root: &Path) -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = below(&root.join("examples"), &[".csv"]).iter().map(|p| short(&bytes(p))).collect();
    let texts = [
        "t [s];a [g]\n0,00;0,01\n0,02;-0,02\n0,04;0,00\n",
        "Time(s) Accel(g)\n0.00 0.01\n0.01 -0.02\n0.02 0.00\n",
        "# time_ms\tacceleration_gal\n0\t1.5\n10\t-2.5\n20\t1e-3\n",
        "acceleration_m_s2\n0.1\n-.2E-01\n3.D-2\n",
        "0.0039,0.1\n0.0078,0.2\n0.0117,-0.3\n0.0156,1\n",
    ];
    all.extend(texts.map(|t| t.as_bytes().to_vec()));
    all
}

/// PEER files, old and new header.
pub fn peer() -> Vec<Vec<u8>> {
    let texts = [
        "PEER NGA STRONG MOTION DATABASE RECORD\nImperial Valley-02, 5/19/1940, El Centro Array #9, 180\n\
         ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   12, DT=   .0100 SEC,\n   .9984852E-03   .9991426E-03   .1000457E-02   .1002429E-02   .1005058E-02\n  \
         -.1008345E-02   .1012289E-02   .1016890E-02   .1022149E-02   .1028065E-02\n   .1034638E-02  -.1041868E-02\n",
        "PACIFIC ENGINEERING AND ANALYSIS STRONG-MOTION DATA\nACCELERATION TIME HISTORY IN UNITS OF G\n  6 .0050 NPTS, DT\n .1-.2 .3E-01-.4E-02\n.5-.1234567-003\n",
        "units: cm/s2\nNPTS= 3, DT= .02\n1. 2. -3.\n",
    ];
    texts.map(|t| t.as_bytes().to_vec()).to_vec()
}

/// Files in the formats of agencies, with invented numbers.
pub fn agencies(root: &Path) -> Vec<Vec<u8>> {
    let all = below(&root.join("tests/records"), &[".asc", ".ns", ".smc", ".v2"]);
    all.iter().map(|p| bytes(p)).collect()
}

/// The kept results with short arrays and short histories, and those of rising scales and of a pushover.
pub fn results(root: &Path) -> Vec<Vec<u8>> {
    let mut all = Vec::new();
    let reports = root.join("reports");
    for path in below(&reports, &["results.json", "ida.json", "push.json"]) {
        let Some(mut document) = Json::parse(&String::from_utf8_lossy(&bytes(&path))) else { continue };
        document.each("", &mut |_, node| {
            if let Json::List(items) = node {
                let plain = items.iter().all(|i| matches!(i, Json::Number(_)));
                items.truncate(if plain { NUMBERS } else { OBJECTS });
            }
        });
        let mut seed = document.print().into_bytes();
        let series = path.strip_prefix(&reports).unwrap_or(&path).with_file_name("series.csv");
        if let Ok(series) = std::fs::read(root.join("tests/golden/histories").join(series)) {
            seed.push(0);
            seed.extend(short(&series));
        }
        all.push(seed);
    }
    all
}

/// The first lines of a table.
fn short(table: &[u8]) -> Vec<u8> {
    table.split_inclusive(|b| *b == b'\n').take(LINES).flatten().copied().collect()
}
