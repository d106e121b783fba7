//! What the report of a study shows, from its plan, rows and curves.

use std::collections::BTreeMap;

use ::fragility::bootstrap;
use codes::record_set::standard::Standard;
use results::{
    Study, StudyCurve, StudyFault, StudyGap, StudyLimit, StudyLoss, StudyRecord, StudyRule, StudyRuleRow, StudyState,
    StudyTank, StudyTrace, VerdictStatus,
};
use tank::units::Dimension;

use super::curves::{Fragility, RESAMPLES};
use super::damage::{Data, Gathered};
use super::merged::Merged;
use super::plan::Plan;
use super::rows::TankRow;
use super::rule::RuleFound;
use crate::curves::Curve;
use crate::curves::runs::{Method, Seen};

/// Points along a curve.
const POINTS: usize = 60;
/// Tanks whose demands are shown record by record.
const TRACED: usize = 4;

/// What is kept of the rows of the tanks.
#[derive(Clone, Debug, Default)]
pub(super) struct Tanks {
    tanks: BTreeMap<String, StudyTank>,
    /// Tank → limit state → why its first row that has it open has not checked it.
    gaps: BTreeMap<String, BTreeMap<String, String>>,
}

impl Tanks {
    /// Notes why limit states were not checked.
    pub(super) fn gaps(&mut self, row: &TankRow) {
        for (state, reason) in &row.gaps {
            let known = self.gaps.entry(row.tank.clone()).or_default();
            known.entry(state.clone()).or_insert_with(|| reason.clone());
        }
    }

    /// Adds a sample of a tank.
    pub(super) fn add(&mut self, row: &TankRow) {
        let verdict = verdict(&row.verdict);
        let tank = self.tanks.entry(row.tank.clone()).or_insert_with(|| StudyTank {
            periods: row.periods,
            volume: row.volume,
            ..blank(&row.tank)
        });
        if tank.open.is_empty() {
            tank.open.clone_from(&row.open);
        }
        tank.samples[0] += 1;
        let Some(found) = verdict else { return };
        match tank.verdict {
            Some(known) if known == found => tank.samples[1] += 1,
            Some(known) if severity(known) >= severity(found) => {}
            _ => (tank.verdict, tank.samples[1]) = (Some(found), 1),
        }
        if let Some((method, check, utilisation)) = &row.governing {
            let utilisation = utilisation.unwrap_or(f64::INFINITY);
            let worse = tank.governing.as_ref().is_none_or(|known| utilisation > known.2);
            if worse {
                tank.governing = Some((method.clone(), check.clone(), utilisation));
            }
        }
    }
}

/// A tank without a row.
fn blank(id: &str) -> StudyTank {
    StudyTank {
        id: id.into(),
        samples: [0, 0],
        verdict: None,
        governing: None,
        periods: [None, None],
        volume: None,
        open: Vec::new(),
        size: None,
        round: true,
        given: Vec::new(),
    }
}

/// The verdict of a row; none of a tank that is not possible.
fn verdict(word: &str) -> Option<VerdictStatus> {
    VerdictStatus::ALL.into_iter().find(|status| status.id() == word)
}

/// Order of verdicts, the worst last.
fn severity(verdict: VerdictStatus) -> u8 {
    match verdict {
        VerdictStatus::Holds => 0,
        VerdictStatus::NotAssessed => 1,
        VerdictStatus::Incomplete => 2,
        VerdictStatus::Fails => 3,
    }
}

