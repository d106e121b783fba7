//! Probes and lines of one harmonic, each a linear functional of the free unknowns.
//!
//! Signs: tension positive; liquid pressure positive in compression; reactions are positive as inertia forces of a
//! positive acceleration (base shear = ιᵀ M ẍ_total). Values at θ = 0.

use tank::Case;

use crate::probe::{ModeSelection, Probe, ProbeLine, Turn};
use fem::linalg::dot;
use results::Channel;
use results::channel::{OnWall, Side};
use tank::options::LinearOptions as Options;

use super::assembly::Assembly;
use super::places::{Place, Places, places};
use super::state::Static;
use super::wall::{NODE, Output};

/// Builds the probes of one harmonic.
pub(super) struct Observer<'a> {
    pub(super) assembly: &'a Assembly,
    pub(super) state: &'a Static,
    pub(super) case: &'a Case,
    /// ι on the free unknowns.
    pub(super) influence: &'a [f64],
    /// Where the outputs over the height are.
    pub(super) places: Places,
    /// Mass and first moment of the parts that move with the ground and are not meshed (side walls of a rectangle).
    pub(super) rigid: (f64, f64),
}

/// Outputs over the height.
const LINES: [(Output, OnWall); 4] = [
    (Output::HoopStress, OnWall::Hoop),
    (Output::AxialStress, OnWall::Axial),
    (Output::BendingStress, OnWall::Bending),
    (Output::RadialDisplacement, OnWall::Displacement),
];

/// Internal forces at a station, in the order of [`OnWall::FORCES`].
const FORCES: [Output; 6] = [
    Output::AxialForce,
    Output::HoopForce,
    Output::ShearForce,
    Output::BendingMoment,
    Output::HoopMoment,
    Output::Twist,
];

