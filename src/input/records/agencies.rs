//! Tests of the readers of agencies, on small files in their formats. Samples of the agencies themselves: `benches/peers/records.py`.

use std::path::Path;

use super::{AccelerationUnit, ReadOptions, ReadRecord, read_bytes};

fn read(text: &str) -> Result<ReadRecord, String> {
    with(text, None)
}

fn with(text: &str, channel: Option<u32>) -> Result<ReadRecord, String> {
    let options = ReadOptions {
        channel,
        ..ReadOptions::default()
    };
    read_bytes(text.as_bytes(), Path::new("record.txt"), &options).map_err(|e| e.to_string())
}

/// What is said of a text in which `from` stands as `to`.
fn changed(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    read(&text.replacen(from, to, 1)).unwrap_err()
}

fn esm() -> String {
    let keys = [
        "EVENT_NAME: SOMEWHERE",
        "NETWORK: XX",
        "STATION_CODE: ABC",
        "STREAM: HNN",
        "SAMPLING_INTERVAL_S: 0.005000",
        "NDATA: 4",
        "UNITS: cm/s^2",
        "BASELINE_CORRECTION: BASELINE REMOVED",
        "LOW_CUT_FREQUENCY_HZ: 0.200",
        "DATA_TYPE: ACCELERATION",
        "DATA_LICENSE: CC BY 4.0",
    ];
    let mut lines: Vec<String> = keys.iter().map(|k| (*k).to_owned()).collect();
    lines.extend((lines.len()..64).map(|i| format!("USER{i}: ")));
    lines.extend(["0.5", "-12.25", "3.0", "1.0"].map(str::to_owned));
    lines.join("\n") + "\n"
}

#[test]
fn esm_ascii() {
    let found = read(&esm()).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.005, 4));
    assert!((found.record.pga() - 0.1225).abs() < 1e-12);
    assert_eq!(found.unit, AccelerationUnit::Gal);
    assert_eq!(found.low_cut_frequency, Some(0.2));
    assert!((found.usable_period().unwrap() - 5.0).abs() < 1e-12);
    assert!(
        found.notes.iter().any(|n| n == "licence: CC BY 4.0"),
        "{:?}",
        found.notes
    );
    assert_eq!(found.record.name, "SOMEWHERE, XX ABC HNN");
    let text = esm();
    assert!(changed(&text, "TYPE: ACCELERATION", "TYPE: VELOCITY").contains("not an acceleration"));
    assert!(changed(&text, "NDATA: 4", "NDATA: 5").contains("4 of 5 numbers"));
    assert!(changed(&text, "NDATA: 4", "NDATA: 3").contains("more numbers"));
    assert!(changed(&text, "-12.25", "nan").contains("record.txt:66"));
    assert!(changed(&text, "UNITS: cm/s^2", "UNITS: furlong").contains("unit"));
}

fn knet() -> String {
    let head = "Origin Time       2011/03/11 14:46:00\nLat.              38.1\nLong.             142.8\nDepth. (km)       24\nMag.              9.0\n\
        Station Code      ABC001\nStation Lat.      38.0\nStation Long.     141.0\nStation Height(m) 30\nRecord Time       2011/03/11 14:46:30\n\
        Sampling Freq(Hz) 100Hz\nDuration Time(s)  0.1\nDir.              N-S\nScale Factor      2000(gal)/8388608\nMax. Acc. (gal)   1.0\n\
        Last Correction   2011/03/11 14:46:00\nMemo.             \n";
    format!("{head}    1000    1010     990    1000    1100     900    1000    1000 \n    1000    1000 \n")
}

/// Ten counts around an offset of 1000: ± 100 counts are 100 · 2000/8388608 gal.
#[test]
fn knet_ascii() {
    let found = read(&knet()).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.01, 10));
    assert!((found.record.pga() - 100.0 * 2000.0 / 8_388_608.0 * 0.01).abs() < 1e-12);
    assert!(found.record.acceleration.iter().sum::<f64>().abs() < 1e-15);
    assert!(found.notes[0].contains("offset of 0.2384 gal"), "{:?}", found.notes);
    let text = knet();
    assert!(changed(&text, "Time(s)  0.1", "Time(s)  1").contains("100 samples"));
    assert!(changed(&text, "2000(gal)/8388608", "2000/8388608").contains("scale factor"));
    assert!(changed(&text, "1100", "11x0").contains("record.txt:18"));
    assert!(changed(&text, "Sampling Freq(Hz)", "Sampling Frequenz").contains("Sampling Freq(Hz)"));
}

