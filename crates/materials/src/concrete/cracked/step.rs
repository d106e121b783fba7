//! One step of a point: axes, new cracks, history; and substeps where one is not enough.

use super::frame::Frame;
use super::local::{Axis, Problem, Solution};
use super::{
    AXIS, CrackedConcrete, EQUIVALENT, KIND, LARGEST, ON_CONE, PARTS, PLASTIC, SHEAR, SLOTS, STRAIN, STRENGTH, TRACTION,
};
use crate::concrete::crack_band;
use crate::concrete::tension::Traction;
use crate::{LawError, Response};

impl CrackedConcrete {
    /// Result in given axes: without flow if that stays inside the cone.
    fn solve(&self, problem: &Problem) -> Option<Solution> {
        let elastic = self.without_flow(problem);
        if let Some(solution) = &elastic
            && self.surface.at(&solution.stress).1 <= ON_CONE * self.surface.scale()
        {
            return elastic;
        }
        self.with_flow(problem, elastic.as_ref())
    }

    /// Traction of a crack of this strength across axis `i`: its energy over the side of the cell next to its normal.
    fn traction_across(&self, strength: f64, frame: Frame, i: usize) -> Traction {
        let traction = self.traction.reduced(strength);
        let Some(sides) = self.sides else { return traction };
        // The second crack's normal is a quarter turn on.
        let [c, s] = if i == 0 { [frame.c, frame.s] } else { [frame.s, frame.c] };
        let longest = sides[0].max(sides[1]);
        traction.stretched((longest / crack_band(sides, s.atan2(c))).max(1.0))
    }

    /// Crack of the history across axis `i`.
    fn axis(&self, history: &[f64], frame: Frame, i: usize) -> Axis {
        let strength = history[STRENGTH + i];
        if strength == 0.0 {
            return Axis::WHOLE;
        }
        Axis {
            traction: Some(self.traction_across(strength, frame, i)),
            largest: history[LARGEST + i],
            at_largest: history[TRACTION + i],
            gradient: [0.0; 3],
        }
    }

