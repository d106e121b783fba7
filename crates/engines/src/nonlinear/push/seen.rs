//! States on the path of a shell, and their summary.

use std::f64::consts::PI;

use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::element::Inspect;
use fem::state::{Gather, State};
use tank::units::Dimension;

use super::lifted;
use super::limits;
use super::model::{Plan, PushModel};
use crate::FeError;
use results::{Capacity, PushBase, PushFoot, PushMeridian, PushPoint, PushShell, WallMap};

/// The compressed meridian at one state, and the places of the wall that yield or buckle.
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
    /// Uplift of the foot at the angles; empty of an anchored tank.
    rim: Vec<f64>,
}

/// States seen so far.
pub(super) struct Seen<'a> {
    plan: &'a Plan<'a>,
    points: Vec<PushPoint>,
    meridians: Vec<Meridian>,
}

impl<'a> Seen<'a> {
    pub(super) fn new(plan: &'a Plan<'a>) -> Seen<'a> {
        Seen { plan, points: Vec::new(), meridians: Vec::new() }
    }

    /// Number of states.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The last state.
    pub(super) fn last(&self) -> Option<&PushPoint> {
        self.points.last()
    }

    fn middle(&self, j: usize) -> f64 {
        0.5 * (self.plan.levels[j] + self.plan.levels[j + 1])
    }

    fn thickness(&self, j: usize) -> f64 {
        self.plan.case.tank.course_at(self.middle(j)).total_thickness()
    }

    /// Takes note of a committed state.
    pub(super) fn see(&mut self, model: &PushModel, acceleration: f64, state: &State) -> Result<(), FeError> {
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
        meridian.plastic = plastic(model, state);
        meridian.rim = lifted::rim(self.plan, model, state);
        let largest = |values: &[f64]| (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
        let compressed = largest(&meridian.axial);
        let rest = self.meridians.first().map_or(&meridian.w, |m| &m.w);
        let half = 0.5 * self.plan.case.liquid.fill_height;
        let low = model.levels.iter().take_while(|z| **z <= half).count();
        let moved = (0..low).map(|l| meridian.w[l] - rest[l]).fold(0.0, f64::max);
        let top = model.rings.last().map_or(0.0, |ring| {
            let u = |node: &usize| model.model.at_node(&state.committed.u, *node)[0];
            // Mean over the angle.
            let shares = crate::nonlinear::arcs::shares(&model.angles);
            ring.iter().zip(shares).map(|(n, s)| s * u(n)).sum::<f64>() / PI
        });
        let (wall, liquid) = (limits::masses(self.plan, 0.0), model.liquid(acceleration));
        let base = lifted::base(self.plan, model, acceleration, meridian.axial[0], state)?;
        self.points.push(PushPoint {
            acceleration,
            base_shear: acceleration * wall.0 + liquid.0,
            base_moment: acceleration * wall.1 + liquid.1,
            top,
            bulge: moved,
            compression: meridian.axial[compressed],
            compression_height: self.middle(compressed),
            plastic_strain: meridian.plastic.iter().copied().fold(0.0, f64::max),
            base,
        });
        self.meridians.push(meridian);
        Ok(())
    }

    /// Height [m], angle [rad] and row of cells of the buckle: where the plates have yielded most since the strongest state.
    /// Where they
    /// have not, the buckle is elastic: where the wall has moved most since then. Before a maximum, where the plates have yielded
    /// most, or are compressed most.
    fn buckle(&self, best: usize) -> (f64, f64, usize) {
        let (rows, angles) = (self.plan.levels.len() - 1, &self.plan.angles);
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
            let level = self.plan.levels.iter().position(|l| *l >= z);
            level.map(|l| l * angles.len())
        };
        let (level, column) = (node.unwrap_or(0) / angles.len(), node.unwrap_or(0) % angles.len());
        (self.plan.levels[level], angles[column], level.min(peak.axial.len() - 1))
    }

    /// Summary; `end` gives the reason why the path ends.
    pub(super) fn shell(&self, end: String) -> PushShell {
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
        let (mut meridians, mut feet) = (Vec::new(), Vec::new());
        let mut picture = |title: &str, i: usize| {
            if !self.meridians[i].rim.is_empty() {
                feet.push(PushFoot {
                    title: title.into(),
                    acceleration: self.points[i].acceleration,
                    theta: self.plan.angles.clone(),
                    w: self.meridians[i].rim.clone(),
                    strips: Vec::new(),
                });
            }
            meridians.push(PushMeridian {
                title: title.into(),
                acceleration: self.points[i].acceleration,
                z: self.plan.levels.clone(),
                w: self.meridians[i].w.clone(),
            });
        };
        picture("at rest", 0);
        picture("strongest state", best);
        if best + 1 < count {
            picture("last state", count - 1);
        }
        let middles = |v: &[f64]| v.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect::<Vec<f64>>();
        PushShell {
            imperfection: None,
            path: self.points.clone(),
            capacity,
            end,
            interrupted: false,
            meridians,
            feet,
            plastic: WallMap {
                id: "plastic_strain".into(),
                title: "Largest plastic strain through the thickness, last state".into(),
                time: None,
                dimension: Dimension::Dimensionless,
                theta: middles(&self.plan.angles),
                z: middles(&self.plan.levels),
                values: plastic,
            },
        }
    }

    pub(super) fn save(&self, to: &mut Writer) {
        to.count(self.points.len());
        for (p, m) in self.points.iter().zip(&self.meridians) {
            to.numbers(&[
                p.acceleration,
                p.base_shear,
                p.base_moment,
                p.top,
                p.bulge,
                p.compression,
                p.compression_height,
                p.plastic_strain,
            ]);
            if let Some(base) = &p.base {
                to.numbers(&[
                    base.rotation,
                    base.moment,
                    base.reaction,
                    base.uplift,
                    base.toe,
                    base.lifted_width,
                    base.lifted_angle,
                    base.plastic_rotation,
                    base.wall_rotation,
                    base.toe_stress,
                    base.toe_reaction,
                ]);
            }
            for values in [&m.w, &m.field, &m.axial, &m.hoop, &m.plastic, &m.rim] {
                to.numbers(values);
            }
        }
    }

    /// Errors: a payload that is not of this plan.
    pub(super) fn restore(plan: &'a Plan<'a>, from: &mut Reader) -> Result<Seen<'a>, CheckpointError> {
        let mut seen = Seen::new(plan);
        let (levels, angles) = (plan.levels.len(), plan.angles.len());
        let (rows, sectors) = (levels - 1, angles - 1);
        for _ in 0..from.count()? {
            let mut p = [0.0; 8];
            from.numbers_into("a point of the path", &mut p)?;
            let mut b = [0.0; 11];
            if plan.plate.is_some() {
                from.numbers_into("the base at a point of the path", &mut b)?;
            }
            let base = plan.plate.is_some().then_some(PushBase {
                rotation: b[0],
                moment: b[1],
                reaction: b[2],
                uplift: b[3],
                toe: b[4],
                lifted_width: b[5],
                lifted_angle: b[6],
                plastic_rotation: b[7],
                wall_rotation: b[8],
                toe_stress: b[9],
                toe_reaction: b[10],
                strips: None,
                strip: None,
            });
            seen.points.push(PushPoint {
                acceleration: p[0],
                base_shear: p[1],
                base_moment: p[2],
                top: p[3],
                bulge: p[4],
                compression: p[5],
                compression_height: p[6],
                plastic_strain: p[7],
                base,
            });
            let mut read = |what, length| {
                let mut values = vec![0.0; length];
                from.numbers_into(what, &mut values).map(|()| values)
            };
            seen.meridians.push(Meridian {
                w: read("a meridian", levels)?,
                field: read("radial displacements", levels * angles)?,
                axial: read("axial compressions", rows)?,
                hoop: read("hoop stresses", rows)?,
                plastic: read("plastic strains", rows * sectors)?,
                rim: read("uplifts of the foot", if plan.plate.is_some() { angles } else { 0 })?,
            });
        }
        match seen.len() {
            0 => Err(CheckpointError::Shape { what: "the path", found: 0, allowed: 1 }),
            _ => Ok(seen),
        }
    }
}

/// Largest plastic strain of every element, sector after sector.
fn plastic(model: &PushModel, state: &State) -> Vec<f64> {
    let mut gather = Gather::default();
    let sectors = model.angles.len() - 1;
    let mut out = Vec::with_capacity(sectors * model.cells.len());
    for k in 0..sectors {
        for row in &model.cells {
            let element = &*model.model.elements()[row[k]];
            let motion = gather.motion(&model.model, &state.committed, element);
            let mut largest = 0.0_f64;
            element.material_points(motion, &state.old[state.history(row[k])], &mut |i| {
                largest = largest.max(i.state.plastic_strain);
            });
            out.push(largest);
        }
    }
    out
}
