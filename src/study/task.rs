//! The computation of one task: rows of one or a few tanks under a block of records.
//!
//! The harmonic engine builds one model for the block and runs a record once; its scales are the scaled response
//! ([`engines::Response::values_under`]), its checks take the factor ([`codes::time_history::Ready`]), and its codes the spectrum of the record once ([`codes::ordinates::Shared`]). A tank whose base lifts or slides, isolators, and the other
//! engines run every scale; the three-dimensional one does so on one model.

mod record;
mod values;

use std::cell::RefCell;
use std::collections::BTreeMap;

use oscillator::record::Record;
use tank::assessment::Excitation;
use tank::case::GroundMotion;
use tank::check::Decision;

use super::changes::{changed, changed_since};
use super::key;
use super::plan::{Plan, Task, of_sample, refusal};
use super::rows::{Line, Row, RowStatus, SITE, TankRow, kept, plain};
use crate::error::Error;
use crate::input::TankFile;
use crate::input::study::{Shaking, StudyInput};
use crate::job::{self, Job};
use crate::pipeline;
use engines::estimate::Estimate;
use engines::{Prepared, engine, solid};
use results::{EngineId, Method};
use values::{utilisations, values_of};

/// The lines of a task: each tank, then its rows.
///
/// Errors: a tank or record that changed since the plan or cannot be read. What cannot be computed is a row.
pub(super) fn compute(study: &StudyInput, plan: &Plan, task: &Task) -> Result<Vec<Line>, Error> {
    let tanks: BTreeMap<(usize, u32), _> = task
        .tanks
        .iter()
        .map(|&(tank, sample)| {
            let found = study.tanks[tank].tank(study.sampling.as_ref(), sample);
            ((tank, sample), found)
        })
        .collect();
    let records: BTreeMap<usize, Shaking> = task
        .records()
        .map(|number| Ok((number, study.records[number].read()?)))
        .collect::<Result<_, files::error::Error>>()?;
    let tank_keys = tanks.iter().map(|(&unit, tank)| (unit, of_sample(tank))).collect();
    let record_keys = records.iter().map(|(&number, shaking)| (number, key::of_shaking(shaking))).collect();
    unchanged(plan, &tank_keys, &record_keys)?;
    let mut lines = Vec::new();
    for ((tank, sample), found) in tanks {
        let unit = Unit { study, plan, id: &plan.tanks[tank].id, sample, records: &records, solid: RefCell::default() };
        match found {
            Ok(found) => unit.rows(found, &mut lines)?,
            Err(faults) => unit.refused(&refusal(&faults), &mut lines),
        }
    }
    Ok(lines)
}

/// Memory and time of the engine for a tank of the plan under its longest record; none for the codes alone and for a tank that is not possible.
///
/// Errors: a run longer than the limits.
pub(super) fn estimate(study: &StudyInput, plan: &Plan, unit: (usize, u32)) -> Result<Option<(Estimate, u64)>, Error> {
    let longest = plan.records.iter().max_by_key(|record| record.samples);
    let (Some(id), Some(longest)) = (study.engine, longest) else { return Ok(None) };
    let Ok(tank) = study.tanks[unit.0].tank(study.sampling.as_ref(), unit.1) else { return Ok(None) };
    let of = Unit {
        study,
        plan,
        id: &plan.tanks[unit.0].id,
        sample: unit.1,
        records: &BTreeMap::new(),
        solid: RefCell::default(),
    };
    let mut job = of.job(&tank)?;
    job.case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: longest.id.clone(),
            dt: longest.dt,
            acceleration: vec![0.0; longest.samples],
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    let limit = job.solid.memory_limit_mib;
    Ok(Some((engine(id).estimate(&job.task())?, limit)))
}

/// Errors: a tank or record that is not as it was when the plan was made.
fn unchanged(
    plan: &Plan,
    tanks: &BTreeMap<(usize, u32), String>,
    records: &BTreeMap<usize, String>,
) -> Result<(), Error> {
    match changed(plan, tanks, records) {
        None => Ok(()),
        Some(what) => Err(changed_since(&what)),
    }
}

