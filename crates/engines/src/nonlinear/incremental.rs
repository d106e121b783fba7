//! A tank at rising scales of its record: strip or cylinder.

use fem::progress::Progress;
use tank::Case;
use tank::Shape;
use tank::units::Dimension;

use super::CheckpointFile;
use super::cylinder::Cylinder;
use crate::FeError;
use crate::checks::check_depth;
use crate::strip::Strip;
use results::{Fact, IdaRun};
use tank::options::nonlinear::NonlinearOptions;

/// A tank with its record, to be run at rising scales.
pub struct Incremental<'a>(Kind<'a>);

enum Kind<'a> {
    Strip(Box<Strip>),
    Cylinder(Box<Cylinder<'a>>),
}

impl<'a> Incremental<'a> {
    /// The tank of a case with its record.
    ///
    /// Errors: no record; an unsupported tank, wall, law or option; parameters out of range.
    pub fn new(
        case: &'a Case,
        options: &'a NonlinearOptions,
        progress: &dyn Progress,
    ) -> Result<Incremental<'a>, FeError> {
        if case.ground_motion.is_none() {
            return Err(FeError::NoRecord);
        }
        check_depth(case)?;
        Ok(Incremental(match case.tank.shape {
            Shape::Cylinder { .. } => Kind::Cylinder(Box::new(Cylinder::new(case, options, progress)?)),
            Shape::Rectangle { .. } => Kind::Strip(Box::new(Strip::new(case, options)?)),
        }))
    }

    /// The model in numbers.
    ///
    /// Errors: no record.
    pub fn facts(&self) -> Result<Vec<Fact>, FeError> {
        match &self.0 {
            Kind::Strip(strip) => Ok(strip.facts.clone()),
            Kind::Cylinder(cylinder) => cylinder.facts(),
        }
    }

    /// Assumptions, one sentence each.
    pub fn assumptions(&self) -> Vec<String> {
        let (mut out, whole) = match &self.0 {
            Kind::Strip(strip) => (strip.assumptions.clone(), "Each number is that of the worse wall."),
            Kind::Cylinder(cylinder) => (
                cylinder.assumptions(),
                "The displacement is the largest radial one of the whole wall, the moment that of the whole tank.",
            ),
        };
        out.push(whole.to_owned());
        out.push(format!(
            "One record is not enough to estimate a capacity; that needs at least {} records.",
            fem::analysis::ida::RECORDS_FOR_CAPACITY
        ));
        out
    }

    /// Dimension of the moment at the base.
    pub fn moment(&self) -> Dimension {
        match &self.0 {
            Kind::Strip(_) => Dimension::LineMoment,
            Kind::Cylinder(_) => Dimension::Moment,
        }
    }

    /// The tank at every scale on `threads` threads, by ascending scale; `each` receives every finished run.
    ///
    /// * `checkpoint`: checkpoint of the run of a scale; the caller removes it
    ///
    /// Errors: a failure of the analysis; a checkpoint that cannot be written or belongs to another run. Collapse is a result,
    /// not an error.
    pub fn run(
        &self,
        scales: &[f64],
        threads: usize,
        checkpoint: &(dyn Fn(f64) -> Option<CheckpointFile> + Sync),
        progress: &dyn Progress,
        each: impl FnMut(IdaRun),
    ) -> Result<Vec<IdaRun>, FeError> {
        match &self.0 {
            Kind::Strip(strip) => strip.incremental(scales, threads, checkpoint, progress, each),
            Kind::Cylinder(cylinder) => cylinder.incremental(scales, threads, checkpoint, progress, each),
        }
    }
}
