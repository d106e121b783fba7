//! One model under the records of a set: mesh, condensed liquid and modes once, a run a record.

use std::f64::consts::TAU;
use std::sync::Arc;

use tank::case::{GroundMotion, Site};
use tank::{Case, Shape};

use super::analysis::Extent;
use super::mesh_error::{self, Second, SecondMesh};
use super::model::Model;
use super::rocking::Known;
use super::{Linear, analyse_on, complete, finished, large_wave, units};
use crate::checks::checked_motion;
use crate::harmonic::{Places, content};
use crate::modes::Kind;
use crate::{FeError, Simulation};
use fem::progress::{Progress, Silent};
use results::EngineId;
use tank::options::LinearOptions as Options;

/// The harmonic model of a tank for a set of records. Its mesh is that of the record whose content reaches highest, so that every record has at
/// least the mesh of its own run.
#[derive(Debug)]
pub struct Shared {
    /// With the record that the mesh follows.
    case: Case,
    options: Options,
    model: Model,
    /// Laws of a base that lifts, from the records so far.
    laws: Arc<Known>,
}

impl Shared {
    /// Builds the model of a case; its own ground motion is not used.
    ///
    /// Errors: no motion; an invalid record; an option out of range; a model that cannot be built or factored.
    pub fn new(case: &Case, options: &Options, motions: &[&GroundMotion]) -> Result<Shared, FeError> {
        let highest = motions.iter().max_by(|a, b| content(a).total_cmp(&content(b)));
        let Some(&highest) = highest else { return Err(FeError::NoRecord) };
        let case = Case { ground_motion: Some(highest.clone()), ..case.clone() };
        checked_motion(&case)?;
        let vertical = motions.iter().any(|motion| motion.vertical.is_some());
        let model = Model::new(&case, options, vertical, Places::Usual)?;
        Ok(Shared { options: options.clone(), case, model, laws: Arc::default() })
    }

    /// First impulsive and sloshing period [s], on a fixed base.
    pub fn periods(&self) -> [Option<f64>; 2] {
        let held = self.model.held();
        let impulsive = held.impulsive().map(|found| found.period());
        let sloshing = held.first(Kind::Sloshing).map(|mode| TAU / mode.omega);
        [impulsive, sloshing]
    }

    /// The run under a record.
    ///
    /// * `thorough`: all that is reported of a run. A quick one has its values, demands and limits alone, and a base that lifts neither on softer and
    ///   harder ground nor under motions slightly apart
    ///
    /// Errors: as [`super::simulate`].
    pub fn run(&self, motion: &GroundMotion, thorough: bool, progress: &dyn Progress) -> Result<Simulation, FeError> {
        let case = self.under(motion);
        let round = matches!(case.tank.shape, Shape::Cylinder { .. });
        if motion.transverse.is_some() && !round {
            return Err(FeError::Unsupported(
                "--quake-y: the harmonic engine has no walls along y of a rectangular tank; use --fe solid".into(),
            ));
        }
        let linear = Linear {
            engine: EngineId::Harmonic,
            model: &self.model,
            direct: None,
            across: None,
            extent: if thorough { Extent::Whole } else { Extent::Quick },
            known: Some(&self.laws),
            states: None,
        };
        if thorough {
            return complete(&case, &self.options, &linear, progress);
        }
        // What does not depend on the record stands in the thorough run.
        let case = Case { site: Site::default(), ..case };
        let options = Options { frequency: None, ..self.options.clone() };
        let mut simulation = complete(&case, &options, &linear, progress)?;
        large_wave::put(options.liquid, &mut simulation);
        Ok(simulation)
    }

    /// Writes the errors estimated on a second mesh into the run under a record, and all else that a run by itself has.
    ///
    /// Errors: as [`super::simulate`].
    pub fn finish(&self, simulation: &mut Simulation, motion: &GroundMotion) -> Result<(), FeError> {
        let second = match SecondMesh::of(&self.options) {
            None => None,
            Some(mesh) => {
                let vertical = self.model.vertical.is_some();
                let model = Model::new(&self.case, &mesh.options, vertical, Places::Dense)?;
                let round = matches!(self.case.tank.shape, Shape::Cylinder { .. });
                Some(Second {
                    ratio: mesh.ratio,
                    values: analyse_on(&model, motion, (&mesh.options, Extent::Extremes), &Silent)?
                        .values(&model, round),
                    wave: None,
                    units: if self.case.site.is_given() { Some(units::units(&model, &mesh.options)?) } else { None },
                })
            }
        };
        mesh_error::note(simulation, second.as_ref(), &self.options);
        finished(&self.under(motion), &self.options, simulation)
    }

    fn under(&self, motion: &GroundMotion) -> Case {
        Case { ground_motion: Some(motion.clone()), ..self.case.clone() }
    }
}