fn smc() -> String {
    let mut integers = [-32768_i64; 48];
    (integers[15], integers[16]) = (1, 10);
    let mut reals = [1.7e38_f64; 50];
    reals[1] = 200.0;
    let mut text = String::from("2 CORRECTED ACCELEROGRAM\n*\n");
    for line in [
        "ABC",
        "date",
        "magnitudes",
        "station = Somewhere",
        "distance",
        "instrument",
        "*",
        "*",
        "*",
    ] {
        text.push_str(&format!("{line}\n"));
    }
    for row in integers.chunks(8) {
        text.push_str(&row.iter().map(|i| format!("{i:>10}")).collect::<String>());
        text.push('\n');
    }
    for row in reals.chunks(5) {
        text.push_str(
            &row.iter()
                .map(|r| format!("{:>15}", format!("{r:.7E}")))
                .collect::<String>(),
        );
        text.push('\n');
    }
    text.push_str("|a comment\n 1.5057E+0-2.2223E+1-1.9234E+0-3.1562E+0-3.2440E+0-3.5638E+0-5.1941E+0-5.7933E+0\n-5.5295E+0-5.4933E+0\n");
    text
}

#[test]
fn usgs_smc_with_fields_that_touch() {
    let found = read(&smc()).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.005, 10));
    assert!((found.record.pga() - 0.22223).abs() < 1e-12);
    assert_eq!(found.record.name, "station = Somewhere");
    let text = smc();
    assert!(changed(&text, "-5.5295E+0-5.4933E+0\n", "-5.5295E+0\n").contains("9 of 10 numbers"));
    assert!(changed(&text, "|a comment", "no comment").contains("no comment"));
    assert!(changed(&text, "-1.9234E+0", "-1.9*34E+0").contains("not a number"));
}

fn cosmos() -> String {
    let integers = |i: usize| [2, 1, 4].get(i).copied().unwrap_or(-999);
    let mut text = String::from("Corrected acceleration    (Format v01.20 with 3 text lines)\nSomewhere\n");
    text.push_str("Record filtered below 0.30  Hz (periods over  3.3 secs)\n 100 Integer-header values follow on  10 lines, Format= (10I8)\n");
    for row in 0..10 {
        text.push_str(
            &(0..10)
                .map(|i| format!("{:>8}", integers(10 * row + i)))
                .collect::<String>(),
        );
        text.push('\n');
    }
    text.push_str(" 100 Real-header values follow on  17 lines, Format= (6F13.6)\n");
    for row in 0..17 {
        let real = |i: usize| if i == 33 { 0.005 } else { -999.0 };
        text.push_str(
            &(6 * row..(6 * row + 6).min(100))
                .map(|i| format!("{:>13.6}", real(i)))
                .collect::<String>(),
        );
        text.push('\n');
    }
    text.push_str("  1 Comment line(s) follow, each starting with a \"|\":\n | a comment\n");
    text.push_str("   9  acceleration pts, approx   1 secs, units=cm/sec2(04),Format=(8F10.5)\n");
    text.push_str("   -.00001    .00013    .00000    .00014  -7.00000    .00013    .00003    .00019\n    .00001\n");
    text
}

#[test]
fn cosmos_v1() {
    let found = read(&cosmos()).unwrap();
    assert_eq!((found.record.dt, found.record.acceleration.len()), (0.005, 9));
    assert!((found.record.pga() - 0.07).abs() < 1e-12);
    assert_eq!(found.low_cut_frequency, Some(0.3));
    let text = cosmos();
    assert!(changed(&text, "       2       1       4", "       2       2       4").contains("not an acceleration"));
    assert!(changed(&text, "       2       1       4", "       2       1       7").contains("unit 7"));
    assert!(changed(&text, "    .00001\n", "\n").contains("8 of 9 numbers"));
}

fn csmip() -> String {
    let channel = |name: &str, first: f64| {
        format!(
            "CORRECTED ACCELEROGRAM   1-2-3       {name}\nx\nSOMEWHERE EARTHQUAKE\nx\nx\nSTATION NO. 1\nSOME STATION\n\
             ACCELEROGRAM BANDPASS FILTERED WITH RAMPS AT  .050- .100 AND 23.00-25.00 CYC/SEC\n\
             \u{20}   3 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)\n{first:>10.3}     -.787     2.288\n\
             \u{20}   3 POINTS OF VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)\n     9.000     9.000     9.000\n"
        )
    };
    channel("CHAN  1:  90 DEG", -3.038) + &channel("CHAN  2:  UP", 30.0)
}

#[test]
fn csmip_channels() {
    let several = read(&csmip()).unwrap_err();
    assert!(
        several.contains("1: CHAN 1: 90 DEG; 2: CHAN 2: UP") && several.contains("--channel"),
        "{several}"
    );
    let (one, two) = (with(&csmip(), Some(1)).unwrap(), with(&csmip(), Some(2)).unwrap());
    assert!((one.record.pga() - 0.03038).abs() < 1e-12 && (two.record.pga() - 0.3).abs() < 1e-12);
    assert_eq!((one.record.dt, one.record.acceleration.len()), (0.02, 3));
    assert_eq!(one.low_cut_frequency, Some(0.1));
    assert!(with(&csmip(), Some(3)).unwrap_err().contains("no such channel"));
    assert!(with(&esm(), Some(1)).unwrap_err().contains("several channels"));
}
