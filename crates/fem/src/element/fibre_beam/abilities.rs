//! Internal state of `fibre_beam`, and its optional abilities.

use nalgebra::Vector3;

use super::{FibreBeam, SIZE, Station, dot, shortening};
use crate::element::{
    Buckling, Element, ElementError, Inspect, Inspection, LocalMatrix, Motion, Response, Sample, SectionState, Trial,
    Want,
};

impl Inspect for FibreBeam {
    /// `n_11` and `m_11` at the sections.
    fn samples(&self) -> Vec<Sample> {
        let Ok(rest) = self.section.at_rest() else { return Vec::new() };
        let mut samples = Vec::new();
        for station in &self.stations {
            for (name, k) in ["n_11", "m_11"].into_iter().zip(rest.tangent) {
                let row = station.strain.iter().zip(&station.curvature);
                samples.push(Sample {
                    name,
                    position: station.position,
                    row: row.map(|(e, c)| k[0] * e + k[1] * c).collect(),
                    of_acceleration: false,
                });
            }
        }
        samples
    }

    fn dissipated(&self, history: &[f64]) -> f64 {
        let own = |(point, s): (usize, &Station)| s.weight * self.section.dissipated(self.own(history, point));
        self.stations.iter().enumerate().map(own).sum()
    }

    fn material_points(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(&Inspection)) {
        let shortened = self.shorten(motion.values).map_or(0.0, |(e, _)| e);
        let [x, z] = self.along;
        for (point, station) in self.stations.iter().enumerate() {
            let strains = self.strains(station, motion.values, shortened);
            self.section.inspect(strains, self.own(history, point), &mut |fibre| {
                let [px, py, pz] = station.position;
                see(&Inspection {
                    point,
                    layer: fibre.fibre,
                    position: [px + z * fibre.depth, py, pz - x * fibre.depth],
                    depth: fibre.depth,
                    axes: [Vector3::new(x, 0.0, z), Vector3::y()],
                    strain: [fibre.strain, 0.0, 0.0],
                    stress: [fibre.stress, 0.0, 0.0],
                    state: fibre.state,
                });
            });
        }
    }

    /// The shear force is that of the nodal forces, constant along the beam.
    fn sections(&self, motion: Motion<'_>, history: &[f64]) -> Result<Vec<SectionState>, ElementError> {
        let u = motion.values;
        let shortened = self.shorten(u).map_or(0.0, |(e, _)| e);
        let mut scratch = history.to_vec();
        let mut force = Response::sized(SIZE);
        self.respond(Trial { motion, old: history, new: &mut scratch, want: Want::FORCE }, &mut force)?;
        let [x, z] = self.along;
        let mut states = Vec::new();
        for (point, station) in self.stations.iter().enumerate() {
            let strains = self.strains(station, u, shortened);
            let own = self.own(history, point);
            let found = self.section.respond(strains, own, &mut scratch[..own.len()])?;
            let mut state = SectionState {
                position: station.position,
                axes: [Vector3::new(x, 0.0, z), Vector3::y()],
                strain: [0.0; 8],
                resultants: [0.0; 8],
            };
            [state.strain[0], state.strain[3]] = strains;
            state.strain[6] = dot(&self.shear, u);
            [state.resultants[0], state.resultants[3]] = [found.axial, found.moment];
            state.resultants[6] = z * force.force[3] - x * force.force[4];
            states.push(state);
        }
        Ok(states)
    }
}

impl Buckling for FibreBeam {
    fn geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError> {
        let k = self.section.at_rest()?.tangent[0];
        let force: f64 = self
            .stations
            .iter()
            .map(|s| s.weight * (k[0] * dot(&s.strain, values) + k[1] * dot(&s.curvature, values)))
            .sum();
        for (o, g) in out.data.iter_mut().zip(&shortening(self.along, self.length).data) {
            *o += force * g;
        }
        Ok(())
    }
}
