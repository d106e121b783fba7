//! The path of one shell, and what is seen on it.

use std::f64::consts::PI;

use codes::units::Dimension;
use fem::analysis::continuation::{Constraint, Continuation, PathPoint, StepLength};
use fem::analysis::newton::Criteria;
use fem::dofs::Dof;
use fem::progress::Progress;
use fem::state::{Gather, State};

use super::imperfection::Dent;
use super::limits;
use super::model::{Plan, PushModel};
use crate::fe::FeError;
use crate::results::{Capacity, PushMeridian, PushPoint, PushShell, WallMap};

/// Load steps over gravity, and the shortest of them.
const FIRST: f64 = 0.1;
const LEAST: f64 = 0.01;
/// The path ends this far beyond its maximum.
const FALL: f64 = 0.97;
/// Largest acceleration over gravity.
const MOST: f64 = 10.0;
/// Most states of a path.
const STATES: usize = 120;
/// A step of the arc over the first one at most.
const LONGEST: f64 = 4.0;
pub(super) const CRITERIA: Criteria = Criteria {
    energy: 1e-10,
    force: 1e-4,
    iterations: 20,
};

/// The compressed meridian at one state, and of the whole wall what tells where it gives way.
#[derive(Clone, Debug, Default)]
struct Meridian {
    /// Radial displacement at the levels.
    w: Vec<f64>,
    /// Radial displacement of all nodes, level by level.
    field: Vec<f64>,
    /// Axial compression and hoop tension [Pa] in the middles of the elements.
    axial: Vec<f64>,
    hoop: Vec<f64>,
    /// Largest plastic strain of every element of the wall, sector after sector.
    plastic: Vec<f64>,
}

/// Follows the path of a shell.
///
/// Errors: a model that cannot be built; a state at rest that is not carried; an interruption before anything was carried beside it.
pub(super) fn follow(
    plan: &Plan,
    imperfection: Option<&Dent>,
    name: &'static str,
    progress: &dyn Progress,
) -> Result<PushShell, FeError> {
    let model = plan.build(imperfection)?;
    let mut state = State::new(&model.model);
    progress.stage(name, STATES as u64);
    let gravity = plan.case.gravity;
    let mut seen = Seen::new(plan, &model);
    // Load steps while there is an equilibrium: what the liquid would pull is left out anew at each.
    let mut reached = 0.0;
    let (mut step, mut arc) = (0.0, f64::NAN);
    while reached <= MOST * gravity && !progress.interrupted() {
        let before = state.committed.u.clone();
        let next = reached + step;
        let mut load = model.load(next).0;
        load.iter_mut().zip(&model.weight).for_each(|(f, w)| *f += w);
        let none = vec![0.0; load.len()];
        match continuation(&model, &load, &none)?.step(&mut state, &Constraint::Load(0.0)) {
            Ok(_) => {
                reached = next;
                seen.see(reached, &state)?;
                progress.advance(1);
                arc = model.translations(&before, &state.committed.u) * FIRST * gravity / step;
                step = if step == 0.0 { FIRST * gravity } else { step };
            }
            Err(failure) if step == 0.0 => {
                return Err(FeError::Analysis(format!(
                    "the wall does not carry weight and hydrostatic pressure at rest: {failure}"
                )));
            }
            Err(_) if step > LEAST * gravity => step *= 0.5,
            Err(_) => break,
        }
    }
    if !arc.is_finite() && progress.interrupted() {
        return Err(FeError::Interrupted { stage: name.into() });
    }
    if !arc.is_finite() {
        return Err(FeError::Analysis(format!(
            "no equilibrium under {LEAST} g beside the state at rest"
        )));
    }
    // Then along the arc, in the pattern of the last load step.
    let (mut constant, slope) = model.load(reached);
    constant.iter_mut().zip(&model.weight).for_each(|(f, w)| *f += w);
    let mut path = continuation(&model, &constant, &slope)?;
    let lengths = StepLength {
        first: 0.1 * arc,
        shortest: arc / 500.0,
        longest: LONGEST * arc,
    };
    let mut fault = None;
    let mut largest = reached;
    let steps = seen.points.len();
    let followed = path.along(&mut state, lengths, progress, |point: &PathPoint, state| {
        progress.advance(1);
        let acceleration = reached + point.factor;
        if let Err(error) = seen.see(acceleration, state) {
            fault = Some(error);
            return true;
        }
        largest = largest.max(acceleration);
        acceleration < FALL * largest || acceleration > MOST * gravity || seen.points.len() >= steps + STATES
    });
    if let Some(fault) = fault {
        return Err(fault);
    }
    let last = seen.points.last().map_or(0.0, |p| p.acceleration);
    let mut interrupted = false;
    let end = match followed.failure {
        Some(failure) => format!("no further equilibrium was found: {failure}"),
        None if last < FALL * largest => format!("followed until {:.0} % of the maximum", 100.0 * FALL),
        None if last > MOST * gravity => format!("stopped at {MOST} g: the wall does not fail in this pattern"),
        None if progress.interrupted() => {
            interrupted = true;
            "interrupted".into()
        }
        None => format!("stopped after {STATES} states"),
    };
    let mut shell = seen.shell(end)?;
    shell.interrupted = interrupted;
    Ok(shell)
}

