//! Any bytes: the record reader answers with a record or with a fault, and never panics.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use tankcheck::input::records::{AccelerationUnit, ReadOptions, read_bytes};

fuzz_target!(|bytes: &[u8]| {
    let path = Path::new("fuzz.csv");
    let _ = read_bytes(bytes, path, &ReadOptions::default());
    let options = ReadOptions { unit: Some(AccelerationUnit::Gal), dt: Some(0.01), allow_implausible: true };
    if let Ok(read) = read_bytes(bytes, path, &options) {
        assert!(read.record.acceleration.len() >= 2 && read.record.dt > 0.0);
        assert!(read.record.acceleration.iter().all(|a| a.is_finite()));
    }
});
