//! What failed in a study, what its numbers stand on, and what they cost.

use super::first_of;
use crate::number::{count, significant, with_unit};
use results::{EngineId, Study, StudyGap};

/// What failed.
pub fn faults(study: &Study) -> String {
    let failed = |status: &str| study.by_status.iter().find(|(s, _)| s == status).map_or(0, |s| s.1);
    if study.faults.is_empty() && study.missing_tasks == 0 {
        return format!("All {} rows were computed to the end of their record.", count(study.rows[1]));
    }
    let words = [
        ("collapsed", "without equilibrium"),
        ("opened", "out of their model"),
        ("refused", "of a tank that is not possible or not modelled"),
        ("error", "that could not be computed"),
    ];
    let mut parts: Vec<String> = words
        .iter()
        .filter(|(status, _)| failed(status) > 0)
        .map(|(status, text)| format!("{} {text}", count(failed(status))))
        .collect();
    if study.rows[0] > study.rows[1] {
        parts.push(format!("{} without a result", count(study.rows[0] - study.rows[1])));
    }
    format!(
        "Of {} rows: {}. Runs without equilibrium are in every damage state.",
        count(study.rows[0]),
        parts.join(", ")
    )
}

/// The tanks of a gap.
pub fn tanks(study: &Study, gap: &StudyGap) -> String {
    match gap.tanks.len() {
        n if n == study.tanks.len() && n > 1 => "every tank".to_owned(),
        _ => first_of(&gap.tanks),
    }
}

/// What the numbers stand on.
pub fn stands_on(study: &Study) -> Vec<String> {
    let mut all = Vec::new();
    if !study.records.is_empty() {
        all.push(match study.levels.is_empty() {
            true => "Records are scaled by factors; the intensity of each row is that of its scaled record.".into(),
            false => format!(
                "Records are scaled to {} levels of {}, from {} to {}.",
                count(study.levels.len()),
                study.im,
                with_unit(study.levels.first().copied().unwrap_or_default(), study.dimension),
                with_unit(study.levels.last().copied().unwrap_or_default(), study.dimension)
            ),
        });
    }
    if study.engine == Some(EngineId::Harmonic) && !study.records.is_empty() {
        all.push(
            "The harmonic engine is linear: a scale is the scaled response with the static state as it is; tanks whose base lifts or slides run every scale. \
             Its mesh follows 20 Hz whatever the record is."
                .into(),
        );
        all.push(
            "Without `tank.anchors.stiffness` the wall of an anchored tank is held down also where its anchors fail; its compression is then too small."
                .into(),
        );
    }
    if study.hazard {
        all.push("Rates are ∫ P |dλ| with the hazard curve straight in double logarithmic axes, continued beyond its last point.".into());
    }
    all.push("The damage states are those of the table above, with their sources; no dispersion is added for what is not known of models and capacities.".into());
    all.push(format!(
        "SHA-256 of `rows.csv`: `{}`. It does not depend on how the work was spread or repeated.",
        study.sha256
    ));
    all
}

/// Tasks and rows.
pub fn cost(study: &Study) -> Vec<(String, String)> {
    let mut all = vec![
        ("Tasks".to_owned(), count(study.tasks)),
        ("Tasks without a result".to_owned(), count(study.missing_tasks)),
        ("Rows planned".to_owned(), count(study.rows[0])),
        ("Rows with a result".to_owned(), count(study.rows[1])),
    ];
    for (status, rows) in &study.by_status {
        all.push((format!("Rows {status}"), count(*rows)));
    }
    if let Some(time) = shaken(study) {
        all.push(("Seconds of record in the rows with a result".to_owned(), significant(time, 4)));
    }
    all
}

/// Duration of the records of the rows with a result, which share the records evenly [s].
fn shaken(study: &Study) -> Option<f64> {
    let once: f64 = study.records.iter().map(|r| r.duration[0]).sum();
    let each = study.rows[1] as f64 / study.records.len().max(1) as f64;
    (!study.records.is_empty()).then_some(once * each)
}