/// The job of one row, as `compare` would run it: with the estimate of the error of its mesh, and with the echo of its tank.
///
/// Errors: a tank that is not possible; a record that cannot be read or processed.
pub(super) fn single(
    study: &StudyInput,
    plan: &Plan,
    unit: (usize, u32),
    record: usize,
    factor: f64,
) -> Result<Job, Error> {
    let found = study.tanks[unit.0].tank(study.sampling.as_ref(), unit.1);
    let raw = study.records[record].read()?;
    unchanged(plan, &[(unit, of_sample(&found))].into(), &[(record, key::of_shaking(&raw))].into())?;
    let tank = found.map_err(|faults| Error::Files(faults.into_error(&study.source)))?;
    let shaking = raw.processed(&tank.record)?;
    let of = Unit {
        study,
        plan,
        id: &plan.tanks[unit.0].id,
        sample: unit.1,
        records: &BTreeMap::new(),
        solid: RefCell::default(),
    };
    let mut job = of.job(&tank)?;
    job.case.ground_motion = Some(motion(&shaking, factor));
    job.linear = tank.fe.clone();
    job.project = study.project.clone().or_else(|| tank.project.clone());
    job.usable_periods = vec![shaking.usable; 1 + usize::from(shaking.across.is_some())];
    job.raw_records =
        [Some(&shaking.along), shaking.across.as_ref(), shaking.up.as_ref()].into_iter().flatten().cloned().collect();
    job.echo = tank.echo;
    Ok(job)
}

/// A tank with the values of a sample, under the records of the task.
struct Unit<'a> {
    study: &'a StudyInput,
    plan: &'a Plan,
    id: &'a str,
    sample: u32,
    records: &'a BTreeMap<usize, Shaking>,
    /// Its model in three dimensions, for records that shake along y or upwards or do not.
    solid: RefCell<Option<([bool; 2], solid::Shared)>>,
}

/// The scales of one record: level and factor.
type Scaled = (Option<f64>, f64);

