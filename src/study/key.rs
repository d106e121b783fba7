//! Keys: hashes of what numbers depend on, as canonical JSON.

use oscillator::record::Record;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::METHOD;
use crate::input::TankFile;
use crate::input::study::{Scales, Shaking, StudyInput};
use crate::job::canonical;

/// Hash of bytes, in hexadecimal digits.
pub(super) fn hex(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Hash of a value as canonical JSON.
pub(super) fn hash(value: Value) -> String {
    hex(canonical(value).to_string().as_bytes())
}

/// Hash of the samples of an earthquake in SI, as read.
pub(super) fn of_shaking(shaking: &Shaking) -> String {
    let mut hash = Sha256::new();
    let mut one = |name: &str, record: &Record| {
        hash.update(name);
        hash.update(record.dt.to_le_bytes());
        hash.update((record.acceleration.len() as u64).to_le_bytes());
        for a in &record.acceleration {
            hash.update(a.to_le_bytes());
        }
    };
    one("along", &shaking.along);
    if let Some(record) = &shaking.across {
        one("across", record);
    }
    if let Some(record) = &shaking.up {
        one("up", record);
    }
    // Rows say whether it is long enough.
    if let Some(period) = shaking.usable {
        hash.update("usable");
        hash.update(period.to_le_bytes());
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Hash of a resolved tank with all its options: the case, and the echo of every value of the file with its defaults.
pub(super) fn of_tank(tank: &TankFile) -> String {
    let echo: Vec<Value> = tank
        .echo
        .iter()
        // Words of the cover change no number.
        .filter(|line| line.path != "project" && !line.path.starts_with("project."))
        .map(|line| json!([line.path, line.text]))
        .collect();
    hash(json!({ "case": tank.case, "echo": echo, "procedures": tank.procedures }))
}

/// What all rows of a study share.
pub(super) fn of_study(study: &StudyInput) -> Value {
    let Scales { name, levels, factors, .. } = &study.scales;
    json!({
        "method": METHOD,
        "engine": study.engine,
        "procedures": study.procedures,
        "im": name,
        "levels": levels,
        "factors": factors,
    })
}