/// All that the report shows.
pub(super) fn page(
    plan: &Plan,
    merged: &Merged,
    gathered: &Gathered,
    fragility: &Fragility,
    mut tanks: Tanks,
) -> Study {
    let end = end(plan, fragility);
    let gaps = gaps(plan, gathered, &tanks.gaps);
    let by_status = merged.by_status.iter().map(|(word, count)| ((*word).to_owned(), *count));
    Study {
        name: plan.name.clone(),
        project: plan.project.clone(),
        engine: plan.engine,
        im: plan.im.clone(),
        dimension: Dimension::from_si_symbol(&plan.im_unit).unwrap_or(Dimension::Dimensionless),
        unit: plan.im_shown.clone(),
        levels: plan.levels.clone(),
        samples: plan.samples,
        tasks: plan.tasks,
        missing_tasks: merged.missing,
        rows: [plan.rows, merged.rows],
        by_status: by_status.collect(),
        sha256: merged.sha256.clone(),
        method: match plan.method {
            Method::Stripes => "stripes",
            Method::Cloud => "cloud",
            Method::Capacities => "capacities",
        }
        .into(),
        resamples: RESAMPLES,
        hazard: plan.hazard.is_some(),
        tanks: plan
            .tanks
            .iter()
            .map(|tank| StudyTank {
                size: tank.size,
                round: tank.round,
                given: tank.given.clone(),
                ..tanks.tanks.remove(&tank.id).unwrap_or_else(|| blank(&tank.id))
            })
            .collect(),
        states: states(plan, gathered),
        gaps,
        curves: fragility.curves.iter().map(|c| curve(c, end)).collect(),
        system: fragility.system.iter().map(|c| curve(c, end)).collect(),
        losses: losses(fragility),
        no_losses: fragility.no_farm.map(str::to_owned),
        records: records(plan, gathered),
        traces: traces(plan, gathered, fragility),
        rule: plan.rule.as_ref().map(|found| rule(found, plan.records.len())),
        faults: faults(gathered),
    }
}

/// Losses of all tanks together.
fn losses(fragility: &Fragility) -> Vec<StudyLoss> {
    let losses = fragility.farm.iter();
    losses
        .map(|loss| StudyLoss {
            im: loss.im,
            earthquakes: loss.earthquakes,
            not_judged: loss.not_judged,
            at_least: loss.at_least.clone(),
            bounds: loss.at_least_bounds.as_ref().and_then(|all| all.first().copied()),
            volume_bounds: loss.mean_volume_bounds_m3,
            independent: loss.at_least_independent.iter().flatten().map(|p| Some(*p)).collect(),
            volume: [loss.mean_volume_m3, loss.largest_volume_m3],
        })
        .collect()
}

/// Rows without a result, by their message.
fn faults(gathered: &Gathered) -> Vec<StudyFault> {
    let faults = gathered.faults.iter();
    faults
        .map(|((status, message), (rows, tank, record))| StudyFault {
            status: (*status).into(),
            message: message.clone(),
            rows: *rows,
            first: [tank.clone(), record.clone()],
        })
        .collect()
}

/// The largest intensity of the figures.
fn end(plan: &Plan, fragility: &Fragility) -> f64 {
    let points = fragility.curves.iter().flat_map(|c| &c.points).map(|p| p.stripe.im);
    plan.levels.iter().copied().chain(points).fold(0.0, f64::max)
}

fn states(plan: &Plan, gathered: &Gathered) -> Vec<StudyState> {
    let of = |(number, state): (usize, &super::damage::DamageState)| {
        let all = || gathered.curves.iter().filter(|((_, at), _)| *at == number);
        let runs = |demand: &str| all().filter_map(|(_, data)| data.ways.get(demand)).sum();
        StudyState {
            name: state.state.clone(),
            limits: state
                .limits
                .iter()
                .map(|limit| StudyLimit {
                    demand: limit.demand.clone(),
                    limit: limit.limit,
                    source: limit.source.clone(),
                    runs: runs(&limit.demand),
                })
                .collect(),
            by_worse: all().map(|(_, data)| data.by_worse).sum(),
        }
    };
    plan.damage.iter().enumerate().map(of).collect()
}

