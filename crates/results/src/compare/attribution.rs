//! Finds where the methods differ, and attributes the differences to causes.
//!
//! A difference is reported where a procedure under the *record's* spectrum is more than 10 % off the finite-element history:
//! there both saw the same ground motion, so the difference is the procedure's. Quantities that differ for the same cause
//! stand together. The two engines are held to 1 %.

use tank::Quantity;
use tank::approach::{Approach, ConvectiveMass, Forces, Wave};
use tank::assessment::Excitation;

use super::{Context, Difference, Estimated, MEASURED, Ratio, Reason, nonlinear};
use crate::{ComparisonRow, EngineId, Method};

/// Smaller differences are within the effect of record processing and damping assumptions (theory manual).
pub const THRESHOLD: f64 = 0.10;

/// The two engines solve one problem: more than this between them is reported.
const ENGINES: f64 = 0.01;

/// Quantities whose differences have one cause.
const GROUPS: [(Cause, &[Quantity]); 6] = [
    (Cause::SloshingPeriod, &[Quantity::SloshingPeriod]),
    (Cause::Wave, &[Quantity::SloshingHeight]),
    (Cause::ImpulsivePeriod, &[Quantity::ImpulsivePeriod]),
    (Cause::ImpulsiveMass, &[Quantity::ImpulsiveMass]),
    (Cause::ConvectiveMass, &[Quantity::ConvectiveMass]),
    (
        Cause::Forces,
        &[
            Quantity::BaseShear,
            Quantity::BaseMoment,
            Quantity::OverturningMoment,
            Quantity::HoopStress,
            Quantity::AxialMembraneStress,
            Quantity::BendingStress,
        ],
    ),
];

/// Why a group of quantities differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cause {
    SloshingPeriod,
    Wave,
    ImpulsivePeriod,
    ImpulsiveMass,
    ConvectiveMass,
    Forces,
}

/// One difference a cause and method, the engines first.
pub(super) fn attribute(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Vec<Difference> {
    let mut found = Vec::new();
    let mut modal_maxima = modal_maxima(context);
    found.extend(engines(methods, rows, context));
    found.extend(nonlinear::attribute(methods, rows, context));
    for (cause, quantities) in GROUPS {
        for (column, method) in methods.iter().enumerate() {
            if method.excitation != Excitation::Record || method.is_run() {
                continue;
            }
            let ratios = ratios(rows, column, THRESHOLD, quantities);
            let Some(first) = ratios.first() else {
                continue;
            };
            let mut reasons: Vec<Reason> = reason(cause, method, first.ratio, context).into_iter().collect();
            if cause == Cause::Forces && method.id != MEASURED {
                // Once is enough: it holds for all methods.
                reasons.extend(modal_maxima.take());
            }
            found.push(Difference {
                method: method.id.clone(),
                ratios,
                reasons,
            });
        }
    }
    found
}

/// Where the three-dimensional engine differs from the harmonic one: their meshes.
fn engines(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Option<Difference> {
    let column = methods.iter().position(|m| m.id == EngineId::Solid.beside())?;
    let ratios = ratios(rows, column, ENGINES, &Quantity::ALL);
    ratios.first()?;
    let error = |r: &Ratio| {
        Some(Estimated {
            quantity: r.quantity,
            error: *context.solid_mesh_error.get(r.quantity.id())?,
        })
    };
    Some(Difference {
        method: EngineId::Solid.beside().into(),
        reasons: vec![Reason::Discretisation {
            estimated: ratios.iter().filter_map(error).collect(),
        }],
        ratios,
    })
}

/// Those of `quantities` whose ratio in a column is off by more than a threshold.
pub(super) fn ratios(rows: &[ComparisonRow], column: usize, threshold: f64, quantities: &[Quantity]) -> Vec<Ratio> {
    let ratio = |&quantity: &Quantity| {
        let row = rows.iter().find(|row| row.quantity == quantity.id())?;
        let ratio = row.cells[column]?.ratio?;
        ((ratio - 1.0).abs() > threshold).then_some(Ratio { quantity, ratio })
    };
    quantities.iter().filter_map(ratio).collect()
}

/// The cause of a difference, where the theory has one.
fn reason(cause: Cause, method: &Method, ratio: f64, context: &Context) -> Option<Reason> {
    if method.id == MEASURED {
        return Some(match cause {
            Cause::Forces => Reason::TestGauges,
            _ => Reason::TestScatter,
        });
    }
    let approach = context.approaches.get(&method.id);
    Some(match cause {
        Cause::SloshingPeriod => Reason::SloshingDepth,
        Cause::ImpulsivePeriod => Reason::UniformWall,
        Cause::ImpulsiveMass => Reason::RigidImpulsiveMass,
        Cause::Wave => wave(approach?, context.sloshing_damping),
        Cause::ConvectiveMass => match approach?.convective_mass {
            ConvectiveMass::AllModes => Reason::AllSloshingModes,
            ConvectiveMass::Coefficient1957 => Reason::Coefficient1957,
            ConvectiveMass::Fit => Reason::FittedMass,
        },
        Cause::Forces => match approach?.forces {
            Forces::RigidWall => Reason::RigidWall {
                amplification: Some(context.amplification()).filter(|a| a.is_finite())?,
            },
            Forces::FirstMode => Reason::FirstModeForces { above: ratio > 1.0 },
            Forces::AnyPeriod => Reason::AnyPeriodForces,
            Forces::FittedPeriod => Reason::FittedPeriodForces,
        },
    })
}

fn wave(approach: &Approach, damping: f64) -> Reason {
    match approach.wave {
        Wave::FiniteAngle => Reason::FiniteAngleWave { damping },
        Wave::SpectralPeak => Reason::SpectralPeakWave { damping },
        Wave::FittedPeriod => Reason::FittedPeriodWave { damping },
    }
}

/// The largest shear of the first structural and the first sloshing mode, and that of the history.
fn modal_maxima(context: &Context) -> Option<Reason> {
    let sum = context.impulsive_shear + context.convective_shear;
    (sum > 0.0 && context.history_shear > 0.0).then_some(Reason::ModalMaxima {
        impulsive: context.impulsive_shear,
        convective: context.convective_shear,
        history: context.history_shear,
    })
}