/// Load steps and arcs of a model under `constant` and λ `load`.
pub(super) fn continuation<'a>(
    model: &'a PushModel,
    constant: &[f64],
    load: &[f64],
) -> Result<Continuation<'a>, FeError> {
    let path = Continuation::new(
        &model.model,
        &model.assembler,
        &model.symbolic,
        constant,
        load,
        CRITERIA,
    );
    Ok(path
        .map_err(|e| FeError::Analysis(e.to_string()))?
        .with_extrapolated_stresses())
}

impl PushModel {
    /// ‖b − a‖ over the translations.
    fn translations(&self, a: &[f64], b: &[f64]) -> f64 {
        let dofs = self.model.dofs();
        let counts = |e: &usize| matches!(dofs.unknown(*e).1, Dof::Ux | Dof::Uy | Dof::Uz);
        let squares = (0..dofs.len()).filter(counts).map(|e| (b[e] - a[e]).powi(2));
        squares.sum::<f64>().sqrt()
    }
}

/// States seen so far.
struct Seen<'a> {
    plan: &'a Plan<'a>,
    model: &'a PushModel,
    points: Vec<PushPoint>,
    meridians: Vec<Meridian>,
}

impl<'a> Seen<'a> {
    fn new(plan: &'a Plan<'a>, model: &'a PushModel) -> Seen<'a> {
        Seen {
            plan,
            model,
            points: Vec::new(),
            meridians: Vec::new(),
        }
    }

    fn middle(&self, j: usize) -> f64 {
        0.5 * (self.model.levels[j] + self.model.levels[j + 1])
    }

    fn thickness(&self, j: usize) -> f64 {
        self.plan.case.tank.course_at(self.middle(j)).total_thickness()
    }

    /// Takes note of a committed state.
    fn see(&mut self, acceleration: f64, state: &State) -> Result<(), FeError> {
        let model = self.model;
        let mut gather = Gather::default();
        let mut meridian = Meridian::default();
        for ring in &model.rings {
            for (&node, angle) in ring.iter().zip(&model.angles) {
                let u = model.model.at_node(&state.committed.u, node);
                meridian.field.push(u[0] * angle.cos() + u[1] * angle.sin());
            }
            meridian.w.push(meridian.field[meridian.field.len() - ring.len()]);
        }
        for (j, row) in model.cells.iter().enumerate() {
            let element = &*model.model.elements()[row[0]];
            let motion = gather.motion(&model.model, &state.committed, element);
            let sections = element
                .sections(motion, &state.old[state.history(row[0])])
                .map_err(|e| FeError::Analysis(e.to_string()))?;
            let mean = |i: usize| sections.iter().map(|s| s.resultants[i]).sum::<f64>() / sections.len() as f64;
            let t = self.thickness(j);
            meridian.hoop.push(mean(0) / t);
            meridian.axial.push(-mean(1) / t);
        }
        meridian.plastic = self.plastic(state);
        let largest = |values: &[f64]| {
            (0..values.len())
                .max_by(|&a, &b| values[a].total_cmp(&values[b]))
                .unwrap_or(0)
        };
        let compressed = largest(&meridian.axial);
        let rest = self.meridians.first().map_or(&meridian.w, |m| &m.w);
        let half = 0.5 * self.plan.case.liquid.fill_height;
        let low = model.levels.iter().take_while(|z| **z <= half).count();
        let moved = (0..low).map(|l| meridian.w[l] - rest[l]).fold(0.0, f64::max);
        let top = model.rings.last().map_or(0.0, |ring| {
            let u = |node: &usize| model.model.at_node(&state.committed.u, *node)[0];
            // Mean over the angle.
            let shares = super::load::shares(&model.angles);
            ring.iter().zip(shares).map(|(n, s)| s * u(n)).sum::<f64>() / PI
        });
        let (wall, liquid) = (limits::masses(self.plan, 0.0), model.liquid(acceleration));
        self.points.push(PushPoint {
            acceleration,
            base_shear: acceleration * wall.0 + liquid.0,
            base_moment: acceleration * wall.1 + liquid.1,
            top,
            bulge: moved,
            compression: meridian.axial[compressed],
            compression_height: self.middle(compressed),
            plastic_strain: meridian.plastic.iter().copied().fold(0.0, f64::max),
        });
        self.meridians.push(meridian);
        Ok(())
    }

    /// Largest plastic strain of every element, sector after sector.
    fn plastic(&self, state: &State) -> Vec<f64> {
        let mut gather = Gather::default();
        let model = self.model;
        let sectors = model.angles.len() - 1;
        let mut out = Vec::with_capacity(sectors * model.cells.len());
        for k in 0..sectors {
            for row in &model.cells {
                let element = &*model.model.elements()[row[k]];
                let motion = gather.motion(&model.model, &state.committed, element);
                let mut largest = 0.0_f64;
                element.inspect(motion, &state.old[state.history(row[k])], &mut |i| {
                    largest = largest.max(i.state.plastic_strain);
                });
                out.push(largest);
            }
        }
        out
    }

    /// Height [m], angle [rad] and row of cells of the buckle: where the plates have yielded most since the strongest state. Where they
    /// have not, the buckle is elastic: where the wall has moved most since then. Before a maximum, where the plates have yielded
    /// most, or are compressed most.
    fn buckle(&self, best: usize) -> (f64, f64, usize) {
        let (rows, angles) = (self.model.cells.len(), &self.model.angles);
        let (peak, last) = (&self.meridians[best], &self.meridians[self.meridians.len() - 1]);
        let passed = best + 1 < self.points.len();
        let yielded = |c: usize| last.plastic[c] - if passed { peak.plastic[c] } else { 0.0 };
        let largest = (0..last.plastic.len()).max_by(|&a, &b| yielded(a).total_cmp(&yielded(b)));
        if let Some(cell) = largest.filter(|&c| yielded(c) > 0.0) {
            let (sector, row) = (cell / rows, cell % rows);
            return (self.middle(row), angles[sector], row);
        }
        let node = if passed {
            let moved = |n: usize| (last.field[n] - peak.field[n]).abs();
            (0..peak.field.len()).max_by(|&a, &b| moved(a).total_cmp(&moved(b)))
        } else {
            let z = self.points[best].compression_height;
            let level = self.model.levels.iter().position(|l| *l >= z);
            level.map(|l| l * angles.len())
        };
        let (level, column) = (node.unwrap_or(0) / angles.len(), node.unwrap_or(0) % angles.len());
        (
            self.model.levels[level],
            angles[column],
            level.min(peak.axial.len() - 1),
        )
    }

    fn shell(&self, end: String) -> Result<PushShell, FeError> {
        let count = self.points.len();
        let best = (0..count)
            .max_by(|&a, &b| self.points[a].acceleration.total_cmp(&self.points[b].acceleration))
            .unwrap_or(0);
        let peak = &self.meridians[best];
        let plastic = self.meridians[count - 1].plastic.clone();
        let (height, angle, cell) = self.buckle(best);
        let state_there = self.points[best];
        let liquid = &self.plan.case.liquid;
        let hydrostatic = liquid.density * self.plan.case.gravity * (liquid.fill_height - height).max(0.0);
        let capacity = Capacity {
            limit: best + 1 < count,
            state: state_there,
            height,
            angle,
            thickness: self.thickness(cell),
            compression: peak.axial[cell],
            hoop: peak.hoop[cell],
            pressure: hydrostatic + state_there.acceleration * self.plan.impulsive.pressure(height),
            beam: limits::stress(self.plan, 0.0, state_there.base_moment),
        };
        let mut meridians = Vec::new();
        let mut picture = |title: &str, i: usize| {
            meridians.push(PushMeridian {
                title: title.into(),
                acceleration: self.points[i].acceleration,
                z: self.model.levels.clone(),
                w: self.meridians[i].w.clone(),
            });
        };
        picture("at rest", 0);
        picture("strongest state", best);
        if best + 1 < count {
            picture("last state", count - 1);
        }
        let middles = |v: &[f64]| v.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect::<Vec<f64>>();
        Ok(PushShell {
            imperfection: None,
            path: self.points.clone(),
            capacity,
            end,
            interrupted: false,
            meridians,
            plastic: WallMap {
                id: "plastic_strain".into(),
                title: "Largest plastic strain through the thickness, last state".into(),
                time: 0.0,
                dimension: Dimension::Dimensionless,
                theta: middles(&self.model.angles),
                z: middles(&self.model.levels),
                values: plastic,
            },
        })
    }
}
