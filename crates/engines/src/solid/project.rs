//! Rows over the model as probes over the reduced coordinates.

use std::cell::RefCell;
use std::collections::BTreeMap;

use fem::dofs::Dof;
use fem::linalg::{Matrix, dot};
use results::Channel;
use results::channel::{OnWall, Side};
use tank::options::LinearOptions as Options;
use tank::{Case, Shape};

use super::model::TankModel;
use super::rows::{Observer, Resultant, Row, sparse_dot};
use super::system::System;
use crate::FeError;
use crate::coupled::{ShapeRows, SparseRow};
use crate::linear::Across;
use crate::probe::{ModeSelection, Probe, ProbeLine, Turn};

/// Stresses over the height.
const STRESSES: [(OnWall, Resultant); 3] =
    [(OnWall::Hoop, Resultant::Hoop), (OnWall::Axial, Resultant::Axial), (OnWall::Bending, Resultant::Moment)];

/// Turns rows over the model into probes over the reduced coordinates.
pub(super) struct Projector<'a> {
    pub tank: &'a TankModel,
    pub system: &'a System,
    pub basis: &'a Matrix,
    pub rigid: &'a [f64],
    pub influence: &'a [f64],
    pub statics: &'a [f64],
    pub observer: Observer<'a>,
    /// The rows that have been made into probes, by [`Probe::key`].
    pub rows: RefCell<BTreeMap<String, Row>>,
}

/// Resultants of the internal forces of a wall, in the order of [`OnWall::FORCES`].
const FORCES: [Resultant; 6] =
    [Resultant::Axial, Resultant::Hoop, Resultant::Shear, Resultant::Moment, Resultant::Around, Resultant::Twist];

