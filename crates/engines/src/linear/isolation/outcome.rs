//! What is reported of a run on isolators.

use std::collections::BTreeMap;

use ::soil::isolated;
use results::part::{Amount, Axis, Block, Chart, Fact, Form, History, Line, Look, Message, Scale, Table};
use results::{Channel, Finding, Part, SeriesInfo};
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
/// Columns of the values by the factor of the properties.
const BAND: [(&str, Dimension, Form); 7] = [
    ("factor", Dimension::Dimensionless, Form::Given),
    ("isolator_displacement", Dimension::Length, Form::Usual),
    ("isolator_force", Dimension::Force, Form::Usual),
    ("effective_period", Dimension::Time, Form::Usual),
    ("effective_damping", Dimension::Dimensionless, Form::Percent),
    ("base_shear", Dimension::Force, Form::Usual),
    ("sloshing_height", Dimension::Length, Form::Usual),
];
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
pub(crate) struct Isolated {
    setup: Setup,
    given: Isolators,
    history: isolated::History,
    /// The motion of the slab in place of that of the ground.
    pub motion: GroundMotion,
    /// Values of the isolators, then those of the tank on them.
    pub values: Vec<Finding>,
    /// Largest values with lower, nominal and upper properties, a row of the table each.
    bands: Vec<Vec<Fact>>,
    /// Demands with scaled properties, and their factor.
    bounds: Vec<(f64, Demands)>,
    /// Difference of the largest force along x from that of the superposed response, relative.
    superposition: f64,
    /// In place of it, the last change of what another model exerts on the slab, relative to that force.
    change: Option<f64>,
}

impl Isolated {
    pub(super) fn new(
        setup: Setup,
        given: Isolators,
        history: isolated::History,
        bounds: Vec<Bound>,
        motion: &GroundMotion,
    ) -> Isolated {
        let isolators = setup.isolators(&given, 1.0);
        let displacement = largest(history.displacement.iter().map(size));
        let force = largest(history.force.iter().map(size));
        let residual = history.displacement.last().map_or(0.0, size);
        let [stiffness, period, damping] = setup.effective(&isolators, displacement.0);
        let peak = |id, (value, step): (f64, usize), dimension| Finding {
            time: Some(step as f64 * setup.step),
            ..Finding::new(id, value, dimension)
        };
        let values = vec![
            peak("isolator_displacement", displacement, Dimension::Length),
            Finding::new("isolator_residual", residual, Dimension::Length),
            peak("isolator_force", force, Dimension::Force),
            Finding::new("effective_stiffness", stiffness, Dimension::LineForce),
            Finding::new("effective_period", period, Dimension::Time),
            Finding { form: Form::Percent, ..Finding::new("effective_damping", damping, Dimension::Dimensionless) },
        ];
        let (bands, bounds) = bounds.into_iter().map(|b| (b.band, (b.factor, b.demands))).unzip();
        Isolated {
            motion: setup.driven(&history, motion),
            setup,
            given,
            history,
            values,
            bands,
            bounds,
            superposition: 0.0,
            change: None,
        }
    }

    /// Adds the values of another model of the tank, and the isolators to its demands.
    ///
    /// * `change`: the last change of the force on the slab, relative
    pub(super) fn of_another(&mut self, change: f64, values: &BTreeMap<Quantity, f64>, demands: &mut Demands) {
        self.change = Some(change);
        self.judge(values, &BTreeMap::new(), demands);
    }

    /// The model under the motion of the slab.
    pub(crate) fn model(&self, model: &Model) -> Model {
        on_isolators(model)
    }

    /// Displacement of the slab at the step next to a time [s], along x and y [m].
    pub(crate) fn displacement(&self, time: f64) -> [f64; 2] {
        let place = (time / self.setup.step).round() as usize;
        self.history.displacement.get(place).or(self.history.displacement.last()).copied().unwrap_or_default()
    }

    /// Steps of the march in one of the record.
    pub(super) fn parts(&self) -> usize {
        self.setup.parts
    }

    /// Samples at the steps of the record from a grid at those of the march.
    pub(crate) fn record_grid(&self, grid: Grid) -> Grid {
        let parts = self.setup.parts;
        Grid { dt: grid.dt * parts as f64, sub_steps: grid.sub_steps * parts, samples: (grid.samples - 1) / parts + 1 }
    }

