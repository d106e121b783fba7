//! One model under several records: mesh, matrices, factors and reduction once, a run a record.

use fem::progress::Progress;
use tank::{Case, Shape};

use super::around;
use super::direct::OwnUnknowns;
use super::exchanged::{TWO_DIRECTIONS, exchanged};
use super::penalty;
use super::run::{Prepared, tilted};
use crate::checks::{check_options, checked_motion};
use crate::linear::analysis::analyse_on;
use crate::linear::mesh_error::{self, Second, SecondMesh};
use crate::linear::model::Model;
use crate::linear::{Across, Extent, Linear, complete};
use crate::{FeError, Simulation};
use results::EngineId;
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;
use tank::options::solid::SolidOptions;

/// Notes on an imperfect wall.
const IMPERFECT: [&str; 2] = [
    "The wall is imperfect (analysis.imperfections): stresses, pressures and displacements over the height are those at θ = 0; the \
     response by waves around the tank and the stress around the base are listed apart.",
    "The wave height counts the first sloshing modes of the perfect tank; waves of other harmonics, to which the imperfections couple \
     them, are not in it.",
];
/// Assumption of a wall about its loaded state.
const LOADED: &str = "The wall moves about its state under weight and liquid, in large rotations with a pressure that turns with the \
    wall: its forces stiffen the wall, and the pressure has pressed its imperfections out as far as it does. A particle of the wall keeps \
    its pressure.";
/// The model of a tank for records with the same components.
pub struct Shared {
    prepared: Prepared,
    /// The model along y of a box under two horizontal components.
    across: Option<(Model, [f64; 2])>,
}

impl Shared {
    /// The model of a case, whose ground motion says which components there are.
    ///
    /// Errors: as [`super::simulate`].
    pub fn new(
        case: &Case,
        options: &Options,
        solid: &SolidOptions,
        progress: &dyn Progress,
    ) -> Result<Shared, FeError> {
        let vertical = checked_motion(case)?.vertical.is_some();
        check_options(case, options)?;
        // Along y first: of its matrices nothing stays but the reduced model.
        let across = match exchanged(case, solid) {
            Some((case, solid, halves)) => {
                Some((Prepared::new(&case, options, &solid, false, progress)?.model, halves))
            }
            None => None,
        };
        Ok(Shared { prepared: Prepared::new(case, options, solid, vertical, progress)?, across })
    }

    /// The response to the ground motion of the case alone, without pictures and a second mesh.
    ///
    /// Errors: as [`super::simulate`].
    pub fn respond(&self, case: &Case, options: &Options, progress: &dyn Progress) -> Result<Simulation, FeError> {
        let prepared = &self.prepared;
        let mut simulation = self.complete(case, options, progress)?;
        if self.across.is_some() {
            simulation.assumptions.push(TWO_DIRECTIONS.into());
        }
        if let Shape::Rectangle { .. } = case.tank.shape {
            simulation.assumptions.push(
                "The four walls are plates in the planes of the inner faces, clamped at the base, free at the top and joined rigidly at the \
                 corners."
                    .into(),
            );
            if case.tank.roof.mass > 0.0 {
                simulation.notes.push(
                    "The roof is a mass along the top edges of the walls; its stiffness, which would hold the edges, is not modelled."
                        .into(),
                );
            }
        }
        let felt = simulation.slab_motion.clone();
        let found = around::respond(
            case,
            &prepared.tank.imperfections,
            (&prepared.model, &prepared.spaces),
            felt.as_ref().map_or_else(|| checked_motion(case), Ok)?,
            options,
            progress,
        )?;
        if let Some(around) = found {
            simulation.result.limits.extend(around::limits(case, &around));
            simulation.notes.extend(IMPERFECT.map(str::to_owned));
            simulation.result.around = Some(around);
        }
        let penalty = penalty::limits(case, &prepared.tank, &prepared.model.horizontal, options);
        simulation.result.limits.extend(penalty);
        if prepared.tank.loaded.is_some() {
            simulation.assumptions.push(LOADED.into());
        }
        if options.integrator == Integrator::Newmark {
            simulation.notes.push(
                "Pictures and ParaView files of the three-dimensional engine come from the reduced coordinates by modal \
                 superposition, also where the histories are integrated directly."
                    .into(),
            );
        }
        simulation.result.incomplete |= progress.interrupted();
        Ok(simulation)
    }

    /// Histories and extremes.
    fn complete(&self, case: &Case, options: &Options, progress: &dyn Progress) -> Result<Simulation, FeError> {
        let prepared = &self.prepared;
        let direct = OwnUnknowns {
            tank: &prepared.tank,
            system: &prepared.system,
            model: &prepared.model,
            space: &prepared.spaces[0],
        };
        let moves = prepared.model.fixed.is_some() || case.tank.isolators.is_some();
        let linear = Linear {
            engine: EngineId::Solid,
            model: &prepared.model,
            // All unknowns of the mesh are those of a tank on rigid ground.
            direct: (!moves).then_some(&direct),
            across: self.across.as_ref().map(|(model, halves)| Across { model, halves: *halves }),
            states: None,
            extent: Extent::Whole,
            known: None,
        };
        let mut simulation = complete(case, options, &linear, progress)?;
        simulation.assumptions.push(
            "Three dimensions: four-node shells and eight-node liquid elements, reduced to the space that the ground motion \
             excites."
                .into(),
        );
        Ok(simulation)
    }

    /// Adds what a run by itself has: the errors estimated on a second mesh, pictures, the tilt test.
    ///
    /// Errors: as [`super::simulate`].
    pub fn finish(
        &self,
        (case, options, solid): (&Case, &Options, &SolidOptions),
        simulation: &mut Simulation,
        progress: &dyn Progress,
    ) -> Result<(), FeError> {
        let motion = checked_motion(case)?;
        let vertical = motion.vertical.is_some();
        let round = matches!(case.tank.shape, Shape::Cylinder { .. });
        let coarser = SecondMesh::coarser(options).filter(|_| solid.mesh.is_none() && !progress.interrupted());
        let second = match coarser {
            Some(SecondMesh { options, ratio }) => {
                let coarse = Prepared::new(case, &options, solid, vertical, progress)?.model;
                let of_values = (&options, Extent::Extremes);
                let limit = mesh_error::extrapolated(&self.prepared.model, &coarse, ratio);
                Some(Second {
                    ratio,
                    values: analyse_on(&coarse, motion, of_values, progress)?.values(&coarse, round),
                    wave: analyse_on(&limit, motion, of_values, progress)?.wave(),
                    units: None,
                })
            }
            None => None,
        };
        let felt = simulation.slab_motion.clone();
        self.prepared.pictures(felt.as_ref().unwrap_or(motion), options, solid, simulation, progress)?;
        if let Some(angle) = options.tilt.filter(|_| !progress.interrupted()) {
            simulation.result.parts.push(tilted(case, angle, options, solid, progress)?);
        }
        simulation.result.incomplete |= progress.interrupted();
        mesh_error::note(simulation, second.as_ref(), options);
        Ok(())
    }
}