    /// One step without substeps; `None` if no stress is found.
    pub(super) fn part(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Option<Response<3>> {
        let a: [f64; 3] = std::array::from_fn(|i| strain[i] - old[PLASTIC + i]);
        new.copy_from_slice(&old[..SLOTS]);
        new[STRAIN..STRAIN + 3].copy_from_slice(strain);
        new[PARTS] = 1.0;
        let held = Frame { c: old[AXIS], s: old[AXIS + 1] };
        let cracked = held.c != 0.0 || held.s != 0.0;
        let (frame, coaxial) = if !cracked {
            if let Some(stress) = self.whole(&a) {
                return Some(Response { stress, tangent: self.elastic_moduli(), dissipation: 0.0 });
            }
            (Frame::principal(&a), true)
        } else if old[LARGEST].max(old[LARGEST + 1]) < self.turning {
            (Frame::principal_near(&a, held), true)
        } else {
            (held, false)
        };
        let mut local = frame.strain(&a);
        if coaxial {
            local[2] = 0.0;
        }
        let mut problem = Problem {
            strain: local,
            axes: [self.axis(old, frame, 0), self.axis(old, frame, 1)],
            beta: 1.0 - old[SHEAR],
            coaxial,
        };
        let mut solution = self.solve(&problem)?;
        // New cracks: the larger stress first, each added to the result without it.
        for _ in 0..2 {
            let over = |i: usize| {
                let whole = problem.axes[i].traction.is_none();
                let limit = self.beginning(solution.stress[1 - i]).0;
                if whole { solution.stress[i] - limit * (1.0 + 1e-12) } else { f64::NEG_INFINITY }
            };
            let i = if over(0) >= over(1) { 0 } else { 1 };
            if over(i) <= 0.0 {
                break;
            }
            let (strength, rate) = self.beginning(solution.stress[1 - i]);
            problem.axes[i] = Axis {
                traction: Some(self.traction_across(strength, frame, i)),
                largest: 0.0,
                at_largest: strength,
                gradient: solution.tangent[1 - i].map(|d| rate * d),
            };
            new[STRENGTH + i] = strength;
            solution = self.solve(&problem)?;
        }
        Some(self.commit(&problem, frame, solution, new))
    }

    /// Writes the history of a result and rotates it into the plane.
    fn commit(&self, problem: &Problem, frame: Frame, solution: Solution, new: &mut [f64]) -> Response<3> {
        let Solution { stress, opening, multiplier, flow, beta, mut tangent } = solution;
        if problem.coaxial {
            let gap = problem.strain[0] - problem.strain[1];
            // Equal strains of a whole point: the limit of the quotient.
            let turning = if gap.abs() > 1e-9 * (problem.strain[0].abs() + problem.strain[1].abs()) {
                0.5 * (stress[0] - stress[1]) / gap
            } else {
                0.25 * (tangent[0][0] + tangent[1][1] - tangent[0][1] - tangent[1][0])
            };
            for i in 0..2 {
                tangent[i][2] = 0.0;
                tangent[2][i] = 0.0;
            }
            tangent[2][2] = turning;
        }
        let mut dissipation = self.surface.dissipation(&stress, &flow, multiplier);
        if multiplier > 0.0 {
            for (i, flow) in frame.strain_back(&flow).iter().enumerate() {
                new[PLASTIC + i] += flow;
            }
            let out = self.surface.through_thickness(&flow, multiplier);
            let square = flow[0] * flow[0] + flow[1] * flow[1] + out * out + 0.5 * flow[2] * flow[2];
            new[EQUIVALENT] += (2.0 / 3.0 * square).sqrt();
        }
        for i in 0..2 {
            let axis = &problem.axes[i];
            let Some(traction) = &axis.traction else { continue };
            new[AXIS] = frame.c;
            new[AXIS + 1] = frame.s;
            if opening[i] > axis.largest * (1.0 + 1e-12) {
                let t = traction.at(opening[i]).0;
                new[LARGEST + i] = opening[i];
                new[TRACTION + i] = t;
                let before = if axis.largest > 0.0 { traction.dissipated(axis.largest, axis.at_largest) } else { 0.0 };
                dissipation += if !traction.brittle() {
                    traction.dissipated(opening[i], t) - before
                } else if axis.largest == 0.0 {
                    // Energy stored in the uncracked concrete, if the stress was uniaxial.
                    0.5 * traction.strength * traction.strength / self.young_modulus
                } else {
                    0.0
                };
            } else if axis.largest == 0.0 {
                new[TRACTION + i] = axis.at_largest;
            }
        }
        if beta < problem.beta {
            let slip = problem.strain[2] - flow[2];
            dissipation += 0.5 * self.shear_modulus * slip * slip * (problem.beta - beta);
            new[SHEAR] = 1.0 - beta;
        }
        Response { stress: frame.stress_back(&stress), tangent: frame.moduli_back(&tangent), dissipation }
    }

    /// One step in `parts` equal substeps.
    fn sequence(&self, strain: &[f64; 3], old: &[f64], parts: usize) -> Option<(Response<3>, [f64; SLOTS])> {
        let mut history = [0.0; SLOTS];
        history.copy_from_slice(&old[..SLOTS]);
        let mut total = Response::default();
        let mut dissipation = 0.0;
        for k in 1..=parts {
            let share = k as f64 / parts as f64;
            let here: [f64; 3] = if k == parts {
                *strain
            } else {
                std::array::from_fn(|i| old[STRAIN + i] + share * (strain[i] - old[STRAIN + i]))
            };
            let before = history;
            total = self.part(&here, &before, &mut history)?;
            dissipation += total.dissipation;
        }
        total.dissipation = dissipation;
        history[PARTS] = parts as f64;
        Some((total, history))
    }

    /// Steps in 2, 4, 8 substeps.
    pub(super) fn in_parts(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        let increment: [f64; 3] = std::array::from_fn(|i| strain[i] - old[STRAIN + i]);
        let size = increment.iter().map(|v| v * v).sum::<f64>().sqrt();
        for parts in [2, 4, 8] {
            let Some((mut response, history)) = self.sequence(strain, old, parts) else { continue };
            // Third root of rounding times the size of strains at which the law bends.
            let step = 1e-6 * (size + self.traction.strength / self.young_modulus);
            for j in 0..3 {
                let (mut up, mut down) = (*strain, *strain);
                (up[j], down[j]) = (strain[j] + step, strain[j] - step);
                if let (Some((up, _)), Some((down, _))) =
                    (self.sequence(&up, old, parts), self.sequence(&down, old, parts))
                {
                    for i in 0..3 {
                        response.tangent[i][j] = (up.stress[i] - down.stress[i]) / (2.0 * step);
                    }
                }
            }
            new.copy_from_slice(&history);
            return Ok(response);
        }
        Err(LawError::NoConvergence { law: KIND, increment: size })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Law;
    use crate::concrete::{CrackedParameters, Softening, Tension};

    /// The way in parts ends near the way in one (backward Euler of other steps), and its tangent is its derivative, here of
    /// another step size.
    #[test]
    fn steps_in_parts() {
        let law = CrackedConcrete::new(&CrackedParameters::new(
            34e9,
            0.2,
            35e6,
            Tension {
                strength: 3.5e6,
                softening: Softening::Energy { fracture_energy: 100.0, size: 0.1 },
                stiffening: None,
                bond: None,
            },
        ))
        .unwrap();
        let (mut old, mut new) = ([0.0; SLOTS], [0.0; SLOTS]);
        law.respond(&[2e-4, -1e-4, 1e-4], &old, &mut new).unwrap();
        for strain in [[4e-4, -2e-4, 3e-4], [1e-4, -1.8e-3, 2e-4]] {
            old = new;
            let one = law.respond(&strain, &old, &mut [0.0; SLOTS]).unwrap();
            let parts = law.in_parts(&strain, &old, &mut new).unwrap();
            assert_eq!(law.parts(&new), 2);
            for i in 0..3 {
                assert!((one.stress[i] - parts.stress[i]).abs() < 0.02 * 35e6, "{one:?} {parts:?}");
            }
            for j in 0..3 {
                let (mut up, mut down) = (strain, strain);
                (up[j], down[j]) = (strain[j] + 1e-7, strain[j] - 1e-7);
                let stress = |at: &[f64; 3]| law.in_parts(at, &old, &mut [0.0; SLOTS]).unwrap().stress;
                let (up, down) = (stress(&up), stress(&down));
                for i in 0..3 {
                    assert!(((up[i] - down[i]) / 2e-7 - parts.tangent[i][j]).abs() < 1e-5 * 34e9);
                }
            }
        }
    }
}