impl Projector<'_> {
    fn project(&self, row: &[(usize, f64)]) -> Vec<f64> {
        if row.is_empty() {
            return Vec::new();
        }
        (0..self.basis.cols).map(|j| sparse_dot(row, self.basis.column(j))).collect()
    }

    /// Completes `probe` from its row.
    fn probe(&self, probe: Probe, row: &Row) -> Probe {
        self.rows.borrow_mut().insert(probe.key(), row.clone());
        self.projected(probe, row)
    }

    /// The same without keeping the row.
    pub(super) fn projected(&self, probe: Probe, row: &Row) -> Probe {
        let dofs = self.tank.model.dofs();
        let mut displacement = row.displacement.clone();
        // The mean of φ̈ over the surface is −g times the mean elevation.
        let potential: f64 =
            row.acceleration.iter().filter(|(e, _)| dofs.unknown(*e).1 == Dof::Phi).map(|(_, c)| c).sum();
        if self.observer.harmonic == 0 && potential != 0.0 {
            let factor = -self.tank.gravity * potential;
            displacement.extend(self.system.mean_elevation.iter().map(|&(e, w)| (e, factor * w)));
        }
        let acceleration = self.project(&row.acceleration);
        let rigid = row.held + sparse_dot(&row.acceleration, self.rigid);
        Probe {
            displacement: self.project(&displacement),
            ground_acceleration: rigid - dot(&acceleration, self.influence),
            absolute_acceleration: acceleration,
            ..probe
        }
    }

    fn gauge(&self, r: f64, channel: Channel, options: &Options) -> Probe {
        let probe = Probe { modes: ModeSelection::FirstSloshing(options.wave_modes), ..Probe::new(channel) };
        self.probe(probe, &self.observer.elevation(r))
    }

    /// Scalar outputs, as of the harmonic engine.
    pub(super) fn probes(&self, case: &Case, options: &Options) -> Result<Vec<Probe>, FeError> {
        let mut probes = vec![self.gauge(self.tank.radius, Channel::Wave(Side::Front), options)];
        for &r in &options.gauges {
            probes.push(self.gauge(r, Channel::WaveAt { r }, options));
        }
        probes.extend(self.reactions()?);
        probes.extend(self.base(case)?);
        for &z in &options.stations {
            let level = self.level_of(z);
            let courses = self.tank.wall.courses();
            let Some(course) = courses.iter().find(|c| c.contains(&level)) else { continue };
            for line in STRESSES {
                let probe = Probe::new(Channel::At { what: line.0, z });
                probes.push(self.wall_probe(probe, line.1, course, z));
            }
            let nodes = &self.tank.wall.z;
            let share = (z - nodes[level]) / (nodes[level + 1] - nodes[level]);
            let mut row = self.observer.radial_displacement(level).scaled(1.0 - share);
            let above = self.observer.radial_displacement(level + 1).scaled(share);
            row.displacement.extend(above.displacement);
            let what = OnWall::Displacement;
            probes.push(self.displacement(Probe::new(Channel::At { what, z }), &row));
        }
        let two = case.ground_motion.as_ref().is_some_and(|motion| motion.transverse.is_some());
        if let (true, Shape::Rectangle { length, breadth, .. }) = (two, case.tank.shape) {
            let degrees = Across::corner([0.5 * length, 0.5 * breadth]);
            let probe = Probe {
                modes: ModeSelection::FirstSloshing(options.wave_modes),
                ..Probe::new(Channel::WaveAround { degrees })
            };
            probes.push(self.probe(probe, &self.observer.corner_elevation()));
        }
        probes.extend(self.forces(options));
        Ok(probes)
    }

    /// Internal forces at the stations of a cylinder: amplitudes of the first harmonic of a perfect one, else values at the place itself.
    fn forces(&self, options: &Options) -> Vec<Probe> {
        let (courses, perfect) = (self.tank.wall.courses(), self.tank.imperfections.is_empty());
        let mut probes = Vec::new();
        for station in options.force_stations.iter().filter(|_| self.tank.is_round()) {
            let (z, degrees) = (station.z, station.degrees());
            let level = self.level_of(z);
            let Some(course) = courses.iter().find(|c| c.contains(&level)) else { continue };
            let poisson = self.tank.wall.poisson_ratio[course.start];
            for (what, resultant) in OnWall::FORCES.into_iter().zip(FORCES) {
                let odd = matches!(resultant, Resultant::Shear | Resultant::Twist);
                let angle = match (perfect, odd) {
                    (false, _) => station.theta,
                    (true, true) => std::f64::consts::FRAC_PI_2,
                    (true, false) => 0.0,
                };
                let mut at = self.observer.at_angle(angle);
                let sum: f64 = at.iter().map(|(_, share)| share).sum();
                // The shares of a harmonic are not those of a mean.
                if self.observer.harmonic != 1 {
                    at.iter_mut().for_each(|(_, share)| *share /= sum);
                }
                let row = self.observer.resultant(course, z, (resultant, &at), poisson);
                let mean = if self.observer.harmonic == 1 { sum } else { 1.0 };
                let probe = Probe {
                    static_value: sparse_dot(&row.displacement, self.statics) / mean,
                    turn: perfect.then(|| Turn::of(what, station.theta)),
                    ..Probe::new(Channel::AtAngle { what, z, degrees })
                };
                probes.push(self.probe(probe, &row));
            }
        }
        probes
    }

    /// Level of elements that holds the height z, the upper one at a node.
    fn level_of(&self, z: f64) -> usize {
        let nodes = &self.tank.wall.z;
        nodes.partition_point(|x| *x <= z).clamp(1, nodes.len() - 1) - 1
    }

    /// Base shear, moment above and below the bottom plate.
    fn reactions(&self) -> Result<Vec<Probe>, FeError> {
        let (shear, moment, below) = if self.observer.harmonic == 1 {
            let ground = self.observer.ground();
            let moment = self.observer.base_moment()?;
            let bottom = self.observer.bottom_moment()?;
            let mut below = moment.clone();
            below.acceleration.extend(bottom.acceleration);
            below.displacement.extend(bottom.displacement);
            (self.observer.inertia(&|_| ground), moment, below)
        } else {
            (Row::default(), Row::default(), Row::default())
        };
        Ok(vec![
            self.probe(Probe::new(Channel::BaseShear), &shear),
            self.probe(Probe::new(Channel::BaseMoment), &moment),
            self.probe(Probe::new(Channel::OverturningMoment), &below),
        ])
    }

    /// Stresses of the clamped edge from its reactions.
    fn base(&self, case: &Case) -> Result<Vec<Probe>, FeError> {
        let t = self.tank.wall.thickness[0];
        let moment = self.observer.edge_reaction(Dof::Ry)?;
        let axial = self.observer.edge_reaction(Dof::Uz)?.scaled(-1.0);
        let of_moment = sparse_dot(&moment.displacement, self.statics);
        // The weight that the lowest elements bring onto the edge does not depend on displacements.
        let tank = &case.tank;
        let weight = case.gravity * tank.weight_above(0.0) / tank.perimeter();
        let probe = |what, row: Row, static_value| {
            let empty = Probe { static_value, ..Probe::new(Channel::Base(what)) };
            self.probe(empty, &row)
        };
        let bending = moment.clone().scaled(6.0 / (t * t));
        Ok(vec![
            probe(OnWall::Axial, axial.scaled(1.0 / t), -weight / t),
            probe(OnWall::Bending, bending, 6.0 / (t * t) * of_moment),
            probe(OnWall::Moment, moment, of_moment),
        ])
    }

    /// A stress at the height z of a course.
    fn wall_probe(&self, probe: Probe, resultant: Resultant, course: &std::ops::Range<usize>, z: f64) -> Probe {
        let wall = &self.tank.wall;
        let t = wall.thickness[course.start];
        let factor = match resultant {
            Resultant::Moment => 6.0 / (t * t),
            _ => 1.0 / t,
        };
        let poisson = wall.poisson_ratio[course.start];
        let place = (resultant, &*self.observer.middle());
        let row = self.observer.resultant(course, z, place, poisson).scaled(factor);
        let probe = Probe {
            // The row holds 1/cos(π/N), which the static state does not need.
            static_value: sparse_dot(&row.displacement, self.statics) * self.tank.beside(self.observer.harmonic),
            ..probe
        };
        self.probe(probe, &row)
    }

    fn displacement(&self, probe: Probe, row: &Row) -> Probe {
        let probe = Probe { static_value: sparse_dot(&row.displacement, self.statics), ..probe };
        self.probe(probe, row)
    }

    /// Pressure at the wet levels of the wall under a liquid of this `weight` [N/m³].
    fn pressure_line(&self, weight: f64) -> ProbeLine {
        let z = self.tank.division.liquid.clone();
        let pressure = |(i, z): (usize, &f64)| {
            let static_value = weight * (self.tank.depth - z).max(0.0);
            let probe = Probe { static_value, ..ProbeLine::probe(OnWall::Pressure, i, *z) };
            self.probe(probe, &self.observer.pressure(i))
        };
        ProbeLine { what: OnWall::Pressure, probes: z.iter().enumerate().map(pressure).collect(), z }
    }

    /// Outputs over the height; the stresses of the base are those of `base`, from reactions.
    pub(super) fn lines(&self, case: &Case, base: &[Probe]) -> Vec<ProbeLine> {
        let mut lines = vec![self.pressure_line(case.liquid.density * case.gravity)];
        let z = &self.tank.wall.z;
        // Both sides of a joint of courses.
        let places: Vec<(f64, std::ops::Range<usize>)> = (self.tank.wall.courses().into_iter())
            .flat_map(|course| (course.start..=course.end).map(move |level| (z[level], course.clone())))
            .collect();
        for (what, resultant) in STRESSES {
            let edge = base.iter().find(|p| p.channel == Channel::Base(what));
            let probes = places.iter().enumerate().map(|(i, (z, course))| {
                let probe = ProbeLine::probe(what, i, *z);
                match (i, edge) {
                    (0, Some(edge)) => {
                        let row = self.rows.borrow().get(&edge.key()).cloned().unwrap_or_default();
                        self.rows.borrow_mut().insert(probe.key(), row);
                        Probe { channel: probe.channel, place: probe.place, ..edge.clone() }
                    }
                    _ => self.wall_probe(probe, resultant, course, *z),
                }
            });
            lines.push(ProbeLine { what, z: places.iter().map(|p| p.0).collect(), probes: probes.collect() });
        }
        if !self.tank.is_round() {
            lines.extend(self.plate_lines(&places));
        }
        let what = OnWall::Displacement;
        lines.push(ProbeLine {
            what,
            z: z.clone(),
            probes: (z.iter().enumerate())
                .map(|(level, z)| {
                    let row = self.observer.radial_displacement(level);
                    self.displacement(ProbeLine::probe(what, level, *z), &row)
                })
                .collect(),
        });
        lines
    }

    /// Bending moments of the plate at θ = 0 at heights of its courses: vertical and horizontal in its middle, horizontal at its corner.
    fn plate_lines(&self, places: &[(f64, std::ops::Range<usize>)]) -> Vec<ProbeLine> {
        let (middle, corner) = (self.observer.middle(), self.observer.corner());
        let line = |what: OnWall, resultant: Resultant, at: &[(usize, f64)]| ProbeLine {
            what,
            z: places.iter().map(|p| p.0).collect(),
            probes: (places.iter().enumerate())
                .map(|(i, (z, course))| {
                    let row = self.observer.resultant(course, *z, (resultant, at), 0.0);
                    self.displacement(ProbeLine::probe(what, i, *z), &row)
                })
                .collect(),
        };
        vec![
            line(OnWall::Moment, Resultant::Moment, &middle),
            line(OnWall::HorizontalMoment, Resultant::Around, &middle),
            line(OnWall::CornerMoment, Resultant::Around, &corner),
        ]
    }

    pub(super) fn shape_rows(&self) -> ShapeRows {
        let dense = |row: SparseRow| -> SparseRow { self.project(&row).into_iter().enumerate().collect() };
        let radii = &self.tank.division.radii;
        ShapeRows {
            z: self.tank.wall.z.clone(),
            wall: (0..self.tank.wall.z.len())
                .map(|level| dense(self.observer.radial_displacement(level).displacement))
                .collect(),
            r: radii.clone(),
            surface: radii.iter().map(|&r| dense(self.observer.elevation(r).displacement)).collect(),
            ..ShapeRows::default()
        }
    }
}
