//! The record reader, format by format and fault by fault; all numbers here are our own.

use std::path::Path;

use proptest::prelude::*;

use super::*;

fn with(text: &[u8], options: &ReadOptions) -> Result<ReadRecord, String> {
    read_bytes(text, Path::new("quake.csv"), options).map_err(|e| e.to_string())
}

fn plain(text: &str) -> Result<ReadRecord, String> {
    with(text.as_bytes(), &ReadOptions::default())
}

fn fault(text: &str, parts: &[&str]) {
    let message = plain(text).expect_err(text);
    for part in parts {
        assert!(message.contains(part), "`{part}` missing:\n{message}");
    }
}

fn gal() -> ReadOptions {
    ReadOptions { unit: Some(AccelerationUnit::Gal), dt: Some(0.02), ..ReadOptions::default() }
}

#[test]
fn csv_in_its_dialects() {
    for text in [
        "time_s,acceleration_m_s2\n0.00,0.1\n0.02,-0.25\n0.04,0.5\n",
        "\u{feff}time_s,acceleration_m_s2\r\n0.00,0.1\r\n0.02,-0.25\r\n0.04,0.5",
        "t [s]; a [m/s²]\n0,00;0,1\n0,02;-0,25\n0,04;0,5\n",
        "Time (s)\tAcc (cm/s2)\n0.00\t10\n0.02\t-25\n0.04\t50\n",
        "# a comment\n# time_s acceleration_m_s2\n0.00 .1\n0.02 -2.5D-01\n0.04 .5E+00\n",
        "A title\nTime[s] Accel[gal]\n 0.00  10.\n 0.02 -25.\n\n 0.04  50.\n",
        "acc_m_s2,time_s\n0.1,0.00\n-0.25,0.02\n0.5,0.04\n",
        "\"time_ms\",\"acceleration_m_s2\"\n\"0\",\"0.1\"\n\"20\",\"-0.25\"\n\"40\",\"0.5\"\n",
    ] {
        let read = plain(text).unwrap_or_else(|e| panic!("{text}\n{e}"));
        assert!((read.record.dt - 0.02).abs() < 1e-15, "{text}");
        for (a, b) in read.record.acceleration.iter().zip([0.1, -0.25, 0.5]) {
            assert!((a - b).abs() < 1e-15, "{text}");
        }
        assert_eq!(read.record.acceleration.len(), 3, "{text}");
    }
    let column = with(b"10\n-25\n50\n", &gal()).unwrap();
    assert_eq!((column.record.dt, column.record.acceleration.len()), (0.02, 3));
    assert_eq!(column.record.acceleration[1], -0.25);
}

#[test]
fn at2_in_its_dialects() {
    for header in [
        "PEER NGA STRONG MOTION DATABASE RECORD\nEvent, station\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   7, DT=   .0100 SEC,\n",
        "PEER STRONG MOTION DATABASE RECORD. PROCESSING\r\nEvent\r\nACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz\r\nNPTS=  7, DT= .01000 SEC\r\n",
        "Event\nACCELERATION IN UNITS OF G\n   7  .0100  NPTS, DT\n",
    ] {
        let text = format!("{header}  .1E-01 -.2E-01  .3E-01  .4E-01-.5E-01\n  .6E-01 -.7E-01\n");
        let read = plain(&text).unwrap_or_else(|e| panic!("{text}\n{e}"));
        assert_eq!((read.record.acceleration.len(), read.record.dt), (7, 0.01));
        assert!((read.record.acceleration[4] + 0.05 * tank::STANDARD_GRAVITY).abs() < 1e-15);
        assert_eq!(read.unit, AccelerationUnit::G);
        fault(&text.replace("7,", "9,").replace("   7 ", "   9 "), &["file ends", "NPTS = 9"]);
        fault(&text.replace("7,", "6,").replace("   7 ", "   6 "), &["more values than NPTS"]);
    }
    fault("X\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01 SEC\n1. 2.\n", &["not an acceleration"]);
    fault("X\nY\nNPTS= 2, DT= .01 SEC\n1. 2.\n", &["does not give the unit", "--units"]);
}