    /// Histories at the steps of the record.
    pub(super) fn columns(&self) -> Vec<(SeriesInfo, Vec<f64>)> {
        let column = |channel: Channel, from: &[[f64; 2]], c: usize| {
            let (peak, at) = largest(from.iter().map(|v| v[c]));
            let info = SeriesInfo::of(channel, 0.0, (peak, at as f64 * self.setup.step));
            (info, from.iter().step_by(self.setup.parts).map(|v| v[c]).collect())
        };
        let (d, f) = (&self.history.displacement, &self.history.force);
        let mut columns = vec![column(Channel::IsolatorDisplacement, d, 0), column(Channel::IsolatorForce, f, 0)];
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
    pub(crate) fn complete(
        &mut self,
        analysis: &Analysis<'_>,
        values: &BTreeMap<Quantity, f64>,
        fixed: &BTreeMap<Quantity, f64>,
        demands: &mut Demands,
    ) {
        // F = −(V + m_b A), V the inertia of the tank, at the samples of the superposed response, which are the steps of the march.
        if let Some((_, shear)) = analysis.scalars.iter().find(|(s, _)| s.channel == Channel::BaseShear) {
            let slab = self.given.slab_mass;
            let both = shear.values.iter().zip(&self.history.acceleration);
            let (found, _) = largest(both.map(|(v, a)| v + slab * a[0]));
            let (march, _) = largest(self.history.force.iter().map(|f| f[0]));
            self.superposition = if march > 0.0 { (found / march - 1.0).abs() } else { 0.0 };
        }
        self.judge(values, fixed, demands);
    }

    /// Adds values and isolators, as of [`Isolated::complete`].
    fn judge(&mut self, values: &BTreeMap<Quantity, f64>, fixed: &BTreeMap<Quantity, f64>, demands: &mut Demands) {
        let isolators = self.setup.isolators(&self.given, 1.0);
        let own = self.setup.band(&isolators, 1.0, &self.history, (values, demands));
        self.bands.insert(self.bands.len().min(1), own);
        let moving = MOVING.into_iter().filter_map(|quantity| {
            Some(Finding {
                held: fixed.get(&quantity).copied(),
                ..Finding::new(quantity.id(), *values.get(&quantity)?, quantity.dimension())
            })
        });
        self.values.extend(moving);
        let found = isolation(&self.setup, &self.given, &self.history, demands);
        self.values.extend(found.bearing_share.map(|share| Finding {
            time: Some(share.time),
            form: Form::Fixed(2),
            ..Finding::new("bearing_share", share.value, Dimension::Dimensionless)
        }));
        demands.isolation = Some(Isolation { bounds: std::mem::take(&mut self.bounds), ..found });
    }

    /// Remarks on the run.
    pub(crate) fn notes(&self) -> Vec<String> {
        if let Some(change) = self.change {
            let differs = (change > words::CLOSE).then(|| words::differs(change));
            return std::iter::once(words::ANOTHER.to_owned()).chain(differs).collect();
        }
        let share = self.values.iter().find(|found| found.id == "bearing_share");
        let tension = share.filter(|q| q.value.value < 0.0);
        let tension = tension.map(|q| words::tension(q.value.value, q.time.unwrap_or_default()));
        std::iter::once(words::MOVES.to_owned()).chain(tension).collect()
    }

    /// What is reported.
    pub(crate) fn part(&self) -> Part {
        let kind = match self.given.bearing {
            Bearing::FrictionPendulum { .. } => "friction_pendulum",
            Bearing::LeadRubber { .. } => "lead_rubber",
            Bearing::Elastomer { .. } => "elastomer",
        };
        let isolators = Message::new("isolation-isolators")
            .with("kind", kind)
            .with("dampers", if self.given.damper.is_some() { "yes" } else { "no" })
            .with("slab", Amount::new(self.given.slab_mass, Dimension::Mass))
            .with("mass", Amount::new(self.setup.mass, Dimension::Mass))
            .with("step", Amount::new(self.setup.step, Dimension::Time).form(Form::Given));
        let energy = &self.history.energy;
        let (about, balance, apart) = match self.change {
            None => ("isolation-beside", "isolation-balance", ("superposition", self.superposition)),
            Some(change) => ("isolation-another", "isolation-balance-another", ("change", change)),
        };
        let balance = Message::new(balance)
            .with("error", Amount::ratio(energy.deviation().abs().max(1e-16)).form(Form::Significant(1)))
            .with(apart.0, Amount::percent(apart.1));
        let mut channels = vec![Channel::IsolatorDisplacement];
        channels.extend(self.motion.transverse.is_some().then_some(Channel::IsolatorDisplacementY));
        Part {
            id: "isolation".into(),
            blocks: vec![
                Block::Text(Message::new(about)),
                Block::Note(isolators),
                Block::values("values", self.values.clone()),
                Block::History(History::new("isolator_displacement", "displacement", &channels)),
                Block::Chart(self.cycles()),
                Block::Table(Table::new("band", &BAND, self.bands.clone())),
                Block::Note(Message::new("isolation-bounds")),
                Block::Table(Table::energies([
                    ("input", energy.input),
                    ("viscous", energy.viscous),
                    ("isolators", energy.isolators),
                    ("body", energy.body),
                ])),
                Block::Note(balance),
                Block::list("isolation", &self.assumptions()),
            ],
        }
    }

    /// Ids of the assumptions.
    fn assumptions(&self) -> Vec<&'static str> {
        let mut list = vec!["rigid", "follows", "mass", "outermost", "cycle", "mesh", "bounded"];
        // Another model has neither the moment of the bottom pressure nor a second mesh.
        list.retain(|id| self.change.is_none() || !["outermost", "mesh"].contains(id));
        if matches!(self.given.bearing, Bearing::FrictionPendulum { .. }) {
            list.push(if self.setup.vertical.is_empty() { "weight-at-rest" } else { "weight" });
        }
        list.push(if self.motion.transverse.is_some() { "circle" } else { "one-component" });
        list
    }

    /// Force against displacement in the direction of the largest displacement, around its step.
    fn cycles(&self) -> Chart {
        let displacement = &self.history.displacement;
        let (length, peak) = largest(displacement.iter().map(size));
        let unit = match displacement.get(peak) {
            Some(direction) if length > 0.0 => direction.map(|d| d / length),
            _ => [1.0, 0.0],
        };
        let side = (CYCLES.1 / self.setup.step) as usize;
        let steps = peak.saturating_sub(side)..(peak + side).min(displacement.len());
        let stride = steps.len().div_ceil(CYCLES.0).max(1);
        let project = |v: [f64; 2]| v[0] * unit[0] + v[1] * unit[1];
        let points =
            steps.step_by(stride).map(|i| [project(displacement[i]), project(self.history.force[i])]).collect();
        let x = Axis::new("displacement", Dimension::Length, Scale::Free);
        let y = Axis::new("force", Dimension::Force, Scale::Free);
        Chart::new("loop", x, y, vec![Line::new(Fact::None, Look::Thin, points)])
    }
}
