//! The rows of one record: codes and engine at every scale.

use std::collections::BTreeMap;

use codes::ordinates::Shared;
use codes::sheet::without_lines;
use codes::time_history::Ready;
use fem::progress::Silent;
use files::code::Code;
use tank::assessment::Excitation;
use tank::case::GroundMotion;
use tank::demand::{Demands, Footing};

use super::values::{checks_of, gaps_of, put, values_of};
use super::{Scaled, Unit, motion};
use crate::error::Error;
use crate::input::records::plausible;
use crate::input::study::Shaking;
use crate::job::Job;
use crate::pipeline;
use crate::study::rows::{Line, Row, RowStatus, kept, plain};
use engines::{FeError, Prepared, Response, Simulation, engine, solid};
use results::nonlinear::End;
use results::{EngineId, FE};

impl Unit<'_> {
    /// The rows of one record, all scales.
    pub(super) fn record(
        &self,
        job: &mut Job,
        prepared: Option<&Prepared>,
        periods: [Option<f64>; 2],
        id: &str,
        shaking: &Shaking,
        lines: &mut Vec<Line>,
    ) -> Result<(), Error> {
        let scales = &self.study.scales;
        let intensity = scales.axis.intensity(periods).ok_or_else(|| {
            Error::input(Code::Unsupported, format!("the tank has no period for the measure {}", scales.name))
        })?;
        let measure = match &shaking.across {
            None => intensity.of(&shaking.along),
            Some(across) => (intensity.of(&shaking.along) * intensity.of(across)).sqrt(),
        };
        if !(measure > 0.0 && measure.is_finite()) {
            let text = format!("{} of the record is {measure}", scales.name);
            return Err(Error::input(Code::OutOfRange, text));
        }
        let measures = shaking.along.measures();
        let all: Vec<Scaled> = match scales.levels.is_empty() {
            true => scales.factors.iter().map(|f| (None, *f)).collect(),
            false => scales.levels.iter().map(|l| (Some(*l), l / measure)).collect(),
        };
        // One run of a linear model serves every scale, that of a base that rests the smaller ones.
        let unit = match prepared {
            Some(prepared) => Some(prepared.run(&motion(shaking, 1.0))?).filter(|r| r.scales(0.0)),
            None => None,
        };
        let none = Demands::default();
        let demands = unit.as_ref().map(|unit| unit.demands.as_ref().unwrap_or(&none));
        let ready = demands.map(|demands| Ready::new(&job.case, demands));
        let linear = unit.as_ref().zip(ready.as_ref());
        let spectra = Shared::new(motion(shaking, 1.0));
        for (level, factor) in all {
            let peak = shaking.along.pga() * factor;
            let mut row = Row {
                level: level.map(kept),
                factor: kept(factor),
                im: Some(kept(measure * factor)),
                peaks: Some([peak, measures.pgv * factor, measures.pgd * factor].map(kept)),
                usable_period: shaking.usable.map(kept),
                sloshing_beyond_usable: shaking.usable.zip(periods[1]).map(|(usable, period)| period > usable),
                ..Row::blank(self.id, self.sample, id, RowStatus::Ok)
            };
            let outcome = plausible::check_peak(peak, format!("the factor {factor}"), false)
                .map_err(Error::Files)
                .and_then(|()| {
                    job.case.ground_motion = Some(motion(shaking, factor));
                    let linear = linear.filter(|(unit, _)| unit.scales(factor));
                    self.row(job, prepared, linear, (&spectra, factor), &mut row)
                });
            job.case.ground_motion = None;
            if let Err(error) = outcome {
                row.status = RowStatus::Error;
                row.message = Some(plain(&error.to_string()));
                row.values.clear();
                row.checks.clear();
            }
            lines.push(Line::Row(Box::new(row)));
        }
        Ok(())
    }

    /// Codes and engine under a scaled record.
    fn row(
        &self,
        job: &Job,
        prepared: Option<&Prepared>,
        linear: Option<(&Response, &Ready<'_>)>,
        (spectra, factor): (&Shared, f64),
        row: &mut Row,
    ) -> Result<(), Error> {
        // A row keeps only the numbers of procedures and checks.
        let procedures = || without_lines(|| pipeline::procedures::under(job, Excitation::Record));
        let methods = match &job.case.ground_motion {
            Some(motion) => spectra.during(motion, factor, procedures)?,
            None => procedures()?,
        };
        values_of(&methods, Excitation::Record, &mut row.values);
        // An engine without periods of its own, or none: those of the codes.
        if let (None, Some(usable)) = (row.sloshing_beyond_usable, row.usable_period) {
            row.sloshing_beyond_usable = pipeline::sloshing_period(&methods).map(|period| period > usable);
        }
        let (values, checks) = match (self.study.engine, linear) {
            (None, _) => (BTreeMap::new(), Vec::new()),
            (Some(_), Some((unit, ready))) => {
                let checks = without_lines(|| pipeline::checks_of_demands(job, ready, factor));
                (unit.values_under(factor), checks)
            }
            (Some(id), None) => {
                let response = self.run(job, prepared, id, row)?;
                let none = Demands::default();
                let demands = response.demands.as_ref().unwrap_or(&none);
                // Values of the wall held down are none of this tank.
                if let Footing::Beyond { time, reason } = &demands.footing {
                    (row.status, row.time) = (RowStatus::Opened, time.map(kept));
                    row.message = Some(plain(&format!("uplift cannot be computed: {reason}")));
                    return Ok(());
                }
                let ready = Ready::new(&job.case, demands);
                let checks = without_lines(|| pipeline::checks_of_demands(job, &ready, 1.0));
                (response.values, checks)
            }
        };
        for (quantity, value) in values {
            put(FE, quantity, value, &mut row.values);
        }
        checks_of(&checks, &mut row.checks);
        row.gaps = gaps_of(&checks, &row.checks);
        Ok(())
    }

    /// A run of the engine under the motion of the job; how it ended stands in the row.
    fn run(&self, job: &Job, prepared: Option<&Prepared>, id: EngineId, row: &mut Row) -> Result<Response, Error> {
        if let (Some(prepared), Some(motion)) = (prepared, &job.case.ground_motion) {
            return Ok(prepared.run(motion)?);
        }
        let task = job.task();
        let refusal = engine(id).refuses(&task).into_iter().next();
        if let Some(refusal) = refusal {
            return Err(Error::Fe(FeError::Unsupported(refusal.message)));
        }
        let simulation = match (id, &job.case.ground_motion) {
            (EngineId::Solid, Some(motion)) => self.in_three_dimensions(job, motion)?,
            _ => engine(id).run(&task, &Silent)?,
        };
        match &simulation.result.end {
            End::Collapsed { time, reason, .. } => {
                (row.status, row.time) = (RowStatus::Collapsed, Some(kept(*time)));
                row.message = Some(plain(reason));
            }
            End::Left { time, .. } | End::Interrupted { time } => {
                (row.status, row.time) = (RowStatus::Opened, Some(kept(*time)));
            }
            End::Completed => {}
        }
        Ok(Response::of(simulation))
    }

    /// The run of the three-dimensional engine, whose model serves all records with the same components.
    fn in_three_dimensions(&self, job: &Job, motion: &GroundMotion) -> Result<Simulation, FeError> {
        let components = [motion.transverse.is_some(), motion.vertical.is_some()];
        let mut kept = self.solid.borrow_mut();
        let (_, model) = match kept.take_if(|(of, _)| *of == components) {
            Some(found) => kept.insert(found),
            None => kept.insert((components, solid::Shared::new(&job.case, &job.linear, &job.solid, &Silent)?)),
        };
        model.respond(&job.case, &job.linear, &Silent)
    }
}