#[test]
fn faults_name_line_found_and_allowed() {
    let head = "time_s,acceleration_m_s2\n";
    fault("", &["empty"]);
    fault(" \n\n", &["empty"]);
    fault("time_s,acceleration_m_s2\n", &["does not contain numbers"]);
    fault(&format!("{head}0,1\n"), &["two samples"]);
    fault(&format!("{head}0,1\n0.02,nan\n0.04,1\n"), &["quake.csv:3", "not a finite number", "nan"]);
    fault(&format!("{head}0,1\n0.02,inf\n"), &["quake.csv:3", "not a finite number"]);
    fault(&format!("{head}0,1\n0.02,1e999\n"), &["not a finite number"]);
    fault(&format!("{head}0,1\n0.02,x\n0.04\n"), &["quake.csv:3", "not a number", "quake.csv:4", "does not match"]);
    fault(&format!("{head}0,1\n0.02,2\n0.01,2\n"), &["quake.csv:4", "does not increase"]);
    fault(&format!("{head}0,1\n0.02,2\n0.06,2\n0.08,1\n"), &["quake.csv:4", "not uniform"]);
    fault(&format!("{head}0,1\n0.02,60\n"), &["implausible", "--allow-implausible"]);
    fault(&format!("{head}0,0\n0.02,0\n"), &["zero"]);
    fault("0 1\n0.02 2\n", &["does not give the unit", "--units"]);
    fault("t,a_g\n0,1\n0.02,2\n", &["does not give the unit"]);
    fault("acceleration_m_s2\n1\n2\n", &["time step", "--dt"]);
    fault("1 2 3\n4 5 6\n", &["3 columns"]);
    fault("t [s];a [g]\n0,00;1.5\n", &["decimal point and decimal comma"]);
    fault("time_s,velocity_m_s\n0,1\n1,2\n", &["neither time nor acceleration"]);
    fault("EVENT_NAME: X\n", &["does not give the unit", "UNITS"]);
    fault("UNCORRECTED ACCELEROGRAM\n", &["volume 1", "not supported"]);
    assert!(with(b"\x00\x01\x02", &gal()).unwrap_err().contains("not text"));
    assert!(with(b"\xff\xfe1\x00", &gal()).unwrap_err().contains("UTF-16"));
    assert!(with(b"time_s,acceleration_m_s2\n0,1\n0.01,2\n", &gal()).unwrap_err().contains("disagree"));
    let allowed = ReadOptions { allow_implausible: true, ..ReadOptions::default() };
    assert!(with(format!("{head}0,1\n0.02,60\n").as_bytes(), &allowed).is_ok());
}

#[test]
fn too_many_samples_are_refused_before_they_cost() {
    let text = "0\n".repeat(MAX_SAMPLES + 10);
    assert!(with(text.as_bytes(), &gal()).unwrap_err().contains("too long"));
    assert!(read(Path::new("."), &gal()).unwrap_err().to_string().contains("folder"));
    assert!(read(Path::new("no/such/file.csv"), &gal()).is_err());
}

proptest! {
    #[test]
    fn any_bytes_are_answered(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = with(&bytes, &gal());
    }

    #[test]
    fn any_text_of_a_record_is_answered(text in "[-+.,;eEdDnaNPTS=0-9 \t\r\n#gms/\\[\\]]{0,200}") {
        let _ = with(text.as_bytes(), &gal());
        let _ = plain(&text);
    }

    #[test]
    fn written_and_read_again(values in proptest::collection::vec(-9.0f64..9.0, 2..60), dt in 1u32..50) {
        prop_assume!(values.iter().any(|v| *v != 0.0));
        let dt = f64::from(dt) / 1000.0;
        let mut text = String::from("time_s,acceleration_m_s2\n");
        for (k, v) in values.iter().enumerate() {
            text.push_str(&format!("{:.3},{v}\n", k as f64 * dt));
        }
        let read = plain(&text).map_err(TestCaseError::fail)?;
        prop_assert_eq!(read.record.acceleration, values);
        prop_assert!((read.record.dt / dt - 1.0).abs() < 1e-12);
    }
}
