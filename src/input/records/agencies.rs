//! Tests of the readers of agencies, on small files in their formats with invented numbers (`tests/records`).
//! Samples of the agencies themselves: `benches/peers/records.py`.

use std::path::Path;

use super::{AccelerationUnit, ReadOptions, ReadRecord, read_bytes};

const ESM: &str = include_str!("../../../tests/records/esm.asc");
const KNET: &str = include_str!("../../../tests/records/knet.ns");
const SMC: &str = include_str!("../../../tests/records/usgs.smc");
const COSMOS: &str = include_str!("../../../tests/records/cosmos.v2");
const CSMIP: &str = include_str!("../../../tests/records/csmip.v2");

fn read(text: &str) -> Result<ReadRecord, String> {
    with(text, None)
}

fn with(text: &str, channel: Option<&str>) -> Result<ReadRecord, String> {
    let options = ReadOptions { channel: channel.map(String::from), ..ReadOptions::default() };
    read_bytes(text.as_bytes(), Path::new("record.txt"), &options).map_err(|e| e.to_string())
}

/// What is said of a text in which `from` stands as `to`.
fn changed(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    read(&text.replacen(from, to, 1)).unwrap_err()
}

#[test]
fn esm_ascii() {
    let found = read(ESM).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.005, 4));
    assert!((found.record.pga() - 0.1225).abs() < 1e-12);
    assert_eq!(found.unit, AccelerationUnit::Gal);
    assert_eq!(found.low_cut_frequency, Some(0.2));
    assert!((found.usable_period().unwrap() - 5.0).abs() < 1e-12);
    assert!(found.notes.iter().any(|n| n == "licence: CC BY 4.0"), "{:?}", found.notes);
    assert_eq!(found.record.name, "SOMEWHERE, XX ABC HNN");
    assert!(changed(ESM, "TYPE: ACCELERATION", "TYPE: VELOCITY").contains("not an acceleration"));
    assert!(changed(ESM, "NDATA: 4", "NDATA: 5").contains("4 of 5 numbers"));
    assert!(changed(ESM, "NDATA: 4", "NDATA: 3").contains("more numbers"));
    assert!(changed(ESM, "-12.25", "nan").contains("record.txt:66"));
    assert!(changed(ESM, "UNITS: cm/s^2", "UNITS: furlong").contains("unit"));
}

/// Ten counts around an offset of 1000: ± 100 counts are 100 · 2000/8388608 gal.
#[test]
fn knet_ascii() {
    let found = read(KNET).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.01, 10));
    assert!((found.record.pga() - 100.0 * 2000.0 / 8_388_608.0 * 0.01).abs() < 1e-12);
    assert!(found.record.acceleration.iter().sum::<f64>().abs() < 1e-15);
    assert!(found.notes[0].contains("offset of 0.2384 gal"), "{:?}", found.notes);
    assert!(changed(KNET, "Time(s)  0.1", "Time(s)  1").contains("100 samples"));
    assert!(changed(KNET, "2000(gal)/8388608", "2000/8388608").contains("scale factor"));
    assert!(changed(KNET, "1100", "11x0").contains("record.txt:18"));
    assert!(changed(KNET, "Sampling Freq(Hz)", "Sampling Frequenz").contains("Sampling Freq(Hz)"));
}