/// Demands of damage states that were not checked, with the tanks for the same reason together; reasons may differ in their numbers.
fn gaps(plan: &Plan, gathered: &Gathered, reasons: &BTreeMap<String, BTreeMap<String, String>>) -> Vec<StudyGap> {
    let mut all: Vec<(String, StudyGap)> = Vec::new();
    for tank in &plan.tanks {
        let data = |state: usize| gathered.curves.get(&(tank.id.clone(), state));
        // The states of a demand count the same rows.
        let mut open: BTreeMap<&str, usize> = BTreeMap::new();
        for (demand, rows) in (0..plan.damage.len()).filter_map(data).flat_map(|d| &d.unchecked) {
            open.insert(demand, *rows);
        }
        for (demand, rows) in open {
            let reason = reasons.get(&tank.id).and_then(|of| of.get(demand));
            let reason = reason.map_or("", String::as_str);
            let words: String = reason.chars().filter(|c| !c.is_ascii_digit()).collect();
            let known = all.iter_mut().find(|(key, gap)| *key == words && gap.demand == demand);
            match known {
                Some((_, gap)) => {
                    gap.tanks.push(tank.id.clone());
                    gap.rows += rows;
                }
                None => all.push((
                    words,
                    StudyGap { demand: demand.into(), tanks: vec![tank.id.clone()], rows, reason: reason.into() },
                )),
            }
        }
    }
    let mut all: Vec<StudyGap> = all.into_iter().map(|(_, gap)| gap).collect();
    all.sort_by(|a, b| a.demand.cmp(&b.demand));
    all
}

fn curve(curve: &Curve, end: f64) -> StudyCurve {
    let fit = curve.curve();
    let at = |k: usize| end * (k + 1) as f64 / POINTS as f64;
    let band = |im: f64| bootstrap::envelope(&curve.samples, im).map(|band| (im, band.low, band.high));
    let scatter = curve.scatter;
    StudyCurve {
        tank: curve.tank.clone(),
        state: curve.damage_state.clone(),
        method: curve.method.into(),
        fit: fit.map(|c| [c.median, c.dispersion]),
        reason: curve.reason.clone(),
        bounds: curve.bounds.unwrap_or_default(),
        n: curve.n,
        median_band: scatter.map(|s| [s.median.low, s.median.high]),
        dispersion_band: scatter.map(|s| [s.dispersion.low, s.dispersion.high]),
        common: curve.common.map(|c| [c.median, c.dispersion]),
        rate: curve.risk.map(|r| [r.annual_rate, r.share_beyond_last]),
        points: curve.points.iter().map(|p| (p.stripe.im, p.stripe.n, p.stripe.exceed, p.bounds)).collect(),
        line: match fit {
            Some(fit) => (0..POINTS).map(|k| (at(k), fit.probability(at(k)))).collect(),
            None => Vec::new(),
        },
        band: (0..POINTS).filter_map(|k| band(at(k))).collect(),
        partial: curve.partial.map(|p| [p.if_safe, p.if_reached].map(|c| c.map(|c| c.median))),
        missing: curve.partial.map_or(0, |p| p.missing),
        unjudged: curve.unjudged.unwrap_or(0),
        never_checked: curve.never_checked.clone(),
        notes: curve.notes.clone(),
    }
}

/// Runs of a tank in the worst state, with a demand greater than 0.
fn demands(data: &Data) -> impl Iterator<Item = (&Seen, f64)> {
    data.runs.iter().filter_map(|run| Some((run, run.ratio.filter(|ratio| *ratio > 0.0)?)))
}

/// Intensity → sum and number of ln Y.
fn levels(data: &Data) -> BTreeMap<u64, (f64, f64)> {
    let mut sums: BTreeMap<u64, (f64, f64)> = BTreeMap::new();
    for (run, ratio) in demands(data) {
        let at = sums.entry(run.im.to_bits()).or_default();
        *at = (at.0 + ratio.ln(), at.1 + 1.0);
    }
    sums
}