impl Unit<'_> {
    /// Rows of a tank that is not possible.
    fn refused(&self, message: &str, lines: &mut Vec<Line>) {
        let tank = TankRow {
            tank: self.id.into(),
            sample: self.sample,
            periods: [None, None],
            volume: None,
            verdict: "refused".into(),
            governing: None,
            open: Vec::new(),
            gaps: BTreeMap::new(),
            message: Some(message.into()),
            values: BTreeMap::new(),
        };
        lines.push(Line::Tank(Box::new(tank)));
        let scales = self.blank_scales();
        for (&record, shaking) in self.records {
            for (level, factor) in &scales {
                lines.push(Line::Row(Box::new(Row {
                    level: *level,
                    factor: *factor,
                    usable_period: shaking.usable.map(kept),
                    message: Some(message.into()),
                    ..Row::blank(self.id, self.sample, &self.plan.records[record].id, RowStatus::Refused)
                })));
            }
        }
        if self.records.is_empty() {
            lines.push(Line::Row(Box::new(Row {
                message: Some(message.into()),
                ..Row::blank(self.id, self.sample, SITE, RowStatus::Refused)
            })));
        }
    }

    /// Scales of a row without a run: levels, or factors.
    fn blank_scales(&self) -> Vec<Scaled> {
        let scales = &self.study.scales;
        match scales.levels.is_empty() {
            true => scales.factors.iter().map(|f| (None, *f)).collect(),
            false => scales.levels.iter().map(|l| (Some(*l), 0.0)).collect(),
        }
    }

    fn rows(&self, tank: TankFile, lines: &mut Vec<Line>) -> Result<(), Error> {
        let mut job = self.job(&tank)?;
        let (methods, verdict) = pipeline::procedures::decide_without_sheets(&job)?;
        let vertical = self.records.values().any(|r| r.up.is_some());
        let prepared = match self.study.engine {
            Some(EngineId::Harmonic) if !self.records.is_empty() => {
                let faults = job::refused(&tank, |task| engine(EngineId::Harmonic).refuses(task));
                match faults.list().first() {
                    Some(fault) => {
                        self.refused(&plain(&fault.message), lines);
                        return Ok(());
                    }
                    None => Some(Prepared::new(&job.case, &job.linear, vertical)),
                }
            }
            _ => None,
        };
        let prepared = match prepared.transpose() {
            Ok(prepared) => prepared,
            Err(error) => {
                self.refused(&plain(&error.to_string()), lines);
                return Ok(());
            }
        };
        let periods = prepared.as_ref().map_or([None, None], Prepared::periods);
        let first = lines.len();
        lines.push(Line::Tank(Box::new(self.tank_row(&job, periods, &methods, &verdict))));
        if self.records.is_empty() {
            let mut row = Row::blank(self.id, self.sample, SITE, RowStatus::Ok);
            values_of(&methods, Excitation::Site, &mut row.values);
            utilisations(&methods, &mut row.checks);
            lines.push(Line::Row(Box::new(row)));
        }
        for (&number, shaking) in self.records {
            let id = &self.plan.records[number].id;
            let found = shaking
                .processed(&tank.record)
                .map_err(Error::Files)
                .and_then(|shaking| self.record(&mut job, prepared.as_ref(), periods, id, &shaking, lines));
            if let Err(error) = found {
                let message = plain(&error.to_string());
                for (level, factor) in self.blank_scales() {
                    lines.push(Line::Row(Box::new(Row {
                        level,
                        factor,
                        usable_period: shaking.usable.map(kept),
                        message: Some(message.clone()),
                        ..Row::blank(self.id, self.sample, id, RowStatus::Error)
                    })));
                }
            }
        }
        keep_gaps(&mut lines[first..]);
        Ok(())
    }

    /// The job of a tank without a record.
    fn job(&self, tank: &TankFile) -> Result<Job, Error> {
        let named = self.study.procedures.clone().unwrap_or_else(|| tank.procedures.clone());
        let procedures = pipeline::procedures::select_procedures(&named, &tank.decision.decide, &tank.case.site)?;
        // A procedure that decides in the tank file and does not run here decides nothing.
        let runs = |id: &String| !codes::ALL.iter().any(|p| p.id() == id) || procedures.contains(id);
        let decision = Decision {
            decide: tank.decision.decide.iter().filter(|id| runs(id)).cloned().collect(),
            ..tank.decision.clone()
        };
        Ok(Job {
            engines: self.study.engine.into_iter().collect(),
            linear: engines::Options { mesh_error: false, ..tank.fe.clone() },
            solid: tank.solid.clone(),
            nonlinear: tank.nonlinear.clone(),
            ..Job::of_case(tank.case.clone(), procedures, decision)
        })
    }

    fn tank_row(
        &self,
        job: &Job,
        periods: [Option<f64>; 2],
        methods: &[Method],
        verdict: &results::Verdict,
    ) -> TankRow {
        let mut values = BTreeMap::new();
        values_of(methods, Excitation::Site, &mut values);
        let governing = verdict.governing.as_ref();
        TankRow {
            tank: self.id.into(),
            sample: self.sample,
            periods: periods.map(|p| p.map(kept)),
            volume: Some(kept(job.case.liquid_mass() / job.case.liquid.density)),
            verdict: verdict.status.id().into(),
            governing: governing.map(|g| {
                let utilisation = g.check.utilisation.filter(|value| value.is_finite());
                (g.method.clone(), g.check.id.clone(), utilisation.map(kept))
            }),
            open: open(verdict),
            gaps: BTreeMap::new(),
            message: None,
            values,
        }
    }
}

/// Moves what the rows of a tank say of their gaps to the tank, whose line is the first.
fn keep_gaps(lines: &mut [Line]) {
    let Some((Line::Tank(tank), rows)) = lines.split_first_mut() else { return };
    for line in rows {
        if let Line::Row(row) = line {
            for (state, reason) in std::mem::take(&mut row.gaps) {
                tank.gaps.entry(state).or_insert(reason);
            }
        }
    }
}

/// Method and limit state of what is required and was not checked, each once.
fn open(verdict: &results::Verdict) -> Vec<(String, String)> {
    let mut open: Vec<(String, String)> = Vec::new();
    for gap in &verdict.missing {
        let gap = (gap.method.clone(), gap.check.limit_state.clone());
        if !open.contains(&gap) {
            open.push(gap);
        }
    }
    open
}

fn motion(shaking: &Shaking, factor: f64) -> GroundMotion {
    let scaled = |record: &Record| Record {
        acceleration: record.acceleration.iter().map(|a| a * factor).collect(),
        ..record.clone()
    };
    GroundMotion {
        horizontal: scaled(&shaking.along),
        transverse: shaking.across.as_ref().map(scaled),
        vertical: shaking.up.as_ref().map(scaled),
    }
}