#[test]
fn usgs_smc_with_fields_that_touch() {
    let found = read(SMC).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.005, 10));
    assert!((found.record.pga() - 0.22223).abs() < 1e-12);
    assert_eq!(found.record.name, "station = Somewhere");
    assert!(changed(SMC, "-5.5295E+0-5.4933E+0\n", "-5.5295E+0\n").contains("9 of 10 numbers"));
    assert!(changed(SMC, "|a comment", "no comment").contains("no comment"));
    assert!(changed(SMC, "-1.9234E+0", "-1.9*34E+0").contains("not a number"));
    // Real 33, the third of its line, is the corner; 1.7E38 is not known.
    assert_eq!(found.low_cut_frequency, None);
    let head = SMC.split("|a comment").next().unwrap();
    let unknown = "   1.7000000E38".repeat(5);
    let lines: Vec<usize> = head.match_indices(&unknown).map(|(at, _)| at).collect();
    // The first line of reals holds the rate, so the seventh is the sixth of unknown ones.
    let place = lines[5] + 2 * 15;
    let mut filtered = SMC.to_owned();
    filtered.replace_range(place..place + 15, "   1.0000000E-1");
    let found = read(&filtered).unwrap();
    assert_eq!(found.low_cut_frequency, Some(0.1));
    assert!((found.usable_period().unwrap() - 10.0).abs() < 1e-12);
}

/// A file that was cut off names its last line.
#[test]
fn cut_off_files_name_their_last_line() {
    for (text, keep, line) in [(ESM, 66, 66), (SMC, 28, 28), (COSMOS, 10, 10), (CSMIP, 9, 9), (KNET, 18, 18)] {
        let cut: Vec<&str> = text.lines().take(keep).collect();
        let error = read(&format!("{}\n", cut.join("\n"))).unwrap_err();
        assert!(error.contains(&format!("record.txt:{line}")), "{line}: {error}");
    }
}

#[test]
fn cosmos_v1() {
    let found = read(COSMOS).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.005, 9));
    assert!((found.record.pga() - 0.07).abs() < 1e-12);
    assert_eq!(found.low_cut_frequency, Some(0.3));
    assert!(changed(COSMOS, "       2       1       4", "       2       2       4").contains("not an acceleration"));
    assert!(changed(COSMOS, "       2       1       4", "       2       1       5").contains("unit 5"));
    assert!(changed(COSMOS, "    .00001\n", "\n").contains("8 of 9 numbers"));
    let unknown = changed(COSMOS, "    .00019\n", "-999.0000\n");
    assert!(unknown.contains("not known") && unknown.contains("sample 8 of 9"), "{unknown}");
    // Real 62, the second of the eleventh line, is the step in milliseconds, and goes before that of the recorder.
    let unknown = "  -999.000000".repeat(6);
    let lines: Vec<usize> = COSMOS.match_indices(&unknown).map(|(at, _)| at).collect();
    // Five of them stand before the line of real 34.
    let place = lines[9] + 13;
    let mut resampled = COSMOS.to_owned();
    resampled.replace_range(place..place + 13, "    10.000000");
    assert_eq!(read(&resampled).unwrap().record.dt, 0.01);
    // 1/0.30 Hz is 3.3 s, not 14.5 s.
    assert!(found.notes.is_empty(), "{:?}", found.notes);
    let found = read(&COSMOS.replace("over  3.3 secs", "over  14.5 secs")).unwrap();
    assert_eq!(found.low_cut_frequency, Some(0.3));
    assert!(found.notes[0].contains("3.333 s") && found.notes[0].contains("14.5 s"), "{:?}", found.notes);
}

#[test]
fn csmip_channels() {
    let several = read(CSMIP).unwrap_err();
    assert!(several.contains("1: CHAN 1: 90 DEG; 2: CHAN 2: UP") && several.contains("--channel"), "{several}");
    let (one, two) = (with(CSMIP, Some("1")).unwrap(), with(CSMIP, Some("up")).unwrap());
    assert!((one.record.pga() - 0.03038).abs() < 1e-12 && (two.record.pga() - 0.3).abs() < 1e-12);
    assert_eq!((one.record.dt, one.record.acceleration.len()), (0.02, 3));
    assert_eq!(one.low_cut_frequency, Some(0.1));
    assert!(with(CSMIP, Some("3")).unwrap_err().contains("no such channel"));
    assert_eq!(with(ESM, Some("1")).unwrap(), with(ESM, Some("hnn")).unwrap());
    assert!(with(ESM, Some("2")).unwrap_err().contains("no such channel"));
}
