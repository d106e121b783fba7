//! What is reported of a run on isolators.

use std::collections::BTreeMap;

use ::soil::isolated::History;
use results::{BaseQuantity, Channel, IsolationEnergy, IsolationRun, SeriesInfo, Value};
use tank::case::GroundMotion;
use tank::demand::{Demands, Isolation};
use tank::units::Dimension;
use tank::{Bearing, Isolators, Quantity};

use super::super::analysis::Analysis;
use super::super::model::Model;
use super::bearings::{isolation, largest, size};
use super::{Bound, Setup, on_isolators, words};
use crate::response::motion::Grid;

/// Points of the cycles that are kept, and their time on either side of the largest displacement [s].
const CYCLES: (usize, f64) = (800, 5.0);
/// Values that depend on how the base moves.
const MOVING: [Quantity; 8] = [
    Quantity::SloshingHeight,
    Quantity::BaseShear,
    Quantity::BaseMoment,
    Quantity::OverturningMoment,
    Quantity::HoopStress,
    Quantity::RimHoopStress,
    Quantity::AxialMembraneStress,
    Quantity::BendingStress,
];

/// A run on isolators.
pub(in crate::linear) struct Isolated {
    setup: Setup,
    given: Isolators,
    history: History,
    /// The motion of the slab in place of that of the ground.
    pub motion: GroundMotion,
    /// Its results.
    pub result: IsolationRun,
    /// Demands with scaled properties, and their factor.
    bounds: Vec<(f64, Demands)>,
}

impl Isolated {
    pub(super) fn new(
        setup: Setup,
        given: Isolators,
        history: History,
        bounds: Vec<Bound>,
        motion: &GroundMotion,
    ) -> Isolated {
        let band = bounds.iter().map(|bound| bound.band).collect();
        let bounds = bounds
            .into_iter()
            .map(|bound| (bound.band.factor, bound.demands))
            .collect();
        let isolators = setup.isolators(&given, 1.0);
        let displacement = largest(history.displacement.iter().map(size));
        let force = largest(history.force.iter().map(size));
        let residual = history.displacement.last().map_or(0.0, size);
        let [stiffness, period, damping] = setup.effective(&isolators, displacement.0);
        let quantity = |id: &str, value: f64, dimension, step: Option<usize>| BaseQuantity {
            id: id.into(),
            value: Value { value, dimension },
            time: step.map(|i| i as f64 * setup.step),
            degrees: None,
            z: None,
        };
        let quantities = vec![
            quantity(
                "isolator_displacement",
                displacement.0,
                Dimension::Length,
                Some(displacement.1),
            ),
            quantity("isolator_residual", residual, Dimension::Length, None),
            quantity("isolator_force", force.0, Dimension::Force, Some(force.1)),
            quantity("effective_stiffness", stiffness, Dimension::LineForce, None),
            quantity("effective_period", period, Dimension::Time, None),
            quantity("effective_damping", damping, Dimension::Dimensionless, None),
        ];
        let energy = &history.energy;
        let pendulum = matches!(given.bearing, Bearing::FrictionPendulum { .. });
        let result = IsolationRun {
            kind: match given.bearing {
                Bearing::FrictionPendulum { .. } => "friction_pendulum",
                Bearing::LeadRubber { .. } => "lead_rubber",
                Bearing::Elastomer { .. } => "elastomer",
            }
            .into(),
            dampers: given.damper.is_some(),
            slab_mass: given.slab_mass,
            mass: setup.mass,
            step: setup.step,
            quantities,
            fixed: BTreeMap::new(),
            superposition: 0.0,
            energy: IsolationEnergy {
                input: energy.input,
                viscous: energy.viscous,
                isolators: energy.isolators,
                body: energy.body,
                error: energy.deviation().abs(),
            },
            band,
            cycles: cycles(&setup, &history, displacement.1),
            assumptions: words::assumptions(!setup.vertical.is_empty(), motion.transverse.is_some(), pendulum),
        };
        Isolated {
            motion: setup.driven(&history, motion),
            setup,
            given,
            history,
            result,
            bounds,
        }
    }

    /// The model under the motion of the slab.
    pub(in crate::linear) fn model(&self, model: &Model) -> Model {
        on_isolators(model)
    }

    /// Steps of the march in one of the record.
    pub(super) fn parts(&self) -> usize {
        self.setup.parts
    }

    /// Samples at the steps of the record from a grid at those of the march.
    pub(in crate::linear) fn record_grid(&self, grid: Grid) -> Grid {
        let parts = self.setup.parts;
        Grid {
            dt: grid.dt * parts as f64,
            sub_steps: grid.sub_steps * parts,
            samples: (grid.samples - 1) / parts + 1,
        }
    }

