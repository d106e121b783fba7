//! Any bytes as a tank file: the reader must answer with a case or with faults that can be shown, never panic, and a
//! case must keep what the reader promises.
#![no_main]

use libfuzzer_sys::fuzz_target;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

fuzz_target!(|bytes: &[u8]| {
    let source = Source::new("tank.json", String::from_utf8_lossy(bytes));
    match parse(&source) {
        Ok(file) => {
            let (tank, liquid) = (&file.case.tank, &file.case.liquid);
            assert!(tank.courses.iter().all(|c| c.height > 0.0 && c.thickness > 0.0 && c.thickness.is_finite()));
            assert!(liquid.fill_height > 0.0 && liquid.fill_height <= tank.wall_height() * 1.000_001);
            assert!(file.case.gravity > 0.0 && file.case.damping.impulsive.is_finite());
        }
        Err(faults) => {
            assert!(!faults.is_empty());
            faults.render(&source, false);
        }
    }
});