impl Observer<'_> {
    /// Scalar outputs.
    pub(super) fn probes(&self, options: &Options) -> Vec<Probe> {
        let mut probes =
            vec![self.gauge(self.assembly.liquid.domain.half_length(), Channel::Wave(Side::Front), options)];
        for &r in &options.gauges {
            probes.push(self.gauge(r, Channel::WaveAt { r }, options));
        }
        probes.extend(self.reactions());
        let base = Place { z: 0.0, at: vec![(0, -1.0)] };
        // A foot that turns is free of bending.
        let bends = self.assembly.wall.held[NODE - 1];
        let outputs = [
            (Output::AxialStress, OnWall::Axial),
            (Output::BendingStress, OnWall::Bending),
            (Output::BendingMoment, OnWall::Moment),
        ];
        for (output, what) in outputs.into_iter().filter(|o| bends || o.1 == OnWall::Axial) {
            probes.push(self.wall_probe(Probe::new(Channel::Base(what)), output, &base));
        }
        for &z in &options.stations {
            let place = Place { z, at: vec![self.assembly.wall.locate(z, true)] };
            for (output, what) in LINES.into_iter().filter(|l| self.exists(l.0)) {
                probes.push(self.wall_probe(Probe::new(Channel::At { what, z }), output, &place));
            }
        }
        probes.extend(self.forces(options));
        probes
    }

    /// Amplitudes of the internal forces at the stations, of a cylinder.
    fn forces(&self, options: &Options) -> Vec<Probe> {
        let mut probes = Vec::new();
        for station in options.force_stations.iter().filter(|_| self.exists(Output::HoopStress)) {
            let (z, degrees) = (station.z, station.degrees());
            let place = Place { z, at: vec![self.assembly.wall.locate(z, true)] };
            for (what, output) in OnWall::FORCES.into_iter().zip(FORCES) {
                let probe = Probe {
                    turn: Some(Turn::of(what, station.theta)),
                    ..Probe::new(Channel::AtAngle { what, z, degrees })
                };
                probes.push(self.wall_probe(probe, output, &place));
            }
        }
        probes
    }

    /// Outputs over the height.
    pub(super) fn lines(&self) -> Vec<ProbeLine> {
        let places = places(&self.assembly.wall, self.places);
        let mut lines = vec![self.pressure_line(&places)];
        for (output, what) in LINES.into_iter().filter(|l| self.exists(l.0)) {
            let probes = places.iter().enumerate();
            lines.push(ProbeLine {
                what,
                z: places.iter().map(|p| p.z).collect(),
                probes: probes.map(|(i, p)| self.wall_probe(ProbeLine::probe(what, i, p.z), output, p)).collect(),
            });
        }
        lines
    }

    /// Membrane shear force at the same places, of a cylinder.
    pub(super) fn shear(&self) -> Option<ProbeLine> {
        if self.assembly.wall.curvature == 0.0 {
            return None;
        }
        let (what, places) = (OnWall::Shear, places(&self.assembly.wall, self.places));
        let probes = places.iter().enumerate();
        let probe = |(i, p): (usize, &Place)| self.wall_probe(ProbeLine::probe(what, i, p.z), Output::ShearForce, p);
        Some(ProbeLine { what, z: places.iter().map(|p| p.z).collect(), probes: probes.map(probe).collect() })
    }

    /// Plane walls have no hoop stress.
    fn exists(&self, output: Output) -> bool {
        output != Output::HoopStress || self.assembly.wall.curvature > 0.0
    }

    fn wall_probe(&self, probe: Probe, output: Output, place: &Place) -> Probe {
        let share = 1.0 / place.at.len() as f64;
        let assembly = self.assembly;
        let (mut row, mut inertia) = (vec![0.0; assembly.size], vec![0.0; assembly.size]);
        let mut static_value = 0.0;
        for &(e, xi) in &place.at {
            let element = &assembly.wall.elements[e];
            let local = assembly.wall.output(e, xi, output);
            assembly.add_nodal_row(e, &element.condensed_row(&local), share, &mut row);
            assembly.add_nodal_row(e, &element.inertia_row(&local), share, &mut inertia);
            static_value += share * self.state.value(e, xi, output);
        }
        let probe = Probe { displacement: assembly.reduction.row(&row), static_value, ..probe };
        // The wall's own weight affects its axial stress under vertical motion only (m = 0).
        if assembly.harmonic == 0 && matches!(output, Output::AxialStress | Output::AxialForce) {
            let rigid = dot(&inertia, &assembly.translation);
            return self.acceleration_probe(probe, &inertia, rigid);
        }
        probe
    }

    fn gauge(&self, r: f64, channel: Channel, options: &Options) -> Probe {
        let row = self.assembly.liquid_row(&self.assembly.liquid.elevation(r));
        Probe {
            displacement: self.assembly.reduction.row(&row),
            modes: ModeSelection::FirstSloshing(options.wave_modes),
            ..Probe::new(channel)
        }
    }

    /// Base shear ιᵀ M ẍ, moment κᵀ M ẍ above and below the bottom plate.
    fn reactions(&self) -> Vec<Probe> {
        let assembly = self.assembly;
        let zero = vec![0.0; assembly.size];
        let (mut shear, mut moment, mut below) = (zero.clone(), zero.clone(), zero);
        let (mut rigid_mass, mut rigid_moment) = (0.0, 0.0);
        if assembly.harmonic == 1 {
            shear = assembly.mass.times(&assembly.translation);
            moment = assembly.mass.times(&assembly.rotation);
            below = moment.clone();
            let bottom = assembly.liquid_row(&assembly.liquid.bottom_moment());
            below.iter_mut().zip(&bottom).for_each(|(v, b)| *v += b);
            (rigid_mass, rigid_moment) = self.rigid;
        }
        let probe = |channel, row: &[f64], rigid: f64| {
            let value = dot(row, &assembly.translation) + rigid;
            self.acceleration_probe(Probe::new(channel), row, value)
        };
        vec![
            probe(Channel::BaseShear, &shear, rigid_mass),
            probe(Channel::BaseMoment, &moment, rigid_moment),
            probe(Channel::OverturningMoment, &below, rigid_moment),
        ]
    }

    /// Completes a probe of accelerations from its row on all unknowns and its value under a unit acceleration of the
    /// ground with everything rigid.
    fn acceleration_probe(&self, probe: Probe, row: &[f64], rigid: f64) -> Probe {
        let free = self.assembly.reduction.row(row);
        Probe { ground_acceleration: rigid - dot(&free, self.influence), absolute_acceleration: free, ..probe }
    }

    fn pressure_line(&self, places: &[Place]) -> ProbeLine {
        let depth = self.case.liquid.fill_height;
        let wetted: Vec<f64> = places.iter().map(|p| p.z).filter(|&z| z <= depth * (1.0 + 1e-9)).collect();
        let probes = wetted.iter().enumerate().map(|(i, &z)| {
            let (row, displacement) = self.assembly.liquid.wall_pressure(z, self.case.gravity);
            let row = self.assembly.liquid_row(&row);
            let rigid = match self.assembly.harmonic {
                0 => self.case.liquid.density * (depth - z).max(0.0),
                _ => dot(&row, &self.assembly.translation),
            };
            let displacement =
                displacement.map_or(Vec::new(), |d| self.assembly.reduction.row(&self.assembly.liquid_row(&d)));
            let probe = Probe {
                displacement,
                static_value: self.state.pressure(z),
                ..ProbeLine::probe(OnWall::Pressure, i, z)
            };
            self.acceleration_probe(probe, &row, rigid)
        });
        ProbeLine { what: OnWall::Pressure, probes: probes.collect(), z: wetted.clone() }
    }
}