    /// Histories at the steps of the record.
    pub(super) fn columns(&self) -> Vec<(SeriesInfo, Vec<f64>)> {
        let column = |channel: Channel, from: &[[f64; 2]], c: usize| {
            let (peak, at) = largest(from.iter().map(|v| v[c]));
            let info = SeriesInfo::of(channel, 0.0, (peak, at as f64 * self.setup.step));
            (info, from.iter().step_by(self.setup.parts).map(|v| v[c]).collect())
        };
        let (d, f) = (&self.history.displacement, &self.history.force);
        let mut columns = vec![
            column(Channel::IsolatorDisplacement, d, 0),
            column(Channel::IsolatorForce, f, 0),
        ];
        if self.motion.transverse.is_some() {
            columns.push(column(Channel::IsolatorDisplacementY, d, 1));
            columns.push(column(Channel::IsolatorForceY, f, 1));
        }
        columns
    }

    /// Adds the superposed values, those on a fixed base, the force of the outermost bearing, and the isolators to the demands.
    ///
    /// * `analysis`: under the motion of the slab, with its `values`
    /// * `fixed`: values on a fixed base
    pub(in crate::linear) fn complete(
        &mut self,
        analysis: &Analysis<'_>,
        values: &BTreeMap<Quantity, f64>,
        fixed: &BTreeMap<Quantity, f64>,
        demands: &mut Demands,
    ) {
        let isolators = self.setup.isolators(&self.given, 1.0);
        let own = self.setup.band(&isolators, 1.0, &self.history, (values, demands));
        self.result.band.insert(self.result.band.len().min(1), own);
        for quantity in MOVING {
            if let Some(&held) = fixed.get(&quantity) {
                self.result.fixed.insert(quantity.id().to_owned(), held);
            }
            let Some(&value) = values.get(&quantity) else { continue };
            self.result.quantities.push(BaseQuantity {
                id: quantity.id().into(),
                value: Value {
                    value,
                    dimension: quantity.dimension(),
                },
                time: None,
                degrees: None,
                z: None,
            });
        }
        // F = −(V + m_b A), V the inertia of the tank, at the samples of the superposed response, which are the steps of the march.
        if let Some((_, shear)) = analysis.scalars.iter().find(|(s, _)| s.channel == Channel::BaseShear) {
            let slab = self.given.slab_mass;
            let both = shear.values.iter().zip(&self.history.acceleration);
            let (found, _) = largest(both.map(|(v, a)| v + slab * a[0]));
            let (march, _) = largest(self.history.force.iter().map(|f| f[0]));
            self.result.superposition = if march > 0.0 { (found / march - 1.0).abs() } else { 0.0 };
        }
        let found = isolation(&self.setup, &self.given, &self.history, demands);
        if let Some(share) = found.bearing_share {
            self.result.quantities.push(BaseQuantity {
                id: "bearing_share".into(),
                value: Value {
                    value: share.value,
                    dimension: Dimension::Dimensionless,
                },
                time: Some(share.time),
                degrees: None,
                z: None,
            });
        }
        demands.isolation = Some(Isolation {
            bounds: std::mem::take(&mut self.bounds),
            ..found
        });
    }

    /// Remarks on the run.
    pub(in crate::linear) fn notes(&self) -> Vec<String> {
        let tension = self.result.quantity("bearing_share").filter(|q| q.value.value < 0.0);
        let tension = tension.map(|q| words::tension(q.value.value, q.time.unwrap_or_default()));
        std::iter::once(words::MOVES.to_owned()).chain(tension).collect()
    }
}

/// Displacement and force in the direction of the largest displacement, around its step.
fn cycles(setup: &Setup, history: &History, peak: usize) -> Vec<[f64; 2]> {
    let Some(direction) = history.displacement.get(peak) else {
        return Vec::new();
    };
    let length = size(direction);
    let unit = if length > 0.0 {
        direction.map(|d| d / length)
    } else {
        [1.0, 0.0]
    };
    let side = (CYCLES.1 / setup.step) as usize;
    let steps = peak.saturating_sub(side)..(peak + side).min(history.displacement.len());
    let stride = steps.len().div_ceil(CYCLES.0).max(1);
    let project = |v: [f64; 2]| v[0] * unit[0] + v[1] * unit[1];
    steps
        .step_by(stride)
        .map(|i| [project(history.displacement[i]), project(history.force[i])])
        .collect()
}
