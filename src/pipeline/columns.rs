//! Columns of the engines beside those of the procedures, and their comparison.

use std::collections::BTreeMap;

use codes::time_history::Findings;
use tank::assessment::Excitation;
use tank::outside::Outside;

use super::design::{self, Design};
use super::{measured, runs, series, site};
use crate::job::Job;
use engines::Simulation;
use results::compare::{self, Context};
use results::{Comparison, EngineId, Method, Run, Series};

/// Columns, runs and histories.
pub(super) struct Columns {
    /// Columns in the order of the comparison.
    pub methods: Vec<Method>,
    /// Runs of the engines.
    pub runs: Vec<Run>,
    /// Their histories.
    pub series: Series,
    /// Columns that are outside the model of their engine.
    outside: Vec<((&'static str, Excitation), Outside)>,
    /// Relative mesh errors under the spectrum of the site, by column and quantity.
    site_errors: Vec<(&'static str, BTreeMap<String, f64>)>,
}

impl Columns {
    /// Those of the procedures.
    pub(super) fn of(methods: Vec<Method>) -> Columns {
        Columns { methods, runs: Vec::new(), series: Series::default(), outside: Vec::new(), site_errors: Vec::new() }
    }

    /// Adds the columns of an engine: under the record, and under the spectrum of the site.
    pub(super) fn add(
        &mut self,
        job: &Job,
        simulation: Simulation,
        (findings, site): (Option<Findings>, Option<site::Column>),
        design: Option<&Design>,
    ) {
        let number = self.runs.len();
        let column = simulation.result.engine.column(number);
        if let Some(findings) = findings {
            self.outside.extend(findings.outside.map(|why| ((column, Excitation::Record), why)));
            let mut method = runs::method(job, number, &simulation, findings);
            if let Some(design) = design {
                design::engine(&mut method, design, &job.case);
            }
            self.methods.push(method);
        }
        if let Some(site) = site {
            self.outside.extend(site.outside.map(|why| ((column, Excitation::Site), why)));
            self.site_errors.push((column, site.errors));
            self.methods.push(site.method);
        }
        match number {
            0 => self.series = simulation.series,
            _ => series::append(&mut self.series, &simulation.series, simulation.result.engine.prefix()),
        }
        self.runs.push(simulation.result);
    }

    /// Compares the columns and marks the values that are not usable.
    pub(super) fn compare(&self, job: &Job, mut context: Context) -> Comparison {
        let Columns { methods, runs, .. } = self;
        if let Some(solid) = runs.iter().skip(1).find(|run| run.engine == EngineId::Solid) {
            context.solid_mesh_error.clone_from(&solid.mesh_error);
        }
        context.nonlinear = runs::happened(job, runs);
        let mut comparison = compare::compare(methods, &context, job.case.published.clone());
        comparison.measured_apart = measured::others(job);
        comparison.published_apart = measured::published(job);
        for (number, run) in runs.iter().enumerate() {
            let column = (run.engine.column(number), Excitation::Record);
            comparison.mark_unusable(methods, column, &run.mesh_error);
        }
        for (column, errors) in &self.site_errors {
            comparison.mark_unusable(methods, (column, Excitation::Site), errors);
        }
        for (column, why) in &self.outside {
            comparison.mark_outside(methods, *column, *why);
        }
        comparison
    }
}
