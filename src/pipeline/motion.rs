//! The ground motion for the report: measures of the records, response and design spectra.

use oscillator::record::Record;
use oscillator::spectrum::{self, Method};

use crate::job::Job;
use codes::Procedure;
use results::{RecordSummary, SpectrumCurve};

/// Periods of the curves: 160 from 0.02 s to 20 s, evenly spaced in log T (50 or more a decade show every peak of a
/// lightly damped spectrum at the width of a page), and those of `marks` between them, so that a value read off a curve
/// at a period of the tank is computed, not interpolated.
fn periods(marks: &[f64]) -> Vec<f64> {
    const COUNT: usize = 160;
    let (first, last) = (0.02_f64, 20.0_f64);
    let grid = (0..COUNT).map(|i| first * (last / first).powf(i as f64 / (COUNT - 1) as f64));
    let mut periods: Vec<f64> = grid.chain(marks.iter().copied().filter(|t| *t > first && *t < last)).collect();
    periods.sort_by(f64::total_cmp);
    periods.dedup();
    periods
}

/// Spectra of the horizontal record and design spectra of the site, at the damping ratios of the case; `marks` are
/// periods of the tank [s].
pub(crate) fn spectra(job: &Job, marks: &[f64]) -> Vec<SpectrumCurve> {
    let mut dampings = vec![job.case.damping.sloshing, job.case.damping.impulsive];
    dampings.dedup();
    let periods = periods(marks);
    let mut curves = Vec::new();
    if let Some(motion) = &job.case.ground_motion {
        curves.extend(response(&motion.horizontal, &periods, &dampings));
    }
    curves.extend(design(job, &periods, &dampings));
    curves
}

/// Response spectra of a record, one per damping ratio, all in one sweep.
fn response(record: &Record, period: &[f64], dampings: &[f64]) -> Vec<SpectrumCurve> {
    let found = spectrum::spectrum(record, period, dampings, Method::Exact);
    dampings
        .iter()
        .zip(&found.ordinates)
        .map(|(&damping, ordinates)| SpectrumCurve {
            id: format!("record-{damping}"),
            title: format!("{}, ξ = {:.1} %", record.name, damping * 100.0),
            damping,
            sd: ordinates.iter().map(|o| o.sd).collect(),
            psv: ordinates.iter().map(|o| o.psv).collect(),
            psa: ordinates.iter().map(|o| o.psa).collect(),
            period: period.to_vec(),
        })
        .collect()
}

/// Design spectra of all procedures, of those that few tanks ask for where they run; none for a site outside the scope of the code (its procedure
/// gives the reason).
fn design(job: &Job, period: &[f64], dampings: &[f64]) -> Vec<SpectrumCurve> {
    let site = &job.case.site;
    let shown = |p: &&&dyn Procedure| p.unasked(site) || job.procedures.iter().any(|id| id == p.id());
    let curves = codes::ALL.iter().filter(shown).flat_map(|p| p.design_curves(site, dampings));
    let covered = |longest: f64| period.iter().copied().filter(|t| *t <= longest).collect::<Vec<_>>();
    curves.map(|c| curve(&c.id, &c.title, c.damping, &covered(c.longest), c.acceleration)).collect()
}

fn curve(id: &str, title: &str, damping: f64, period: &[f64], acceleration: impl Fn(f64) -> f64) -> SpectrumCurve {
    let psa: Vec<f64> = period.iter().map(|&t| acceleration(t)).collect();
    let omega = |t: f64| 2.0 * std::f64::consts::PI / t;
    SpectrumCurve {
        id: id.into(),
        title: title.into(),
        damping,
        sd: period.iter().zip(&psa).map(|(&t, a)| a / omega(t).powi(2)).collect(),
        psv: period.iter().zip(&psa).map(|(&t, a)| a / omega(t)).collect(),
        psa,
        period: period.to_vec(),
    }
}

/// The records as computed with, and their measures.
pub(crate) fn records(job: &Job) -> Vec<RecordSummary> {
    let Some(motion) = &job.case.ground_motion else { return Vec::new() };
    let processed = [
        ("horizontal", Some(&motion.horizontal)),
        ("horizontal, y", motion.transverse.as_ref()),
        ("vertical", motion.vertical.as_ref()),
    ];
    processed
        .into_iter()
        .filter_map(|(direction, record)| Some((direction, record?)))
        .zip(&job.raw_records)
        .enumerate()
        .map(|(i, ((direction, record), raw))| RecordSummary {
            usable_period: job.usable_periods.get(i).copied().flatten(),
            ..RecordSummary::new(direction, record, raw)
        })
        .collect()
}

/// Marks the horizontal records that say nothing of the sloshing period [s].
pub(super) fn mark(records: &mut [RecordSummary], sloshing: Option<f64>) {
    for record in records.iter_mut().filter(|r| r.direction != "vertical") {
        let beyond = sloshing.zip(record.usable_period).is_some_and(|(t, usable)| t > usable);
        record.sloshing_beyond_usable = beyond;
    }
}