fn records(plan: &Plan, gathered: &Gathered) -> Vec<StudyRecord> {
    let worst = plan.damage.len().saturating_sub(1);
    // Record → sum and number of ln Y less the mean at its level; rows in the worst state, and rows judged.
    let mut logs: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
    let mut lost: BTreeMap<u32, [usize; 2]> = BTreeMap::new();
    for data in gathered.curves.iter().filter(|((_, s), _)| *s == worst).map(|(_, d)| d) {
        let means = levels(data);
        for (run, ratio) in demands(data) {
            let (sum, n) = means.get(&run.im.to_bits()).copied().unwrap_or_default();
            // Alone at its level it is its own mean.
            if n > 1.0 {
                let at = logs.entry(run.record).or_default();
                *at = (at.0 + ratio.ln() - sum / n, at.1 + 1.0);
            }
        }
        for run in &data.runs {
            let at = lost.entry(run.record).or_default();
            *at = [at[0] + usize::from(run.reached), at[1] + 1];
        }
    }
    let of = |planned: &super::plan::PlannedRecord| {
        let number = gathered.records.get(&planned.id);
        let measures = gathered.measures.get(&planned.id);
        StudyRecord {
            id: planned.id.clone(),
            duration: [planned.dt * planned.samples.saturating_sub(1) as f64, planned.dt],
            peaks: measures.map(|(factor, peaks)| peaks.map(|peak| peak / factor)),
            severity: number.and_then(|n| logs.get(n)).map(|(sum, n)| (sum / n).exp()),
            lost: number.and_then(|n| lost.get(n)).copied().unwrap_or_default(),
        }
    };
    plan.records.iter().map(of).collect()
}

/// Demands record by record of the tanks whose worst state comes first.
fn traces(plan: &Plan, gathered: &Gathered, fragility: &Fragility) -> Vec<StudyTrace> {
    let Some((worst, state)) = plan.damage.iter().enumerate().next_back() else { return Vec::new() };
    let mut first: Vec<(f64, &str)> = fragility
        .curves
        .iter()
        .filter(|c| c.damage_state == state.state)
        .filter_map(|c| {
            let lowest = c.curve().map(|c| c.median).or(c.bounds.and_then(|b| b[0]));
            Some((lowest.unwrap_or(f64::INFINITY), c.tank.as_deref()?))
        })
        .collect();
    first.sort_by(|a, b| a.0.total_cmp(&b.0));
    let names: BTreeMap<u32, &str> = gathered.records.iter().map(|(id, n)| (*n, id.as_str())).collect();
    let of = |(_, tank): &(f64, &str)| {
        let data = gathered.curves.get(&((*tank).to_owned(), worst))?;
        let mut records: BTreeMap<u32, Vec<(f64, f64)>> = BTreeMap::new();
        // The first sample: others are other tanks.
        for (run, ratio) in demands(data).filter(|(run, _)| run.sample == 0) {
            records.entry(run.record).or_default().push((run.im, ratio));
        }
        (!records.is_empty()).then(|| StudyTrace {
            tank: (*tank).into(),
            state: state.state.clone(),
            records: records
                .into_iter()
                .map(|(n, points)| (names.get(&n).copied().unwrap_or_default().to_owned(), points))
                .collect(),
            deviation: deviation(data),
        })
    };
    first.iter().filter_map(of).take(TRACED).collect()
}

/// Standard deviation of ln Y about its mean at a level, pooled over the levels; none of several samples, which scatter too.
fn deviation(data: &Data) -> Option<f64> {
    if data.runs.iter().any(|run| run.sample > 0) {
        return None;
    }
    let means = levels(data);
    let (mut square, mut free) = (0.0, 0.0);
    for (run, ratio) in demands(data) {
        let (sum, n) = means.get(&run.im.to_bits()).copied()?;
        square += (ratio.ln() - sum / n).powi(2);
    }
    for (_, n) in means.values() {
        free += n - 1.0;
    }
    (free > 0.0).then(|| (square / free).sqrt())
}

fn rule(found: &RuleFound, records: usize) -> StudyRule {
    StudyRule {
        clause: found.clause.clone(),
        target: found.target.clone(),
        records: [records, Standard::En1998.fewest()],
        holds: found.holds,
        rows: found
            .rows
            .iter()
            .map(|row| StudyRuleRow {
                tank: row.tank.clone(),
                which: row.which.clone(),
                period: row.period,
                damping: row.damping,
                smallest: row.smallest_ratio,
                zero: row.mean_zero_period_ratio,
                factor: row.factor,
                holds: row.holds,
            })
            .collect(),
    }
}
